//! A pocket, a stud, a slot or a place of a contour that is so far from the blank that nothing of it is machined there, a
//! round pocket that the edge of the blank cuts, a rectangular one that leaves nothing of it or goes far beyond it at both
//! ends; a cycle that stays above the blank, and a movement that cuts far below it, where an execution shows them.
//!
//! Only at places that are known, in programs with a box as their blank and without transformations. Each is said once a
//! program.
use crate::base::diag::{Arg, Diagnostic, Severity};
use crate::check::incident::Incident;
use crate::check::travel::incidents;
use crate::check::{Facts, Rule};

pub(super) const RULE: Rule = Rule { code: "machining-outside-blank", severity: Severity::Warning, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let (mut outside, mut over, mut above, mut below) = (false, false, false, false);
    for (span, own) in incidents(facts) {
        let (what, [x, y], said) = match own {
            Incident::Outside(place) => ("outside", *place, &mut outside),
            Incident::Over(place) => ("over", *place, &mut over),
            Incident::Above(height) => ("above", [*height, 0.0], &mut above),
            Incident::Below(height) => ("below", [*height, 0.0], &mut below),
            _ => continue,
        };
        if !std::mem::replace(said, true) {
            let finding = rule.at(facts, *span).arg("what", what).arg("value", Arg::Number(x));
            found.push(finding.arg("other", Arg::Number(y)));
        }
    }
}
