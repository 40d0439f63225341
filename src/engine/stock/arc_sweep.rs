//! The way of a tool on an arc or a helix: how low its envelope reaches in each column.
//!
//! Everything is exact for each column: a flat tool leaves a column, or comes to it, where two circles cut each other;
//! where the slopes of path and end balance has a closed form for a ball,
//! and is searched for with a bull nose or a point on a helix.
use std::f64::consts::{FRAC_PI_2, PI, TAU};
use std::ops::Range;

use glam::DVec2;

use super::columns::{BLOCK, OFFSETS, WIDE, larger, smaller};
use super::cutter::Tip;
use super::kernel::{BISECTIONS, fill, fill_few, under};
use super::sweep::{HAIR, NARROW, NONE, Sweep, Way};

/// Parts of a turn among which the lowest is searched before the search closes in on it.
const PARTS: usize = 16;
/// How far, in radians, an angle may lie off the ends of a way by rounding.
const EDGE: f64 = 1e-12;

/// The arc sine of a number up to a fifth: the rest of the series is below rounding.
#[inline(always)]
fn arc_sine(sin: f64) -> f64 {
    let q = sin * sin;
    let tail = 945.0 / 42_240.0 + q * (10_395.0 / 599_040.0 + q * (135_135.0 / 9_676_800.0));
    sin * (1.0 + q * (1.0 / 6.0 + q * (3.0 / 40.0 + q * (15.0 / 336.0 + q * (105.0 / 3456.0 + q * tail)))))
}

/// The same up to four tenths.
#[inline(always)]
fn wide_arc_sine(sin: f64) -> f64 {
    let q = sin * sin;
    let tail = 13_749_310_575.0 / 1_880_240_947_200.0 + q * (316_234_143_225.0 / 49_049_763_840_000.0);
    let tail = 34_459_425.0 / 3_530_096_640.0 + q * (654_729_075.0 / 78_033_715_200.0 + q * tail);
    let tail = 135_135.0 / 9_676_800.0 + q * (2_027_025.0 / 175_472_640.0 + q * tail);
    let tail = 945.0 / 42_240.0 + q * (10_395.0 / 599_040.0 + q * tail);
    sin * (1.0 + q * (1.0 / 6.0 + q * (3.0 / 40.0 + q * (15.0 / 336.0 + q * (105.0 / 3456.0 + q * tail)))))
}

/// The columns of a block as seen from the centre of an arc: the first coordinate leads to the start, the second to
/// where the tool goes from there.
struct Seen {
    from: [f64; 2],
    step: [f64; 2],
    /// The direction of the end.
    end: DVec2,
    radius: f64,
    /// Rise in a radian.
    slope: f64,
    wide: bool,
}

impl Seen {
    #[inline(always)]
    fn at(&self, n: f64) -> DVec2 {
        DVec2::new(self.from[0] + n * self.step[0], self.from[1] + n * self.step[1])
    }

    /// The square of the distance from the start.
    #[inline(always)]
    fn beside_start(&self, p: DVec2) -> f64 {
        (p.x - self.radius) * (p.x - self.radius) + p.y * p.y
    }

    /// The square of the distance from the end.
    #[inline(always)]
    fn beside_end(&self, p: DVec2) -> f64 {
        let (x, y) = (p.x - self.radius * self.end.x, p.y - self.radius * self.end.y);
        x * x + y * y
    }

    /// The angle of a unit vector that is not beyond the way, from the start.
    #[inline(always)]
    fn angle(&self, there: DVec2) -> f64 {
        if !self.wide {
            return arc_sine(there.y);
        }
        // A quarter of the angle, by halving it twice.
        let a = (0.5 + 0.5 * there.x).sqrt();
        let b = (0.5 + 0.5 * a).sqrt();
        4.0 * wide_arc_sine(there.y / (4.0 * a * b))
    }
}

/// A column under a flat tool on a helix keeps the height at which the tool comes to it or leaves it, and that of the
/// lower end where the tool is over it there.
struct Leave {
    /// The square of the tool's radius, and of that of the helix, and how much greater this is.
    square: f64,
    wide: f64,
    most: f64,
    each: f64,
    side: f64,
    falls: bool,
    sweep: f64,
    /// Height at the start, and the lowest.
    z: f64,
    low: f64,
}

impl Leave {
    #[inline(always)]
    fn new(tool: f64, radius: f64, z: f64, [sweep, rise]: [f64; 2]) -> Self {
        let (square, wide) = (tool * tool, radius * radius);
        let (most, each, side) = (wide - square, 1.0 / radius, -rise.signum());
        Self { square, wide, most, each, side, falls: rise < 0.0, sweep, z, low: z + rise.min(0.0) }
    }

