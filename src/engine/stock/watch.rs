//! The events of a run with what the stock finds about its moves.
//!
//! Invariant: events keep their order, and a finding follows the move that it is about; events wait for the stock in
//! bounded number.
use std::collections::VecDeque;

use super::Stock;
use super::follow::Machining;
use super::report::Report;
use crate::engine::report::event::{Event, EventKind};

/// Events that wait before the stock is brought up to date.
const WAITING: usize = 16_384;

/// Passes events on, with findings among them.
pub struct Watch {
    machining: Machining,
    waiting: VecDeque<Event>,
    /// How many events were passed on.
    passed: u64,
}

impl Watch {
    /// Before the first event.
    pub fn new(mut machining: Machining) -> Self {
        drop(machining.found());
        Self { machining, waiting: VecDeque::new(), passed: 0 }
    }

    /// Takes an event; `emit` gets what can be reported now. Everything is reported when the run has ended.
    pub fn see(&mut self, event: Event, emit: &mut dyn FnMut(Event)) {
        self.machining.see(&event);
        // A turn may belong to a move.
        let most = if matches!(event.kind, EventKind::Move { .. }) { 2 * WAITING } else { WAITING };
        self.waiting.push_back(event);
        if self.waiting.len() >= most {
            self.machining.settle();
        }
        if self.machining.settled() {
            self.pass_on(emit);
        }
    }

    fn pass_on(&mut self, emit: &mut dyn FnMut(Event)) {
        let mut findings = self.machining.found().into_iter().peekable();
        for event in self.waiting.drain(..) {
            self.passed += 1;
            let at = event.at.clone();
            emit(event);
            while let Some(found) = findings.next_if(|found| found.event <= self.passed) {
                let kind = EventKind::Finding { kind: found.kind, amount: found.amount };
                emit(Event { at: at.clone(), kind });
            }
        }
    }

    /// What is left, and the report.
    pub fn finish(self) -> (Stock, Report) {
        self.machining.finish()
    }
}
