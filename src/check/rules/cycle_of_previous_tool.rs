//! A cycle that one tool has machined with, called with another tool: its definition for the new one was forgotten.
//!
//! Said once a definition. Silent where it is not certain which definition or which tool a call means, and where the
//! tool call names the same tool again.
use std::collections::HashMap;

use crate::base::diag::{Diagnostic, Severity};
use crate::check::cycle::removes_material;
use crate::check::{Facts, Loaded, Pending, Rule};
use crate::program::syntax::{BlockKind, ToolRef};

pub(super) const RULE: Rule = Rule { code: "cycle-of-previous-tool", severity: Severity::Warning, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    // The tool call of the first call of each definition; nothing once it was said.
    let mut first: HashMap<u32, Option<u32>> = HashMap::new();
    let mut calls: Vec<_> = facts.run.calls.iter().collect();
    calls.sort_by_key(|call| call.block);
    for call in calls {
        let (Pending::Definition(index), Loaded::By(tool)) = (call.modal.pending, call.modal.loaded) else { continue };
        let Some(own) = facts.definitions.get(index as usize) else { continue };
        // One that is defined anew on the way is another one.
        let cycle = own.related_cycle().filter(|cycle| removes_material(cycle));
        let before = first.entry(index).or_insert(Some(tool));
        let (Some(cycle), Some(with)) = (cycle, *before) else { continue };
        if with == tool || own.view.first > tool as usize || !differ(facts, with, tool) {
            continue;
        }
        *before = None;
        found.push(rule.at(facts, call.span).arg("cycle", cycle.key.to_string()));
    }
}

/// Whether two tool calls certainly name different tools.
fn differ(facts: &Facts<'_>, one: u32, other: u32) -> bool {
    let tool = |block: u32| match facts.program.blocks().get(block as usize).map(|block| &block.kind) {
        Some(BlockKind::ToolCall(call)) => call.tool,
        _ => None,
    };
    match (tool(one), tool(other)) {
        (Some(ToolRef::Number(one)), Some(ToolRef::Number(other))) => {
            facts.number(&one).zip(facts.number(&other)).is_some_and(|(one, other)| one != other)
        }
        (Some(ToolRef::Name(one)), Some(ToolRef::Name(other))) => facts.text(one).trim() != facts.text(other).trim(),
        _ => false,
    }
}
