//! Closed contours of lines and arcs.
//!
//! Invariant: a boundary is closed, does not cross itself and encloses an area; arcs sweep less than a half turn each
//! inside, and come out as they are.
use std::f64::consts::{PI, TAU};

use cavalier_contours::core::Control;
use cavalier_contours::core::math::Vector2;
use cavalier_contours::polyline::{
    PlineCreation, PlineIntersect, PlineOrientation, PlineSelfIntersectOptions, PlineSource, PlineSourceMut,
    PlineVertex, Polyline, SelfIntersectsInclude, seg_arc_radius_and_center, seg_closest_point,
};
use glam::DVec2;

use super::{NEAR, NO_AREA};

/// Distances that differ by no more than this, mm, are equal.
pub(super) const EQUAL: f64 = 1e-6;

/// A piece of a contour, from where the one before it ended.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Edge {
    /// A straight line to a point.
    Line(DVec2),
    /// An arc to a point.
    Arc {
        /// Where it ends.
        to: DVec2,
        /// Its centre.
        centre: DVec2,
        /// The angle that it sweeps in degrees, counterclockwise positive; at most a full turn.
        sweep: f64,
    },
}

impl Edge {
    /// Where it ends.
    pub fn to(&self) -> DVec2 {
        match *self {
            Self::Line(to) | Self::Arc { to, .. } => to,
        }
    }

    /// Its length in mm, from where it begins.
    pub fn length(&self, from: DVec2) -> f64 {
        match *self {
            Self::Line(to) => from.distance(to),
            Self::Arc { centre, sweep, .. } => from.distance(centre) * sweep.to_radians().abs(),
        }
    }

    /// Its direction at one of its points.
    pub fn heading(&self, from: DVec2, at: DVec2) -> DVec2 {
        match *self {
            Self::Line(to) => (to - from).normalize_or_zero(),
            Self::Arc { centre, sweep, .. } => {
                (at - centre).perp().normalize_or_zero() * if sweep < 0.0 { -1.0 } else { 1.0 }
            }
        }
    }

    /// Its first part of a length in mm.
    pub fn shortened(&self, from: DVec2, length: f64) -> Self {
        let whole = self.length(from);
        let share = if whole > 0.0 { (length / whole).clamp(0.0, 1.0) } else { 0.0 };
        match *self {
            Self::Line(to) => Self::Line(from.lerp(to, share)),
            Self::Arc { centre, sweep, .. } => {
                let sweep = sweep * share;
                Self::Arc { to: centre + turned(from - centre, sweep.to_radians()), centre, sweep }
            }
        }
    }

    /// The same edge the other way, from its end to where it begins.
    pub fn reversed(&self, from: DVec2) -> Self {
        match *self {
            Self::Line(_) => Self::Line(from),
            Self::Arc { centre, sweep, .. } => Self::Arc { to: from, centre, sweep: -sweep },
        }
    }

    /// The point on it that is nearest to a point.
    fn nearest(&self, from: DVec2, point: DVec2) -> DVec2 {
        match *self {
            Self::Line(to) => {
                let (way, square) = (to - from, from.distance_squared(to));
                if square > 0.0 { from + way * ((point - from).dot(way) / square).clamp(0.0, 1.0) } else { from }
            }
            Self::Arc { to, centre, sweep } => {
                let radial = centre + (point - centre).normalize_or_zero() * from.distance(centre);
                if swept(from - centre, point - centre, sweep) <= sweep.abs() {
                    radial
                } else if point.distance(from) <= point.distance(to) {
                    from
                } else {
                    to
                }
            }
        }
    }

    /// The part of it that ends at one of its points.
    fn cut(&self, from: DVec2, end: DVec2) -> Self {
        match *self {
            Self::Line(_) => Self::Line(end),
            Self::Arc { to, .. } if end.distance(to) <= NEAR => *self,
            Self::Arc { centre, sweep, .. } => {
                let angle = if end.distance(from) <= NEAR { 0.0 } else { swept(from - centre, end - centre, sweep) };
                Self::Arc { to: end, centre, sweep: angle * sweep.signum() }
            }
        }
    }

    /// Whether it goes nowhere.
    fn is_point(&self, from: DVec2) -> bool {
        self.length(from) <= NEAR
    }
}

/// Why contour elements are no boundary.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Flaw {
    /// It does not end where it begins.
    Open {
        /// Where it begins.
        from: DVec2,
        /// Where it ends.
        to: DVec2,
    },
    /// It crosses or touches itself at this point.
    Crossing(DVec2),
    /// It encloses nothing.
    NoArea,
}

/// One closed contour, followed in its direction.
#[derive(Clone, Debug)]
pub struct Boundary {
    /// Counterclockwise.
    line: Polyline,
    /// Whether it is followed against the direction of `line`.
    clockwise: bool,
    start: DVec2,
}

