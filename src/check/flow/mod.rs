//! What can be known of a program's run without running it: an abstract interpretation over its labels, calls,
//! repeats and jumps.
//!
//! Every way that the run can take is followed with what is certain on it; where ways meet, what differs is
//! unknown. Invariant: certain means certain on every way. A program that takes too long to follow is one of
//! which nothing is known. Start reading in [`run`] (what is found out), `step` (what a block does) and `walk`.
mod call_effect;
mod called;
mod circles;
mod effects;
mod graph;
mod project;
mod run;
mod state;
mod step;
mod trace;
mod walk;

pub use circles::circles;
pub use graph::{Graph, Mark, Use, Way};
pub use project::{Called, Callee, ProgramCall, Project, Rows, ToolName, named};
pub(super) use project::{Callees, ToolKey, calls, name};
pub use run::{CycleCall, Run};
use state::State;
pub use state::{Loaded, Modal, Pending};
use step::Steps;
use walk::Walk;

use super::program::{Reading, stops};
use crate::program::syntax::{BlockKind, StatementKind};

/// Follows a program.
pub(super) fn follow(reading: &Reading<'_>, callees: &Callees) -> Run {
    let steps = Steps::new(reading, callees);
    let graph = Graph::of(reading);
    let mut walk = Walk::new(&steps, graph);
    let (main, blank) = kind(reading);
    walk.start(&State::begin(main, blank));
    let finished = walk.follow();
    walk.result(finished)
}

/// Whether a program is one that is started, not one that others call: it names its blank or its tools or ends with
/// M2 or M30; and whether that is certain: it names its blank, or its tools and such an end.
fn kind(reading: &Reading<'_>) -> (bool, bool) {
    let (mut tool, mut end, mut blank) = (false, false, false);
    for (_, block) in reading.marked() {
        match &block.kind {
            BlockKind::BlkForm(_) => blank = true,
            BlockKind::Statement(statement) => blank |= statement.kind == StatementKind::BlkForm,
            BlockKind::ToolCall(_) => tool = true,
            BlockKind::BeginPgm(_) | BlockKind::EndPgm(_) => {}
            _ => end |= stops(block),
        }
    }
    (reading.begins() && (tool || end || blank), reading.begins() && (blank || (tool && end)))
}
