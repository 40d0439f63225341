//! Follows a run: takes its events, keeps the stock, and writes down what is worth knowing.
//!
//! Invariant: moves wait in batches of bounded size, so memory does not grow with their number.
use glam::DVec3;

use super::cutter::{Cutter, Tip};
use super::report::{Place, Report};
use super::timing::Pace;
use super::turning::{Turn, Turning};
use super::{Batch, Blank, Cut, SKIN, Stock, StockTrouble};
use crate::engine::geometry::{Axis, Frame};
use crate::engine::machine::{Machine, Neck};
use crate::engine::report::event::{Event, EventKind, FindingKind, MoveKind, Turned};
use crate::engine::scene::Scene;
use crate::engine::solid::Path;
use crate::program::syntax::Program;

/// Moves that are carried out together.
pub(super) const TOGETHER: usize = 4096;
/// Pieces of moves that are carried out together, unless one move has more of them.
const MOST_PIECES: usize = 4 * TOGETHER;
/// Share of a cell between two poses of a tool over a turning table.
const STEP: f64 = 0.25;
/// More poses of one turn are not followed.
const MOST_POSES: f64 = 200_000.0;
/// Volume, mm³, below which nothing was cut.
pub(super) const NOTHING: f64 = 1e-6;

/// The farthest that a blank reaches from the axis of the table that it is clamped on.
fn reach(machine: &Machine, angles: DVec3, blank: &Blank) -> f64 {
    let Some(axis) = machine.clamped_on() else { return 0.0 };
    let (turning, [min, max]) = (machine.turning(axis, angles), blank.bounds);
    let corners = (0..8).map(|n| {
        let side = |bit: u32, low: f64, high: f64| if n & bit == 0 { low } else { high };
        let corner = DVec3::new(side(1, min.x, max.x), side(2, min.y, max.y), side(4, min.z, max.z));
        (blank.frame.point(corner) - turning.centre).reject_from(turning.direction).length()
    });
    corners.fold(0.0, f64::max)
}

/// A path in other coordinates.
pub(super) fn seen(frame: &Frame, path: &Path) -> Path {
    match *path {
        Path::Line { from, to } => Path::line(frame.point(from), frame.point(to)),
        Path::Arc { centre, axis, from, sweep, rise } => {
            Path::Arc { centre: frame.point(centre), axis: frame.vector(axis), from: frame.point(from), sweep, rise }
        }
    }
}

/// How the table turns.
struct TableTurn {
    /// The rotary axes before.
    before: DVec3,
    /// Degrees a minute.
    feed: f64,
    rapid: bool,
    /// Whether at the same time as the last move.
    together: bool,
}

/// Something that was found about the move of an event.
#[derive(Clone, Copy, Debug)]
pub(super) struct Found {
    /// The number of the event, from 1.
    pub event: u64,
    pub kind: FindingKind,
    pub amount: f64,
}

/// What is known of a move that waits for its cut.
struct Noted {
    event: u64,
    at: Place,
    rapid: bool,
    spindle_off: bool,
    length: f64,
    feed: f64,
    edges: f64,
}

/// A part that is being machined.
pub struct Machining {
    pub(super) stock: Stock,
    pub(super) batch: Batch,
    noted: Vec<Noted>,
    pace: Pace,
    pub(super) report: Report,
    necks: Vec<(f64, Neck)>,
    cutter: Option<Cutter>,
    /// The tool in the spindle that has no radius, and whether that was reported.
    unknown: Option<(f64, bool)>,
    /// What is turned.
    pub(super) turned: Turning,
    axis: Axis,
    turning: bool,
    machine: Machine,
    /// Machine coordinates of the rotary axes, at the start and now.
    angles: [DVec3; 2],
    /// From the machine to where the parts were at the start, if the table has turned.
    pub(super) parts: Option<Frame>,
    /// The last move, its length and its feed.
    last: Option<(Path, f64, f64)>,
    /// Whether the tool tip is held on the workpiece while rotary axes turn.
    tip_held: bool,
    /// The farthest that the blank reaches from the axis that it is clamped on.
    reach: f64,
    /// How many events were seen.
    seen: u64,
    /// What was found and not asked for yet, if someone asks.
    found: Option<Vec<Found>>,
    /// The events that have removed something and were not asked for yet, if someone asks.
    cuts: Option<Vec<u64>>,
}

