//! A movement of several axes at once: where it takes a point of the tool, and how far that can be from where it was.
//!
//! Invariant: all axes begin and end together and turn evenly. The bounds are proven ones: no point goes farther than
//! they say, so what is farther away than that is never reached.
use glam::DVec3;

use super::{Carried, Machine, RotaryMachineAxis};
use crate::engine::geometry::Frame;

/// What runs straight while the rotary axes turn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Straight {
    /// The linear axes, from one of their positions to another.
    Axes(DVec3, DVec3),
    /// The tool tip relative to the workpiece, in the machine as it would be with all axes of the table at 0: the
    /// linear axes hold it there.
    Tip(DVec3, DVec3),
}

/// A movement of linear and rotary axes.
#[derive(Clone, Copy, Debug)]
pub struct Course<'m> {
    machine: &'m Machine,
    /// The rotary axes at its beginning and at its end.
    angles: [DVec3; 2],
    straight: Straight,
    /// From the tool tip to the point about which the head turns, while it is at 0.
    pivot: DVec3,
}

/// The rotary axes of a machine that carry the same, from the one that is carried last, with their way in radians.
type Turns<'m> = Vec<(&'m RotaryMachineAxis, f64)>;

impl<'m> Course<'m> {
    /// A movement between two positions of the rotary axes; `pivot` leads from the tool tip to the point about which
    /// the head turns, while it is at 0.
    pub const fn new(machine: &'m Machine, angles: [DVec3; 2], straight: Straight, pivot: DVec3) -> Self {
        Self { machine, angles, straight, pivot }
    }

    /// The rotary axes when a share of it is done.
    pub fn angles(&self, share: f64) -> DVec3 {
        let [from, to] = self.angles;
        from + (to - from) * share
    }

    /// What runs straight, then.
    fn on_line(&self, share: f64) -> DVec3 {
        let (Straight::Axes(from, to) | Straight::Tip(from, to)) = self.straight;
        from + (to - from) * share
    }

    fn line(&self) -> f64 {
        let (Straight::Axes(from, to) | Straight::Tip(from, to)) = self.straight;
        (to - from).length()
    }

    /// The axes that carry something, the last first, with how far each turns.
    fn turns(&self, carries: Carried) -> Turns<'m> {
        let [from, to] = self.angles;
        let own = self.machine.rotary.iter().rev().filter(|axis| axis.carries == carries);
        own.map(|axis| (axis, (axis.axis.of(to) - axis.axis.of(from)).to_radians().abs())).collect()
    }

    /// Where a point of the tool is when a share of the movement is done, seen from what lies on the table, in the
    /// machine as it would be with all axes of the table at 0.
    /// `arm` leads from the tip to the point while the head is at 0.
    pub fn at(&self, arm: DVec3, share: f64) -> DVec3 {
        let (angles, line) = (self.angles(share), self.on_line(share));
        let (table, head) = (self.machine.table(angles), self.machine.head(angles));
        match self.straight {
            Straight::Tip(..) => line + table.inverse().vector(head.vector(arm)),
            Straight::Axes(..) => table.inverse().point(line + self.pivot + head.point(arm - self.pivot)),
        }
    }

    /// How far, at most, that point is from where it is at `middle`, at any moment not more than `half` away from it.
    pub fn reach(&self, arm: DVec3, middle: f64, half: f64) -> f64 {
        let (table, head) = (self.turns(Carried::Workpiece), self.turns(Carried::Tool));
        let turned = |turns: &Turns<'_>| turns.iter().map(|(_, way)| way).sum::<f64>();
        match self.straight {
            Straight::Tip(..) => half * (self.line() + (turned(&table) + turned(&head)) * arm.length()),
            Straight::Axes(..) => {
                let mut speed = self.line() + turned(&head) * ((arm - self.pivot).length() + self.off_pivot());
                // The point goes inwards through the axes of the table: each sees it turn about itself, and what the
                // outer ones add to its way.
                let angles = self.angles(middle);
                let mut seen = self.on_line(middle) + self.pivot + self.machine.head(angles).point(arm - self.pivot);
                for (axis, way) in table.iter().rev() {
                    let arm = across(axis, seen) + half * speed;
                    speed += way * arm;
                    seen = axis.turned(axis.axis.of(angles)).inverse().point(seen);
                }
                half * speed
            }
        }
    }

    /// The linear axes when a share of the movement is done: the tool tip in the machine while the head is at 0.
    pub fn axes(&self, share: f64) -> DVec3 {
        let (angles, line) = (self.angles(share), self.on_line(share));
        match self.straight {
            Straight::Axes(..) => line,
            Straight::Tip(..) => {
                let tip = self.machine.table(angles).point(line);
                tip - self.machine.head(angles).point(-self.pivot) - self.pivot
            }
        }
    }

    /// How far, at most, the linear axes are from where they are at `middle`, at any moment not more than `half` away.
    pub fn axes_reach(&self, middle: f64, half: f64) -> f64 {
        let head = self.turns(Carried::Tool).iter().map(|(_, way)| way).sum::<f64>();
        let mut speed = self.line();
        if let Straight::Tip(..) = self.straight {
            let angles = self.angles(middle);
            let mut seen = self.on_line(middle);
            for (axis, way) in self.turns(Carried::Workpiece) {
                let arm = across(axis, seen) + half * speed;
                speed += way * arm;
                seen = axis.turned(axis.axis.of(angles)).point(seen);
            }
            speed += head * (self.pivot.length() + self.off_pivot());
        }
        half * speed
    }

    /// How far the lines about which the axes of the head turn are, at most, from the point about which it swivels.
    fn off_pivot(&self) -> f64 {
        let own = self.machine.rotary.iter().filter(|axis| axis.carries == Carried::Tool);
        own.map(|axis| 2.0 * axis.centre.length()).sum()
    }

    /// The same movement of another machine: the true one, while this one is what the control believes.
    #[must_use]
    pub const fn on(self, machine: &'m Machine) -> Self {
        Self { machine, ..self }
    }

    /// The frame of the table when the movement begins: what lies on it was there when all its axes were at 0.
    pub fn table_at_start(&self) -> Frame {
        self.machine.table(self.angles[0])
    }
}

/// How far a point is from the line about which an axis turns.
fn across(axis: &RotaryMachineAxis, point: DVec3) -> f64 {
    (point - axis.centre).reject_from(axis.about.0.unit()).length()
}
