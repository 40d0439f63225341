//! What strategies of action share: they change something at the control, through the narrow parts of it that are here.
//!
//! A strategy asks for no more than it needs: one that writes a table takes `&mut dyn Tables`. [`Control`] is all of
//! them; the engine is one, and a test can be another. Invariant: lengths are mm, angles degrees, coordinates by axis
//! unless they are said to be main, minor and tool coordinate.
use glam::DVec3;

use super::contour::Contours;
use super::signature::{Results, Signature};
use super::turned::Turned;
use crate::engine::geometry::{Axis, Frame, RotaryAxis, WorkingPlane};
use crate::engine::report::ending::Done;
use crate::engine::report::fault::Fault;
use crate::engine::table::{Cell, TableKind};

/// A strategy that changes something at the control.
pub trait Action: Signature {
    /// What it gives.
    type Results: Results;
    /// Whether it moves the probe towards the workpiece.
    const PROBES: bool = false;

    /// Does it.
    ///
    /// # Errors
    /// The control stops with an error, or the operator stops the program.
    fn act(&self, control: &mut dyn Control) -> Done<Self::Results>;
}

/// The coordinate system in effect.
pub trait System {
    /// The working plane.
    fn plane(&self) -> WorkingPlane;

    /// From program to machine coordinates.
    fn frame(&self) -> Frame;

    /// What lies outside the datum shift, and what lies inside it.
    fn around_datum(&self) -> (Frame, Frame);

    /// Whether the values of datum tables count from the machine datum and not from the preset.
    fn datums_are_of_machine(&self) -> bool;

    /// Moves the preset in effect by a way in the machine.
    fn move_preset(&mut self, way: DVec3);

    /// The basic rotation about the tool axis, degrees.
    fn basic_rotation(&self) -> f64;

    /// Sets it; a point, in program coordinates, keeps its coordinates, and without one the preset its place.
    fn set_basic_rotation(&mut self, degrees: f64, held: Option<DVec3>);

    /// Where a rotary axis has the coordinate 0 by the preset, and its datum shift, in machine coordinates.
    fn zero_of(&self, axis: RotaryAxis) -> (f64, f64);

    /// Sets both.
    fn set_zero_of(&mut self, axis: RotaryAxis, zero: (f64, f64));

    /// A point given by main, minor and tool coordinate, by axis.
    fn axes(&self, point: DVec3) -> DVec3 {
        self.plane().lift(point.truncate(), point.z)
    }

    /// A point given by axis, as main, minor and tool coordinate.
    fn in_plane(&self, point: DVec3) -> DVec3 {
        let plane = self.plane();
        plane.flat(point).extend(plane.tool.of(point))
    }
}

/// The tables of the control.
pub trait Tables {
    /// Whether a table has a row.
    ///
    /// # Errors
    /// There is no such table.
    fn has_row(&self, table: TableKind, row: f64) -> Result<bool, Fault>;

    /// A number of a row that is there; nothing if its cell is empty.
    ///
    /// # Errors
    /// There is no such table, row or column.
    fn number(&self, table: TableKind, row: f64, column: &str) -> Result<Option<f64>, Fault>;

    /// Where a row of the preset table puts its origin, and the frame from its coordinates to the machine; those of an
    /// empty row where there is none.
    ///
    /// # Errors
    /// There is no preset table.
    fn preset(&self, row: f64) -> Result<(DVec3, Frame), Fault>;

    /// Writes a cell.
    ///
    /// # Errors
    /// It cannot be written.
    fn write(&mut self, table: TableKind, row: f64, column: &str, cell: &Cell) -> Done;

    /// The number of the tool in the spindle, if there is one.
    fn tool(&self) -> Option<f64>;
}

/// A rotary axis of the machine.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rotary {
    /// The direction about which it turns what it carries, in the machine.
    pub about: DVec3,
    /// Whether that is the workpiece, and not the tool.
    pub carries_workpiece: bool,
}

/// The rotary axes of the machine.
pub trait RotaryAxes {
    /// An axis.
    ///
    /// # Errors
    /// The machine has none of that letter.
    fn rotary(&self, axis: RotaryAxis) -> Result<Rotary, Fault>;

    /// Where an axis is, in machine coordinates.
    fn angle(&self, axis: RotaryAxis) -> f64;

