//! The same machined twice at the same datum or preset: a row that is activated again before the same subprogram or the same
//! cycle at the same place, or a loop that activates the same row on each pass although it counts.
//!
//! Also a row for another side of the workpiece for which the table was not turned on. Between the two activations there must
//! be nothing that could make a difference: no tool, no parameter, no other cycle.
use std::collections::BTreeSet;

use crate::base::diag::{Arg, Diagnostic, Severity, Span};
use crate::base::expr::QRef;
use crate::check::loops::Loop;
use crate::check::program::{is_silent, number, reads, with_meaning};
use crate::check::{Defined, Facts, Mark, Pending, Rule, Way};
use crate::program::syntax::{Amount, Axis, Block, BlockKind, Coord, Element, Path, StatementKind};
use crate::spec::TakesEffect;

pub(super) const RULE: Rule = Rule { code: "same-datum-twice", severity: Severity::Warning, run };

/// The meanings of a row that is activated.
const ROWS: [&str; 2] = ["preset-number", "datum-row"];
/// How often a block may be looked at on average.
const PATIENCE: usize = 48;

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let tables = || facts.marked().any(|(_, block)| row_of_table(facts, block).is_some());
    if facts.flow.unread.any() || !facts.definitions.iter().any(|own| names_row(own)) && !tables() {
        return;
    }
    in_a_row(rule, facts, found);
    in_a_loop(rule, facts, found);
    turned(rule, facts, found);
}

/// So many sides of a workpiece make a row.
const SIDES: usize = 4;

/// Rows that are activated for the sides of a workpiece, where the table is turned to one side twice and one side is left out.
fn turned(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    if facts.definitions.iter().filter(|own| names_row(own)).count() < SIDES {
        return;
    }
    for axis in [Axis::A, Axis::B, Axis::C] {
        let mut sides: Vec<(f64, Span, f64)> = Vec::new();
        let mut angle: Option<(f64, Span)> = None;
        for (index, block) in facts.program.blocks().iter().enumerate() {
            match &block.kind {
                BlockKind::Motion(motion) if motion.path() == Path::L && !block.skip => {
                    if let Some(coord) = motion.words().coord(axis) {
                        angle = match coord.value.amount {
                            Amount::Number(number) if !coord.incremental => Some((number, coord.value.span)),
                            _ => None,
                        };
                    }
                }
                BlockKind::CycleDef(_) | BlockKind::OldCycleLine(_) => {
                    let own = facts.definition_at(index).filter(|own| names_row(own));
                    if let (Some((row, _)), Some((turned, span))) = (own.and_then(|own| row(facts, own)), angle.take())
                    {
                        sides.push((turned, span, row));
                    }
                }
                BlockKind::Lbl(_) | BlockKind::ToolCall(_) => judge(rule, facts, &std::mem::take(&mut sides), found),
                _ => {}
            }
        }
        judge(rule, facts, &sides, found);
    }
}

/// Sides at equal steps of which one has the angle of another and the row of none.
fn judge(rule: &Rule, facts: &Facts<'_>, sides: &[(f64, Span, f64)], found: &mut Vec<Diagnostic>) {
    let rows: BTreeSet<u64> = sides.iter().map(|(_, _, row)| row.to_bits()).collect();
    if sides.len() < SIDES || rows.len() < sides.len() {
        return;
    }
    let angle = |at: usize| sides.get(at).map_or(f64::NAN, |(angle, ..)| *angle);
    let steps = [angle(1) - angle(0), angle(sides.len() - 1) - angle(sides.len() - 2), (angle(3) - angle(0)) / 3.0];
    for step in steps.into_iter().filter(|step| step.abs() > 1e-6) {
        let begin = if (angle(1) - angle(0) - step).abs() > 1e-6 { angle(2) - 2.0 * step } else { angle(0) };
        let fits = |at: usize| (angle(at) - begin - step * at as f64).abs() <= 1e-6;
        let wrong: Vec<usize> = (0..sides.len()).filter(|at| !fits(*at)).collect();
        let [only] = wrong.as_slice() else { continue };
        let again = (0..sides.len()).any(|at| at != *only && (angle(at) - angle(*only)).abs() <= 1e-6);
        if let (true, Some((_, span, row))) = (again, sides.get(*only)) {
            return found.push(rule.at(facts, *span).arg("what", "turned").arg("row", Arg::Number(*row)));
        }
    }
}

