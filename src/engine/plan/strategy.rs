//! The named strategies that the engine has, with their arguments.
//!
//! A strategy is written once for all cycles and does one thing with values that are given to it; one that
//! is not listed here is pending. Invariant: signatures only, no execution.
use crate::base::expr::Type;
use crate::spec::Quantity;

/// A strategy.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Strategy {
    /// The active preset is moved so that a point has given coordinates.
    SetDatum,
    /// A row of the preset table is written so that a point will have given coordinates.
    WritePreset,
    /// A row of the active datum table is written so that a point will have given coordinates.
    WriteDatumRow,
    /// Ends the basic rotation about the tool axis.
    ResetBasicRotation,
    /// Sets the basic rotation about the tool axis, in effect or in a row of the preset table.
    WriteBasicRotation,
    /// Turns the basic rotation in effect by an angle, about a point that keeps its coordinates.
    TurnBasicRotation,
    /// The direction from one point to another in the working plane.
    Direction,
    /// The point where two lines of the working plane meet.
    IntersectLines,
    /// Turns the rotary axis about the tool axis so that a workpiece turned by an angle is straight.
    AlignRotaryTable,
    /// Turns a rotary axis so that a line of the workpiece lies along an axis or at an angle to one.
    AlignRotaryAxis,
    /// Turns a rotary axis so that the direction from the datum to a point becomes the one to its nominal position.
    AlignDirection,
    /// The coordinate of a rotary axis, or of the one about the tool axis, becomes 0.
    ZeroRotaryTable,
    /// The coordinate of a rotary axis becomes 0, and a row of a table gets what makes it so.
    ZeroRotaryAxis,
    /// Adds an angle to what a row of the active datum table has for the rotary axis about the tool axis.
    AddAngleToDatumRow,
    /// Brings the tool to a level on a helix.
    PlungeOnHelix,
    /// Brings the tool to a level in strokes to and fro.
    PlungeInStrokes,
    /// Probes on a path and at a feed of its own, and stays where it stops.
    ProbeWithOwnPath,
    /// Goes back from where the probe stopped.
    RetractFromTouchPoint,
    /// The angles of the plane through three points.
    PlaneAngles,
    /// Writes what a calibration found.
    StoreProbeCalibration,
    /// Brings the tool to a level in strokes along a slot, from its left end.
    PlungeAlongSlot,
    /// Brings the tool to a level in strokes along a circular slot, from its beginning.
    PlungeAlongCircularSlot,
    /// Clears a level of a rectangle with round corners, from the inside to the wall.
    ClearRectangleLevel,
    /// Clears a level of a circle on a spiral, from the centre to the wall.
    ClearCircleLevel,
    /// Clears a level of a slot.
    ClearSlotLevel,
    /// Clears a level of a circular slot.
    ClearCircularSlotLevel,
    /// Cuts the wall of a rectangular pocket at one level.
    FinishRectangleSide,
    /// Cuts the wall of a circular pocket at one level.
    FinishCircleSide,
    /// Cuts the wall of a slot at one level.
    FinishSlotSide,
    /// Cuts the wall of a circular slot at one level.
    FinishCircularSlotSide,
    /// Cuts the floor of a rectangular pocket.
    FinishRectangleFloor,
    /// Cuts the floor of a circular pocket.
    FinishCircleFloor,
    /// Cuts the floor of a slot.
    FinishSlotFloor,
    /// Cuts the floor of a circular slot.
    FinishCircularSlotFloor,
    /// Mills around a rectangular stud at one level, from the blank to the stud.
    MillRectangularStudLevel,
    /// Mills around a circular stud at one level on a spiral, from the blank to the stud.
    MillCircularStudLevel,
    /// Half a turn about a centre to a point at another distance from it.
    HalfTurn,
    /// Mills a flat surface at one level in lines.
    MillFaceLevel,
    /// Moves to the height at which the helix of a thread begins.
    MoveToThreadStartPlane,
    /// Onto the diameter of a thread on a half turn that rises with it.
    ApproachThreadOnHelix,
    /// Mills a thread: one turn, a continuous helix or several helices.
    MillThreadHelix,
    /// Away from a thread on a half turn that rises with it.
    DepartThreadTangentially,
    /// Countersinks a hole on a circle, joined and left on half circles.
    CountersinkOnCircle,
    /// The spindle turns the other way round.
    ReverseSpindle,
    /// Spindle and coolant become what they were when the cycle began.
    RestoreSpindleAndCoolant,
    /// The spindle turns as an M function says, at a speed.
    TurnSpindle,
    /// An M function whose number is a value.
    ExecuteMFunction,
    /// Where the rotary axes must stand for the tool to be at right angles to the tilted working plane.
    ComputeRotaryPositions,
    /// Turns the rotary axes and brings the tool back to where it was over the workpiece.
    PositionRotaryAxes,
    /// Whether the spindle is at right angles to the rotary axis that turns the workpiece.
    CheckSpindleAcrossRotaryAxis,
    /// The size of the insert of a turning tool.
    TurningInsert,
    /// Executes a whole program.
    CallProgram,
    /// The angle to which an M function orients the spindle.
    KeepOrientationAngle,
    /// How far the path may deviate.
    KeepTolerance,
    /// Reads a tolerance band that is written as a text (TNC 640 manual 004, lines 151-162).
    ToleranceBand,
}

