//! An arc that joins neither of its neighbours tangentially as it is written, and both of them with the other direction of
//! rotation or the other sign of its radius: the tool turns back at its ends, or goes round the other side of the chord.
//! Also a full circle within a contour that the tool does not leave tangentially: a sign of its end is wrong. Also an arc
//! that goes beyond the blank, and does not with the other direction of rotation.
//!
//! Elements of free contours of which all is written are looked at like plain ones. The movements that switch radius
//! compensation on and off are no neighbours. Only where the elements follow each other without roundings and chamfers, and
//! all of them are numbers. Arcs with a right angle or less at their ends may be scoops on purpose: they are reported only
//! if the contour has one such arc.
use crate::base::diag::{Diagnostic, Severity, Span};
use crate::check::blank::{Blank, is_unmoved};
use crate::check::contours::Line;
use crate::check::program::is_silent;
use crate::check::{Facts, Rule};
use crate::program::syntax::{Amount, Axis, BlockKind, Compensation, Coord, Motion, Operand, Path, ValueKind};

pub(super) const RULE: Rule = Rule { code: "arc-direction-wrong", severity: Severity::Warning, run };

const PLANE: [Axis; 2] = [Axis::X, Axis::Y];
/// Elements join tangentially if their directions differ by less, degrees: coordinates are rounded.
const JOINED: f64 = 1.0;
/// And not if they differ by more.
const KINK: f64 = 10.0;
/// A corner of a contour is no sharper than this, degrees.
const SHARP: f64 = 130.0;
/// Corners as sharp as the first one at both ends of an arc are no contour, where the smaller part of the circle has corners
/// as flat as the second one, degrees.
const STEEP: [f64; 2] = [110.0, 70.0];
/// At such an angle the tool goes back along the way that it has come.
const BACK: f64 = 170.0;

/// The directions in which an element begins and ends.
type Ways = [[f64; 2]; 2];

/// An element.
struct Piece {
    ways: Ways,
    /// Those of an arc with the other direction of rotation, and of one with the other sign of its radius.
    other: Option<Ways>,
    signed: Option<Ways>,
    /// Whether it is a full circle.
    full: bool,
    place: Span,
}

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    // The words of all movements are read only where there are arcs.
    if !facts.turns {
        return;
    }
    let mut line = Line::default();
    // The last elements of the contour, and those arcs in it that are doubtful.
    let mut last: Vec<Piece> = Vec::new();
    let mut doubtful: Vec<Span> = Vec::new();
    let mut compensated = false;
    let blank = Blank::of(facts.program).filter(|_| facts.begins());
    let mut beyond = None;
    for (index, block) in facts.program.blocks().iter().enumerate() {
        let motion = match &block.kind {
            _ if is_silent(block) || block.is_blend() => continue,
            // The run comes from the blocks above it the first time.
            BlockKind::Lbl(_) if !block.ends_subprogram() => continue,
            BlockKind::Motion(motion) if !block.skip => motion,
            _ => {
                line.lose();
                last.clear();
                end(rule, facts, &mut doubtful, found);
                continue;
            }
        };
        let words = motion.words();
        let words = match words.path {
            Path::Fpol => continue,
            Path::Fl | Path::Flt | Path::Fc | Path::Fct => match determined(facts, &words) {
                Some((own, centre)) => {
                    if let Some(centre) = centre {
                        line.go_on(&centre, PLANE);
                    }
                    own
                }
                None => words,
            },
            _ => words,
        };
        if words.path == Path::Cc {
            if line.go_on(&words, PLANE).is_none() {
                line.lose();
                last.clear();
            }
            continue;
        }
        if matches!(words.path, Path::Rnd | Path::Chf) {
            last.clear();
            continue;
        }
        let flat = words.coords.iter().all(|own| matches!(own.axis, Axis::X | Axis::Y | Axis::Pr | Axis::Pa));
        // The way to a contour and the one away from it are no elements of it.
        let beside = words.compensation.map(|own| matches!(own, Compensation::Rl | Compensation::Rr));
        let after = beside.unwrap_or(compensated);
        let switches = after != compensated;
        compensated = after && !matches!(words.path, Path::Dep(_));
        let after_compensated = after;
        let way = matches!(words.path, Path::Appr(_) | Path::Dep(_));
        let away = motion.outline().is_rapid() || !flat || way || switches;
        let before = line.clone();
        let piece = piece(&mut line, &words, facts.content(block));
        if let Some(blank) = blank.as_ref().filter(|_| !away && beyond.is_none() && after) {
            let unmoved = || facts.run.before(index).is_some_and(|modal| is_unmoved(&modal));
            let turned = goes_beyond(blank, &before, &line, &words, facts.millimetre()) && unmoved();
            beyond = turned.then(|| facts.content(block));
        }
        line.begin();
        if away || piece.is_none() {
            last.clear();
        }
        if words.functions.iter().any(|own| matches!(own.number, 2 | 30)) {
            line.lose();
        }
        if away {
            end(rule, facts, &mut doubtful, found);
            continue;
        }
        let Some(piece) = piece else { continue };
        last.push(piece);
        if last.len() > 3 {
            last.remove(0);
        }
        if let [before, own, after] = last.as_slice()
            && let Some(angle) = is_turned(before, own, after)
        {
            if angle > BACK {
                found.push(rule.at(facts, own.place).arg("what", "direction"));
            } else {
                doubtful.push(own.place);
            }
        } else if let [before, own, after] = last.as_slice()
            && let Some(what) = is_strange(before, own, after).filter(|what| *what != "full" || after_compensated)
        {
            found.push(rule.at(facts, own.place).arg("what", what));
        }
    }
    end(rule, facts, &mut doubtful, found);
    let known = |place: &Span| found.iter().any(|own| own.place.as_ref().is_some_and(|at| at.span == *place));
    if let Some(place) = beyond.filter(|place| !known(place)) {
        found.push(rule.at(facts, place).arg("what", "beyond"));
    }
}

