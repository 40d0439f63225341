//! Undercuts of turned contours: what a corner between a surface along the rotary axis and a face becomes, as DIN 509 has
//! its forms E, F and H, DIN 76 the undercuts of threads, and the controls their forms K and U.
//!
//! The manuals of the cycles do not print these shapes; they are common knowledge of the trade (`docs/contours.md`).
//! Invariant: plain geometry in the plane of contours, `x` along the rotary axis, `y` a radius.
use glam::DVec2;

use super::element::{Element, Shape, broken, rounded};
use crate::base::expr::{cosd, sind, tand};

/// What is shorter than this, mm, or turns by less, is nothing.
const NOTHING: f64 = 1e-9;
/// Sizes by DIN 509: up to which diameter, depth, breadth, radius, depth in the face, mm.
const SIZES: [[f64; 5]; 6] = [
    [1.6, 0.1, 0.5, 0.1, 0.1],
    [3.0, 0.1, 1.0, 0.2, 0.1],
    [10.0, 0.2, 2.0, 0.2, 0.1],
    [18.0, 0.2, 2.0, 0.6, 0.1],
    [80.0, 0.3, 2.5, 0.6, 0.2],
    [f64::INFINITY, 0.4, 4.0, 1.0, 0.3],
];
/// The angle of the slope, and that of the face to a right angle, by DIN 509, degrees.
const ANGLES: [f64; 2] = [15.0, 8.0];
/// Sizes by DIN 76: the pitch; by how much less than the thread an outside undercut has in diameter, and how broad it is;
/// by how much more an inside one has, and how broad it is; the radius, mm.
const THREADS: [[f64; 6]; 24] = [
    [0.2, 0.3, 0.7, 0.1, 1.2, 0.1],
    [0.25, 0.4, 0.9, 0.1, 1.4, 0.12],
    [0.3, 0.5, 1.05, 0.1, 1.6, 0.16],
    [0.35, 0.6, 1.2, 0.2, 1.9, 0.16],
    [0.4, 0.7, 1.4, 0.2, 2.2, 0.2],
    [0.45, 0.7, 1.6, 0.3, 2.4, 0.2],
    [0.5, 0.8, 1.75, 0.3, 2.7, 0.2],
    [0.6, 1.0, 2.1, 0.3, 3.3, 0.4],
    [0.7, 1.1, 2.45, 0.3, 3.8, 0.4],
    [0.75, 1.2, 2.6, 0.3, 4.0, 0.4],
    [0.8, 1.3, 2.8, 0.3, 4.2, 0.4],
    [1.0, 1.6, 3.5, 0.5, 5.2, 0.6],
    [1.25, 2.0, 4.4, 0.5, 6.7, 0.6],
    [1.5, 2.3, 5.2, 0.5, 7.8, 0.8],
    [1.75, 2.6, 6.1, 0.5, 9.1, 1.0],
    [2.0, 3.0, 7.0, 0.5, 10.3, 1.0],
    [2.5, 3.6, 8.7, 0.5, 13.0, 1.2],
    [3.0, 4.4, 10.5, 0.5, 15.2, 1.6],
    [3.5, 5.0, 12.0, 0.5, 17.7, 1.6],
    [4.0, 5.7, 14.0, 0.5, 20.0, 2.0],
    [4.5, 6.4, 16.0, 0.5, 23.0, 2.0],
    [5.0, 7.0, 17.5, 0.5, 26.0, 2.5],
    [5.5, 7.7, 19.0, 0.5, 28.0, 3.2],
    [6.0, 8.3, 21.0, 0.5, 30.0, 3.2],
];
/// The angle of the slope of the undercut of a thread by DIN 76, degrees.
const THREAD_ANGLE: f64 = 30.0;
/// By how many pitches the bore of a metric thread is less than the thread in diameter.
const BORE: f64 = 1.082_532;
/// The angle to the rotary axis at which form K goes into the corner, degrees.
const DIAGONAL: f64 = 45.0;

/// The forms.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Form {
    /// In the surface, with a slope.
    E,
    /// In the surface and in the face.
    F,
    /// In the surface, with a slope that a rounding leads to the face.
    H,
    /// A notch into the corner.
    K,
    /// In the surface, with walls at right angles.
    U,
    /// After a thread.
    Thread,
}

