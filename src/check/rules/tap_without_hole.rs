//! A tap where no hole was drilled, in a program that drills others; a tap that goes deeper than its hole; a thread mill
//! outside of a stud that goes into the floor around it.
//!
//! Only where the places and depths of all holes are known, in programs with a box as their blank and without
//! transformations. A hole that goes through the blank is deep enough. Each is said once a program.
use crate::base::diag::{Arg, Diagnostic, Severity};
use crate::check::incident::Incident;
use crate::check::travel::incidents;
use crate::check::{Facts, Rule};

pub(super) const RULE: Rule = Rule { code: "tap-without-hole", severity: Severity::Warning, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    for (span, own) in incidents(facts) {
        let finding = rule.at(facts, *span);
        match own {
            Incident::NoHole([x, y]) => {
                let finding = finding.arg("what", "missing").arg("value", Arg::Number(*x));
                found.push(finding.arg("other", Arg::Number(*y)));
            }
            Incident::HoleTooShallow { tap, hole } => {
                let finding = finding.arg("what", "shallow").arg("value", Arg::Number(*tap));
                found.push(finding.arg("other", Arg::Number(*hole)));
            }
            Incident::ThreadIntoFloor { thread, floor } => {
                let finding = finding.arg("what", "floor").arg("value", Arg::Number(*thread));
                found.push(finding.arg("other", Arg::Number(*floor)));
            }
            _ => {}
        }
    }
}