    /// The height in a column; infinity where the tool does not come.
    #[inline(always)]
    fn height(&self, seen: &Seen, n: f64) -> f64 {
        let p = seen.at(n);
        let below = if self.falls { seen.beside_end(p) } else { seen.beside_start(p) };
        // Where the rim runs through the column the tool is so many times the column's arm
        // along it, and so many across.
        let distance = p.length_squared();
        let nearer = 1.0 / distance;
        let along = (distance + self.most) * 0.5 * nearer;
        let rest = self.wide * nearer - along * along;
        let beside = self.side * if rest > 0.0 { rest } else { 0.0 }.sqrt();
        let there = DVec2::new(p.x * along - p.y * beside, p.x * beside + p.y * along) * self.each;
        let within = (rest >= 0.0) & (there.y >= -EDGE) & (there.perp_dot(seen.end) >= -EDGE);
        let angle = larger(0.0, seen.angle(there));
        let height = self.z + seen.slope * smaller(self.sweep, angle);
        let height = if within { height } else { f64::INFINITY };
        if below <= self.square { self.low } else { height }
    }
}

impl Sweep {
    /// The part of a row that it can reach: within the rectangle and the outer rim, and of a short way no more than
    /// from end to end of what is covered there.
    pub(super) fn arc_span(&self, y: f64) -> Option<[f64; 2]> {
        let Way::Arc { centre, radius, start, end, turn, sweep, .. } = self.way else { return None };
        let tool = self.cutter.radius;
        let half = |middle: f64, reach: f64| {
            let square = reach * reach - (y - middle) * (y - middle);
            (square >= 0.0).then(|| square.sqrt())
        };
        if y < self.min.y || y > self.max.y {
            return None;
        }
        if sweep >= FRAC_PI_2 + HAIR {
            let outer = half(centre.y, radius + tool)?;
            let (low, high) = (self.min.x.max(centre.x - outer), self.max.x.min(centre.x + outer));
            return (low <= high).then_some([low, high]);
        }
        let [mut low, mut high] = NONE;
        for way in [start, end] {
            let footprint = centre + way * radius;
            if let Some(half) = half(footprint.y, tool) {
                low = smaller(low, footprint.x - half);
                high = larger(high, footprint.x + half);
            }
        }
        // Where the row crosses the rims of the ring next to the way. A rim is no farther from its chord than its radius
        // times the square of the angle over eight, so few rows come near it.
        for reach in [radius + tool, (radius - tool).max(0.0)] {
            let (from, to) = (centre.y + start.y * reach, centre.y + end.y * reach);
            let bulge = reach * (sweep * sweep * 0.125) + HAIR;
            if y < smaller(from, to) - bulge || y > larger(from, to) + bulge {
                continue;
            }
            let Some(half) = half(centre.y, reach) else { continue };
            for across in [half, -half] {
                let arm = DVec2::new(across, y - centre.y);
                if start.perp_dot(arm) * turn >= 0.0 && arm.perp_dot(end) * turn >= 0.0 {
                    low = smaller(low, centre.x + across);
                    high = larger(high, centre.x + across);
                }
            }
        }
        (low <= high).then_some([low, high])
    }

    /// The parts of a row in which it can cut something: outside of what it never reaches about its centre, and of what
    /// is gone where the tool has been at the start.
    pub(super) fn arc_fresh(&self, y: f64, [low, high]: [f64; 2]) -> [[f64; 2]; 2] {
        let Way::Arc { centre, radius, start, turn, sweep, rise, .. } = self.way else { return [[low, high], NONE] };
        let tool = self.cutter.radius;
        let hole = |middle: DVec2, reach: f64| {
            let square = reach * reach - (y - middle.y) * (y - middle.y);
            let half = if square > 0.0 && reach > 0.0 { square.sqrt() - HAIR } else { 0.0 };
            (middle.x, half)
        };
        let flat = self.cutter.tip == Tip::Flat;
        if flat && rise < 0.0 && sweep < NARROW {
            // A short way goes along the hole about its centre, and not around it.
            return [[low, high], NONE];
        }
        let (mut at, mut half) = hole(centre, radius - tool);
        if self.joined && flat && rise >= 0.0 {
            let stood = hole(centre + start * radius, tool);
            if stood.1 > half {
                (at, half) = stood;
            }
        }
        let mut parts =
            if half > 0.0 { [[low, high.min(at - half)], [low.max(at + half), high]] } else { [[low, high], NONE] };
        // Nothing that lies farther back than this is lower than where the tool was; a wide tool may come back.
        if self.joined && !flat && radius >= tool && sweep <= FRAC_PI_2 {
            let slope = if rise < 0.0 { -rise / (sweep * radius) } else { 0.0 };
            let after = match self.cutter.tip {
                Tip::Round(corner) if corner >= tool => tool * slope,
                Tip::Point(steep) => tool * slope / steep,
                _ if slope == 0.0 => 0.0,
                _ => return parts,
            };
            // Along the row, the distance before the radial line at the start.
            let (rate, fixed) = (-turn * start.y, turn * start.x * (y - centre.y) + after + HAIR);
            let limit = centre.x - fixed / rate;
            for part in &mut parts {
                if rate > 1e-9 {
                    part[0] = part[0].max(limit);
                } else if rate < -1e-9 {
                    part[1] = part[1].min(limit);
                }
            }
        }
        parts
    }

