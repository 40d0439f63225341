//! A tool that goes down below the top of the blank before the program has said where it is in the plane.
//!
//! Where an execution shows it. Said once a program.
use crate::base::diag::{Arg, Diagnostic, Severity};
use crate::check::incident::Incident;
use crate::check::travel::first_incident;
use crate::check::{Facts, Rule};

pub(super) const RULE: Rule = Rule { code: "position-missing", severity: Severity::Warning, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let first = first_incident(facts, |own| match own {
        Incident::DownBeforePositioned(height) => Some(height),
        _ => None,
    });
    if let Some((span, height)) = first {
        found.push(rule.at(facts, span).arg("value", Arg::Number(height)));
    }
}
