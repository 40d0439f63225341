//! Shapes as a scene describes them, and their reduction to surfaces combined by AND and OR.
//!
//! Invariant: after the reduction complements are at the surfaces only, and equal surfaces are one.
use super::mesh::{Mesh, PlacedMesh};
use super::surface::Surface;
use crate::engine::geometry::Frame;
use glam::DVec3;
use std::sync::Arc;

/// A solid shape. Nesting is arbitrary.
#[derive(Clone, Debug, PartialEq)]
pub enum Shape {
    /// All points on the inner side of a plane; the normal (of any length) points out of the material.
    HalfSpace {
        /// A point of the plane.
        point: DVec3,
        /// The direction out of the material.
        normal: DVec3,
    },
    /// A box along the axes of its frame.
    Box {
        /// The corner with the smallest coordinates.
        min: DVec3,
        /// The corner with the largest coordinates.
        max: DVec3,
    },
    /// A circular cylinder with plane ends.
    Cylinder {
        /// Centre of one end.
        from: DVec3,
        /// Centre of the other end.
        to: DVec3,
        /// Radius in mm.
        radius: f64,
    },
    /// A cone or a truncated cone with plane ends; equal radii make a cylinder.
    Cone {
        /// Centre of one end.
        from: DVec3,
        /// Centre of the other end.
        to: DVec3,
        /// Radius at `from`, not negative.
        radius_from: f64,
        /// Radius at `to`, not negative.
        radius_to: f64,
    },
    /// A ball.
    Sphere {
        /// Centre.
        centre: DVec3,
        /// Radius in mm.
        radius: f64,
    },
    /// A triangulated surface. It can be part of a union and be placed, but not be part of a difference.
    Mesh(Arc<Mesh>),
    /// Everything that one of them holds; of none, nothing.
    Union(Vec<Shape>),
    /// The first without the others; of none, nothing.
    Difference(Vec<Shape>),
    /// A shape turned and shifted.
    Placed {
        /// From the shape's coordinates to those around it.
        frame: Frame,
        /// The shape.
        shape: Box<Shape>,
    },
}

impl Shape {
    /// How many sides of surfaces it is made of.
    pub(super) fn sides(&self) -> usize {
        match self {
            Self::Mesh(_) => 0,
            Self::HalfSpace { .. } | Self::Sphere { .. } => 1,
            Self::Box { .. } => 6,
            Self::Cylinder { .. } | Self::Cone { .. } => 3,
            Self::Union(shapes) | Self::Difference(shapes) => shapes.iter().map(Self::sides).sum(),
            Self::Placed { shape, .. } => shape.sides(),
        }
    }

    /// Whether a triangulated surface is part of it.
    pub fn has_mesh(&self) -> bool {
        match self {
            Self::Mesh(_) => true,
            Self::Union(shapes) | Self::Difference(shapes) => shapes.iter().any(Self::has_mesh),
            Self::Placed { shape, .. } => shape.has_mesh(),
            _ => false,
        }
    }

    /// Whether a triangulated surface is cut, or cuts something.
    pub(super) fn cuts_mesh(&self) -> bool {
        match self {
            Self::Union(shapes) => shapes.iter().any(Self::cuts_mesh),
            Self::Difference(shapes) => shapes.iter().any(Self::has_mesh),
            Self::Placed { shape, .. } => shape.cuts_mesh(),
            _ => false,
        }
    }

    /// Adds the triangulated surfaces at their places.
    pub(super) fn meshes(&self, frame: &Frame, all: &mut Vec<PlacedMesh>) {
        match self {
            Self::Mesh(mesh) => all.push(PlacedMesh::new(mesh, frame)),
            Self::Union(shapes) => shapes.iter().for_each(|shape| shape.meshes(frame, all)),
            Self::Placed { frame: inner, shape } => shape.meshes(&frame.of(*inner), all),
            _ => {}
        }
    }
}

/// Surfaces combined; complements are at the leaves only.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Tree {
    /// The side of a surface: its inside, or its outside.
    Side { surface: usize, inside: bool },
    /// All of them.
    And(Vec<Tree>),
    /// One of them.
    Or(Vec<Tree>),
}

/// The mark of a point that closes both sides of a surface: the apex of a cone.
pub(super) const EITHER: i8 = 2;

/// The surfaces met so far, each once.
#[derive(Default)]
pub(super) struct Surfaces(pub(super) Vec<Surface>);

impl Surfaces {
    fn side(&mut self, surface: Surface, inside: bool) -> Tree {
        for (index, known) in self.0.iter().enumerate() {
            if let Some(same) = known.same(&surface) {
                return Tree::Side { surface: index, inside: inside == same };
            }
        }
        self.0.push(surface);
        Tree::Side { surface: self.0.len() - 1, inside }
    }

    fn plane(&mut self, point: DVec3, normal: DVec3, keep: bool) -> Tree {
        let normal = normal.normalize_or_zero();
        self.side(Surface::Plane { normal, offset: normal.dot(point) }, keep)
    }

