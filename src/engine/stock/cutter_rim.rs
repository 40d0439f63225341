//! What a flat tool on a ramp or on a short piece of a helix leaves at its rim: a column keeps the height at which the
//! tool leaves it on the way down, or comes to it on the way up.
//!
//! Columns are points in coordinates of the way: along it and to its left from the start of a line; of an arc towards
//! its start and towards where it goes from there, from its centre. Invariant: nothing here branches, so that several
//! columns are worked on side by side.
use glam::DVec2;

use super::columns::{larger, smaller};
use super::grid::Grid;
use super::sweep::{NARROW, Sweep, Way};

/// How far, as the tangent of half an angle, a column may lie off the ends of a way by rounding.
const EDGE: f64 = 5e-13;

/// Up to this angle, in radians, a few terms of the series of the arc tangent are enough.
const BRIEF: f64 = 0.03;

/// Twice the arc tangent of a number up to a tenth, the tangent of half of [`NARROW`], or of half of [`BRIEF`]: the
/// rest of the series is below rounding.
#[inline(always)]
fn angle_of_half<const IS_BRIEF: bool>(tan: f64) -> f64 {
    let q = tan * tan;
    if IS_BRIEF {
        return tan * (2.0 - q * (2.0 / 3.0 - q * (2.0 / 5.0 - q * (2.0 / 7.0))));
    }
    let tail = 2.0 / 9.0 - q * (2.0 / 11.0 - q * (2.0 / 13.0));
    tan * (2.0 - q * (2.0 / 3.0 - q * (2.0 / 5.0 - q * (2.0 / 7.0 - q * tail))))
}

/// The rows of a grid in coordinates of a way.
#[derive(Clone, Copy, Debug)]
pub(super) struct Seen {
    /// Where the first column of a row at y = 0 lies.
    first: [f64; 2],
    /// From one column to the next, and over a mm of y.
    pub step: [f64; 2],
    rise: [f64; 2],
}

impl Seen {
    /// As seen from a point; `turn` is +1, or -1 if the second coordinate grows to the right of
    /// the first one's direction.
    fn new(grid: &Grid, from: DVec2, ahead: DVec2, turn: f64) -> Self {
        let (dx, step) = (grid.x(0) - from.x, grid.cell.x);
        Self {
            first: [dx * ahead.x - from.y * ahead.y, -turn * (dx * ahead.y + from.y * ahead.x)],
            step: [step * ahead.x, -turn * step * ahead.y],
            rise: [ahead.y, turn * ahead.x],
        }
    }

    /// Where the first column of a row lies.
    #[inline(always)]
    pub(super) fn row(&self, y: f64) -> [f64; 2] {
        [self.first[0] + y * self.rise[0], self.first[1] + y * self.rise[1]]
    }

    /// Where another column of that row lies.
    #[inline(always)]
    pub(super) fn column(&self, row: [f64; 2], n: f64) -> [f64; 2] {
        [row[0] + n * self.step[0], row[1] + n * self.step[1]]
    }
}

/// A way of a flat tool that ends or begins lower than the other end.
pub(super) trait Trail {
    /// The height that it leaves in a column; infinity where the tool does not come.
    fn height(&self, p: [f64; 2]) -> f64;

    /// What distinguishes places across the way, see [`Sweep::across`].
    fn across(&self, p: [f64; 2]) -> f64;
}

/// A straight ramp.
#[derive(Clone, Copy, Debug)]
pub(super) struct Slope {
    square: f64,
    length: f64,
    z: f64,
    slope: f64,
}

impl Trail for Slope {
    #[inline(always)]
    fn height(&self, [u, v]: [f64; 2]) -> f64 {
        let room = self.square - v * v;
        let reach = larger(room, 0.0).sqrt();
        let (first, last) = (larger(u - reach, 0.0), smaller(u + reach, self.length));
        let height = self.z + self.slope * if self.slope > 0.0 { first } else { last };
        if (room >= 0.0) & (first <= last) { height } else { f64::INFINITY }
    }

    #[inline(always)]
    fn across(&self, [_, v]: [f64; 2]) -> f64 {
        v
    }
}

