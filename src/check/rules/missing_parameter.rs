//! A parameter or field that the cycle needs and the definition lacks.
//!
//! Silent where a line of the definition cannot be read: it may be the one that is missed.
use super::together;
use crate::check::{Definition, Facts, Rule};
use crate::diag::{Diagnostic, Severity};

pub(super) const RULE: Rule = Rule { code: "missing-parameter", severity: Severity::Error, run: together };

pub(super) fn each(rule: &Rule, facts: &Facts<'_>, definition: &Definition<'_>, found: &mut Vec<Diagnostic>) {
    for param in definition.missing.iter().filter(|_| !definition.torn) {
        let finding = rule.at(facts, definition.view.head).arg("parameter", param.label_in(definition.key.number));
        found.push(finding.arg("cycle", definition.key.to_string()));
    }
}
