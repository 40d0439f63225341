//! The straight ways of plain movements below the top of the blank, and which of them widen each other's groove.
use glam::DVec3;

use super::body::SAME;

/// The ends of an open contour are so many radii of the tool apart.
const APART: f64 = 4.0;

/// A straight way below the top of the blank.
#[derive(Clone, Copy)]
pub(super) struct Way {
    pub(super) line: usize,
    pub(super) from: DVec3,
    pub(super) to: DVec3,
    pub(super) radius: f64,
    /// Which contour with RL or RR it belongs to, if that begins outside of the blank.
    pub(super) contour: Option<usize>,
}

/// Whether a way belongs to a contour that ends elsewhere than it begins: what is cut out of a plate leaves a frame.
pub(super) fn is_open(way: &Way, ways: &[Way]) -> bool {
    let mut own = ways.iter().filter(|other| other.contour == way.contour);
    let Some(first) = own.next().filter(|_| way.contour.is_some()) else { return false };
    let near = |place: DVec3| (place - first.to).length() <= APART * way.radius;
    !own.skip(1).any(|other| near(other.from) || near(other.to))
}

/// Whether another way goes beside this one and widens its groove.
pub(super) fn is_beside(way: &Way, other: &Way) -> bool {
    let along = (way.to - way.from).truncate().normalize_or_zero();
    let parallel = along.perp_dot((other.to - other.from).truncate().normalize_or_zero()).abs() < 0.01;
    let apart = along.perp_dot((other.from - way.from).truncate()).abs();
    parallel && apart > SAME && apart < 2.0 * way.radius.max(other.radius)
}
