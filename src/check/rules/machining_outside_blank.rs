//! A pocket, a stud, a slot or a place of a contour that is so far from the blank that nothing of it is machined there,
//! a round pocket that the edge of the blank cuts, a rectangular one that leaves nothing of it or goes far beyond it at
//! both ends, or would lie inside of it with its sides exchanged; a cycle that stays above the blank, and a movement that
//! cuts far below it, where an execution shows them; a cycle of the old form that no manual describes and that is called far above the blank: it works from where the
//! tool is; a contour that is called above the blank, and elsewhere inside of it; a pocket or slot that lies across the face
//! milled in a tilted plane, and goes beyond it at both ends; a whole circle, or a curve that a loop draws, which begins in
//! the blank and is outside of it for a part.
//!
//! Only at places that are known, in programs with a box as their blank and without transformations. Each is said once
//! a program.
use std::collections::BTreeMap;

use crate::base::diag::{Diagnostic, Severity, Span};
use crate::check::blank::{Blank, is_unmoved};
use crate::check::contours::place_of_call;
use crate::check::incident::Incident;
use crate::check::program::{is_silent, number};
use crate::check::travel::{first_incident, incidents};
use crate::check::{Aspect, CycleCall, Defined, Facts, Pending, Rule, Tri};
use crate::program::syntax::{Amount, Axis, Block, BlockKind, Compensates, CycleForm, Path, StatementKind, ValueKind};
use crate::spec::{Group, Keyword, Known};

pub(super) const RULE: Rule = Rule { code: "machining-outside-blank", severity: Severity::Warning, run };

/// So far above the blank no cycle begins that works from where the tool is, in millimetres.
const HIGH: f64 = 50.0;
/// So many lines a cycle has that machines: its name, clearance, depth and more.
const LINES: usize = 4;
/// The meanings of a face that is milled: where it begins, its sides, and its height.
const FACE: [&str; 5] =
    ["starting-point-main", "starting-point-minor", "first-side-length", "second-side-length", "end-point-tool"];
/// So many blocks before a call are looked at for the height.
const BACK: usize = 32;

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let (mut outside, mut over, mut above, mut below, mut curve) = (false, false, false, false, false);
    for (span, own) in incidents(facts) {
        let (what, [x, y], said) = match own {
            Incident::OutsideBlank(place) => ("outside", *place, &mut outside),
            Incident::CurveLeavesBlank(place) => ("curve", *place, &mut curve),
            Incident::CoversBlank(place) => ("over", *place, &mut over),
            Incident::AboveBlank(height) => ("above", [*height, 0.0], &mut above),
            Incident::BelowBlank(height) => ("below", [*height, 0.0], &mut below),
            _ => continue,
        };
        if !std::mem::replace(said, true) {
            found.push(rule.comparison(facts, *span, what, x, y));
        }
    }
    let pass = first_incident(facts, |own| match own {
        Incident::PassInAir(height) => Some(height),
        _ => None,
    });
    let contour = called_above(facts);
    if let Some((span, height)) = pass.filter(|_| !above && contour.is_none()) {
        found.push(rule.comparison(facts, span, "above", height, 0.0));
    }
    if let Some((span, [x, y])) = from_corner(facts).filter(|_| !over && !outside) {
        found.push(rule.comparison(facts, span, "corner", x, y));
    }
    if let Some((span, long, room)) = across(facts) {
        found.push(rule.comparison(facts, span, "across", long, room));
    }
    if let Some((span, height)) = contour.filter(|_| !above) {
        found.push(rule.comparison(facts, span, "contour", height, 0.0));
    }
    if let Some((span, height)) = old_cycle(facts).filter(|_| !above) {
        found.push(rule.comparison(facts, span, "above", height, 0.0));
    }
}

/// A pocket whose position counts from a corner, and which goes over the edge of the blank, though it is called at the middle
/// of the blank and would fit there about its centre: where the choice is, and the place.
fn from_corner(facts: &Facts<'_>) -> Option<(Span, [f64; 2])> {
    /// What is so near to the middle is in it, mm or inch.
    const NEAR: f64 = 1e-3;
    let blank = Blank::of(facts.program)?;
    facts.run.calls.iter().filter(|call| is_unmoved(&call.modal)).find_map(|call| {
        let Pending::Definition(index) = call.modal.pending else { return None };
        let own = facts.definitions.get(index as usize)?;
        own.related_cycle().filter(|cycle| cycle.file.group == Group::Pockets)?;
        let related = own.as_related_cycle();
        let read = facts.read(&related);
        let choice = read.item("pocket-position")?;
        let corner = number(choice).filter(|own| *own != 0.0)?;
        let sides = ["first-side-length", "second-side-length"].map(|meaning| read.item(meaning).and_then(number));
        let [Some(long), Some(wide)] = sides else { return None };
        let place = place_of_call(facts, call.block)?;
        let middle = |axis: usize| (place[axis] - (blank.low[axis] + blank.high[axis]) / 2.0).abs() <= NEAR;
        let room = [0, 1].map(|axis| (blank.high[axis] - blank.low[axis]) / 2.0);
        let fits = long / 2.0 < room[0] && wide / 2.0 < room[1];
        let over = long > room[0] || wide > room[1];
        let turned = read.item("angle-of-rotation").and_then(number) != Some(0.0);
        let wrong = middle(0) && middle(1) && fits && over && !turned && (1.0..=4.0).contains(&corner);
        wrong.then_some((choice.value_span, place))
    })
}

