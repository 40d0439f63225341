//! The parts of a scene cut by a plane: faces to be painted one over the other, material and holes in turn.
//!
//! Invariant: what cannot be cut exactly (a cone, a ball or a cylinder askew to the plane) is given by many corners.
use glam::{DAffine3, DVec2, DVec3};

use super::shot::Shot;
use super::window::Window;
use crate::base::expr::{cosd, sind};
use crate::engine::geometry::Frame;
use crate::engine::solid::Shape;
use crate::spec::FigureView;

/// A face in the plane.
#[derive(Clone, Debug)]
pub(super) struct Face {
    /// Whether there is material in it.
    pub(super) material: bool,
    /// What it is.
    pub(super) outline: Outline,
}

/// The outline of a face.
#[derive(Clone, Debug)]
pub(super) enum Outline {
    /// A circle.
    Circle(DVec2, f64),
    /// A polygon.
    Polygon(Vec<DVec2>),
}

/// How far a half-space is drawn.
const FAR: f64 = 1000.0;
/// Corners of a round outline that is no circle.
const CORNERS: usize = 72;

/// The middles of all parts and of their holes, in the coordinates of the shot.
pub(super) fn middles(shot: &Shot) -> Vec<DVec3> {
    fn take(shape: &Shape, frame: DAffine3, all: &mut Vec<DVec3>) {
        let middle = match shape {
            Shape::Placed { frame: inner, shape } => return take(shape, frame * affine(inner), all),
            Shape::Union(parts) | Shape::Difference(parts) => {
                return parts.iter().for_each(|part| take(part, frame, all));
            }
            Shape::Box { min, max } => (*min + *max) / 2.0,
            Shape::Cylinder { from, to, .. } | Shape::Cone { from, to, .. } => (*from + *to) / 2.0,
            Shape::Sphere { centre, .. } => *centre,
            Shape::HalfSpace { .. } | Shape::Mesh(_) => return,
        };
        let own = frame.transform_point3(middle);
        all.push(own);
    }
    let mut all = Vec::new();
    take(&shot.parts, shot.back, &mut all);
    all.into_iter().map(|p| shot.plane.flat(p).extend(shot.plane.tool.of(p))).collect()
}

fn affine(frame: &Frame) -> DAffine3 {
    let rows = frame.rows();
    let column = |n: usize| DVec3::new(rows[0][n], rows[1][n], rows[2][n]);
    DAffine3 { matrix3: glam::DMat3::from_cols(column(0), column(1), column(2)), translation: column(3) }
}

/// The faces of the parts in the plane of a view at `depth` along the axis that the view does not show.
pub(super) fn faces(shot: &Shot, view: FigureView, depth: f64) -> Vec<Face> {
    // To (right, up, towards the reader), with the plane at 0.
    let plane = shot.plane;
    let own = shot.back;
    let turned = move |p: DVec3| {
        let p = own.transform_point3(p);
        let p = plane.flat(p).extend(plane.tool.of(p));
        match view {
            FigureView::Plan | FigureView::RotaryC | FigureView::ThreeD => DVec3::new(p.x, p.y, p.z - depth),
            FigureView::Section | FigureView::Side | FigureView::Rotary | FigureView::RotaryB => {
                DVec3::new(p.x, p.z, depth - p.y)
            }
            FigureView::RotaryA => DVec3::new(p.y, p.z, p.x - depth),
            FigureView::Turned => DVec3::new(p.z, p.x, p.y - depth),
        }
    };
    let (origin, x, y, z) = (turned(DVec3::ZERO), turned(DVec3::X), turned(DVec3::Y), turned(DVec3::Z));
    let frame = DAffine3 { matrix3: glam::DMat3::from_cols(x - origin, y - origin, z - origin), translation: origin };
    let mut faces = Vec::new();
    cut(&shot.parts, frame, true, &mut faces);
    faces
}

/// The corners of a rectangle around all material; nothing where there is some without corners.
pub(super) fn bounds(faces: &[Face]) -> Option<[DVec2; 2]> {
    let mut found = [DVec2::INFINITY, DVec2::NEG_INFINITY];
    for face in faces.iter().filter(|face| face.material) {
        let Outline::Polygon(points) = &face.outline else { return None };
        for p in points {
            found = [found[0].min(*p), found[1].max(*p)];
        }
    }
    (found[0].x < found[1].x).then_some(found)
}

