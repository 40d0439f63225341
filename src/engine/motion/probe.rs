//! Probing: the ball moves towards the workpiece until it touches.
//!
//! Invariant: what the control learns is where the ball centre was, as far as it knows the ball; the true ball
//! is the scene's. Points here are given by axis.
use glam::DVec3;

use crate::engine::motion::drives::Drives;
use crate::engine::report::ending::Done;
use crate::engine::report::envelope::Touching;
use crate::engine::report::event::EventKind;
use crate::engine::report::event::{MoveKind, Probing};
use crate::engine::report::fault::{Class, Fault};
use crate::engine::scene::Orientation;
use crate::engine::solid::{Contact, Path};
use crate::engine::world::state::Pressed;
use crate::engine::world::stylus::ProbeData;

/// Angles that differ by less, in degrees, are the same orientation.
const SAME_ANGLE: f64 = 1e-9;

/// A pre-travel that changes by less, in mm, is found.
const PUSHED: f64 = 1e-12;
/// A pre-travel that depends on the direction is found in so many steps.
const PUSHES: usize = 16;

/// A movement of the ball towards the workpiece.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ProbingStroke {
    /// Its direction in program coordinates, of length 1.
    pub direction: DVec3,
    /// How far it goes at most, mm.
    pub path: f64,
    /// mm/min.
    pub feed: f64,
}

/// Where such a movement ended.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Stop {
    /// The tool tip in machine coordinates.
    pub tip: DVec3,
    /// The ball centre in program coordinates as the control knows it.
    pub centre: DVec3,
    /// Whether something was touched.
    pub touched: bool,
}

impl Drives<'_, '_> {
    /// Probes towards a point (program coordinates) and returns to the start of the probing. The ball centre at
    /// contact in program coordinates. `turned` is by how much the spindle is turned from the calibration angle;
    /// without it a probe that is tracked is turned into the direction.
    pub(crate) fn probe(&mut self, towards: DVec3, turned: Option<f64>) -> Done<DVec3> {
        self.not_compensated("TCH PROBE")?;
        let probe = self.world.probe()?;
        let from = self.world.here + self.world.up() * probe.effective_radius;
        let way = towards - from;
        let length = way.length();
        if length == 0.0 {
            return Err(Fault::new(Class::Internal, "probe-no-direction").into());
        }
        let approach = ProbingStroke { direction: way / length, path: probe.dist, feed: probe.feed };
        let tracked = self.world.tracked(&probe, self.world.system.frame().vector(approach.direction));
        if let Some(turned) = turned.or(tracked) {
            self.orient_probe(&probe, turned);
        }
        let mut centres = Vec::with_capacity(probe.measurements as usize);
        for _ in 0..probe.measurements {
            let stop = self.stroke(&probe, &approach)?;
            if !stop.touched {
                // It is where the path ended.
                self.world.machine = stop.tip;
                self.world.renew();
                return Err(Fault::control("probe-no-contact").arg("distance", probe.dist).into());
            }
            self.back_from(stop.tip);
            centres.push(stop.centre);
        }
        mean(&probe, &centres, approach.direction).map_err(Into::into)
    }

    /// Probes along a direction of the machine, as far as probes go, and returns to where it began. The linear axes where
    /// it touched: the tool tip in the machine with the head at 0, and what turning the head has done to the offset of
    /// the ball.
    pub(crate) fn touch_along(&mut self, way: DVec3) -> Done<DVec3> {
        self.not_compensated("TCH PROBE")?;
        let probe = self.world.probe()?;
        let direction = self.world.system.back().vector(way).normalize();
        if let Some(turned) = self.world.tracked(&probe, way) {
            self.orient_probe(&probe, turned);
        }
        let stroke = ProbingStroke { direction, path: probe.dist, feed: probe.feed };
        let mut tips = Vec::with_capacity(probe.measurements as usize);
        for _ in 0..probe.measurements {
            let stop = self.stroke(&probe, &stroke)?;
            if !stop.touched {
                self.world.machine = stop.tip;
                self.world.renew();
                return Err(Fault::control("probe-no-contact").arg("distance", probe.dist).into());
            }
            self.back_from(stop.tip);
            tips.push(stop.tip);
        }
        let offset = self.world.offset_of_straight_head(&probe);
        let offset = self.world.head.map_or(offset, |head| head.vector(offset));
        Ok(mean(&probe, &tips, way.normalize())? + offset)
    }

    /// Turns the spindle so far from the angle at which the probe was calibrated, if it can turn.
    pub(crate) fn orient_probe(&mut self, probe: &ProbeData, turned: f64) {
        let way = (turned - self.world.spindle_turned).rem_euclid(360.0);
        if probe.orientation == Orientation::Fixed || way.min(360.0 - way) < SAME_ANGLE {
            return;
        }
        self.world.spindle_turned = turned;
        let orient = Some((probe.angle + turned).rem_euclid(360.0));
        self.report.report(EventKind::Spindle { tool: None, direction: 0, speed: 0.0, orient });
    }

