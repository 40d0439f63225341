//! A helix in material that goes down in one turn by more than four fifths of the width of the tool: a digit of the
//! angle is missing, or the angle is that of a part of the turns.
//!
//! Also a helix of several turns upwards that is followed by a full circle at its end, as one to a floor is: its sign
//! is wrong. And a helix of several turns, or one that goes along by more than a pitch, whose pitch is not that of the thread
//! mill in the spindle, or that cuts a left-hand thread although nothing says so.
//!
//! Only polar helices with incremental numbers; in inch programs, and where the tool is not known, 20 mm in one turn
//! are too much. Threads are milled with a feed of many revolutions, but no pitch is so large.
use crate::base::diag::{Arg, Diagnostic, Severity};
use crate::check::program::is_silent;
use crate::check::tools::{Tools, named};
use crate::check::{Facts, Loaded, Rule, is_left};
use crate::program::syntax::{Axis, Block, BlockKind, Motion, Path};

pub(super) const RULE: Rule = Rule { code: "helix-too-steep", severity: Severity::Warning, run };

/// So much in a turn is too much for any tool, mm.
const MOST: f64 = 20.0;
/// And this part of the diameter.
const STEEPEST: f64 = 0.8;
/// So many turns make a hole, degrees; a thread has one.
const TURNS: f64 = 720.0;
/// A way to a thread turns by less, degrees, or goes along it by less than so many pitches.
const HALF: f64 = 180.0;
const FAR: f64 = 1.5;
/// A pitch that differs by more than this part is another one.
const OTHER: f64 = 0.05;
/// Less than this is a way into a floor, mm.
const SHALLOW: f64 = 3.0;

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let unit = facts.millimetre();
    let tools = Tools::of(facts);
    for (index, block) in facts.program.blocks().iter().enumerate() {
        let BlockKind::Motion(motion) = &block.kind else { continue };
        if motion.path() != Path::Cp || motion.outline().is_rapid() {
            continue;
        }
        let words = motion.words();
        let incremental = |axis: Axis| incremental(facts, &words, axis);
        let (Some(angle), Some(depth)) = (incremental(Axis::Pa), incremental(Axis::Z)) else { continue };
        let Some(modal) = facts.run.before(index) else { continue };
        let tool = tools.as_ref().and_then(|tools| tools.get(modal.loaded));
        let width = tool.map(|tool| 2.0 * tool.radius);
        let most = width.map_or(MOST * unit, |width| STEEPEST * width).min(MOST * unit);
        let (again, after) = repeats(facts, index);
        let turned = angle.abs() * (again + 1.0);
        if depth > 0.0 && turned >= TURNS && is_floor(facts, facts.program.blocks().get(after..)) {
            found.push(rule.comparison(facts, facts.content(block), "up", depth, most));
        }
        let each = -depth * 360.0 / angle.abs();
        let pitch = tool.and_then(|tool| tool.pitch).filter(|pitch| {
            // In less than a turn a tool may also come to the thread, by less than the pitch.
            let far = depth.abs().min(each.abs()) > FAR * pitch && angle.abs() >= HALF;
            *pitch > 0.0 && (angle.abs() >= TURNS || far)
        });
        if let Some(pitch) = pitch.filter(|pitch| (each.abs() - pitch).abs() > OTHER * pitch && depth != 0.0) {
            let value = Arg::Number((each.abs() * 1e3).round() / 1e3);
            let finding = rule.at(facts, facts.content(block)).arg("what", "pitch").arg("value", value);
            found.push(finding.arg("other", Arg::Number(pitch)));
            continue;
        }
        let threads = tool.and_then(|tool| tool.pitch).is_some_and(|own| (each.abs() - own).abs() <= OTHER * own);
        let turns = words.counter_clockwise.unwrap_or(angle > 0.0);
        if threads && turns != (depth > 0.0) && !is_left_handed(facts, modal.loaded) {
            found.push(rule.comparison(facts, facts.content(block), "left", depth, 0.0));
            continue;
        }
        if depth < -SHALLOW * unit && angle != 0.0 && each > most + unit / 1e3 {
            found.push(rule.comparison(facts, facts.content(block), "steep", (each * 1e3).round() / 1e3, most));
        }
    }
}

/// Whether a comment, or the name of the tool, says that a thread is left-handed.
fn is_left_handed(facts: &Facts<'_>, loaded: Loaded) -> bool {
    let called = match loaded {
        Loaded::By(block) => facts.program.blocks().get(block as usize),
        Loaded::None | Loaded::Unknown => None,
    };
    let name = called.and_then(|block| match &block.kind {
        BlockKind::ToolCall(call) => named(facts, call.tool?),
        _ => None,
    });
    let listed = name.and_then(|name| facts.project?.tool_word(name, "NAME"));
    let mut comments = facts.program.blocks().iter().filter_map(|block| block.comment().map(|span| facts.text(span)));
    listed.is_some_and(is_left) || comments.any(is_left)
}

/// How often the next block repeats a part that consists of one element alone, and where the program goes on.
fn repeats(facts: &Facts<'_>, index: usize) -> (f64, usize) {
    let blocks = facts.program.blocks();
    let next = blocks.iter().enumerate().skip(index + 1).find(|(_, block)| !is_silent(block));
    let before = blocks.get(..index).and_then(|own| own.iter().rposition(|block| !is_silent(block)));
    match next.map(|(at, block)| (at, &block.kind)) {
        Some((at, BlockKind::CallLbl(call)))
            if facts.run.graph.called_from(at).is_some_and(|to| Some(to) == before) =>
        {
            let times = call.repeat.as_ref().and_then(|times| facts.number(times));
            (times.unwrap_or_default(), if times.is_some() { at + 1 } else { index + 1 })
        }
        _ => (0.0, index + 1),
    }
}

/// Whether blocks begin with a full circle at the height that was reached.
fn is_floor(facts: &Facts<'_>, blocks: Option<&[Block]>) -> bool {
    let next = blocks.and_then(|blocks| blocks.iter().find(|block| !is_silent(block)));
    let Some(BlockKind::Motion(motion)) = next.map(|block| &block.kind) else { return false };
    let words = motion.words();
    let angle = incremental(facts, &words, Axis::Pa);
    motion.path() == Path::Cp && words.coord(Axis::Z).is_none() && angle.is_some_and(|angle| angle.abs() == 360.0)
}

fn incremental(facts: &Facts<'_>, words: &Motion, axis: Axis) -> Option<f64> {
    let coord = words.coord(axis).filter(|coord| coord.incremental)?;
    facts.number(&coord.value)
}
