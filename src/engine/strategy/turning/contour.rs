//! Strategies that turn the contour of a subprogram: what is turned of it, and cuts parallel to it.
//!
//! Cuts along the axes, and finishing, are those of shoulders ([`cuts`](super::cuts)). On which side of the contour
//! the tool works, and how cuts parallel to it are spread, is decided in `cycle-specs/errata.yaml`. Invariant: what lies
//! under a part of the contour that goes back stays, and is told as left.
use glam::{DVec2, DVec3};

use super::area::{Cutting, Sight, Turned, direction, highest};
use super::cuts::turned;
use super::insert_report::{Held, hold};
use super::shoulder::{area_of, insert_of, material_of};
use crate::base::expr::{atan2d, tand};
use crate::engine::region::insert_envelope::{Allowance, GoesBack, Insert, monotone};
use crate::engine::region::{Edge, Way};
use crate::engine::report::ending::Done;
use crate::engine::report::fault::Fault;
use crate::engine::strategy::action::{Action, Control};
use crate::engine::strategy::contour::{Contours, OverContours};
use crate::engine::strategy::milling::{shape_impossible, too_many};
use crate::engine::strategy::pen::{Cutter, Pen};
use crate::engine::strategy::signature::{results, strategy};

/// The feed that means rapid traverse.
const RAPID: f64 = 99_999.999;
/// More cuts than this are refused.
const MOST_CUTS: f64 = 10_000.0;
/// What calculation may add to a whole number of cuts.
const SPARE: f64 = 1e-9;
/// Directions that differ by less are the same.
const SAME: f64 = 1e-9;
/// Inside corners are reckoned no sharper than this, degrees.
const SHARPEST: f64 = 170.0;
/// The direction of the back edge of an insert that cannot go down anywhere, degrees.
const NEVER_DOWN: f64 = 180.0;
/// That of a front edge that leans nowhere.
const UPRIGHT: f64 = 90.0;

strategy! {
    /// The contour of a subprogram is turned, from where the cycle began.
    AreaOfTurningContour = "area-of-turning-contour" {
        /// Whether the cuts go across the rotary axis.
        face: bool = Number,
        /// Where the cycle began, with a diameter as its main coordinate.
        start: DVec3 = Length,
        /// Whether the contour is machined against the direction in which it is programmed.
        reversed: bool = Number,
        /// Whether the tool goes down into the part where the contour does; by itself it does.
        undercuts: Option<bool> = Number,
        /// Whether the limits hold.
        limited: Option<bool> = Number,
        /// A diameter; the tool works on the side of it where it is.
        limit_diameter: Option<f64> = Length,
        /// A coordinate on the rotary axis, likewise.
        limit_z: Option<f64> = Length,
        /// What stays on diameters, mm.
        diameter_oversize: f64 = Length,
        /// What stays along the rotary axis, mm.
        z_oversize: f64 = Length,
        /// The set-up clearance, mm.
        clearance: f64 = Length,
        /// The greatest infeed, mm.
        depth: f64 = Length,
        /// For cuts parallel to the contour: how far the blank is from it, mm.
        blank: Option<f64> = Length,
        /// Whether these are all at the same distance; otherwise chips have the same section.
        equidistant: Option<bool> = Number,
    }
}

results! {
    /// The levels of an area that is turned: diameters, or coordinates on the rotary axis.
    ContourArea {
        /// Where infeeds begin.
        from: f64 = Length,
        /// Where they end.
        to: f64 = Length,
        /// The infeed, all being the same.
        infeed: f64 = Length,
        /// What the insert cannot reach, mm.
        left: f64 = Length,
        /// How many cuts there are parallel to the contour.
        count: f64 = Number,
        /// Where the contour begins on the rotary axis.
        start_z: f64 = Length,
    }
}

strategy! {
    /// To the beginning of a cut parallel to the contour at rapid traverse: out, and in again in front of it.
    InfeedToParallelCut = "infeed-to-parallel-cut" {
        /// Its number, from 1.
        cut: f64 = Number,
    }
}

strategy! {
    /// A cut parallel to the contour; the tool is in front of it.
    CutParallelToContour = "cut-parallel-to-contour" {
        /// Its number, from 1.
        cut: f64 = Number,
        /// The feed, mm/min.
        at: f64 = Feed,
    }
}

strategy! {
    /// Out to where the cycle began, if the tool is not there yet.
    RetractFromParallelCut = "retract-from-parallel-cut" {
        /// The feed, mm/min.
        at: f64 = Feed,
    }
}

