//! A place in the blank to which the tool goes at rapid between calls of a cycle, and at which it does nothing: M99 or
//! CYCL CALL is missing, and so is a hole.
//!
//! Only a movement in the plane alone that follows a call, in programs with a box as their blank and without
//! transformations; after it the tool is retracted, goes to the next call, or the subprogram ends. Halfway between two
//! calls, or as far from the last one as that is from the one before it, it needs neither.
use std::collections::BTreeMap;

use crate::base::diag::{Arg, Diagnostic, Severity};
use crate::check::blank::{Blank, is_unmoved};
use crate::check::contours::led;
use crate::check::flow::CycleCall;
use crate::check::program::is_silent;
use crate::check::program::words::has_function;
use crate::check::{Facts, Pending, Rule};
use crate::program::syntax::{Axis, Block, BlockKind, Element, Motion, Path};
use crate::spec::Group;

pub(super) const RULE: Rule = Rule { code: "position-without-call", severity: Severity::Warning, run };

/// Programs of more blocks are not looked at.
const MOST: usize = 3_000;

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let blank = Blank::of(facts.program).filter(|_| facts.begins());
    let blocks = facts.program.blocks();
    // Longer programs are written by posts; after M89 each position calls the cycle.
    if blocks.len() > MOST || blocks.iter().any(|block| has_function(block, &[89])) {
        return;
    }
    let calls = calls(facts);
    let called = |index: usize| calls.contains_key(&index);
    let acts: Vec<usize> =
        (0..blocks.len()).filter(|index| blocks.get(*index).is_some_and(|own| !is_silent(own))).collect();
    let (mut at, mut last, mut first) = (None, None, None);
    for (turn, index) in acts.iter().enumerate() {
        let Some(words) = blocks.get(*index).and_then(plain) else {
            // A call leaves the tool where it was.
            let keeps = matches!(blocks.get(*index).map(|own| &own.kind), Some(BlockKind::CyclCall(_)));
            at = at.filter(|_| keeps);
            continue;
        };
        if at.is_some() {
            (first, last) = (last, at);
        }
        at = led(at, &words);
        let before = turn.checked_sub(1).and_then(|before| acts.get(before)).and_then(|own| *calls.get(own)?);
        let after = acts.get(turn + 1).copied();
        let ends = after.is_some_and(|after| called(after) && !calls_here(&blocks[after]) || ends_work(&blocks[after]));
        if called(*index) || before.is_none() || !ends || !is_position(&words) {
            continue;
        }
        let next = after.and_then(|after| blocks.get(after)).and_then(plain).and_then(|words| led(at, &words));
        let halfway = at.zip(last).zip(next).is_some_and(|((at, last), next)| is_halfway(last, at, next));
        // One more of a row.
        let goes_on = at.zip(last).zip(first).is_some_and(|((at, last), first)| is_halfway(first, last, at));
        let inside = |place: &[f64; 2]| {
            let holds = blank.as_ref().is_some_and(|blank| blank.holds(place[0], place[1]));
            before == Some(true) && holds && *place != [0.0, 0.0]
        };
        let Some([x, y]) = at.filter(|place| halfway || goes_on || inside(place)) else { continue };
        let place = facts.content(&blocks[*index]);
        // One of a row of holes was reported before.
        if found.iter().any(|own| own.place.as_ref().is_some_and(|own| own.span == place)) {
            continue;
        }
        let finding = rule.at(facts, place).arg("value", Arg::Number(x));
        return found.push(finding.arg("other", Arg::Number(y)));
    }
}

/// The words of a straight movement at rapid.
fn plain(block: &Block) -> Option<Motion> {
    let BlockKind::Motion(motion) = &block.kind else { return None };
    (motion.path() == Path::L && motion.outline().is_rapid() && !block.skip).then(|| motion.words())
}

/// Whether a movement goes to a place of the plane, and does nothing else but to switch the coolant.
fn is_position(words: &Motion) -> bool {
    let flat = words.coords.iter().all(|coord| matches!(coord.axis, Axis::X | Axis::Y));
    flat && !words.coords.is_empty() && words.functions.iter().all(|own| matches!(own.number, 3 | 7 | 8 | 13))
}

/// Whether a block calls the cycle where the tool is already.
fn calls_here(block: &Block) -> bool {
    matches!(block.kind, BlockKind::CyclCall(_) | BlockKind::Functions(_))
}

/// Whether a block retracts the tool, or ends a subprogram.
fn ends_work(block: &Block) -> bool {
    match &block.kind {
        BlockKind::Motion(element) => lifts(element),
        _ => block.ends_subprogram(),
    }
}

fn lifts(element: &Element) -> bool {
    let words = element.words();
    let only = !words.coords.is_empty() && words.coords.iter().all(|coord| coord.axis == Axis::Z);
    only && element.outline().is_rapid()
}

/// Whether a place is the middle between two others.
fn is_halfway(one: [f64; 2], place: [f64; 2], other: [f64; 2]) -> bool {
    let apart = (0..2).any(|axis| (one[axis] - other[axis]).abs() > 1.0);
    apart && (0..2).all(|axis| (one[axis] + other[axis] - 2.0 * place[axis]).abs() < 1e-6)
}

/// The blocks that call cycles: whether coordinates are those of the blank there, or nothing where one of the cycles makes
/// neither holes nor pockets.
fn calls(facts: &Facts<'_>) -> BTreeMap<usize, Option<bool>> {
    let makes = |call: &CycleCall| {
        let Pending::Definition(index) = call.modal.pending else { return false };
        let group = facts.definitions.get(index as usize).and_then(|own| own.related_cycle()).map(|own| own.file.group);
        matches!(group, Some(Group::Drilling | Group::Threads | Group::Pockets))
    };
    let mut all: BTreeMap<usize, Option<bool>> = BTreeMap::new();
    for call in &facts.run.calls {
        let own = all.entry(call.block).or_insert(Some(true));
        *own = own.filter(|_| makes(call)).map(|unmoved| unmoved && is_unmoved(&call.modal));
    }
    all
}
