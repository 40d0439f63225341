//! An approach or a departure that the control cannot calculate, or that spoils the contour: the start or end point is
//! inside of the arc that leads to the contour, or the tool has plunged at the first point of a contour.
//!
//! Places are followed from label to label in programs with a box as their blank. Without a known radius of the tool it is
//! taken to be at most 10 mm. Each is said once a program.
use crate::base::diag::{Arg, Diagnostic, Severity};
use crate::check::incident::Incident;
use crate::check::travel::incidents;
use crate::check::{Facts, Rule};

pub(super) const RULE: Rule = Rule { code: "approach-wrong", severity: Severity::Warning, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let (mut arc, mut plunged) = (false, false);
    for (span, own) in incidents(facts) {
        let (what, radius, said) = match own {
            Incident::Arc(radius) => ("arc", *radius, &mut arc),
            Incident::Plunged => ("plunged", 0.0, &mut plunged),
            _ => continue,
        };
        if !std::mem::replace(said, true) {
            found.push(rule.at(facts, *span).arg("what", what).arg("value", Arg::Number(radius)));
        }
    }
}
