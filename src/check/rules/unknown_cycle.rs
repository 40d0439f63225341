//! A cycle that no control of the specifications knows, that is not the machine builder's, and that is none of those
//! which the profile of the control knows from other manuals.
use super::cycle_not_on_control::elsewhere;
use crate::check::{Facts, Rule};
use crate::diag::{Diagnostic, Severity};
use crate::spec::Known;

pub(super) const RULE: Rule = Rule { code: "unknown-cycle", severity: Severity::Error, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    for definition in &facts.definitions {
        let unknown = matches!(definition.known, Known::Unknown) && !facts.against.on.has_elsewhere(definition.key);
        if unknown && elsewhere(facts, definition.key).is_empty() {
            found.push(rule.at(facts, definition.view.head).arg("cycle", definition.key.to_string()));
        }
    }
}
