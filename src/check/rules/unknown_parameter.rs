//! A parameter or field that the cycle does not have on this control.
//!
//! If it has none of all that are written, that is reported once, at the cycle. Where nothing else is missing, or what
//! is missing may be in a line that cannot be read, it is a warning: later software versions have parameters of which
//! the manuals here do not speak. Those that are known to be such are distinguished (`parameter-of-later-software`).
//! With the software version of the manual, everything else is an error.
use super::parameter_of_later_software::since;
use super::together;
use crate::base::diag::{Diagnostic, Severity};
use crate::check::{Definition, Facts, Item, Rule};
use crate::spec::Since;

pub(super) const RULE: Rule = Rule { code: "unknown-parameter", severity: Severity::Error, run: together };

/// How many parameters must not fit before the cycle is doubted.
const LEAST: usize = 2;

pub(super) fn each(rule: &Rule, facts: &Facts<'_>, definition: &Definition<'_>, found: &mut Vec<Diagnostic>) {
    if definition.in_order || definition.cycle().is_none() {
        return;
    }
    let strange = definition.items.iter().filter(|item| item.param.is_none());
    let number = strange.clone().count();
    // Where nothing fits, the number of the cycle is wrong rather than each parameter.
    if number >= LEAST && number == definition.items.len() {
        let names: Vec<&str> = strange.map(|item| item.name.as_ref()).collect();
        let finding = rule.at(facts, definition.view.head).arg("parameter", names.join(", "));
        found.push(finding.arg("cycle", definition.key.to_string()));
        return;
    }
    let reported = |item: &&Item<'_>| !matches!(since(facts, definition, item), Since::Later | Since::There);
    for item in strange.filter(reported) {
        let complete = definition.missing.is_empty() || definition.torn;
        let addition = complete && crate::base::expr::QRef::parse(&item.name).is_some();
        let addition = addition && since(facts, definition, item) != Since::NotYet;
        let severity = if addition { Severity::Warning } else { rule.severity };
        let finding = rule.at(facts, item.span).arg("parameter", item.name.as_ref());
        found.push(Diagnostic { severity, ..finding }.arg("cycle", definition.key.to_string()));
    }
}
