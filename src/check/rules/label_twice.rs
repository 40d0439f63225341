//! Two parameters of a definition with the same label: one of them is another one's.
//!
//! Looked at where the label is in no language that is loaded, or no manual of the control describes the cycle. Silent
//! where a language calls both parameters the same, and where another cycle of the program has the same label at both:
//! then it is the language that does.
use std::borrow::Cow;
use std::collections::HashMap;

use super::together;
use crate::base::diag::{Diagnostic, Place, Severity};
use crate::base::expr::QRef;
use crate::check::cycle::fold;
use crate::check::{CycleLabels, Definition, Facts, Item, Rule, is_label};
use crate::program::syntax::CycleForm;
use crate::spec::Known;

pub(super) const RULE: Rule = Rule { code: "label-twice", severity: Severity::Warning, run: together };

/// So many definitions of other cycles are looked through.
const FEW: usize = 64;

pub(super) fn each(rule: &Rule, facts: &Facts<'_>, definition: &Definition<'_>, found: &mut Vec<Diagnostic>) {
    if matches!(definition.view.form, CycleForm::Lines(_)) || facts.has_usual_labels(definition) {
        return;
    }
    if matches!(definition.known, Known::Builders) {
        return;
    }
    let most = facts.against.on.control.label.max_length;
    let mut seen: HashMap<(usize, Cow<'_, str>), Seen<'_, '_>> = HashMap::new();
    for item in &definition.items {
        let Some(label) = item.label.map(|label| facts.text(label)) else { continue };
        let printed = label.trim();
        let Some(first) = seen.entry((printed.len(), fold(label))).or_default().before(item) else { continue };
        if !is_label(printed, most)
            || is_known(facts, definition, item, printed)
            || is_called_so(facts, definition, first, item)
            || is_repeated(facts, definition, [first, item], printed)
        {
            continue;
        }
        for (own, other) in [(first, item), (item, first)] {
            let place = Place::new(facts.program.source(), other.span);
            let finding = rule.at(facts, own.label.unwrap_or(own.span)).arg("label", printed);
            let finding = finding.arg("parameter", own.name.as_ref()).arg("other", other.name.as_ref());
            found.push(finding.related("other-place", place));
        }
    }
}

/// The parameters with a label, as far as the next one asks for them.
#[derive(Default)]
struct Seen<'i, 'a> {
    first: Option<&'i Item<'a>>,
    /// The first one that is another parameter than the first.
    other: Option<&'i Item<'a>>,
}

impl<'i, 'a> Seen<'i, 'a> {
    /// The first parameter that had the label before and is another one. From here on this one has had it, too.
    fn before(&mut self, item: &'i Item<'a>) -> Option<&'i Item<'a>> {
        let first = *self.first.get_or_insert(item);
        if first.name == item.name {
            return self.other;
        }
        self.other.get_or_insert(item);
        Some(first)
    }
}

/// Whether the label is reported by a rule of its own: a language has it for one of the cycle's parameters.
fn is_known(facts: &Facts<'_>, definition: &Definition<'_>, item: &Item<'_>, printed: &str) -> bool {
    let folded = fold(printed);
    let has = |labels: &CycleLabels| {
        labels.languages.iter().any(|language| language.params.iter().any(|own| own.matches_folded(&folded)))
    };
    item.index.is_some() && facts.labels(definition).is_some_and(has)
}

/// Whether a definition of another cycle has the label at both parameters.
fn is_repeated(facts: &Facts<'_>, definition: &Definition<'_>, pair: [&Item<'_>; 2], printed: &str) -> bool {
    let wanted = fold(printed);
    let others = facts.definitions.iter().filter(|own| own.key != definition.key).take(FEW);
    others.map(|own| facts.read(own)).any(|other| {
        pair.iter().all(|own| {
            let there = other.items.iter().find(|item| item.name == own.name).and_then(|item| item.label);
            there.is_some_and(|label| fold(facts.text(label).trim()) == wanted)
        })
    })
}

/// Whether the labels of both parameters are the same in a language.
fn is_called_so(facts: &Facts<'_>, definition: &Definition<'_>, first: &Item<'_>, second: &Item<'_>) -> bool {
    let same = |labels: &CycleLabels, one: usize, other: usize| {
        labels.languages.iter().any(|language| {
            let label = |at: usize| language.params.get(at).and_then(|own| own.label.as_deref()).map(fold);
            label(one).is_some() && label(one) == label(other)
        })
    };
    if let (Some(labels), Some(one), Some(other)) = (facts.labels(definition), first.index, second.index) {
        return same(labels, one, other);
    }
    let Some((on, cycle)) = facts.against.catalogue.describing(definition.key) else { return false };
    let place = |item: &Item<'_>| cycle.place_of(QRef::parse(&item.name)?);
    let labels = facts.against.labels.labels_elsewhere(on, cycle);
    place(first).zip(place(second)).is_none_or(|(one, other)| same(&labels, one, other))
}
