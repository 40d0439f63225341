//! Ways in the working plane, open or closed: lines and arcs one after another, and the way beside another one.
//!
//! Invariant: the edges of a way join; a way beside another keeps its sense.
use cavalier_contours::polyline::{PlineCreation, PlineOffsetOptions, PlineSource, PlineSourceMut, Polyline};
use glam::DVec2;

use super::boundary::{add, heading, push};
use super::contours::CLOSED;
use super::{Boundary, Edge, NEAR};

/// A way of a tool.
#[derive(Clone, Debug, Default)]
pub struct Way {
    /// Where it begins.
    pub start: DVec2,
    /// Its edges in order.
    pub edges: Vec<Edge>,
}

impl Way {
    /// Where it ends.
    pub fn end(&self) -> DVec2 {
        self.edges.last().map_or(self.start, Edge::to)
    }

    /// Whether it ends where it begins.
    pub fn is_closed(&self) -> bool {
        self.start.distance(self.end()) <= CLOSED
    }

    /// Its length in mm.
    pub fn length(&self) -> f64 {
        let mut at = self.start;
        self.edges.iter().map(|edge| edge.length(std::mem::replace(&mut at, edge.to()))).sum()
    }

    /// Its first part of a length in mm, or all of it.
    pub fn shortened(&self, length: f64) -> Self {
        let mut own = Self { start: self.start, edges: Vec::new() };
        let mut left = length;
        for edge in &self.edges {
            if left <= NEAR {
                break;
            }
            let end = own.end();
            let whole = edge.length(end);
            own.edges.push(if whole > left { edge.shortened(end, left) } else { *edge });
            left -= whole;
        }
        own
    }

    /// The same way from its end to where it begins.
    pub fn reversed(&self) -> Self {
        let mut at = self.start;
        let mut edges: Vec<Edge> =
            self.edges.iter().map(|edge| edge.reversed(std::mem::replace(&mut at, edge.to()))).collect();
        edges.reverse();
        Self { start: at, edges }
    }

    /// The ways at a distance in mm on the left of this one, on its right if negative: one, unless it is too narrow
    /// somewhere for a circle of that radius; nothing if it is so everywhere. Where it is closed the way begins beside
    /// its beginning. A closed contour that is joined and left tangentially at one point is one as well.
    pub fn beside(&self, distance: f64) -> Vec<Self> {
        if distance.abs() <= NEAR {
            return vec![self.clone()];
        }
        let closed = self.is_closed();
        let mut line = Polyline::with_capacity(self.edges.len() + 1, closed);
        let mut at = self.start;
        for edge in &self.edges {
            push(&mut line, at, edge);
            at = edge.to();
        }
        if !closed {
            line.add(at.x, at.y, 0.0);
        }
        let line = line.remove_repeat_pos(NEAR).unwrap_or(line);
        let options = PlineOffsetOptions {
            handle_self_intersects: true,
            pos_equal_eps: NEAR,
            offset_dist_eps: 1e-6,
            ..PlineOffsetOptions::default()
        };
        let found = line.parallel_offset_opt(distance, &options);
        if !closed
            && found.len() != 1
            && let Some(joined) = self.beside_joined(distance)
        {
            return vec![joined];
        }
        let begin = self.start + heading(self.start, &self.edges).perp() * distance;
        found.iter().filter(|own| own.path_length() > NEAR).map(|own| from_line(own, begin)).collect()
    }
}

impl Way {
    /// The way beside a closed contour between a first and a last element that join and leave it tangentially: where the tool
    /// comes from is no wall of the contour, so the tool may pass there again.
    fn beside_joined(&self, distance: f64) -> Option<Self> {
        let [first, ring @ .., last] = self.edges.as_slice() else { return None };
        let ring = Self { start: first.to(), edges: ring.to_vec() };
        if ring.edges.is_empty() || !ring.is_closed() {
            return None;
        }
        let parts =
            [Self { start: self.start, edges: vec![*first] }, ring, Self { start: first.to(), edges: vec![*last] }];
        let mut whole: Option<Self> = None;
        for part in parts {
            let mut beside = part.beside(distance);
            let (Some(next), true) = (beside.pop(), beside.is_empty()) else { return None };
            match &mut whole {
                None => whole = Some(next),
                Some(before) if before.end().distance(next.start) <= CLOSED => before.edges.extend(next.edges),
                Some(_) => return None,
            }
        }
        whole
    }
}

/// The way along a line; along a closed one from where it is nearest to a point.
fn from_line(line: &Polyline, begin: DVec2) -> Way {
    if line.is_closed() {
        let boundary = Boundary::of_either_sense(line.clone()).from_nearest(begin);
        return Way { start: boundary.start(), edges: boundary.edges() };
    }
    let mut edges = Vec::with_capacity(line.vertex_count());
    for (from, to) in line.iter_segments() {
        add(&mut edges, from, to);
    }
    let first = line.at(0);
    Way { start: DVec2::new(first.x, first.y), edges }
}
