//! A language in the making, whole enough to be read: what is missing is the source text, with marks around it.
//!
//! Invariant: nothing of this is a translation, and nothing is written; labels and names in NC programs, which may have no
//! such marks, are those of the source.
use super::fluent::{Piece, merged};
use super::import::filled;
use super::prose;
use super::unit::{self, Unit};
use crate::language::locale::{LocaleError, Locales};

/// What is around a text that is not translated.
const MARKS: (&str, &str) = ("\u{27e6}", "\u{27e7}");
/// So often gaps are looked for again.
const ROUNDS: usize = 3;
/// Ends of keys of texts that are printed in NC programs, or symbols.
const BARE: [&str; 5] = [".label", ".nc", ".word", ".symbol", ".more"];
/// Beginnings of keys of texts that are the same in all languages, or join others.
const SYMBOLS: [&str; 2] = ["unit-", "list-"];

/// The files with the gaps of a language filled, and how many texts were missing.
///
/// # Errors
/// If the source language was not loaded.
pub fn draft(files: &[(String, String)], tag: &str) -> Result<(Vec<(String, String)>, usize), LocaleError> {
    let (mut files, mut missing) = filled_once(files, tag)?;
    // What was filled in may serve where the source has another text.
    for _ in 0..ROUNDS {
        let (more, count) = filled_once(&files, tag)?;
        if count == 0 {
            break;
        }
        (files, missing) = (more, missing + count);
    }
    Ok((files, missing))
}

fn filled_once(files: &[(String, String)], tag: &str) -> Result<(Vec<(String, String)>, usize), LocaleError> {
    let (locales, _) = Locales::load(files.iter().map(|(path, text)| (path, text)));
    let texts = unit::texts(&locales, tag)?;
    let missing = texts.iter().filter(|text| text.target.is_none()).count();
    let mut changed = filled(files, &texts, tag, &|unit| marked(unit));
    let pages = prose::gaps(&locales, tag, MARKS);
    let missing = missing + pages.len();
    changed.extend(pages);
    let kept = files.iter().filter(|(path, _)| !changed.iter().any(|(own, _)| own == path)).cloned();
    Ok((kept.chain(changed.iter().cloned()).collect(), missing))
}

fn marked(unit: &Unit) -> Vec<Piece> {
    let bare = BARE.iter().any(|end| unit.key.ends_with(end))
        || SYMBOLS.iter().any(|head| unit.message.starts_with(head))
        || unit.message.starts_with('-');
    let mut pieces = unit.source.clone();
    if !bare {
        pieces.insert(0, Piece::Text(MARKS.0.to_owned()));
        pieces.push(Piece::Text(MARKS.1.to_owned()));
    }
    merged(pieces)
}
