//! Motion blocks: lines, circles, polar forms, helices. What they do beside a contour is in `contour`.
//!
//! Invariant: a position is known both in program and machine coordinates after every move; a motion that
//! cannot be executed exactly is a fault.
use glam::{DVec2, DVec3};

use crate::base::expr::{atan2d, cosd, sind};
use crate::engine::contour::element::tangential;
use crate::engine::geometry::{Axis as LinearAxis, RotaryAxis, WorkingPlane};
use crate::engine::motion::axis::linear;
use crate::engine::motion::axis::rotary;
use crate::engine::motion::probe::Pressed;
use crate::engine::report::event::MoveKind;
use crate::engine::report::fault::{Class, Fault};
use crate::engine::run::{Done, Pole, Run, Touching};
use crate::engine::solid::Path as BallPath;
use crate::engine::world::stylus::ProbeData;
use crate::program::syntax::{Approach, Axis, Coord, Feed, FeedKind, Motion, Path};

/// How far the end of a circle may lie off it, mm: what the controls' input step of 0.0001 mm can cause, with room.
const OFF_CIRCLE: f64 = 0.001;
/// What calculation may put between two positions that are the same, mm.
pub(in crate::engine) const SAME: f64 = 1e-10;
/// From this feed on a move is one at rapid traverse: the value that the word FMAX has as a parameter.
pub(in crate::engine) const RAPID_FEED: f64 = 99_999.999;

/// A probe that presses against a face must move away from it by so much of its way to come free.
const LEAST_BACK: f64 = 1e-3;
/// What a probe that has just come free is away from what it touched, mm.
const FREE: f64 = 1e-9;

/// The speed of a move.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::engine) enum Speed {
    /// Rapid traverse.
    Rapid,
    /// mm/min along the path.
    Feed(f64),
}

/// How a circular movement turns.
#[derive(Clone, Copy, Debug)]
struct Turn {
    /// The plane of the circle.
    plane: WorkingPlane,
    /// Its centre, program coordinates.
    centre: DVec3,
    /// 1 counter-clockwise, -1 clockwise.
    direction: f64,
    /// The signed angle where it is programmed, degrees.
    sweep: Option<f64>,
}

impl Speed {
    /// A feed as a cycle has it: that of FMAX and more is rapid traverse.
    pub(in crate::engine) fn of_feed(feed: f64) -> Result<Self, Fault> {
        if feed >= RAPID_FEED {
            return Ok(Self::Rapid);
        }
        if feed > 0.0 { Ok(Self::Feed(feed)) } else { Err(Fault::program("feed-missing").arg("feed", feed)) }
    }
}

impl Run<'_, '_> {
    /// Executes a motion block. Whether it positions the tool.
    pub(in crate::engine) fn motion(&mut self, motion: &Motion, in_machine: bool) -> Done<bool> {
        match motion.path {
            Path::Cc => {
                self.set_pole(motion)?;
                return Ok(false);
            }
            Path::Rnd | Path::Chf => {
                self.rounding(motion, motion.path == Path::Chf)?;
                return Ok(false);
            }
            _ => {}
        }
        let before = self.modal.rapid;
        let feed_before = self.modal.feed;
        let speed = self.speed(motion.feed.as_ref());
        self.modal.rapid = speed == Ok(Speed::Rapid);
        let unsupported = |word: &'static str| Err(Fault::unsupported("unsupported-path").arg("word", word).into());
        match motion.path {
            Path::L => self.line(motion, in_machine, speed)?,
            Path::Axis => self.along_axis(motion, in_machine, speed)?,
            _ if in_machine => return unsupported("M91"),
            Path::Lp => {
                let to = self.polar_target(motion)?;
                self.straight_block(motion, to, speed)?;
            }
            Path::C => {
                let to = self.target(&motion.coords, self.programmed())?;
                self.circle_block(motion, to, speed)?;
            }
            Path::Cp => self.polar_circle(motion, speed)?,
            Path::Cr => self.radius_circle(motion, speed)?,
            Path::Ct => {
                let to = self.target(&motion.coords, self.programmed())?;
                self.tangential_circle(motion, to, speed)?;
            }
            Path::Ctp => {
                let to = self.polar_target(motion)?;
                self.tangential_circle(motion, to, speed)?;
            }
            Path::Cc | Path::Rnd | Path::Chf => {}
            Path::Appr(form) => {
                let to = self.point_of_approach(motion, form)?;
                let before = if before { Ok(Speed::Rapid) } else { Speed::of_feed(feed_before.unwrap_or_default()) };
                self.approach_contour(motion, form, to, before, speed)?;
            }
            Path::Dep(form) => {
                let to = self.point_of_approach(motion, form)?;
                self.leave_by(motion, form, to, speed)?;
            }
            Path::Ln => return unsupported("LN"),
            Path::Fl => return unsupported("FL"),
            Path::Flt => return unsupported("FLT"),
            Path::Fc => return unsupported("FC"),
            Path::Fct => return unsupported("FCT"),
            Path::Fpol => return unsupported("FPOL"),
            Path::Spl => return unsupported("SPL"),
        }
        Ok(true)
    }

