//! A tilted working plane that leaves the rotary axes where they are, in a program that never moves one.
//!
//! PLANE with STAY only calculates the positions of the rotary axes; a block of its own is to take them there. Only
//! reported of whole programs that call no others, where material is removed later, and once a program. Whether a cycle
//! that tilts the plane positions them is up to the machine, but to do so it needs a feed and a set-up clearance in its
//! definition (001:6796): it is reported where it has no feed, and no block positions them.
use std::collections::BTreeSet;
use std::ops::Range;

use crate::base::diag::{Arg, Diagnostic, Severity};
use crate::check::cycle::{Effect, Then, removes_material};
use crate::check::{Aspect, Defined, Facts, Pending, Rule};
use crate::program::syntax::{
    Amount, Axis, Block, BlockKind, Coord, CycleForm, Element, MFunction, Motion, NamedWord, Path, StatementKind,
    ValueKind,
};

pub(super) const RULE: Rule = Rule { code: "plane-not-positioned", severity: Severity::Warning, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    after_plane(rule, facts, found);
    after_reset(rule, facts, found);
    after_cycle(rule, facts, found);
}

fn after_plane(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
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
        found.push(rule.at(facts, facts.content(block)).arg("what", "plane"));
        return;
    }
    let forgotten = facts.marked().find(|(index, block)| stays(facts, block) && is_forgotten(facts, *index, block));
    found.extend(forgotten.map(|(_, block)| rule.at(facts, facts.content(block)).arg("what", "plane")));
}

/// A reset that leaves the rotary axes where a plane has positioned them, before a cycle or a subprogram that calls
/// one.
fn after_reset(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    if !facts.begins() || facts.flow.programs || facts.flow.unread.may_move() {
        return;
    }
    let cycles: BTreeSet<usize> = facts.run.calls.iter().map(|call| call.block).collect();
    // The last reset that left the axes turned.
    let (mut turned, mut left) = (false, None);
    for (index, block) in facts.program.blocks().iter().enumerate() {
        match &block.kind {
            BlockKind::Statement(own) if own.kind == StatementKind::Plane => {
                let (resets, stays) = (has(facts, block, "RESET"), has(facts, block, "STAY"));
                left = (resets && stays && turned).then_some(block);
                turned = !stays && !resets || turned && stays;
            }
            BlockKind::Motion(motion) if motion.outline().has_coords() && turns(&motion.words()) => {
                (turned, left) = (false, None);
            }
            BlockKind::Motion(motion) if motion.functions().iter().any(is_unusual) => left = None,
            BlockKind::Functions(list) if list.iter().any(is_unusual) => left = None,
            // Up to there the order of the text is that of the run.
            BlockKind::Lbl(_) | BlockKind::FnJump(_) => return,
            BlockKind::CallLbl(call) if call.repeat.is_some() => return,
            _ => {}
        }
        let calls = |part: Range<usize>| cycles.range(part).next().is_some();
        let mut works = calls(index..index + 1);
        if matches!(block.kind, BlockKind::CallLbl(_)) && turned {
            match still(facts, index) {
                Some(part) => works |= calls(part),
                // It may position the axes by itself.
                None => (turned, left) = (false, None),
            }
        }
        if let Some(reset) = left.filter(|_| works) {
            // What an execution shows of it is the same mistake.
            let axes = ("what", Arg::Text("axes".to_owned()));
            found.retain(|own| own.code != super::plane_left_on::RULE.code || !own.args.contains(&axes));
            found.push(rule.at(facts, facts.content(reset)).arg("what", "reset"));
            return;
        }
    }
}

/// The blocks of the subprogram that a block calls, if they certainly move no rotary axis.
fn still(facts: &Facts<'_>, index: usize) -> Option<Range<usize>> {
    let label = facts.run.graph.called_from(index)?;
    let body = facts.subprogram(label)?;
    let moves = |block: &Block| match &block.kind {
        BlockKind::Motion(motion) => turns(&motion.words()),
        BlockKind::Statement(_) | BlockKind::CallLbl(_) => true,
        _ => false,
    };
    (!body.iter().any(moves)).then_some(label + 1..label + 1 + body.len())
}

