//! What an insert sweeps in the half plane of turning: a rounded convex polygon on a line or an arc.
//!
//! On a line that is a rounded convex polygon again. On an arc it is the insert where it begins and where it ends, and
//! what its corners and its edges pass over in between. Invariant: lines and arcs stay lines and arcs.
use glam::DVec2;

use super::insert_envelope::{Piece, Shape};
use super::section::{Cell, THIN, arc, between, line};
use crate::base::expr::{atan2d, cosd, sind};

/// Corners of an insert that are farther from its tip, mm, are ends that are not known.
pub const FAR: f64 = 5_000.0;

/// An insert: all that is not farther than its radius from a convex polygon about its tip.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Rounded {
    /// The corners, counter-clockwise; two of them make a line, one a circle.
    corners: Vec<DVec2>,
    radius: f64,
}

/// What was swept: cells that may overlap.
#[derive(Clone, Debug, Default)]
pub struct Swept {
    pub(super) cells: Vec<Cell>,
}

/// A way of the tip.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum TipWay {
    /// Straight.
    Line {
        /// From here.
        from: DVec2,
        /// To here.
        to: DVec2,
    },
    /// On an arc.
    Arc {
        /// Its centre.
        centre: DVec2,
        /// Where it begins.
        from: DVec2,
        /// The angle in degrees, counter-clockwise positive.
        sweep: f64,
    },
}

impl TipWay {
    /// Where it ends.
    pub fn end(&self) -> DVec2 {
        match *self {
            Self::Line { to, .. } => to,
            Self::Arc { centre, from, sweep } => centre + DVec2::new(cosd(sweep), sind(sweep)).rotate(from - centre),
        }
    }
}

impl Rounded {
    /// The convex line around some points, and all that is nearer to it than a radius (mm).
    pub fn around(points: &[DVec2], radius: f64) -> Self {
        Self { corners: hull(points.to_vec()), radius: radius.max(0.0) }
    }

    /// The same, smaller by so much on all sides; of one that is too small for that the nearest thing to it.
    #[must_use]
    pub fn shrunk(&self, by: f64) -> Self {
        let inner = (by - self.radius).max(0.0);
        let radius = (self.radius - by).max(0.0);
        let count = self.corners.len();
        if inner <= 0.0 || count < 3 {
            return Self { corners: self.corners.clone(), radius };
        }
        // Each corner goes inwards so far that both of its sides do by that much.
        let moved = (0..count).map(|n| {
            let (before, at, after) =
                (self.corners[(n + count - 1) % count], self.corners[n], self.corners[(n + 1) % count]);
            let (into, out) = ((at - before).normalize_or_zero().perp(), (after - at).normalize_or_zero().perp());
            let spread = 1.0 + into.dot(out);
            if spread > 1e-6 { at + (into + out) * (inner / spread) } else { at }
        });
        Self { corners: hull(moved.collect()), radius }
    }

    /// What it sweeps while its tip goes a way; `joined` if what it covers where that begins is known to be gone.
    pub fn swept(&self, way: TipWay, joined: bool) -> Swept {
        match way {
            TipWay::Line { from, to } => {
                let mut points: Vec<DVec2> = self.corners.iter().map(|corner| *corner + from).collect();
                if from.distance(to) > THIN {
                    points.extend(self.corners.iter().map(|corner| *corner + to));
                }
                Swept { cells: between(&rounded(&hull(points), self.radius)) }
            }
            TipWay::Arc { centre, from, sweep } => {
                let mut swept = Swept::default();
                if !joined {
                    swept.cells.extend(self.at(from));
                }
                swept.cells.extend(self.at(way.end()));
                let arm = from - centre;
                let turn = Turn { radius: arm.length(), begin: atan2d(arm.y, arm.x), sweep };
                for (n, corner) in self.corners.iter().enumerate() {
                    let next = self.corners[(n + 1) % self.corners.len()];
                    let is_far = |at: DVec2| at.abs().max_element() > FAR;
                    if self.radius > THIN && !is_far(*corner) {
                        turn.of_circle(centre + *corner, self.radius, &mut swept.cells);
                    }
                    if self.corners.len() > 1 && !(is_far(*corner) && is_far(next)) {
                        let out = -(next - *corner).normalize_or_zero().perp() * self.radius;
                        turn.of_side(centre + *corner + out, next - *corner, &mut swept.cells);
                    }
                }
                swept
            }
        }
    }

    /// What it covers at a place.
    fn at(&self, place: DVec2) -> Vec<Cell> {
        let corners: Vec<DVec2> = self.corners.iter().map(|corner| *corner + place).collect();
        between(&rounded(&corners, self.radius))
    }
}

impl Swept {
    /// The same on the other side of the rotary axis.
    pub fn mirrored(&self) -> Self {
        let mirrored = |shape: Shape| match shape {
            Shape::Line { through, slope } => Shape::Line { through: DVec2::new(through.x, -through.y), slope: -slope },
            Shape::Arc { centre, radius, upper } => {
                Shape::Arc { centre: DVec2::new(centre.x, -centre.y), radius, upper: !upper }
            }
        };
        let cells = self.cells.iter().map(|cell| Cell { low: mirrored(cell.high), high: mirrored(cell.low), ..*cell });
        Self { cells: cells.collect() }
    }
}

