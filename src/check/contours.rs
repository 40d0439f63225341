//! The contours that cycles read from subprograms of the same program, with the cycles that machine them.
//!
//! Invariant: a contour names only cycles that certainly machine it; a program that selects contours in another way has
//! none here.
use std::collections::{HashMap, HashSet};

use super::flow::{Pending, Way};
use super::program::is_silent;
use super::{Defined, Facts};
use crate::base::diag::Span;
use crate::base::expr::{atan2d, cosd, sind};
use crate::program::syntax::{
    Amount, Axis, Block, BlockKind, CallForm, Compensates, Compensation, Motion, Path, StatementKind,
};
use crate::spec::{ContourWanted, ParameterKind};

/// A list of contours, the definition that holds it, and the cycles that machine them.
pub(super) struct Listed<'f, 'a> {
    /// The definition with the list.
    pub(super) list: &'f Defined<'a>,
    /// The definitions of the cycles.
    pub(super) readers: Vec<&'f Defined<'a>>,
    /// The blocks of the contours, that of the label and the one that ends it left out.
    pub(super) contours: Vec<&'a [Block]>,
}

/// What a cycle wants of the contours that it machines.
pub(super) fn wanted<'a>(definition: &Defined<'a>) -> Option<&'a ContourWanted> {
    definition.related_cycle()?.file.contour.as_ref()
}

/// The lists of contours of a program that cycles machine.
pub(super) fn listed<'f, 'a>(facts: &'f Facts<'a>) -> Vec<Listed<'f, 'a>> {
    let lists: Vec<&Defined<'a>> =
        facts.definitions.iter().filter(|own| own.has_kind(ParameterKind::LabelList)).collect();
    if lists.is_empty() || facts.marked().any(|(_, block)| selects(facts, block)) {
        return Vec::new();
    }
    let graph = &facts.run.graph;
    let ends = ends(facts);
    let contours = |list: &Defined<'_>| {
        let named = graph.uses_in(list.view.last).iter().filter(|own| own.way == Way::Named);
        let starts = named.filter_map(|own| graph.block_of(own.mark.as_ref()?));
        starts.filter_map(|start| body(facts.program.blocks(), &ends, start)).collect()
    };
    let mut found: Vec<Listed<'f, 'a>> = Vec::new();
    // The places of the lists among those found, and the readers that each has.
    let (mut places, mut read) = (HashMap::new(), HashSet::new());
    for call in &facts.run.calls {
        let Pending::Definition(index) = call.modal.pending else { continue };
        let Some(reader) = facts.definitions.get(index as usize).filter(|own| wanted(own).is_some()) else { continue };
        let list = match lists.as_slice() {
            [only] => Some(*only),
            _ if facts.flow.jumps => None,
            several => {
                let before = several.partition_point(|own| own.view.first < call.block);
                before.checked_sub(1).and_then(|at| several.get(at)).copied()
            }
        };
        let Some(list) = list else { continue };
        let place = *places.entry(list.view.first).or_insert_with(|| {
            found.push(Listed { list, readers: Vec::new(), contours: contours(list) });
            found.len() - 1
        });
        if read.insert((place, index)) {
            found[place].readers.push(reader);
        }
    }
    found
}

/// Whether a block names contours in another way than by labels.
fn selects(facts: &Facts<'_>, block: &Block) -> bool {
    match &block.kind {
        BlockKind::Sel(own) => facts.text(own.what).eq_ignore_ascii_case("CONTOUR"),
        BlockKind::Statement(own) => matches!(own.kind, StatementKind::ContourDef | StatementKind::DeclareContour),
        BlockKind::Iso(_) => !block.is_blend(),
        BlockKind::CallPgm(_) | BlockKind::Unknown(_) => true,
        _ => false,
    }
}

/// The blocks that end subprograms.
pub(super) fn ends(facts: &Facts<'_>) -> Vec<usize> {
    facts.marked().filter(|(_, block)| block.ends_subprogram()).map(|(at, _)| at).collect()
}

/// The blocks between a label and the first of those `ends` after it; nothing if there is none.
pub(super) fn body<'a>(blocks: &'a [Block], ends: &[usize], start: usize) -> Option<&'a [Block]> {
    blocks.get(start + 1..*ends.get(ends.partition_point(|end| *end <= start))?)
}

