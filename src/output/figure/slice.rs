//! The parts of a scene cut by a plane: faces to be painted one over the other, material and holes in turn.
//!
//! Invariant: what cannot be cut exactly (a cone, a ball or a cylinder askew to the plane) is given by many corners.
use glam::{DAffine3, DVec2, DVec3};

use super::shot::Shot;
use crate::base::expr::{cosd, sind};
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

/// The faces of the parts in the plane of a view at `depth` along the axis that the view does not show.
pub(super) fn faces(shot: &Shot, view: FigureView, depth: f64) -> Vec<Face> {
    // To (right, up, towards the reader), with the plane at 0.
    let plane = shot.plane;
    let own = shot.back;
    let turned = move |p: DVec3| {
        let p = own.transform_point3(p);
        let p = plane.flat(p).extend(plane.tool.of(p));
        match view {
            FigureView::Plan => DVec3::new(p.x, p.y, p.z - depth),
            FigureView::Section | FigureView::Side => DVec3::new(p.x, p.z, depth - p.y),
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

fn cut(shape: &Shape, frame: DAffine3, material: bool, faces: &mut Vec<Face>) {
    let mut take = |outline: Option<Outline>| {
        faces.extend(outline.map(|outline| Face { material, outline }));
    };
    match shape {
        Shape::Placed { frame: inner, shape } => {
            let rows = inner.rows();
            let column = |n: usize| DVec3::new(rows[0][n], rows[1][n], rows[2][n]);
            let inner =
                DAffine3 { matrix3: glam::DMat3::from_cols(column(0), column(1), column(2)), translation: column(3) };
            cut(shape, frame * inner, material, faces);
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
