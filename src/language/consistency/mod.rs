//! Whether the texts of all languages agree: with each other, and with the parameters that they name.
//!
//! Nothing is compared with a stored copy. A fact that a text states in one language, such as a number,
//! unit, sign, word of the code or argument, must occur in it in the others as well; a label must
//! not be that of another parameter; two choices of a parameter must not have changed places. Where
//! languages disagree, the majority decides which text is reported.
//! Invariant: judges texts, never changes or formats one.
mod choice;
mod fact;
mod label;
mod lexicon;
mod meaning;
mod pair;
mod term;
mod used;

pub use meaning::meanings;

use std::collections::{BTreeMap, BTreeSet};

use crate::base::diag::{Diagnostic, Place};
use crate::language::locale::{Key, Language, Locales, Scope};
use crate::spec::Catalogue;

/// Attributes whose wording is each language's own: printed labels, lists, sources.
const OWN: [&str; 12] = [
    "figure",
    "label",
    "label-aliases",
    "nc",
    "nc-aliases",
    "word",
    "prompt",
    "forms",
    "forbidden",
    "source",
    "endings",
    "symbol",
];

/// Messages whose value is a printed name.
const NAMES: [&str; 3] = ["parameter-", "cycle-", "unit-"];

/// What the languages do not agree on.
pub fn check(catalogue: &Catalogue, locales: &Locales) -> Vec<Diagnostic> {
    let mut found = Vec::new();
    facts(locales, &mut found);
    label::check(catalogue, locales, &mut found);
    pair::check(catalogue, locales, &mut found);
    lexicon::check(catalogue, locales, &mut found);
    used::check(catalogue, locales, &mut found);
    choice::check(catalogue, locales, &mut found);
    term::check(locales, &mut found);
    crate::base::diag::dedupe(&mut found);
    found
}

/// A text of a language, as its file has it.
pub(crate) struct Said<'l> {
    pub(crate) language: &'l Language,
    pub(crate) text: String,
    pub(crate) place: Place,
    /// Whether it was written for just this scope.
    pub(crate) exact: bool,
}

/// What each language says under the key in the scope.
pub(crate) fn said<'l>(locales: &'l Locales, key: Key, scope: Scope) -> Vec<Said<'l>> {
    let said = |language: &'l Language| {
        let (text, place) = language.raw(key, scope)?;
        Some(Said { language, text, place, exact: language.is_exact(key, scope) })
    };
    locales.iter().filter_map(said).collect()
}

/// Every text with every scope that any language distinguishes.
fn facts(locales: &Locales, found: &mut Vec<Diagnostic>) {
    let mut keys: BTreeSet<(String, Option<String>, Vec<String>)> = BTreeSet::new();
    for language in locales.iter() {
        for (key, suffixes) in language.keys() {
            let printed = key.attribute.is_none() && NAMES.iter().any(|prefix| key.id.starts_with(prefix));
            if !printed && key.attribute.is_none_or(|name| !OWN.contains(&name)) {
                let suffixes = suffixes.iter().map(|suffix| suffix.to_string()).collect();
                keys.insert((key.id.to_owned(), key.attribute.map(str::to_owned), suffixes));
            }
        }
    }
    for (id, attribute, suffixes) in &keys {
        let key = Key { id, attribute: attribute.as_deref() };
        let scope = match suffixes.as_slice() {
            [] => Scope::NONE,
            [one] => Scope { cycle: Some(one), control: Some(one) },
            [cycle, control, ..] => Scope::new(cycle, control),
        };
        compare(key, &said(locales, key, scope), found);
    }
}

/// Reports the texts whose facts are not those of most languages.
fn compare(key: Key, all: &[Said], found: &mut Vec<Diagnostic>) {
    if all.len() < 2 {
        return;
    }
    let stated: Vec<BTreeMap<fact::Kind, Vec<String>>> =
        all.iter().map(|said| fact::facts(&said.text, said.language.tag())).collect();
    for kind in fact::Kind::ALL {
        let of = |at: usize| stated[at].get(&kind).cloned().unwrap_or_default();
        // What was written for the scope counts before what only serves for it.
        let exact = all.iter().any(|said| said.exact);
        let voter = |at: usize| all[at].exact || !exact;
        let votes = |wanted: &[String]| (0..all.len()).filter(|at| voter(*at) && of(*at) == wanted).count();
        let mut options: Vec<Vec<String>> = (0..all.len()).map(of).collect();
        // The source language comes first among those with as many votes.
        options.sort();
        options.dedup();
        if options.len() < 2 {
            continue;
        }
        let source = all.iter().position(|said| said.language.tag() == crate::language::locale::SOURCE_LANGUAGE);
        let is_source = |option: &Vec<String>| source.is_some_and(|at| of(at) == *option);
        let Some(agreed) = options.iter().max_by_key(|option| (votes(option), is_source(option))) else { continue };
        for (at, said) in all.iter().enumerate() {
            let own = of(at);
            if own == *agreed {
                continue;
            }
            let with: Vec<&str> =
                (0..all.len()).filter(|other| of(*other) == *agreed).map(|other| all[other].language.tag()).collect();
            found.push(
                Diagnostic::error(kind.code(), said.place.clone())
                    .arg("key", key.to_string())
                    .arg("language", said.language.tag())
                    .arg("found", shown(&own, agreed))
                    .arg("expected", shown(agreed, &own))
                    .arg("others", with.join(", ")),
            );
        }
    }
}

/// What is in the one list and not in the other, for a message.
fn shown(own: &[String], other: &[String]) -> String {
    let mut rest = other.to_vec();
    let mut more = Vec::new();
    for fact in own {
        match rest.iter().position(|known| known == fact) {
            Some(at) => {
                rest.swap_remove(at);
            }
            None => more.push(fact.as_str()),
        }
    }
    if more.is_empty() { "\u{2013}".to_owned() } else { more.join(", ") }
}