strategy! {
    /// To where cuts begin at rapid traverse, over the blank.
    ReturnToParallelCut = "return-to-parallel-cut" {}
}

impl AreaOfTurningContour {
    /// How the cuts see the contour. Outside is where the tool is not nearer to the axis than the end of the contour that
    /// has the greater coordinate on it; a face looks towards greater coordinates.
    fn sight(&self, way: &Way) -> Sight {
        let (from, to) = (way.start, way.end());
        let along = if self.face { to.y - from.y } else { to.x - from.x };
        let front = if to.x > from.x { to.y } else { from.y };
        let inside = !self.face && self.start.x / 2.0 < front - SAME;
        let ahead = match along {
            along if along.abs() <= SAME => -1.0,
            along => along.signum(),
        };
        Sight { face: self.face, ahead, away: if inside { -1.0 } else { 1.0 } }
    }

    fn allowance(&self) -> Allowance {
        let (across, along) = (self.diameter_oversize / 2.0, self.z_oversize);
        match self.face {
            true => Allowance { along: across, away: along },
            false => Allowance { along, away: across },
        }
    }

    /// The distances of the cuts parallel to the contour, the last one being 0.
    fn distances(&self, profile: &Way, blank: f64) -> Result<Vec<f64>, Fault> {
        let allowance = self.allowance();
        let whole = (blank - allowance.along.abs().min(allowance.away)).max(0.0);
        if !(self.depth > 0.0) {
            return Err(Fault::program("parameter-out-of-range").arg("q", "").arg("value", self.depth));
        }
        let least = libm::ceil(whole / self.depth - SPARE).max(1.0);
        let (length, turn) = (profile.length(), turned_by(profile));
        let section = |distance: f64| distance * (length + turn * distance / 2.0);
        let distance_of = |section: f64| {
            if turn.abs() < SAME {
                return section / length;
            }
            (libm::sqrt((length * length + 2.0 * turn * section).max(0.0)) - length) / turn
        };
        // Where a cut would have no length any more there is no section to share.
        let equal = self.equidistant == Some(true) || length + turn * whole <= 0.0;
        let mut count = least;
        loop {
            if !(count <= MOST_CUTS) {
                return Err(too_many(MOST_CUTS));
            }
            let distance = |cut: f64| match equal {
                true => whole * cut / count,
                false => distance_of(section(whole) * cut / count),
            };
            let found: Vec<f64> = (0..count as u32).rev().map(|cut| distance(f64::from(cut))).collect();
            let mut before = whole;
            let deepest = found.iter().map(|to| std::mem::replace(&mut before, *to) - to).fold(0.0, f64::max);
            if deepest <= self.depth + SPARE {
                return Ok(found);
            }
            count += 1.0;
        }
    }
}

impl Action for AreaOfTurningContour {
    type Results = ContourArea;

    fn act(&self, control: &mut dyn Control) -> Done<ContourArea> {
        let programmed = control.read_turned_contour()?;
        let way = if self.reversed { programmed.reversed() } else { programmed };
        let sight = self.sight(&way);
        let start = sight.seen(self.start.x / 2.0, self.start.z);
        let limit = sight.seen(self.limit_diameter.unwrap_or_default() / 2.0, self.limit_z.unwrap_or_default());
        let limited = self.limited == Some(true);
        let mut profile = monotone(&sight.seen_way(&way));
        if limited {
            profile = within(&profile, start, limit.x)?;
        }
        let (mut insert, tip) = insert_of(control, sight)?;
        let whole = insert;
        let mut nose = Insert { edges: None, ..insert };
        if self.undercuts == Some(false) {
            let (front, back) = insert.edges.unwrap_or((UPRIGHT, NEVER_DOWN));
            insert.edges = Some((front, back.max(NEVER_DOWN)));
            nose.edges = Some((UPRIGHT, NEVER_DOWN));
        }
        let material = material_of(control, sight, whole, tip)?;
        // Where the contour begins by going down, it goes down from what is in front of it.
        let solid = profile.edges.first().is_some_and(|edge| direction(profile.start, edge, false).y < -SAME);
        let of = |grown: f64| {
            let cutting = Cutting { allowance: self.allowance(), insert, tip, nose, grown };
            let turned = Turned::of(sight, &profile, &cutting, (start, self.clearance), solid);
            let turned = turned.map_err(|GoesBack| shape_impossible(0.0, 0.0))?;
            let turned = turned.of_blank(material.as_ref());
            Ok::<_, Fault>(if limited && start.y >= limit.y { turned.raised(limit.y) } else { turned })
        };
        let mut turned = of(0.0)?;
        turned.along_contour = true;
        if let Some(blank) = self.blank {
            let distances = self.distances(&profile, blank.abs())?;
            turned.cuts_beside = distances.into_iter().map(of).collect::<Result<_, _>>()?;
            turned.blank = blank.abs();
        }
        let area = area_of(&turned, self.depth)?;
        let start_z = sight.point(profile.start, 0.0).z;
        let count = turned.cuts_beside.len() as f64;
        control.keep_turned(turned);
        hold(control, sight, Held::Pointed(whole, tip))?;
        Ok(ContourArea { from: area.from, to: area.to, infeed: area.infeed, left: area.left, count, start_z })
    }
}

