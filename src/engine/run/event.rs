//! Events: what a run tells while it goes on, and their JSON form (`docs/events.md`).
//!
//! Invariant: every effect of a program on the world is one event; lengths are mm, angles degrees, feeds mm/min,
//! times seconds. Only this file knows how events look in JSON.
use std::sync::Arc;

use glam::DVec3;
use serde::Serialize;
use serde::ser::{SerializeMap, Serializer};
use serde_json::Value;

use super::fault::{Class, Fault};
use super::world::Tool;
use crate::diag::Arg;
use crate::engine::geometry::{Axis, RotaryAxis, WorkingPlane};
use crate::engine::solid::Path;
use crate::expr::QRef;
use crate::spec::CycleKey;

/// The version of the JSON form.
pub const FORMAT: &str = "ciklo-events/1";

/// Where in the program an event belongs.
#[derive(Clone, Debug, Default)]
pub struct At {
    /// The file name of the program.
    pub program: Arc<str>,
    /// The physical line, from 1.
    pub line: usize,
    /// The printed block number.
    pub block: Option<u32>,
    /// Inside a cycle: its key, and the id of the step once one has begun.
    pub cycle: Option<(CycleKey, Option<Arc<str>>)>,
}

/// An event.
#[derive(Clone, Debug)]
pub struct Event {
    /// Where it belongs.
    pub at: At,
    /// What happens.
    pub kind: EventKind,
}

/// How a move goes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum MoveKind {
    /// Straight at rapid traverse.
    Rapid,
    /// Straight at a feed.
    Feed,
    /// On an arc in the working plane.
    Arc {
        /// A point of the axis, at the height of the start.
        centre: DVec3,
        /// The working plane.
        plane: WorkingPlane,
        /// The angle in degrees, counter-clockwise positive.
        angle: f64,
        /// The way along the tool axis, mm.
        rise: f64,
        /// Whether it goes at rapid traverse.
        rapid: bool,
    },
}

/// A probing movement, in the active coordinate system.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Probing {
    /// The ball centre where it begins.
    pub from: DVec3,
    /// Where the ball centre would be at the end of the probing path.
    pub target: DVec3,
    /// The point of the workpiece that was touched, and the ball centre at that moment as the control knows it.
    pub contact: Option<(DVec3, DVec3)>,
    /// The probing feed.
    pub feed: f64,
}

/// The coordinate system in effect.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Coordinates {
    /// The row of the preset table, if the preset is one of its rows.
    pub preset: f64,
    /// The preset in machine coordinates.
    pub origin: DVec3,
    /// The spatial angles of the preset.
    pub basic_rotation: DVec3,
    /// The datum shift in the coordinates of the preset.
    pub datum: DVec3,
    /// The rotation in the working plane, degrees.
    pub rotation: f64,
    /// Axes that are mirrored have -1, others 1: linear and rotary ones.
    pub mirror: (DVec3, DVec3),
    /// The scaling factor, and the factors of the axes with the point that stays.
    pub scaling: (f64, Option<(DVec3, DVec3)>),
    /// The spatial angles of a tilted working plane.
    pub tilt: Option<DVec3>,
    /// From program to machine coordinates: three rows, the last number of each is the shift.
    pub matrix: [[f64; 4]; 3],
    /// Where the rotary axes have the coordinate 0, in machine coordinates.
    pub angles: DVec3,
}

/// How one rotary axis turns, in degrees.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Turned {
    /// The axis.
    pub axis: RotaryAxis,
    /// From where, in program coordinates.
    pub from: f64,
    /// Where to, in program coordinates.
    pub to: f64,
    /// Where to in machine coordinates.
    pub machine: f64,
}

/// A thread as the ways of the tool have cut it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Threaded {
    /// Whether it was milled; else it was tapped.
    pub milled: bool,
    /// Whether it lies around a stud.
    pub outside: bool,
    /// Whether it is a right-hand thread.
    pub right: bool,
    /// The diameter that the cutting edge reached, mm.
    pub diameter: f64,
    /// The way along the axis in a turn, mm.
    pub pitch: f64,
    /// The end nearer to the spindle, on the axis, in the active coordinate system.
    pub top: DVec3,
    /// The other end.
    pub bottom: DVec3,
    /// Helices, or ways in.
    pub passes: u32,
}

