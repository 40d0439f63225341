//! A contour, or an element of one, that the control cannot calculate from what is programmed.
//!
//! Only where the program is executed: it has a box as its blank, and everything before the place is known. Said once: the
//! execution ends there. Silent where a rule that reads the contour has found why.
use crate::base::diag::{Diagnostic, Severity};
use crate::check::incident::Incident;
use crate::check::travel::incidents;
use crate::check::{Facts, Rule};

pub(super) const RULE: Rule = Rule { code: "uncalculable-contour", severity: Severity::Warning, run };

/// The rules that say more precisely what cannot be calculated.
const READ: [&str; 5] =
    ["approach-wrong", "contour-wrong", "corner-wrong", "free-contour-wrong", "turned-contour-wrong"];

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    if found.iter().any(|known| READ.contains(&known.code)) {
        return;
    }
    for (span, own) in incidents(facts) {
        if let Incident::Incalculable(why) = own {
            found.push(rule.at(facts, *span).arg("what", *why));
        }
    }
}
