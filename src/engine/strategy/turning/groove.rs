//! What is recessed: a groove as the cuts of an insert see it, with what they leave and what finishing makes of it.
//!
//! `x` goes across the groove from where its contour begins, `y` away from the part; positions are those of the
//! corner of the insert that is further in the direction of `x`; the tool table may say that another one is measured. Invariant: coordinates of the main axis
//! are radii here.
use glam::{DVec2, DVec3};

use super::area::{Sight, direction};
use crate::engine::region::groove::{CuttingEdge, EASED};
use crate::engine::region::insert_envelope::{Allowance, Envelope, GoesBack};
use crate::engine::region::{Edge, Way};
use crate::engine::strategy::pen::Pen;

/// So far beside a wall a place is not on it, mm.
const SIDE: f64 = 1e-8;
/// Places between walls that are not further from each other than this are one, mm.
const ONE: f64 = EASED[1] + 4e-7;
/// What calculation may add to a height, mm.
const SPARE: f64 = 1e-8;
/// A level that is so near to the floor is that of the floor, mm.
const NEAR: f64 = 1e-7;
/// So far below a flat floor that is found, and nothing beside it, mm.
const BELOW: f64 = 5e-10;
/// What is lower beside a place by more than this is beyond a wall, mm.
const WALL: f64 = 1e-6;
/// An insert that is narrower by next to nothing is one that fits better if it comes down by more than this, mm.
const DEEPER: f64 = 1e-6;
/// What stays beyond what a nose leaves is reported if it is more than this, mm.
const REPORTED: f64 = 1e-3;
/// What is higher by no more than this, mm, is touched and not cut.
const TOUCHES: f64 = 1e-6;

/// The places of the tip that leave an allowance.
#[derive(Clone, Debug)]
pub struct Reach {
    /// Where it may be.
    pub envelope: Envelope,
    /// Where it touches the begin of the contour.
    pub begin: DVec2,
    /// Where it touches the end.
    pub end: DVec2,
    /// The lowest place.
    pub floor: f64,
    /// Between these two it is on the floor: `x`.
    pub feet: [f64; 2],
}

impl Reach {
    /// What an insert can reach of a profile with an allowance, and by how much at most it stays away from what one of
    /// its corners would reach.
    ///
    /// # Errors
    /// The profile has no element.
    pub fn new(profile: &Way, edge: CuttingEdge, allowance: Allowance, far: f64) -> Result<(Self, f64), GoesBack> {
        let (first, last) = (profile.edges.first().ok_or(GoesBack)?, profile.edges.last().ok_or(GoesBack)?);
        let exact = edge.over(profile, allowance, far)?;
        let before = profile.edges.iter().rev().nth(1).map_or(profile.start, Edge::to);
        let (heading, leaving) = (direction(profile.start, first, false), direction(before, last, true));
        let touching = |at: DVec2, along: DVec2| {
            let side = if along.y.abs() < SPARE { 0.0 } else { -along.y.signum() };
            at + DVec2::new(side * allowance.along.abs(), allowance.away) + along.perp() * edge.radius
        };
        // From the centre of the corner in front to the tip, and from that behind.
        let tip = DVec2::new(edge.radius, -edge.radius);
        let begin = touching(profile.start, heading) + tip + DVec2::new(edge.straight(), 0.0);
        let end = touching(profile.end(), leaving) + tip;
        let reach = |envelope| {
            let mut own = Self { envelope, begin, end, floor: begin.y.min(end.y), feet: [begin.x, end.x] };
            own.find_floor();
            own
        };
        // Between walls that are as far from each other as the insert is wide there is one place, where it comes down
        // to the floor only if it is a little narrower.
        let mut reached = vec![reach(exact)];
        for narrower in EASED {
            reached.push(reach(edge.eased_over(narrower, (profile, allowance, far))?));
        }
        let lowest = reached.iter().map(|own| own.floor).fold(f64::INFINITY, f64::min);
        let own = reached.into_iter().find(|own| own.floor <= lowest + DEEPER).ok_or(GoesBack)?;
        let left = edge.leaves((profile, allowance, far), &own.envelope, [own.begin.x, own.end.x])?;
        Ok((own, if left > REPORTED { left } else { 0.0 }))
    }

