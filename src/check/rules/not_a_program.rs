//! A file that is no program: no BEGIN PGM, no END PGM, and most of its blocks cannot be read.
//!
//! Header files of other languages end with `.h`, too. What cannot be read in such a file is not told one by one.
use crate::base::diag::{Diagnostic, Severity};
use crate::check::{Facts, Rule};

pub(super) const RULE: Rule = Rule { code: "not-a-program", severity: Severity::Warning, run };

/// Fewer blocks than that may be a piece of a program with mistakes.
const LEAST: usize = 4;

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    if facts.begins() || facts.end.is_some() {
        return;
    }
    let (mut all, mut unread) = (0, 0);
    for block in facts.acting() {
        all += 1;
        unread += usize::from(block.is_unread());
    }
    if all < LEAST || unread * 2 <= all || facts.unread("BEGIN") || facts.unread("END") || facts.unread("%") {
        return;
    }
    if let Some(first) = facts.acting().next() {
        found.retain(|own| own.severity != Severity::Error || !own.code.starts_with("syntax-"));
        found.push(rule.at(facts, facts.content(first)));
    }
}