/// What is found about a move in the material.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FindingKind {
    /// A move at rapid traverse went through material; the amount is the greatest height of it in mm.
    Rapid,
    /// A tool went through material while the spindle stood; the amount as above.
    SpindleStands,
    /// Material was cut above the cutting edges; the amount is the length that the edges would need, mm.
    EdgesTooShort,
    /// A rotary axis turned while the tool moved: the stock knows where they ended, and not the way between.
    TurnsTogether,
    /// The tool has no radius, so what it removes is not known; the amount is its number.
    NoRadius,
}

impl FindingKind {
    /// All kinds.
    pub const ALL: [Self; 5] =
        [Self::Rapid, Self::SpindleStands, Self::EdgesTooShort, Self::TurnsTogether, Self::NoRadius];

    /// The word for it in JSON, and in the id of its message (`stock-<word>`).
    pub const fn as_str(self) -> &'static str {
        match self {
            Self::Rapid => "rapid-in-material",
            Self::SpindleStands => "spindle-stands",
            Self::EdgesTooShort => "edges-too-short",
            Self::TurnsTogether => "turns-together",
            Self::NoRadius => "no-radius",
        }
    }
}

/// The kinds of messages.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MessageKind {
    /// Worth knowing.
    Note,
    /// A guard warns.
    Warning,
    /// A guard skips the cycle.
    Skip,
    /// The operator must agree.
    Confirm,
    /// The operator is asked or shown something, and the program waits.
    Question,
    /// The program stops until the operator continues.
    Stop,
}

impl MessageKind {
    const fn as_str(self) -> &'static str {
        match self {
            Self::Note => "note",
            Self::Warning => "warning",
            Self::Skip => "skip",
            Self::Confirm => "confirm",
            Self::Question => "question",
            Self::Stop => "stop",
        }
    }
}

/// The value that a Q parameter or a cell of a table gets.
#[derive(Clone, Debug, PartialEq)]
pub enum Content {
    /// A number.
    Number(f64),
    /// A text.
    Text(Arc<str>),
}

/// How a run ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Status {
    /// The program came to its end.
    Done,
    /// It stopped and nobody continued it.
    Stopped,
    /// The control would stop with an error, or the program is wrong.
    Error,
    /// A limit of the engine was reached.
    Limit,
    /// The engine cannot do what the program wants.
    Unsupported,
}

impl Status {
    /// The word in JSON.
    pub const fn as_str(self) -> &'static str {
        match self {
            Self::Done => "done",
            Self::Stopped => "stopped",
            Self::Error => "error",
            Self::Limit => "limit",
            Self::Unsupported => "unsupported",
        }
    }

    /// The status of that word.
    pub fn by_word(word: &str) -> Option<Self> {
        [Self::Done, Self::Stopped, Self::Error, Self::Limit, Self::Unsupported]
            .into_iter()
            .find(|status| status.as_str() == word)
    }
}

