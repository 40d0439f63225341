//! A parameter of a cycle that is written between the cycle's definition and a call of it.
//!
//! The call takes the new value, which may be meant; so it is a note, and only said where it is certain which cycle
//! the next call means.
use std::collections::HashMap;

use crate::check::{Facts, Pending, Rule};
use crate::diag::{Diagnostic, Severity};
use crate::syntax::BlockKind;

pub(super) const RULE: Rule = Rule { code: "transfer-parameter-overwritten", severity: Severity::Note, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    if !facts.marked().any(|(_, block)| matches!(block.kind, BlockKind::FnAssign(_) | BlockKind::Formula(_))) {
        return;
    }
    // The last block that calls each definition.
    let mut calls: HashMap<u32, usize> = HashMap::new();
    for call in &facts.run.calls {
        if let Pending::Definition(index) = call.modal.pending {
            let last = calls.entry(index).or_default();
            *last = call.block.max(*last);
        }
    }
    for (from, to, modal) in facts.run.stretches() {
        let Some(Pending::Definition(index)) = modal.map(|modal| modal.pending) else { continue };
        let Some(definition) = facts.definitions.get(index as usize) else { continue };
        let mut read = None;
        for (block, at) in facts.program.blocks().get(from..to).unwrap_or_default().iter().zip(from..) {
            let (target, span) = match &block.kind {
                BlockKind::FnAssign(assign) => (assign.target, assign.target_span),
                BlockKind::Formula(formula) => (formula.target, formula.target_span),
                _ => continue,
            };
            if calls.get(&index).is_none_or(|last| *last <= at) {
                continue;
            }
            let definition = read.get_or_insert_with(|| facts.read(definition));
            if definition.items.iter().any(|item| item.param.is_some_and(|param| param.q == Some(target))) {
                let finding = rule.at(facts, span).arg("parameter", target.to_string());
                found.push(finding.arg("cycle", definition.key.to_string()));
            }
        }
    }
}