/// An element of a free contour of which all is written, as a plain one with its centre: of a line its end, of an arc its
/// end, its centre and its direction.
fn determined(facts: &Facts<'_>, words: &Motion) -> Option<(Motion, Option<Motion>)> {
    let axes: Vec<_> = words.coords.iter().map(|own| (own.axis, own.incremental)).collect();
    if axes != [(Axis::X, false), (Axis::Y, false)] {
        return None;
    }
    let plain = |path: Path| Motion { path, radius: None, words: Vec::new(), ..words.clone() };
    if matches!(words.path, Path::Fl | Path::Flt) {
        return Some((plain(Path::L), None));
    }
    let part = |name: &str, axis: Axis| {
        let own = words.words.iter().find(|own| facts.text(own.name).trim().eq_ignore_ascii_case(name))?;
        let ValueKind::Number(number) = own.value.kind else { return None };
        let value = Operand { span: own.value.span, amount: Amount::Number(number) };
        Some(Coord { span: own.span, axis, incremental: false, value })
    };
    let coords = vec![part("CCX", Axis::X)?, part("CCY", Axis::Y)?];
    words.counter_clockwise.map(|_| (plain(Path::C), Some(Motion { coords, ..Motion::new(Path::Cc) })))
}

/// Whether an arc goes beyond the blank although its ends are inside of it, and would not with the other direction of
/// rotation.
fn goes_beyond(blank: &Blank, before: &Line, after: &Line, words: &Motion, unit: f64) -> bool {
    /// So far, mm: less is an allowance.
    const FAR: f64 = 1.0;
    if !matches!(words.path, Path::C | Path::Cr) || words.counter_clockwise.is_none() {
        return false;
    }
    let (Some(from), Some(to)) = (before.end(), after.end()) else { return false };
    let inside = |place: [f64; 2]| blank.distance(place) <= 0.0;
    let out = |line: &Line| line.points.iter().map(|place| blank.distance(*place)).fold(0.0, f64::max);
    let reversed = Motion { counter_clockwise: words.counter_clockwise.map(|own| !own), ..words.clone() };
    let mut other = before.clone();
    other.begin();
    let apart = libm::hypot(to[0] - from[0], to[1] - from[1]) > FAR * unit;
    apart
        && inside(from)
        && inside(to)
        && out(after) > FAR * unit
        && other.go_on(&reversed, PLANE).is_some()
        && out(&other) <= 0.0
}

