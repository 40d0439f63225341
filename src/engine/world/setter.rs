//! Where a tool touches the tool setter: pure geometry of edges and the upper face of the setter.
//!
//! Everything is seen along the tool axis, in main and minor coordinates about the true centre of the face; heights count
//! from it, upwards. Invariant: a tool that turns touches with its longest or widest edge, one that stands with the edge
//! that comes to the face first; no movement and no belief of the control is known here.
use glam::DVec2;

use crate::base::expr::{cosd, sind};
use crate::engine::machine::Tool;
use crate::engine::scene::{Edge, Plate};

/// How the spindle is while a tool is measured.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Pose {
    /// It turns.
    Turning,
    /// It stands at an angle, degrees.
    At(f64),
}

/// A tool above or beside the face.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Measured<'t> {
    /// Corner radius and point angle, as the tool table has them.
    pub(crate) tool: &'t Tool,
    /// The true edges; never empty.
    pub(crate) edges: &'t [Edge],
    /// Whether it is round all over, such as a calibration tool: it touches with its circumference, whatever its pose.
    pub(crate) round: bool,
    /// Where the first edge is while the spindle is at 0, degrees.
    pub(crate) first: f64,
    /// How far the centre of the tool is from the spindle axis while the spindle is at 0.
    pub(crate) misaligned: DVec2,
}

fn turned(by: f64) -> DVec2 {
    DVec2::new(cosd(by), sind(by))
}

impl Measured<'_> {
    /// How much higher the edge is at a radius than at its lowest point.
    fn rise(&self, edge: &Edge, radius: f64) -> f64 {
        let corner = self.tool.corner.min(edge.radius);
        if self.tool.point > 0.0 && self.tool.point < 180.0 {
            return radius / libm::tan((self.tool.point / 2.0).to_radians());
        }
        let out = radius - (edge.radius - corner);
        if corner > 0.0 && out > 0.0 { corner - libm::sqrt((corner * corner - out * out).max(0.0)) } else { 0.0 }
    }

    /// The greatest radius of the edge up to a height above its lowest point.
    fn reach(&self, edge: &Edge, height: f64) -> f64 {
        let corner = self.tool.corner.min(edge.radius);
        if self.tool.point > 0.0 && self.tool.point < 180.0 {
            return edge.radius.min(height * libm::tan((self.tool.point / 2.0).to_radians()));
        }
        if corner > 0.0 && height < corner {
            let down = corner - height;
            return edge.radius - corner + libm::sqrt(corner * corner - down * down);
        }
        edge.radius
    }

    /// The centre of the tool while the spindle axis is at a point.
    fn centre(&self, axis: DVec2, pose: Pose) -> DVec2 {
        match pose {
            Pose::Turning => axis,
            Pose::At(angle) => axis + turned(angle).rotate(self.misaligned),
        }
    }

    /// The edges with the directions in which they point; none of tools that touch with their circumference.
    fn pointing(&self, pose: Pose) -> impl Iterator<Item = (&Edge, Option<DVec2>)> {
        let step = 360.0 / self.edges.len() as f64;
        self.edges.iter().enumerate().map(move |(index, edge)| match pose {
            Pose::At(angle) if !self.round => (edge, Some(turned(angle + self.first + step * index as f64))),
            _ => (edge, None),
        })
    }

    /// How far a turning tool reaches beyond its radius.
    fn wobble(&self, pose: Pose) -> f64 {
        if pose == Pose::Turning { self.misaligned.length() } else { 0.0 }
    }

    /// How long the tool is where it comes down on the face with its axis there; nothing if it misses the face.
    pub(crate) fn length_over(&self, plate: Plate, axis: DVec2, pose: Pose) -> Option<f64> {
        let (centre, wobble) = (self.centre(axis, pose), self.wobble(pose));
        let length = |(edge, way): (&Edge, Option<DVec2>)| {
            let radius = match way {
                None => distance(plate, centre) - wobble,
                Some(way) => first_inside(plate, centre, way)?,
            };
            (radius <= edge.radius).then(|| edge.length - self.rise(edge, radius.max(0.0)))
        };
        self.pointing(pose).filter_map(length).reduce(f64::max)
    }

    /// How far the axis goes from a point in a direction of length 1 until the tool touches the side of the face;
    /// `height` is how high the face is above the lowest point of a tool of length 0. Nothing if it misses.
    pub(crate) fn way_to_side(
        &self,
        plate: Plate,
        axis: DVec2,
        direction: DVec2,
        height: f64,
        pose: Pose,
    ) -> Option<f64> {
        let (centre, wobble) = (self.centre(axis, pose), self.wobble(pose));
        let way = |(edge, points): (&Edge, Option<DVec2>)| {
            let above = height + edge.length;
            if above <= 0.0 {
                return None;
            }
            let radius = self.reach(edge, above);
            match points {
                None => way_to(plate, centre, direction, radius + wobble),
                Some(points) => way_to(plate, centre + points * radius, direction, 0.0),
            }
        };
        self.pointing(pose).filter_map(way).reduce(f64::min)
    }
}

