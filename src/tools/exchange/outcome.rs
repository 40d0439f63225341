//! What comes of a file that a translator has sent back.
use crate::base::diag::Diagnostic;

/// Why a unit is refused.
#[derive(Clone, Debug)]
pub enum Why {
    /// There is no text of this identifier.
    Unknown,
    /// Its identifier is there several times.
    Twice,
    /// Its source is not that of today.
    SourceChanged,
    /// It has no translation, or something in it that is neither text nor a known code.
    NotRead,
    /// Codes are missing, or there are some that the text does not have.
    Codes {
        /// Those that are missing.
        missing: String,
        /// Those that do not belong there.
        foreign: String,
    },
    /// Codes have changed places among the same words.
    Exchanged,
    /// The translation that was there has changed places with that of another text.
    Swapped {
        /// The key of the other text.
        other: String,
    },
    /// A word that denies was taken out of the translation that was there.
    Negation,
    /// A page of prose would have other marks or blocks.
    Markup,
    /// Numbers, or words with digits, of a page of prose differ from those of its source.
    Numbers {
        /// Those that are missing.
        missing: String,
        /// Those that the source does not have.
        foreign: String,
    },
    /// Other variants of the same text, or segments of the same page, are missing.
    Incomplete,
    /// A check of `ciklo lint` finds something.
    Found(Box<Diagnostic>),
}

/// A unit that is not taken over.
#[derive(Clone, Debug)]
pub struct Refusal {
    /// Its identifier.
    pub id: String,
    /// Where it is in the file.
    pub at: usize,
    /// The reason.
    pub why: Why,
}

/// What came of a file.
#[derive(Debug, Default)]
pub struct Imported {
    /// The files that change, with their new texts.
    pub files: Vec<(String, String)>,
    /// The identifiers of the units that are taken over.
    pub taken: Vec<String>,
    /// The keys of the texts whose units were all final, changed or not.
    pub confirmed: Vec<String>,
    /// How many final units are as they were.
    pub unchanged: usize,
    /// How many units are not final.
    pub passed_over: usize,
    /// What is refused.
    pub refused: Vec<Refusal>,
}
