//! Lengths in the unit of a program or cycle, and in mm.
//!
//! Invariant: in programs in mm no number changes by that.
use glam::DVec3;

use super::drives::Drives;
use crate::engine::geometry::Axis;
use crate::engine::table::{Quantity, TableKind};

/// Coordinates that come back from the program's unit no further from where the tool is, in mm, are the same.
const SAME: f64 = 1e-10;

impl Drives<'_, '_> {
    /// mm in the unit of the program.
    pub(crate) const fn unit(&self) -> f64 {
        self.unit
    }

    /// mm in the unit in which the cycle being executed calculates.
    pub(crate) const fn cycle_unit(&self) -> f64 {
        self.cycle_unit
    }

    /// A point of a cycle (main, minor, tool axis, in its unit) by axis and in mm.
    pub(crate) fn to_mm(&self, point: DVec3) -> DVec3 {
        let axes = self.world.system.axes(point) / self.world.system.doubled_axes();
        if self.unit() == 1.0 {
            return axes;
        }
        self.unless_moved(axes * self.cycle_unit())
    }

    /// Coordinates that differ from the present ones by rounding only are the present ones.
    pub(crate) fn unless_moved(&self, to: DVec3) -> DVec3 {
        Axis::ALL.into_iter().fold(to, |to, axis| {
            let here = axis.of(self.world.here);
            if (axis.of(to) - here).abs() < SAME { axis.with(to, here) } else { to }
        })
    }

    /// The same for one coordinate.
    pub(crate) fn with_mm(&self, axis: Axis, to: DVec3, value: f64) -> DVec3 {
        let to = axis.with(to, value * self.cycle_unit() / self.world.system.doubled(axis));
        if self.unit() == 1.0 { to } else { self.unless_moved(to) }
    }

    /// A point by axis and in mm as a cycle has it: main, minor and tool axis, in its unit.
    pub(crate) fn to_program(&self, axes: DVec3) -> DVec3 {
        self.in_plane(axes * self.world.system.doubled_axes()) / self.cycle_unit()
    }

    /// mm, or mm/min, in the unit in which the cycle has what a column holds.
    pub(crate) fn unit_of(&self, table: TableKind, column: &str) -> f64 {
        match table.column(column).map(|column| column.quantity) {
            Some(Quantity::Length | Quantity::Feed) => self.cycle_unit(),
            _ => 1.0,
        }
    }
}
