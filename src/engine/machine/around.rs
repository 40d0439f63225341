//! Where a tool is, seen from the rotary axis on which the workpiece is clamped.
//!
//! Invariant: the directions are those of the machine: what turns is the workpiece, the tool keeps its direction.
use glam::DVec3;

use super::{Carried, Machine, RotaryMachineAxis};

/// The directions in which [`Around`](crate::engine::geometry::Around) counts, in machine coordinates.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Across {
    /// A point of the rotary axis.
    pub centre: DVec3,
    /// Along it; a growing coordinate takes the tool right-handed about it.
    pub along: DVec3,
    /// From the workpiece to the spindle.
    pub up: DVec3,
}

impl Across {
    /// The third direction.
    pub fn beside(&self) -> DVec3 {
        self.along.cross(self.up)
    }

    /// A point of the machine: beside the rotary axis, along it and above it.
    pub fn seen(&self, point: DVec3) -> DVec3 {
        let arm = point - self.centre;
        DVec3::new(arm.dot(self.beside()), arm.dot(self.along), arm.dot(self.up))
    }

    /// The way back from [`Across::seen`].
    pub fn point(&self, seen: DVec3) -> DVec3 {
        self.centre + self.beside() * seen.x + self.along * seen.y + self.up * seen.z
    }
}

impl Machine {
    /// The rotary axis on which the workpiece is clamped: the last one of the table.
    pub fn clamped_on(&self) -> Option<&RotaryMachineAxis> {
        self.rotary.iter().rev().find(|axis| axis.carries == Carried::Workpiece)
    }

    /// The directions about that axis, with the tool as the head turns it.
    pub fn across(&self, axis: &RotaryMachineAxis, angles: DVec3) -> Across {
        let turning = self.turning(axis, angles);
        let up = self.head(angles).vector(self.spindle.unit()).normalize();
        // The workpiece turns one way, so to it the tool goes the other way. What rounding has left along it is no part
        // of the direction of the tool.
        let along = (-turning.direction).normalize();
        Across { centre: turning.centre, along, up: up.reject_from(along).normalize_or_zero() }
    }
}
