//! A contour that a cycle reads from a subprogram and cannot machine: movements of the tool axis, approaches, tool
//! calls or cycles in it, a first point without both coordinates, no RL or RR, an end elsewhere than the beginning,
//! elements that the cycle does not read, a corner as its last element, local parameters that are not assigned in it,
//! more contours than it machines, the same contour twice, islands without a pocket or beside all of them, a pocket in another
//! one, one that does not fit on its cylinder.
//!
//! A contour may leave it to the control to close it by going on in the line with which it began. Lengths are only
//! compared where all coordinates are numbers.
use std::collections::{BTreeSet, HashMap, HashSet};

use crate::base::diag::{Diagnostic, Severity, Span};
use crate::base::expr::{QKind, QRef};
use crate::check::contours::{Listed, area, body, corners, ends, holds, is_inside, listed, polygon, wanted};
use crate::check::program::{is_silent, number, reads, with_meaning};
use crate::check::{Defined, Facts, Rule, Use, Way};
use crate::program::syntax::{Axis, Block, BlockKind, Compensates, Motion, Path, StatementKind};
use crate::spec::{ContourWanted, TakesEffect};

pub(super) const RULE: Rule = Rule { code: "contour-wrong", severity: Severity::Warning, run };

/// How far the end may be from the beginning, mm or inch: coordinates are rounded.
const TOLERANCE: f64 = 0.01;

/// How often a block of contours is looked at on average: contours that do not end hold all that come after them.
const PATIENCE: usize = 48;

/// So many points may be compared with sides of other contours.
const COMPARISONS: usize = 1 << 24;

/// The axes in which contours are described.
const PLANE: [Axis; 2] = [Axis::X, Axis::Y];
/// The same of what is turned.
const TURNED: [Axis; 2] = [Axis::Z, Axis::X];
/// The meanings of parameters: the tool that has roughed before, which only cycles that rough out have; the radius of a
/// cylinder, and how what is on it is dimensioned.
const ROUGHING: &str = "coarse-roughing-tool";
const CYLINDER: &str = "cylinder-radius";
const DEVELOPMENT: &str = "development-dimension-type";

/// The word of a blank that is turned.
const BLANK: &str = "FUNCTION TURNDATA BLANK";

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    for block in blanks(facts) {
        let finding = rule.at(facts, facts.content(block)).arg("what", "open").arg("word", "");
        found.push(finding.arg("cycle", BLANK));
    }
    // What was looked at: contours, each with what a cycle wants of it.
    let (mut known, mut lists) = (HashSet::new(), HashSet::new());
    let mut patience = facts.program.blocks().len().saturating_mul(PATIENCE).saturating_add(100_000);
    let mut comparisons = COMPARISONS;
    for list in listed(facts) {
        if let Some(second) = second_label(facts, &list) {
            for reader in &list.readers {
                let finding = rule.at(facts, second).arg("what", "many").arg("cycle", reader.key.to_string());
                found.push(finding.arg("word", facts.text(second).to_owned()));
            }
        }
        // Lists of the same contours say the same.
        let same: Vec<*const Block> = list.contours.iter().map(|contour| contour.as_ptr()).collect();
        if lists.insert(same) {
            if let Some((at, other)) = twice(facts, &list) {
                let cycle = list.readers.first().map_or_else(String::new, |reader| reader.key.to_string());
                let finding = rule.at(facts, at).arg("what", "same").arg("word", facts.text(other).to_owned());
                found.push(finding.arg("cycle", cycle));
            }
            for (block, what, reader) in
                no_pocket(&list).into_iter().chain(nested(&list, &mut comparisons)).chain(too_wide(facts, &list))
            {
                let finding = rule.at(facts, facts.content(block)).arg("what", what).arg("word", "");
                found.push(finding.arg("cycle", reader.key.to_string()));
            }
        }
        // Definitions of a cycle want the same.
        let mut kinds = HashSet::new();
        let wanting = |own: &&Defined<'_>| wanted(own).is_some_and(|wanted| kinds.insert(std::ptr::from_ref(wanted)));
        let readers: Vec<_> = list.readers.iter().copied().filter(wanting).collect();
        for contour in &list.contours {
            let mut reported = HashSet::new();
            for reader in &readers {
                let Some(wanted) = wanted(reader) else { continue };
                if !known.insert((contour.as_ptr(), std::ptr::from_ref(wanted))) {
                    continue;
                }
                let Some(rest) = patience.checked_sub(contour.len()) else { return };
                patience = rest;
                for (block, what, word) in wrong(facts, contour, wanted) {
                    if !reported.insert(block.span.start) {
                        continue;
                    }
                    let finding = rule.at(facts, facts.content(block)).arg("what", what).arg("word", word);
                    let severity = if what == "open" { Severity::Error } else { rule.severity };
                    found.push(Diagnostic { severity, ..finding.arg("cycle", reader.key.to_string()) });
                }
            }
        }
    }
}

