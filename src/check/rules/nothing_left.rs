//! A tool for holes that is narrower than the hole in which it works, and goes no deeper: it is not the tool that was meant,
//! or comes too late.
//!
//! Where an execution shows it and both diameters are known. Said once a program.
use crate::base::diag::{Arg, Diagnostic, Severity};
use crate::check::incident::Incident;
use crate::check::travel::first_incident;
use crate::check::{Facts, Rule};

pub(super) const RULE: Rule = Rule { code: "nothing-left", severity: Severity::Warning, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let first = first_incident(facts, |own| match own {
        Incident::NothingLeft { tool, hole } => Some((tool, hole)),
        _ => None,
    });
    if let Some((span, (tool, hole))) = first {
        found.push(rule.at(facts, span).arg("value", Arg::Number(tool)).arg("other", Arg::Number(hole)));
    }
}
