//! A tool that plunges straight down into material by far more per revolution than any does: the feed rate has a digit too
//! many, or is that for positioning. Also one that goes sideways through solid material with three times the feed of its
//! tool call or more, and has cut with that feed before: a way beside the part that leads through it; or with ten times the
//! feed of its other cuts, which is more for each revolution than a mill takes.
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
    let bites = first_incident(facts, |own| match own {
        Incident::FastMilling(value) => Some(value),
        _ => None,
    });
    if let Some((span, value)) = bites.filter(|_| first.is_none() && sideways.is_none()) {
        let value = (value * 1000.0).round() / 1000.0;
        found.push(rule.at(facts, span).arg("what", "turn").arg("value", Arg::Number(value)));
        return;
    }
    let tenfold = first_incident(facts, |own| match own {
        Incident::TenfoldFeed(times) => Some(times),
        _ => None,
    });
    if let Some((span, times)) = tenfold.filter(|_| sideways.is_none()) {
        let times = (times * 10.0).round() / 10.0;
        found.push(rule.at(facts, span).arg("what", "tenfold").arg("value", Arg::Number(times)));
    }
}
