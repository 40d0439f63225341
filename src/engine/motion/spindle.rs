//! Spindle and coolant: turning, orienting, reversing, and moves in step with the spindle.
//!
//! Invariant: whatever the spindle does next is told before the tool moves.
use crate::engine::cycle::execute::Exec;
use crate::engine::geometry::Axis;
use crate::engine::motion::functions::{Effect, effect};
use crate::engine::motion::moves::Speed;
use crate::engine::plan::{Calc, StrategyCall};
use crate::engine::report::fault::{Class, Fault};
use crate::engine::run::{Done, EventKind, Run, Spindle, Tool};

impl<'e> Run<'_, 'e> {
    pub(in crate::engine) fn spindle(&mut self, direction: i8) {
        self.modal.spindle = Spindle { direction, ..self.modal.spindle };
        self.tell_spindle(None);
    }

    /// Tells how the spindle turns now, with the tool that it just got.
    pub(in crate::engine) fn tell_spindle(&mut self, tool: Option<(Tool, Axis)>) {
        let Spindle { speed, direction } = self.modal.spindle;
        self.tell_turning(tool, direction, speed);
    }

    fn tell_turning(&mut self, tool: Option<(Tool, Axis)>, direction: i8, speed: f64) {
        let speed = if direction == 0 { 0.0 } else { speed };
        self.tell(EventKind::Spindle { tool, direction, speed, orient: None });
    }

    /// The spindle stands at an angle.
    pub(in crate::engine) fn orient(&mut self, angle: f64) {
        self.modal.spindle.direction = 0;
        self.modal.orientation = angle;
        self.tell(EventKind::Spindle { tool: None, direction: 0, speed: 0.0, orient: Some(angle) });
    }

    pub(in crate::engine) fn coolant(&mut self, on: bool) {
        self.modal.coolant = on;
        self.tell(EventKind::Coolant(on));
    }

    pub(in crate::engine) fn restore_spindle_and_coolant(&mut self, exec: &Exec<'_, 'e>) {
        let (spindle, coolant) = exec.switched;
        if self.modal.spindle != spindle {
            self.modal.spindle = spindle;
            self.tell_spindle(None);
        }
        if self.modal.coolant != coolant {
            self.coolant(coolant);
        }
    }

    /// Turns or stops the spindle as the M function of a value says, at a speed that stays in force.
    pub(in crate::engine) fn turn_spindle(&mut self, call: &StrategyCall, exec: &Exec<'_, 'e>) -> Done {
        let [function, speed] = self.all_given(call, 0, exec)?;
        let Some(Effect::Spindle(direction)) = function_effect(function) else {
            return Err(unknown_function(function).into());
        };
        self.modal.spindle = Spindle { direction, speed };
        self.tell_spindle(None);
        Ok(())
    }

    /// Executes the M function of a value, if it is one of spindle and coolant or changes nothing.
    pub(in crate::engine) fn execute_m_function(&mut self, call: &StrategyCall, exec: &Exec<'_, 'e>) -> Done {
        let function = self.given(call, 0, exec)?;
        match function_effect(function) {
            Some(Effect::Spindle(direction)) => self.spindle(direction),
            Some(Effect::Coolant(on)) => self.coolant(on),
            Some(Effect::SpindleAndCoolant(direction)) => {
                self.spindle(direction);
                self.coolant(true);
            }
            Some(Effect::Nothing) => {}
            _ => return Err(unknown_function(function).into()),
        }
        Ok(())
    }

    /// Along the tool axis in step with the spindle, which turns as the thread asks for in this direction; the speed
    /// of the program stays in force.
    pub(in crate::engine) fn synchronized(
        &mut self,
        tool: &Calc,
        pitch: &Calc,
        factor: Option<&Calc>,
        exec: &Exec<'_, 'e>,
    ) -> Done {
        let (height, pitch) = (self.number(tool, exec)?, self.number(pitch, exec)?);
        let factor = factor.map_or(Ok(1.0), |factor| self.number(factor, exec))?;
        let here = self.in_plane(self.world.here);
        if height == here.z {
            return Ok(());
        }
        // A right-hand thread goes in clockwise, against the direction of the tool axis.
        let direction = if (height < here.z) == (pitch > 0.0) { 1 } else { -1 };
        let speed = self.modal.spindle.speed * factor;
        self.modal.spindle.direction = direction;
        self.tell_turning(None, direction, speed);
        let to = self.world.system.axes(here.truncate().extend(height));
        self.straight_to(to, None, Speed::of_feed(pitch.abs() * speed))
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