/// An undercut; what is not given is as its standard has it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Undercut {
    pub(crate) form: Form,
    /// The radius of its inner corners, mm.
    pub(crate) radius: Option<f64>,
    /// How deep it is in the surface, of form K along the rotary axis, mm.
    pub(crate) depth: Option<f64>,
    /// How far it reaches from the face, mm.
    pub(crate) breadth: Option<f64>,
    /// The angle of its slope, degrees.
    pub(crate) angle: Option<f64>,
    /// How deep it is in the face, mm.
    pub(crate) face_depth: Option<f64>,
    /// The angle of its slope in the face to a right angle, degrees.
    pub(crate) face_angle: Option<f64>,
    /// At its outer edge: a rounding, or a chamfer, mm.
    pub(crate) edge: Option<(f64, bool)>,
    /// The angle of a notch to the rotary axis, degrees.
    pub(crate) rotation: Option<f64>,
    /// The angle between the sides of a notch, degrees.
    pub(crate) opening: Option<f64>,
    /// The pitch of the thread, mm.
    pub(crate) pitch: Option<f64>,
}

/// What becomes of a corner.
#[derive(Clone, Copy, Debug)]
pub(super) enum Treated {
    Sharp,
    Round(f64),
    Chamfer(f64),
}

impl Treated {
    /// An edge with a rounding, or a chamfer, or nothing.
    pub(super) const fn edge(edge: Option<(f64, bool)>) -> Self {
        match edge {
            None => Self::Sharp,
            Some((size, false)) => Self::Round(size),
            Some((size, true)) => Self::Chamfer(size),
        }
    }
}

/// The way from a point through treated corners to another one: its first element, those between, and its last one.
/// Nothing where a corner has no room.
pub(super) fn through(
    from: DVec2,
    corners: &[(DVec2, Treated)],
    to: DVec2,
) -> Option<(Element, Vec<Element>, Element)> {
    let mut way = vec![Element::line(from, corners.first()?.0)];
    for (index, (at, treated)) in corners.iter().enumerate() {
        let before = way.pop()?;
        let after = Element::line(*at, corners.get(index + 1).map_or(to, |(next, _)| *next));
        let (before, between, after) = match *treated {
            Treated::Sharp => (before, None, after),
            Treated::Round(radius) => rounded(&before, &after, radius)?,
            Treated::Chamfer(leg) => broken(&before, &after, leg)?,
        };
        way.push(before);
        way.extend(between);
        way.push(after);
    }
    let (last, first) = (way.pop()?, way.remove(0));
    Some((first, way, last))
}

/// A corner: where it is, the direction of its surface there, and that of its face.
struct At {
    corner: DVec2,
    along: DVec2,
    up: DVec2,
}

/// The sizes of an undercut in a surface.
struct Sizes {
    depth: f64,
    breadth: f64,
    radius: f64,
    /// The angle of the slope, if it has one.
    angle: Option<f64>,
    face_depth: f64,
}

impl Undercut {
    /// One of which nothing but the form is given.
    pub(crate) const fn of(form: Form) -> Self {
        Self {
            form,
            radius: None,
            depth: None,
            breadth: None,
            angle: None,
            face_depth: None,
            face_angle: None,
            edge: None,
            rotation: None,
            opening: None,
            pitch: None,
        }
    }

    /// A corner of a surface and a face, one after the other in either order, with the undercut: what is left of the
    /// first one, the elements of the undercut, what follows of the second one. Nothing where they are no such corner,
    /// where there is no room, or where a size is missing.
    pub(crate) fn between(&self, first: &Element, second: &Element) -> Option<(Element, Vec<Element>, Element)> {
        if first.shape != Shape::Line || second.shape != Shape::Line {
            return None;
        }
        let is_surface = |line: &Element| (line.to - line.from).y.abs() <= NOTHING;
        let is_face = |line: &Element| (line.to - line.from).x.abs() <= NOTHING;
        if is_surface(first) && is_face(second) {
            return self.in_corner(first, second);
        }
        if !is_face(first) || !is_surface(second) {
            return None;
        }
        // The surface comes last: the same the other way round.
        let (surface, between, face) = self.in_corner(&second.reversed(), &first.reversed())?;
        let between = between.iter().rev().map(Element::reversed).collect();
        Some((face.reversed(), between, surface.reversed()))
    }

    fn in_corner(&self, surface: &Element, face: &Element) -> Option<(Element, Vec<Element>, Element)> {
        let (along, up) = (surface.to - surface.from, face.to - face.from);
        let at = At { corner: surface.to, along: along.normalize_or_zero(), up: up.normalize_or_zero() };
        let corners = match self.form {
            Form::H => self.rounded_slope(&at)?,
            Form::K => self.notch(&at)?,
            Form::E | Form::F | Form::U | Form::Thread => self.in_surface(&at)?,
        };
        let (first, last) = (corners.first()?.0, corners.last()?.0);
        let (reach, rise) = ((at.corner - first).dot(at.along), (last - at.corner).dot(at.up));
        if !(reach > NOTHING) || !(reach < along.length() - NOTHING) || !(rise < up.length() - NOTHING) {
            return None;
        }
        through(surface.from, &corners, face.to)
    }

