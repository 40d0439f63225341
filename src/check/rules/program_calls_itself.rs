//! A program that calls a program of its own name.
//!
//! Only said where the call names no folder.
use crate::check::{Facts, Rule};
use crate::diag::{Diagnostic, Severity};
use crate::syntax::BlockKind;

pub(super) const RULE: Rule = Rule { code: "program-calls-itself", severity: Severity::Error, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let mut own = None;
    for (_, block) in facts.marked() {
        match &block.kind {
            BlockKind::BeginPgm(frame) => own = Some(facts.text(frame.name).trim()),
            BlockKind::CallPgm(name) => {
                let called = facts.text(*name).trim();
                let stem = called.len().checked_sub(2).and_then(|at| called.split_at_checked(at));
                let called = match stem {
                    Some((stem, end)) if end.eq_ignore_ascii_case(".H") => stem,
                    _ => called,
                };
                if !called.is_empty() && own.is_some_and(|own| own.eq_ignore_ascii_case(called)) {
                    found.push(rule.at(facts, *name).arg("name", called));
                }
            }
            _ => {}
        }
    }
}
