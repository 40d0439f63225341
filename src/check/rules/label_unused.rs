//! A label that the run comes to and nothing names: a jump, a repeat or a call that was meant for it leads elsewhere.
//!
//! Only inside of subprograms: in the main part a label may be a mark for the operator, unless the jump after it goes back to
//! the label of another loop. Silent in pieces of programs, where
//! a parameter chooses a label, and where blocks cannot be read.
use crate::base::diag::{Diagnostic, Severity};
use crate::check::program::stops;
use crate::check::{Facts, Mark, Rule, Use, Way};
use crate::program::syntax::{Block, BlockKind};

pub(super) const RULE: Rule = Rule { code: "label-unused", severity: Severity::Warning, run };

/// Programs with more jumps, repeats and calls are written by posts.
const MANY: usize = 1 << 10;

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
        if used(mark) || facts.run.before(*only).is_none() {
            continue;
        }
        if !is_inside(blocks, *only) && !is_jumped_over(facts, *only) {
            continue;
        }
        let Some(block) = blocks.get(*only) else { continue };
        found.push(rule.at(facts, facts.content(block)).arg("label", mark.to_string()));
    }
}

/// Whether the next jump or repeat after a label in the main part goes back past it, to a label that another one before names
/// already.
fn is_jumped_over(facts: &Facts<'_>, at: usize) -> bool {
    let graph = &facts.run.graph;
    if graph.uses.len() > MANY {
        return false;
    }
    let back = |own: &&Use| matches!(own.way, Way::Jump | Way::Repeat);
    let target = |own: &Use| own.mark.as_ref().and_then(|mark| graph.block_of(mark));
    let next = graph.uses.iter().filter(back).filter(|own| own.block > at).min_by_key(|own| own.block);
    let Some((next, to)) = next.and_then(|own| Some((own, target(own)?))) else { return false };
    // Nothing else begins between the label and the jump.
    let between = facts.program.blocks().get(at + 1..next.block).unwrap_or_default();
    let plain = !between.iter().any(|block| matches!(block.kind, BlockKind::Lbl(_)));
    let before = |own: &&Use| own.block < at && own.block > to && target(own) == Some(to);
    plain && to < at && graph.uses.iter().filter(back).any(|own| before(&own))
}

/// Whether a label is inside of a subprogram: LBL 0 follows before the program ends.
fn is_inside(blocks: &[Block], at: usize) -> bool {
    let after = blocks.get(at + 1..).unwrap_or_default();
    let ends = |block: &&Block| block.ends_subprogram() || stops(block);
    after.iter().find(ends).is_some_and(Block::ends_subprogram)
        && !matches!(after.first().map(|own| &own.kind), Some(BlockKind::Lbl(_)))
}
