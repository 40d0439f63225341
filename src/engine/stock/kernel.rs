//! How low the envelope of a tool on a straight way reaches in the columns of a block.
//!
//! Where there is a closed form nothing branches, so that several columns are worked on side by side. Only a bull nose
//! on a ramp has none; there the balance of path and end is found by bisection down to rounding.
use std::ops::Range;

use glam::{DVec2, DVec3};

use super::columns::{BLOCK, OFFSETS, WIDE};
use super::cutter::Tip;
use super::sweep::{Hull, Sweep, Way};

/// Steps of a bisection; each halves an interval of some mm or radians.
pub(super) const BISECTIONS: usize = 50;
/// The share of a ball's radius within which its end is not too steep for a tangent to say something.
const GENTLE: f64 = 0.98;

/// Gives columns the heights that belong to their numbers, always so many together as are worked on side by side.
#[inline(always)]
pub(super) fn fill(out: &mut [f64; BLOCK], columns: Range<usize>, height: impl Fn(f64) -> f64) {
    let chunks = columns.start / WIDE..columns.end.div_ceil(WIDE);
    let (out, offsets) = (out.as_chunks_mut::<WIDE>().0, OFFSETS.as_chunks::<WIDE>().0);
    let (Some(out), Some(offsets)) = (out.get_mut(chunks.clone()), offsets.get(chunks)) else { return };
    for (out, offsets) in out.iter_mut().zip(offsets) {
        for n in 0..WIDE {
            out[n] = height(offsets[n]);
        }
    }
}

/// The same for columns that are seldom more than a few: those are then the only ones.
#[inline(always)]
pub(super) fn fill_few(out: &mut [f64; BLOCK], columns: Range<usize>, height: impl Fn(f64) -> f64) {
    if columns.len() > WIDE {
        return fill(out, columns, height);
    }
    for (out, n) in out.get_mut(columns.clone()).unwrap_or_default().iter_mut().zip(OFFSETS.get(columns).unwrap_or(&[]))
    {
        *out = height(*n);
    }
}

/// The square root, and nothing where there is none: infinity takes its place.
#[inline(always)]
pub(super) fn under(top: f64, rest: f64) -> f64 {
    let height = top - if rest > 0.0 { rest } else { 0.0 }.sqrt();
    if rest >= 0.0 { height } else { f64::INFINITY }
}

/// A number between two others.
#[inline(always)]
fn between(number: f64, low: f64, high: f64) -> f64 {
    let number = if number < low { low } else { number };
    if number > high { high } else { number }
}

impl Sweep {
    /// The lowest heights of the envelope at the points `(x + n step, y)` for these numbers;
    /// infinity where it does not come.
    pub(super) fn heights(&self, at: [f64; 3], columns: Range<usize>, out: &mut [f64; BLOCK]) {
        match self.way {
            Way::Line { from, along, length, rise } if rise == 0.0 || length == 0.0 => {
                self.on_level(DVec3::new(from.x, from.y, from.z + rise.min(0.0)), along, length, at, columns, out);
            }
            Way::Line { from, along, length, rise } => self.on_ramp(from, along, [length, rise], at, columns, out),
            Way::Arc { .. } => self.arc_heights(at, columns, out),
        }
    }

    /// Along the path from its start, and across it: at the first column and from one to the next.
    fn along(from: DVec3, along: DVec2, [x, step, y]: [f64; 3]) -> [f64; 4] {
        let (dx, dy) = (x - from.x, y - from.y);
        [dx * along.x + dy * along.y, dy * along.x - dx * along.y, step * along.x, -step * along.y]
    }

    fn on_level(
        &self,
        from: DVec3,
        along: DVec2,
        length: f64,
        at: [f64; 3],
        columns: Range<usize>,
        out: &mut [f64; BLOCK],
    ) {
        let (z, radius) = (from.z, self.cutter.radius);
        let square = radius * radius;
        let [u, v, du, dv] = Self::along(from, along, at);
        // The square of the distance from the path.
        let far = |n: f64| {
            let (u, v) = (u + n * du, v + n * dv);
            let beyond = u - between(u, 0.0, length);
            beyond * beyond + v * v
        };
        match self.cutter.tip {
            Tip::Flat => fill(out, columns, |n| if far(n) <= square { z } else { f64::INFINITY }),
            Tip::Round(corner) if corner >= radius => fill(out, columns, |n| under(z + radius, square - far(n))),
            Tip::Round(corner) => {
                let flat = radius - corner;
                fill(out, columns, |n| {
                    let far = far(n);
                    let beyond = far.sqrt() - flat;
                    let beyond = if beyond > 0.0 { beyond } else { 0.0 };
                    let rest = corner * corner - beyond * beyond;
                    let height = z + corner - if rest > 0.0 { rest } else { 0.0 }.sqrt();
                    if far <= square { height } else { f64::INFINITY }
                });
            }
            Tip::Point(steep) => fill(out, columns, |n| {
                let far = far(n);
                if far <= square { z + steep * far.sqrt() } else { f64::INFINITY }
            }),
        }
    }