impl Boundary {
    /// The boundary that begins at a point and consists of these edges. Ends that miss the start by no more than
    /// `tolerance` (mm) are closed by moving the last point.
    pub fn new(start: DVec2, edges: &[Edge], tolerance: f64) -> Result<Self, Flaw> {
        let mut line = Polyline::with_capacity(edges.len() + 1, true);
        let mut at = start;
        for edge in edges {
            push(&mut line, at, edge);
            at = edge.to();
        }
        if at.distance(start) > tolerance.max(NEAR) {
            return Err(Flaw::Open { from: start, to: at });
        }
        let line = line.remove_repeat_pos(NEAR).unwrap_or(line);
        if !has_area(&line) {
            return Err(Flaw::NoArea);
        }
        let options =
            PlineSelfIntersectOptions { aabb_index: None, pos_equal_eps: NEAR, include: SelfIntersectsInclude::All };
        let mut crossing = None;
        line.visit_self_intersects_opt(
            &mut |found| {
                crossing = Some(match found {
                    PlineIntersect::Basic(found) => point(found.point),
                    PlineIntersect::Overlapping(found) => point(found.point1),
                });
                Control::Break(())
            },
            &options,
        );
        if let Some(crossing) = crossing {
            return Err(Flaw::Crossing(crossing));
        }
        let clockwise = line.orientation() == PlineOrientation::Clockwise;
        Ok(Self { line: if clockwise { inverted(&line) } else { line }, clockwise, start })
    }

    /// Of a line that runs counterclockwise.
    pub(super) fn of(line: Polyline) -> Self {
        let start = line.get(0).map_or(DVec2::ZERO, |vertex| DVec2::new(vertex.x, vertex.y));
        Self { line, clockwise: false, start }
    }

    /// Of a line that is followed in its own sense.
    pub(super) fn of_either_sense(line: Polyline) -> Self {
        let clockwise = line.orientation() == PlineOrientation::Clockwise;
        Self { clockwise, ..Self::of(if clockwise { inverted(&line) } else { line }) }
    }

    /// Counterclockwise.
    pub(super) fn line(&self) -> &Polyline {
        &self.line
    }

    /// Where it begins.
    pub fn start(&self) -> DVec2 {
        self.start
    }

    /// Whether it runs clockwise.
    pub fn is_clockwise(&self) -> bool {
        self.clockwise
    }

    /// The direction in which it begins.
    pub fn heading(&self) -> DVec2 {
        heading(self.start, &self.edges())
    }

    /// The same contour in the other direction.
    pub fn reversed(self) -> Self {
        Self { clockwise: !self.clockwise, ..self }
    }

    /// The same contour and direction from the point on it that is nearest to `point`.
    pub fn from_nearest(&self, near: DVec2) -> Self {
        let found = self.line.closest_point(vector(near), NEAR);
        let turned = found.and_then(|found| {
            let at = found.seg_point;
            Some((self.line.rotate_start(found.seg_start_index, at, NEAR)?, point(at)))
        });
        match turned {
            Some((line, start)) => Self { line, clockwise: self.clockwise, start },
            None => self.clone(),
        }
    }

    /// The point on it that is nearest to a point.
    pub fn nearest(&self, to: DVec2) -> DVec2 {
        nearest_of(points_of(&self.line, to), to).unwrap_or(self.start)
    }

    /// Its length in mm.
    pub fn length(&self) -> f64 {
        self.line.path_length()
    }

    /// The edges from one of its points to another, in its direction.
    pub fn way(&self, from: DVec2, to: DVec2) -> Vec<Edge> {
        let edges = self.from_nearest(from).edges();
        let (mut at, mut best) = (self.nearest(from), (f64::INFINITY, 0, to));
        for (n, edge) in edges.iter().enumerate() {
            let near = edge.nearest(at, to);
            if near.distance(to) < best.0 - NEAR {
                best = (near.distance(to), n, near);
            }
            at = edge.to();
        }
        let (_, last, end) = best;
        let before = if last == 0 { self.nearest(from) } else { edges.get(last - 1).map_or(end, Edge::to) };
        let cut = edges.get(last).map(|edge| edge.cut(before, end));
        let mut way: Vec<Edge> = edges.into_iter().take(last).chain(cut).collect();
        if way.last().is_some_and(|edge| edge.is_point(before)) {
            way.pop();
        }
        way
    }

