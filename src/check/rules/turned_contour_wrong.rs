//! Turning to a contour that cannot be meant: its end or a corner of it is above the blank, a recess is narrower than
//! the tool, the same tool recesses inwards and outwards, a contour without undercuts falls below the diameter with
//! which it begins, a rounding needs more of a line than there is, a recess is deeper than the tool is long, a face
//! ends in an edge without any width. Where an execution shows it, also turning through the wall of the part, and a
//! cycle that turns only in the air.
//!
//! The width of the tool is that of the table of turning tools. The tool position that a cycle takes as the start of
//! the contour is known where movements directly before the call name it as numbers.
use std::collections::HashMap;

use crate::base::diag::{Arg, Diagnostic, Severity};
use crate::check::blank::top;
use crate::check::contours::{listed, moved, wanted};
use crate::check::incident::Incident;
use crate::check::program::{is_silent, number, with_meaning};
use crate::check::tools::named;
use crate::check::travel::first_incident;
use crate::check::{CycleCall, Defined, Definition, Facts, Loaded, Pending, Rule};
use crate::program::syntax::{Amount, Axis, Block, BlockKind, Path};
use crate::spec::{Group, MM_PER_INCH};

pub(super) const RULE: Rule = Rule { code: "turned-contour-wrong", severity: Severity::Warning, run };

/// The meanings of the ends of a simple contour, and of its start where a cycle has one.
const END: [&str; 2] = ["contour-end-diameter", "contour-end-z"];
const START: [&str; 2] = ["contour-start-diameter", "contour-start-z"];
/// The meaning that only cycles for recesses have, and that of machining undercuts.
const RECESS: &str = "recess-clearance";
const UNDERCUT: &str = "undercut-machining";
/// What counts as the same, mm or inch, and how far above the blank something is.
const NEAR: f64 = 0.01;
const ABOVE: f64 = 1.0;
/// So many blocks before a call are looked at for the position.
const BACK: usize = 32;

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let turns = |own: &Defined<'_>| own.related_cycle().is_some_and(|cycle| cycle.file.group == Group::Turning);
    if !facts.definitions.iter().any(turns) {
        return;
    }
    let unit = if facts.inch { MM_PER_INCH } else { 1.0 };
    let top = top(facts.program);
    // Which way each tool recesses: outside of the part or inside.
    let mut ways: HashMap<u32, bool> = HashMap::new();
    for call in &facts.run.calls {
        let Pending::Definition(index) = call.modal.pending else { continue };
        let Some(own) = facts.definitions.get(index as usize).filter(|own| turns(own)) else { continue };
        let Some(cycle) = own.cycle() else { continue };
        let read = facts.read(own);
        let Some(contour) = simple(facts, &read, call) else { continue };
        let report = |item: &str, what: &str, value: f64| {
            let place = read.item(item).map_or(own.view.head, |item| item.value_span);
            rule.at(facts, place).arg("what", what.to_owned()).arg("value", Arg::Number(rounded(value)))
        };
        if let (Some(top), Some(end)) = (top, contour.end[1])
            && end > top + ABOVE / unit
            && contour.start[1].is_none_or(|start| top - start < end - top)
        {
            found.push(report(END[1], "above", end).arg("limit", Arg::Number(top)));
            continue;
        }
        if with_meaning(cycle, RECESS).is_none() {
            continue;
        }
        let axial = cycle.file.name.as_str().contains("axial");
        let across = |at: usize| Some((contour.start[at]? - contour.end[at]?).abs() / if at == 0 { 2.0 } else { 1.0 });
        if let (Some(width), Some(tool)) = (across(usize::from(!axial)), cutting_width(facts, call.modal.loaded))
            && width < tool / unit - NEAR
        {
            let item = if axial { END[0] } else { END[1] };
            found.push(report(item, "narrow", width).arg("limit", Arg::Number(rounded(tool / unit))));
        }
        if let (Some(depth), Some(tool)) = (across(usize::from(axial)), cutting_length(facts, call.modal.loaded))
            && depth > tool / unit + NEAR
        {
            let item = if axial { END[1] } else { END[0] };
            found.push(report(item, "deep", depth).arg("limit", Arg::Number(rounded(tool / unit))));
        }
        if let (false, [Some(start), _], [Some(end), _], Loaded::By(block)) =
            (axial, contour.start, contour.end, call.modal.loaded)
        {
            let outwards = end > start;
            if *ways.entry(block).or_insert(outwards) != outwards {
                found.push(report(END[0], "side", end).arg("limit", Arg::Number(start)));
            }
        }
    }
    contours(rule, facts, unit, found);
    executed(rule, facts, found);
}

