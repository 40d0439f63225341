//! A parameter or field that the cycle needs and the definition lacks.
//!
//! Silent where a line of the definition cannot be read: it may be the one that is missed.
use crate::check::{Facts, Rule};
use crate::diag::{Diagnostic, Severity};

pub(super) const RULE: Rule = Rule { code: "missing-parameter", severity: Severity::Error, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    for (definition, _) in facts.described().filter(|(definition, _)| !definition.torn) {
        for param in &definition.missing {
            let finding = rule.at(facts, definition.view.head).arg("parameter", param.label_in(definition.key.number));
            found.push(finding.arg("cycle", definition.key.to_string()));
        }
    }
}
