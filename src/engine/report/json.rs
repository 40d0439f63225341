//! The JSON form of events (`docs/events.md`). Only this file knows it.
//!
//! The members of an event go to an [`Object`]: a tree of values, or the bytes of a line (`json_line.rs`).
use glam::DVec3;
use serde_json::{Map, Value};

use crate::base::diag::Arg;
use crate::engine::geometry::{Axis, RotaryAxis};
use crate::engine::params::Content;
use crate::engine::report::event::{
    At, Coordinates, Event, EventKind, MoveKind, OnDiameter, Probing, Slid, Threaded, Turned,
};
use crate::engine::report::fault::Class;
use crate::engine::report::json_line::Lines;

/// What takes the members of an object, in their order.
pub(super) trait Object: Sized {
    /// A text.
    fn text(&mut self, key: &str, text: &str);
    /// A number; null if it is infinite or none.
    fn number(&mut self, key: &str, number: f64);
    /// A whole number, without a point.
    fn whole(&mut self, key: &str, whole: i64);
    /// True or false.
    fn truth(&mut self, key: &str, truth: bool);
    /// Null.
    fn null(&mut self, key: &str);
    /// An object with the members that `fill` adds.
    fn object(&mut self, key: &str, fill: impl FnOnce(&mut Self));
    /// A list of letters.
    fn letters(&mut self, key: &str, letters: &[char]);
    /// Rows of numbers.
    fn rows(&mut self, key: &str, rows: &[[f64; 4]]);

    /// The place of an event.
    fn place(&mut self, at: &At) {
        at.line_members(self);
        at.step_members(self);
    }

    /// Coordinates by axis letter.
    fn point(&mut self, key: &str, point: DVec3) {
        self.object(key, |object| {
            object.number("X", plain(point.x));
            object.number("Y", plain(point.y));
            object.number("Z", plain(point.z));
        });
    }

    /// Coordinates by axis letter, or null.
    fn opt_point(&mut self, key: &str, point: Option<DVec3>) {
        match point {
            Some(point) => self.point(key, point),
            None => self.null(key),
        }
    }

    /// A number, or null.
    fn opt_number(&mut self, key: &str, value: Option<f64>) {
        match value {
            Some(value) => self.number(key, plain(value)),
            None => self.null(key),
        }
    }

    /// A text, or null.
    fn opt_text(&mut self, key: &str, text: Option<&str>) {
        match text {
            Some(text) => self.text(key, text),
            None => self.null(key),
        }
    }

    /// A number of a row or tool: whole numbers without a point.
    fn row(&mut self, key: &str, value: f64) {
        let whole = value.fract() == 0.0 && value.abs() < 1e9;
        if whole { self.whole(key, value as i64) } else { self.number(key, value) }
    }

    /// Angles by axis letter.
    fn angles(&mut self, key: &str, angles: impl Iterator<Item = (RotaryAxis, f64)>) {
        self.object(key, |object| {
            for (axis, angle) in angles {
                object.number(axis.letter().encode_utf8(&mut [0; 4]), plain(angle));
            }
        });
    }

    /// The value of a parameter or cell.
    fn content(&mut self, key: &str, content: &Content) {
        match content {
            Content::Number(value) => self.number(key, plain(*value)),
            Content::Text(text) => self.text(key, text),
        }
    }
}

impl Object for Map<String, Value> {
    fn text(&mut self, key: &str, text: &str) {
        self.insert(key.to_owned(), text.into());
    }

    fn number(&mut self, key: &str, number: f64) {
        self.insert(key.to_owned(), number.into());
    }

    fn whole(&mut self, key: &str, whole: i64) {
        self.insert(key.to_owned(), whole.into());
    }

    fn truth(&mut self, key: &str, truth: bool) {
        self.insert(key.to_owned(), truth.into());
    }

    fn null(&mut self, key: &str) {
        self.insert(key.to_owned(), Value::Null);
    }

    fn object(&mut self, key: &str, fill: impl FnOnce(&mut Self)) {
        let mut inner = Self::new();
        fill(&mut inner);
        self.insert(key.to_owned(), Value::Object(inner));
    }

    fn letters(&mut self, key: &str, letters: &[char]) {
        let letters: Vec<String> = letters.iter().map(char::to_string).collect();
        self.insert(key.to_owned(), letters.into());
    }

    fn rows(&mut self, key: &str, rows: &[[f64; 4]]) {
        let rows: Vec<Value> = rows.iter().map(|row| row.to_vec().into()).collect();
        self.insert(key.to_owned(), rows.into());
    }
}

/// A number as JSON has it: no negative zero.
pub(super) fn plain(value: f64) -> f64 {
    value + 0.0
}

