//! What cycles have done at a place: holes beside the blank, one over the other, too narrow or too wide for what
//! follows, pockets and texts outside.
use glam::{DVec2, DVec3, Vec2Swizzles};

use super::areas::{MOST_PIECES, Piece, from_place, pieces};
use super::body::{Body, SAME, SKIN};
use super::watcher::Watcher;
use crate::check::{Incident, ToolKind, is_milling, is_reaming};
use crate::spec::{Cycle, CycleKey, Group};

/// A hole goes so far through the blank, mm.
const TIP: f64 = 25.0;
/// The meaning of the value that only cycles for boring bars have.
const DISENGAGES: &str = "disengaging-direction";
/// The meaning of how far beside the axis of the hole a bar goes through it.
const ASIDE: &str = "off-centre-distance";
/// The meaning of the circle on which slots lie.
const ON_CIRCLE: &str = "pitch-circle-diameter";
/// The meaning of the rounding of corners, which only rectangular pockets and studs have.
const CORNER: &str = "corner-radius";
/// A pocket may be so far beyond an edge of the blank, and its corners are rounder than its tool by so much, mm.
const OVER: f64 = 0.5;
const ROUND: f64 = 0.1;
/// No allowance on a side is greater, mm.
const SIDE: f64 = 1.0;
/// A bar takes no more off the diameter than this, and this part of the diameter, mm.
const BORED: (f64, f64) = (4.0, 0.15);
/// Two holes of one tool are no nearer to each other than so much of its diameter.
const APART: f64 = 0.95;
/// A reamer takes no more off the diameter than this, and this part of the diameter, mm.
const REAMED: (f64, f64) = (0.6, 0.03);
/// Facing goes so far beyond the blank, besides the diameter of the tool, mm.
const BEYOND: f64 = 10.0;
/// A drill of this part of the diameter of a thread removes it.
const CORE: f64 = 0.8;
/// So many holes are remembered.
const MOST_HOLES: usize = 2_000;

/// A hole, or all that a cycle does without another one between.
pub(super) struct Work {
    /// Where it is reported.
    pub(super) line: usize,
    /// Where it is written, be it in a called program.
    pub(super) written: usize,
    pub(super) key: CycleKey,
    pub(super) group: Group,
    pub(super) milled: bool,
    /// Where its first cut begins, and whether that is certain.
    pub(super) start: DVec3,
    known: bool,
    /// Whether it has met material that was certainly there.
    pub(super) solid: bool,
    /// Whether it may have met any.
    pub(super) meets: bool,
    pub(super) low: DVec3,
    pub(super) high: DVec3,
    /// Where the tool goes in the plane, of pockets.
    pub(super) way: Vec<Piece>,
}

impl Work {
    /// The middle of what was milled: where the tool has plunged, if that is near to it.
    pub(super) fn middle(&self) -> DVec3 {
        let middle = (self.low + self.high) / 2.0;
        let near = (middle - self.start).truncate().length() <= 0.1 * (self.high - self.low).truncate().length();
        if near { self.start.with_z(middle.z) } else { middle }
    }
}

/// A thread that was tapped.
pub(super) struct Thread {
    at: DVec2,
    width: f64,
    /// The tool call that it was made after.
    call: u32,
}

/// A hole that was made.
#[derive(Clone, Copy)]
pub(super) struct Hole {
    pub(super) at: [f64; 2],
    bottom: f64,
    /// How wide it is, if that is known.
    width: Option<f64>,
    /// Whether the tip of a drill is at its bottom: there it is not as wide.
    pointed: bool,
    /// Whether it was milled.
    pub(super) milled: bool,
    /// The tool call that it was made after, and the cycle.
    made: (u32, CycleKey),
}

impl Hole {
    /// Whether a tool that is so wide goes into it without cutting.
    pub(super) fn is_as_wide(&self, width: f64) -> bool {
        self.width.is_some_and(|own| own >= width - SAME)
    }

    /// Its radius, if that is known.
    pub(super) fn radius(&self) -> Option<f64> {
        self.width.map(|width| width / 2.0)
    }

