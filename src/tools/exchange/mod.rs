//! Texts on their way to translators and back: how far each language is.
//!
//! Invariant: nothing is written; which files there are, and how a report is shown, is for `cli`.
mod status;

pub use status::{Count, LanguageStatus, Open, State, status};
