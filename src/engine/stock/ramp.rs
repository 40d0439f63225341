//! A flat tool on a ramp or on a short piece of a helix: nearly all that it covers lies under it where it is
//! lowest, and its floor is level there.
//!
//! Of the rest, a rim of few columns, each has a height of its own. Where the tool reaches is calculated for the rows
//! of a band side by side. Invariant: what is taken from the ends of the way alone is all that is covered in a row, but
//! for rows near the rims next to the way, which are examined as a whole.
use std::ops::Range;

use glam::DVec2;

use super::bed::Reach;
use super::columns::{Tally, larger, smaller};
use super::cutter::Tip;
use super::cutter_rim::{Leaving, Seen, Trail};
use super::dexel_row::Row;
use super::grid::{BAND, Grid};
use super::rim::{Place, Rims};
use super::sweep::{HAIR, NONE, Sweep, Way};

/// The first and the last of some columns.
type Columns = (usize, usize);

/// A number to which others are added so that their fractions are rounded away: what is left is in the last bits.
const WHOLE: f64 = 6_755_399_441_055_744.0;
/// What rounds up or down when it is added before; a column that the rim touches belongs to both sides of it.
const UP: f64 = 0.5 - 1e-9;

/// The whole number in the last bits of a sum with [`WHOLE`].
#[inline(always)]
fn whole(sum: f64) -> i32 {
    sum.to_bits() as i32
}

/// A flat tool on its way up or down.
#[derive(Clone, Copy, Debug)]
pub(super) struct Ramp<'s> {
    sweep: &'s Sweep,
    /// Where it is lowest, and the other end.
    low: DVec2,
    high: DVec2,
    square: f64,
    height: f64,
    /// Rows that may cross a rim next to the way.
    rims: [[f64; 2]; 2],
    /// Whether all under the lower end is gone.
    gone: bool,
    leaving: Leaving,
    seen: Seen,
}

/// Where a tool reaches in the rows of a band: columns from the first to after the last.
struct Reaches {
    y: [f64; BAND],
    /// What it covers at its ends, and what it is over where it is lowest.
    all: [[i32; 2]; BAND],
    footprint: [[i32; 2]; BAND],
}

impl<'s> Ramp<'s> {
    /// Of a path; nothing if more has to be examined.
    pub(super) fn new(grid: &Grid, sweep: &'s Sweep) -> Option<Self> {
        if sweep.cutter.tip != Tip::Flat {
            return None;
        }
        let radius = sweep.cutter.radius;
        let rim = |from: f64, to: f64, bulge: f64| [smaller(from, to) - bulge, larger(from, to) + bulge];
        let (leaving, seen) = Leaving::new(grid, sweep)?;
        let (start, end, rise, rims) = match sweep.way {
            Way::Line { from, along, length, rise } => {
                let start = DVec2::new(from.x, from.y);
                let end = start + along * length;
                let side = along.x * radius;
                (start, end, rise, [side, -side].map(|side| rim(start.y + side, end.y + side, HAIR)))
            }
            Way::Arc { centre, radius: wide, start, end, sweep: angle, rise, .. } => {
                // A rim is no farther from its chord than its radius times the square of the angle over eight.
                let rims = [wide + radius, (wide - radius).max(0.0)].map(|reach| {
                    let bulge = reach * (angle * angle * 0.125) + HAIR;
                    rim(centre.y + start.y * reach, centre.y + end.y * reach, bulge)
                });
                (centre + start * wide, centre + end * wide, rise, rims)
            }
        };
        let (low, high) = if rise < 0.0 { (end, start) } else { (start, end) };
        let gone = sweep.joined && rise > 0.0;
        Some(Self { sweep, low, high, square: radius * radius, height: sweep.low, rims, gone, leaving, seen })
    }

    /// Where it reaches in the rows of a band.
    #[inline(always)]
    fn reaches(&self, grid: &Grid, row: usize) -> Reaches {
        let place = |x: f64| (x - grid.min.x) * grid.each.x - 0.5;
        let (low, high) = (place(self.low.x), place(self.high.x));
        let (each, hair, count) = (grid.each.x, HAIR * grid.each.x, grid.columns as f64);
        let begin = grid.y(row);
        let (mut y, mut all, mut footprint) = ([0.0; BAND], [[0; 2]; BAND], [[0; 2]; BAND]);
        let first = |at: f64| smaller(larger(at, 0.0), count) + UP + WHOLE;
        let after = |at: f64| smaller(larger(at, -1.0), count - 1.0) + (1.0 - UP) + WHOLE;
        for n in 0..BAND {
            y[n] = begin + n as f64 * grid.cell.y;
            let (a, b) = (y[n] - self.low.y, y[n] - self.high.y);
            let (a, b) = (self.square - a * a, self.square - b * b);
            // Where there is no root, nothing is covered.
            let (half, other) = (larger(a, 0.0).sqrt() * each, larger(b, 0.0).sqrt() * each);
            let (half, gap) = if a > 0.0 { (half, 0.0) } else { (0.0, f64::INFINITY) };
            let (other, none) = if b > 0.0 { (other, 0.0) } else { (0.0, f64::INFINITY) };
            let (from, to) = (low - half + gap, low + half - gap);
            footprint[n] = [whole(first(from + hair)), whole(after(to - hair))];
            let (from, to) = (smaller(from, high - other + none), larger(to, high + other - none));
            all[n] = [whole(first(from)), whole(after(to))];
        }
        Reaches { y, all, footprint }
    }