impl Machining {
    /// Before the first event: the blank of the scene or the program, with cells at most as large as the resolution.
    ///
    /// # Errors
    /// There is no blank, or the resolution does not fit.
    pub fn new(program: &Program, scene: &Scene, resolution: Option<f64>) -> Result<Self, StockTrouble> {
        let blank = Blank::find(program, scene)?;
        let [min, max] = blank.bounds;
        // A two hundredth of the greatest extent shows what a part looks like.
        let resolution = resolution.unwrap_or((max - min).max_element() / 200.0);
        let stock = Stock::new(&blank.shape, blank.bounds, blank.frame, blank.axis, resolution)?;
        let report = Report { blank: stock.volume(), ..Report::default() };
        Ok(Self {
            stock,
            batch: Batch::default(),
            noted: Vec::new(),
            pace: Pace::new(&scene.machine),
            report,
            necks: scene.necks.clone(),
            cutter: None,
            unknown: None,
            turned: Turning::new(&blank, scene.frame),
            axis: scene.machine.spindle,
            turning: false,
            machine: scene.machine.clone(),
            angles: [scene.start_angles; 2],
            parts: None,
            last: None,
            tip_held: false,
            reach: reach(&scene.machine, scene.start_angles, &blank),
            seen: 0,
            found: None,
            cuts: None,
        })
    }

    /// Takes an event of the run.
    pub fn see(&mut self, event: &Event) {
        self.seen += 1;
        match &event.kind {
            EventKind::Spindle { tool, direction, .. } => {
                if let Some((tool, axis)) = tool {
                    let neck = self.necks.iter().find(|(number, _)| *number == tool.number).map(|(_, neck)| *neck);
                    self.cutter = Cutter::of_tool(tool, neck);
                    self.unknown = (self.cutter.is_none() && tool.probe.is_none()).then_some((tool.number, false));
                    self.turn_with(tool.number);
                    self.axis = *axis;
                    self.pace.stop();
                }
                self.turning = *direction != 0;
            }
            EventKind::Dwell(seconds) => {
                self.report.time_dwell += seconds;
                self.pace.stop();
            }
            EventKind::Turn { axes, feed, rapid, together } => {
                let [start, now] = &mut self.angles;
                let before = *now;
                *now = axes.iter().fold(*now, |angles, turned| turned.axis.with(angles, turned.machine));
                let (at_start, after) = (self.machine.table(*start), self.machine.table(*now));
                self.parts = (at_start != after).then(|| at_start.of(after.inverse()));
                let turn = TableTurn { before, feed: *feed, rapid: *rapid, together: *together };
                if !self.follow_turn(axes, &turn, &Place::of(&event.at)) && *together {
                    self.find(FindingKind::TurnsTogether, &Place::of(&event.at), 0.0, self.seen);
                }
                self.pace.stop();
            }
            EventKind::Insert(insert) => self.turn_with_insert(*insert),
            EventKind::Transform(now) => {
                self.tip_held = now.tip_held;
                self.turned.frame = now.frame();
            }
            EventKind::Probe(_) => self.pace.stop(),
            EventKind::Move { kind, feed, path, turned, .. } => {
                let rapid = matches!(kind, MoveKind::Rapid | MoveKind::Arc { rapid: true, .. });
                let length = path.length();
                self.report.moves += 1;
                *(if rapid { &mut self.report.length_rapid } else { &mut self.report.length_feed }) += length;
                self.pace.go(path, *feed, rapid);
                self.last = Some((*path, length, *feed));
                let at = Place::of(&event.at);
                if let (Some((number, reported)), false, None) = (self.unknown, rapid, turned) {
                    self.report.find(FindingKind::NoRadius, &at, number);
                    if let (Some(found), false) = (&mut self.found, reported) {
                        found.push(Found { event: self.seen, kind: FindingKind::NoRadius, amount: number });
                        self.unknown = Some((number, true));
                    }
                }
                if let Some(turned) = turned {
                    let stopped = turned.speed == 0.0;
                    self.follow_turned(path, Turn { event: self.seen, at, rapid, stopped, length, feed: *feed });
                    return;
                }
                self.end_turning();
                let Some(cutter) = self.in_effect() else { return };
                let (spindle_off, edges) = (!self.turning, cutter.edges);
                self.settle_if_many();
                // Whatever the spindle does, a move that stays out of the material must do so by more than rounding.
                let [_, angles] = self.angles;
                let (mut axis, mut path) = (self.machine.head(angles).vector(self.axis.unit()), *path);
                if let Some(parts) = &self.parts {
                    (axis, path) = (parts.vector(axis), seen(parts, &path));
                }
                self.stock.add(&mut self.batch, &path, axis, &cutter, rapid || spindle_off);
                self.noted.push(Noted { event: self.seen, at, rapid, spindle_off, length, feed: *feed, edges });
            }
            EventKind::End(_) => {
                self.pace.stop();
                self.settle();
            }
            _ => {}
        }
    }

