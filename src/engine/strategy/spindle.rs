//! Strategies of spindle and coolant.
//!
//! Invariant: whatever the spindle does next is reported before the tool moves.
use super::action::{Action, Control, Function};
use super::signature::strategy;
use crate::engine::report::ending::Done;
use crate::engine::report::fault::Fault;

strategy! {
    /// The spindle turns the other way round.
    ReverseSpindle = "reverse-spindle" {}
}

strategy! {
    /// Spindle and coolant become what they were when the cycle began.
    RestoreSpindleAndCoolant = "restore-spindle-and-coolant" {}
}

strategy! {
    /// Turns or stops the spindle as an M function says, at a speed that stays in force.
    TurnSpindle = "turn-spindle" {
        /// The number of the M function: 3, 4 or 5.
        function: f64 = Number,
        /// The speed, 1/min.
        speed: f64 = Speed,
    }
}

strategy! {
    /// Executes an M function, if it is one of spindle and coolant or changes nothing.
    ExecuteMFunction = "execute-m-function" {
        /// Its number.
        function: f64 = Number,
    }
}

strategy! {
    /// The angle to which M functions orient the spindle from now on.
    KeepOrientationAngle = "keep-orientation-angle" {
        /// The angle, degrees.
        angle: f64 = Angle,
    }
}

impl Action for ReverseSpindle {
    type Results = ();

    fn act(&self, control: &mut dyn Control) -> Done {
        let running = control.running();
        control.turn(-running.direction, running.speed);
        Ok(())
    }
}

impl Action for RestoreSpindleAndCoolant {
    type Results = ();

    fn act(&self, control: &mut dyn Control) -> Done {
        let (before, now) = (control.at_begin(), control.running());
        if (now.direction, now.speed) != (before.direction, before.speed) {
            control.turn(before.direction, before.speed);
        }
        if now.coolant != before.coolant {
            control.coolant(before.coolant);
        }
        Ok(())
    }
}

impl Action for TurnSpindle {
    type Results = ();

    fn act(&self, control: &mut dyn Control) -> Done {
        match control.function(self.function) {
            Some(Function { spindle: Some(direction), coolant: None }) => {
                control.turn(direction, self.speed);
                Ok(())
            }
            _ => Err(unknown(self.function).into()),
        }
    }
}

impl Action for ExecuteMFunction {
    type Results = ();

    fn act(&self, control: &mut dyn Control) -> Done {
        let Some(function) = control.function(self.function) else { return Err(unknown(self.function).into()) };
        if let Some(direction) = function.spindle {
            control.turn(direction, control.running().speed);
        }
        if let Some(on) = function.coolant {
            control.coolant(on);
        }
        Ok(())
    }
}

impl Action for KeepOrientationAngle {
    type Results = ();

    fn act(&self, control: &mut dyn Control) -> Done {
        control.keep_orientation(self.angle);
        Ok(())
    }
}

fn unknown(function: f64) -> Fault {
    Fault::unsupported("unsupported-m").arg("word", format!("M{function}"))
}
