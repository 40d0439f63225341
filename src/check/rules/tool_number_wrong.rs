//! A tool number that no control has: negative, or above the greatest one.
//!
//! Told of numbers, and of parameters that certainly have one.
use crate::check::{Facts, Rule};
use crate::diag::{Arg, Diagnostic, Severity};
use crate::syntax::{Amount, BlockKind, Operand, ToolRef};

pub(super) const RULE: Rule = Rule { code: "tool-number-wrong", severity: Severity::Warning, run };

/// The greatest tool number with its greatest step (TNC 640, 001: 13327).
const GREATEST: f64 = 32767.9;

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    for (_, block) in facts.marked() {
        let tool = match &block.kind {
            BlockKind::ToolCall(call) => call.tool,
            BlockKind::ToolDef(definition) => Some(definition.tool),
            _ => None,
        };
        let Some(ToolRef::Number(operand)) = tool else { continue };
        if let Some(number) = number(facts, &operand)
            && !(0.0..=GREATEST).contains(&number)
        {
            found.push(rule.at(facts, operand.span).arg("tool", Arg::Number(number)));
        }
    }
}

fn number(facts: &Facts<'_>, operand: &Operand) -> Option<f64> {
    match operand.amount {
        Amount::Number(number) => Some(number),
        Amount::Q { negative, .. } => {
            facts.run.number_at(operand.span).map(|number| if negative { -number } else { number })
        }
        Amount::Text(_) => None,
    }
}
