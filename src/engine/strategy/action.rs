//! What strategies of action share: they change something at the control, through the narrow parts of it that are here.
//!
//! A strategy asks for no more than it needs: one that writes a table takes `&mut dyn Tables`. [`Control`] is all of
//! them; the engine is one, and a test can be another. Invariant: lengths are mm, angles degrees, coordinates by axis
//! unless they are said to be main, minor and tool coordinate.
use std::ops::RangeInclusive;

use glam::DVec3;

use super::contour::Contours;
use super::digitizing::range::Digitizing;
use super::signature::{Results, Signature};
use super::turning::area::Turned;
use super::turning::groove::Groove;
use super::turning::thread::TurnedThread;
use crate::engine::geometry::{Around, Axis, Frame, RotaryAxis, WorkingPlane};
use crate::engine::machine::{Arm, Insert, Machine, MemoryReport, SavedKinematics, Survey, TurningInsert};
use crate::engine::region::Way;
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

    /// Turns the system about the rotary axis of the workpiece by a precession angle, degrees, or turns the tool round,
    /// up to the next tool call; what is not given stays. The spindle turns the insert into its direction.
    ///
    /// # Errors
    /// The tables of tools cannot be read.
    fn align_turning(&mut self, precession: Option<f64>, reversed: Option<bool>) -> Done;

    /// Ends that; the spindle stays as it is.
    fn end_turning_alignment(&mut self);

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

    /// The insert of the tool in the spindle, with the corrections of the program.
    ///
    /// # Errors
    /// The tables of tools cannot be read.
    fn insert(&self) -> Result<TurningInsert, Fault>;
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
    fn stroke(&mut self, way: DVec3, feed: f64) -> Done<Stopped>;

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
    /// contours see them from then on, down to a depth below the surface in mm.
    ///
    /// # Errors
    /// No definition names contours, one of them is none, or deeper than that.
    fn read_contours(&mut self, depth: f64) -> Done;

    /// Reads the first of these contours, which may be open.
    ///
    /// # Errors
    /// No definition names a contour, or it is none.
    fn read_first_contour(&mut self) -> Done;

    /// Reads the first of these contours as one that is turned: `x` along the rotary axis, `y` a radius.
    ///
    /// # Errors
    /// No definition names a contour, or it is none.
    fn read_turned_contour(&mut self) -> Done<Way>;
    /// Reads the first of these contours as one in the development of a cylinder. Where `mm_in_degree` is there, its
    /// coordinates of X are degrees.
    ///
    /// # Errors
    /// No definition names a contour, it is none, or its first block does not say where it begins.
    fn read_developed_contour(&mut self, mm_in_degree: Option<f64>) -> Done;

    /// The contours that were read last.
    fn contours(&self) -> &Contours;

    /// Reports an area (mm²) about a point, main, minor and tool coordinate, in which a tool leaves material.
    fn note_left(&mut self, area: f64, at: DVec3);

    /// The blank that turning updates, along what is left of it furthest out, as `seen` sees a way with `x` along the rotary
    /// axis and radii as `y`; nothing if none is updated, or nothing is left.
    fn outline_of_blank(&self, seen: &dyn Fn(&Way) -> Way) -> Option<Way>;

    /// Whether turning updates a blank.
    fn updates_blank(&self) -> bool;

    /// What is recessed from now on; strategies over contours see it.
    fn keep_groove(&mut self, groove: Groove);

    /// What is turned from now on; strategies over contours see it.
    fn keep_turned(&mut self, turned: Turned);

    /// The thread that is turned from now on; strategies over contours see it.
    fn keep_thread(&mut self, thread: TurnedThread);

    /// The insert meets the workpiece like this from now on.
    fn hold_insert(&mut self, insert: Insert);

    /// The radius of the tool in the spindle in the coordinates of the program, mm.
    fn tool_radius(&self) -> f64;
}

/// What the control knows of the tool setter.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct KnownSetter {
    /// The centre of its upper face, in its own directions ([`ToolSetter::setter_frame`]).
    pub at: DVec3,
    /// The radius of that face, or half its width, mm.
    pub radius: f64,
    /// Whether it is a disc, and not a cube.
    pub is_round: bool,
}

/// The tool setter. Points and ways are in the directions in which it is mounted, those of the machine where nothing
/// else is said, and the tool is along the tool axis of these.
pub trait ToolSetter {
    /// The frame from these directions to machine coordinates.
    ///
    /// # Errors
    /// The scene has no tool setter.
    fn setter_frame(&self) -> Result<Frame, Fault>;

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