    /// Whether it goes down to a height.
    pub(super) fn is_as_deep(&self, height: f64) -> bool {
        self.bottom <= height + SKIN
    }
}

/// What a tool is there for.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Job {
    Hole,
    Thread,
    MilledThread,
    Milling,
    Turning,
}

impl Job {
    /// Whether one tool can do both.
    pub(super) const fn goes_with(self, other: Self) -> bool {
        match (self, other) {
            (Self::Thread, other) | (other, Self::Thread) => matches!(other, Self::Thread),
            (Self::Turning, other) | (other, Self::Turning) => matches!(other, Self::Turning),
            (Self::Hole, Self::MilledThread) | (Self::MilledThread, Self::Hole) => false,
            _ => true,
        }
    }
}

/// What a cycle needs a tool for; nothing if tools of many kinds do it.
pub(super) fn job(cycle: &Cycle) -> Option<Job> {
    let has = |meaning: &str| cycle.params.iter().any(|param| param.is.as_str() == meaning);
    match cycle.file.group {
        Group::Drilling if is_milling(cycle) => Some(Job::Milling),
        Group::Drilling => Some(Job::Hole),
        // Its tool drills before it mills.
        Group::Threads if is_milling(cycle) && has("plunging-depth") => None,
        Group::Threads if is_milling(cycle) => Some(Job::MilledThread),
        Group::Threads => Some(Job::Thread),
        Group::Pockets | Group::Surfaces => Some(Job::Milling),
        Group::Turning => Some(Job::Turning),
        _ => None,
    }
}

