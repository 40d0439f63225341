//! A repeated part of a program that does the same in each pass although it goes into the blank, or that goes deeper in
//! each pass and ends far below the blank; also one that calls cycles under a transformation which is absolute.
//!
//! A part that infeeds in each pass needs an incremental value or one that a parameter changes: one that follows an
//! absolute value in the same axis is neither. Only parts are looked
//! at that consist of movements with numbers and of calls of subprograms that stay at their height, which are repeated
//! several times, in programs with a box as their blank; once is enough where the tool was brought at a feed to the
//! height from which they are to infeed, and where the part begins with an infeed and has no radius compensation. Incremental
//! infeeds after an absolute height in the part are the same on each pass.
use std::collections::BTreeMap;

use crate::base::diag::{Arg, Diagnostic, Severity};
use crate::check::blank::{Blank, is_unmoved};
use crate::check::cycle::removes_material;
use crate::check::program::is_silent;
use crate::check::{Aspect, Defined, Facts, Modal, Rule, Tri};
use crate::program::syntax::{Amount, Axis, Block, BlockKind, Compensates, Coord, Motion, Path};
use crate::spec::Group;

pub(super) const RULE: Rule = Rule { code: "repeated-infeed", severity: Severity::Warning, run };

/// One repetition may be a finishing pass.
const LEAST: f64 = 2.0;
/// So far below the blank nobody machines, in millimetres.
const BELOW: f64 = 25.0;
/// So deep subprograms of subprograms are looked at.
const NESTED: usize = 2;

/// What was found out of subprograms, by the block of their label and how deep it may go from there.
type Known = BTreeMap<(usize, usize), bool>;

/// So far through the blank the pass before the last one may go, in millimetres.
const THROUGH: f64 = 2.0;

/// What a pass does along the tool axis.
#[derive(Default)]
struct Pass {
    /// Whether anything depends on what was before: incremental values, polar ones, parameters.
    changes: bool,
    /// The axes of the plane that an absolute value has set: what is incremental after it is the same in each pass.
    set: Vec<Axis>,
    /// The lowest absolute height.
    lowest: Option<f64>,
    /// What the incremental heights add up to.
    sum: f64,
    /// The height after an absolute one: incremental ones that follow are the same on each pass.
    height: Option<f64>,
    /// Whether such follow, and whether the pass begins with the absolute one, at a feed.
    steps: bool,
    settles: bool,
    /// Whether the tool moves at feed.
    feeds: bool,
    /// Whether it begins with a movement at feed along the tool axis alone, and does not lift the tool: what is
    /// repeated is an infeed.
    plunges: bool,
    /// Whether it has radius compensation: such a contour may have a finishing pass.
    compensates: bool,
}

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    if !facts.begins() {
        return;
    }
    let blank = Blank::of(facts.program);
    let unit = facts.millimetre();
    let blocks = facts.program.blocks();
    let mut known = Known::new();
    let mut levels = BTreeMap::new();
    for (index, block) in facts.marked() {
        let BlockKind::CallLbl(call) = &block.kind else { continue };
        let times = call.repeat.as_ref().and_then(|own| facts.number(own)).filter(|times| *times >= 1.0);
        let (Some(times), false) = (times, block.skip) else { continue };
        let uses = facts.run.graph.uses_in(index);
        let start = uses.first().and_then(|own| facts.run.graph.block_of(own.mark.as_ref()?));
        let Some(start) = start.filter(|start| *start < index) else { continue };
        if is_absolute(facts, start + 1..index, &mut known) {
            let finding = rule.at(facts, facts.content(block)).arg("what", "absolute");
            found.push(finding.arg("value", Arg::Number(times)));
            continue;
        }
        let usual = facts.run.before(index).is_some_and(|modal| is_level_frame(facts, &modal));
        let part = blocks.get(start + 1..index).filter(|_| usual);
        let Some(pass) = part.and_then(|part| pass(facts, part, start + 1, &mut levels)) else {
            continue;
        };
        let Some(blank) = &blank else { continue };
        let finding = rule.at(facts, facts.content(block));
        match pass.lowest {
            // One repetition may be a finishing pass, unless the tool was brought to a height for the infeed.
            Some(lowest)
                if !pass.changes
                    && pass.feeds
                    && lowest < blank.high[2]
                    && (times >= LEAST
                        || is_led(facts, blocks, start)
                        || (pass.plunges || pass.settles && pass.steps) && !pass.compensates) =>
            {
                found.push(finding.arg("what", "same").arg("value", Arg::Number(lowest)));
            }
            None if pass.sum < 0.0 => {
                let before = blocks.get(..start).and_then(|before| height(facts, before));
                let end = before.map(|height| height + pass.sum * (times + 1.0));
                // Nobody machines far below the blank, and no pass is left for what lies wholly below it.
                let begins = |end: f64| end - pass.sum < blank.low[2] - THROUGH * unit;
                if let Some(end) = end.filter(|end| *end < blank.low[2] - BELOW * unit || begins(*end)) {
                    found.push(finding.arg("what", "deep").arg("value", Arg::Number(end)));
                }
            }
            _ => {}
        }
    }
}

