//! A value that is calculated with the radius of the active tool (Q108), and read only after another tool was called: it holds
//! the radius of the tool before.
//!
//! In the order of the text, with the subprograms that are called; silent after a jump or a label, from which the value may
//! be another one.
use crate::base::diag::{Diagnostic, Severity, Span};
use crate::base::expr::{QKind, QRef};
use crate::check::program::{assigned, reads};
use crate::check::{Facts, Rule};
use crate::program::syntax::{Block, BlockKind};

pub(super) const RULE: Rule = Rule { code: "tool-radius-outdated", severity: Severity::Warning, run };

/// The parameter that holds the radius of the active tool.
const RADIUS: QRef = QRef { kind: QKind::Q, number: 108 };

/// A value that depends on the radius.
struct Value {
    q: QRef,
    place: Span,
    /// Whether another tool was called since, and nothing has read it before.
    outdated: bool,
}

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let mut values: Vec<Value> = Vec::new();
    let mut read = Vec::new();
    for (index, block) in facts.program.blocks().iter().enumerate() {
        read.clear();
        reads(block, &mut read);
        match &block.kind {
            BlockKind::Lbl(_) | BlockKind::FnJump(_) | BlockKind::CallPgm(_) => {
                values.clear();
                continue;
            }
            BlockKind::CallLbl(_) => {
                let body = facts.run.graph.called_from(index).and_then(|label| facts.subprogram(label));
                read_in(body.unwrap_or_default(), &mut read);
            }
            BlockKind::ToolCall(call) if call.tool.is_some() => {
                values.iter_mut().for_each(|own| own.outdated = true);
                continue;
            }
            _ => {}
        }
        if let Some(own) = values.iter().find(|own| own.outdated && read.iter().any(|(q, _)| *q == own.q)) {
            return found.push(rule.at(facts, own.place));
        }
        let depends = read.iter().any(|(q, _)| *q == RADIUS || values.iter().any(|own| own.q == *q));
        let target = assigned(block).map(|(q, _)| q);
        // What was used with its tool may be used again.
        values.retain(|own| Some(own.q) != target && (target.is_some() || !read.iter().any(|(q, _)| *q == own.q)));
        if let Some(q) = target.filter(|_| depends) {
            values.push(Value { q, place: facts.content(block), outdated: false });
        }
    }
}

/// What a subprogram reads before it sets it.
fn read_in(body: &[Block], read: &mut Vec<(QRef, Span)>) {
    let mut set = Vec::new();
    for block in body {
        let from = read.len();
        reads(block, read);
        let own = read.split_off(from);
        read.extend(own.into_iter().filter(|(q, _)| !set.contains(q)));
        set.extend(assigned(block).map(|(q, _)| q));
    }
}