/// The corners of a contour whose elements are all written with numbers, its first point included;
/// nothing if that is not certain.
pub(super) fn corners(blocks: &[Block], axes: [Axis; 2]) -> Option<Vec<[f64; 2]>> {
    let mut points: Vec<[f64; 2]> = Vec::new();
    let (mut at, mut pole, mut polar) = ([None; 2], [None; 2], [None; 2]);
    for block in blocks {
        let motion = match &block.kind {
            BlockKind::Empty | BlockKind::Comment | BlockKind::Structure(_) | BlockKind::Functions(_) => continue,
            BlockKind::Motion(motion) if !block.skip => motion.words(),
            _ if block.is_blend() => continue,
            _ => return None,
        };
        match motion.path {
            Path::Rnd | Path::Chf => continue,
            Path::Cc => {
                pole = moved(&motion, axes, if motion.coords.is_empty() { at } else { pole })?;
                continue;
            }
            Path::L | Path::C | Path::Cr | Path::Ct => at = moved(&motion, axes, at)?,
            Path::Lp | Path::Cp | Path::Ctp => {
                for (axis, known) in [Axis::Pr, Axis::Pa].into_iter().zip(&mut polar) {
                    if let Some((value, incremental)) = number(&motion, axis)? {
                        *known = Some(if incremental { (*known)? + value } else { value });
                    }
                }
                let ([Some(x), Some(y)], [Some(radius), Some(angle)]) = (pole, polar) else { return None };
                at = [Some(x + radius * cosd(angle)), Some(y + radius * sind(angle))];
            }
            _ => return None,
        }
        if !matches!(motion.path, Path::Lp | Path::Cp | Path::Ctp) {
            polar = [None; 2];
        }
        let [Some(x), Some(y)] = at else { return None };
        points.push([x, y]);
    }
    Some(points)
}

/// A line in the plane followed element after element, arcs as polygons.
///
/// Roundings and chamfers between elements are left out; an element whose end is not certain ends it.
#[derive(Clone, Default)]
pub(super) struct Line {
    /// Its points, the first one included.
    pub(super) points: Vec<[f64; 2]>,
    at: [Option<f64>; 2],
    pole: [Option<f64>; 2],
    /// The polar coordinates: radius and angle.
    polar: [Option<f64>; 2],
    heading: Option<[f64; 2]>,
}

/// Into so many pieces an arc is divided.
const PIECES: i32 = 16;

impl Line {
    /// Forgets where it is; a centre stays.
    pub(super) fn lose(&mut self) {
        (self.at, self.polar, self.heading) = ([None; 2], [None; 2], None);
        self.points.clear();
    }

    /// Where it has come to.
    pub(super) fn end(&self) -> Option<[f64; 2]> {
        let [Some(x), Some(y)] = self.at else { return None };
        Some([x, y])
    }

    /// The direction in which its last element ends.
    pub(super) const fn heading(&self) -> Option<[f64; 2]> {
        self.heading
    }

    /// Begins anew where it is.
    pub(super) fn begin(&mut self) {
        self.points.clear();
    }

