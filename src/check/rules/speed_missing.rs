//! The spindle is turned on before any tool call has given a speed, be it that none comes before.
//!
//! Reported once a program. Before the first tool call only in programs that name their blank and call a tool later:
//! others may go on with a spindle that turns already.
use crate::base::diag::{Diagnostic, Severity};
use crate::check::{Aspect, Facts, Modal, Rule, Tri};
use crate::program::syntax::{Block, BlockKind};

pub(super) const RULE: Rule = Rule { code: "speed-missing", severity: Severity::Warning, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let speed = |block: &Block| match &block.kind {
        BlockKind::ToolCall(call) => call.speed.is_some() || call.cutting_speed.is_some(),
        _ => false,
    };
    let blank = facts.begins() && facts.marked().any(|(_, block)| matches!(block.kind, BlockKind::BlkForm(_)));
    let first = facts.marked().find(|(_, block)| speed(block)).map(|(index, _)| index).filter(|_| blank);
    for (from, to, modal) in facts.run.stretches() {
        let early = |modal: Modal| modal.is(Aspect::Tool) == Tri::No && first.is_none_or(|first| first < from);
        if modal.is_none_or(|modal| modal.is(Aspect::Speed) != Tri::No || early(modal)) {
            continue;
        }
        for block in facts.program.blocks().get(from..to).unwrap_or_default() {
            let functions = facts.functions(block);
            let on = functions.iter().find(|function| matches!(function.number, 3 | 4 | 13 | 14));
            if let Some(function) = on {
                found.push(rule.at(facts, function.span));
                return;
            }
        }
    }
}
