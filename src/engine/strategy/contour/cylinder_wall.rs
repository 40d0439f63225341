//! The walls of slots and ridges on a cylinder: where a tool is beside a centre path in the development.
//!
//! While it mills a wall, the tool is parallel to the radius of the cylinder through the centre path, as a tool would be
//! that is as wide as the slot, or a body as wide as the ridge: so the walls are parallel. The development is that of the
//! surface: x is the way round the cylinder, y the way along it, mm. Invariant: arcs are chords that lie within
//! [`CHORD`] of them.
use glam::DVec2;

use crate::base::expr::{atan2d, cosd, sind};
use crate::engine::geometry::{Around, left_of};
use crate::engine::region::{Edge, Way};

/// How far a chord may lie off its arc, mm.
pub const CHORD: f64 = 0.001;
/// How much nearer than asked for the tool may come to a ridge, mm: what chords cost.
const SPARE: f64 = 2.0 * CHORD;
/// The same on a way from one wall to the next in an inside corner.
const SPARE_IN_CORNER: f64 = 5.0 * CHORD;
/// Whether the tool is clear of a ridge is looked at in steps of this length, mm.
const STEP: f64 = 0.5;
/// A ridge is looked at in steps of this length along its centre path, mm.
const ALONG: f64 = 0.2;
/// How near the place is found, as a share of a step, where the tool would come too near.
const NEARNESS: f64 = 1e-6;
/// By how much the tool goes farther away, again and again, to get round a corner.
const OUTWARDS: f64 = 1.01;
/// How often.
const TRIES: usize = 80;
/// A way round a corner is halved so often.
const HALVES: usize = 6;

/// A place of the tool.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Beside {
    /// The point of the centre path through whose radius the tool is parallel.
    pub centre: DVec2,
    /// From there to the tool, at right angles to that radius: round the cylinder and along it, mm.
    pub arm: DVec2,
}

impl Beside {
    /// Where that is on a cylinder of a radius, with the tip at a height over its axis.
    pub fn around(&self, radius: f64, height: f64) -> Around {
        let turn = (self.centre.x / radius).to_degrees();
        Around { turn, across: self.arm.x, along: self.centre.y + self.arm.y, height }
    }

    fn lerp(&self, to: &Self, share: f64) -> Self {
        Self { centre: self.centre.lerp(to.centre, share), arm: self.arm.lerp(to.arm, share) }
    }

    fn distance(&self, to: &Self) -> f64 {
        self.centre.distance(to.centre) + self.arm.distance(to.arm)
    }
}

/// Turned counter-clockwise.
fn turned(arm: DVec2, degrees: f64) -> DVec2 {
    DVec2::from((cosd(degrees), sind(degrees))).rotate(arm)
}

/// Into how many chords an arc of a radius is divided.
fn chords(radius: f64, degrees: f64) -> usize {
    let step = if radius > CHORD { 2.0 * (2.0 * CHORD / radius).sqrt().to_degrees() } else { 90.0 };
    ((degrees.abs() / step.min(90.0)).ceil() as usize).max(1)
}

/// The places on the arc that an arm makes about its centre, without the first one.
pub fn swing(from: &Beside, degrees: f64) -> Vec<Beside> {
    let count = chords(from.arm.length(), degrees);
    let at = |n: usize| turned(from.arm, degrees * n as f64 / count as f64);
    (1..=count).map(|n| Beside { arm: at(n), ..*from }).collect()
}

/// The points of an element with the directions there; `reach` is how far away from it the tool is.
fn points(from: DVec2, edge: &Edge, reach: f64) -> Vec<(DVec2, DVec2)> {
    match *edge {
        Edge::Line(to) => {
            let along = (to - from).normalize_or_zero();
            vec![(from, along), (to, along)]
        }
        Edge::Arc { to, centre, sweep } => {
            let arm = from - centre;
            let count = chords(arm.length() + reach, sweep);
            let at = |n: usize| {
                let arm = turned(arm, sweep * n as f64 / count as f64);
                let point = if n == count { to } else { centre + arm };
                (point, left_of(arm).normalize_or_zero() * sweep.signum())
            };
            (0..=count).map(at).collect()
        }
    }
}

