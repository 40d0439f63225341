//! The holes of a whole program together: what was centred and what drilled, what was drilled and what tapped, and
//! circles of holes that lack one.
//!
//! Invariant: only of programs of which all holes are known: those that came to their end, or to a block after which
//! nothing is drilled.
use std::collections::BTreeMap;

use super::body::{Body, SAME};
use super::watcher::Watcher;
use super::work::Work;
use crate::check::{Incident, Observed, ToolKind, is_slip};
use crate::program::fields::key;
use crate::program::syntax::{BlockKind, CallForm};
use crate::spec::{CycleKey, Group};

/// So many holes are compared.
const MOST: usize = 1_000;
/// So many holes make a row.
const ROW: usize = 3;
/// So many holes make a row of which one may be left out.
const SEVERAL: usize = 4;
/// So many holes make a circle that may lack one.
const CIRCLE: usize = 4;
/// The meaning that only cycles for centring have.
const CENTRES: &str = "centring-diameter";
/// A reamer takes no more off the diameter than this, and this part of the diameter, mm.
const REAMED: (f64, f64) = (0.4, 0.02);
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
    Reamed,
    /// Countersunk, bored.
    Other,
}

/// What one tool call does with one cycle.
struct Row {
    made: (u32, CycleKey),
    /// The line of that tool call.
    called: usize,
    /// The setting in which its places are meant.
    setting: usize,
    kind: Kind,
    width: Option<f64>,
    /// The places, with the lines where they are reported and written.
    places: Vec<([f64; 2], usize, usize)>,
}

/// The preset, its place and its turn, the tilt of the plane and the rotary axes: places of the machine in the same
/// setting are places of one workpiece.
type Setting = Vec<i64>;

/// The rows of a program.
#[derive(Default)]
pub(super) struct Rows {
    rows: Vec<Row>,
    settings: Vec<Setting>,
    count: usize,
    /// Whether there may be holes that are not among them.
    pub(super) open: bool,
}

impl Rows {
    /// Whether there is any hole.
    pub(super) const fn has_any(&self) -> bool {
        self.count > 0
    }
}

impl Row {
    fn has(&self, place: [f64; 2]) -> bool {
        self.places.iter().any(|(own, ..)| is_same(*own, place))
    }

    fn has_any(&self, other: &Self) -> bool {
        other.places.iter().any(|(own, ..)| self.has(*own))
    }

