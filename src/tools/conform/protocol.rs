//! The protocol by which another engine is tested (`docs/conform-protocol.md`): one JSON object a line each way.
//!
//! Invariant: a request holds all that a case needs, and an answer all that can be compared; how lines travel is the
//! caller's.
use std::collections::BTreeMap;

use glam::DVec3;
use serde::{Deserialize, Serialize};
use serde_json::{Map, Value};

use super::expect::spindle_words;
use super::{Called, LogTexts, World};
use crate::base::diag::Source;
use crate::base::expr::QRef;
use crate::engine::geometry::{Axis, RotaryAxis, WorkingPlane};
use crate::engine::run::{
    Content, Engine, Event, EventKind, ForeignOutcome, MoveKind, OnDiameter, Outcome, Probing, Status, Turned,
};
use crate::engine::scene::Scene;
use crate::engine::solid::Path;
use crate::program::syntax;
use crate::spec::{CycleKey, Keyword, Kind, Node};

/// The name and version of the protocol.
pub const PROTOCOL: &str = "ciklo-conform-protocol/1";

/// The error of an answer to a line that is no request.
const BAD_REQUEST: &str = "bad-request";

/// A case for another engine.
#[derive(Clone, Debug, Deserialize, Serialize)]
pub struct Request {
    /// The name and version of the protocol.
    pub format: String,
    /// Counts the requests of a run.
    pub id: u64,
    /// The control.
    pub control: String,
    /// The cycle whose movements are wanted.
    pub cycle: CycleName,
    /// The name of the case.
    pub case: String,
    /// The language of logs.
    pub language: String,
    /// The text of the program.
    pub program: String,
    /// The programs that it calls, by their names.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub programs: BTreeMap<String, String>,
    /// The scene, as `docs/scene.md` describes it.
    pub scene: Value,
    /// The tables of the scene as files of the control, by their names.
    pub tables: BTreeMap<String, String>,
}

/// The name of a cycle.
#[derive(Clone, Debug, Deserialize, Serialize)]
pub struct CycleName {
    /// `CYCL DEF` or `TCH PROBE`.
    pub keyword: String,
    /// Its number.
    pub number: u32,
}

/// What an engine answers.
#[derive(Clone, Debug, Default, Deserialize, Serialize)]
#[serde(default)]
pub struct Answer {
    /// That of the request.
    pub id: u64,
    /// How the run ended: `done`, `stopped`, `error`, `limit` or `unsupported`.
    pub end: String,
    /// The code of the error that ended it.
    pub errors: Vec<String>,
    /// The Q parameters at the end.
    pub q: BTreeMap<String, Value>,
    /// The tool tip and the rotary axes at the end, in program coordinates.
    pub position: BTreeMap<String, f64>,
    /// The ids of the messages, in order.
    pub messages: Vec<String>,
    /// The cells written, in order.
    pub tables: Vec<CellWritten>,
    /// The texts of the logs.
    pub logs: Vec<String>,
    /// What the cycle does with the spindle and the coolant, in order, in the words of the cases.
    pub spindle: Vec<String>,
    /// The movements and pauses of the cycle, in order; without it they are not compared.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub moves: Option<Vec<Moved>>,
}

/// A cell of a table that was written.
#[derive(Clone, Debug, Deserialize, Serialize)]
pub struct CellWritten {
    /// The table.
    pub file: String,
    /// The row.
    pub row: f64,
    /// The column.
    pub column: String,
    /// A number or a text.
    pub value: Value,
}

/// A movement or a pause.
#[derive(Clone, Debug, Default, Deserialize, Serialize)]
#[serde(default)]
pub struct Moved {
    /// `rapid`, `feed`, `arc`, `turn`, `dwell` or `probe`.
    pub verb: String,
    /// Where to, in program coordinates by letter; of a probing, the point touched.
    #[serde(skip_serializing_if = "BTreeMap::is_empty")]
    pub to: BTreeMap<String, f64>,
    /// The feed.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub feed: Option<f64>,
    /// The angle of an arc.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub angle: Option<f64>,
    /// The time of a pause.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub seconds: Option<f64>,
}

impl Request {
    /// The scene of a case as JSON, which is read as any scene file.
    pub(super) fn scene(node: Option<&Node>) -> Value {
        let mut scene = node.map_or(Value::Null, json);
        if !scene.is_object() {
            scene = Value::Object(Map::new());
        }
        if let Some(map) = scene.as_object_mut() {
            map.entry("scene").or_insert_with(|| 1.into());
        }
        scene
    }

    /// The tables of a scene as texts.
    pub(super) fn tables(scene: &Scene) -> BTreeMap<String, String> {
        let all = [&scene.tools, &scene.probes, &scene.presets].into_iter().chain(&scene.datums);
        all.map(|table| (table.file().to_owned(), table.to_text())).collect()
    }
}

