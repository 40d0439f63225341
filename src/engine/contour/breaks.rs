//! What a program puts between two elements of a contour: a rounding, a chamfer, an undercut, a recess.
//!
//! Invariant: plain geometry.
use super::element::{Element, broken, rounded};
use super::recess::Recess;
use super::undercut::Undercut;
use crate::engine::report::fault::Fault;

/// What comes at a corner.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Break {
    Rounding(f64),
    Chamfer(f64),
    Undercut(Undercut),
    /// In the element before the corner, which stays as it is.
    Recess(Recess),
}

impl Break {
    /// What is left of the two elements, with what comes between them.
    pub(crate) fn elements(
        &self,
        first: &Element,
        second: &Element,
    ) -> Result<(Element, Vec<Element>, Element), Fault> {
        let alone = |(first, corner, last): (Element, Option<Element>, Element)| (first, Vec::from_iter(corner), last);
        let too_small = |size: f64| Fault::program("rounding-impossible").arg("size", size);
        match *self {
            Self::Rounding(radius) => rounded(first, second, radius).map(alone).ok_or_else(|| too_small(radius)),
            Self::Chamfer(leg) => broken(first, second, leg).map(alone).ok_or_else(|| too_small(leg)),
            Self::Undercut(undercut) => {
                undercut.between(first, second).ok_or_else(|| Fault::program("undercut-impossible"))
            }
            Self::Recess(recess) => {
                let (first, rest) = recess.within(first).ok_or_else(|| Fault::program("recess-impossible"))?;
                Ok((first, rest, *second))
            }
        }
    }
}
