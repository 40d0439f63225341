//! A thread that is tapped in a hole which is too narrow for any thread of that diameter, or milled in one that is
//! narrower than the thread mill: the tool breaks.
//!
//! Where an execution shows it, and both diameters are known. Said once a program.
use crate::base::diag::{Arg, Diagnostic, Severity};
use crate::check::incident::Incident;
use crate::check::travel::first_incident;
use crate::check::{Facts, Rule};

pub(super) const RULE: Rule = Rule { code: "core-hole-too-small", severity: Severity::Warning, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let first = first_incident(facts, |own| match own {
        Incident::NarrowCore { thread, hole } => Some((thread, hole)),
        _ => None,
    });
    if let Some((span, (thread, hole))) = first {
        let finding = rule.at(facts, span).arg("what", "tapped").arg("value", Arg::Number(thread));
        found.push(finding.arg("other", Arg::Number(hole)));
    }
    let milled = first_incident(facts, |own| match own {
        Incident::ToolWiderThanCore { tool, hole } => Some((tool, hole)),
        _ => None,
    });
    if let Some((span, (tool, hole))) = milled {
        let finding = rule.at(facts, span).arg("what", "milled").arg("value", Arg::Number(tool));
        found.push(finding.arg("other", Arg::Number(hole)));
    }
}