/// The pieces of the edges of all polygons at which there is material on one side only, and the edges of holes: behind
/// the plane one sees them.
pub(super) fn edges(faces: &[Face], window: &Window) -> Vec<[DVec2; 2]> {
    let polygons: Vec<(Vec<DVec2>, bool)> = faces
        .iter()
        .filter_map(|face| match &face.outline {
            Outline::Polygon(points) => {
                let ends = points.iter().all(|p| p.abs().max_element() < 0.9 * FAR);
                Some((window.clip(points), !face.material && ends))
            }
            Outline::Circle(..) => None,
        })
        .collect();
    let held = |p: DVec2| faces.iter().rev().find(|face| face.holds(p)).is_some_and(|face| face.material);
    let mut kept: Vec<[DVec2; 2]> = Vec::new();
    for ([a, b], seen) in polygons.iter().flat_map(|(polygon, seen)| sides(polygon).map(move |side| (side, *seen))) {
        let across = (b - a).normalize_or_zero().perp() * BESIDE;
        let mut places: Vec<f64> =
            polygons.iter().flat_map(|(other, _)| sides(other)).filter_map(|c| met([a, b], c)).collect();
        places.extend([0.0, 1.0]);
        places.sort_by(f64::total_cmp);
        for pair in places.windows(2).filter(|pair| (pair[1] - pair[0]) * a.distance(b) > BESIDE) {
            let middle = a.lerp(b, (pair[0] + pair[1]) / 2.0);
            let piece = [a.lerp(b, pair[0]), a.lerp(b, pair[1])];
            let known = |other: &[DVec2; 2]| {
                let near = |p: DVec2, q: DVec2| p.distance(q) < BESIDE;
                near(other[0], piece[0]) && near(other[1], piece[1])
                    || near(other[0], piece[1]) && near(other[1], piece[0])
            };
            if (seen || held(middle + across) != held(middle - across)) && !kept.iter().any(known) {
                match kept.last_mut() {
                    // The next piece of the same edge.
                    Some(last) if last[1] == piece[0] && (last[1] - last[0]).perp_dot(b - a).abs() < 1e-9 => {
                        last[1] = piece[1];
                    }
                    _ => kept.push(piece),
                }
            }
        }
    }
    kept
}

/// How far beside an edge it is looked for material, mm.
const BESIDE: f64 = 1e-6;

impl Face {
    fn holds(&self, p: DVec2) -> bool {
        match &self.outline {
            Outline::Circle(centre, radius) => p.distance(*centre) < *radius,
            // Convex, in either sense.
            Outline::Polygon(points) => {
                let turns: Vec<bool> = sides(points).map(|[a, b]| (b - a).perp_dot(p - a) > 0.0).collect();
                !turns.contains(&true) || !turns.contains(&false)
            }
        }
    }
}

fn sides(polygon: &[DVec2]) -> impl Iterator<Item = [DVec2; 2]> + '_ {
    polygon.iter().enumerate().map(|(n, a)| [*a, polygon.get((n + 1) % polygon.len()).copied().unwrap_or(*a)])
}

/// Where on its way the first of two lines crosses the second one, or one end of it.
fn met([a, b]: [DVec2; 2], [c, d]: [DVec2; 2]) -> Option<f64> {
    let (way, other) = (b - a, d - c);
    let turn = way.perp_dot(other);
    if turn.abs() < 1e-12 {
        // Along the same line: where the other one ends.
        let share = (c - a).dot(way) / way.length_squared();
        let off = way.normalize_or_zero().perp_dot(c - a);
        return (off.abs() < BESIDE && share > 0.0 && share < 1.0).then_some(share);
    }
    let (share, there) = ((c - a).perp_dot(other) / turn, (c - a).perp_dot(way) / turn);
    (share > 0.0 && share < 1.0 && (-1e-9..=1.0 + 1e-9).contains(&there)).then_some(share)
}

