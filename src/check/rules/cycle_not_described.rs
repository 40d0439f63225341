//! A cycle that the control has and no manual here describes, though it may name it: its parameters cannot be checked.
use crate::check::{Facts, Rule};
use crate::diag::{Diagnostic, Severity};
use crate::spec::Known;

pub(super) const RULE: Rule = Rule { code: "cycle-not-described", severity: Severity::Note, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    for definition in &facts.definitions {
        let (name, manual) = match definition.known {
            Known::Named(named) => (named.name.trim(), "named"),
            Known::Unknown if facts.against.on.has_elsewhere(definition.key) => ("", "other"),
            _ => continue,
        };
        let finding = rule.at(facts, definition.view.head).arg("cycle", definition.key.to_string());
        found.push(finding.arg("name", name).arg("manual", manual));
    }
}