    fn sizes(&self, at: &At) -> Option<Sizes> {
        let diameter = 2.0 * at.corner.y.abs();
        // Depth and breadth, radius, angle of the slope, depth in the face.
        let (standard, radius, angle, face_depth) = match self.form {
            Form::E | Form::F => {
                let [_, depth, breadth, radius, face] = *SIZES.iter().find(|row| diameter <= row[0])?;
                let face = if self.form == Form::F { face } else { 0.0 };
                (Some((depth, breadth)), radius, Some(ANGLES[0]), face)
            }
            Form::Thread => {
                let pitch = self.pitch.unwrap_or_default();
                let row = THREADS.iter().find(|row| (row[0] - pitch).abs() < NOTHING);
                let is_outside = at.up.y * at.corner.y > 0.0;
                let size = |row: &[f64; 6]| match is_outside {
                    true => (row[1] / 2.0, row[2]),
                    // The surface is that of the bore, the standard counts from the thread.
                    false => ((row[3] + BORE * row[0]) / 2.0, row[4]),
                };
                (row.map(size), row.map_or(0.0, |row| row[5]), Some(THREAD_ANGLE), 0.0)
            }
            Form::H | Form::K | Form::U => (None, 0.0, None, 0.0),
        };
        Some(Sizes {
            depth: self.depth.or(standard.map(|(depth, _)| depth))?,
            breadth: self.breadth.or(standard.map(|(_, breadth)| breadth))?,
            radius: self.radius.unwrap_or(radius),
            angle: angle.map(|angle| self.angle.unwrap_or(angle)),
            face_depth: if self.form == Form::F { self.face_depth.unwrap_or(face_depth) } else { 0.0 },
        })
    }

    /// Down into the surface, along a floor, and up the face, or out of it.
    fn in_surface(&self, at: &At) -> Option<Vec<(DVec2, Treated)>> {
        let Sizes { depth, breadth, radius, angle, face_depth } = self.sizes(at)?;
        let run = angle.map_or(0.0, |angle| depth / tand(angle));
        let rise = if face_depth > 0.0 { face_depth / tand(self.face_angle.unwrap_or(ANGLES[1])) } else { 0.0 };
        let floor = breadth + face_depth - run;
        if !(depth > NOTHING) || !(floor > NOTHING) || run < 0.0 || face_depth < 0.0 || rise < 0.0 {
            return None;
        }
        let begin = at.corner - at.along * breadth;
        let (foot, root) = (begin + at.along * run - at.up * depth, at.corner + at.along * face_depth - at.up * depth);
        let mut corners =
            vec![(begin, Treated::edge(self.edge)), (foot, Treated::Round(radius)), (root, Treated::Round(radius))];
        if face_depth > 0.0 {
            corners.push((root - at.along * face_depth + at.up * rise, Treated::Sharp));
        }
        Some(corners)
    }

    /// Form H: down a slope, and tangentially on an arc up to the face.
    fn rounded_slope(&self, at: &At) -> Option<Vec<(DVec2, Treated)>> {
        let (radius, breadth, angle) = (self.radius?, self.breadth?, self.angle?);
        if !(angle > 0.0) || !(angle < 90.0) {
            return None;
        }
        let begin = at.corner - at.along * breadth;
        Some(vec![(begin, Treated::Sharp), (at.corner - at.up * (breadth * tand(angle)), Treated::Round(radius))])
    }

    /// Form K: two sides about a line into the corner, with a round ground that is so deep along the rotary axis.
    fn notch(&self, at: &At) -> Option<Vec<(DVec2, Treated)>> {
        let (depth, opening) = (self.depth?, self.opening?);
        let (radius, turn, half) = (self.radius.unwrap_or(0.0), self.rotation.unwrap_or(DIAGONAL), opening / 2.0);
        if !(depth > NOTHING) || !(half > NOTHING) || !(half < turn) || !(half + turn < 90.0) {
            return None;
        }
        // Where both sides would meet, from the corner.
        let far = depth / cosd(turn) + radius * (1.0 / sind(half) - 1.0);
        let (ahead, below) = (far * cosd(turn), far * sind(turn));
        let begin = ahead - below * cosd(turn - half) / sind(turn - half);
        let end = ahead * sind(turn + half) / cosd(turn + half) - below;
        Some(vec![
            (at.corner + at.along * begin, Treated::Sharp),
            (at.corner + at.along * ahead - at.up * below, Treated::Round(radius)),
            (at.corner + at.up * end, Treated::Sharp),
        ])
    }
}