/// What an execution shows of the part.
fn executed(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let shown = first_incident(facts, |own| match own {
        Incident::WallTurnedThrough { other } => Some(("wall", 0.0, other)),
        _ => None,
    });
    let shown = shown.or_else(|| {
        first_incident(facts, |own| match own {
            Incident::TurnedInAir { tool, part } => Some(("air", tool, part)),
            _ => None,
        })
    });
    // What is said of a contour explains what comes after.
    if let Some((span, (what, value, limit))) = shown.filter(|_| found.iter().all(|own| own.code != rule.code)) {
        let finding = rule.at(facts, span).arg("what", what).arg("value", Arg::Number(rounded(value)));
        found.push(finding.arg("limit", Arg::Number(rounded(limit))));
    }
}

/// The start and the end of a contour that parameters describe: diameter and Z.
struct Simple {
    start: [Option<f64>; 2],
    end: [Option<f64>; 2],
}

fn simple(facts: &Facts<'_>, read: &Definition<'_>, call: &CycleCall) -> Option<Simple> {
    let value = |meaning: &str| read.item(meaning).and_then(number);
    let end = END.map(value);
    if end == [None; 2] {
        return None;
    }
    let named = START.map(|meaning| read.item(meaning).is_some());
    let at = position(facts, call.block);
    let start = [0, 1].map(|axis| if named[axis] { value(START[axis]) } else { at[axis] });
    Some(Simple { start, end })
}

/// Where the tool is before a call, in X and Z, as far as the movements directly before it name it.
fn position(facts: &Facts<'_>, block: usize) -> [Option<f64>; 2] {
    let mut found = [None; 2];
    let blocks = facts.program.blocks().get(..=block).unwrap_or_default();
    for own in blocks.iter().rev().take(BACK) {
        let motion = match &own.kind {
            BlockKind::Motion(motion) if !own.skip => motion.words(),
            BlockKind::CycleDef(_) | BlockKind::OldCycleLine(_) | BlockKind::CyclCall(_) | BlockKind::Functions(_) => {
                continue;
            }
            _ if is_silent(own) => continue,
            _ => break,
        };
        if motion.path != Path::L || motion.functions.iter().any(|own| matches!(own.number, 91 | 92)) {
            break;
        }
        for (known, axis) in found.iter_mut().zip([Axis::X, Axis::Z]) {
            if let (None, Some(coord)) = (&known, motion.coord(axis)) {
                match coord.value.amount {
                    Amount::Number(number) if !coord.incremental => *known = Some(number),
                    _ => return [None; 2],
                }
            }
        }
        if found.iter().all(Option::is_some) {
            break;
        }
    }
    found
}

/// The width of the cutting edge of the tool in the spindle, in mm.
fn cutting_width(facts: &Facts<'_>, loaded: Loaded) -> Option<f64> {
    recessing(facts, loaded, "CUTWIDTH")
}

/// How deep the tool in the spindle recesses, in mm.
fn cutting_length(facts: &Facts<'_>, loaded: Loaded) -> Option<f64> {
    recessing(facts, loaded, "CUTLENGTH")
}

/// What a column says of the tool in the spindle, if it recesses.
fn recessing(facts: &Facts<'_>, loaded: Loaded, column: &str) -> Option<f64> {
    let Loaded::By(block) = loaded else { return None };
    let BlockKind::ToolCall(call) = &facts.program.blocks().get(block as usize)?.kind else { return None };
    let (name, project) = (named(facts, call.tool?)?, facts.project?);
    let recesses = project.turning_type(name).is_some_and(|kind| matches!(kind, "RECESS" | "RECTURN"));
    project.turning_value(name, column).filter(|width| recesses && *width > 0.0)
}

