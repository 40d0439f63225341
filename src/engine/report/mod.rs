//! What a run reports: events, faults, and the forms in which both are handed on.
//!
//! Start reading at [`event`] (everything that can happen) and [`fault`] (why a run ends early). Invariant: nothing here
//! executes anything or knows who does.
pub(crate) mod ending;
pub(crate) mod envelope;
pub(crate) mod event;
pub(crate) mod fault;
pub(crate) mod foreign_outcome;
mod json;
pub(crate) mod json_line;
pub(crate) mod outcome;
pub(crate) mod reporter;
mod threads;
pub(crate) mod trace;