/// An argument of a strategy.
#[derive(Clone, Copy, Debug)]
pub struct Parameter {
    /// Its name.
    pub name: &'static str,
    /// Its type.
    pub ty: Type,
    /// What it measures; `Number` for what has no unit.
    pub quantity: Quantity,
    /// Whether it must be there.
    pub required: bool,
}

impl Parameter {
    const fn optional(self) -> Self {
        Self { required: false, ..self }
    }
}

const POINT: Parameter = point("point");
const MAIN: Parameter = length("main").optional();
const MINOR: Parameter = length("minor").optional();
const TOOL: Parameter = length("tool").optional();
const TEXT: Parameter = text("text");
const ROW: Parameter = number("row");
const CENTRE: Parameter = point("centre");

const fn of(name: &'static str, quantity: Quantity) -> Parameter {
    Parameter { name, ty: Type::Number, quantity, required: true }
}

const fn number(name: &'static str) -> Parameter {
    of(name, Quantity::Number)
}

const fn length(name: &'static str) -> Parameter {
    of(name, Quantity::Length)
}

const fn angle(name: &'static str) -> Parameter {
    of(name, Quantity::Angle)
}

const fn feed(name: &'static str) -> Parameter {
    of(name, Quantity::Feed)
}

const fn point(name: &'static str) -> Parameter {
    Parameter { ty: Type::Point, ..length(name) }
}

const fn text(name: &'static str) -> Parameter {
    Parameter { name, ty: Type::Text, quantity: Quantity::Text, required: true }
}

const ANY_AXIS: Parameter = number("axis").optional();
const ACTUAL: Parameter = point("actual");
const NOMINAL: Parameter = point("nominal");
const ALONG_SECOND: Parameter = number("along_second_axis");
const MEASURING_AXIS: Parameter = number("measuring_axis");
const TRANSFER: Parameter = number("transfer");
const TARGET_ANGLE: Parameter = angle("angle").optional();
const TABLE_ROW: Parameter = number("row").optional();
const LINE: (Parameter, Parameter) = (point("from"), point("to"));
const LINES: [Parameter; 4] = [point("first"), point("second"), point("third"), point("fourth")];
const OWN_PATH: [Parameter; 6] = [
    Parameter { quantity: Quantity::Number, ..point("direction") },
    length("path"),
    feed("feed"),
    number("in_machine").optional(),
    number("tolerant").optional(),
    number("silent").optional(),
];
const PATH: Parameter = length("path");
const THREE: [Parameter; 3] = [point("first"), point("second"), point("third")];
const CALIBRATED: [Parameter; 3] =
    [length("radius").optional(), length("length").optional(), point("offset").optional()];
