//! The path of a tool, drawn leg by leg: lines and arcs in main, minor and tool coordinates, each with its feed.
//!
//! Invariant: a path knows no machine and no program. A line that goes nowhere is no leg: the pen stays where it is,
//! as the tool will.
use glam::{DVec2, DVec3};

use super::outline::{Outline, Piece, Place, Tangent};
use crate::engine::geometry::SAME_POSITION;
use crate::engine::report::fault::Fault;

/// What a strategy must know of the milling tool.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cutter {
    /// Its radius in the coordinates of the program, which may be scaled: mm.
    pub radius: f64,
}

/// A leg of a path. Points are main, minor and tool coordinates.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Leg {
    /// Straight.
    Line {
        /// Its end.
        to: DVec3,
        /// mm/min.
        feed: f64,
    },
    /// On an arc in the working plane, at another height at its end on a helix.
    Arc {
        /// Its centre.
        centre: DVec3,
        /// Its end.
        to: DVec3,
        /// Counter-clockwise if positive.
        direction: f64,
        /// The signed angle where it is more than one turn, degrees; otherwise it follows from the end.
        sweep: Option<f64>,
        /// mm/min.
        feed: f64,
    },
    /// On an arc in the plane of the tool axis and the main axis.
    Upright {
        /// Its centre.
        centre: DVec3,
        /// Its end.
        to: DVec3,
        /// The signed angle from the tool axis towards the main axis, degrees.
        sweep: f64,
        /// mm/min.
        feed: f64,
    },
    /// Nowhere: what follows at a feed begins when the turning spindle is at an angle, and goes on in step with it.
    /// Feeds are mm per revolution from then on, and the spindle keeps the speed that it has on a diameter.
    InStep {
        /// Where the tool is.
        here: DVec3,
        /// The angle of the spindle, degrees.
        angle: f64,
        /// The diameter, mm.
        diameter: f64,
    },
}

impl Leg {
    /// Its end.
    pub const fn end(&self) -> DVec3 {
        match self {
            Self::Line { to, .. } | Self::Arc { to, .. } | Self::Upright { to, .. } | Self::InStep { here: to, .. } => {
                *to
            }
        }
    }
}

/// A path, and why it ends where it does if that is not where it should: the legs before that are gone all the same.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Path {
    /// Its legs in order.
    pub legs: Vec<Leg>,
    /// Why it is not whole.
    pub fault: Option<Fault>,
}

/// Draws a path.
#[derive(Clone, Debug)]
pub struct Pen {
    here: DVec3,
    legs: Vec<Leg>,
}

impl Pen {
    /// A pen where the tool is: main, minor and tool coordinate.
    pub(super) const fn new(here: DVec3) -> Self {
        Self { here, legs: Vec::new() }
    }

    /// What was drawn.
    pub(super) fn path(self, ended: Result<(), Fault>) -> Path {
        Path { legs: self.legs, fault: ended.err() }
    }

    /// Where it is.
    pub const fn here(&self) -> DVec3 {
        self.here
    }

    /// Whether it is at a point.
    pub fn is_at(&self, point: DVec3) -> bool {
        (point - self.here).abs().max_element() < SAME_POSITION
    }

    /// Straight to a point.
    pub fn line(&mut self, to: DVec3, feed: f64) {
        if self.is_at(to) {
            return;
        }
        self.here = to;
        self.legs.push(Leg::Line { to, feed });
    }

    /// On an arc about a centre; `sweep` is its angle where that does not follow from its end.
    pub fn arc(&mut self, (centre, to): (DVec3, DVec3), direction: f64, sweep: Option<f64>, feed: f64) {
        self.here = to;
        self.legs.push(Leg::Arc { centre, to, direction, sweep, feed });
    }

    /// On a quarter circle downwards about a centre above the end, along the main axis there.
    pub fn upright(&mut self, centre: DVec3, to: DVec3, feed: f64) {
        self.sideways((centre, to), -90.0, feed);
    }

    /// On an arc in the plane of the tool axis and the main axis by a signed angle from the one towards the other.
    pub fn sideways(&mut self, (centre, to): (DVec3, DVec3), sweep: f64, feed: f64) {
        self.here = to;
        self.legs.push(Leg::Upright { centre, to, sweep, feed });
    }

    /// From here on in step with the turning spindle, which begins at an angle and keeps its speed on a diameter.
    pub fn in_step(&mut self, angle: f64, diameter: f64) {
        self.legs.push(Leg::InStep { here: self.here, angle, diameter });
    }

    /// Straight along the tool axis.
    pub fn down(&mut self, height: f64, feed: f64) {
        self.line(self.here.truncate().extend(height), feed);
    }

    /// Straight to a point of a figure at the present height.
    pub fn to(&mut self, place: &Place, to: DVec2, feed: f64) {
        self.line(place.at(to).extend(self.here.z), feed);
    }

    /// On an arc to a point of a figure at a height.
    pub fn around(&mut self, place: &Place, (centre, to): (DVec2, DVec2), height: f64, direction: f64, feed: f64) {
        self.arc((place.at(centre).extend(height), place.at(to).extend(height)), direction, None, feed);
    }

    /// Once around at the present height; the tool is at the beginning of the outline.
    pub fn outline(&mut self, place: &Place, outline: &Outline, feed: f64) {
        let height = self.here.z;
        for piece in outline.pieces() {
            match *piece {
                Piece::Line(to) => self.to(place, to, feed),
                Piece::Arc(centre, to, direction) => self.around(place, (centre, to), height, direction, feed),
            }
        }
    }

    /// Joins an outline on a quarter circle.
    pub fn join(&mut self, place: &Place, tangent: &Tangent, outline: &Outline, feed: f64) {
        let height = self.here.z;
        self.to(place, tangent.before, feed);
        self.around(place, (tangent.centre, outline.start), height, tangent.direction, feed);
    }

    /// Leaves an outline on a quarter circle.
    pub fn leave(&mut self, place: &Place, tangent: &Tangent, feed: f64) {
        self.around(place, (tangent.centre, tangent.after), self.here.z, tangent.direction, feed);
    }
}
