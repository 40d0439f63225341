//! Texts on their way to translators and back: how far each language is, files for their tools, and what comes back.
//!
//! Invariant: nothing is written; which files there are, and how a report is shown, is for `cli`.
mod about;
mod draft;
mod fluent;
mod import;
pub mod markdown;
mod memory;
mod outcome;
mod po;
mod prose;
mod pseudo;
mod received;
mod status;
mod termbase;
mod terms;
mod unit;
mod xliff;

pub use about::{About, Remark};
pub use draft::draft;
pub use fluent::Piece;
pub use import::import;
pub use memory::{Entry, entries, tmx};
pub use outcome::{Imported, Refusal, Why};
pub use pseudo::{Pseudo, pseudo};
pub use received::{Form, Received, Returned, Unreadable};
pub use status::{Count, LanguageStatus, Open, State, status};
pub use termbase::{Row, import_terms, is_terms, read_terms};
pub use terms::{Concept, Words, concepts, csv, tbx};
pub use unit::{Unit, units};

/// The units as a file for translators.
pub fn write(units: &[Unit], tag: &str, form: Form) -> String {
    match form {
        Form::Po => po::write(units, tag),
        _ => xliff::write(units, tag, form),
    }
}

/// The units of a file from a translator, XLIFF or PO.
///
/// # Errors
/// If it is not such a file.
pub fn read(text: &str) -> Result<Returned, Unreadable> {
    let begin = text.trim_start_matches('\u{feff}').trim_start();
    if begin.starts_with('<') { xliff::read(text) } else { po::read(text) }
}
