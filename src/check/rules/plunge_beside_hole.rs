//! A block that plunges into a hole on one pass and into solid material on another: the holes lie elsewhere, or there are
//! too few of them.
//!
//! Where an execution shows it, with tools that are known. Said once a program.
use crate::base::diag::{Arg, Diagnostic, Severity};
use crate::check::incident::Incident;
use crate::check::travel::first_incident;
use crate::check::{Facts, Rule};

pub(super) const RULE: Rule = Rule { code: "plunge-beside-hole", severity: Severity::Warning, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let first = first_incident(facts, |own| match own {
        Incident::PlungeBesideHoles(place) => Some(place),
        _ => None,
    });
    if let Some((span, [x, y])) = first {
        found.push(rule.at(facts, span).arg("value", Arg::Number(x)).arg("other", Arg::Number(y)));
    }
}
