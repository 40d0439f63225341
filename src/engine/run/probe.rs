//! Probing: the ball moves towards the workpiece until it touches.
//!
//! Invariant: what the control learns is where the ball centre was, as far as it knows the ball; the true ball
//! is the scene's. Points here are given by axis.
use glam::DVec3;

use super::event::{MoveKind, Probing};
use super::fault::{Class, Fault};
use super::{Done, EventKind, Run};

impl Run<'_, '_> {
    /// Probes towards a point (program coordinates) and returns to the start of the probing. The ball centre at
    /// contact in program coordinates.
    pub(super) fn probe(&mut self, towards: DVec3) -> Done<DVec3> {
        let probe = self.world.probe()?;
        let (frame, back) = (*self.world.system.frame(), *self.world.system.back());
        let plane = self.world.system.plane;
        let from = self.world.here + plane.tool.unit() * probe.ball_radius;
        let way = towards - from;
        let length = way.length();
        if length == 0.0 {
            return Err(Fault::new(Class::Internal, "probe-no-direction").into());
        }
        let target = from + way * (probe.dist / length);
        let start = self.world.ball_centre(self.world.machine, &probe, probe.offset);
        let (body, at_start) = (&self.world.scene.body, self.world.at_parts(start));
        if body.touches(probe.ball_radius, at_start)? {
            return Err(Fault::control("probe-deflected").into());
        }
        let path_end = self.world.at_parts(start + frame.vector(target - from));
        let contact = body.first_contact(probe.ball_radius, at_start, path_end)?;
        let Some(contact) = contact else {
            let kind = Probing { from, target, contact: None, feed: probe.feed };
            self.tell(EventKind::Probe(kind));
            return Err(Fault::control("probe-no-contact").arg("distance", probe.dist).into());
        };
        let (ball, touched) = (self.world.off_parts(contact.ball_centre), self.world.off_parts(contact.point));
        let stopped = self.world.machine + (ball - start);
        let centre = back.point(self.world.believed_centre(ball, stopped, &probe));
        let touched = back.point(touched);
        if let Some(fault) = self.world.beyond_limits(stopped) {
            return Err(fault.into());
        }
        self.tell(EventKind::Probe(Probing { from, target, contact: Some((touched, centre)), feed: probe.feed }));
        let (here, machine) = (self.world.here, self.world.machine);
        if stopped != machine {
            let feed = self.world.scene.machine.rapid_feed(machine - stopped);
            let kind = MoveKind::Rapid;
            self.tell(EventKind::Move { kind, from: back.point(stopped), to: here, machine, feed });
        }
        Ok(centre)
    }
}
