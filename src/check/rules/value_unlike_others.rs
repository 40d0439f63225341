//! A value that differs only by its sign, by a factor of ten or by two exchanged digits from the one that all other
//! definitions of the same cycle have there, or a depth of a plain plunge that differs so from all others.
//!
//! At least two others, and all of them equal. Coordinates, angles and choices are not compared. Each is reported.
use std::collections::BTreeMap;

use crate::base::diag::{Arg, Diagnostic, Severity, Span};
use crate::check::program::number;
use crate::check::{Facts, Rule};
use crate::program::syntax::{Amount, Axis, BlockKind, Path, ValueKind};
use crate::spec::{CycleKey, Group, Quantity, Reference};

pub(super) const RULE: Rule = Rule { code: "value-unlike-others", severity: Severity::Warning, run };

/// Longer programs are written by posts.
const MOST: usize = 3_000;
/// Others that make a rule.
const OTHERS: usize = 2;

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let mut all: BTreeMap<(CycleKey, usize), Vec<(f64, Span)>> = BTreeMap::new();
    for own in &facts.definitions {
        let Some(cycle) = own.related_cycle().filter(|cycle| cycle.file.group != Group::Patterns) else { continue };
        if matches!(cycle.file.group, Group::Datum | Group::Measuring | Group::Rotation | Group::Turning) {
            continue;
        }
        let related = own.as_related_cycle();
        let read = facts.read(&related);
        for item in &read.items {
            let (Some(param), Some(at)) = (item.param, item.index) else { continue };
            let measures = matches!(param.quantity, Quantity::Length | Quantity::Feed)
                && param.reference != Some(Reference::Absolute)
                && param.choices.is_empty();
            let written = item.value.is_some_and(|value| matches!(value.kind, ValueKind::Number(_)));
            if let Some(value) = number(item).filter(|_| measures && written) {
                all.entry((own.key, at)).or_default().push((value, item.value_span));
            }
        }
    }
    all.into_values().filter_map(odd).for_each(|own| tell(rule, facts, own, found));
    if let Some(own) = odd(plunges(facts)) {
        tell(rule, facts, own, found);
    }
}

fn tell(rule: &Rule, facts: &Facts<'_>, (span, value, other): (Span, f64, f64), found: &mut Vec<Diagnostic>) {
    found.push(rule.at(facts, span).arg("value", Arg::Number(value)).arg("other", Arg::Number(other)));
}

/// The heights to which plain movements along the tool axis alone go at a feed.
fn plunges(facts: &Facts<'_>) -> Vec<(f64, Span)> {
    let mut heights = Vec::new();
    let blocks = facts.program.blocks();
    for block in blocks.iter().filter(|_| blocks.len() <= MOST) {
        let BlockKind::Motion(motion) = &block.kind else { continue };
        if motion.path() != Path::L || motion.outline().is_rapid() {
            continue;
        }
        if let [only] = motion.words().coords.as_slice()
            && only.axis == Axis::Z
            && !only.incremental
            && let Amount::Number(height) = only.value.amount
        {
            heights.push((height, only.value.span));
        }
    }
    heights
}

/// The one value that differs so from all others, with the others.
fn odd(all: Vec<(f64, Span)>) -> Option<(Span, f64, f64)> {
    if all.len() <= OTHERS {
        return None;
    }
    let first = all.first()?.0;
    let usual = if all.iter().filter(|(own, _)| *own == first).count() > 1 { first } else { all.get(1)?.0 };
    let mut others = all.iter().filter(|(own, _)| *own != usual);
    let (value, span) = *others.next()?;
    (others.next().is_none() && is_slip(value, usual)).then_some((span, value, usual))
}

/// Whether somebody who means a value may have written another one.
fn is_slip(written: f64, meant: f64) -> bool {
    let near = |one: f64, other: f64| (one - other).abs() <= 1e-9 * other.abs();
    if written == 0.0 || meant == 0.0 {
        return false;
    }
    let factor = [10.0, 0.1, 100.0, 0.01].iter().any(|factor| near(written, meant * factor));
    near(written, -meant) || factor || exchanged(written, meant)
}

/// Whether two neighbouring digits are exchanged.
fn exchanged(one: f64, other: f64) -> bool {
    let (one, other) = (one.to_string(), other.to_string());
    let differ: Vec<usize> =
        one.bytes().zip(other.bytes()).enumerate().filter(|(_, (a, b))| a != b).map(|own| own.0).collect();
    let ([first, second], true) = (differ.as_slice(), one.len() == other.len()) else { return false };
    let at = |text: &str, place: usize| text.as_bytes().get(place).copied();
    second - first == 1 && at(&one, *first) == at(&other, *second) && at(&one, *second) == at(&other, *first)
}
