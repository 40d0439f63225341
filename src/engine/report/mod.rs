//! What a run reports: events, faults, and the forms in which both are handed on.
//!
//! Start reading at [`event`] (everything that can happen) and [`fault`] (why a run ends early). Invariant: a leaf.
//! Nothing here executes anything or knows who does.
pub(in crate::engine) mod envelope;
pub(in crate::engine) mod event;
pub(in crate::engine) mod fault;
pub(in crate::engine) mod foreign_outcome;
mod json;
pub(in crate::engine) mod threads;
pub(in crate::engine) mod trace;