/// A tree as JSON: what is a number without quotation marks is one.
fn json(node: &Node) -> Value {
    match &node.kind {
        Kind::Scalar(text, plain) => {
            let whole = text.parse::<i64>().ok().filter(|_| *plain).map(Value::from);
            let number = || text.parse::<f64>().ok().filter(|number| *plain && number.is_finite()).map(Value::from);
            whole.or_else(number).unwrap_or_else(|| Value::from(&**text))
        }
        Kind::List(items) => items.iter().map(json).collect(),
        Kind::Map(entries) => {
            Value::Object(entries.iter().map(|(key, node)| (key.text.to_string(), json(node))).collect())
        }
    }
}

/// Answers a line by the engine of this library.
pub fn serve(world: &World<'_>, line: &str) -> String {
    let answer = match serde_json::from_str::<Request>(line) {
        Ok(request) => answer(world, &request),
        Err(_) => refused(0, BAD_REQUEST),
    };
    serde_json::to_string(&answer).unwrap_or_default()
}

fn refused(id: u64, code: &str) -> Answer {
    Answer { id, end: Status::Error.as_str().to_owned(), errors: vec![code.to_owned()], ..Answer::default() }
}

fn answer(world: &World<'_>, request: &Request) -> Answer {
    let key = Keyword::by_word(&request.cycle.keyword).map(|keyword| CycleKey::new(keyword, request.cycle.number));
    let on = world.catalogue.on(&request.control);
    let language = world.locales.language(&request.language);
    let (Some(key), Some(on), Ok(language), true) = (key, on, language, request.format == PROTOCOL) else {
        return refused(request.id, BAD_REQUEST);
    };
    let scene = match Scene::parse(&Source::new("scene", request.scene.to_string()), world.files) {
        Ok(scene) => scene,
        Err(found) => return refused(request.id, found.first().map_or(BAD_REQUEST, |first| first.code)),
    };
    let texts = LogTexts::new(language, on.id(), world.files);
    let name = format!("{}.H", request.case.to_ascii_uppercase());
    let program = syntax::parse(&Source::new(name, request.program.as_str()));
    let called: Vec<_> =
        request.programs.iter().map(|(name, text)| Source::new(name.as_str(), text.as_str())).collect();
    let called = Called::new(&called);
    let mut events: Vec<Event> = Vec::new();
    let engine = Engine::new(&program, on, &scene, &texts).with_catalogue(world.catalogue).with_programs(&called);
    let outcome = engine.run(&mut |event| events.push(event));
    answer_of(request.id, key, &scene, &outcome, &events)
}

/// What was executed, as an answer.
fn answer_of(id: u64, key: CycleKey, scene: &Scene, outcome: &Outcome, events: &[Event]) -> Answer {
    let numbers = outcome.params.numbers().map(|(number, value)| (format!("Q{number}"), Value::from(value)));
    let texts = outcome.params.texts().map(|(number, text)| (format!("QS{number}"), Value::from(text)));
    let linear = Axis::ALL.map(|axis| (axis.letter().to_string(), axis.of(outcome.position)));
    let rotary = RotaryAxis::ALL.into_iter().filter(|axis| scene.machine.rotary(*axis).is_some());
    let rotary = rotary.map(|axis| (axis.letter().to_string(), axis.of(outcome.angles)));
    let mut answer = Answer {
        id,
        end: outcome.status.as_str().to_owned(),
        errors: outcome.fault.iter().map(|fault| fault.code.to_string()).collect(),
        q: numbers.chain(texts).collect(),
        position: linear.into_iter().chain(rotary).collect(),
        logs: outcome.logs.iter().map(|(_, text)| text).chain(&outcome.screens).cloned().collect(),
        ..Answer::default()
    };
    let mut moves = Vec::new();
    for event in events {
        match &event.kind {
            EventKind::Message { id, .. } => answer.messages.push(id.to_string()),
            EventKind::Table { file, row, column, value } => {
                let value = match value {
                    Content::Number(number) => Value::from(*number),
                    Content::Text(text) => Value::from(&**text),
                };
                answer.tables.push(CellWritten { file: file.clone(), row: *row, column: column.clone(), value });
            }
            kind if event.at.cycle.as_ref().is_some_and(|(own, _)| *own == key) => {
                moves.extend(moved(kind));
                answer.spindle.extend(spindle_words(kind));
            }
            _ => {}
        }
    }
    answer.moves = Some(moves);
    answer
}

fn by_letter(point: DVec3) -> BTreeMap<String, f64> {
    Axis::ALL.map(|axis| (axis.letter().to_string(), axis.of(point))).into_iter().collect()
}

fn moved(kind: &EventKind) -> Option<Moved> {
    let moved = |verb: &str, to| Moved { verb: verb.to_owned(), to, ..Moved::default() };
    Some(match kind {
        EventKind::Move { kind, to, feed, turned, .. } => {
            let to = OnDiameter::programmed(*turned, *to);
            let (verb, angle) = match kind {
                MoveKind::Rapid => ("rapid", None),
                MoveKind::Feed => ("feed", None),
                MoveKind::Arc { angle, .. } => ("arc", Some(*angle)),
            };
            Moved { feed: Some(*feed), angle, ..moved(verb, by_letter(to)) }
        }
        EventKind::Turn { axes, feed, .. } => {
            let to = axes.iter().map(|turned| (turned.axis.letter().to_string(), turned.to)).collect();
            Moved { feed: Some(*feed), ..moved("turn", to) }
        }
        EventKind::Dwell(seconds) => Moved { seconds: Some(*seconds), ..moved("dwell", BTreeMap::new()) },
        EventKind::Probe(probing) => {
            let to = probing.contact.map(|(touched, _)| by_letter(touched)).unwrap_or_default();
            Moved { feed: Some(probing.feed), ..moved("probe", to) }
        }
        _ => return None,
    })
}

