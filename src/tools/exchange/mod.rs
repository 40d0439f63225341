//! Texts on their way to translators and back: how far each language is, files for their tools, and what comes back.
//!
//! Invariant: nothing is written; which files there are, and how a report is shown, is for `cli`.
mod fluent;
mod import;
mod po;
mod status;
mod unit;
mod xliff;
mod xml;

pub use fluent::Piece;
pub use import::{Imported, Refusal, Why, import};
pub use status::{Count, LanguageStatus, Open, State, status};
pub use unit::{Unit, units};

/// A form of files for translators.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Form {
    /// XLIFF 1.2.
    Xliff,
    /// XLIFF 2.0.
    Xliff2,
    /// Gettext PO.
    Po,
}

/// A file that cannot be read, from this byte on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Unreadable {
    /// The byte.
    pub at: usize,
    /// A word for the reason: `form`, `document-type`, `entity`, `encoding`, `depth`, or `xliff` if it is another kind of
    /// file.
    pub what: &'static str,
}

/// A unit as it comes back.
#[derive(Clone, Debug)]
pub struct Received {
    /// Its identifier.
    pub id: String,
    /// Where it is in the file.
    pub at: usize,
    /// Whether the translator says that it is done.
    pub is_final: bool,
    /// Its source; nothing if it cannot be understood.
    pub source: Option<Vec<Piece>>,
    /// Its translation; nothing if there is none, or if it cannot be understood.
    pub target: Option<Vec<Piece>>,
}

/// The units as a file for translators.
pub fn write(units: &[Unit], tag: &str, form: Form) -> String {
    match form {
        Form::Po => po::write(units, tag),
        _ => xliff::write(units, tag, form),
    }
}

/// A file from a translator.
#[derive(Clone, Debug, Default)]
pub struct Returned {
    /// The tag of the language, as the file says it.
    pub language: Option<String>,
    /// Its units.
    pub units: Vec<Received>,
}

/// The units of a file from a translator, XLIFF or PO.
///
/// # Errors
/// If it is not such a file.
pub fn read(text: &str) -> Result<Returned, Unreadable> {
    let begin = text.trim_start_matches('\u{feff}').trim_start();
    if begin.starts_with('<') { xliff::read(text) } else { po::read(text) }
}

/// The length of the placeable with which a text begins.
fn code_length(text: &str) -> Option<usize> {
    let mut depth = 0_usize;
    let mut quoted = false;
    for (at, byte) in text.bytes().enumerate() {
        match byte {
            b'"' => quoted = !quoted,
            b'{' if !quoted => depth += 1,
            b'}' if !quoted => {
                depth = depth.checked_sub(1)?;
                if depth == 0 {
                    return Some(at + 1);
                }
            }
            _ => {}
        }
    }
    None
}