/// A pocket or slot in the only tilted plane of a program that goes beyond the face milled there, at its surface, at both ends,
/// while it would lie on it if it were turned by 90 degrees: where its angle is, its side and that of the face.
fn across(facts: &Facts<'_>) -> Option<(Span, f64, f64)> {
    let tilts = |block: &Block| match &block.kind {
        BlockKind::Statement(own) if own.kind == StatementKind::Plane => {
            !facts.text(facts.content(block)).to_ascii_uppercase().contains("RESET")
        }
        _ => false,
    };
    if facts.marked().filter(|(_, block)| tilts(block)).count() != 1 {
        return None;
    }
    let tilted = facts.run.calls.iter().filter(|call| call.modal.is(Aspect::Tilting) == Tri::Yes);
    let of = |call: &CycleCall| match call.modal.pending {
        Pending::Definition(index) => facts.definitions.get(index as usize),
        Pending::None | Pending::Unknown => None,
    };
    let called: Vec<(usize, &Defined<'_>)> = tilted.filter_map(|call| Some((call.block, of(call)?))).collect();
    let group = |own: &Defined<'_>| own.related_cycle().map(|cycle| cycle.file.group);
    let mut faces = called.iter().filter(|(_, own)| group(own) == Some(Group::Surfaces));
    let face = faces.next().filter(|_| faces.next().is_none()).map(|(_, own)| own.as_related_cycle())?;
    let read = facts.read(&face);
    let [x, y, long, wide, end] = FACE.map(|meaning| read.item(meaning).and_then(number));
    let corner = [(x?, long?), (y?, wide?)].map(|(from, side)| [from.min(from + side), from.max(from + side)]);
    let pockets = called.iter().filter(|(_, own)| group(own) == Some(Group::Pockets));
    pockets.into_iter().find_map(|(block, own)| beyond(facts, *block, own, corner, end?))
}

/// Whether a pocket goes beyond a face in this way.
fn beyond(
    facts: &Facts<'_>,
    block: usize,
    own: &Defined<'_>,
    face: [[f64; 2]; 2],
    end: f64,
) -> Option<(Span, f64, f64)> {
    let related = own.as_related_cycle();
    let read = facts.read(&related);
    let value = |meaning: &str| read.item(meaning).and_then(number);
    let first = |all: [&str; 2]| all.into_iter().find_map(value);
    let sides = [first(["slot-length", "first-side-length"])?, first(["milled-slot-width", "second-side-length"])?];
    let centred = first(["slot-position", "pocket-position"])? == 0.0;
    let turn = read.item("angle-of-rotation")?;
    let quarters = number(turn)? / 90.0;
    if !centred || quarters.fract() != 0.0 || (value("surface-coordinate")? - end).abs() > 1e-6 {
        return None;
    }
    let middle = place_of_call(facts, block)?;
    let room = facts.millimetre();
    let ends = |axis: usize, side: f64| [middle[axis] - side / 2.0, middle[axis] + side / 2.0];
    let fits = |axis: usize, side: f64| {
        let [low, high] = ends(axis, side);
        face[axis][0] <= low && high <= face[axis][1]
    };
    let turned = quarters.rem_euclid(2.0) == 1.0;
    let side = |axis: usize| sides[usize::from((axis == 1) != turned)];
    let exceeds = |axis: &usize| {
        let [low, high] = ends(*axis, side(*axis));
        low < face[*axis][0] - room && high > face[*axis][1] + room
    };
    let axis = (0..2).find(exceeds)?;
    let would_fit = fits(0, side(1)) && fits(1, side(0));
    would_fit.then_some((turn.value_span, side(axis), face[axis][1] - face[axis][0]))
}

/// The first call of a contour directly after a movement at feed to a height above the blank, if it is called at a
/// height inside of the blank elsewhere.
fn called_above(facts: &Facts<'_>) -> Option<(Span, f64)> {
    let top = Blank::of(facts.program)?.high[2];
    // By the blocks of their labels: the lowest height, and the first one above the blank.
    let mut heights: BTreeMap<usize, (f64, Option<(Span, f64)>)> = BTreeMap::new();
    let blocks = facts.program.blocks();
    for (index, block) in facts.marked().filter(|(_, block)| matches!(block.kind, BlockKind::CallLbl(_))) {
        let Some(label) = facts.run.graph.called_from(index) else { continue };
        let before = blocks.get(..index).and_then(|before| before.iter().rfind(|block| !is_silent(block)));
        let Some((place, height)) = before.filter(|own| !own.skip && !block.skip).and_then(|own| plunge(facts, own))
        else {
            continue;
        };
        let own = heights.entry(label).or_insert((height, None));
        own.0 = own.0.min(height);
        if height > top && own.1.is_none() {
            own.1 = Some((place, height));
        }
    }
    let wrong = heights.into_iter().filter(|(label, (lowest, _))| *lowest < top && is_contour(facts, *label));
    wrong.filter_map(|(_, (_, above))| above).min_by_key(|(span, _)| span.start)
}

/// The height to which a block goes at feed along the tool axis alone.
fn plunge(facts: &Facts<'_>, block: &Block) -> Option<(Span, f64)> {
    let BlockKind::Motion(motion) = &block.kind else { return None };
    let words = motion.words();
    let [own] = words.coords.as_slice() else { return None };
    let Amount::Number(height) = own.value.amount else { return None };
    let down = own.axis == Axis::Z && !own.incremental && !motion.outline().is_rapid();
    down.then_some((facts.content(block), height))
}

/// Whether a subprogram begins with a contour at the height where it is called.
fn is_contour(facts: &Facts<'_>, label: usize) -> bool {
    for block in facts.subprogram(label).unwrap_or_default() {
        let BlockKind::Motion(motion) = &block.kind else { continue };
        let outline = motion.outline();
        if outline.has_functions() || motion.words().coord(Axis::Z).is_some() {
            return false;
        }
        if outline.compensates() == Compensates::Beside {
            return true;
        }
    }
    false
}

/// The first call of a cycle of the old form far above the blank, with its height.
fn old_cycle(facts: &Facts<'_>) -> Option<(Span, f64)> {
    let surface = Blank::of(facts.program)?.high[2];
    let top = surface + HIGH * facts.millimetre();
    let blocks = facts.program.blocks();
    facts.run.calls.iter().find_map(|call| {
        let own = facts.definition_before(call.block)?;
        // What acts when it is defined has fewer lines.
        let long = matches!(&own.view.form, CycleForm::Lines(lines) if lines.len() >= LINES);
        let lines = long && own.key.keyword == Keyword::CyclDef;
        // No one describes it, so it states no surface.
        let named = match own.known {
            Known::Named(named) => named.activates.is_none(),
            Known::Unknown => true,
            Known::Described(_) | Known::Builders => false,
        };
        let straight = !blocks.get(own.view.last + 1..call.block)?.iter().any(leads);
        let flat = call.modal.is(Aspect::Tilting) != Tri::Yes && call.modal.is(Aspect::ShiftZ) != Tri::Yes;
        if !(lines && named && own.related_cycle().is_none() && straight && flat) {
            return None;
        }
        let height = height(facts, call.block)?;
        let reach = reach(own).map_or(0.0, |reach| height + reach - surface);
        (height > top || reach > 0.0).then_some((call.span, height))
    })
}

/// How far below where the tool is the cycle of such a definition goes, a negative number: its first value is the
/// clearance above the surface and its second one the depth.
fn reach(own: &Defined<'_>) -> Option<f64> {
    let CycleForm::Lines(lines) = &own.view.form else { return None };
    let value = |line: u32| {
        let words = lines.iter().find(|own| own.line == line)?.words.as_slice();
        match words {
            [only] => match only.value.kind {
                ValueKind::Number(number) => Some(number),
                _ => None,
            },
            _ => None,
        }
    };
    let (clearance, depth) = (value(1)?, value(2)?);
    (clearance > 0.0 && depth < 0.0).then_some(depth - clearance)
}

/// Whether another way may lead to a block, or away from it.
const fn leads(block: &Block) -> bool {
    matches!(block.kind, BlockKind::Lbl(_) | BlockKind::CallLbl(_) | BlockKind::CallPgm(_) | BlockKind::FnJump(_))
}

/// The height to which the blocks before a call have moved the tool, as far as they lie in a row.
fn height(facts: &Facts<'_>, block: usize) -> Option<f64> {
    let before = facts.program.blocks().get(block.saturating_sub(BACK)..=block)?;
    for own in before.iter().rev().take_while(|own| !leads(own) && !own.skip) {
        let BlockKind::Motion(motion) = &own.kind else { continue };
        let words = motion.words();
        if words.functions.iter().any(|own| matches!(own.number, 91 | 92)) || words.path != Path::L {
            return None;
        }
        if let Some(coord) = words.coord(Axis::Z) {
            return facts.number(&coord.value).filter(|_| !coord.incremental);
        }
    }
    None
}
