//! What can go wrong when a text is asked for.
//!
//! Invariant: an error names the text and what it lacks; it never carries half-formatted text.
use std::fmt;

use crate::base::diag::{Diagnostic, Place, Severity};

/// The word of a message where it is not known in which file a text belongs.
pub const NO_FILE: &str = "none";

/// Why a text could not be made.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Fault {
    /// No language has this tag.
    UnknownLanguage,
    /// The language has no such message, or the message has no value or no such attribute.
    MissingText,
    /// The text uses an argument that it was not given.
    MissingArgument(String),
    /// The text refers to a message, term or attribute that does not exist.
    UnknownReference(String),
    /// The text calls a function that does not exist.
    UnknownFunction(String),
    /// A function refused its arguments; its name, with the reason as a word of the `reason` selector.
    FunctionFailed(&'static str, &'static str),
    /// The text contains itself.
    Cyclic,
    /// The text has more placeables than Fluent resolves.
    TooLong,
}

impl Fault {
    /// The code of the diagnostic for this fault.
    pub const fn code(&self) -> &'static str {
        match self {
            Self::UnknownLanguage => "locale-unknown-language",
            Self::MissingText => "locale-missing-text",
            Self::MissingArgument(_) => "locale-missing-argument",
            Self::UnknownReference(_) => "locale-unknown-reference",
            Self::UnknownFunction(_) => "locale-unknown-function",
            Self::FunctionFailed(..) => "locale-function-failed",
            Self::Cyclic => "locale-cyclic",
            Self::TooLong => "locale-too-long",
        }
    }
}

/// A text that could not be made.
#[derive(Clone, Debug)]
pub struct LocaleError {
    /// The tag of the language.
    pub language: String,
    /// The message, with `.attribute` if an attribute was asked for.
    pub key: String,
    /// Why.
    pub fault: Fault,
    /// Where the text is, if it exists.
    pub place: Option<Place>,
}

impl LocaleError {
    pub(super) fn unknown_language(tag: &str) -> Self {
        Self { language: tag.to_owned(), key: String::new(), fault: Fault::UnknownLanguage, place: None }
    }
}

impl fmt::Display for LocaleError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {} {} {:?}", self.fault.code(), self.language, self.key, self.fault)
    }
}

impl std::error::Error for LocaleError {}

impl From<LocaleError> for Diagnostic {
    fn from(error: LocaleError) -> Self {
        let diagnostic = Self {
            code: error.fault.code(),
            severity: Severity::Error,
            place: error.place,
            args: Vec::new(),
            related: Vec::new(),
            fix: None,
        };
        let diagnostic = diagnostic.arg("language", error.language).arg("key", error.key);
        match error.fault {
            Fault::MissingArgument(name) | Fault::UnknownReference(name) | Fault::UnknownFunction(name) => {
                diagnostic.arg("name", name)
            }
            Fault::FunctionFailed(name, reason) => diagnostic.arg("name", name).arg("reason", reason),
            // Whoever knows the other languages says where it belongs.
            Fault::MissingText => diagnostic.arg("file", NO_FILE),
            Fault::UnknownLanguage | Fault::Cyclic | Fault::TooLong => diagnostic,
        }
    }
}