    /// The lowest heights at the points `(x + n step, y)` for these numbers; infinity where the tool does not come.
    pub(super) fn arc_heights(&self, [x, step, y]: [f64; 3], columns: Range<usize>, out: &mut [f64; BLOCK]) {
        let Way::Arc { centre, radius, start, end, turn, sweep, z, rise } = self.way else { return };
        let arm = DVec2::new(x, y) - centre;
        let seen = Seen {
            from: [start.dot(arm), turn * start.perp_dot(arm)],
            step: [step * start.x, -turn * step * start.y],
            end: DVec2::new(start.dot(end), turn * start.perp_dot(end)),
            radius,
            slope: if sweep > 0.0 { rise / sweep } else { 0.0 },
            // Angles are asked for up to the sweep only.
            wide: sweep > NARROW,
        };
        let short = sweep <= FRAC_PI_2 + HAIR;
        match self.cutter.tip {
            _ if rise == 0.0 => self.on_level_arc(&seen, z, sweep, columns, out),
            Tip::Flat if short => self.flat_on_helix(&seen, z, [sweep, rise], columns, out),
            Tip::Round(corner) if short && corner >= self.cutter.radius => {
                self.ball_on_helix(&seen, z, rise, columns, out);
            }
            _ => fill(out, columns, |n| z + self.rise_on_helix(arm + DVec2::X * (n * step))),
        }
    }

    /// A tool that stays at its height.
    fn on_level_arc(&self, seen: &Seen, z: f64, sweep: f64, columns: Range<usize>, out: &mut [f64; BLOCK]) {
        let (tool, tip) = (self.cutter.radius, self.cutter.tip);
        let square = tool * tool;
        let (whole, less) = (sweep >= TAU, sweep <= PI);
        // The square of the distance from the path.
        let far = |n: f64| {
            let p = seen.at(n);
            let (after, before) = (p.y >= 0.0, p.perp_dot(seen.end) >= 0.0);
            let beside = whole || if less { after && before } else { after || before };
            let off = p.length_squared().sqrt() - seen.radius;
            let [a, b] = [seen.beside_start(p), seen.beside_end(p)];
            if beside {
                off * off
            } else if a < b {
                a
            } else {
                b
            }
        };
        match tip {
            Tip::Flat => fill(out, columns, |n| if far(n) <= square { z } else { f64::INFINITY }),
            Tip::Round(corner) if corner >= tool => fill(out, columns, |n| under(z + tool, square - far(n))),
            _ => fill(out, columns, |n| {
                let far = far(n);
                if far <= square { z + self.cutter.rise(far.sqrt()) } else { f64::INFINITY }
            }),
        }
    }

    /// A flat tool on a helix of a quarter turn at most.
    fn flat_on_helix(
        &self,
        seen: &Seen,
        z: f64,
        [sweep, rise]: [f64; 2],
        columns: Range<usize>,
        out: &mut [f64; BLOCK],
    ) {
        let leave = Leave::new(self.cutter.radius, seen.radius, z, [sweep, rise]);
        // Two closures, so that each is put in its place.
        if columns.len() > WIDE {
            fill(out, columns, |n| leave.height(seen, n));
        } else {
            fill_few(out, columns, |n| leave.height(seen, n));
        }
    }

