//! What was translated, for the memories of translation tools: TMX of all accepted texts.
//!
//! An entry is a text and not a string: two texts with the same words are two entries, each with its key and, as its
//! concept, the message that it belongs to.
use std::collections::{BTreeMap, HashMap};
use std::fmt::Write as _;

use quick_xml::escape::escape;

use super::fluent::Piece;
use super::unit::{Unit, units};
use crate::language::locale::{LocaleError, Locales, Meanings, SOURCE_LANGUAGE};

/// A text in the languages in which it is accepted.
#[derive(Clone, Debug)]
pub struct Entry {
    /// The unit of the source language; its state and notes are empty.
    pub unit: Unit,
    /// The translations by tag.
    pub translations: BTreeMap<String, Vec<Piece>>,
}

/// All texts with their accepted translations into these languages, in the order of the source files.
///
/// # Errors
/// If the source language was not loaded.
pub fn entries(locales: &Locales, meanings: &Meanings, tags: &[String]) -> Result<Vec<Entry>, LocaleError> {
    let mut all: Vec<Entry> = Vec::new();
    let mut places: HashMap<String, usize> = HashMap::new();
    for tag in tags {
        for unit in units(locales, meanings, tag)?.into_iter().filter(|unit| unit.state.is_none()) {
            let place = *places.entry(unit.id.clone()).or_insert_with(|| {
                let own = Unit { target: Vec::new(), notes: Vec::new(), ..unit.clone() };
                all.push(Entry { unit: own, translations: BTreeMap::new() });
                all.len() - 1
            });
            if let Some(entry) = all.get_mut(place) {
                entry.translations.insert(tag.clone(), unit.target);
            }
        }
    }
    Ok(all)
}

/// The entries as a translation memory, TMX 1.4.
pub fn tmx(entries: &[Entry]) -> String {
    let mut text = format!(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<tmx version=\"1.4\">\n  <header creationtool=\"ciklo\" creationtoolversion=\"{}\" segtype=\"block\" o-tmf=\"Fluent\" adminlang=\"{SOURCE_LANGUAGE}\" srclang=\"{SOURCE_LANGUAGE}\" datatype=\"plaintext\"/>\n  <body>\n",
        env!("CARGO_PKG_VERSION")
    );
    for entry in entries {
        let unit = &entry.unit;
        let _ = writeln!(text, "    <tu tuid=\"{}\">", escape(&unit.id));
        let _ = writeln!(text, "      <prop type=\"x-concept\">{}</prop>", escape(&unit.message));
        let _ = writeln!(text, "      <prop type=\"x-file\">{}</prop>", escape(&unit.file));
        variant(&mut text, SOURCE_LANGUAGE, &unit.source);
        for (tag, pieces) in &entry.translations {
            variant(&mut text, tag, pieces);
        }
        text += "    </tu>\n";
    }
    text + "  </body>\n</tmx>\n"
}

fn variant(text: &mut String, tag: &str, pieces: &[Piece]) {
    let _ = write!(text, "      <tuv xml:lang=\"{}\"><seg>", escape(tag));
    let mut codes: Vec<&str> = Vec::new();
    for piece in pieces {
        match piece {
            Piece::Text(words) => *text += &escape(words),
            Piece::Code(code) => {
                // The same code has the same number in all languages as far as it stands in the same place there.
                let number = codes.iter().position(|own| own == code).unwrap_or_else(|| {
                    codes.push(code);
                    codes.len() - 1
                });
                let _ = write!(text, "<ph x=\"{}\">{}</ph>", number + 1, escape(code));
            }
        }
    }
    *text += "</seg></tuv>\n";
}
