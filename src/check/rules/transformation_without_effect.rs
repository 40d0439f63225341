//! A transformation that a preset ends before anything uses it.
//!
//! Activating a preset resets datum shift, mirroring, rotation and scaling (TNC 640, 001: 6478). A transformation that is
//! programmed directly before it acts on nothing: the program was meant the other way round. Only reported where nothing
//! but definitions of transformations comes between the two, and where the control certainly resets it.
use crate::base::diag::{Diagnostic, Severity};
use crate::check::cycle::{Effect, Then};
use crate::check::program::is_silent;
use crate::check::{Aspect, Defined, Facts, Rule, Tri};
use crate::program::syntax::BlockKind;
use crate::spec::Group;

pub(super) const RULE: Rule = Rule { code: "transformation-without-effect", severity: Severity::Warning, run };

/// What a preset resets.
const RESET: [Aspect; 5] =
    [Aspect::DatumShift, Aspect::Mirroring, Aspect::Rotation, Aspect::Scaling, Aspect::AxisScaling];

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    for (at, own) in facts.definitions.iter().enumerate().filter(|(_, own)| own.cycle().is_some_and(transforms)) {
        let Some(modal) = facts.run.before(own.view.first) else { continue };
        for aspect in RESET {
            let ends = does(own, aspect, |then| matches!(then, Then::Certain(Tri::No)));
            if !ends || modal.is(aspect) != Tri::Yes {
                continue;
            }
            let before = facts.definitions.get(..at).unwrap_or_default();
            let begun = before.iter().rev().find(|own| does(own, aspect, |then| matches!(then, Then::Written)));
            if let Some(begun) = begun.filter(|begun| idle(facts, begun, own)) {
                let finding = rule.at(facts, begun.view.head).arg("cycle", begun.key.to_string());
                found.push(finding.arg("other", own.key.to_string()));
            }
        }
    }
}

fn transforms(cycle: &crate::spec::Cycle) -> bool {
    cycle.file.group == Group::Transforms
}

/// Whether a definition does something to an aspect.
fn does(own: &Defined<'_>, aspect: Aspect, what: impl Fn(&Then) -> bool) -> bool {
    own.cycle()
        .is_some_and(|cycle| Effect::of_cycle(cycle).aspects.iter().any(|(own, then)| *own == aspect && what(then)))
}

/// Whether nothing but definitions of transformations comes between two definitions.
fn idle(facts: &Facts<'_>, begun: &Defined<'_>, end: &Defined<'_>) -> bool {
    let between = facts.program.blocks().get(begun.view.last + 1..end.view.first).unwrap_or_default();
    between.iter().enumerate().all(|(at, block)| match &block.kind {
        BlockKind::CycleDef(_) | BlockKind::OldCycleLine(_) => {
            let own = facts.definition_at(begun.view.last + 1 + at);
            own.is_none_or(|own| own.related_cycle().is_some_and(transforms))
        }
        _ => is_silent(block),
    })
}
