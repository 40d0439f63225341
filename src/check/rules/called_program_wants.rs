//! A called program that reads a free parameter to which neither it nor the calling program has given a value.
//!
//! Only in whole programs with tools and M2 or M30, which others do not call, of Q0 to Q99, and in the order of the text;
//! silent after a call of a program that is not known, or of one that may give parameters values out of sight.
use std::collections::BTreeSet;

use crate::base::diag::{Diagnostic, Severity};
use crate::base::expr::QRef;
use crate::check::{Called, Facts, Rule};
use crate::program::syntax::{BlockKind, StatementKind};

pub(super) const RULE: Rule = Rule { code: "called-program-wants", severity: Severity::Warning, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let ends = facts.run.ends.iter().any(|(block, _)| {
        facts.program.blocks().get(*block).is_some_and(|block| !matches!(block.kind, BlockKind::EndPgm(_)))
    });
    if facts.calls.is_empty() || !facts.begins() || !ends || facts.flow.unread.may_assign() {
        return;
    }
    let mut given: BTreeSet<QRef> = BTreeSet::new();
    // Labels may be come to from below: what is written anywhere counts then.
    let written = |block: &BlockKind| match block {
        BlockKind::FnAssign(own) => Some(own.target),
        BlockKind::Formula(own) => Some(own.target),
        _ => None,
    };
    if facts.flow.jumps {
        given.extend(facts.program.blocks().iter().filter_map(|block| written(&block.kind)));
    }
    let mut calls = facts.calls.iter().filter(|call| call.cycle.is_none() && !call.read).peekable();
    let cycles = facts.calls.iter().any(|call| call.cycle.is_some());
    let mut reported = BTreeSet::new();
    for (index, block) in facts.program.blocks().iter().enumerate() {
        if let BlockKind::Statement(own) = &block.kind
            && !matches!(own.kind, StatementKind::Plane | StatementKind::Trans | StatementKind::BlkForm)
        {
            return;
        }
        given.extend(written(&block.kind));
        while let Some(call) = calls.next_if(|call| call.block <= index) {
            let Called::Is { callee, round: false } = &call.called else { return };
            for q in callee.wants.iter().filter(|q| !given.contains(q)) {
                if !cycles && reported.insert(*q) {
                    let finding = rule.at(facts, call.span).arg("parameter", q.to_string());
                    found.push(finding.arg("name", facts.text(call.span).trim()));
                }
            }
            match &callee.gives {
                Some(gives) => given.extend(gives.iter().copied()),
                None => return,
            }
        }
    }
}
