//! The main part runs into a subprogram, because neither M2 nor M30 stands before it.
//!
//! Nothing is said of an M2 or M30 that may be skipped: a program that others call is left there on purpose.
//! Only said where the subprogram is called before, is not jumped to, and only subprograms or the end of the program
//! follow it: a subprogram that stands before its calls may be meant to be executed once on the way.
use crate::check::{Facts, Rule, Way};
use crate::diag::{Diagnostic, Severity};
use crate::syntax::{Block, BlockKind, Label};

pub(super) const RULE: Rule = Rule { code: "main-runs-into-subprogram", severity: Severity::Warning, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let graph = &facts.run.graph;
    let blocks = facts.program.blocks();
    for (mark, set) in &graph.labels {
        let &[at] = set.as_slice() else { continue };
        let mut uses = graph.uses.iter().filter(|own| own.mark.as_ref() == Some(mark)).peekable();
        let called = uses.peek().is_some() && uses.all(|own| own.way == Way::Call && own.block < at);
        if !called || !facts.run.main.contains(&at) || follows_end(blocks, at) || !last_part(facts, blocks, at) {
            continue;
        }
        if let Some(BlockKind::Lbl(label)) = blocks.get(at).map(|block| &block.kind) {
            found.push(rule.at(facts, label.span).arg("label", mark.to_string()));
            // Those behind it are run into for the same reason.
            return;
        }
    }
}

/// Whether the block before, comments left out, ends another subprogram, or ends the program unless it is skipped.
fn follows_end(blocks: &[Block], at: usize) -> bool {
    let before = blocks.get(..at).unwrap_or_default().iter().rev().find(|block| !silent(block));
    before.is_some_and(|block| returns(block) || (block.skip && ends(block)))
}

fn ends(block: &Block) -> bool {
    let functions = match &block.kind {
        BlockKind::Functions(functions) => functions.as_slice(),
        BlockKind::Motion(motion) => motion.functions.as_slice(),
        _ => return false,
    };
    functions.iter().any(|function| matches!(function.number, 2 | 30))
}

/// Whether behind the end of the subprogram only another one or the end of the program follows.
fn last_part(facts: &Facts<'_>, blocks: &[Block], at: usize) -> bool {
    let mut rest = blocks.get(at..).unwrap_or_default().iter().filter(|block| !silent(block));
    if !rest.any(returns) {
        return false;
    }
    match rest.next() {
        None => true,
        Some(next) => {
            matches!(next.kind, BlockKind::Lbl(_) | BlockKind::EndPgm(_)) && !facts.text(next.span).is_empty()
        }
    }
}

fn silent(block: &Block) -> bool {
    matches!(block.kind, BlockKind::Empty | BlockKind::Comment | BlockKind::Structure(_))
}

fn returns(block: &Block) -> bool {
    matches!(&block.kind, BlockKind::Lbl(label) if label.target == Label::Number(0))
}