    /// Leaves what is beyond a limit as it is: what is lower than a height, and what is on one side of a place.
    pub fn limited(mut self, edge: CuttingEdge, (height, side): (Option<f64>, Option<(f64, bool)>), far: f64) -> Self {
        let top = self.envelope.lowest([self.begin.x - far, self.begin.x]).unwrap_or(self.begin.y);
        let top = self.envelope.summit([self.begin.x - edge.width, self.end.x]).map_or(top, |summit| summit.y.max(top));
        let none = Allowance { along: 0.0, away: 0.0 };
        let line = |from: DVec2, to: DVec2| Way { start: from, edges: vec![Edge::Line(to)] };
        let middle = self.begin.midpoint(self.end);
        let mut add = |way: &Way| {
            if let Ok(limit) = edge.over(way, none, 0.0) {
                self.envelope = self.envelope.higher(&limit);
            }
        };
        if let Some(height) = height {
            let at = DVec2::new(middle.x, height);
            add(&line(at - DVec2::X * far, at + DVec2::X * far));
        }
        if let Some((place, beyond)) = side {
            let at = DVec2::new(place, top);
            if beyond {
                add(&line(at, at + DVec2::X * far));
                self.end.x = self.end.x.min(place);
            } else {
                add(&line(at - DVec2::X * far, at));
                self.begin.x = self.begin.x.max(place + edge.width);
            }
        }
        self.find_floor();
        let (begin, end) = (self.low(self.begin.x), self.low(self.end.x));
        (self.begin.y, self.end.y) = (self.begin.y.max(begin), self.end.y.max(end));
        self
    }

    fn find_floor(&mut self) {
        let range = [self.begin.x, self.end.x];
        let lowest = if range[0] < range[1] { self.envelope.lowest(range) } else { None };
        let middle = self.begin.x.midpoint(self.end.x);
        self.floor = lowest.unwrap_or_else(|| self.low(middle));
        let flat = self.below(self.floor, range);
        self.feet = match (flat.first(), flat.last()) {
            (Some(first), Some(last)) => [first[0], last[1]],
            _ => [middle; 2],
        };
    }

    fn below(&self, level: f64, range: [f64; 2]) -> Vec<[f64; 2]> {
        let exact = if (level - self.floor).abs() < NEAR { self.floor - BELOW } else { level };
        let wide = [range[0] - SIDE, range[1] + SIDE];
        let mut found = self.envelope.below(exact, wide);
        // A round floor and a corner have one lowest place.
        let is_point = found.is_empty();
        if is_point {
            found = self.envelope.below(level + SPARE, wide);
        }
        // Between a wall and a steep flank it is too narrow to be found.
        if found.is_empty()
            && let Some(lowest) = self.envelope.lowest_place(range).filter(|lowest| lowest.y <= level + SPARE)
        {
            found.push([lowest.x; 2]);
        }
        let one_place = |[from, to]: [f64; 2]| match is_point || to - from < ONE {
            true => [from.midpoint(to); 2],
            false => [from.max(range[0]), to.min(range[1])],
        };
        found.into_iter().map(one_place).filter(|[from, to]| from <= to).collect()
    }

    /// The lowest height at a place, on either side of a wall there.
    pub fn low(&self, x: f64) -> f64 {
        let beside = [x - SIDE, x + SIDE].into_iter().filter_map(|x| self.envelope.height(x));
        match (self.envelope.height(x), beside.reduce(f64::min)) {
            (Some(here), Some(beside)) if beside < here - WALL => beside,
            (one, other) => one.or(other).unwrap_or(self.begin.y),
        }
    }

    /// The cuts at a level: pairs of beginning and end.
    pub fn cuts(&self, level: f64) -> Vec<[f64; 2]> {
        if self.end.x - self.begin.x < ONE {
            // An insert as wide as the groove has one place.
            let middle = self.begin.x.midpoint(self.end.x);
            let free = self.begin.x - self.end.x < ONE && self.low(middle) <= level + SPARE;
            return if free { vec![[middle; 2]] } else { Vec::new() };
        }
        self.below(level, [self.begin.x, self.end.x])
    }

    /// Whether the insert has one place between upright walls: it comes straight down to the floor and goes straight out.
    pub fn is_one_place(&self) -> bool {
        let [first, last] = self.feet;
        let wide = [self.begin.x - last, first - last, self.end.x - first].into_iter().map(f64::abs);
        wide.fold(0.0, f64::max) < ONE
    }

    /// Whether nothing is in the way at a height between two places.
    pub fn is_free(&self, height: f64, one: f64, other: f64) -> bool {
        let (from, to) = (one.min(other) + SIDE, one.max(other) - SIDE);
        let whole = |free: &[f64; 2]| free[0] <= from + SIDE && to - SIDE <= free[1];
        from >= to || self.envelope.below(height + SPARE, [from, to]).first().is_some_and(whole)
    }
}

