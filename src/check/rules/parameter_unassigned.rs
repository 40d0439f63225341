//! A parameter that is read before anything gives it a value, on every way that the run can take.
//!
//! Only the freely available parameters Q0 to Q99, QS0 to QS99 and local ones are looked at, each once, and only in
//! programs with a blank: others are called, and their callers may fill parameters. Nothing is said behind calls of
//! other programs and cycles of the machine builder.
use std::collections::BTreeSet;

use crate::check::{Facts, Rule};
use crate::diag::{Diagnostic, Severity};

pub(super) const RULE: Rule = Rule { code: "parameter-unassigned", severity: Severity::Warning, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let mut told = BTreeSet::new();
    for (q, span) in &facts.run.unset {
        if told.insert(*q) {
            found.push(rule.at(facts, *span).arg("parameter", q.to_string()));
        }
    }
}
