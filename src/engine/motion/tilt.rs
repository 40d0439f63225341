//! The tilted working plane: where the rotary axes must be, and turning them there.
//!
//! Invariant: positions follow from the axes of the machine alone; of two that do, the one nearer to 0 is taken. A
//! plane that the axes cannot reach is a fault.
use glam::DVec3;

use crate::base::expr::atan2d;
use crate::engine::geometry::{Frame, RotaryAxis};
use crate::engine::machine::{Carried, Machine, MachineAxis, RotaryMachineAxis};
use crate::engine::motion::drives::Drives;
use crate::engine::motion::moves::Speed;
use crate::engine::report::ending::Done;
use crate::engine::report::fault::Fault;

/// Directions that differ by less are the same.
const SAME: f64 = 1e-9;
/// A direction whose part along another one is less is at right angles to it.
const STRAIGHT: f64 = 1e-6;

/// Parts of a direction below this are rounding: the axis does not move.
const STILL: f64 = 1e-9;

/// How far the tool is retracted before the axes turn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Back {
    By(f64),
    ToLimit,
}

/// The direction about which an axis turns what it carries, right-handed for growing coordinates.
fn about(axis: &RotaryMachineAxis) -> DVec3 {
    axis.direction()
}

/// The rotary axis whose sign chooses between two positions.
fn master<'m>(machine: &'m Machine, tilts: &dyn Fn(&RotaryMachineAxis) -> bool) -> Option<&'m RotaryMachineAxis> {
    let of = |carried| machine.rotary.iter().filter(move |axis| axis.carries == carried && tilts(axis));
    of(Carried::Tool).last().or_else(|| of(Carried::Workpiece).next())
}

/// By which angle about an axis one direction becomes another; 0 for those along the axis.
fn angle_about(axis: DVec3, from: DVec3, to: DVec3) -> f64 {
    let (from, to) = (from.reject_from(axis), to.reject_from(axis));
    if from.length() < SAME || to.length() < SAME { 0.0 } else { atan2d(axis.dot(from.cross(to)), from.dot(to)) }
}

/// The angles by which `p` about `a` and `q` about `b` come to lie on each other.
fn meet(a: DVec3, p: DVec3, b: DVec3, q: DVec3) -> Vec<(f64, f64)> {
    let (c, across) = (a.dot(b), a.cross(b));
    let square = across.length_squared();
    if square < SAME {
        return Vec::new();
    }
    let (along_a, along_b) = (p.dot(a), q.dot(b));
    let (x, y) = ((along_a - c * along_b) / square, (along_b - c * along_a) / square);
    let rest = (1.0 - x * x - y * y - 2.0 * x * y * c) / square;
    if rest < -SAME {
        return Vec::new();
    }
    let side = libm::sqrt(rest.max(0.0));
    [side, -side]
        .into_iter()
        .map(|side| {
            let met = a * x + b * y + across * side;
            (angle_about(a, p, met), angle_about(b, q, met))
        })
        .collect()
}

impl Drives<'_, '_> {
    /// Where the rotary axes must stand for the tilted plane, in program coordinates.
    pub(crate) fn rotary_positions(&self) -> Result<DVec3, Fault> {
        self.rotary_positions_with(None)
    }

    /// The same with a positive (`Some(true)`) or negative angle of the master axis: the one next to the tool, or, where
    /// the head has none, the one farthest from the workpiece.
    pub(crate) fn rotary_positions_with(&self, positive: Option<bool>) -> Result<DVec3, Fault> {
        let (system, machine) = (&self.world.system, self.world.kinematics());
        let datum = system.angle_datum();
        let tool = machine.spindle.unit();
        // The direction of the plane in the workpiece while all axes of the table are at 0.
        let plane = system.table.inverse().of(*system.frame()).vector(system.plane.tool.unit()).normalize();
        // A mirrored tool axis does not turn the plane over.
        let plane = plane * system.plane.tool.of(system.mirror().0);
        let plane = machine.table(datum).inverse().vector(plane);
        let tilts = |axis: &RotaryMachineAxis| self.world.tilts(axis.axis);
        let reached = self.reaching(plane).into_iter().filter_map(|angles| {
            let all = angles.iter().fold(datum, |all, (axis, angle)| axis.axis.with(all, *angle));
            let straight = machine.table(all).vector(plane) - machine.head(all).vector(tool);
            let within = angles.iter().all(|(axis, angle)| axis.reaches(*angle));
            let position = (all - datum) * system.mirror().1;
            let angle = master(machine, &tilts).map_or(0.0, |axis| axis.axis.of(position));
            let asked = positive.is_none_or(|positive| if positive { angle > -SAME } else { angle < SAME });
            (straight.length() < 1e-6 && within && asked).then_some(position)
        });
        let nearer = reached.reduce(|a, b| if b.length_squared() < a.length_squared() - SAME { b } else { a });
        nearer.ok_or_else(|| Fault::control("tilting-unreachable"))
    }

