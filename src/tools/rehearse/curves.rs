//! Curves of plain movements: one that begins within the blank, leaves it and comes back, and a contour that other blocks of
//! the same tool have gone before.
//!
//! Invariant: a curve is what one block draws, a whole circle or the movements of a loop; straight cuts from edge to edge
//! leave the blank with every line.
use std::collections::HashMap;

use glam::{DVec2, DVec3};

use super::body::{SAME, SKIN};
use super::watcher::Watcher;
use crate::check::Incident;

/// A loop that draws a curve makes so many movements.
const MANY: usize = 12;
/// So far outside of the blank, besides the radius of the tool, a curve has left it, mm.
const OUTSIDE: f64 = 1.0;
/// So many movements of a contour that others have made before make it the same one.
const LEAST: usize = 4;
/// So many movements are remembered.
const MOST: usize = 1 << 14;

/// The ends of a movement, hundredths of a millimetre.
type Ends = [i64; 6];

/// What is known of the curves.
#[derive(Default)]
pub(super) struct Curves {
    /// The block that draws now, and its height, hundredths of a millimetre.
    block: (usize, i64),
    count: usize,
    /// Whether it began in the blank, and where it was outside of it.
    inside: bool,
    left: Option<DVec3>,
    /// Where the tool went down last.
    entry: Option<DVec2>,
    /// The movements along contours, with the tool call: the line of each and where the tool went down before it.
    gone: HashMap<(u32, Ends), (usize, Option<DVec2>)>,
    /// So many of the last ones others have made before, of which the first line is this.
    again: (usize, usize),
}

impl Watcher<'_> {
    /// Notes where the tool goes down.
    pub(super) fn note_entry(&mut self, from: DVec3) {
        let flat = self.at.truncate();
        if (flat - from.truncate()).length() <= SAME && self.at.z < from.z - SAME {
            self.curves.entry = Some(flat);
        }
    }

    /// Notes a plain movement at feed with places on it.
    pub(super) fn note_curve(&mut self, from: DVec3, line: usize, round: &[DVec3]) {
        let Some(body) = self.body.filter(|_| self.width().is_some() && !self.is_compensated()) else { return };
        let radius = self.radius();
        let level = (from.z - self.at.z).abs() <= SAME && self.at.z < body.high.z - SKIN;
        let block = (line, (self.at.z / SAME).round() as i64);
        if !level || self.curves.block != block {
            self.curves.block = block;
            (self.curves.count, self.curves.left) = (0, None);
            self.curves.inside = body.is_within(from, radius);
        }
        if !level {
            return;
        }
        self.curves.count += 1;
        let outside = |place: &&DVec3| body.distance(**place) > radius + OUTSIDE;
        self.curves.left = self.curves.left.or(round.iter().find(outside).copied());
        let far = round.iter().map(|place| (*place - from).truncate().length()).fold(0.0, f64::max);
        let circle = far > SAME && (self.at - from).truncate().length() <= SAME;
        let back = body.is_within(self.at, radius) && (circle || self.curves.count >= MANY);
        if let Some(place) = self.curves.left.filter(|_| self.curves.inside && back) {
            self.report(self.line, Incident::CurveLeavesBlank([place.x * self.unit, place.y * self.unit]));
        }
    }

    /// Notes a plain movement along a contour: whether blocks elsewhere have made it before, after the tool had gone down at
    /// another place. What is cut once more to remove what the tool has left begins where it began before.
    pub(super) fn note_contour(&mut self, from: DVec3, line: usize) {
        let top = self.top().unwrap_or(f64::NEG_INFINITY);
        if !self.is_compensated() || self.at.z >= top - SKIN || (self.at - from).truncate().length() <= SAME {
            self.curves.again = (0, 0);
            return;
        }
        let ends = [from, self.at].map(|place| (place / SAME).to_array().map(|own| own.round() as i64));
        let [[a, b, c], [d, e, f]] = ends;
        let (key, entry) = ((self.calls, [a, b, c, d, e, f]), self.curves.entry);
        let other = self.curves.gone.get(&key).is_some_and(|(own, before)| {
            let apart = entry.zip(*before).is_some_and(|(one, other)| (one - other).length() > 2.0 * self.radius());
            *own != line && apart
        });
        if !other {
            self.curves.again = (0, 0);
            if self.curves.gone.len() < MOST {
                self.curves.gone.entry(key).or_insert((line, entry));
            }
            return;
        }
        let (count, first) = self.curves.again;
        self.curves.again = (count + 1, if count == 0 { line } else { first });
        if count + 1 == LEAST {
            let first = self.curves.again.1;
            self.report(first, Incident::ContourCopied);
        }
    }
}
