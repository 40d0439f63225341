//! A contour with radius compensation that comes back to a corner which it has already, other than the one where it began: a
//! sign or a coordinate of the corner is wrong.
//!
//! Only straight lines and arcs whose ends are known, in programs with a box as their blank. Said once a program.
use crate::base::diag::{Arg, Diagnostic, Severity};
use crate::check::incident::Incident;
use crate::check::travel::first_incident;
use crate::check::{Facts, Rule};

pub(super) const RULE: Rule = Rule { code: "contour-returns", severity: Severity::Warning, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let first = first_incident(facts, |own| match own {
        Incident::CornerPassedTwice(place) => Some(place),
        _ => None,
    });
    if let Some((span, [x, y])) = first {
        let round = |own: f64| Arg::Number((own * 1000.0).round() / 1000.0);
        found.push(rule.at(facts, span).arg("value", round(x)).arg("other", round(y)));
    }
}