    /// Follows an element; nothing if its end is not certain.
    pub(super) fn go_on(&mut self, motion: &Motion, axes: [Axis; 2]) -> Option<()> {
        let from = self.end();
        let straight = matches!(motion.path, Path::L | Path::Lp | Path::Appr(_));
        match motion.path {
            Path::Rnd | Path::Chf => return Some(()),
            Path::Cc => {
                let before = if motion.coords.is_empty() { self.at } else { self.pole };
                self.pole = moved(motion, axes, before)?;
                return Some(());
            }
            Path::L | Path::C | Path::Cr | Path::Ct | Path::Appr(_) => {
                self.at = moved(motion, axes, self.at)?;
                self.polar = [None; 2];
            }
            Path::Lp => {
                for (axis, known) in [Axis::Pr, Axis::Pa].into_iter().zip(&mut self.polar) {
                    if let Some((value, incremental)) = number(motion, axis)? {
                        *known = Some(if incremental { (*known)? + value } else { value });
                    }
                }
                let ([Some(x), Some(y)], [Some(radius), Some(angle)]) = (self.pole, self.polar) else { return None };
                self.at = [Some(x + radius * cosd(angle)), Some(y + radius * sind(angle))];
            }
            Path::Cp => return self.polar_arc(from?, motion),
            _ => return None,
        }
        // An axis may still be open before the first point.
        let Some(to) = self.end() else { return straight.then_some(()) };
        match (motion.path, from) {
            (Path::C, Some(from)) => {
                let [Some(x), Some(y)] = self.pole else { return None };
                self.arc(from, to, [x, y], motion.counter_clockwise?);
            }
            (Path::Cr, Some(from)) => {
                let Amount::Number(radius) = motion.radius?.amount else { return None };
                let turns = motion.counter_clockwise?;
                let chord = [to[0] - from[0], to[1] - from[1]];
                let long = libm::hypot(chord[0], chord[1]);
                let rise = libm::sqrt((radius * radius - long * long / 4.0).max(0.0));
                let left = if turns == (radius > 0.0) { rise } else { -rise };
                let middle = [f64::midpoint(from[0], to[0]), f64::midpoint(from[1], to[1])];
                let centre = [middle[0] - chord[1] / long * left, middle[1] + chord[0] / long * left];
                (long > 0.0).then(|| self.arc(from, to, centre, turns))?;
            }
            (Path::Ct, Some(from)) => {
                let heading = self.heading?;
                let left = [-heading[1], heading[0]];
                let chord = [to[0] - from[0], to[1] - from[1]];
                let aside = left[0] * chord[0] + left[1] * chord[1];
                let radius = (chord[0] * chord[0] + chord[1] * chord[1]) / (2.0 * aside);
                if !radius.is_finite() {
                    return None;
                }
                let centre = [from[0] + left[0] * radius, from[1] + left[1] * radius];
                self.arc(from, to, centre, radius > 0.0);
            }
            (_, from) if straight => {
                self.points.push(to);
                let from = from.unwrap_or(to);
                let way = [to[0] - from[0], to[1] - from[1]];
                let long = libm::hypot(way[0], way[1]);
                self.heading = if long > 0.0 { Some([way[0] / long, way[1] / long]) } else { self.heading };
            }
            _ => return None,
        }
        Some(())
    }

    /// An arc about the pole to an angle.
    fn polar_arc(&mut self, from: [f64; 2], motion: &Motion) -> Option<()> {
        let [Some(x), Some(y)] = self.pole else { return None };
        let (angle, incremental) = number(motion, Axis::Pa)??;
        let radius = libm::hypot(from[0] - x, from[1] - y);
        let begin = atan2d(from[1] - y, from[0] - x);
        let end = if incremental { begin + angle } else { angle };
        let to = [x + radius * cosd(end), y + radius * sind(end)];
        let turns =
            if incremental { motion.counter_clockwise.unwrap_or(angle > 0.0) } else { motion.counter_clockwise? };
        (self.at, self.polar) = ([Some(to[0]), Some(to[1])], [Some(radius), Some(end)]);
        self.arc(from, to, [x, y], turns);
        Some(())
    }

    fn arc(&mut self, from: [f64; 2], to: [f64; 2], centre: [f64; 2], turns: bool) {
        let angle = |place: [f64; 2]| libm::atan2(place[1] - centre[1], place[0] - centre[0]);
        let (begin, whole) = (angle(from), std::f64::consts::TAU);
        let mut sweep = (angle(to) - begin).rem_euclid(whole);
        // What ends where it begins is a full circle.
        if sweep < 1e-6 || whole - sweep < 1e-6 {
            sweep = whole;
        }
        if !turns && sweep < whole {
            sweep -= whole;
        } else if !turns {
            sweep = -whole;
        }
        let radius = libm::hypot(from[0] - centre[0], from[1] - centre[1]);
        for piece in 1..PIECES {
            let at = begin + sweep * f64::from(piece) / f64::from(PIECES);
            self.points.push([centre[0] + radius * libm::cos(at), centre[1] + radius * libm::sin(at)]);
        }
        self.points.push(to);
        let end = begin + sweep;
        let way = if turns { 1.0 } else { -1.0 };
        self.heading = Some([-libm::sin(end) * way, libm::cos(end) * way]);
    }
}