/// The contours that cycles for turning read from subprograms.
fn contours(rule: &Rule, facts: &Facts<'_>, unit: f64, found: &mut Vec<Diagnostic>) {
    for list in listed(facts) {
        let turning: Vec<&Defined<'_>> =
            list.readers.iter().copied().filter(|own| wanted(own).is_some_and(|wanted| wanted.turned)).collect();
        let Some(first) = turning.first() else { continue };
        let recess =
            turning.iter().find(|own| own.related_cycle().is_some_and(|cycle| with_meaning(cycle, RECESS).is_some()));
        let straight = |own: &Defined<'_>| facts.read(own).item(UNDERCUT).and_then(number) == Some(0.0);
        let width = recess.and_then(|own| {
            let index = facts.definitions.iter().position(|other| other.view.first == own.view.first)?;
            let calls =
                |call: &&CycleCall| call.modal.pending == Pending::Definition(u32::try_from(index).unwrap_or(u32::MAX));
            cutting_width(facts, facts.run.calls.iter().find(calls)?.modal.loaded)
        });
        for contour in &list.contours {
            let Some(lines) = lines(contour) else { continue };
            let report = |block: &Block, what: &str, value: f64, limit: f64| {
                let finding = rule.at(facts, facts.content(block)).arg("what", what.to_owned());
                finding.arg("value", Arg::Number(rounded(value))).arg("limit", Arg::Number(rounded(limit)))
            };
            if let Some((top, (block, z))) =
                top(facts.program).and_then(|top| Some((top, beyond(&lines, top + ABOVE / unit)?)))
            {
                found.push(report(block, "corner", z, top));
                continue;
            }
            if let Some((block, size, most)) = large_rounding(&lines) {
                found.push(report(block, "rounding", size, most));
                continue;
            }
            if let Some(tool) = width {
                if let Some((block, own)) = narrowest(&lines).filter(|(_, own)| *own < tool / unit - NEAR) {
                    found.push(report(block, "narrow", own, tool / unit));
                }
            } else if let Some((block, top, other)) = ridge(&lines) {
                found.push(report(block, "ridge", top, other));
            } else if straight(first)
                && let Some((block, diameter, begin)) = dip(&lines)
            {
                found.push(report(block, "dip", diameter, begin));
            }
        }
    }
}

/// A point of a contour in Z and the radius, with its block and the rounding after it.
struct Point<'a> {
    block: &'a Block,
    at: [f64; 2],
    /// The block and radius of the rounding at this corner.
    rounding: Option<(&'a Block, f64)>,
    straight: bool,
}

/// The points of a contour of numbers.
fn lines(contour: &[Block]) -> Option<Vec<Point<'_>>> {
    let (mut points, mut at): (Vec<Point<'_>>, [Option<f64>; 2]) = (Vec::new(), [None; 2]);
    for block in contour {
        let motion = match &block.kind {
            BlockKind::Motion(motion) if !block.skip => motion.words(),
            _ if is_silent(block) || block.is_blend() => continue,
            _ => return None,
        };
        match motion.path {
            Path::Rnd => {
                let Amount::Number(radius) = motion.radius?.amount else { return None };
                points.last_mut()?.rounding = Some((block, radius));
                continue;
            }
            Path::Cc | Path::Chf => continue,
            Path::L | Path::C | Path::Cr | Path::Ct => at = moved(&motion, [Axis::Z, Axis::X], at)?,
            _ => return None,
        }
        let [Some(z), Some(diameter)] = at else { return None };
        points.push(Point { block, at: [z, diameter / 2.0], rounding: None, straight: motion.path == Path::L });
    }
    Some(points)
}

fn way(from: &Point<'_>, to: &Point<'_>) -> [f64; 2] {
    [to.at[0] - from.at[0], to.at[1] - from.at[1]]
}

