//! A program that ends with END PGM and does not begin with BEGIN PGM.
use crate::base::diag::{Diagnostic, Severity};
use crate::check::{Facts, Rule};

pub(super) const RULE: Rule = Rule { code: "program-begin-missing", severity: Severity::Error, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let ends = facts.end.is_some();
    if !ends || facts.begins() || facts.unread("BEGIN") {
        return;
    }
    if let Some(first) = facts.acting().next() {
        found.push(rule.at(facts, facts.content(first)));
    }
}
