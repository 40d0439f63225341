//! Pieces of the way of a tool, as a run went them.
//!
//! Invariant: plain data; what it means to a view is not known here.
use glam::DVec3;

use crate::engine::machine::Tool;

/// How a piece of the way is gone.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Way {
    /// At rapid traverse.
    Rapid,
    /// At a feed.
    Feed,
    /// Towards the workpiece, to touch it.
    Probe,
}

/// A piece of the way of the tool tip or of the ball centre.
#[derive(Clone, Debug)]
pub(super) struct Stroke {
    /// How it is gone.
    pub(super) way: Way,
    /// Its points; the chords of an arc leave it by 0.04 mm at most.
    pub(super) points: Vec<DVec3>,
    /// The tool that goes it.
    pub(super) tool: Tool,
    /// Where the table turns what is milled: the direction of the tool at each of the points.
    pub(super) up: Vec<DVec3>,
    /// How the spindle stands or turns meanwhile.
    pub(super) turning: Turning,
    /// The angles of the rotary axes at its end, in the program.
    pub(super) angles: DVec3,
}

/// How the spindle stands or turns while the tool moves.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Turning {
    /// +1 clockwise as seen from the spindle, -1 counter-clockwise, 0 standing.
    pub(super) direction: i8,
    /// The angle at which it stands, if it was oriented.
    pub(super) angle: Option<f64>,
    /// Where the first edge of the tool is while the spindle is at 0, degrees.
    pub(super) first: f64,
}
