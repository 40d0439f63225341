//! A machining cycle called, a movement with radius compensation, or one at feed into the blank, while the spindle
//! certainly is.
//!
//! Reported once a program. The spindle is still at the beginning, after M0, M2, M5, M6 and M30, and after a cycle
//! that stops it (TNC 640, 001: 2581 and 2656); after a tool call and M functions of the machine builder no one knows.
//! FUNCTION MODE TURN goes on with another spindle, which is still until it is turned on (TNC 640, 001: 7314-7321),
//! and after M305 again, in programs that turn it on with M303 or M304 elsewhere.
use crate::base::diag::{Diagnostic, Severity, Span};
use crate::check::cycle::{probes, removes_material, stops_spindle};
use crate::check::first_way::{FirstWay, Spindle};
use crate::check::incident::Incident;
use crate::check::program::{Work, each_function, with_meaning};
use crate::check::travel::incidents;
use crate::check::{Aspect, Defined, Facts, Loaded, Pending, Rule, Tri};
use crate::program::syntax::{Block, BlockKind, Compensates, StatementKind};
use crate::spec::{Cycle, Group};

pub(super) const RULE: Rule = Rule { code: "spindle-off", severity: Severity::Warning, run };

/// The meaning of the speed that a cycle drills with itself.
const OWN_SPEED: &str = "drilling-speed";

/// Whether a cycle has its own drilling speed: it turns the spindle itself (TNC 640, 001: 2281-2300).
pub(super) fn turns_spindle(cycle: &Cycle) -> bool {
    with_meaning(cycle, OWN_SPEED).is_some()
}

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let calls = facts.run.calls.iter().filter(|call| call.modal.is(Aspect::Spindle) == Tri::No).filter(|call| {
        let Pending::Definition(index) = call.modal.pending else { return false };
        let Some(cycle) = facts.definitions.get(index as usize).and_then(Defined::related_cycle) else { return false };
        // What has stopped the spindle itself also starts it.
        let again = call.modal.is(Aspect::Stopped) == Tri::Yes && stops_spindle(cycle);
        let again = again || turns_spindle(cycle);
        (removes_material(cycle) || cycle.file.group == Group::Turning) && !again
    });
    let standing =
        incidents(facts).iter().find(|(span, own)| *own == Incident::FeedWithoutSpindle && mills(facts, *span));
    let standing = standing.map(|(span, _)| *span);
    let still = incidents(facts).iter().find(|(_, own)| *own == Incident::CutsWithoutSpindle { unstarted: false });
    let still = still.map(|(span, _)| *span);
    let way = FirstWay::of(facts);
    let early = way.called().filter(|(call, own)| {
        call.spindle == Spindle::Stopped && own.work != Work::RigidTapping && own.clearance.is_some()
    });
    let all = calls
        .map(|call| call.span)
        .chain(early.map(|(call, _)| call.span))
        .chain(contour(facts))
        .chain(standing)
        .chain(still)
        .chain(turning(facts))
        .chain(stopped(facts));
    let first = all.min_by_key(|span| span.start);
    if let Some(span) = first {
        found.push(rule.at(facts, span));
    }
}

/// The first call of a turning cycle in a program that nowhere says how the turning spindle turns (TNC 640, 001:
/// 7314-7321).
fn turning(facts: &Facts<'_>) -> Option<Span> {
    let says = |own: &Block| match &own.kind {
        BlockKind::Statement(own) if own.kind == StatementKind::Function => {
            facts.text(own.head).to_ascii_uppercase().contains("TURNDATA")
        }
        _ => false,
    };
    if facts.flow.programs || facts.flow.unread.any() || facts.program.blocks().iter().any(says) {
        return None;
    }
    let turns = |index: u32| {
        facts.definitions.get(index as usize).and_then(Defined::related_cycle).map(|cycle| cycle.file.group)
            == Some(Group::Turning)
    };
    let call = facts.run.calls.iter().find(|call| match call.modal.pending {
        Pending::Definition(index) => call.modal.is(Aspect::Turning) == Tri::Yes && turns(index),
        Pending::None | Pending::Unknown => false,
    })?;
    Some(call.span)
}

/// M functions that turn the turning spindle on, and off.
const ON: [u16; 2] = [303, 304];
const OFF: u16 = 305;

/// The first call of a turning cycle after M305, in a program that turns the spindle on again for others.
fn stopped(facts: &Facts<'_>) -> Option<Span> {
    if facts.flow.jumps || facts.flow.programs || facts.flow.unread.any() {
        return None;
    }
    let (mut on, mut off, mut calls) = (false, false, facts.run.calls.iter().peekable());
    for (index, block) in facts.program.blocks().iter().enumerate() {
        each_function(block, |number| {
            if ON.contains(&number) {
                (on, off) = (true, false);
            }
        });
        while let Some(call) = calls.next_if(|call| call.block <= index) {
            let Pending::Definition(at) = call.modal.pending else { continue };
            let turns = facts.definitions.get(at as usize).and_then(Defined::related_cycle);
            let turns = turns.is_some_and(|cycle| cycle.file.group == Group::Turning);
            if call.block == index && turns && on && off && call.modal.is(Aspect::Turning) == Tri::Yes {
                return Some(call.span);
            }
        }
        each_function(block, |number| off |= number == OFF);
        if facts.ends(block) {
            break;
        }
    }
    None
}

/// Whether the tool of a movement is there to cut: it was called with a speed, and nothing is probed in the program.
pub(super) fn mills(facts: &Facts<'_>, span: Span) -> bool {
    let at = facts.program.blocks().partition_point(|block| block.span.start < span.start);
    let Some(Loaded::By(call)) = facts.run.before(at.saturating_sub(1)).map(|modal| modal.loaded) else { return false };
    let block = facts.program.blocks().get(call as usize).map(|block| &block.kind);
    let speed = match block {
        Some(BlockKind::ToolCall(call)) => call.speed.as_ref().and_then(|speed| facts.number(speed)),
        _ => None,
    };
    speed.is_some_and(|speed| speed > 0.0)
        && !facts.definitions.iter().any(|own| own.related_cycle().is_some_and(probes))
}

/// The first movement along a contour, or to one, while the spindle is stationary.
fn contour(facts: &Facts<'_>) -> Option<Span> {
    for (from, to, modal) in facts.run.stretches() {
        if modal.is_none_or(|modal| modal.is(Aspect::Spindle) != Tri::No || modal.is(Aspect::Tool) != Tri::Yes) {
            continue;
        }
        let active = modal.is_some_and(|modal| modal.is(Aspect::Compensation) == Tri::Yes);
        for block in facts.program.blocks().get(from..to).unwrap_or_default() {
            let BlockKind::Motion(motion) = &block.kind else { continue };
            let outline = motion.outline();
            let along = outline.compensates() == Compensates::Unsaid && !outline.is_rapid() && active;
            let compensated = outline.compensates() == Compensates::Beside || along;
            // M functions of the machine builder may turn it on.
            if compensated && outline.has_coords() && !outline.has_functions() {
                return Some(facts.content(block));
            }
        }
    }
    None
}