/// What is recessed.
#[derive(Clone, Debug)]
pub struct Groove {
    /// How its cuts see it.
    pub sight: Sight,
    /// The insert.
    pub edge: CuttingEdge,
    /// How far the corner in front is ahead of the position of the tool, mm.
    pub lead: f64,
    /// What roughing leaves.
    pub rough: Reach,
    /// What finishing leaves.
    pub finished: Reach,
    /// Where the cycle began.
    pub start: DVec2,
    /// The height at which the tool goes across: that of where the cycle began, or of the contour.
    pub over: f64,
    /// What roughing leaves on the floor, mm.
    pub allowance: f64,
    /// What is left of the blank, where turning updates it: the heights at which the insert touches it.
    pub material: Option<Envelope>,
}

impl Groove {
    /// The cuts of roughing at a level: pairs of beginning and end; of a blank only where something of it is left.
    pub fn cuts(&self, level: f64) -> Vec<[f64; 2]> {
        let whole = self.rough.cuts(level);
        let Some(material) = &self.material else { return whole };
        let left = |[from, to]: [f64; 2]| {
            if to - from < ONE {
                return self.touches(from.midpoint(to)).is_some_and(|top| top > level + TOUCHES).then_some([from, to]);
            }
            let spans = material.higher_than(&self.rough.envelope, level, TOUCHES, [from, to]);
            Some([spans.first()?[0], spans.last()?[1]])
        };
        whole.into_iter().filter_map(left).collect()
    }

    /// Where the insert touches the blank at a place.
    pub fn touches(&self, x: f64) -> Option<f64> {
        let material = self.material.as_ref()?;
        [x - SIDE, x, x + SIDE].into_iter().filter_map(|x| material.height(x)).reduce(f64::max)
    }

    /// The height at which roughing begins: that at which the tool goes across, of a blank what of it is above the groove.
    pub fn top(&self) -> f64 {
        let Some(material) = &self.material else { return self.over };
        let (rough, range) = (&self.rough, [self.rough.begin.x - SIDE, self.rough.end.x + SIDE]);
        let spans = material.higher_than(&rough.envelope, rough.floor, TOUCHES, range);
        let tops = spans.iter().filter_map(|span| material.summit(*span)).map(|top| top.y);
        tops.fold(rough.floor, f64::max)
    }

    /// What roughing leaves, or what finishing leaves.
    pub const fn reach(&self, rough: bool) -> &Reach {
        if rough { &self.rough } else { &self.finished }
    }

    /// The coordinate across the groove of a place: a diameter where that is one.
    pub fn side(&self, x: f64) -> f64 {
        x * self.sight.ahead * self.scale()
    }

    /// The place of that coordinate.
    pub fn place(&self, side: f64) -> f64 {
        side * self.sight.ahead / self.scale()
    }

    /// What a way across the groove changes that coordinate by.
    pub const fn scale(&self) -> f64 {
        if self.sight.face { 2.0 } else { 1.0 }
    }

    /// Where the pen is, as cuts see it.
    pub fn here(&self, pen: &Pen) -> DVec2 {
        let here = pen.here();
        self.sight.seen(here.x, here.z) + DVec2::X * self.lead
    }

    /// Straight to a point.
    pub fn line(&self, pen: &mut Pen, to: DVec2, feed: f64) {
        let to = self.point(to, pen.here().y);
        pen.line(to, feed);
    }

    /// Where the tool is while its corner in front is at a point: main, minor and tool coordinate.
    fn point(&self, seen: DVec2, minor: f64) -> DVec3 {
        self.sight.point(seen - DVec2::X * self.lead, minor)
    }

    /// Along what the tip can reach to a point of it, from where the pen is or from below there.
    pub fn follow(&self, reach: &Reach, pen: &mut Pen, to: DVec2, feed: f64) {
        let minor = pen.here().y;
        for edge in reach.envelope.way(self.here(pen), to).edges {
            if edge.to().distance(self.here(pen)) < NEAR {
                continue;
            }
            match edge {
                Edge::Line(to) => pen.line(self.point(to, minor), feed),
                Edge::Arc { to, centre, sweep } => {
                    let (centre, to) = (self.point(centre, minor), self.point(to, minor));
                    pen.sideways((centre, to), sweep * self.sight.sense(), feed);
                }
            }
        }
    }
}
