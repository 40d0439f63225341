//! Scanning: where the ball would touch, and a stylus that stays on the surface.
//!
//! Invariant: what is felt is the contact of the true ball with the parts. A position of the stylus is that of the south
//! pole of its ball as the control believes it, in program coordinates.
use glam::DVec3;

use crate::engine::geometry::RotaryAxis;
use crate::engine::motion::drives::Drives;
use crate::engine::motion::moves::Speed;
use crate::engine::report::ending::Done;
use crate::engine::report::event::MoveKind;
use crate::engine::report::fault::Fault;
use crate::engine::solid::{Contact, Path};
use crate::engine::world::state::Pressed;
use crate::engine::world::stylus::ProbeData;

/// What calculation may push a ball into a surface on which it slides, mm.
const PUSHED: f64 = 1e-6;
/// A ball centre nearer to a rotary axis, mm, does not move when that turns.
const ON_AXIS: f64 = 1e-9;

impl Drives<'_, '_> {
    /// Where the stylus is.
    pub(crate) fn stylus_at(&self, probe: &ProbeData) -> DVec3 {
        self.world.here + self.world.calibrated_offset(probe)
    }

    /// The true centre of the ball in machine coordinates when the stylus is at a position.
    fn ball_at(&self, at: DVec3, probe: &ProbeData) -> DVec3 {
        self.world.ball_centre(self.world.to_machine(at - self.world.calibrated_offset(probe)), probe)
    }

    /// Where the ball touches the parts first on a straight way of the stylus, or on an arc about the tool axis
    /// (`about` its centre, degrees counter-clockwise): the position of the stylus then, and the direction out of the
    /// material.
    pub(crate) fn feel(
        &self,
        probe: &ProbeData,
        from: DVec3,
        to: DVec3,
        about: Option<(DVec3, f64)>,
    ) -> Result<Option<(DVec3, DVec3)>, Fault> {
        let frame = self.world.system.frame();
        let start = self.ball_at(from, probe);
        let path = match about {
            None => Path::line(start, self.ball_at(to, probe)),
            Some((centre, sweep)) => Path::Arc {
                centre: self.ball_at(centre, probe),
                axis: frame.vector(self.world.system.plane.tool.unit()),
                from: start,
                sweep,
                rise: 0.0,
            },
        };
        let found = self.world.scene.body.first_contact_on(probe.ball_radius, &self.world.path_at_parts(&path))?;
        Ok(found.map(|Contact { ball_centre, normal, .. }| {
            let back = self.world.system.back();
            let gone = back.vector(self.world.off_parts(ball_centre) - start);
            (from + gone, back.vector(self.world.vector_off_parts(normal)))
        }))
    }

    /// A rotary axis in machine coordinates, from its coordinate in the program.
    fn machine_angle(&self, axis: RotaryAxis, angle: f64) -> f64 {
        let system = &self.world.system;
        axis.of(system.angle_datum()) + angle * axis.of(system.mirror().1)
    }

    /// The same as [`Drives::feel`] on a straight way, once a rotary axis of the table has turned to an angle (program
    /// coordinates).
    pub(crate) fn feel_turned(
        &self,
        probe: &ProbeData,
        (axis, angle): (RotaryAxis, f64),
        from: DVec3,
        to: DVec3,
    ) -> Result<Option<(DVec3, DVec3)>, Fault> {
        let angles = axis.with(self.world.angles, self.machine_angle(axis, angle));
        let parts = self.world.parts_after(angles);
        let [start, end] = [from, to].map(|at| parts.point(self.ball_at(at, probe)));
        let found = self.world.scene.body.first_contact_on(probe.ball_radius, &Path::line(start, end))?;
        Ok(found.map(|Contact { ball_centre, normal, .. }| {
            let (back, off) = (self.world.system.back(), parts.inverse());
            (from + back.vector(off.vector(ball_centre - start)), back.vector(off.vector(normal)))
        }))
    }

    /// Whether the ball would touch the parts at a position while a rotary axis of the table turns to an angle (program
    /// coordinates).
    pub(crate) fn touches_while_turning(
        &self,
        probe: &ProbeData,
        (axis, angle): (RotaryAxis, f64),
        at: DVec3,
    ) -> Result<bool, Fault> {
        let machine = self.world.true_machine();
        let turning = machine.turning(self.rotary_axis(axis)?, self.world.angles);
        let way = self.machine_angle(axis, angle) - axis.of(self.world.angles);
        let from = self.ball_at(at, probe);
        let centre = turning.centre + turning.direction * (from - turning.centre).dot(turning.direction);
        if way == 0.0 || (from - centre).length() < ON_AXIS {
            return Ok(false);
        }
        // The parts turn one way, so to them the ball turns the other way.
        let path = Path::Arc { centre, axis: turning.direction, from, sweep: -way, rise: 0.0 };
        Ok(self.world.scene.body.first_contact_on(probe.ball_radius, &self.world.path_at_parts(&path))?.is_some())
    }

    /// By how much the ball moves over the parts at a position for each degree of a rotary axis of the table.
    pub(crate) fn way_in_degree(&self, probe: &ProbeData, axis: RotaryAxis, at: DVec3) -> Result<DVec3, Fault> {
        let turning = self.world.true_machine().turning(self.rotary_axis(axis)?, self.world.angles);
        let arm = self.ball_at(at, probe) - turning.centre;
        let sign = axis.of(self.world.system.mirror().1);
        Ok(self.world.system.back().vector(arm.cross(turning.direction)) * (1_f64.to_radians() * sign))
    }

    /// Turns a rotary axis to an angle (program coordinates) while the stylus goes to a position.
    pub(crate) fn fly_turning(
        &mut self,
        probe: &ProbeData,
        (axis, angle): (RotaryAxis, f64),
        to: DVec3,
        speed: Result<Speed, Fault>,
    ) -> Done {
        let to = to - self.world.calibrated_offset(probe);
        let angle = self.machine_angle(axis, angle);
        self.turn_and_go(&[(axis, angle)], to, None, speed, None)
    }

    /// Whether a ball that is larger by so much overlaps the parts when the stylus is there.
    pub(crate) fn touches_at(&self, probe: &ProbeData, at: DVec3, larger: f64) -> Result<bool, Fault> {
        let centre = self.world.at_parts(self.ball_at(at, probe));
        Ok(self.world.scene.body.touches(probe.ball_radius + larger, centre)?)
    }

    /// Moves a stylus that measures its deflection straight along the surface, which it touches at the end in that
    /// direction.
    pub(crate) fn slide(&mut self, probe: &ProbeData, to: DVec3, out: DVec3, feed: f64) -> Done {
        let to = to - self.world.calibrated_offset(probe);
        let (from, machine) = (self.world.here, self.world.to_machine(to));
        if from == to {
            return Ok(());
        }
        self.count_move()?;
        self.has_axes_to(machine)?;
        self.world.within_limits(machine)?;
        let path = Path::line(self.world.machine, machine);
        self.note_way(&path, true);
        let lift = self.world.ball_centre(DVec3::ZERO, probe);
        self.shaft_touches(probe, &path.moved(lift))?;
        let direction = -self.world.system.frame().vector(out);
        self.world.pressed = Some(Pressed { from: self.world.machine, direction, depth: PUSHED });
        self.world.here = to;
        self.world.machine = machine;
        let path = self.world.path_of_tip(&path);
        self.report.report_move(MoveKind::Feed, from, to, machine, feed, path, None);
        Ok(())
    }
}