/// Whether heights are those of the blank: nothing moves coordinates but shifts in the plane.
fn is_level_frame(facts: &Facts<'_>, modal: &Modal) -> bool {
    const OTHERS: [Aspect; 5] =
        [Aspect::Rotation, Aspect::Mirroring, Aspect::Scaling, Aspect::AxisScaling, Aspect::Tilting];
    // A row of a datum table may have a height, too.
    let upwards = |word: &str| {
        let rest = word.trim_start_matches(['I', 'i']).strip_prefix(['Z', 'z', 'P', 'p', '#']);
        rest.is_some_and(|rest| {
            !rest.is_empty() && !rest.starts_with(char::is_alphabetic) || rest.starts_with(['Q', 'q'])
        })
    };
    let shifts = || {
        let blocks = facts.program.blocks();
        let all = facts.definitions.iter().filter(|own| {
            own.related_cycle().is_none_or(|cycle| matches!(cycle.file.group, Group::Transforms | Group::Datum))
        });
        let mut lines = all.filter_map(|own| blocks.get(own.view.first..=own.view.last)).flatten();
        lines.any(|block| facts.text(facts.content(block)).split_ascii_whitespace().any(upwards))
    };
    is_unmoved(modal) || OTHERS.iter().all(|own| modal.is(*own) == Tri::No) && !shifts()
}

/// Whether a part calls a cycle, or subprograms under a transformation, and all of it is absolute: from its second pass on it
/// does the same each time.
fn is_absolute(facts: &Facts<'_>, part: std::ops::Range<usize>, known: &mut Known) -> bool {
    let calls = facts.run.calls.iter().any(|call| part.contains(&call.block));
    let (mut works, mut transforms) = (calls, false);
    let all = facts.program.blocks().get(part.clone()).unwrap_or_default().iter().zip(part);
    for (block, index) in all.filter(|(block, _)| !is_silent(block)) {
        let text = || facts.text(facts.content(block)).split(';').next().unwrap_or_default();
        match &block.kind {
            BlockKind::Motion(motion) if !block.skip => {
                let absolute = |own: &Coord| !own.incremental && matches!(own.value.amount, Amount::Number(_));
                if !motion.words().coords.iter().all(absolute) {
                    return false;
                }
            }
            BlockKind::OldCycleLine(_) => {
                if let Some(own) = facts.definition_at(index) {
                    if own.related_cycle().is_none_or(|cycle| cycle.file.group != Group::Transforms) {
                        return false;
                    }
                    transforms = true;
                }
                let moves = |word: &str| {
                    word.starts_with(['I', 'Q']) && word.bytes().any(|byte| byte.is_ascii_digit()) || word.contains('Q')
                };
                if text().split_whitespace().skip(3).any(moves) {
                    return false;
                }
            }
            BlockKind::CyclCall(_) | BlockKind::Functions(_) => {}
            BlockKind::CallLbl(call) if call.repeat.is_none() && !block.skip => {
                if facts
                    .run
                    .graph
                    .called_from(index)
                    .is_none_or(|start| !is_same_each_time(facts, start, NESTED, known))
                {
                    return false;
                }
                works = true;
            }
            _ => return false,
        }
    }
    calls || transforms && works
}

