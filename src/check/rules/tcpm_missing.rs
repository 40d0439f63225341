//! Rotary axes, at least two of them, that move with linear ones at feed in several blocks while nothing holds the tool tip
//! in its place, in a program that switches TCPM off later: switching it on was forgotten.
//!
//! Reported once a program. A program that never speaks of M128 or TCPM may calculate the way of the tool itself.
use std::collections::BTreeSet;

use crate::base::diag::{Diagnostic, Severity};
use crate::check::program::each_function;
use crate::check::{Aspect, Facts, Rule, Tri};
use crate::program::syntax::{Axis, Block, BlockKind, Path, StatementKind};

pub(super) const RULE: Rule = Rule { code: "tcpm-missing", severity: Severity::Warning, run };

/// How many such movements make the case: one alone may position the axes.
const SEVERAL: usize = 3;

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let Some((last, _)) = facts.marked().filter(|(_, block)| switches_off(facts, block)).last() else { return };
    if facts.flow.jumps || facts.flow.programs || facts.flow.unread.any() {
        return;
    }
    let mut first = None;
    let mut count = 0;
    let mut letters = BTreeSet::new();
    for (from, to, modal) in facts.run.stretches() {
        let off = modal.is_some_and(|modal| modal.is(Aspect::Tcpm) == Tri::No && modal.is(Aspect::Tilting) == Tri::No);
        if !off {
            (first, count) = (None, 0);
            letters.clear();
            continue;
        }
        for block in facts.program.blocks().get(from..to.min(last)).unwrap_or_default() {
            let turned = turned(block);
            if !turned.is_empty() {
                first = first.or(Some(block));
                count += 1;
                letters.extend(turned);
            }
            if let Some(first) = first.filter(|_| count >= SEVERAL && letters.len() >= 2) {
                return found.push(rule.at(facts, facts.content(first)));
            }
        }
    }
}

/// The rotary axes that a block moves at feed together with linear ones.
fn turned(block: &Block) -> Vec<Axis> {
    let BlockKind::Motion(motion) = &block.kind else { return Vec::new() };
    if motion.path() != Path::L || motion.outline().is_rapid() || motion.has_functions() {
        return Vec::new();
    }
    let words = motion.words();
    if !words.coords.iter().any(|own| matches!(own.axis, Axis::X | Axis::Y | Axis::Z)) {
        return Vec::new();
    }
    words.coords.iter().map(|own| own.axis).filter(|own| matches!(own, Axis::A | Axis::B | Axis::C)).collect()
}

/// Whether a block switches TCPM off.
fn switches_off(facts: &Facts<'_>, block: &Block) -> bool {
    if let BlockKind::Statement(own) = &block.kind {
        let text = facts.text(facts.content(block)).to_ascii_uppercase();
        return own.kind == StatementKind::Function && text.contains("RESET TCPM");
    }
    let mut off = false;
    each_function(block, |number| off |= number == 129);
    off
}
