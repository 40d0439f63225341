//! A subprogram that is called and comes to the end of the program without LBL 0.
//!
//! Silent where it ends with M2 or M30, which may be meant.
use crate::check::{Facts, Rule};
use crate::diag::{Diagnostic, Severity};
use crate::syntax::BlockKind;

pub(super) const RULE: Rule = Rule { code: "subprogram-without-end", severity: Severity::Warning, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    for (mark, block) in facts.run.endless_parts() {
        if let Some(BlockKind::Lbl(label)) = facts.program.blocks().get(block).map(|block| &block.kind) {
            found.push(rule.at(facts, label.span).arg("label", mark.to_string()));
        }
    }
}
