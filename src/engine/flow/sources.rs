//! Where the contours of a run come from: the labels of a definition, a program with declarations, a formula, a list.
//!
//! Invariant: plain data; what reads contours is not known here.
use std::collections::BTreeMap;
use std::sync::Arc;

use crate::engine::region::relief::Relief;
use crate::engine::world::coordinates::System;

/// Where the contours of a run come from, and what formulas know.
#[derive(Default)]
pub(crate) struct Sources {
    /// The contour that is selected; nothing where the labels of a definition are.
    pub(crate) selected: Option<Selected>,
    /// Contours by the number of their name `QC`.
    pub(crate) declared: BTreeMap<u32, Relief>,
    /// The coordinates of the contours while a program with declarations is executed: those before it.
    pub(crate) reading: Option<Arc<System>>,
}

/// A contour that is no list of labels.
#[derive(Clone)]
pub(crate) enum Selected {
    /// Of the last formula of a program, which is executed for each cycle.
    Program(usize),
    /// Of a formula.
    Formula(u32),
    /// Of `CONTOUR DEF`.
    List(Arc<[Listed]>),
}

/// A contour of `CONTOUR DEF`.
#[derive(Clone)]
pub(crate) struct Listed {
    pub(crate) of: Of,
    /// Whether it is a pocket, and no island.
    pub(crate) is_pocket: bool,
    /// Its own depth or, of an island, how far it lies below the surface, mm.
    pub(crate) depth: Option<f64>,
}

/// What describes a contour.
#[derive(Clone)]
pub(crate) enum Of {
    /// A subprogram.
    Label(Arc<str>),
    /// A program, by its number.
    Program(usize, Arc<str>),
}

impl Of {
    pub(crate) fn name(&self) -> &str {
        match self {
            Self::Label(name) | Self::Program(_, name) => name,
        }
    }
}

impl Sources {
    /// From now on the labels of a definition say which contours there are.
    pub(crate) fn take_labels(&mut self) {
        self.selected = None;
    }
}
