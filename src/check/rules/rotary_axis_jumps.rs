//! A rotary axis that swings far away for one block at feed and back in the next one, while it hardly moves before and after.
//!
//! Only A and B, in a row of at least four blocks of which each names the axis as a number: the jump is three times as far
//! as all other positions are apart, and more than 20 degrees. Said once for a row.
use crate::base::diag::{Arg, Diagnostic, Severity, Span};
use crate::check::{Facts, Rule};
use crate::program::syntax::{Amount, Axis, Block, BlockKind, Path};

pub(super) const RULE: Rule = Rule { code: "rotary-axis-jumps", severity: Severity::Warning, run };

/// A row is at least so long.
const LEAST: usize = 4;
/// A jump is at least so far, degrees.
const FAR: f64 = 20.0;
/// So many times the distance of all others.
const TIMES: f64 = 3.0;

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    for axis in [Axis::A, Axis::B] {
        let mut row: Vec<(f64, Span)> = Vec::new();
        for block in facts.program.blocks() {
            match angle(block, axis) {
                Some(own) => row.push(own),
                None if matches!(block.kind, BlockKind::Comment | BlockKind::Empty) => {}
                None => judge(rule, facts, &std::mem::take(&mut row), found),
            }
        }
        judge(rule, facts, &row, found);
    }
}

/// The angle of an axis that a movement at feed names.
fn angle(block: &Block, axis: Axis) -> Option<(f64, Span)> {
    let BlockKind::Motion(motion) = &block.kind else { return None };
    if motion.path() != Path::L || motion.outline().is_rapid() {
        return None;
    }
    let words = motion.words();
    let coord = words.coord(axis).filter(|coord| !coord.incremental)?;
    match coord.value.amount {
        Amount::Number(number) => Some((number, coord.value.span)),
        _ => None,
    }
}

fn judge(rule: &Rule, facts: &Facts<'_>, row: &[(f64, Span)], found: &mut Vec<Diagnostic>) {
    if row.len() < LEAST {
        return;
    }
    for (at, three) in row.windows(3).enumerate() {
        let [(before, _), (own, span), (after, _)] = three else { continue };
        let others = row.iter().enumerate().filter(|(place, _)| *place != at + 1).map(|(_, (value, _))| *value);
        let (low, high) = others.fold((f64::MAX, f64::MIN), |(low, high), own| (low.min(own), high.max(own)));
        let jump = (own - before).abs().min((own - after).abs());
        let beyond = (low - own).max(own - high);
        if jump > FAR && beyond > TIMES * (high - low).max(1.0) {
            found.push(rule.at(facts, *span).arg("value", Arg::Number(*own)).arg("other", Arg::Number(*before)));
            return;
        }
    }
}
