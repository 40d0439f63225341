//! Strategies of the basic rotation about the tool axis.
//!
//! Invariant: the preset stays where it is, unless a point is named that keeps its coordinates.
use glam::DVec3;

use crate::engine::report::ending::Done;
use crate::engine::strategy::action::{Action, Control, table_axis};
use crate::engine::strategy::signature::{Mm, strategy};
use crate::engine::table::{Cell, TableKind};

strategy! {
    /// Ends the basic rotation about the tool axis.
    ResetBasicRotation = "reset-basic-rotation" {}
}

strategy! {
    /// Sets the basic rotation about the tool axis, in effect or in a row of the preset table.
    WriteBasicRotation = "write-basic-rotation" {
        /// The basic rotation, degrees.
        angle: f64 = Angle,
        /// The row; without one, or with 0, it takes effect.
        row: Option<f64> = Number,
    }
}

strategy! {
    /// Turns the basic rotation in effect by an angle.
    TurnBasicRotation = "turn-basic-rotation" {
        /// By how much, degrees.
        angle: f64 = Angle,
        /// The point that keeps its coordinates in the program; without one, the preset stays where it is.
        about: Option<Mm<DVec3>> = Length,
    }
}

impl Action for ResetBasicRotation {
    type Results = ();

    fn act(&self, control: &mut dyn Control) -> Done {
        control.set_basic_rotation(0.0, None);
        Ok(())
    }
}

impl Action for WriteBasicRotation {
    type Results = ();

    fn act(&self, control: &mut dyn Control) -> Done {
        let row = self.row.unwrap_or(0.0);
        if row == 0.0 {
            control.set_basic_rotation(self.angle, None);
            return Ok(());
        }
        let column = format!("SP{}", table_axis(control).letter());
        control.write(TableKind::Preset, row, &column, &Cell::Number(self.angle))
    }
}

impl Action for TurnBasicRotation {
    type Results = ();

    fn act(&self, control: &mut dyn Control) -> Done {
        let about = self.about.map(|about| control.axes(about.0));
        control.set_basic_rotation(direction(control.basic_rotation() + self.angle), about);
        Ok(())
    }
}

/// The angle from -180 (excluded) to 180 that means the same direction.
pub(super) fn direction(degrees: f64) -> f64 {
    let turned = degrees.rem_euclid(360.0);
    if turned > 180.0 { turned - 360.0 } else { turned }
}
