//! Triangulated surfaces: what lies in them, what of them is nearest, what a line meets.
//!
//! A surface is *closed* if each edge belongs to an even number of triangles: then it bounds material, whichever way
//! its triangles are turned round. Any other surface is a skin without thickness that can be touched from both sides.
//!
//! Invariant: triangles are in a hierarchy of boxes ([`boxes`]), so a question looks at those near the answer only.
mod boxes;
mod contact;

use std::collections::BTreeMap;
use std::sync::Arc;

use glam::DVec3;

use super::SolidError;
use super::contact::Nearest;
use crate::engine::geometry::Frame;
use boxes::{Bounds, Boxes};

/// A point is on a surface when it is closer than this, in mm.
const ON: f64 = 1e-10;
/// A line that passes an edge nearer than this share of a triangle's extent meets it or not: another line decides.
const BESIDE: f64 = 1e-9;
/// Directions in which a point is looked at from infinity, until one meets no edge. Their numbers have no pattern, so that
/// none lies in the faces that parts have.
const LOOKS: [DVec3; 6] = [
    DVec3::new(0.613_729_1, 0.271_934_7, 0.741_284_3),
    DVec3::new(-0.317_482_9, 0.841_273_1, 0.437_561_7),
    DVec3::new(0.291_837_3, -0.517_394_1, 0.804_471_9),
    DVec3::new(0.837_192_7, 0.418_273_9, -0.352_719_3),
    DVec3::new(-0.471_938_3, -0.329_174_7, -0.817_839_1),
    DVec3::new(0.193_847_1, 0.928_371_9, -0.317_293_7),
];

/// A triangle with an area.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Triangle {
    corners: [DVec3; 3],
    /// Of length 1.
    normal: DVec3,
}

impl Triangle {
    /// Nothing if it has no area.
    fn new(corners: [DVec3; 3]) -> Option<Self> {
        let [a, b, c] = corners;
        let normal = (b - a).cross(c - a).try_normalize()?;
        Some(Self { corners, normal })
    }

    fn sides(&self) -> [(DVec3, DVec3); 3] {
        let [a, b, c] = self.corners;
        [(a, b), (b, c), (c, a)]
    }

    /// The nearest point of the triangle.
    fn closest(&self, p: DVec3) -> DVec3 {
        let [a, ..] = self.corners;
        let foot = p - self.normal * (p - a).dot(self.normal);
        let within = |(from, to): (DVec3, DVec3)| (to - from).cross(foot - from).dot(self.normal) >= 0.0;
        if self.sides().into_iter().all(within) {
            return foot;
        }
        let ends = self.sides().map(|(from, to)| {
            let way = to - from;
            from + way * ((p - from).dot(way) / way.length_squared()).clamp(0.0, 1.0)
        });
        ends.into_iter().fold(a, |best, end| if (end - p).length() < (best - p).length() { end } else { best })
    }

    /// Where the line `origin + s direction` goes through, if it does; an error where it passes an edge too closely.
    fn met_by(&self, origin: DVec3, direction: DVec3) -> Result<Option<f64>, ()> {
        let [a, b, c] = self.corners.map(|corner| corner - origin);
        let [u, v, w] = [b.cross(c), c.cross(a), a.cross(b)].map(|volume| volume.dot(direction));
        let extent = (b - a).length().max((c - a).length());
        let beside = BESIDE * direction.length() * extent * (a.length().min(b.length()).min(c.length()) + extent);
        let all = [u, v, w];
        if all.iter().any(|volume| *volume > beside) && all.iter().any(|volume| *volume < -beside) {
            return Ok(None);
        }
        if all.iter().any(|volume| volume.abs() <= beside) {
            return Err(());
        }
        let slope = self.normal.dot(direction);
        Ok((slope != 0.0).then(|| self.normal.dot(a) / slope))
    }
}

/// A triangulated surface, ready for questions.
#[derive(Clone, Debug, PartialEq)]
pub struct Mesh {
    triangles: Vec<Triangle>,
    boxes: Boxes,
    closed: bool,
}

impl Mesh {
    /// The surface of triangles with finite corners, in mm. Corners are the same if their numbers are. Nothing if no
    /// triangle has an area.
    pub fn new(corners: &[[DVec3; 3]]) -> Option<Self> {
        let mut triangles: Vec<Triangle> = corners.iter().filter_map(|corners| Triangle::new(*corners)).collect();
        if triangles.is_empty() {
            return None;
        }
        let boxes = Boxes::of(&mut triangles, |triangle| Bounds::of(&triangle.corners));
        Some(Self { closed: is_closed(corners), triangles, boxes })
    }

    /// Whether it bounds material.
    pub const fn is_closed(&self) -> bool {
        self.closed
    }

    /// How many triangles with an area it has.
    pub const fn len(&self) -> usize {
        self.triangles.len()
    }

