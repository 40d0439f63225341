//! Rotary axes: what each carries, about what it turns, and where that puts workpiece and tool.
//!
//! Invariant: angles are degrees in machine coordinates; frames are rigid and exact up to rounding.
use glam::DVec3;

use super::Machine;
use crate::engine::geometry::{Axis, Frame, RotaryAxis};
use crate::engine::read::Reader;
use crate::spec::Node;

/// What a rotary axis carries.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Carried {
    /// The workpiece: an axis of the table.
    Workpiece,
    /// The tool: an axis of the head.
    Tool,
}

/// A rotary axis of a machine.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RotaryMachineAxis {
    /// Its letter.
    pub axis: RotaryAxis,
    /// What it carries.
    pub carries: Carried,
    /// What it carries turns right-handed about this axis when its coordinate grows:
    /// +1 as the axis points, -1 against it.
    pub about: (Axis, f64),
    /// A point that stays where it is while all other axes are at 0: of the table in machine coordinates, of the head
    /// seen from the point about which the head swivels.
    pub centre: DVec3,
    /// By how much the line about which it turns is out of its direction: angles in degrees about X, Y and Z.
    pub askew: DVec3,
    /// The grid of an axis with Hirth teeth, degrees; others stop anywhere.
    pub hirth: Option<f64>,
    /// Whether its angle is measured with the encoder of its motor, and not with one of its own.
    pub is_measured_at_motor: bool,
    /// The lowest and the highest machine coordinate in degrees; without them it turns without end.
    pub limits: Option<(f64, f64)>,
    /// Rapid traverse in degrees a minute.
    pub rapid: f64,
}

impl RotaryMachineAxis {
    /// What turning it to that coordinate does to what it carries.
    pub(super) fn turned(&self, degrees: f64) -> Frame {
        let turn = Frame::rotate(self.about.0, self.about.1 * degrees);
        if self.askew == DVec3::ZERO {
            return Frame::shift(self.centre).of(turn).of(Frame::shift(-self.centre));
        }
        if degrees == 0.0 {
            return Frame::IDENTITY;
        }
        let line = Frame::placed(self.centre, self.askew);
        line.of(turn).of(line.inverse())
    }

    /// The direction about which it turns what it carries, while all other axes are at 0.
    pub fn direction(&self) -> DVec3 {
        Frame::placed(DVec3::ZERO, self.askew).vector(self.about.0.unit() * self.about.1)
    }

    /// Whether it turns without end.
    pub const fn is_endless(&self) -> bool {
        self.limits.is_none()
    }

    /// Whether the coordinate is at least so far from both limits, degrees.
    pub fn keeps_from_limits(&self, degrees: f64, way: f64) -> bool {
        self.reaches(degrees - way) && self.reaches(degrees + way)
    }

    /// Whether the coordinate is within its limits.
    pub fn reaches(&self, degrees: f64) -> bool {
        self.limits.is_none_or(|(min, max)| (min - super::ROUNDING..=max + super::ROUNDING).contains(&degrees))
    }
}

/// How what an axis carries turns when it alone moves.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Turning {
    /// A point of the line about which it turns: in machine coordinates, of a head seen from the point about which it
    /// swivels.
    pub centre: DVec3,
    /// The direction of that line, right-handed for growing coordinates.
    pub direction: DVec3,
}

impl Machine {
    /// The data of a rotary axis, if the machine has it.
    pub fn rotary(&self, axis: RotaryAxis) -> Option<&RotaryMachineAxis> {
        self.rotary.iter().find(|known| known.axis == axis)
    }

    /// Where the table puts what lies on it, seen from where it lies while all axes are at 0.
    pub fn table(&self, angles: DVec3) -> Frame {
        self.chain(Carried::Workpiece, angles, None)
    }

    /// How the head turns the tool, about the point about which it swivels.
    pub fn head(&self, angles: DVec3) -> Frame {
        self.chain(Carried::Tool, angles, None)
    }

    /// The axes that carry the same thing, from the machine bed on, up to one of them or all.
    fn chain(&self, carries: Carried, angles: DVec3, before: Option<RotaryAxis>) -> Frame {
        let own = self.rotary.iter().filter(|axis| axis.carries == carries);
        let carrying = own.take_while(|axis| Some(axis.axis) != before);
        carrying.fold(Frame::IDENTITY, |frame, axis| frame.of(axis.turned(axis.axis.of(angles))))
    }