/// Whether a cycle machines in a plane before an axis turns, though the program turns them after other planes; the axes
/// may already be there for the same plane.
fn is_forgotten(facts: &Facts<'_>, index: usize, block: &Block) -> bool {
    let blocks = facts.program.blocks();
    let words = |block: &Block| facts.text(facts.content(block)).to_ascii_uppercase();
    let own = words(block);
    let before = blocks.get(..index).unwrap_or_default();
    if before.iter().any(|other| stays(facts, other) && words(other) == own) {
        return false;
    }
    for (at, next) in blocks.iter().enumerate().skip(index + 1) {
        match &next.kind {
            BlockKind::Motion(motion) if motion.outline().has_coords() && turns(&motion.words()) => return false,
            BlockKind::Statement(_) | BlockKind::CallLbl(_) | BlockKind::Lbl(_) | BlockKind::CallPgm(_) => {
                return false;
            }
            BlockKind::Functions(list) if list.iter().any(is_unusual) => return false,
            _ => {}
        }
        let cuts = match &next.kind {
            BlockKind::Motion(motion) => cuts_across(motion),
            _ => false,
        };
        if cuts || facts.run.calls.iter().any(|call| call.block == at) {
            return true;
        }
    }
    false
}

/// Cycles that tilt the plane, with what follows each of them up to the next.
fn after_cycle(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    // Subprograms and labels are looked at where they are; a jump may lead anywhere.
    let jumps = || facts.marked().any(|(_, block)| matches!(block.kind, BlockKind::FnJump(_)));
    if !facts.begins() || facts.flow.programs || facts.flow.unread.may_move() || jumps() {
        return;
    }
    let tilting: Vec<_> = facts.definitions.iter().filter(|own| tilts(own)).collect();
    let mut forgotten = None;
    for (at, own) in tilting.iter().enumerate() {
        let end = tilting.get(at + 1).map_or(facts.program.blocks().len(), |next| next.view.first);
        let first = own.view.last + 1;
        let part = facts.program.blocks().get(first..end).unwrap_or_default();
        // What is after the end of the main part is looked at where it is called.
        let end = part.iter().position(|block| facts.ends(block)).map_or(end, |at| first + at + 1);
        let part = part.get(..end - first).unwrap_or_default();
        let positions = |at: usize, block: &Block| match &block.kind {
            BlockKind::CallLbl(_) => subprogram(facts, first + at).is_none_or(|body| body.iter().any(moves_axes)),
            BlockKind::Lbl(_) => true,
            _ => moves_axes(block),
        };
        let moved = part.iter().enumerate().any(|(at, block)| positions(at, block));
        if !is_tilt(facts, own) {
            continue;
        }
        let across = |block: &Block| match &block.kind {
            BlockKind::Motion(motion) => cuts_across(motion),
            _ => false,
        };
        let cuts = part.iter().any(across)
            || facts.run.calls.iter().any(|call| (own.view.last..end).contains(&call.block))
            || (first..end).any(|at| subprogram(facts, at).is_some_and(|body| body.iter().any(across)))
            || (first..end).any(|at| calls_cycle(facts, at));
        if !moved && cuts && !feeds(facts, own) {
            forgotten = forgotten.or(Some(own.view.head));
        }
    }
    if let Some(span) = forgotten {
        found.push(rule.at(facts, span).arg("what", "cycle"));
    }
}

/// Whether a block calls a subprogram in which a cycle is called.
fn calls_cycle(facts: &Facts<'_>, at: usize) -> bool {
    let label = || facts.run.graph.called_from(at);
    let Some((label, body)) = subprogram(facts, at).and_then(|body| Some((label()?, body))) else { return false };
    facts.run.calls.iter().any(|call| (label..=label + body.len()).contains(&call.block))
}