/// The first rounding that takes more of a line than there is, with its radius and the largest possible one.
fn large_rounding<'a>(points: &[Point<'a>]) -> Option<(&'a Block, f64, f64)> {
    points.windows(3).find_map(|three| {
        let [before, corner, after] = three else { return None };
        let (block, radius) = corner.rounding.filter(|_| corner.straight && after.straight)?;
        let (one, other) = (way(corner, before), way(corner, after));
        let (long, wide) = (libm::hypot(one[0], one[1]), libm::hypot(other[0], other[1]));
        let cosine = (one[0] * other[0] + one[1] * other[1]) / (long * wide);
        let most = long.min(wide) * libm::sqrt((1.0 - cosine) / (1.0 + cosine));
        (most.is_finite() && radius > most + NEAR).then_some((block, radius, most))
    })
}

/// A point of a contour above a height between others that are below it, with its block.
fn beyond<'a>(points: &[Point<'a>], height: f64) -> Option<(&'a Block, f64)> {
    let inside = points.get(1..points.len().checked_sub(1)?)?;
    let high = inside.iter().position(|point| point.at[0] > height)? + 1;
    let below = |points: &[Point<'_>]| points.iter().any(|point| point.at[0] < height);
    // The contour comes from above at its beginning and may go there at its end.
    let both = below(points.get(..high)?) && below(points.get(high + 1..)?);
    both.then(|| (points[high].block, points[high].at[0]))
}

/// The narrowest bottom of a recess, with its block: a line between two that go opposite ways.
fn narrowest<'a>(points: &[Point<'a>]) -> Option<(&'a Block, f64)> {
    let bottoms = points.windows(4).filter_map(|four| {
        let [before, one, other, after] = four else { return None };
        let (down, along, up) = (way(before, one), way(one, other), way(other, after));
        let flat = |at: usize| along[at].abs() <= NEAR && along[1 - at].abs() > NEAR;
        let axis = [0, 1].into_iter().find(|at| flat(*at))?;
        let recess = down[axis] * up[axis] < 0.0 && other.straight;
        recess.then(|| (other.block, along[1 - axis].abs()))
    });
    bottoms.min_by(|one, other| one.1.total_cmp(&other.1))
}

/// The first point at which a contour of lines that grows in all other places comes back at once from a face, so that
/// an edge without any width stays: its block, its diameter and the one to which it falls.
fn ridge<'a>(points: &[Point<'a>]) -> Option<(&'a Block, f64, f64)> {
    if !points.iter().all(|point| point.straight) {
        return None;
    }
    let falls: Vec<usize> = (1..points.len()).filter(|at| points[*at].at[1] < points[*at - 1].at[1] - NEAR).collect();
    let [only] = falls.as_slice() else { return None };
    let [from, top, end] = points.get(only.checked_sub(2)?..=*only)? else { return None };
    let (face, back) = (way(from, top), way(top, end));
    // A rounding of the edge would be a shape that somebody wants.
    let sharp = top.rounding.is_none() && face[0].abs() <= NEAR && face[1] > NEAR && back[0].abs() > NEAR;
    // An undercut goes below the diameter before the face.
    (sharp && end.at[1] > from.at[1] + NEAR).then_some((top.block, 2.0 * top.at[1], 2.0 * end.at[1]))
}

/// The point at which a contour that has grown falls below its first diameter, with that and the first one.
fn dip<'a>(points: &[Point<'a>]) -> Option<(&'a Block, f64, f64)> {
    let first = points.first()?.at[1];
    let grown = points.iter().position(|point| point.at[1] > first + NEAR)?;
    if points.iter().take(grown).any(|point| point.at[1] < first - NEAR) {
        return None;
    }
    let fallen = points.iter().skip(grown).find(|point| point.at[1] < first - NEAR)?;
    Some((fallen.block, 2.0 * fallen.at[1], 2.0 * first))
}

fn rounded(value: f64) -> f64 {
    libm::round(value * 1e4) / 1e4
}
