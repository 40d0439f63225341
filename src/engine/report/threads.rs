//! Threads recognised in the events of a run: what was cut follows from the way of the tool and the turning of the
//! spindle, and from no parameter.
//!
//! A thread is milled by helices of whole turns that are joined and left on half turns rising with them by half a
//! pitch. It is tapped by moves on one line, in at a feed that belongs to the speed and out again with the spindle
//! reversed. Invariant: one thread is reported for all passes on it, when the tool goes on to something else.
use glam::DVec3;

use crate::engine::report::event::{At, Event, EventKind, MoveKind, Threaded};
use crate::engine::solid::Path;

/// Lengths, in mm, and shares of a pitch that differ by less are the same.
const SAME: f64 = 1e-6;
/// Degrees by which calculation may miss a half or whole turn.
const TURN: f64 = 1e-6;

/// Moves of a tap on one line.
#[derive(Clone, Copy, Debug)]
struct Tap {
    /// Where it began and how far it went in, program coordinates.
    from: DVec3,
    deepest: DVec3,
    /// Where it is now, machine coordinates.
    now: DVec3,
    /// The direction in, and how the spindle turns on the way in.
    way: DVec3,
    turning: i8,
    /// How far in it is, and was.
    depth: f64,
    greatest: f64,
    pitch: f64,
    /// Ways in, and whether it came back.
    passes: u32,
    inwards: bool,
    back: bool,
}

/// A half turn that may join a thread, or a helix that waits for the one that leaves it.
#[derive(Clone, Copy, Debug)]
enum Helix {
    Joined { centre: DVec3, end: DVec3, rise: f64 },
    Milled { thread: Threaded, end: DVec3, phase: f64, half: f64 },
}

/// What was seen so far.
#[derive(Clone, Debug, Default)]
pub(crate) struct Threads {
    radius: f64,
    axis: DVec3,
    turning: i8,
    speed: f64,
    tap: Option<Tap>,
    helix: Option<Helix>,
    /// A thread that may go on, with the height of its groove in the direction of the main axis.
    pending: Option<(Threaded, f64)>,
    /// Where the last pass was.
    at: At,
}

impl Threads {
    /// Takes an event before it is reported. The thread that it ends.
    pub(crate) fn see(&mut self, event: &Event) -> Option<Event> {
        match &event.kind {
            EventKind::Move { kind: MoveKind::Feed, from, to, feed, path, .. } => {
                self.helix = None;
                self.along([*from, *to], *feed, path, &event.at)
            }
            EventKind::Move {
                kind: MoveKind::Arc { centre, plane, angle, rise, rapid: false }, from, path, ..
            } => {
                let tapped = self.end_of_tap();
                let flat = plane.flat(*from - *centre);
                let program = [plane.tool.of(*centre), *rise, *angle, libm::atan2(flat.y, flat.x).to_degrees()];
                let ends = [*centre, *centre + plane.tool.unit() * *rise];
                let ended = self.around(path, ends, program, &event.at);
                tapped.or(ended)
            }
            EventKind::Move { .. } | EventKind::Turn { .. } | EventKind::Transform(_) | EventKind::Probe(_) => {
                self.end()
            }
            EventKind::Error(_) | EventKind::End(_) => self.end(),
            EventKind::Spindle { tool, direction, speed, .. } => {
                let ended = if tool.is_some() || *direction == 0 { self.end() } else { None };
                (self.turning, self.speed) = (*direction, *speed);
                if let Some((tool, axis)) = tool {
                    (self.radius, self.axis) = (tool.radius, axis.unit());
                }
                ended
            }
            _ => None,
        }
    }

    fn end(&mut self) -> Option<Event> {
        self.helix = None;
        self.end_of_tap().or_else(|| self.end_of_milling())
    }

    fn event(&self, thread: Threaded) -> Event {
        Event { at: self.at.clone(), kind: EventKind::Thread(thread) }
    }

    fn end_of_milling(&mut self) -> Option<Event> {
        self.pending.take().map(|(thread, _)| self.event(thread))
    }

    fn end_of_tap(&mut self) -> Option<Event> {
        let tap = self.tap.take().filter(|tap| tap.back)?;
        let inwards = tap.way.dot(self.axis);
        let (top, bottom) = if inwards < 0.0 { (tap.from, tap.deepest) } else { (tap.deepest, tap.from) };
        // A right-hand thread goes away from the spindle while that turns clockwise.
        let right = (inwards < 0.0) == (tap.turning > 0);
        let (diameter, pitch, passes) = (2.0 * self.radius, tap.pitch, tap.passes);
        Some(self.event(Threaded { milled: false, outside: false, right, diameter, pitch, top, bottom, passes }))
    }

