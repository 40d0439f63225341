//! What is turned: a body of revolution with its half section.
//!
//! The half plane has the rotary axis as `x` and the radius as `y`. Invariant: the half section is exact.
use glam::{DVec2, DVec3};

use super::Blank;
use crate::engine::geometry::Frame;
use crate::engine::region::section::Section;
use crate::engine::region::{Edge, Way};
use crate::engine::solid::{HalfWay, Path, Shape};

/// How far from the rotary axis is on it, mm.
const SAME: f64 = 1e-6;

/// A body of revolution.
#[derive(Clone, Debug)]
pub(super) struct Body {
    /// Its half section.
    pub section: Section,
    /// A point of its axis and the direction of that, in the coordinates of the blank.
    line: (DVec3, DVec3),
    /// From the coordinates of the blank to the machine.
    frame: Frame,
}

impl Body {
    /// The body that a blank is; nothing of another one, or of one that is not along or across the columns.
    pub(super) fn of(blank: &Blank) -> Option<Self> {
        let mut line = None;
        let section = section(&blank.shape, &mut line)?;
        let (origin, axis) = line?;
        let along = axis.dot(blank.axis.unit()).abs();
        let is_held = blank.frame.is_rigid() && !(1e-12..=1.0 - 1e-12).contains(&along);
        is_held.then_some(Self { section, line: (origin, axis), frame: blank.frame })
    }

    /// A path in the half plane: machine coordinates, as the parts were at the start, and the frame of the program.
    /// Nothing if the program has its rotary axis elsewhere, or the path is not in the plane through it.
    pub(super) fn half(&self, path: &Path, program: &Frame) -> Option<HalfWay> {
        let line = (self.frame.point(self.line.0), self.frame.vector(self.line.1).normalize_or_zero());
        HalfWay::of(path, line, program)
    }

    /// What a line holds of it, given in the coordinates of the blank: stretches from low to high.
    pub(super) fn along(&self, point: DVec3, up: DVec3) -> Vec<[f64; 2]> {
        let (origin, axis) = self.line;
        let arm = point - origin;
        let (place, leans) = (arm.dot(axis), up.dot(axis));
        if leans.abs() > 0.5 {
            let stretches = self.section.along(arm.reject_from(axis).length());
            let mut found: Vec<[f64; 2]> = stretches
                .into_iter()
                .map(|ends| ends.map(|x| (x - place) / leans))
                .map(|[a, b]| [a.min(b), a.max(b)])
                .collect();
            found.sort_by(|a, b| a[0].total_cmp(&b[0]));
            return found;
        }
        let middle = -arm.dot(up);
        let beside = (arm + up * middle).reject_from(axis).length();
        let half = |radius: f64| libm::sqrt((radius * radius - beside * beside).max(0.0));
        let mut found = Vec::new();
        for [low, high] in self.section.at(place).into_iter().filter(|[_, high]| *high > beside) {
            let (inner, outer) = (half(low), half(high));
            if inner > 0.0 {
                found.extend([[middle - outer, middle - inner], [middle + inner, middle + outer]]);
            } else {
                found.push([middle - outer, middle + outer]);
            }
        }
        found.sort_by(|a, b| a[0].total_cmp(&b[0]));
        found
    }
}

/// The half section of a shape about an axis, which the first cylinder or cone gives.
fn section(shape: &Shape, line: &mut Option<(DVec3, DVec3)>) -> Option<Section> {
    match shape {
        Shape::Cylinder { from, to, radius } => {
            let [from, to] = ends(*from, *to, line)?;
            Some(Section::ring([from.min(to), from.max(to)], [0.0, *radius]))
        }
        Shape::Cone { from, to, radius_from, radius_to } => {
            let [from, to] = ends(*from, *to, line)?;
            let edges = [(to, 0.0), (to, *radius_to), (from, *radius_from)];
            let edges = edges.map(|(x, y)| Edge::Line(DVec2::new(x, y))).to_vec();
            Some(Section::within(&Way { start: DVec2::new(from, 0.0), edges }))
        }
        Shape::Sphere { centre, radius } => {
            let (origin, axis) = (*line)?;
            let arm = *centre - origin;
            let at = DVec2::new(arm.dot(axis), 0.0);
            let end = at - DVec2::X * *radius;
            let edges = vec![Edge::Arc { to: end, centre: at, sweep: 180.0 }];
            let start = at + DVec2::X * *radius;
            (arm.reject_from(axis).length() <= SAME).then(|| Section::within(&Way { start, edges }))
        }
        Shape::Union(shapes) => {
            let mut whole = Section::default();
            for shape in shapes {
                whole.add(&section(shape, line)?);
            }
            Some(whole)
        }
        Shape::Difference(shapes) => {
            let (first, others) = shapes.split_first()?;
            let mut rest = section(first, line)?;
            for shape in others {
                rest.take(&section(shape, line)?, &mut |_| {});
            }
            Some(rest)
        }
        Shape::HalfSpace { .. } | Shape::Box { .. } | Shape::Mesh(_) | Shape::Placed { .. } => None,
    }
}

/// The places of two points on an axis, which they are if there is none yet.
fn ends(from: DVec3, to: DVec3, line: &mut Option<(DVec3, DVec3)>) -> Option<[f64; 2]> {
    let (origin, axis) = *line.get_or_insert_with(|| {
        let axis = (to - from).normalize_or_zero();
        // Coordinates grow as those of the blank do.
        let axis = if axis.x + axis.y + axis.z < 0.0 { -axis } else { axis };
        (from - axis * from.dot(axis), axis)
    });
    let on = |point: DVec3| (point - origin).reject_from(axis).length() <= SAME;
    (on(from) && on(to)).then(|| [from, to].map(|point| (point - origin).dot(axis)))
}
