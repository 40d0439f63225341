//! The holes of a whole program together: what was centred and what drilled, what was drilled and what tapped, and circles
//! of holes that lack one.
//!
//! Invariant: only of programs of which all holes are known: those that came to their end, or to a block after which nothing
//! is drilled.
use super::body::Body;
use super::watcher::{SAME, Watcher};
use super::work::Work;
use crate::check::{Incident, ToolKind, is_slip};
use crate::program::fields::key;
use crate::program::syntax::{BlockKind, CallForm};
use crate::spec::{CycleKey, Group};

/// So many holes are compared.
const MOST: usize = 1_000;
/// So many holes make a row.
const ROW: usize = 3;
/// So many holes make a circle that may lack one.
const CIRCLE: usize = 4;
/// The meaning that only cycles for centring have.
const CENTRES: &str = "centring-diameter";
/// How far the drill for a thread may differ from its core, mm.
const CORE: f64 = 0.16;
/// So much of its diameter a hole may lie from the edge of the blank.
const AT_EDGE: f64 = 0.2;
/// Places on a circle are so near to it, mm, and steps between them so equal, degrees.
const ROUND: f64 = 0.02;
const EQUAL: f64 = 0.05;

/// What is done at a row of places.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Kind {
    Centred,
    Drilled,
    Threaded,
    /// Reamed, countersunk, bored.
    Other,
}

/// What one tool call does with one cycle.
struct Row {
    made: (u32, CycleKey),
    kind: Kind,
    width: Option<f64>,
    /// The places, with the lines where they are reported and written.
    places: Vec<([f64; 2], usize, usize)>,
}

/// The rows of a program.
#[derive(Default)]
pub(super) struct Rows {
    rows: Vec<Row>,
    count: usize,
    /// Whether there may be holes that are not among them.
    pub(super) open: bool,
}

impl Row {
    fn has(&self, place: [f64; 2]) -> bool {
        self.places.iter().any(|(own, ..)| is_same(*own, place))
    }
}

fn is_same(one: [f64; 2], other: [f64; 2]) -> bool {
    (0..2).all(|axis| (one[axis] - other[axis]).abs() <= 5.0 * SAME)
}

impl Watcher<'_> {
    /// Notes a hole with what was done there.
    pub(super) fn note_hole(&mut self, work: &Work) {
        if !matches!(work.group, Group::Drilling | Group::Threads) {
            return;
        }
        self.series.count += 1;
        if self.series.count > MOST {
            self.series.open = true;
            return;
        }
        let Some(cycle) = self.cycle(work.key) else { return };
        let centres = cycle.params.iter().any(|param| param.is.as_str() == CENTRES);
        let kind = match work.group {
            Group::Threads => Kind::Threaded,
            // A countersink works with the cycle for centring, too.
            _ if self.kind() == Some(ToolKind::Spot) => Kind::Centred,
            _ if centres && self.kind().is_none() => Kind::Centred,
            _ if centres || self.kind().is_some_and(|own| own != ToolKind::Drill) => Kind::Other,
            _ => Kind::Drilled,
        };
        let at = if work.milled { work.middle() } else { work.start };
        let place = [at.x, at.y];
        let made = (self.calls, work.key);
        let extent = work.high.x - work.low.x;
        let width = self.width().map(|width| if work.milled { width + extent } else { width });
        self.at_edge(work, place, width.filter(|_| kind != Kind::Centred && kind != Kind::Other));
        let own = (place, work.line, work.written);
        match self.series.rows.iter_mut().find(|row| row.made == made) {
            Some(row) => row.places.push(own),
            None => self.series.rows.push(Row { made, kind, width, places: vec![own] }),
        }
    }

    /// A hole that begins in the blank, so near to its edge that it is cut.
    fn at_edge(&mut self, work: &Work, place: [f64; 2], width: Option<f64>) {
        let Some(body) = self.body else { return };
        let (Some(width), Some(room)) = (width, room(&body, place)) else { return };
        if room >= 0.0 && room < AT_EDGE * width {
            self.report(work.line, Incident::Edge(place.map(|own| own * self.unit)));
        }
    }

    /// Whether a cycle that is defined after a line makes holes.
    pub(super) fn drills_after(&self, line: usize) -> bool {
        let mut drills = false;
        self.program.each_cycle(|view| {
            let after = self.program.blocks().get(view.first).is_some_and(|block| block.line > line);
            let group = self.cycle(key(view.keyword, view.number)).map(|own| own.file.group);
            drills |= after && matches!(group, None | Some(Group::Drilling | Group::Threads));
        });
        drills
    }

    /// The program is over: what its rows of holes say together.
    pub(super) fn judge_rows(&mut self) {
        let rows = std::mem::take(&mut self.series);
        if rows.open || self.lost {
            return;
        }
        let rows = rows.rows;
        let unit = self.unit;
        if let Some((line, place)) = stray(&rows) {
            self.report(line, Incident::Stray(place.map(|own| own * unit)));
        }
        if let Some((line, place)) = untapped(&rows) {
            self.report(line, Incident::Untapped(place.map(|own| own * unit)));
        }
        let others = rows.iter().filter(|row| row.kind != Kind::Other);
        if let Some((line, place)) = others.filter_map(corner).next() {
            self.report(line, Incident::Corner(place.map(|own| own * unit)));
        }
        let plain = |line: &usize| {
            self.blocks.get(line).is_some_and(|block| match &block.kind {
                BlockKind::Motion(_) => true,
                BlockKind::CyclCall(call) => !matches!(call.form, CallForm::Pattern),
                _ => false,
            })
        };
        let gaps = rows.iter().filter(|row| row.kind != Kind::Other).find_map(|row| {
            let (_, _, written) = row.places.first()?;
            let one = row.places.iter().all(|(.., own)| own == written) && plain(written);
            let places: Vec<[f64; 2]> = row.places.iter().map(|(place, ..)| *place).collect();
            Some((row.places.last()?.1, gap(&places).filter(|_| one)?))
        });
        if let Some((line, place)) = gaps {
            self.report(line, Incident::Gap(place.map(|own| own * unit)));
        }
    }
}

