//! A label that belongs to another parameter of the same cycle: the value may be meant for that one.
//!
//! Labels that no language has are left alone; machine builders and older software have their own.
use crate::check::{Facts, Rule};
use crate::diag::{Diagnostic, Severity};

pub(super) const RULE: Rule = Rule { code: "label-of-another-parameter", severity: Severity::Warning, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let Some(language) = &facts.language else { return };
    for (definition, cycle) in facts.described() {
        let Some(labels) = facts.labels(definition) else { continue };
        let Some(spoken) = labels.language(language) else { continue };
        for item in &definition.items {
            let (Some(own), Some(span), Some(folded)) = (item.index, item.label, &item.folded) else { continue };
            let printed = facts.text(span);
            let is_own = |language: &crate::check::LanguageLabels| {
                language.params.get(own).is_some_and(|labels| labels.matches_folded(folded))
            };
            if labels.languages.iter().any(is_own) {
                continue;
            }
            let other = spoken.params.iter().position(|labels| labels.matches_folded(folded));
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
}
