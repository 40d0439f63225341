//! The coordinate system of turning: the tool as it is measured, in the plane of the rotary axis.
//!
//! The precession angle turns the coordinate system about the rotary axis, and the spindle with it; a reversed tool is turned
//! round by the spindle (TNC 640 manual, lines 7384-7410). Invariant: no axis moves.
use crate::engine::report::ending::Done;
use crate::engine::strategy::action::{Action, Control};
use crate::engine::strategy::signature::strategy;

strategy! {
    /// Aligns the coordinate system and the tool for turning.
    AlignTurningSystem = "align-turning-system" {
        /// The precession angle, degrees.
        precession: f64 = Angle,
    }
}

strategy! {
    /// Reverses the tool for turning.
    ReverseTurningTool = "reverse-turning-tool" {
        /// Whether it is turned by a half turn.
        reversed: bool = Number,
    }
}

strategy! {
    /// Ends the alignment of the coordinate system; the tool stays as it is.
    ResetTurningSystem = "reset-turning-system" {}
}

impl Action for AlignTurningSystem {
    type Results = ();

    fn act(&self, control: &mut dyn Control) -> Done {
        control.align_turning(Some(self.precession), None)
    }
}

impl Action for ReverseTurningTool {
    type Results = ();

    fn act(&self, control: &mut dyn Control) -> Done {
        control.align_turning(None, Some(self.reversed))
    }
}

impl Action for ResetTurningSystem {
    type Results = ();

    fn act(&self, control: &mut dyn Control) -> Done {
        control.end_turning_alignment();
        Ok(())
    }
}
