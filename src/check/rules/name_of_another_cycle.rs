//! A definition with the printed name of another cycle: number or name is not the one that is meant.
//!
//! Controls read the number only. Silent where the name is one of the cycle itself in any language, or is none that is
//! known. Cycles that the control's manuals only name are known by that name and by those that another control's
//! manuals have; there a name that is a part of an own one, or has an own one in it, is left alone, too.
use super::together;
use crate::check::labels::fold;
use crate::check::{Definition, Facts, Rule};
use crate::diag::{Diagnostic, Severity};
use crate::spec::{CycleKey, Known};

pub(super) const RULE: Rule = Rule { code: "name-of-another-cycle", severity: Severity::Warning, run: together };

pub(super) fn each(rule: &Rule, facts: &Facts<'_>, definition: &Definition<'_>, found: &mut Vec<Diagnostic>) {
    if facts.has_usual_labels(definition) {
        return;
    }
    let Some(span) = definition.view.name else { return };
    let name = facts.text(span);
    let folded = fold(name);
    if matches!(definition.known, Known::Named(_)) {
        if let Some(other) = named_elsewhere(facts, definition.key, &folded) {
            let finding = rule.at(facts, span).arg("name", name).arg("cycle", definition.key.to_string());
            found.push(finding.arg("other", other.to_string()));
        }
        return;
    }
    let Some(labels) = facts.labels(definition) else { return };
    if folded.is_empty() || labels.languages.iter().any(|own| own.name.matches_folded(&folded)) {
        return;
    }
    let [other, ..] = facts.against.labels.named(&folded) else { return };
    let finding = rule.at(facts, span).arg("name", name).arg("cycle", definition.key.to_string());
    found.push(finding.arg("other", other.to_string()));
}

/// The other cycle that the name of one that the control's manuals only name belongs to.
fn named_elsewhere(facts: &Facts<'_>, key: CycleKey, folded: &str) -> Option<CycleKey> {
    let is_own = |own: &str| own.contains(folded) || folded.contains(own);
    if folded.is_empty() || has_name(facts, key, is_own) {
        return None;
    }
    let named = facts.against.on.control.named.iter().map(|own| CycleKey::new(own.keyword, own.number));
    named
        .filter(|other| *other != key && other.keyword == key.keyword)
        .find(|other| has_name(facts, *other, |own| own == folded))
}

/// Whether one of the names of a cycle, as the overviews of the control's manuals or another control's manuals in any
/// language have it, is such.
fn has_name(facts: &Facts<'_>, key: CycleKey, is: impl Fn(&str) -> bool) -> bool {
    let against = &facts.against;
    if against.on.named(key).is_some_and(|named| is(&fold(&named.name))) {
        return true;
    }
    let Some((on, cycle)) = against.catalogue.describing(key) else { return false };
    let labels = against.labels.labels_elsewhere(on, cycle);
    labels.languages.iter().any(|language| language.name.any_folded(&is))
}
