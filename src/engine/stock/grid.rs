//! The grid of the columns: where they are, in the machine and in the coordinates of the blank.
use glam::{DVec2, DVec3};

use super::columns::{larger, smaller};
use crate::engine::geometry::{Frame, WorkingPlane};

/// Rows that lie together in one lane.
pub(super) const BAND: usize = 4;

/// Where columns are.
#[derive(Clone, Copy, Debug)]
pub(super) struct Grid {
    /// From the coordinates of the blank to the machine, and back.
    pub(super) frame: Frame,
    pub(super) back: Frame,
    /// The plane across the columns.
    pub(super) plane: WorkingPlane,
    /// The lower corner in the coordinates of the grid: main axis, secondary axis, along the columns.
    pub(super) min: DVec3,
    pub(super) max: DVec3,
    /// Size of a cell, and how many there are in a mm.
    pub(super) cell: DVec2,
    pub(super) each: DVec2,
    pub(super) columns: usize,
    pub(super) rows: usize,
}

impl Grid {
    pub(super) fn x(&self, column: usize) -> f64 {
        self.min.x + (column as f64 + 0.5) * self.cell.x
    }

    pub(super) fn y(&self, row: usize) -> f64 {
        self.min.y + (row as f64 + 0.5) * self.cell.y
    }

    /// Coordinates of the grid of a point of the machine.
    pub(super) fn point(&self, machine: DVec3) -> DVec3 {
        self.in_plane(self.back.point(machine))
    }

    pub(super) fn vector(&self, machine: DVec3) -> DVec3 {
        self.in_plane(self.back.vector(machine))
    }

    pub(super) fn in_plane(&self, blank: DVec3) -> DVec3 {
        let flat = self.plane.flat(blank);
        DVec3::new(flat.x, flat.y, self.plane.tool.of(blank))
    }

    /// The point in the coordinates of the blank.
    pub(super) fn blank(&self, grid: DVec3) -> DVec3 {
        self.plane.lift(DVec2::new(grid.x, grid.y), grid.z)
    }

    /// Indices from `low` to `high`, both included, whose centres lie between the two coordinates.
    pub(super) fn between(from: f64, to: f64, origin: f64, each: f64, count: usize) -> Option<(usize, usize)> {
        let from = larger((from - origin) * each - 0.5, 0.0);
        let to = smaller((to - origin) * each - 0.5, count as f64 - 1.0);
        // What is no number is on no side of another.
        if from.partial_cmp(&to).is_none_or(|order| order.is_gt()) {
            return None;
        }
        // A grid has fewer columns than the largest number that a cast gives.
        let (low, high) = (from as i32, to as i32);
        let low = if f64::from(low) < from { low + 1 } else { low };
        let (low, high) = (low as usize, high as usize);
        (low <= high).then_some((low, high))
    }
}