    /// The tip of the tool, if the tool is as the tool table says.
    ///
    /// # Errors
    /// The tool is not at right angles to the face, or the control does not know where it is.
    fn tip(&self) -> Result<DVec3, Fault>;

    /// Radius and length with which the control reckons, oversizes included, mm.
    fn reckoned(&self) -> (f64, f64);

    /// Moves the tip at rapid traverse.
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

    /// Where the first edge is from the main direction while the spindle is at 0, degrees, as found while the tool touched
    /// turning.
    ///
    /// # Errors
    /// The tool is not at right angles to the face.
    fn first_edge(&self) -> Result<f64, Fault>;
}

/// A way of the stylus on which it is felt for the part, program coordinates.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Course {
    /// Straight.
    Line {
        /// Its start.
        from: DVec3,
        /// Its end.
        to: DVec3,
    },
    /// On an arc about the tool axis.
    Arc {
        /// Its centre.
        centre: DVec3,
        /// Its start.
        from: DVec3,
        /// Its angle in degrees, counter-clockwise.
        sweep: f64,
    },
}

/// A coordinate of a definition.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Coordinate {
    /// The axis; of a rotary one, the linear axis that it turns about.
    pub axis: Axis,
    /// Whether it is the rotary axis.
    pub rotary: bool,
    /// mm, or degrees; of the direction of a rotary axis its sign.
    pub value: f64,
}

/// Where the stylus touches the part.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Felt {
    /// The south pole of its ball, program coordinates.
    pub at: DVec3,
    /// The direction out of the material, of length 1.
    pub out: DVec3,
}

/// A stylus that follows a part. Its position is that of the south pole of its ball as the control knows it, in program
/// coordinates.
pub trait Stylus {
    /// Where it is, and the probing feed, mm/min.
    ///
    /// # Errors
    /// There is no probe.
    fn stylus(&self) -> Result<(DVec3, f64), Fault>;

    /// Where it would touch the part first.
    ///
    /// # Errors
    /// There is no probe, or the contact cannot be calculated.
    fn feel(&self, course: Course) -> Result<Option<Felt>, Fault>;

    /// Whether it touches the part at a position, or is nearer to it than that, mm.
    ///
    /// # Errors
    /// There is no probe, or the contact cannot be calculated.
    fn touches(&self, at: DVec3, nearer: f64) -> Result<bool, Fault>;

    /// Moves it through the air, at a feed in mm/min or at rapid traverse.
    ///
    /// # Errors
    /// It cannot go there, or touches something.
    fn fly(&mut self, to: DVec3, feed: Option<f64>) -> Done;

    /// Moves it along the surface to a position at which the material is on the other side of that direction.
    ///
    /// # Errors
    /// It cannot go there.
    fn slide(&mut self, to: DVec3, out: DVec3, feed: f64) -> Done;

    /// What digitizing keeps.
    fn digitizing(&mut self) -> &mut Digitizing;

    /// The axes and coordinates that the parameter of that meaning has in the definition in effect; none of a direction
    /// along a linear axis.
    fn coordinates(&self, meaning: &str) -> Vec<Coordinate>;

    /// Where it would touch the part first on a straight way, once a rotary axis of the table has turned to an angle in
    /// program coordinates.
    ///
    /// # Errors
    /// There is no probe, or the contact cannot be calculated.
    fn feel_turned(&self, turned: (RotaryAxis, f64), from: DVec3, to: DVec3) -> Result<Option<Felt>, Fault>;

    /// Whether it would touch the part at a position while a rotary axis of the table turns to an angle from where it is.
    ///
    /// # Errors
    /// There is no probe, or the contact cannot be calculated.
    fn touches_while_turning(&self, turned: (RotaryAxis, f64), at: DVec3) -> Result<bool, Fault>;

    /// By how much its ball moves over the part at a position for each degree of a rotary axis of the table.
    ///
    /// # Errors
    /// There is no probe.
    fn way_in_degree(&self, axis: RotaryAxis, at: DVec3) -> Result<DVec3, Fault>;

    /// Moves it through the air while a rotary axis turns to an angle; at a feed, mm/min or degrees/min, or at rapid
    /// traverse.
    ///
    /// # Errors
    /// It cannot go there, or touches something.
    fn fly_turning(&mut self, turned: (RotaryAxis, f64), to: DVec3, feed: Option<f64>) -> Done;

