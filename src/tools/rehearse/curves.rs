//! Curves of plain movements: one that begins within the blank, leaves it and comes back, and a contour that other blocks of
//! the same tool have gone before.
//!
//! Invariant: a curve is what one block draws, an arc or the movements of a loop; straight cuts from edge to edge
//! leave the blank with every line.
use glam::{DVec2, DVec3};

use super::body::{SAME, SKIN};
use super::watcher::Watcher;
use crate::check::{Incident, Observed};

/// A loop that draws a curve makes so many movements.
const MANY: usize = 12;
/// So far outside of the blank, besides the radius of the tool, a curve has left it, mm.
const OUTSIDE: f64 = 1.0;
/// So many movements of a contour that others have made before make it the same one.
const LEAST: usize = 4;
/// So many movements are remembered.
const MOST: usize = 1 << 14;
/// So many heights of contours are remembered, and so many places between lines.
const MOST_HEIGHTS: usize = 1 << 11;
const MOST_RIBS: usize = 1 << 8;
/// Lines that are farther apart than so many diameters are meant to leave something between them.
const FARTHEST: f64 = 2.0;

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
        let Some(body) = self.body.filter(|_| self.width().is_some()) else { return };
        let radius = self.radius();
        let level = (from.z - self.at.z).abs() <= SAME && self.at.z < body.high.z - SKIN;
        let block = (line, (self.at.z / SAME).round() as i64);
        if !level || self.curves.block != block || self.curves.count == 0 {
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
        let way = self.at - from;
        let bent = |place: &DVec3| {
            let off = (*place - from).truncate();
            off.length() > way.truncate().length() + SAME || off.perp_dot(way.truncate()).abs() > radius * way.length()
        };
        let arc = round.iter().any(bent);
        let loops = self.curves.count >= MANY && !self.is_compensated();
        let back = body.is_within(self.at, radius) && (arc || loops);
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
        if self.curves.heights.len() < MOST_HEIGHTS {
            self.curves.heights.insert((line, self.called, (self.at.z / SAME).round() as i64));
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

    /// Notes a plain movement at feed: lines to and fro from edge to edge, with equal steps between them.
    pub(super) fn note_lines(&mut self, from: DVec3) {
        let Some(body) = self.body else { return };
        let level = (from.z - self.at.z).abs() <= SAME && (self.at - from).truncate().length() > SAME;
        let joined = self.curves.lines.last().is_none_or(|[_, end]| (*end - from).length() <= SAME);
        if !level || !joined {
            self.curves.lines.clear();
        }
        if !level {
            return;
        }
        self.curves.lines.push([from, self.at]);
        let Some(width) = self.width() else { return };
        let Some([one, step, two, other, three]) = self.curves.lines.last_chunk::<5>() else { return };
        let way = |own: &[DVec3; 2]| (own[1] - own[0]).truncate();
        let opposite = |a: &[DVec3; 2], b: &[DVec3; 2]| (way(a) + way(b)).length() <= SAME;
        let across = |own: &[DVec3; 2]| own.iter().all(|end| body.distance(*end) > 0.0);
        let far = way(step).length();
        let square = way(one).dot(way(step)).abs() <= SAME * way(one).length();
        let lines = opposite(one, two) && opposite(two, three) && [one, two, three].into_iter().all(across);
        let steps = (way(step) - way(other)).length() <= SAME && square;
        if lines && steps && far > width + SAME && far < FARTHEST * width && self.curves.ribs.len() < MOST_RIBS {
            let place = (one[0] + one[1] + two[0] + two[1]) / 4.0;
            self.curves.ribs.push((self.line, place, [far, width]));
        }
        if self.curves.lines.len() > 5 {
            self.curves.lines.remove(0);
        }
    }

    /// The program is over: what is left between such lines, and how deep contours were machined.
    pub(super) fn judge_curves(&mut self) {
        let ribs = std::mem::take(&mut self.curves.ribs);
        let left = |place: DVec3| !self.remains.open && self.is_solid(place + DVec3::Z * (2.0 * SKIN));
        if let Some((line, _, [step, width])) = ribs.into_iter().find(|(_, place, _)| left(*place)) {
            self.report(line, Incident::RibsLeft { step: step * self.unit, width: width * self.unit });
        }
        for (line, call, height) in std::mem::take(&mut self.curves.heights) {
            let height = height as f64 * SAME * self.unit;
            self.found.push(Observed { line, incident: Incident::ContourAt { line, call, height } });
        }
    }

    /// The only hole of a tool, where nothing else is done, if a pocket without a hole is at the exchanged coordinates.
    pub(super) fn beside_pocket(&self, single: &[[f64; 2]], holes: &[[f64; 2]]) -> Option<[f64; 2]> {
        let near = |one: DVec2, other: DVec2| (one - other).length() <= 5.0 * SAME;
        let inside = |place: DVec2| self.areas.iter().any(|own| own.distance(place) <= own.radius);
        single.iter().copied().find(|[x, y]| {
            let (place, swapped) = (DVec2::new(*x, *y), DVec2::new(*y, *x));
            let alone = holes.iter().filter(|own| near(DVec2::from(**own), place)).count() == 1;
            let pocket = self.areas.iter().any(|own| near(own.middle(), swapped));
            let hole = holes.iter().any(|own| near(DVec2::from(*own), swapped));
            !near(place, swapped) && alone && pocket && !hole && !inside(place)
        })
    }
}