/// A short piece of a helix.
#[derive(Clone, Copy, Debug)]
pub(super) struct Helix {
    square: f64,
    /// By how much the square of its radius is greater than that of the tool's, and half of one over its radius.
    most: f64,
    half: f64,
    /// +1 where the tool leaves columns, -1 where it comes to them.
    side: f64,
    /// Its angle, and the tangent of half of that.
    sweep: f64,
    tan: f64,
    /// Height at the start, the rise in a radian, and the lowest height.
    z: f64,
    slope: f64,
    low: f64,
    /// Where the tool is lowest.
    end: [f64; 2],
}

impl Helix {
    /// The tool at an angle has a column at its rim where `x cos + y sin` is a `middle` that the three distances give;
    /// written in the tangent of half the angle that is a quadratic equation, whose root has two forms. One of them at
    /// least is not the quotient of two small numbers; about a far centre that is always the same one.
    #[inline(always)]
    fn left<const IS_USUAL: bool>(&self, [x, y]: [f64; 2]) -> f64 {
        let distance = x * x + y * y;
        let middle = (distance + self.most) * self.half;
        let rest = distance - middle * middle;
        let beside = self.side * larger(rest, 0.0).sqrt();
        let (one, other) = (x + middle, y - beside);
        let steady = IS_USUAL || one.abs() > other.abs();
        let tan = if steady { y + beside } else { middle - x } / if steady { one } else { other };
        let angle = smaller(larger(angle_of_half::<IS_USUAL>(tan), 0.0), self.sweep);
        let within = (rest >= 0.0) & (tan >= -EDGE) & (tan <= self.tan);
        let height = if within { self.z + self.slope * angle } else { f64::INFINITY };
        let (dx, dy) = (x - self.end[0], y - self.end[1]);
        if dx * dx + dy * dy <= self.square { self.low } else { height }
    }
}

impl Trail for Helix {
    #[inline(always)]
    fn height(&self, p: [f64; 2]) -> f64 {
        self.left::<false>(p)
    }

    #[inline(always)]
    fn across(&self, [x, y]: [f64; 2]) -> f64 {
        x * x + y * y
    }
}

/// A helix whose angle is [`BRIEF`], about a centre that is well outside of the tool.
#[derive(Clone, Copy, Debug)]
pub(super) struct Usual(Helix);

impl Trail for Usual {
    #[inline(always)]
    fn height(&self, p: [f64; 2]) -> f64 {
        self.0.left::<true>(p)
    }

    #[inline(always)]
    fn across(&self, p: [f64; 2]) -> f64 {
        self.0.across(p)
    }
}

/// What a way leaves.
#[derive(Clone, Copy, Debug)]
pub(super) enum Leaving {
    Slope(Slope),
    Helix(Helix),
    Usual(Usual),
}

impl Leaving {
    /// Of a flat tool on a way that rises or falls; nothing on an arc that is not short.
    pub(super) fn new(grid: &Grid, sweep: &Sweep) -> Option<(Self, Seen)> {
        let square = sweep.cutter.radius * sweep.cutter.radius;
        match sweep.way {
            Way::Line { from, along, length, rise } if rise != 0.0 && length > 0.0 => {
                let slope = Slope { square, length, z: from.z, slope: rise / length };
                Some((Self::Slope(slope), Seen::new(grid, DVec2::new(from.x, from.y), along, 1.0)))
            }
            Way::Arc { centre, radius, start, end, turn, sweep, z, rise } if rise != 0.0 && sweep < NARROW => {
                let [cos, sin] = [start.dot(end), turn * start.perp_dot(end)];
                let end = if rise < 0.0 { [radius * cos, radius * sin] } else { [radius, 0.0] };
                let helix = Helix {
                    square,
                    most: radius * radius - square,
                    half: 0.5 / radius,
                    side: -rise.signum(),
                    sweep,
                    tan: sin / (1.0 + cos) + EDGE,
                    z,
                    slope: rise / sweep,
                    low: z + rise.min(0.0),
                    end,
                };
                let usual = sweep < BRIEF && radius * radius > 2.0 * square;
                let leaving = if usual { Self::Usual(Usual(helix)) } else { Self::Helix(helix) };
                Some((leaving, Seen::new(grid, centre, start, turn)))
            }
            _ => None,
        }
    }
}
