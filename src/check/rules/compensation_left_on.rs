//! A tool change, or the end of the program, while radius compensation is certainly active.
//!
//! Of programs without a blank and a tool, which others may read as a contour, the end is passed over.
use crate::base::diag::{Diagnostic, Severity};
use crate::check::{Aspect, Facts, Rule, Tri};
use crate::program::syntax::BlockKind;

pub(super) const RULE: Rule = Rule { code: "compensation-left-on", severity: Severity::Warning, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let blocks = facts.program.blocks();
    for (from, to, modal) in facts.run.stretches() {
        if modal.is_none_or(|modal| modal.is(Aspect::Compensation) != Tri::Yes) {
            continue;
        }
        for block in blocks.get(from..to).unwrap_or_default() {
            if matches!(&block.kind, BlockKind::ToolCall(call) if call.tool.is_some()) {
                found.push(rule.at(facts, facts.content(block)));
            }
        }
    }
    // A contour that others read keeps its compensation to the end.
    let started = facts.run.before(0).is_some_and(|modal| modal.is(Aspect::Compensation) == Tri::No);
    for (block, modal) in facts.run.ends.iter().filter(|_| started) {
        if modal.is(Aspect::Compensation) == Tri::Yes
            && let Some(block) = blocks.get(*block)
        {
            found.push(rule.at(facts, facts.content(block)));
        }
    }
}