/// Whether a definition of a cycle that is called has numbers only.
fn is_of_numbers(facts: &Facts<'_>, own: &Defined<'_>) -> bool {
    let related = own.as_related_cycle();
    let read = facts.read(&related);
    let machines = own.related_cycle().is_some_and(removes_material);
    machines && !read.items.is_empty() && read.items.iter().all(|item| !item.printed.contains(['Q', 'q']))
}

/// Whether a subprogram only moves, be it incrementally, and calls cycles: it leaves no parameter and no transformation
/// behind.
fn is_same_each_time(facts: &Facts<'_>, start: usize, nested: usize, known: &mut Known) -> bool {
    if let Some(known) = known.get(&(start, nested)) {
        return *known;
    }
    let same = facts.subprogram(start).is_some_and(|body| {
        let mut all = body.iter().zip(start + 1..).filter(|(block, _)| !is_silent(block));
        all.all(|(block, index)| match &block.kind {
            BlockKind::CallLbl(call) if call.repeat.is_none() && !block.skip && nested > 0 => facts
                .run
                .graph
                .called_from(index)
                .is_some_and(|start| is_same_each_time(facts, start, nested - 1, known)),
            BlockKind::Motion(motion) => {
                !block.skip && motion.words().coords.iter().all(|own| matches!(own.value.amount, Amount::Number(_)))
            }
            BlockKind::CyclCall(_) | BlockKind::Functions(_) => true,
            BlockKind::CycleDef(_) => facts.definition_at(index).is_some_and(|own| is_of_numbers(facts, own)),
            _ => false,
        })
    });
    known.insert((start, nested), same);
    same
}

/// What one pass of a part does; nothing if it has anything but movements.
fn pass(facts: &Facts<'_>, part: &[Block], start: usize, levels: &mut BTreeMap<usize, bool>) -> Option<Pass> {
    let mut pass = Pass::default();
    let mut first = true;
    for (block, index) in part.iter().zip(start..).filter(|(block, _)| !is_silent(block)) {
        let motion = match &block.kind {
            BlockKind::Motion(motion) => motion,
            // A contour that stays at its height.
            BlockKind::CallLbl(call) if call.repeat.is_none() && !block.skip && is_level(facts, index, levels)? => {
                (pass.feeds, pass.compensates) = (true, true);
                continue;
            }
            _ if block.is_blend() => continue,
            _ => return None,
        };
        let words = motion.words();
        let plain = matches!(
            words.path,
            Path::L | Path::Lp | Path::C | Path::Cr | Path::Cc | Path::Cp | Path::Ct | Path::Rnd | Path::Chf
        ) || matches!(words.path, Path::Appr(_) | Path::Dep(_));
        if block.skip || !plain || words.functions.iter().any(|own| !matches!(own.number, 3 | 4 | 8 | 9 | 13 | 14)) {
            return None;
        }
        pass.feeds |= !motion.outline().is_rapid() && motion.outline().has_coords();
        pass.compensates |= motion.outline().compensates() == Compensates::Beside;
        let infeeds = words.coords.iter().any(|own| own.axis == Axis::Z);
        match std::mem::replace(&mut first, false) {
            true => {
                pass.plunges = infeeds && words.coords.len() == 1 && !motion.outline().is_rapid();
                pass.settles = pass.plunges && !words.coords.iter().any(|own| own.incremental);
            }
            false => pass.plunges &= !infeeds,
        }
        note(facts, &words, &mut pass)?;
    }
    Some(pass)
}