    /// The angles of rotary axes, in machine coordinates, with which the tool is along a direction of the workpiece, seen
    /// while all axes of the table are at 0. They still have to be proven: the head may have been turned before.
    fn reaching(&self, plane: DVec3) -> Vec<Vec<(&RotaryMachineAxis, f64)>> {
        let machine = self.world.kinematics();
        let tool = machine.spindle.unit();
        let tilts = |axis: &RotaryMachineAxis| self.world.tilts(axis.axis);
        let of =
            |carried| machine.rotary.iter().filter(|axis| axis.carries == carried && tilts(axis)).collect::<Vec<_>>();
        match (&*of(Carried::Workpiece), &*of(Carried::Tool)) {
            ([], []) => vec![Vec::new()],
            ([one], []) => vec![vec![(*one, angle_about(about(one), plane, tool))]],
            ([], [one]) => vec![vec![(*one, angle_about(about(one), tool, plane))]],
            ([outer, inner], []) => meet(about(inner), plane, about(outer), tool)
                .into_iter()
                .map(|(angle, back)| vec![(*inner, angle), (*outer, -back)])
                .collect(),
            ([], [outer, inner]) => meet(about(inner), tool, about(outer), plane)
                .into_iter()
                .map(|(angle, back)| vec![(*inner, angle), (*outer, -back)])
                .collect(),
            ([table], [head]) => meet(about(table), plane, about(head), tool)
                .into_iter()
                .map(|(a, b)| vec![(*table, a), (*head, b)])
                .collect(),
            _ => Vec::new(),
        }
    }

    /// Where the rotary axes go so that the tool is along a direction of the program, in machine coordinates: of the
    /// positions that do it the one with the shortest way; an axis that does not matter stays.
    pub(crate) fn turns_along(&self, direction: DVec3) -> Result<Vec<(RotaryAxis, f64)>, Fault> {
        let (system, machine) = (&self.world.system, self.world.kinematics());
        let (tool, datum, now) = (machine.spindle.unit(), system.angle_datum(), self.world.angles);
        let wanted = system.table.inverse().of(*system.frame()).vector(direction).normalize();
        let wanted = machine.table(datum).inverse().vector(wanted);
        let off = |all: DVec3| (machine.table(all).vector(wanted) - machine.head(all).vector(tool)).length();
        if off(now) < SAME {
            return Ok(Vec::new());
        }
        let positions = self.reaching(wanted).into_iter().filter_map(|angles| {
            let mut all = angles.iter().fold(now, |all, (axis, angle)| axis.axis.with(all, *angle));
            if off(all) > STRAIGHT {
                return None;
            }
            for (own, _) in &angles {
                let stays = own.axis.with(all, own.axis.of(now));
                // Nearest to where it is, by whole turns.
                let angle = own.axis.of(all);
                let turns = libm::round((own.axis.of(now) - angle) / 360.0);
                let near = [turns, turns - 1.0, turns + 1.0].map(|turns| angle + 360.0 * turns);
                let way = |angle: f64| (angle - own.axis.of(now)).abs();
                let reached = near.into_iter().filter(|angle| own.reaches(*angle));
                let nearest = reached.min_by(|a, b| way(*a).total_cmp(&way(*b)))?;
                all = if off(stays) < SAME { stays } else { own.axis.with(all, nearest) };
            }
            Some(all)
        });
        let far = |all: &DVec3| (*all - now).abs().max_element();
        let nearer = positions.reduce(|a, b| if far(&b) < far(&a) - SAME { b } else { a });
        let all = nearer.ok_or_else(|| Fault::control("tool-direction-unreachable"))?;
        Ok(machine.rotary.iter().map(|own| (own.axis, own.axis.of(all))).collect())
    }

    /// The positions with the table turned so that the main axis of the plane is that of the machine, where an axis
    /// of the table is free to do so: it turns about the tool and leaves the plane as it is. In program coordinates.
    pub(crate) fn with_table_turned(&self, positions: DVec3) -> Result<DVec3, Fault> {
        let (system, machine) = (&self.world.system, &self.world.scene.machine);
        let datum = system.angle_datum();
        let all = positions * system.mirror().1 + datum;
        let tool = machine.head(all).vector(machine.spindle.unit()).normalize();
        let is_free = |axis: &&RotaryMachineAxis| {
            axis.carries == Carried::Workpiece
                && self.world.tilts(axis.axis)
                && machine.turning(axis, all).direction.dot(tool).abs() > 1.0 - SAME
        };
        // The workpiece is clamped on the last one.
        let Some(axis) = machine.rotary.iter().rev().find(is_free) else { return Ok(positions) };
        let main = system.plane.main;
        let of_plane = system.table.inverse().of(*system.frame()).vector(main.unit()) * main.of(system.mirror().0);
        let of_plane = machine.table(all).vector(machine.table(datum).inverse().vector(of_plane));
        let by = angle_about(machine.turning(axis, all).direction.normalize(), of_plane, main.unit());
        let to = axis.axis.of(all) + by;
        if !axis.reaches(to) {
            return Err(Fault::control("tilting-unreachable"));
        }
        Ok((axis.axis.with(all, to) - datum) * system.mirror().1)
    }

