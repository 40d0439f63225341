//! A datum shift that is reset while the working plane is still tilted that was tilted after it, or a tilted plane
//! that is reset while a rotation is still active that was switched on in it.
//!
//! With a tilted plane, transformations are reset in the reverse order of their definition (TNC 640, 001: 6836-6850).
//! Only reported of programs without jumps, where it is certain at each step what is active, and once a program.
use crate::base::diag::{Diagnostic, Severity};
use crate::check::{Aspect, Facts, Modal, Rule, Tri};

pub(super) const RULE: Rule = Rule { code: "reset-order-wrong", severity: Severity::Warning, run };

/// What is reset too early, what is still active, and how the message is called.
const ORDERS: [(Aspect, Aspect, &str); 2] =
    [(Aspect::DatumShift, Aspect::Tilting, "shift"), (Aspect::Tilting, Aspect::Rotation, "tilt")];

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    if facts.flow.jumps || facts.flow.programs || facts.flow.unread.any() {
        return;
    }
    for (outer, inner, what) in ORDERS {
        if let Some(block) = early(facts, outer, inner) {
            let head = facts.definitions.iter().find(|own| own.view.first == block).map(|own| own.view.head);
            let place = head.or_else(|| Some(facts.content(facts.program.blocks().get(block)?)));
            found.extend(place.map(|place| rule.at(facts, place).arg("what", what)));
            return;
        }
    }
}

/// The block that resets the outer one while the inner one is active that was switched on after it.
fn early(facts: &Facts<'_>, outer: Aspect, inner: Aspect) -> Option<usize> {
    let is = |modal: &Modal, aspect, value| modal.is(aspect) == value;
    let mut before: Option<Modal> = None;
    // Whether the inner one was switched on while the outer one was active.
    let mut within = false;
    for (from, _, modal) in facts.run.stretches() {
        let Some(modal) = modal else {
            (before, within) = (None, false);
            continue;
        };
        if let Some(last) = before.replace(modal) {
            let on = is(&last, inner, Tri::No) && is(&modal, inner, Tri::Yes);
            if on && is(&last, outer, Tri::Yes) && is(&modal, outer, Tri::Yes) {
                within = true;
            } else if within && is(&last, outer, Tri::Yes) && is(&modal, outer, Tri::No) && is(&modal, inner, Tri::Yes)
            {
                return from.checked_sub(1);
            }
        }
        within &= is(&modal, outer, Tri::Yes) && is(&modal, inner, Tri::Yes);
    }
    None
}
