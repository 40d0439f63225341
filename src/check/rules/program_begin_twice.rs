//! A second BEGIN PGM before END PGM.
use crate::base::diag::{Diagnostic, Severity};
use crate::check::{Facts, Rule};
use crate::program::syntax::BlockKind;

pub(super) const RULE: Rule = Rule { code: "program-begin-twice", severity: Severity::Error, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let mut begun = false;
    for (_, block) in facts.marked() {
        match &block.kind {
            BlockKind::BeginPgm(_) if begun => found.push(rule.at(facts, facts.content(block))),
            BlockKind::BeginPgm(_) => begun = true,
            BlockKind::EndPgm(_) => return,
            _ => {}
        }
    }
}
