//! Motion blocks: lines, circles, polar forms, helices. What they do next to a contour is in `contour`.
//!
//! Invariant: a position is known both in program and machine coordinates after every move; a motion that
//! cannot be executed exactly is a fault.
use glam::DVec3;

use crate::base::expr::atan2d;
use crate::engine::geometry::{Axis as LinearAxis, SAME_POSITION, WorkingPlane};
use crate::engine::motion::drives::Drives;
use crate::engine::report::ending::Done;
use crate::engine::report::envelope::Touching;
use crate::engine::report::event::MoveKind;
use crate::engine::report::fault::{Class, Fault};
use crate::engine::solid::Path as BallPath;
use crate::engine::world::state::Pressed;
use crate::engine::world::stylus::ProbeData;

/// How far the end of a circle may lie off it, mm: what the controls' input step of 0.0001 mm can cause, with room.
pub(crate) const OFF_CIRCLE: f64 = 0.001;
/// The ends of an arc that are so near to each other, mm, are the same: no control is given a shorter arc.
const SAME_END: f64 = 1e-7;
/// What calculation may put between two positions that are the same, mm.
pub(crate) const SAME: f64 = SAME_POSITION;
/// Turns that one move may make, far more than a control takes: a stock follows them quarter by quarter.
const MOST_TURNS: f64 = 10_000.0;
/// From this feed on a move is one at rapid traverse: the value that the word FMAX has as a parameter.
pub(crate) const RAPID_FEED: f64 = 99_999.999;

/// A probe that presses against a face must move away from it by so much of its way to come free.
const LEAST_BACK: f64 = 1e-3;
/// What a probe that has just come free is away from what it touched, mm.
const FREE: f64 = 1e-9;

/// The speed of a move.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Speed {
    /// Rapid traverse.
    Rapid,
    /// mm/min along the path.
    Feed(f64),
}

/// How a circular movement turns.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Turn {
    /// The plane of the circle.
    pub(crate) plane: WorkingPlane,
    /// Its centre, program coordinates.
    pub(crate) centre: DVec3,
    /// 1 counter-clockwise, -1 clockwise.
    pub(crate) direction: f64,
    /// The signed angle where it is programmed, degrees.
    pub(crate) sweep: Option<f64>,
}

impl Speed {
    /// A feed as a cycle has it: that of FMAX and more is rapid traverse.
    pub(crate) fn of_feed(feed: f64) -> Result<Self, Fault> {
        if feed >= RAPID_FEED {
            return Ok(Self::Rapid);
        }
        if feed > 0.0 { Ok(Self::Feed(feed)) } else { Err(Fault::program("feed-missing").arg("feed", feed)) }
    }
}

const fn is_rapid(kind: MoveKind) -> bool {
    matches!(kind, MoveKind::Rapid | MoveKind::Arc { rapid: true, .. })
}

impl Drives<'_, '_> {
    /// Moves straight; `machine` gives the target in machine coordinates where that is what is programmed.
    pub(crate) fn straight_to(&mut self, to: DVec3, machine: Option<DVec3>, speed: Result<Speed, Fault>) -> Done {
        let to = if machine.is_none() && self.unit() != 1.0 { self.unless_moved(to) } else { to };
        let machine = machine.unwrap_or_else(|| self.world.to_machine(to));
        let from = self.world.here;
        if (to - from).abs().max_element() < SAME {
            return Ok(());
        }
        let path = BallPath::line(self.world.machine, machine);
        if self.traced.is_some() {
            return self.trace(to, machine, path);
        }
        let (kind, feed) = match speed? {
            Speed::Rapid => (MoveKind::Rapid, self.world.rapid_feed(machine - self.world.machine)),
            Speed::Feed(feed) => (MoveKind::Feed, self.per_minute(feed, &path)?),
        };
        self.go(kind, feed, to, machine, &path)
    }

    /// Moves on an arc in the working plane about the centre; `sweep` is the signed angle where it is programmed, else
    /// it follows from the end (a whole circle if that is where the tool is). Heights may differ: a helix.
    pub(crate) fn arc_to(
        &mut self,
        centre: DVec3,
        to: DVec3,
        direction: f64,
        sweep: Option<f64>,
        speed: Result<Speed, Fault>,
    ) -> Done {
        self.arc_by(Turn { plane: self.world.system.plane, centre, direction, sweep }, to, speed)
    }

