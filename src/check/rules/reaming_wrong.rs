//! A reamer where no hole was made, one that goes deeper than its hole, or one whose hole is so narrow that it would
//! have to drill; a boring bar that goes deeper than its hole, into what is solid.
//!
//! Where an execution shows it; the diameters only where they are known and the tool is called a reamer. Said once a
//! program.
use crate::base::diag::{Diagnostic, Severity};
use crate::check::incident::Incident;
use crate::check::travel::first_incident;
use crate::check::{Facts, Rule};

pub(super) const RULE: Rule = Rule { code: "reaming-wrong", severity: Severity::Warning, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let first = first_incident(facts, |own| match own {
        Incident::ReamedWrongly { what, value, other } => Some((what, value, other)),
        _ => None,
    });
    if let Some((span, (what, value, other))) = first {
        found.push(rule.comparison(facts, span, what, value, other));
    }
}
