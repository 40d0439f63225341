//! Digitizing without a range defined before it, contour lines in a range that a point table bounds, a range whose MIN
//! point lies above its MAX point, and a clearance height below the MAX point in the probe axis.
//!
//! The range is defined before the cycle that digitizes (003: 3236, 3301, 3380), contour lines need the block-shaped
//! one (003: 3124, 3303), and its points are the least and the greatest coordinates (003: 3096-3107). Where blocks are
//! repeated or called, a range is missing only if the program has none at all; silent in programs that call others or
//! are parts of one.
use crate::base::diag::{Diagnostic, Severity};
use crate::check::program::with_meaning;
use crate::check::{Defined, Definition, Facts, Item, Rule};
use crate::program::syntax::{BlockKind, CycleForm, ValueKind};
use crate::spec::{Cycle, Group};

pub(super) const RULE: Rule = Rule { code: "digitizing-wrong", severity: Severity::Warning, run };

/// Where a range ends, at its least and at its greatest: of a block, and in the probe axis next to a table.
const ENDS: [[&str; 2]; 2] = [["digitizing-range-min", "digitizing-range-max"], ["probe-axis-min", "probe-axis-max"]];
const HEIGHT: &str = "digitizing-clearance-height";
const PROBE_AXIS: &str = "digitizing-probe-axis";
/// What only a range of any shape has, and only contour lines.
const TABLE: &str = "digitizing-range-table";
const CONTOUR_LINES: &str = "contour-line-start";

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let digitizes = |own: &&Defined<'_>| own.cycle().is_some_and(|cycle| cycle.file.group == Group::Digitizing);
    let all: Vec<_> = facts.definitions.iter().filter(digitizes).collect();
    if all.is_empty() {
        return;
    }
    order(rule, facts, &all, found);
    for definition in all.iter().filter(|own| own.cycle().is_some_and(is_range)) {
        extent(rule, facts, &facts.read(definition), found);
    }
}

fn has(cycle: &Cycle, meaning: &str) -> bool {
    with_meaning(cycle, meaning).is_some()
}

fn is_range(cycle: &Cycle) -> bool {
    has(cycle, HEIGHT)
}

/// Whether each cycle that digitizes has a range before it that it can work with.
fn order(rule: &Rule, facts: &Facts<'_>, all: &[&Defined<'_>], found: &mut Vec<Diagnostic>) {
    // What names no tool is a part of another program.
    let calls_tool = facts.marked().any(|(_, block)| matches!(block.kind, BlockKind::ToolCall(_)));
    let torn = facts.unread("TCH");
    if facts.flow.programs || torn || !facts.begins() || !calls_tool {
        return;
    }
    let jumps = facts.flow.jumps;
    let mut missing = false;
    for (at, own) in all.iter().enumerate() {
        let Some(cycle) = own.cycle().filter(|cycle| !is_range(cycle)) else { continue };
        // The ranges that may be in effect here.
        let before = if jumps { all } else { all.get(..at).unwrap_or_default() };
        let mut ranges = before.iter().filter(|own| own.cycle().is_some_and(is_range)).rev();
        let Some(last) = ranges.next() else {
            if !missing {
                missing = true;
                found.push(rule.at(facts, own.view.head).arg("what", "missing").arg("cycle", own.key.to_string()));
            }
            continue;
        };
        let of_table = |own: &Defined<'_>| own.cycle().is_some_and(|range| has(range, TABLE));
        if has(cycle, CONTOUR_LINES) && of_table(last) && (!jumps || ranges.all(|own| of_table(own))) {
            let finding = rule.at(facts, own.view.head).arg("what", "combined").arg("cycle", own.key.to_string());
            found.push(finding.arg("range", last.key.to_string()));
        }
    }
}

/// Whether a range goes from its least to its greatest coordinates, and the clearance height is above them.
fn extent(rule: &Rule, facts: &Facts<'_>, range: &Definition<'_>, found: &mut Vec<Diagnostic>) {
    let reported = |place, what: &str| rule.at(facts, place).arg("what", what);
    let item = |meaning: &str| range.item(meaning);
    let height = item(HEIGHT).and_then(|item| coordinates(facts, range, item).into_iter().next());
    let axis = item(PROBE_AXIS).map(|item| item.printed.as_ref());
    for [least, greatest] in ENDS {
        let [least, greatest] = [least, greatest].map(|own| item(own).map(|item| coordinates(facts, range, item)));
        for max in greatest.iter().flatten() {
            let min = least.iter().flatten().find(|min| min.axis == max.axis);
            if let Some(min) = min.filter(|min| min.number > max.number) {
                found.push(
                    reported(max.span, "swapped").arg("word", facts.text(max.span)).arg("other", facts.text(min.span)),
                );
            }
            let above = max.axis.is_none() || max.axis.as_deref() == axis;
            if let Some(height) = height.as_ref().filter(|height| above && height.number < max.number) {
                let finding = reported(height.span, "low").arg("word", facts.text(height.span));
                found.push(finding.arg("other", facts.text(max.span)));
            }
        }
    }
}

/// A coordinate as written, with its axis if it names one.
struct Coordinate {
    axis: Option<String>,
    number: f64,
    span: crate::base::diag::Span,
}

/// The coordinates of a field that are certain; incremental ones are not.
fn coordinates(facts: &Facts<'_>, range: &Definition<'_>, item: &Item<'_>) -> Vec<Coordinate> {
    let CycleForm::Lines(lines) = &range.view.form else { return Vec::new() };
    let words = lines.iter().flat_map(|line| &line.words);
    let own = words.filter(|word| item.span.start <= word.span.start && word.span.end <= item.span.end);
    let read = own.filter_map(|word| {
        let number = match word.value.kind {
            ValueKind::Number(number) => number,
            ValueKind::Q { negative, .. } => facts.known_at(word.value.span, negative)?,
            _ => return None,
        };
        let name = facts.text(word.name);
        let is_position = item.label.is_none() && !name.is_empty();
        let (axis, span) = if is_position { (Some(name.to_uppercase()), word.span) } else { (None, word.value.span) };
        Some(Coordinate { axis, number, span })
    });
    read.filter(|own| own.axis.as_ref().is_none_or(|name| name.len() == 1)).collect()
}