    /// The plane at right angles to the tool with the rotary axes at these positions, in program coordinates: its system
    /// as seen from the one that is not tilted.
    pub(crate) fn tilt_by_axes(&self, positions: DVec3) -> Frame {
        let (system, machine) = (&self.world.system, self.world.kinematics());
        let datum = system.angle_datum();
        let all = positions * system.mirror().1 + datum;
        let turned = |frame: Frame| Frame::placed(DVec3::ZERO, frame.spatial_angles());
        let (before, table, head) = (machine.table(datum), machine.table(all), machine.head(all));
        let by_axes =
            turned(before).of(turned(table).inverse()).of(turned(head)).of(turned(machine.head(datum)).inverse());
        // As seen from a system that may be turned itself.
        let mut level = system.clone();
        level.set_tilt(DVec3::ZERO);
        let base = if level.frame().mirrors() { Frame::IDENTITY } else { turned(*level.frame()) };
        base.inverse().of(by_axes).of(base)
    }

    /// Whether the spindle is at right angles to the rotary axis on which the workpiece is clamped;
    /// not where there is none.
    pub(crate) fn spindle_is_across(&self) -> bool {
        let (world, machine) = (&self.world, self.world.kinematics());
        let spindle = machine.head(world.angles).vector(machine.spindle.unit()).normalize();
        machine
            .clamped_on()
            .is_some_and(|axis| machine.turning(axis, world.angles).direction.dot(spindle).abs() < STRAIGHT)
    }

    /// Positions of all rotary axes of the machine, in program coordinates, as targets.
    pub(crate) fn turns_in_program(&self, to: DVec3) -> Vec<(RotaryAxis, f64)> {
        let wanted = to * self.world.system.mirror().1 + self.world.system.angle_datum();
        let of_machine = |axis: &RotaryMachineAxis| (axis.axis, axis.axis.of(wanted));
        self.world.scene.machine.rotary.iter().map(of_machine).collect()
    }

    /// Turns the axes; the point that far before the tip keeps its place on the workpiece, and the tool returns to it.
    pub(crate) fn turn_about_point(&mut self, to: DVec3, distance: f64, speed: Result<Speed, Fault>) -> Done {
        let turns = self.turns_in_program(to);
        let machine = self.world.kinematics();
        let direction = machine.head(self.world.angles).vector(machine.spindle.unit());
        let system = &self.world.system;
        if !system.is_on_workpiece() {
            // A system that is not tilted stays with the machine: the point goes with the table, and the axes after it.
            let (before, spindle) = (self.world.angles, machine.spindle.unit());
            let after = turns.iter().fold(before, |angles, (axis, angle)| axis.with(angles, *angle));
            let (head, turned) = (machine.head(before), machine.head(after));
            let tip = self.world.machine + self.world.swing(&head);
            let held = tip - direction.normalize() * distance;
            let held = machine.table(after).point(machine.table(before).inverse().point(held));
            let end = held + turned.vector(spindle).normalize() * distance - self.world.swing(&turned);
            self.turn_to(&turns, speed.clone())?;
            return self.straight_to(self.world.to_program(end), Some(end), speed);
        }
        let held = self.world.here - system.back().vector(direction).normalize() * distance;
        let to = held + system.plane.tool.unit() * distance;
        self.turn_to(&turns, speed.clone())?;
        self.straight_to(to, None, speed)
    }

    /// Back along the tool, as far as the axes go if it shall be the greatest way.
    pub(crate) fn retract_before_turning(&mut self, back: Back) -> Done {
        let back = if let Back::By(way) = back { Back::By(way.max(0.0)) } else { back };
        let machine = self.world.kinematics();
        let along = machine.head(self.world.angles).vector(machine.spindle.unit()).normalize();
        self.retract_along(along, back, Ok(Speed::Rapid))
    }

    /// The direction of the tool in the machine where it is that of the tool axis for the control, too: of the tilted
    /// working plane, or of the machine where none is tilted.
    pub(crate) fn along_tool_axis(&self) -> Option<DVec3> {
        let system = &self.world.system;
        let axis = system.plane.tool.unit();
        let along = self.world.kinematics().head(self.world.angles).vector(axis).normalize();
        let axis = if system.tilt().is_some() { system.frame().vector(axis).normalize() } else { axis };
        ((axis - along).length() < STRAIGHT).then_some(along)
    }

    /// In a direction of the machine, as far as the axes go if it shall be the greatest way.
    pub(crate) fn retract_along(&mut self, along: DVec3, back: Back, speed: Result<Speed, Fault>) -> Done {
        let here = self.world.machine;
        let to_limit = |axis: &MachineAxis| {
            let part = axis.axis.of(along);
            (if part > 0.0 { axis.max } else { axis.min } - axis.axis.of(here)) / part
        };
        let way = match back {
            Back::By(way) => way,
            Back::ToLimit => {
                let moving = self.world.kinematics().axes.iter().filter(|axis| axis.axis.of(along).abs() > STILL);
                moving.map(to_limit).fold(f64::INFINITY, f64::min).max(0.0)
            }
        };
        let to = here + along * way;
        self.straight_to(self.world.to_program(to), Some(to), speed)
    }
}
