//! A rapid movement into the blank where nothing has been cut: along the tool axis, sideways or diagonally, at any time.
//!
//! Places are followed from label to label in programs with a box as their blank; what a contour with arcs or a cycle
//! for more than holes has cut is not known, so nothing is said after it. Near places that were cut nothing is said
//! either. An execution shows the same of round blanks, too, in programs that do not probe: a part that was turned before is
//! probed where it was turned. Said once a program.
use crate::base::diag::{Arg, Diagnostic, Severity};
use crate::check::blank::{Blank, top};
use crate::check::cycle::probes;
use crate::check::incident::Incident;
use crate::check::travel::first_incident;
use crate::check::{Facts, Rule};

pub(super) const RULE: Rule = Rule { code: "rapid-into-blank", severity: Severity::Warning, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let Some(top) = top(facts.program) else { return };
    let probed = || facts.definitions.iter().any(|own| own.related_cycle().is_some_and(probes));
    if Blank::of(facts.program).is_none() && probed() {
        return;
    }
    let first = first_incident(facts, |own| match own {
        Incident::RapidInMaterial(height) => Some(height),
        _ => None,
    });
    if let Some((span, height)) = first {
        let finding = rule.at(facts, span).arg("value", Arg::Number(height));
        found.push(finding.arg("top", Arg::Number(top)));
    }
}
