//! Blocks after END PGM, which the control does not execute.
use crate::base::diag::{Diagnostic, Severity};
use crate::check::program::is_silent;
use crate::check::{Facts, Rule};
use crate::program::syntax::BlockKind;

pub(super) const RULE: Rule = Rule { code: "blocks-after-end", severity: Severity::Warning, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let Some(end) = facts.end else { return };
    let after = facts.program.blocks().get(end + 1..).unwrap_or_default();
    // The rest of an unread file is reported by a rule of its own.
    let next =
        after.iter().find(|block| !is_silent(block)).filter(|block| !matches!(block.kind, BlockKind::Unknown(_)));
    if let Some(next) = next {
        found.push(rule.at(facts, facts.content(next)));
    }
}