impl Answer {
    /// What it reports, in the form in which outcomes are compared; a word that is wrong is named.
    pub(super) fn read(self, scene: &Scene) -> Result<ForeignOutcome, String> {
        let status = Status::by_word(&self.end).ok_or_else(|| format!("end: {}", self.end))?;
        let mut q = Vec::with_capacity(self.q.len());
        for (name, value) in &self.q {
            let target = QRef::parse(name).ok_or_else(|| format!("q: {name}"))?;
            q.push((target, content(value).ok_or_else(|| format!("q.{name}: {value}"))?));
        }
        let mut cells = Vec::with_capacity(self.tables.len());
        for cell in self.tables {
            let value = content(&cell.value).ok_or_else(|| format!("tables: {}", cell.value))?;
            cells.push((cell.file, cell.row, cell.column, value));
        }
        let plane = WorkingPlane::of_tool_axis(scene.machine.spindle);
        let mut actions = Vec::new();
        for moved in self.moves.iter().flatten() {
            actions.push(moved.event(plane).ok_or_else(|| format!("moves: {}", moved.verb))?);
        }
        for words in &self.spindle {
            actions.push(spindle(words).ok_or_else(|| format!("spindle: {words}"))?);
        }
        let error = (!self.errors.is_empty()).then(|| self.errors.join(", "));
        let (position, angles) = (linear(&self.position), rotary(&self.position));
        Ok(ForeignOutcome {
            status,
            error,
            q,
            position,
            angles,
            messages: self.messages,
            cells,
            logs: self.logs,
            actions,
        })
    }
}

fn spindle(words: &str) -> Option<EventKind> {
    let (word, number) = words.split_once(' ').unwrap_or((words, ""));
    let turns = |direction, speed, orient| EventKind::Spindle { tool: None, direction, speed, orient };
    match (word, number) {
        ("stop", "") => Some(turns(0, 0.0, None)),
        ("coolant", "on" | "off") => Some(EventKind::Coolant(number == "on")),
        ("orient", number) => Some(turns(0, 0.0, Some(number.parse().ok()?))),
        ("clockwise", number) => Some(turns(1, number.parse().ok()?, None)),
        ("counter-clockwise", number) => Some(turns(-1, number.parse().ok()?, None)),
        _ => None,
    }
}

fn content(value: &Value) -> Option<Content> {
    value.as_f64().map(Content::Number).or_else(|| value.as_str().map(|text| Content::Text(text.into())))
}

/// Coordinates by letter; one that is missing is none.
fn linear(by_letter: &BTreeMap<String, f64>) -> DVec3 {
    Axis::ALL.into_iter().fold(DVec3::NAN, |all, axis| {
        by_letter.get(&axis.letter().to_string()).map_or(all, |value| axis.with(all, *value))
    })
}

fn rotary(by_letter: &BTreeMap<String, f64>) -> DVec3 {
    RotaryAxis::ALL.into_iter().fold(DVec3::NAN, |all, axis| {
        by_letter.get(&axis.letter().to_string()).map_or(all, |value| axis.with(all, *value))
    })
}

impl Moved {
    fn event(&self, plane: WorkingPlane) -> Option<EventKind> {
        let (to, feed) = (linear(&self.to), self.feed.unwrap_or(f64::NAN));
        let straight = |kind| {
            let path = Path::line(DVec3::NAN, DVec3::NAN);
            EventKind::Move { kind, from: DVec3::NAN, to, machine: DVec3::NAN, feed, path, turned: None }
        };
        Some(match self.verb.as_str() {
            "rapid" => straight(MoveKind::Rapid),
            "feed" => straight(MoveKind::Feed),
            "arc" => {
                let angle = self.angle.unwrap_or(f64::NAN);
                straight(MoveKind::Arc { centre: DVec3::NAN, plane, angle, rise: f64::NAN, rapid: false })
            }
            "turn" => {
                let axes = RotaryAxis::ALL.into_iter().filter_map(|axis| {
                    let to = *self.to.get(&axis.letter().to_string())?;
                    Some(Turned { axis, from: f64::NAN, to, machine: f64::NAN })
                });
                EventKind::Turn { axes: axes.collect(), feed, rapid: false, together: false }
            }
            "dwell" => EventKind::Dwell(self.seconds?),
            "probe" => {
                let contact = (!self.to.is_empty()).then_some((to, DVec3::NAN));
                EventKind::Probe(Probing { from: DVec3::NAN, target: DVec3::NAN, contact, feed })
            }
            _ => return None,
        })
    }
}
