//! One tool that cuts without coolant, although all the others of the program have it.
//!
//! Only where each of at least two other tools turns it on itself and it is off again when the tool is called. Probes
//! and tools that do not cut are not looked at, nor those of cycles that turn it on themselves, nor programs in which M
//! functions of the machine builder may turn it on.
use std::collections::BTreeSet;

use crate::base::diag::{Diagnostic, Severity};
use crate::check::cycle::removes_material;
use crate::check::program::{each_function, with_meaning};
use crate::check::{CycleCall, Facts, Loaded, Pending, Rule};
use crate::program::syntax::{Block, BlockKind, Compensates};

pub(super) const RULE: Rule = Rule { code: "coolant-forgotten", severity: Severity::Warning, run };

/// The meaning of the M function with which a cycle turns it on itself.
const OWN_COOLANT: &str = "coolant-on-function";

/// So many others have it.
const OTHERS: usize = 2;
/// The numbers of M functions from which on the machine builder says what they do.
const BUILDERS: std::ops::RangeInclusive<u16> = 20..=88;

/// What is done with a tool.
struct Part {
    call: usize,
    /// Whether it is on before it, and whether the tool turns it on.
    before: bool,
    on: bool,
    cuts: bool,
}

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let jumps = |(_, block): (usize, &Block)| matches!(block.kind, BlockKind::FnJump(_));
    if !facts.begins()
        || facts.flow.programs
        || facts.flow.skips
        || facts.flow.unread.any()
        || facts.marked().any(jumps)
    {
        return;
    }
    // Subprograms must leave it as it is.
    let blocks = facts.program.blocks();
    let end = blocks.iter().position(|block| facts.ends(block)).unwrap_or(blocks.len());
    let mut switched = false;
    for block in blocks.get(end + 1..).unwrap_or_default() {
        each_function(block, |number| switched |= matches!(number, 7..=9 | 13 | 14));
    }
    if switched {
        return;
    }
    let (mut parts, mut on, mut others): (Vec<Part>, bool, bool) = (Vec::new(), false, false);
    // What works through a pattern is not looked at: holes are often centred dry.
    let calls = facts.run.calls.iter().filter(|call| facts.definition_at(call.block).is_none());
    let cuts: Vec<usize> = calls.filter(|call| removes(facts, call.modal.pending)).map(|call| call.block).collect();
    let cooling: BTreeSet<usize> = facts.run.calls.iter().filter_map(|call| cools(facts, call)).collect();
    for (index, block) in facts.program.blocks().iter().enumerate() {
        if let BlockKind::ToolCall(call) = &block.kind
            && call.tool.is_some()
        {
            let cools = cooling.contains(&index);
            parts.push(Part { call: index, before: on, on: on || cools, cuts: false });
        }
        each_function(block, |number| {
            match number {
                7 | 8 | 13 | 14 => on = true,
                9 => on = false,
                own => others |= BUILDERS.contains(&own) && own != 30,
            };
        });
        let Some(part) = parts.last_mut() else { continue };
        part.on |= on;
        part.cuts |= cuts.binary_search(&index).is_ok() || mills(block) || calls_a_part(block);
        if facts.ends(block) {
            break;
        }
    }
    parts.retain(|own| own.cuts);
    let without: Vec<&Part> = parts.iter().filter(|own| !own.on).collect();
    let ([only], false) = (without.as_slice(), others) else { return };
    let named = parts.iter().filter(|own| own.on && !own.before).count();
    if named < OTHERS || named + 1 != parts.len() {
        return;
    }
    if let Some(block) = facts.program.blocks().get(only.call) {
        found.push(rule.at(facts, facts.content(block)));
    }
}

/// The tool call with whose tool a cycle works that turns the coolant on itself.
fn cools(facts: &Facts<'_>, call: &CycleCall) -> Option<usize> {
    let (Pending::Definition(index), Loaded::By(block)) = (call.modal.pending, call.modal.loaded) else { return None };
    let cycle = facts.definitions.get(index as usize)?.related_cycle()?;
    with_meaning(cycle, OWN_COOLANT).is_some().then_some(block as usize)
}

fn removes(facts: &Facts<'_>, pending: Pending) -> bool {
    match pending {
        Pending::Definition(index) => {
            facts.definitions.get(index as usize).and_then(|own| own.related_cycle()).is_some_and(removes_material)
        }
        Pending::None | Pending::Unknown => false,
    }
}

fn mills(block: &Block) -> bool {
    match &block.kind {
        BlockKind::Motion(motion) => motion.outline().compensates() == Compensates::Beside,
        _ => false,
    }
}

/// Whether a block calls a subprogram: where it is called, the tool works.
const fn calls_a_part(block: &Block) -> bool {
    matches!(block.kind, BlockKind::CallLbl(_))
}
