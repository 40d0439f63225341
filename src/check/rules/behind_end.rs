//! Blocks behind END PGM, which the control does not execute.
use crate::check::{Facts, Rule};
use crate::diag::{Diagnostic, Severity};
use crate::syntax::BlockKind;

pub(super) const RULE: Rule = Rule { code: "behind-end", severity: Severity::Warning, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let mut acting = facts.acting().skip_while(|block| !matches!(block.kind, BlockKind::EndPgm(_)));
    // The rest of an unread file is told by itself.
    let next = acting.nth(1).filter(|block| !matches!(block.kind, BlockKind::Unknown(_)));
    if let Some(next) = next {
        found.push(rule.at(facts, facts.content(next)));
    }
}
