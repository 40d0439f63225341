//! A program that calls a program of its own name, with CALL PGM, a selected program or a program that is made a cycle.
//!
//! Only reported where the call names no folder.
use crate::base::diag::{Diagnostic, Severity};
use crate::check::flow::name;
use crate::check::{Facts, Rule};
use crate::program::syntax::BlockKind;

pub(super) const RULE: Rule = Rule { code: "program-calls-itself", severity: Severity::Error, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    if facts.calls.is_empty() {
        return;
    }
    let mut frames = facts.marked().filter_map(|(_, block)| match &block.kind {
        BlockKind::BeginPgm(frame) => Some(facts.text(frame.name).trim()),
        _ => None,
    });
    let Some(own) = frames.next() else { return };
    for call in facts.calls.iter().filter(|call| !call.read) {
        let called = name(facts.program, call.span);
        let stem = called.len().checked_sub(2).and_then(|at| called.split_at_checked(at));
        let called = match stem {
            Some((stem, end)) if end.eq_ignore_ascii_case(".H") => stem,
            _ => called,
        };
        if !called.is_empty() && own.eq_ignore_ascii_case(called) {
            found.push(rule.at(facts, call.span).arg("name", called.to_owned()));
        }
    }
}
