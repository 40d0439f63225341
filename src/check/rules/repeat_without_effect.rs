//! A repeat zero times: the part of the program is executed once, as without it. Also a repeat of a contour that does the
//! same again, because its depth is absolute, while incremental steps of that depth would just go through the blank; and a
//! repeat of a single movement to a place with absolute coordinates, where the tool already is.
//! A jump on a condition to the block that follows it anyway: what it was to pass over is missing.
use crate::base::diag::{Arg, Diagnostic, Severity};
use crate::check::blank::Blank;
use crate::check::program::is_silent;
use crate::check::{Facts, Rule, Use, Way};
use crate::program::syntax::{Amount, Axis, Block, BlockKind, Compensates, Motion, Path};

pub(super) const RULE: Rule = Rule { code: "repeat-without-effect", severity: Severity::Warning, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    for (_, block) in facts.marked() {
        let BlockKind::CallLbl(call) = &block.kind else { continue };
        if let Some(times) = call.repeat.filter(|times| times.amount == Amount::Number(0.0)) {
            found.push(rule.at(facts, times.span).arg("what", "zero").arg("value", ""));
        }
    }
    same(rule, facts, found);
    for block in idle_jumps(facts) {
        found.push(rule.at(facts, facts.content(block)).arg("what", "jump").arg("value", ""));
    }
}

/// The jumps on a condition to the next block. The last one of a row of jumps may say what is done otherwise.
fn idle_jumps<'p>(facts: &Facts<'p>) -> Vec<&'p Block> {
    let graph = &facts.run.graph;
    let blocks = facts.program.blocks();
    let jumps = |block: Option<&&Block>| matches!(block.map(|own| &own.kind), Some(BlockKind::FnJump(_)));
    let idle = |own: &Use| {
        let block = blocks.get(own.block).filter(|block| !block.skip)?;
        let target = own.mark.as_ref().and_then(|mark| graph.block_of(mark))?;
        let between = blocks.get(own.block + 1..target)?;
        let empty = between.iter().all(|own| is_silent(own) || matches!(own.kind, BlockKind::Lbl(_)));
        let before = blocks.get(..own.block)?.iter().rfind(|own| !is_silent(own));
        let conditional = matches!(&block.kind, BlockKind::FnJump(jump) if jump.decided().is_none());
        (empty && conditional && !jumps(before.as_ref())).then_some(block)
    };
    graph.uses.iter().filter(|own| own.way == Way::Jump).filter_map(idle).collect()
}

/// What counts as the same height, mm or inch.
const SAME: f64 = 0.01;

/// Repeats of a contour at the same depth.
fn same(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let Some(blank) = Blank::of(facts.program).filter(|_| facts.begins()) else { return };
    for own in facts.run.graph.uses.iter().filter(|own| own.way == Way::Repeat) {
        let blocks = facts.program.blocks();
        let (Some(from), Some(block)) =
            (own.mark.as_ref().and_then(|mark| facts.run.graph.block_of(mark)), blocks.get(own.block))
        else {
            continue;
        };
        let BlockKind::CallLbl(call) = &block.kind else { continue };
        let Some(Amount::Number(times)) = call.repeat.map(|times| times.amount).filter(|_| !block.skip) else {
            continue;
        };
        let part = blocks.get(from + 1..own.block);
        if times >= 1.0 && part.is_some_and(stays) {
            let finding = rule.at(facts, facts.content(block)).arg("what", "place");
            return found.push(finding.arg("value", ""));
        }
        let Some(lowest) = part.and_then(fixed_depth) else { continue };
        let (deep, thick) = (blank.high[2] - lowest, blank.high[2] - blank.low[2]);
        let through = deep * (times + 1.0);
        if times >= 1.0 && deep > SAME && through >= thick - SAME && through - deep < thick - SAME {
            let finding = rule.at(facts, facts.content(block)).arg("what", "same");
            found.push(finding.arg("value", Arg::Number(lowest)));
            return;
        }
    }
}

/// Whether a part consists of one movement to a place that is given by absolute numbers.
fn stays(blocks: &[Block]) -> bool {
    let mut moves = blocks.iter().filter(|block| !is_silent(block));
    let (Some(only), None) = (moves.next(), moves.next()) else { return false };
    let BlockKind::Motion(motion) = &only.kind else { return false };
    let words = motion.words();
    let absolute = words.coords.iter().all(|own| !own.incremental && matches!(own.value.amount, Amount::Number(_)));
    let line = matches!(words.path, Path::L | Path::Lp);
    line && absolute && !words.coords.is_empty() && !motion.has_functions() && !only.skip
}

/// The lowest height of a contour that is the same on each pass: its first coordinates and all heights are absolute numbers.
fn fixed_depth(blocks: &[Block]) -> Option<f64> {
    let (mut lowest, mut contour) = (f64::INFINITY, false);
    let mut named = [false; 2];
    for block in blocks {
        match &block.kind {
            BlockKind::Motion(motion) if !motion.outline().has_parameters() && !block.skip => {
                contour |= motion.outline().compensates() == Compensates::Beside;
                heights(&motion.words(), &mut lowest, &mut named)?;
            }
            BlockKind::Functions(_) | BlockKind::Comment | BlockKind::Empty | BlockKind::Structure(_) => {}
            _ if block.is_blend() => {}
            _ => return None,
        }
    }
    (contour && lowest.is_finite()).then_some(lowest)
}

/// Takes the heights of a movement; nothing if one is incremental, or the first coordinate of another axis is.
fn heights(words: &Motion, lowest: &mut f64, named: &mut [bool; 2]) -> Option<()> {
    for coord in &words.coords {
        let Amount::Number(value) = coord.value.amount else { return None };
        match coord.axis {
            Axis::Z if coord.incremental => return None,
            Axis::Z => *lowest = lowest.min(value),
            Axis::X | Axis::Y => {
                let named = &mut named[usize::from(coord.axis == Axis::Y)];
                if coord.incremental && !*named {
                    return None;
                }
                *named = true;
            }
            _ => {}
        }
    }
    Some(())
}