const ABOUT: Parameter = point("about").optional();
const AXIS: Parameter = number("axis");
const FROM: Parameter = length("from");
const TO: Parameter = length("to");
const ANGLE: Parameter = angle("angle");
const FEED: Parameter = feed("feed");
const RADIUS: Parameter = length("radius");
const DIRECTION: Parameter = number("direction");
const ROTATION: Parameter = angle("rotation");
const LEAST: Parameter = length("least");
const ROOM: Parameter = length("room");
/// Of every strategy of thread milling.
const THREAD: [Parameter; 8] = [
    CENTRE,
    length("surface"),
    length("depth"),
    DIAMETER,
    length("pitch"),
    number("outside"),
    CLIMB,
    number("threads"),
];
/// Of the one that may go from helix to helix.
const THREAD_WITH_STEPS: [Parameter; 9] = {
    let [a, b, c, d, e, f, g, h] = THREAD;
    [a, b, c, d, e, f, g, h, feed("between")]
};
const FUNCTION: Parameter = number("function");
const SPEED: Parameter = of("speed", Quantity::Speed);
const POSITIONS: [Parameter; 5] = [angle("a"), angle("b"), angle("c"), FEED, length("clearance")];
const PROGRAM: Parameter = text("program");
const TOLERANCE: [Parameter; 3] =
    [length("contour").optional(), number("hsc_mode").optional(), angle("rotary").optional()];
const LENGTH: Parameter = length("length");
const WIDTH: Parameter = length("width");
const CORNER: Parameter = length("corner");
const DIAMETER: Parameter = length("diameter");
const BEGIN: Parameter = angle("begin");
const OPENING: Parameter = angle("opening");
const CLIMB: Parameter = number("climb");
const STEPOVER: Parameter = length("stepover");
const ALLOWANCE: Parameter = length("allowance");
const LEVEL: Parameter = length("level");
const BLANK: (Parameter, Parameter) = (length("blank_length"), length("blank_width"));
const APPROACH: Parameter = number("approach");
const MODE: Parameter = number("mode");
const OUTSIDE: (Parameter, Parameter) = (length("begin"), length("end"));
const INSIDE: (Parameter, Parameter) = (length("inner_begin"), length("inner_end"));
const FIRST: Parameter = length("first");
const STEP: Parameter = length("step");
const LINES_OF_LEVEL: Parameter = number("lines");
const ACROSS: Parameter = feed("across");
const LIFT: Parameter = length("lift");

impl Strategy {
    /// The strategy of that name.
    pub fn by_name(name: &str) -> Option<Self> {
        Some(match name {
            "set-datum" => Self::SetDatum,
            "write-preset" => Self::WritePreset,
            "write-datum-row" => Self::WriteDatumRow,
            "reset-basic-rotation" => Self::ResetBasicRotation,
            "write-basic-rotation" => Self::WriteBasicRotation,
            "turn-basic-rotation" => Self::TurnBasicRotation,
            "direction" => Self::Direction,
            "intersect-lines" => Self::IntersectLines,
            "align-rotary-table" => Self::AlignRotaryTable,
            "align-rotary-axis" => Self::AlignRotaryAxis,
            "align-direction" => Self::AlignDirection,
            "zero-rotary-table" => Self::ZeroRotaryTable,
            "zero-rotary-axis" => Self::ZeroRotaryAxis,
            "add-angle-to-datum-row" => Self::AddAngleToDatumRow,
            "plunge-on-helix" => Self::PlungeOnHelix,
            "plunge-in-strokes" => Self::PlungeInStrokes,
            "probe-with-own-path" => Self::ProbeWithOwnPath,
            "retract-from-touch-point" => Self::RetractFromTouchPoint,
            "plane-angles" => Self::PlaneAngles,
            "store-probe-calibration" => Self::StoreProbeCalibration,
            "plunge-along-slot" => Self::PlungeAlongSlot,
            "plunge-along-circular-slot" => Self::PlungeAlongCircularSlot,
            "clear-rectangle-level" => Self::ClearRectangleLevel,
            "clear-circle-level" => Self::ClearCircleLevel,
            "clear-slot-level" => Self::ClearSlotLevel,
            "clear-circular-slot-level" => Self::ClearCircularSlotLevel,
            "finish-rectangle-side" => Self::FinishRectangleSide,
            "finish-circle-side" => Self::FinishCircleSide,
            "finish-slot-side" => Self::FinishSlotSide,
            "finish-circular-slot-side" => Self::FinishCircularSlotSide,
            "finish-rectangle-floor" => Self::FinishRectangleFloor,
            "finish-circle-floor" => Self::FinishCircleFloor,
            "finish-slot-floor" => Self::FinishSlotFloor,
            "finish-circular-slot-floor" => Self::FinishCircularSlotFloor,
            "mill-rectangular-stud-level" => Self::MillRectangularStudLevel,
            "mill-circular-stud-level" => Self::MillCircularStudLevel,
            "half-turn" => Self::HalfTurn,
            "mill-face-level" => Self::MillFaceLevel,
            "move-to-thread-start-plane" => Self::MoveToThreadStartPlane,
            "approach-thread-on-helix" => Self::ApproachThreadOnHelix,
            "mill-thread-helix" => Self::MillThreadHelix,
            "depart-thread-tangentially" => Self::DepartThreadTangentially,
            "countersink-on-circle" => Self::CountersinkOnCircle,
            "reverse-spindle" => Self::ReverseSpindle,
            "restore-spindle-and-coolant" => Self::RestoreSpindleAndCoolant,
            "turn-spindle" => Self::TurnSpindle,
            "execute-m-function" => Self::ExecuteMFunction,
            "compute-rotary-positions" => Self::ComputeRotaryPositions,
            "position-rotary-axes" => Self::PositionRotaryAxes,
            "check-spindle-across-rotary-axis" => Self::CheckSpindleAcrossRotaryAxis,
            "turning-insert" => Self::TurningInsert,
            "call-program" => Self::CallProgram,
            "keep-orientation-angle" => Self::KeepOrientationAngle,
            "keep-tolerance" => Self::KeepTolerance,
            "tolerance-band" => Self::ToleranceBand,
            _ => return None,
        })
    }

