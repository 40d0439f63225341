//! Holes that do not go together: one of a row is not centred while a centred place stays without a hole, or the others
//! of the row are, or the other centred places of it have holes; core holes of which only some are tapped, or holes of
//! which only some are reamed; a circle of holes that lacks one; a place between two calls that is only passed over; an
//! arc of a contour whose centre misses the hole that belongs to it; what a tool makes at all of at least five equal angles
//! but one.
//!
//! The first three and the last one need an execution of the whole program. Of arcs at least two others must lie about holes, and the one
//! coordinate that differs must look like a slip of the keyboard. Each is said once a program.
use crate::base::diag::{Diagnostic, Severity, Span};
use crate::check::incident::Incident;
use crate::check::program::is_silent;
use crate::check::slip::is_slip;
use crate::check::travel::incidents;
use crate::check::{Facts, Pending, Rule};
use crate::program::syntax::{Amount, Axis, Block, BlockKind, CallForm, Coord, Motion, Path, ValueKind};

pub(super) const RULE: Rule = Rule { code: "holes-differ", severity: Severity::Warning, run };

/// Longer programs are written by posts.
const MOST: usize = 3_000;
/// So many arcs about holes make a rule.
const OTHERS: usize = 2;
/// What counts as the same place, mm or inch.
const SAME: f64 = 1e-3;

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let mut report = |span: Span, what: &str, [x, y]: [f64; 2]| {
        found.push(rule.comparison(facts, span, what, x, y));
    };
    let mut reported = [false; 8];
    for (span, own) in incidents(facts) {
        let (what, place, at) = match own {
            Incident::NotCentred(place) => ("stray", *place, 0),
            Incident::Untapped(place) => ("untapped", *place, 1),
            Incident::OnlyOneNotCentred(place) => ("uncentred", *place, 5),
            Incident::CentredInVain(place) => ("unused", *place, 6),
            Incident::Unreamed(place) => ("unreamed", *place, 4),
            Incident::GapInCircle(place) => ("gap", *place, 2),
            Incident::CornerOfRectangleOff(place) => ("corner", *place, 3),
            Incident::RotationsLackOne(count) => ("rotation", [(count - 1) as f64, *count as f64], 7),
            _ => continue,
        };
        if !std::mem::replace(&mut reported[at], true) {
            report(*span, what, place);
        }
    }
    if facts.program.blocks().len() > MOST {
        return;
    }
    if let Some((block, place)) = passed(facts) {
        report(facts.content(block), "passed", place);
    }
    if let Some((span, place)) = arc(facts) {
        report(span, "arc", place);
    }
}

/// A rapid movement in the plane between two that call the same cycle with M99: it stops at a place and does nothing there.
fn passed<'a>(facts: &Facts<'a>) -> Option<(&'a Block, [f64; 2])> {
    let calls: Vec<(usize, Pending)> = facts.run.calls.iter().map(|call| (call.block, call.modal.pending)).collect();
    let cycle = |index: usize| calls.iter().filter(|(at, _)| *at == index).map(|(_, own)| *own).collect::<Vec<_>>();
    let blocks = facts.program.blocks();
    let mut at: [Option<f64>; 2] = [None; 2];
    // The blocks since the last one that was no movement: their place in the program and whether they call a cycle.
    let mut row: Vec<(usize, bool)> = Vec::new();
    let mut place_of = Vec::new();
    for (index, block) in blocks.iter().enumerate().filter(|(_, block)| !is_silent(block)) {
        let words = match &block.kind {
            BlockKind::Motion(motion) if motion.path() == Path::L && motion.outline().is_rapid() && !block.skip => {
                motion.words()
            }
            // A call after a movement belongs to it.
            BlockKind::CyclCall(call) if matches!(call.form, CallForm::Plain) => {
                if let Some(last) = row.last_mut() {
                    *last = (index, true);
                }
                continue;
            }
            _ => {
                (row, place_of, at) = (Vec::new(), Vec::new(), [None; 2]);
                continue;
            }
        };
        let flat = words.coords.iter().all(|own| matches!(own.axis, Axis::X | Axis::Y)) && !words.coords.is_empty();
        at = crate::check::contours::moved(&words, [Axis::X, Axis::Y], at).unwrap_or([None; 2]);
        // Coolant goes with the first position.
        let only_call = words.functions.iter().all(|own| matches!(own.number, 8 | 9 | 99));
        let called = words.functions.iter().any(|own| own.number == 99);
        if !flat || !only_call {
            (row, place_of) = (Vec::new(), Vec::new());
            continue;
        }
        row.push((index, called));
        place_of.push(at);
        // What is called at the end of the row is known when the next movement comes, or at once with M99.
        let next = |from: usize| blocks.get(from..).into_iter().flatten().find(|own| !is_silent(own));
        let calls_next = next(index + 1)
            .is_some_and(|own| matches!(&own.kind, BlockKind::CyclCall(call) if matches!(call.form, CallForm::Plain)));
        if calls_next {
            let at =
                blocks.iter().skip(index + 1).position(|own| !is_silent(own)).map_or(index, |more| index + 1 + more);
            if let Some(last) = row.last_mut() {
                *last = (at, true);
            }
        }
        let [.., (first, true), (idle, false), (last, true)] = row.as_slice() else { continue };
        let many = row.iter().filter(|(_, calls)| *calls).count() > 2
            || next(last + 1).is_some_and(|own| match &own.kind {
                BlockKind::Motion(motion) => {
                    let words = motion.words();
                    let calls = words.functions.iter().any(|own| own.number == 99);
                    calls || calls_next && motion.outline().is_rapid() && words.coord(Axis::Z).is_none()
                }
                _ => false,
            });
        let (one, other) = (cycle(*first), cycle(*last));
        let place = place_of.get(row.len() - 2).copied().unwrap_or_default();
        if let ([Some(x), Some(y)], true, true) = (place, many, one == other && !one.is_empty()) {
            return blocks.get(*idle).map(|block| (block, [x, y]));
        }
    }
    None
}

