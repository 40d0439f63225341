//! Files of translators as they come back, whatever their form.
use super::fluent::Piece;
pub use crate::base::xml::Unreadable;

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

/// A file from a translator.
#[derive(Clone, Debug, Default)]
pub struct Returned {
    /// The tag of the language, as the file says it.
    pub language: Option<String>,
    /// Its units.
    pub units: Vec<Received>,
}

/// The length of the placeable with which a text begins.
pub(super) fn code_length(text: &str) -> Option<usize> {
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
