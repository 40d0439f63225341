//! Recesses in turned contours: what a straight element becomes into which a program sets a recess.
//!
//! The manuals of the cycles do not print this shape; it is common knowledge of the trade (`docs/contours.md`).
//! Invariant: plain geometry in the plane of contours, `x` along the rotary axis, `y` a radius.
use glam::DVec2;

use super::element::{Element, Shape};
use super::undercut::{Treated, through};
use crate::base::expr::tand;
use crate::engine::geometry::left_of;

/// What is shorter than this, mm, is nothing.
const NOTHING: f64 = 1e-9;

/// How deep a recess is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Deep {
    /// So far to the right of the element, negative to its left, mm.
    Beside(f64),
    /// Down to a radius, mm.
    Radius(f64),
}

/// A recess in a straight element.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Recess {
    /// Whether its place is one along the rotary axis; else it is a radius.
    pub(crate) radial: bool,
    /// The place of its middle, mm.
    pub(crate) centre: f64,
    pub(crate) deep: Deep,
    /// How broad it is at the element, mm.
    pub(crate) breadth: f64,
    /// The angle of both walls to a right angle, degrees.
    pub(crate) lean: f64,
    /// The radius of both corners at its ground, mm.
    pub(crate) radius: f64,
    /// At its first edge and at the other one: a rounding, or a chamfer, mm.
    pub(crate) edges: [Option<(f64, bool)>; 2],
}

impl Recess {
    /// An element with the recess: what is left of it before, and all that follows up to its end. Nothing where it is not
    /// straight or runs the wrong way, or where there is no room.
    pub(crate) fn within(&self, line: &Element) -> Option<(Element, Vec<Element>)> {
        let way = line.to - line.from;
        let (from, whole) = if self.radial { (line.from.x, way.x) } else { (line.from.y, way.y) };
        if line.shape != Shape::Line || whole.abs() <= NOTHING {
            return None;
        }
        let (along, length) = (way / way.length(), way.length());
        let middle = (self.centre - from) / whole * length;
        let deep = match self.deep {
            Deep::Beside(depth) => -left_of(along) * depth,
            // Only of a surface along the axis is the ground everywhere as far from it.
            Deep::Radius(_) if along.y.abs() > NOTHING => return None,
            Deep::Radius(radius) => DVec2::new(0.0, radius - line.from.y),
        };
        let half = self.breadth / 2.0;
        let run = deep.length() * tand(self.lean);
        let is_between = middle - half > -NOTHING && middle + half < length + NOTHING;
        if !(half > NOTHING) || !(deep.length() > NOTHING) || !is_between || !(half - run > -NOTHING) || run < 0.0 {
            return None;
        }
        let place = |x: f64| line.from + along * x;
        let (ground, corner) = (half - run, Treated::Round(self.radius));
        let mut corners = vec![(place(middle - half), Treated::edge(self.edges[0]))];
        if ground > NOTHING {
            corners.extend([(place(middle - ground) + deep, corner), (place(middle + ground) + deep, corner)]);
        } else {
            corners.push((place(middle) + deep, corner));
        }
        corners.push((place(middle + half), Treated::edge(self.edges[1])));
        let (first, mut rest, last) = through(line.from, &corners, line.to)?;
        if last.extent() > NOTHING {
            rest.push(last);
        }
        Some((first, rest))
    }
}
