//! A label that the run comes to and nothing names: a jump, a repeat or a call that was meant for it leads elsewhere.
//!
//! Only inside of subprograms: in the main part a label may be a mark for the operator. Silent in pieces of programs, where
//! a parameter chooses a label, and where blocks cannot be read.
use crate::base::diag::{Diagnostic, Severity};
use crate::check::program::stops;
use crate::check::{Facts, Mark, Rule};
use crate::program::syntax::{Block, BlockKind};

pub(super) const RULE: Rule = Rule { code: "label-unused", severity: Severity::Warning, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let graph = &facts.run.graph;
    if !facts.begins() || facts.flow.unread.any() || graph.uses.iter().any(|own| own.mark.is_none()) {
        return;
    }
    let blocks = facts.program.blocks();
    let used = |mark: &Mark| graph.uses.iter().any(|own| own.mark.as_ref() == Some(mark));
    for (mark, places) in &graph.labels {
        let [only] = places.as_slice() else { continue };
        // What the run never comes to is reported as that.
        if used(mark) || facts.run.before(*only).is_none() || !is_inside(blocks, *only) {
            continue;
        }
        let Some(block) = blocks.get(*only) else { continue };
        found.push(rule.at(facts, facts.content(block)).arg("label", mark.to_string()));
    }
}

/// Whether a label is inside of a subprogram: LBL 0 follows before the program ends.
fn is_inside(blocks: &[Block], at: usize) -> bool {
    let after = blocks.get(at + 1..).unwrap_or_default();
    let ends = |block: &&Block| block.ends_subprogram() || stops(block);
    after.iter().find(ends).is_some_and(Block::ends_subprogram)
        && !matches!(after.first().map(|own| &own.kind), Some(BlockKind::Lbl(_)))
}
