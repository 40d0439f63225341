//! A cycle that works with a spindle that turns clockwise only, called while it certainly turns the other way.
//!
//! Said once a program.
use crate::check::{Aspect, Facts, Pending, Rule, Tri};
use crate::diag::{Diagnostic, Severity};

pub(super) const RULE: Rule = Rule { code: "spindle-direction", severity: Severity::Warning, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let wrong = |modal: &crate::check::Modal| {
        modal.is(Aspect::Counterclockwise) == Tri::Yes && modal.is(Aspect::Spindle) == Tri::Yes
    };
    let mut calls = facts.run.calls.iter().filter(|call| wrong(&call.modal));
    let call = calls.find_map(|call| {
        let Pending::Definition(index) = call.modal.pending else { return None };
        let own = facts.definitions.get(index as usize)?;
        own.kin().is_some_and(|cycle| cycle.file.clockwise_only).then_some((call.span, own))
    });
    if let Some((span, own)) = call {
        found.push(rule.at(facts, span).arg("cycle", own.key.to_string()));
    }
}
