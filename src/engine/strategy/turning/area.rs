//! What is turned: the profile that an insert must not go below, as its cuts see it.
//!
//! Cuts go along the rotary axis, or across it. Either way `x` of the half plane grows in the direction of the feed, and
//! `y` away from the part. Positions are those of the tip of the insert. Unless the tool table says otherwise, it is as far
//! in front of the centre of its nose and below it as the nose has radius. Invariant: coordinates of the main axis are radii here.
use std::sync::Arc;

use glam::{DVec2, DVec3};

use crate::base::expr::tand;
use crate::engine::region::insert_envelope::{Allowance, Envelope, GoesBack, Insert, monotone};
use crate::engine::region::{Edge, Way};
use crate::engine::strategy::pen::Pen;

/// An edge that leans back further from upright is reckoned as this, degrees.
const MOST_LEANING: f64 = 89.0;
/// From the centre of the nose to the tip, in nose radii, where no orientation of the tool is known.
pub(super) const TIP: DVec2 = DVec2::new(1.0, -1.0);
/// Places that are nearer to each other are one, mm.
const COUNTS: f64 = 1e-6;
/// What is higher by no more than this, mm, is touched and not cut.
const TOUCHES: f64 = 1e-6;
/// A place so far in front of a wall is not on it, mm.
const SIDE: f64 = 1e-8;
/// What stays beyond what the nose alone leaves is reported if it is more than this, mm.
const REPORTED: f64 = 1e-3;

/// How the half plane of the machine is seen by cuts.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sight {
    /// Whether the cuts go across the rotary axis.
    pub face: bool,
    /// The sign of the machine's coordinate along the feed.
    pub ahead: f64,
    /// The sign of the machine's coordinate away from the part.
    pub away: f64,
}

impl Sight {
    /// A point of the machine as cuts see it.
    pub fn seen(&self, radius: f64, z: f64) -> DVec2 {
        let (along, out) = if self.face { (radius, z) } else { (z, radius) };
        DVec2::new(along * self.ahead, out * self.away)
    }

    /// A contour as cuts see it, given with `x` along the rotary axis and radii as `y`.
    pub fn seen_way(&self, way: &Way) -> Way {
        let seen = |at: DVec2| self.seen(at.y, at.x);
        let edge = |edge: &Edge| match *edge {
            Edge::Line(to) => Edge::Line(seen(to)),
            Edge::Arc { to, centre, sweep } => {
                Edge::Arc { to: seen(to), centre: seen(centre), sweep: sweep * self.sense() }
            }
        };
        Way { start: seen(way.start), edges: way.edges.iter().map(edge).collect() }
    }

    /// The other way: main, minor and tool coordinate, with a minor one that is given.
    pub fn point(&self, seen: DVec2, minor: f64) -> DVec3 {
        let (along, out) = (seen.x * self.ahead, seen.y * self.away);
        let (radius, z) = if self.face { (along, out) } else { (out, along) };
        DVec3::new(radius, minor, z)
    }

    /// The coordinate that infeeds change, of a level: a diameter where they are radial.
    pub fn level(&self, height: f64) -> f64 {
        height * self.away * if self.face { 1.0 } else { 2.0 }
    }

    /// The level of that coordinate.
    pub fn height(&self, level: f64) -> f64 {
        self.away * level / if self.face { 1.0 } else { 2.0 }
    }

    /// Where the tip of an insert is from the centre of its nose, in nose radii, given which way it points along X and Z;
    /// nothing if it points away from the part or against the feed. By itself it is in front and below.
    pub fn tip(&self, way: Option<DVec2>) -> Option<DVec2> {
        let seen = way.map_or(TIP, |way| self.seen(way.x, way.y));
        (seen.x >= 0.0 && seen.y <= 0.0).then_some(seen)
    }

    /// The sense of arcs in the plane of the tool axis and the main axis, where they turn counter-clockwise as seen.
    pub(super) fn sense(&self) -> f64 {
        self.ahead * self.away * if self.face { -1.0 } else { 1.0 }
    }

