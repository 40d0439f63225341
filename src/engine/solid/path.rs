//! Paths of the ball centre: straight lines, circular arcs, helices.
//!
//! Invariant: lines and arcs are made of rational pieces `N(u) / w(u)` with quadratic polynomials, exact and
//! not approximated; neighbouring pieces overlap by a hair, so a root on the seam belongs to one of them.
use super::poly::Poly;
use crate::base::expr::{cosd, sind};
use glam::DVec3;

/// A path; its parameter t runs from 0 (start) to 1 (end) in proportion to the way.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Path {
    /// A straight line.
    Line {
        /// Start.
        from: DVec3,
        /// End.
        to: DVec3,
    },
    /// A circular arc, or a helix if it rises.
    Arc {
        /// A point of the axis, at the height of the start.
        centre: DVec3,
        /// Direction of the axis.
        axis: DVec3,
        /// Start.
        from: DVec3,
        /// Angle in degrees, positive counter-clockwise seen against the axis; more than 360 is allowed.
        sweep: f64,
        /// Way along the axis in mm over the whole sweep.
        rise: f64,
    },
}

/// Arcs are cut into pieces of at most this many degrees, which keeps the half-angle form well conditioned.
const PIECE_DEGREES: f64 = 60.0;
/// How far, as a share of its length, a piece reaches beyond its ends.
const OVERLAP: f64 = 1e-9;

impl Path {
    /// The straight line between two points.
    pub const fn line(from: DVec3, to: DVec3) -> Self {
        Self::Line { from, to }
    }

    /// The point at parameter t.
    pub fn at(&self, t: f64) -> DVec3 {
        match *self {
            Self::Line { from, to } => from + (to - from) * t,
            Self::Arc { centre, axis, from, sweep, rise } => {
                let Arm { axis, x, y } = Arm::new(centre, axis, from);
                let foot = from - x;
                foot + x * cosd(sweep * t) + y * sind(sweep * t) + axis * (rise * t)
            }
        }
    }

    /// The same path elsewhere.
    #[must_use]
    pub fn moved(&self, by: DVec3) -> Self {
        match *self {
            Self::Line { from, to } => Self::line(from + by, to + by),
            Self::Arc { centre, axis, from, sweep, rise } => {
                Self::Arc { centre: centre + by, axis, from: from + by, sweep, rise }
            }
        }
    }

    /// The length of the way in mm.
    pub fn length(&self) -> f64 {
        match *self {
            Self::Line { from, to } => (to - from).length(),
            Self::Arc { centre, axis, from, sweep, rise } => {
                let way = Arm::new(centre, axis, from).x.length() * sweep.to_radians();
                libm::hypot(way, rise)
            }
        }
    }

    /// The points of an arc at which a coordinate is greatest or least, apart from its ends.
    pub fn extremes(&self) -> Vec<DVec3> {
        let Self::Arc { centre, axis, from, sweep, rise } = *self else { return Vec::new() };
        if sweep == 0.0 {
            return Vec::new();
        }
        let arm = Arm::new(centre, axis, from);
        let climb = arm.axis * (rise / sweep.to_radians());
        let (low, high) = (sweep.min(0.0), sweep.max(0.0));
        let mut points = Vec::new();
        for ((x, y), climb) in arm.x.to_array().into_iter().zip(arm.y.to_array()).zip(climb.to_array()) {
            let reach = libm::hypot(x, y);
            if climb.abs() >= reach {
                continue;
            }
            // d/da of reach * cos(a - peak) + climb * a is zero at these angles, once in every turn.
            let (peak, lean) = (libm::atan2(y, x).to_degrees(), libm::asin(climb / reach).to_degrees());
            for angle in [peak + lean, peak + 180.0 - lean] {
                let first = angle + 360.0 * libm::ceil((low - angle) / 360.0);
                let last = angle + 360.0 * libm::floor((high - angle) / 360.0);
                if first <= last {
                    points.extend([self.at(first / sweep), self.at(last / sweep)]);
                }
            }
        }
        points
    }

    pub(super) fn is_finite(&self) -> bool {
        match *self {
            Self::Line { from, to } => from.is_finite() && to.is_finite(),
            Self::Arc { centre, axis, from, sweep, rise } => {
                let numbers = centre.is_finite() && axis.is_finite() && from.is_finite();
                numbers && sweep.is_finite() && rise.is_finite() && axis.length() > 0.0
            }
        }
    }

    /// Whether it rises while it turns: such a path has no rational pieces.
    pub(super) fn is_helix(&self) -> bool {
        matches!(self, Self::Arc { rise, .. } if *rise != 0.0)
    }

