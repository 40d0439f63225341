//! Undercuts of turned contours: what a corner between a surface along the rotary axis and a face becomes, as DIN 509 has
//! its forms E and F, and a groove with walls at right angles (form U).
//!
//! The manuals of the cycles do not print these shapes; they are common knowledge of the trade (`docs/events.md`).
//! Invariant: plain geometry in the plane of contours, `x` along the rotary axis, `y` a radius.
use super::element::{Element, Shape, broken, rounded};
use crate::base::expr::tand;

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

/// The forms that are known.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Form {
    /// In the surface, with a slope.
    E,
    /// In the surface and in the face.
    F,
    /// In the surface, with walls at right angles.
    U,
}

/// An undercut; what is not given is as DIN 509 has it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Undercut {
    pub(crate) form: Form,
    /// The radius of its inner corners, mm.
    pub(crate) radius: Option<f64>,
    /// How deep it is in the surface, mm.
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
}

/// What becomes of a corner.
enum Treated {
    Sharp,
    Round(f64),
    Chamfer(f64),
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
        }
    }

    /// The corner of a surface and the face after it with the undercut: what is left of the surface, the elements of the
    /// undercut, what follows of the face. Nothing where they are no such corner, or where there is no room.
    pub(crate) fn between(&self, surface: &Element, face: &Element) -> Option<(Element, Vec<Element>, Element)> {
        let (corner, along, up) = (surface.to, surface.to - surface.from, face.to - face.from);
        let lines = surface.shape == Shape::Line && face.shape == Shape::Line;
        // Always in the surface along the axis.
        if !lines || along.y.abs() > NOTHING || up.x.abs() > NOTHING {
            return None;
        }
        let (length, height) = (along.length(), up.length());
        let (u, w) = (along.normalize_or_zero(), up.normalize_or_zero());
        let diameter = 2.0 * corner.y.abs();
        let row = SIZES.iter().find(|row| diameter <= row[0])?;
        let by_standard = self.form != Form::U;
        let size = |own: Option<f64>, standard: f64| own.or_else(|| by_standard.then_some(standard));
        let (depth, breadth) = (size(self.depth, row[1])?, size(self.breadth, row[2])?);
        let radius = self.radius.unwrap_or(if by_standard { row[3] } else { 0.0 });
        let begin = corner - u * breadth;
        let (run, into, rise) = match self.form {
            Form::U => (0.0, 0.0, 0.0),
            form => {
                let run = depth / tand(self.angle.unwrap_or(ANGLES[0]));
                let into = if form == Form::F { self.face_depth.unwrap_or(row[4]) } else { 0.0 };
                (run, into, if into > 0.0 { into / tand(self.face_angle.unwrap_or(ANGLES[1])) } else { 0.0 })
            }
        };
        let sizes = [depth, breadth, length - breadth, breadth + into - run, height - (rise - depth)];
        if sizes.iter().any(|size| !(*size > NOTHING)) || run < 0.0 || into < 0.0 {
            return None;
        }
        let (foot, root) = (begin + u * run - w * depth, corner + u * into - w * depth);
        let edge = match self.edge {
            None => Treated::Sharp,
            Some((size, false)) => Treated::Round(size),
            Some((size, true)) => Treated::Chamfer(size),
        };
        let mut points = vec![(begin, edge), (foot, Treated::Round(radius)), (root, Treated::Round(radius))];
        if into > 0.0 {
            points.push((root - u * into + w * rise, Treated::Sharp));
        }
        let mut way = vec![Element::line(surface.from, begin)];
        for (index, (at, treated)) in points.iter().enumerate() {
            let before = way.pop()?;
            let after = Element::line(*at, points.get(index + 1).map_or(face.to, |(next, _)| *next));
            let (before, between, after) = match treated {
                Treated::Sharp => (before, None, after),
                Treated::Round(radius) => rounded(&before, &after, *radius)?,
                Treated::Chamfer(leg) => broken(&before, &after, *leg)?,
            };
            way.push(before);
            way.extend(between);
            way.push(after);
        }
        let (last, first) = (way.pop()?, way.remove(0));
        Some((first, way, last))
    }
}
