//! A transformation that a preset ends before anything uses it, or that is defined a second time as it already is before the
//! same subprogram is called again.
//!
//! Activating a preset resets datum shift, mirroring, rotation and scaling (TNC 640, 001: 6478). A transformation that is
//! programmed directly before it acts on nothing: the program was meant the other way round. Only reported where nothing
//! but definitions of transformations comes between the two, and where the control certainly resets it.
use crate::base::diag::{Diagnostic, Severity};
use crate::check::cycle::{Effect, Then};
use crate::check::incident::Incident;
use crate::check::program::is_silent;
use crate::check::travel::incidents;
use crate::check::{Aspect, Defined, Facts, Rule, Tri};
use crate::program::syntax::{Block, BlockKind};
use crate::spec::Group;

pub(super) const RULE: Rule = Rule { code: "transformation-without-effect", severity: Severity::Warning, run };

/// What a preset resets.
const RESET: [Aspect; 5] =
    [Aspect::DatumShift, Aspect::Mirroring, Aspect::Rotation, Aspect::Scaling, Aspect::AxisScaling];

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    for (at, own) in facts.definitions.iter().enumerate().filter(|(_, own)| own.related_cycle().is_some_and(transforms))
    {
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
                found.push(finding.arg("what", "ended").arg("other", own.key.to_string()));
            }
        }
    }
    again(rule, facts, found);
}

/// Definitions that say word for word what the one of the same cycle before them has said, between two calls of the same
/// subprogram: another value was meant.
fn again(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    // What is machined twice in the same place is said there.
    let twice = |own: &Incident| matches!(own, Incident::MachinedAgain(_) | Incident::PathTwice);
    if facts.flow.programs || facts.flow.unread.any() || incidents(facts).iter().any(|(_, own)| twice(own)) {
        return;
    }
    let blocks = facts.program.blocks();
    // Between labels, jumps and repeats the order of the text is that of the run.
    let turns = |block: &Block| match &block.kind {
        BlockKind::CallLbl(call) => call.repeat.is_some(),
        BlockKind::FnJump(_) | BlockKind::Lbl(_) => true,
        _ => false,
    };
    let straight = |from: usize, to: usize| {
        !blocks.get(from..to).unwrap_or_default().iter().any(|block| turns(block) || block.skip)
    };
    let all: Vec<&Defined<'_>> =
        facts.definitions.iter().filter(|own| own.related_cycle().is_some_and(transforms)).collect();
    let words = |own: &Defined<'_>| -> Vec<&str> {
        let lines = blocks.get(own.view.first..=own.view.last).unwrap_or_default().iter();
        let code = |block| facts.text(facts.content(block)).split(';').next().unwrap_or_default();
        lines.filter(|block| !is_silent(block)).flat_map(|block| code(block).split_whitespace()).collect()
    };
    let incremental = |words: &[&str]| {
        words.iter().any(|word| word.starts_with('I') && word.bytes().any(|byte| byte.is_ascii_digit()))
    };
    let moves = |own: &Defined<'_>| {
        let modal = facts.run.before(own.view.last + 1);
        modal.is_some_and(|modal| {
            RESET.iter().any(|aspect| does(own, *aspect, |_| true) && modal.is(*aspect) == Tri::Yes)
        })
    };
    let calls = |from: usize, to: usize| {
        let part = blocks.get(from..to).unwrap_or_default().iter();
        part.filter(|block| !is_silent(block)).map(|block| match &block.kind {
            BlockKind::CallLbl(call) if call.repeat.is_none() => Some(facts.text(facts.content(block))),
            _ => None,
        })
    };
    for (at, own) in all.iter().enumerate() {
        let Some(before) = at.checked_sub(1).and_then(|at| all.get(at)).filter(|before| before.key == own.key) else {
            continue;
        };
        let said = words(own);
        if !straight(before.view.first, own.view.last + 1) {
            continue;
        }
        if said != words(before) || incremental(&said) || !moves(own) || !moves(before) {
            continue;
        }
        let between: Vec<_> = calls(before.view.last + 1, own.view.first).collect();
        let after = calls(own.view.last + 1, blocks.len()).next().flatten();
        if let [.., Some(call)] = between.as_slice()
            && after == Some(*call)
        {
            let finding = rule.at(facts, own.view.head).arg("what", "again").arg("cycle", own.key.to_string());
            found.push(finding.arg("other", before.key.to_string()));
        }
    }
}

fn transforms(cycle: &crate::spec::Cycle) -> bool {
    cycle.file.group == Group::Transforms
}

/// Whether a definition does something to an aspect.
fn does(own: &Defined<'_>, aspect: Aspect, what: impl Fn(&Then) -> bool) -> bool {
    own.related_cycle()
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
