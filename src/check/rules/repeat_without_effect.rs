//! A repeat zero times: the part of the program is executed once, as without it.
use crate::base::diag::{Diagnostic, Severity};
use crate::check::{Facts, Rule};
use crate::program::syntax::{Amount, BlockKind};

pub(super) const RULE: Rule = Rule { code: "repeat-without-effect", severity: Severity::Warning, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    for (_, block) in facts.marked() {
        let BlockKind::CallLbl(call) = &block.kind else { continue };
        if let Some(times) = call.repeat.filter(|times| times.amount == Amount::Number(0.0)) {
            found.push(rule.at(facts, times.span));
        }
    }
}
