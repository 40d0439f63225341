//! A parameter that the control itself writes: Q100 to Q199 hold tool data, results of cycles and the like.
//!
//! Reported once for each parameter.
use std::collections::BTreeSet;

use crate::base::diag::{Diagnostic, Severity};
use crate::base::expr::QKind;
use crate::check::{Facts, Rule};
use crate::program::syntax::BlockKind;

pub(super) const RULE: Rule = Rule { code: "reserved-parameter", severity: Severity::Warning, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let mut reported = BTreeSet::new();
    for (_, block) in facts.marked() {
        let (target, span) = match &block.kind {
            BlockKind::FnAssign(assign) => (assign.target, assign.target_span),
            BlockKind::Formula(formula) => (formula.target, formula.target_span),
            BlockKind::TextFormula(formula) => (formula.target, formula.target_span),
            _ => continue,
        };
        let reserved = matches!(target.kind, QKind::Q | QKind::Qs) && (100..200).contains(&target.number);
        if reserved && reported.insert(target) {
            found.push(rule.at(facts, span).arg("parameter", target.to_string()));
        }
    }
}
