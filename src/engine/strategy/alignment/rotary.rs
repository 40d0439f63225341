//! Strategies of rotary axes: aligning a workpiece, zeroing a display.
//!
//! Invariant: a direction is never guessed: points that determine none are a fault.
use glam::{DVec2, DVec3};

use super::basic_rotation::direction;
use crate::base::expr::atan2d;
use crate::engine::geometry::{Axis, RotaryAxis, WorkingPlane};
use crate::engine::report::ending::Done;
use crate::engine::report::fault::Fault;
use crate::engine::strategy::action::{Action, Control, RotaryAxes, numbered_axis, table_axis};
use crate::engine::strategy::calculation::{SAME_POINT, directed};
use crate::engine::strategy::signature::{results, strategy};
use crate::engine::table::{Cell, TableKind};

/// A rotary axis turns about a direction if the cosine of the angle between them differs from 1 by less.
const ALONG: f64 = 1e-9;

strategy! {
    /// Turns the rotary axis about the tool axis so that a workpiece turned by an angle is straight.
    AlignRotaryTable = "align-rotary-table" {
        /// By how much the workpiece is turned in the working plane, degrees.
        angle: f64 = Angle,
    }
}

results! {
    /// How an axis was turned.
    AlignRotaryTableResults {
        /// By how much, degrees.
        way: f64 = Angle,
    }
}

strategy! {
    /// Turns a rotary axis so that a line of the workpiece lies along an axis or at an angle to one: a line measured
    /// along an axis of the working plane along the other one; one measured along the tool axis level across the rotary
    /// axis.
    AlignRotaryAxis = "align-rotary-axis" {
        /// A point of the line.
        from: DVec3 = Length,
        /// Another one.
        to: DVec3 = Length,
        /// Along which axis it was measured: 1 main, 2 minor, 3 tool axis.
        measuring_axis: f64 = Number,
        /// The rotary axis: 4 to 6 are A to C.
        axis: f64 = Number,
        /// The angle at which it shall lie to where it would lie so, degrees.
        angle: Option<f64> = Angle,
    }
}

strategy! {
    /// Turns a rotary axis so that the direction from the datum to a point becomes the one to its nominal position. The
    /// directions are those in the plane across the rotary axis.
    AlignDirection = "align-direction" {
        /// The rotary axis: 4 to 6 are A to C.
        axis: f64 = Number,
        /// Where the point is.
        actual: DVec3 = Length,
        /// Where it shall be.
        nominal: DVec3 = Length,
        /// Whether it shall lie along the second axis of the plane instead (Y for C).
        along_second_axis: bool = Number,
    }
}

results! {
    /// A misalignment, and how it was compensated.
    AlignedResults {
        /// The misalignment, degrees.
        angle: f64 = Angle,
        /// By how much the axis was turned, degrees.
        way: f64 = Angle,
    }
}

strategy! {
    /// The coordinate of a rotary axis becomes 0.
    ZeroRotaryTable = "zero-rotary-table" {
        /// The rotary axis, 4 to 6 are A to C; without it the one about the tool axis.
        axis: Option<f64> = Number,
    }
}

strategy! {
    /// The coordinate of a rotary axis becomes 0, and a row of a table gets what makes it so: the preset table where the
    /// axis is in machine coordinates; the datum table the shift from the present preset, which takes effect.
    ZeroRotaryAxis = "zero-rotary-axis" {
        /// The rotary axis: 4 to 6 are A to C.
        axis: f64 = Number,
        /// The row.
        row: f64 = Number,
        /// Whether the table is the preset table.
        transfer: bool = Number,
    }
}

strategy! {
    /// Adds an angle to what a row of the active datum table has for a rotary axis.
    AddAngleToDatumRow = "add-angle-to-datum-row" {
        /// The angle, degrees.
        angle: f64 = Angle,
        /// The row.
        row: f64 = Number,
        /// The rotary axis: 4 to 6 are A to C.
        axis: f64 = Number,
    }
}

impl Action for AlignRotaryTable {
    type Results = AlignRotaryTableResults;

    fn act(&self, control: &mut dyn Control) -> Done<AlignRotaryTableResults> {
        let axis = table_axis(control);
        let way = straightening(axis, axis.0, self.angle, control)?;
        turn_by(axis, way, control)?;
        Ok(AlignRotaryTableResults { way })
    }
}

impl Action for AlignRotaryAxis {
    type Results = AlignedResults;

