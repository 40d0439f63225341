//! The JSON form of events (`docs/events.md`). Only this file knows it.
use glam::DVec3;
use serde::Serialize;
use serde::ser::{SerializeMap, Serializer};
use serde_json::Value;

use crate::base::diag::Arg;
use crate::engine::geometry::{Axis, RotaryAxis};
use crate::engine::params::Content;
use crate::engine::report::event::{Coordinates, Event, EventKind, MoveKind, Threaded, Turned};
use crate::engine::report::fault::Class;

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
    if system.tip_held {
        map.serialize_entry("tcpm", &true)?;
    }
    if mirrored.is_empty() && factor == 1.0 && axes.is_none() && system.tilt.is_none() && !system.tip_held {
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
