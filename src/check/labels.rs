//! The labels of a control's cycles in all languages, and the language of a program.
//!
//! Invariant: a text that a language lacks matches nothing; labels are compared without regard to
//! case and blanks, as programs come from many hands.
use std::borrow::Cow;
use std::collections::BTreeMap;
use std::sync::OnceLock;

use super::facts::Facts;
use crate::locale::{Language, Locales};
use crate::spec::{Cycle, CycleKey, OnControl};
use crate::text::{CycleText, Vocabulary};

/// The labels of a control, put together when a cycle is first asked for.
pub struct LabelBook<'a> {
    on: &'a OnControl,
    locales: &'a Locales,
    cycles: BTreeMap<CycleKey, OnceLock<CycleLabels>>,
}

/// The labels of a cycle in all languages, in the order of their tags.
#[derive(Debug)]
pub struct CycleLabels {
    /// The labels in each language.
    pub languages: Vec<LanguageLabels>,
}

/// The labels of a cycle in a language.
#[derive(Debug)]
pub struct LanguageLabels {
    /// The tag of the language.
    pub tag: String,
    /// The name in NC blocks and its printed variants.
    pub name: ParamLabels,
    /// The labels of the parameters, in the order of the cycle's.
    pub params: Vec<ParamLabels>,
}

/// A label with its variants.
#[derive(Debug, Default)]
pub struct ParamLabels {
    /// The label as it is printed; the printed word of an old-style field.
    pub label: Option<String>,
    /// It and its variants, folded.
    folded: Vec<String>,
}

impl ParamLabels {
    fn new(label: Option<String>, aliases: Vec<String>) -> Self {
        let label = label.filter(|label| !label.is_empty());
        let folded = label.iter().chain(&aliases).map(|label| fold(label).into_owned()).collect();
        Self { label, folded }
    }

    /// Whether a printed label is this one.
    pub fn matches(&self, printed: &str) -> bool {
        self.matches_folded(&fold(printed))
    }

    /// Whether a label made ready by [`fold`] is this one.
    pub(super) fn matches_folded(&self, printed: &str) -> bool {
        self.folded.iter().any(|own| own == printed)
    }
}

/// A label for comparison: capitals, single blanks, no colon at the end.
pub(super) fn fold(label: &str) -> Cow<'_, str> {
    if is_folded(label) { Cow::Borrowed(label) } else { Cow::Owned(folded(label)) }
}

/// Whether nothing has to change: most labels are printed in capitals, with single blanks.
fn is_folded(label: &str) -> bool {
    let mut before = b' ';
    for &byte in label.as_bytes() {
        if byte.is_ascii_lowercase() || byte.is_ascii_control() || (byte == b' ' && before == b' ') {
            return false;
        }
        before = byte;
    }
    !matches!(before, b' ' | b':')
        && (label.is_ascii() || label.chars().all(|c| c.is_ascii() || !(c.is_lowercase() || c.is_whitespace())))
}

fn folded(label: &str) -> String {
    let mut folded = String::with_capacity(label.len());
    for word in label.split_whitespace() {
        if !folded.is_empty() {
            folded.push(' ');
        }
        folded.push_str(word);
    }
    folded.truncate(folded.trim_end_matches(':').len());
    if folded.is_ascii() {
        folded.make_ascii_uppercase();
        return folded;
    }
    folded.to_uppercase()
}

impl<'a> LabelBook<'a> {
    /// The labels of a control in all languages that are loaded.
    pub fn new(on: &'a OnControl, locales: &'a Locales) -> Self {
        Self { on, locales, cycles: on.cycles.keys().map(|key| (*key, OnceLock::new())).collect() }
    }

    /// The labels of a cycle; nothing if the control does not describe it.
    pub fn cycle(&self, key: CycleKey) -> Option<&CycleLabels> {
        let cycle = self.on.cycles.get(&key)?;
        Some(self.cycles.get(&key)?.get_or_init(|| CycleLabels {
            languages: self.locales.iter().map(|language| labels(self.on, cycle, language)).collect(),
        }))
    }
}

fn labels(on: &OnControl, cycle: &Cycle, language: &Language) -> LanguageLabels {
    let vocabulary = Vocabulary::of(on, cycle, language);
    let text = CycleText::new(on, cycle, language, &vocabulary);
    let own = |text: &CycleText<'_>, param| {
        ParamLabels::new(text.label_of(param).map(|label| label.into_owned()), text.label_aliases_of(param))
    };
    LanguageLabels {
        tag: language.tag().to_owned(),
        name: ParamLabels::new(Some(text.nc_name().into_owned()), text.nc_name_aliases()),
        params: cycle.params.iter().map(|param| own(&text, param)).collect(),
    }
}

impl CycleLabels {
    /// The labels in a language.
    pub fn language(&self, tag: &str) -> Option<&LanguageLabels> {
        self.languages.iter().find(|language| language.tag == tag)
    }
}

/// The language that most of the program's names and labels belong to; among equals the language of
/// the control's manual.
pub(super) fn language_of(facts: &Facts<'_>) -> Option<String> {
    let mut votes: BTreeMap<&str, usize> = BTreeMap::new();
    for (definition, _) in facts.described() {
        let Some(labels) = facts.labels(definition) else { continue };
        let name = definition.view.name.map(|name| fold(facts.text(name)));
        for language in &labels.languages {
            let named = name.as_ref().is_some_and(|name| language.name.matches_folded(name));
            let labelled = definition.items.iter().filter(|item| {
                let own = item.index.and_then(|index| language.params.get(index));
                item.folded.as_ref().zip(own).is_some_and(|(label, own)| own.matches_folded(label))
            });
            *votes.entry(&language.tag).or_default() += labelled.count() + usize::from(named);
        }
    }
    let manual = facts.against.on.control.language.as_str();
    let best = votes.into_iter().filter(|(_, count)| *count > 0).max_by_key(|(tag, count)| (*count, *tag == manual));
    best.map(|(tag, _)| tag.to_owned())
}
