//! A cycle that no manual of the specifications names and that is not the machine builder's. A warning: controls have
//! cycles of other software versions, of which the manuals here do not speak.
use super::cycle_not_on_control::elsewhere;
use crate::check::{Facts, Rule};
use crate::diag::{Diagnostic, Severity};
use crate::spec::Known;

pub(super) const RULE: Rule = Rule { code: "unknown-cycle", severity: Severity::Warning, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    for definition in &facts.definitions {
        let unknown = matches!(definition.known, Known::Unknown) && facts.against.on.covers(definition.key);
        if unknown && elsewhere(facts, definition.key).is_empty() {
            found.push(rule.at(facts, definition.view.head).arg("cycle", definition.key.to_string()));
        }
    }
}