    /// The point that an approach or a departure names.
    fn point_of_approach(&self, motion: &Motion, form: Approach) -> Result<DVec3, Fault> {
        let is_polar = motion.coords.iter().any(|coord| matches!(coord.axis, Axis::Pr | Axis::Pa));
        match form {
            Approach::Plt | Approach::Pln | Approach::Pct | Approach::Plct if is_polar => self.polar_target(motion),
            _ => self.target(&motion.coords, self.programmed()),
        }
    }

    /// A straight block: at once, or as an element of a contour.
    fn straight_block(&mut self, motion: &Motion, to: DVec3, speed: Result<Speed, Fault>) -> Done {
        if self.is_in_contour(motion) {
            return self.contour_line(motion, to, speed);
        }
        let plane = self.world.system.plane;
        let from = self.programmed();
        self.contour.passed(plane.flat(from), plane.flat(to));
        self.straight_to(to, None, speed)
    }

    /// A circular block: at once, or as an element of a contour.
    fn arc_block(&mut self, motion: &Motion, turn: Turn, to: DVec3, speed: Result<Speed, Fault>) -> Done {
        let (plane, from) = (turn.plane, self.programmed());
        let sweep = self.sweep(from, to, &turn)?;
        let beside = self.is_in_contour(motion);
        if plane != self.world.system.plane {
            if beside {
                return Err(Fault::unsupported("unsupported-compensation").arg("word", "CC").into());
            }
            // In the working plane it has no direction.
            self.contour.last = None;
            return self.arc_by(Turn { sweep: Some(sweep), ..turn }, to, speed);
        }
        if beside {
            return self.contour_arc(turn.centre, to, sweep, motion, speed);
        }
        self.passed_arc(plane.flat(from), plane.flat(to), plane.flat(turn.centre), sweep);
        self.arc_by(Turn { sweep: Some(sweep), ..turn }, to, speed)
    }

    /// An arc that goes on in the direction of the element before it.
    fn tangential_circle(&mut self, motion: &Motion, to: DVec3, speed: Result<Speed, Fault>) -> Done {
        let plane = self.world.system.plane;
        let (from, heading) = (self.programmed(), self.heading()?);
        let found = tangential(plane.flat(from), heading, plane.flat(to));
        let Some((centre, sweep)) = found else { return Err(Fault::program("tangent-missing").into()) };
        let centre = plane.lift(centre, plane.tool.of(from));
        self.arc_block(motion, Turn { plane, centre, direction: sweep.signum(), sweep: Some(sweep) }, to, speed)
    }

    /// The speed of a block; a feed word stays in force. What is missing shows only if the tool moves.
    pub(in crate::engine) fn speed(&mut self, feed: Option<&Feed>) -> Result<Speed, Fault> {
        match feed.map(|feed| feed.kind) {
            Some(FeedKind::Max) => return Ok(Speed::Rapid),
            Some(FeedKind::Value(value)) => self.modal.feed = Some(self.operand(&value)? * self.unit()),
            Some(FeedKind::Auto) => self.modal.feed = self.modal.tool_feed,
            Some(FeedKind::PerRevolution(value)) => {
                self.modal.feed = Some(self.operand(&value)? * self.unit() * self.modal.spindle.speed);
            }
            Some(FeedKind::PerTooth(value)) => {
                let teeth = self.world.tool().map_or(0.0, |tool| tool.teeth);
                self.modal.feed = Some(self.operand(&value)? * self.unit() * self.modal.spindle.speed * teeth);
            }
            None => {}
        }
        Speed::of_feed(self.modal.feed.unwrap_or(0.0))
    }