    /// An insert as its cuts see it, given the angle of its main edge to the rotary axis and that of its point, degrees.
    pub fn insert(&self, radius: f64, angle: f64, point: f64) -> Insert {
        let known = angle > 0.0 && point > 0.0;
        let along = (angle, angle + point);
        let seen = if self.face { (270.0 - along.1, 270.0 - along.0) } else { along };
        Insert { radius, edges: known.then_some(seen) }
    }
}

/// What is turned.
#[derive(Clone, Debug)]
pub struct Turned {
    /// How its cuts see it.
    pub sight: Sight,
    /// Where the tip may be.
    pub envelope: Envelope,
    /// The tip where the contour begins, and the direction of its first element there.
    pub begin: DVec2,
    /// The direction of the first element.
    pub heading: DVec2,
    /// The tip where the contour ends.
    pub end: DVec2,
    /// Where the cycle began.
    pub start: DVec2,
    /// The set-up clearance, mm.
    pub clearance: f64,
    /// By how much at most the insert stays away from what its nose alone would reach, mm.
    pub left: f64,
    /// Where the contour begins: `x`.
    pub first: f64,
    /// The highest place of the contour without its allowance.
    pub highest: f64,
    /// No cut goes further than this, though the contour ends before: `x`.
    pub limit: f64,
    /// The same beside the contour, where it is cut parallel to it: the outermost first.
    pub cuts_beside: Vec<Turned>,
    /// How far the blank is beside the contour there, mm.
    pub blank: f64,
    /// Whether what is above the contour is cut along it, too, where no level comes to it.
    pub along_contour: bool,
    /// What is left of the blank, where turning updates it: the heights at which the tip touches it.
    pub material: Option<Arc<Envelope>>,
    /// How far back the edge in front of the insert leans, by the mm that it goes up; 0 where it does not.
    pub leans_back: f64,
}

/// A cut at a level.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cut {
    /// Where it begins.
    pub from: f64,
    /// Where it ends.
    pub to: f64,
    /// Whether it begins where there is neither blank nor contour.
    pub begins_free: bool,
}

impl Cut {
    /// Beginning and end.
    pub const fn range(&self) -> [f64; 2] {
        [self.from, self.to]
    }
}

/// How a contour is cut.
#[derive(Clone, Copy, Debug)]
pub struct Cutting {
    /// What stays on it.
    pub allowance: Allowance,
    /// The insert.
    pub insert: Insert,
    /// Where its tip is from the centre of its nose, in nose radii.
    pub tip: DVec2,
    /// What the insert would reach all that is wanted with.
    pub nose: Insert,
    /// How far beside the contour it is cut, mm.
    pub grown: f64,
}

impl Turned {
    /// What is turned of a profile from where a cycle began with a clearance. It may be `solid` in front of the profile
    /// as high as that begins.
    ///
    /// # Errors
    /// The profile goes back where it begins or ends, or has no element.
    pub fn new(
        sight: Sight,
        profile: &Way,
        (allowance, insert, tip): (Allowance, Insert, DVec2),
        at: (DVec2, f64),
        solid: bool,
    ) -> Result<Self, GoesBack> {
        let nose = Insert { edges: None, ..insert };
        Self::of(sight, profile, &Cutting { allowance, insert, tip, nose, grown: 0.0 }, at, solid)
    }

