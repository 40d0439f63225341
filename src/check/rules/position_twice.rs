//! A place that a cycle machines a second time, with the same definition and the same tool: another place was meant.
//!
//! Only holes, taps and pockets at places that are known, in programs with a box as their blank and without
//! transformations, or at the same coordinates in a row of calls without anything between; and cycles that are defined again
//! word for word and called without any movement between. Said once a program.
use std::collections::HashSet;

use crate::base::diag::{Diagnostic, Severity, Span};
use crate::check::incident::Incident;
use crate::check::program::is_silent;
use crate::check::travel::first_incident;
use crate::check::{Facts, Rule};
use crate::program::syntax::{Amount, Axis, Block, BlockKind, CallForm, Path};

pub(super) const RULE: Rule = Rule { code: "position-twice", severity: Severity::Warning, run };

/// Longer programs are written by posts.
const MOST: usize = 3_000;

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let first = first_incident(facts, |own| match own {
        Incident::MachinedAgain(place) => Some(place),
        _ => None,
    });
    if let Some((span, [x, y])) = first.or_else(|| in_a_row(facts)) {
        found.push(rule.comparison(facts, span, "place", x, y));
    } else if let Some(span) = defined_again(facts) {
        found.push(rule.at(facts, span).arg("what", "definition").arg("value", 0).arg("other", 0));
    }
}

/// The first call of a definition that says the same, word for word, as the one that was called before it, while the tool
/// has not been moved in between: a copy was not adapted.
fn defined_again(facts: &Facts<'_>) -> Option<Span> {
    // What is defined, and what was called last where the tool still is.
    let (mut defined, mut called): (Option<Vec<&str>>, Option<Vec<&str>>) = (None, None);
    let blocks = facts.program.blocks();
    if blocks.len() > MOST {
        return None;
    }
    for (index, block) in blocks.iter().enumerate().filter(|(_, block)| !is_silent(block)) {
        match &block.kind {
            BlockKind::CycleDef(_) => {
                let own = facts.definition_at(index).filter(|own| own.view.first == index && !own.calls_last());
                let blocks = own.and_then(|own| facts.program.blocks().get(own.view.first..=own.view.last));
                defined = blocks.map(|blocks| blocks.iter().flat_map(|block| words(facts, block)).collect());
            }
            BlockKind::OldCycleLine(_) => {}
            BlockKind::CyclCall(call) if matches!(call.form, CallForm::Plain) && !block.skip => {
                if defined.is_some() && defined == called {
                    return Some(facts.content(block));
                }
                called.clone_from(&defined);
            }
            _ => (defined, called) = (None, None),
        }
    }
    None
}

/// The words of a block without labels and comments.
fn words<'f>(facts: &'f Facts<'_>, block: &Block) -> Vec<&'f str> {
    let lines = facts.text(block.span).lines().map(|line| line.split(';').next().unwrap_or_default());
    let words = lines.flat_map(str::split_whitespace).filter(|word| *word != "~");
    words.skip(usize::from(block.number.is_some())).collect()
}

/// The first block that calls a cycle at the place which one of the blocks directly before it has named for the same call:
/// this needs no blank.
fn in_a_row(facts: &Facts<'_>) -> Option<(Span, [f64; 2])> {
    let mut row: Vec<([f64; 2], usize)> = Vec::new();
    let calls: HashSet<usize> = facts.run.calls.iter().map(|call| call.block).collect();
    for (index, block) in facts.marked() {
        if is_silent(block) {
            continue;
        }
        let place =
            Some(block).filter(|block| calls.contains(&index) && !block.skip).and_then(|block| place(facts, block));
        let Some(place) = place else {
            row.clear();
            continue;
        };
        // Between the blocks of a row there is nothing, not even a plain movement.
        if row.last().is_some_and(|(_, last)| {
            let between = facts.program.blocks().get(last + 1..index).unwrap_or_default();
            !between.iter().all(is_silent)
        }) {
            row.clear();
        }
        if row.iter().any(|(other, _)| *other == place) {
            return Some((facts.content(block), place));
        }
        row.push((place, index));
    }
    None
}

/// The place that a straight movement names with both coordinates of the plane and nothing else.
fn place(facts: &Facts<'_>, block: &Block) -> Option<[f64; 2]> {
    let BlockKind::Motion(motion) = &block.kind else { return None };
    let words = motion.words();
    let value = |axis: Axis| {
        let coord = words.coord(axis).filter(|coord| !coord.incremental)?;
        match coord.value.amount {
            Amount::Number(_) => facts.number(&coord.value),
            _ => None,
        }
    };
    (motion.path() == Path::L && words.coords.len() == 2).then_some(())?;
    Some([value(Axis::X)?, value(Axis::Y)?])
}