    /// The tool as it meets the material now: while the spindle is stationary, the one edge of a side cutter goes where
    /// the program turned it, and only its neck must find room.
    fn in_effect(&self) -> Option<Cutter> {
        let cutter = self.cutter?;
        match cutter.neck {
            Some(neck) if !self.turning => Some(Cutter { radius: neck.radius, tip: Tip::Flat, neck: None, ..cutter }),
            _ => Some(cutter),
        }
    }

    /// Puts a finding into the report, and keeps it for those who watch.
    pub(super) fn find(&mut self, kind: FindingKind, at: &Place, amount: f64, event: u64) {
        self.report.find(kind, at, amount);
        if let Some(found) = &mut self.found {
            found.push(Found { event, kind, amount });
        }
    }

    /// Whether no move waits for its cut.
    pub(super) fn settled(&self) -> bool {
        self.batch.is_empty() && !self.turned.waits()
    }

    /// What was found since this was asked last; the first question makes findings be kept.
    pub(super) fn found(&mut self) -> Vec<Found> {
        let mut found = self.found.replace(Vec::new()).unwrap_or_default();
        found.sort_by_key(|found| found.event);
        found
    }

    /// The numbers of the events, from 1, whose moves have removed something since this was asked last, in their order;
    /// the first question makes them be kept.
    pub fn cuts(&mut self) -> Vec<u64> {
        self.settle();
        let mut cuts = self.cuts.replace(Vec::new()).unwrap_or_default();
        cuts.sort_unstable();
        cuts
    }

    /// Carries out the moves that wait.
    pub(super) fn settle(&mut self) {
        self.give_up_waiting();
        self.settle_columns();
    }

    /// Carries out the moves that wait in the columns.
    pub(super) fn settle_columns(&mut self) {
        let cuts = self.stock.carry_out(&mut self.batch);
        let noted = std::mem::take(&mut self.noted);
        let mut cuts = cuts.as_slice();
        // The poses of a turning table are one move.
        for pieces in noted.chunk_by(|one, next| one.event == next.event) {
            let (own, rest) = cuts.split_at(pieces.len().min(cuts.len()));
            cuts = rest;
            if let (Some(first), Some(cut)) = (pieces.first(), own.iter().copied().reduce(Cut::and)) {
                self.carried_out(&cut, first, pieces.iter().map(|piece| piece.length).sum());
            }
        }
        self.noted = noted;
        self.noted.clear();
    }