fn names_row(own: &Defined<'_>) -> bool {
    own.related_cycle().is_some_and(|cycle| ROWS.iter().any(|meaning| with_meaning(cycle, meaning).is_some()))
}

/// The row that a definition activates as a number, and its place.
fn row(facts: &Facts<'_>, own: &Defined<'_>) -> Option<(f64, Span)> {
    let related = own.as_related_cycle();
    let read = facts.read(&related);
    let item = ROWS.iter().find_map(|meaning| read.item(meaning))?;
    let plain = |item: &crate::check::Item<'_>| {
        !matches!(item.value.map(|value| value.kind), Some(crate::program::syntax::ValueKind::Q { .. }))
    };
    Some((number(item).filter(|_| plain(item))?, item.value_span))
}

/// The row of a datum table that TRANS DATUM activates, and its place.
fn row_of_table(facts: &Facts<'_>, block: &Block) -> Option<(f64, Span)> {
    const WORD: &str = "TABLINE";
    let BlockKind::Statement(own) = &block.kind else { return None };
    let span = facts.content(block);
    let text = facts.text(span).split(';').next().unwrap_or_default().to_ascii_uppercase();
    let rest = text.split(WORD).nth(1).filter(|_| own.kind == StatementKind::Trans && !block.skip)?;
    Some((rest.split_whitespace().next()?.parse().ok()?, span))
}

/// What is done at a row.
#[derive(PartialEq, Eq, PartialOrd, Ord)]
enum Done {
    /// A subprogram.
    Part(Mark),
    /// A definition is called at a place.
    Cycle(u32, String),
}

/// A call of a cycle in a movement to a place that does not depend on where the tool is.
fn called(facts: &Facts<'_>, index: usize, motion: &Element) -> Option<Done> {
    let call = facts.run.calls.iter().find(|call| call.block == index)?;
    let Pending::Definition(definition) = call.modal.pending else { return None };
    let words = motion.words();
    let fixed = |own: &Coord| !own.incremental && matches!(own.value.amount, Amount::Number(_));
    let whole = [Axis::X, Axis::Y].iter().all(|axis| words.coord(*axis).is_some()) && words.coords.iter().all(fixed);
    let places: Vec<String> =
        words.coords.iter().map(|own| format!("{:?}{}", own.axis, facts.text(own.value.span))).collect();
    whole.then(|| Done::Cycle(definition, places.join(" ")))
}

/// Rows one after the other.
fn in_a_row(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let graph = &facts.run.graph;
    let mut seen: BTreeSet<(u64, Done)> = BTreeSet::new();
    let mut active: Option<(f64, Span)> = None;
    for (index, block) in facts.program.blocks().iter().enumerate() {
        match &block.kind {
            _ if is_silent(block) => {}
            BlockKind::Motion(motion) => {
                if let Some((row, place)) = active
                    && let Some(done) = called(facts, index, motion)
                {
                    active = None;
                    if !seen.insert((row.to_bits(), done)) {
                        found.push(rule.at(facts, place).arg("what", "cycle").arg("row", Arg::Number(row)));
                    }
                }
            }
            BlockKind::Functions(_) => {}
            BlockKind::Statement(_) if row_of_table(facts, block).is_some() => active = row_of_table(facts, block),
            BlockKind::CycleDef(_) | BlockKind::OldCycleLine(_) => {
                if let Some(own) = facts.definition_at(index) {
                    active = if names_row(own) { row(facts, own) } else { None };
                    if active.is_none() {
                        seen.clear();
                    }
                }
            }
            BlockKind::CallLbl(call) if call.repeat.is_none() => {
                let mark =
                    graph.uses_in(index).iter().find(|own| own.way == Way::Call).and_then(|own| own.mark.clone());
                if let (Some((row, place)), Some(mark)) = (active.take(), mark)
                    && !seen.insert((row.to_bits(), Done::Part(mark)))
                {
                    found.push(rule.at(facts, place).arg("what", "again").arg("row", Arg::Number(row)));
                }
            }
            _ => {
                seen.clear();
                active = None;
            }
        }
    }
}

