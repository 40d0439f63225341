//! A circle about a centre, or a movement in polar coordinates, before any CC.
//!
//! Reported once a program, and only in programs that name their blank or their tools. A contour that a cycle reads is
//! looked at by itself: where the program has a CC elsewhere it is a warning, as the cycle may find that one active.
use std::collections::BTreeSet;

use crate::base::diag::{Diagnostic, Severity};
use crate::check::{Aspect, Facts, Mark, Rule, Tri, Way};
use crate::program::syntax::{Approach, Block, BlockKind, Path};

pub(super) const RULE: Rule = Rule { code: "pole-missing", severity: Severity::Error, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    for (from, to, modal) in facts.run.stretches() {
        if modal.is_none_or(|modal| modal.is(Aspect::Pole) != Tri::No) {
            continue;
        }
        let blocks = facts.program.blocks().get(from..to).unwrap_or_default();
        if let Some(block) = blocks.iter().find(|block| turns(block)) {
            found.push(rule.at(facts, facts.content(block)));
            return;
        }
    }
    let started = facts.run.before(0).is_some_and(|modal| modal.is(Aspect::Pole) == Tri::No);
    if !started || facts.flow.programs || facts.flow.unread.may_move() {
        return;
    }
    // Only programs with contours are looked through.
    let mut contours = contours(facts);
    if contours.is_empty() {
        return;
    }
    contours.sort_unstable();
    let sets = facts.program.blocks().iter().any(Block::sets_pole);
    // Labels without an end between them are followed by the same.
    let mut last: Option<(usize, Option<&Block>)> = None;
    for at in contours {
        let known = last.take().filter(|(decisive, _)| at < *decisive);
        let (_, unset) = last.insert(known.unwrap_or_else(|| unset(facts, at)));
        let Some(block) = unset else { continue };
        let severity = if sets { Severity::Warning } else { rule.severity };
        found.push(Diagnostic { severity, ..rule.at(facts, facts.content(block)) });
    }
}

/// Whether a block turns about the centre or counts from the pole.
fn turns(block: &Block) -> bool {
    let BlockKind::Motion(motion) = &block.kind else { return false };
    let polar = |form: Approach| matches!(form, Approach::Plt | Approach::Pln | Approach::Pct | Approach::Plct);
    match motion.path() {
        Path::C | Path::Cp | Path::Lp | Path::Ctp => true,
        Path::Appr(form) | Path::Dep(form) => polar(form),
        _ => false,
    }
}

/// The blocks of the labels that only cycles read.
fn contours(facts: &Facts<'_>) -> Vec<usize> {
    let graph = &facts.run.graph;
    let led = |way: fn(Way) -> bool| {
        let uses = graph.uses.iter().filter(move |own| way(own.way));
        uses.filter_map(|own| own.mark.as_ref()).collect::<BTreeSet<&Mark>>()
    };
    let (read, others) = (led(|way| way == Way::Named), led(|way| way != Way::Named));
    read.difference(&others).filter_map(|mark| graph.block_of(mark)).collect()
}

/// The first block of a contour that needs a pole and has none before it in the contour, after the place of the block
/// that decides it.
fn unset<'f>(facts: &'f Facts<'_>, label: usize) -> (usize, Option<&'f Block>) {
    let blocks = facts.program.blocks();
    for (at, block) in blocks.iter().enumerate().skip(label + 1) {
        match &block.kind {
            BlockKind::CallLbl(_) | BlockKind::FnJump(_) => return (at, None),
            _ if block.sets_pole() || block.ends_subprogram() || facts.ends(block) => return (at, None),
            _ if turns(block) => return (at, Some(block)),
            _ => {}
        }
    }
    (blocks.len(), None)
}