/// The polygon of a contour that is all written with numbers, and its first radius compensation; nothing if that is not
/// certain.
pub(super) fn polygon(blocks: &[Block], axes: [Axis; 2]) -> Option<(Vec<[f64; 2]>, Option<Compensation>)> {
    let (mut line, mut side) = (Line::default(), None);
    for block in blocks {
        let motion = match &block.kind {
            BlockKind::Empty | BlockKind::Comment | BlockKind::Structure(_) | BlockKind::Functions(_) => continue,
            BlockKind::Motion(motion) if !block.skip => motion.words(),
            _ if block.is_blend() => continue,
            _ => return None,
        };
        let own = motion.compensation.filter(|own| matches!(own, Compensation::Rl | Compensation::Rr));
        side = side.or(own);
        if matches!(motion.path, Path::Appr(_) | Path::Dep(_)) {
            return None;
        }
        line.go_on(&motion, axes)?;
    }
    Some((line.points, side))
}

/// What lies so near a contour is on it, mm or inch.
pub(super) const NEAR: f64 = 0.01;

/// The points of a contour that comes back to its beginning, once each; nothing of others.
///
/// It ends on its first line, its last line goes over its first point, or both lines are drawn beyond the corner in which
/// they meet.
pub(super) fn closed(points: &[[f64; 2]]) -> Option<Vec<[f64; 2]>> {
    let (first, second, last) = (*points.first()?, *points.get(1)?, *points.last()?);
    let before = *points.get(points.len().checked_sub(2)?)?;
    let whole = points.get(..points.len() - 1).filter(|_| points.len() > 3)?;
    if distance(last, first, second) <= NEAR || distance(first, before, last) <= NEAR {
        return Some(whole.to_vec());
    }
    let corner = crossing([first, second], [before, last])?;
    Some(std::iter::once(corner).chain(whole.iter().skip(1).copied()).collect())
}

/// How far a place is from a line.
pub(super) fn distance(place: [f64; 2], one: [f64; 2], other: [f64; 2]) -> f64 {
    let way = [other[0] - one[0], other[1] - one[1]];
    let long = way[0] * way[0] + way[1] * way[1];
    let along = (place[0] - one[0]) * way[0] + (place[1] - one[1]) * way[1];
    let share = if long > 0.0 { (along / long).clamp(0.0, 1.0) } else { 0.0 };
    libm::hypot(place[0] - one[0] - way[0] * share, place[1] - one[1] - way[1] * share)
}

/// Where two lines cross, if they do.
fn crossing([a, b]: [[f64; 2]; 2], [c, d]: [[f64; 2]; 2]) -> Option<[f64; 2]> {
    let (one, other) = ([b[0] - a[0], b[1] - a[1]], [d[0] - c[0], d[1] - c[1]]);
    let turn = one[0] * other[1] - one[1] * other[0];
    let between = [c[0] - a[0], c[1] - a[1]];
    let along = (between[0] * other[1] - between[1] * other[0]) / turn;
    let across = (between[0] * one[1] - between[1] * one[0]) / turn;
    let meets = (0.0..=1.0).contains(&along) && (0.0..=1.0).contains(&across);
    meets.then(|| [a[0] + one[0] * along, a[1] + one[1] * along])
}

/// The sides of a polygon.
pub(super) fn edges(points: &[[f64; 2]]) -> impl Iterator<Item = [[f64; 2]; 2]> {
    let next = points.iter().skip(1).chain(points.first());
    points.iter().zip(next).map(|(one, next)| [*one, *next])
}

/// The area of a polygon, positive if it goes round counter-clockwise.
pub(super) fn area(points: &[[f64; 2]]) -> f64 {
    edges(points).map(|[one, next]| one[0] * next[1] - one[1] * next[0]).sum::<f64>() / 2.0
}

/// Whether a place is inside of a polygon, by the sides that a line from there to the right crosses.
pub(super) fn holds(points: &[[f64; 2]], [x, y]: [f64; 2]) -> bool {
    let crossed = edges(points).filter(|[one, next]| {
        (one[1] > y) != (next[1] > y) && x < one[0] + (y - one[1]) / (next[1] - one[1]) * (next[0] - one[0])
    });
    crossed.count() % 2 == 1
}

/// Whether the tool of a contour that goes round so is inside of it.
pub(super) fn is_inside(area: f64, side: Compensation) -> bool {
    (area > 0.0) == (side == Compensation::Rl)
}

/// The number of an axis and whether it is incremental, if the axis is there; nothing if it is a parameter.
fn number(motion: &Motion, axis: Axis) -> Option<Option<(f64, bool)>> {
    match motion.coord(axis) {
        None => Some(None),
        Some(coord) => match coord.value.amount {
            Amount::Number(number) => Some(Some((number, coord.incremental))),
            _ => None,
        },
    }
}

