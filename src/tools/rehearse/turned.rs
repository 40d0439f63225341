//! What turning cycles do to a round blank: on which side of the part they work and with which tool, whether a bar goes
//! deeper than the hole that was drilled, through the wall, or past everything that is there.
//!
//! Invariant: what is not known of the workpiece says nothing.
use glam::DVec3;

use super::body::SAME;
use super::lathe::{MOST_SLICES, Pass, WALL};
use super::watcher::Watcher;
use super::work::Work;
use crate::check::{Incident, TurnedPart};
use crate::engine::machine::{Insert, InsertForm};
use crate::engine::solid::Path;
use crate::spec::{Cycle, CycleKey, Group};

/// So much of the length of a wall is cut through, mm.
const THROUGH: f64 = 2.0;
/// So far below the bottom of a hole a bar does not go, mm.
const BELOW: f64 = 1.0;
/// So much wider than the hole that is there the way of a bar may begin: on the radius, mm.
const RING: f64 = 2.5;
/// So far beside the insert a recess is looked at: its other corner, mm.
const BESIDE: f64 = 1.5;
/// So far beyond the end of the blank nothing is turned, mm and as a part of its length.
const BEYOND: (f64, f64) = (6.0, 0.1);
/// The meanings that only cycles for recesses and for threads have.
const RECESS: &str = "recess-clearance";
const THREAD: &str = "turned-thread-pitch";