    /// Turns an axis to machine coordinates at rapid traverse.
    ///
    /// # Errors
    /// It cannot go there.
    fn turn_to(&mut self, axis: RotaryAxis, angle: f64) -> Done;

    /// Where A, B and C must be for the tool to be at right angles to the tilted working plane, in program coordinates.
    ///
    /// # Errors
    /// They cannot reach it.
    fn for_tilted_plane(&self) -> Result<DVec3, Fault>;

    /// Turns A, B and C to program coordinates at a feed in mm/min; the point that far before the tip keeps its place
    /// on the workpiece, and the tool returns to it.
    ///
    /// # Errors
    /// They cannot go there.
    fn turn_about_point(&mut self, angles: DVec3, distance: f64, feed: f64) -> Done;

    /// Whether the spindle is at right angles to the axis on which the workpiece is clamped.
    fn spindle_is_across(&self) -> bool;
}

/// A calibrated touch probe.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Calibrated {
    /// Its row in the probe table.
    pub row: f64,
    /// The offset of its ball from the spindle axis, main and minor axis, mm.
    pub offset: glam::DVec2,
    /// The number of its tool; 0 if there is none.
    pub tool: f64,
    /// The oversizes of the tool call: radius and length, mm.
    pub oversizes: (f64, f64),
}

/// Where a probe stopped.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stopped {
    /// The centre of its ball, program coordinates.
    pub centre: DVec3,
    /// Whether it touched something.
    pub touched: bool,
}

/// The touch probe.
pub trait Probe {
    /// The centre of its ball as the control knows it, program coordinates.
    ///
    /// # Errors
    /// There is no probe, or its axis is not the one that the cycle reckons with.
    fn ball(&self) -> Result<DVec3, Fault>;

    /// Probes on a way in program coordinates, at a feed in mm/min, and stays where it stops.
    ///
    /// # Errors
    /// The stylus is deflected at the start (`probe-deflected`), or something else is touched.
    fn approach(&mut self, way: DVec3, feed: f64) -> Done<Stopped>;

    /// Goes back against the direction in which it touched, at rapid traverse, not beyond where that movement began;
    /// nowhere if it does not touch anything.
    ///
    /// # Errors
    /// It cannot move.
    fn retract(&mut self, way: f64) -> Done;

    /// Its calibration.
    ///
    /// # Errors
    /// There is no probe.
    fn calibration(&self) -> Result<Calibrated, Fault>;

    /// The data of the tables take effect.
    ///
    /// # Errors
    /// The tables cannot be read.
    fn renew(&mut self) -> Result<(), Fault>;
}

/// How spindle and coolant are.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Running {
    /// 1 clockwise, -1 counter-clockwise, 0 not at all.
    pub direction: i8,
    /// Its speed, 1/min.
    pub speed: f64,
    /// Whether the coolant flows.
    pub coolant: bool,
}

/// What an M function does to spindle and coolant.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Function {
    /// How the spindle turns from then on, if that changes.
    pub spindle: Option<i8>,
    /// Whether the coolant flows from then on, if that changes.
    pub coolant: Option<bool>,
}

/// Spindle and coolant.
pub trait Spindle {
    /// How they are.
    fn running(&self) -> Running;

    /// How they were when the cycle began.
    fn at_begin(&self) -> Running;

    /// Turns the spindle in a direction, at a speed that stays in force; always reported.
    fn turn(&mut self, direction: i8, speed: f64);

    /// Switches the coolant.
    fn coolant(&mut self, on: bool);

    /// The angle to which M functions orient the spindle from now on.
    fn keep_orientation(&mut self, angle: f64);

    /// What an M function does; nothing if it does anything else, or is unknown.
    fn function(&self, number: f64) -> Option<Function>;
}

/// Programs, and what they are executed with.
pub trait Programs {
    /// Executes a program to its end.
    ///
    /// # Errors
    /// There is none of that name, or it does not come to its end.
    fn call(&mut self, name: &str) -> Done;

    /// How far the path may deviate: contour, filter mode, rotary axes; nothing for that of the machine.
    fn keep_tolerance(&mut self, tolerance: Option<[f64; 3]>);
}

