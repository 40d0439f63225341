//! M128 or FUNCTION TCPM that is certainly still active where a tool is called or the program ends.
//!
//! Each is reported once a program.
use crate::base::diag::{Diagnostic, Severity};
use crate::check::{Aspect, Facts, Rule, Tri};
use crate::program::syntax::BlockKind;

pub(super) const RULE: Rule = Rule { code: "tcpm-left-on", severity: Severity::Warning, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let calls = facts.marked().find(|(index, block)| {
        matches!(&block.kind, BlockKind::ToolCall(call) if call.tool.is_some())
            && facts.run.before(*index).is_some_and(|modal| modal.is(Aspect::Tcpm) == Tri::Yes)
    });
    if let Some((_, block)) = calls {
        found.push(rule.at(facts, facts.content(block)).arg("what", "tool"));
    }
    let mut ends = facts.run.ends.iter().filter(|(_, modal)| modal.is(Aspect::Tcpm) == Tri::Yes);
    let end = ends.find_map(|(block, _)| facts.program.blocks().get(*block));
    if let Some(block) = end.filter(|block| !matches!(block.kind, BlockKind::EndPgm(_))) {
        found.push(rule.at(facts, facts.content(block)).arg("what", "end"));
    }
}
