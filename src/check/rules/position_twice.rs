//! A place that a cycle machines a second time, with the same definition and the same tool: another place was meant.
//!
//! Only holes, taps and pockets at places that are known, in programs with a box as their blank and without
//! transformations. Said once a program.
use crate::base::diag::{Arg, Diagnostic, Severity};
use crate::check::incident::Incident;
use crate::check::travel::incidents;
use crate::check::{Facts, Rule};

pub(super) const RULE: Rule = Rule { code: "position-twice", severity: Severity::Warning, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let first = incidents(facts).iter().find_map(|(span, own)| match own {
        Incident::Again(place) => Some((*span, *place)),
        _ => None,
    });
    if let Some((span, [x, y])) = first {
        found.push(rule.at(facts, span).arg("value", Arg::Number(x)).arg("other", Arg::Number(y)));
    }
}
