//! What plain movements at feed have done since the last tool call, or under one transformation: whether they stay above
//! the blank, and whether they go where the same tool has been under another transformation.
use std::collections::HashSet;

use glam::DVec3;

use super::body::Body;
use super::watcher::{SAME, SKIN, Watcher};
use crate::check::Incident;
use crate::engine::run::Coordinates;

/// So many movements make a path that is compared.
const LEAST: usize = 4;
/// So many movements are remembered.
const MOST: usize = 4_096;

/// A movement, whichever way it goes.
type Stroke = [[i64; 3]; 2];

/// The plain movements of a tool.
#[derive(Default)]
pub(super) struct Ways {
    /// The line of the first movement that goes along the blank, and the lowest height of all.
    along: Option<usize>,
    lowest: Option<f64>,
    /// Under other transformations, and under the one in effect with the line of the first.
    before: HashSet<Stroke>,
    now: HashSet<Stroke>,
    first: Option<usize>,
    /// The transformation in effect, without its datum shift along the tool axis.
    transformation: Option<[[i64; 4]; 3]>,
}

impl Ways {
    /// Notes a movement at feed.
    pub(super) fn note(&mut self, line: usize, from: DVec3, to: DVec3, body: &Body) {
        let flat = (to - from).truncate().length() > SAME;
        if flat {
            self.lowest = Some(self.lowest.map_or(to.z, |lowest| lowest.min(to.z)).min(from.z));
        }
        if flat && body.distance(to) <= 0.0 {
            self.along.get_or_insert(line);
        }
        if flat && to.z < body.high.z - SKIN && self.now.len() + self.before.len() < MOST {
            let mut ends = [from, to].map(|own| own.to_array().map(|value| (value / SAME).round() as i64));
            ends.sort_unstable();
            self.now.insert(ends);
            self.first.get_or_insert(line);
        }
    }
}

impl Watcher<'_> {
    /// The tool call is over: whether its movements have only gone along above the blank.
    pub(super) fn judge_ways(&mut self) {
        self.compare();
        let ways = std::mem::take(&mut self.ways);
        let (Some(line), Some(lowest), Some(top)) = (ways.along, ways.lowest, self.top()) else { return };
        if lowest > top + SKIN && !self.away() {
            self.report(line, Incident::AboveBlank(lowest * self.unit));
        }
    }

    /// Coordinates mean something else from here on.
    pub(super) fn transformed(&mut self, now: &Coordinates) {
        let rows = now.matrix.map(|row| row.map(|own| (own / SAME).round() as i64));
        if self.ways.transformation != Some(rows) {
            self.compare();
            self.ways.transformation = Some(rows);
        }
    }

    /// Whether all that was done under the transformation in effect was done before under others.
    fn compare(&mut self) {
        let (now, first) = (std::mem::take(&mut self.ways.now), self.ways.first.take());
        if let Some(line) = first
            && now.len() >= LEAST
            && now.iter().all(|own| self.ways.before.contains(own))
            && !self.away()
        {
            self.report(line, Incident::PathTwice);
        }
        self.ways.before.extend(now);
    }
}
