//! Moves about the rotary axis on which the workpiece is clamped: the table turns, and the linear axes go with it.
//!
//! Invariant: all axes begin and end together; the tool keeps its direction in the machine, and so does a tilted system:
//! what moves along its tool axis after the cycle moves along the tool, as the programs of the manual do (TNC 640
//! manual, lines 5385 and 5437).
use glam::DVec3;

use crate::engine::geometry::{Around, RotaryAxis, SAME_POSITION};
use crate::engine::machine::Across;
use crate::engine::motion::drives::Drives;
use crate::engine::motion::moves::Speed;
use crate::engine::report::ending::Done;
use crate::engine::report::fault::Fault;
use crate::spec::Transformation;

impl Drives<'_, '_> {
    /// The rotary axis on which the workpiece is clamped, and the directions about it.
    fn across_table(&self) -> Result<(RotaryAxis, Across), Fault> {
        let (world, machine) = (&self.world, &self.world.scene.machine);
        let refused = |name: &'static str| Err(Fault::unsupported("unsupported-transformation").arg("name", name));
        let system = &world.system;
        if world.head.is_some() && !system.is_on_workpiece() {
            // The control goes on as if the head was at 0, and does not know where the tip is.
            return refused(Transformation::Tilting.as_str());
        }
        if system.scaling().1.is_some() {
            // The cylinder would no longer be round.
            return refused(Transformation::AxisScaling.as_str());
        }
        let axis = machine.clamped_on().ok_or_else(|| Fault::control("rotary-axis-missing").arg("axis", "C"))?;
        Ok((axis.axis, machine.across(axis, world.angles)))
    }

    /// Where the datum lies along that axis.
    fn datum_along(&self, across: &Across) -> f64 {
        across.seen(self.world.system.frame().point(DVec3::ZERO)).y
    }

    /// How far the datum lies beside the rotary axis on which the workpiece is clamped, mm.
    pub(crate) fn datum_off_table(&self) -> Result<f64, Fault> {
        let (_, across) = self.across_table()?;
        let datum = across.seen(self.world.system.frame().point(DVec3::ZERO));
        Ok(libm::hypot(datum.x, datum.z))
    }

    /// Where the tool is about that axis: lengths as the program has them, which may be scaled.
    pub(crate) fn around_table(&self) -> Result<Around, Fault> {
        let (axis, across) = self.across_table()?;
        let seen = across.seen(self.world.machine + self.world.swung());
        let turn = axis.of(self.world.program_angles());
        let scale = self.world.system.scaling().0;
        let along = (seen.y - self.datum_along(&across)) / scale;
        Ok(Around { turn, across: seen.x / scale, along, height: seen.z / scale })
    }

    /// Moves there. `radius` is that of the cylinder whose development the path lies in: the feed is the one along it.
    pub(crate) fn go_around_table(&mut self, to: Around, radius: f64, speed: Result<Speed, Fault>) -> Done {
        let from = self.around_table()?;
        let (axis, across) = self.across_table()?;
        let scale = self.world.system.scaling().0;
        let scaled = |own: Around| Around {
            turn: own.turn,
            across: own.across * scale,
            along: own.along * scale,
            height: own.height * scale,
        };
        let (from, to, radius) = (scaled(from), scaled(to), radius * scale);
        let tip = across.point(DVec3::new(to.across, to.along + self.datum_along(&across), to.height));
        let mut machine = tip - self.world.swung();
        if (machine - self.world.machine).abs().max_element() < SAME_POSITION {
            machine = self.world.machine;
        }
        let goal = self.world.to_program(machine);
        let turned = (to.turn - from.turn).to_radians() * radius;
        if turned.abs() < SAME_POSITION {
            return self.straight_to(goal, Some(machine), speed);
        }
        let (linear, developed) = ways(&from, &to, turned);
        let angle = axis.of(self.world.system.angle_datum()) + to.turn * axis.of(self.world.system.mirror().1);
        let speed = speed?;
        let rates = match speed {
            Speed::Rapid => None,
            Speed::Feed(feed) => {
                let minutes = developed / feed;
                Some((linear / minutes, (to.turn - from.turn).abs() / minutes))
            }
        };
        self.world.system_stays = true;
        let gone = self.turn_and_go(&[(axis, angle)], goal, Some(machine), Ok(speed), rates);
        self.world.system_stays = false;
        gone
    }
}

/// How far the linear axes go, and how far the tool goes on the development, mm; `turned` is the way of the rotary axis
/// there. What only turns the tool about the place where it cuts takes as long as the axis that goes farthest.
fn ways(from: &Around, to: &Around, turned: f64) -> (f64, f64) {
    let linear = DVec3::new(to.across - from.across, to.along - from.along, to.height - from.height);
    let developed = DVec3::new(linear.x + turned, linear.y, linear.z);
    (linear.length(), developed.length().max(linear.length()).max(turned.abs()))
}
