//! A thread that is tapped in a hole which is too narrow for any thread of that diameter, or milled in one that is
//! narrower than the thread mill: the tool breaks.
//!
//! Where an execution shows it, and both diameters are known. Said once a program.
use crate::base::diag::{Diagnostic, Severity};
use crate::check::incident::Incident;
use crate::check::{Facts, Rule};

pub(super) const RULE: Rule = Rule { code: "core-hole-too-small", severity: Severity::Warning, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    rule.report_first(facts, found, "tapped", |own| match own {
        Incident::NarrowCore { thread, hole } => Some((thread, hole)),
        _ => None,
    });
    rule.report_first(facts, found, "milled", |own| match own {
        Incident::ToolWiderThanCore { tool, hole } => Some((tool, hole)),
        _ => None,
    });
}
