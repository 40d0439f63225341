//! A ball that goes on from where it has been: most moves of a finished surface are of that kind, and short.
//!
//! All that it covers at its start is gone. Beyond its end it is lowest over a column where it is at the end; only
//! in a strip between start and end the way itself counts. Invariant: a column beyond one limit or the other may be
//! taken for either, as both give the same height there.
use glam::{DVec2, DVec3};

use super::columns::{PART, Tally, larger, smaller};
use super::dexel_row::Row;
use super::grid::Grid;
use super::sweep::{HAIR, Hull, Sweep, Way};

/// What is not less than this along the row counts as standing across it.
const ALONG: f64 = 1e-9;

/// The first and the last of some columns.
type Columns = Option<(usize, usize)>;

/// The part of the plane that lies in a direction from a line.
#[derive(Clone, Copy, Debug)]
struct Limit {
    /// The number of the column at which the line crosses the row at y = 0, and by how many more per mm of y; of a line
    /// along the rows its y.
    at: f64,
    lean: f64,
    /// +1 if the part lies towards greater x, -1 towards less, 0 for lines along the rows.
    sign: f64,
    /// The same for y of lines along the rows.
    beyond: f64,
}

impl Limit {
    /// What lies farther than `offset` in the direction from a point.
    fn new(grid: &Grid, point: DVec2, direction: DVec2, offset: f64) -> Self {
        let reached = direction.dot(point) + offset;
        if direction.x.abs() > ALONG {
            let each = direction.x.recip();
            let (at, lean) = (index(grid, reached * each), -direction.y * each * grid.each.x);
            return Self { at, lean, sign: direction.x.signum(), beyond: 0.0 };
        }
        Self { at: reached * direction.y.signum(), lean: 0.0, sign: 0.0, beyond: direction.y.signum() }
    }

    /// The part of a row, in numbers of columns.
    fn part(&self, y: f64) -> [f64; 2] {
        let at = self.at + self.lean * y;
        if self.sign > 0.0 {
            [at, f64::INFINITY]
        } else if self.sign < 0.0 {
            [f64::NEG_INFINITY, at]
        } else if self.beyond * (y - at) >= 0.0 {
            [f64::NEG_INFINITY, f64::INFINITY]
        } else {
            [f64::INFINITY, f64::NEG_INFINITY]
        }
    }
}

/// Where a place lies among the columns of a row.
#[inline(always)]
fn index(grid: &Grid, x: f64) -> f64 {
    (x - grid.min.x) * grid.each.x - 0.5
}

/// A ball on a way that it has come to on another one.
#[derive(Clone, Copy, Debug)]
pub(super) struct BallContinuation {
    /// Its middle at the end.
    end: DVec3,
    square: f64,
    /// Where it is lowest at the end, and where it is not lowest at the start.
    ends: Limit,
    starts: Limit,
    /// The numbers of columns between which it stays.
    within: [f64; 2],
    hull: Hull,
    is_line: bool,
    low: f64,
}

impl BallContinuation {
    /// Of a path; nothing if more has to be examined.
    pub(super) fn new(grid: &Grid, sweep: &Sweep) -> Option<Self> {
        let hull = sweep.hull.filter(|hull| sweep.joined && hull.length > 0.0)?;
        let radius = sweep.cutter.radius;
        let flat = DVec2::new(hull.from.x, hull.from.y);
        // On the way up it is lowest somewhat before a column, at most by that, and on the way down after it.
        let lag = radius * hull.slope / hull.steep;
        let (directions, ahead, after) = match sweep.way {
            Way::Line { .. } => ([hull.along, hull.along], lag.max(0.0), lag.min(0.0)),
            // A wide tool may come back to where it was.
            Way::Arc { radius: wide, rise, start, end, turn, sweep, .. } if rise <= 0.0 && wide >= radius => {
                let slope = rise / (sweep * wide);
                ([start, end].map(|arm| turn * DVec2::new(-arm.y, arm.x)), 0.0, radius * slope)
            }
            Way::Arc { .. } => return None,
        };
        let end = hull.from + (hull.along * hull.length).extend(hull.slope * hull.length);
        Some(Self {
            end,
            square: radius * radius,
            ends: Limit::new(grid, DVec2::new(end.x, end.y), directions[1], ahead),
            starts: Limit::new(grid, flat, directions[0], after - HAIR),
            within: [sweep.min.x, sweep.max.x].map(|x| index(grid, x)),
            hull,
            is_line: matches!(sweep.way, Way::Line { .. }),
            low: sweep.low,
        })
    }

