//! The way of a tool on an arc or a helix: how low its envelope reaches in each column.
//!
//! Everything is exact for each column: a flat tool leaves a column, or comes to it, where two circles cut each other;
//! for round and pointed ends on a helix, which have no closed form, the place where the slopes of path and end
//! balance is found by Newton's rule (a ball), or by bisection.
use std::f64::consts::{FRAC_PI_2, PI, TAU};

use glam::DVec2;

use super::cutter::Tip;
use super::lane::BLOCK;
use super::sweep::{BISECTIONS, HAIR, NONE, Sweep, Way};

/// Parts of a turn among which the lowest is looked for before the search closes in on it.
const PARTS: usize = 16;
/// Steps of Newton's rule; few are needed, as the slope of a path is small.
const STEPS: usize = 40;
/// An angle, radians, that is near enough: heights differ by its square.
const NEAR: f64 = 1e-7;

/// The angle of a unit vector that is turned by little, and of any.
fn angle_of(cross: f64, dot: f64) -> f64 {
    if dot > 0.0 && cross.abs() < 0.05 {
        let q = cross * cross;
        return cross * (1.0 + q * (1.0 / 6.0 + q * (3.0 / 40.0 + q * (15.0 / 336.0 + q * (105.0 / 3456.0)))));
    }
    libm::atan2(cross, dot)
}

impl Sweep {
    /// The part of a row within the rectangle and the outer rim.
    pub(super) fn arc_span(&self, y: f64) -> Option<[f64; 2]> {
        let Way::Arc { centre, radius, .. } = self.way else { return None };
        let outer = radius + self.cutter.radius;
        let square = outer * outer - (y - centre.y) * (y - centre.y);
        if y < self.min.y || y > self.max.y || square < 0.0 {
            return None;
        }
        let half = square.sqrt();
        let (low, high) = (self.min.x.max(centre.x - half), self.max.x.min(centre.x + half));
        (low <= high).then_some([low, high])
    }

