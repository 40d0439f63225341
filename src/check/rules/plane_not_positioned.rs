//! A tilted working plane that leaves the rotary axes where they are, in a program that never moves one.
//!
//! PLANE with STAY only calculates the positions of the rotary axes; a block of its own is to take them there. Only
//! reported of whole programs that call no others, where material is removed later, and once a program.
use crate::base::diag::{Diagnostic, Severity};
use crate::check::cycle::removes_material;
use crate::check::{Defined, Facts, Pending, Rule};
use crate::program::syntax::{Axis, Block, BlockKind, Motion, NamedWord, Path, StatementKind, ValueKind};

pub(super) const RULE: Rule = Rule { code: "plane-not-positioned", severity: Severity::Warning, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let Some((index, block)) = facts.marked().find(|(_, block)| stays(facts, block)) else { return };
    if !facts.begins() || facts.flow.programs || facts.flow.unread.may_move() || block.skip {
        return;
    }
    let moved = facts.program.blocks().iter().any(|block| match &block.kind {
        BlockKind::Motion(motion) => motion.outline().has_coords() && turns(&motion.words()),
        BlockKind::Statement(own) => own.kind == StatementKind::Plane && !has(facts, block, "STAY"),
        _ => false,
    });
    let works = |index: u32| {
        facts.definitions.get(index as usize).and_then(Defined::related_cycle).is_some_and(removes_material)
    };
    let cuts = facts.run.calls.iter().filter(|call| call.block > index).any(|call| match call.modal.pending {
        Pending::Definition(index) => works(index),
        _ => false,
    });
    if !moved && cuts {
        found.push(rule.at(facts, facts.content(block)));
    }
}

/// Whether a block tilts the plane without moving.
fn stays(facts: &Facts<'_>, block: &Block) -> bool {
    let BlockKind::Statement(own) = &block.kind else { return false };
    let angle = |kind: ValueKind| match kind {
        ValueKind::Number(number) => number != 0.0,
        ValueKind::Q { .. } => true,
        _ => false,
    };
    // About the tool axis alone the coordinates may be turned without any rotary axis.
    let about_axis = |word: &NamedWord| facts.text(word.name).trim().eq_ignore_ascii_case("SPC");
    own.kind == StatementKind::Plane
        && own.words.iter().any(|word| angle(word.value.kind) && !about_axis(word))
        && has(facts, block, "STAY")
        && !["RESET", "ROT"].iter().any(|word| has(facts, block, word))
}

fn has(facts: &Facts<'_>, block: &Block, wanted: &str) -> bool {
    facts.text(facts.content(block)).split_ascii_whitespace().any(|word| word.eq_ignore_ascii_case(wanted))
}

/// Whether a movement turns an axis.
fn turns(motion: &Motion) -> bool {
    motion.path != Path::Cc && motion.coords.iter().any(|coord| matches!(coord.axis, Axis::A | Axis::B | Axis::C))
}
