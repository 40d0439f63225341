//! The insert of a turning tool: which way its tip points, and its size.
//!
//! Which number of the tool orientation is which way, and what lengthens a tool, is common knowledge of the trade
//! (`docs/tables.md`). Invariant: coordinates of the half plane are those of the machine, along X and along Z.
use glam::{DVec2, DVec3};

/// Which way the tip points from the centre of the nose, by the numbers of the column `TO`, along X and Z.
const WAYS: [(f64, f64); 9] =
    [(-1.0, -1.0), (-1.0, 0.0), (-1.0, 1.0), (0.0, 1.0), (1.0, 1.0), (1.0, 0.0), (1.0, -1.0), (0.0, -1.0), (0.0, 0.0)];

/// The insert of a turning tool.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct TurningInsert {
    /// The radius of its nose, mm.
    pub radius: f64,
    /// The angle of its main edge to the rotary axis, degrees; 0 if it is not known.
    pub angle: f64,
    /// The angle of its point, degrees; 0 if it is not known.
    pub point: f64,
    /// Its cutting width, mm; 0 if it is none for recesses.
    pub width: f64,
    /// Which way its tip points, along X and Z: -1, 0 or 1; nothing if it is not known.
    pub way: Option<DVec2>,
    /// The number of the tool.
    pub tool: f64,
    /// Whether the tool is reversed.
    pub reversed: bool,
}

impl TurningInsert {
    /// Which way the tip of a tool points by its orientation; nothing of one that is none.
    pub fn way_of(orientation: f64, reversed: bool) -> Option<DVec2> {
        let index = (orientation.fract() == 0.0 && orientation >= 1.0).then(|| orientation as usize - 1)?;
        let (x, z) = *WAYS.get(index)?;
        Some(DVec2::new(if reversed { -x } else { x }, z))
    }

    /// The number of the orientation in effect: that of a reversed tool is mirrored. 0 if it is not known.
    pub fn orientation(&self) -> f64 {
        let found = self.way.and_then(|way| WAYS.iter().position(|own| DVec2::from(*own) == way));
        found.map_or(0.0, |index| index as f64 + 1.0)
    }
}

/// How a program corrects the tool with which it turns.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct InsertCorrection {
    /// Along X and Z, mm.
    pub lengths: DVec2,
    /// Of the radius of the nose, mm.
    pub radius: f64,
    /// Of the cutting width, mm.
    pub width: f64,
    /// Whether the lengths are those of the tool, and not of the coordinate system of the workpiece.
    pub of_tool: bool,
}

impl InsertCorrection {
    /// By how much the tip of the tool, as the tables have it, is beside the programmed position. A tool that is longer
    /// than the tables say stays further away: above, and on the side from which its tip points.
    pub fn beside(&self, way: Option<DVec2>) -> DVec3 {
        let inside = self.of_tool && way.is_some_and(|way| way.x > 0.0);
        let across = if inside { -self.lengths.x } else { self.lengths.x };
        DVec3::new(across, 0.0, self.lengths.y)
    }
}
