//! Rotary axes turn: the table with the parts on it, the head with the tool; alone, together, and while the tool moves.
//!
//! Invariant: relative to the parts, the ball of a probe runs on an arc while one axis turns; while several axes move,
//! each stretch of its way is proven free by how far it can go at most. What cannot be proven is a fault.
use glam::DVec3;

use crate::engine::geometry::RotaryAxis;
use crate::engine::machine::{Carried, Course, RotaryMachineAxis, Straight};
use crate::engine::motion::drives::Drives;
use crate::engine::motion::moves::{SAME, Speed};
use crate::engine::report::ending::Done;
use crate::engine::report::event::EventKind;
use crate::engine::report::event::{MoveKind, Turned};
use crate::engine::report::fault::Fault;
use crate::engine::solid::{Contact, Path as BallPath, SolidError};

/// A ball centre nearer to the axis, in mm, does not move when it turns.
const ON_AXIS: f64 = 1e-9;
/// While the tool tip is held, the linear axes may leave their range by less than this, in mm, between its ends.
const AT_LIMIT: f64 = 1e-3;

impl Drives<'_, '_> {
    /// A rotary axis of the machine.
    pub(crate) fn rotary_axis(&self, axis: RotaryAxis) -> Result<&RotaryMachineAxis, Fault> {
        let missing = || Fault::control("rotary-axis-missing").arg("axis", axis.letter().to_string());
        self.world.scene.machine.rotary(axis).ok_or_else(missing)
    }

    /// Whether axes can turn to these machine coordinates.
    pub(crate) fn can_turn(&self, to: &[(RotaryAxis, f64)]) -> Result<(), Fault> {
        for (axis, _) in to {
            self.rotary_axis(*axis)?;
        }
        let angles = to.iter().fold(self.world.angles, |angles, (axis, angle)| axis.with(angles, *angle));
        self.world.turned_too_far(angles).map_or(Ok(()), Err)
    }

    /// Turns axes to machine coordinates.
    pub(crate) fn turn_to(&mut self, to: &[(RotaryAxis, f64)], speed: Result<Speed, Fault>) -> Done {
        self.turn_and_go(to, self.world.here, None, speed, None)
    }

    /// Turns axes to machine coordinates while the tool goes to a point of the program, as it is before they turn;
    /// `machine` gives it in machine coordinates where that is what is programmed.
    /// A tip that is held goes straight on the workpiece. `rates` are those of the linear axes together, mm/min, and of
    /// the rotary axis that goes farthest, degrees/min, where a feed is neither of them.
    pub(crate) fn turn_and_go(
        &mut self,
        turns: &[(RotaryAxis, f64)],
        to: DVec3,
        machine: Option<DVec3>,
        speed: Result<Speed, Fault>,
        rates: Option<(f64, f64)>,
    ) -> Done {
        self.can_turn(turns)?;
        let before = self.world.angles;
        let after = turns.iter().fold(before, |angles, (axis, angle)| axis.with(angles, *angle));
        let moving: Vec<RotaryAxis> =
            RotaryAxis::ALL.into_iter().filter(|axis| axis.of(after) != axis.of(before)).collect();
        if moving.is_empty() {
            return self.straight_to(to, machine, speed);
        }
        if self.world.parallels.drive() {
            // Which of them the table or the head would carry, nothing says.
            return Err(Fault::unsupported("unsupported-block").arg("word", "FUNCTION PARAXMODE").into());
        }
        self.count_move()?;
        self.not_beside_contour(moving.iter().map(|axis| axis.letter()).collect::<String>())?;
        self.no_unexecuted()?;
        let speed = speed?;
        let to = if machine.is_none() && self.unit() != 1.0 { self.unless_moved(to) } else { to };
        let goes = (to - self.world.here).abs().max_element() >= SAME;
        let (course, end) = self.course(after, goes.then_some(to), machine);
        let (moves, held) = (goes || end != self.world.machine, self.world.system.tip_held);
        self.has_axes_to(end)?;
        self.within_limits(&course, end)?;
        if moves || held || moving.len() > 1 {
            self.course_is_free(&course)?;
        } else if let [axis] = *moving {
            self.turn_is_free(axis, after)?;
        }
        if moves {
            let (from, swung) = (self.world.machine + self.world.swung(), self.swung_after(after));
            let path = BallPath::line(from, end + swung);
            let (kind, feed) = match speed {
                Speed::Rapid => (MoveKind::Rapid, self.world.rapid_feed(end - self.world.machine)),
                Speed::Feed(feed) => (MoveKind::Feed, rates.map_or(feed, |(linear, _)| linear)),
            };
            self.world.pressed = None;
            self.report.report(EventKind::Move {
                kind,
                from: self.world.here,
                to,
                machine: end,
                feed,
                path,
                turned: None,
            });
            (self.world.here, self.world.machine) = (to, end);
        }
        let turning = match (speed, rates) {
            (Speed::Feed(_), Some((_, rotary))) => Speed::Feed(rotary),
            _ => speed,
        };
        let turned = self.turned(&moving, after, turning, moves || held);
        let transform = self.world.system.reported();
        self.world.turn(after);
        self.report.report(turned);
        self.transformed(transform);
        if held && machine.is_none() {
            // Whatever turns, that is where it stays.
            self.world.here = to;
        }
        Ok(())
    }