    /// The same, cut as is said.
    ///
    /// # Errors
    /// The profile goes back where it begins or ends, or has no element.
    pub fn of(
        sight: Sight,
        profile: &Way,
        cutting: &Cutting,
        (start, clearance): (DVec2, f64),
        solid: bool,
    ) -> Result<Self, GoesBack> {
        let Cutting { allowance, insert, tip: point, nose, grown } = *cutting;
        let (first, last) = (profile.edges.first().ok_or(GoesBack)?, profile.edges.last().ok_or(GoesBack)?);
        let heading = direction(profile.start, first, false);
        let last_but_one = profile.edges.iter().rev().nth(1).map_or(profile.start, Edge::to);
        let leaving = direction(last_but_one, last, true);
        // Beside the contour the nose acts as a larger one; the tip stays where it is on it.
        let radius = insert.radius + grown;
        let tip = point * if radius > 0.0 { insert.radius / radius } else { 0.0 };
        let longer = 2.0 * (radius + allowance.along.abs()) + clearance;
        // In front of a flank is what the contour goes down into.
        let before = match solid {
            true => DVec2::new(-(longer + (profile.start.x - start.x).max(0.0)), 0.0),
            false => -heading * longer,
        };
        let whole = lengthened(profile, before, leaving * longer);
        let envelope = Envelope::over(&whole, allowance, Insert { radius, ..insert }, tip)?;
        let nose = match nose == insert {
            true => envelope.clone(),
            false => Envelope::over(&whole, allowance, Insert { radius, ..nose }, tip)?,
        };
        let touching = |at: DVec2, along: DVec2| {
            // Of the two corners of an allowance the one that is further out counts.
            let side = if along.y.abs() < COUNTS { 0.0 } else { -along.y.signum() };
            let wide = DVec2::new(side * allowance.along.abs(), allowance.away);
            at + wide + along.perp() * radius + point * insert.radius
        };
        let (mut begin, mut end) = (touching(profile.start, heading), touching(profile.end(), leaving));
        begin.y = envelope.height(begin.x).map_or(begin.y, |height| height.max(begin.y));
        // Where the insert leans against the last wall it cannot go down along it.
        end.y = envelope.height(end.x - SIDE).map_or(end.y, |height| height.max(end.y));
        let highest = highest(profile);
        let left = envelope.above(&nose, [begin.x, end.x]).max(hidden(profile)?);
        let left = if left > REPORTED { left } else { 0.0 };
        let limit = profile.edges.iter().map(|edge| edge.to().x).fold(profile.start.x, f64::max);
        Ok(Self {
            sight,
            envelope,
            begin,
            heading,
            end,
            start,
            clearance,
            left,
            limit,
            highest,
            first: profile.start.x,
            cuts_beside: Vec::new(),
            blank: 0.0,
            along_contour: false,
            material: None,
            leans_back: insert.edges.map_or(0.0, |(front, _)| tand((front - 90.0).clamp(0.0, MOST_LEANING))),
        })
    }

    /// The same, and nothing below a level is turned.
    #[must_use]
    pub fn raised(mut self, level: f64) -> Self {
        self.envelope = self.envelope.raised(level);
        self.begin.y = self.begin.y.max(level);
        self.end.y = self.end.y.max(level);
        self
    }

    /// The same of what is left of a blank, if there is one, that an insert meets with its tip there.
    ///
    /// # Errors
    /// The insert cannot be over it.
    pub fn of_blank(mut self, material: Option<&Arc<Envelope>>) -> Self {
        self.material = material.cloned();
        self
    }

    /// Where an insert touches what is left of a blank; all of it is gone without an outline.
    ///
    /// # Errors
    /// The outline goes back where it begins or ends.
    pub fn over_blank(outline: Option<Way>, insert: Insert, tip: DVec2) -> Result<Envelope, GoesBack> {
        let none = Allowance { along: 0.0, away: 0.0 };
        outline.map_or_else(|| Ok(Envelope::default()), |outline| Envelope::over(&outline, none, insert, tip))
    }

    /// Where cuts begin: where the cycle began, or, where that is within the part, the clearance before it.
    pub fn beginning(&self) -> DVec2 {
        if self.start.x <= self.first + COUNTS {
            return self.start;
        }
        let above = self.highest + self.clearance;
        let x = self.first - self.clearance;
        DVec2::new(x, if self.is_inside() { above } else { self.start.y })
    }

    /// Whether the cycle began within what is to be removed.
    pub fn is_inside(&self) -> bool {
        self.start.x > self.first + COUNTS && self.start.y < self.highest - COUNTS
    }

