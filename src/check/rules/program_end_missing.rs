//! A program that begins with BEGIN PGM and has no END PGM: its end is missing, or more than its end.
use crate::base::diag::{Diagnostic, Severity};
use crate::check::{Facts, Rule};
use crate::program::syntax::Dialect;

pub(super) const RULE: Rule = Rule { code: "program-end-missing", severity: Severity::Error, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let ends = facts.end.is_some();
    if ends || !facts.begins() || facts.unread("END") {
        return;
    }
    if let Some(last) = facts.acting().next_back() {
        let end = match facts.program.dialect() {
            Dialect::Klartext => "pgm",
            Dialect::Iso => "iso",
        };
        found.push(rule.at(facts, facts.content(last)).arg("end", end));
    }
}