/// An arc on which something is moved without being turned.
struct Turn {
    radius: f64,
    /// The angle at which it begins, and what it sweeps, degrees.
    begin: f64,
    sweep: f64,
}

impl Turn {
    fn point(&self, centre: DVec2, angle: f64) -> DVec2 {
        centre + DVec2::new(cosd(angle), sind(angle)) * self.radius
    }

    /// What a circle about a point of the arc passes over, but for what it covers at both ends.
    fn of_circle(&self, centre: DVec2, circle: f64, cells: &mut Vec<Cell>) {
        let (outer, inner) = (self.radius + circle, (self.radius - circle).max(0.0));
        let mut pieces = Vec::with_capacity(8);
        let sweep = self.sweep.clamp(-360.0, 360.0);
        arc(centre, outer, [self.begin, sweep], &mut pieces);
        arc(centre, inner, [self.begin, sweep], &mut pieces);
        if sweep.abs() < 360.0 {
            for angle in [self.begin, self.begin + sweep] {
                let out = DVec2::new(cosd(angle), sind(angle));
                line(centre + out * inner, centre + out * outer, &mut pieces);
            }
        }
        cells.extend(between(&pieces));
    }

    /// What a straight side passes over that begins on the arc.
    fn of_side(&self, centre: DVec2, side: DVec2, cells: &mut Vec<Cell>) {
        let along = atan2d(side.y, side.x);
        let sweep = self.sweep.clamp(-360.0, 360.0);
        let (low, high) = (self.begin.min(self.begin + sweep), self.begin.max(self.begin + sweep));
        // Where the side goes along the arc it turns back over what it has passed.
        let first = libm::ceil((low - along - 90.0) / 180.0) * 180.0 + along + 90.0;
        let mut at = low;
        let mut next = first;
        while high - at > THIN {
            if next - at <= THIN {
                next += 180.0;
                continue;
            }
            let end = next.min(high);
            let mut pieces = Vec::with_capacity(8);
            for by in [DVec2::ZERO, side] {
                arc(centre + by, self.radius, [at, end - at], &mut pieces);
            }
            for angle in [at, end] {
                let from = self.point(centre, angle);
                line(from, from + side, &mut pieces);
            }
            cells.extend(between(&pieces));
            at = end;
        }
    }
}

/// The boundary of all that is nearer than a radius to a convex polygon.
fn rounded(corners: &[DVec2], radius: f64) -> Vec<Piece> {
    let count = corners.len();
    let mut pieces = Vec::with_capacity(2 * count + 4);
    if count == 1 {
        arc(corners[0], radius, [0.0, 360.0], &mut pieces);
        return pieces;
    }
    // Outwards of the side that begins at a corner.
    let out = |n: usize| -(corners[(n + 1) % count] - corners[n % count]).normalize_or_zero().perp();
    for n in 0..count {
        let (at, next, normal) = (corners[n], corners[(n + 1) % count], out(n));
        line(at + normal * radius, next + normal * radius, &mut pieces);
        if radius > THIN {
            round(at, radius, out(n + count - 1), normal, &mut pieces);
        }
    }
    pieces
}

/// The arc about a corner from the direction of one normal to that of the next, counter-clockwise and not more than a
/// half turn.
fn round(centre: DVec2, radius: f64, from: DVec2, to: DVec2, pieces: &mut Vec<Piece>) {
    let mut half = |a: DVec2, b: DVec2| {
        let (begin, end) = (centre.x + radius * a.x, centre.x + radius * b.x);
        if (begin - end).abs() > THIN {
            // Counter-clockwise the upper half goes back.
            let shape = Shape::Arc { centre, radius, upper: begin > end };
            pieces.push(Piece { from: begin.min(end), to: begin.max(end), shape });
        }
    };
    let is_half = from.dot(to) < 0.0 && from.perp_dot(to).abs() < 1e-12;
    let side = [DVec2::X, -DVec2::X].into_iter().find(|side| {
        let beyond = if is_half { from.perp_dot(*side) } else { side.perp_dot(to) };
        from.perp_dot(*side) > 0.0 && beyond > 0.0
    });
    match side {
        Some(side) => {
            half(from, side);
            half(side, to);
        }
        None => half(from, to),
    }
}

/// The corners of the convex line around some points, counter-clockwise.
fn hull(mut points: Vec<DVec2>) -> Vec<DVec2> {
    points.sort_by(|a, b| a.x.total_cmp(&b.x));
    // What is as far along the axis but for rounding is so exactly: else it would decide about what is above what.
    let mut place = f64::NEG_INFINITY;
    for point in &mut points {
        place = if point.x - place <= THIN { place } else { point.x };
        point.x = place;
    }
    points.sort_by(|a, b| a.x.total_cmp(&b.x).then(a.y.total_cmp(&b.y)));
    points.dedup_by(|a, b| a.distance(*b) <= THIN);
    if points.len() < 3 {
        return points;
    }
    let mut corners: Vec<DVec2> = Vec::with_capacity(points.len() + 1);
    let mut half = |points: &mut dyn Iterator<Item = DVec2>| {
        let begin = corners.len();
        for point in points {
            while let [.., a, b] = corners[begin..]
                && (b - a).perp_dot(point - b) <= THIN * (point - a).length()
            {
                corners.pop();
            }
            corners.push(point);
        }
        corners.pop();
    };
    half(&mut points.iter().copied());
    half(&mut points.iter().rev().copied());
    corners
}