    /// A straight move at a feed.
    fn along(&mut self, [from, to]: [DVec3; 2], feed: f64, path: &Path, at: &At) -> Option<Event> {
        let Path::Line { from: start, to: end } = *path else { return None };
        let pitch = feed / self.speed;
        let way = end - start;
        let goes_on = |tap: &Tap| {
            let along = way.dot(tap.way);
            let turning = if along > 0.0 { tap.turning } else { -tap.turning };
            (start - tap.now).length() < SAME
                && (way - tap.way * along).length() < SAME
                && turning == self.turning
                && (pitch - tap.pitch).abs() < SAME * tap.pitch
        };
        if let Some(tap) = self.tap.as_mut().filter(|tap| goes_on(tap)) {
            let along = way.dot(tap.way);
            tap.now = end;
            tap.depth += along;
            if along < 0.0 {
                tap.back = true;
                self.at = at.clone();
            } else if !tap.inwards {
                tap.passes += 1;
            }
            tap.inwards = along > 0.0;
            if tap.depth > tap.greatest {
                (tap.greatest, tap.deepest) = (tap.depth, to);
            }
            return None;
        }
        let ended = self.end_of_tap();
        if self.turning != 0 && self.speed > 0.0 && self.radius > 0.0 {
            let depth = way.length();
            let (way, turning) = (way / depth, self.turning);
            let tap = Tap {
                from,
                deepest: to,
                now: end,
                way,
                turning,
                depth,
                greatest: depth,
                pitch,
                passes: 1,
                inwards: true,
                back: false,
            };
            self.tap = Some(tap);
        }
        ended
    }

    /// An arc at a feed. In program coordinates: the ends of its axis, and the height, rise, angle and first direction.
    fn around(
        &mut self,
        path: &Path,
        ends: [DVec3; 2],
        [height, climb, angle, first]: [f64; 4],
        at: &At,
    ) -> Option<Event> {
        let before = self.helix.take();
        let Path::Arc { centre, from, sweep, rise, .. } = *path else { return None };
        if rise == 0.0 {
            return None;
        }
        let end = path.at(1.0);
        if (sweep.abs() - 180.0).abs() < TURN {
            if let Some(Helix::Milled { thread, end: left, phase, half }) = before
                && (left - from).length() < SAME
                && (rise - half).abs() < SAME
            {
                self.at = at.clone();
                return self.add(thread, phase);
            }
            self.helix = Some(Helix::Joined { centre, end, rise });
            return None;
        }
        let Some(Helix::Joined { centre: beside, end: joined, rise: half }) = before else { return None };
        let turns = sweep.abs() / 360.0;
        let pitch = rise.abs() / turns;
        let whole = turns > 1.0 - TURN && (joined - from).length() < SAME;
        if !whole || (half.abs() - pitch / 2.0).abs() > SAME || half * rise < 0.0 {
            return None;
        }
        let arm = from - centre;
        // The half turn lies on the side of the thread from which the tool came.
        let outside = (beside - from).dot(centre - from) < 0.0;
        let radius = if outside { arm.length() - self.radius } else { arm.length() + self.radius };
        let [low, high] = ends;
        let (top, bottom) = if climb > 0.0 { (high, low) } else { (low, high) };
        let right = sweep * rise > 0.0;
        let thread = Threaded { milled: true, outside, right, diameter: 2.0 * radius, pitch, top, bottom, passes: 1 };
        let turn = climb * 360.0 / angle;
        let phase = (height - turn * first / 360.0) / turn.abs();
        self.helix = Some(Helix::Milled { thread, end, phase, half });
        None
    }

    /// A pass on a thread, which may be one that was there before. The thread that is finished by that.
    fn add(&mut self, pass: Threaded, phase: f64) -> Option<Event> {
        if let Some((thread, known)) = &mut self.pending {
            let near = |a: f64, b: f64| (a - b).abs() < SAME;
            let shift = thread.top - pass.top;
            let up = (thread.top - thread.bottom).normalize_or_zero();
            let across = shift - up * shift.dot(up);
            let offset = phase - *known;
            let same = thread.outside == pass.outside
                && thread.right == pass.right
                && near(thread.diameter, pass.diameter)
                && near(thread.pitch, pass.pitch)
                && across.length() < SAME
                && near(offset, offset.round());
            if same {
                if pass.top.dot(up) > thread.top.dot(up) {
                    thread.top = pass.top;
                }
                if pass.bottom.dot(up) < thread.bottom.dot(up) {
                    thread.bottom = pass.bottom;
                }
                thread.passes += 1;
                return None;
            }
        }
        let before = self.end_of_milling();
        self.pending = Some((pass, phase));
        before
    }
}
