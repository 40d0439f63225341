//! A closed contour with RL or RR to which the tool comes from the wrong side: it begins outside and compensates to the
//! inside, or the other way round, and crosses the contour by its radius; or one that goes from a corner straight back to
//! the one before it; or one that the tool leaves for its other side without being lifted; or one that is approached in an
//! inside corner, which the tool damages by its radius; or one that ends on its first line, short of its beginning; or one
//! that comes back to one of its own lines between.
//!
//! Only contours whose elements are all numbers, that do not cross themselves, and whose height does not change from the
//! compensating movement to the one that leaves: a tool that plunges at the contour may come from above.
use crate::base::diag::{Diagnostic, Severity, Span};
use crate::check::contours::{Line, NEAR, area, closed, distance, edges, holds, is_inside};
use crate::check::program::is_silent;
use crate::check::{Aspect, Facts, Rule, Tri};
use crate::program::syntax::{Approach, Axis, BlockKind, Compensation, Motion, Path, ValueKind};

pub(super) const RULE: Rule = Rule { code: "contour-crossed", severity: Severity::Warning, run };

/// Contours of more points are left to others: each pair of lines is looked at.
const MANY: usize = 1 << 8;
const PLANE: [Axis; 2] = [Axis::X, Axis::Y];

/// The finding about a contour that other tools machine from the other side.
const OTHER_SIDE: &str = "compensation-other-side";
/// The finding about an arc that makes a contour cross itself.
const ARC: &str = "arc-direction-wrong";

/// A contour under way.
struct Course {
    side: Compensation,
    /// Where the tool was before it, if that is known.
    start: Option<[f64; 2]>,
    place: Span,
    /// Whether APPR leads to it, with a straight line so long where it is one, and whether its first element and its last one
    /// so far are straight.
    approached: bool,
    lead: Option<(Approach, f64)>,
    straight: Option<[bool; 2]>,
}

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let mut line = Line::default();
    let mut course: Option<Course> = None;
    let mut upright = false;
    let mut stretches = facts.run.stretches().peekable();
    let blocks = facts.program.blocks();
    // Without RL or RR there is nothing to follow.
    if facts.shaped().next().is_none() {
        return;
    }
    for (index, block) in blocks.iter().enumerate() {
        while let Some((_, _, modal)) = stretches.next_if(|(from, _, _)| *from <= index) {
            upright = modal
                .is_some_and(|modal| modal.is(Aspect::OtherAxis) == Tri::No && modal.is(Aspect::Turning) == Tri::No);
        }
        let motion = match &block.kind {
            _ if is_silent(block) => continue,
            BlockKind::Motion(motion) if upright && !block.skip && !facts.ends(block) => motion,
            // A part that is repeated begins and ends within the course.
            BlockKind::Lbl(_) if !block.ends_subprogram() => continue,
            BlockKind::CallLbl(call) if call.repeat.is_some() => continue,
            _ if block.is_blend() => continue,
            _ => {
                line.lose();
                course = None;
                continue;
            }
        };
        let words = motion.words();
        let beside = words.compensation.filter(|own| matches!(own, Compensation::Rl | Compensation::Rr));
        let leaves = words.compensation == Some(Compensation::R0) || matches!(words.path, Path::Dep(_));
        if leaves && let Some(own) = course.take() {
            let what = if turns_back(&line.points) {
                Some(("back", own.place))
            } else {
                let ring = closed(&line.points).unwrap_or_default();
                let starts = own.start.into_iter().chain(own.lead_from(&line.points));
                let begins =
                    starts.into_iter().any(|start| is_across(own.side, start, &ring)).then_some(("side", own.place));
                let ends = || left_for(&line, &words).is_some_and(|end| is_across(own.side, end, &ring));
                let corner = || own.begins_in_corner(&line.points).then_some(("start", own.place));
                let short = || stops_short(&line.points).then(|| ("short", facts.content(block)));
                let arc = found.iter().any(|own| own.code == ARC);
                let itself = || (!arc && meets_itself(&line.points)).then_some(("itself", own.place));
                let away = || ends().then(|| ("away", facts.content(block)));
                begins.or_else(away).or_else(corner).or_else(short).or_else(itself)
            };
            // Against the other passes of the contour the side was reported before.
            let same = |known: &Diagnostic| {
                known.code == OTHER_SIDE && known.place.as_ref().is_some_and(|place| place.span == own.place)
            };
            if let Some((what, place)) = what.filter(|_| !found.iter().any(same)) {
                found.push(rule.at(facts, place).arg("what", what));
            }
            line.begin();
        }
        if let (Some(side), None) = (beside, &course) {
            let approached = matches!(words.path, Path::Appr(_));
            let (start, place) = (line.end(), facts.content(block));
            course = Some(Course { side, start, place, approached, lead: lead(facts, &words), straight: None });
            line.begin();
        } else if let Some(own) = &mut course {
            own.note(&words);
        }
        let lifts = words.coords.iter().any(|coord| !matches!(coord.axis, Axis::X | Axis::Y | Axis::Pr | Axis::Pa));
        let other = beside.zip(course.as_ref()).is_some_and(|(side, own)| side != own.side);
        if course.is_some() && (lifts || other) {
            course = None;
        }
        let moved =
            if matches!(words.path, Path::Dep(_)) { departed(&mut line, &words) } else { line.go_on(&words, PLANE) };
        if moved.is_none() || words.functions.iter().any(|own| !matches!(own.number, 0..=9 | 13 | 14)) {
            line.lose();
            course = None;
        }
    }
}