/// What happens.
#[derive(Clone, Debug)]
pub enum EventKind {
    /// The tool moves.
    Move {
        /// How.
        kind: MoveKind,
        /// From where, in the active coordinate system.
        from: DVec3,
        /// Where to.
        to: DVec3,
        /// Where to in machine coordinates.
        machine: DVec3,
        /// The feed along the path.
        feed: f64,
        /// The way of the tool tip in machine coordinates; JSON tells it by the other members.
        path: Path,
    },
    /// Rotary axes turn together.
    Turn {
        /// The axes that turn.
        axes: Vec<Turned>,
        /// The rate of the longest way in degrees/min.
        feed: f64,
        /// Whether at rapid traverse.
        rapid: bool,
        /// Whether at the same time as the move told before.
        together: bool,
    },
    /// The program waits.
    Dwell(f64),
    /// The spindle gets a tool, turns (+1 clockwise, -1 counter-clockwise), stops, or is oriented.
    Spindle {
        /// The tool that was called and the tool axis; nothing if the tool stays.
        tool: Option<(Tool, Axis)>,
        /// +1 clockwise (M3), -1 counter-clockwise (M4), 0 stop.
        direction: i8,
        /// The speed, rev/min; 0 while the spindle stands.
        speed: f64,
        /// The angle of an orientation.
        orient: Option<f64>,
    },
    /// The coolant is switched.
    Coolant(bool),
    /// The probe moves towards the workpiece.
    Probe(Probing),
    /// A Q parameter changes.
    Set {
        /// The parameter.
        q: QRef,
        /// Its new value.
        value: Content,
    },
    /// The coordinate system changes.
    Transform(Coordinates),
    /// How far the path may deviate: the tolerance of the contour, the filter and the tolerance of rotary axes; nothing if
    /// it is that of the machine.
    Tolerance(Option<[f64; 3]>),
    /// A cell of a table is written.
    Table {
        /// The file.
        file: String,
        /// The row.
        row: f64,
        /// The column.
        column: String,
        /// The new value.
        value: Content,
    },
    /// A log is written.
    Log {
        /// The file; nothing if it is shown on the screen.
        file: Option<String>,
        /// What is written.
        text: String,
    },
    /// The operator is told something.
    Message {
        /// What kind.
        kind: MessageKind,
        /// Its id: of a message or guard of a specification, or `stop`.
        id: Arc<str>,
        /// What the operator said, if he was asked.
        answer: Option<bool>,
    },
    /// A thread was cut.
    Thread(Threaded),
    /// The move before did something in the material that it should not, or that is not known (`engine::stock`).
    Finding {
        /// What.
        kind: FindingKind,
        /// By how much.
        amount: f64,
    },
    /// The program ends with an error.
    Error(Fault),
    /// The run ends.
    End(Status),
}

/// A number as JSON has it: no negative zero.
fn number(value: f64) -> f64 {
    value + 0.0
}

/// A number of a row or tool: whole numbers without a point.
#[derive(Serialize)]
#[serde(untagged)]
enum RowNumber {
    Whole(i64),
    Broken(f64),
}

fn key(value: f64) -> RowNumber {
    let whole = value.fract() == 0.0 && value.abs() < 1e9;
    if whole { RowNumber::Whole(value as i64) } else { RowNumber::Broken(value) }
}

/// Coordinates by axis letter.
#[derive(Serialize)]
struct Point {
    #[serde(rename = "X")]
    x: f64,
    #[serde(rename = "Y")]
    y: f64,
    #[serde(rename = "Z")]
    z: f64,
}

fn point(point: DVec3) -> Point {
    Point { x: number(point.x), y: number(point.y), z: number(point.z) }
}

/// Angles by axis letter.
struct Angles<'a>(&'a [(RotaryAxis, f64)]);

impl Serialize for Angles<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map(self.0.iter().map(|(axis, angle)| (axis.letter(), number(*angle))))
    }
}

impl Serialize for Content {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self {
            Self::Number(value) => serializer.serialize_f64(number(*value)),
            Self::Text(text) => serializer.serialize_str(text),
        }
    }
}

/// What decided about a fault, by name.
struct Args<'a>(&'a [(&'static str, Arg)]);

impl Serialize for Args<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(Some(self.0.len()))?;
        for (name, arg) in self.0 {
            match arg {
                Arg::Number(value) => map.serialize_entry(name, &number(*value))?,
                Arg::Text(text) => map.serialize_entry(name, text)?,
            }
        }
        map.end()
    }
}

impl Serialize for Event {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(None)?;
        map.serialize_entry("event", self.kind.name())?;
        map.serialize_entry("line", &self.at.line)?;
        map.serialize_entry("block", &self.at.block)?;
        if let Some((key, step)) = &self.at.cycle {
            map.serialize_entry("cycle", &key.number)?;
            map.serialize_entry("keyword", key.keyword.as_str())?;
            map.serialize_entry("step", &step.as_deref())?;
        }
        self.kind.fields(&mut map)?;
        map.end()
    }
}

impl Event {
    /// The event as a JSON object.
    pub fn to_json(&self) -> Value {
        serde_json::to_value(self).unwrap_or(Value::Null)
    }

    /// The event as a line of JSON with its line end.
    pub fn to_line(&self) -> String {
        // Only a key that is no text could fail, and every key here is one.
        let mut line = serde_json::to_string(self).unwrap_or_default();
        line.push('\n');
        line
    }
}

