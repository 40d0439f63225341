//! A deepened starting point below the bottom of the hole that is there: the tool comes down to it at the feed for
//! pre-positioning, or at the slow speed for entering, in solid material.
//!
//! Only at places that are known, in programs with a box as their blank and without transformations. Said once a program.
use crate::base::diag::{Arg, Diagnostic, Severity};
use crate::check::incident::Incident;
use crate::check::travel::first_incident;
use crate::check::{Facts, Rule};

pub(super) const RULE: Rule = Rule { code: "pilot-hole-too-shallow", severity: Severity::Warning, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let first = first_incident(facts, |own| match own {
        Incident::StartBelowPilotHole { start, bottom } => Some((start, bottom)),
        _ => None,
    });
    if let Some((span, (start, bottom))) = first {
        found.push(rule.at(facts, span).arg("value", Arg::Number(start)).arg("other", Arg::Number(bottom)));
    }
}
