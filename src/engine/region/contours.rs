//! Contours as programs describe them: pockets and islands, and what they enclose together.
//!
//! Invariant: a contour says by its side and its sense what it is; nothing here knows a program.
use glam::DVec2;

use super::{Boundary, Edge, Flaw, Region, Way};

/// How far the end of a contour may lie off its beginning, mm: what the controls' input step of 0.0001 mm can cause.
pub(super) const CLOSED: f64 = 0.001;
/// The frame around islands without a pocket is this much larger than they are, mm.
const AROUND: f64 = 1000.0;

/// A contour in main and minor coordinates, mm.
#[derive(Clone, Debug)]
pub struct Contour {
    /// Its elements, with roundings and chamfers.
    pub way: Way,
    /// Positive with the tool on its left (RL), negative on its right (RR), 0 on it.
    pub side: i8,
}

/// A closed contour: a pocket, or an island that stays.
#[derive(Clone, Debug)]
pub struct Closed {
    /// Its boundary.
    pub boundary: Boundary,
    /// Whether what it encloses is machined.
    pub is_pocket: bool,
}

impl Contour {
    /// The contour with its points in other places, at the same distances from each other; `mirrored` where left has
    /// become right.
    pub fn placed(&self, place: &dyn Fn(DVec2) -> DVec2, mirrored: bool) -> Self {
        let sign = if mirrored { -1 } else { 1 };
        let edge = |edge: &Edge| match *edge {
            Edge::Line(to) => Edge::Line(place(to)),
            Edge::Arc { to, centre, sweep } => {
                Edge::Arc { to: place(to), centre: place(centre), sweep: sweep * f64::from(sign) }
            }
        };
        let way = Way { start: place(self.way.start), edges: self.way.edges.iter().map(edge).collect() };
        Self { way, side: self.side * sign }
    }

    /// The contour as a boundary.
    ///
    /// # Errors
    /// It is open, crosses itself or encloses nothing.
    pub fn boundary(&self) -> Result<Boundary, Flaw> {
        Boundary::new(self.way.start, &self.way.edges, CLOSED)
    }

    /// The same with what it is: with the tool inside of it it is a pocket (TNC 640 manual, lines 4372-4373).
    ///
    /// # Errors
    /// It is open, crosses itself or encloses nothing.
    pub fn closed(&self) -> Result<Closed, Flaw> {
        let boundary = self.boundary()?;
        let is_pocket = (self.side > 0) != boundary.is_clockwise();
        Ok(Closed { boundary, is_pocket })
    }
}

/// What closed contours in their order enclose together (TNC 640 manual, lines 4510-4586).
///
/// Two pockets are a sum, or, where the first one begins within the second, what both cover. Islands stay, wherever they
/// are in the list; only a pocket that comes after an island and lies wholly in it is machined all the same. Islands
/// without any pocket stand in a wide frame.
pub fn enclosed(contours: &[Closed]) -> Region {
    let (mut pockets, mut inner): (Option<(Region, DVec2)>, Vec<Region>) = (None, Vec::new());
    let mut islands: Vec<Region> = Vec::new();
    for contour in contours {
        let (area, start) = (Region::within(&contour.boundary), contour.boundary.start());
        if !contour.is_pocket {
            islands.push(area);
        } else if islands.iter().any(|island| area.difference(island).is_empty()) {
            inner.push(area);
        } else {
            pockets = Some(match pockets {
                None => (area, start),
                Some((before, first)) if area.contains(first) => (before.intersection(&area), start),
                Some((before, first)) => (before.union(&area), first),
            });
        }
    }
    let region = pockets.map_or_else(|| Region::around(&islands, AROUND), |(region, _)| region);
    let region = islands.iter().fold(region, |region, island| region.difference(island));
    inner.iter().fold(region, |region, pocket| region.union(pocket))
}
