//! The named strategies that the engine has, with their arguments.
//!
//! A strategy is written once for all cycles and does one thing with values that are given to it; one that
//! is not listed here is pending. Invariant: signatures only, no execution.
use crate::expr::Type;

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
    /// Whether it must be there.
    pub required: bool,
}

const fn required(name: &'static str, ty: Type) -> Parameter {
    Parameter { name, ty, required: true }
}

const fn optional(name: &'static str) -> Parameter {
    Parameter { name, ty: Type::Number, required: false }
}

const POINT: Parameter = required("point", Type::Point);
const MAIN: Parameter = optional("main");
const MINOR: Parameter = optional("minor");
const TOOL: Parameter = optional("tool");
const TEXT: Parameter = required("text", Type::Text);
const ROW: Parameter = required("row", Type::Number);
const CENTRE: Parameter = required("centre", Type::Point);

const fn number(name: &'static str) -> Parameter {
    required(name, Type::Number)
}

const fn point(name: &'static str) -> Parameter {
    required(name, Type::Point)
}

const ANY_AXIS: Parameter = optional("axis");
const ACTUAL: Parameter = point("actual");
const NOMINAL: Parameter = point("nominal");
const ALONG_SECOND: Parameter = number("along_second_axis");
const MEASURING_AXIS: Parameter = number("measuring_axis");
const TRANSFER: Parameter = number("transfer");
const TARGET_ANGLE: Parameter = optional("angle");
const TABLE_ROW: Parameter = optional("row");
const LINE: (Parameter, Parameter) = (point("from"), point("to"));
const LINES: [Parameter; 4] = [point("first"), point("second"), point("third"), point("fourth")];
const OWN_PATH: [Parameter; 6] = [
    point("direction"),
    number("path"),
    number("feed"),
    optional("in_machine"),
    optional("tolerant"),
    optional("silent"),
];
const PATH: Parameter = number("path");
const THREE: [Parameter; 3] = [point("first"), point("second"), point("third")];
const CALIBRATED: [Parameter; 3] =
    [optional("radius"), optional("length"), Parameter { name: "offset", ty: Type::Point, required: false }];
const ABOUT: Parameter = Parameter { name: "about", ty: Type::Point, required: false };
const AXIS: Parameter = number("axis");
const FROM: Parameter = number("from");
const TO: Parameter = number("to");
const ANGLE: Parameter = number("angle");
const FEED: Parameter = number("feed");
const RADIUS: Parameter = number("radius");
const DIRECTION: Parameter = number("direction");
const ROTATION: Parameter = number("rotation");
const LEAST: Parameter = number("least");
const ROOM: Parameter = number("room");

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
            Self::ToleranceBand => &[TEXT],
        }
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
            Self::ToleranceBand => &["upper", "lower", "monitored"],
            _ => &[],
        }
    }
}
