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
mod negation;
mod pair;
mod term;
mod used;

pub use meaning::meanings;
pub use negation::Negation;

use std::collections::{BTreeMap, BTreeSet};

use crate::base::diag::{Arg, Diagnostic, Place};
use crate::base::parallel;
use crate::language::locale::{Key, Language, Locales, Scope};
use crate::spec::Catalogue;

/// Attributes whose wording is each language's own: printed labels, lists, sources.
const OWN: [&str; 11] = [
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

/// A language has no variant of a text where the source has one with other facts.
pub const VARIANT: &str = "consistency-variant";

/// Two texts seem to have changed places in a language.
pub const SWAPPED: &str = "consistency-swapped";

/// One thing that the languages are compared in.
type Check = fn(&Catalogue, &Locales, &mut Vec<Diagnostic>);

/// What an edit of a translation can change, in the order of the findings.
const OF_TRANSLATIONS: [Check; 7] = [
    |_, locales, found| facts(locales, found),
    label::check,
    pair::check,
    lexicon::check,
    choice::check,
    |_, locales, found| term::check(locales, found),
    |_, locales, found| negation::check(locales, found),
];

/// What the languages do not agree on, and parameters that no run and no text uses.
pub fn check(catalogue: &Catalogue, locales: &Locales) -> Vec<Diagnostic> {
    let all: Vec<Check> = OF_TRANSLATIONS.into_iter().chain([used::check as Check]).collect();
    found_by(&all, catalogue, locales)
}

/// What the languages do not agree on.
pub fn check_translations(catalogue: &Catalogue, locales: &Locales) -> Vec<Diagnostic> {
    found_by(&OF_TRANSLATIONS, catalogue, locales)
}

fn found_by(checks: &[Check], catalogue: &Catalogue, locales: &Locales) -> Vec<Diagnostic> {
    let found = parallel::map(checks, |check| {
        let mut found = Vec::new();
        check(catalogue, locales, &mut found);
        found
    });
    let mut found = found.concat();
    crate::base::diag::dedupe(&mut found);
    found
}

/// Labels that are the same for two meanings in one language alone: no mistake by itself, but one where an edit makes them so.
pub fn shared_labels(locales: &Locales) -> Vec<Diagnostic> {
    let mut found = Vec::new();
    label::shared(locales, &mut found);
    found
}

/// Units that may be after a number, longest first.
pub const UNITS: [&str; 6] = fact::UNITS;

/// Whether a degree sign after a number makes an ordinal of it in this language: `2° asse`, but not `5°.` The number is right
/// before the sign; `after` is what follows it.
pub fn is_ordinal(number: f64, after: &str, language: &str) -> bool {
    fact::is_ordinal(number, after.chars(), language)
}

/// How often a text says absolute or incremental, in the words of any language.
pub fn references(text: &str) -> [usize; 2] {
    fact::references(text)
}

/// Variants of source texts for which a language has only a wider text with other facts: the key, the message without
/// suffixes, and the place of the source text.
pub fn lacking(locales: &Locales, tag: &str) -> Vec<(String, String, Place)> {
    let mut found = Vec::new();
    facts(locales, &mut found);
    let is_own = |one: &Diagnostic| matches!(one.get("language"), Some(Arg::Text(language)) if language == tag);
    let lacks = found.into_iter().filter(|one| one.code == VARIANT && is_own(one)).filter_map(|one| {
        let (Some(Arg::Text(variant)), Some(source)) = (one.get("variant"), one.related.first()) else { return None };
        let message = variant.split(['.']).next().unwrap_or_default().split("__").next().unwrap_or_default();
        Some((variant.clone(), (variant.clone(), message.to_owned(), source.1.clone())))
    });
    // A text may lack several kinds of facts.
    lacks.collect::<BTreeMap<_, _>>().into_values().collect()
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

/// A message, its attribute, and for what its variant is.
type Variant = (String, Option<String>, Vec<String>);

/// All sentences with every scope that any language distinguishes.
fn keys(locales: &Locales) -> BTreeSet<Variant> {
    let mut keys = BTreeSet::new();
    for language in locales.iter() {
        for (key, suffixes) in language.keys() {
            let printed = key.attribute.is_none() && NAMES.iter().any(|prefix| key.id.starts_with(prefix));
            if !printed && key.attribute.is_none_or(|name| !OWN.contains(&name)) {
                let suffixes = suffixes.iter().map(|suffix| suffix.to_string()).collect();
                keys.insert((key.id.to_owned(), key.attribute.map(str::to_owned), suffixes));
            }
        }
    }
    keys
}

fn scope_of(suffixes: &[String]) -> Scope<'_> {
    match suffixes {
        [] => Scope::NONE,
        [one] => Scope { cycle: Some(one), control: Some(one) },
        [cycle, control, ..] => Scope::new(cycle, control),
    }
}

/// The facts of every sentence.
fn facts(locales: &Locales, found: &mut Vec<Diagnostic>) {
    for (id, attribute, suffixes) in &keys(locales) {
        let key = Key { id, attribute: attribute.as_deref() };
        let scope = scope_of(suffixes);
        let message = std::iter::once(id).chain(suffixes).map(String::as_str).collect::<Vec<_>>().join("__");
        let variant = attribute.as_ref().map_or_else(|| message.clone(), |name| format!("{message}.{name}"));
        let all = said(locales, key, scope);
        compare(key, &variant, &all, found);
        for one in variants(&all, key, scope) {
            compare(key, &variant, &one, found);
        }
    }
}

/// What the languages say in each variant of a selection that several of them have.
fn variants<'l>(all: &[Said<'l>], key: Key, scope: Scope) -> Vec<Vec<Said<'l>>> {
    let mut by_path: BTreeMap<String, Vec<Said<'l>>> = BTreeMap::new();
    for said in all {
        for (path, text) in said.language.variants(key, scope) {
            by_path.entry(path).or_default().push(Said {
                language: said.language,
                text,
                place: said.place.clone(),
                exact: said.exact,
            });
        }
    }
    by_path.into_values().collect()
}

/// Reports the texts whose facts are not those of most languages; the variant is the key with the suffixes of the scope.
fn compare(key: Key, variant: &str, all: &[Said], found: &mut Vec<Diagnostic>) {
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
            // A text that serves for a scope in which the source has one of its own is not wrong: another one is missing.
            let lacks = !said.exact && source.is_some_and(|at| all[at].exact);
            let code = if lacks { VARIANT } else { kind.code() };
            let report = Diagnostic::error(code, said.place.clone());
            let report = match source.filter(|_| lacks).and_then(|at| all.get(at)) {
                Some(source) => report.arg("variant", variant).related("said-here", source.place.clone()),
                None => report,
            };
            found.push(
                report
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
