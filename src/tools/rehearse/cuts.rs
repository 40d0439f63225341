//! What a movement at feed takes away: too much per revolution, sideways with a tool that only cuts along its axis, or
//! straight down where a thread is milled.
use glam::DVec3;

use super::body::SAME;
use super::watcher::Watcher;
use crate::check::{Incident, ToolKind};
use crate::program::syntax::{Amount, BlockKind, FeedKind, Operand};
use crate::spec::CycleKey;

/// A feed so many times that of the tool call is one for positioning, and one at which the tool cuts is hardly above
/// it.
const POSITIONING: f64 = 3.0;
const CUTTING: f64 = 1.1;
/// A chamfer is so wide at least, and at most, mm.
const CHAMFER: (f64, f64) = (0.1, 3.0);
/// A floor beside a stud lies so far below the place where a milled thread begins, mm.
const FLOOR: f64 = 6.0;

impl Watcher<'_> {
    /// A movement at feed straight down into material: how much it takes per revolution.
    pub(super) fn plunges(&mut self, from: DVec3, feed: f64, drills: bool) {
        /// So much of the diameter a tool may plunge per revolution, and so much any tool, mm.
        const OF_DIAMETER: f64 = 0.15;
        const OF_DRILL: f64 = 0.1;
        const AT_MOST: f64 = 1.5;
        /// So deep, mm, a mill plunges no faster than this, mm per revolution.
        const DEEP: f64 = 4.0;
        const INTO_FULL: f64 = 1.0;
        let feed = self.in_tenths(feed);
        let (along, down) = ((self.at - from).truncate().length(), from.z - self.at.z);
        if along <= SAME && down > 0.0 && self.speed > 0.0 {
            // A drill keeps to its feed, and plain movements are also those to a height.
            let part = if drills { OF_DRILL } else { OF_DIAMETER };
            let most = self.width().map_or(AT_MOST, |width| (part * width).clamp(0.3, AT_MOST));
            // A mill that goes deep into the full is far slower.
            let deep =
                !drills && self.remains.above(self.at) >= DEEP && self.kind().is_none_or(|own| own != ToolKind::Drill);
            let most = if deep { most.min(INTO_FULL) } else { most };
            if feed / self.speed > most {
                self.report(self.line, Incident::FastPlunge(feed / self.speed * self.unit));
            }
        }
    }

    /// A plain movement straight down that goes into a hole on one pass and into solid material on another: the holes are
    /// elsewhere, or there are too few.
    pub(super) fn dips(&mut self, from: DVec3) {
        let down = (self.at - from).truncate().length() <= SAME && from.z - self.at.z > SAME;
        let Some(width) = self.width().filter(|_| down && !self.remains.open) else { return };
        let fits = |own: &super::work::Hole| own.is_as_wide(width) && own.is_as_deep(self.at.z);
        let hole = self.holes_at(self.at).iter().any(fits);
        let solid = self.is_solid(self.at) && self.is_solid((self.at + from) / 2.0);
        let seen = self.dips.entry(self.line).or_default();
        (seen[0], seen[1]) = (seen[0] || hole, seen[1] || solid);
        if *seen == [true; 2] {
            self.report(self.line, Incident::PlungeBesideHoles([self.at.x * self.unit, self.at.y * self.unit]));
        }
    }

    /// A plain movement at feed through material: whether such a tool cuts sideways.
    pub(super) fn cuts_sideways(&mut self, from: DVec3, places: &[DVec3], feed: f64) {
        let (along, down) = ((self.at - from).truncate().length(), from.z - self.at.z);
        let level = down.abs() <= SAME && places.iter().filter(|place| self.is_solid(**place)).count() > 2;
        if let Some(usual) = self.called_feed().filter(|_| level && along > SAME) {
            if self.cuts && feed >= POSITIONING * usual {
                self.report(self.line, Incident::FastCut(feed / usual));
            }
            self.cuts |= feed <= CUTTING * usual;
        }
        if level && along > SAME && self.speed > 0.0 {
            self.ways.note_feed(self.line, self.in_tenths(feed), self.speed);
        }
        if level && along > SAME && self.kind().is_some_and(ToolKind::only_along_axis) {
            self.report(self.line, Incident::SidewaysWithDrill);
        }
    }

    /// A plain movement at feed of a tool for chamfers: whether its tip goes through solid material along an edge of the
    /// blank that its cone reaches, and would only chamfer that edge from outside.
    pub(super) fn chamfers(&mut self, from: DVec3, places: &[DVec3]) {
        let angle = self.points.iter().find(|(number, _)| Some(*number) == self.tool).map(|(_, angle)| *angle);
        let Some((body, angle)) = self.body.zip(angle).filter(|_| self.kind() == Some(ToolKind::Chamfer)) else {
            return;
        };
        let way = self.at - from;
        let (along, across) = match () {
            () if body.is_round() || way.z.abs() > SAME => return,
            () if way.y.abs() <= SAME && way.x.abs() > SAME => (0, 1),
            () if way.x.abs() <= SAME && way.y.abs() > SAME => (1, 0),
            () => return,
        };
        let inside = |place: &&DVec3| (body.low[along]..=body.high[along]).contains(&place[along]);
        let depths: Vec<f64> =
            places.iter().filter(inside).map(|place| self.remains.above(*place)).filter(|depth| *depth > 0.0).collect();
        let depth = depths.iter().copied().fold(f64::INFINITY, f64::min);
        let edge = (self.at[across] - body.low[across]).min(body.high[across] - self.at[across]);
        let width = depth * libm::tan((angle / 2.0).to_radians()) - edge;
        if depths.len() > 2 && edge > CHAMFER.0 && width > CHAMFER.0 && width <= CHAMFER.1 {
            self.report(self.line, Incident::ChamferInside { depth: depth * self.unit, edge: edge * self.unit });
        }
    }

    /// A feed as it is at least: programs in inches may give it in tenths of them.
    pub(super) fn in_tenths(&self, feed: f64) -> f64 {
        if self.unit < 1.0 { feed / 10.0 } else { feed }
    }

    /// A tool that cuts deep enough to break takes far more per revolution than any does.
    pub(super) fn bites(&mut self, from: DVec3, places: &[DVec3], feed: f64) {
        /// So much of the diameter per revolution, in a cut at least so deep: tools for high feeds cut less deep.
        const LIMITS: [[f64; 2]; 2] = [[0.2, 0.06], [0.17, 0.2]];
        let Some(width) = self.width().filter(|width| *width >= 2.0 && self.speed > 0.0) else { return };
        let (along, down) = ((self.at - from).truncate().length(), (from.z - self.at.z).abs());
        if along <= SAME || down >= along {
            return;
        }
        let turn = self.in_tenths(feed) / self.speed;
        let deep = |least: f64| places.iter().any(|place| self.remains.above(*place) >= least);
        if LIMITS.iter().any(|[part, least]| turn > part * width && deep(least * width)) {
            self.report(self.line, Incident::FastMilling(turn * self.unit));
        }
    }

    /// A milled thread without a depth of its own for drilling needs a hole: the tool must not go straight down into
    /// material.
    pub(super) fn mills_thread(&mut self, key: Option<CycleKey>, from: DVec3, places: &[DVec3]) {
        let only = key.and_then(|key| self.cycle(key)).is_some_and(super::work::mills_thread_in_hole);
        let along = (self.at - from).truncate().length();
        let Some(solid) = places.iter().find(|place| self.is_solid(**place)).filter(|_| only && along <= SAME) else {
            return;
        };
        let incident = Incident::HoleTooShallow { tap: self.at.z * self.unit, hole: solid.z * self.unit };
        self.report(self.line, incident);
    }

    /// A thread that is milled outside of a stud: the tool must not go into the floor around it.
    pub(super) fn mills_into_floor(&mut self, key: Option<CycleKey>, places: &[DVec3]) {
        let outside = key.and_then(|key| self.cycle(key)).is_some_and(super::work::mills_thread_outside);
        let Some(start) = self.work.as_ref().map(|own| own.start.z).filter(|_| outside) else { return };
        let floor = |place: &DVec3| place.z + self.remains.above(*place);
        let into = places.iter().filter(|place| self.is_solid(**place)).map(floor).find(|own| *own < start - FLOOR);
        if let Some(floor) = into {
            let lowest = places.iter().map(|place| place.z).fold(self.at.z, f64::min);
            self.report(self.line, Incident::ThreadIntoFloor { thread: lowest * self.unit, floor: floor * self.unit });
        }
    }

    /// Takes away what the tool may cut at places.
    pub(super) fn cut(&mut self, places: &[DVec3]) {
        let flat = self.flat.iter().find(|(number, _)| Some(*number) == self.tool).map(|(_, radius)| *radius);
        let pointed = [ToolKind::Drill, ToolKind::Spot, ToolKind::Chamfer, ToolKind::Ball, ToolKind::Engraver];
        let sure = flat.filter(|_| self.kind().is_none_or(|kind| !pointed.contains(&kind)));
        self.remains.cut(places, (self.radius(), sure.unwrap_or_default()), self.up());
    }

    /// Notes whether what a cycle does may meet material.
    pub(super) fn meets(&mut self, places: &[DVec3], known: bool) {
        if self.work.as_ref().is_none_or(|own| own.meets) {
            return;
        }
        let radius = self.width().map(|width| width / 2.0).filter(|_| known && !self.remains.open);
        let meets = radius.is_none_or(|radius| self.remains.may_meet(places, radius));
        if let Some(work) = &mut self.work {
            work.meets = meets;
        }
    }

    /// The feed of the last tool call, mm/min.
    fn called_feed(&self) -> Option<f64> {
        let BlockKind::ToolCall(call) = &self.blocks.get(&self.called)?.kind else { return None };
        match call.feed.as_ref()?.kind {
            FeedKind::Value(Operand { amount: Amount::Number(feed), .. }) if feed > 0.0 => Some(feed / self.unit),
            _ => None,
        }
    }
}