/// What definitions keep for the cycles that follow: values, and the contours of subprograms.
pub trait Kept {
    /// A number that a definition has kept by name.
    fn kept(&self, name: &str) -> Option<f64>;

    /// Reads the closed contours that the definition in effect names, with the present parameters; strategies over
    /// contours see them from then on.
    ///
    /// # Errors
    /// No definition names contours, or one of them is none.
    fn read_contours(&mut self) -> Done;

    /// Reads the first of these contours, which may be open.
    ///
    /// # Errors
    /// No definition names a contour, or it is none.
    fn read_first_contour(&mut self) -> Done;

    /// The contours that were read last.
    fn contours(&self) -> &Contours;

    /// What is turned from now on; strategies over contours see it.
    fn keep_turned(&mut self, turned: Turned);

    /// The radius of the tool in the spindle in the coordinates of the program, mm.
    fn tool_radius(&self) -> f64;
}

/// What the control knows of the tool setter.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct KnownSetter {
    /// The centre of its upper face, machine coordinates.
    pub at: DVec3,
    /// The radius of that face, or half its width, mm.
    pub radius: f64,
    /// Whether it is a disc, and not a cube.
    pub is_round: bool,
}

/// The tool setter.
pub trait ToolSetter {
    /// What the control knows of it: from its calibration, else from machine parameters, else as it is.
    ///
    /// # Errors
    /// The scene has none.
    fn setter(&self) -> Result<KnownSetter, Fault>;

    /// Keeps what a calibration found.
    fn calibrate_setter(&mut self, known: KnownSetter);

    /// The number of a machine parameter by its neutral name, mm, mm/min or m/min.
    ///
    /// # Errors
    /// It is not set.
    fn setting(&self, name: &str) -> Result<f64, Fault>;

    /// The text of a machine parameter by its neutral name; that of a number is its digits.
    fn setting_word(&self, name: &str) -> Option<String>;

    /// The tip of the tool in machine coordinates, if the tool is as the tool table says.
    ///
    /// # Errors
    /// The tool is not along an axis of the machine.
    fn tip(&self) -> Result<DVec3, Fault>;

    /// Radius and length with which the control reckons, oversizes included, mm.
    fn reckoned(&self) -> (f64, f64);

    /// Moves the tip at rapid traverse, machine coordinates.
    ///
    /// # Errors
    /// It cannot go there.
    fn go(&mut self, to: DVec3) -> Done;

    /// Moves towards the setter until it triggers, with the spindle at an angle or turning, at a feed in mm/min, and stays
    /// there. The tip then; nothing at the end of the way.
    ///
    /// # Errors
    /// It triggers at the start already, or an axis cannot go there.
    fn touch_setter(&mut self, way: DVec3, feed: f64, at: Option<f64>) -> Done<Option<DVec3>>;

    /// Turns the spindle to an angle.
    fn orient(&mut self, angle: f64);

    /// Whether the tool table says that the tool cuts with the spindle turning counter-clockwise (`DIRECT.` +).
    ///
    /// # Errors
    /// The tool table cannot be read.
    fn cuts_counter_clockwise(&self) -> Result<bool, Fault>;

    /// Where the first edge is while the spindle is at 0, as found while the tool touched turning.
    fn first_edge(&self) -> f64;
}

/// Everything of a control that strategies act on.
pub trait Control: System + Tables + RotaryAxes + Probe + Spindle + Programs + Kept + ToolSetter {}

impl<C: System + Tables + RotaryAxes + Probe + Spindle + Programs + Kept + ToolSetter> Control for C {}

/// The axis of a number as cycles have it: 4, 5, 6 mean A, B, C.
pub(super) fn numbered_axis(number: f64) -> Result<RotaryAxis, Fault> {
    let found = RotaryAxis::ALL.into_iter().zip([4.0, 5.0, 6.0]).find(|(_, known)| *known == number);
    let unknown = || Fault::program("parameter-out-of-range").arg("q", "").arg("value", number);
    found.map(|(axis, _)| axis).ok_or_else(unknown)
}

/// The rotary axis that turns about a parallel of the tool axis.
pub(super) fn table_axis(system: &dyn System) -> RotaryAxis {
    RotaryAxis(system.plane().tool)
}

/// A linear axis as a column of a table.
pub(super) fn column(axis: Axis) -> String {
    axis.letter().to_string()
}
