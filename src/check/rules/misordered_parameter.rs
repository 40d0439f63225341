//! A parameter that stands before one which it follows on the control.
//!
//! Controls know parameters by their numbers, so this is a warning; it is said once a definition.
//! Lines of the old form may stand in any order.
use super::together;
use crate::check::{Definition, Facts, Rule};
use crate::diag::{Diagnostic, Severity};
use crate::spec::Cycle;

pub(super) const RULE: Rule = Rule { code: "misordered-parameter", severity: Severity::Warning, run: together };

pub(super) fn each(rule: &Rule, facts: &Facts<'_>, definition: &Definition<'_>, found: &mut Vec<Diagnostic>) {
    if definition.in_order || definition.cycle().is_none_or(Cycle::is_old_style) {
        return;
    }
    let mut last: Option<(usize, &str)> = None;
    for item in &definition.items {
        let Some(own) = item.index else { continue };
        match last {
            Some((before, name)) if own < before => {
                let finding = rule.at(facts, item.span).arg("parameter", item.name.as_ref());
                found.push(finding.arg("before", name).arg("cycle", definition.key.to_string()));
                break;
            }
            _ => last = Some((own, item.name.as_ref())),
        }
    }
}
