//! A working plane that is certainly still tilted where the program ends, or a cycle for the working plane that the
//! program sets to 0 and never switches off.
//!
//! It stays tilted for whatever is run next. The cycle is reset in two steps: with 0 for all axes, and then once more
//! without any angle, which switches it off (TNC 640, 001: 6735-6738). The second one is only missed where the program
//! has tilted the plane before with angles that are not 0, and where no jump leaves open which definition is the last.
use super::plane_not_positioned::{angles, is_tilt, tilts};
use crate::base::diag::{Diagnostic, Severity};
use crate::check::{Aspect, Facts, Rule, Tri};

pub(super) const RULE: Rule = Rule { code: "plane-not-reset", severity: Severity::Warning, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let tilted = facts.run.ends.iter().find(|(_, modal)| modal.is(Aspect::Tilting) == Tri::Yes);
    if let Some(block) = tilted.and_then(|(block, _)| facts.program.blocks().get(*block)) {
        found.push(rule.at(facts, facts.content(block)).arg("what", "tilted"));
        return;
    }
    if facts.flow.jumps || facts.flow.programs || facts.flow.unread.any() || facts.run.ends.is_empty() {
        return;
    }
    let mut tilting = facts.definitions.iter().filter(|own| tilts(own)).rev();
    let Some(last) = tilting.next() else { return };
    let zero = angles(facts, last).next().is_some() && !is_tilt(facts, last);
    if zero && tilting.any(|own| is_tilt(facts, own)) {
        found.push(rule.at(facts, last.view.head).arg("what", "zero").arg("cycle", last.key.to_string()));
    }
}