impl Event {
    /// The event as a JSON object.
    pub fn to_json(&self) -> Value {
        let mut map = Map::new();
        self.members(&mut map);
        Value::Object(map)
    }

    /// The event as a line of JSON with its line end. Many events are written by [`Lines`].
    pub fn to_line(&self) -> String {
        let mut lines = Lines::default();
        lines.add(self);
        String::from_utf8_lossy(lines.bytes()).into_owned()
    }

    #[inline]
    pub(super) fn members(&self, object: &mut impl Object) {
        object.text("event", self.kind.name());
        object.place(&self.at);
        self.kind.members(object);
    }
}

impl At {
    /// Where it is in the text of the program.
    #[inline]
    pub(super) fn line_members(&self, object: &mut impl Object) {
        object.whole("line", i64::try_from(self.line).unwrap_or(i64::MAX));
        match self.block {
            Some(block) => object.whole("block", block.into()),
            None => object.null("block"),
        }
    }

    /// Where it is in a cycle.
    pub(super) fn step_members(&self, object: &mut impl Object) {
        if let Some((key, step)) = &self.cycle {
            object.whole("cycle", key.number.into());
            object.text("keyword", key.keyword.as_str());
            object.opt_text("step", step.as_deref());
        }
    }
}

/// What is mirrored, scaled and tilted, and what that makes of program coordinates; nothing where nothing is.
fn changed(object: &mut impl Object, system: &Coordinates) {
    let (linear, rotary) = system.mirror;
    let (factor, axes) = system.scaling;
    let mut mirrored: Vec<char> =
        Axis::ALL.into_iter().filter(|axis| axis.of(linear) < 0.0).map(Axis::letter).collect();
    mirrored.extend(RotaryAxis::ALL.into_iter().filter(|axis| axis.of(rotary) < 0.0).map(RotaryAxis::letter));
    if !mirrored.is_empty() {
        object.letters("mirrored", &mirrored);
    }
    if factor != 1.0 {
        object.number("scaling", plain(factor));
    }
    if let Some((factors, about)) = axes {
        object.point("axis_scaling", factors);
        object.point("scaled_about", about);
    }
    if let Some(angles) = system.tilt {
        object.angles("tilting", RotaryAxis::ALL.into_iter().map(|axis| (axis, axis.of(angles))));
    }
    if system.tip_held {
        object.truth("tcpm", true);
    }
    if system.axes_counted {
        object.truth("axes_counted", true);
    }
    let on_workpiece = system.tilt.is_some() || system.tip_held || system.axes_counted;
    if !mirrored.is_empty() || factor != 1.0 || axes.is_some() || on_workpiece {
        object.rows("matrix", &system.matrix);
    }
}

impl EventKind {
    #[inline]
    fn members(&self, object: &mut impl Object) {
        match self {
            Self::Move { kind, from, to, machine, feed, turned, .. } => {
                moved(object, *kind, [*from, *to, *machine], *feed);
                if let Some(OnDiameter { diameter, speed }) = turned {
                    object.number("diameter", plain(*diameter));
                    object.number("turning_speed", plain(*speed));
                }
            }
            other => other.other_members(object),
        }
    }

