//! The edges in which two surfaces meet, as far as they are lines and circles.
//!
//! Invariant: a pair of surfaces either gives all of its common curves exactly, or says that it cannot.
use super::path::{Piece, arc_pieces};
use super::poly::Poly;
use super::surface::{SAME, Surface, split};
use glam::DVec3;

/// Lines are followed as far as this from their foot point, in mm: beyond any axis of a machine.
const REACH: f64 = 2e5;
/// Directions count as parallel or perpendicular below this; over 1000 mm that is 1e-9 mm.
const PARALLEL: f64 = 1e-12;

/// Surfaces that overlap by less than this (mm) only touch.
const OVERLAP: f64 = 1e-10;

/// An edge curve; directions are unit vectors.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Curve {
    Line { origin: DVec3, direction: DVec3 },
    Circle { centre: DVec3, axis: DVec3, radius: f64 },
}

/// The curves in which two surfaces meet.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Meeting {
    /// All of them, perhaps none.
    Curves(Vec<Curve>),
    /// Neither lines nor circles: not supported.
    Other,
}

impl Curve {
    /// The nearest point of the curve; any of them where all are equally near.
    pub(super) fn foot(&self, p: DVec3) -> DVec3 {
        match *self {
            Self::Line { origin, direction } => origin + direction * (p - origin).dot(direction),
            Self::Circle { centre, axis, radius } => {
                let across = split(p, centre, axis).1;
                centre + across.try_normalize().unwrap_or_else(|| axis.any_orthonormal_vector()) * radius
            }
        }
    }

    /// A polynomial that is zero wherever the piece has the distance `radius` from the curve.
    pub(super) fn at_distance(&self, piece: &Piece, radius: f64) -> Poly {
        let weight = piece.weight().square();
        match *self {
            Self::Line { origin, direction } => {
                piece.square_across(direction, origin).sub(weight.scale(radius * radius))
            }
            Self::Circle { centre, axis, radius: big } => {
                let rest = piece.square(centre).add(weight.scale(big * big - radius * radius));
                rest.square().sub(piece.square_across(axis, centre).mul(weight).scale(4.0 * big * big))
            }
        }
    }

    /// The curve itself as rational pieces.
    pub(super) fn pieces(&self) -> Vec<Piece> {
        match *self {
            Self::Line { origin, direction } => {
                // The foot point of the world's origin, so that the reach covers the machine.
                let near = origin - direction * origin.dot(direction);
                vec![Piece::line(near, direction, -REACH, REACH)]
            }
            Self::Circle { centre, axis, radius } => {
                let (x, y) = axis.any_orthonormal_pair();
                arc_pieces(centre, x * radius, y * radius, 360.0)
            }
        }
    }
}

fn one(curve: Curve) -> Meeting {
    Meeting::Curves(vec![curve])
}

fn none() -> Meeting {
    Meeting::Curves(Vec::new())
}

/// The curves in which two different surfaces meet.
pub(super) fn meet(a: &Surface, b: &Surface) -> Meeting {
    use Surface::{Cone, Cylinder, Plane, Sphere};
    match (*a, *b) {
        (Plane { normal: n, offset: d }, Plane { normal: m, offset: e }) => planes(n, d, m, e),
        (Plane { normal, offset }, other) | (other, Plane { normal, offset }) => plane_and(normal, offset, other),
        (Sphere { centre: a, radius: r }, Sphere { centre: b, radius: s }) => spheres(a, r, b, s),
        (Sphere { centre, radius }, Cylinder { origin, axis, radius: across })
        | (Cylinder { origin, axis, radius: across }, Sphere { centre, radius }) => {
            sphere_and_cylinder(centre, radius, origin, axis, across)
        }
        (Cylinder { origin: a, axis: u, radius: r }, Cylinder { origin: b, axis: v, radius: s }) => {
            cylinders(a, u, r, b, v, s)
        }
        (Cylinder { origin, axis: u, radius }, Cone { apex, axis, sin, cos })
        | (Cone { apex, axis, sin, cos }, Cylinder { origin, axis: u, radius }) => {
            cone_and_cylinder(apex, axis, sin, cos, origin, u, radius)
        }
        (Sphere { centre, radius }, Cone { apex, axis, sin, cos })
        | (Cone { apex, axis, sin, cos }, Sphere { centre, radius }) => {
            cone_and_sphere(apex, axis, sin, cos, centre, radius)
        }
        (Cone { apex: a, axis: u, sin: s, cos: c }, Cone { apex: b, axis: v, sin: t, cos: d }) => {
            cones(a, u, s / c, b, v, t / d)
        }
    }
}

fn planes(n: DVec3, d: f64, m: DVec3, e: f64) -> Meeting {
    let cross = n.cross(m);
    let square = cross.length_squared();
    if square <= PARALLEL * PARALLEL {
        return none();
    }
    let origin = (m.cross(cross) * d + cross.cross(n) * e) / square;
    one(Curve::Line { origin, direction: cross.normalize() })
}

fn plane_and(normal: DVec3, offset: f64, other: Surface) -> Meeting {
    match other {
        Surface::Plane { normal: m, offset: e } => planes(normal, offset, m, e),
        Surface::Sphere { centre, radius } => {
            let gap = normal.dot(centre) - offset;
            if radius - gap.abs() <= OVERLAP {
                return none();
            }
            ring(centre - normal * gap, normal, libm::sqrt(radius * radius - gap * gap))
        }
        Surface::Cylinder { origin, axis, radius } => plane_and_cylinder(normal, offset, origin, axis, radius),
        Surface::Cone { apex, axis, sin, cos } => {
            if normal.cross(axis).length() > PARALLEL {
                return Meeting::Other;
            }
            let height = (offset - normal.dot(apex)) / normal.dot(axis);
            if height <= 0.0 { none() } else { ring(apex + axis * height, axis, height * sin / cos) }
        }
    }
}

