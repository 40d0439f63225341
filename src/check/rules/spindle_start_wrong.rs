//! A tool that machines although nothing has turned the spindle on since it was called, or with a spindle that turns
//! counter-clockwise: a mill or drill that nothing calls left-hand, or any tool where an execution shows it.
//!
//! Each is reported once for a tool call. Left-hand taps and milled threads may turn that way, a cycle that taps
//! rigidly or has its own drilling speed turns the spindle itself, and nothing is said in turning or after M functions
//! of the machine builder.
use std::collections::HashSet;

use super::spindle_off::{mills, turns_spindle};
use crate::base::diag::{Diagnostic, Severity, Span};
use crate::check::cycle::{removes_material, stops_spindle};
use crate::check::first_way::{FirstWay, Spindle};
use crate::check::incident::Incident;
use crate::check::program::{Work, number, with_meaning};
use crate::check::tools::{kind_of_call, named};
use crate::check::travel::incidents;
use crate::check::{Aspect, CycleCall, Facts, Loaded, Modal, Pending, Rule, ToolKind, ToolName, Tri, is_left};
use crate::program::syntax::{Block, BlockKind, Compensates};
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
    let way = FirstWay::of(facts);
    all.extend(unturned(way));
    all.extend(backwards(facts, way));
    all.sort_by_key(|(span, ..)| span.start);
    let mut reported = HashSet::new();
    for (span, loaded, what) in all {
        if reported.insert((loaded, what)) {
            found.push(rule.at(facts, span).arg("what", what));
        }
    }
}

/// The calls of early cycles, of which only the text knows, before which nothing turns the spindle on.
fn unturned(way: &FirstWay) -> impl Iterator<Item = (Span, Loaded, &'static str)> + '_ {
    let calls = way.called().filter(|(call, own)| {
        call.spindle == Spindle::Unstarted && own.work != Work::RigidTapping && own.clearance.is_some()
    });
    calls.filter_map(|(call, _)| Some((call.span, by(call.tool?)?, "missing")))
}

/// The tools that machine with M4 although what they are called says that they cut the other way.
///
/// Where all tools of a program turn that way, there may be an angle head that turns them back.
fn backwards(facts: &Facts<'_>, way: &FirstWay) -> Vec<(Span, Loaded, &'static str)> {
    if !way.clockwise && way.backwards.iter().any(|own| way.backwards.first().is_some_and(|one| one.tool != own.tool)) {
        return Vec::new();
    }
    let wrong = way.backwards.iter().filter(|own| turns_clockwise(facts, own.tool, own.taps));
    wrong.filter_map(|own| Some((own.span, by(own.tool)?, "direction"))).collect()
}

fn by(block: usize) -> Option<Loaded> {
    u32::try_from(block).ok().map(Loaded::By)
}

/// Whether a tool certainly cuts with a spindle that turns clockwise: nothing calls it left-hand.
fn turns_clockwise(facts: &Facts<'_>, call: usize, taps: bool) -> bool {
    let blocks = facts.program.blocks();
    let Some(BlockKind::ToolCall(own)) = blocks.get(call).map(|block| &block.kind) else { return false };
    let Some(name) = own.tool.and_then(|tool| named(facts, tool)) else { return false };
    let listed = |column: &str| facts.project.and_then(|project| project.tool_word(name, column));
    let kind = kind_of_call(facts, call).or_else(|| listed("TYP").and_then(ToolKind::of_type));
    let right = match kind {
        Some(ToolKind::Tap) => taps,
        Some(
            ToolKind::Drill
            | ToolKind::Spot
            | ToolKind::Reamer
            | ToolKind::FaceMill
            | ToolKind::EndMill
            | ToolKind::Ball
            | ToolKind::ThreadMill
            | ToolKind::Chamfer,
        ) => !taps,
        _ => false,
    };
    let comment = |block: &Block| block.comment().map(|span| facts.text(span));
    // A thread is called left-hand anywhere, a tool beside its call.
    let said: Vec<&str> = if taps {
        blocks.iter().filter_map(comment).collect()
    } else {
        blocks
            .get(call.saturating_sub(1)..(call + 2).min(blocks.len()))
            .unwrap_or_default()
            .iter()
            .filter_map(comment)
            .collect()
    };
    let own_name = match name {
        ToolName::Name(own) => Some(own),
        ToolName::Number(_) => None,
    };
    let words = ["NAME", "DOC"].into_iter().filter_map(listed).chain(own_name).chain(said);
    let turns = ["DIRECT", "DIRECT."].into_iter().filter_map(listed).any(|own| own.starts_with('-'));
    right && !turns && !words.into_iter().any(is_left)
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
    let cycle = own.related_cycle().filter(|cycle| removes_material(cycle) && !turns_spindle(cycle))?;
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