/// Whether the subprogram that a block calls only moves, and never along the tool axis; nothing if that is not certain.
fn is_level(facts: &Facts<'_>, call: usize, levels: &mut BTreeMap<usize, bool>) -> Option<bool> {
    let start = facts.run.graph.called_from(call)?;
    if let Some(known) = levels.get(&start) {
        return Some(*known);
    }
    let level = facts.subprogram(start)?.iter().filter(|block| !is_silent(block)).all(|block| match &block.kind {
        BlockKind::Motion(motion) => {
            let words = motion.words();
            !block.skip && words.path != Path::Cp && words.coord(Axis::Z).is_none()
        }
        _ => false,
    });
    levels.insert(start, level);
    Some(level)
}

/// Adds a movement to a pass; nothing if its height is not certain.
fn note(facts: &Facts<'_>, words: &Motion, pass: &mut Pass) -> Option<()> {
    for own in &words.coords {
        let number = matches!(own.value.amount, Amount::Number(_));
        // A whole turn leads to where it begins.
        let turn = |value: f64| value != 0.0 && value % 360.0 == 0.0;
        if own.axis == Axis::Pa && own.incremental && facts.number(&own.value).is_some_and(turn) {
            continue;
        }
        let tool = own.axis == Axis::Z && words.path != Path::Cc;
        let steps = tool && own.incremental && pass.height.is_some();
        let flat = matches!(own.axis, Axis::X | Axis::Y) && words.path != Path::Cc;
        let from_absolute = steps || flat && pass.set.contains(&own.axis);
        pass.changes |= own.incremental && !from_absolute || !number;
        if number && !own.incremental && flat && !pass.set.contains(&own.axis) {
            pass.set.push(own.axis);
        }
        if tool {
            let value = facts.number(&own.value).filter(|_| number)?;
            if own.incremental {
                pass.sum += value;
                pass.steps |= steps && value < 0.0;
                pass.height = pass.height.map(|height| height + value);
                pass.lowest =
                    pass.height.map_or(pass.lowest, |height| Some(pass.lowest.map_or(height, |own| own.min(height))));
            } else {
                pass.height = Some(value);
                pass.lowest = Some(pass.lowest.map_or(value, |lowest| lowest.min(value)));
            }
        }
    }
    Some(())
}

/// Whether the tool is moved along its axis alone, at a feed, directly before a part that begins with such a movement:
/// the height from which the part is to infeed.
fn is_led(facts: &Facts<'_>, blocks: &[Block], start: usize) -> bool {
    let plunge = |block: Option<&Block>| match block.map(|block| &block.kind) {
        Some(BlockKind::Motion(motion)) if motion.path() == Path::L && !motion.outline().is_rapid() => {
            match motion.words().coords.as_slice() {
                [only] if only.axis == Axis::Z && !only.incremental => facts.number(&only.value),
                _ => None,
            }
        }
        _ => None,
    };
    let before = blocks.get(..start).unwrap_or_default().iter().rev().find(|block| !is_silent(block));
    let first = blocks.get(start + 1..).unwrap_or_default().iter().find(|block| !is_silent(block));
    plunge(before).zip(plunge(first)).is_some_and(|(from, to)| to < from)
}

/// The height that was reached last before a part.
fn height(facts: &Facts<'_>, before: &[Block]) -> Option<f64> {
    for block in before.iter().rev().filter(|block| !is_silent(block)) {
        let BlockKind::Motion(motion) = &block.kind else { return None };
        if motion.has_functions() && motion.functions().iter().any(|own| !matches!(own.number, 3 | 4 | 8 | 9 | 13 | 14))
        {
            return None;
        }
        let words = motion.words();
        if !matches!(words.path, Path::L | Path::C | Path::Cr | Path::Cc) {
            return None;
        }
        if let Some(own) = words.coord(Axis::Z).filter(|_| words.path != Path::Cc) {
            return if own.incremental { None } else { facts.number(&own.value) };
        }
    }
    None
}