impl Watcher<'_> {
    /// A tool cuts with a cycle: whether it is called something else, or has done a job before that no such tool does.
    pub(super) fn use_tool(&mut self, tool: f64, key: CycleKey) {
        let Some(cycle) = self.cycle(key) else { return };
        let number = tool.to_bits();
        if !self.used.insert((number, key)) {
            return;
        }
        if let Some(kind) = self.kind().filter(|kind| kind.misfits(cycle)) {
            self.report(self.line, Incident::Misused { tool, kind, cycle: key });
        }
        let job = |key: CycleKey| self.cycle(key).and_then(job);
        let own = job(key);
        // An end mill that stands for the thread mill of the table.
        let instead = self.spare_thread_mill && self.kind() != Some(ToolKind::ThreadMill);
        let mills = |own: Job, other: Job| {
            instead && matches!((own, other), (Job::Milling, Job::MilledThread) | (Job::MilledThread, Job::Milling))
        };
        let other = self.used.iter().find(|(before, done)| {
            *before == number
                && own.zip(job(*done)).is_some_and(|(own, other)| !own.goes_with(other) || mills(own, other))
        });
        if let Some((_, before)) = other.copied() {
            self.report(self.line, Incident::ToolHasOtherJob { cycle: key, before });
        }
    }

    /// The operator goes on: the workpiece may lie otherwise from here on.
    pub(super) fn stop(&mut self) {
        self.finish();
        if self.worked && self.stopped.is_none() {
            self.stopped = Some(self.series.open);
            (self.lost, self.turned.open) = (true, true);
            self.series.open = true;
        }
    }

    /// Another preset is activated after the operator was asked to go on: the workpiece is clamped otherwise, and
    /// nothing is known of its blank, but holes that belong together have the same datum again.
    pub(super) fn clamp_again(&mut self, other: bool) {
        let Some(open) = self.stopped.filter(|_| other && self.worked) else { return };
        self.stopped = None;
        self.finish();
        self.series.open = open;
        (self.lost, self.worked, self.others, self.body) = (false, false, false, None);
        self.holes.clear();
        self.threads.clear();
        self.machined.clear();
        self.milled.clear();
        self.areas.clear();
        self.walls.clear();
    }

    /// Adds a cut to what a cycle does; `written` is the line of its call.
    pub(super) fn note(&mut self, key: Option<CycleKey>, written: usize, path: &[DVec3], known: bool) {
        let Some(from) = path.first().copied() else { return };
        let Some((key, cycle)) = key.and_then(|key| Some((key, self.cycle(key)?))) else { return };
        let (at, line) = (self.at, self.line);
        let group = cycle.file.group;
        let cuts = matches!(group, Group::Drilling | Group::Threads | Group::Pockets | Group::Contours);
        if !cuts && !matches!(group, Group::Surfaces | Group::Special) {
            return;
        }
        let milled = is_milling(cycle);
        let hole = matches!(group, Group::Drilling | Group::Threads) && !milled;
        let same = |own: &Work| (own.start - from).truncate().length() <= SAME;
        if hole && self.work.as_ref().is_some_and(|own| !same(own)) && (from - at).truncate().length() <= SAME {
            self.finish();
        }
        let met = path.iter().skip(1).any(|place| self.is_solid(*place));
        let new = Work {
            line,
            written,
            key,
            group,
            milled,
            start: from,
            known,
            solid: false,
            meets: false,
            low: at,
            high: at,
            way: Vec::new(),
        };
        let work = self.work.get_or_insert(new);
        work.solid |= met;
        if group == Group::Pockets && work.way.len() < MOST_PIECES {
            let flat: Vec<DVec2> = path.iter().map(|place| place.truncate()).collect();
            work.way.extend(pieces(&flat));
        }
        // The way to the first place is none of its size.
        for place in path.iter().skip(1) {
            work.low = work.low.min(*place);
            work.high = work.high.max(*place);
        }
    }

    /// A cycle has done what it does at a place.
    pub(super) fn finish(&mut self) {
        let Some(work) = self.work.take() else { return };
        let drills = matches!(work.group, Group::Drilling | Group::Threads);
        let down = work.low.z < work.start.z - SKIN;
        self.leave_middle(&work, down);
        if self.away() {
            // What the tool makes along its axis has a place in the setting of the machine.
            let straight = down && !work.milled && (work.high - work.low).truncate().length() <= SAME;
            match drills && straight && !self.across {
                true => self.note_hole(&work),
                false => self.series.open |= drills,
            }
            return;
        }
        // What does not go down is a way between, or cuts from below.
        if drills && !down {
            return;
        }
        // Where the tool is after a change is where the one before it was.
        self.note_hole(&work);
        if !work.known {
            return;
        }
        let hole = matches!(work.group, Group::Drilling | Group::Threads) && !work.milled;
        if let Some(body) = self.body {
            self.beside(&body, &work, hole);
            self.in_air(&body, &work);
            if hole {
                self.cut_by_area(&body, &work);
            }
        }
        self.note_area(&work);
        self.back_bore(&work);
        if hole {
            self.again(&work);
        } else if work.group == Group::Pockets {
            self.milled_again(&work);
        }
        match work.group {
            Group::Threads => self.thread(&work),
            Group::Drilling if hole => self.drill(&work),
            Group::Drilling | Group::Pockets => self.mill(&work),
            _ => {}
        }
    }

    /// Whether it is in the blank at all.
    fn beside(&mut self, body: &Body, work: &Work, hole: bool) {
        let bottom = work.low.z;
        let place = [work.start.x * self.unit, work.start.y * self.unit];
        if bottom > body.high.z + SKIN {
            self.report(work.line, Incident::AboveBlank(bottom * self.unit));
        }
        if hole {
            if body.distance(work.start) > SKIN {
                self.report(work.line, Incident::HoleBesideBlank(place));
            } else if bottom < body.low.z - TIP {
                self.report(work.line, Incident::HoleThroughBlank(bottom * self.unit));
            }
            return;
        }
        let radius = self.radius();
        let middle = (work.low + work.high) / 2.0;
        let over = (body.low - work.low).max(work.high - body.high).truncate().max_element();
        let reach = DVec3::new(radius, radius, 0.0);
        let nothing = (work.high + reach - body.low).truncate().min_element() < 0.0
            || (body.high - work.low + reach).truncate().min_element() < 0.0;
        // The tool begins beside the blank of a stud.
        let stud =
            self.cycle(work.key).is_some_and(|own| own.params.iter().any(|param| param.is.as_str().contains("blank")));
        let outside = match work.group {
            Group::Special => over > SKIN,
            Group::Pockets => !stud && (nothing || body.distance(middle) > SKIN),
            Group::Surfaces => nothing || over > 2.0 * radius + BEYOND,
            _ => nothing,
        };
        let place = [middle.x * self.unit, middle.y * self.unit];
        if outside {
            self.report(work.line, Incident::OutsideBlank(place));
        } else if work.group == Group::Pockets && !stud && self.is_across(body, work) {
            self.report(work.line, Incident::CoversBlank(place));
        }
    }

    /// Whether a rectangular pocket with round corners goes beyond the blank at both ends, and would lie inside of it if its
    /// sides were exchanged: a groove that is open at both ends needs no corners.
    fn is_across(&self, body: &Body, work: &Work) -> bool {
        let cornered = |own: &Cycle| own.params.iter().any(|param| param.is.as_str() == CORNER);
        let Some(radius) = self.width().map(|width| width / 2.0) else { return false };
        if body.is_round() || !self.cycle(work.key).is_some_and(cornered) {
            return false;
        }
        let long = |own: &&Piece| (own[1] - own[0]).length();
        let longest = work.way.iter().max_by(|one, other| long(one).total_cmp(&long(other)));
        let straight = longest.is_some_and(|[from, to]| (*to - *from).abs().min_element() <= SAME);
        let places = || work.way.iter().flatten();
        let low = places().fold(DVec2::INFINITY, |low, own| low.min(*own)) - radius;
        let high = places().fold(DVec2::NEG_INFINITY, |high, own| high.max(*own)) + radius;
        // Only the first levels of a deep one may be remembered, with an allowance on the sides.
        let [least, most] = [work.low.truncate() - radius, work.high.truncate() + radius];
        let whole = (low - least).max(most - high).max_element() <= SIDE;
        let edges = [body.low.truncate(), body.high.truncate()];
        let (middle, turned) = ((low + high) / 2.0, (high - low).yx() / 2.0);
        let both = (low + OVER).cmplt(edges[0]) & (high - OVER).cmpgt(edges[1]);
        let fits = (middle - turned).cmpge(edges[0]).all() && (middle + turned).cmple(edges[1]).all();
        let corners = [low, DVec2::new(low.x, high.y), high, DVec2::new(high.x, low.y)];
        // Where the tool makes the corners itself, it has been within so much of each of them.
        let sharp = radius * std::f64::consts::SQRT_2 + ROUND;
        let round = |corner: &DVec2| work.way.iter().all(|piece| from_place(*piece, *corner) > sharp);
        whole && straight && both.any() && fits && corners.iter().all(round)
    }

    /// Whether everything was gone where it has cut, although it goes below the top of the blank.
    fn in_air(&mut self, body: &Body, work: &Work) {
        let cuts = matches!(work.group, Group::Drilling | Group::Threads | Group::Pockets | Group::Contours);
        let inside = body.distance((work.low + work.high) / 2.0) <= 0.0 && work.low.z < body.high.z - SKIN;
        if cuts && inside && !work.meets && self.holes_at(work.start).is_empty() {
            self.report(work.line, Incident::InAir(work.low.z * self.unit));
        }
    }

    /// A hole that the same tool has made already from another block, or on another round.
    fn again(&mut self, work: &Work) {
        let place = [work.start.x * self.unit, work.start.y * self.unit];
        let bits = work.start.with_z(work.low.z).to_array().map(|own| (own / SAME).round() as i64);
        if self.machined.insert((work.key, self.calls, bits), work.line).is_some() {
            self.report(work.line, Incident::MachinedAgain(place));
        }
    }

    /// A pocket that one block has made already at the same place, on another round.
    fn milled_again(&mut self, work: &Work) {
        let middle = (work.low + work.high) / 2.0;
        // Another one may be smaller or turned.
        let size = work.high - work.low;
        let all = [middle.x, middle.y, work.low.z, size.x, size.y].map(|own| (own / SAME).round() as i64);
        if !self.milled.insert((work.key, self.calls, work.written, all)) {
            let place = [middle.x * self.unit, middle.y * self.unit];
            self.report(work.line, Incident::MachinedAgain(place));
        }
    }

    /// The holes that were made at a place.
    pub(super) fn holes_at(&self, place: DVec3) -> Vec<Hole> {
        let here = |own: &&Hole| (own.at[0] - place.x).abs() <= SAME && (own.at[1] - place.y).abs() <= SAME;
        self.holes.iter().filter(here).copied().collect()
    }

    /// How wide the widest of several holes is that go down to a height, or through the blank.
    fn widest(&self, holes: &[Hole], height: f64) -> Option<f64> {
        let deep = |own: &&Hole| own.bottom <= height + SKIN || self.goes_through(own);
        holes.iter().filter(deep).filter_map(|own| own.width).reduce(f64::max)
    }

    /// Whether a hole goes through the blank in its whole width; without a blank none does.
    pub(super) fn goes_through(&self, hole: &Hole) -> bool {
        self.body.is_some_and(|body| match hole.pointed {
            true => hole.bottom < body.low.z - SKIN,
            false => hole.bottom <= body.low.z,
        })
    }

    /// A thread that was tapped before where a hole is made now, by its diameter.
    fn thread_at(&self, place: DVec3) -> Option<f64> {
        let here = |own: &&Thread| (own.at - place.truncate()).abs().max_element() <= SAME && own.call != self.calls;
        self.threads.iter().find(here).map(|own| own.width)
    }

    fn remember(&mut self, work: &Work, width: Option<f64>, at: DVec3) {
        if self.holes.len() < MOST_HOLES {
            let made = (self.calls, work.key);
            let pointed = self.kind() == Some(ToolKind::Drill);
            let hole = Hole { at: [at.x, at.y], bottom: work.low.z, width, pointed, milled: work.milled, made };
            self.holes.push(hole);
        }
    }

    /// A hole along the tool axis: beside others of the same tool, and in one that is there already.
    fn drill(&mut self, work: &Work) {
        let width = self.width();
        let (bottom, unit) = (work.low.z, self.unit);
        let reams = self.cycle(work.key).is_some_and(is_reaming) && self.kind() != Some(ToolKind::Drill);
        let reams = reams || self.kind() == Some(ToolKind::Reamer);
        let here = self.holes_at(work.start);
        // What only centres is not as wide as its tool.
        let widest = self.widest(&here, bottom);
        // A reamer needs something to remove.
        let wider = |own: f64, hole: f64| hole > own + SAME || reams && hole > own - SAME;
        if let Some((own, hole)) = width.zip(widest).filter(|(own, hole)| wider(*own, *hole)) {
            self.report(work.line, Incident::NothingLeft { tool: own * unit, hole: hole * unit });
        } else if reams && !self.holes.is_empty() {
            self.ream(work, &here);
        } else {
            self.bore(work, &here);
        }
        if let Some(width) = width.filter(|_| !reams) {
            let made = (self.calls, work.key);
            let distance = |own: &Hole| libm::hypot(own.at[0] - work.start.x, own.at[1] - work.start.y);
            let same = self.holes.iter().filter(|own| own.made == made && own.bottom <= bottom + SKIN);
            let near = same.map(distance).filter(|own| *own > SAME).reduce(f64::min);
            if let Some(distance) = near.filter(|own| *own < APART * width) {
                let incident = Incident::Overlap { distance: distance * unit, width: width * unit };
                self.report(work.line, incident);
            }
        }
        if let Some((hole, thread)) = width.zip(self.thread_at(work.start)).filter(|(hole, own)| *hole >= CORE * own) {
            self.report(work.line, Incident::ThreadRemoved { thread: thread * unit, hole: hole * unit });
        }
        self.remember(work, width, work.start);
    }

    /// A reamer needs a hole that is there, as deep as it goes, and a little narrower.
    fn ream(&mut self, work: &Work, here: &[Hole]) {
        let unit = self.unit;
        let Some(lowest) = lowest(here) else {
            let certain = !self.others || work.solid && !self.remains.open;
            if certain && self.kind() == Some(ToolKind::Reamer) {
                self.report(work.line, Incident::ReamedWrongly { what: "none", value: 0.0, other: 0.0 });
            }
            return;
        };
        if !self.goes_through(&lowest) && work.low.z < lowest.bottom - SKIN {
            let (value, other) = (work.low.z * unit, lowest.bottom * unit);
            return self.report(work.line, Incident::ReamedWrongly { what: "deep", value, other });
        }
        let hole = self.widest(here, work.low.z);
        if let Some((reamer, hole)) = self.width().zip(hole)
            && reamer - hole > REAMED.0 + REAMED.1 * reamer
            && self.kind() == Some(ToolKind::Reamer)
        {
            let (value, other) = (reamer * unit, hole * unit);
            self.report(work.line, Incident::ReamedWrongly { what: "allowance", value, other });
        }
    }

    /// A boring bar does not go deeper than its hole, into what is solid.
    fn bore(&mut self, work: &Work, here: &[Hole]) {
        let bores = self.cycle(work.key).is_some_and(|own| {
            own.file.group == Group::Drilling && own.params.iter().any(|param| param.is.as_str() == DISENGAGES)
        });
        let aside = self.cycle(work.key).is_some_and(|own| own.params.iter().any(|param| param.is.as_str() == ASIDE));
        let Some(lowest) = lowest(here).filter(|_| bores && !aside && !self.remains.open) else { return };
        if work.solid && !self.goes_through(&lowest) && work.low.z < lowest.bottom - SKIN {
            let (value, other) = (work.low.z * self.unit, lowest.bottom * self.unit);
            return self.report(work.line, Incident::ReamedWrongly { what: "bored", value, other });
        }
        let hole = self.widest(here, work.low.z);
        if let Some((bar, hole)) = self.width().zip(hole).filter(|(bar, hole)| bar - hole > BORED.0 + BORED.1 * bar) {
            let (value, other) = (bar * self.unit, hole * self.unit);
            self.report(work.line, Incident::ReamedWrongly { what: "stock", value, other });
        }
    }

    /// A bar that goes through a hole beside its axis: its edge must not be wider than the hole there.
    fn back_bore(&mut self, work: &Work) {
        let aside = self.cycle(work.key).is_some_and(|own| own.params.iter().any(|param| param.is.as_str() == ASIDE));
        let Some(edge) = self.width().map(|width| width / 2.0).filter(|_| aside) else { return };
        // It counterbores in the middle, and goes through beside it.
        let (start, far) = (work.start, (work.low - work.start).abs().cmpgt((work.high - work.start).abs()));
        let centre = DVec3::select(far, work.low, work.high);
        let out = edge - (centre - start).truncate().length();
        let through = self.holes_at(centre).into_iter().filter(|own| self.goes_through(own));
        let hole = through.filter_map(|own| own.width).reduce(f64::max);
        if let Some(hole) = hole.map(|width| width / 2.0).filter(|hole| out > hole + SAME) {
            self.report(work.line, Incident::EdgeWiderThanHole { edge: out * self.unit, hole: hole * self.unit });
        }
    }

    /// A round hole that is milled, as wide as its ways and the tool.
    fn mill(&mut self, work: &Work) {
        let extent = work.high - work.low;
        let middle = work.middle();
        let round = (extent.x - extent.y).abs() <= 0.05 * extent.x;
        // Slots on a circle are none.
        let slots =
            self.cycle(work.key).is_some_and(|own| own.params.iter().any(|param| param.is.as_str() == ON_CIRCLE));
        if let Some(width) = self.width().filter(|_| round && extent.x > 0.0 && !slots) {
            let here = self.holes_at(middle);
            if here.is_empty() {
                self.beside_drilled(work, middle.truncate());
            }
            let whole = extent.x + width;
            if let Some(hole) = self.widest(&here, work.low.z).filter(|hole| *hole > whole + SAME) {
                self.report(work.line, Incident::NothingLeft { tool: whole * self.unit, hole: hole * self.unit });
            }
            self.remember(work, Some(extent.x + width), middle);
        }
    }

    /// A thread goes into a hole that must be there, wide enough and not too wide, and not deeper than it.
    fn thread(&mut self, work: &Work) {
        let place = [work.start.x * self.unit, work.start.y * self.unit];
        let mut here = self.holes_at(work.start);
        if let Some(thread) = self.width().filter(|_| work.milled).map(|width| width + work.high.x - work.low.x) {
            let wide = here.iter().filter(|own| own.bottom <= work.low.z + SKIN).filter_map(|own| own.width);
            if let Some(hole) = wide.reduce(f64::max).filter(|hole| *hole >= thread - SAME) {
                let incident = Incident::WideCore { thread: thread * self.unit, hole: hole * self.unit };
                self.report(work.line, incident);
            }
            // What is wider than a milled thread is no core hole of it: that one was there before.
            here.retain(|own| own.width.is_none_or(|hole| hole <= thread + SAME));
        }
        let bottom = lowest(&here);
        // What only centres is not as wide as its tool.
        let hole = here.iter().filter(|own| own.bottom <= work.low.z).filter_map(|own| own.width).reduce(f64::max);
        if let Some((thread, hole)) = self.width().zip(hole).filter(|_| !work.milled) {
            let incident = |wide: bool| match wide {
                true => Incident::WideCore { thread: thread * self.unit, hole: hole * self.unit },
                false => Incident::NarrowCore { thread: thread * self.unit, hole: hole * self.unit },
            };
            match core(thread) {
                Some((_, most)) if hole > most => self.report(work.line, incident(true)),
                Some((least, _)) if hole < least => self.report(work.line, incident(false)),
                None if hole >= thread => self.report(work.line, incident(true)),
                _ => {}
            }
        }
        // A thread mill goes down in the middle of the hole.
        if let Some((tool, hole)) = self.width().zip(hole).filter(|(tool, hole)| work.milled && *tool >= hole - SAME) {
            self.report(work.line, Incident::ToolWiderThanCore { tool: tool * self.unit, hole: hole * self.unit });
        }
        if let Some(width) = self.width().filter(|_| !work.milled && self.threads.len() < MOST_HOLES) {
            self.threads.push(Thread { at: work.start.truncate(), width, call: self.calls });
        }
        match bottom {
            Some(hole) if !self.goes_through(&hole) && work.low.z < hole.bottom - SKIN => {
                let incident = Incident::HoleTooShallow { tap: work.low.z * self.unit, hole: hole.bottom * self.unit };
                self.report(work.line, incident);
            }
            None if !work.milled
                && !self.holes.is_empty()
                && (!self.others || work.solid && !self.remains.open)
                && self.body.is_none_or(|body| body.distance(work.start) <= 0.0) =>
            {
                self.report(work.line, Incident::NoHole(place));
            }
            _ => {}
        }
    }
}

