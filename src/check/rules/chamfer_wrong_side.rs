//! A tool for chamfers whose tip goes through solid material beside an edge of the blank, and would chamfer that edge if it
//! were as far on the other side of it: a sign is wrong.
//!
//! Where an execution shows it. Said once a program.
use crate::base::diag::{Arg, Diagnostic, Severity};
use crate::check::incident::Incident;
use crate::check::travel::first_incident;
use crate::check::{Facts, Rule};

pub(super) const RULE: Rule = Rule { code: "chamfer-wrong-side", severity: Severity::Warning, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let first = first_incident(facts, |own| match own {
        Incident::ChamferInside { depth, edge } => Some((depth, edge)),
        _ => None,
    });
    if let Some((span, (depth, edge))) = first {
        found.push(rule.at(facts, span).arg("value", Arg::Number(depth)).arg("other", Arg::Number(edge)));
    }
}
