//! What strategies of milling share: they draw a path from where the tool is.
//!
//! Invariant: a path follows from the arguments, the radius of the tool and where it is; nothing else is seen.
use glam::DVec3;

use super::pen::{Cutter, Path, Pen};
use super::signature::Signature;
use crate::engine::report::fault::{Class, Fault};

/// More outlines or lines of one level than this are refused.
pub(super) const MAX_OUTLINES: f64 = 10_000.0;

/// A strategy that moves a milling tool.
pub trait Milling: Signature {
    /// Draws the path from where the pen is. What was drawn before a fault is milled.
    ///
    /// # Errors
    /// No path of this tool makes the shape, or it has too many legs.
    fn mill(&self, tool: Cutter, pen: &mut Pen) -> Result<(), Fault>;

    /// The path from a point: main, minor and tool coordinate.
    fn path(&self, tool: Cutter, from: DVec3) -> Path {
        let mut pen = Pen::new(from);
        let ended = self.mill(tool, &mut pen);
        pen.path(ended)
    }
}

/// The fault of a figure that no path of this tool makes.
pub(super) fn shape_impossible(least: f64, found: f64) -> Fault {
    Fault::control("shape-impossible").arg("least", least).arg("found", found)
}

/// The fault of a path that would have no end.
pub(super) fn too_many(limit: f64) -> Fault {
    Fault::new(Class::Limit, "series-limit").arg("limit", limit)
}