/// How much longer the way beside a way is, in its distance: by the arcs round its outside corners, less what falls away
/// of either side in its inside corners.
fn turned_by(way: &Way) -> f64 {
    let (mut at, mut before, mut whole) = (way.start, None, 0.0);
    for edge in &way.edges {
        let (from, to) = (direction(at, edge, false), direction(at, edge, true));
        let before = before.replace(to).unwrap_or(from);
        let angle = atan2d(before.perp_dot(from), before.dot(from));
        whole -= if angle > 0.0 { 2.0 * tand(angle.min(SHARPEST) / 2.0) } else { angle.to_radians() };
        if let Edge::Arc { sweep, .. } = edge {
            whole -= sweep.to_radians();
        }
        at = edge.to();
    }
    whole
}

/// The part of a way that is on the same side of a place as the tool; at the place there is a wall.
fn within(way: &Way, tool: DVec2, place: f64) -> Result<Way, Fault> {
    let top = highest(way).max(tool.y);
    let wall = DVec2::new(place, top);
    if tool.x <= place {
        return before(way, wall);
    }
    let (mut at, mut after) = (way.start, None);
    for edge in &way.edges {
        let (from, to) = (at, edge.to());
        at = to;
        match &mut after {
            None if from.x > place => after = Some((from, vec![*edge])),
            None if to.x > place => {
                let crosses = from.x < place;
                let point = if crosses { crossing(from, edge, place) } else { from };
                let rest = if crosses { parts(from, edge, point).1 } else { *edge };
                after = Some((point, vec![rest]));
            }
            None => {}
            Some((_, edges)) => edges.push(*edge),
        }
    }
    match after {
        None => Err(shape_impossible(0.0, 0.0)),
        Some((start, edges)) if start.x > place + SAME || way.start.x >= place => Ok(Way { start, edges }),
        Some((start, edges)) => {
            let down = (start.y < top).then_some(Edge::Line(start));
            Ok(Way { start: wall, edges: down.into_iter().chain(edges).collect() })
        }
    }
}

/// The part of a way that is before a wall, from its beginning there; where it comes back from behind the wall, as an
/// overhang does, it goes on up the wall.
fn before(way: &Way, wall: DVec2) -> Result<Way, Fault> {
    let place = wall.x;
    if way.start.x > place {
        return Err(shape_impossible(0.0, 0.0));
    }
    let (mut at, mut found) = (way.start, Way { start: way.start, edges: Vec::new() });
    for edge in &way.edges {
        let (from, to) = (at, edge.to());
        at = to;
        let crosses = (from.x - place) * (to.x - place) < 0.0;
        let point = if crosses { crossing(from, edge, place) } else { to };
        let (begin, piece) = match (crosses, to.x <= place) {
            (false, true) if from.x <= place => (from, *edge),
            (true, false) => (from, parts(from, edge, point).0),
            (true, true) => (point, parts(from, edge, point).1),
            (false, _) => continue,
        };
        if found.end().distance(begin) > SAME {
            found.edges.push(Edge::Line(begin));
        }
        found.edges.push(piece);
    }
    if at.x > place && found.end().y < wall.y {
        found.edges.push(Edge::Line(wall));
    }
    if found.edges.is_empty() { Err(shape_impossible(0.0, 0.0)) } else { Ok(found) }
}

/// Where an edge that does not turn back is at a place between its ends.
fn crossing(from: DVec2, edge: &Edge, place: f64) -> DVec2 {
    match *edge {
        Edge::Line(to) => from.lerp(to, (place - from.x) / (to.x - from.x)),
        Edge::Arc { to, centre, sweep } => {
            let radius = from.distance(centre);
            let rise = libm::sqrt((radius * radius - (place - centre.x) * (place - centre.x)).max(0.0));
            let upper = (sweep < 0.0) == (to.x > from.x);
            DVec2::new(place, centre.y + if upper { rise } else { -rise })
        }
    }
}

