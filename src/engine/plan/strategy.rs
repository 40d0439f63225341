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
    /// Brings the tool to a level on a helix.
    PlungeOnHelix,
    /// Brings the tool to a level in strokes to and fro.
    PlungeInStrokes,
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
            "plunge-on-helix" => Self::PlungeOnHelix,
            "plunge-in-strokes" => Self::PlungeInStrokes,
            "tolerance-band" => Self::ToleranceBand,
            _ => return None,
        })
    }

    /// Its arguments: the point, the coordinates that it shall have (axes not named stay as they are), the row.
    pub const fn parameters(self) -> &'static [Parameter] {
        match self {
            Self::SetDatum => &[POINT, MAIN, MINOR, TOOL],
            Self::WritePreset | Self::WriteDatumRow => &[POINT, MAIN, MINOR, TOOL, ROW],
            Self::PlungeOnHelix => &[CENTRE, FROM, TO, ANGLE, FEED, RADIUS, DIRECTION],
            Self::PlungeInStrokes => &[CENTRE, FROM, TO, ANGLE, FEED, ROTATION, LEAST, ROOM],
            Self::ToleranceBand => &[TEXT],
        }
    }

    /// Its results, all of them numbers.
    pub const fn results(self) -> &'static [&'static str] {
        match self {
            Self::SetDatum | Self::WritePreset | Self::WriteDatumRow | Self::PlungeOnHelix | Self::PlungeInStrokes => {
                &[]
            }
            Self::ToleranceBand => &["upper", "lower", "monitored"],
        }
    }
}