    pub(in crate::engine) fn coordinate(&self, coord: &Coord, now: f64) -> Result<f64, Fault> {
        let linear = coord.axis == Axis::Pr || linear(coord.axis).is_ok();
        let value = self.operand(&coord.value)? * if linear { self.unit() } else { 1.0 };
        Ok(if coord.incremental { now + value } else { value })
    }

    /// The position with the coordinates of the block, others as they are.
    pub(in crate::engine) fn target(&self, coords: &[Coord], from: DVec3) -> Result<DVec3, Fault> {
        let mut to = from;
        for coord in coords {
            if matches!(coord.axis, Axis::Pr | Axis::Pa) {
                continue;
            }
            let axis = linear(coord.axis)?;
            to = axis.with(to, self.coordinate(coord, axis.of(from))?);
        }
        Ok(to)
    }

    /// A straight line, with rotary axes that turn at the same time.
    pub(in crate::engine) fn line(&mut self, motion: &Motion, in_machine: bool, speed: Result<Speed, Fault>) -> Done {
        if !in_machine && motion.coords.iter().all(|coord| rotary(coord.axis).is_none()) {
            let to = self.target(&motion.coords, self.programmed())?;
            return self.straight_block(motion, to, speed);
        }
        if self.is_in_contour(motion) {
            let word = motion.coords.iter().find(|coord| rotary(coord.axis).is_some());
            let word = word.filter(|_| !in_machine).map_or("M91", |coord| coord.axis.name());
            return Err(Fault::unsupported("unsupported-compensation").arg("word", word).into());
        }
        let (turning, coords): (Vec<Coord>, Vec<Coord>) =
            motion.coords.iter().copied().partition(|coord| rotary(coord.axis).is_some());
        let turns = self.turn_target(&turning, in_machine)?;
        if in_machine {
            let to = self.target(&coords, self.world.machine)?;
            return self.turn_and_go(&turns, self.world.to_program(to), Some(to), speed);
        }
        let to = self.target(&coords, self.world.here)?;
        self.turn_and_go(&turns, to, None, speed)
    }

    /// Where the rotary axes of a block go, in machine coordinates.
    fn turn_target(&self, coords: &[Coord], in_machine: bool) -> Result<Vec<(RotaryAxis, f64)>, Fault> {
        let system = &self.world.system;
        let (datum, signs) =
            if in_machine { (DVec3::ZERO, DVec3::ONE) } else { (system.angle_datum(), system.mirror().1) };
        let mut turns = Vec::with_capacity(coords.len());
        for coord in coords {
            let Some(axis) = rotary(coord.axis) else { continue };
            let now = axis.of((self.world.angles - datum) * signs);
            turns.push((axis, self.coordinate(coord, now)? * axis.of(signs) + axis.of(datum)));
        }
        self.can_turn(&turns)?;
        Ok(turns)
    }

    fn set_pole(&mut self, motion: &Motion) -> Done {
        let here = self.programmed();
        if motion.coords.is_empty() {
            self.modal.pole = Some(Pole { at: here, plane: None });
            return Ok(());
        }
        let mut at = self.modal.pole.map_or(here, |pole| pole.at);
        let mut axes = Vec::with_capacity(2);
        for coord in &motion.coords {
            let axis = linear(coord.axis)?;
            at = axis.with(at, self.coordinate(coord, axis.of(here))?);
            axes.push(axis);
        }
        // Two axes, one of them that of the tool, are a plane of their own.
        let tool = self.world.system.plane.tool;
        let upright = axes.len() == 2 && axes.contains(&tool);
        let across = LinearAxis::ALL.into_iter().find(|axis| upright && !axes.contains(axis));
        self.modal.pole = Some(Pole { at, plane: across.map(WorkingPlane::of_tool_axis) });
        Ok(())
    }

    /// The plane of circles about the pole, and the pole at the tool's height above that plane.
    fn pole(&self) -> Result<(WorkingPlane, DVec3), Fault> {
        let pole = self.modal.pole.ok_or_else(|| Fault::program("pole-missing"))?;
        let plane = pole.plane.unwrap_or(self.world.system.plane);
        Ok((plane, plane.tool.with(pole.at, plane.tool.of(self.programmed()))))
    }

    /// Angle and radius of the present position about the pole.
    fn polar_now(&self, (plane, pole): (WorkingPlane, DVec3)) -> (f64, f64) {
        let arm = plane.flat(self.programmed() - pole);
        (libm::hypot(arm.x, arm.y), atan2d(arm.y, arm.x))
    }

