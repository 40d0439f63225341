//! A repeat whose number of times is negative or no whole number.
use crate::base::diag::{Diagnostic, Severity};
use crate::check::{Facts, Rule};
use crate::program::syntax::{Amount, BlockKind};

pub(super) const RULE: Rule = Rule { code: "repeat-count-wrong", severity: Severity::Error, run };

/// The greatest number of repeats.
const MOST: f64 = 65534.0;

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    for (_, block) in facts.marked() {
        let BlockKind::CallLbl(call) = &block.kind else { continue };
        if let Some(times) = call.repeat
            && let Amount::Number(number) = times.amount
            && (!(0.0..=MOST).contains(&number) || libm::trunc(number) != number)
        {
            found.push(rule.at(facts, times.span));
        }
    }
}