/// Whether a contour comes back to the line with which it begins, in the same direction, and ends before its beginning.
fn stops_short(points: &[[f64; 2]]) -> bool {
    let [first, second, .., before, last] = points else { return false };
    let way = [second[0] - first[0], second[1] - first[1]];
    let end = [last[0] - before[0], last[1] - before[1]];
    let (long, wide) = (libm::hypot(way[0], way[1]), libm::hypot(end[0], end[1]));
    let gap = [first[0] - last[0], first[1] - last[1]];
    let along = (gap[0] * way[0] + gap[1] * way[1]) / long;
    let aside = (gap[0] * way[1] - gap[1] * way[0]) / long;
    let turned = (way[0] * end[1] - way[1] * end[0]) / (long * wide);
    let same = way[0] * end[0] + way[1] * end[1] > 0.0 && turned.abs() < 1e-3;
    points.len() > 4 && same && aside.abs() < NEAR && along > NEAR
}

/// The form of an approach on a straight line, and how long that is.
fn lead(facts: &Facts<'_>, words: &Motion) -> Option<(Approach, f64)> {
    let Path::Appr(form @ (Approach::Lt | Approach::Ln | Approach::Plt | Approach::Pln)) = words.path else {
        return None;
    };
    let word = words.words.iter().find(|own| facts.text(own.name).trim().eq_ignore_ascii_case("LEN"))?;
    match word.value.kind {
        ValueKind::Number(length) => Some((form, length)),
        _ => None,
    }
}

impl Course {
    /// Where the line begins on which the tool is led to the contour: before its first element, or beside it.
    fn lead_from(&self, points: &[[f64; 2]]) -> Option<[f64; 2]> {
        let ((form, long), [first, next, ..]) = (self.lead?, points) else { return None };
        let way = [next[0] - first[0], next[1] - first[1]];
        let unit = long / libm::hypot(way[0], way[1]);
        let aside = if self.side == Compensation::Rl { unit } else { -unit };
        Some(match form {
            Approach::Lt | Approach::Plt => [first[0] - way[0] * unit, first[1] - way[1] * unit],
            _ => [first[0] - way[1] * aside, first[1] + way[0] * aside],
        })
    }

    /// Notes an element.
    fn note(&mut self, words: &Motion) {
        let straight = match words.path {
            Path::L | Path::Lp => !words.coords.is_empty(),
            Path::Cc => return,
            _ => false,
        };
        let first = self.straight.map_or(straight, |[first, _]| first);
        self.straight = Some([first, straight]);
    }

    /// Whether the tool is led to an inside corner of the closed contour, and leaves it there.
    fn begins_in_corner(&self, points: &[[f64; 2]]) -> bool {
        /// Lines that turn by less go on straight.
        const BENT: f64 = 0.05;
        let (Some(first), Some(last)) = (points.first(), points.last()) else { return false };
        let apart = libm::hypot(first[0] - last[0], first[1] - last[1]);
        let [Some(next), Some(before)] = [points.get(1), points.len().checked_sub(2).and_then(|at| points.get(at))]
        else {
            return false;
        };
        if !self.approached || self.straight != Some([true; 2]) || apart > NEAR || points.len() < 4 {
            return false;
        }
        let unit = |from: &[f64; 2], to: &[f64; 2]| {
            let long = libm::hypot(to[0] - from[0], to[1] - from[1]);
            [(to[0] - from[0]) / long, (to[1] - from[1]) / long]
        };
        let (end, begin) = (unit(before, first), unit(first, next));
        let turn = end[0] * begin[1] - end[1] * begin[0];
        if self.side == Compensation::Rl { turn > BENT } else { turn < -BENT }
    }
}

