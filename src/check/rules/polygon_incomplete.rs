//! A regular polygon in polar coordinates that lacks a corner: all corners lie on one circle about the pole, and all steps
//! between them are equal but one, which is twice as great.
//!
//! Only corners that are written as straight lines with numbers, one after the other, about a pole with numbers, of polygons
//! with five corners or more.
//!
//! Also a rectangle along the axes that lacks a corner: a contour with radius compensation has one line across, with acute
//! corners at both ends, and all its other lines lie on two sides. A triangle may be meant: it is reported where a remark
//! names both sides of the rectangle, a hole lies in the corner, or another contour goes round it.
use crate::base::diag::{Arg, Diagnostic, Severity, Span};
use crate::base::expr::atan2d;
use crate::check::contours::{Contour, compensated, led, place_of_call};
use crate::check::program::is_silent;
use crate::check::{Facts, Rule};
use crate::program::syntax::{Amount, Axis, Block, BlockKind, Motion, Path};

pub(super) const RULE: Rule = Rule { code: "polygon-incomplete", severity: Severity::Warning, run };

/// A polygon has so many corners at least, besides the one that it lacks.
const LEAST: usize = 4;
/// Steps that differ by less are equal, degrees, and what is so near to the circle lies on it, mm or inch.
const EQUAL: f64 = 0.05;
const NEAR: f64 = 0.02;

/// The corners of a polygon under way.
#[derive(Default)]
struct Corners {
    radius: Option<f64>,
    angles: Vec<f64>,
    last: Option<Span>,
    /// The pole, and where the tool is before the first corner.
    pole: Option<[f64; 2]>,
    before: Option<[f64; 2]>,
}

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    rectangles(rule, facts, found);
    let mut corners = Corners::default();
    let (mut pole, mut at) = (None, None);
    for block in facts.program.blocks() {
        let motion = match &block.kind {
            _ if is_silent(block) || block.is_blend() => continue,
            BlockKind::Motion(motion) if !block.skip => motion.words(),
            _ => {
                judge(rule, facts, &std::mem::take(&mut corners), None, found);
                at = None;
                continue;
            }
        };
        match motion.path {
            Path::Rnd | Path::Chf => continue,
            Path::Cc => {
                judge(rule, facts, &std::mem::take(&mut corners), None, found);
                pole = led(None, &motion);
                continue;
            }
            _ => {}
        }
        let own = corner(&motion, corners.radius);
        match own {
            Some((radius, angle)) if corners.radius.is_none_or(|own| (own - radius).abs() < 1e-6) => {
                if corners.angles.is_empty() {
                    (corners.pole, corners.before) = (pole, at);
                }
                corners.radius = Some(radius);
                corners.angles.push(angle);
                corners.last = Some(facts.content(block));
                at = None;
            }
            _ => {
                at = led(None, &motion);
                judge(rule, facts, &std::mem::take(&mut corners), at, found);
            }
        }
    }
}

/// The polar coordinates of a straight line; a radius that is not written is the one before.
fn corner(motion: &Motion, before: Option<f64>) -> Option<(f64, f64)> {
    if motion.path != Path::Lp || motion.coords.iter().any(|own| own.incremental) {
        return None;
    }
    let number = |axis: Axis| match motion.coord(axis)?.value.amount {
        Amount::Number(number) => Some(number),
        _ => None,
    };
    let radius = if motion.coord(Axis::Pr).is_some() { number(Axis::Pr) } else { before };
    Some((radius?, number(Axis::Pa)?))
}

