//! Follows what is turned: moves of the insert in turning, as events have them.
//!
//! Moves between a tool call and the first cycle wait, because that cycle says how the insert meets the workpiece.
//! Invariant: as soon as the part is no body of revolution any more, or it is not known how the insert meets it, a
//! finding says so, once for each tool call.
use super::Blank;
use super::follow::{Machining, NOTHING, TOGETHER};
use super::report::Place;
use super::turned::Body;
use super::{SKIN, Stock};
use crate::engine::geometry::Frame;
use crate::engine::machine::{Insert, InsertForm};
use crate::engine::region::section::Cell;
use crate::engine::region::sweep::TipWay;
use crate::engine::report::event::FindingKind;
use crate::engine::solid::{Path, Shaped};

/// A move in turning.
#[derive(Clone, Debug)]
pub(super) struct Turn {
    /// The number of its event.
    pub event: u64,
    pub at: Place,
    pub rapid: bool,
    /// Whether the workpiece does not turn.
    pub stopped: bool,
    pub length: f64,
    pub feed: f64,
}

/// What is turned, and with what.
pub(super) struct Turning {
    /// The body, as long as the part is one.
    body: Option<Body>,
    /// Whether something was turned, and whether the columns do not know of it yet.
    any: bool,
    is_newer: bool,
    /// From the program to the machine.
    pub frame: Frame,
    /// The number of the tool in the spindle.
    number: f64,
    /// How it meets the workpiece, and the same in the half plane.
    insert: Option<Insert>,
    shaped: Option<Shaped>,
    /// Where the last cut ended, if all that the insert covers there is gone.
    gone: Option<glam::DVec2>,
    /// Which findings there were since it was called.
    found: Vec<FindingKind>,
    /// Moves that wait until it is known how the insert meets the workpiece.
    waiting: Vec<(TipWay, f64, Turn)>,
}

impl Turning {
    /// Before the first event.
    pub(super) fn new(blank: &Blank, frame: Frame) -> Self {
        Self {
            body: Body::of(blank),
            any: false,
            is_newer: false,
            frame,
            number: 0.0,
            insert: None,
            shaped: None,
            gone: None,
            found: Vec::new(),
            waiting: Vec::new(),
        }
    }

    /// Whether moves wait.
    pub(super) const fn waits(&self) -> bool {
        !self.waiting.is_empty()
    }

    /// The part was milled: it is no body of revolution any more.
    pub(super) fn is_milled(&mut self) {
        self.body = None;
    }

    /// The half section of what is left, if something was turned and the part is still a body of revolution.
    pub(super) fn left(&self) -> Option<Vec<Cell>> {
        self.body.as_ref().filter(|_| self.any).map(|body| body.section.in_order())
    }

    /// Brings columns up to date.
    fn show(&mut self, stock: &mut Stock) {
        if let (Some(body), true) = (&self.body, self.is_newer) {
            stock.renew(&|point, up| body.along(point, up));
        }
        self.is_newer = false;
    }
}

impl Machining {
    /// Another tool is in the spindle.
    pub(super) fn turn_with(&mut self, number: f64) {
        self.give_up_waiting();
        let turned = &mut self.turned;
        (turned.number, turned.insert, turned.shaped, turned.gone) = (number, None, None, None);
        turned.found.clear();
    }

    /// The insert meets the workpiece like this from now on.
    pub(super) fn turn_with_insert(&mut self, insert: Insert) {
        (self.turned.insert, self.turned.shaped, self.turned.gone) = (Some(insert), None, None);
        for (way, sense, turn) in std::mem::take(&mut self.turned.waiting) {
            self.turn_along(way, sense, &turn);
        }
    }

    /// Nothing will say how the insert meets the workpiece on the moves that wait.
    pub(super) fn give_up_waiting(&mut self) {
        let waiting = std::mem::take(&mut self.turned.waiting);
        if let Some((_, _, turn)) = waiting.into_iter().find(|(_, _, turn)| !turn.rapid) {
            self.find_once(FindingKind::InsertUnknown, &turn);
        }
    }

    /// The part is not turned any more, at least for now.
    pub(super) fn end_turning(&mut self) {
        self.give_up_waiting();
        self.turned.show(&mut self.stock);
    }

    fn find_once(&mut self, kind: FindingKind, turn: &Turn) {
        if !self.turned.found.contains(&kind) {
            self.turned.found.push(kind);
            self.find(kind, &turn.at, self.turned.number, turn.event);
        }
    }

    /// Follows a move of the tip in turning, given in machine coordinates.
    pub(super) fn follow_turned(&mut self, path: &Path, turn: Turn) {
        if !self.batch.is_empty() {
            // Milling may end that the part is a body of revolution.
            self.settle_columns();
        }
        let (path, frame) = match &self.parts {
            None => (*path, self.turned.frame),
            Some(parts) => (super::follow::seen(parts, path), parts.of(self.turned.frame)),
        };
        let half = self.turned.body.as_ref().and_then(|body| body.half(&path, &frame));
        let Some(half) = half else {
            if !turn.rapid {
                self.find_once(FindingKind::Turned, &turn);
            }
            return;
        };
        if self.turned.insert.is_some() {
            self.turn_along(half.way, half.sense, &turn);
        } else {
            self.turned.waiting.push((half.way, half.sense, turn));
            if self.turned.waiting.len() > TOGETHER {
                self.give_up_waiting();
            }
        }
    }

    fn turn_along(&mut self, way: TipWay, sense: f64, turn: &Turn) {
        let Some(insert) = self.turned.insert else { return };
        if insert.form == InsertForm::Thread {
            if !turn.rapid {
                self.find_once(FindingKind::ThreadTurned, turn);
            }
            return;
        }
        let turned = &mut self.turned;
        let Some(body) = &mut turned.body else { return };
        let shaped = match &mut turned.shaped {
            Some(shaped) if shaped.has_sense(sense) => shaped,
            other => other.insert(Shaped::new(&insert, sense, SKIN)),
        };
        if !turned.any {
            turned.any = true;
            self.report.blank = body.section.volume();
        }
        let all = !turn.rapid && !turn.stopped;
        let from = match way {
            TipWay::Line { from, .. } | TipWay::Arc { from, .. } => from,
        };
        let joined = all && turned.gone.is_some_and(|gone| gone.distance(from) < 1e-10);
        let (done, behind) = shaped.cut(&mut body.section, way, all, joined);
        turned.gone = all.then(|| way.end());
        let volume = done.volume + behind.volume;
        if volume <= NOTHING {
            return;
        }
        turned.is_newer = true;
        self.report.removed += volume;
        if turn.rapid {
            self.find(FindingKind::Rapid, &turn.at, done.depth + SKIN, turn.event);
        } else if turn.stopped {
            self.find(FindingKind::SpindleStopped, &turn.at, done.depth + SKIN, turn.event);
        }
        if behind.volume > NOTHING {
            self.find(FindingKind::EdgesTooShort, &turn.at, behind.reach, turn.event);
        }
        if turn.rapid {
            return;
        }
        let report = &mut self.report;
        report.cuts += 1;
        report.length_cut += turn.length;
        report.width.note(done.width(), turn.at.line);
        if turn.length > 0.0 {
            report.rate.note(volume / turn.length * turn.feed, turn.at.line);
        }
    }
}