/// The way of a tool on a side of a centre path: on its left at a positive distance. The walls are those at a share of
/// the radius of the cylinder: 1 on its surface. About a corner the tool turns on an arc.
pub fn beside(way: &Way, distance: f64, share: f64) -> Vec<Beside> {
    let mut path: Vec<Beside> = Vec::new();
    let mut from = way.start;
    for edge in &way.edges {
        for (n, (centre, along)) in points(from, edge, distance.abs()).into_iter().enumerate() {
            // Nearer to the axis the way round is shorter, and the same path is steeper.
            // Nothing beside the path is no negative zero.
            let arm = left_of(DVec2::new(along.x * share, along.y)).normalize_or_zero() * distance + DVec2::ZERO;
            if let (0, Some(last)) = (n, path.last().copied()) {
                let angle = atan2d(last.arm.perp_dot(arm), last.arm.dot(arm));
                if angle.abs() > 1e-9 {
                    path.extend(swing(&last, angle));
                }
            }
            path.push(Beside { centre, arm });
        }
        from = edge.to();
    }
    path
}

/// A way in the development without anything beside it.
pub fn along(way: &Way) -> Vec<Beside> {
    beside(way, 0.0, 1.0)
}

/// The radii of a cylinder, from its surface to the floor of a slot, at which walls are milled so that nowhere more
/// stays than a tolerance of what a tool would leave that is as wide as the slot; `arm` is how far beside the centre path
/// the tool is. Without the surface itself; at most so many.
///
/// An oblique path is the steeper the nearer to the axis: by the angle with the tangent (1 - q) / 2 √q at the worst
/// between two radii with the ratio q. A wall that is milled where it is steeper by an angle stays by
/// arm (1 - cos angle) too narrow, and nowhere too wide.
pub fn radii_of_walls(surface: f64, floor: f64, arm: f64, tolerance: f64, most: usize) -> Option<Vec<f64>> {
    if arm <= tolerance || floor >= surface {
        return Some(Vec::new());
    }
    let cosine = 1.0 - tolerance / arm;
    let allowed = 2.0 * atan2d((1.0 - cosine * cosine).sqrt(), cosine);
    let whole = floor.max(surface * f64::EPSILON) / surface;
    let ratio = |count: usize| libm::pow(whole, 1.0 / count as f64);
    let enough = |count: &usize| atan2d(1.0 - ratio(*count), 2.0 * ratio(*count).sqrt()) <= allowed;
    let count = (1..=most).find(enough)?;
    Some((1..=count).map(|n| surface * libm::pow(ratio(count), n as f64)).collect())
}

/// A ridge on a cylinder that a tool goes round: the bodies as wide as the ridge along its centre path.
pub struct Ridge {
    /// Sine and cosine of their places round the cylinder, and their places along it, in the order of these.
    bodies: Vec<(DVec2, f64)>,
    /// The radius of the cylinder.
    radius: f64,
    /// How far the axis of the tool must be from theirs.
    reach: f64,
    /// From the axis of the cylinder to a height on the ridge, and by how much nearer the tool comes there where the
    /// path is oblique.
    heights: [(f64, f64); 2],
}

impl Ridge {
    /// About a centre path, between surface and floor of a cylinder, for a tool of a radius: also on the arcs onto the
    /// wall and off it, which are tangential on the surface, no more is lost than its radius makes of the angle.
    pub fn new(way: &Way, (radius, floor): (f64, f64), reach: f64, tool: f64) -> Self {
        let mut bodies = Vec::new();
        let mut from = way.start;
        for edge in &way.edges {
            let count = ((edge.length(from) / ALONG).ceil() as usize).max(1);
            let step = edge.length(from) / count as f64;
            bodies.extend((0..=count).map(|n| edge.shortened(from, step * n as f64).to()));
            from = edge.to();
        }
        let mut bodies: Vec<(DVec2, f64)> = bodies
            .into_iter()
            .map(|at| {
                let turn = (at.x / radius).to_degrees();
                (DVec2::new(sind(turn), cosd(turn)), at.y)
            })
            .collect();
        bodies.sort_by(|(_, one), (_, other)| one.total_cmp(other));
        let low = floor.max(radius * 1e-3);
        let ratio = low / radius;
        let steeper = atan2d(1.0 - ratio, 2.0 * ratio.sqrt());
        let heights = [(radius, 0.0), (low, (reach + tool) * (1.0 - cosd(steeper)))];
        Self { bodies, radius, reach, heights }
    }