/// Loops that count and activate one row.
fn in_a_loop(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let graph = &facts.run.graph;
    let mut patience = facts.program.blocks().len().saturating_mul(PATIENCE).saturating_add(100_000);
    for own in graph.uses.iter().filter(|own| own.way == Way::Jump) {
        let target = own.mark.as_ref().and_then(|mark| graph.block_of(mark));
        let Some(from) = target.filter(|from| *from < own.block) else { continue };
        let rows = facts.definitions.iter().filter(|row| (from..own.block).contains(&row.view.first) && names_row(row));
        let rows: Vec<_> = rows.collect();
        let [only] = rows.as_slice() else { continue };
        let Some((row, place)) = row(facts, only) else { continue };
        let mut body = Loop::new(&mut patience);
        body.add(facts, from, own.block.saturating_sub(1));
        if body.open || body.written.is_empty() {
            continue;
        }
        let mut parts = Vec::new();
        parts_of(facts, from, own.block, &mut parts, 4);
        let moving =
            |at: &usize| facts.program.blocks().get(*at).is_none_or(|block| changes(facts, *at, block, &body.written));
        let calls = facts.run.calls.iter().any(|call| parts.contains(&call.block));
        if calls && !parts.iter().any(moving) {
            found.push(rule.at(facts, place).arg("what", "loop").arg("row", Arg::Number(row)));
        }
    }
}

/// The blocks of a loop with those of the subprograms that it calls.
fn parts_of(facts: &Facts<'_>, from: usize, to: usize, parts: &mut Vec<usize>, depth: usize) {
    let blocks = facts.program.blocks();
    for at in from..to {
        parts.push(at);
        for own in facts.run.graph.uses_in(at).iter().filter(|own| own.way == Way::Call && depth > 0) {
            let Some(start) = own.mark.as_ref().and_then(|mark| facts.run.graph.block_of(mark)) else { continue };
            let after = blocks.get(start..).unwrap_or_default();
            if let Some(end) = after.iter().position(Block::ends_subprogram) {
                parts_of(facts, start, start + end, parts, depth - 1);
            }
        }
    }
}

/// Whether a block does something else on each pass: it reads what the loop writes, or moves on from where it is.
fn changes(facts: &Facts<'_>, at: usize, block: &Block, written: &[QRef]) -> bool {
    match &block.kind {
        // The counter itself.
        BlockKind::FnAssign(_) | BlockKind::Formula(_) | BlockKind::FnJump(_) => return false,
        BlockKind::Motion(motion) => {
            if motion.words().coords.iter().any(|coord| coord.incremental) {
                return true;
            }
        }
        BlockKind::CyclCall(_)
        | BlockKind::CycleDef(_)
        | BlockKind::OldCycleLine(_)
        | BlockKind::Functions(_)
        | BlockKind::Lbl(_)
        | BlockKind::CallLbl(_) => {}
        _ if is_silent(block) => {}
        _ => return true,
    }
    let mut read = Vec::new();
    reads(block, &mut read);
    let transforms = facts
        .definition_at(at)
        .is_some_and(|own| own.takes_effect() == Some(TakesEffect::OnDefinition) && !names_row(own));
    transforms || read.iter().any(|(q, _)| written.contains(q))
}
