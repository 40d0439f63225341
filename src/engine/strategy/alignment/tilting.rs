//! Strategies around the tilted working plane.
//!
//! Invariant: positions follow from the axes of the machine alone.
use glam::DVec3;

use crate::engine::report::ending::Done;
use crate::engine::strategy::action::{Action, Control};
use crate::engine::strategy::signature::{results, strategy};

strategy! {
    /// Where the rotary axes must be for the tool to be at right angles to the tilted working plane.
    ComputeRotaryPositions = "compute-rotary-positions" {}
}

results! {
    /// Positions of the rotary axes in program coordinates, degrees; 0 for those that there are not.
    ComputeRotaryPositionsResults {
        /// Of A.
        a: f64 = Angle,
        /// Of B.
        b: f64 = Angle,
        /// Of C.
        c: f64 = Angle,
    }
}

strategy! {
    /// Turns the rotary axes and brings the tool back to where it was over the workpiece.
    PositionRotaryAxes = "position-rotary-axes" {
        /// Where A shall be, degrees.
        a: f64 = Angle,
        /// Where B shall be, degrees.
        b: f64 = Angle,
        /// Where C shall be, degrees.
        c: f64 = Angle,
        /// The feed.
        feed: f64 = Feed,
        /// The point that far before the tip keeps its place on the workpiece, mm.
        clearance: f64 = Length,
    }
}

strategy! {
    /// Whether the spindle is at right angles to the rotary axis that turns the workpiece.
    CheckSpindleAcrossRotaryAxis = "check-spindle-across-rotary-axis" {}
}

results! {
    /// How the spindle is.
    CheckSpindleAcrossRotaryAxisResults {
        /// 1 if it is at right angles, otherwise 0.
        across: f64 = Number,
    }
}

impl Action for ComputeRotaryPositions {
    type Results = ComputeRotaryPositionsResults;

    fn act(&self, control: &mut dyn Control) -> Done<ComputeRotaryPositionsResults> {
        let DVec3 { x: a, y: b, z: c } = control.for_tilted_plane()?;
        Ok(ComputeRotaryPositionsResults { a, b, c })
    }
}

impl Action for PositionRotaryAxes {
    type Results = ();

    fn act(&self, control: &mut dyn Control) -> Done {
        control.turn_about_point(DVec3::new(self.a, self.b, self.c), self.clearance, self.feed)
    }
}

impl Action for CheckSpindleAcrossRotaryAxis {
    type Results = CheckSpindleAcrossRotaryAxisResults;

    fn act(&self, control: &mut dyn Control) -> Done<CheckSpindleAcrossRotaryAxisResults> {
        Ok(CheckSpindleAcrossRotaryAxisResults { across: f64::from(u8::from(control.spindle_is_across())) })
    }
}
