//! What strategies of calculation share: values in, values out, nothing moves.
//!
//! Invariant: they are functions of their arguments and the working plane; lengths are in the unit of the cycle.
use glam::DVec2;

use super::signature::{Results, Signature};
use crate::engine::geometry::WorkingPlane;
use crate::engine::report::fault::Fault;

/// Points that are nearer to each other, in mm, determine no direction: a tenth of what controls take as input.
pub(super) const SAME_POINT: f64 = 1e-5;

/// A strategy that calculates.
pub trait Calculation: Signature {
    /// What it gives; lengths in the unit of the cycle, as its arguments are.
    type Results: Results;

    /// The results.
    ///
    /// # Errors
    /// The arguments determine none.
    fn calculate(&self, plane: WorkingPlane) -> Result<Self::Results, Fault>;
}

/// A way that has a direction.
pub(super) fn directed(way: DVec2) -> Result<DVec2, Fault> {
    if way.length() < SAME_POINT {
        return Err(Fault::control("direction-undefined").arg("distance", way.length()));
    }
    Ok(way)
}
