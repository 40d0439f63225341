//! A hole next to the blank or cut by its edge, one that begins well above it or below it, or one that goes far through
//! it.
//!
//! Only cycles for holes at places that are known, in programs with a box as their blank and without transformations.
//! An execution shows them through subprograms and patterns, in a round blank that was turned before, and after cycles
//! that nobody describes. A hole next to the blank is said once a program, the others once a definition.
use crate::base::diag::{Arg, Diagnostic, Severity};
use crate::check::incident::Incident;
use crate::check::travel::incidents;
use crate::check::{Facts, Rule};

pub(super) const RULE: Rule = Rule { code: "hole-outside-blank", severity: Severity::Warning, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let mut beside = false;
    for (span, own) in incidents(facts) {
        let finding = rule.at(facts, *span);
        match own {
            Incident::HoleBesideBlank([x, y]) if !std::mem::replace(&mut beside, true) => {
                let finding = finding.arg("what", "beside").arg("value", Arg::Number(*x));
                found.push(finding.arg("other", Arg::Number(*y)));
            }
            Incident::MissesBlankInTiltedPlane => {
                found.push(finding.arg("what", "tilted").arg("value", 0).arg("other", 0));
            }
            Incident::HoleCutByEdge([x, y]) => {
                let finding = finding.arg("what", "edge").arg("value", Arg::Number(*x));
                found.push(finding.arg("other", Arg::Number(*y)));
            }
            Incident::HoleOffSurface(height) => {
                found.push(finding.arg("what", "surface").arg("value", Arg::Number(*height)).arg("other", 0));
            }
            Incident::HoleThroughBlank(height) => {
                found.push(finding.arg("what", "through").arg("value", Arg::Number(*height)).arg("other", 0));
            }
            _ => {}
        }
    }
}
