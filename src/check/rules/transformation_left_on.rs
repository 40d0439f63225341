//! A datum shift, rotation, mirror image or scaling that is certainly still active where the program ends.
//!
//! A rotation by a parameter in a loop is one, too, where no definition of the program has the angle 0.
//!
//! A machine parameter decides whether the end of a program resets it, so this is no error. A program that ends with
//! END PGM only may set it for those that call it.
use crate::base::diag::{Diagnostic, Severity};
use crate::check::program::{number, with_meaning};
use crate::check::{Aspect, Facts, Rule, Tri, Way};
use crate::program::syntax::BlockKind;

pub(super) const RULE: Rule = Rule { code: "transformation-left-on", severity: Severity::Warning, run };

/// The meaning of an angle by which coordinates are turned.
const ANGLE: &str = "rotation-angle";

/// What may be left on, with the word by which the message knows it.
const LEFT: [(Aspect, &str); 5] = [
    (Aspect::DatumShift, "datum-shift"),
    (Aspect::Rotation, "rotation"),
    (Aspect::Mirroring, "mirroring"),
    (Aspect::Scaling, "scaling"),
    (Aspect::AxisScaling, "scaling"),
];

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    for (aspect, what) in LEFT {
        let ends = facts.run.ends.iter().filter(|(_, modal)| modal.is(aspect) == Tri::Yes);
        let mut blocks = ends.filter_map(|(block, _)| facts.program.blocks().get(*block));
        if let Some(block) = blocks.find(|block| !matches!(block.kind, BlockKind::EndPgm(_))) {
            found.push(rule.at(facts, facts.content(block)).arg("what", what));
        }
    }
    let mut ends = facts.run.ends.iter().filter(|(_, modal)| modal.is(Aspect::Rotation) == Tri::Unknown);
    let end = ends.find_map(|(block, _)| facts.program.blocks().get(*block));
    if let Some(block) = end.filter(|block| !matches!(block.kind, BlockKind::EndPgm(_)) && never_turned_back(facts)) {
        found.push(rule.at(facts, facts.content(block)).arg("what", "rotation"));
    }
}

/// Whether the program turns coordinates by the absolute value of a parameter and never back by the angle 0, nor in any other
/// way.
fn never_turned_back(facts: &Facts<'_>) -> bool {
    if facts.flow.programs || facts.flow.unread.any() {
        return false;
    }
    let loops: Vec<(usize, usize)> = facts
        .run
        .graph
        .uses
        .iter()
        .filter(|own| own.way == Way::Jump)
        .filter_map(|own| Some((facts.run.graph.block_of(own.mark.as_ref()?)?, own.block)))
        .filter(|(from, to)| from < to)
        .collect();
    // One look is enough: the first loop and the last one say which blocks may be in one.
    let range = loops.iter().map(|own| own.0).min().zip(loops.iter().map(|own| own.1).max());
    let counts = |at: usize| range.is_some_and(|(from, to)| from < at && at < to);
    let mut turns = false;
    for own in &facts.definitions {
        let Some(cycle) = own.related_cycle() else { return false };
        if with_meaning(cycle, ANGLE).is_none() {
            continue;
        }
        let related = own.as_related_cycle();
        let read = facts.read(&related);
        let Some(item) = read.item(ANGLE) else { return false };
        let written = item.printed.trim().to_ascii_uppercase();
        let incremental = written.starts_with('I') || facts.text(item.span).to_ascii_uppercase().starts_with('I');
        if incremental || number(item) == Some(0.0) {
            return false;
        }
        turns |= written.contains('Q') && counts(own.view.first);
    }
    // Functions of blocks reset it, too.
    turns && !facts.marked().any(|(_, block)| matches!(block.kind, BlockKind::Statement(_)))
}