    fn polar_target(&self, motion: &Motion) -> Result<DVec3, Fault> {
        let (plane, pole) = self.pole()?;
        let (radius, angle) = self.polar_now((plane, pole));
        let radius = motion.coord(Axis::Pr).map_or(Ok(radius), |coord| self.coordinate(coord, radius))?;
        let angle = motion.coord(Axis::Pa).map_or(Ok(angle), |coord| self.coordinate(coord, angle))?;
        let flat = plane.flat(pole) + DVec2::new(radius * cosd(angle), radius * sind(angle));
        let height = plane.tool.of(self.programmed());
        self.target(&motion.coords, plane.lift(flat, height))
    }

    fn direction(motion: &Motion) -> Result<f64, Fault> {
        match motion.counter_clockwise {
            Some(true) => Ok(1.0),
            Some(false) => Ok(-1.0),
            None => Err(Fault::program("direction-missing")),
        }
    }

    fn circle_block(&mut self, motion: &Motion, to: DVec3, speed: Result<Speed, Fault>) -> Done {
        let direction = Self::direction(motion)?;
        let (plane, centre) = self.pole()?;
        self.arc_block(motion, Turn { plane, centre, direction, sweep: None }, to, speed)
    }

    fn polar_circle(&mut self, motion: &Motion, speed: Result<Speed, Fault>) -> Done {
        let direction = Self::direction(motion)?;
        let (plane, pole) = self.pole()?;
        let (radius, now) = self.polar_now((plane, pole));
        let Some(angle) = motion.coord(Axis::Pa) else { return Err(Fault::program("angle-missing").into()) };
        let sweep = if angle.incremental { Some(self.operand(&angle.value)?) } else { None };
        let end = self.coordinate(angle, now)?;
        let flat = plane.flat(pole) + DVec2::new(radius * cosd(end), radius * sind(end));
        let to = self.target(&motion.coords, plane.lift(flat, plane.tool.of(self.programmed())))?;
        if sweep.is_some_and(|sweep| sweep * direction < 0.0) {
            return Err(Fault::program("direction-contradicts").into());
        }
        self.arc_block(motion, Turn { plane, centre: pole, direction, sweep }, to, speed)
    }

    fn radius_circle(&mut self, motion: &Motion, speed: Result<Speed, Fault>) -> Done {
        let direction = Self::direction(motion)?;
        let Some(radius) = &motion.radius else { return Err(Fault::program("radius-missing").into()) };
        let radius = self.operand(radius)? * self.unit();
        let here = self.programmed();
        let to = self.target(&motion.coords, here)?;
        let plane = self.world.system.plane;
        let chord = plane.flat(to - here);
        let half = libm::hypot(chord.x, chord.y) / 2.0;
        if half == 0.0 || half > radius.abs() + OFF_CIRCLE {
            let fault = Fault::program("radius-too-small").arg("radius", radius.abs());
            return Err(fault.arg("chord", 2.0 * half).into());
        }
        // A positive radius takes the arc below 180 degrees: its centre lies to the left of a counter-clockwise chord.
        let height = libm::sqrt((radius * radius - half * half).max(0.0));
        let side = direction * if radius > 0.0 { 1.0 } else { -1.0 };
        let left = DVec2::new(-chord.y, chord.x) / (2.0 * half);
        let centre = plane.lift(plane.flat(here) + chord / 2.0 + left * (height * side), plane.tool.of(here));
        self.arc_block(motion, Turn { plane, centre, direction, sweep: None }, to, speed)
    }

    /// Moves straight; `machine` gives the target in machine coordinates where that is what is programmed.
    pub(in crate::engine) fn straight_to(
        &mut self,
        to: DVec3,
        machine: Option<DVec3>,
        speed: Result<Speed, Fault>,
    ) -> Done {
        let to = if machine.is_none() && self.unit() != 1.0 { self.unless_moved(to) } else { to };
        let machine = machine.unwrap_or_else(|| self.world.to_machine(to));
        let from = self.world.here;
        if (to - from).abs().max_element() < SAME {
            return Ok(());
        }
        let path = BallPath::line(self.world.machine, machine);
        let (kind, feed) = match speed? {
            Speed::Rapid => (MoveKind::Rapid, self.world.scene.machine.rapid_feed(machine - self.world.machine)),
            Speed::Feed(feed) => (MoveKind::Feed, feed),
        };
        self.go(kind, feed, to, machine, &path)
    }