impl EventKind {
    /// The name of the kind.
    pub const fn name(&self) -> &'static str {
        match self {
            Self::Move { .. } => "move",
            Self::Turn { .. } => "turn",
            Self::Dwell(_) => "dwell",
            Self::Spindle { .. } => "spindle",
            Self::Coolant(_) => "coolant",
            Self::Probe(_) => "probe",
            Self::Set { .. } => "set",
            Self::Transform(_) => "transform",
            Self::Tolerance(_) => "tolerance",
            Self::Table { .. } => "table",
            Self::Log { .. } => "log",
            Self::Message { .. } => "message",
            Self::Thread(_) => "thread",
            Self::Finding { .. } => "finding",
            Self::Error(_) => "error",
            Self::End(_) => "end",
        }
    }
}

/// What is mirrored, scaled and tilted, and what that makes of program coordinates; nothing where nothing is.
fn changed<M: SerializeMap>(map: &mut M, system: &Coordinates) -> Result<(), M::Error> {
    let (linear, rotary) = system.mirror;
    let (factor, axes) = system.scaling;
    let mut mirrored: Vec<char> =
        Axis::ALL.into_iter().filter(|axis| axis.of(linear) < 0.0).map(Axis::letter).collect();
    mirrored.extend(RotaryAxis::ALL.into_iter().filter(|axis| axis.of(rotary) < 0.0).map(RotaryAxis::letter));
    if !mirrored.is_empty() {
        map.serialize_entry("mirrored", &mirrored)?;
    }
    if factor != 1.0 {
        map.serialize_entry("scaling", &number(factor))?;
    }
    if let Some((factors, about)) = axes {
        map.serialize_entry("axis_scaling", &point(factors))?;
        map.serialize_entry("scaled_about", &point(about))?;
    }
    if let Some(angles) = system.tilt {
        let angles: Vec<_> = RotaryAxis::ALL.into_iter().map(|axis| (axis, axis.of(angles))).collect();
        map.serialize_entry("tilting", &Angles(&angles))?;
    }
    if mirrored.is_empty() && factor == 1.0 && axes.is_none() && system.tilt.is_none() {
        return Ok(());
    }
    map.serialize_entry("matrix", &system.matrix)
}

