//! A definition without parameters that an earlier software version, or an earlier control, did not have: the control
//! adds them when it reads the program. What it adds is in the specifications.
//!
//! One finding a definition. Silent where a line of the definition cannot be read.
use super::together;
use crate::base::diag::{Diagnostic, Severity};
use crate::check::{Definition, Facts, Rule};
use crate::spec::Param;

pub(super) const RULE: Rule = Rule { code: "older-parameter-set", severity: Severity::Warning, run: together };

pub(super) fn each(rule: &Rule, facts: &Facts<'_>, definition: &Definition<'_>, found: &mut Vec<Diagnostic>) {
    if definition.torn || definition.missing.is_empty() {
        return;
    }
    let number = definition.key.number;
    let shown = |param: &&Param| match param.supplied()? {
        value if value.is_empty() => Some(param.label_in(number)),
        value => Some(format!("{}={value}", param.label_in(number))),
    };
    let names: Vec<String> = definition.missing.iter().filter_map(shown).collect();
    if !names.is_empty() {
        let finding = rule.at(facts, definition.view.head).arg("cycle", definition.key.to_string());
        found.push(finding.arg("parameter", names.join(", ")).arg("count", names.len()));
    }
}
