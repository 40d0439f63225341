//! Values that the next branch gives anew before anything reads them: the jump at the end of the branch is missing.
//!
//! A branch begins with a label that a condition jumps to, and gives numbers to parameters. Directly after them comes the
//! label of another branch that gives numbers to all of the same parameters. Also a branch that a jump on a condition passes
//! over, and that runs on into the other one, which begins in the same way and ends at a label to which nothing leads.
use std::collections::{BTreeMap, BTreeSet};

use crate::base::diag::{Diagnostic, Severity};
use crate::base::expr::{Node, QRef};
use crate::check::program::{is_silent, stops};
use crate::check::{Facts, Mark, Rule, Use, Way};
use crate::program::syntax::{Amount, Block, BlockKind, FnOp, Motion};

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
            let finding = rule.at(facts, facts.content(block)).arg("what", "values");
            found.push(finding.arg("parameter", names.join(", ")));
        }
        before = Some((end, set, last));
    }
    for (block, mark) in passed_over(facts) {
        let finding = rule.at(facts, facts.content(block)).arg("what", "variant");
        found.push(finding.arg("parameter", mark.to_string()));
    }
}

/// The last blocks of branches that run on into the other one, with the label that nothing leads to.
fn passed_over<'f>(facts: &'f Facts<'_>) -> Vec<(&'f Block, &'f Mark)> {
    let (blocks, graph) = (facts.program.blocks(), &facts.run.graph);
    let names = |mark: &Mark| graph.uses.iter().any(|own| own.mark.as_ref() == Some(mark));
    let unused = graph.labels.iter().filter(|(mark, _)| !names(mark)).filter_map(|(mark, places)| match places[..] {
        [only] => Some((only, mark)),
        _ => None,
    });
    let unused: BTreeMap<usize, &Mark> = unused.collect();
    if unused.is_empty() || graph.uses.iter().any(|own| own.mark.is_none()) {
        return Vec::new();
    }
    let leads = |to: usize| {
        let leads = move |own: &&Use| own.mark.as_ref().and_then(|mark| graph.block_of(mark)) == Some(to);
        graph.uses.iter().filter(leads)
    };
    let found = graph.uses.iter().filter(|own| own.way == Way::Jump).filter_map(|own| {
        let to = own.mark.as_ref().and_then(|mark| graph.block_of(mark)).filter(|to| *to > own.block)?;
        let next = to + 1 + blocks.get(to + 1..)?.iter().position(|own| matches!(own.kind, BlockKind::Lbl(_)))?;
        let mark = unused.get(&next)?;
        let plain = |block: &&Block| !is_silent(block);
        let [one, other] = [own.block + 1..to, to + 1..next].map(|part| blocks.get(part).unwrap_or_default());
        let conditional = |block: &Block| matches!(&block.kind, BlockKind::FnJump(jump) if jump.decided().is_none());
        let leaves = |block: &Block| {
            stops(block) || matches!(block.kind, BlockKind::FnJump(_) | BlockKind::Lbl(_)) || block.ends_subprogram()
        };
        let alike = one.iter().find(plain).zip(other.iter().find(plain)).is_some_and(|(a, b)| begins_alike(a, b));
        let single = leads(to).count() == 1 && blocks.get(own.block).is_some_and(conditional);
        let runs_on = alike && single && !one.iter().chain(other).any(leaves);
        Some((one.iter().rfind(plain)?, *mark)).filter(|_| runs_on)
    });
    found.collect()
}

/// Whether two blocks do the same with other numbers: a movement of the same axes, a tool call, or a value of a parameter.
fn begins_alike(one: &Block, other: &Block) -> bool {
    match (&one.kind, &other.kind) {
        (BlockKind::Motion(one), BlockKind::Motion(other)) => {
            let [one, other] = [one.words(), other.words()];
            let axes = |own: &Motion| own.coords.iter().map(|own| (own.axis, own.incremental)).collect::<Vec<_>>();
            let numbers = |own: &Motion| own.coords.iter().all(|own| matches!(own.value.amount, Amount::Number(_)));
            let values = |own: &Motion| own.coords.iter().map(|own| own.value.amount).collect::<Vec<_>>();
            one.path == other.path
                && !one.coords.is_empty()
                && axes(&one) == axes(&other)
                && numbers(&one)
                && numbers(&other)
                && values(&one) != values(&other)
        }
        (BlockKind::ToolCall(one), BlockKind::ToolCall(other)) => one.tool.is_some() && other.tool.is_some(),
        (BlockKind::FnAssign(one), BlockKind::FnAssign(other)) => one.target == other.target,
        (BlockKind::Formula(one), BlockKind::Formula(other)) => one.target == other.target,
        _ => false,
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
