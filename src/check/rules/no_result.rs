//! A formula that certainly has no result: it divides by zero, or takes the root of a negative number, the logarithm of
//! what is not positive, or a number that is too large.
//!
//! FN 4 with a divisor of zero is `division-by-zero`.
use crate::base::diag::{Diagnostic, Severity};
use crate::check::{Facts, Rule};

pub(super) const RULE: Rule = Rule { code: "no-result", severity: Severity::Error, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    for (span, why) in &facts.run.failing {
        found.push(rule.at(facts, *span).arg("why", *why));
    }
}