    /// The rational pieces in the order of travel. A helix and an arc of no sweep have none.
    pub(super) fn pieces(&self) -> Vec<Piece> {
        match *self {
            Self::Line { from, to } => vec![Piece::line(from, to - from, 0.0, 1.0)],
            Self::Arc { centre, axis, from, sweep, rise } if rise == 0.0 && sweep != 0.0 => {
                let arm = Arm::new(centre, axis, from);
                arc_pieces(from - arm.x, arm.x, arm.y, sweep)
            }
            Self::Arc { .. } => Vec::new(),
        }
    }
}

/// The arm from the axis to the start of an arc, and where it points after 90 degrees.
struct Arm {
    axis: DVec3,
    x: DVec3,
    y: DVec3,
}

impl Arm {
    fn new(centre: DVec3, axis: DVec3, from: DVec3) -> Self {
        let axis = axis.normalize_or_zero();
        let arm = from - centre;
        let x = arm - axis * arm.dot(axis);
        Self { axis, x, y: axis.cross(x) }
    }
}

/// The pieces of the arc `centre + x cos a + y sin a` for a from 0 to `sweep` degrees.
pub(super) fn arc_pieces(centre: DVec3, x: DVec3, y: DVec3, sweep: f64) -> Vec<Piece> {
    let count = libm::ceil(sweep.abs() / PIECE_DEGREES).clamp(1.0, 1e6);
    let step = sweep / count;
    (0..count as usize)
        .map(|k| {
            let middle = (k as f64 + 0.5) * step;
            let (c, s) = (cosd(middle), sind(middle));
            let (x, y) = (x * c + y * s, y * c - x * s);
            let end = libm::tan((step / 4.0).to_radians());
            let time = Time::Arc { middle: middle / sweep, per_degree: 1.0 / sweep };
            Piece::new([centre + x, 2.0 * y, centre - x], [1.0, 1.0], (-end).min(end), (-end).max(end), time)
        })
        .collect()
}

/// How the parameter of a piece gives the parameter of the path.
#[derive(Clone, Copy, Debug)]
enum Time {
    Same,
    Arc { middle: f64, per_degree: f64 },
}

/// A piece `N(u) / (w0 + w2 u²)` for u in `[low, high]`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Piece {
    n: [DVec3; 3],
    w: [f64; 2],
    pub(super) low: f64,
    pub(super) high: f64,
    time: Time,
}

impl Piece {
    fn new(n: [DVec3; 3], w: [f64; 2], low: f64, high: f64, time: Time) -> Self {
        let margin = (high - low) * OVERLAP;
        Self { n, w, low: low - margin, high: high + margin, time }
    }

    /// The line `from + direction u`.
    pub(super) fn line(from: DVec3, direction: DVec3, low: f64, high: f64) -> Self {
        Self::new([from, direction, DVec3::ZERO], [1.0, 0.0], low, high, Time::Same)
    }

    pub(super) fn at(&self, u: f64) -> DVec3 {
        let [a, b, c] = self.n;
        (a + (b + c * u) * u) / (self.w[0] + self.w[1] * u * u)
    }

    /// The derivative by u.
    pub(super) fn speed(&self, u: f64) -> DVec3 {
        let [_, b, c] = self.n;
        let w = self.w[0] + self.w[1] * u * u;
        (b + c * (2.0 * u) - self.at(u) * (2.0 * self.w[1] * u)) / w
    }

    /// The parameter of the whole path, kept within 0 and 1.
    pub(super) fn t(&self, u: f64) -> f64 {
        match self.time {
            Time::Same => u,
            Time::Arc { middle, per_degree } => middle + 2.0 * libm::atan(u).to_degrees() * per_degree,
        }
        .clamp(0.0, 1.0)
    }

    /// Whether the path runs through the piece towards smaller u.
    pub(super) fn backwards(&self) -> bool {
        matches!(self.time, Time::Arc { per_degree, .. } if per_degree < 0.0)
    }

    /// The denominator.
    pub(super) fn weight(&self) -> Poly {
        Poly::quadratic(self.w[0], 0.0, self.w[1])
    }

    /// The component along `direction` of the way from `origin`, times the denominator.
    pub(super) fn along(&self, direction: DVec3, origin: DVec3) -> Poly {
        let [a, b, c] = self.n;
        let (a, c) = (a - origin * self.w[0], c - origin * self.w[1]);
        Poly::quadratic(direction.dot(a), direction.dot(b), direction.dot(c))
    }

    /// The squared distance from `origin`, times the square of the denominator.
    pub(super) fn square(&self, origin: DVec3) -> Poly {
        let [x, y, z] = [DVec3::X, DVec3::Y, DVec3::Z].map(|unit| self.along(unit, origin).square());
        x.add(y).add(z)
    }

    /// The squared distance from the line through `origin` along a unit vector, times the squared denominator.
    ///
    /// Sums the squares of two components across the axis: subtracting the one along it would cancel.
    pub(super) fn square_across(&self, axis: DVec3, origin: DVec3) -> Poly {
        let (x, y) = axis.any_orthonormal_pair();
        self.along(x, origin).square().add(self.along(y, origin).square())
    }
}
