//! Values that the next branch gives anew before anything reads them: the jump at the end of the branch is missing.
//!
//! A branch begins with a label that a condition jumps to, and gives numbers to parameters. Directly after them comes the
//! label of another branch that gives numbers to all of the same parameters.
use std::collections::BTreeSet;

use crate::base::diag::{Diagnostic, Severity};
use crate::base::expr::{Node, QRef};
use crate::check::program::is_silent;
use crate::check::{Facts, Rule, Way};
use crate::program::syntax::{Block, BlockKind, FnOp};

pub(super) const RULE: Rule = Rule { code: "branch-runs-on", severity: Severity::Warning, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let blocks = facts.program.blocks();
    let graph = &facts.run.graph;
    let jumped: BTreeSet<usize> = graph
        .uses
        .iter()
        .filter(|own| own.way == Way::Jump)
        .filter_map(|own| graph.block_of(own.mark.as_ref()?))
        .collect();
    // Each branch with the block after it and what it has set, in the order of the text.
    let mut before: Option<(usize, BTreeSet<QRef>, usize)> = None;
    for start in jumped {
        let (end, set, last) = assigned(blocks, start);
        if let Some((next, earlier, place)) = before.take()
            && next == start
            && !earlier.is_empty()
            && earlier.is_subset(&set)
            && let Some(block) = blocks.get(place)
        {
            let names: Vec<String> = earlier.iter().map(ToString::to_string).collect();
            found.push(rule.at(facts, facts.content(block)).arg("parameter", names.join(", ")));
        }
        before = Some((end, set, last));
    }
}

/// The parameters to which the blocks directly after a label give numbers: the block after them, the parameters, and the
/// last of the blocks.
fn assigned(blocks: &[Block], start: usize) -> (usize, BTreeSet<QRef>, usize) {
    let (mut set, mut last) = (BTreeSet::new(), start);
    for (at, block) in blocks.iter().enumerate().skip(start + 1) {
        let target = match &block.kind {
            _ if is_silent(block) => continue,
            _ if block.skip => None,
            BlockKind::FnAssign(own) => (own.op == FnOp::Set).then_some(own.target),
            BlockKind::Formula(own) => matches!(own.expr.node, Node::Number(_) | Node::Unary(..)).then_some(own.target),
            _ => None,
        };
        match target {
            Some(target) => {
                set.insert(target);
                last = at;
            }
            None => return (at, set, last),
        }
    }
    (blocks.len(), set, last)
}
