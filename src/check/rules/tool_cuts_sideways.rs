//! A drill, tap or reamer that a plain movement at feed moves sideways through material: another tool was to be called.
//!
//! Where an execution shows it, and the name of the tool or a comment beside its call says what it is. Said once a program.
use crate::base::diag::{Diagnostic, Severity};
use crate::check::incident::Incident;
use crate::check::travel::incidents;
use crate::check::{Facts, Rule};

pub(super) const RULE: Rule = Rule { code: "tool-cuts-sideways", severity: Severity::Warning, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let first = incidents(facts).iter().find(|(_, own)| *own == Incident::SidewaysWithDrill);
    found.extend(first.map(|(span, _)| rule.at(facts, *span)));
}
