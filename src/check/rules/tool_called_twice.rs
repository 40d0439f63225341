//! A tool that is called twice with nothing between: one of the two calls was to name another tool, or is left over.
//!
//! Tool 0 and calls with an oversize are passed over, as are tools that a parameter names.
use crate::base::diag::{Diagnostic, Severity};
use crate::check::program::is_silent;
use crate::check::{Facts, Rule};
use crate::program::syntax::{Amount, Block, BlockKind, ToolRef};

pub(super) const RULE: Rule = Rule { code: "tool-called-twice", severity: Severity::Warning, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    for (index, block) in facts.marked() {
        let Some(tool) = tool(facts, block).filter(|tool| *tool != "0") else { continue };
        let after = facts.program.blocks().get(index + 1..).unwrap_or_default();
        let next = after.iter().find(|block| !is_silent(block));
        if let Some(next) = next.filter(|next| self::tool(facts, next) == Some(tool)) {
            found.push(rule.at(facts, facts.content(next)).arg("tool", tool.to_owned()));
        }
    }
}

/// The tool that a block calls without an oversize, as it is written.
fn tool<'a>(facts: &Facts<'a>, block: &Block) -> Option<&'a str> {
    let BlockKind::ToolCall(call) = &block.kind else { return None };
    if block.skip || call.dl.is_some() || call.dr.is_some() || call.dr2.is_some() {
        return None;
    }
    match call.tool? {
        ToolRef::Number(number) if matches!(number.amount, Amount::Number(_)) => Some(facts.text(number.span)),
        ToolRef::Number(_) => None,
        ToolRef::Name(name) => Some(facts.text(name)),
    }
}
