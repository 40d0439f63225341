//! The spindle is turned on before any tool call has given a speed, be it that none comes before.
//!
//! Reported once a program. Before the first tool call only in programs that name their blank and call a tool later:
//! others may go on with a spindle that turns already. The same for another tool that is called without a speed after the
//! tools before it had one: it would turn at theirs.
use crate::base::diag::{Diagnostic, Severity};
use crate::check::tools::named;
use crate::check::{Aspect, Facts, Modal, Rule, Tri};
use crate::program::syntax::{Block, BlockKind};

pub(super) const RULE: Rule = Rule { code: "speed-missing", severity: Severity::Warning, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let before = found.len();
    without_any(rule, facts, found);
    if found.len() == before {
        of_tool_before(rule, facts, found);
    }
}

/// A tool that is called without a speed, and then turned on, after another tool that was called with one.
fn of_tool_before(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    // The tool that was called last with a speed, and whether another one follows it without.
    let (mut last, mut lacks) = (None, false);
    for (_, block) in facts.marked() {
        if let BlockKind::ToolCall(call) = &block.kind {
            let Some(tool) = call.tool else {
                lacks &= call.speed.is_none();
                continue;
            };
            let name = named(facts, tool);
            if call.speed.is_some() || call.cutting_speed.is_some() {
                (last, lacks) = (name.map(|name| name.key()), false);
            } else {
                lacks = last.zip(name).is_some_and(|(last, name)| last != name.key());
            }
        } else if lacks {
            let functions = facts.functions(block);
            if let Some(function) = functions.iter().find(|function| matches!(function.number, 3 | 4 | 13 | 14)) {
                found.push(rule.at(facts, function.span));
                return;
            }
        }
    }
}

fn without_any(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
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
