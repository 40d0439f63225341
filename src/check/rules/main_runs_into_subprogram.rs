//! The main part runs into a subprogram, because neither M2 nor M30 comes before it.
//!
//! A contour that a cycle reads is a subprogram, too. Nothing is reported of an M2 or M30 that may be skipped: a program that others call is left there on purpose. Only
//! reported where the subprogram is called before, is not jumped to, and only subprograms or the end of the program
//! follow it: a subprogram that comes before its calls may be meant to be executed once on the way.
use std::collections::BTreeMap;

use crate::base::diag::{Diagnostic, Severity};
use crate::check::contours::ends;
use crate::check::program::{each_function, is_silent};
use crate::check::{Facts, Mark, Rule, Way};
use crate::program::syntax::{Block, BlockKind};

pub(super) const RULE: Rule = Rule { code: "main-runs-into-subprogram", severity: Severity::Warning, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let graph = &facts.run.graph;
    let blocks = facts.program.blocks();
    let returns = ends(facts);
    // Whether all that leads to a label are calls that come before it.
    let mut called: BTreeMap<&Mark, bool> = BTreeMap::new();
    for own in &graph.uses {
        if let Some(mark) = &own.mark {
            let before = graph.block_of(mark).is_some_and(|at| own.block < at);
            *called.entry(mark).or_insert(true) &= matches!(own.way, Way::Call | Way::Named) && before;
        }
    }
    for (mark, set) in &graph.labels {
        let &[at] = set.as_slice() else { continue };
        let called = called.get(mark).is_some_and(|own| *own);
        if !called || !facts.run.main.contains(&at) || follows_end(blocks, at) || !last_part(blocks, &returns, at) {
            continue;
        }
        if let Some(BlockKind::Lbl(label)) = blocks.get(at).map(|block| &block.kind) {
            found.push(rule.at(facts, label.span).arg("label", mark.to_string()));
            // Those after it are run into for the same reason.
            return;
        }
    }
}

/// Whether the block before, comments left out, ends another subprogram, or ends the program unless it is skipped.
fn follows_end(blocks: &[Block], at: usize) -> bool {
    let before = blocks.get(..at).unwrap_or_default().iter().rev().find(|block| !is_silent(block));
    before.is_some_and(|block| block.ends_subprogram() || (block.skip && ends_program(block)))
}

/// Whether M2 or M30 is in a block.
fn ends_program(block: &Block) -> bool {
    let mut ends = false;
    if matches!(block.kind, BlockKind::Functions(_) | BlockKind::Motion(_)) {
        each_function(block, |number| ends |= matches!(number, 2 | 30));
    }
    ends
}

/// Whether after the end of the subprogram only another one or the end of the program follows.
fn last_part(blocks: &[Block], returns: &[usize], at: usize) -> bool {
    let Some(end) = returns.get(returns.partition_point(|end| *end < at)) else { return false };
    let next = blocks.get(end + 1..).unwrap_or_default().iter().find(|block| !is_silent(block));
    next.is_none_or(|next| matches!(next.kind, BlockKind::Lbl(_) | BlockKind::EndPgm(_)))
}
