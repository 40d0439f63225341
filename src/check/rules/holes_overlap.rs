//! Holes of one tool that overlap: a spacing has lost a digit, or there are too many of them on a circle.
//!
//! Where an execution shows them and the diameter of the tool is known, be it after turning. Said once a program.
use crate::base::diag::{Arg, Diagnostic, Severity};
use crate::check::incident::Incident;
use crate::check::travel::first_incident;
use crate::check::{Facts, Rule};

pub(super) const RULE: Rule = Rule { code: "holes-overlap", severity: Severity::Warning, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let first = first_incident(facts, |own| match own {
        Incident::Overlap { distance, width } => Some((distance, width)),
        _ => None,
    });
    if let Some((span, (distance, width))) = first {
        found.push(rule.at(facts, span).arg("value", Arg::Number(distance)).arg("other", Arg::Number(width)));
    }
}
