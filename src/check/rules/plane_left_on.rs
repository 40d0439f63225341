//! A working plane that is still tilted where a tool is called, and was to be reset before.
//!
//! Several tools may machine in one tilted plane, so that alone is none. It is one where nothing resets the plane up to
//! the end of the program, and where a program that resets its planes before tool calls tilts the next one from a plane
//! that is still tilted, with a tool call between and nothing machined after it. So is one where the tool is placed, before
//! the plane is tilted, by the same blocks as another tool that was placed in the untilted plane. Reported once a program.
//! And where an execution shows it, a cut after the plane was reset while its rotary axes were not turned back.
use std::collections::BTreeSet;

use crate::base::diag::{Diagnostic, Severity};
use crate::check::cycle::Effect;
use crate::check::incident::Incident;
use crate::check::travel::incidents;
use crate::check::{Aspect, Defined, Facts, Rule, Tri};
use crate::program::syntax::{Axis, Block, BlockKind, Compensates, StatementKind};

pub(super) const RULE: Rule = Rule { code: "plane-left-on", severity: Severity::Warning, run };

/// What matters of a block.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Step {
    /// A tool call in a tilted plane.
    Tool(usize),
    /// One in the plane that the machine has.
    FlatTool,
    Tilt,
    Machining,
    /// From here on the plane is certainly tilted.
    Tilted,
    /// From here on it certainly is not.
    Flat,
    /// From here on nobody knows.
    Unknown,
}

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let axes = incidents(facts).iter().find(|(_, own)| *own == Incident::AxesLeftTurned);
    found.extend(axes.map(|(span, _)| rule.at(facts, *span).arg("what", "axes")));
    let steps = steps(facts);
    // Whether nothing was machined since the last tool call, the first one in the plane, the one at which a reset was
    // forgotten, and whether the program has reset a plane, and that before a tool call.
    let (mut fresh, mut in_plane, mut forgotten) = (false, None, None);
    let (mut reset, mut resets_for_tools) = (false, false);
    for (at, step) in steps.iter().enumerate() {
        match *step {
            Step::Tilted | Step::Flat => {
                reset |= *step == Step::Flat;
                (fresh, in_plane) = (false, None);
            }
            Step::Unknown => return,
            Step::FlatTool => resets_for_tools |= reset,
            Step::Tool(block) => {
                fresh = true;
                in_plane = in_plane.or(Some(block));
            }
            Step::Machining => fresh = false,
            // It may be what resets the plane.
            Step::Tilt if steps.get(at + 1) == Some(&Step::Flat) => {}
            Step::Tilt => {
                forgotten = forgotten.or(in_plane.filter(|_| fresh));
                (fresh, in_plane) = (false, None);
            }
        }
    }
    // Nothing has reset the last plane.
    let ends_tilted =
        !facts.run.ends.is_empty() && facts.run.ends.iter().all(|(_, modal)| modal.is(Aspect::Tilting) == Tri::Yes);
    let first = forgotten.filter(|_| resets_for_tools).or(in_plane.filter(|_| ends_tilted));
    let first = first.or_else(|| placed_as_untilted(facts));
    if let Some(block) = first.and_then(|block| facts.program.blocks().get(block)) {
        found.push(rule.at(facts, facts.content(block)).arg("what", "tool"));
    }
}