    /// Moves on an arc in the working plane about the centre; `sweep` is the signed angle where it is programmed, else
    /// it follows from the end (a whole circle if that is where the tool stands). Heights may differ: a helix.
    pub(in crate::engine) fn arc_to(
        &mut self,
        centre: DVec3,
        to: DVec3,
        direction: f64,
        sweep: Option<f64>,
        speed: Result<Speed, Fault>,
    ) -> Done {
        self.arc_by(Turn { plane: self.world.system.plane, centre, direction, sweep }, to, speed)
    }

    fn arc_by(&mut self, turn: Turn, to: DVec3, speed: Result<Speed, Fault>) -> Done {
        let (plane, from) = (turn.plane, self.world.here);
        let angle = self.sweep(from, to, &turn)?;
        let rise = plane.tool.of(to) - plane.tool.of(from);
        let frame = *self.world.system.frame();
        let centre = plane.lift(plane.flat(turn.centre), plane.tool.of(from));
        let machine = self.world.to_machine(to);
        let across = plane != self.world.system.plane;
        let stretched = |axis: LinearAxis| frame.vector(axis.unit()).length();
        if self.world.system.plane_scale().is_none()
            || across && (stretched(plane.main) - stretched(plane.secondary)).abs() > SAME
        {
            return Err(Fault::program("arc-scaled-unequally").into());
        }
        // Seen along the tool axis of a mirrored system a circle goes round the other way.
        let up = frame.vector(plane.tool.unit());
        let path = BallPath::Arc {
            centre: self.world.to_machine(centre),
            axis: up / up.length(),
            from: self.world.machine,
            sweep: if frame.mirrors() { -angle } else { angle },
            rise: rise * up.length(),
        };
        let speed = speed?;
        let feed = match speed {
            Speed::Rapid => self.slowest_rapid(),
            Speed::Feed(feed) => feed,
        };
        let kind = MoveKind::Arc { centre, plane, angle, rise, rapid: speed == Speed::Rapid };
        self.go(kind, feed, to, machine, &path)
    }

    /// The signed angle of an arc: that which is programmed, else what follows from its end.
    fn sweep(&self, from: DVec3, to: DVec3, turn: &Turn) -> Result<f64, Fault> {
        let (plane, centre, direction) = (turn.plane, turn.centre, turn.direction);
        let (a, b) = (plane.flat(from - centre), plane.flat(to - centre));
        let (start, end) = (libm::hypot(a.x, a.y), libm::hypot(b.x, b.y));
        if (start - end).abs() > OFF_CIRCLE || start == 0.0 {
            return Err(Fault::program("end-off-circle").arg("start_radius", start).arg("end_radius", end));
        }
        Ok(turn.sweep.unwrap_or_else(|| {
            let turn = (atan2d(b.y, b.x) - atan2d(a.y, a.x)) * direction;
            let turn = turn.rem_euclid(360.0);
            direction * if a == b || turn == 0.0 { 360.0 } else { turn }
        }))
    }

    /// The rapid rate that every axis can keep.
    fn slowest_rapid(&self) -> f64 {
        self.world.scene.machine.axes.iter().map(|axis| axis.rapid).fold(f64::INFINITY, f64::min)
    }

    fn go(&mut self, kind: MoveKind, feed: f64, to: DVec3, machine: DVec3, path: &BallPath) -> Done {
        let from = self.world.here;
        self.count_move()?;
        if self.contour.is_disturbed() {
            let word = self.event.at.cycle.as_ref().map_or_else(String::new, |(key, _)| key.to_string());
            self.not_beside_contour(word)?;
        }
        self.no_unexecuted()?;
        self.has_axes_to(machine)?;
        if matches!(path, BallPath::Arc { .. }) {
            for point in path.extremes() {
                self.world.within_limits(point)?;
            }
        }
        self.world.within_limits(machine)?;
        self.note_way(path, false);
        self.collide(path)?;
        self.release(path);
        self.world.here = to;
        self.world.machine = machine;
        let path = self.world.path_of_tip(path);
        self.tell_move(kind, from, to, machine, feed, path);
        Ok(())
    }

    /// An axis that would have to move must be there.
    pub(in crate::engine) fn has_axes_to(&self, machine: DVec3) -> Result<(), Fault> {
        if self.world.has_all_axes() {
            return Ok(());
        }
        let moves = |axis: &LinearAxis| axis.of(machine) != axis.of(self.world.machine);
        match LinearAxis::ALL.into_iter().find(|axis| moves(axis) && !self.world.has_axis(*axis)) {
            Some(axis) => Err(Fault::unsupported("unsupported-axis").arg("axis", axis.letter().to_string())),
            None => Ok(()),
        }
    }