    /// The event of turning.
    fn turned(&self, moving: &[RotaryAxis], after: DVec3, speed: Speed, together: bool) -> EventKind {
        let before = self.world.angles;
        let ways: Vec<(f64, f64)> = moving
            .iter()
            .filter_map(|axis| self.world.scene.machine.rotary(*axis))
            .map(|axis| ((axis.axis.of(after) - axis.axis.of(before)).abs(), axis.rapid))
            .collect();
        let (rapid, feed) = match speed {
            Speed::Feed(feed) => (false, feed),
            Speed::Rapid => {
                let longest = ways.iter().map(|(way, _)| *way).fold(0.0, f64::max);
                // The slowest axis needs the whole time.
                let rate = ways.iter().map(|(way, rapid)| rapid * (longest / way)).fold(f64::INFINITY, f64::min);
                (true, rate)
            }
        };
        let (datum, signs) = (self.world.system.angle_datum(), self.world.system.mirror().1);
        let turned = |axis: &RotaryAxis| Turned {
            axis: *axis,
            from: axis.of((before - datum) * signs),
            to: axis.of((after - datum) * signs),
            machine: axis.of(after),
        };
        EventKind::Turn { axes: moving.iter().map(turned).collect(), feed, rapid, together }
    }

    /// By how much the head will have moved the tool tip when the axes are there, if the control reckons with it.
    fn swung_after(&self, angles: DVec3) -> DVec3 {
        if self.world.system.is_on_workpiece() {
            self.world.swing(&self.world.kinematics().head(angles))
        } else {
            DVec3::ZERO
        }
    }

    /// The movement to where the axes shall be, and where the linear ones are then.
    fn course(&self, after: DVec3, to: Option<DVec3>, machine: Option<DVec3>) -> (Course<'_>, DVec3) {
        let world = &self.world;
        let (kinematics, before) = (world.kinematics(), world.angles);
        let made = |straight| Course::new(kinematics, [before, after], straight, world.to_pivot());
        if let Some(end) = machine.filter(|_| to.is_some() || world.system.tip_held) {
            return (made(Straight::Axes(world.machine, end)), end);
        }
        if !world.system.tip_held {
            let end = to.map_or(world.machine, |to| world.to_machine(to));
            return (made(Straight::Axes(world.machine, end)), end);
        }
        let frame = world.carried(after).of(world.system.table.inverse()).of(*world.system.frame());
        let tip = frame.point(to.unwrap_or(world.here));
        let from = kinematics.table(before).inverse().point(world.machine + world.swung());
        let end = tip - self.swung_after(after);
        (made(Straight::Tip(from, kinematics.table(after).inverse().point(tip))), end)
    }

    /// No linear axis leaves its range on the way.
    fn within_limits(&self, course: &Course<'_>, end: DVec3) -> Result<(), Fault> {
        if end != self.world.machine
            && let Some(fault) = self.world.beyond_limits(end)
        {
            return Err(fault);
        }
        if !self.world.system.tip_held {
            return Ok(());
        }
        let mut open = vec![(0.5, 0.5)];
        while let Some((middle, half)) = open.pop() {
            let at = course.axes(middle);
            if let Some(fault) = self.world.beyond_limits(at) {
                return Err(fault);
            }
            let reach = course.axes_reach(middle, half);
            if reach >= AT_LIMIT && self.world.scene.machine.room(self.world.parallels.linear(at)) < reach {
                open.extend([(middle + half / 2.0, half / 2.0), (middle - half / 2.0, half / 2.0)]);
            }
        }
        Ok(())
    }

    /// Whether contact matters: a probe is in the spindle, and there are parts.
    fn can_collide(&self) -> Done<bool> {
        if !self.probing && !self.world.holds_probe() {
            return Ok(false);
        }
        Ok(self.world.probe().is_ok() && self.world.scene.body.nearest(DVec3::ZERO)?.is_some())
    }

    /// A probe that touches something while several axes move is an error.
    fn course_is_free(&self, course: &Course<'_>) -> Done {
        if !self.can_collide()? {
            return Ok(());
        }
        let (world, probe) = (&self.world, self.world.probe()?);
        let (machine, course) = (world.true_machine(), course.on(world.true_machine()));
        let parts = machine.table(world.scene.start_angles);
        let ball = world.arm(&probe);
        let touches = |radius: f64, arm: DVec3| -> Result<Option<Contact>, SolidError> {
            let at = |share| parts.point(course.at(arm, share));
            world.scene.body.contact_on_course(radius, &at, &|middle, half| course.reach(arm, middle, half))
        };
        if let Some(contact) = touches(probe.ball_radius, ball)? {
            return Err(self.at_point(Fault::control("collision"), contact.point).into());
        }
        let Some(shaft) = probe.shaft else { return Ok(()) };
        let up = world.shaft_of_straight_head(shaft);
        let on_shaft = |radius: f64, share: f64| touches(radius, ball + up * share);
        match world.scene.body.shaft_contact_by(shaft.radius, up.length(), &on_shaft)? {
            None => Ok(()),
            Some(contact) => Err(self.at_point(Fault::control("shaft-collision"), contact.point).into()),
        }
    }

    /// A probe that touches something while one axis turns is an error.
    fn turn_is_free(&self, axis: RotaryAxis, after: DVec3) -> Done {
        if !self.can_collide()? {
            return Ok(());
        }
        let probe = self.world.probe()?;
        let axis = self.rotary_axis(axis)?;
        let machine = self.world.true_machine();
        let axis = machine.rotary(axis.axis).unwrap_or(axis);
        let turning = machine.turning(axis, self.world.angles);
        let way = axis.axis.of(after - self.world.angles);
        let from = self.world.ball_centre(self.world.machine, &probe);
        let (centre, sweep) = match axis.carries {
            // The parts turn one way, so to them the ball turns the other way.
            Carried::Workpiece => (turning.centre, -way),
            Carried::Tool => (self.world.pivot(self.world.machine) + turning.centre, way),
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
