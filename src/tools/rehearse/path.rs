//! What plain movements at feed have done since the last tool call, or under one transformation: whether they stay above
//! the blank, and whether they go where the same tool has been under another transformation.
use glam::DVec3;

use super::body::{SAME, SKIN};
use super::watcher::Watcher;
use super::ways::{MOST, Stroke, TURN};
use crate::check::Incident;
use crate::engine::run::Coordinates;

/// So many movements make a path that is compared.
const LEAST: usize = 4;
/// The width of a tool that is not known, mm.
const WIDE: f64 = 25.0;
/// So many times the slowest feed through material is a digit too many, if it is more than this part of the diameter for
/// each revolution.
const TENFOLD: f64 = 9.5;
const MOST_OF_DIAMETER: f64 = 0.15;

impl Watcher<'_> {
    /// The tool call is over: whether its movements have only gone along above the blank.
    pub(super) fn judge_ways(&mut self) {
        self.compare();
        let ways = std::mem::take(&mut self.ways);
        self.judge_feeds(&ways.feeds);
        if let Some(count) = ways.lacks_one() {
            self.report(self.line, Incident::RotationsLackOne(count));
        }
        if let Some((line, at)) =
            ways.below.filter(|_| !ways.meets && !ways.cycles && ways.deep >= LEAST && !self.away())
        {
            self.report(line, Incident::OutsideBlank([at.x * self.unit, at.y * self.unit]));
        }
        let (Some(line), Some(lowest), Some(top)) = (ways.along, ways.lowest, self.top()) else { return };
        if lowest > top + SKIN && !ways.cycles && !self.away() {
            self.report(line, Incident::AboveBlank(lowest * self.unit));
        }
    }

    /// Notes how high a movement along a contour goes: one that the same tool has made below the top of the blank before, and
    /// makes above it now, removes nothing.
    pub(super) fn note_height(&mut self, from: DVec3, line: usize) {
        /// So far above the blank it is certainly in the air, mm.
        const ABOVE: f64 = 1.0;
        let flat = (self.at - from).truncate().length() > SAME && (self.at.z - from.z).abs() <= SAME;
        let (Some(body), true) = (self.body, flat && self.is_compensated()) else { return };
        let key = (self.calls, line);
        if self.at.z < body.high.z - SKIN && self.lines_cut.len() < MOST {
            self.lines_cut.insert(key);
        } else if self.at.z > body.high.z + ABOVE && self.lines_cut.contains(&key) {
            self.report(self.line, Incident::PassInAir(self.at.z * self.unit));
        }
    }

    /// Notes a movement of a block: one that goes through material, and then twice more the same way, does nothing. One that has
    /// found nothing the first time, along most of the blank and below its top, does nothing either.
    pub(super) fn note_pass(&mut self, from: DVec3, line: usize, places: &[DVec3]) {
        /// So many ways are remembered, and so often one is gone.
        const MOST_PASSES: usize = 1 << 14;
        const OFTEN: u8 = 3;
        const IN_AIR: u8 = 5;
        let ends = [from, self.at].map(|place| (place / SAME).to_array().map(|own| own.round() as i64));
        let [[a, b, c], [d, e, f]] = ends;
        let key = (self.calls, line, [a, b, c, d, e, f]);
        let cuts = !self.remains.open && places.iter().any(|place| self.is_solid(*place));
        if (self.at - from).truncate().length() <= SAME {
            return;
        }
        let along = self.body.is_some_and(|body| {
            let plan = (body.high - body.low).truncate().max_element();
            (self.at - from).truncate().length() >= plan / 2.0 && self.at.z.max(from.z) < body.high.z - SKIN
        });
        if let Some((count, often)) = self.passes.get_mut(&key) {
            *count = count.saturating_add(1);
            if *count == *often {
                self.report(self.line, Incident::PathRepeated);
            }
        } else if (cuts || along) && self.passes.len() < MOST_PASSES {
            self.passes.insert(key, (1, if cuts { OFTEN } else { IN_AIR }));
        }
    }

    /// A feed that is ten times another one of the tool, and far more per revolution than it takes.
    fn judge_feeds(&mut self, feeds: &[([f64; 2], usize)]) {
        let Some(width) = self.width().filter(|width| *width > 0.0) else { return };
        let slowest = feeds.iter().map(|([own, _], _)| *own).fold(f64::INFINITY, f64::min);
        let fastest = feeds.iter().max_by(|one, other| one.0[0].total_cmp(&other.0[0]));
        if let Some(([fastest, turn], line)) = fastest.copied()
            && fastest >= TENFOLD * slowest
            && turn > MOST_OF_DIAMETER * width
        {
            self.report(line, Incident::TenfoldFeed(fastest / slowest));
        }
    }

    /// Coordinates mean something else from here on.
    pub(super) fn transformed(&mut self, now: &Coordinates) {
        self.ways.rotation = ((now.rotation * 100.0).round() as i64).rem_euclid(TURN);
        let rows = now.matrix.map(|row| row.map(|own| (own / SAME).round() as i64));
        if self.ways.transformation != Some(rows) {
            self.compare();
            self.ways.transformation = Some(rows);
        }
    }

    /// Whether a movement under a mirror image or a rotation about a place of the blank lies wholly beside the blank: then it
    /// is the other axis that had to be mirrored, and not another workpiece that is machined.
    fn is_mirrored_beside(&self, (_, ends): &Stroke) -> bool {
        let (Some(body), Some(rows)) = (self.body, self.ways.transformation) else { return false };
        let radius = self.width().unwrap_or(WIDE) / 2.0;
        let one = (1.0 / SAME) as i64;
        let turned = rows[0][0] != one || rows[1][1] != one;
        let [low, high] = [body.low.to_array(), body.high.to_array()];
        let on_blank = (0..2).all(|axis| {
            let origin = rows[axis][3] as f64 * SAME;
            (low[axis] - SKIN..=high[axis] + SKIN).contains(&origin)
        });
        let beside = (0..2).any(|axis| {
            let [from, to] = [ends[axis], ends[axis + 3]].map(|own| own as f64 * SAME);
            from.max(to) + radius < low[axis] || from.min(to) - radius > high[axis]
        });
        turned && on_blank && beside
    }

    /// Whether all that was done under the transformation in effect was done before under others.
    fn compare(&mut self) {
        let (now, first) = (std::mem::take(&mut self.ways.now), self.ways.first.take());
        let strokes = std::mem::take(&mut self.ways.strokes);
        let cuts = std::mem::take(&mut self.ways.cuts);
        let one = (1.0 / SAME) as i64;
        let plain = [[one, 0, 0, 0], [0, one, 0, 0], [0, 0, one, 0]];
        if let Some(line) = first
            && (strokes.len() >= LEAST && self.ways.covers(&now)
                || strokes.iter().all(|own| self.ways.done.contains(own)))
            && !self.away()
        {
            self.report(line, Incident::PathTwice);
        } else if let Some(line) = first
            .filter(|_| !cuts && !self.away())
            .filter(|_| strokes.len() >= LEAST || strokes.iter().all(|own| self.is_mirrored_beside(own)))
        {
            let again = strokes.iter().all(|(own, _)| self.ways.cutting.contains(own));
            let other = |own: [[i64; 4]; 3]| own != plain && !self.ways.transformations.contains(&own);
            if again && self.ways.transformation.is_some_and(other) {
                self.report(line, Incident::PathInAir);
            }
        }
        if cuts {
            self.ways.cutting.extend(strokes.iter().map(|(line, _)| *line));
        }
        if !strokes.is_empty() {
            self.ways.transformations.extend(self.ways.transformation);
        }
        self.ways.before.extend(now);
        self.ways.done.extend(strokes);
    }
}
