//! The languages of Ciklo: one wrapper around Fluent, with the numbers, units, lists and order of
//! each language.
//!
//! A directory `locales/<language>/` with Fluent files is a language; nothing in Rust lists them.
//! Texts vary by cycle and control (`id__cycle__control`), and every failure to format is an error
//! value, never text. Invariant: this module knows no cycle, no specification and no file system; it
//! is handed files and plain keys. See `docs/locale-files.md` for the form of the files.
mod accept;
mod args;
mod audit;
mod check;
mod collation;
mod entries;
mod error;
mod function;
mod index;
mod language;
mod load;
mod lock;
mod moved;
mod number;
mod pattern;
pub mod render;
mod ui;

use std::collections::BTreeMap;
use std::sync::Arc;

pub use accept::{Accept, Accepted};
pub use args::Args;
pub use audit::{Audit, Finding, Meanings, Pair, SourceText};
pub use collation::Collation;
pub use error::{Fault, LocaleError, NO_FILE};
pub use language::{Key, Language, Scope};
pub use number::{Digits, Numbers};
pub use ui::Ui;

use crate::base::data::Prepared;
use crate::base::diag::{Arg, Diagnostic, Mistakes};

/// The tag of the source language, which all others translate.
pub const SOURCE_LANGUAGE: &str = "en";

/// All languages that were loaded. A copy shares them, and what was read of them so far.
#[derive(Clone, Debug)]
pub struct Locales {
    languages: BTreeMap<String, Arc<Language>>,
    mistakes: Mistakes,
}

impl Locales {
    /// Reads every `locales/<language>/**/*.ftl` and `locales/<language>/source.lock` among the files
    /// and passes over the rest; the path `locales/<language>/` is a language that may have no file yet. All mistakes of all files come back together; what is sound is usable.
    pub fn load<P, T>(files: impl IntoIterator<Item = (P, T)>) -> (Self, Vec<Diagnostic>)
    where
        P: AsRef<str>,
        T: AsRef<[u8]>,
    {
        let (languages, diagnostics) = load::languages(files);
        (Self { languages, mistakes: Mistakes::default() }, diagnostics)
    }

    /// The languages of the prepared files: each text is read when it is asked for, and [`Locales::mistakes`] are those
    /// of the texts that were read so far.
    pub fn open(data: &'static Prepared) -> Self {
        let mistakes = Mistakes::default();
        Self { languages: load::open(data, &mistakes), mistakes }
    }

    /// What was found in texts that were read when they were asked for.
    pub const fn mistakes(&self) -> &Mistakes {
        &self.mistakes
    }

    /// The tags of the languages, in alphabetical order.
    pub fn tags(&self) -> impl Iterator<Item = &str> {
        self.languages.keys().map(String::as_str)
    }

    /// The languages, in the order of their tags.
    pub fn iter(&self) -> impl Iterator<Item = &Language> {
        self.languages.values().map(Arc::as_ref)
    }

    /// The language with that tag.
    ///
    /// # Errors
    /// [`Fault::UnknownLanguage`] if there is none.
    pub fn language(&self, tag: &str) -> Result<&Language, LocaleError> {
        self.languages.get(tag).map(Arc::as_ref).ok_or_else(|| LocaleError::unknown_language(tag))
    }

    /// The source language; nothing if its files are not among those loaded.
    pub fn source(&self) -> Option<&Language> {
        self.languages.get(SOURCE_LANGUAGE).map(Arc::as_ref)
    }

    /// Gives findings about texts that a language lacks the place of the text in the source language, and the file in
    /// which the missing one belongs.
    pub fn place_missing(&self, found: &mut [Diagnostic]) {
        for finding in found.iter_mut().filter(|finding| finding.code == Fault::MissingText.code()) {
            let (Some(Arg::Text(language)), Some(Arg::Text(key))) = (finding.get("language"), finding.get("key"))
            else {
                continue;
            };
            let Some(place) = self.source().and_then(|source| source.place_of(Key::from(key))) else { continue };
            let file = place.source.name().replacen(&format!("/{SOURCE_LANGUAGE}/"), &format!("/{language}/"), 1);
            if language != SOURCE_LANGUAGE {
                finding.args.retain(|(name, _)| *name != "file");
                finding.args.push(("file", file.into()));
                finding.place.get_or_insert(place);
            }
        }
    }
}
