//! The tilted working plane: where the rotary axes must stand, and turning them there.
//!
//! Invariant: positions follow from the axes of the machine alone; of two that do, the one nearer to 0 is taken. A
//! plane that the axes cannot reach is a fault.
use glam::DVec3;

use crate::base::expr::{Value, atan2d};
use crate::engine::cycle::execute::Exec;
use crate::engine::geometry::RotaryAxis;
use crate::engine::machine::{Carried, RotaryMachineAxis};
use crate::engine::motion::moves::Speed;
use crate::engine::plan::StrategyCall;
use crate::engine::report::fault::Fault;
use crate::engine::run::{Done, Run};

/// Directions that differ by less are the same.
const SAME: f64 = 1e-9;
/// A direction whose part along another one is less stands at right angles to it.
const STRAIGHT: f64 = 1e-6;

/// The direction about which an axis turns what it carries, right-handed for growing coordinates.
fn about(axis: &RotaryMachineAxis) -> DVec3 {
    axis.about.0.unit() * axis.about.1
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

impl<'e> Run<'_, 'e> {
    /// Where the rotary axes must stand: the tool at right angles to the tilted plane, in program coordinates.
    pub(in crate::engine) fn compute_rotary_positions(&mut self, call: &StrategyCall, exec: &mut Exec<'_, 'e>) -> Done {
        let found = match self.world.system.tilt() {
            Some(_) => self.rotary_positions()?,
            None => DVec3::ZERO,
        };
        for (slot, axis) in call.results.iter().zip(RotaryAxis::ALL) {
            exec.put(*slot, Value::Number(axis.of(found)));
        }
        Ok(())
    }

    /// Where the rotary axes must stand for the tilted plane, in program coordinates.
    pub(in crate::engine) fn rotary_positions(&self) -> Result<DVec3, Fault> {
        let (system, machine) = (&self.world.system, &self.world.scene.machine);
        let datum = system.angle_datum();
        let tool = machine.spindle.unit();
        // The direction of the plane in the workpiece while all axes of the table stand at 0.
        let plane = system.table.inverse().of(*system.frame()).vector(system.plane.tool.unit()).normalize();
        // A mirrored tool axis does not turn the plane over.
        let plane = plane * system.plane.tool.of(system.mirror().0);
        let plane = machine.table(datum).inverse().vector(plane);
        let of = |carried| machine.rotary.iter().filter(move |axis| axis.carries == carried).collect::<Vec<_>>();
        let found: Vec<Vec<(&RotaryMachineAxis, f64)>> = match (&*of(Carried::Workpiece), &*of(Carried::Tool)) {
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
        };
        let reached = found.into_iter().filter_map(|angles| {
            let all = angles.iter().fold(datum, |all, (axis, angle)| axis.axis.with(all, *angle));
            let straight = machine.table(all).vector(plane) - machine.head(all).vector(tool);
            let within = angles.iter().all(|(axis, angle)| axis.reaches(*angle));
            (straight.length() < 1e-6 && within).then_some((all - datum) * system.mirror().1)
        });
        let nearer = reached.reduce(|a, b| if b.length_squared() < a.length_squared() - SAME { b } else { a });
        nearer.ok_or_else(|| Fault::control("tilting-unreachable"))
    }

    /// Whether the spindle stands at right angles to the rotary axis on which the workpiece is clamped;
    /// not where there is none.
    pub(in crate::engine) fn spindle_is_across(&self) -> bool {
        let (world, machine) = (&self.world, &self.world.scene.machine);
        let spindle = machine.head(world.angles).vector(machine.spindle.unit()).normalize();
        let clamped = machine.rotary.iter().rev().find(|axis| axis.carries == Carried::Workpiece);
        clamped.is_some_and(|axis| machine.turning(axis, world.angles).direction.dot(spindle).abs() < STRAIGHT)
    }

    /// Turns the axes; a point that far before the tip keeps its place on the workpiece, and the tool returns to it.
    pub(in crate::engine) fn position_rotary_axes(&mut self, call: &StrategyCall, exec: &Exec<'_, 'e>) -> Done {
        let [a, b, c, feed, clearance] = self.all_given(call, 0, exec)?;
        self.turn_about_point(DVec3::new(a, b, c), clearance, Speed::of_feed(feed))
    }
}