/// An edge before and after one of its points.
fn parts(from: DVec2, edge: &Edge, point: DVec2) -> (Edge, Edge) {
    match *edge {
        Edge::Line(to) => (Edge::Line(point), Edge::Line(to)),
        Edge::Arc { to, centre, sweep } => {
            let (a, b) = (from - centre, point - centre);
            let first = atan2d(a.perp_dot(b), a.dot(b));
            (Edge::Arc { to: point, centre, sweep: first }, Edge::Arc { to, centre, sweep: sweep - first })
        }
    }
}

/// What is turned with a cut parallel to it.
fn beside(contours: &Contours, cut: f64) -> Result<(&Turned, &Turned), Fault> {
    let whole = turned(contours)?;
    let found = (cut >= 1.0).then(|| whole.cuts_beside.get((cut - 1.0) as usize)).flatten();
    let wrong = || Fault::program("parameter-out-of-range").arg("q", "").arg("value", cut);
    Ok((whole, found.ok_or_else(wrong)?))
}

impl OverContours for InfeedToParallelCut {
    fn mill(&self, contours: &Contours, _: Cutter, pen: &mut Pen) -> Result<(), Fault> {
        let (whole, cut) = beside(contours, self.cut)?;
        let Some([from, _]) = cut.along_blank() else { return Ok(()) };
        if from > cut.begin.x + SAME {
            let to = DVec2::new(from, cut.envelope.height(from).unwrap_or(cut.begin.y));
            let over = whole.over().max(whole.here(pen).y);
            whole.line(pen, DVec2::new(whole.here(pen).x, over), RAPID);
            whole.line(pen, DVec2::new(from, over), RAPID);
            whole.line(pen, DVec2::new(from, (to.y + cut.clearance).min(over)), RAPID);
            return Ok(());
        }
        // What the cut before has left, or the blank, is as far in front of this cut.
        let before = (self.cut >= 2.0).then(|| whole.cuts_beside.get((self.cut - 2.0) as usize)).flatten();
        let thick = before.map_or(whole.blank, |before| before.begin.distance(cut.begin));
        let here = whole.here(pen);
        let x = (cut.begin.x - cut.clearance - thick).min(here.x);
        let over = if here.x <= x { here.y } else { whole.over().max(here.y) };
        whole.line(pen, DVec2::new(here.x, over), RAPID);
        whole.line(pen, DVec2::new(x, over), RAPID);
        // Where the contour goes down from its beginning, there is material in front of it.
        let deep = if cut.heading.y < -SAME { cut.begin.y + thick + cut.clearance } else { cut.begin.y };
        whole.line(pen, DVec2::new(x, deep.min(over)), RAPID);
        Ok(())
    }
}

impl OverContours for CutParallelToContour {
    fn mill(&self, contours: &Contours, _: Cutter, pen: &mut Pen) -> Result<(), Fault> {
        let (whole, cut) = beside(contours, self.cut)?;
        let Some([from, until]) = cut.along_blank() else { return Ok(()) };
        let at = |x: f64, end: DVec2| match cut.envelope.height(x) {
            Some(height) if (x - end.x).abs() > SAME => DVec2::new(x, height),
            _ => end,
        };
        let (begin, end) = (at(from, cut.begin), at(until, cut.end));
        if from > cut.begin.x + SAME {
            whole.line(pen, begin, self.at);
            cut.follow(pen, end, self.at);
            return Ok(());
        }
        let here = whole.here(pen);
        if here.y > cut.begin.y {
            whole.line(pen, DVec2::new(cut.begin.x, here.y), self.at);
        }
        whole.line(pen, cut.begin, self.at);
        cut.follow(pen, end, self.at);
        Ok(())
    }
}

impl OverContours for RetractFromParallelCut {
    fn mill(&self, contours: &Contours, _: Cutter, pen: &mut Pen) -> Result<(), Fault> {
        let whole = turned(contours)?;
        let here = whole.here(pen);
        whole.line(pen, DVec2::new(here.x, here.y.max(whole.start.y)), self.at);
        Ok(())
    }
}

impl OverContours for ReturnToParallelCut {
    fn mill(&self, contours: &Contours, _: Cutter, pen: &mut Pen) -> Result<(), Fault> {
        let whole = turned(contours)?;
        let (here, x) = (whole.here(pen), whole.beginning().x);
        if whole.material.is_some() && here.x <= x + SAME {
            return Ok(());
        }
        let over = whole.over().max(here.y);
        whole.line(pen, DVec2::new(here.x, over), RAPID);
        whole.line(pen, DVec2::new(x, over), RAPID);
        Ok(())
    }
}