impl Watcher<'_> {
    /// The insert of the tool in the spindle, as a cycle uses it.
    pub(super) fn hold_insert(&mut self, insert: Insert) {
        self.turned.insert = Some(insert);
    }

    /// Another tool is in the spindle.
    pub(super) fn release_insert(&mut self) {
        self.judge_turned();
        (self.turned.insert, self.turned.start) = (None, None);
    }

    /// What was machined without turning: a hole in the middle is known, something else may be anything.
    pub(super) fn leave_middle(&mut self, work: &Work, down: bool) {
        let hole = matches!(work.group, Group::Drilling | Group::Threads) && !work.milled;
        let radius = self.width().map(|width| width / 2.0);
        if !hole {
            self.turned.open = true;
        } else if down && work.start.truncate().length() <= SAME && work.group == Group::Drilling {
            self.turned.drill(work.low.z, radius);
        }
    }

    /// The places of a movement while the workpiece turns, several in each slice.
    pub(super) fn places_turned(&self, path: &Path) -> Vec<DVec3> {
        let count = (2.0 * path.length() / self.turned.slice).ceil().clamp(1.0, MOST_SLICES);
        (0..=count as usize).map(|at| self.place(path.at(at as f64 / count))).collect()
    }

    /// A movement while the workpiece turns; `written` is the line of the call of its cycle.
    pub(super) fn turn(&mut self, key: Option<CycleKey>, written: usize, places: &[DVec3], rapid: bool) {
        let leans = self.tilted || self.across || self.angles.iter().any(|(_, angle)| angle.abs() > 1e-6);
        self.turned.open |= leans;
        let cycle = key.and_then(|key| Some((key, self.cycle(key)?)));
        let Some((key, cycle)) = cycle.filter(|(_, cycle)| cycle.file.group == Group::Turning) else {
            self.judge_turned();
            self.turned.start = Some(self.at);
            // What is turned without a cycle is not followed.
            self.turned.open |= !rapid && places.iter().any(|place| self.turned.at(place.z).is_some());
            return;
        };
        if rapid || leans {
            return;
        }
        if self.turned.pass.as_ref().is_some_and(|own| own.key != key || own.written != written) {
            self.judge_turned();
        }
        let Some(insert) = self.turned.insert.filter(|own| own.tip[0] != 0.0) else { return };
        let (inside, face) = (insert.tip[0] > 0.0, is_axial(cycle));
        let (Some(first), Some(last)) = (places.first(), places.last()) else { return };
        if self.turned.pass.is_none() {
            let recess = insert.form == InsertForm::Recessing || has(cycle, RECESS);
            let before = self.turned.slices.clone();
            self.turned.pass = Some(Pass {
                line: self.line,
                written,
                key,
                recess,
                inside,
                before,
                cuts: false,
                nearest: None,
                through: 0.0,
                other: 0.0,
                deepest: None,
            });
            if !face {
                self.side(inside);
                self.enter(inside, has(cycle, THREAD));
            }
        }
        if self.turned.open || self.turned.slices.is_empty() {
            return;
        }
        let along = (last.z - first.z).abs() >= (last.x - first.x).abs();
        let step = (last.z - first.z).abs() / (places.len().saturating_sub(1).max(1)) as f64;
        for place in places {
            self.look(*place, (face, along), step);
        }
        // An insert of some width takes away more, and an axial recess something else.
        let axial_recess = face && self.turned.pass.as_ref().is_some_and(|own| own.recess);
        if !axial_recess && !has(cycle, THREAD) {
            places.iter().for_each(|place| self.turned.cut(*place, inside, face));
        }
    }

    /// A place of a pass: whether it meets the part, and whether it may.
    fn look(&mut self, place: DVec3, (face, along): (bool, bool), step: f64) {
        let turned = &mut self.turned;
        let (low, high, slice) = (turned.low, turned.high(), turned.slice);
        let Some(pass) = turned.pass.as_mut() else { return };
        let index = |z: f64| ((z - low) / slice).floor().max(0.0) as usize;
        if !face && place.z > low && place.z < high {
            pass.miss(place, [place.z - BESIDE, place.z + BESIDE].map(index));
            let wall = along && !pass.recess && place.z < turned.faced - slice;
            if wall && let Some(before) = pass.before.get(index(place.z)).copied() {
                pass.see(before, place.x.abs(), step);
            }
        }
        let inside = pass.inside && !face && !pass.recess;
        if let Some((bottom, _)) = turned.drilled.filter(|_| inside && turned.bore == 0.0)
            && bottom > low + BELOW
            && place.z < bottom - BELOW
        {
            pass.deepest = Some(pass.deepest.map_or(place.z, |own| own.min(place.z)));
        }
        let beyond = BEYOND.0.max(BEYOND.1 * (high - low));
        if place.z < low - beyond && !inside {
            self.report(self.line, Incident::BelowBlank(place.z * self.unit));
        }
    }

    /// On which side a tool turns: not that which its name denies, nor the other one of what it has turned before.
    fn side(&mut self, inside: bool) {
        let Some(tool) = self.tool else { return };
        let named = self.turned.named.iter().find(|(number, _)| *number == tool).map(|(_, part)| *part);
        let number = tool.to_bits();
        let [own, other] = if inside { [1, 0] } else { [0, 1] };
        let what = match named {
            Some(TurnedPart::Inside) if !inside => Some("bar"),
            Some(TurnedPart::Outside) if inside => Some("outer"),
            _ if self.turned.sides[other].contains(&number) => Some(if inside { "inwards" } else { "outwards" }),
            _ => None,
        };
        self.turned.sides[own].push(number);
        if let Some(what) = what {
            self.report(self.line, Incident::TurnedOnOtherSide(what));
        }
    }

    /// A tool begins inside: whether it, and the way on which it begins, fit into the hole.
    fn enter(&mut self, inside: bool, thread: bool) {
        let unit = self.unit;
        let drilled = self.turned.drilled.and_then(|(_, radius)| radius);
        let known =
            if self.turned.bore > 0.0 { Some(self.turned.bore.max(drilled.unwrap_or_default())) } else { drilled };
        let Some(hole) = known.filter(|own| inside && *own > 0.0 && !self.turned.open && !thread) else { return };
        // What was turned inside before counts as well, from the face on.
        let turned = self.turned.slices.iter().rev().map(|[_, bore]| *bore).find(|bore| *bore > 0.0);
        let hole = hole.max(turned.unwrap_or_default());
        if let Some(start) = self.turned.start.map(|at| at.x.abs()).filter(|start| *start > hole + RING) {
            let incident = Incident::BarBesideHole { what: "start", bar: 2.0 * start * unit, hole: 2.0 * hole * unit };
            return self.report(self.line, incident);
        }
        let width = self.turned.bars.iter().find(|(number, _)| Some(*number) == self.tool).map(|(_, width)| *width);
        if let Some(width) = width.filter(|width| *width > 2.0 * hole + SAME) {
            let incident = Incident::BarBesideHole { what: "thick", bar: width * unit, hole: 2.0 * hole * unit };
            self.report(self.line, incident);
        }
    }

    /// A cycle has turned what it turns.
    pub(super) fn judge_turned(&mut self) {
        let Some(pass) = self.turned.pass.take().filter(|_| !self.turned.open) else { return };
        let unit = 2.0 * self.unit;
        let drilled = self.turned.drilled.map(|(bottom, _)| bottom);
        if let Some((bar, hole)) = pass.deepest.zip(drilled) {
            let incident = Incident::BoredBelowHole { bar: bar * self.unit, hole: hole * self.unit };
            return self.report(pass.line, incident);
        }
        if pass.through >= THROUGH {
            let incident = Incident::WallTurnedThrough { other: pass.other * unit };
            return self.report(pass.line, incident);
        }
        if let Some([beside, radius, surface]) = pass.nearest.filter(|_| !pass.cuts)
            && (pass.recess || beside > WALL)
        {
            let incident = Incident::TurnedInAir { tool: radius * unit, part: surface * unit };
            self.report(pass.line, incident);
        }
    }
}

fn has(cycle: &Cycle, meaning: &str) -> bool {
    cycle.params.iter().any(|param| param.is.as_str() == meaning)
}

/// Whether a cycle works from the face.
fn is_axial(cycle: &Cycle) -> bool {
    let name = cycle.file.name.as_str();
    name.contains("face") || name.contains("axial")
}