fn judge(rule: &Rule, facts: &Facts<'_>, own: &Corners, after: Option<[f64; 2]>, found: &mut Vec<Diagnostic>) {
    let (Some(pole), Some(radius), Some(place)) = (own.pole, own.radius, own.last) else { return };
    let mut angles: Vec<f64> = own.angles.iter().map(|own| own.rem_euclid(360.0)).collect();
    // A corner that is named twice is reported by itself.
    let same = |one: &f64, other: &f64| (one - other).abs() < EQUAL;
    let inner = angles.get(1..).unwrap_or_default();
    if inner.iter().enumerate().any(|(at, one)| inner.iter().skip(at + 1).any(|other| same(one, other))) {
        return;
    }
    // A corner at the beginning or at the end may be written in other coordinates.
    for [x, y] in [own.before, after].into_iter().flatten() {
        let arm = [x - pole[0], y - pole[1]];
        if (libm::hypot(arm[0], arm[1]) - radius).abs() < NEAR {
            angles.push(atan2d(arm[1], arm[0]).rem_euclid(360.0));
        }
    }
    angles.sort_by(f64::total_cmp);
    // What ends where it begins names that corner twice.
    angles.dedup_by(|one, other| (*one - *other).abs() < EQUAL);
    let count = angles.len();
    if count < LEAST {
        return;
    }
    let step = 360.0 / (count as f64 + 1.0);
    let next = angles.iter().skip(1).copied().chain(angles.first().map(|first| first + 360.0));
    let steps: Vec<(f64, f64)> = angles.iter().zip(next).map(|(from, to)| (*from, to - from)).collect();
    let (double, equal): (Vec<_>, Vec<_>) = steps.into_iter().partition(|(_, own)| (own - 2.0 * step).abs() < EQUAL);
    let [(from, _)] = double.as_slice() else { return };
    if equal.iter().all(|(_, own)| (own - step).abs() < EQUAL) {
        let angle = libm::round((from + step).rem_euclid(360.0) * 1e3) / 1e3;
        let finding = rule.at(facts, place).arg("what", "polar").arg("value", Arg::Number(angle));
        found.push(finding.arg("count", count + 1));
    }
}

/// A rectangle that lacks a corner.
struct Rectangle {
    /// The ends of the line across, and the corner.
    across: [[f64; 2]; 2],
    /// How long its sides are.
    sides: [f64; 2],
    corner: [f64; 2],
    place: Span,
}

/// Rectangles along the axes that lack a corner.
fn rectangles(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let contours = compensated(facts);
    for own in contours.iter().filter_map(rectangle) {
        let passed = contours
            .iter()
            .flatten()
            .any(|(place, _)| libm::hypot(place[0] - own.corner[0], place[1] - own.corner[1]) < NEAR);
        if passed || is_remarked(facts, &own) || is_drilled(facts, &own) {
            let finding = rule.at(facts, own.place).arg("what", "rectangle");
            let [x, y] = own.corner;
            return found.push(finding.arg("value", Arg::Number(x)).arg("other", Arg::Number(y)));
        }
    }
}

/// The rectangle that a contour would be with one more corner.
fn rectangle(contour: &Contour) -> Option<Rectangle> {
    let along = |one: [f64; 2], other: [f64; 2]| [(one[0] - other[0]).abs() < NEAR, (one[1] - other[1]).abs() < NEAR];
    let mut sides: Vec<([[f64; 2]; 2], Span)> = Vec::new();
    for pair in contour.windows(2) {
        let [(from, _), (to, place)] = pair else { continue };
        if along(*from, *to) != [true; 2] {
            sides.push(([*from, *to], *place));
        }
    }
    let mut lines = sides.iter().enumerate().filter(|(_, ([from, to], _))| along(*from, *to) == [false; 2]);
    let (at, ([begin, end], place)) = lines.next().filter(|_| lines.next().is_none())?;
    let way = |[from, to]: [[f64; 2]; 2]| [to[0] - from[0], to[1] - from[1]];
    let dot = |one: [f64; 2], other: [f64; 2]| one[0] * other[0] + one[1] * other[1];
    let ([first, _], [_, last]) = (sides.first()?.0, sides.last()?.0);
    let across = way([*begin, *end]);
    // Both of its corners are acute: else it is a chamfer. One of them may lie within the side where the contour ends.
    let acute = [at.checked_sub(1).and_then(|at| sides.get(at)), sides.get(at + 1)]
        .map(|side| side.is_none_or(|(side, _)| dot(way(*side), across) < 0.0));
    let open = at == 0 || at + 1 == sides.len();
    let edge = if at == 0 { sides.last()?.0 } else { sides.first()?.0 };
    let overlaps = dot(way([first, last]), way(edge)) > NEAR;
    if acute != [true; 2] || sides.len() < 3 || open && !overlaps {
        return None;
    }
    let corners = [[begin[0], end[1]], [end[0], begin[1]]];
    let corner = corners.into_iter().find(|corner| {
        let through = [way([*begin, *corner]), way([*corner, *end])];
        let (before, after) = (sides.get(..at).unwrap_or_default(), sides.get(at + 1..).unwrap_or_default());
        let others = |all: &[([[f64; 2]; 2], Span)]| all.iter().map(|(side, _)| way(*side)).collect::<Vec<_>>();
        is_round([others(before), through.to_vec(), others(after)].concat(), open)
    })?;
    // Where the contour begins within a side, nothing of it is drawn beyond the corners.
    let span = |axis: usize| {
        let places = contour.iter().map(|(place, _)| place[axis]).filter(|_| open);
        let (low, high) = (begin[axis].min(end[axis]), begin[axis].max(end[axis]));
        places.clone().fold(high, f64::max) - places.fold(low, f64::min)
    };
    Some(Rectangle { across: [*begin, *end], sides: [span(0), span(1)], corner, place: *place })
}

