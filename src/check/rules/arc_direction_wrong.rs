//! An arc that joins neither of its neighbours tangentially as it is written, and both of them with the other direction of
//! rotation: the tool turns back at its ends, or goes round the other side of the chord.
//!
//! The movements that switch radius compensation on and off are no neighbours. Only where the elements follow each other
//! without roundings and chamfers, and all of them are numbers. Arcs with a right angle or less at their ends may be scoops
//! on purpose: they are reported only if the contour has one such arc.
use crate::base::diag::{Diagnostic, Severity, Span};
use crate::check::contours::Line;
use crate::check::program::is_silent;
use crate::check::{Facts, Rule};
use crate::program::syntax::{Axis, BlockKind, Compensation, Motion, Path};

pub(super) const RULE: Rule = Rule { code: "arc-direction-wrong", severity: Severity::Warning, run };

const PLANE: [Axis; 2] = [Axis::X, Axis::Y];
/// Elements join tangentially if their directions differ by less, degrees: coordinates are rounded.
const JOINED: f64 = 1.0;
/// And not if they differ by more.
const KINK: f64 = 10.0;
/// At such an angle the tool goes back along the way that it has come.
const BACK: f64 = 170.0;

/// The directions in which an element begins and ends.
type Ways = [[f64; 2]; 2];

/// An element.
struct Piece {
    ways: Ways,
    /// Those of an arc with the other direction of rotation.
    other: Option<Ways>,
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
    for block in facts.program.blocks() {
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
        let way = matches!(words.path, Path::Appr(_) | Path::Dep(_));
        let away = motion.outline().is_rapid() || !flat || way || switches;
        let piece = piece(&mut line, &words, facts.content(block));
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
                found.push(rule.at(facts, own.place));
            } else {
                doubtful.push(own.place);
            }
        }
    }
    end(rule, facts, &mut doubtful, found);
}

/// A contour is over: one doubtful arc in it is wrong, several are meant.
fn end(rule: &Rule, facts: &Facts<'_>, doubtful: &mut Vec<Span>, found: &mut Vec<Diagnostic>) {
    if let [only] = doubtful.as_slice() {
        found.push(rule.at(facts, *only));
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
    let chord = unit([to[0] - from[0], to[1] - from[1]])?;
    let arc = match words.path {
        Path::L | Path::Lp => return Some(Piece { ways: [chord; 2], other: None, place }),
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
    let other = (written && turned.go_on(&reversed, PLANE).is_some()).then(|| turned.heading().map(ways));
    Some(Piece { ways: own, other: other.flatten(), place })
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
