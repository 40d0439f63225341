//! A cycle as a program has defined it: its plan, its old-style fields, its unit.
//!
//! A cycle that probes calculates in the unit of the program, as its results are in it; any other one in mm. Invariant:
//! lengths are converted where values leave the program or a cycle and where they come back, and nowhere else; in
//! programs in mm no number changes by that.
use std::sync::Arc;

use glam::DVec3;

use crate::base::expr::QRef;
use crate::engine::geometry::Axis as LinearAxis;
use crate::engine::plan::Plan;
use crate::spec::{Cycle, CycleKey, Keyword, OnControl};

/// The steps to which lengths are rounded that come from inches, a mm.
const STEPS: f64 = 1e10;

/// mm in the unit in which the run of a cycle calculates that was defined in that unit.
fn calculated_in(plan: &Plan, key: CycleKey, unit: f64) -> f64 {
    if plan.probes || key.keyword == Keyword::TchProbe { unit } else { 1.0 }
}

/// A coordinate of an old-style field.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct FieldCoord {
    /// The axis; of a rotary one, the linear axis that it turns about.
    pub(crate) axis: LinearAxis,
    /// Whether it is the rotary axis.
    pub(crate) rotary: bool,
    /// mm, or degrees.
    pub(crate) value: f64,
    pub(crate) incremental: bool,
}

/// The value of an old-style field.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum FieldValue {
    /// A number; whether it counts from what is in effect, and whether it is a length or feed in
    /// the unit of the program.
    Number { value: f64, incremental: bool, length: bool },
    /// Coordinates.
    Coords(Vec<FieldCoord>),
    /// An axis with the sense of a movement.
    Direction(DVec3),
    /// A Q parameter.
    Q(QRef),
    /// A text, or a list of labels.
    Text(Arc<str>),
}

/// A cycle as it was defined.
#[derive(Clone, Debug)]
pub(crate) struct Definition<'e> {
    /// The definitions of a run are numbered.
    pub(crate) id: u64,
    pub(crate) cycle: &'e Cycle,
    /// The control whose manual describes it.
    pub(crate) on: &'e OnControl,
    pub(crate) plan: Arc<Plan>,
    /// mm in the unit of the program that defines it.
    pub(crate) unit: f64,
    /// The form, if the cycle has several.
    pub(crate) form: Option<usize>,
    /// Values of old-style fields by their ids.
    pub(crate) fields: Vec<(Arc<str>, FieldValue)>,
}

impl Definition<'_> {
    /// The value of a field.
    pub(crate) fn field(&self, id: &str) -> Option<&FieldValue> {
        self.fields.iter().find(|(known, _)| **known == *id).map(|(_, value)| value)
    }
}

impl Definition<'_> {
    /// A length or feed of the program as the run of the cycle calculates with it. What was a round number of mm before
    /// the program wrote it in inches is one again: guards compare sizes.
    pub(crate) fn in_run(&self, value: f64) -> f64 {
        Self::scaled(value, self.scale())
    }

    /// The same for the value of a Q parameter.
    pub(crate) fn read(&self, q: QRef, value: f64) -> f64 {
        Self::scaled(value, self.scale_of(q))
    }

    fn scaled(value: f64, scale: f64) -> f64 {
        if scale == 1.0 { value } else { libm::round(value * scale * STEPS) / STEPS }
    }

    fn scale(&self) -> f64 {
        if self.unit == 1.0 {
            return 1.0;
        }
        self.unit / calculated_in(&self.plan, self.cycle.key, self.unit)
    }

    /// What the value of a Q parameter is multiplied with.
    pub(crate) fn scale_of(&self, q: QRef) -> f64 {
        let scale = self.scale();
        if scale == 1.0 || !self.plan.measures.contains(&q) { 1.0 } else { scale }
    }

    /// mm in the unit in which the run of the cycle calculates.
    pub(crate) fn calculates_in(&self) -> f64 {
        calculated_in(&self.plan, self.cycle.key, self.unit)
    }
}
