//! The four surfaces that bound the solids: plane, sphere, cylinder, cone; infinite, with an inside.
//!
//! Invariant: `signed` is negative inside, zero on the surface, positive outside, and changes by at most the
//! way that a point moves; it is the exact distance wherever the foot of the perpendicular exists.
use super::path::Piece;
use super::poly::Poly;
use glam::DVec3;

/// Two surfaces closer together than this (mm, or as a direction) are the same surface.
pub(super) const SAME: f64 = 1e-11;

/// A surface; all directions are unit vectors.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Surface {
    /// Inside is where `normal · p < offset`.
    Plane { normal: DVec3, offset: f64 },
    /// Inside is within the radius.
    Sphere { centre: DVec3, radius: f64 },
    /// Inside is within the radius about the line.
    Cylinder { origin: DVec3, axis: DVec3, radius: f64 },
    /// One nappe that opens along the axis; inside is around the axis. Sine and cosine of half the opening angle.
    Cone { apex: DVec3, axis: DVec3, sin: f64, cos: f64 },
}

/// The way from a point of a line to `p`, split into height along the axis and the vector across it.
pub(super) fn split(p: DVec3, origin: DVec3, axis: DVec3) -> (f64, DVec3) {
    let way = p - origin;
    let height = way.dot(axis);
    (height, way - axis * height)
}

/// The unit vector, or any one across the axis for the zero vector.
fn direction_across(across: DVec3, axis: DVec3) -> DVec3 {
    across.try_normalize().unwrap_or_else(|| axis.any_orthonormal_vector())
}

impl Surface {
    /// Distance to the surface, negative inside.
    pub(super) fn signed(&self, p: DVec3) -> f64 {
        match *self {
            Self::Plane { normal, offset } => normal.dot(p) - offset,
            Self::Sphere { centre, radius } => (p - centre).length() - radius,
            Self::Cylinder { origin, axis, radius } => split(p, origin, axis).1.length() - radius,
            Self::Cone { apex, axis, sin, cos } => {
                let (height, across) = split(p, apex, axis);
                across.length() * cos - height * sin
            }
        }
    }

    /// The unit normal away from the inside, at or near the surface.
    pub(super) fn normal(&self, p: DVec3) -> DVec3 {
        match *self {
            Self::Plane { normal, .. } => normal,
            Self::Sphere { centre, .. } => (p - centre).try_normalize().unwrap_or(DVec3::Z),
            Self::Cylinder { origin, axis, .. } => direction_across(split(p, origin, axis).1, axis),
            Self::Cone { apex, axis, sin, cos } => direction_across(split(p, apex, axis).1, axis) * cos - axis * sin,
        }
    }

    /// The nearest point of the surface (of the lateral line, for a cone).
    pub(super) fn foot(&self, p: DVec3) -> DVec3 {
        p - self.normal(p) * self.signed(p)
    }

    /// The point where the surface has no tangent plane.
    pub(super) fn apex(&self) -> Option<DVec3> {
        match *self {
            Self::Cone { apex, .. } => Some(apex),
            _ => None,
        }
    }

    /// Whether the other is the same surface: `Some(true)` with the same inside, `Some(false)` turned about.
    pub(super) fn same(&self, other: &Self) -> Option<bool> {
        let near = |a: DVec3, b: DVec3| (a - b).length() <= SAME;
        let close = |a: f64, b: f64| (a - b).abs() <= SAME;
        match (*self, *other) {
            (Self::Plane { normal: n, offset: d }, Self::Plane { normal: m, offset: e }) => {
                if near(n, m) && close(d, e) {
                    Some(true)
                } else if near(n, -m) && close(d, -e) {
                    Some(false)
                } else {
                    None
                }
            }
            (Self::Sphere { centre: a, radius: r }, Self::Sphere { centre: b, radius: s }) => {
                (near(a, b) && close(r, s)).then_some(true)
            }
            (Self::Cylinder { origin: a, axis: u, radius: r }, Self::Cylinder { origin: b, axis: v, radius: s }) => {
                let parallel = near(u, v) || near(u, -v);
                (parallel && close(r, s) && split(b, a, u).1.length() <= SAME).then_some(true)
            }
            (Self::Cone { apex: a, axis: u, sin: s, .. }, Self::Cone { apex: b, axis: v, sin: t, .. }) => {
                (near(a, b) && near(u, v) && close(s, t)).then_some(true)
            }
            _ => None,
        }
    }

    /// A polynomial that is zero wherever the piece has the signed distance `gap` from the surface. It may
    /// be zero elsewhere too (the other nappe); nothing if no point can have that distance.
    pub(super) fn at_gap(&self, piece: &Piece, gap: f64) -> Option<Poly> {
        let weight = piece.weight();
        let round =
            |square: Poly, radius: f64| (radius >= 0.0).then(|| square.sub(weight.square().scale(radius * radius)));
        match *self {
            Self::Plane { normal, offset } => Some(piece.along(normal, normal * offset).sub(weight.scale(gap))),
            Self::Sphere { centre, radius } => round(piece.square(centre), radius + gap),
            Self::Cylinder { origin, axis, radius } => round(piece.square_across(axis, origin), radius + gap),
            Self::Cone { apex, axis, sin, cos } => {
                let side = piece.along(axis, apex).scale(sin).add(weight.scale(gap));
                Some(piece.square_across(axis, apex).scale(cos * cos).sub(side.square()))
            }
        }
    }
}