    /// Those of everything but a move.
    fn other_members(&self, object: &mut impl Object) {
        match self {
            Self::Move { .. } => {}
            Self::Dwell(seconds) => object.number("seconds", plain(*seconds)),
            Self::Spindle { tool, direction, speed, orient } => {
                if let Some((tool, axis)) = tool {
                    object.row("tool", tool.number);
                    object.text("axis", axis.letter().encode_utf8(&mut [0; 4]));
                }
                let word = match direction {
                    1 => "clockwise",
                    -1 => "counter-clockwise",
                    _ => "stop",
                };
                object.text("direction", word);
                object.number("speed", plain(*speed));
                object.opt_number("orient", *orient);
            }
            Self::Turn { axes, feed, rapid, together } => {
                let mut of = |key: &str, value: fn(&Turned) -> f64| {
                    object.angles(key, axes.iter().map(|axis| (axis.axis, value(axis))));
                };
                of("from", |axis| axis.from);
                of("to", |axis| axis.to);
                of("machine", |axis| axis.machine);
                object.number("feed", plain(*feed));
                object.truth("rapid", *rapid);
                object.truth("together", *together);
            }
            Self::Insert(insert) => {
                object.text("form", insert.form.as_str());
                object.number("radius", plain(insert.radius));
                object.object("tip", |tip| {
                    tip.number("X", plain(insert.tip[0]));
                    tip.number("Z", plain(insert.tip[1]));
                });
                object.object("edges", |edges| {
                    edges.number("front", plain(insert.edges[0]));
                    edges.number("back", plain(insert.edges[1]));
                });
                if insert.width.0 > 0.0 {
                    object.number("width", plain(insert.width.0));
                    object.number("across", plain(insert.width.1));
                }
                object.number("length", plain(insert.length));
            }
            Self::Slide { axes, feed, rapid, together } => {
                let mut of = |key: &str, value: fn(&Slid) -> f64| {
                    object.object(key, |object| {
                        for axis in axes {
                            object.number(axis.axis.encode_utf8(&mut [0; 4]), plain(value(axis)));
                        }
                    });
                };
                of("from", |axis| axis.from);
                of("to", |axis| axis.to);
                object.number("feed", plain(*feed));
                object.truth("rapid", *rapid);
                object.truth("together", *together);
            }
            Self::Coolant(on) => object.truth("on", *on),
            Self::Function(text) => object.text("text", text),
            Self::Probe(probing) => probed(object, probing),
            Self::Set { q, value } => {
                object.text("q", &q.to_string());
                object.content("value", value);
            }
            Self::Transform(system) => transformed(object, system),
            Self::Tolerance(tolerance) => {
                let [contour, hsc, rotary] = tolerance.map_or([None; 3], |values| values.map(Some));
                object.opt_number("contour", contour);
                object.opt_number("hsc_mode", hsc);
                object.opt_number("rotary", rotary);
            }
            Self::Table { file, row, column, value } => {
                object.text("file", file);
                object.row("row", *row);
                object.text("column", column);
                object.content("value", value);
            }
            Self::Log { file, text } => {
                object.opt_text("file", file.as_deref());
                if file.is_none() {
                    object.text("text", text);
                }
            }
            Self::Message { kind, id, answer } => {
                object.text("kind", kind.as_str());
                object.text("id", id);
                match answer {
                    Some(answer) => object.truth("answer", *answer),
                    None => object.null("answer"),
                }
            }
            Self::Left { area, at } => {
                object.number("area", plain(*area));
                object.point("place", *at);
            }
            Self::Thread(thread) => threaded(object, thread),
            Self::Finding { kind, amount } => {
                object.text("finding", kind.as_str());
                object.number("amount", plain(*amount));
            }
            Self::Error(fault) => {
                object.text("code", &fault.code);
                object.text("class", fault.class.as_str());
                object.object("args", |object| {
                    for (name, arg) in &fault.args {
                        match arg {
                            Arg::Number(value) => object.number(name, plain(*value)),
                            Arg::Text(text) => object.text(name, text),
                        }
                    }
                });
            }
            Self::End(status) => object.text("status", status.as_str()),
        }
    }
}

fn transformed(object: &mut impl Object, system: &Coordinates) {
    object.row("preset", system.preset);
    object.point("origin", system.origin);
    object.point("basic_rotation", system.basic_rotation);
    object.point("datum_shift", system.datum);
    object.number("rotation", plain(system.rotation));
    let angles = RotaryAxis::ALL.into_iter().map(|axis| (axis, axis.of(system.angles)));
    let mut angles = angles.filter(|(_, angle)| *angle != 0.0).peekable();
    if angles.peek().is_some() {
        object.angles("angles", angles);
    }
    changed(object, system);
}

fn probed(object: &mut impl Object, probing: &Probing) {
    object.point("from", probing.from);
    object.point("target", probing.target);
    object.opt_point("contact", probing.contact.map(|(touched, _)| touched));
    object.opt_point("ball_centre", probing.contact.map(|(_, centre)| centre));
    object.number("feed", plain(probing.feed));
}

fn threaded(object: &mut impl Object, thread: &Threaded) {
    object.text("way", if thread.milled { "milled" } else { "tapped" });
    object.text("side", if thread.outside { "outside" } else { "inside" });
    object.text("hand", if thread.right { "right" } else { "left" });
    object.number("diameter", plain(thread.diameter));
    object.number("pitch", plain(thread.pitch));
    object.point("top", thread.top);
    object.point("bottom", thread.bottom);
    object.whole("passes", thread.passes.into());
}

#[inline]
fn moved(object: &mut impl Object, kind: MoveKind, [from, to, machine]: [DVec3; 3], feed: f64) {
    let word = match kind {
        MoveKind::Rapid => "rapid",
        MoveKind::Feed => "feed",
        MoveKind::Arc { .. } => "arc",
    };
    object.text("kind", word);
    object.point("from", from);
    object.point("to", to);
    object.point("machine", machine);
    object.number("feed", plain(feed));
    if let MoveKind::Arc { centre, plane, angle, rise, rapid } = kind {
        object.point("centre", centre);
        object.text("plane", &[plane.main.letter(), plane.secondary.letter()].iter().collect::<String>());
        object.number("angle", plain(angle));
        object.number("rise", plain(rise));
        object.truth("rapid", rapid);
    }
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
