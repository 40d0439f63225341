//! A path that the same tool has gone before under another transformation: mirroring or rotation brings it to itself, so
//! something is machined twice and something else not at all.
//!
//! Where an execution shows it. Said once a program.
use crate::base::diag::{Diagnostic, Severity};
use crate::check::incident::Incident;
use crate::check::travel::incidents;
use crate::check::{Facts, Rule};

pub(super) const RULE: Rule = Rule { code: "path-twice", severity: Severity::Warning, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let first = incidents(facts).iter().find(|(_, own)| *own == Incident::PathTwice);
    found.extend(first.map(|(span, _)| rule.at(facts, *span)));
}
