//! Translations that have got the words of another text since they were accepted: two lines that changed places, or one
//! that was copied to where it does not belong.
//!
//! The record of accepted translations says which words belong to which text. Texts that say the same in English may
//! get the same words. Invariant: a language without an edit since its texts were accepted has none.
use std::collections::{BTreeMap, HashMap};

use super::audit::{Text, counterpart, digest, hash, texts, written};
use super::language::Language;

/// The keys of such texts, each with the key of the text whose words it has.
pub(super) fn moved(source: &Language, translation: &Language) -> BTreeMap<String, String> {
    let Some(lock) = translation.lock.as_ref() else { return BTreeMap::new() };
    let all = texts(translation);
    let number = |text: &Text| digest(&written(text.pattern));
    let is_edited = |text: &&Text| {
        let then = lock.0.get(&text.key).and_then(|recorded| recorded.translation);
        then.is_some_and(|then| then != number(text))
    };
    let edited: Vec<&Text> = all.iter().filter(is_edited).collect();
    if edited.is_empty() {
        return BTreeMap::new();
    }
    let said = |text: &Text| counterpart(source, text).and_then(|form| source.pattern(form)).map(hash);
    let mut accepted: HashMap<u32, Vec<&Text>> = HashMap::new();
    for text in &all {
        if let Some(then) = lock.0.get(&text.key).and_then(|recorded| recorded.translation) {
            accepted.entry(then).or_default().push(text);
        }
    }
    let mut found = BTreeMap::new();
    for text in edited {
        let owners = accepted.get(&number(text)).map(Vec::as_slice).unwrap_or_default();
        let alike = |other: &&Text| other.attribute == text.attribute;
        let mut owners = owners.iter().copied().filter(alike).peekable();
        let Some(other) = owners.peek().copied() else { continue };
        if owners.all(|owner| said(owner) != said(text)) {
            found.insert(text.key.clone(), other.key.clone());
        }
    }
    found
}
