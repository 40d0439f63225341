//! A retraction without M91, to the height to which the same program retracts with M91 elsewhere.
//!
//! Heights in machine coordinates are zero or less near the end of the travel; in workpiece coordinates they are at the
//! workpiece or inside of it. Only movements along Z alone at rapid are looked at, directly before a tool call, a turn of
//! rotary axes, a plane, a movement with M91 or the end, or directly after a tool call. Said once a program.
use crate::base::diag::{Arg, Diagnostic, Severity};
use crate::check::program::{is_silent, stops};
use crate::check::{Facts, Rule};
use crate::program::syntax::{Axis, Block, BlockKind, Path, StatementKind};

pub(super) const RULE: Rule = Rule { code: "machine-coordinates-missing", severity: Severity::Warning, run };

/// The function for coordinates of the machine.
const MACHINE: u16 = 91;
/// The functions for other places of the machine.
const PLACES: [u16; 3] = [91, 92, 140];
/// Higher than this a height may be one of the workpiece, mm or inch.
const HIGHEST: f64 = 0.0;

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let (mut heights, mut plain) = (Vec::new(), Vec::new());
    for (index, block) in facts.program.blocks().iter().enumerate() {
        let Some((height, machine)) = retracts(facts, block) else { continue };
        if machine {
            heights.push(height);
        } else if height <= HIGHEST {
            plain.push((index, height));
        }
    }
    let forgotten = plain.into_iter().find(|(index, height)| heights.contains(height) && is_retreat(facts, *index));
    if let Some((index, height)) = forgotten
        && let Some(block) = facts.program.blocks().get(index)
    {
        found.push(rule.at(facts, facts.content(block)).arg("value", Arg::Number(height)));
    }
}

/// The height to which a movement goes at rapid, along Z alone, and whether it is one of the machine.
fn retracts(facts: &Facts<'_>, block: &Block) -> Option<(f64, bool)> {
    let BlockKind::Motion(motion) = &block.kind else { return None };
    if !motion.outline().is_rapid() || motion.path() != Path::L || !motion.outline().has_coords() {
        return None;
    }
    let mut functions = Vec::new();
    motion.each_function(|number| functions.push(number));
    let machine = functions.contains(&MACHINE);
    if !machine && functions.iter().any(|own| PLACES.contains(own)) {
        return None;
    }
    let words = motion.words();
    let [only] = words.coords.as_slice() else { return None };
    let height = facts.number(&only.value).filter(|_| only.axis == Axis::Z && !only.incremental)?;
    Some((height, machine))
}

/// Whether a movement stands where tools are changed, axes turned or the program ends.
fn is_retreat(facts: &Facts<'_>, index: usize) -> bool {
    let blocks = facts.program.blocks();
    let own = blocks.get(index).is_some_and(stops);
    let before = blocks.get(..index).unwrap_or_default().iter().rev().find(|block| !is_silent(block));
    let after = blocks.get(index + 1..).unwrap_or_default().iter().find(|block| !is_silent(block));
    let calls = |block: &Block| matches!(&block.kind, BlockKind::ToolCall(call) if call.tool.is_some());
    let follows = |block: &Block| calls(block) || stops(block) || turns(block) || is_of_machine(block);
    own || before.is_some_and(calls) || after.is_some_and(follows)
}

/// Whether a block goes to another place of the machine.
fn is_of_machine(block: &Block) -> bool {
    let mut found = false;
    if let BlockKind::Motion(motion) = &block.kind {
        motion.each_function(|number| found |= number == MACHINE);
    }
    found
}

/// Whether a block tilts the plane or turns nothing but rotary axes.
fn turns(block: &Block) -> bool {
    match &block.kind {
        BlockKind::Statement(own) => own.kind == StatementKind::Plane,
        BlockKind::Motion(motion) if motion.outline().has_coords() => {
            let rotary = |axis: Axis| matches!(axis, Axis::A | Axis::B | Axis::C);
            motion.path() == Path::L && motion.words().coords.iter().all(|own| rotary(own.axis))
        }
        _ => false,
    }
}
