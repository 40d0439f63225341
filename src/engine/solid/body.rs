//! A solid made ready for questions: its surfaces, its edges, its corners, and what belongs to it.
//!
//! Invariant: a point that lies on surfaces belongs to the body exactly if material lies next to it; skins
//! without thickness (the mouth of a hole that ends in the face it is drilled from) do not exist.
use super::SolidError;
use super::cells::{cells, parallel};
use super::curve::{Curve, Meeting, meet};
use super::mesh::PlacedMesh;
use super::path::Piece;
use super::poly::Poly;
use super::shape::{EITHER, Shape, Surfaces, Tree};
use super::surface::Surface;
use crate::engine::geometry::Frame;
use glam::DVec3;

/// A point is on a surface when it is closer than this, in mm; an order below the accuracy of a contact.
pub(super) const ON: f64 = 1e-10;

/// Most sides of surfaces that a shape may have: each may meet each of the others in an edge.
const MOST_SIDES: usize = 4_000;
/// How often a surface may be asked for its side while edges are looked for: some seconds.
const MOST_LOOKS: u64 = 4_000_000_000;

/// A solid made ready for questions; see the module [`crate::engine::solid`].
#[derive(Clone, Debug)]
pub struct Body {
    pub(super) surfaces: Vec<Surface>,
    pub(super) tree: Tree,
    pub(super) features: Vec<Feature>,
    /// Pairs of surfaces that meet in curves which are neither lines nor circles.
    pub(super) unsupported: Vec<(usize, usize)>,
    /// The triangulated surfaces beside what the tree combines.
    pub(super) meshes: Vec<PlacedMesh>,
}

/// Something that a ball can touch first.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Feature {
    /// A surface, touched from its outside (1) or from its inside (-1).
    Face(Surface, f64),
    Edge(Curve),
    Corner(DVec3),
}

impl Feature {
    /// The point of the feature nearest to `p`.
    pub(super) fn foot(&self, p: DVec3) -> DVec3 {
        match self {
            Self::Face(surface, _) => surface.foot(p),
            Self::Edge(curve) => curve.foot(p),
            Self::Corner(point) => *point,
        }
    }

    /// A polynomial that is zero where a ball whose centre is on the piece touches the feature.
    pub(super) fn at_distance(&self, piece: &Piece, radius: f64) -> Option<Poly> {
        match self {
            Self::Face(surface, side) => surface.at_gap(piece, side * radius),
            Self::Edge(curve) => Some(curve.at_distance(piece, radius)),
            Self::Corner(point) => Some(piece.square(*point).sub(piece.weight().square().scale(radius * radius))),
        }
    }
}

impl Body {
    /// Reduces a shape to surfaces, edges and corners.
    ///
    /// # Errors
    /// [`SolidError::NotFinite`] if a number of the shape is not finite or a surface has no extent,
    /// [`SolidError::TooMany`] if it would take too long to find its edges, [`SolidError::CutMesh`] if a triangulated
    /// surface is part of a difference.
    pub fn new(shape: &Shape) -> Result<Self, SolidError> {
        if shape.sides() > MOST_SIDES {
            return Err(SolidError::TooMany);
        }
        if shape.cuts_mesh() {
            return Err(SolidError::CutMesh);
        }
        let mut meshes = Vec::new();
        shape.meshes(&Frame::IDENTITY, &mut meshes);
        let mut surfaces = Surfaces::default();
        let tree = surfaces.reduce(shape, &Frame::IDENTITY, true);
        let mut body = Self { surfaces: surfaces.0, tree, features: Vec::new(), unsupported: Vec::new(), meshes };
        if !body.surfaces.iter().all(is_sound) {
            return Err(SolidError::NotFinite);
        }
        body.find_features()?;
        Ok(body)
    }

    /// Whether the point belongs to the solid; its boundary does.
    ///
    /// # Errors
    /// [`SolidError::Cusp`] at a point where surfaces touch without crossing and leave no thickness.
    pub fn contains(&self, p: DVec3) -> Result<bool, SolidError> {
        if self.holds(p)? {
            return Ok(true);
        }
        for mesh in &self.meshes {
            if mesh.contains(p)? {
                return Ok(true);
            }
        }
        Ok(false)
    }

    /// Whether the point belongs to the solid apart from its triangulated surfaces.
    pub(super) fn holds(&self, p: DVec3) -> Result<bool, SolidError> {
        let looked = |k: usize| self.surfaces.get(k).map_or(1, |surface| side(surface, p, ON));
        if let Some(known) = self.tree.holds(&looked) {
            return Ok(known);
        }
        let sides: Vec<i8> = (0..self.surfaces.len()).map(looked).collect();
        let side_of = |k: usize| sides.get(k).copied().unwrap_or(1);
        let active: Vec<usize> = (0..sides.len()).filter(|k| side_of(*k) == 0).collect();
        if let [only] = *active {
            let next_to = |sign: i8| self.tree.holds(&|k| if k == only { sign } else { side_of(k) }) == Some(true);
            return Ok(next_to(-1) || next_to(1));
        }
        let normals: Vec<DVec3> =
            active.iter().filter_map(|k| self.surfaces.get(*k)).map(|surface| surface.normal(p)).collect();
        let material = cells(&normals).iter().any(|cell| {
            let in_cell = |k: usize| match active.iter().position(|a| *a == k) {
                Some(at) => cell.get(at).copied().unwrap_or(1),
                None => side_of(k),
            };
            self.tree.holds(&in_cell) == Some(true)
        });
        let tangent = || normals.iter().enumerate().any(|(k, a)| normals.iter().skip(k + 1).any(|b| parallel(*a, *b)));
        if !material && tangent() { Err(SolidError::Cusp(p)) } else { Ok(material) }
    }