/// Whether a cycle mills a thread in a hole that is there: it has no depth but that of the thread, and no countersink.
pub(super) fn mills_thread_in_hole(cycle: &Cycle) -> bool {
    let mut depths = cycle.params.iter().filter(|param| param.is.as_str().contains("depth"));
    is_milling(cycle) && depths.next().is_some() && depths.next().is_none()
}

/// Whether a cycle mills a thread on the outside of a stud: it has a depth at the front, but drills and countersinks
/// nothing.
pub(super) fn mills_thread_outside(cycle: &Cycle) -> bool {
    let mut depths = cycle.params.iter().map(|param| param.is.as_str()).filter(|own| own.contains("depth"));
    let mills = is_milling(cycle);
    mills && !mills_thread_in_hole(cycle) && depths.all(|own| matches!(own, "thread-depth" | "depth-at-front"))
}

/// The deepest of several holes.
fn lowest(holes: &[Hole]) -> Option<Hole> {
    holes.iter().copied().min_by(|one, other| one.bottom.total_cmp(&other.bottom))
}

/// The narrowest and the widest hole in which a metric thread of a diameter is cut or formed, whatever its pitch:
/// cutting the coarse one needs the narrowest, forming it the widest; finer ones lie nearer to the diameter.
fn core(diameter: f64) -> Option<(f64, f64)> {
    let (_, coarse) = crate::check::COARSE.iter().find(|(own, _)| (own - diameter).abs() <= 0.02)?;
    Some((diameter - 1.35 * coarse, diameter - 0.3 * coarse))
}