    /// The same in any plane.
    pub(crate) fn arc_by(&mut self, turn: Turn, to: DVec3, speed: Result<Speed, Fault>) -> Done {
        let (plane, from) = (turn.plane, self.world.here);
        let angle = self.sweep(from, to, &turn)?;
        if angle.abs() > MOST_TURNS * 360.0 {
            return Err(Fault::new(Class::Limit, "turn-limit").arg("limit", MOST_TURNS).into());
        }
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
        if self.traced.is_some() {
            return self.trace(to, machine, path);
        }
        let speed = speed?;
        let feed = match speed {
            Speed::Rapid => self.slowest_rapid(),
            Speed::Feed(feed) => self.per_minute(feed, &path)?,
        };
        let kind = MoveKind::Arc { centre, plane, angle, rise, rapid: speed == Speed::Rapid };
        self.go(kind, feed, to, machine, &path)
    }

    /// The signed angle of an arc: that which is programmed, else what follows from its end.
    pub(crate) fn sweep(&self, from: DVec3, to: DVec3, turn: &Turn) -> Result<f64, Fault> {
        let (plane, centre, direction) = (turn.plane, turn.centre, turn.direction);
        let (a, b) = (plane.flat(from - centre), plane.flat(to - centre));
        let (start, end) = (libm::hypot(a.x, a.y), libm::hypot(b.x, b.y));
        if (start - end).abs() > OFF_CIRCLE || start == 0.0 {
            return Err(Fault::program("end-off-circle").arg("start_radius", start).arg("end_radius", end));
        }
        Ok(turn.sweep.unwrap_or_else(|| {
            let turn = (atan2d(b.y, b.x) - atan2d(a.y, a.x)) * direction;
            let turn = turn.rem_euclid(360.0);
            // An arc whose ends differ by rounding only is a full circle.
            direction * if a.distance(b) < SAME_END || turn == 0.0 { 360.0 } else { turn }
        }))
    }

    /// The rapid rate that every axis can keep.
    fn slowest_rapid(&self) -> f64 {
        self.world.scene.machine.axes.iter().map(|axis| axis.rapid).fold(f64::INFINITY, f64::min)
    }

    fn go(&mut self, kind: MoveKind, feed: f64, to: DVec3, machine: DVec3, path: &BallPath) -> Done {
        let from = self.world.here;
        self.count_move()?;
        if self.beside_contour {
            let word = self.report.at().cycle.as_ref().map_or_else(String::new, |(key, _)| key.to_string());
            self.not_compensated(word)?;
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
        self.meets_setter(path)?;
        self.collide(path)?;
        self.release(path);
        self.world.here = to;
        self.world.machine = machine;
        let path = self.world.path_of_tip(path);
        let turned = self.on_diameter(to);
        if self.blank.is_some() && turned.is_some() && !is_rapid(kind) {
            self.cut_blank(&path);
        }
        self.report.report_move(kind, from, to, machine, feed, path, turned);
        Ok(())
    }

    /// Notes a move of a contour that is only read.
    fn trace(&mut self, to: DVec3, machine: DVec3, path: BallPath) -> Done {
        self.count_move()?;
        self.world.here = to;
        self.world.machine = machine;
        self.traced.get_or_insert_default().push(path);
        Ok(())
    }

    /// An axis that would have to move must be there.
    pub(crate) fn has_axes_to(&self, machine: DVec3) -> Result<(), Fault> {
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
    pub(crate) fn no_unexecuted(&self) -> Result<(), Fault> {
        match self.world.system.unexecuted.first() {
            Some(active) => Err(Fault::unsupported("unsupported-transformation").arg("name", active.as_str())),
            None => Ok(()),
        }
    }

    /// A probe that touches something while it is not probing is an error.
    fn collide(&self, path: &BallPath) -> Done {
        if self.touching() != Touching::AsScene || (!self.probing && !self.world.holds_probe()) {
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
    pub(crate) fn shaft_touches(&self, probe: &ProbeData, path: &BallPath) -> Done {
        let Some(shaft) = probe.shaft else { return Ok(()) };
        let (path, axis) = (self.world.path_at_parts(path), self.world.along_parts(self.world.shaft_axis(shaft)));
        self.shaft_touches_on(shaft.radius, axis.length(), &|share| path.moved(axis * share))
    }

    /// The same for any movement; `way` says how a point of the axis moves, as the parts see it.
    pub(crate) fn shaft_touches_on(&self, radius: f64, length: f64, way: &dyn Fn(f64) -> BallPath) -> Done {
        match self.world.scene.body.shaft_contact(radius, length, way)? {
            None => Ok(()),
            Some(contact) => Err(self.at_point(Fault::control("shaft-collision"), contact.point).into()),
        }
    }

    /// A fault at a point of the parts.
    pub(crate) fn at_point(&self, fault: Fault, at_parts: DVec3) -> Fault {
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
    pub(crate) fn touches_on(&self, ball_radius: f64, path: &BallPath) -> Done {
        let path = self.world.path_at_parts(path);
        match self.world.scene.body.first_contact_on(ball_radius, &path)? {
            None => Ok(()),
            Some(contact) => Err(self.at_point(Fault::control("collision"), contact.point).into()),
        }
    }
}