    /// The tree of a shape, or of everything outside it when `keep` is false.
    pub(super) fn reduce(&mut self, shape: &Shape, frame: &Frame, keep: bool) -> Tree {
        match shape {
            Shape::HalfSpace { point, normal } => self.plane(frame.point(*point), frame.vector(*normal), keep),
            Shape::Box { min, max } => self.reduce_box(*min, *max, frame, keep),
            Shape::Cylinder { from, to, radius } => self.reduce_cone(*from, *to, [*radius; 2], frame, keep),
            Shape::Cone { from, to, radius_from, radius_to } => {
                self.reduce_cone(*from, *to, [*radius_from, *radius_to], frame, keep)
            }
            Shape::Sphere { centre, radius } => {
                self.side(Surface::Sphere { centre: frame.point(*centre), radius: *radius }, keep)
            }
            // What it bounds is asked of the surface itself.
            Shape::Mesh(_) => self.nothing(keep),
            Shape::Union(shapes) => {
                let sides = shapes.iter().map(|shape| self.reduce(shape, frame, keep)).collect();
                if keep { Tree::Or(sides) } else { Tree::And(sides) }
            }
            Shape::Difference(shapes) => {
                let Some((first, rest)) = shapes.split_first() else { return self.nothing(keep) };
                let mut sides = vec![self.reduce(first, frame, keep)];
                sides.extend(rest.iter().map(|shape| self.reduce(shape, frame, !keep)));
                if keep { Tree::And(sides) } else { Tree::Or(sides) }
            }
            Shape::Placed { frame: inner, shape } => self.reduce(shape, &frame.of(*inner), keep),
        }
    }

    fn nothing(&self, keep: bool) -> Tree {
        if keep { Tree::Or(Vec::new()) } else { Tree::And(Vec::new()) }
    }

    fn reduce_box(&mut self, min: DVec3, max: DVec3, frame: &Frame, keep: bool) -> Tree {
        let mut sides = Vec::new();
        for unit in [DVec3::X, DVec3::Y, DVec3::Z] {
            sides.push(self.plane(frame.point(max), frame.vector(unit), keep));
            sides.push(self.plane(frame.point(min), frame.vector(-unit), keep));
        }
        if keep { Tree::And(sides) } else { Tree::Or(sides) }
    }

    fn reduce_cone(&mut self, from: DVec3, to: DVec3, radii: [f64; 2], frame: &Frame, keep: bool) -> Tree {
        let (from, to) = (frame.point(from), frame.point(to));
        let axis = (to - from).normalize_or_zero();
        let mut sides = vec![self.plane(to, axis, keep), self.plane(from, -axis, keep)];
        let [start, end] = radii;
        let (length, growth) = ((to - from).length(), end - start);
        let side = if growth == 0.0 {
            Surface::Cylinder { origin: from, axis, radius: start }
        } else {
            let slant = libm::hypot(length, growth);
            let (axis, sign) = if growth > 0.0 { (axis, 1.0) } else { (-axis, -1.0) };
            let apex = from - axis * (sign * start * length / growth);
            Surface::Cone { apex, axis, sin: growth.abs() / slant, cos: length / slant }
        };
        sides.push(self.side(side, keep));
        if keep { Tree::And(sides) } else { Tree::Or(sides) }
    }
}

impl Tree {
    /// Whether a point belongs to the solid, as far as the sides that it lies on are known:
    /// negative inside a surface, positive outside, zero unknown; [`EITHER`] belongs to both sides.
    pub(super) fn holds(&self, side_of: &dyn Fn(usize) -> i8) -> Option<bool> {
        match self {
            Self::Side { surface, inside } => match side_of(*surface) {
                0 => None,
                EITHER => Some(true),
                side => Some((side < 0) == *inside),
            },
            Self::And(trees) => fold(trees, side_of, false),
            Self::Or(trees) => fold(trees, side_of, true),
        }
    }

    /// Calls `pair` for each two surfaces that are combined by AND: only these can form an edge that sticks out.
    pub(super) fn for_each_edge_pair(&self, pair: &mut dyn FnMut(usize, usize)) -> Vec<usize> {
        let (trees, and) = match self {
            Self::Side { surface, .. } => return vec![*surface],
            Self::And(trees) => (trees, true),
            Self::Or(trees) => (trees, false),
        };
        let mut all: Vec<usize> = Vec::new();
        for tree in trees {
            let mine = tree.for_each_edge_pair(pair);
            if and {
                all.iter().for_each(|a| mine.iter().for_each(|b| pair(*a, *b)));
            }
            all.extend(mine);
        }
        all.sort_unstable();
        all.dedup();
        all
    }

    /// Marks the sides of surfaces that bound material: `[inside, outside]` by surface.
    pub(super) fn mark_sides(&self, used: &mut [[bool; 2]]) {
        match self {
            Self::Side { surface, inside } => {
                if let Some([kept, cut]) = used.get_mut(*surface) {
                    *(if *inside { kept } else { cut }) = true;
                }
            }
            Self::And(trees) | Self::Or(trees) => trees.iter().for_each(|tree| tree.mark_sides(used)),
        }
    }
}

/// AND (`decides` false) or OR (`decides` true) over three values.
fn fold(trees: &[Tree], side_of: &dyn Fn(usize) -> i8, decides: bool) -> Option<bool> {
    let mut unknown = false;
    for tree in trees {
        match tree.holds(side_of) {
            Some(value) if value == decides => return Some(decides),
            Some(_) => {}
            None => unknown = true,
        }
    }
    if unknown { None } else { Some(!decides) }
}