    /// The parts of a row in which it can cut something: outside of what it never reaches about its centre, and of what
    /// is gone where the tool has stood at the start.
    pub(super) fn arc_fresh(&self, y: f64, [low, high]: [f64; 2]) -> [[f64; 2]; 2] {
        let Way::Arc { centre, radius, start, turn, sweep, rise, .. } = self.way else { return [[low, high], NONE] };
        let tool = self.cutter.radius;
        let hole = |middle: DVec2, reach: f64| {
            let square = reach * reach - (y - middle.y) * (y - middle.y);
            let half = if square > 0.0 && reach > 0.0 { square.sqrt() - HAIR } else { 0.0 };
            (middle.x, half)
        };
        let (mut at, mut half) = hole(centre, radius - tool);
        let flat = self.cutter.tip == Tip::Flat;
        if self.joined && flat && rise >= 0.0 {
            let stood = hole(centre + start * radius, tool);
            if stood.1 > half {
                (at, half) = stood;
            }
        }
        let mut parts =
            if half > 0.0 { [[low, high.min(at - half)], [low.max(at + half), high]] } else { [[low, high], NONE] };
        // Nothing that lies farther back than this is lower than where the tool stood; a wide tool may come back.
        if self.joined && !flat && radius >= tool && sweep <= FRAC_PI_2 {
            let slope = if rise < 0.0 { -rise / (sweep * radius) } else { 0.0 };
            let behind = match self.cutter.tip {
                Tip::Round(corner) if corner >= tool => tool * slope,
                Tip::Point(steep) => tool * slope / steep,
                _ if slope == 0.0 => 0.0,
                _ => return parts,
            };
            // Along the row, the distance before the radial line at the start.
            let (rate, fixed) = (-turn * start.y, turn * start.x * (y - centre.y) + behind + HAIR);
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

    /// The lowest heights at the points `(x + n step, y)`; infinity where the tool does not come.
    pub(super) fn arc_heights(&self, [x, step, y]: [f64; 3], out: &mut [f64; BLOCK]) {
        let Way::Arc { centre, radius, z, rise, .. } = self.way else { return };
        let tool = self.cutter.radius;
        let (inner, outer) = ((radius - tool).max(0.0), radius + tool);
        for (n, out) in out.iter_mut().enumerate() {
            let arm = DVec2::new(x + n as f64 * step, y) - centre;
            let square = arm.length_squared();
            // What is no part of the ring is not reached.
            *out = if square > outer * outer + HAIR || square < inner * inner - HAIR {
                f64::INFINITY
            } else if rise == 0.0 {
                z + self.rise_on_level(arm)
            } else {
                z + self.rise_on_helix(arm)
            };
        }
    }

    /// How high above its tip a tool that stays at its height passes over a column.
    fn rise_on_level(&self, arm: DVec2) -> f64 {
        let Way::Arc { radius, start, end, turn, sweep, .. } = self.way else { return f64::INFINITY };
        let square = self.cutter.radius * self.cutter.radius;
        let beside = sweep >= TAU || {
            let (after, before) = (start.perp_dot(arm) * turn >= 0.0, arm.perp_dot(end) * turn >= 0.0);
            if sweep <= PI { after && before } else { after || before }
        };
        let far = if beside {
            let off = arm.length() - radius;
            off * off
        } else {
            (arm - start * radius).length_squared().min((arm - end * radius).length_squared())
        };
        if far > square {
            f64::INFINITY
        } else if self.cutter.tip == Tip::Flat {
            0.0
        } else {
            self.cutter.rise(far.sqrt())
        }
    }

    /// How high above the start of a helix the tool passes over a column at its lowest.
    fn rise_on_helix(&self, arm: DVec2) -> f64 {
        let Way::Arc { radius, start, end, turn, sweep, rise, .. } = self.way else { return f64::INFINITY };
        let square = self.cutter.radius * self.cutter.radius;
        let flat = self.cutter.tip == Tip::Flat;
        let ball = matches!(self.cutter.tip, Tip::Round(corner) if corner >= self.cutter.radius);
        let lowest = if rise < 0.0 { end } else { start };
        if flat && (arm - lowest * radius).length_squared() <= square {
            return rise.min(0.0);
        }
        let out = arm.length();
        if (out - radius).abs() > self.cutter.radius {
            return f64::INFINITY;
        }
        // How far the tool may be turned away from the column and still be over it.
        let share = if out > 0.0 { (out * out + radius * radius - square) / (2.0 * out * radius) } else { -1.0 };
        let slope = rise / sweep;
        if flat && sweep <= FRAC_PI_2 && share > -1.0 {
            // It is over the column up to there, or from there on, and not at the lower end.
            let (cos, sin) = (share.min(1.0), (1.0 - share * share).max(0.0).sqrt());
            let way = arm / out;
            let there = way * cos + way.perp() * (sin * turn * -rise.signum());
            let angle = angle_of(turn * start.perp_dot(there), start.dot(there));
            let within = angle >= -1e-12 && angle <= sweep + 1e-12;
            return if within { slope * angle.clamp(0.0, sweep) } else { f64::INFINITY };
        }
        if sweep <= PI && (start.perp_dot(arm) * turn < 0.0 || arm.perp_dot(end) * turn < 0.0) {
            let near = (arm - start * radius).length_squared().min((arm - end * radius).length_squared());
            if near > square {
                return f64::INFINITY;
            }
        }
        let reach = if share <= -1.0 { PI } else { libm::acos(share.min(1.0)) };
        let own = angle_of(turn * start.perp_dot(arm) / out, start.dot(arm) / out);
        if ball && share > 0.0 && sweep <= FRAC_PI_2 {
            let ends = [(own - reach).max(0.0), (own + reach).min(sweep)];
            return if ends[0] <= ends[1] { self.balanced(slope, own, ends, out, radius) } else { f64::INFINITY };
        }
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

    /// Height of the envelope over a column at the angle `own` while the tool stands at another angle.
    fn height_at(&self, slope: f64, own: f64, at: f64, out: f64, radius: f64) -> f64 {
        let far = (out * out + radius * radius - 2.0 * out * radius * libm::cos(at - own)).max(0.0).sqrt();
        slope * at + self.cutter.rise(far.min(self.cutter.radius))
    }

    /// The lowest height of a ball between two angles that are less than a quarter turn away from the column: there the
    /// height is convex, and has one place where the slopes balance.
    fn balanced(&self, slope: f64, own: f64, [first, last]: [f64; 2], out: f64, radius: f64) -> f64 {
        let half = out * radius;
        let room = self.cutter.radius * self.cutter.radius - out * out - radius * radius;
        let (mut low, mut high) = (first, last);
        let mut at = own.clamp(first, last);
        for _ in 0..STEPS {
            let (sin, cos) = (libm::sin(at - own), libm::cos(at - own));
            let up = (room + 2.0 * half * cos).max(1e-18).sqrt();
            let steep = half * sin / up;
            let rate = slope + steep;
            *(if rate > 0.0 { &mut high } else { &mut low }) = at;
            let next = at - rate / ((half * cos + steep * steep) / up);
            let next = if next > low && next < high { next } else { 0.5 * (low + high) };
            let far = (next - at).abs();
            at = next;
            if far < NEAR {
                break;
            }
        }
        let height = |at: f64| self.height_at(slope, own, at, out, radius);
        height(at).min(height(first)).min(height(last))
    }

    /// The lowest height on the part of a helix that passes over a column whose angle is `angle`.
    fn lowest_on_turn(&self, slope: f64, angle: f64, [first, last]: [f64; 2], out: f64, radius: f64) -> f64 {
        let height = |at: f64| self.height_at(slope, angle, at, out, radius);
        let (down, up) = if slope < 0.0 { (last, first) } else { (first, last) };
        if self.cutter.tip == Tip::Flat {
            return height(down);
        }
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
