//! A repeated part of a program that does the same in each pass although it goes into the blank, or that goes deeper in
//! each pass and ends far below the blank.
//!
//! A part that infeeds in each pass needs an incremental value or one that a parameter changes. Only parts are looked at
//! that consist of movements with numbers, which are repeated several times, in programs with a box as their blank.
use crate::base::diag::{Arg, Diagnostic, Severity};
use crate::check::blank::{Blank, is_unmoved};
use crate::check::program::is_silent;
use crate::check::{Facts, Rule};
use crate::program::syntax::{Amount, Axis, Block, BlockKind, Motion, Path};
use crate::spec::MM_PER_INCH;

pub(super) const RULE: Rule = Rule { code: "repeated-infeed", severity: Severity::Warning, run };

/// One repetition may be a finishing pass.
const LEAST: f64 = 2.0;
/// So far below the blank nobody machines, in millimetres.
const BELOW: f64 = 25.0;

/// What a pass does along the tool axis.
#[derive(Default)]
struct Pass {
    /// Whether anything depends on what was before: incremental values, polar ones, parameters.
    changes: bool,
    /// The lowest absolute height.
    lowest: Option<f64>,
    /// What the incremental heights add up to.
    sum: f64,
    /// Whether the tool moves at feed.
    feeds: bool,
}

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let Some(blank) = Blank::of(facts.program).filter(|_| facts.begins()) else { return };
    let unit = if facts.inch { 1.0 / MM_PER_INCH } else { 1.0 };
    let blocks = facts.program.blocks();
    for (index, block) in facts.marked() {
        let BlockKind::CallLbl(call) = &block.kind else { continue };
        let times = call.repeat.as_ref().and_then(|own| facts.number(own)).filter(|times| *times >= LEAST);
        let (Some(times), false) = (times, block.skip) else { continue };
        let uses = facts.run.graph.uses_in(index);
        let start = uses.first().and_then(|own| facts.run.graph.block_of(own.mark.as_ref()?));
        let Some(start) = start.filter(|start| *start < index) else { continue };
        let usual = facts.run.before(index).is_some_and(|modal| is_unmoved(&modal));
        let Some(pass) = blocks.get(start + 1..index).and_then(|part| pass(facts, part)).filter(|_| usual) else {
            continue;
        };
        let finding = rule.at(facts, facts.content(block));
        match pass.lowest {
            Some(lowest) if !pass.changes && pass.feeds && lowest < blank.high[2] => {
                found.push(finding.arg("what", "same").arg("value", Arg::Number(lowest)));
            }
            None if pass.sum < 0.0 => {
                let before = blocks.get(..start).and_then(|before| height(facts, before));
                let end = before.map(|height| height + pass.sum * (times + 1.0));
                if let Some(end) = end.filter(|end| *end < blank.low[2] - BELOW * unit) {
                    found.push(finding.arg("what", "deep").arg("value", Arg::Number(end)));
                }
            }
            _ => {}
        }
    }
}

/// What one pass of a part does; nothing if it has anything but movements.
fn pass(facts: &Facts<'_>, part: &[Block]) -> Option<Pass> {
    let mut pass = Pass::default();
    for block in part.iter().filter(|block| !is_silent(block)) {
        let BlockKind::Motion(motion) = &block.kind else { return None };
        let words = motion.words();
        let plain = matches!(words.path, Path::L | Path::C | Path::Cr | Path::Cc | Path::Ct | Path::Rnd | Path::Chf);
        if block.skip || !plain || words.functions.iter().any(|own| !matches!(own.number, 3 | 4 | 8 | 9 | 13 | 14)) {
            return None;
        }
        pass.feeds |= !motion.outline().is_rapid() && motion.outline().has_coords();
        note(facts, &words, &mut pass)?;
    }
    Some(pass)
}

/// Adds a movement to a pass; nothing if its height is not certain.
fn note(facts: &Facts<'_>, words: &Motion, pass: &mut Pass) -> Option<()> {
    for own in &words.coords {
        let number = matches!(own.value.amount, Amount::Number(_));
        pass.changes |= own.incremental || !number;
        if own.axis == Axis::Z && words.path != Path::Cc {
            let value = facts.number(&own.value).filter(|_| number)?;
            if own.incremental {
                pass.sum += value;
            } else {
                pass.lowest = Some(pass.lowest.map_or(value, |lowest| lowest.min(value)));
            }
        }
    }
    Some(())
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