    /// The lowest place of the contour.
    pub fn bottom(&self) -> f64 {
        let lowest = self.envelope.lowest([self.begin.x, self.limit.max(self.begin.x)]);
        lowest.unwrap_or(self.begin.y).min(self.begin.y)
    }

    /// The height at which the tool crosses what it does not cut.
    pub fn over(&self) -> f64 {
        let begin = self.beginning().x.min(self.begin.x);
        let material = self.material.as_ref().and_then(|material| material.summit([begin, self.limit.max(begin)]));
        let highest = (self.highest + self.blank).max(material.map_or(f64::NEG_INFINITY, |top| top.y));
        self.start.y.max(highest) + self.clearance
    }

    /// The heights between which there is something to cut: where the cycle began and the lowest place of the contour, of a
    /// blank what of it is above the contour.
    pub fn heights(&self) -> [f64; 2] {
        let (from, bottom) = (self.beginning().y, self.bottom());
        let Some(material) = &self.material else { return [from, bottom] };
        let spans = self.touched(bottom, [self.beginning().x, self.limit]);
        let top = spans.iter().filter_map(|span| material.summit(*span)).map(|top| top.y).reduce(f64::max);
        let low = spans.iter().filter_map(|span| self.envelope.lowest(*span)).reduce(f64::min);
        let to = low.map_or(bottom, |low| low.max(bottom));
        [top.unwrap_or(to).max(to), to]
    }

    /// Where there is something of the blank above a level and above the contour, between two places.
    fn touched(&self, level: f64, range: [f64; 2]) -> Vec<[f64; 2]> {
        let material = self.material.as_ref().filter(|_| range[0] < range[1]);
        material.map_or_else(Vec::new, |own| own.higher_than(&self.envelope, level, TOUCHES, range))
    }

    /// The part of the contour along which there is something of the blank, with the clearance at both ends; without a
    /// blank all of it.
    pub fn along_blank(&self) -> Option<[f64; 2]> {
        let whole = [self.begin.x, self.end.x];
        if self.material.is_none() {
            return Some(whole);
        }
        let spans = self.touched(f64::NEG_INFINITY, whole);
        let (first, last) = (spans.first()?[0], spans.last()?[1]);
        Some([(first - self.clearance).max(whole[0]), (last + self.clearance).min(whole[1])])
    }

    /// The cuts at a level after one at another level: of a blank only where something of it is left, with the clearance
    /// before and after it.
    pub fn cuts_after(&self, level: f64, before: f64) -> Vec<Cut> {
        let whole = self.cuts(level);
        if self.material.is_none() {
            return whole.into_iter().map(|[from, to]| Cut { from, to, begins_free: false }).collect();
        }
        let mut found = Vec::new();
        for (number, [from, to]) in whole.iter().copied().enumerate() {
            // What the cut before has left beside this one belongs to it: the tool follows the contour there.
            let outer = self.cut_at(before, from.midpoint(to)).unwrap_or([from, to]);
            let after = number.checked_sub(1).and_then(|last| whole.get(last)).map_or(outer[0], |last| last[1]);
            let until = whole.get(number + 1).map_or(outer[1], |next| next[0]);
            let range = [outer[0].max(after).min(from), outer[1].min(until).max(to)];
            let mut lumps: Vec<[f64; 2]> = Vec::new();
            for span in self.touched(level, range) {
                match lumps.last_mut() {
                    Some(last) if span[0] - last[1] <= 2.0 * self.clearance => last[1] = span[1],
                    _ => lumps.push(span),
                }
            }
            for [first, last] in lumps {
                let begins_free = first - self.clearance > from;
                let begin = if begins_free { (first - self.clearance).min(to) } else { from };
                found.push(Cut { from: begin, to: (last + self.clearance).min(to).max(begin), begins_free });
            }
        }
        found
    }

    /// The cuts at a level: pairs of beginning and end.
    pub fn cuts(&self, level: f64) -> Vec<[f64; 2]> {
        let from = self.beginning().x;
        if from >= self.limit { Vec::new() } else { self.envelope.below(level, [from, self.limit]) }
    }

