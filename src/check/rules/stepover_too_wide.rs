//! A face that is milled in lines which are farther apart than the tool is wide: ribs stay between them.
//!
//! Where an execution shows it, with a tool that is known: lines to and fro from edge to edge of the blank, with equal steps
//! between, and material between them that is still there when the program ends. Said once a program.
use crate::base::diag::{Diagnostic, Severity};
use crate::check::incident::Incident;
use crate::check::{Facts, Rule};

pub(super) const RULE: Rule = Rule { code: "stepover-too-wide", severity: Severity::Warning, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    rule.report_first(facts, found, "rib", |own| match own {
        Incident::RibsLeft { step, width } => Some((step, width)),
        _ => None,
    });
}