    /// Its arguments: the point, the coordinates that it shall have (axes not named stay as they are), the row.
    pub const fn parameters(self) -> &'static [Parameter] {
        match self {
            Self::SetDatum => &[POINT, MAIN, MINOR, TOOL],
            Self::WritePreset | Self::WriteDatumRow => &[POINT, MAIN, MINOR, TOOL, ROW],
            Self::ResetBasicRotation => &[],
            Self::ZeroRotaryTable => &[ANY_AXIS],
            Self::AlignDirection => &[AXIS, ACTUAL, NOMINAL, ALONG_SECOND],
            Self::WriteBasicRotation => &[ANGLE, TABLE_ROW],
            Self::TurnBasicRotation => &[ANGLE, ABOUT],
            Self::Direction => &[LINE.0, LINE.1],
            Self::IntersectLines => &LINES,
            Self::AlignRotaryTable => &[ANGLE],
            Self::AlignRotaryAxis => &[LINE.0, LINE.1, MEASURING_AXIS, AXIS, TARGET_ANGLE],
            Self::ZeroRotaryAxis => &[AXIS, ROW, TRANSFER],
            Self::AddAngleToDatumRow => &[ANGLE, ROW, AXIS],
            Self::PlungeOnHelix => &[CENTRE, FROM, TO, ANGLE, FEED, RADIUS, DIRECTION],
            Self::PlungeInStrokes => &[CENTRE, FROM, TO, ANGLE, FEED, ROTATION, LEAST, ROOM],
            Self::ProbeWithOwnPath => &OWN_PATH,
            Self::RetractFromTouchPoint => &[PATH],
            Self::PlaneAngles => &THREE,
            Self::StoreProbeCalibration => &CALIBRATED,
            Self::PlungeAlongSlot => &[CENTRE, FROM, TO, ANGLE, FEED, ROTATION, LENGTH],
            Self::PlungeAlongCircularSlot => &[CENTRE, FROM, TO, ANGLE, FEED, DIAMETER, BEGIN, OPENING],
            Self::ClearRectangleLevel => &[CENTRE, CLIMB, LENGTH, WIDTH, CORNER, ROTATION, STEPOVER],
            Self::ClearCircleLevel => &[CENTRE, CLIMB, DIAMETER, STEPOVER],
            Self::ClearSlotLevel => &[CENTRE, CLIMB, LENGTH, WIDTH, ROTATION, ALLOWANCE],
            Self::ClearCircularSlotLevel => &[CENTRE, CLIMB, DIAMETER, BEGIN, OPENING, WIDTH, ALLOWANCE],
            Self::FinishRectangleSide => &[CENTRE, CLIMB, LENGTH, WIDTH, CORNER, ROTATION, LEVEL],
            Self::FinishCircleSide => &[CENTRE, CLIMB, DIAMETER, LEVEL],
            Self::FinishSlotSide => &[CENTRE, CLIMB, LENGTH, WIDTH, ROTATION, LEVEL],
            Self::FinishCircularSlotSide => &[CENTRE, CLIMB, DIAMETER, BEGIN, OPENING, WIDTH, LEVEL],
            Self::FinishRectangleFloor => &[CENTRE, CLIMB, LENGTH, WIDTH, CORNER, ROTATION, STEPOVER, FROM, LEVEL],
            Self::FinishCircleFloor => &[CENTRE, CLIMB, DIAMETER, STEPOVER, FROM, LEVEL],
            Self::FinishSlotFloor => &[CENTRE, CLIMB, LENGTH, WIDTH, ROTATION, FROM, LEVEL],
            Self::FinishCircularSlotFloor => &[CENTRE, CLIMB, DIAMETER, BEGIN, OPENING, WIDTH, FROM, LEVEL],
            Self::MillRectangularStudLevel => {
                &[CENTRE, CLIMB, LENGTH, WIDTH, CORNER, ROTATION, STEPOVER, ALLOWANCE, BLANK.0, BLANK.1, APPROACH]
            }
            Self::MillCircularStudLevel => &[CENTRE, CLIMB, DIAMETER, STEPOVER],
            Self::HalfTurn => &[CENTRE, DIRECTION, RADIUS],
            Self::MillFaceLevel => {
                &[MODE, OUTSIDE.0, OUTSIDE.1, INSIDE.0, INSIDE.1, FIRST, STEP, LINES_OF_LEVEL, ACROSS, LIFT]
            }
            Self::MoveToThreadStartPlane | Self::ApproachThreadOnHelix | Self::DepartThreadTangentially => &THREAD,
            Self::MillThreadHelix => &THREAD_WITH_STEPS,
            Self::CountersinkOnCircle => &[CENTRE, RADIUS],
            Self::ReverseSpindle | Self::RestoreSpindleAndCoolant => &[],
            Self::TurnSpindle => &[FUNCTION, SPEED],
            Self::ExecuteMFunction => &[FUNCTION],
            Self::ComputeRotaryPositions | Self::CheckSpindleAcrossRotaryAxis | Self::TurningInsert => &[],
            Self::PositionRotaryAxes => &POSITIONS,
            Self::CallProgram => &[PROGRAM],
            Self::KeepOrientationAngle => &[ANGLE],
            Self::KeepTolerance => &TOLERANCE,
            Self::ToleranceBand => &[TEXT],
        }
    }

    /// Whether it moves the probe towards the workpiece.
    pub const fn probes(self) -> bool {
        matches!(self, Self::ProbeWithOwnPath)
    }

    /// Its results, all of them numbers.
    pub const fn results(self) -> &'static [&'static str] {
        match self {
            Self::Direction => &["angle"],
            Self::IntersectLines => &["main", "minor"],
            Self::AlignRotaryTable => &["way"],
            Self::AlignRotaryAxis | Self::AlignDirection => &["angle", "way"],
            Self::ProbeWithOwnPath => &["main", "minor", "tool", "status"],
            Self::PlaneAngles => &["section_a", "section_b", "rotary_a", "rotary_b", "a", "b", "c"],
            Self::ComputeRotaryPositions => &["a", "b", "c"],
            Self::CheckSpindleAcrossRotaryAxis => &["across"],
            Self::TurningInsert => &["width", "radius"],
            Self::ToleranceBand => &["upper", "lower", "monitored"],
            _ => &[],
        }
    }

    /// What the result of that name measures; `Number` for what has no unit.
    pub fn quantity_of_result(name: &str) -> Quantity {
        match name {
            "main" | "minor" | "tool" | "width" | "radius" | "upper" | "lower" => Quantity::Length,
            "status" | "across" | "monitored" => Quantity::Number,
            _ => Quantity::Angle,
        }
    }
}