    /// A ball on a helix of a quarter turn at most. Where the slopes of way and end balance, the sine of the angle by
    /// which the tool is turned away from the column is `-slope up / (out radius)`, `up` being its centre's height over
    /// the column; with the theorem of Pythagoras that gives a quadratic equation for the cosine.
    /// Else an end is lowest.
    fn ball_on_helix(&self, seen: &Seen, z: f64, rise: f64, columns: Range<usize>, out: &mut [f64; BLOCK]) {
        let tool = self.cutter.radius;
        let (square, slope) = (tool * tool, seen.slope);
        let (once, twice) = (slope * slope / seen.radius, slope * slope / (seen.radius * seen.radius));
        let ends = |p: DVec2| {
            let last = under(z + rise + tool, square - seen.beside_end(p));
            let first = if self.joined { f64::INFINITY } else { under(z + tool, square - seen.beside_start(p)) };
            if first < last { first } else { last }
        };
        // On the way down the tool is lowest after a column: beyond the end of the way only the end counts.
        let beyond = |n: f64| rise <= 0.0 && seen.at(n).perp_dot(seen.end) <= 0.0;
        let is_beyond = |n: usize| OFFSETS.get(n).is_some_and(|n| beyond(*n));
        let mut at = columns.start;
        while at < columns.end {
            let next = (at / WIDE * WIDE + WIDE).min(columns.end);
            if is_beyond(at) && is_beyond(next - 1) {
                fill(out, at..next, |n| ends(seen.at(n)));
            } else {
                fill(out, at..next, |n| {
                    let p = seen.at(n);
                    let distance = p.length_squared();
                    let far = distance.sqrt();
                    let nearer = 1.0 / far;
                    let room = square - distance - seen.radius * seen.radius;
                    let q = once * nearer;
                    let m = 1.0 - twice * room * nearer * nearer;
                    // The root nearer to the column, without the difference of two large numbers.
                    let cos = m / (q + (q * q + m).sqrt());
                    let up = (room + 2.0 * far * seen.radius * cos).sqrt();
                    let sin = -slope * up * nearer / seen.radius;
                    let there = DVec2::new(p.x * cos - p.y * sin, p.x * sin + p.y * cos) * nearer;
                    // What has no root is no number, which is in no order.
                    let within = up >= 0.0 && cos >= -1.0 && there.y >= 0.0 && there.perp_dot(seen.end) >= 0.0;
                    let height = z + slope * seen.angle(there) + tool - up;
                    let ends = ends(p);
                    if within && height < ends { height } else { ends }
                });
            }
            at = next;
        }
    }

    /// How high above the start of a helix a bull nose or a point passes over a column at its lowest.
    fn rise_on_helix(&self, arm: DVec2) -> f64 {
        let Way::Arc { radius, start, turn, sweep, rise, .. } = self.way else { return f64::INFINITY };
        let square = self.cutter.radius * self.cutter.radius;
        let out = arm.length();
        if (out - radius).abs() > self.cutter.radius {
            return f64::INFINITY;
        }
        // How far the tool may be turned away from the column and still be over it.
        let share = if out > 0.0 { (out * out + radius * radius - square) / (2.0 * out * radius) } else { -1.0 };
        let slope = rise / sweep;
        let reach = if share <= -1.0 { PI } else { libm::acos(share.min(1.0)) };
        let own = libm::atan2(turn * start.perp_dot(arm), start.dot(arm));
        let turns = (sweep / TAU).ceil();
        let mut lowest = f64::INFINITY;
        let mut angle = own - TAU;
        while angle <= TAU * turns + PI {
            let (first, last) = ((angle - reach).max(0.0), (angle + reach).min(sweep));
            if first <= last {
                lowest = lowest.min(self.lowest_on_turn(slope, angle, [first, last], out, radius));
            }
            angle += TAU;
        }
        lowest
    }

    /// Height of the envelope over a column at the angle `own` while the tool is at another angle.
    fn height_at(&self, slope: f64, own: f64, at: f64, out: f64, radius: f64) -> f64 {
        let far = (out * out + radius * radius - 2.0 * out * radius * libm::cos(at - own)).max(0.0).sqrt();
        slope * at + self.cutter.rise(far.min(self.cutter.radius))
    }

    /// The lowest height on the part of a helix that passes over a column whose angle is `angle`.
    fn lowest_on_turn(&self, slope: f64, angle: f64, [first, last]: [f64; 2], out: f64, radius: f64) -> f64 {
        let height = |at: f64| self.height_at(slope, angle, at, out, radius);
        let (down, up) = if slope < 0.0 { (last, first) } else { (first, last) };
        // Up to the column's own angle both slopes go down; from there to the lower end they work against each other.
        let begin = angle.clamp(first, last);
        let at = |n: usize| begin + (down - begin) * (n as f64 / PARTS as f64);
        let lowest = (0..=PARTS).min_by(|a, b| height(at(*a)).total_cmp(&height(at(*b)))).unwrap_or(0);
        let (mut near, mut far) = (at(lowest.saturating_sub(1)), at((lowest + 1).min(PARTS)));
        let mut best = height(up).min(height(at(lowest)));
        for _ in 0..BISECTIONS {
            let (a, b) = (near + (far - near) * 0.382, near + (far - near) * 0.618);
            let (low, high) = (height(a), height(b));
            best = best.min(low).min(high);
            if low < high { far = b } else { near = a }
        }
        best
    }
}
