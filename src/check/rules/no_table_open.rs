//! FN 27 or FN 28 before FN 26 has opened a table.
//!
//! Passed over in parts of programs and after calls of other ones.
use crate::base::diag::{Diagnostic, Severity};
use crate::check::{Facts, Rule};
use crate::program::syntax::{BlockKind, StatementKind};

pub(super) const RULE: Rule = Rule { code: "no-table-open", severity: Severity::Warning, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    if !facts.begins() || facts.flow.programs || !facts.calls.is_empty() {
        return;
    }
    for (_, block) in facts.marked() {
        match &block.kind {
            BlockKind::Statement(own) if own.kind == StatementKind::Fn(26) => return,
            // What a label leads to may come before.
            BlockKind::Lbl(_) => return,
            BlockKind::Statement(own) if matches!(own.kind, StatementKind::Fn(27 | 28)) => {
                found.push(rule.at(facts, facts.content(block)));
                return;
            }
            _ => {}
        }
    }
}
