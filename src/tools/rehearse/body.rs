//! The blank of a program, with the tool axis upwards.
use glam::DVec3;

use crate::engine::geometry::{Axis, WorkingPlane};
use crate::engine::solid::Shape;
use crate::engine::stock::Blank;

/// What lies so little inside of the blank is at its faces, mm.
pub(super) const SKIN: f64 = 0.05;
/// Places that are so near are the same, mm.
pub(super) const SAME: f64 = 0.01;

/// A blank: a box, or a cylinder about the tool axis; lengths in mm.
#[derive(Clone, Copy, Debug)]
pub(super) struct Body {
    /// The tool axis.
    pub(super) axis: Axis,
    /// The lowest corner of the box that holds it: main axis, secondary axis, tool axis.
    pub(super) low: DVec3,
    /// The highest one.
    pub(super) high: DVec3,
    /// Whether it is a cylinder about the middle of that box, and the radius of the bore in it.
    bore: Option<f64>,
}

impl Body {
    /// The body of a blank form.
    pub(super) fn of(blank: &Blank) -> Self {
        let plane = WorkingPlane::of_tool_axis(blank.axis);
        let [low, high] = blank.bounds.map(|corner| plane.flat(corner).extend(plane.tool.of(corner)));
        let bore = match &blank.shape {
            Shape::Cylinder { .. } => Some(0.0),
            Shape::Difference(shapes) => match shapes.last() {
                Some(Shape::Cylinder { radius, .. }) => Some(*radius),
                _ => None,
            },
            _ => None,
        };
        Self { axis: blank.axis, low, high, bore }
    }

    /// Whether it is a cylinder.
    pub(super) const fn is_round(&self) -> bool {
        self.bore.is_some()
    }

    /// The radius of the bore of a cylinder, 0 without one.
    pub(super) fn bore(&self) -> f64 {
        self.bore.unwrap_or_default()
    }

    /// How far a place is beside it in the plane; 0 inside.
    pub(super) fn distance(&self, place: DVec3) -> f64 {
        if let Some(bore) = self.bore {
            let middle = (self.low + self.high) / 2.0;
            let out = (place - middle).truncate().length();
            return (out - (self.high.x - self.low.x) / 2.0).max(bore - out).max(0.0);
        }
        let beyond = (self.low - place).max(place - self.high).max(DVec3::ZERO);
        libm::hypot(beyond.x, beyond.y)
    }

    /// Whether a place is at least so far inside of its sides, at any height.
    pub(super) fn is_within(&self, place: DVec3, margin: f64) -> bool {
        if let Some(bore) = self.bore {
            let out = (place - (self.low + self.high) / 2.0).truncate().length();
            return out <= (self.high.x - self.low.x) / 2.0 - margin && (bore <= 0.0 || out >= bore + margin);
        }
        let room = (place - self.low).min(self.high - place).truncate();
        room.min_element() >= margin
    }

    /// Whether a place is at least so far inside of its faces.
    pub(super) fn holds(&self, place: DVec3, skin: f64) -> bool {
        let inside = (place - self.low).min_element() > skin && (self.high - place).min_element() > skin;
        inside
            && self.bore.is_none_or(|bore| {
                let out = (place - (self.low + self.high) / 2.0).truncate().length();
                out < (self.high.x - self.low.x) / 2.0 - skin && out > bore + skin * bore.signum()
            })
    }
}
