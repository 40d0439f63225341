//! A label that belongs to another parameter of the same cycle: the value may be meant for that one.
//!
//! Labels that no language has are passed over; machine builders and older software have their own.
use super::together;
use crate::base::diag::{Diagnostic, Severity};
use crate::check::cycle::fold;
use crate::check::{Definition, Facts, Rule};

pub(super) const RULE: Rule = Rule { code: "label-of-another-parameter", severity: Severity::Warning, run: together };

pub(super) fn each(rule: &Rule, facts: &Facts<'_>, definition: &Definition<'_>, found: &mut Vec<Diagnostic>) {
    if facts.has_usual_labels(definition) {
        return;
    }
    let (Some(language), Some(labels)) = (&facts.language, facts.labels(definition)) else { return };
    let Some((cycle, spoken)) = definition.cycle().zip(labels.language(language)) else { return };
    for item in &definition.items {
        let (Some(own), Some(span)) = (item.index, item.label) else { continue };
        let printed = facts.text(span);
        if spoken.params.get(own).is_some_and(|labels| labels.is_exactly(printed)) {
            continue;
        }
        let folded = fold(printed);
        let is_own = |language: &crate::check::LanguageLabels| {
            language.params.get(own).is_some_and(|labels| labels.matches_folded(&folded))
        };
        // Most labels are those of the program's language.
        if is_own(spoken) || labels.languages.iter().any(is_own) {
            continue;
        }
        let other = spoken.params.iter().position(|labels| labels.matches_folded(&folded));
        if let Some(other) = other.and_then(|index| cycle.params.get(index)) {
            let finding = rule.at(facts, span).arg("label", printed).arg("parameter", item.name.as_ref());
            let finding = finding.arg("other", other.label_in(definition.key.number));
            // The number is what the control reads: the comment is made to say what it does.
            let right = spoken.params.get(own).and_then(|labels| labels.label.as_deref());
            found.push(match right {
                Some(right) => finding.fix(span, right),
                None => finding,
            });
        }
    }
}
