//! A parameter of a cycle that is written between the cycle's definition and a call of it.
//!
//! The call takes the new value, which may be meant; so it is a note, and only said where it is certain which cycle
//! the next call means.
use crate::check::{Facts, Pending, Rule};
use crate::diag::{Diagnostic, Severity};
use crate::syntax::BlockKind;

pub(super) const RULE: Rule = Rule { code: "transfer-parameter-overwritten", severity: Severity::Note, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    for (from, to, modal) in facts.run.stretches() {
        let Some(Pending::Definition(index)) = modal.map(|modal| modal.pending) else { continue };
        let Some(definition) = facts.definitions.get(index as usize) else { continue };
        for (block, at) in facts.program.blocks().get(from..to).unwrap_or_default().iter().zip(from..) {
            let (target, span) = match &block.kind {
                BlockKind::FnAssign(assign) => (assign.target, assign.target_span),
                BlockKind::Formula(formula) => (formula.target, formula.target_span),
                _ => continue,
            };
            let own = definition.items.iter().any(|item| item.param.is_some_and(|param| param.q == Some(target)));
            let called =
                |call: &crate::check::CycleCall| call.block > at && call.modal.pending == Pending::Definition(index);
            if own && facts.run.calls.iter().any(called) {
                let finding = rule.at(facts, span).arg("parameter", target.to_string());
                found.push(finding.arg("cycle", definition.key.to_string()));
            }
        }
    }
}
