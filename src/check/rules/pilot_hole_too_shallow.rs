//! A deepened starting point below the bottom of the hole that is there: the tool comes down to it at the feed for
//! pre-positioning, or at the slow speed for entering, in solid material. Also a tool that turns inside and goes deeper
//! than the hole that was drilled in the middle.
//!
//! Only at places that are known, in programs with a box as their blank and without transformations, or where nothing before
//! goes as deep as the starting point and the same blocks have called the cycle that made the hole; turning in an execution
//! with a round blank. Each is said once a program.
use std::collections::{BTreeMap, BTreeSet};

use crate::base::diag::{Diagnostic, Severity};
use crate::check::floors::{SURFACE, lowest_before};
use crate::check::incident::Incident;
use crate::check::program::{number, with_meaning};
use crate::check::{Aspect, Defined, Facts, Pending, Rule, Tri};
use crate::program::syntax::BlockKind;
use crate::spec::Group;

pub(super) const RULE: Rule = Rule { code: "pilot-hole-too-shallow", severity: Severity::Warning, run };

/// The meaning of the starting point, below the surface.
const DEEPENED: &str = "deepened-starting-point";
/// The meaning of the preset that a cycle activates.
const PRESET: &str = "preset-number";
/// What moves heights.
const MOVING: [Aspect; 3] = [Aspect::ShiftZ, Aspect::Scaling, Aspect::AxisScaling];
/// Longer programs are written by posts.
const LONGEST: usize = 3_000;
/// So much deeper a starting point is certainly not at the bottom of the hole, mm.
const LOWER: f64 = 0.1;

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    rule.report_first(facts, found, "start", |own| match own {
        Incident::StartBelowPilotHole { start, bottom } => Some((start, bottom)),
        _ => None,
    });
    if found.iter().all(|own| own.code != rule.code) {
        below_all(rule, facts, found);
    }
    rule.report_first(facts, found, "bored", |own| match own {
        Incident::BoredBelowHole { bar, hole } => Some((bar, hole)),
        _ => None,
    });
}

/// A starting point below everything that the program has machined before, where the places are not known.
fn below_all(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let has = |own: &Defined<'_>| own.related_cycle().is_some_and(|cycle| with_meaning(cycle, DEEPENED).is_some());
    if facts.program.blocks().len() > LONGEST || !facts.definitions.iter().any(has) {
        return;
    }
    // What a measurement leaves unknown stays as it is, where nothing else moves coordinates.
    let group = |own: &Defined<'_>| own.related_cycle().map(|cycle| cycle.file.group);
    let mut after = facts.definitions.iter().skip_while(|own| group(own) != Some(Group::Drilling));
    let shifts = |own: &Defined<'_>| own.related_cycle().is_some_and(|cycle| with_meaning(cycle, PRESET).is_none());
    let before = facts.definitions.iter().take_while(|own| group(own) != Some(Group::Drilling));
    let transforms = after.any(|own| group(own).is_none_or(|own| own == Group::Transforms));
    let transforms = transforms || before.into_iter().any(|own| group(own) == Some(Group::Transforms) && shifts(own));
    let transforms = transforms || facts.marked().any(|(_, block)| matches!(block.kind, BlockKind::Statement(_)));
    // The definitions that each block calls.
    let mut called: BTreeMap<usize, BTreeSet<usize>> = BTreeMap::new();
    for call in &facts.run.calls {
        let Pending::Definition(index) = call.modal.pending else { return };
        if MOVING.iter().any(|own| call.modal.is(*own) == Tri::Yes || transforms && call.modal.is(*own) != Tri::No) {
            return;
        }
        called.entry(call.block).or_default().insert(index as usize);
    }
    for (index, own) in facts.definitions.iter().enumerate() {
        let drills = |index: &usize| {
            let own = facts.definitions.get(*index).and_then(|own| own.related_cycle());
            own.is_some_and(|cycle| cycle.file.group == Group::Drilling)
        };
        let related = own.as_related_cycle();
        let read = facts.read(&related);
        let value = |meaning: &str| read.item(meaning).and_then(|item| Some((number(item)?, item.value_span)));
        let Some(((deepened, span), (surface, _))) = value(DEEPENED).zip(value(SURFACE)) else { continue };
        let mut calls = called.values().filter(|all| all.contains(&index)).peekable();
        let piloted = calls.peek().is_some() && calls.all(|all| all.range(..index).any(&drills));
        if deepened <= 0.0 || !piloted {
            continue;
        }
        let start = surface - deepened;
        let lowest = lowest_before(facts, index).filter(|own| start < own - LOWER * facts.millimetre());
        if let Some(lowest) = lowest {
            found.push(rule.comparison(facts, span, "start", start, lowest));
            return;
        }
    }
}
