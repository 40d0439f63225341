//! Whether the name of a parameter speaks of what the specification says that it measures.
//!
//! Each language lists the words that name a quantity or a reference (`lexicon-angle`,
//! `lexicon-absolute`), pieces of words separated by ` | `. A name that contains words of others and
//! none of its own contradicts the specification. What a name says of a place (`lexicon-place`: "pause at half depth") is not
//! what it measures. Invariant: a name without any such word says nothing.
use std::collections::BTreeSet;

use crate::base::diag::Diagnostic;
use crate::language::locale::{Key, Language, Locales, Scope};
use crate::spec::{Catalogue, Cycle, OnControl, Param, Quantity, Reference};

/// The words of a language for one kind.
struct Words {
    kind: &'static str,
    words: Vec<String>,
}

/// Quantities that names speak of.
const QUANTITIES: [Quantity; 7] = [
    Quantity::Length,
    Quantity::Angle,
    Quantity::Feed,
    Quantity::Time,
    Quantity::Speed,
    Quantity::Count,
    Quantity::Factor,
];
/// The words that say where.
const PLACE: &str = "place";
const REFERENCES: [Reference; 2] = [Reference::Absolute, Reference::Incremental];

/// Reports names that contradict the quantity or the reference of their parameter.
pub(super) fn check(catalogue: &Catalogue, locales: &Locales, found: &mut Vec<Diagnostic>) {
    for language in locales.iter() {
        let quantities = lexicon(language, QUANTITIES.iter().map(|quantity| quantity.as_str()));
        let places = listed(language, PLACE);
        let references = lexicon(language, REFERENCES.iter().map(|reference| reference.as_str()));
        let mut seen = BTreeSet::new();
        for on in catalogue.controls.values() {
            for cycle in on.cycles.values() {
                for param in &cycle.params {
                    let kinds = (param.quantity.as_str(), param.reference.map(Reference::as_str));
                    let texts = Texts::of(language, (catalogue, on), cycle, param);
                    if !texts.explained && seen.insert((param.is.text.to_string(), texts.name.clone(), kinds)) {
                        let measured = Texts { name: without_place(&texts.name, &places), ..texts.clone() };
                        judge(&measured, param, kinds.0, &quantities, "consistency-quantity", found);
                        if let Some(reference) = kinds.1 {
                            judge(&texts, param, reference, &references, "consistency-reference", found);
                        }
                    }
                }
            }
        }
    }
}

fn lexicon(language: &Language, kinds: impl Iterator<Item = &'static str>) -> Vec<Words> {
    let words = |kind| Words { kind, words: listed(language, kind) };
    kinds.map(words).filter(|words| !words.words.is_empty()).collect()
}

/// The words of a language for one kind; none if it lists none.
fn listed(language: &Language, kind: &str) -> Vec<String> {
    let list = language.plain(&format!("lexicon-{kind}"), &Scope::NONE).unwrap_or_default();
    list.split('|').map(|word| word.trim().to_lowercase()).filter(|word| !word.is_empty()).collect()
}

/// A name without what a word of place says, up to a colon or comma, and without words that end like one (`-ssa`). Its
/// first word stays.
fn without_place(name: &str, places: &[String]) -> String {
    let mut kept: Vec<&str> = Vec::new();
    let mut in_place = false;
    for word in name.split_whitespace() {
        let ends = |place: &String| place.strip_prefix('-').is_some_and(|ending| word.ends_with(ending));
        in_place |= !kept.is_empty() && places.iter().any(|place| place == word);
        if !in_place && (kept.is_empty() || !places.iter().any(ends)) {
            kept.push(word);
        }
        in_place &= !word.ends_with([':', ',']);
    }
    kept.join(" ")
}

/// What a language says of a parameter.
#[derive(Clone)]
struct Texts<'l> {
    language: &'l Language,
    id: String,
    name: String,
    /// Whether the errata say that the name is meant so.
    explained: bool,
    scope: (String, String),
}

impl<'l> Texts<'l> {
    fn of(language: &'l Language, (catalogue, on): (&Catalogue, &OnControl), cycle: &Cycle, param: &Param) -> Self {
        let id = format!("parameter-{}", param.is.as_str());
        let scope = Scope::new(cycle.name(), on.id());
        let name = language.raw(Key { id: &id, attribute: None }, scope);
        let name = name.map(|(text, _)| text.to_lowercase()).unwrap_or_default();
        let explained = catalogue.explains(on, cycle, param);
        Self { language, name, explained, scope: (cycle.name().to_owned(), on.id().to_owned()), id }
    }
}

fn judge(
    texts: &Texts,
    param: &Param,
    own: &'static str,
    lexicon: &[Words],
    code: &'static str,
    found: &mut Vec<Diagnostic>,
) {
    // Quantities without words, such as plain numbers, cannot be contradicted.
    if !lexicon.iter().any(|words| words.kind == own) {
        return;
    }
    let speaks = |words: &Words, text: &str| words.words.iter().any(|word| text.contains(word.as_str()));
    let others: Vec<&str> = lexicon.iter().filter(|words| speaks(words, &texts.name)).map(|words| words.kind).collect();
    if others.is_empty() || others.contains(&own) {
        return;
    }
    let scope = Scope::new(&texts.scope.0, &texts.scope.1);
    let place = texts.language.raw(Key { id: &texts.id, attribute: None }, scope).map(|(_, place)| place);
    let diagnostic = Diagnostic::error(code, param.is.place.clone())
        .arg("language", texts.language.tag())
        .arg("parameter", texts.id.as_str())
        .arg("name", texts.name.as_str())
        .arg("found", own)
        .arg("expected", others.join(", "));
    found.push(match place {
        Some(place) => diagnostic.related("said-here", place),
        None => diagnostic,
    });
}
