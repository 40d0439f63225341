//! Events: what a run tells while it goes on, and their JSON form (`docs/events.md`).
//!
//! Invariant: every effect of a program on the world is one event; lengths are mm, angles degrees, feeds mm/min,
//! times seconds. Only this file knows how events look in JSON.
use std::sync::Arc;

use glam::DVec3;
use serde_json::{Map, Value, json};

use super::fault::{Class, Fault};
use crate::diag::Arg;
use crate::engine::geometry::{Axis, WorkingPlane};
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
    },
    /// The program waits.
    Dwell(f64),
    /// A tool is called.
    Tool {
        /// Its number.
        number: f64,
        /// The tool axis.
        axis: Axis,
    },
    /// The spindle turns (+1 clockwise, -1 counter-clockwise), stops, or is oriented.
    Spindle {
        /// +1 clockwise (M3), -1 counter-clockwise (M4), 0 stop.
        direction: i8,
        /// The speed, rev/min.
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
        /// The file.
        file: String,
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
    /// The program ends with an error.
    Error(Fault),
    /// The run ends.
    End(Status),
}

/// A number as JSON has it: no negative zero, and null for what is no number.
fn number(value: f64) -> Value {
    json!(value + 0.0)
}

/// A number of a row or tool: whole numbers without a point.
fn key(value: f64) -> Value {
    if value.fract() == 0.0 && value.abs() < 1e9 { json!(value as i64) } else { number(value) }
}

fn point(point: DVec3) -> Value {
    json!({"X": number(point.x), "Y": number(point.y), "Z": number(point.z)})
}

fn content(content: &Content) -> Value {
    match content {
        Content::Number(value) => number(*value),
        Content::Text(text) => json!(&**text),
    }
}

fn arg(arg: &Arg) -> Value {
    match arg {
        Arg::Number(value) => number(*value),
        Arg::Text(text) => json!(text),
    }
}

impl Event {
    /// The event as a JSON object.
    pub fn to_json(&self) -> Value {
        let mut object = Map::new();
        object.insert("event".to_owned(), self.kind.name().into());
        object.insert("line".to_owned(), self.at.line.into());
        object.insert("block".to_owned(), json!(self.at.block));
        if let Some((key, step)) = &self.at.cycle {
            object.insert("cycle".to_owned(), key.number.into());
            object.insert("keyword".to_owned(), key.keyword.as_str().into());
            object.insert("step".to_owned(), json!(step.as_deref()));
        }
        if let Value::Object(fields) = self.kind.fields() {
            object.extend(fields);
        }
        Value::Object(object)
    }
}

impl EventKind {
    /// The name of the kind.
    pub const fn name(&self) -> &'static str {
        match self {
            Self::Move { .. } => "move",
            Self::Dwell(_) => "dwell",
            Self::Tool { .. } => "tool",
            Self::Spindle { .. } => "spindle",
            Self::Coolant(_) => "coolant",
            Self::Probe(_) => "probe",
            Self::Set { .. } => "set",
            Self::Transform(_) => "transform",
            Self::Table { .. } => "table",
            Self::Log { .. } => "log",
            Self::Message { .. } => "message",
            Self::Error(_) => "error",
            Self::End(_) => "end",
        }
    }

    fn fields(&self) -> Value {
        match self {
            Self::Move { kind, from, to, machine, feed } => moved(*kind, *from, *to, *machine, *feed),
            Self::Dwell(seconds) => json!({"seconds": number(*seconds)}),
            Self::Tool { number: tool, axis } => json!({"tool": key(*tool), "axis": axis.letter().to_string()}),
            Self::Spindle { direction, speed, orient } => {
                let word = match direction {
                    1 => "clockwise",
                    -1 => "counter-clockwise",
                    _ => "stop",
                };
                json!({"direction": word, "speed": number(*speed), "orient": orient.map(number)})
            }
            Self::Coolant(on) => json!({"on": on}),
            Self::Probe(probing) => json!({
                "from": point(probing.from),
                "target": point(probing.target),
                "contact": probing.contact.map(|(touched, _)| point(touched)),
                "ball_centre": probing.contact.map(|(_, centre)| point(centre)),
                "feed": number(probing.feed),
            }),
            Self::Set { q, value } => json!({"q": q.to_string(), "value": content(value)}),
            Self::Transform(system) => json!({
                "preset": key(system.preset),
                "origin": point(system.origin),
                "basic_rotation": point(system.basic_rotation),
                "datum_shift": point(system.datum),
                "rotation": number(system.rotation),
            }),
            Self::Table { file, row, column, value } => {
                json!({"file": file, "row": key(*row), "column": column, "value": content(value)})
            }
            Self::Log { file } => json!({"file": file}),
            Self::Message { kind, id, answer } => json!({"kind": kind.as_str(), "id": &**id, "answer": answer}),
            Self::Error(fault) => {
                let args: Map<String, Value> =
                    fault.args.iter().map(|(name, value)| ((*name).to_owned(), arg(value))).collect();
                json!({"code": &*fault.code, "class": fault.class.as_str(), "args": args})
            }
            Self::End(status) => json!({"status": status.as_str()}),
        }
    }
}

fn moved(kind: MoveKind, from: DVec3, to: DVec3, machine: DVec3, feed: f64) -> Value {
    let word = match kind {
        MoveKind::Rapid => "rapid",
        MoveKind::Feed => "feed",
        MoveKind::Arc { .. } => "arc",
    };
    let mut value = json!({"kind": word, "from": point(from), "to": point(to), "machine": point(machine),
        "feed": number(feed)});
    if let (MoveKind::Arc { centre, plane, angle, rise, rapid }, Some(object)) = (kind, value.as_object_mut()) {
        let letters = [plane.main.letter(), plane.secondary.letter()].iter().collect::<String>();
        object.insert("centre".to_owned(), point(centre));
        object.insert("plane".to_owned(), letters.into());
        object.insert("angle".to_owned(), number(angle));
        object.insert("rise".to_owned(), number(rise));
        object.insert("rapid".to_owned(), rapid.into());
    }
    value
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