    fn act(&self, control: &mut dyn Control) -> Done<AlignedResults> {
        let plane = control.plane();
        let measured = match self.measuring_axis {
            1.0 => plane.main,
            2.0 => plane.secondary,
            _ => plane.tool,
        };
        let axis = numbered_axis(self.axis)?;
        let about = axis.0;
        // The axis along which the line shall lie, and the one that follows it about the rotary axis.
        let along = Axis::ALL.into_iter().find(|known| *known != measured && *known != about);
        let in_plane = about == plane.tool;
        let (Some(along), true) = (along, in_plane != (measured == plane.tool)) else {
            return Err(unsuitable(axis).into());
        };
        let across = about.unit().cross(along.unit());
        let way = control.axes(self.to) - control.axes(self.from);
        let (x, y) = (along.of(way), way.dot(across));
        if libm::hypot(x, y) < SAME_POINT {
            return Err(Fault::control("direction-undefined").arg("distance", libm::hypot(x, y)).into());
        }
        let angle = line(atan2d(y, x) - self.angle.unwrap_or(0.0));
        let way = straightening(axis, about, angle, control)?;
        turn_by(axis, way, control)?;
        Ok(AlignedResults { angle, way })
    }
}

impl Action for AlignDirection {
    type Results = AlignedResults;

    fn act(&self, control: &mut dyn Control) -> Done<AlignedResults> {
        let axis = numbered_axis(self.axis)?;
        let plane = WorkingPlane::of_tool_axis(axis.0);
        let flat = |point| directed(plane.flat(control.axes(point)));
        let actual = flat(self.actual)?;
        let nominal = if self.along_second_axis { DVec2::Y } else { flat(self.nominal)? };
        let angle = direction(atan2d(actual.y, actual.x) - atan2d(nominal.y, nominal.x));
        let way = straightening(axis, axis.0, angle, control)?;
        turn_by(axis, way, control)?;
        Ok(AlignedResults { angle, way })
    }
}

impl Action for ZeroRotaryTable {
    type Results = ();

    fn act(&self, control: &mut dyn Control) -> Done {
        let axis = self.axis.map_or_else(|| Ok(table_axis(control)), numbered_axis)?;
        zero_display(axis, control);
        Ok(())
    }
}

impl Action for ZeroRotaryAxis {
    type Results = ();

    fn act(&self, control: &mut dyn Control) -> Done {
        let axis = numbered_axis(self.axis)?;
        let column = axis.letter().to_string();
        let machine = control.angle(axis);
        if self.transfer {
            control.write(TableKind::Preset, self.row, &column, &Cell::Number(machine))?;
            zero_display(axis, control);
            return Ok(());
        }
        let (zero, _) = control.zero_of(axis);
        let shift = machine - zero;
        control.write(TableKind::Datum, self.row, &column, &Cell::Number(shift))?;
        control.set_zero_of(axis, (zero, shift));
        Ok(())
    }
}

impl Action for AddAngleToDatumRow {
    type Results = ();

    fn act(&self, control: &mut dyn Control) -> Done {
        let column = numbered_axis(self.axis)?.letter().to_string();
        let mut old = 0.0;
        if control.has_row(TableKind::Datum, self.row)? {
            old = control.number(TableKind::Datum, self.row, &column)?.unwrap_or_default();
        }
        control.write(TableKind::Datum, self.row, &column, &Cell::Number(old + self.angle))
    }
}

/// The angle from -90 (excluded) to 90 that means the same line.
fn line(degrees: f64) -> f64 {
    let turned = degrees.rem_euclid(180.0);
    if turned > 90.0 { turned - 180.0 } else { turned }
}

fn unsuitable(axis: RotaryAxis) -> Fault {
    Fault::control("rotary-axis-unsuitable").arg("axis", axis.letter().to_string())
}

/// By how much a rotary axis must go so that the workpiece, turned by an angle about an axis of the program, is
/// straight relative to the tool.
fn straightening(axis: RotaryAxis, about: Axis, degrees: f64, control: &dyn Control) -> Result<f64, Fault> {
    let rotary = control.rotary(axis)?;
    let along = rotary.about.dot(control.frame().vector(about.unit()));
    if 1.0 - along.abs() > ALONG {
        return Err(unsuitable(axis));
    }
    // A table turns the workpiece back, a head turns the tool after it.
    let sense = if rotary.carries_workpiece { -along.signum() } else { along.signum() };
    Ok(sense * degrees)
}

fn turn_by(axis: RotaryAxis, way: f64, axes: &mut dyn RotaryAxes) -> Done {
    axes.turn_to(axis, axes.angle(axis) + way)
}

/// The display of a rotary axis shows 0 where it is.
fn zero_display(axis: RotaryAxis, control: &mut dyn Control) {
    let (_, shift) = control.zero_of(axis);
    control.set_zero_of(axis, (control.angle(axis) - shift, shift));
}
