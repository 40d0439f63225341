//! A cycle call (CYCL CALL, M99, M89) with no cycle defined before it.
//!
//! Where blocks are repeated, called or skipped, only a program that defines no cycle at all is
//! objected to; where other programs are called, none: they may define one.
use crate::check::{Event, Facts, Rule};
use crate::diag::{Diagnostic, Severity};

pub(super) const RULE: Rule = Rule { code: "called-but-not-defined", severity: Severity::Error, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    if facts.flow.programs || (facts.flow.jumps && !facts.definitions.is_empty()) {
        return;
    }
    for event in &facts.events {
        match event {
            Event::Define(_) => return,
            Event::Call { span, .. } => found.push(rule.at(facts, *span)),
            _ => {}
        }
    }
}