/// Whether sides along the axes go round a rectangle; where the contour ends within a side, it goes on in the same direction.
fn is_round(ways: Vec<[f64; 2]>, open: bool) -> bool {
    let cross = |one: [f64; 2], other: [f64; 2]| one[0] * other[1] - one[1] * other[0];
    let dot = |one: [f64; 2], other: [f64; 2]| one[0] * other[0] + one[1] * other[1];
    let (mut turns, mut back) = (Vec::new(), false);
    for pair in ways.windows(2) {
        let [one, other] = pair else { continue };
        let turn = cross(*one, *other);
        back |= turn.abs() < NEAR && dot(*one, *other) < 0.0;
        turns.extend(Some(turn).filter(|own| own.abs() >= NEAR));
    }
    let same = turns.iter().all(|own| *own > 0.0) || turns.iter().all(|own| *own < 0.0);
    !back && same && if open { turns.len() == 4 } else { matches!(turns.len(), 3 | 4) }
}

/// Whether a remark of the program names both sides, as `80X50`.
fn is_remarked(facts: &Facts<'_>, own: &Rectangle) -> bool {
    let sides = own.sides;
    let same = |one: f64, other: f64| (one - other).abs() < NEAR;
    let names = |text: &str| {
        let text = text.to_ascii_uppercase().replace(" X ", "X").replace(',', ".");
        let parts = text.split(|sign: char| !(sign.is_ascii_digit() || matches!(sign, '.' | 'X')));
        parts.into_iter().any(|part| {
            let numbers: Vec<f64> = part.split('X').filter_map(|own| own.parse().ok()).collect();
            numbers.windows(2).any(|pair| {
                let [one, other] = pair else { return false };
                same(*one, sides[0]) && same(*other, sides[1]) || same(*one, sides[1]) && same(*other, sides[0])
            })
        })
    };
    let mut remarks = facts.program.blocks().iter().filter_map(Block::comment);
    remarks.any(|remark| names(facts.text(remark)))
}

/// Whether a cycle is called in the corner, beyond the line across.
fn is_drilled(facts: &Facts<'_>, own: &Rectangle) -> bool {
    let [begin, end] = own.across;
    let side =
        |place: [f64; 2]| (end[0] - begin[0]) * (place[1] - begin[1]) - (end[1] - begin[1]) * (place[0] - begin[0]);
    let inside = |place: [f64; 2]| {
        let between = |axis: usize| {
            let (low, high) = (begin[axis].min(end[axis]), begin[axis].max(end[axis]));
            low < place[axis] && place[axis] < high
        };
        between(0) && between(1) && side(place) * side(own.corner) > 0.0
    };
    facts.run.calls.iter().filter_map(|call| place_of_call(facts, call.block)).any(inside)
}
