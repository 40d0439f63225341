//! An open contour along an edge of the blank that leaves a wall there: RL and RR are exchanged, and the step is missing.
//!
//! Where an execution shows it: there is material on both sides of the way when the program ends, and the tool has gone
//! beside it nowhere else. Said once a program.
use crate::base::diag::{Arg, Diagnostic, Severity};
use crate::check::incident::Incident;
use crate::check::travel::first_incident;
use crate::check::{Facts, Rule};

pub(super) const RULE: Rule = Rule { code: "wall-left", severity: Severity::Warning, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let first = first_incident(facts, |own| match own {
        Incident::WallLeft(wide) => Some(wide),
        _ => None,
    });
    if let Some((span, wide)) = first {
        found.push(rule.at(facts, span).arg("value", Arg::Number(wide)));
    }
}