/// The last blocks of contours of blanks that do not end where they begin.
fn blanks<'a>(facts: &Facts<'a>) -> Vec<&'a Block> {
    let graph = &facts.run.graph;
    let turned = |own: &&Use| {
        own.way == Way::Named
            && facts.program.blocks().get(own.block).is_some_and(|block| {
                matches!(&block.kind, BlockKind::Statement(own) if own.kind == StatementKind::Function)
                    && facts.text(facts.content(block)).to_ascii_uppercase().starts_with(BLANK)
            })
    };
    let starts = graph.uses.iter().filter(turned).filter_map(|own| graph.block_of(own.mark.as_ref()?));
    let ends = ends(facts);
    let mut last: HashMap<usize, Option<&Block>> = HashMap::new();
    let open = starts.filter_map(|start| {
        *last.entry(start).or_insert_with(|| {
            let contour = body(facts.program.blocks(), &ends, start)?;
            let open = corners(contour, TURNED).is_some_and(|points| is_open(&points));
            contour.iter().rev().find(|block| open && matches!(block.kind, BlockKind::Motion(_)))
        })
    });
    open.collect()
}

/// The second label of a list of which all cycles read the first only.
fn second_label(facts: &Facts<'_>, list: &Listed<'_, '_>) -> Option<Span> {
    let all = list.readers.iter().all(|own| wanted(own).is_some_and(|own| own.first_only));
    facts.run.graph.uses_in(list.list.view.last).get(1).filter(|_| all).map(|own| own.span)
}

/// A label of a list whose contour is, word for word, that of one before it, with the place of that one.
fn twice(facts: &Facts<'_>, list: &Listed<'_, '_>) -> Option<(Span, Span)> {
    let uses: Vec<&Use> =
        facts.run.graph.uses_in(list.list.view.last).iter().filter(|own| own.way == Way::Named).collect();
    // One contour for each label, or none can be told apart.
    if list.readers.is_empty() || list.contours.len() < 2 || uses.len() != list.contours.len() {
        return None;
    }
    let mut seen: HashMap<Vec<&str>, Span> = HashMap::new();
    for (own, contour) in uses.iter().zip(&list.contours) {
        let acts = contour.iter().filter(|block| !is_silent(block));
        let words: Vec<&str> = acts
            .flat_map(|block| facts.text(facts.content(block)).split(';').next().unwrap_or_default().split_whitespace())
            .collect();
        if let Some(before) = seen.insert(words, own.span) {
            return Some((own.span, before));
        }
    }
    None
}

/// The first block of a list of nothing but islands that a cycle clears: there is no pocket in which they are.
///
/// A side may be finished alone at an island (001: 4785-4837), so a cycle that roughs out must be among the readers.
fn no_pocket<'f, 'a>(list: &Listed<'f, 'a>) -> Option<(&'a Block, &'static str, &'f Defined<'a>)> {
    let roughs = |own: &&&Defined<'_>| own.related_cycle().is_some_and(|cycle| with_meaning(cycle, ROUGHING).is_some());
    let reader = list.readers.iter().find(roughs)?;
    let island = |contour: &&[Block]| {
        let (points, side) = polygon(contour, PLANE)?;
        let area = area(&points);
        (area != 0.0).then_some(!is_inside(area, side?))
    };
    let first = list.contours.first()?;
    let all = list.contours.iter().all(|contour| island(contour) == Some(true));
    let block = first.iter().find(|block| matches!(block.kind, BlockKind::Motion(_)))?;
    all.then_some((block, "islands", *reader))
}

/// The contours of a list as polygons, and whether each is a pocket; nothing if one is not certain, or there are too many
/// points to compare.
fn shapes(list: &Listed<'_, '_>, patience: &mut usize) -> Option<Vec<(Vec<[f64; 2]>, bool)>> {
    let shape = |contour: &&[Block]| {
        let (points, side) = polygon(contour, PLANE)?;
        let area = area(&points);
        (area != 0.0).then_some(())?;
        Some((points, is_inside(area, side?)))
    };
    let shapes: Vec<(Vec<[f64; 2]>, bool)> = list.contours.iter().map(shape).collect::<Option<_>>()?;
    // Each point is compared with each side of the others.
    let points: usize = shapes.iter().map(|(points, _)| points.len()).sum();
    *patience = patience.checked_sub(points.saturating_mul(points))?;
    Some(shapes)
}

