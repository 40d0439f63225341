//! A deepened starting point below the bottom of the hole that is there: the tool comes down to it at the feed for
//! pre-positioning, or at the slow speed for entering, in solid material. Also a tool that turns inside and goes deeper
//! than the hole that was drilled in the middle.
//!
//! Only at places that are known, in programs with a box as their blank and without transformations; turning in an
//! execution with a round blank. Each is said once a program.
use crate::base::diag::{Diagnostic, Severity};
use crate::check::incident::Incident;
use crate::check::{Facts, Rule};

pub(super) const RULE: Rule = Rule { code: "pilot-hole-too-shallow", severity: Severity::Warning, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    rule.report_first(facts, found, "start", |own| match own {
        Incident::StartBelowPilotHole { start, bottom } => Some((start, bottom)),
        _ => None,
    });
    rule.report_first(facts, found, "bored", |own| match own {
        Incident::BoredBelowHole { bar, hole } => Some((bar, hole)),
        _ => None,
    });
}
