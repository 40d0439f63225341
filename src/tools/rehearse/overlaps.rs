//! Pockets and slots of one definition that run into each other, and holes that one of them cuts.
use glam::DVec2;

use super::areas::Area;
use super::body::{Body, SAME};
use super::watcher::Watcher;
use super::work::{Hole, Work};
use crate::check::{Incident, ToolKind};
use crate::program::fields::key;
use crate::program::syntax::{CycleForm, ValueKind};
use crate::spec::{Cycle, CycleKey, Group};

/// So many pockets are compared.
const MOST_AREAS: usize = 1 << 7;
/// What overlaps by less is a wall that was to be thin, mm.
const DEEP: f64 = 0.2;
/// Pockets with centres so near to each other are one in another, mm.
const CONCENTRIC: f64 = 0.5;
/// Sizes that differ by so much are the same, mm.
const EQUAL: f64 = 0.05;
/// So much of its way lies in another pocket.
const MOSTLY: f64 = 0.7;
/// A hole so much wider is no other one of the same row.
const WIDER: f64 = 1.5;
/// The meaning of the diameter of the hole that is there, and how far the drill may differ from it, mm.
const PRE_DRILLED: &str = "pre-drilled-diameter";
const DRILLED: f64 = 0.3;

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
        let meets = !said
            && self.areas.iter().any(|other| {
                let same = other.made == area.made && (other.long - area.long).abs() <= EQUAL;
                let apart = (other.middle() - area.middle()).length() > CONCENTRIC;
                same && apart && area.comes_within(other, area.radius + other.radius - DEEP)
            });
        if meets {
            let middle = area.middle() * self.unit;
            self.report(work.line, Incident::PocketsOverlap(middle.to_array()));
        }
        let inside = |area: &Area| {
            let deeper = |own: &&Area| own.made != area.made && own.bottom <= area.bottom + SAME;
            self.areas.iter().filter(deeper).map(|own| area.share_within(own, DEEP)).fold(0.0, f64::max)
        };
        let like = |own: &&Area| own.made == area.made && (own.long - area.long).abs() <= EQUAL;
        let others: Vec<f64> = self.areas.iter().filter(like).map(inside).collect();
        if !others.is_empty() && others.iter().all(|own| *own == 0.0) && inside(&area) >= MOSTLY {
            let middle = area.middle() * self.unit;
            self.report(work.line, Incident::PocketInPocket(middle.to_array()));
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
        } else {
            self.cut_by_hole(work, radius);
        }
    }

    /// A hole of which a part lies in a wider one that was made before, over its whole length.
    fn cut_by_hole(&mut self, work: &Work, radius: f64) {
        let place = work.start.truncate();
        let cut = self.holes.iter().any(|own| {
            let distance = (place - DVec2::from_array(own.at)).length();
            own.radius().filter(|wide| *wide >= WIDER * radius).is_some_and(|wide| {
                let deep = own.is_as_deep(work.low.z) || self.goes_through(own);
                distance > wide - radius + DEEP && distance < wide + radius - DEEP && deep
            })
        });
        let drilled = self.holes_at(work.start).iter().any(|own| own.is_as_deep(work.low.z));
        if cut && !drilled && !self.remains.open && work.group == Group::Drilling {
            self.report(work.line, Incident::HoleCutByHole((place * self.unit).to_array()));
        }
    }

    /// A hole that is milled wider than one that was drilled for it, and is not where holes of that diameter are.
    pub(super) fn beside_drilled(&mut self, work: &Work, middle: DVec2) {
        let Some(drilled) = self.pre_drilled(work.key).filter(|_| work.solid && !self.remains.open) else { return };
        let like = |own: &&Hole| own.radius().is_some_and(|own| (2.0 * own - drilled).abs() <= DRILLED);
        let holes: Vec<f64> =
            self.holes.iter().filter(like).map(|own| (DVec2::from_array(own.at) - middle).length()).collect();
        let nearest = holes.into_iter().fold(f64::INFINITY, f64::min);
        if nearest > CONCENTRIC && nearest.is_finite() {
            self.report(work.line, Incident::NotPreDrilled((middle * self.unit).to_array()));
        }
    }

    /// The diameter that the holes have which a cycle mills wider, if all its definitions name one; mm.
    fn pre_drilled(&self, own: CycleKey) -> Option<f64> {
        let q = self.cycle(own)?.params.iter().find(|param| param.is.as_str() == PRE_DRILLED)?.q?;
        let mut least: Option<f64> = None;
        self.program.each_cycle(|view| {
            let CycleForm::Parameters(definition) = &view.form else { return };
            if key(view.keyword, view.number) != own {
                return;
            }
            let written = definition.parameters.iter().find(|parameter| parameter.q == q).map(|own| own.value.kind);
            let value = match written {
                Some(ValueKind::Number(number)) => number / self.unit,
                _ => 0.0,
            };
            least = Some(least.map_or(value, |before| before.min(value)));
        });
        least.filter(|least| *least > 0.0)
    }
}
