//! A label in another language than most labels of the program.
use crate::check::{Facts, Rule};
use crate::diag::{Diagnostic, Severity};

pub(super) const RULE: Rule = Rule { code: "label-of-another-language", severity: Severity::Warning, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let Some(language) = &facts.language else { return };
    for (definition, _) in facts.described() {
        let Some(labels) = facts.labels(definition) else { continue };
        for item in &definition.items {
            let (Some(own), Some(span), Some(folded)) = (item.index, item.label, &item.folded) else { continue };
            // Most labels are those of the program's language.
            let right = labels.language(language).and_then(|language| language.params.get(own));
            if right.is_some_and(|labels| labels.matches_folded(folded)) {
                continue;
            }
            let printed = facts.text(span);
            let speaking: Vec<&str> = labels
                .languages
                .iter()
                .filter(|language| language.params.get(own).is_some_and(|labels| labels.matches_folded(folded)))
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
}
