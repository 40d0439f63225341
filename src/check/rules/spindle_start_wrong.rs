//! A tool that machines although nothing has turned the spindle on since it was called, or with a spindle that turns
//! counter-clockwise.
//!
//! Each is reported once for a tool call. Left-hand taps and milled threads may turn that way, a cycle that taps rigidly
//! turns the spindle itself, and nothing is said in turning or after M functions of the machine builder.
use std::collections::HashSet;

use super::spindle_off::mills;
use crate::base::diag::{Diagnostic, Severity, Span};
use crate::check::cycle::{removes_material, stops_spindle};
use crate::check::incident::Incident;
use crate::check::program::{number, with_meaning};
use crate::check::travel::incidents;
use crate::check::{Aspect, CycleCall, Facts, Loaded, Modal, Pending, Rule, Tri};
use crate::program::syntax::{BlockKind, Compensates};
use crate::spec::Group;

pub(super) const RULE: Rule = Rule { code: "spindle-start-wrong", severity: Severity::Warning, run };

/// The meaning of the value by which a thread is a right-hand or left-hand one.
const PITCH: &str = "thread-pitch";

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let mut all: Vec<(Span, Loaded, &str)> = Vec::new();
    for call in &facts.run.calls {
        all.extend(judged(facts, call).map(|what| (call.span, call.modal.loaded, what)));
    }
    all.extend(contours(facts));
    let unstarted =
        incidents(facts).iter().filter(|(span, own)| *own == Incident::FeedBeforeSpindleStart && mills(facts, *span));
    all.extend(unstarted.filter_map(|(span, _)| {
        let at = facts.program.blocks().partition_point(|block| block.span.start < span.start);
        Some((*span, facts.run.before(at.saturating_sub(1))?.loaded, "missing"))
    }));
    let still = incidents(facts).iter().filter(|(_, own)| *own == Incident::CutsWithoutSpindle { unstarted: true });
    if all.iter().all(|(.., what)| *what != "missing") {
        all.extend(still.map(|(span, _)| (*span, Loaded::Unknown, "missing")));
    }
    if all.iter().all(|(.., what)| *what != "direction") {
        let backwards = incidents(facts).iter().filter(|(_, own)| *own == Incident::SpindleBackwards);
        all.extend(backwards.map(|(span, _)| (*span, Loaded::Unknown, "direction")));
    }
    all.sort_by_key(|(span, ..)| span.start);
    let mut reported = HashSet::new();
    for (span, loaded, what) in all {
        if reported.insert((loaded, what)) {
            found.push(rule.at(facts, span).arg("what", what));
        }
    }
}

/// What is wrong with the spindle where a tool cuts.
fn wrong(modal: &Modal) -> Option<&'static str> {
    let mills = modal.is(Aspect::Turning) == Tri::No && modal.is(Aspect::Tool) == Tri::Yes;
    if !mills || modal.is(Aspect::Spindle) == Tri::No {
        None
    } else if modal.is(Aspect::Unstarted) == Tri::Yes {
        Some("missing")
    } else if modal.is(Aspect::Counterclockwise) == Tri::Yes && modal.is(Aspect::Spindle) == Tri::Yes {
        Some("direction")
    } else {
        None
    }
}

/// What is wrong with the spindle where a cycle is called.
fn judged(facts: &Facts<'_>, call: &CycleCall) -> Option<&'static str> {
    let Pending::Definition(index) = call.modal.pending else { return None };
    let own = facts.definitions.get(index as usize)?;
    let cycle = own.related_cycle().filter(|cycle| removes_material(cycle))?;
    let what = wrong(&call.modal)?;
    let right_hand = || {
        let related = own.as_related_cycle();
        let pitch = facts.read(&related).item(PITCH).and_then(number);
        pitch.is_some_and(|pitch| pitch > 0.0)
    };
    let certain = match what {
        "missing" => !stops_spindle(cycle),
        // Which way round it must turn for a thread its pitch says, if anything does.
        _ if cycle.file.clockwise_only => false,
        _ if cycle.file.group == Group::Threads => {
            stops_spindle(cycle) && with_meaning(cycle, PITCH).is_some() && right_hand()
        }
        _ => true,
    };
    certain.then_some(what)
}

/// The contours that begin with a spindle that is wrong.
fn contours<'f>(facts: &'f Facts<'_>) -> impl Iterator<Item = (Span, Loaded, &'static str)> + 'f {
    facts.shaped().filter_map(|(index, block)| {
        let BlockKind::Motion(motion) = &block.kind else { return None };
        let outline = motion.outline();
        // M functions of the machine builder may turn it on.
        if outline.compensates() != Compensates::Beside || outline.has_functions() {
            return None;
        }
        let modal = facts.run.before(index)?;
        Some((facts.content(block), modal.loaded, wrong(&modal)?))
    })
}