/// The tool call after which the tool is placed in the tilted plane, by the very blocks that have placed another one in
/// the untilted one before the plane was tilted.
fn placed_as_untilted(facts: &Facts<'_>) -> Option<usize> {
    let tilting = |at: usize| facts.run.before(at).map(|modal| modal.is(Aspect::Tilting));
    let places = |block: &Block| match &block.kind {
        BlockKind::Motion(motion) => {
            let words = motion.words();
            let of_machine = words.functions.iter().any(|own| matches!(own.number, 91 | 92));
            let in_plane = [Axis::X, Axis::Y].iter().any(|axis| words.coord(*axis).is_some_and(|own| !own.incremental));
            motion.outline().is_rapid() && in_plane && !of_machine
        }
        _ => false,
    };
    let mut untilted = BTreeSet::new();
    let (mut tool, mut moves) = (None, Vec::new());
    for (at, block) in facts.program.blocks().iter().enumerate() {
        match &block.kind {
            _ if facts.ends(block) => return None,
            BlockKind::ToolCall(call) if call.tool.is_some() => (tool, moves) = (Some(at), Vec::new()),
            BlockKind::Motion(_) if places(block) => moves.push(facts.text(facts.content(block))),
            BlockKind::Motion(motion) if motion.outline().is_rapid() => {}
            BlockKind::Statement(own) if own.kind == StatementKind::Plane => {
                match tool.and_then(tilting) {
                    Some(Tri::No) => untilted.extend(moves.drain(..)),
                    Some(Tri::Yes) if moves.iter().any(|own| untilted.contains(own)) => return tool,
                    _ => {}
                }
                tool = None;
            }
            BlockKind::Comment | BlockKind::Empty | BlockKind::Structure(_) | BlockKind::Functions(_) => {}
            _ => tool = None,
        }
    }
    None
}

/// What matters of the main program, in the order of the text.
fn steps(facts: &Facts<'_>) -> Vec<Step> {
    let mut steps = Vec::new();
    let mut before = Tri::No;
    let mut definitions = facts.definitions.iter().filter(|own| tilts(own)).map(|own| own.view.first).peekable();
    let mut shaped = facts.shaped().peekable();
    let mut calls: Vec<usize> = facts.run.calls.iter().map(|call| call.block).collect();
    calls.sort_unstable();
    let mut calls = calls.into_iter().peekable();
    for (from, to, modal) in facts.run.stretches() {
        let tilted = modal.map_or(Tri::Unknown, |modal| modal.is(Aspect::Tilting));
        if tilted != before {
            steps.push(match tilted {
                Tri::Yes => Step::Tilted,
                Tri::No => Step::Flat,
                Tri::Unknown => Step::Unknown,
            });
            before = tilted;
        }
        for (index, block) in facts.program.blocks().iter().enumerate().take(to).skip(from) {
            while definitions.next_if(|own| *own < index).is_some() {}
            while calls.next_if(|own| *own < index).is_some() {}
            while shaped.next_if(|(own, _)| *own < index).is_some() {}
            if tilted == Tri::No
                && let BlockKind::ToolCall(call) = &block.kind
                && call.tool.is_some()
            {
                steps.push(Step::FlatTool);
            }
            if tilted == Tri::Yes {
                let machines = calls.peek() == Some(&index)
                    || shaped.peek().is_some_and(|(own, block)| *own == index && is_compensated(block));
                match &block.kind {
                    BlockKind::ToolCall(call) if call.tool.is_some() => steps.push(Step::Tool(index)),
                    BlockKind::Statement(own) if own.kind == StatementKind::Plane => steps.push(Step::Tilt),
                    _ if definitions.peek() == Some(&index) => steps.push(Step::Tilt),
                    BlockKind::Motion(motion) if motion.outline().has_feed() => steps.push(Step::Machining),
                    _ if machines => steps.push(Step::Machining),
                    _ => {}
                }
            }
            if facts.ends(block) {
                return steps;
            }
        }
    }
    steps
}

fn is_compensated(block: &Block) -> bool {
    matches!(&block.kind, BlockKind::Motion(motion) if motion.outline().compensates() == Compensates::Beside)
}

/// Whether a definition tilts the plane, or resets it.
fn tilts(own: &Defined<'_>) -> bool {
    own.related_cycle()
        .is_some_and(|cycle| Effect::of_cycle(cycle).aspects.iter().any(|(aspect, _)| *aspect == Aspect::Tilting))
}