/// The centre of an arc with its places: the span of each coordinate.
type Centre = [(f64, Span); 2];

/// An arc whose centre differs in one coordinate, by a slip, from a hole about which no other arc lies.
fn arc(facts: &Facts<'_>) -> Option<(Span, [f64; 2])> {
    let centres: Vec<Centre> = facts.program.blocks().iter().filter_map(|block| centre(facts, block)).collect();
    if centres.len() <= OTHERS {
        return None;
    }
    let mut holes: Vec<[f64; 2]> = Vec::new();
    for call in &facts.run.calls {
        let Some(hole) = facts.program.blocks().get(call.block).and_then(hole) else { continue };
        if !holes.iter().any(|own| is_same(*own, hole)) {
            holes.push(hole);
        }
    }
    let at = |own: &Centre| own.map(|(value, _)| value);
    let about = |hole: &[f64; 2]| centres.iter().filter(|own| is_same(at(own), *hole)).count();
    if holes.iter().filter(|hole| about(hole) > 0).count() < OTHERS {
        return None;
    }
    let free = || holes.iter().filter(|hole| about(hole) == 0);
    centres.iter().filter(|own| !holes.iter().any(|hole| is_same(at(own), *hole))).find_map(|own| {
        let hole = free().find(|hole| {
            let differs: Vec<usize> = (0..2).filter(|axis| (own[*axis].0 - hole[*axis]).abs() > SAME).collect();
            matches!(differs.as_slice(), [only] if is_slip(own[*only].0, hole[*only]))
        })?;
        let axis = (0..2).find(|axis| (own[*axis].0 - hole[*axis]).abs() > SAME)?;
        Some((own[axis].1, *hole))
    })
}

fn is_same(one: [f64; 2], other: [f64; 2]) -> bool {
    (0..2).all(|axis| (one[axis] - other[axis]).abs() <= SAME)
}

/// The centre that a block writes with both coordinates: of CC, or of an arc of a free contour.
fn centre(facts: &Facts<'_>, block: &Block) -> Option<Centre> {
    let BlockKind::Motion(motion) = &block.kind else { return None };
    match motion.path() {
        Path::Cc => {
            let words = motion.words();
            let own = |axis: Axis| written(&words.coords, axis);
            Some([own(Axis::X)?, own(Axis::Y)?])
        }
        Path::Fc | Path::Fct => {
            let words = motion.words();
            let own = |name: &str| word(facts, &words, name);
            Some([own("CCX")?, own("CCY")?])
        }
        _ => None,
    }
}

fn word(facts: &Facts<'_>, words: &Motion, name: &str) -> Option<(f64, Span)> {
    let own = words.words.iter().find(|own| facts.text(own.name).trim().eq_ignore_ascii_case(name))?;
    match own.value.kind {
        ValueKind::Number(number) => Some((number, own.span)),
        _ => None,
    }
}

fn written(coords: &[Coord], axis: Axis) -> Option<(f64, Span)> {
    let coord = coords.iter().find(|own| own.axis == axis && !own.incremental)?;
    match coord.value.amount {
        Amount::Number(number) => Some((number, coord.value.span)),
        _ => None,
    }
}

/// The place of a hole that the block of its call writes with both coordinates.
fn hole(block: &Block) -> Option<[f64; 2]> {
    let coords = match &block.kind {
        BlockKind::Motion(motion) => motion.words().coords,
        BlockKind::CyclCall(call) => match &call.form {
            CallForm::Position(coords) => coords.clone(),
            _ => return None,
        },
        _ => return None,
    };
    Some([written(&coords, Axis::X)?.0, written(&coords, Axis::Y)?.0])
}