    /// Its edges in its direction, from its start.
    pub fn edges(&self) -> Vec<Edge> {
        let line = if self.clockwise { inverted(&self.line) } else { self.line.clone() };
        let count = line.vertex_count();
        // The line begins at the start, or ends there when it has been inverted.
        let first = (0..count)
            .min_by(|a, b| {
                let distance = |at: usize| self.start.distance_squared(DVec2::new(line.at(at).x, line.at(at).y));
                distance(*a).total_cmp(&distance(*b))
            })
            .unwrap_or(0);
        let mut edges: Vec<Edge> = Vec::with_capacity(count);
        for n in 0..count {
            let (from, to) = (line.at((first + n) % count), line.at((first + n + 1) % count));
            add(&mut edges, from, to);
        }
        edges
    }
}

/// Of each segment of a line the point that is nearest to a point.
pub(super) fn points_of(line: &Polyline, to: DVec2) -> impl Iterator<Item = DVec2> + Clone + '_ {
    line.iter_segments().map(move |(from, end)| point(seg_closest_point(from, end, vector(to), NEAR)))
}

/// The one of some points that is nearest to a point. Of those that are equally near, but for rounding, the one farthest
/// to the left, then the lowest: the unit of a program must not decide.
pub(super) fn nearest_of(points: impl Iterator<Item = DVec2> + Clone, to: DVec2) -> Option<DVec2> {
    let least = points.clone().map(|point| point.distance(to)).fold(f64::INFINITY, f64::min);
    let near = points.filter(|point| point.distance(to) <= least + EQUAL);
    near.reduce(earliest)
}

/// The one of two points that is farther to the left, or else lower.
pub(super) fn earliest(one: DVec2, other: DVec2) -> DVec2 {
    let is_earlier = if (one.x - other.x).abs() > EQUAL { other.x < one.x } else { other.y < one.y };
    if is_earlier { other } else { one }
}

/// The direction in which edges begin.
pub(super) fn heading(start: DVec2, edges: &[Edge]) -> DVec2 {
    edges.first().map_or(DVec2::X, |edge| edge.heading(start, start))
}

/// Adds a segment; one that continues the arc before it about the same centre is one with it.
pub(super) fn add(edges: &mut Vec<Edge>, from: PlineVertex, to: PlineVertex) {
    let end = DVec2::new(to.x, to.y);
    if from.bulge == 0.0 {
        return edges.push(Edge::Line(end));
    }
    let (_, centre) = seg_arc_radius_and_center(from, to);
    let centre = point(centre);
    let swept = (4.0 * libm::atan(from.bulge)).to_degrees();
    if let Some(Edge::Arc { to, centre: before, sweep }) = edges.last_mut()
        && before.distance(centre) <= 10.0 * NEAR
        && *sweep * swept > 0.0
        && (*sweep + swept).abs() <= 360.0
    {
        (*to, *sweep) = (end, *sweep + swept);
        return;
    }
    edges.push(Edge::Arc { to: end, centre, sweep: swept });
}

/// Adds the vertices of an edge that begins at a point: arcs in pieces of less than a half turn.
pub(super) fn push(line: &mut Polyline, from: DVec2, edge: &Edge) {
    let Edge::Arc { to, centre, sweep } = *edge else {
        return line.add(from.x, from.y, 0.0);
    };
    let sweep = sweep.to_radians().clamp(-TAU, TAU);
    let pieces = (sweep.abs() / (0.75 * PI)).ceil().max(1.0);
    let bulge = libm::tan(sweep / pieces / 4.0);
    let (out, back) = (from - centre, to - centre);
    for n in 0..pieces as u32 {
        // Between its ends the radius goes over from that of the start to that of the end.
        let share = f64::from(n) / pieces;
        let radius = out.length() + (back.length() - out.length()) * share;
        let at = if n == 0 { from } else { centre + turned(out, sweep * share).normalize_or_zero() * radius };
        line.add(at.x, at.y, bulge);
    }
}

/// The angle in degrees, from 0 to 360, from one arm to another in the direction of a sweep.
fn swept(from: DVec2, to: DVec2, sweep: f64) -> f64 {
    let angle = libm::atan2(from.perp_dot(to), from.dot(to)).to_degrees();
    let angle = if sweep < 0.0 { -angle } else { angle };
    if angle < 0.0 { angle + 360.0 } else { angle }
}

fn turned(v: DVec2, angle: f64) -> DVec2 {
    let (sin, cos) = (libm::sin(angle), libm::cos(angle));
    DVec2::new(v.x * cos - v.y * sin, v.x * sin + v.y * cos)
}

pub(super) fn vector(point: DVec2) -> Vector2 {
    Vector2::new(point.x, point.y)
}

pub(super) fn point(vector: Vector2) -> DVec2 {
    DVec2::new(vector.x, vector.y)
}

/// The same line in the other direction.
pub(super) fn inverted(line: &Polyline) -> Polyline {
    let mut line = line.clone();
    line.invert_direction_mut();
    line
}

/// Whether a closed line encloses something.
pub(super) fn has_area(line: &Polyline) -> bool {
    line.vertex_count() > 1 && line.area().abs() > NO_AREA
}
