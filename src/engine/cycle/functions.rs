//! Actions of cycles on spindle, coolant and rotary axes.
//!
//! Invariant: whatever the spindle does next is reported before the tool moves.
use glam::DVec3;

use crate::base::expr::Value;
use crate::engine::flow::exec::Exec;
use crate::engine::flow::state::Run;
use crate::engine::geometry::RotaryAxis;
use crate::engine::motion::drives::{Spindle, Switched};
use crate::engine::motion::functions::{Effect, effect};
use crate::engine::motion::moves::Speed;
use crate::engine::plan::{Calc, StrategyCall};
use crate::engine::report::ending::Done;
use crate::engine::report::fault::{Class, Fault};

impl<'e> Run<'_, 'e> {
    /// Where the rotary axes must be: the tool at right angles to the tilted plane, in program coordinates.
    pub(crate) fn compute_rotary_positions(&mut self, call: &StrategyCall, exec: &mut Exec<'_, 'e>) -> Done {
        let found = match self.drives.world.system.tilt() {
            Some(_) => self.drives.rotary_positions()?,
            None => DVec3::ZERO,
        };
        for (slot, axis) in call.results.iter().zip(RotaryAxis::ALL) {
            exec.put(*slot, Value::Number(axis.of(found)));
        }
        Ok(())
    }

    /// Turns the axes; a point that far before the tip keeps its place on the workpiece, and the tool returns to it.
    pub(crate) fn position_rotary_axes(&mut self, call: &StrategyCall, exec: &Exec<'_, 'e>) -> Done {
        let [a, b, c, feed, clearance] = self.all_given(call, 0, exec)?;
        self.drives.turn_about_point(DVec3::new(a, b, c), clearance, Speed::of_feed(feed))
    }

    pub(crate) fn restore_spindle_and_coolant(&mut self, exec: &Exec<'_, 'e>) {
        let Switched { spindle, coolant, .. } = exec.switched;
        if self.drives.switched.spindle != spindle {
            self.drives.switched.spindle = spindle;
            self.drives.report_spindle(None);
        }
        if self.drives.switched.coolant != coolant {
            self.drives.coolant(coolant);
        }
    }

    /// Turns or stops the spindle as the M function of a value says, at a speed that stays in force.
    pub(crate) fn turn_spindle(&mut self, call: &StrategyCall, exec: &Exec<'_, 'e>) -> Done {
        let [function, speed] = self.all_given(call, 0, exec)?;
        let Some(Effect::Spindle(direction)) = function_effect(function) else {
            return Err(unknown_function(function).into());
        };
        self.drives.switched.spindle = Spindle { direction, speed };
        self.drives.report_spindle(None);
        Ok(())
    }

    /// Executes the M function of a value, if it is one of spindle and coolant or changes nothing.
    pub(crate) fn execute_m_function(&mut self, call: &StrategyCall, exec: &Exec<'_, 'e>) -> Done {
        let function = self.given(call, 0, exec)?;
        match function_effect(function) {
            Some(Effect::Spindle(direction)) => self.drives.spindle(direction),
            Some(Effect::Coolant(on)) => self.drives.coolant(on),
            Some(Effect::SpindleAndCoolant(direction)) => {
                self.drives.spindle(direction);
                self.drives.coolant(true);
            }
            Some(Effect::Nothing) => {}
            _ => return Err(unknown_function(function).into()),
        }
        Ok(())
    }

    /// Along the tool axis in step with the spindle, which turns as the thread asks for in this direction; the speed
    /// of the program stays in force.
    pub(crate) fn synchronized(
        &mut self,
        tool: &Calc,
        pitch: &Calc,
        factor: Option<&Calc>,
        exec: &Exec<'_, 'e>,
    ) -> Done {
        let (height, pitch) = (self.number(tool, exec)?, self.number(pitch, exec)?);
        let factor = factor.map_or(Ok(1.0), |factor| self.number(factor, exec))?;
        let here = self.drives.in_plane(self.drives.world.here);
        if height == here.z {
            return Ok(());
        }
        // A right-hand thread goes in clockwise, against the direction of the tool axis.
        let direction = if (height < here.z) == (pitch > 0.0) { 1 } else { -1 };
        let speed = self.drives.switched.spindle.speed * factor;
        self.drives.switched.spindle.direction = direction;
        self.drives.report_turning(None, direction, speed);
        let to = self.drives.world.system.axes(here.truncate().extend(height));
        self.drives.straight_to(to, None, Speed::of_feed(pitch.abs() * speed))
    }
}

/// What the M function of a value does.
fn function_effect(function: f64) -> Option<Effect> {
    let whole = (0.0..=f64::from(u16::MAX)).contains(&function) && function.fract() == 0.0;
    if whole { effect(function as u16) } else { None }
}

fn unknown_function(function: f64) -> Fault {
    Fault::new(Class::Unsupported, "unsupported-m").arg("word", format!("M{function}"))
}