    /// Takes away what it covers in some bands, given by their first row and its place among the rows. `slow` takes the
    /// rows that have no bed to be taken on.
    #[inline(always)]
    pub(super) fn cut_bands(
        &self,
        grid: &Grid,
        rows: &mut [Row],
        bands: impl Iterator<Item = (usize, usize)>,
        rims: &mut Rims,
        (tally, across): (&mut Tally, &mut [f64; 2]),
        slow: impl FnMut(&mut Row, usize, &mut Tally, &mut [f64; 2]),
    ) {
        match &self.leaving {
            Leaving::Slope(slope) => self.cut_rows(grid, rows, bands, slope, rims, (tally, across), slow),
            Leaving::Helix(helix) => self.cut_rows(grid, rows, bands, helix, rims, (tally, across), slow),
            Leaving::Usual(helix) => self.cut_rows(grid, rows, bands, helix, rims, (tally, across), slow),
        }
    }

    #[inline(always)]
    #[expect(clippy::too_many_arguments)]
    fn cut_rows(
        &self,
        grid: &Grid,
        rows: &mut [Row],
        bands: impl Iterator<Item = (usize, usize)>,
        trail: &impl Trail,
        rims: &mut Rims,
        (tally, across): (&mut Tally, &mut [f64; 2]),
        mut slow: impl FnMut(&mut Row, usize, &mut Tally, &mut [f64; 2]),
    ) {
        let [[a, b], [c, d]] = self.rims;
        let place = |centre: DVec2| ((centre.x - grid.min.x) * grid.each.x - 0.5, centre.y);
        let (middle, beside) = self.sweep.centre().map_or((f64::NAN, 0.0), place);
        for (begin, place) in bands {
            if rims.is_full() {
                rims.carry_out(rows, trail, self.height, tally, across);
            }
            let reaches = self.reaches(grid, begin);
            for (n, own) in rows.get_mut(place..).unwrap_or_default().iter_mut().enumerate().take(BAND) {
                let (y, [mut first, mut after], [from, to]) = (reaches.y[n], reaches.all[n], reaches.footprint[n]);
                if (a <= y && y <= b) || (c <= y && y <= d) {
                    [first, after] = self.columns(grid, y);
                }
                if first >= after || !own.ends_above(first as usize..after as usize, self.height) {
                    continue;
                }
                if !self.gone && own.is_above_floor(self.height) {
                    let at = self.seen.row(y);
                    let foot = [middle, (y - beside) * (y - beside)];
                    let place = || Place { row: (place + n) as u32, at, seen: &self.seen, foot };
                    let (all, footprint) = (first as u32..after as u32, from as u32..to as u32);
                    let reach = || Reach { all: all.clone(), footprint: footprint.clone(), height: self.height };
                    let across = |n: f64| trail.across(self.seen.column(at, n));
                    let left = |column: u32| trail.height(self.seen.column(at, f64::from(column)));
                    let done = if from >= to {
                        own.end(all.clone(), place(), left, rims)
                    } else if own.bed.is_some() && own.take_on(reach(), place(), across, left, rims) {
                        true
                    } else {
                        own.spread();
                        own.begin(reach(), place(), left, rims)
                    };
                    if done {
                        continue;
                    }
                }
                slow(own, begin + n, tally, across);
            }
        }
        rims.carry_out(rows, trail, self.height, tally, across);
    }

    /// All columns that it covers in a row, to after the last.
    #[cold]
    #[inline(never)]
    fn columns(&self, grid: &Grid, y: f64) -> [i32; 2] {
        let span = self.sweep.span(y);
        let columns = span.and_then(|[from, to]| Grid::between(from, to, grid.min.x, grid.each.x, grid.columns));
        columns.map_or([0, 0], |(first, last)| [first as i32, last as i32 + 1])
    }

    /// Takes away what it covers in a row, whose columns must all have material down to its lowest place. Calls
    /// `cut` with the first and the last column of each run that loses something.
    pub(super) fn cut(&self, grid: &Grid, own: &mut Row, y: f64, tally: &mut Tally, mut cut: impl FnMut(usize, usize)) {
        let [mut from, mut to] = NONE;
        let (low, high) = (y - self.low.y, y - self.high.y);
        let (footprint, other) = (self.square - low * low, self.square - high * high);
        let half = if footprint > 0.0 { footprint } else { 0.0 }.sqrt();
        if footprint >= 0.0 {
            (from, to) = (self.low.x - half, self.low.x + half);
        }
        if other >= 0.0 {
            let half = other.sqrt();
            (from, to) = (smaller(from, self.high.x - half), larger(to, self.high.x + half));
        }
        let [[a, b], [c, d]] = self.rims;
        if (a <= y && y <= b) || (c <= y && y <= d) {
            let Some(span) = self.sweep.span(y) else { return };
            [from, to] = span;
        }
        let columns = |from: f64, to: f64| Grid::between(from, to, grid.min.x, grid.each.x, grid.columns);
        let Some((first, last)) = columns(from, to) else { return };
        // Under the lower end; where there is no such column, an empty stretch.
        let settled = if half > HAIR { columns(self.low.x - half + HAIR, self.low.x + half - HAIR) } else { None };
        let (from, to) = settled.unwrap_or((usize::MAX, 0));
        let down = !self.gone && from <= to;
        own.spread();
        let before = tally.height;
        let mut sink = |columns: Columns| {
            let at = |begin: usize| [grid.x(begin), grid.cell.x, y];
            let heights = |begin: usize, part: Range<usize>, out: &mut _| self.sweep.heights(at(begin), part, out);
            own.sink(columns, (from, to), self.height, heights, tally, &mut cut);
        };
        if down {
            sink((first, last));
            if tally.height > before {
                own.lay(from as u32..to as u32 + 1, self.height);
            }
            return;
        }
        if !self.gone || from > to {
            return sink((first, last));
        }
        if first < from {
            sink((first, from - 1));
        }
        if to < last {
            sink((to + 1, last));
        }
    }
}