/// Deeper than this, mm, is a collision.
const DEEP: f64 = 1e-6;
/// A greatest or least place of a curve that bends one way is found in so many steps.
const STEPS: usize = 80;

/// The spindle on a straight way: its axis beside the centre of the face, and how high the spindle nose is above it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Course {
    /// Where it begins.
    pub(crate) from: (DVec2, f64),
    /// Where it ends.
    pub(crate) to: (DVec2, f64),
}

impl Course {
    fn axis(&self, share: f64) -> DVec2 {
        self.from.0.lerp(self.to.0, share)
    }

    fn height(&self, share: f64) -> f64 {
        self.from.1 + (self.to.1 - self.from.1) * share
    }
}

impl Measured<'_> {
    /// Whether the turning tool gets into the setter on a straight way, or is there at its start; `nearer` is how much
    /// wider it is taken.
    pub(crate) fn meets(&self, plate: Plate, course: &Course, nearer: f64) -> bool {
        let wobble = self.wobble(Pose::Turning) + nearer;
        self.edges.iter().any(|edge| {
            // The distance from the face bends one way along the way, and so does how deep the tool is.
            let beside = |share: f64| distance(plate, course.axis(share)) - wobble - edge.radius;
            let next = least(&beside, 0.0, 1.0);
            if beside(next) >= -DEEP {
                return false;
            }
            let (first, last) = (boundary(&beside, next, 0.0), boundary(&beside, next, 1.0));
            let above = |share: f64| {
                let radius = (distance(plate, course.axis(share)) - wobble).max(0.0);
                course.height(share) - edge.length + self.rise(edge, radius)
            };
            above(least(&above, first, last)) < -DEEP
        })
    }
}

/// Where a curve that bends upwards is least.
fn least(curve: &dyn Fn(f64) -> f64, from: f64, to: f64) -> f64 {
    let (mut low, mut high) = (from, to);
    for _ in 0..STEPS {
        let third = (high - low) / 3.0;
        let (a, b) = (low + third, high - third);
        if curve(a) <= curve(b) { high = b } else { low = a }
    }
    let ends = [from, low.midpoint(high), to];
    ends.into_iter().fold(from, |best, at| if curve(at) < curve(best) { at } else { best })
}

/// The place nearest to `end` up to which the curve stays below 0 from a place where it is.
fn boundary(curve: &dyn Fn(f64) -> f64, below: f64, end: f64) -> f64 {
    if curve(end) < -DEEP {
        return end;
    }
    let (mut inside, mut outside) = (below, end);
    for _ in 0..STEPS {
        let middle = inside.midpoint(outside);
        if curve(middle) < -DEEP { inside = middle } else { outside = middle }
    }
    inside
}

/// How far a point is from the face; 0 on it.
fn distance(plate: Plate, point: DVec2) -> f64 {
    match plate {
        Plate::Disc(radius) => (point.length() - radius).max(0.0),
        Plate::Cube(half) => (point.abs() - DVec2::splat(half)).max(DVec2::ZERO).length(),
    }
}

/// The least way from a point in a direction to a point of the face.
fn first_inside(plate: Plate, from: DVec2, direction: DVec2) -> Option<f64> {
    if distance(plate, from) <= 0.0 {
        return Some(0.0);
    }
    way_to(plate, from, direction, 0.0)
}

/// The least way of a circle of a radius about a point until it touches the face.
fn way_to(plate: Plate, from: DVec2, direction: DVec2, radius: f64) -> Option<f64> {
    match plate {
        Plate::Disc(own) => way_to_circle(from, direction, own + radius),
        Plate::Cube(half) => {
            let corners = [(1.0, 1.0), (1.0, -1.0), (-1.0, 1.0), (-1.0, -1.0)].into_iter().filter_map(|(x, y)| {
                let corner = DVec2::new(x, y) * half;
                way_to_circle(from - corner, direction, radius).filter(|_| radius > 0.0)
            });
            let faces = [DVec2::X, DVec2::NEG_X, DVec2::Y, DVec2::NEG_Y].into_iter().filter_map(|normal| {
                let against = -direction.dot(normal);
                let way = (from.dot(normal) - half - radius) / against;
                let at = from + direction * way;
                (against > 0.0 && way >= 0.0 && at.dot(normal.perp()).abs() <= half).then_some(way)
            });
            corners.chain(faces).reduce(f64::min)
        }
    }
}

/// The least way of a point to a circle about the centre.
fn way_to_circle(from: DVec2, direction: DVec2, radius: f64) -> Option<f64> {
    let (along, across) = (-from.dot(direction), from.perp_dot(direction));
    let half = radius * radius - across * across;
    let way = along - libm::sqrt(half.max(0.0));
    (half >= 0.0 && way >= 0.0).then_some(way)
}