    /// The line about which an axis turns now.
    pub fn turning(&self, axis: &RotaryMachineAxis, angles: DVec3) -> Turning {
        let carried_by = self.chain(axis.carries, angles, Some(axis.axis));
        Turning { centre: carried_by.point(axis.centre), direction: carried_by.vector(axis.direction()) }
    }

    /// The first rotary axis that a position takes beyond its limits.
    pub fn turned_too_far(&self, angles: DVec3) -> Option<&RotaryMachineAxis> {
        self.rotary.iter().find(|axis| !axis.reaches(axis.axis.of(angles)))
    }
}

/// Reads the rotary axes of a machine.
pub(super) fn read(list: &Node, reader: &mut Reader<'_>) -> Vec<RotaryMachineAxis> {
    let mut axes: Vec<RotaryMachineAxis> = Vec::new();
    for item in reader.items(list) {
        let Some(axis) = read_axis(item, reader) else { continue };
        if axes.iter().any(|known| known.axis == axis.axis) {
            reader.report("scene-repeated", item, vec![("found", axis.axis.letter().to_string().into())]);
            continue;
        }
        axes.push(axis);
    }
    axes
}

fn read_axis(node: &Node, reader: &mut Reader<'_>) -> Option<RotaryMachineAxis> {
    let carries = match reader.need(node, "carries")?.text() {
        Some("workpiece") => Carried::Workpiece,
        Some("tool") => Carried::Tool,
        _ => {
            let found = node.get("carries").unwrap_or(node);
            reader.expected(found, "carried");
            return None;
        }
    };
    reader.only_keys(node, &["axis", "carries", "about", "min", "max", "rapid", "centre", "askew", "hirth", "encoder"]);
    let letter = reader.need(node, "axis")?;
    let mut letters = letter.text().unwrap_or_default().chars();
    let axis = letters.next().and_then(RotaryAxis::from_letter).filter(|_| letters.next().is_none());
    let Some(axis) = axis else {
        reader.expected(letter, "rotary-axis");
        return None;
    };
    // The coordinates say how the tool turns relative to the workpiece, so a table turns the other way.
    let usual = (axis.0, if carries == Carried::Workpiece { -1.0 } else { 1.0 });
    let about = node.get("about").map_or(Some(usual), |about| direction(about, reader))?;
    let centre = node.get("centre").map_or(Some(DVec3::ZERO), |centre| reader.vector(centre))?;
    let askew = node.get("askew").map_or(Some(DVec3::ZERO), |askew| reader.angles(askew))?;
    let hirth = match node.get("hirth") {
        None => None,
        Some(grid) => Some(above_zero(grid, reader)?),
    };
    let is_measured_at_motor = match node.get("encoder").map(Node::text) {
        None | Some(Some("axis")) => false,
        Some(Some("motor")) => true,
        Some(_) => {
            reader.expected(node.get("encoder").unwrap_or(node), "encoder");
            return None;
        }
    };
    let mut angle = |key: &str| node.get(key).map_or(Some(None), |node| reader.number(node).map(Some));
    let limits = match (angle("min")?, angle("max")?) {
        (None, None) => None,
        (Some(min), Some(max)) if min < max => Some((min, max)),
        _ => {
            reader.report("scene-min-max", node, Vec::new());
            return None;
        }
    };
    let rapid = reader.need(node, "rapid")?;
    let rapid = above_zero(rapid, reader)?;
    Some(RotaryMachineAxis { axis, carries, about, centre, askew, hirth, is_measured_at_motor, limits, rapid })
}

/// A number above zero that is no length.
fn above_zero(node: &Node, reader: &mut Reader<'_>) -> Option<f64> {
    let number = reader.number(node)?;
    if number <= 0.0 {
        reader.report("scene-not-positive", node, vec![("found", number.into())]);
        return None;
    }
    Some(number)
}

/// `Z` or `-Z`.
fn direction(node: &Node, reader: &mut Reader<'_>) -> Option<(Axis, f64)> {
    let text = node.text().unwrap_or_default();
    let (sense, letter) = match text.strip_prefix('-') {
        Some(rest) => (-1.0, rest),
        None => (1.0, text.strip_prefix('+').unwrap_or(text)),
    };
    let mut letters = letter.chars();
    let axis = letters.next().and_then(Axis::from_letter).filter(|_| letters.next().is_none());
    if axis.is_none() {
        reader.expected(node, "axis");
    }
    Some((axis?, sense))
}