/// The blocks of the subprogram that a block calls.
fn subprogram<'f>(facts: &'f Facts<'_>, at: usize) -> Option<&'f [Block]> {
    let calls = |block: &Block| matches!(&block.kind, BlockKind::CallLbl(call) if call.repeat.is_none());
    facts.program.blocks().get(at).filter(|block| calls(block))?;
    facts.subprogram(facts.run.graph.called_from(at)?)
}

/// Whether a block may move rotary axes; to 0 they are not moved for a tilt.
fn moves_axes(block: &Block) -> bool {
    let away = |own: &Coord| {
        matches!(own.axis, Axis::A | Axis::B | Axis::C) && (own.incremental || own.value.amount != Amount::Number(0.0))
    };
    match &block.kind {
        BlockKind::Motion(motion) => {
            let turned = || motion.path() != Path::Cc && motion.words().coords.iter().any(away);
            motion.outline().has_coords() && turned() || motion.functions().iter().any(is_unusual)
        }
        BlockKind::Functions(list) => list.iter().any(is_unusual),
        BlockKind::CallLbl(call) => call.repeat.is_none(),
        BlockKind::CallPgm(_) | BlockKind::Statement(_) | BlockKind::Unknown(_) => true,
        _ => false,
    }
}

/// Whether a movement goes across the plane at a feed: what goes along the tool axis may be lifted.
fn cuts_across(motion: &Element) -> bool {
    let outline = motion.outline();
    let across = |own: &Coord| matches!(own.axis, Axis::X | Axis::Y);
    outline.has_coords() && outline.has_feed() && motion.words().coords.iter().any(across)
}

/// Whether a function may be one of the machine builder.
const fn is_unusual(own: &MFunction) -> bool {
    !matches!(own.number, 0..=9 | 13 | 14 | 30 | 89..=199)
}

/// Whether a cycle tilts the plane.
pub(super) fn tilts(own: &Defined<'_>) -> bool {
    let tilts = |cycle| {
        Effect::of_cycle(cycle)
            .aspects
            .iter()
            .any(|(aspect, then)| *aspect == Aspect::Tilting && matches!(then, Then::Written))
    };
    own.related_cycle().is_some_and(tilts)
}

/// The words of the lines of a definition.
pub(super) fn words<'d>(own: &'d Defined<'_>) -> impl Iterator<Item = &'d NamedWord> {
    let lines = match &own.view.form {
        CycleForm::Lines(lines) => lines.as_slice(),
        CycleForm::Parameters(_) => &[],
    };
    lines.iter().filter(|line| line.line > 0).flat_map(|line| &line.words)
}

/// The angles of a definition: which axis, and whether it is 0.
pub(super) fn angles<'d>(facts: &'d Facts<'_>, own: &'d Defined<'_>) -> impl Iterator<Item = (&'d str, bool)> {
    words(own).filter_map(|word| {
        let name = facts.text(word.name).trim();
        let zero = word.value.kind == ValueKind::Number(0.0);
        matches!(name, "A" | "B" | "C").then_some((name, zero))
    })
}

/// Whether a definition has an angle that is not 0.
pub(super) fn is_tilt(facts: &Facts<'_>, own: &Defined<'_>) -> bool {
    angles(facts, own).any(|(_, zero)| !zero)
}

/// Whether a definition states the feed at which the axes turn.
fn feeds(facts: &Facts<'_>, own: &Defined<'_>) -> bool {
    words(own).any(|word| facts.text(word.name).trim().starts_with('F'))
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
        && !["RESET", "COORD"].iter().any(|word| has(facts, block, word))
}

fn has(facts: &Facts<'_>, block: &Block, wanted: &str) -> bool {
    facts.text(facts.content(block)).split_ascii_whitespace().any(|word| word.eq_ignore_ascii_case(wanted))
}

/// Whether a movement turns an axis.
fn turns(motion: &Motion) -> bool {
    motion.path != Path::Cc && motion.coords.iter().any(|coord| matches!(coord.axis, Axis::A | Axis::B | Axis::C))
}
