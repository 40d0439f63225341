//! A thread that is cut in a hole as wide as the thread: nothing is left for it. Also a drill about as wide as a thread that
//! was tapped there before: it removes the thread.
//!
//! The hole is a round pocket or a milled bore, or one of a drill that a table or TOOL DEF describes. Only at places that
//! are known, in programs with a box as their blank and without transformations. Said once a program.
use crate::base::diag::{Diagnostic, Severity};
use crate::check::incident::Incident;
use crate::check::{Facts, Rule};

pub(super) const RULE: Rule = Rule { code: "core-hole-too-large", severity: Severity::Warning, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    rule.report_first(facts, found, "core", |own| match own {
        Incident::WideCore { thread, hole } => Some((thread, hole)),
        _ => None,
    });
    rule.report_first(facts, found, "removed", |own| match own {
        Incident::ThreadRemoved { thread, hole } => Some((thread, hole)),
        _ => None,
    });
}
