//! Motion blocks: lines, circles, polar forms, helices. What they do next to a contour is in `engine::contour`.
//!
//! Invariant: a block that cannot be executed exactly is a fault.
use glam::{DVec2, DVec3};

use crate::base::expr::{atan2d, cosd, sind};
use crate::engine::contour::element::tangential;
use crate::engine::contour::path::BlockPlace;
use crate::engine::flow::state::{Pole, Run};
use crate::engine::geometry::{Axis as LinearAxis, RotaryAxis, WorkingPlane};
use crate::engine::machine::Carried;
use crate::engine::motion::axis::{linear, parallel, rotary};
use crate::engine::motion::functions::{Effect, effect};
use crate::engine::motion::moves::{OFF_CIRCLE, Speed, Turn};
use crate::engine::report::ending::{Done, Leave};
use crate::engine::report::fault::Fault;
use crate::program::syntax::{Approach, Axis, Coord, Motion, Path};

impl Run<'_, '_> {
    /// Executes a motion block. Whether it positions the tool.
    pub(super) fn motion(&mut self, motion: &Motion, in_machine: bool) -> Done<bool> {
        match motion.path {
            Path::Cc => {
                self.set_pole(motion)?;
                return Ok(false);
            }
            Path::Fpol => {
                self.free_pole(motion)?;
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
        if self.drives.world.parallels.drive() {
            self.only_driven(motion, in_machine)?;
        }
        if let Some(word) = motion.coords.iter().find(|coord| parallel(coord.axis).is_some()) {
            let machine = &self.drives.world.scene.machine;
            if parallel(word.axis).is_some_and(|letter| machine.parallel(letter).is_some()) {
                if !matches!(motion.path, Path::L | Path::Axis) {
                    return unsupported(word.axis.name());
                }
                self.slide(motion, in_machine, speed)?;
                return Ok(true);
            }
        }
        match motion.path {
            Path::L if motion.coords.iter().any(|coord| matches!(coord.axis, Axis::Pr | Axis::Pa)) => {
                return Err(Fault::program("coordinate-out-of-place").arg("path", "L").into());
            }
            _ if !in_machine && self.is_untilted(motion) => self.untilted_line(motion, speed)?,
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
            Path::Cc | Path::Rnd | Path::Chf | Path::Fpol => {}
            Path::Appr(form) => {
                let to = self.point_of_approach(motion, form)?;
                let before = if before { Ok(Speed::Rapid) } else { Speed::of_feed(feed_before.unwrap_or_default()) };
                self.approach_contour(motion, form, to, before, speed)?;
            }
            Path::Dep(form) => {
                let to = self.point_of_approach(motion, form)?;
                self.leave_by(motion, form, to, speed)?;
            }
            Path::Ln => self.line_with_normal(motion, speed)?,
            Path::Fl | Path::Flt | Path::Fc | Path::Fct => self.free_element(motion, speed)?,
            Path::Spl => self.spline(motion, speed)?,
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
    pub(super) fn straight_block(&mut self, motion: &Motion, to: DVec3, speed: Result<Speed, Fault>) -> Done {
        let speed = self.plunging_speed(to, speed);
        if self.is_in_contour(motion) {
            let place = self.block_place();
            return self.contour.line(&mut self.drives, motion, place, to, speed);
        }
        let plane = self.drives.world.system.contour_plane();
        let from = self.programmed();
        self.contour.passed(plane.flat(from), plane.flat(to));
        self.drives.straight_to(to, None, speed)
    }

    /// The speed of a straight way on which the tool does not go down faster than `M103` lets it.
    pub(super) fn plunging_speed(&self, to: DVec3, speed: Result<Speed, Fault>) -> Result<Speed, Fault> {
        let (Some(factor), Ok(Speed::Feed(feed))) = (self.modal.plunge_factor, &speed) else { return speed };
        let way = to - self.programmed();
        let down = -self.drives.world.system.plane.tool.of(way);
        if down <= 0.0 {
            return speed;
        }
        Ok(Speed::Feed(feed.min(feed * factor * way.length() / down)))
    }

    /// A circular block: at once, or as an element of a contour.
    pub(super) fn arc_block(&mut self, motion: &Motion, turn: Turn, to: DVec3, speed: Result<Speed, Fault>) -> Done {
        let (plane, from) = (turn.plane, self.programmed());
        let sweep = self.drives.sweep(from, to, &turn)?;
        let beside = self.is_in_contour(motion);
        if plane != self.drives.world.system.contour_plane() {
            if beside {
                return Err(Fault::unsupported("unsupported-compensation").arg("word", "CC").into());
            }
            // In the working plane it has no direction.
            self.contour.last = None;
            return self.drives.arc_by(Turn { sweep: Some(sweep), ..turn }, to, speed);
        }
        if beside {
            let place = self.block_place();
            return self.contour.arc(&mut self.drives, (turn.centre, sweep), to, motion, place, speed);
        }
        self.contour.passed_arc(plane.flat(from), plane.flat(to), plane.flat(turn.centre), sweep);
        self.drives.arc_by(Turn { sweep: Some(sweep), ..turn }, to, speed)
    }

    /// An arc that goes on in the direction of the element before it.
    fn tangential_circle(&mut self, motion: &Motion, to: DVec3, speed: Result<Speed, Fault>) -> Done {
        let plane = self.drives.world.system.contour_plane();
        let (from, heading) = (self.programmed(), self.contour.heading(&self.drives.world)?);
        let found = tangential(plane.flat(from), heading, plane.flat(to));
        let Some((centre, sweep)) = found else { return Err(Fault::program("tangent-missing").into()) };
        let centre = plane.lift(centre, plane.tool.of(from));
        self.arc_block(motion, Turn { plane, centre, direction: sweep.signum(), sweep: Some(sweep) }, to, speed)
    }

    /// A straight line, with rotary axes that turn at the same time.
    pub(super) fn line(&mut self, motion: &Motion, in_machine: bool, speed: Result<Speed, Fault>) -> Done {
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
            let from = self.second_datum(motion, turns.is_empty())?;
            let from = from + self.drives.world.parallels.carried();
            let to = self.target(&coords, self.drives.world.machine - from)? + from;
            return self.drives.turn_and_go(&turns, self.drives.world.to_program(to), Some(to), speed, None);
        }
        let to = self.target(&coords, self.drives.world.here)?;
        let speed = self.speed_at_tool(&turns, to, speed)?;
        self.drives.turn_and_go(&turns, to, None, speed, None)
    }

    /// From where machine coordinates count: with `M92` from the second datum of the machine, which is one of linear axes.
    fn second_datum(&self, motion: &Motion, is_linear: bool) -> Result<DVec3, Fault> {
        if !motion.functions.iter().any(|function| effect(function.number) == Some(Effect::SecondDatum)) {
            return Ok(DVec3::ZERO);
        }
        let datum = self.drives.world.scene.machine.second_datum.filter(|_| is_linear);
        datum.ok_or_else(|| Fault::unsupported("unsupported-m").arg("word", "M92"))
    }

    /// The speed of rotary axes with `M116`: as many degrees a minute as bring the tool along the workpiece with the feed
    /// that is written, at the distance from the axis that it has at the start of the block. Only of one axis of the table
    /// that turns alone: how a way of several axes is shared, no manual here says.
    fn speed_at_tool(
        &self,
        turns: &[(RotaryAxis, f64)],
        to: DVec3,
        speed: Result<Speed, Fault>,
    ) -> Done<Result<Speed, Fault>> {
        let (true, Ok(Speed::Feed(feed))) = (self.modal.feed_at_tool, &speed) else { return Ok(speed) };
        let world = &self.drives.world;
        let moving = |(axis, angle): &&(RotaryAxis, f64)| axis.of(world.angles) != *angle;
        let moving: Vec<_> = turns.iter().filter(moving).collect();
        let [(axis, _)] = *moving else {
            return if moving.is_empty() { Ok(speed) } else { Err(self.no_feed_at_tool()) };
        };
        let own = self.drives.rotary_axis(*axis)?;
        if own.carries != Carried::Workpiece || to != world.here || world.system.tip_held {
            return Err(self.no_feed_at_tool());
        }
        let turning = world.kinematics().turning(own, world.angles);
        let radius = (world.machine - turning.centre).reject_from(turning.direction).length();
        // Near the axis it turns as fast as it can.
        let rate = if radius > 0.0 { (feed / radius).to_degrees().min(own.rapid) } else { own.rapid };
        Ok(Speed::of_feed(rate))
    }

    fn no_feed_at_tool(&self) -> Leave {
        Fault::unsupported("unsupported-m").arg("word", "M116").into()
    }

    /// Whether a block leads to a place in the system that is not tilted, and another one is.
    fn is_untilted(&self, motion: &Motion) -> bool {
        let asked = motion.functions.iter().any(|function| effect(function.number) == Some(Effect::Untilted));
        asked && self.drives.world.system.tilt().is_some()
    }

    /// A straight line with `M130`: its coordinates are those of the system as it is without the tilt. Where the head is
    /// turned, nothing says which point of the tool goes there.
    fn untilted_line(&mut self, motion: &Motion, speed: Result<Speed, Fault>) -> Done {
        self.drives.not_beside_contour("M130")?;
        let turns = motion.coords.iter().any(|coord| rotary(coord.axis).is_some());
        if motion.path != Path::L || turns || self.drives.world.head.is_some() || self.drives.world.system.tip_held {
            return Err(Fault::unsupported("unsupported-m").arg("word", "M130").into());
        }
        let mut level = self.drives.world.system.clone();
        level.set_tilt(DVec3::ZERO);
        let to = self.target(&motion.coords, level.back().point(self.drives.world.machine))?;
        let to = level.frame().point(to);
        self.contour.forget();
        self.drives.turn_and_go(&[], self.drives.world.to_program(to), Some(to), speed, None)
    }

    /// Where the rotary axes of a block go, in machine coordinates.
    pub(super) fn turn_target(&self, coords: &[Coord], in_machine: bool) -> Result<Vec<(RotaryAxis, f64)>, Fault> {
        let system = &self.drives.world.system;
        let (datum, signs) =
            if in_machine { (DVec3::ZERO, DVec3::ONE) } else { (system.angle_datum(), system.mirror().1) };
        let mut turns = Vec::with_capacity(coords.len());
        for coord in coords {
            let Some(axis) = rotary(coord.axis) else { continue };
            let now = axis.of((self.drives.world.angles - datum) * signs);
            let to = self.coordinate(coord, now)? * axis.of(signs) + axis.of(datum);
            turns.push((axis, if self.modal.shorter_way { self.shorter(axis, to)? } else { to }));
        }
        self.drives.can_turn(&turns)?;
        Ok(turns)
    }

    /// The angle that is the same on an endless axis and nearest to where it is.
    fn shorter(&self, axis: RotaryAxis, to: f64) -> Result<f64, Fault> {
        if !self.drives.rotary_axis(axis)?.is_endless() {
            return Ok(to);
        }
        let now = axis.of(self.drives.world.angles);
        let way = (to - now).rem_euclid(360.0);
        Ok(now + if way > 180.0 { way - 360.0 } else { way })
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
        let tool = self.drives.world.system.plane.tool;
        let upright = axes.len() == 2 && axes.contains(&tool);
        let across = LinearAxis::ALL.into_iter().find(|axis| upright && !axes.contains(axis));
        self.modal.pole = Some(Pole { at, plane: across.map(WorkingPlane::of_tool_axis) });
        Ok(())
    }

    /// The plane of circles about the pole, and the pole at the tool's height above that plane.
    fn pole(&self) -> Result<(WorkingPlane, DVec3), Fault> {
        let pole = self.modal.pole.ok_or_else(|| Fault::program("pole-missing"))?;
        let plane = pole.plane.unwrap_or(self.drives.world.system.contour_plane());
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
        let radius = self.operand(radius)? * self.drives.unit();
        let here = self.programmed();
        let to = self.target(&motion.coords, here)?;
        let plane = self.drives.world.system.contour_plane();
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

    /// A block that positions one axis: with `R+` the way is longer by the tool radius, with `R-` shorter.
    pub(super) fn along_axis(&mut self, motion: &Motion, in_machine: bool, speed: Result<Speed, Fault>) -> Done {
        let along = self.contour.lengthened(motion.compensation);
        let axis = motion.coords.first().and_then(|coord| linear(coord.axis).ok());
        let Some(axis) = axis.filter(|_| !in_machine) else { return self.line(motion, in_machine, speed) };
        if along != 0 {
            self.drives.not_beside_contour("R+, R-")?;
        }
        if self.is_in_contour(motion) {
            return self.line(motion, in_machine, speed);
        }
        let from = self.programmed();
        let nominal = self.target(&motion.coords, from)?;
        let way = axis.of(nominal - from);
        let radius = self.contour.offset(&self.drives.world, 1)? * f64::from(along);
        let tool = self.drives.world.system.plane.tool;
        // Along its own axis the tool has no radius, and no way has no end.
        let longer = if axis == tool || way == 0.0 { 0.0 } else { radius * way.signum() };
        let to = axis.with(self.drives.world.here, axis.of(nominal) + longer);
        self.contour.forget();
        self.drives.straight_to(to, None, speed)?;
        self.contour.went_along(nominal, self.drives.world.here);
        Ok(())
    }

    /// Whether a block belongs to a contour that waits, or begins one.
    pub(super) fn is_in_contour(&self, motion: &Motion) -> bool {
        self.contour.takes(motion, self.block_place())
    }

    /// The block being executed, as an element of a contour.
    pub(super) fn block_place(&self) -> BlockPlace {
        let is_rounded = self.calls.here().is_some_and(|prepared| prepared.is_rounded(self.calls.block));
        BlockPlace { block: (self.calls.program, self.calls.block), is_rounded }
    }
}
