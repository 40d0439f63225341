//! A turning cycle that begins elsewhere than where the tool is: the tool is beyond the end of the contour, or the
//! contour ends at a positive Z and leads away from the part. Also, where an execution shows it: a tool whose name says
//! that it is for inside, or that has turned there, turns outside, or the other way round; turning inside begins beside
//! the hole that is there, or with a bar that is wider.
//!
//! Only where the last movements before the call say where the tool is, and no datum shift is active. A contour is only
//! looked at if its cycle names its corners (TNC 640, 001: 7404-7560): those of subprograms may begin anywhere.
use std::collections::BTreeSet;

use crate::base::diag::{Diagnostic, Severity, Span};
use crate::check::incident::Incident;
use crate::check::program::{is_silent, number, with_meaning};
use crate::check::travel::first_incident;
use crate::check::{Aspect, Facts, Pending, Rule, Tri};
use crate::program::syntax::{Axis, BlockKind};
use crate::spec::Group;

pub(super) const RULE: Rule = Rule { code: "turning-start-wrong", severity: Severity::Warning, run };

/// The meanings of both ends of the contour, in X and in Z.
const DIAMETERS: [&str; 2] = ["contour-start-diameter", "contour-end-diameter"];
const LENGTHS: [&str; 2] = ["contour-start-z", "contour-end-z"];
/// The finding about the contour itself.
const OTHER: &str = "turned-contour-wrong";
/// The meaning of the pitch that only turned threads have.
const THREADED: &str = "turned-thread-pitch";

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let mut seen = BTreeSet::new();
    for call in &facts.run.calls {
        let Pending::Definition(index) = call.modal.pending else { continue };
        let Some(definition) = facts.definitions.get(index as usize) else { continue };
        // The ends of a tapered thread are on any side of the tool.
        let turns = definition
            .cycle()
            .is_some_and(|cycle| cycle.file.group == Group::Turning && with_meaning(cycle, THREADED).is_none());
        if !turns || call.modal.is(Aspect::DatumShift) != Tri::No || !seen.insert(index) {
            continue;
        }
        let read = facts.read(definition);
        let item = |meaning: &str| read.item(meaning).and_then(|item| Some((number(item)?, item.value_span)));
        let beyond = |at: f64, start: f64, end: f64| start != end && (at - end) * (end - start) > 0.0;
        let [x, z] = position(facts, call.block);
        let of = |at: Option<f64>, ends: [&str; 2]| Some((at?, item(ends[0])?, item(ends[1])?));
        let wrong = match (of(x, DIAMETERS), of(z, LENGTHS)) {
            (Some((at, (start, _), (end, span))), _) if beyond(at, start, end) => Some(("diameter", span)),
            (_, Some((at, (start, _), (end, span)))) if beyond(at, start, end) => Some(("z", span)),
            _ => z
                .zip(item(LENGTHS[1]))
                .filter(|(at, (end, _))| item(LENGTHS[0]).is_none_or(|(start, _)| start <= 0.0) && *end > at.max(0.0))
                .map(|(_, (_, span))| ("positive", span)),
        };
        // A contour that is wrong by itself is not reported again for where it begins.
        let known = |span: Span| {
            found.iter().any(|own| own.code == OTHER && own.place.as_ref().is_some_and(|p| p.span == span))
        };
        if let Some((what, span)) = wrong.filter(|(_, span)| !known(*span)) {
            found.push(rule.at(facts, span).arg("what", what).arg("value", "").arg("other", ""));
        }
    }
    sides(rule, facts, found);
}

/// What an execution shows of the side on which tools turn.
fn sides(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let other = first_incident(facts, |own| match own {
        Incident::TurnedOnOtherSide(what) => Some(what),
        _ => None,
    });
    if let Some((span, what)) = other {
        found.push(rule.at(facts, span).arg("what", what).arg("value", "").arg("other", ""));
        return;
    }
    let beside = first_incident(facts, |own| match own {
        Incident::BarBesideHole { what, bar, hole } => Some((what, bar, hole)),
        _ => None,
    });
    if let Some((span, (what, bar, hole))) = beside {
        found.push(rule.comparison(facts, span, what, bar, hole));
    }
}

/// Where the last movements before a block lead, as far as they say it: X as a diameter, and Z.
fn position(facts: &Facts<'_>, before: usize) -> [Option<f64>; 2] {
    let mut at = [None; 2];
    let mut open = [true; 2];
    for (index, block) in facts.program.blocks().iter().enumerate().take(before).rev() {
        match &block.kind {
            BlockKind::Motion(motion) => {
                let words = motion.words();
                if words.functions.iter().any(|own| matches!(own.number, 91 | 92 | 140)) {
                    break;
                }
                for (place, axis) in [Axis::X, Axis::Z].into_iter().enumerate() {
                    if let Some(coord) = words.coord(axis).filter(|_| open[place]) {
                        at[place] = facts.number(&coord.value).filter(|_| !coord.incremental);
                        open[place] = false;
                    }
                }
            }
            BlockKind::CycleDef(_) if facts.definition_at(index).is_some_and(|own| own.cycle().is_some()) => {}
            _ if is_silent(block) => {}
            _ => break,
        }
        if open == [false; 2] {
            break;
        }
    }
    at
}