/// What is strange about an arc between two elements: the sign of its radius, or that it is a full circle.
fn is_strange(before: &Piece, own: &Piece, after: &Piece) -> Option<&'static str> {
    let joins = |ways: &Ways| angle(before.ways[1], ways[0]) < JOINED && angle(ways[1], after.ways[0]) < JOINED;
    let kinks = [angle(before.ways[1], own.ways[0]), angle(own.ways[1], after.ways[0])];
    if own.full {
        // Led to and away from tangentially it is a contour of its own.
        return kinks.iter().any(|own| *own > KINK).then_some("full");
    }
    let signed = own.signed.as_ref()?;
    let fits = joins(signed) && signed != &own.ways && kinks.iter().all(|own| *own > KINK);
    // At its ends the tool would go back on itself, and not with the other sign.
    let other = [angle(before.ways[1], signed[0]), angle(signed[1], after.ways[0])];
    let back = kinks.iter().any(|own| *own > BACK) && other.iter().all(|own| *own < SHARP);
    let back = back || kinks.iter().all(|own| *own > STEEP[0]) && other.iter().all(|own| *own < STEEP[1]);
    (fits || back).then_some("sign")
}

/// A contour is over: one doubtful arc in it is wrong, several are meant.
fn end(rule: &Rule, facts: &Facts<'_>, doubtful: &mut Vec<Span>, found: &mut Vec<Diagnostic>) {
    if let [only] = doubtful.as_slice() {
        found.push(rule.at(facts, *only).arg("what", "direction"));
    }
    doubtful.clear();
}

/// Follows an element: its directions, if they are certain.
fn piece(line: &mut Line, words: &Motion, place: Span) -> Option<Piece> {
    let from = line.end();
    let mut turned = line.clone();
    if line.go_on(words, PLANE).is_none() {
        line.lose();
        return None;
    }
    let (from, to) = (from?, line.end()?);
    if words.path == Path::C && libm::hypot(to[0] - from[0], to[1] - from[1]) < 1e-6 {
        // It begins as it ends.
        return Some(Piece { ways: [line.heading()?; 2], other: None, signed: None, full: true, place });
    }
    let chord = unit([to[0] - from[0], to[1] - from[1]])?;
    let arc = match words.path {
        Path::L | Path::Lp => {
            return Some(Piece { ways: [chord; 2], other: None, signed: None, full: false, place });
        }
        Path::C | Path::Cr | Path::Cp => true,
        _ => false,
    };
    // An arc begins as it ends, seen from its chord.
    let ways = |end: [f64; 2]| {
        let along = chord[0] * end[0] + chord[1] * end[1];
        [[2.0 * along * chord[0] - end[0], 2.0 * along * chord[1] - end[1]], end]
    };
    let own = ways(line.heading()?);
    let reversed = Motion { counter_clockwise: words.counter_clockwise.map(|own| !own), ..words.clone() };
    let written = words.counter_clockwise.is_some() && arc;
    let mut signed = turned.clone();
    let other = (written && turned.go_on(&reversed, PLANE).is_some()).then(|| turned.heading().map(ways));
    let opposite = negated(words).filter(|_| written);
    let signed = opposite.filter(|own| signed.go_on(own, PLANE).is_some()).and_then(|_| signed.heading().map(ways));
    Some(Piece { ways: own, other: other.flatten(), signed, full: false, place })
}

/// An arc with the other sign of its radius.
fn negated(words: &Motion) -> Option<Motion> {
    let radius = words.radius.filter(|_| words.path == Path::Cr)?;
    let Amount::Number(size) = radius.amount else { return None };
    Some(Motion { radius: Some(Operand { amount: Amount::Number(-size), ..radius }), ..words.clone() })
}

/// The greater angle at the ends of an arc that fits only the other way round.
fn is_turned(before: &Piece, own: &Piece, after: &Piece) -> Option<f64> {
    let [begin, end] = own.other?;
    let joins = angle(before.ways[1], begin) < JOINED && angle(end, after.ways[0]) < JOINED;
    let kinks = [angle(before.ways[1], own.ways[0]), angle(own.ways[1], after.ways[0])];
    (joins && kinks.iter().all(|own| *own > KINK)).then(|| kinks[0].max(kinks[1]))
}

fn unit(way: [f64; 2]) -> Option<[f64; 2]> {
    let long = libm::hypot(way[0], way[1]);
    (long > 1e-6).then(|| [way[0] / long, way[1] / long])
}

/// The angle between two directions, degrees.
fn angle(one: [f64; 2], other: [f64; 2]) -> f64 {
    let (along, across) = (one[0] * other[0] + one[1] * other[1], one[0] * other[1] - one[1] * other[0]);
    libm::atan2(across.abs(), along).to_degrees()
}
