//! A definition with the printed name of another cycle: number or name is not the one that is meant.
//!
//! Controls read the number only. Silent where the name is one of the cycle itself in any language, or is none that is
//! known.
use super::together;
use crate::check::labels::fold;
use crate::check::{Definition, Facts, Rule};
use crate::diag::{Diagnostic, Severity};

pub(super) const RULE: Rule = Rule { code: "name-of-another-cycle", severity: Severity::Warning, run: together };

pub(super) fn each(rule: &Rule, facts: &Facts<'_>, definition: &Definition<'_>, found: &mut Vec<Diagnostic>) {
    if facts.has_usual_labels(definition) {
        return;
    }
    let (Some(span), Some(labels)) = (definition.view.name, facts.labels(definition)) else { return };
    let name = facts.text(span);
    let folded = fold(name);
    if folded.is_empty() || labels.languages.iter().any(|own| own.name.matches_folded(&folded)) {
        return;
    }
    let [other, ..] = facts.against.labels.named(&folded) else { return };
    let finding = rule.at(facts, span).arg("name", name).arg("cycle", definition.key.to_string());
    found.push(finding.arg("other", other.to_string()));
}