/// Where the block that leaves a contour leads at the same height, if that is certain.
fn left_for(line: &Line, words: &Motion) -> Option<[f64; 2]> {
    if words.coords.iter().any(|coord| !matches!(coord.axis, Axis::X | Axis::Y | Axis::Pr | Axis::Pa)) {
        return None;
    }
    let mut line = line.clone();
    if matches!(words.path, Path::Dep(_)) { departed(&mut line, words) } else { line.go_on(words, PLANE) }?;
    line.end()
}

/// A departure leads to the point that it names, if it names one.
fn departed(line: &mut Line, words: &Motion) -> Option<()> {
    let names = |axis| words.coord(axis).is_some();
    if !(names(Axis::X) && names(Axis::Y)) {
        return None;
    }
    line.go_on(&Motion { path: Path::L, ..words.clone() }, PLANE)
}

/// Whether a closed contour goes from a corner straight back to the one before it.
fn turns_back(points: &[[f64; 2]]) -> bool {
    let same = |one: [f64; 2], other: [f64; 2]| libm::hypot(one[0] - other[0], one[1] - other[1]) <= NEAR;
    let back = |three: &[[f64; 2]]| matches!(three, [a, b, c] if same(*a, *c) && !same(*a, *b));
    points.len() < MANY && closed(points).is_some_and(|ring| ring.len() > 4 && ring.windows(3).any(back))
}

/// Whether a place is on the other side of a closed contour than the tool that goes along it.
fn is_across(side: Compensation, place: [f64; 2], ring: &[[f64; 2]]) -> bool {
    let area = area(ring);
    if ring.len() < 3 || MANY < ring.len() || area.abs() < NEAR || is_crossed(ring) {
        return false;
    }
    let apart = edges(ring).all(|[one, other]| distance(place, one, other) > NEAR);
    apart && is_inside(area, side) != holds(ring, place)
}

/// Whether a contour crosses one of its own lines, or comes to it between its ends: the first and the last one may overlap.
fn meets_itself(points: &[[f64; 2]]) -> bool {
    let lines: Vec<[[f64; 2]; 2]> = points.windows(2).filter_map(|two| two.try_into().ok()).collect();
    if lines.len() < 4 || MANY < lines.len() {
        return false;
    }
    let last = lines.len() - 1;
    let within = |place: [f64; 2], [from, to]: [[f64; 2]; 2]| {
        let apart = |end: [f64; 2]| libm::hypot(place[0] - end[0], place[1] - end[1]) > NEAR;
        distance(place, from, to) <= NEAR && apart(from) && apart(to)
    };
    lines.iter().enumerate().any(|(at, one)| {
        lines.iter().enumerate().skip(at + 2).filter(|(after, _)| (at, *after) != (0, last)).any(|(after, other)| {
            // What goes on along the line from there overlaps it.
            let leaves = lines.get(after + 1).is_some_and(|next| !is_along(*next, *one));
            let comes = leaves && within(other[1], *one) || at != 0 && within(one[0], *other);
            comes || crosses(*one, *other)
        })
    })
}

/// Whether two lines have the same direction.
fn is_along([a, b]: [[f64; 2]; 2], [c, d]: [[f64; 2]; 2]) -> bool {
    let (one, other) = ([b[0] - a[0], b[1] - a[1]], [d[0] - c[0], d[1] - c[1]]);
    let turn = one[0] * other[1] - one[1] * other[0];
    turn.abs() <= NEAR * libm::hypot(one[0], one[1]) && one[0] * other[0] + one[1] * other[1] > 0.0
}

/// Whether two lines cross.
fn crosses([a, b]: [[f64; 2]; 2], [c, d]: [[f64; 2]; 2]) -> bool {
    let turn = |a: [f64; 2], b: [f64; 2], c: [f64; 2]| (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    turn(a, b, c) * turn(a, b, d) < 0.0 && turn(c, d, a) * turn(c, d, b) < 0.0
}

/// Whether two of its lines cross.
fn is_crossed(ring: &[[f64; 2]]) -> bool {
    let all: Vec<[[f64; 2]; 2]> = edges(ring).collect();
    all.iter().enumerate().any(|(at, one)| all.iter().skip(at + 2).any(|other| crosses(*one, *other)))
}
