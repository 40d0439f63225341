//! A movement along the tool axis alone while M89 still calls the cycle in every block: the tool machines the last
//! position once more. Or one to a place next to the blank, with coordinates that nothing has moved.
//!
//! M99 in the block of the last position, or the definition of another cycle, ends M89 (TNC 640, 001: 1253-1258). Only
//! reported where nothing but movements is between M89 and the movement, so that the order of the text is that of the
//! run, and once for each M89.
use crate::base::diag::{Diagnostic, Severity};
use crate::check::blank::{AXES, Blank, is_unmoved};
use crate::check::contours::moved;
use crate::check::cycle::removes_material;
use crate::check::program::each_function;
use crate::check::{Aspect, Defined, Facts, Modal, Pending, Rule, Tri};
use crate::program::syntax::{Axis, BlockKind, Path};

pub(super) const RULE: Rule = Rule { code: "modal-call-left-on", severity: Severity::Warning, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    if !facts.flow.modal {
        return;
    }
    let blank = Blank::of(facts.program);
    let (mut called, mut at) = (false, [None; 3]);
    for (index, block) in facts.program.blocks().iter().enumerate() {
        let motion = match &block.kind {
            BlockKind::Empty | BlockKind::Comment | BlockKind::Structure(_) => continue,
            BlockKind::Motion(motion) if !block.skip => motion,
            _ => {
                called = false;
                continue;
            }
        };
        let (mut on, mut off) = (false, false);
        each_function(block, |number| match number {
            89 => on = true,
            // What turns the spindle or the coolant on and off changes nothing.
            3..=5 | 7..=9 | 13 | 14 => {}
            _ => off = true,
        });
        let coords = motion.words();
        let to = moved(&coords, AXES, std::mem::take(&mut at)).unwrap_or_default();
        at = to;
        if on || off {
            called = on && !off;
            continue;
        }
        if !called {
            continue;
        }
        let along = motion.path() == Path::L && matches!(coords.coords.as_slice(), [only] if only.axis == Axis::Z);
        let beside = |modal: &Modal| match (&blank, to) {
            (Some(blank), [Some(x), Some(y), _]) => blank.lacks(x, y) && is_unmoved(modal),
            _ => false,
        };
        let modal = facts.run.before(index).filter(|modal| machines(facts, *modal));
        if modal.is_some_and(|modal| along || beside(&modal)) {
            let what = if along { "again" } else { "beside" };
            found.push(rule.at(facts, facts.content(block)).arg("what", what));
            called = false;
        }
    }
}

/// Whether a call means a cycle that machines, with the tool axis Z.
fn machines(facts: &Facts<'_>, modal: Modal) -> bool {
    let Pending::Definition(index) = modal.pending else { return false };
    let cycle = facts.definitions.get(index as usize).and_then(Defined::related_cycle);
    cycle.is_some_and(removes_material) && modal.is(Aspect::OtherAxis) == Tri::No
}
