//! A label in another language than most labels of the program.
use super::together;
use crate::base::diag::{Diagnostic, Severity};
use crate::check::cycle::fold;
use crate::check::{Definition, Facts, Rule};

pub(super) const RULE: Rule = Rule { code: "label-of-another-language", severity: Severity::Warning, run: together };

pub(super) fn each(rule: &Rule, facts: &Facts<'_>, definition: &Definition<'_>, found: &mut Vec<Diagnostic>) {
    if facts.has_usual_labels(definition) {
        return;
    }
    let Some((language, labels)) = facts.language.as_ref().zip(facts.labels(definition)) else { return };
    let spoken = labels.language(language);
    for item in &definition.items {
        let (Some(own), Some(span)) = (item.index, item.label) else { continue };
        let printed = facts.text(span);
        if spoken.and_then(|language| language.params.get(own)).is_some_and(|labels| labels.is_exactly(printed)) {
            continue;
        }
        let folded = fold(printed);
        // Most labels are those of the program's language.
        let right = spoken.and_then(|language| language.params.get(own));
        if right.is_some_and(|labels| labels.matches_folded(&folded)) {
            continue;
        }
        let speaking: Vec<&str> = labels
            .languages
            .iter()
            .filter(|language| language.params.get(own).is_some_and(|labels| labels.matches_folded(&folded)))
            .map(|language| language.tag.as_str())
            .collect();
        if speaking.is_empty() || speaking.contains(&language.as_str()) {
            continue;
        }
        let Some(right) = right.and_then(|labels| labels.label.as_deref()) else { continue };
        let finding = rule.at(facts, span).arg("label", printed).arg("parameter", item.name.as_ref());
        found.push(finding.arg("language", speaking.join(", ")).arg("right", right).fix(span, right));
    }
}