/// How far a place is inside of the edges of a box; nothing of a cylinder.
fn room(body: &Body, place: [f64; 2]) -> Option<f64> {
    if body.is_round() {
        return None;
    }
    let [x, y] = place;
    let all = [x - body.low.x, body.high.x - x, y - body.low.y, body.high.y - y];
    all.into_iter().reduce(f64::min)
}

/// The first hole of a row that was not centred, although others of it were and a centred place has no hole.
fn stray(rows: &[Row]) -> Option<(usize, [f64; 2])> {
    let centred = |place: [f64; 2]| rows.iter().any(|row| row.kind == Kind::Centred && row.has(place));
    let used = |place: [f64; 2]| rows.iter().any(|row| row.kind != Kind::Centred && row.has(place));
    let all = rows.iter().filter(|row| row.kind == Kind::Centred).flat_map(|row| &row.places);
    if all.filter(|(place, ..)| !used(*place)).count() == 0 {
        return None;
    }
    rows.iter().filter(|row| row.kind == Kind::Drilled && row.places.len() >= ROW).find_map(|row| {
        row.places.iter().find(|(place, ..)| centred(*place))?;
        let (place, line, _) = row.places.iter().find(|(place, ..)| !centred(*place))?;
        Some((*line, *place))
    })
}

/// The first core hole of a row of which only a part is tapped, with the line of the tapping.
fn untapped(rows: &[Row]) -> Option<(usize, [f64; 2])> {
    for (at, thread) in rows.iter().enumerate().filter(|(_, row)| row.kind == Kind::Threaded) {
        let Some(diameter) = thread.width else { continue };
        let Some((_, pitch)) = crate::check::COARSE.iter().find(|(own, _)| (own - diameter).abs() <= 0.02) else {
            continue;
        };
        for drilled in rows.iter().take(at).filter(|row| row.kind == Kind::Drilled) {
            let core = drilled.width.is_some_and(|width| {
                (width - (diameter - pitch)).abs() <= CORE && (width - width.round()).abs() > SAME
            });
            let tapped = drilled.places.iter().filter(|(place, ..)| thread.has(*place)).count();
            if !core || tapped == 0 || drilled.places.len() < ROW {
                continue;
            }
            let later = |place: [f64; 2]| {
                rows.iter().any(|row| row.made.0 > drilled.made.0 && row.kind != Kind::Centred && row.has(place))
            };
            if let Some((place, ..)) = drilled.places.iter().find(|(place, ..)| !later(*place)) {
                return Some((thread.places.first()?.1, *place));
            }
        }
    }
    None
}

