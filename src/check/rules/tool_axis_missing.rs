//! A tool call without a tool axis where none was named before.
//!
//! Later calls may leave it out. Reported once a program, and only where no way of the run has named one. Turning tools
//! have no tool axis: nothing is reported of programs with `FUNCTION MODE TURN`.
use std::cell::LazyCell;

use crate::base::diag::{Diagnostic, Severity};
use crate::check::{Aspect, Facts, Rule, Tri};
use crate::program::syntax::{Amount, BlockKind, ToolRef};

pub(super) const RULE: Rule = Rule { code: "tool-axis-missing", severity: Severity::Warning, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let turns = LazyCell::new(|| turns(facts));
    for (from, to, modal) in facts.run.stretches() {
        if modal.is_none_or(|modal| modal.is(Aspect::Tool) != Tri::No) {
            continue;
        }
        for block in facts.program.blocks().get(from..to).unwrap_or_default() {
            let BlockKind::ToolCall(call) = &block.kind else { continue };
            // Tool 0 is none.
            let none = matches!(call.tool, Some(ToolRef::Number(own)) if own.amount == Amount::Number(0.0));
            if call.tool.is_some() && call.axis.is_none() && !none && !*turns {
                found.push(rule.at(facts, facts.content(block)));
                return;
            }
        }
    }
}

/// Whether the program switches to turning.
fn turns(facts: &Facts<'_>) -> bool {
    let is_turning = |text: &str| {
        let mut words = text.split_ascii_whitespace().skip_while(|word| word.bytes().all(|b| b.is_ascii_digit()));
        ["FUNCTION", "MODE", "TURN"].iter().all(|own| words.next().is_some_and(|word| word.eq_ignore_ascii_case(own)))
    };
    facts.program.blocks().iter().any(|block| is_turning(facts.program.slice(block.span)))
}