    /// The cut at a level that a place belongs to.
    pub fn cut_at(&self, level: f64, x: f64) -> Option<[f64; 2]> {
        self.cuts(level).into_iter().find(|[from, to]| *from - COUNTS <= x && x <= *to + COUNTS)
    }

    /// Whether a cut is open towards where cuts begin.
    pub fn is_open(&self, cut: [f64; 2]) -> bool {
        cut[0] <= self.beginning().x + COUNTS
    }

    /// Where the pen is, as cuts see it.
    pub fn here(&self, pen: &Pen) -> DVec2 {
        let here = pen.here();
        self.sight.seen(here.x, here.z)
    }

    /// Straight to a point.
    pub fn line(&self, pen: &mut Pen, to: DVec2, feed: f64) {
        let to = self.sight.point(to, pen.here().y);
        pen.line(to, feed);
    }

    /// Along the envelope to a point of it; the pen is at another one.
    pub fn follow(&self, pen: &mut Pen, to: DVec2, feed: f64) {
        self.follow_down(pen, to, feed, feed);
    }

    /// The same with a feed of its own where it goes down into the part.
    pub fn follow_down(&self, pen: &mut Pen, to: DVec2, feed: f64, plunging: f64) {
        let minor = pen.here().y;
        let way = self.envelope.way(self.here(pen), to);
        let mut at = way.start;
        for edge in way.edges {
            let feed = if edge.to().y < at.y - COUNTS { plunging } else { feed };
            at = edge.to();
            match edge {
                Edge::Line(to) => pen.line(self.sight.point(to, minor), feed),
                Edge::Arc { to, centre, sweep } => {
                    let (centre, to) = (self.sight.point(centre, minor), self.sight.point(to, minor));
                    pen.sideways((centre, to), sweep * self.sight.sense(), feed);
                }
            }
        }
    }
}

/// By how much a profile goes back under itself.
fn hidden(profile: &Way) -> Result<f64, GoesBack> {
    let profile = monotone(profile);
    let none = Allowance { along: 0.0, away: 0.0 };
    let (mut at, mut deepest, mut cover) = (profile.start, 0.0_f64, None);
    for edge in &profile.edges {
        if edge.to().x < at.x - COUNTS {
            let cover = match &cover {
                Some(cover) => cover,
                None => cover.insert(Envelope::over(&profile, none, Insert::default(), DVec2::ZERO)?),
            };
            for share in [0.01, 0.5, 0.99] {
                let point = edge.shortened(at, edge.length(at) * share).to();
                deepest = deepest.max(cover.height(point.x).map_or(0.0, |height| height - point.y));
            }
        }
        at = edge.to();
    }
    Ok(deepest)
}

/// The direction of an edge at its beginning or at its end.
pub(super) fn direction(from: DVec2, edge: &Edge, at_end: bool) -> DVec2 {
    match *edge {
        Edge::Line(to) => (to - from).normalize_or_zero(),
        Edge::Arc { to, centre, sweep } => {
            let arm = if at_end { to - centre } else { from - centre };
            (arm.perp() * sweep.signum()).normalize_or_zero()
        }
    }
}

/// A way that begins and ends further out.
fn lengthened(way: &Way, begin: DVec2, end: DVec2) -> Way {
    let mut edges = Vec::with_capacity(way.edges.len() + 2);
    edges.push(Edge::Line(way.start));
    edges.extend(&way.edges);
    edges.push(Edge::Line(way.end() + end));
    Way { start: way.start + begin, edges }
}

/// The highest place of a way.
pub(super) fn highest(way: &Way) -> f64 {
    let (mut at, mut highest) = (way.start, way.start.y);
    for edge in &way.edges {
        highest = highest.max(edge.to().y);
        if let Edge::Arc { to, centre, sweep } = *edge
            && sweep < 0.0
            && (at.x..=to.x).contains(&centre.x)
        {
            highest = highest.max(centre.y + centre.distance(at));
        }
        at = edge.to();
    }
    highest
}