    /// Whether there are none; a surface always has some.
    pub const fn is_empty(&self) -> bool {
        self.triangles.is_empty()
    }

    fn triangle(&self, index: usize) -> Option<&Triangle> {
        self.triangles.get(index)
    }

    /// The nearest point of the surface if it is nearer than `limit`.
    fn nearest(&self, p: DVec3, limit: f64) -> Option<Nearest> {
        let mut best: Option<Nearest> = None;
        self.boxes.nearest(p, limit, &mut |index, limit| {
            let Some(triangle) = self.triangle(index) else { return limit };
            let point = triangle.closest(p);
            let distance = (point - p).length();
            if distance < limit {
                best = Some(Nearest { distance, point });
            }
            distance.min(limit)
        });
        best
    }

    /// The triangles of which a point may be nearer than `reach`; of more than `most`, not all.
    fn near(&self, p: DVec3, reach: f64, most: usize) -> Vec<&Triangle> {
        let mut found = Vec::new();
        self.boxes.within(p, reach, &mut |index| {
            let near = self.triangle(index).filter(|triangle| (triangle.closest(p) - p).length() <= reach);
            found.extend(near);
            found.len() <= most
        });
        found
    }

    /// Whether the point belongs to it: to its triangles, or to the material that it bounds.
    fn contains(&self, p: DVec3) -> Result<bool, SolidError> {
        if !self.boxes.bounds().holds(p, ON) {
            return Ok(false);
        }
        if self.nearest(p, ON).is_some() {
            return Ok(true);
        }
        if !self.closed {
            return Ok(false);
        }
        for direction in LOOKS {
            let mut met: Result<usize, ()> = Ok(0);
            self.boxes.along(p, direction, true, &mut |index| {
                let Some(triangle) = self.triangle(index) else { return };
                match (triangle.met_by(p, direction), &mut met) {
                    (Ok(Some(s)), Ok(count)) if s > 0.0 => *count += 1,
                    (Err(()), _) => met = Err(()),
                    _ => {}
                }
            });
            if let Ok(count) = met {
                return Ok(count % 2 == 1);
            }
        }
        Err(SolidError::Cusp(p))
    }

    /// Adds where a line may go in or out.
    fn cuts(&self, origin: DVec3, direction: DVec3, cuts: &mut Vec<f64>) {
        self.boxes.along(origin, direction, false, &mut |index| {
            let Some(triangle) = self.triangle(index) else { return };
            let [a, ..] = triangle.corners;
            let slope = triangle.normal.dot(direction);
            // A line that passes an edge closely goes in or out there all the same.
            if slope != 0.0 && !matches!(triangle.met_by(origin, direction), Ok(None)) {
                cuts.push((a - origin).dot(triangle.normal) / slope);
            }
        });
    }
}

/// Whether each edge belongs to an even number of triangles.
fn is_closed(corners: &[[DVec3; 3]]) -> bool {
    // Numbers in the order of their bits: which order does not matter, 0 and -0 are the same.
    let key = |p: DVec3| p.to_array().map(|value| (value + 0.0).to_bits());
    let mut numbers: BTreeMap<[u64; 3], u32> = BTreeMap::new();
    let mut edges: Vec<(u32, u32)> = Vec::with_capacity(corners.len() * 3);
    for triangle in corners {
        let [a, b, c] = triangle.map(|corner| {
            let next = numbers.len() as u32;
            *numbers.entry(key(corner)).or_insert(next)
        });
        edges.extend([(a, b), (b, c), (c, a)].map(|(from, to)| (from.min(to), from.max(to))));
    }
    edges.retain(|(from, to)| from != to);
    edges.sort_unstable();
    edges.chunk_by(|one, other| one == other).all(|same| same.len() % 2 == 0)
}

/// A surface at its place.
#[derive(Clone, Debug)]
pub(super) struct PlacedMesh {
    frame: Frame,
    back: Frame,
    mesh: Arc<Mesh>,
}

impl PlacedMesh {
    pub(super) fn new(mesh: &Arc<Mesh>, frame: &Frame) -> Self {
        Self { frame: *frame, back: frame.inverse(), mesh: Arc::clone(mesh) }
    }

    pub(super) fn contains(&self, p: DVec3) -> Result<bool, SolidError> {
        self.mesh.contains(self.back.point(p))
    }

    /// The nearest point of the surface if it is nearer than `limit`.
    pub(super) fn nearest(&self, p: DVec3, limit: f64) -> Option<Nearest> {
        let found = self.mesh.nearest(self.back.point(p), limit)?;
        Some(Nearest { point: self.frame.point(found.point), ..found })
    }

    /// Adds where a line may go in or out.
    pub(super) fn cuts(&self, origin: DVec3, direction: DVec3, cuts: &mut Vec<f64>) {
        self.mesh.cuts(self.back.point(origin), self.back.vector(direction), cuts);
    }
}
