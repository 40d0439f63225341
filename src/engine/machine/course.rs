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
    fn angles(&self, share: f64) -> DVec3 {
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
            Straight::Axes(..) => table.inverse().point(line + self.pivot + head.vector(arm - self.pivot)),
        }
    }

    /// How far, at most, that point is from where it is at `middle`, at any moment not more than `half` away from it.
    pub fn reach(&self, arm: DVec3, middle: f64, half: f64) -> f64 {
        let (table, head) = (self.turns(Carried::Workpiece), self.turns(Carried::Tool));
        let turned = |turns: &Turns<'_>| turns.iter().map(|(_, way)| way).sum::<f64>();
        match self.straight {
            Straight::Tip(..) => half * (self.line() + (turned(&table) + turned(&head)) * arm.length()),
            Straight::Axes(..) => {
                let mut speed = self.line() + turned(&head) * (arm - self.pivot).length();
                // The point goes inwards through the axes of the table: each sees it turn about itself, and what the
                // outer ones add to its way.
                let angles = self.angles(middle);
                let mut seen = self.on_line(middle) + self.pivot + self.machine.head(angles).vector(arm - self.pivot);
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
                tip + self.machine.head(angles).vector(self.pivot) - self.pivot
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
            speed += head * self.pivot.length();
        }
        half * speed
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::engine::geometry::{Axis, RotaryAxis};
    use crate::engine::machine::MachineAxis;

    fn rotary(letter: char, carries: Carried, about: (Axis, f64), centre: DVec3) -> RotaryMachineAxis {
        let axis = RotaryAxis::from_letter(letter).expect("a letter");
        RotaryMachineAxis { axis, carries, about, centre, limits: None, rapid: 3600.0 }
    }

    /// Tables of two axes with centres of their own, heads, and one axis of each.
    fn machines() -> Vec<Machine> {
        let axes = Axis::ALL.map(|axis| MachineAxis { axis, min: -1e3, max: 1e3, rapid: 1e4, acceleration: 2e3 });
        let made = |rotary: Vec<RotaryMachineAxis>, pivot| Machine {
            name: String::new(),
            spindle: Axis::Z,
            axes: axes.to_vec(),
            rotary,
            pivot,
        };
        let (one, other) = (DVec3::new(10.0, -20.0, -50.0), DVec3::new(-7.0, 3.0, 30.0));
        vec![
            made(
                vec![
                    rotary('A', Carried::Workpiece, (Axis::X, -1.0), one),
                    rotary('C', Carried::Workpiece, (Axis::Z, -1.0), other),
                ],
                0.0,
            ),
            made(
                vec![
                    rotary('C', Carried::Tool, (Axis::Z, 1.0), DVec3::ZERO),
                    rotary('B', Carried::Tool, (Axis::Y, 1.0), DVec3::ZERO),
                ],
                120.0,
            ),
            made(
                vec![
                    rotary('B', Carried::Tool, (Axis::Y, 1.0), DVec3::ZERO),
                    rotary('C', Carried::Workpiece, (Axis::Z, -1.0), one),
                ],
                80.0,
            ),
        ]
    }

    /// No point and no axis is ever farther from the middle of a stretch than its bound; and the bound is no more than
    /// a few times too large, or nothing could be proven with it.
    #[test]
    fn nothing_goes_farther_than_its_bound() {
        let angles = [DVec3::new(-20.0, 15.0, 40.0), DVec3::new(35.0, -30.0, -100.0)];
        let (from, to) = (DVec3::new(60.0, -10.0, 80.0), DVec3::new(-20.0, 40.0, 10.0));
        let mut looked = 0;
        for machine in machines() {
            for straight in [Straight::Axes(from, to), Straight::Tip(from, to)] {
                let course = Course::new(&machine, angles, straight, DVec3::Z * (machine.pivot + 95.0));
                for arm in [DVec3::ZERO, DVec3::new(0.3, -0.2, 2.0), DVec3::Z * 60.0] {
                    for (middle, half) in [(0.5, 0.5), (0.2, 0.1), (0.9, 0.01)] {
                        let way = |point: &dyn Fn(f64) -> DVec3| {
                            let at = |step: i32| point(middle + half * f64::from(step) / 50.0);
                            (-50..=50).map(|step| (at(step) - at(0)).length()).fold(0.0, f64::max)
                        };
                        let (gone, bound) = (way(&|share| course.at(arm, share)), course.reach(arm, middle, half));
                        assert!(gone <= bound && bound < 8.0 * gone, "{gone} {bound} {straight:?}");
                        let (gone, bound) = (way(&|share| course.axes(share)), course.axes_reach(middle, half));
                        assert!(gone <= bound && bound < 8.0 * gone, "{gone} {bound} {straight:?}");
                        looked += 1;
                    }
                }
            }
        }
        assert_eq!(looked, 54);
    }

    /// The tip that is held goes straight where the workpiece is, whatever turns.
    #[test]
    fn a_tip_that_is_held_goes_straight() {
        let angles = [DVec3::new(-20.0, 15.0, 40.0), DVec3::new(35.0, -30.0, -100.0)];
        let (from, to) = (DVec3::new(60.0, -10.0, 80.0), DVec3::new(-20.0, 40.0, 10.0));
        for machine in machines() {
            let pivot = DVec3::Z * (machine.pivot + 95.0);
            let held = Course::new(&machine, angles, Straight::Tip(from, to), pivot);
            for share in [0.0, 0.25, 1.0] {
                assert_eq!(held.at(DVec3::ZERO, share), from + (to - from) * share);
                // The same seen from the linear axes.
                let axes = held.axes(share);
                let still = Course::new(&machine, [held.angles(share); 2], Straight::Axes(axes, axes), pivot);
                assert!((still.at(DVec3::ZERO, 0.0) - held.at(DVec3::ZERO, share)).length() < 1e-12);
            }
        }
    }
}
