//! What came out of a run.
use std::collections::BTreeSet;
use std::sync::Arc;

use glam::DVec3;

use super::envelope::Envelope;
use super::event::Status;
use super::fault::Fault;
use crate::base::diag::Diagnostic;
use crate::base::expr::Value;
use crate::engine::params::Params;
use crate::spec::CycleKey;

/// What a sentence of the run is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum SentenceKind {
    /// A numbered step.
    Step,
    /// A bullet inside a step.
    Say,
}

/// A sentence of the run: what coverage counts.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Sentence {
    /// What it is.
    pub kind: SentenceKind,
    /// Its id.
    pub id: Arc<str>,
}

/// A sentence or guard of a cycle that a run has shown.
#[derive(Clone, Debug, Default)]
pub struct Shown {
    /// Steps and bullets executed.
    pub sentences: BTreeSet<(CycleKey, Sentence)>,
    /// Guards that applied, by code.
    pub guards: BTreeSet<(CycleKey, Arc<str>)>,
}

/// What came out of a run.
#[derive(Clone, Debug)]
pub struct Outcome {
    /// How it ended.
    pub status: Status,
    /// Why, if it ended before its end.
    pub fault: Option<Fault>,
    /// The fault with its place in the program and the calls that led there.
    pub diagnostic: Option<Diagnostic>,
    /// Names and texts of the tables that were written.
    pub tables: Vec<(String, String)>,
    /// Names and texts of the logs that were written.
    pub logs: Vec<(String, String)>,
    /// The texts of the logs that were shown on the screen.
    pub screens: Vec<String>,
    /// The Q parameters at the end.
    pub params: Params,
    /// The tool tip at the end, in program coordinates.
    pub position: DVec3,
    /// The rotary axes at the end, in program coordinates.
    pub angles: DVec3,
    /// What was executed of the cycles.
    pub shown: Shown,
    /// What the probing cycles would do in the worst case, if that was asked for.
    pub envelopes: Vec<Envelope>,
    /// The values that were watched, in the order of the run.
    pub noted: Vec<Noted>,
}

/// Values of a run at a moment.
#[derive(Clone, Debug)]
pub struct Noted {
    /// Which of the watches it is.
    pub watch: usize,
    /// How many events were reported before.
    pub events: usize,
    /// The values of its expressions; nothing for one that has none then.
    pub values: Vec<Option<Value>>,
}
