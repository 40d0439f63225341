//! FN 4 with a divisor that is certainly zero.
use crate::base::diag::{Diagnostic, Severity};
use crate::check::{Facts, Rule};
use crate::program::syntax::{Amount, BlockKind, FnOp};

pub(super) const RULE: Rule = Rule { code: "division-by-zero", severity: Severity::Error, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    for block in facts.program.blocks() {
        let BlockKind::FnAssign(assign) = &block.kind else { continue };
        let Some(divisor) = assign.b.filter(|_| assign.op == FnOp::Div) else { continue };
        let number = match divisor.amount {
            Amount::Number(number) => Some(number),
            Amount::Q { .. } | Amount::Text(_) => facts.run.number_at(divisor.span),
        };
        if number == Some(0.0) {
            found.push(rule.at(facts, divisor.span));
        }
    }
}
