//! Rotary axes turn: the table with the parts on it, the head with the tool.
//!
//! Invariant: relative to the parts, the ball of a probe runs on an arc while one axis turns, and that arc is proven free
//! of contact; what cannot be proven is a fault.
use glam::DVec3;

use super::event::Turned;
use super::fault::Fault;
use super::motion::Speed;
use super::{Done, EventKind, Run};
use crate::engine::geometry::RotaryAxis;
use crate::engine::machine::{Carried, RotaryMachineAxis};
use crate::engine::solid::Path as BallPath;
use crate::syntax::Axis;

/// A ball centre nearer to the axis, in mm, does not move when it turns.
const ON_AXIS: f64 = 1e-9;

/// The rotary axis of an axis word.
pub(super) const fn rotary(axis: Axis) -> Option<RotaryAxis> {
    match axis {
        Axis::A => RotaryAxis::from_letter('A'),
        Axis::B => RotaryAxis::from_letter('B'),
        Axis::C => RotaryAxis::from_letter('C'),
        _ => None,
    }
}

impl Run<'_, '_> {
    /// A rotary axis of the machine.
    pub(super) fn rotary_axis(&self, axis: RotaryAxis) -> Result<&RotaryMachineAxis, Fault> {
        let missing = || Fault::control("rotary-axis-missing").arg("axis", axis.letter().to_string());
        self.world.scene.machine.rotary(axis).ok_or_else(missing)
    }

    /// Whether axes can turn to these machine coordinates.
    pub(super) fn can_turn(&self, to: &[(RotaryAxis, f64)]) -> Result<(), Fault> {
        for (axis, _) in to {
            self.rotary_axis(*axis)?;
        }
        let angles = to.iter().fold(self.world.angles, |angles, (axis, angle)| axis.with(angles, *angle));
        self.world.turned_too_far(angles).map_or(Ok(()), Err)
    }

    /// Turns axes to machine coordinates; `together` tells that the tool moves at the same time.
    pub(super) fn turn_to(&mut self, to: &[(RotaryAxis, f64)], speed: Result<Speed, Fault>, together: bool) -> Done {
        self.can_turn(to)?;
        let before = self.world.angles;
        let after = to.iter().fold(before, |angles, (axis, angle)| axis.with(angles, *angle));
        let moving: Vec<RotaryAxis> =
            RotaryAxis::ALL.into_iter().filter(|axis| axis.of(after) != axis.of(before)).collect();
        if moving.is_empty() {
            return Ok(());
        }
        self.count_move()?;
        self.not_beside_contour(moving.iter().map(|axis| axis.letter()).collect::<String>())?;
        self.no_unexecuted()?;
        let ways: Vec<(f64, f64)> = moving
            .iter()
            .filter_map(|axis| self.world.scene.machine.rotary(*axis))
            .map(|axis| ((axis.axis.of(after) - axis.axis.of(before)).abs(), axis.rapid))
            .collect();
        let (rapid, feed) = match speed? {
            Speed::Feed(feed) => (false, feed),
            Speed::Rapid => {
                let longest = ways.iter().map(|(way, _)| *way).fold(0.0, f64::max);
                // The slowest axis needs the whole time.
                let rate = ways.iter().map(|(way, rapid)| rapid * (longest / way)).fold(f64::INFINITY, f64::min);
                (true, rate)
            }
        };
        self.turns_free(&moving, after, together)?;
        let (datum, signs) = (self.world.system.angle_datum(), self.world.system.mirror().1);
        let turned = |axis: &RotaryAxis| Turned {
            axis: *axis,
            from: axis.of((before - datum) * signs),
            to: axis.of((after - datum) * signs),
            machine: axis.of(after),
        };
        let axes = moving.iter().map(turned).collect();
        let told = self.world.system.told();
        self.world.turn(after);
        self.tell(EventKind::Turn { axes, feed, rapid, together });
        self.transformed(told);
        Ok(())
    }

    /// A probe that touches something while an axis turns is an error.
    fn turns_free(&self, moving: &[RotaryAxis], after: DVec3, together: bool) -> Done {
        if !self.probing && !self.world.holds_probe() {
            return Ok(());
        }
        let Ok(probe) = self.world.probe() else { return Ok(()) };
        if self.world.scene.body.nearest(DVec3::ZERO)?.is_none() {
            return Ok(());
        }
        let [axis] = moving else { return Err(Fault::unsupported("unsupported-simultaneous").into()) };
        if together {
            return Err(Fault::unsupported("unsupported-simultaneous").into());
        }
        let axis = self.rotary_axis(*axis)?;
        let turning = self.world.scene.machine.turning(axis, self.world.angles);
        let way = axis.axis.of(after - self.world.angles);
        let from = self.world.ball_centre(self.world.machine, &probe);
        let (centre, sweep) = match axis.carries {
            // The parts turn one way, so to them the ball turns the other way.
            Carried::Workpiece => (turning.centre, -way),
            Carried::Tool => (self.world.pivot(self.world.machine), way),
        };
        let around = |from: DVec3| {
            let centre = centre + turning.direction * (from - centre).dot(turning.direction);
            if (from - centre).length() < ON_AXIS {
                return BallPath::line(from, from);
            }
            BallPath::Arc { centre, axis: turning.direction, from, sweep, rise: 0.0 }
        };
        let path = around(from);
        if path.length() > 0.0 {
            self.touches_on(probe.ball_radius, &path)?;
        }
        let Some(shaft) = probe.shaft else { return Ok(()) };
        let axis = self.world.shaft_axis(shaft);
        let way = |share: f64| self.world.path_at_parts(&around(from + axis * share));
        self.shaft_touches_on(shaft.radius, axis.length(), &way)
    }
}
