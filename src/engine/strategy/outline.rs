//! Closed paths of the tool in the working plane: outlines of pockets, slots and studs, and the ways to them.
//!
//! Invariant: outlines are counted from a place of the workpiece (a centre and a turn about it); they know nothing of
//! material, levels or cycles.
use glam::{DVec2, DVec3};

use crate::base::expr::{cosd, sind};
use crate::engine::geometry::left_of;

/// Where a figure lies in the working plane.
#[derive(Clone, Copy, Debug)]
pub struct Place {
    /// Its centre.
    pub centre: DVec2,
    /// The direction of its first axis, degrees.
    pub rotation: f64,
}

impl Place {
    /// About a point, main and minor coordinate, turned by an angle in degrees.
    pub fn new(centre: DVec3, rotation: f64) -> Self {
        Self { centre: centre.truncate(), rotation }
    }

    /// The point of the working plane that the figure has there.
    pub fn at(&self, point: DVec2) -> DVec2 {
        let (c, s) = (cosd(self.rotation), sind(self.rotation));
        self.centre + DVec2::new(point.x * c - point.y * s, point.x * s + point.y * c)
    }

    /// The point of the figure that lies there in the working plane.
    pub fn back(&self, point: DVec2) -> DVec2 {
        let (c, s) = (cosd(self.rotation), sind(self.rotation));
        let arm = point - self.centre;
        DVec2::new(arm.x * c + arm.y * s, arm.y * c - arm.x * s)
    }
}

/// A piece of an outline, counter-clockwise about the figure.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Piece {
    /// Straight to its end.
    Line(DVec2),
    /// On an arc: centre, end, direction (+ counter-clockwise).
    Arc(DVec2, DVec2, f64),
}

impl Piece {
    const fn end(&self) -> DVec2 {
        match self {
            Self::Line(end) | Self::Arc(_, end, _) => *end,
        }
    }
}

/// A closed path.
#[derive(Clone, Debug)]
pub struct Outline {
    /// Where it begins and ends.
    pub start: DVec2,
    /// The direction of travel at its beginning.
    pub heading: DVec2,
    pieces: Vec<Piece>,
}

/// The unit vector of an angle in degrees.
pub fn unit(angle: f64) -> DVec2 {
    DVec2::new(cosd(angle), sind(angle))
}

impl Outline {
    /// Its pieces in order, from the start.
    pub fn pieces(&self) -> &[Piece] {
        &self.pieces
    }

    /// A rectangle with half its sides and round corners; it begins in the middle of its right side.
    pub fn rectangle(half: DVec2, corner: f64) -> Self {
        let (a, b, c) = (half.x, half.y, corner);
        let (m, n) = (a - c, b - c);
        let mut pieces = vec![Piece::Line(DVec2::new(a, n))];
        let corners = [
            (DVec2::new(m, n), DVec2::new(m, b), DVec2::new(-m, b)),
            (DVec2::new(-m, n), DVec2::new(-a, n), DVec2::new(-a, -n)),
            (DVec2::new(-m, -n), DVec2::new(-m, -b), DVec2::new(m, -b)),
            (DVec2::new(m, -n), DVec2::new(a, -n), DVec2::new(a, 0.0)),
        ];
        for (centre, after, next) in corners {
            if c > 0.0 {
                pieces.push(Piece::Arc(centre, after, 1.0));
            }
            pieces.push(Piece::Line(next));
        }
        Self { start: DVec2::new(a, 0.0), heading: DVec2::Y, pieces }
    }

    /// A circle; it begins on its right.
    pub fn circle(radius: f64) -> Self {
        let start = DVec2::new(radius, 0.0);
        Self { start, heading: DVec2::Y, pieces: vec![Piece::Arc(DVec2::ZERO, start, 1.0)] }
    }

    /// A slot between two half circles; it begins at its left end.
    pub fn slot(reach: f64, radius: f64) -> Self {
        let (left, right) = (DVec2::new(-reach, 0.0), DVec2::new(reach, 0.0));
        let (up, out) = (DVec2::new(0.0, radius), DVec2::new(radius, 0.0));
        Self {
            start: left - out,
            heading: -DVec2::Y,
            pieces: vec![
                Piece::Arc(left, left - up, 1.0),
                Piece::Line(right - up),
                Piece::Arc(right, right + up, 1.0),
                Piece::Line(left + up),
                Piece::Arc(left, left - out, 1.0),
            ],
        }
    }

    /// A slot along a circle between two half circles; it begins at the end of the first half circle. The opening
    /// angle is positive; from 360 degrees on it is a whole ring.
    pub fn band(radius: f64, begin: f64, opening: f64, half: f64) -> Self {
        let first = unit(begin);
        let last = if opening >= 360.0 { first } else { unit(begin + opening) };
        let start = first * radius - left_of(first) * half;
        let mut pieces = vec![Piece::Arc(first * radius, first * (radius + half), 1.0)];
        if opening > 0.0 {
            pieces.push(Piece::Arc(DVec2::ZERO, last * (radius + half), 1.0));
        }
        pieces.push(Piece::Arc(last * radius, last * (radius - half), 1.0));
        if opening > 0.0 {
            pieces.push(Piece::Arc(DVec2::ZERO, first * (radius - half), -1.0));
        }
        pieces.push(Piece::Arc(first * radius, start, 1.0));
        // The first half circle is entered in its middle, on the way outwards.
        Self { start, heading: first, pieces }
    }

    /// The same path in the other direction if that is clockwise.
    pub fn towards(self, direction: f64) -> Self {
        if direction > 0.0 {
            return self;
        }
        let mut ends: Vec<DVec2> = std::iter::once(self.start).chain(self.pieces.iter().map(Piece::end)).collect();
        ends.pop();
        let pieces = self.pieces.iter().rev().zip(ends.into_iter().rev());
        let pieces = pieces
            .map(|(piece, end)| match piece {
                Piece::Line(_) => Piece::Line(end),
                Piece::Arc(centre, _, direction) => Piece::Arc(*centre, end, -direction),
            })
            .collect();
        Self { start: self.start, heading: -self.heading, pieces }
    }
}

/// A quarter circle by which the tool joins an outline or leaves it.
#[derive(Clone, Copy, Debug)]
pub struct Tangent {
    /// Its centre.
    pub centre: DVec2,
    /// Where the tool begins to join.
    pub before: DVec2,
    /// Where it has left.
    pub after: DVec2,
    /// Counter-clockwise if positive.
    pub direction: f64,
}

impl Tangent {
    /// On the left of the direction of travel if `left` is positive.
    pub fn at(outline: &Outline, radius: f64, left: f64) -> Self {
        let centre = outline.start + left_of(outline.heading) * (radius * left);
        let arm = outline.heading * radius;
        Self { centre, before: centre - arm, after: centre + arm, direction: left }
    }
}
