//! Pockets and slots of one definition that run into each other, and holes that one of them cuts.
use glam::DVec2;

use super::areas::Area;
use super::body::{Body, SAME};
use super::watcher::Watcher;
use super::work::Work;
use crate::check::{Incident, ToolKind};
use crate::spec::{Cycle, Group};

/// So many pockets are compared.
const MOST_AREAS: usize = 1 << 7;
/// What overlaps by less is a wall that was to be thin, mm.
const DEEP: f64 = 0.2;
/// Pockets with centres so near to each other are one in another, mm.
const CONCENTRIC: f64 = 0.5;
/// Sizes that differ by so much are the same, mm.
const EQUAL: f64 = 0.05;

impl Watcher<'_> {
    /// Remembers a pocket or slot, and compares it with those before.
    pub(super) fn note_area(&mut self, work: &Work) {
        let studs = |own: &Cycle| own.params.iter().any(|param| param.is.as_str().contains("blank"));
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
        // Said once: each piece is compared with each.
        let said = self.found.iter().any(|own| matches!(own.incident, Incident::PocketsOverlap(_)));
        let meets = !said && self.areas.iter().any(|other| {
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
