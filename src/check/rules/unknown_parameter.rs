//! A parameter or field that the cycle does not have on this control.
use crate::check::{Facts, Rule};
use crate::diag::{Diagnostic, Severity};

pub(super) const RULE: Rule = Rule { code: "unknown-parameter", severity: Severity::Error, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    for (definition, _) in facts.described() {
        for item in definition.items.iter().filter(|item| item.param.is_none()) {
            let finding = rule.at(facts, item.span).arg("parameter", item.name.as_ref());
            found.push(finding.arg("cycle", definition.key.to_string()));
        }
    }
}
