//! An outcome that another engine reports, in the form of ours, so that both are compared by the same rules.
//!
//! Invariant: nothing is executed here, and nothing is added to what was reported.
use std::borrow::Cow;
use std::sync::Arc;

use glam::DVec3;

use crate::base::expr::QRef;
use crate::engine::params::{Content, Params};
use crate::engine::report::event::{At, Event, EventKind, MessageKind, Status};
use crate::engine::report::fault::{Class, Fault};
use crate::engine::report::outcome::Outcome;
use crate::engine::report::outcome::Shown;
use crate::spec::CycleKey;

/// What another engine reports of a run.
#[derive(Clone, Debug)]
pub struct ForeignOutcome {
    /// How it ended.
    pub status: Status,
    /// The code of the error that ended it.
    pub error: Option<String>,
    /// The Q parameters at the end.
    pub q: Vec<(QRef, Content)>,
    /// The tool tip at the end, in program coordinates.
    pub position: DVec3,
    /// The rotary axes at the end, in program coordinates.
    pub angles: DVec3,
    /// The ids of the messages.
    pub messages: Vec<String>,
    /// Cells written: file, row, column, value.
    pub cells: Vec<(String, f64, String, Content)>,
    /// The texts of the logs.
    pub logs: Vec<String>,
    /// The movements and pauses of the cycle.
    pub actions: Vec<EventKind>,
}

impl ForeignOutcome {
    /// The outcome and the events of a run in which that cycle was executed.
    pub fn outcome(self, key: CycleKey) -> (Outcome, Vec<Event>) {
        let at = At { cycle: Some((key, None)), ..At::default() };
        let mut params = Params::new();
        for (q, value) in &self.q {
            // What is of the wrong kind has no value, and is missing in the comparison.
            let _ = params.set(*q, value);
        }
        let message =
            |id: &String| EventKind::Message { kind: MessageKind::Note, id: id.as_str().into(), answer: None };
        let cell =
            |(file, row, column, value): (String, f64, String, Content)| EventKind::Table { file, row, column, value };
        let mut shown = Shown::default();
        shown.guards.extend(self.messages.iter().chain(&self.error).map(|code| (key, Arc::from(code.as_str()))));
        let messages: Vec<EventKind> = self.messages.iter().map(message).collect();
        let kinds = messages.into_iter().chain(self.cells.into_iter().map(cell)).chain(self.actions);
        let events = kinds.map(|kind| Event { at: at.clone(), kind }).collect();
        let class = if self.status == Status::Unsupported { Class::Unsupported } else { Class::Control };
        let fault = self.error.map(|code| Fault { class, code: Cow::Owned(code), of_cycle: true, args: Vec::new() });
        let outcome = Outcome {
            status: self.status,
            fault,
            diagnostic: None,
            tables: Vec::new(),
            logs: Vec::new(),
            screens: self.logs,
            params,
            position: self.position,
            angles: self.angles,
            shown,
            envelopes: Vec::new(),
            noted: Vec::new(),
        };
        (outcome, events)
    }
}
