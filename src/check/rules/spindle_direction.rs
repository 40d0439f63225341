//! A cycle that works with a spindle that turns clockwise only, called while it certainly turns the other way.
//!
//! Reported once a program, of the M function that turns it the wrong way where it comes right before in the text.
use crate::base::diag::{Diagnostic, Place, Severity, Span};
use crate::check::program::each_function;
use crate::check::{Aspect, CycleCall, Facts, Pending, Rule, Tri};
use crate::program::syntax::BlockKind;

pub(super) const RULE: Rule = Rule { code: "spindle-direction", severity: Severity::Warning, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let wrong = |modal: &crate::check::Modal| {
        modal.is(Aspect::Counterclockwise) == Tri::Yes && modal.is(Aspect::Spindle) == Tri::Yes
    };
    let mut calls = facts.run.calls.iter().filter(|call| wrong(&call.modal));
    let call = calls.find_map(|call| {
        let Pending::Definition(index) = call.modal.pending else { return None };
        let own = facts.definitions.get(index as usize)?;
        own.related_cycle().is_some_and(|cycle| cycle.file.clockwise_only).then_some((call, own))
    });
    if let Some((call, own)) = call {
        let finding = |span| rule.at(facts, span).arg("cycle", own.key.to_string());
        found.push(match started(facts, call) {
            Some(span) => finding(span).related("called-here", Place::new(facts.program.source(), call.span)),
            None => finding(call.span),
        });
    }
}

/// The block before a call that starts the spindle, with nothing between that may be come to from elsewhere.
fn started(facts: &Facts<'_>, call: &CycleCall) -> Option<Span> {
    for block in facts.program.blocks().get(..call.block)?.iter().rev() {
        let (mut on, mut other) = (false, false);
        each_function(block, |number| match number {
            4 | 14 => on = true,
            3 | 13 => other = true,
            _ => {}
        });
        if on && !other {
            return Some(facts.content(block));
        }
        if other || matches!(block.kind, BlockKind::Lbl(_)) {
            return None;
        }
    }
    None
}