    /// What is certain about all points within `reach` of `p`: that they belong to the solid, or do not.
    /// The sides of the surfaces `a` and `b` count as unknown.
    pub(super) fn certain(&self, p: DVec3, reach: f64, a: usize, b: usize) -> Option<bool> {
        self.tree.holds(&|k| match self.surfaces.get(k) {
            Some(surface) if k != a && k != b => side(surface, p, reach),
            _ => 0,
        })
    }

    fn find_features(&mut self) -> Result<(), SolidError> {
        let mut used = vec![[false; 2]; self.surfaces.len()];
        self.tree.mark_sides(&mut used);
        for (surface, [kept, cut]) in self.surfaces.iter().zip(used) {
            self.features.extend(kept.then_some(Feature::Face(*surface, 1.0)));
            self.features.extend(cut.then_some(Feature::Face(*surface, -1.0)));
            self.features.extend(surface.apex().map(Feature::Corner));
        }
        let mut pairs: Vec<(usize, usize)> = Vec::new();
        self.tree.for_each_edge_pair(&mut |a, b| {
            if a != b {
                pairs.push((a.min(b), a.max(b)));
            }
        });
        pairs.sort_unstable();
        pairs.dedup();
        let mut looks = 0;
        for (a, b) in pairs {
            self.find_edges(a, b, &mut looks)?;
        }
        Ok(())
    }

    /// Adds the edges in which two surfaces meet, and the corners at their ends.
    fn find_edges(&mut self, a: usize, b: usize, looks: &mut u64) -> Result<(), SolidError> {
        let (Some(first), Some(second)) = (self.surfaces.get(a), self.surfaces.get(b)) else { return Ok(()) };
        let curves = match meet(first, second) {
            Meeting::Curves(curves) => curves,
            Meeting::Other => {
                self.unsupported.push((a, b));
                return Ok(());
            }
        };
        for curve in curves {
            let (real, corners) = self.real_stretches(&curve, a, b, looks);
            if *looks > MOST_LOOKS {
                return Err(SolidError::TooMany);
            }
            if real {
                self.features.push(Feature::Edge(curve));
            }
            for corner in corners {
                let known = |f: &Feature| matches!(f, Feature::Corner(p) if (p - corner).length() <= ON);
                if !self.features.iter().any(known) {
                    self.features.push(Feature::Corner(corner));
                }
            }
        }
        Ok(())
    }

    /// Cuts a curve at the other surfaces: whether any stretch belongs to the body, and where such stretches end.
    fn real_stretches(&self, curve: &Curve, a: usize, b: usize, looks: &mut u64) -> (bool, Vec<DVec3>) {
        let (mut real, mut corners) = (false, Vec::new());
        for piece in curve.pieces() {
            let mut cuts = vec![piece.low];
            for (k, surface) in self.surfaces.iter().enumerate() {
                if k != a && k != b {
                    cuts.extend(crossings(surface, &piece));
                }
            }
            cuts.push(piece.high);
            cuts.sort_by(f64::total_cmp);
            *looks += (cuts.len() * self.surfaces.len()) as u64;
            for (from, to) in cuts.iter().zip(cuts.iter().skip(1)) {
                // A point that cannot be decided keeps its stretch: contacts with it are examined again.
                if self.holds(piece.at(0.5 * (from + to))).unwrap_or(true) {
                    real = true;
                    corners.extend(
                        [*from, *to].iter().filter(|u| **u != piece.low && **u != piece.high).map(|u| piece.at(*u)),
                    );
                }
            }
        }
        (real, corners)
    }
}

/// Where a piece of a curve crosses a surface; nothing if it lies in the surface.
fn crossings(surface: &Surface, piece: &Piece) -> Vec<f64> {
    let samples = [0.13, 0.37, 0.59, 0.83];
    let within = |share: &f64| surface.signed(piece.at(piece.low + (piece.high - piece.low) * share)).abs() <= ON;
    if samples.iter().all(within) {
        return Vec::new();
    }
    let Some(poly) = surface.at_gap(piece, 0.0) else { return Vec::new() };
    let mut roots = poly.roots(piece.low, piece.high);
    roots.retain(|u| surface.signed(piece.at(*u)).abs() <= 10.0 * ON);
    roots
}

/// The side of a surface on which a point lies, 0 if closer than `reach`; a cone's apex closes both sides.
fn side(surface: &Surface, p: DVec3, reach: f64) -> i8 {
    let signed = surface.signed(p);
    if signed > reach {
        1
    } else if signed < -reach {
        -1
    } else if surface.apex().is_some_and(|apex| (p - apex).length() <= ON) {
        EITHER
    } else {
        0
    }
}

fn is_sound(surface: &Surface) -> bool {
    let unit = |v: DVec3| v.is_finite() && (v.length() - 1.0).abs() < 1e-9;
    match *surface {
        Surface::Plane { normal, offset } => unit(normal) && offset.is_finite(),
        Surface::Sphere { centre, radius } => centre.is_finite() && radius.is_finite() && radius > 0.0,
        Surface::Cylinder { origin, axis, radius } => {
            origin.is_finite() && unit(axis) && radius.is_finite() && radius > 0.0
        }
        Surface::Cone { apex, axis, sin, cos } => apex.is_finite() && unit(axis) && sin > 0.0 && cos > 0.0,
    }
}
