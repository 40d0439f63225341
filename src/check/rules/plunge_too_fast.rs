//! A tool that plunges straight down into material by far more per revolution than any does: the feed rate has a digit too
//! many, or is that for positioning. Also one that goes sideways through solid material with three times the feed of its
//! tool call or more, and has cut with that feed before: a way beside the part that leads through it.
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
        found.push(rule.at(facts, span).arg("what", "plunge").arg("value", Arg::Number(value)));
    }
    let sideways = first_incident(facts, |own| match own {
        Incident::FastCut(times) => Some(times),
        _ => None,
    });
    if let Some((span, times)) = sideways {
        let times = (times * 10.0).round() / 10.0;
        found.push(rule.at(facts, span).arg("what", "sideways").arg("value", Arg::Number(times)));
    }
}
