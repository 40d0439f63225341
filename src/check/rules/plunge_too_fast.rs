//! A tool that plunges straight down into material by far more per revolution than any does: the feed rate has a digit too
//! many, or is that for positioning.
//!
//! Only plain movements, where an execution shows that material is there. Said once a program.
use crate::base::diag::{Arg, Diagnostic, Severity};
use crate::check::incident::Incident;
use crate::check::travel::first_incident;
use crate::check::{Facts, Rule};

pub(super) const RULE: Rule = Rule { code: "plunge-too-fast", severity: Severity::Warning, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let first = first_incident(facts, |own| match own {
        Incident::FastPlunge(value) => Some(value),
        _ => None,
    });
    if let Some((span, value)) = first {
        found.push(rule.at(facts, span).arg("value", Arg::Number(value)));
    }
}