    /// Moves towards the workpiece until the probe triggers or the path ends, and reports it. The tool stays where it is.
    pub(crate) fn stroke(&mut self, probe: &ProbeData, approach: &ProbingStroke) -> Done<Stop> {
        let frame = *self.world.system.frame();
        let from = self.world.here + self.world.up() * probe.effective_radius;
        let target = from + approach.direction * approach.path;
        let start = self.world.ball_centre(self.world.machine, probe);
        let way = frame.vector(approach.direction);
        self.note_way(&Path::line(self.world.machine, self.world.machine + way * approach.path), true);
        let found = match self.touching() {
            Touching::AsScene => self.found(probe, approach.path, start, way)?,
            Touching::AtOnce => Some((self.world.machine, start + way * probe.ball_radius, 0.0)),
            Touching::AtEnd | Touching::AsExpected => {
                let expected = if self.touching() == Touching::AtEnd { f64::INFINITY } else { self.expected(probe) };
                let gone = way * approach.path.min(expected);
                Some((self.world.machine + gone, start + gone + way * probe.ball_radius, 0.0))
            }
        };
        let tip = found.map_or(self.world.machine + way * approach.path, |(tip, _, _)| tip);
        if let Some(fault) = self.world.beyond_limits(tip) {
            return Err(fault.into());
        }
        let back = *self.world.system.back();
        let centre = back.point(self.world.believed_centre(tip, probe));
        let contact = found.map(|(_, point, _)| (back.point(point), centre));
        self.report.report(EventKind::Probe(Probing { from, target, contact, feed: approach.feed }));
        let pressed = |(_, _, depth)| Pressed { from: self.world.machine, direction: way, depth };
        self.world.pressed = found.map(pressed);
        Ok(Stop { tip, centre, touched: found.is_some() })
    }

    /// How far from the beginning of a probing path the cycle expects the workpiece, mm.
    fn expected(&self, probe: &ProbeData) -> f64 {
        (probe.set_up + self.clearance).max(0.0)
    }

    /// Where the probe triggers on a path of the ball from its centre at the start, if it does: the tool tip then, the
    /// point touched, and how far the ball went on after touching. In machine coordinates.
    fn found(&mut self, probe: &ProbeData, path: f64, start: DVec3, way: DVec3) -> Done<Option<(DVec3, DVec3, f64)>> {
        let (body, at_start) = (&self.world.scene.body, self.world.at_parts(start));
        if body.touches(probe.ball_radius, at_start)? {
            return Err(Fault::control("probe-deflected").into());
        }
        let path_end = self.world.at_parts(start + way * path);
        let Some(contact) = body.first_contact(probe.ball_radius, at_start, path_end)? else {
            self.shaft_touches(probe, &Path::line(start, start + way * path))?;
            return Ok(None);
        };
        let trigger = self.trigger(probe, at_start, path_end, contact)?;
        let reached = trigger.map(|trigger| {
            let (ball, point) = (self.world.off_parts(trigger.ball_centre), self.world.off_parts(trigger.point));
            let late = self.world.scatter();
            let depth = (trigger.ball_centre - contact.ball_centre).length() + late;
            (ball - start + way * late, point, depth)
        });
        let reached = reached.filter(|(gone, ..)| gone.length() <= path);
        let end = reached.map_or(way * path, |(gone, ..)| gone);
        self.shaft_touches(probe, &Path::line(start, start + end))?;
        Ok(reached.map(|(gone, point, depth)| (self.world.machine + gone, point, depth)))
    }

    /// Where the surface has pushed the ball in so far that the probe triggers: where a ball that is smaller by the
    /// pre-travel touches. That may depend on the direction into the material there.
    fn trigger(&self, probe: &ProbeData, from: DVec3, to: DVec3, touched: Contact) -> Done<Option<Contact>> {
        let (mut contact, mut pushed) = (touched, 0.0);
        for _ in 0..PUSHES {
            let into = self.world.vector_off_parts(-contact.normal);
            let wanted = self.world.pre_travel(probe, into);
            if (wanted - pushed).abs() < PUSHED {
                break;
            }
            pushed = wanted;
            // A ball that would be pushed in beyond its centre slips by.
            if pushed >= probe.ball_radius {
                return Ok(None);
            }
            match self.world.scene.body.first_contact(probe.ball_radius - pushed, from, to)? {
                Some(found) => contact = found,
                None => return Ok(None),
            }
        }
        Ok(Some(contact))
    }

    /// Reports the return from where the probe stopped.
    fn back_from(&mut self, stopped: DVec3) {
        let (here, machine) = (self.world.here, self.world.machine);
        self.world.pressed = None;
        if stopped != machine {
            let feed = self.world.rapid_feed(machine - stopped);
            let (from, swung) = (self.world.to_program(stopped), self.world.swung());
            let path = Path::line(stopped + swung, machine + swung);
            self.report.report(EventKind::Move {
                kind: MoveKind::Rapid,
                from,
                to: here,
                machine,
                feed,
                path,
                turned: None,
            });
        }
    }
}

/// The mean of what was measured, unless it lies too far apart.
fn mean(probe: &ProbeData, centres: &[DVec3], direction: DVec3) -> Result<DVec3, Fault> {
    let ways = || centres.iter().map(|centre| centre.dot(direction));
    let apart = ways().fold(f64::NEG_INFINITY, f64::max) - ways().fold(f64::INFINITY, f64::min);
    if let Some(range) = probe.confidence.filter(|range| apart > *range) {
        return Err(Fault::control("probe-measurements-differ").arg("found", apart).arg("range", range));
    }
    Ok(centres.iter().sum::<DVec3>() / centres.len() as f64)
}
