//! A thread that is tapped in a hole which is too narrow for any thread of that diameter: the tap breaks.
//!
//! Where an execution shows it, and both diameters are known. Said once a program.
use crate::base::diag::{Arg, Diagnostic, Severity};
use crate::check::incident::Incident;
use crate::check::travel::first_incident;
use crate::check::{Facts, Rule};

pub(super) const RULE: Rule = Rule { code: "core-hole-too-small", severity: Severity::Warning, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let first = first_incident(facts, |own| match own {
        Incident::NarrowCore { thread, hole } => Some((thread, hole)),
        _ => None,
    });
    if let Some((span, (thread, hole))) = first {
        found.push(rule.at(facts, span).arg("value", Arg::Number(thread)).arg("other", Arg::Number(hole)));
    }
}