    /// Whether a hole as wide as those of this row is what a tap or a reamer of another one needs.
    fn fits(&self, finishes: &Self) -> bool {
        let Some((own, other)) = self.width.zip(finishes.width) else { return false };
        if finishes.kind == Kind::Reamed {
            return own < other - SAME && other - own <= REAMED.0 + REAMED.1 * other;
        }
        let coarse = crate::check::COARSE.iter().find(|(diameter, _)| (diameter - other).abs() <= 0.02);
        coarse.is_some_and(|(_, pitch)| (own - (other - pitch)).abs() <= CORE)
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
            _ if !centres && self.kind() == Some(ToolKind::Reamer) => Kind::Reamed,
            _ if centres || self.kind().is_some_and(|own| own != ToolKind::Drill) => Kind::Other,
            _ => Kind::Drilled,
        };
        let at = if work.milled { work.middle() } else { work.start };
        let place = [at.x, at.y];
        let made = (self.calls, work.key);
        let extent = work.high.x - work.low.x;
        let width = self.width().map(|width| if work.milled { width + extent } else { width });
        if !self.away() {
            self.at_edge(work, place, width.filter(|_| matches!(kind, Kind::Drilled | Kind::Threaded)));
        }
        let (own, called) = ((place, work.line, work.written), self.called);
        let setting = self.setting();
        let series = &mut self.series;
        let setting = series.settings.iter().position(|own| *own == setting).unwrap_or_else(|| {
            series.settings.push(setting);
            series.settings.len() - 1
        });
        match series.rows.iter_mut().find(|row| row.made == made && row.setting == setting) {
            Some(row) => row.places.push(own),
            None => series.rows.push(Row { made, called, setting, kind, width, places: vec![own] }),
        }
    }

    /// A hole that begins in the blank, so near to its edge that it is cut.
    fn at_edge(&mut self, work: &Work, place: [f64; 2], width: Option<f64>) {
        let Some(body) = self.body else { return };
        let (Some(width), Some(room)) = (width, room(&body, place)) else { return };
        if room >= 0.0 && room < AT_EDGE * width {
            self.report(work.line, Incident::HoleCutByEdge(place.map(|own| own * self.unit)));
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
        if rows.open {
            return;
        }
        let mut made: BTreeMap<usize, usize> = BTreeMap::new();
        for row in &rows.rows {
            *made.entry(row.called).or_default() += row.places.len();
        }
        let counted = made.into_iter().map(|(line, count)| Observed { line, incident: Incident::HolesMade(count) });
        self.found.extend(counted);
        let holes: Vec<[f64; 2]> = rows.rows.iter().flat_map(|row| row.places.iter().map(|own| own.0)).collect();
        let alone = rows.rows.iter().filter(|row| row.kind == Kind::Drilled && row.places.len() == 1);
        let single: Vec<[f64; 2]> = alone.flat_map(|row| row.places.iter().map(|own| own.0)).collect();
        if let Some(place) = self.beside_pocket(&single, &holes).filter(|_| rows.settings.len() == 1) {
            let line = rows.rows.iter().flat_map(|row| &row.places).find(|own| own.0 == place).map(|own| own.1);
            self.report(line.unwrap_or(self.line), Incident::PilotHoleExchanged(place.map(|own| own * self.unit)));
        }
        let settings = rows.settings.len();
        let mut all: Vec<Vec<Row>> = (0..settings).map(|_| Vec::new()).collect();
        for row in rows.rows {
            if let Some(own) = all.get_mut(row.setting) {
                own.push(row);
            }
        }
        all.iter().for_each(|rows| self.judge_setting(rows));
    }

    /// The same of the rows in one setting.
    fn judge_setting(&mut self, rows: &[Row]) {
        let unit = self.unit;
        if let Some((line, place)) = stray(rows).or_else(|| self.beside_centres(rows)) {
            self.report(line, Incident::NotCentred(place.map(|own| own * unit)));
        } else if let Some((line, place)) = self.left_out(rows, Kind::Drilled) {
            self.report(line, Incident::OnlyOneNotCentred(place.map(|own| own * unit)));
        } else if let Some((line, place)) = self.left_out(rows, Kind::Centred) {
            self.report(line, Incident::CentredInVain(place.map(|own| own * unit)));
        }
        if let Some((line, place, reamed)) = unfinished(rows) {
            let place = place.map(|own| own * unit);
            self.report(line, if reamed { Incident::Unreamed(place) } else { Incident::Untapped(place) });
        }
        if let Some((line, place, reamed)) = self.beside_holes(rows) {
            let none = Incident::ReamedWrongly { what: "none", value: 0.0, other: 0.0 };
            self.report(line, if reamed { none } else { Incident::NoHole(place.map(|own| own * unit)) });
        }
        let plain_kind = |row: &&Row| matches!(row.kind, Kind::Centred | Kind::Drilled | Kind::Threaded);
        let others = rows.iter().filter(plain_kind);
        if let Some((line, place)) = others.filter_map(corner).next() {
            self.report(line, Incident::CornerOfRectangleOff(place.map(|own| own * unit)));
        }
        let plain = |line: &usize| {
            self.blocks.get(line).is_some_and(|block| match &block.kind {
                BlockKind::Motion(_) => true,
                BlockKind::CyclCall(call) => !matches!(call.form, CallForm::Pattern),
                _ => false,
            })
        };
        let gaps = rows.iter().filter(plain_kind).find_map(|row| {
            let (_, _, written) = row.places.first()?;
            let one = row.places.iter().all(|(.., own)| own == written) && plain(written);
            let places: Vec<[f64; 2]> = row.places.iter().map(|(place, ..)| *place).collect();
            Some((row.places.last()?.1, gap(&places).filter(|_| one)?))
        });
        if let Some((line, place)) = gaps {
            self.report(line, Incident::GapInCircle(place.map(|own| own * unit)));
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

/// The first hole of a row of which only a part is tapped or reamed though all are as wide as the tap or reamer needs,
/// with the line of that, and whether it is a reamer.
fn unfinished(rows: &[Row]) -> Option<(usize, [f64; 2], bool)> {
    for (at, finishes) in rows.iter().enumerate().filter(|(_, row)| row.finishes()) {
        for drilled in rows.iter().take(at).filter(|row| row.kind == Kind::Drilled) {
            let done = drilled.places.iter().filter(|(place, ..)| finishes.has(*place)).count();
            // A hole of whole millimetres may also be one by itself.
            let whole = drilled.width.is_some_and(|width| (width - width.round()).abs() <= SAME);
            if whole || !drilled.fits(finishes) || done == 0 || drilled.places.len() < ROW {
                continue;
            }
            if let Some(place) = left(rows, drilled) {
                return Some((finishes.places.first()?.1, place, finishes.kind == Kind::Reamed));
            }
        }
    }
    None
}

/// The first place of a drilled row to which no other tool comes later.
fn left(rows: &[Row], drilled: &Row) -> Option<[f64; 2]> {
    let later = |place: [f64; 2]| {
        rows.iter().any(|row| row.made.0 > drilled.made.0 && row.kind != Kind::Centred && row.has(place))
    };
    drilled.places.iter().map(|(place, ..)| *place).find(|place| !later(*place))
}

impl Row {
    const fn finishes(&self) -> bool {
        matches!(self.kind, Kind::Threaded | Kind::Reamed)
    }
}

impl Watcher<'_> {
    /// The setting in effect.
    fn setting(&self) -> Setting {
        let mut setting = self.frame.clone();
        for (axis, angle) in &self.angles {
            setting.extend([axis.letter() as i64, (angle / SAME).round() as i64]);
        }
        setting
    }

    /// Whether a milled hole or pocket is at a place.
    fn is_hollow(&self, place: [f64; 2]) -> bool {
        self.holes.iter().any(|own| own.milled && is_same(own.at, place))
    }

    /// The only hole of a row that was not centred, or the only centred place of a row to which no tool comes, with its
    /// line.
    fn left_out(&self, rows: &[Row], kind: Kind) -> Option<(usize, [f64; 2])> {
        rows.iter().enumerate().filter(|(_, row)| row.kind == kind && row.places.len() >= SEVERAL).find_map(
            |(at, row)| {
                let other = |own: &&Row| own.has_any(row) && (kind == Kind::Drilled) == (own.kind == Kind::Centred);
                let part = if kind == Kind::Drilled { rows.get(..at)? } else { rows.get(at + 1..)? };
                let part: Vec<&Row> = part.iter().filter(other).collect();
                let met = |place: [f64; 2]| part.iter().any(|own| own.has(place));
                let mut without = row.places.iter().filter(|(place, ..)| !met(*place));
                let ((place, line, _), None) = (without.next()?, without.next()) else { return None };
                // What another tool has made there, or makes there in another way, is not looked at.
                let others = rows.iter().filter(|own| !std::ptr::eq(*own, row)).any(|own| own.has(*place));
                (!others && !self.is_hollow(*place)).then_some((*line, *place))
            },
        )
    }

    /// The first place of a row that is tapped or reamed without a hole, while holes of another row that are as wide as
    /// it needs stay as they are.
    fn beside_holes(&self, rows: &[Row]) -> Option<(usize, [f64; 2], bool)> {
        for (at, finishes) in rows.iter().enumerate().filter(|(_, row)| row.finishes()) {
            let before = || rows.iter().take(at);
            let hole = |place: [f64; 2]| before().any(|row| row.kind != Kind::Centred && row.has(place));
            let mut without = finishes.places.iter().filter(|(place, ..)| !hole(*place) && !self.is_hollow(*place));
            let Some((place, line, _)) = without.next() else { continue };
            let waits = |row: &&Row| row.kind == Kind::Drilled && row.fits(finishes) && left(rows, row).is_some();
            if before().any(|row| waits(&row)) {
                return Some((*line, *place, finishes.kind == Kind::Reamed));
            }
        }
        None
    }

    /// The first hole of a row that was not centred, while another row of as many places was centred, and no tool comes
    /// there.
    fn beside_centres(&self, rows: &[Row]) -> Option<(usize, [f64; 2])> {
        let others = |place: [f64; 2]| rows.iter().any(|row| row.kind != Kind::Centred && row.has(place));
        let centred = |place: [f64; 2]| rows.iter().any(|row| row.kind == Kind::Centred && row.has(place));
        let idle = rows.iter().enumerate().find(|(_, row)| {
            let unused = |place: [f64; 2]| !others(place) && !self.is_hollow(place);
            row.kind == Kind::Centred && row.places.len() > 1 && row.places.iter().all(|(place, ..)| unused(*place))
        });
        let (at, idle) = idle?;
        let drilled = rows.iter().skip(at + 1).find(|row| {
            let count = row.places.len() == idle.places.len();
            row.kind == Kind::Drilled && count && !row.places.iter().any(|(place, ..)| centred(*place))
        })?;
        drilled.places.first().map(|(place, line, _)| (*line, *place))
    }
}

/// The hole of four that is not at the corner of the rectangle which the others form, by a slip in one coordinate: its
/// line, and the corner.
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
