//! The unit of the program being executed: Q parameters have its lengths, the world has mm.
//!
//! A cycle that probes calculates in the unit of the program, as its results are in it; any other one in mm. Invariant:
//! lengths are converted where values leave the program or a cycle and where they come back, and nowhere else; in
//! programs in mm no number changes by that.
use glam::DVec3;

use crate::base::expr::QRef;
use crate::engine::flow::definition::Definition;
use crate::engine::geometry::Axis;
use crate::engine::plan::Plan;
use crate::engine::run::Run;
use crate::engine::table::{Quantity, TableKind};
use crate::spec::{CycleKey, Keyword};

/// Coordinates that come back from the program's unit no further from where the tool stands, in mm, are the same.
const SAME: f64 = 1e-10;
/// The steps to which lengths are rounded that come from inches, a mm.
const STEPS: f64 = 1e10;

/// mm in the unit in which the run of a cycle calculates that was defined in that unit.
fn calculated_in(plan: &Plan, key: CycleKey, unit: f64) -> f64 {
    if plan.probes || key.keyword == Keyword::TchProbe { unit } else { 1.0 }
}

impl Definition<'_> {
    /// A length or feed of the program as the run of the cycle calculates with it. What was a round number of mm before
    /// the program wrote it in inches is one again: guards compare sizes.
    pub(in crate::engine) fn in_run(&self, value: f64) -> f64 {
        Self::scaled(value, self.scale())
    }

    /// The same for the value of a Q parameter.
    pub(in crate::engine) fn read(&self, q: QRef, value: f64) -> f64 {
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
    pub(in crate::engine) fn scale_of(&self, q: QRef) -> f64 {
        let scale = self.scale();
        if scale == 1.0 || !self.plan.measures.contains(&q) { 1.0 } else { scale }
    }
}

impl<'e> Run<'_, 'e> {
    /// mm in the unit of the program.
    pub(in crate::engine) fn unit(&self) -> f64 {
        self.programs.get(self.flow.program).map_or(1.0, |program| program.unit)
    }

    /// mm in the unit in which the cycle being executed calculates.
    pub(in crate::engine) const fn cycle_unit(&self) -> f64 {
        self.calculating_in
    }

    /// Does something with a cycle in the unit in which it calculates.
    pub(in crate::engine) fn in_unit_of<T>(
        &mut self,
        definition: &Definition<'e>,
        work: impl FnOnce(&mut Self) -> T,
    ) -> T {
        let unit = calculated_in(&definition.plan, definition.cycle.key, definition.unit);
        let outer = std::mem::replace(&mut self.calculating_in, unit);
        let done = work(self);
        self.calculating_in = outer;
        done
    }

    /// A point of a cycle (main, minor, tool axis, in its unit) by axis and in mm.
    pub(in crate::engine) fn to_mm(&self, point: DVec3) -> DVec3 {
        let axes = self.world.system.axes(point);
        if self.unit() == 1.0 {
            return axes;
        }
        self.unless_moved(axes * self.cycle_unit())
    }

    /// Coordinates that differ from the present ones by rounding only are the present ones.
    pub(in crate::engine) fn unless_moved(&self, to: DVec3) -> DVec3 {
        Axis::ALL.into_iter().fold(to, |to, axis| {
            let here = axis.of(self.world.here);
            if (axis.of(to) - here).abs() < SAME { axis.with(to, here) } else { to }
        })
    }

    /// The same for one coordinate.
    pub(in crate::engine) fn with_mm(&self, axis: Axis, to: DVec3, value: f64) -> DVec3 {
        let to = axis.with(to, value * self.cycle_unit());
        if self.unit() == 1.0 { to } else { self.unless_moved(to) }
    }

    /// A point by axis and in mm as a cycle has it: main, minor and tool axis, in its unit.
    pub(in crate::engine) fn to_program(&self, axes: DVec3) -> DVec3 {
        self.in_plane(axes) / self.cycle_unit()
    }

    /// mm, or mm/min, in the unit in which the cycle has what a column holds.
    pub(in crate::engine) fn unit_of(&self, table: TableKind, column: &str) -> f64 {
        match table.column(column).map(|column| column.quantity) {
            Some(Quantity::Length | Quantity::Feed) => self.cycle_unit(),
            _ => 1.0,
        }
    }
}
