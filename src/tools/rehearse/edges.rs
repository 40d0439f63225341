//! Walls that open contours leave at the edge of the blank: the tool goes along an edge on the wrong side of the
//! contour, and the step that was to be there stands as a wall.
//!
//! Invariant: only material that is there at the end of the program, on both sides of a way that the tool has gone only once
//! in the plane.
use glam::DVec3;

use super::body::{SAME, SKIN};
use super::walls::{Way, is_beside, is_open};
use super::watcher::Watcher;
use crate::check::Incident;
use crate::program::syntax::{BlockKind, Compensation};

/// So many ways are remembered.
const MOST: usize = 1 << 8;
/// So many blocks back the radius compensation is looked for.
const BACK: usize = 64;
/// A way along an edge is so long, as a part of the blank.
const ALONG: f64 = 0.4;
/// So many places of it are looked at.
const PLACES: usize = 8;
/// A wall is at least so wide, mm.
const LEAST: f64 = 0.5;

impl Watcher<'_> {
    /// Notes a plain movement at feed.
    pub(super) fn note_way(&mut self, from: DVec3, places: &[DVec3]) {
        let Some(body) = self.body.filter(|body| !body.is_round()) else { return };
        let compensated = self.is_compensated();
        if !compensated {
            self.contour += 1;
            self.from_outside = body.distance(self.at) > 0.0;
        }
        if self.at.z >= body.high.z - SKIN {
            return;
        }
        let flat = (self.at.z - from.z).abs() <= SAME && (self.at - from).truncate().length() > SAME;
        let middle = places.get(places.len() / 2).copied().unwrap_or(from);
        let straight = ((from + self.at) / 2.0 - middle).length() <= self.remains.cell;
        let (Some(width), true) = (self.width(), flat && straight && self.walls.len() < MOST) else { return };
        let contour = Some(self.contour).filter(|_| self.from_outside && compensated);
        self.walls.push(Way { line: self.line, from, to: self.at, radius: width / 2.0, contour });
    }

    /// Whether RL or RR acts in the block that is executed, as the text before it says.
    pub(super) fn is_compensated(&self) -> bool {
        let last = self.blocks.range(..=self.line).rev().take(BACK).find_map(|(_, block)| match &block.kind {
            BlockKind::Motion(element) => element.words().compensation,
            _ => None,
        });
        matches!(last, Some(Compensation::Rl | Compensation::Rr))
    }

    /// The program is over: whether such a way has left a wall at the edge.
    pub(super) fn judge_walls(&mut self) {
        let ways = std::mem::take(&mut self.walls);
        let wall = ways.iter().filter(|way| is_open(way, &ways)).find_map(|way| {
            let wide = self.wall_beside(way)?;
            let alone = ways.iter().all(|other| !is_beside(way, other));
            alone.then_some((way.line, wide))
        });
        if let Some((line, wide)) = wall.filter(|_| !self.remains.open && !self.away()) {
            self.report(line, Incident::WallLeft(wide * self.unit));
        }
    }

    /// How wide the wall is that a way along an edge of the blank leaves there, if it has material on both sides.
    fn wall_beside(&self, way: &Way) -> Option<f64> {
        let body = self.body?;
        let along = (way.to - way.from).truncate().abs();
        let axis = if along.y <= SAME {
            0
        } else if along.x <= SAME {
            1
        } else {
            return None;
        };
        let across = 1 - axis;
        let (low, high) = (body.low.to_array(), body.high.to_array());
        let (from, to) = (way.from.to_array(), way.to.to_array());
        let at = from[across];
        let (begin, end) = (from[axis].min(to[axis]).max(low[axis]), from[axis].max(to[axis]).min(high[axis]));
        if end - begin < ALONG * (high[axis] - low[axis]) || at <= low[across] || high[across] <= at {
            return None;
        }
        // The nearer edge, and the way from the tool to it.
        let (edge, side) = if at - low[across] < high[across] - at { (low[across], -1.0) } else { (high[across], 1.0) };
        let wide = (edge - at).abs() - way.radius;
        if wide < LEAST || wide > 2.0 * way.radius {
            return None;
        }
        // What goes through the blank cuts something off.
        if way.from.z <= body.low.z + SKIN {
            return None;
        }
        let height = way.from.z + 2.0 * SKIN;
        let solid = |offset: f64| {
            let at_turn = |turn: &usize| {
                let mut place = [0.0, 0.0, height];
                place[axis] = begin + (end - begin) * *turn as f64 / PLACES as f64;
                place[across] = at + offset;
                self.is_solid(DVec3::from_array(place))
            };
            (1..PLACES).filter(at_turn).count()
        };
        let beyond = way.radius + 2.0 * self.remains.cell;
        let middle = way.radius + wide / 2.0;
        // The tool comes through the wall, and pockets may be milled beside it.
        let stands = 3 * solid(side * middle) >= 2 * (PLACES - 1) && 2 * solid(-side * beyond) >= PLACES - 1;
        stands.then_some(wide)
    }
}
