//! Exact solids: half-spaces, boxes, cylinders, cones and spheres, joined, cut, shifted and rotated, and triangulated
//! surfaces beside them; and the contact of a moving ball with them.
//!
//! # Why the contact is exact
//! A shape is reduced to four kinds of surfaces (plane, sphere, cylinder, cone) that AND and OR combine. Let
//! `p` be the point where a ball first touches the solid. Write the solid as an OR of ANDs: `p` is the nearest
//! point of one of these ANDs, so the way from `p` to the ball centre is a combination of the normals of the
//! surfaces on which `p` lies. With one such surface `p` is the foot of the perpendicular to a face, with two
//! it is the nearest point of the curve in which they meet, with three it is a corner (an apex is one, too).
//! For each face, edge and corner, "the centre is one radius away" is a polynomial equation along a line or
//! (in half-angle form) along an arc; all its roots are found by bisection between critical points and
//! sharpened on the distance itself. The earliest root whose point belongs to the solid is the contact: one
//! that belongs to it is a contact, and the first contact is among them.
//!
//! # Limits, each an error and never an approximation
//! - Edges that are neither lines nor circles (a plane oblique to a hole, two crossing holes) cannot be
//!   touched: a ball that comes within 1/32 of its radius of such an edge gives [`SolidError::Edge`]. Faces
//!   next to such edges are exact.
//! - Where surfaces touch without crossing and leave material of no thickness: [`SolidError::Cusp`].
//! - A triangulated surface can be joined with solids, and not be cut by them or cut them: [`SolidError::CutMesh`].
//! - A helix is either proven free of contact or [`SolidError::Helix`].
//! - The shaft of a stylus is decided to 1e-6 mm: nearer than that, it touches.
//!
//! Invariant: lengths are mm; nothing here knows a control, a scene file or a program.
mod body;
mod cells;
mod contact;
mod curve;
mod mesh;
mod path;
mod poly;
mod ray;
mod shaft;
mod shape;
mod surface;
mod turned;

pub use body::Body;
pub use contact::{Contact, Nearest};
pub use mesh::Mesh;
pub use path::Path;
pub use shape::Shape;
pub use turned::{HalfWay, Shaped, Taken};

use glam::DVec3;

/// Why a question to a solid has no answer. The point says where.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SolidError {
    /// A number of the question or of the shape is not finite, or a length that must be positive is not.
    NotFinite,
    /// An edge that is neither a line nor a circle may be touched.
    Edge(DVec3),
    /// A shape has so many surfaces that it would take too long to find its edges.
    TooMany,
    /// Surfaces touch without crossing and leave material of no thickness.
    Cusp(DVec3),
    /// A triangulated surface is cut, or cuts something.
    CutMesh,
    /// A helical motion may touch.
    Helix(DVec3),
}

impl SolidError {
    /// The code of the diagnostic that says it.
    pub const fn code(&self) -> &'static str {
        match self {
            Self::NotFinite => "solid-not-finite",
            Self::TooMany => "solid-too-many",
            Self::CutMesh => "solid-mesh-cut",
            Self::Edge(_) => "solid-edge-unsupported",
            Self::Cusp(_) => "solid-cusp",
            Self::Helix(_) => "solid-helix-unsupported",
        }
    }

    /// Where the trouble is, in the coordinates of the solid.
    pub const fn point(&self) -> Option<DVec3> {
        match *self {
            Self::NotFinite | Self::TooMany | Self::CutMesh => None,
            Self::Edge(p) | Self::Cusp(p) | Self::Helix(p) => Some(p),
        }
    }
}