    /// The same if so many wait that this is time; the last one, to which a turn may belong, still waits afterwards.
    fn settle_if_many(&mut self) {
        if self.batch.len() >= TOGETHER || self.batch.pieces() >= MOST_PIECES {
            self.settle_columns();
        }
    }

    /// Follows the axis of the table on which the blank is clamped while it turns, alone or together with the last
    /// move. Whether that could be done.
    fn follow_turn(&mut self, axes: &[Turned], turn: &TableTurn, at: &Place) -> bool {
        let Some(clamped) = self.machine.clamped_on().copied() else { return false };
        let alone = matches!(axes, [one] if one.axis == clamped.axis) && !self.tip_held;
        let (Some((path, length, feed)), true) = (self.last, alone) else { return false };
        let [start, now] = self.angles;
        let way = (clamped.axis.of(now) - clamped.axis.of(turn.before)).to_radians().abs();
        // After a whole turn nothing more is met.
        let way = if turn.together { way } else { way.min(std::f64::consts::TAU) };
        let count = (way * self.reach / (STEP * self.stock.cell().min_element())).ceil().max(1.0);
        if count > MOST_POSES {
            return false;
        }
        let mut event = self.seen;
        if turn.together && self.noted.last().is_some_and(|noted| noted.event + 1 == event) {
            // That move has not gone straight through the material.
            event -= 1;
            self.noted.pop();
            self.batch.take_back();
        }
        let Some(cutter) = self.in_effect() else { return true };
        let (spindle_off, edges) = (!self.turning, cutter.edges);
        let minutes = if turn.together && feed > 0.0 { length / feed } else { way.to_degrees() / turn.feed };
        let mut before: Option<DVec3> = None;
        for n in 0..=count as usize {
            let share = n as f64 / count;
            let shown = if turn.together { share } else { 1.0 };
            let turned = turn.before + (now - turn.before) * share;
            let parts = self.machine.table(start).of(self.machine.table(turned).inverse());
            let tip = parts.point(path.at(shown));
            let axis = parts.vector(self.machine.head(now).vector(self.axis.unit()));
            let length = before.map_or(0.0, |before| before.distance(tip));
            before = Some(tip);
            self.settle_if_many();
            self.stock.add(&mut self.batch, &Path::line(tip, tip), axis, &cutter, turn.rapid || spindle_off);
            let feed = length * count / minutes;
            self.noted.push(Noted { event, at: at.clone(), rapid: turn.rapid, spindle_off, length, feed, edges });
        }
        true
    }

    fn carried_out(&mut self, cut: &Cut, noted: &Noted, length: f64) {
        if cut.volume <= NOTHING {
            return;
        }
        self.report.removed += cut.volume;
        if let Some(cuts) = &mut self.cuts {
            cuts.push(noted.event);
        }
        self.turned.is_milled();
        if noted.rapid {
            self.find(FindingKind::Rapid, &noted.at, cut.depth + SKIN, noted.event);
        } else if noted.spindle_off {
            self.find(FindingKind::SpindleStopped, &noted.at, cut.depth + SKIN, noted.event);
        }
        if noted.edges > 0.0 && cut.reach > noted.edges + SKIN {
            self.find(FindingKind::EdgesTooShort, &noted.at, cut.reach, noted.event);
        }
        if noted.rapid {
            return;
        }
        let report = &mut self.report;
        report.cuts += 1;
        report.length_cut += length;
        report.depth.note(cut.depth, noted.at.line);
        report.width.note(cut.width, noted.at.line);
        if length > 0.0 {
            report.rate.note(cut.volume / length * noted.feed, noted.at.line);
        }
    }

    /// The stock, without the moves that still wait.
    pub const fn stock(&self) -> &Stock {
        &self.stock
    }

    /// What is left, and the report.
    pub fn finish(mut self) -> (Stock, Report) {
        self.pace.stop();
        self.settle();
        self.end_turning();
        self.report.turned = self.turned.left();
        (self.report.time_feed, self.report.time_rapid) = (self.pace.feed, self.pace.rapid);
        (self.stock, self.report)
    }
}