impl EventKind {
    fn fields<M: SerializeMap>(&self, map: &mut M) -> Result<(), M::Error> {
        match self {
            Self::Move { kind, from, to, machine, feed, .. } => moved(map, *kind, [*from, *to, *machine], *feed),
            Self::Dwell(seconds) => map.serialize_entry("seconds", &number(*seconds)),
            Self::Spindle { tool, direction, speed, orient } => {
                if let Some((tool, axis)) = tool {
                    map.serialize_entry("tool", &key(tool.number))?;
                    map.serialize_entry("axis", &axis.letter())?;
                }
                let word = match direction {
                    1 => "clockwise",
                    -1 => "counter-clockwise",
                    _ => "stop",
                };
                map.serialize_entry("direction", word)?;
                map.serialize_entry("speed", &number(*speed))?;
                map.serialize_entry("orient", &orient.map(number))
            }
            Self::Turn { axes, feed, rapid, together } => {
                let of =
                    |value: fn(&Turned) -> f64| axes.iter().map(|axis| (axis.axis, value(axis))).collect::<Vec<_>>();
                map.serialize_entry("from", &Angles(&of(|axis| axis.from)))?;
                map.serialize_entry("to", &Angles(&of(|axis| axis.to)))?;
                map.serialize_entry("machine", &Angles(&of(|axis| axis.machine)))?;
                map.serialize_entry("feed", &number(*feed))?;
                map.serialize_entry("rapid", rapid)?;
                map.serialize_entry("together", together)
            }
            Self::Coolant(on) => map.serialize_entry("on", on),
            Self::Probe(probing) => {
                map.serialize_entry("from", &point(probing.from))?;
                map.serialize_entry("target", &point(probing.target))?;
                map.serialize_entry("contact", &probing.contact.map(|(touched, _)| point(touched)))?;
                map.serialize_entry("ball_centre", &probing.contact.map(|(_, centre)| point(centre)))?;
                map.serialize_entry("feed", &number(probing.feed))
            }
            Self::Set { q, value } => {
                map.serialize_entry("q", &q.to_string())?;
                map.serialize_entry("value", value)
            }
            Self::Transform(system) => {
                map.serialize_entry("preset", &key(system.preset))?;
                map.serialize_entry("origin", &point(system.origin))?;
                map.serialize_entry("basic_rotation", &point(system.basic_rotation))?;
                map.serialize_entry("datum_shift", &point(system.datum))?;
                map.serialize_entry("rotation", &number(system.rotation))?;
                let angles = RotaryAxis::ALL.into_iter().map(|axis| (axis, axis.of(system.angles)));
                let angles: Vec<_> = angles.filter(|(_, angle)| *angle != 0.0).collect();
                if !angles.is_empty() {
                    map.serialize_entry("angles", &Angles(&angles))?;
                }
                changed(map, system)
            }
            Self::Tolerance(tolerance) => {
                let [contour, hsc, rotary] = tolerance.map_or([None; 3], |values| values.map(Some));
                map.serialize_entry("contour", &contour.map(number))?;
                map.serialize_entry("hsc_mode", &hsc.map(number))?;
                map.serialize_entry("rotary", &rotary.map(number))
            }
            Self::Table { file, row, column, value } => {
                map.serialize_entry("file", file)?;
                map.serialize_entry("row", &key(*row))?;
                map.serialize_entry("column", column)?;
                map.serialize_entry("value", value)
            }
            Self::Log { file, text } => {
                map.serialize_entry("file", file)?;
                if file.is_none() {
                    map.serialize_entry("text", text)?;
                }
                Ok(())
            }
            Self::Message { kind, id, answer } => {
                map.serialize_entry("kind", kind.as_str())?;
                map.serialize_entry("id", &**id)?;
                map.serialize_entry("answer", answer)
            }
            Self::Thread(thread) => threaded(map, thread),
            Self::Finding { kind, amount } => {
                map.serialize_entry("finding", kind.as_str())?;
                map.serialize_entry("amount", &number(*amount))
            }
            Self::Error(fault) => {
                map.serialize_entry("code", &*fault.code)?;
                map.serialize_entry("class", fault.class.as_str())?;
                map.serialize_entry("args", &Args(&fault.args))
            }
            Self::End(status) => map.serialize_entry("status", status.as_str()),
        }
    }
}

fn threaded<M: SerializeMap>(map: &mut M, thread: &Threaded) -> Result<(), M::Error> {
    map.serialize_entry("way", if thread.milled { "milled" } else { "tapped" })?;
    map.serialize_entry("side", if thread.outside { "outside" } else { "inside" })?;
    map.serialize_entry("hand", if thread.right { "right" } else { "left" })?;
    map.serialize_entry("diameter", &number(thread.diameter))?;
    map.serialize_entry("pitch", &number(thread.pitch))?;
    map.serialize_entry("top", &point(thread.top))?;
    map.serialize_entry("bottom", &point(thread.bottom))?;
    map.serialize_entry("passes", &thread.passes)
}

fn moved<M: SerializeMap>(map: &mut M, kind: MoveKind, points: [DVec3; 3], feed: f64) -> Result<(), M::Error> {
    let word = match kind {
        MoveKind::Rapid => "rapid",
        MoveKind::Feed => "feed",
        MoveKind::Arc { .. } => "arc",
    };
    map.serialize_entry("kind", word)?;
    for (name, value) in ["from", "to", "machine"].iter().zip(points) {
        map.serialize_entry(name, &point(value))?;
    }
    map.serialize_entry("feed", &number(feed))?;
    if let MoveKind::Arc { centre, plane, angle, rise, rapid } = kind {
        let letters = [plane.main.letter(), plane.secondary.letter()].iter().collect::<String>();
        map.serialize_entry("centre", &point(centre))?;
        map.serialize_entry("plane", &letters)?;
        map.serialize_entry("angle", &number(angle))?;
        map.serialize_entry("rise", &number(rise))?;
        map.serialize_entry("rapid", &rapid)?;
    }
    Ok(())
}

impl Class {
    /// The word in JSON.
    pub const fn as_str(self) -> &'static str {
        match self {
            Self::Program => "program",
            Self::Control => "control",
            Self::Limit => "limit",
            Self::Unsupported => "unsupported",
            Self::Internal => "internal",
        }
    }
}
