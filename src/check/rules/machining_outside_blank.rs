//! A pocket, a stud, a slot or a place of a contour that is so far from the blank that nothing of it is machined there.
//!
//! Only at places that are known, in programs with a box as their blank and without transformations. Said once a program.
use crate::base::diag::{Arg, Diagnostic, Severity};
use crate::check::incident::Incident;
use crate::check::travel::incidents;
use crate::check::{Facts, Rule};

pub(super) const RULE: Rule = Rule { code: "machining-outside-blank", severity: Severity::Warning, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let first = incidents(facts).iter().find_map(|(span, own)| match own {
        Incident::Outside(place) => Some((*span, *place)),
        _ => None,
    });
    if let Some((span, [x, y])) = first {
        found.push(rule.at(facts, span).arg("value", Arg::Number(x)).arg("other", Arg::Number(y)));
    }
}