/// The place in the plane that a block of a call names with both coordinates, or one of the few movements before a call
/// without any.
pub(super) fn place_of_call(facts: &Facts<'_>, call: usize) -> Option<[f64; 2]> {
    /// So many blocks are looked back through.
    const BACK: usize = 8;
    let blocks = facts.program.blocks().get(..=call)?;
    let mut found: [Option<f64>; 2] = [None; 2];
    for block in blocks.iter().rev().filter(|own| !is_silent(own)).take(BACK) {
        let coords = match &block.kind {
            BlockKind::Motion(motion) => match motion.path() {
                Path::L if !motion.functions().iter().any(|own| matches!(own.number, 91 | 92)) => motion.words().coords,
                _ => return None,
            },
            BlockKind::CyclCall(call) => match &call.form {
                CallForm::Position(coords) => coords.clone(),
                CallForm::Plain => continue,
                CallForm::Pattern => return None,
            },
            BlockKind::CycleDef(_) | BlockKind::OldCycleLine(_) | BlockKind::Functions(_) => continue,
            _ => return None,
        };
        for (known, axis) in found.iter_mut().zip([Axis::X, Axis::Y]) {
            let Some(coord) = coords.iter().find(|own| own.axis == axis).filter(|_| known.is_none()) else { continue };
            match coord.value.amount {
                Amount::Number(number) if !coord.incremental => *known = Some(number),
                _ => return None,
            }
        }
        if let [Some(x), Some(y)] = found {
            return Some([x, y]);
        }
    }
    None
}

/// The corners of a contour with radius compensation, each with its block.
pub(super) type Contour = Vec<([f64; 2], Span)>;

/// The contours of straight lines with radius compensation.
pub(super) fn compensated(facts: &Facts<'_>) -> Vec<Contour> {
    let (mut all, mut own): (Vec<Contour>, Contour) = (Vec::new(), Vec::new());
    let (mut at, mut on) = (None, false);
    // Most long programs have none.
    let beside = |block: &Block| match &block.kind {
        BlockKind::Motion(motion) => motion.outline().compensates() == Compensates::Beside,
        _ => false,
    };
    if !facts.program.blocks().iter().any(beside) {
        return all;
    }
    for block in facts.program.blocks() {
        let motion = match &block.kind {
            _ if is_silent(block) || block.is_blend() => continue,
            BlockKind::Motion(motion) if !block.skip => motion.words(),
            _ => {
                all.push(std::mem::take(&mut own));
                (at, on) = (None, false);
                continue;
            }
        };
        if motion.path.is_corner() {
            continue;
        }
        let straight = matches!(motion.path, Path::L | Path::Appr(_));
        on = motion.compensation.map_or(on, |own| own != Compensation::R0) && !matches!(motion.path, Path::Dep(_));
        at = led(at, &motion).filter(|_| straight);
        match at.filter(|_| on) {
            Some(place) => own.push((place, facts.content(block))),
            None => all.push(std::mem::take(&mut own)),
        }
    }
    all.push(own);
    all
}

/// The coordinates of a movement as they are written, without pluses and blanks: the same in two blocks that lead to the same
/// place.
pub(super) fn written(facts: &Facts<'_>, motion: &Motion) -> String {
    let signs = motion.coords.iter().flat_map(|own| facts.text(own.span).chars());
    signs.filter(|own| *own != '+' && !own.is_whitespace()).map(|own| own.to_ascii_uppercase()).collect()
}

/// Where a movement leads from a place in X and Y; nothing if that is not certain.
pub(super) fn led(from: Option<[f64; 2]>, motion: &Motion) -> Option<[f64; 2]> {
    match moved(motion, [Axis::X, Axis::Y], from.map_or([None; 2], |from| from.map(Some)))? {
        [Some(x), Some(y)] => Some([x, y]),
        _ => None,
    }
}

/// The same in any axes, of which some may be open before or remain so; nothing if a coordinate is not certain.
pub(super) fn moved<const AXES: usize>(
    motion: &Motion,
    axes: [Axis; AXES],
    from: [Option<f64>; AXES],
) -> Option<[Option<f64>; AXES]> {
    let mut to = from;
    for (axis, known) in axes.into_iter().zip(&mut to) {
        if let Some((value, incremental)) = number(motion, axis)? {
            *known = Some(if incremental { (*known)? + value } else { value });
        }
    }
    Some(to)
}
