//! Where a tool that leans touches the tool setter: the head of a machine with errors is not quite where the control
//! believes it to be.
//!
//! Tool and setter are convex, so a way that ends in touching ends where some plane between them is reached last. How far
//! that is bends one way in the two coordinates of the plane's direction, and its greatest value is looked for. Points are
//! main, minor and tool coordinate of the setter about the centre of its face. Invariant: as for tools at right angles.
use std::f64::consts::FRAC_PI_2;

use glam::{DVec2, DVec3};

use super::setter::{Course, Measured, Pose};
use crate::base::expr::{cosd, sind};
use crate::engine::scene::{Edge, Plate};

/// The steepest plane that is looked at, an angle in radians, and from where on one says that none is steep enough.
const STEEPEST: f64 = FRAC_PI_2 - 1e-7;
const NEARLY: f64 = FRAC_PI_2 - 1e-6;
/// By which share an interval shrinks with each step of a search, and how many steps it has.
const GOLDEN: f64 = 0.618_033_988_749_895;
const STEPS: usize = 70;
/// Deeper than this, mm, is a collision.
const DEEP: f64 = 1e-6;

/// A tool that leans.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Leaning<'t> {
    pub(crate) measured: Measured<'t>,
    /// Main, minor and tool axis of the spindle as they really are.
    pub(crate) axes: [DVec3; 3],
}

/// What of a tool touches.
#[derive(Clone, Copy, Debug)]
struct Body<'t> {
    edge: &'t Edge,
    /// Where the edge of a stationary tool points; nothing of a round tool.
    points: Option<DVec3>,
    /// How far the centre of the tool is from the spindle axis.
    off: DVec3,
    /// How far it reaches beyond its radius.
    wider: f64,
    /// How much longer it is.
    longer: f64,
}

impl Leaning<'_> {
    fn across(&self, way: DVec2) -> DVec3 {
        self.axes[0] * way.x + self.axes[1] * way.y
    }

    /// What of the tool touches in a pose.
    fn bodies(&self, pose: Pose) -> impl Iterator<Item = Body<'_>> {
        let Measured { edges, round, first, misaligned, .. } = self.measured;
        let turned = |by: f64| DVec2::new(cosd(by), sind(by));
        let step = 360.0 / edges.len() as f64;
        let (off, wider) = match pose {
            Pose::Turning => (DVec3::ZERO, misaligned.length()),
            Pose::At(angle) => (self.across(turned(angle).rotate(misaligned)), 0.0),
        };
        edges.iter().enumerate().map(move |(index, edge)| {
            let points = match pose {
                Pose::At(angle) if !round => Some(self.across(turned(angle + first + step * index as f64))),
                _ => None,
            };
            Body { edge, points, off, wider, longer: 0.0 }
        })
    }

    /// How far the tool reaches from the spindle nose in a direction.
    fn reach(&self, body: &Body<'_>, to: DVec3) -> f64 {
        let [_, _, axis] = self.axes;
        let up = to.dot(axis);
        let out = match body.points {
            Some(points) => to.dot(points).max(0.0),
            None => (to - axis * up).length(),
        };
        let (radius, length) = (body.edge.radius, body.edge.length + body.longer);
        let corner = self.measured.tool.corner.min(radius);
        let point = self.measured.tool.point;
        let own = if up >= 0.0 {
            out * radius
        } else if point > 0.0 && point < 180.0 {
            let high = radius / libm::tan((point / 2.0).to_radians());
            (-length * up).max(out * radius - (length - high) * up)
        } else {
            out * (radius - corner) - (length - corner) * up + corner * libm::hypot(out, up)
        };
        own + out * body.wider + to.dot(body.off)
    }

    /// How far the spindle nose goes from a point in a direction of length 1, down or across, until the tool touches the
    /// face or its side; nothing if it misses.
    pub(crate) fn way_to(&self, plate: Plate, nose: DVec3, direction: DVec3, pose: Pose) -> Option<f64> {
        let is_down = direction.truncate().length() < 0.5;
        let (u, v, lowest) = if is_down {
            (DVec3::X, DVec3::Y, -STEEPEST)
        } else {
            // The setter has no lower end.
            (direction.truncate().perp().extend(0.0), DVec3::Z, 0.0)
        };
        let way = |body: Body<'_>| {
            let behind = |a: f64, b: f64| {
                let normal = u * a + v * b - direction;
                normal.dot(nose) - reach_of_plate(plate, normal) - self.reach(&body, -normal)
            };
            greatest_of_two(&behind, lowest)
        };
        self.bodies(pose).filter_map(way).reduce(f64::min)
    }

    /// Whether the turning tool gets into the setter on a straight way, given by the spindle nose at its ends, or is there
    /// at its start; `nearer` is how much wider it is taken.
    pub(crate) fn meets(&self, plate: Plate, [from, to]: [DVec3; 2], nearer: f64) -> bool {
        self.bodies(Pose::Turning).any(|body| {
            let body = Body { wider: body.wider + nearer - DEEP, longer: -DEEP, ..body };
            let apart = |a: f64, b: f64| {
                let normal = DVec3::new(a, b, 1.0);
                normal.dot(from).min(normal.dot(to)) - reach_of_plate(plate, normal) - self.reach(&body, -normal)
            };
            greatest_of_two(&apart, -STEEPEST).is_some_and(|apart| apart <= 0.0)
        })
    }

    /// The spindle nose at the ends of a course.
    pub(crate) fn noses(&self, course: &Course) -> [DVec3; 2] {
        [course.from, course.to].map(|(axis, high)| axis.extend(high))
    }
}

/// How far the setter reaches from the centre of its face in a direction that is not downwards.
fn reach_of_plate(plate: Plate, to: DVec3) -> f64 {
    match plate {
        Plate::Disc(radius) => radius * to.truncate().length(),
        Plate::Cube(half) => half * (to.x.abs() + to.y.abs()),
    }
}

/// The greatest value of a function that bends down; nothing if it grows without end.
fn greatest_of_two(function: &dyn Fn(f64, f64) -> f64, lowest: f64) -> Option<f64> {
    let inner = |a: f64| greatest(&|b| function(a, b), lowest);
    let (a, _) = greatest(&|a| inner(a).1, -STEEPEST);
    let (b, found) = inner(libm::tan(a));
    (a.abs().max(b.abs()) < NEARLY).then_some(found)
}

/// Where a curve over the tangent of an angle that bends down is greatest, and how great it is there.
fn greatest(curve: &dyn Fn(f64) -> f64, from: f64) -> (f64, f64) {
    let at = |angle: f64| curve(libm::tan(angle));
    let (mut low, mut high) = (from, STEEPEST);
    let (mut a, mut b) = (high - (high - low) * GOLDEN, low + (high - low) * GOLDEN);
    let (mut of_a, mut of_b) = (at(a), at(b));
    for _ in 0..STEPS {
        if of_a >= of_b {
            (high, b, of_b) = (b, a, of_a);
            a = high - (high - low) * GOLDEN;
            of_a = at(a);
        } else {
            (low, a, of_a) = (a, b, of_b);
            b = low + (high - low) * GOLDEN;
            of_b = at(b);
        }
    }
    if of_a >= of_b { (a, of_a) } else { (b, of_b) }
}
