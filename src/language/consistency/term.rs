//! Whether the words of the trade are translated by the words that the glossary has for them.
//!
//! A term is `term-<id>`; `.forms` lists the beginnings under which it is found in texts, `.forbidden`
//! words that must not stand for it. Where the source text uses a term, the translation must use its own.
use std::collections::HashMap;

use crate::base::diag::Diagnostic;
use crate::language::locale::{Key, Language, Locales, Scope};

/// What the message of a term begins with.
const TERM: &str = "term-";
/// Texts in which terms are looked for.
const TEXTS: [&str; 8] = ["step-", "say-", "until-", "note-", "guard-", "choice-", "cycle-", "parameter-"];

/// Which terms, by their place, the source texts that were looked at use.
type Asked = HashMap<String, Vec<bool>>;

/// A term in a language.
struct Term<'l> {
    id: &'l str,
    word: String,
    forms: Vec<String>,
    forbidden: Vec<String>,
}

/// Reports translations without the term, and texts with a forbidden word.
pub(super) fn check(locales: &Locales, found: &mut Vec<Diagnostic>) {
    let Some(source) = locales.source() else { return };
    let terms = terms(source);
    let mut asked = Asked::default();
    for language in locales.iter() {
        let own = terms_of(language, &terms);
        for (key, suffixes) in language.keys() {
            let prose = key.attribute.is_none_or(|name| name == "help" || name == "purpose");
            let name = key.attribute.is_none() && key.id.starts_with("parameter-");
            if !prose || name || !TEXTS.iter().any(|prefix| key.id.starts_with(prefix)) {
                continue;
            }
            let scope = match suffixes {
                [] => Scope::NONE,
                [one] => Scope { cycle: Some(one), control: Some(one) },
                [cycle, control, ..] => Scope::new(cycle, control),
            };
            judge(key, scope, (source, &terms, &mut asked), (language, &own), found);
        }
    }
}

fn terms(language: &Language) -> Vec<Term<'_>> {
    let mut ids: Vec<&str> = language.ids().filter(|id| id.starts_with(TERM)).collect();
    ids.sort_unstable();
    ids.into_iter().map(|id| term(language, id)).collect()
}

/// The terms of a language in the order of those of the source.
fn terms_of<'l>(language: &Language, terms: &[Term<'l>]) -> Vec<Term<'l>> {
    terms.iter().map(|known| term(language, known.id)).collect()
}

fn term<'l>(language: &Language, id: &'l str) -> Term<'l> {
    let list = |attribute: &'static str| -> Vec<String> {
        let text = language.raw(Key { id, attribute: Some(attribute) }, Scope::NONE);
        let text = text.map(|(text, _)| text).unwrap_or_default();
        text.split('|').map(|form| form.trim().to_lowercase()).filter(|form| !form.is_empty()).collect()
    };
    let word = language.raw(Key { id, attribute: None }, Scope::NONE).map(|(text, _)| text).unwrap_or_default();
    Term { id, word, forms: list("forms"), forbidden: list("forbidden") }
}

fn judge(
    key: Key,
    scope: Scope,
    (source, terms, asked): (&Language, &[Term], &mut Asked),
    (language, own): (&Language, &[Term]),
    found: &mut Vec<Diagnostic>,
) {
    let Some((text, place)) = language.raw(key, scope) else { return };
    let text = prose(&text);
    let is_source = language.tag() == source.tag();
    let original = source.raw(key, scope).filter(|_| !is_source).map(|(text, _)| text).unwrap_or_default();
    let asked = asked.entry(original).or_insert_with_key(|original| {
        let original = prose(original);
        let is_in = |term: &Term| term.forms.iter().any(|form| has(&original, form));
        terms.iter().map(is_in).collect()
    });
    for ((term, own), asked) in terms.iter().zip(own).zip(asked) {
        let report = |code| {
            let found = Diagnostic::warning(code, place.clone()).arg("key", key.to_string());
            found.arg("language", language.tag()).arg("concept", own.id)
        };
        if let Some(word) = own.forbidden.iter().find(|word| has(&text, word)) {
            found.push(report("consistency-forbidden").arg("word", word.as_str()).arg("term", own.word.as_str()));
        }
        let answered = || own.forms.iter().any(|form| has(&text, form));
        if *asked && !own.forms.is_empty() && !answered() {
            found.push(report("consistency-term").arg("source", term.word.as_str()).arg("term", own.word.as_str()));
        }
    }
}

/// The text in lower case without its arguments, whose names are English words.
fn prose(raw: &str) -> String {
    let mut text = String::with_capacity(raw.len());
    let mut rest = raw;
    while let Some((before, inside)) = rest.split_once('‹') {
        text.push_str(before);
        text.push(' ');
        rest = inside.split_once('›').map_or("", |(_, after)| after);
    }
    text.push_str(rest);
    text.to_lowercase()
}

/// Whether the text has a word that begins so.
fn has(text: &str, form: &str) -> bool {
    let mut from = 0;
    while let Some(at) = text.get(from..).and_then(|rest| rest.find(form)) {
        let at = from + at;
        if !text[..at].ends_with(char::is_alphanumeric) {
            return true;
        }
        from = at + form.len();
    }
    false
}
