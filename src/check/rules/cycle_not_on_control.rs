//! A cycle that this control lacks and another one has.
use crate::base::diag::{Diagnostic, Severity};
use crate::check::{Facts, Rule};
use crate::spec::{CycleKey, Known};

pub(super) const RULE: Rule = Rule { code: "cycle-not-on-control", severity: Severity::Warning, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    for definition in &facts.definitions {
        if !matches!(definition.known, Known::Unknown) || !facts.against.on.covers(definition.key) {
            continue;
        }
        let controls = elsewhere(facts, definition.key);
        if !controls.is_empty() {
            let finding = rule.at(facts, definition.view.head).arg("cycle", definition.key.to_string());
            let own = facts.against.on.control.title.as_str();
            found.push(finding.arg("control", own).arg("controls", controls.join(", ")));
        }
    }
}

/// The titles of the controls that know a cycle.
pub(super) fn elsewhere<'a>(facts: &Facts<'a>, key: CycleKey) -> Vec<&'a str> {
    let knows = |known: Known<'_>| matches!(known, Known::Described(_) | Known::Named(_));
    let controls = facts.against.catalogue.controls.values();
    controls.filter(|on| knows(on.known(key))).map(|on| on.control.title.as_str()).collect()
}
