//! The only hole of a tool lies where nothing else is done, while a pocket begins at the place with both coordinates exchanged:
//! the hole in which the mill was to plunge is elsewhere.
//!
//! Where an execution shows it. Said once a program.
use crate::base::diag::{Diagnostic, Severity};
use crate::check::incident::Incident;
use crate::check::{Facts, Rule};

pub(super) const RULE: Rule = Rule { code: "pilot-hole-elsewhere", severity: Severity::Warning, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    rule.report_first(facts, found, "exchanged", |own| match own {
        Incident::PilotHoleExchanged([x, y]) => Some((x, y)),
        _ => None,
    });
}
