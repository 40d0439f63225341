//! The trace of a run: what happens, without where the program says it.
//!
//! Lines, block numbers and the names of program files are left out, so programs that differ only in how
//! they are written have the same trace. Invariant: the fingerprint is SHA-256 of the trace's bytes, a JSON
//! object and a line end for each event, the same on every machine.
use sha2::{Digest as _, Sha256};

use crate::engine::report::event::{At, Event};

/// An event of a trace and the line of the program that it belongs to.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Traced {
    /// The event as JSON, without a place.
    pub event: String,
    /// The physical line of the program, from 1.
    pub line: usize,
}

/// The trace of a run.
#[derive(Clone, Debug, Default)]
pub struct Trace {
    /// Its events, in order.
    pub events: Vec<Traced>,
    digest: Sha256,
}

impl Trace {
    /// Adds an event.
    pub fn push(&mut self, event: Event) {
        let Event { at, kind } = event;
        let placeless = Event { at: At { cycle: at.cycle, ..At::default() }, kind };
        let mut json = placeless.to_json();
        if let Some(entries) = json.as_object_mut() {
            entries.retain(|key, _| !matches!(key.as_str(), "line" | "block"));
        }
        let event = json.to_string();
        self.digest.update(event.as_bytes());
        self.digest.update(b"\n");
        self.events.push(Traced { event, line: at.line });
    }

    /// The fingerprint: `sha256:` and 64 digits.
    pub fn fingerprint(&self) -> String {
        let digits = self.digest.clone().finalize().iter().map(|byte| format!("{byte:02x}")).collect::<String>();
        format!("sha256:{digits}")
    }
}