/// The first block of a pocket that lies completely in another one and removes nothing: it was to be an island. Or that
/// of an island beside all pockets, which was to be a pocket.
///
/// A pocket in an island is one. Roundings and chamfers do not count, arcs are polygons.
fn nested<'f, 'a>(list: &Listed<'f, 'a>, patience: &mut usize) -> Option<(&'a Block, &'static str, &'f Defined<'a>)> {
    let roughs = |own: &&&Defined<'_>| own.related_cycle().is_some_and(|cycle| with_meaning(cycle, ROUGHING).is_some());
    let reader = list.readers.iter().find(roughs)?;
    let shapes = shapes(list, patience)?;
    let lies_in = |inner: &[[f64; 2]], outer: &[[f64; 2]]| inner.iter().all(|point| holds(outer, *point));
    let (what, contour) =
        shapes.iter().zip(&list.contours).enumerate().find_map(|(at, ((points, pocket), contour))| {
            let others = || shapes.iter().enumerate().filter(|(other, _)| *other != at).map(|(_, own)| own);
            let inside = others().any(|(other, is_pocket)| *is_pocket && lies_in(points, other));
            let island =
                others().any(|(other, is_pocket)| !is_pocket && points.iter().any(|point| holds(other, *point)));
            if *pocket {
                return (inside && !island && points.len() > 2).then_some(("nested", contour));
            }
            let mut pockets = others().filter(|(_, is_pocket)| *is_pocket).peekable();
            (pockets.peek().is_some() && pockets.all(|(pocket, _)| are_apart(points, pocket)))
                .then_some(("beside", contour))
        })?;
    let block = contour.iter().find(|block| matches!(block.kind, BlockKind::Motion(_)))?;
    Some((block, what, *reader))
}

/// Whether two polygons do not overlap, by the rectangles around them.
fn are_apart(one: &[[f64; 2]], other: &[[f64; 2]]) -> bool {
    let extent = |points: &[[f64; 2]], axis: usize| {
        points.iter().fold((f64::MAX, f64::MIN), |(low, high), point| (low.min(point[axis]), high.max(point[axis])))
    };
    (0..2).any(|axis| {
        let ((low, high), (other_low, other_high)) = (extent(one, axis), extent(other, axis));
        high < other_low || other_high < low
    })
}

/// The first block of a contour that does not fit on the cylinder on which it is rolled up: it is longer than the
/// circumference along both axes.
fn too_wide<'f, 'a>(facts: &'f Facts<'a>, list: &Listed<'f, 'a>) -> Option<(&'a Block, &'static str, &'f Defined<'a>)> {
    list.readers.iter().find_map(|reader| {
        let read = facts.read(reader);
        let radius = read.item(CYLINDER).and_then(number)?;
        // Otherwise it is in degrees.
        read.item(DEVELOPMENT).and_then(number).filter(|own| *own == 1.0)?;
        let around = std::f64::consts::TAU * radius.abs();
        let fits = |contour: &&&[Block]| {
            let Some((points, _)) = polygon(contour, PLANE) else { return true };
            (0..2).any(|axis| {
                let along = || points.iter().map(|point| point[axis]);
                along().fold(f64::MIN, f64::max) - along().fold(f64::MAX, f64::min) <= around
            })
        };
        let contour = list.contours.iter().find(|contour| !fits(contour))?;
        let block = contour.iter().find(|block| matches!(block.kind, BlockKind::Motion(_)))?;
        Some((block, "round", *reader))
    })
}

