//! A cycle that the control has and no manual here describes, though it may name it: its parameters cannot be checked.
use crate::check::{Facts, Rule};
use crate::diag::{Diagnostic, Severity};
use crate::spec::Known;

pub(super) const RULE: Rule = Rule { code: "cycle-not-described", severity: Severity::Note, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    for definition in &facts.definitions {
        let Known::Named(named) = definition.known else { continue };
        let finding = rule.at(facts, definition.view.head).arg("cycle", definition.key.to_string());
        found.push(finding.arg("name", named.name.trim()));
    }
}