fn cut(shape: &Shape, frame: DAffine3, material: bool, faces: &mut Vec<Face>) {
    let mut take = |outline: Option<Outline>| {
        faces.extend(outline.map(|outline| Face { material, outline }));
    };
    match shape {
        Shape::Placed { frame: inner, shape } => {
            cut(shape, frame * affine(inner), material, faces);
        }
        Shape::Union(all) => all.iter().for_each(|one| cut(one, frame, material, faces)),
        Shape::Difference(all) => {
            for (n, one) in all.iter().enumerate() {
                cut(one, frame, if n == 0 { material } else { !material }, faces);
            }
        }
        Shape::Box { min, max } => take(polygon(&corners(*min, *max), frame)),
        Shape::HalfSpace { point, normal } => take(half_space(*point, *normal, frame)),
        Shape::Cylinder { from, to, radius } => take(round(*from, *to, [*radius; 2], frame)),
        Shape::Cone { from, to, radius_from, radius_to } => {
            take(round(*from, *to, [*radius_from, *radius_to], frame));
        }
        // The scenes of specifications have no files.
        Shape::Mesh(_) => {}
        Shape::Sphere { centre, radius } => {
            let centre = frame.transform_point3(*centre);
            let square = radius * radius - centre.z * centre.z;
            take((square > 0.0).then(|| Outline::Circle(centre.truncate(), square.sqrt())));
        }
    }
}

/// The corners of a box: the lower face around, then the upper one.
fn corners(min: DVec3, max: DVec3) -> Vec<[DVec3; 2]> {
    let flat = [(min.x, min.y), (max.x, min.y), (max.x, max.y), (min.x, max.y)];
    flat.map(|(x, y)| [DVec3::new(x, y, min.z), DVec3::new(x, y, max.z)]).to_vec()
}

/// The cut through a prism that is given by its upright edges in order around.
fn polygon(edges: &[[DVec3; 2]], frame: DAffine3) -> Option<Outline> {
    let edges: Vec<[DVec3; 2]> = edges.iter().map(|edge| edge.map(|p| frame.transform_point3(p))).collect();
    let mut lines = edges.clone();
    for (n, edge) in edges.iter().enumerate() {
        let next = edges.get((n + 1) % edges.len())?;
        lines.extend([[edge[0], next[0]], [edge[1], next[1]]]);
    }
    let mut points: Vec<DVec2> = Vec::new();
    for [a, b] in lines {
        if (a.z < 0.0) != (b.z < 0.0) {
            let p = a.lerp(b, a.z / (a.z - b.z)).truncate();
            if points.iter().all(|other| (*other - p).length() > 1e-9) {
                points.push(p);
            }
        }
    }
    let count = points.len() as f64;
    let middle = points.iter().copied().sum::<DVec2>() / count.max(1.0);
    points.sort_by(|a, b| angle(*a - middle).total_cmp(&angle(*b - middle)));
    (points.len() > 2).then_some(Outline::Polygon(points))
}

fn angle(v: DVec2) -> f64 {
    libm::atan2(v.y, v.x)
}

fn half_space(point: DVec3, normal: DVec3, frame: DAffine3) -> Option<Outline> {
    let (point, normal) = (frame.transform_point3(point), frame.transform_vector3(normal));
    let flat = normal.truncate();
    if flat.length() < 1e-9 {
        let inside = -point.z * normal.z <= 0.0;
        let square = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)].map(|(x, y)| DVec2::new(x, y) * FAR);
        return inside.then(|| Outline::Polygon(square.to_vec()));
    }
    let away = flat / flat.length();
    let foot = point.truncate() + away * (point.z * normal.z / flat.length());
    let side = away.perp() * FAR;
    Some(Outline::Polygon(vec![foot + side, foot - side, foot - side - away * FAR, foot + side - away * FAR]))
}

/// The cut through a cylinder or cone.
fn round(from: DVec3, to: DVec3, radii: [f64; 2], frame: DAffine3) -> Option<Outline> {
    let (a, b) = (frame.transform_point3(from), frame.transform_point3(to));
    let axis = b - a;
    if axis.truncate().length() < 1e-9 * axis.length() {
        let share = a.z / (a.z - b.z);
        let radius = radii[0] + (radii[1] - radii[0]) * share;
        return (0.0..=1.0).contains(&share).then(|| Outline::Circle(a.truncate(), radius));
    }
    let x = axis.normalize().any_orthonormal_vector();
    let y = axis.normalize().cross(x);
    let edge = |n: usize| {
        let turn = n as f64 * 360.0 / CORNERS as f64;
        let out = x * cosd(turn) + y * sind(turn);
        [a + out * radii[0], b + out * radii[1]]
    };
    polygon(&(0..CORNERS).map(edge).collect::<Vec<_>>(), DAffine3::IDENTITY)
}