    /// Whether the tool leaves the ridge as it shall be.
    fn is_clear_of(&self, place: &Beside) -> bool {
        self.is_clear_by(place, SPARE)
    }

    /// The same with what it may lose.
    fn is_clear_by(&self, place: &Beside, spare: f64) -> bool {
        let turn = (place.centre.x / self.radius).to_degrees();
        let (sine, cosine) = (sind(turn), cosd(turn));
        let along = place.centre.y + place.arm.y;
        let first = self.bodies.partition_point(|(_, y)| *y < along - self.reach);
        let near = self.bodies.iter().skip(first).take_while(|(_, y)| *y <= along + self.reach);
        for (at, y) in near {
            // The body as the tool sees it: how far it is turned away.
            let (away, facing) = (at.x * cosine - at.y * sine, at.y * cosine + at.x * sine);
            if facing <= 0.0 {
                continue;
            }
            for (height, oblique) in self.heights {
                let gap = libm::hypot(place.arm.x - height * away, along - y);
                if gap < self.reach - oblique - spare {
                    return false;
                }
            }
        }
        true
    }

    /// The same all along a straight way of all axes.
    fn is_clear_between(&self, from: &Beside, to: &Beside) -> bool {
        let count = ((from.distance(to) / STEP).ceil() as usize).max(2);
        (1..count).all(|n| self.is_clear_by(&from.lerp(to, n as f64 / count as f64), SPARE_IN_CORNER))
    }

    /// The last place that is clear on the way from one that is to one that is not.
    fn border(&self, clear: &Beside, blocked: &Beside) -> Beside {
        let (mut low, mut high) = (0.0, 1.0);
        while high - low > NEARNESS {
            let middle = (low + high) / 2.0;
            *(if self.is_clear_of(&clear.lerp(blocked, middle)) { &mut low } else { &mut high }) = middle;
        }
        clear.lerp(blocked, low)
    }

    /// A way without the parts where the tool would come too near, which it goes round: inside corners. Nothing where
    /// it cannot.
    pub fn kept_clear(&self, path: &[Beside]) -> Option<Vec<Beside>> {
        let first = *path.first().filter(|first| self.is_clear_of(first))?;
        let mut kept = vec![first];
        // The last place, and whether that is clear.
        let (mut here, mut clear) = (first, true);
        for to in path.iter().skip(1) {
            let (from, count) = (here, ((here.distance(to) / STEP).ceil() as usize).max(1));
            for n in 1..=count {
                let next = if n == count { *to } else { from.lerp(to, n as f64 / count as f64) };
                let now = self.is_clear_of(&next);
                if clear && !now {
                    kept.push(self.border(&here, &next));
                } else if now && !clear {
                    let border = self.border(&next, &here);
                    let last = *kept.last()?;
                    self.connect(&last, &border, HALVES, &mut kept)?;
                }
                (here, clear) = (next, now);
            }
            if clear {
                kept.push(here);
            }
        }
        clear.then_some(kept)
    }

    /// From one clear place to another, farther away from the ridge where that must be.
    fn connect(&self, from: &Beside, to: &Beside, halves: usize, kept: &mut Vec<Beside>) -> Option<()> {
        if self.is_clear_between(from, to) {
            kept.push(*to);
            return Some(());
        }
        if halves == 0 {
            return None;
        }
        let mut middle = from.lerp(to, 0.5);
        for _ in 0..TRIES {
            if self.is_clear_of(&middle) {
                self.connect(from, &middle, halves - 1, kept)?;
                return self.connect(&middle, to, halves - 1, kept);
            }
            middle.arm *= OUTWARDS;
        }
        None
    }
}
