//! Where a moving ball touches a triangulated surface first.
//!
//! The ball goes as far as it is certainly free, which its distance from the surface says. Where it comes near, the
//! triangles about it are examined on a short stretch of its path as other solids are: their faces, edges and corners.
//!
//! Invariant: an answer is exact; a contact is the first one, and its point belongs to a triangle.
use glam::DVec3;

use super::{Mesh, PlacedMesh, Triangle};
use crate::engine::geometry::Frame;
use crate::engine::solid::SolidError;
use crate::engine::solid::body::Feature;
use crate::engine::solid::contact::{Contact, SHALLOW, TOUCH, candidates_on};
use crate::engine::solid::curve::Curve;
use crate::engine::solid::path::{Path, Piece};
use crate::engine::solid::surface::Surface;

/// Stretches are so long, as a share of the radius of the ball, and within these limits in mm.
const STRETCH: (f64, f64, f64) = (0.1, 1e-3, 1.0);
/// Stretches near more triangles than this are made shorter.
const MANY: usize = 128;
/// How far from a triangle a point of it may be calculated, mm.
const OFF: f64 = 1e-9;

impl Triangle {
    /// What a ball can touch of it.
    fn features(&self, all: &mut Vec<Feature>) {
        let plane = Surface::Plane { normal: self.normal, offset: self.normal.dot(self.corners[0]) };
        all.extend([Feature::Face(plane, 1.0), Feature::Face(plane, -1.0)]);
        for (from, to) in self.sides() {
            all.extend([
                Feature::Edge(Curve::Line { origin: from, direction: (to - from).normalize() }),
                Feature::Corner(from),
            ]);
        }
    }

    fn holds(&self, point: DVec3) -> bool {
        (self.closest(point) - point).length() <= OFF
    }
}

impl Mesh {
    fn first_contact(&self, radius: f64, path: &Path) -> Result<Option<Contact>, SolidError> {
        let pieces = path.pieces();
        let start = path.at(0.0);
        let way = pieces.first().map_or(DVec3::ZERO, |piece| {
            if piece.backwards() { -piece.speed(piece.high) } else { piece.speed(piece.low) }
        });
        let (at_start, sliding) = self.contact_at_start(radius, start, way.normalize_or_zero())?;
        if at_start.is_some() {
            return Ok(at_start);
        }
        let found = pieces.iter().find_map(|piece| self.contact_on(piece, radius));
        // A motion along a touched face may still lead or bend into it.
        let half_way = path.at(0.5 * found.map_or(1.0, |contact| contact.t));
        let bends_in = sliding.filter(|_| self.nearest(half_way, radius - TOUCH).is_some());
        Ok(bends_in.or(found))
    }

    /// The contact at the start if the ball is there already and goes in, and where it slides along the surface.
    fn contact_at_start(
        &self,
        radius: f64,
        start: DVec3,
        way: DVec3,
    ) -> Result<(Option<Contact>, Option<Contact>), SolidError> {
        if self.contains(start)? {
            let contact = Contact { t: 0.0, ball_centre: start, point: start, normal: -way, deflected: true };
            return Ok((Some(contact), None));
        }
        if let Some(found) = self.nearest(start, radius - TOUCH) {
            let normal = (start - found.point) / found.distance;
            let contact = Contact { t: 0.0, ball_centre: start, point: found.point, normal, deflected: true };
            return Ok((Some(contact), None));
        }
        let mut sliding = None;
        for triangle in self.near(start, radius + TOUCH, usize::MAX) {
            let point = triangle.closest(start);
            let normal = (start - point).normalize_or_zero();
            let contact = Contact { t: 0.0, ball_centre: start, point, normal, deflected: false };
            if normal.dot(way) < -SHALLOW {
                return Ok((Some(contact), None));
            }
            sliding = Some(contact);
        }
        Ok((None, sliding))
    }

    /// The first contact on a piece of the path on which the ball is free at the start.
    fn contact_on(&self, piece: &Piece, radius: f64) -> Option<Contact> {
        let (from, to, sign) =
            if piece.backwards() { (piece.high, piece.low, -1.0) } else { (piece.low, piece.high, 1.0) };
        // Nowhere on a piece does the centre go faster.
        let fastest = piece.speed(0.0_f64.clamp(piece.low, piece.high)).length();
        let least = STRETCH.1.min(radius * STRETCH.0);
        let mut stretch = (radius * STRETCH.0).min(STRETCH.2);
        let mut u = from;
        while (to - u) * sign > 0.0 {
            let left = (to - u).abs() * fastest;
            let centre = piece.at(u);
            let gap = self.nearest(centre, radius + left + OFF)?.distance - radius;
            if gap > stretch {
                u += sign * gap / fastest;
                continue;
            }
            let mut near = self.near(centre, radius + stretch + TOUCH, MANY);
            while near.len() > MANY && stretch > least {
                stretch *= 0.5;
                near = self.near(centre, radius + stretch + TOUCH, MANY);
            }
            if near.len() > MANY {
                near = self.near(centre, radius + stretch + TOUCH, usize::MAX);
            }
            let next = u + sign * (stretch / fastest).min((to - u).abs());
            let mut part = *piece;
            let room = (next - u).abs() * 1e-6;
            (part.low, part.high) = ((u.min(next) - room).max(piece.low), (u.max(next) + room).min(piece.high));
            if let Some(contact) = first_on(&part, radius, &near) {
                return Some(contact);
            }
            (u, stretch) = (next, (stretch * 2.0).min(radius * STRETCH.0).min(STRETCH.2));
        }
        None
    }
}

/// The first contact with some triangles.
fn first_on(piece: &Piece, radius: f64, near: &[&Triangle]) -> Option<Contact> {
    let mut first: Option<Contact> = None;
    let (mut features, mut candidates) = (Vec::new(), Vec::new());
    for triangle in near {
        features.clear();
        candidates.clear();
        triangle.features(&mut features);
        candidates_on(piece, radius, &features.iter().collect::<Vec<_>>(), &mut candidates);
        for candidate in &candidates {
            let sooner = first.is_none_or(|contact| candidate.t < contact.t);
            if sooner && triangle.holds(candidate.point) {
                let normal = (candidate.centre - candidate.point) / radius;
                let (t, ball_centre, point) = (candidate.t, candidate.centre, candidate.point);
                first = Some(Contact { t, ball_centre, point, normal, deflected: false });
            }
        }
    }
    first
}

impl PlacedMesh {
    /// Where a ball that moves along a path touches first, as [`super::super::Body::first_contact_on`] says it.
    pub(in crate::engine::solid) fn first_contact(
        &self,
        radius: f64,
        path: &Path,
    ) -> Result<Option<Contact>, SolidError> {
        let found = self.mesh.first_contact(radius, &placed(path, &self.back))?;
        Ok(found.map(|contact| Contact {
            ball_centre: self.frame.point(contact.ball_centre),
            point: self.frame.point(contact.point),
            normal: self.frame.vector(contact.normal),
            ..contact
        }))
    }
}

/// A path in other coordinates.
fn placed(path: &Path, frame: &Frame) -> Path {
    match *path {
        Path::Line { from, to } => Path::line(frame.point(from), frame.point(to)),
        Path::Arc { centre, axis, from, sweep, rise } => {
            Path::Arc { centre: frame.point(centre), axis: frame.vector(axis), from: frame.point(from), sweep, rise }
        }
    }
}
