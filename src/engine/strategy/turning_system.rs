//! The coordinate system of turning: the tool as it is measured, in the plane of the rotary axis.
//!
//! A precession angle and a reversed tool need a tilting head, which is not executed. Invariant: nothing moves.
use super::action::{Action, Control};
use super::signature::strategy;
use crate::engine::report::ending::Done;
use crate::engine::report::fault::Fault;

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

/// The fault of an alignment for which the head would have to tilt.
fn needs_head() -> Fault {
    Fault::unsupported("unsupported-transformation").arg("name", "tilting")
}

impl Action for AlignTurningSystem {
    type Results = ();

    fn act(&self, _: &mut dyn Control) -> Done {
        if self.precession % 360.0 == 0.0 { Ok(()) } else { Err(needs_head().into()) }
    }
}

impl Action for ReverseTurningTool {
    type Results = ();

    fn act(&self, _: &mut dyn Control) -> Done {
        if self.reversed { Err(needs_head().into()) } else { Ok(()) }
    }
}

impl Action for ResetTurningSystem {
    type Results = ();

    fn act(&self, _: &mut dyn Control) -> Done {
        Ok(())
    }
}
