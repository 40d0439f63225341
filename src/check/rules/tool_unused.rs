//! A tool that is called and changed for another one in the next block.
//!
//! Tool 0, which empties the spindle, and tools that a parameter names are passed over.
use crate::base::diag::{Diagnostic, Severity};
use crate::check::program::is_silent;
use crate::check::{Facts, Rule};
use crate::program::syntax::{Amount, Block, BlockKind, ToolRef};

pub(super) const RULE: Rule = Rule { code: "tool-unused", severity: Severity::Warning, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    for (index, block) in facts.marked() {
        let Some(tool) = tool(facts, block) else { continue };
        let after = facts.program.blocks().get(index + 1..).unwrap_or_default();
        let next = after.iter().find(|block| !is_silent(block));
        if let Some(other) = next.and_then(|next| self::tool(facts, next))
            && other != tool
            && tool != "0"
            && other != "0"
        {
            found.push(rule.at(facts, facts.content(block)).arg("tool", tool.to_owned()));
        }
    }
}

/// The tool that a block calls, as it is written.
fn tool<'a>(facts: &Facts<'a>, block: &Block) -> Option<&'a str> {
    match &block.kind {
        BlockKind::ToolCall(call) if !block.skip => match call.tool? {
            ToolRef::Number(number) if matches!(number.amount, Amount::Number(_)) => Some(facts.text(number.span)),
            ToolRef::Number(_) => None,
            ToolRef::Name(name) => Some(facts.text(name)),
        },
        _ => None,
    }
}
