//! The language of a definition's name and labels.
//!
//! Invariant: labels that have the form of a control's own and that no loaded language has are foreign, not wrong.
use std::borrow::Cow;

use super::Facts;
use super::cycle::{CycleLabels, LanguageLabels, fold, is_label};
use super::program::{Defined, Definition};
use crate::program::syntax::CycleForm;

/// What a definition's name and labels are in.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Speech {
    /// It has none, or none that says a language.
    Silent,
    /// A language that is loaded, by its tag.
    In(String),
    /// A language that is not: it has the labels that a control writes, and no language here has them.
    Foreign,
}

/// Whether a definition without comments has a name in a language that is not loaded. Older software has names of its
/// own, so that alone says nothing of a program of which the language is known otherwise.
fn is_foreign_name<'a>(facts: &Facts<'a>, definition: &Definition<'a>, labels: &CycleLabels) -> bool {
    let known = |name: &str| labels.languages.iter().any(|language| language.name.matches(name));
    let most = facts.against.on.control.label.max_length;
    let silent = !definition.torn && definition.items.iter().all(|item| item.label.is_none() && item.index.is_some());
    silent && definition.view.name.map(|name| facts.text(name)).is_some_and(|name| is_label(name, most) && !known(name))
}

/// Whether the name and the only label of a definition have the form of a control's own, and no loaded language has either.
fn is_foreign_single<'a>(facts: &Facts<'a>, definition: &Definition<'a>, labels: &CycleLabels) -> bool {
    let most = facts.against.on.control.label.max_length;
    let ([item], Some(name)) = (definition.items.as_slice(), definition.view.name) else { return false };
    let Some(label) = item.label.filter(|_| item.index.is_some() && !definition.torn) else { return false };
    let (name, label) = (facts.text(name), facts.text(label));
    let known = labels
        .languages
        .iter()
        .any(|own| own.name.matches(name) || own.params.iter().any(|param| param.matches(label)));
    !known && is_label(name, most) && is_label(label, most)
}

/// Whether any definition has labels in a language that is not loaded.
fn foreign_labels(facts: &Facts<'_>) -> bool {
    let any = || facts.readings().any(|own| facts.labels(&own).is_some_and(|labels| is_foreign(facts, &own, labels)));
    *facts.foreign.get_or_init(any)
}

/// How many of a definition's names and labels each language has.
fn votes<'a, 'l>(facts: &Facts<'a>, definition: &Definition<'a>, labels: &'l CycleLabels) -> Vec<(&'l str, usize)> {
    let name = definition.view.name.map(|name| fold(facts.text(name)));
    let count = |language: &LanguageLabels| {
        let named = name.as_ref().is_some_and(|name| language.name.matches_folded(name));
        let labelled = definition.items.iter().filter(|item| {
            let own = item.index.and_then(|index| language.params.get(index));
            item.label.zip(own).is_some_and(|(label, own)| own.matches(facts.text(label)))
        });
        labelled.count() + usize::from(named)
    };
    labels.languages.iter().map(|language| (language.tag.as_str(), count(language))).collect()
}

/// The language of a definition's name and labels. Among equals it is the program's, or that of the control's manual.
pub fn speech<'a>(facts: &Facts<'a>, definition: &Definition<'a>) -> Speech {
    let Some(labels) = facts.labels(definition) else { return Speech::Silent };
    if is_foreign(facts, definition, labels) {
        return Speech::Foreign;
    }
    if is_foreign_name(facts, definition, labels) && (facts.language.is_none() || foreign_labels(facts)) {
        return Speech::Foreign;
    }
    if is_foreign_single(facts, definition, labels) && (facts.language.is_none() || foreign_labels(facts)) {
        return Speech::Foreign;
    }
    let (own, manual) = (facts.language.as_deref(), facts.against.on.control.language.as_str());
    let votes = votes(facts, definition, labels).into_iter().filter(|(_, count)| *count > 0);
    let best = votes.max_by_key(|(tag, count)| (*count, Some(*tag) == own, *tag == manual));
    best.map_or(Speech::Silent, |(tag, _)| Speech::In(tag.to_owned()))
}

/// Whether a definition says nothing in another language than the program: it has no labels, or its name and labels are
/// letter by letter those of the language. Most definitions of long programs are such.
pub(super) fn is_in_own_language(facts: &Facts<'_>, definition: &Defined<'_>) -> bool {
    let Some(kept) = definition.kept.filter(|_| definition.cycle().is_some()) else { return true };
    let unlabelled = matches!(definition.view.form, CycleForm::Lines(_)) && !kept.labelled;
    unlabelled || facts.has_usual_labels(definition)
}

/// Whether a definition is one that a control wrote in a language that is not loaded.
///
/// Of its parameters at most one of eight is not the cycle's own: newer software has more of them. Two or more and at
/// least half of them have a comment, three of four comments have the form of labels, and at most one of four is a
/// label in a language that is loaded.
fn is_foreign<'a>(facts: &Facts<'a>, definition: &Definition<'a>, labels: &CycleLabels) -> bool {
    let most = facts.against.on.control.label.max_length;
    let items = &definition.items;
    let added = items.iter().filter(|item| item.index.is_none()).count();
    if definition.torn || added * 8 > items.len() {
        return false;
    }
    let known_name = |name: &str| labels.languages.iter().any(|language| language.name.matches(name));
    let name = definition.view.name.map(|name| facts.text(name));
    let written: Vec<Cow<'_, str>> =
        items.iter().filter_map(|item| item.label).map(|label| fold(facts.text(label))).collect();
    let is_known = |label: &&Cow<'_, str>| {
        labels.languages.iter().any(|own| own.params.iter().any(|param| param.matches_folded(label)))
    };
    let (known, shaped) = (
        written.iter().filter(is_known).count(),
        items.iter().filter(|item| item.label.is_some_and(|label| is_label(facts.text(label), most))).count(),
    );
    let enough = written.len() > 1 && written.len() * 2 >= items.len();
    enough && known * 4 <= written.len() && shaped * 4 >= written.len() * 3 && !name.is_some_and(known_name)
}
