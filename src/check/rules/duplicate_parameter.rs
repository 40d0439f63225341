//! A parameter that the same definition has had before.
use crate::check::{Facts, Rule};
use crate::diag::{Diagnostic, Place, Severity};

pub(super) const RULE: Rule = Rule { code: "duplicate-parameter", severity: Severity::Error, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    for definition in &facts.definitions {
        for (index, item) in definition.items.iter().enumerate() {
            let repeats = item.param.is_some_and(|param| param.field.as_ref().is_some_and(|field| field.repeat));
            let first = definition.items.iter().take(index).find(|other| other.name == item.name);
            // Fields without a printed word have no name to tell them apart by.
            let named = item.name.starts_with('Q') || item.name.ends_with(':');
            if let Some(first) = first.filter(|_| named && !repeats) {
                let place = Place::new(facts.program.source(), first.span);
                let finding = rule.at(facts, item.span).arg("parameter", item.name.as_ref());
                found.push(finding.arg("cycle", definition.key.to_string()).related("first-place", place));
            }
        }
    }
}
