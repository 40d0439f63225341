//! Holes of one tool that overlap: a spacing has lost a digit, or there are too many of them on a circle. Also pockets
//! and slots of one definition that run into each other, a hole that a pocket or a wider hole cuts which was made before, a
//! pocket or slot that lies for the most part where a deeper one is, unlike another one of the same definition, and a hole
//! that is milled beside the one that was drilled for it.
//!
//! Where an execution shows them and the diameter of the tool is known, be it after turning. Each is said once a program.
use crate::base::diag::{Diagnostic, Severity};
use crate::check::incident::Incident;
use crate::check::travel::incidents;
use crate::check::{Facts, Rule};

pub(super) const RULE: Rule = Rule { code: "holes-overlap", severity: Severity::Warning, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    for (span, own) in incidents(facts) {
        let (what, value, other) = match own {
            Incident::Overlap { distance, width } => ("holes", *distance, *width),
            Incident::PocketsOverlap([x, y]) => ("pockets", *x, *y),
            Incident::HoleCutByPocket([x, y]) => ("pocket", *x, *y),
            Incident::HoleCutByHole([x, y]) => ("hole", *x, *y),
            Incident::PocketInPocket([x, y]) => ("inside", *x, *y),
            Incident::NotPreDrilled([x, y]) => ("beside", *x, *y),
            _ => continue,
        };
        found.push(rule.comparison(facts, *span, what, value, other));
    }
}
