//! Regions of the working plane: what contours enclose, and the paths of a tool that clears it.
//!
//! A [`Boundary`] is one closed contour of lines and arcs, a [`Region`] an area with holes. Regions are combined
//! (union, difference, intersection), shrunk and grown by the radius of a tool, and cleared ([`clearing`]). Lengths are in mm, in the
//! coordinates of the working plane (x: main axis, y: minor axis).
//!
//! The offsets and the intersections of polylines with arcs are those of the crate `cavalier_contours`, which keeps
//! arcs as arcs; nothing outside this room sees its types. Invariant: nothing here knows a machine, a tool or a cycle.
mod boundary;
pub mod clearing;
mod combine;
pub mod contours;
pub mod formula;
pub mod groove;
pub mod insert_envelope;
mod nearest;
pub mod relief;
pub mod section;
pub mod sweep;
mod way;

use cavalier_contours::polyline::{PlineSource, Polyline};
use cavalier_contours::shape_algorithms::{Shape, ShapeOffsetOptions};
use glam::DVec2;

pub use boundary::{Boundary, Edge, Flaw};
pub use nearest::Nearest;
pub use way::Way;

/// Points that lie nearer to each other than this are one, in mm.
pub const NEAR: f64 = 1e-7;

/// Areas below this are none, in mm².
const NO_AREA: f64 = 1e-9;

/// An area of the working plane with holes, of any number of parts.
#[derive(Clone, Debug, Default)]
pub struct Region {
    parts: Vec<Part>,
}

/// A connected area: what its outer boundary encloses without its holes.
#[derive(Clone, Debug)]
pub(crate) struct Part {
    /// Counterclockwise.
    outer: Polyline,
    /// Counterclockwise as well; inside of the outer boundary and outside of each other.
    holes: Vec<Polyline>,
}

impl Region {
    /// What a boundary encloses.
    pub fn within(boundary: &Boundary) -> Self {
        Self { parts: vec![Part { outer: boundary.line().clone(), holes: Vec::new() }] }
    }

    /// A rectangle around some regions that is wider than they are by a margin on each side (mm); nothing around none.
    pub fn around(regions: &[Self], margin: f64) -> Self {
        let all = Self { parts: regions.iter().flat_map(|region| region.parts.iter().cloned()).collect() };
        combine::frame(&all, &Self::default(), margin).unwrap_or_default()
    }

    /// Whether nothing belongs to it.
    pub fn is_empty(&self) -> bool {
        self.parts.is_empty()
    }

    /// Its area in mm².
    pub fn area(&self) -> f64 {
        let part = |part: &Part| part.outer.area() - part.holes.iter().map(PlineSource::area).sum::<f64>();
        self.parts.iter().map(part).sum()
    }

    /// Its connected parts, each as a region.
    pub fn parts(&self) -> impl Iterator<Item = Self> + '_ {
        self.parts.iter().map(|part| Self { parts: vec![part.clone()] })
    }

    /// Its boundaries as they are followed with the region on the left: outer ones counterclockwise, holes clockwise.
    pub fn boundaries(&self) -> impl Iterator<Item = Boundary> + '_ {
        self.parts.iter().flat_map(|part| {
            let outer = std::iter::once(Boundary::of(part.outer.clone()));
            outer.chain(part.holes.iter().map(|hole| Boundary::of(hole.clone()).reversed()))
        })
    }

    /// What belongs to both.
    pub fn intersection(&self, other: &Self) -> Self {
        combine::intersection(self, other)
    }

    /// What belongs to this one only.
    pub fn difference(&self, other: &Self) -> Self {
        combine::difference(self, other)
    }

    /// What belongs to one of them or both.
    pub fn union(&self, other: &Self) -> Self {
        combine::union(self, other)
    }

    /// The region without all that is nearer than `by` to its boundary (mm): where the centre of a cutter of that
    /// radius may be.
    pub fn shrunk(&self, by: f64) -> Self {
        self.offset(by.max(0.0))
    }

    /// The region with all that is nearer than `by` to it (mm).
    pub fn grown(&self, by: f64) -> Self {
        self.offset(-by.max(0.0))
    }

    /// The region whose inside corners have a radius of at least `radius` (mm): what a circle of that radius reaches
    /// that stays within it.
    pub fn rounded(&self, radius: f64) -> Self {
        if radius <= NEAR { self.clone() } else { self.shrunk(radius).grown(radius) }
    }

    /// Whether a point belongs to it; of points nearer than [`NEAR`] to a boundary either answer may come.
    pub fn contains(&self, point: DVec2) -> bool {
        self.parts.iter().any(|part| {
            let within = |line: &Polyline| line.winding_number(boundary::vector(point)) != 0;
            within(&part.outer) && !part.holes.iter().any(within)
        })
    }

    /// The point of its boundaries that is nearest to a point, with its distance; nothing of an empty region.
    pub fn nearest(&self, point: DVec2) -> Option<(DVec2, f64)> {
        let lines = self.parts.iter().flat_map(|part| std::iter::once(&part.outer).chain(&part.holes));
        let near = boundary::nearest_of(lines.flat_map(|line| boundary::points_of(line, point)), point)?;
        Some((near, near.distance(point)))
    }

    /// A point in the middle of the box around it; nothing of an empty region.
    pub fn middle(&self) -> Option<DVec2> {
        let boxes = self.parts.iter().filter_map(|part| part.outer.extents());
        let whole = boxes.map(|own| (DVec2::new(own.min_x, own.min_y), DVec2::new(own.max_x, own.max_y)));
        whole.reduce(|a, b| (a.0.min(b.0), a.1.max(b.1))).map(|(low, high)| (low + high) / 2.0)
    }

    /// Whether the straight way between two points of the region stays within it.
    pub fn has_line_of_sight(&self, from: DVec2, to: DVec2) -> bool {
        Nearest::of(self).is_clear(self, from, to)
    }

    fn offset(&self, inwards: f64) -> Self {
        if inwards.abs() <= NEAR || self.is_empty() {
            return self.clone();
        }
        let outer = self.parts.iter().map(|part| part.outer.clone());
        let holes = self.parts.iter().flat_map(|part| &part.holes).map(boundary::inverted);
        let options = ShapeOffsetOptions { pos_equal_eps: NEAR, offset_dist_eps: 1e-6, slice_join_eps: 1e-6 };
        let found = Shape::from_plines(outer.chain(holes)).parallel_offset(inwards, &options);
        let plain = |lines: Vec<cavalier_contours::shape_algorithms::IndexedPolyline<f64>>| {
            lines.into_iter().map(|line| line.polyline).filter(boundary::has_area).collect::<Vec<_>>()
        };
        let holes = plain(found.cw_plines).iter().map(boundary::inverted).collect();
        combine::assembled(plain(found.ccw_plines), holes)
    }
}
