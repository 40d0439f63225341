//! Rotary axes that move with linear ones at feed in several blocks while nothing holds the tool tip
//! in its place, in a program that switches TCPM off later: switching it on was forgotten.
//!
//! Reported once a program. A program that never speaks of M128 or TCPM may calculate the way of the tool itself. One rotary
//! axis alone makes the case only where nothing switches TCPM on, and where it tilts the tool a little while the tool moves
//! in the plane in which it is tilted: a cylinder that is turned under the tool goes farther round.
use std::collections::BTreeSet;

use crate::base::diag::{Diagnostic, Severity};
use crate::check::program::each_function;
use crate::check::{Aspect, Facts, Rule, Tri};
use crate::program::syntax::{Amount, Axis, Block, BlockKind, Path, StatementKind};

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
    let alone = !facts.marked().any(|(_, block)| switches_on(facts, block));
    let mut angles = BTreeSet::new();
    for (from, to, modal) in facts.run.stretches() {
        let off = modal.is_some_and(|modal| modal.is(Aspect::Tcpm) == Tri::No && modal.is(Aspect::Tilting) == Tri::No);
        if !off {
            (first, count) = (None, 0);
            letters.clear();
            angles.clear();
            continue;
        }
        for block in facts.program.blocks().get(from..to.min(last)).unwrap_or_default() {
            let turned = turned(block);
            if !turned.is_empty() {
                first = first.or(Some(block));
                count += 1;
                letters.extend(turned);
                angles.extend(tilted(block).filter(|_| alone));
            }
            let enough = count >= SEVERAL && letters.len() >= 2 || angles.len() >= SEVERAL;
            if let Some(first) = first.filter(|_| enough) {
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

/// The angle to which a block tilts the tool by one axis, while it moves in the plane of that, in thousandths of a degree.
fn tilted(block: &Block) -> Option<i64> {
    /// So far a tool leans over a surface.
    const MOST: f64 = 45.0;
    let BlockKind::Motion(motion) = &block.kind else { return None };
    let words = motion.words();
    let mut angles = [(Axis::A, Axis::Y), (Axis::B, Axis::X)].into_iter().filter_map(|(rotary, linear)| {
        let own = words.coord(rotary).filter(|own| !own.incremental)?;
        let (true, Amount::Number(angle)) = (words.coord(linear).is_some(), own.value.amount) else { return None };
        (angle.abs() <= MOST).then_some((angle * 1000.0).round() as i64)
    });
    angles.next().filter(|_| words.coord(Axis::Z).is_some())
}

/// Whether a block switches TCPM on.
fn switches_on(facts: &Facts<'_>, block: &Block) -> bool {
    if let BlockKind::Statement(own) = &block.kind {
        let text = facts.text(facts.content(block)).to_ascii_uppercase();
        return own.kind == StatementKind::Function && text.contains("TCPM") && !text.contains("RESET");
    }
    let mut on = false;
    each_function(block, |number| on |= number == 128);
    on
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
