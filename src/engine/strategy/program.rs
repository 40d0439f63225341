//! Strategies around programs and what they are executed with: a program called, a tolerance, the insert of a tool.
//!
//! Invariant: one value or one call at a time.
use std::sync::Arc;

use super::action::{Action, Control};
use super::signature::{Mm, results, strategy};
use crate::engine::report::ending::Done;

strategy! {
    /// Executes a whole program.
    CallProgram = "call-program" {
        /// Its name.
        program: Arc<str> = Text,
    }
}

strategy! {
    /// How far the path may deviate from the programmed one; without anything as the machine has it.
    KeepTolerance = "keep-tolerance" {
        /// From the contour, mm.
        contour: Option<f64> = Length,
        /// The filter: 0 for finishing, 1 for roughing.
        hsc_mode: Option<f64> = Number,
        /// Of rotary axes, degrees.
        rotary: Option<f64> = Angle,
    }
}

strategy! {
    /// The size of the insert of the turning tool in the spindle, as the tables have it.
    TurningInsert = "turning-insert" {}
}

results! {
    /// The size of an insert; 0 where the tables have none.
    TurningInsertResults {
        /// Its cutting width.
        width: Mm<f64> = Length,
        /// Its cutting radius.
        radius: Mm<f64> = Length,
    }
}

impl Action for CallProgram {
    type Results = ();

    fn act(&self, control: &mut dyn Control) -> Done {
        control.call(&self.program)
    }
}

impl Action for KeepTolerance {
    type Results = ();

    fn act(&self, control: &mut dyn Control) -> Done {
        let values = [self.contour, self.hsc_mode, self.rotary].map(|value| value.unwrap_or(0.0));
        control.keep_tolerance(self.contour.is_some().then_some(values));
        Ok(())
    }
}

impl Action for TurningInsert {
    type Results = TurningInsertResults;

    fn act(&self, control: &mut dyn Control) -> Done<TurningInsertResults> {
        let insert = control.insert()?;
        let [width, radius] = [insert.width, insert.radius].map(Mm);
        Ok(TurningInsertResults { width, radius })
    }
}