fn plane_and_cylinder(normal: DVec3, offset: f64, origin: DVec3, axis: DVec3, radius: f64) -> Meeting {
    let lean = normal.dot(axis);
    if normal.cross(axis).length() <= PARALLEL {
        return ring(origin + axis * ((offset - normal.dot(origin)) / lean), axis, radius);
    }
    if lean.abs() > PARALLEL {
        return Meeting::Other;
    }
    let gap = offset - normal.dot(origin);
    let depth = radius - gap.abs();
    let (foot, side) = (origin + normal * gap, axis.cross(normal).normalize());
    if depth.abs() <= OVERLAP {
        return one(Curve::Line { origin: foot, direction: axis });
    }
    if depth < 0.0 {
        return none();
    }
    let half = side * libm::sqrt(radius * radius - gap * gap);
    Meeting::Curves([half, -half].map(|way| Curve::Line { origin: foot + way, direction: axis }).to_vec())
}

/// A circle; a single point is no edge.
fn ring(centre: DVec3, axis: DVec3, radius: f64) -> Meeting {
    if radius <= SAME { none() } else { one(Curve::Circle { centre, axis, radius }) }
}

fn spheres(a: DVec3, r: f64, b: DVec3, s: f64) -> Meeting {
    let way = b - a;
    let distance = way.length();
    if !cross_over(distance, r, s) {
        return none();
    }
    let along = (distance * distance + r * r - s * s) / (2.0 * distance);
    let square = (r * r - along * along).max(0.0);
    ring(a + way * (along / distance), way / distance, libm::sqrt(square))
}

/// Whether two circles at this distance cross, and do not only touch.
fn cross_over(distance: f64, r: f64, s: f64) -> bool {
    distance < r + s - OVERLAP && distance > (r - s).abs() + OVERLAP
}

fn sphere_and_cylinder(centre: DVec3, radius: f64, origin: DVec3, axis: DVec3, across: f64) -> Meeting {
    let (height, off) = split(centre, origin, axis);
    let off = off.length();
    if off > SAME {
        let apart = off >= across + radius || off + radius <= across;
        return if apart { none() } else { Meeting::Other };
    }
    let depth = radius - across;
    let at = |height: f64| Curve::Circle { centre: origin + axis * height, axis, radius: across };
    if depth.abs() <= OVERLAP {
        return one(at(height));
    }
    if depth < 0.0 {
        return none();
    }
    let half = libm::sqrt(radius * radius - across * across);
    Meeting::Curves(vec![at(height - half), at(height + half)])
}

fn cylinders(a: DVec3, u: DVec3, r: f64, b: DVec3, v: DVec3, s: f64) -> Meeting {
    let cross = u.cross(v);
    let sine = cross.length();
    if sine > PARALLEL {
        let apart = (b - a).dot(cross).abs() / sine >= r + s;
        return if apart { none() } else { Meeting::Other };
    }
    let way = split(b, a, u).1;
    let distance = way.length();
    if distance <= SAME || distance > r + s + OVERLAP || distance < (r - s).abs() - OVERLAP {
        return none();
    }
    let along = (distance * distance + r * r - s * s) / (2.0 * distance);
    let foot = a + way * (along / distance);
    if !cross_over(distance, r, s) {
        return one(Curve::Line { origin: foot, direction: u });
    }
    let half = u.cross(way / distance) * libm::sqrt((r * r - along * along).max(0.0));
    Meeting::Curves([half, -half].map(|way| Curve::Line { origin: foot + way, direction: u }).to_vec())
}

fn cone_and_cylinder(apex: DVec3, axis: DVec3, sin: f64, cos: f64, origin: DVec3, u: DVec3, radius: f64) -> Meeting {
    let coaxial = axis.cross(u).length() <= PARALLEL && split(origin, apex, axis).1.length() <= SAME;
    if coaxial { ring(apex + axis * (radius * cos / sin), axis, radius) } else { Meeting::Other }
}

fn cone_and_sphere(apex: DVec3, axis: DVec3, sin: f64, cos: f64, centre: DVec3, radius: f64) -> Meeting {
    let (height, off) = split(centre, apex, axis);
    if off.length() > SAME {
        let gap = Surface::Cone { apex, axis, sin, cos }.signed(centre).abs();
        return if gap >= radius { none() } else { Meeting::Other };
    }
    // Along a generator at the way s from the apex: s² - 2 s height cos + height² = radius².
    let depth = radius - height.abs() * sin;
    if depth < -OVERLAP {
        return none();
    }
    let (middle, half) = (height * cos, libm::sqrt((radius * radius - height * height * sin * sin).max(0.0)));
    let ways = if depth <= OVERLAP { vec![middle] } else { vec![middle - half, middle + half] };
    let rings = ways.into_iter().filter(|s| s * sin > SAME);
    Meeting::Curves(rings.map(|s| Curve::Circle { centre: apex + axis * (s * cos), axis, radius: s * sin }).collect())
}

/// Two cones by the tangents of their half angles.
fn cones(a: DVec3, u: DVec3, s: f64, b: DVec3, v: DVec3, t: f64) -> Meeting {
    let (height, off) = split(b, a, u);
    if u.cross(v).length() > PARALLEL || off.length() > SAME {
        return Meeting::Other;
    }
    // Along the common axis from a: s h = ± t (h - height), both radii positive.
    let other = if u.dot(v) > 0.0 { t } else { -t };
    let slope = other - s;
    if slope.abs() <= PARALLEL {
        return none();
    }
    let h = other * height / slope;
    if h * s <= SAME { none() } else { ring(a + u * h, u, h * s) }
}
