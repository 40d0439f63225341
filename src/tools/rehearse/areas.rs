//! The pockets and slots that a program mills: those of one definition that run into each other, and holes that one of
//! them cuts.
//!
//! Invariant: an area is where the tool was, as far as that is remembered: never more than what was milled.
use glam::DVec2;

use super::body::{Body, SAME};
use super::watcher::Watcher;
use super::work::Work;
use crate::check::{Incident, ToolKind};
use crate::spec::{CycleKey, Group};

/// So many pieces of the way of one pocket are remembered, and so many pockets.
pub(super) const MOST_PIECES: usize = 400;
const MOST_AREAS: usize = 128;
/// What overlaps by less is a wall that was to be thin, mm.
const DEEP: f64 = 0.2;
/// Pockets with centres so near to each other are one in another, mm.
const CONCENTRIC: f64 = 0.5;
/// Sizes that differ by so much are the same, mm.
const EQUAL: f64 = 0.05;

/// A straight piece of the way of the tool in the plane.
pub(super) type Piece = [DVec2; 2];

/// A pocket or slot that was milled.
pub(super) struct Area {
    made: (u32, CycleKey),
    way: Vec<Piece>,
    /// How long that is, which is the same for all that one definition makes.
    long: f64,
    low: DVec2,
    high: DVec2,
    radius: f64,
    bottom: f64,
}

impl Area {
    fn middle(&self) -> DVec2 {
        (self.low + self.high) / 2.0
    }

    /// How far a place is from the way.
    fn distance(&self, place: DVec2) -> f64 {
        self.way.iter().map(|piece| from_place(*piece, place)).fold(f64::INFINITY, f64::min)
    }

    /// Whether the ways of two areas come nearer to each other than so much.
    fn comes_within(&self, other: &Self, reach: f64) -> bool {
        let apart = (self.low - other.high).max(other.low - self.high).max_element();
        apart < reach && self.way.iter().any(|one| other.way.iter().any(|own| between(*one, *own) < reach))
    }
}

/// Straight pieces of a movement whose places are known: one if they lie on a line.
pub(super) fn pieces(places: &[DVec2]) -> Vec<Piece> {
    let (Some(first), Some(last)) = (places.first(), places.last()) else { return Vec::new() };
    if places.iter().all(|place| from_place([*first, *last], *place) <= SAME) {
        return vec![[*first, *last]];
    }
    places.windows(2).filter_map(|pair| pair.try_into().ok()).collect()
}

fn from_place([one, other]: Piece, place: DVec2) -> f64 {
    let way = other - one;
    let long = way.length_squared();
    let share = if long > 0.0 { ((place - one).dot(way) / long).clamp(0.0, 1.0) } else { 0.0 };
    (place - one - way * share).length()
}

/// How far two pieces are from each other; 0 if they cross.
fn between(one: Piece, other: Piece) -> f64 {
    let turn = |a: DVec2, b: DVec2, c: DVec2| (b - a).perp_dot(c - a);
    let ([a, b], [c, d]) = (one, other);
    if turn(a, b, c) * turn(a, b, d) < 0.0 && turn(c, d, a) * turn(c, d, b) < 0.0 {
        return 0.0;
    }
    let ends = [from_place(one, c), from_place(one, d), from_place(other, a), from_place(other, b)];
    ends.into_iter().fold(f64::INFINITY, f64::min)
}

impl Watcher<'_> {
    /// Remembers a pocket or slot, and compares it with those before.
    pub(super) fn note_area(&mut self, work: &Work) {
        let studs = |own: &crate::spec::Cycle| own.params.iter().any(|param| param.is.as_str().contains("blank"));
        let (Some(width), false) = (self.width(), self.cycle(work.key).is_none_or(studs)) else { return };
        if work.group != Group::Pockets || work.way.is_empty() || self.areas.len() >= MOST_AREAS {
            return;
        }
        let all = || work.way.iter().flatten();
        let area = Area {
            made: (self.calls, work.key),
            way: work.way.clone(),
            long: work.way.iter().map(|[one, other]| (*other - *one).length()).sum(),
            low: all().fold(DVec2::INFINITY, |low, own| low.min(*own)),
            high: all().fold(DVec2::NEG_INFINITY, |high, own| high.max(*own)),
            radius: width / 2.0,
            bottom: work.low.z,
        };
        let meets = self.areas.iter().any(|other| {
            let same = other.made == area.made && (other.long - area.long).abs() <= EQUAL;
            let apart = (other.middle() - area.middle()).length() > CONCENTRIC;
            same && apart && area.comes_within(other, area.radius + other.radius - DEEP)
        });
        if meets {
            let middle = area.middle() * self.unit;
            self.report(work.line, Incident::PocketsOverlap(middle.to_array()));
        }
        self.areas.push(area);
    }

    /// A hole of which a part lies in a pocket that was milled before, and a part beside it.
    pub(super) fn cut_by_area(&mut self, body: &Body, work: &Work) {
        let Some(radius) = self.width().map(|width| width / 2.0) else { return };
        if work.milled || self.kind().is_some_and(|kind| matches!(kind, ToolKind::Spot | ToolKind::Chamfer)) {
            return;
        }
        let place = work.start.truncate();
        let cut = self.areas.iter().any(|area| {
            let distance = area.distance(place);
            let partly = distance < area.radius + radius - DEEP && distance > (area.radius - radius).abs() + DEEP;
            partly && area.radius > radius && area.bottom < body.high.z - SAME && work.low.z < area.bottom
        });
        if cut && self.holes_at(work.start).is_empty() {
            self.report(work.line, Incident::HoleCutByPocket((place * self.unit).to_array()));
        }
    }
}
