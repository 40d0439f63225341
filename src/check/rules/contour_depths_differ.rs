//! A contour with radius compensation that two tools machine, where the depths do not go together: roughing has come down less
//! far than finishing goes in one pass, or one infeed farther; or a chamfer is cut below the floor of its contour.
//!
//! Contours are the same if their blocks have the same coordinates, as written; how deep each tool goes there is seen in an
//! execution, through repeats, subprograms and parameters. Said once a program.
use std::collections::{BTreeMap, BTreeSet};

use crate::base::diag::{Diagnostic, Severity, Span};
use crate::check::contours::written;
use crate::check::incident::Incident;
use crate::check::program::is_silent;
use crate::check::tools::kind_of_call;
use crate::check::travel::incidents;
use crate::check::{Facts, Rule, ToolKind};
use crate::program::syntax::{Block, BlockKind, Compensates, Path};

pub(super) const RULE: Rule = Rule { code: "contour-depths-differ", severity: Severity::Warning, run };

/// Longer programs are written by posts.
const MOST: usize = 3_000;
/// A contour has so many elements.
const LEAST: usize = 3;
/// What counts as the same height, mm, and the allowance for a floor.
const SAME: f64 = 0.01;
const ALLOWANCE: f64 = 2.0;

/// What one tool does along a contour: the line of its call, where it begins, and its heights from the top.
struct Pass {
    call: usize,
    place: Span,
    heights: Vec<f64>,
}

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    if facts.program.blocks().len() > MOST || facts.shaped().next().is_none() {
        return;
    }
    let heights = heights(facts);
    if heights.is_empty() {
        return;
    }
    // The passes of each contour, by the lines of the tool calls.
    let mut contours: BTreeMap<Vec<String>, BTreeMap<usize, Pass>> = BTreeMap::new();
    for (block, elements) in contours_of(facts) {
        let passes = contours.entry(elements).or_default();
        for ((_, call), heights) in heights.range((block.line, 0)..(block.line + 1, 0)) {
            let place = facts.content(block);
            let pass = passes.entry(*call).or_insert_with(|| Pass { call: *call, place, heights: Vec::new() });
            pass.heights.extend(heights.iter().map(|own| *own as f64 * SAME));
        }
    }
    for passes in contours.into_values() {
        let mut passes: Vec<Pass> = passes.into_values().collect();
        for own in &mut passes {
            own.heights.sort_by(|one, other| other.total_cmp(one));
            own.heights.dedup();
        }
        let mut pairs =
            passes.iter().enumerate().flat_map(|(at, first)| passes.iter().skip(at + 1).map(move |own| (first, own)));
        let wrong = pairs.find_map(|(first, last)| {
            let (what, value, other) = differ(facts, first, last)?;
            // Another tool may have come down between.
            let between = passes.iter().filter(|own| first.call < own.call && own.call < last.call);
            let reached = between.flat_map(|own| own.heights.last()).any(|own| *own <= value + SAME);
            (what != "shallow" || !reached).then_some((last.place, what, value, other))
        });
        if let Some((place, what, value, other)) = wrong {
            return found.push(rule.comparison(facts, place, what, value, other));
        }
    }
}

/// What is wrong with the depths of two passes, with the depth of the last one and of the first one.
fn differ(facts: &Facts<'_>, first: &Pass, last: &Pass) -> Option<(&'static str, f64, f64)> {
    let (reached, wanted) = (*first.heights.last()?, *last.heights.last()?);
    let unit = facts.millimetre();
    let kind = |pass: &Pass| {
        let blocks = facts.program.blocks();
        kind_of_call(facts, blocks.partition_point(|block| block.line < pass.call))
    };
    let breaks = |kind: Option<ToolKind>| matches!(kind, Some(ToolKind::Chamfer | ToolKind::Spot | ToolKind::Engraver));
    match (breaks(kind(first)), breaks(kind(last))) {
        (false, true) => return (wanted < reached - SAME).then_some(("chamfer", wanted, reached)),
        (true, _) => return None,
        (false, false) => {}
    }
    let step = first.heights.windows(2).map(|two| two[0] - two[1]).fold(f64::INFINITY, f64::min);
    let single = last.heights.len() == 1;
    if wanted < reached {
        // A last infeed of finishing may be as deep as those before.
        let most = if step.is_finite() { 0.5 * step } else { ALLOWANCE * unit };
        return (single && reached - wanted > most.max(ALLOWANCE * unit)).then_some(("shallow", wanted, reached));
    }
    let once = (wanted - reached - step).abs() <= SAME;
    (step.is_finite() && once).then_some(("deep", wanted, reached))
}

/// The heights at which tools go along contours, by line and tool call, in steps.
fn heights(facts: &Facts<'_>) -> BTreeMap<(usize, usize), BTreeSet<i64>> {
    let mut found: BTreeMap<(usize, usize), BTreeSet<i64>> = BTreeMap::new();
    for (_, own) in incidents(facts) {
        if let Incident::ContourAt { line, call, height } = own {
            found.entry((*line, *call)).or_default().insert((*height / SAME).round() as i64);
        }
    }
    found
}

/// The blocks with which contours begin, and the coordinates of their elements as they are written.
fn contours_of<'f>(facts: &'f Facts<'_>) -> Vec<(&'f Block, Vec<String>)> {
    let mut found = Vec::new();
    let mut current: Option<(&Block, Vec<String>)> = None;
    for block in facts.program.blocks() {
        let motion = match &block.kind {
            _ if is_silent(block) || block.is_blend() => continue,
            BlockKind::Motion(motion) => motion,
            BlockKind::CallLbl(call) if call.repeat.is_none() => {
                if let Some((_, elements)) = &mut current {
                    elements.push(facts.text(facts.content(block)).to_ascii_uppercase());
                }
                continue;
            }
            BlockKind::Lbl(_) | BlockKind::CallLbl(_) => continue,
            _ => {
                current = None;
                continue;
            }
        };
        if matches!(motion.path(), Path::Rnd | Path::Chf) {
            continue;
        }
        let compensates = motion.outline().compensates();
        if compensates == Compensates::Off || matches!(motion.path(), Path::Dep(_)) {
            found.extend(current.take().filter(|(_, elements)| elements.len() >= LEAST));
        } else if current.is_some() || compensates == Compensates::Beside {
            let (_, elements) = current.get_or_insert_with(|| (block, Vec::new()));
            let words = motion.words();
            elements.push(written(facts, &words));
        }
    }
    found
}
