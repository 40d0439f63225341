//! The unit of the program being executed: Q parameters and the formulas of cycles have its lengths, the world has mm.
//!
//! Invariant: lengths are converted where values leave the program or a cycle and where they come back, and nowhere
//! else; in programs in mm no number changes by that.
use glam::DVec3;

use super::Run;
use crate::engine::geometry::Axis;
use crate::engine::table::{Quantity, TableKind};

/// Coordinates that come back from the program's unit no further from where the tool stands, in mm, are the same.
const SAME: f64 = 1e-10;

impl Run<'_, '_> {
    /// mm in the unit of the program.
    pub(super) fn unit(&self) -> f64 {
        self.programs.get(self.flow.program).map_or(1.0, |program| program.unit)
    }

    /// A point of a cycle (main, minor, tool axis, in the program's unit) by axis and in mm.
    pub(super) fn to_mm(&self, point: DVec3) -> DVec3 {
        let unit = self.unit();
        let axes = self.world.system.axes(point);
        if unit == 1.0 {
            return axes;
        }
        Axis::ALL.into_iter().fold(axes * unit, |to, axis| self.unless_moved(axis, to))
    }

    /// A coordinate that differs from the present one by rounding only is the present one.
    fn unless_moved(&self, axis: Axis, to: DVec3) -> DVec3 {
        let here = axis.of(self.world.here);
        if (axis.of(to) - here).abs() < SAME { axis.with(to, here) } else { to }
    }

    /// The same for one coordinate.
    pub(super) fn with_mm(&self, axis: Axis, to: DVec3, value: f64) -> DVec3 {
        let unit = self.unit();
        let to = axis.with(to, value * unit);
        if unit == 1.0 { to } else { self.unless_moved(axis, to) }
    }

    /// A point by axis and in mm as a cycle has it: main, minor and tool axis, in the program's unit.
    pub(super) fn to_program(&self, axes: DVec3) -> DVec3 {
        self.in_plane(axes) / self.unit()
    }

    /// mm, or mm/min, in the unit in which the program has what a column holds.
    pub(super) fn unit_of(&self, table: TableKind, column: &str) -> f64 {
        match table.column(column).map(|column| column.quantity) {
            Some(Quantity::Length | Quantity::Feed) => self.unit(),
            _ => 1.0,
        }
    }
}