    /// Takes away what it covers in a row. The first and the last column that lose something, and the columns of an arc
    /// between its start and its end, which are left.
    #[inline(always)]
    pub(super) fn cut(&self, grid: &Grid, own: &mut Row, y: f64, tally: &mut Tally) -> (Columns, Columns) {
        let most = grid.columns as f64 - 1.0;
        let columns = |from: f64, to: f64| {
            let (from, to) = (larger(from, 0.0), smaller(to, most));
            if from > to {
                return None;
            }
            let low = from as i32;
            let low = if f64::from(low) < from { low + 1 } else { low };
            let high = to as i32;
            (low <= high).then_some((low as usize, high as usize))
        };
        let [mut from, mut to] = self.ends.part(y);
        let (mut cut, mut left) = (None, None);
        // The strip between the lines through start and end.
        if self.ends.sign != 0.0 || from > to {
            let [first, last] = self.starts.part(y);
            let [low, high] = self.within;
            let (mut first, mut last) = (larger(first, low), smaller(last, high));
            if self.ends.sign > 0.0 {
                last = smaller(last, from);
            } else if self.ends.sign < 0.0 {
                first = larger(first, to);
            }
            let strip = columns(first, last);
            if !self.is_line {
                left = strip;
            } else if let Some(strip) = strip {
                cut = self.along(grid, own, strip, y, tally);
                // What lies in the same part of a block is done.
                if self.ends.sign > 0.0 {
                    from = larger(from, ((strip.1 / PART + 1) * PART) as f64);
                } else {
                    to = smaller(to, (strip.0 / PART * PART) as f64 - 1.0);
                }
            }
        }
        let beside = y - self.end.y;
        let square = self.square - beside * beside;
        if square > 0.0 && from <= to {
            let half = square.sqrt();
            let footprint = [index(grid, self.end.x - half), index(grid, self.end.x + half)];
            if let Some(columns) = columns(larger(from, footprint[0]), smaller(to, footprint[1])) {
                let (away, step, height) = (grid.x(0) - self.end.x, grid.cell.x, self.end.z);
                let ball = |n: f64| {
                    let far = away + n * step;
                    [square - far * far, height]
                };
                // Nowhere between two columns is it lower than at the one nearer to its middle.
                let most = |first: f64, last: f64| {
                    let (first, last) = (away + first * step, away + last * step);
                    let far = larger(larger(first, -last), 0.0);
                    square - far * far
                };
                cut = joined(cut, own.balls(columns, [height - half, height], ball, most, tally));
            }
        }
        (cut, left)
    }

    /// The columns between the ends of a straight way.
    #[inline(always)]
    fn along(&self, grid: &Grid, own: &mut Row, columns: (usize, usize), y: f64, tally: &mut Tally) -> Columns {
        let Hull { from, along, length, slope, steep, radius } = self.hull;
        let (dx, dy) = (grid.x(0) - from.x, y - from.y);
        let (u, v) = (dx * along.x + dy * along.y, dy * along.x - dx * along.y);
        let (du, dv) = (grid.cell.x * along.x, -grid.cell.x * along.y);
        let (square, lag) = (radius * radius, slope / steep);
        // It is lowest where the slopes of way and end balance, or at an end of the way.
        let ball = |n: f64| {
            let (u, v) = (u + n * du, v + n * dv);
            let room = square - v * v;
            let best = smaller(larger(u - lag * larger(room, 0.0).sqrt(), 0.0), length);
            [room - (u - best) * (u - best), from.z + slope * best]
        };
        // Along the rows all columns are as far from the way.
        let beside = larger(square - v * v, 0.0).sqrt();
        let ball_along = |n: f64| {
            let u = u + n * du;
            let best = smaller(larger(u - lag * beside, 0.0), length);
            [square - v * v - (u - best) * (u - best), from.z + slope * best]
        };
        // In these parts of blocks no ball on the way reaches lower than half the height of one that passes as near.
        let across = |column: usize| v + column as f64 * dv;
        let (first, last) = (across(columns.0 / PART * PART), across((columns.1 / PART + 1) * PART - 1));
        let near = if first * last > 0.0 { smaller(first.abs(), last.abs()) } else { 0.0 };
        let low = self.low + radius - larger(square - near * near, 0.0).sqrt() - HAIR;
        if dv == 0.0 {
            return own.balls(columns, [low, low], ball_along, |_, _| f64::INFINITY, tally);
        }
        own.balls(columns, [low, low], ball, |_, _| f64::INFINITY, tally)
    }
}

/// The first and the last column of two parts.
fn joined(one: Columns, other: Columns) -> Columns {
    match (one, other) {
        (Some((a, b)), Some((c, d))) => Some((a.min(c), b.max(d))),
        (one, other) => one.or(other),
    }
}