/// What is wrong with a contour: the block, what it is, and the word that is named.
fn wrong<'a>(
    facts: &Facts<'_>,
    contour: &'a [Block],
    wanted: &ContourWanted,
) -> Vec<(&'a Block, &'static str, String)> {
    let mut found = Vec::new();
    let (mut first, mut last, mut compensated, mut unread) = (None, None, false, false);
    // The development of a cylinder may be described in its own axes.
    let rotary = |axis: &Axis| matches!(axis, Axis::A | Axis::B | Axis::C);
    let developed = contour.iter().any(|block| match &block.kind {
        BlockKind::Motion(motion) => motion.words().coords.iter().any(|coord| rotary(&coord.axis)),
        _ => false,
    });
    let in_plane = !developed && !wanted.turned;
    for block in contour {
        match &block.kind {
            BlockKind::Motion(motion) => {
                let path = motion.path();
                compensated |= motion.outline().compensates() == Compensates::Beside;
                let words = motion.words();
                if let Some(what) = foreign(&words, wanted).filter(|what| *what != "axis" || in_plane) {
                    let word = if what == "axis" { Axis::Z.name() } else { path.name() };
                    found.push((block, what, word.to_uppercase()));
                }
                if !matches!(path, Path::Cc | Path::Fpol) {
                    if first.is_none() && in_plane && lacks_axis(&words) {
                        found.push((block, "first", String::new()));
                    }
                    first = first.or(Some(block));
                    last = Some(block);
                }
            }
            BlockKind::ToolCall(_) => found.push((block, "tool", "TOOL CALL".to_owned())),
            BlockKind::CyclCall(_) => found.push((block, "call", "CYCL CALL".to_owned())),
            BlockKind::CycleDef(_) if machines(facts, block) => {
                found.push((block, "call", "CYCL DEF".to_owned()));
            }
            BlockKind::CallLbl(_) | BlockKind::FnJump(_) | BlockKind::Lbl(_) | BlockKind::Unknown(_) => unread = true,
            _ => {}
        }
    }
    if let Some((block, name)) = unassigned(contour).filter(|_| !unread) {
        found.push((block, "local", name));
    }
    let (Some(first), Some(last)) = (first, last) else { return found };
    if let BlockKind::Motion(motion) = &last.kind
        && motion.path().is_corner()
        && !unread
    {
        found.push((last, "corner", motion.path().name().to_uppercase()));
    }
    // Of a train of contours on its centre line no manual says what the control does: the engine refuses it, too.
    if wanted.compensated && !compensated && !unread {
        found.push((first, "uncompensated", String::new()));
    }
    if wanted.closed && !unread && found.is_empty() && corners(contour, PLANE).is_some_and(|points| is_open(&points)) {
        found.push((last, "open", String::new()));
    }
    found
}

/// The first local parameter that a contour reads and has not assigned: those of the program are not known in it (TNC
/// 640 manual line 4367).
fn unassigned(contour: &[Block]) -> Option<(&Block, String)> {
    let mut assigned: BTreeSet<QRef> = BTreeSet::new();
    for block in contour {
        let mut read = Vec::new();
        reads(block, &mut read);
        if let Some((q, _)) = read.iter().find(|(q, _)| q.kind == QKind::Ql && !assigned.contains(q)) {
            return Some((block, q.to_string()));
        }
        match &block.kind {
            BlockKind::FnAssign(own) => _ = assigned.insert(own.target),
            BlockKind::Formula(own) => _ = assigned.insert(own.target),
            BlockKind::TextFormula(own) => _ = assigned.insert(own.target),
            _ => {}
        }
    }
    None
}

/// What a cycle that moves the tool itself does not find in a contour.
fn foreign(motion: &Motion, wanted: &ContourWanted) -> Option<&'static str> {
    match motion.path {
        Path::Appr(_) | Path::Dep(_) => Some("approach"),
        path => {
            let name = path.name().to_ascii_uppercase();
            if !wanted.paths.is_empty() && !wanted.paths.contains(&name) {
                return Some("path");
            }
            motion.coord(Axis::Z).map(|_| "axis")
        }
    }
}

/// Whether a first point leaves an axis of the plane unsaid.
fn lacks_axis(motion: &Motion) -> bool {
    let has = |axis| motion.coord(axis).is_some_and(|coord| !coord.incremental);
    matches!(motion.path, Path::L | Path::C | Path::Cr | Path::Ct) && !(has(Axis::X) && has(Axis::Y))
}

/// Whether a block defines a cycle that is called.
fn machines(facts: &Facts<'_>, block: &Block) -> bool {
    let at = facts.program.blocks().partition_point(|own| own.span.start < block.span.start);
    facts.definition_at(at).is_some_and(|own| own.takes_effect() == Some(TakesEffect::OnCall))
}

/// Whether the contour does not end where it begins, nor on the line with which it begins.
fn is_open(points: &[[f64; 2]]) -> bool {
    let (Some(first), Some(last)) = (points.first(), points.last()) else { return false };
    let gap = [first[0] - last[0], first[1] - last[1]];
    let long = libm::hypot(gap[0], gap[1]);
    if long <= TOLERANCE {
        return false;
    }
    let Some(second) = points.get(1) else { return true };
    // What goes towards the first point does not stop before it.
    if let [.., before, _] = points {
        let end = [last[0] - before[0], last[1] - before[1]];
        let (aside, on) = (gap[0] * end[1] - gap[1] * end[0], gap[0] * end[0] + gap[1] * end[1]);
        if on > 0.0 && libm::fabs(aside) <= TOLERANCE * libm::hypot(end[0], end[1]) && points.len() > 3 {
            return true;
        }
    }
    let begin = [second[0] - first[0], second[1] - first[1]];
    let across = gap[0] * begin[1] - gap[1] * begin[0];
    let along = gap[0] * begin[0] + gap[1] * begin[1];
    !(along > 0.0 && libm::fabs(across) <= TOLERANCE * libm::hypot(begin[0], begin[1]))
}