    /// Nothing moves while a transformation is in effect that the engine cannot execute.
    pub(in crate::engine) fn no_unexecuted(&self) -> Result<(), Fault> {
        match self.world.system.unexecuted.first() {
            Some(active) => Err(Fault::unsupported("unsupported-transformation").arg("name", active.as_str())),
            None => Ok(()),
        }
    }

    /// Few blocks can move the tool without end: a pattern of many points with a cycle of many infeeds.
    pub(in crate::engine) fn count_move(&mut self) -> Done {
        self.moves += 1;
        let limit = self.engine.limits.moves;
        if self.moves > limit {
            return Err(Fault::new(Class::Limit, "move-limit").arg("limit", limit as f64).into());
        }
        Ok(())
    }

    /// A probe that touches something while it is not probing is an error.
    fn collide(&self, path: &BallPath) -> Done {
        if self.touching != Touching::AsScene || (!self.probing && !self.world.holds_probe()) {
            return Ok(());
        }
        let Some(probe) = self.world.probe_if_any() else { return Ok(()) };
        let lift = self.world.ball_centre(DVec3::ZERO, &probe);
        let path = match *path {
            BallPath::Line { from, to } => {
                let skipped = self.way_to_freedom(to - from);
                if skipped > (to - from).length() {
                    return Ok(());
                }
                BallPath::line(from + (to - from).normalize_or_zero() * skipped, to)
            }
            arc @ BallPath::Arc { .. } => arc,
        };
        self.touches_on(probe.ball_radius, &path.moved(lift))?;
        self.shaft_touches(&probe, &path.moved(lift))
    }

    /// An error if the shaft of the stylus touches the parts on a path of the ball centre.
    pub(in crate::engine) fn shaft_touches(&self, probe: &ProbeData, path: &BallPath) -> Done {
        let Some(shaft) = probe.shaft else { return Ok(()) };
        let (path, axis) = (self.world.path_at_parts(path), self.world.along_parts(self.world.shaft_axis(shaft)));
        self.shaft_touches_on(shaft.radius, axis.length(), &|share| path.moved(axis * share))
    }

    /// The same for any movement; `way` tells how a point of the axis moves, as the parts see it.
    pub(in crate::engine) fn shaft_touches_on(&self, radius: f64, length: f64, way: &dyn Fn(f64) -> BallPath) -> Done {
        match self.world.scene.body.shaft_contact(radius, length, way)? {
            None => Ok(()),
            Some(contact) => Err(self.at_point(Fault::control("shaft-collision"), contact.point).into()),
        }
    }

    /// A fault at a point of the parts.
    pub(in crate::engine) fn at_point(&self, fault: Fault, at_parts: DVec3) -> Fault {
        let point = self.world.system.back().point(self.world.off_parts(at_parts));
        fault.arg("x", point.x).arg("y", point.y).arg("z", point.z)
    }

    /// How far a probe that still presses against what it touched must go on a line to come free; 0 if it is free, or
    /// if the line does not lead away.
    fn way_to_freedom(&self, way: DVec3) -> f64 {
        let Some(pressed) = self.world.pressed else { return 0.0 };
        let back = -way.normalize_or_zero().dot(pressed.direction);
        if back < LEAST_BACK { 0.0 } else { pressed.depth.max(0.0) / back + FREE }
    }

    /// After a move: the probe is free, unless it went back too little.
    fn release(&mut self, path: &BallPath) {
        if self.world.pressed.is_none() {
            return;
        }
        let BallPath::Line { from, to } = *path else {
            self.world.pressed = None;
            return;
        };
        let still = self.way_to_freedom(to - from) > (to - from).length();
        let back =
            |pressed: &Pressed| Pressed { depth: pressed.depth + (to - from).dot(pressed.direction), ..*pressed };
        self.world.pressed = self.world.pressed.as_ref().filter(|_| still).map(back);
    }

    /// An error if the ball touches the parts on a path of its centre.
    pub(in crate::engine) fn touches_on(&self, ball_radius: f64, path: &BallPath) -> Done {
        let path = self.world.path_at_parts(path);
        match self.world.scene.body.first_contact_on(ball_radius, &path)? {
            None => Ok(()),
            Some(contact) => Err(self.at_point(Fault::control("collision"), contact.point).into()),
        }
    }
}
