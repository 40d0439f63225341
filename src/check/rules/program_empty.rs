//! A file without any block: nothing but empty lines or zero bytes, as an export or a transfer that was cut off leaves
//! it. Comments are blocks: what someone has written is passed over.
use crate::base::diag::{Diagnostic, Severity, Span};
use crate::check::{Facts, Rule};
use crate::program::syntax::BlockKind;

pub(super) const RULE: Rule = Rule { code: "program-empty", severity: Severity::Error, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    if facts.program.blocks().iter().all(|block| matches!(block.kind, BlockKind::Empty)) {
        found.push(rule.at(facts, Span::new(0, 0)));
    }
}