/// The hole of four that is not at the corner of the rectangle which the others form, by a slip in one coordinate: its line,
/// and the corner.
fn corner(row: &Row) -> Option<(usize, [f64; 2])> {
    let places: Vec<[f64; 2]> = row.places.iter().map(|(place, ..)| *place).collect();
    let [_, _, _, _] = places.as_slice() else { return None };
    let near = |one: f64, other: f64| (one - other).abs() <= SAME;
    (0..4).find_map(|odd| {
        let others: Vec<[f64; 2]> = (0..4).filter(|at| *at != odd).map(|at| places[at]).collect();
        // The one of the three at the right angle lies beside one of the others and above the other.
        let right = (0..3).find_map(|at| {
            let (own, one, other) = (others[at], others[(at + 1) % 3], others[(at + 2) % 3]);
            let fits = |a: [f64; 2], b: [f64; 2]| {
                near(own[1], a[1]) && near(own[0], b[0]) && !near(own[0], a[0]) && !near(own[1], b[1])
            };
            match (fits(one, other), fits(other, one)) {
                (true, _) => Some([one[0], other[1]]),
                (_, true) => Some([other[0], one[1]]),
                _ => None,
            }
        })?;
        let own = places[odd];
        let differs: Vec<usize> = (0..2).filter(|axis| !near(own[*axis], right[*axis])).collect();
        let rounded = |value: f64| libm::round(value * 1e4) / 1e4;
        let slip = |axis: usize| is_slip(rounded(own[axis]), rounded(right[axis]));
        matches!(differs.as_slice(), [only] if slip(*only)).then(|| (row.places[odd].1, right.map(rounded)))
    })
}

/// The place that a circle of holes with equal steps lacks.
fn gap(places: &[[f64; 2]]) -> Option<[f64; 2]> {
    let [a, b, c, ..] = places else { return None };
    if places.len() < CIRCLE {
        return None;
    }
    let (ab, ac) = ([b[0] - a[0], b[1] - a[1]], [c[0] - a[0], c[1] - a[1]]);
    let twice = 2.0 * (ab[0] * ac[1] - ab[1] * ac[0]);
    if twice.abs() < SAME {
        return None;
    }
    let (long, wide) = (ab[0] * ab[0] + ab[1] * ab[1], ac[0] * ac[0] + ac[1] * ac[1]);
    let centre = [a[0] + (ac[1] * long - ab[1] * wide) / twice, a[1] + (ab[0] * wide - ac[0] * long) / twice];
    let radius = libm::hypot(a[0] - centre[0], a[1] - centre[1]);
    let on = |own: &[f64; 2]| (libm::hypot(own[0] - centre[0], own[1] - centre[1]) - radius).abs() <= ROUND;
    if !places.iter().all(on) {
        return None;
    }
    let mut angles: Vec<f64> = places
        .iter()
        .map(|own| libm::atan2(own[1] - centre[1], own[0] - centre[0]).to_degrees().rem_euclid(360.0))
        .collect();
    angles.sort_by(f64::total_cmp);
    let next = angles.iter().skip(1).copied().chain(angles.first().map(|first| first + 360.0));
    let steps: Vec<(f64, f64)> = angles.iter().zip(next).map(|(from, to)| (*from, to - from)).collect();
    let step = 360.0 / (places.len() as f64 + 1.0);
    let (wide, usual): (Vec<_>, Vec<_>) = steps.iter().partition(|(_, own)| (own - 2.0 * step).abs() <= EQUAL);
    let equal = usual.iter().all(|(_, own)| (own - step).abs() <= EQUAL);
    let [(from, _)] = wide.as_slice() else { return None };
    let angle = (from + step).to_radians();
    let place = [centre[0] + radius * libm::cos(angle), centre[1] + radius * libm::sin(angle)];
    equal.then(|| place.map(|own| libm::round(own * 1e4) / 1e4))
}
