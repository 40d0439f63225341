//! A tool axis that does not fit: PATTERN DEF with another one than Z,
//! or a first tool call with another axis than the blank.
//!
//! A pattern is reported where the axis is certain. An angular head may well have another axis than the blank names, so
//! only a program in which no tool has the axis of the blank is reported.
use crate::base::diag::{Diagnostic, Severity};
use crate::check::{Aspect, Facts, Rule, Tri};
use crate::program::syntax::{Axis, Block, BlockKind};

pub(super) const RULE: Rule = Rule { code: "tool-axis-other", severity: Severity::Warning, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let (mut blank, mut first, mut fits): (_, Option<(&Block, Axis)>, _) = (None, None, false);
    for (index, block) in facts.marked() {
        match &block.kind {
            BlockKind::BlkForm(own) => blank = blank.or(own.axis),
            BlockKind::ToolCall(own) => {
                if let Some(axis) = own.axis {
                    fits |= blank.is_none_or(|blank| blank == axis);
                    first = first.or(Some((block, axis)));
                }
            }
            BlockKind::PatternDef(_) => {
                let modal = facts.run.before(index);
                if modal.is_some_and(|modal| modal.is(Aspect::OtherAxis) == Tri::Yes) {
                    found.push(rule.at(facts, facts.content(block)).arg("what", "pattern").arg("axis", "Z"));
                }
            }
            _ => {}
        }
    }
    if let (Some(blank), Some((block, _)), false) = (blank, first, fits) {
        found.push(rule.at(facts, facts.content(block)).arg("what", "blank").arg("axis", blank.name()));
    }
}
