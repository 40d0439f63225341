//! A subprogram that is called, or a contour that a cycle reads,
//! and that comes to the end of the program without LBL 0.
//!
//! Silent where it ends with M2 or M30, which may be meant.
use std::collections::BTreeSet;

use crate::base::diag::{Diagnostic, Severity};
use crate::check::{Facts, Rule, Way};
use crate::program::syntax::{Block, BlockKind};

pub(super) const RULE: Rule = Rule { code: "subprogram-without-end", severity: Severity::Warning, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    for (mark, block) in facts.run.endless_parts() {
        if let Some(BlockKind::Lbl(label)) = facts.program.blocks().get(block).map(|block| &block.kind) {
            found.push(rule.at(facts, label.span).arg("label", mark.to_string()));
        }
    }
    contours(rule, facts, found);
}

/// Contours that cycles read, without LBL 0 anywhere after them.
fn contours(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let blocks = facts.program.blocks();
    let last = blocks.iter().rposition(Block::ends_subprogram);
    let mut reported = BTreeSet::new();
    for own in facts.run.graph.uses.iter().filter(|own| own.way == Way::Named) {
        let Some(mark) = &own.mark else { continue };
        let Some(block) = facts.run.graph.block_of(mark).filter(|block| last.is_none_or(|last| last < *block)) else {
            continue;
        };
        if let Some(BlockKind::Lbl(label)) = blocks.get(block).map(|block| &block.kind)
            && reported.insert(block)
        {
            found.push(rule.at(facts, label.span).arg("label", mark.to_string()));
        }
    }
}
