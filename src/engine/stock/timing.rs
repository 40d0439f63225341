//! How long the moves take on a machine that accelerates.
//!
//! Axes accelerate evenly, each at its own rate. A corner is passed at the speed at which the path may be rounded by
//! [`CORNER`]; what changes the spindle or waits makes the machine stop. The control looks ahead over the moves that
//! are queued here. Invariant: memory does not grow with the number of moves.
use glam::DVec3;

use crate::engine::machine::Machine;
use crate::engine::solid::Path;

/// Moves that are looked ahead over.
const AHEAD: usize = 300;
/// How far a corner may be rounded, mm.
const CORNER: f64 = 0.01;

/// A move that waits for its time.
#[derive(Clone, Copy, Debug)]
struct Waiting {
    length: f64,
    /// mm/s.
    speed: f64,
    /// mm/s² along the path.
    gain: f64,
    /// The greatest speed at its start that the corner allows.
    entry: f64,
    rapid: bool,
}

/// The clock.
#[derive(Clone, Debug)]
pub(super) struct Pace {
    /// Acceleration by axis, mm/s².
    gains: DVec3,
    queue: Vec<Waiting>,
    /// Direction at the end of the last move; nothing while the machine is at rest.
    heading: Option<DVec3>,
    /// The speed at the start of the queue.
    speed: f64,
    /// Seconds at feed and at rapid traverse.
    pub feed: f64,
    pub rapid: f64,
}

impl Pace {
    pub(super) fn new(machine: &Machine) -> Self {
        let gain = |axis| machine.axis(axis).map_or(f64::INFINITY, |axis| axis.acceleration);
        let [x, y, z] = crate::engine::geometry::Axis::ALL.map(gain);
        let (gains, queue) = (DVec3::new(x, y, z), Vec::with_capacity(AHEAD));
        Self { gains, queue, heading: None, speed: 0.0, feed: 0.0, rapid: 0.0 }
    }

    /// A move with its feed in mm/min.
    pub(super) fn go(&mut self, path: &Path, feed: f64, rapid: bool) {
        let length = path.length();
        if length <= 0.0 || feed <= 0.0 {
            return;
        }
        let (first, last, radius) = headings(path);
        let mut speed = feed / 60.0;
        let gain = match radius {
            None => self.along(first),
            Some(radius) => {
                let gain = self.gains.min_element();
                speed = speed.min((gain * radius).sqrt());
                gain
            }
        };
        let entry = self.heading.map_or(0.0, |before| self.corner(before, first, gain).min(speed));
        let entry = self.queue.last().map_or(entry, |before| entry.min(before.speed));
        if self.queue.len() == AHEAD {
            self.plan(AHEAD / 2);
        }
        self.queue.push(Waiting { length, speed, gain, entry, rapid });
        self.heading = Some(last);
    }

    /// The machine is still.
    pub(super) fn stop(&mut self) {
        self.plan(self.queue.len());
        self.heading = None;
        self.speed = 0.0;
    }

    /// Acceleration along a direction.
    fn along(&self, way: DVec3) -> f64 {
        let share = |gain: f64, part: f64| if part == 0.0 { f64::INFINITY } else { gain / part.abs() };
        share(self.gains.x, way.x).min(share(self.gains.y, way.y)).min(share(self.gains.z, way.z))
    }

    /// The speed in a corner: that of an arc which the path between its legs would have within [`CORNER`].
    fn corner(&self, before: DVec3, after: DVec3, gain: f64) -> f64 {
        let cos = before.dot(after).clamp(-1.0, 1.0);
        // Half the angle between the legs of the corner.
        let half = (0.5 * (1.0 + cos)).sqrt();
        if half > 1.0 - 1e-12 {
            return f64::INFINITY;
        }
        (gain * CORNER * half / (1.0 - half)).sqrt()
    }

    /// Gives the first moves of the queue their times.
    fn plan(&mut self, count: usize) {
        // From the end, where the machine must be able to be: how fast each move may begin.
        let mut next = 0.0;
        let mut entries = vec![0.0; self.queue.len() + 1];
        for (move_, entry) in self.queue.iter().zip(&mut entries).rev() {
            let most = (next * next + 2.0 * move_.gain * move_.length).sqrt();
            next = most.min(move_.entry);
            *entry = next;
        }
        for (n, move_) in self.queue.drain(..count).enumerate() {
            let wanted = entries.get(n + 1).copied().unwrap_or(0.0);
            let (start, gain) = (self.speed, move_.gain);
            let end = wanted.min((start * start + 2.0 * gain * move_.length).sqrt());
            let peak = (0.5 * (start * start + end * end) + gain * move_.length).sqrt().min(move_.speed.max(start));
            let way = |v: f64| (peak * peak - v * v) / (2.0 * gain);
            let even = (move_.length - way(start) - way(end)).max(0.0);
            let time = (peak - start) / gain + (peak - end) / gain + even / peak;
            *(if move_.rapid { &mut self.rapid } else { &mut self.feed }) += time;
            self.speed = end;
        }
    }
}

/// The directions at start and end, and the radius of an arc.
fn headings(path: &Path) -> (DVec3, DVec3, Option<f64>) {
    match *path {
        Path::Line { from, to } => {
            let way = (to - from).normalize_or_zero();
            (way, way, None)
        }
        Path::Arc { centre, axis, from, sweep, rise } => {
            let axis = axis.normalize_or_zero();
            let arm = from - centre;
            let x = arm - axis * arm.dot(axis);
            let y = axis.cross(x);
            let angle = sweep.to_radians();
            let (s, c) = (libm::sin(angle), libm::cos(angle));
            let climb = axis * rise;
            (
                (y * angle + climb).normalize_or_zero(),
                ((y * c - x * s) * angle + climb).normalize_or_zero(),
                Some(x.length()),
            )
        }
    }
}