    fn on_ramp(
        &self,
        from: DVec3,
        along: DVec2,
        [length, rise]: [f64; 2],
        at: [f64; 3],
        columns: Range<usize>,
        out: &mut [f64; BLOCK],
    ) {
        let (slope, radius) = (rise / length, self.cutter.radius);
        let square = radius * radius;
        let [u, v, du, dv] = Self::along(from, along, at);
        // The parts of the path that are near enough, as seen from the column.
        let parts = |n: f64| {
            let (u, v) = (u + n * du, v + n * dv);
            let room = square - v * v;
            let reach = if room > 0.0 { room } else { 0.0 }.sqrt();
            let first = if -u > -reach { -u } else { -reach };
            let last = if length - u < reach { length - u } else { reach };
            (u, v, first, last, room >= 0.0 && first <= last)
        };
        match self.cutter.tip {
            Tip::Flat => fill_few(out, columns, |n| {
                let (u, _, first, last, any) = parts(n);
                let height = from.z + slope * (u + if slope > 0.0 { first } else { last });
                if any { height } else { f64::INFINITY }
            }),
            Tip::Round(corner) if corner >= radius => {
                let (top, steep) = (from.z + radius, 1.0 + slope * slope);
                // The tool is lowest so many times its reach after a column; squares with their sign are compared, so
                // that only one root is drawn.
                let lean = -slope * slope.abs() / steep;
                fill(out, columns, |n| {
                    let (u, v) = (u + n * du, v + n * dv);
                    let room = square - v * v;
                    let (lag, past) = (lean * room, u - length);
                    let before = u * u.abs() + lag < 0.0;
                    let after = past * past.abs() + lag > 0.0;
                    let end = if before { 0.0 } else { length };
                    let rest = room - (u - end) * (u - end);
                    let ended = before || after;
                    let height = top + slope * if ended { end } else { u };
                    under(height, if ended { rest } else { room * steep })
                });
            }
            Tip::Point(steep) => {
                // A path that is steeper than the point leaves a column at its edge.
                let plunges = slope.abs() >= steep;
                let lag = if plunges { 0.0 } else { -slope / (steep * steep - slope * slope).sqrt() };
                fill(out, columns, |n| {
                    let (u, v, first, last, any) = parts(n);
                    let edge = if slope > 0.0 { first } else { last };
                    let best = if plunges { edge } else { between(lag * v.abs(), first, last) };
                    let height = from.z + slope * (u + best) + steep * (best * best + v * v).sqrt();
                    if any { height } else { f64::INFINITY }
                });
            }
            Tip::Round(corner) => fill(out, columns, |n| {
                let (u, v, first, last, any) = parts(n);
                if !any {
                    return f64::INFINITY;
                }
                let reach = (square - v * v).max(0.0).sqrt();
                let best = self.balance(slope, corner, v, reach).max(first).min(last);
                from.z + slope * (u + best) + self.cutter.rise(libm::hypot(best, v))
            }),
        }
    }

    /// Where along a ramp the end of a bull nose reaches lowest over a column at the distance `v` from the path: after
    /// (negative) or before it.
    fn balance(&self, slope: f64, corner: f64, v: f64, reach: f64) -> f64 {
        let flat = self.cutter.radius - corner;
        // The slope of the end along the path at the distance s from the column.
        let steepness = |s: f64| {
            let far = libm::hypot(s, v);
            let beyond = (far - flat).max(0.0);
            let depth = (corner * corner - beyond * beyond).max(0.0).sqrt();
            if beyond == 0.0 { 0.0 } else { beyond / depth * (s / far) }
        };
        let (mut near, mut far) = (0.0, reach);
        for _ in 0..BISECTIONS {
            let middle = 0.5 * (near + far);
            if steepness(middle) < slope.abs() { near = middle } else { far = middle }
        }
        -slope.signum() * near
    }

    /// A straight line below which nothing of the envelope of a ball comes in the row through a point: its height there
    /// and how it rises in a mm. The envelope of its hull is convex, so that is a tangent.
    pub(super) fn tangent(&self, p: DVec2) -> Option<[f64; 2]> {
        let Hull { from, along, length, slope, steep, radius } = self.hull?;
        let [u, v, du, dv] = Self::along(from, along, [p.x, 1.0, p.y]);
        if v.abs() > GENTLE * radius {
            return None;
        }
        let reach = (radius * radius - v * v).sqrt();
        let best = u - slope / steep * reach;
        if best >= 0.0 && best <= length {
            return Some([from.z + slope * u - steep * reach, slope * du + steep * v * dv / reach]);
        }
        let at = between(best, 0.0, length);
        let beyond = u - at;
        let rest = radius * radius - v * v - beyond * beyond;
        if rest < (1.0 - GENTLE * GENTLE) * radius * radius {
            return None;
        }
        let depth = rest.sqrt();
        Some([from.z + slope * at - depth, (v * dv + beyond * du) / depth])
    }
}