    /// The points of a point table.
    ///
    /// # Errors
    /// There is no such table.
    fn points_of_table(&self, name: &str) -> Result<Vec<DVec3>, Fault>;

    /// Writes the file of digitized data.
    fn write_data(&mut self) -> Done;
}

/// The rotary axis on which the workpiece is clamped, and the tool across it.
pub trait Turntable {
    /// Where the tool is about it.
    ///
    /// # Errors
    /// There is none, or the control cannot reckon with it.
    fn around(&self) -> Result<Around, Fault>;

    /// How far the datum lies beside it, mm.
    ///
    /// # Errors
    /// There is none, or the control cannot reckon with it.
    fn datum_off_table(&self) -> Result<f64, Fault>;

    /// Moves all axes there together, at a feed along the development of a cylinder of a radius, mm/min.
    ///
    /// # Errors
    /// An axis cannot go there.
    fn go_around(&mut self, to: Around, radius: f64, feed: f64) -> Done;
}

/// How a probe is used.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Probing {
    /// The distance kept from the touch point, mm.
    pub set_up: f64,
    /// The feed between touch points, mm/min; endless for rapid traverse.
    pub feed: f64,
    /// The radius of the ball that the control reckons with, mm.
    pub radius: f64,
}

/// The kinematics of the machine as the control believes them to be, and measuring them.
pub trait Kinematics {
    /// The kinematics.
    fn kinematics(&self) -> Machine;

    /// The control has other kinematics from now on; the machine stays where it is.
    fn set_kinematics(&mut self, machine: Machine);

    /// The kinematics that are saved.
    fn memories(&self) -> Vec<SavedKinematics>;

    /// Other kinematics are saved from now on.
    fn set_memories(&mut self, memories: Vec<SavedKinematics>);

    /// The value of the parameter of that meaning, which takes a number or a name, as a name.
    ///
    /// # Errors
    /// It has no value.
    fn name_given(&self, meaning: &str) -> Result<String, Fault>;

    /// Text parameters have no values from now on.
    fn forget_texts(&mut self, numbers: RangeInclusive<u16>);

    /// Date and time as logs write them.
    fn moment(&self) -> String;

    /// What the log says of memories.
    fn keep_memory_report(&mut self, report: MemoryReport);

    /// What was measured last.
    ///
    /// # Errors
    /// Nothing was.
    fn survey(&self) -> Result<Survey, Fault>;

    /// Keeps what was measured.
    fn keep_survey(&mut self, survey: Survey);

    /// The value of a machine parameter by its neutral name; nothing where the scene has none.
    fn limit(&self, name: &str) -> Option<f64>;

    /// The rotary axes in machine coordinates.
    fn angles(&self) -> DVec3;

    /// Where the rotary axes have the coordinate 0, in machine coordinates.
    fn angle_datum(&self) -> DVec3;

    /// The row of the preset in effect, and its origin in machine coordinates.
    fn preset_in_effect(&self) -> (f64, DVec3);

    /// The linear axes: where the tool tip would be with the head at 0, machine coordinates.
    fn linear(&self) -> DVec3;

    /// How the probe is in the spindle as the control knows it.
    ///
    /// # Errors
    /// There is no probe.
    fn arm(&self) -> Result<Arm, Fault>;

    /// How the probe is used.
    ///
    /// # Errors
    /// There is no probe.
    fn probing(&self) -> Result<Probing, Fault>;

    /// The tool tip is no longer held on the workpiece while rotary axes turn.
    ///
    /// # Errors
    /// That cannot end here.
    fn release_tip(&mut self) -> Done;

    /// Turns rotary axes to machine coordinates while the linear axes go to a position; at a feed, mm/min or
    /// degrees/min.
    ///
    /// # Errors
    /// They cannot go there.
    fn go_turning(&mut self, turns: &[(RotaryAxis, f64)], to: DVec3, feed: f64) -> Done;

    /// Probes along a way of the machine and goes back. The linear axes where it touched.
    ///
    /// # Errors
    /// It touches nothing, or the stylus is deflected at the start.
    fn touch(&mut self, way: DVec3) -> Done<DVec3>;
}

/// Everything of a control that strategies act on.
pub trait Control:
    System + Tables + RotaryAxes + Probe + Spindle + Programs + Kept + ToolSetter + Stylus + Turntable + Kinematics
{
}

impl<C: System + Tables + RotaryAxes + Probe + Spindle + Programs + Kept + ToolSetter + Stylus + Turntable + Kinematics>
    Control for C
{
}

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
