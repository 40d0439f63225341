//! Strategies that set the datum: the preset in effect, a row of the preset table, a row of the datum table.
//!
//! Invariant: the point that is named gets the coordinates that are named; axes that are not named keep theirs.
use glam::DVec3;

use crate::engine::geometry::{Axis, Frame};
use crate::engine::report::ending::Done;
use crate::engine::strategy::action::{Action, Control, System, Tables, column};
use crate::engine::strategy::signature::{Mm, strategy};
use crate::engine::table::{Cell, TableKind};

/// Coordinates that differ by less, in mm, are the same: cells keep no more.
const UNCHANGED: f64 = 1e-9;

/// Declares a strategy that gives a point coordinates, and what it is given besides.
macro_rules! of_point {
    ($(#[$doc:meta])* $name:ident = $text:literal { $($more:tt)* }) => {
        strategy! {
            $(#[$doc])*
            $name = $text {
                /// The point, in coordinates that are in effect.
                point: Mm<DVec3> = Length,
                /// The main coordinate that it shall have, mm.
                main: Option<Mm<f64>> = Length,
                /// The minor coordinate, mm.
                minor: Option<Mm<f64>> = Length,
                /// The tool coordinate, mm.
                tool: Option<Mm<f64>> = Length,
                $($more)*
            }
        }

        impl $name {
            fn wanted(&self, system: &dyn System) -> Wanted {
                let plane = system.plane();
                let axes = [(plane.main, self.main), (plane.secondary, self.minor), (plane.tool, self.tool)];
                let values = axes.into_iter().filter_map(|(axis, value)| Some((axis, value?.0))).collect();
                Wanted { point: system.axes(self.point.0), values }
            }
        }
    };
}

of_point! {
    /// The active preset is moved so that a point has given coordinates.
    SetDatum = "set-datum" {}
}

of_point! {
    /// A row of the preset table is written so that a point will have given coordinates once it is the preset. The row
    /// keeps its spatial angles; a new row has none.
    WritePreset = "write-preset" {
        /// The row.
        row: f64 = Number,
    }
}

of_point! {
    /// A row of the active datum table is written so that a point will have given coordinates once it is the datum
    /// shift, with all else as it is.
    WriteDatumRow = "write-datum-row" {
        /// The row.
        row: f64 = Number,
    }
}

impl Action for SetDatum {
    type Results = ();

    fn act(&self, control: &mut dyn Control) -> Done {
        let wanted = self.wanted(control);
        let change = wanted.change(wanted.point);
        control.move_preset(-control.frame().vector(change));
        Ok(())
    }
}

impl Action for WritePreset {
    type Results = ();

    fn act(&self, control: &mut dyn Control) -> Done {
        let wanted = self.wanted(control);
        let machine = control.frame().point(wanted.point);
        let (origin, frame) = control.preset(self.row)?;
        let change = wanted.change(frame.inverse().point(machine));
        wanted.write(TableKind::Preset, self.row, (origin, origin - frame.vector(change)), control)
    }
}

impl Action for WriteDatumRow {
    type Results = ();

    fn act(&self, control: &mut dyn Control) -> Done {
        let wanted = self.wanted(control);
        let machine = control.frame().point(wanted.point);
        let (outside, inside) = control.around_datum();
        let to_machine = if control.datums_are_of_machine() { outside } else { Frame::IDENTITY };
        let mut old = DVec3::ZERO;
        if control.has_row(TableKind::Datum, self.row)? {
            let number = |column| control.number(TableKind::Datum, self.row, column).map(Option::unwrap_or_default);
            old = DVec3::new(number("X")?, number("Y")?, number("Z")?);
        }
        let shift = to_machine.inverse().point(old);
        let change = wanted.change(inside.inverse().vector(outside.inverse().point(machine) - shift));
        let new = to_machine.point(shift - inside.vector(change));
        wanted.write(TableKind::Datum, self.row, (old, new), control)
    }
}

/// A point of the program and the coordinates that it shall have on some axes.
struct Wanted {
    /// The point in program coordinates, by axis.
    point: DVec3,
    /// Axis and coordinate.
    values: Vec<(Axis, f64)>,
}

impl Wanted {
    /// By how much coordinates must change to become those that are wanted; axes not named stay.
    fn change(&self, from: DVec3) -> DVec3 {
        self.values.iter().fold(DVec3::ZERO, |change, (axis, value)| axis.with(change, value - axis.of(from)))
    }

    /// Writes the coordinates of the axes that are wanted. Where the system of the row is turned, what moves its datum
    /// along one of its axes changes other coordinates, too.
    fn write(&self, table: TableKind, row: f64, (old, new): (DVec3, DVec3), tables: &mut dyn Tables) -> Done {
        for axis in Axis::ALL {
            let asked = self.values.iter().any(|(known, _)| *known == axis);
            if asked || (axis.of(old) - axis.of(new)).abs() > UNCHANGED {
                tables.write(table, row, &column(axis), &Cell::Number(axis.of(new)))?;
            }
        }
        Ok(())
    }
}
