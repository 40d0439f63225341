//! What a case expects: read from its tree with every mistake at its place, compared with what came out.
//!
//! Invariant: an unknown key is a mistake, so that nothing is believed to be checked that is not.
use std::sync::Arc;

use super::part::Part;
use super::report::Mismatch;
use super::show;
use crate::base::diag::{Diagnostic, Place, Source};
use crate::base::expr::{QKind, QRef};
use crate::engine::geometry::{Axis, RotaryAxis};
use crate::engine::run::{Content, Event, EventKind, MoveKind, OnDiameter, Outcome, Status};
use crate::spec::{CycleKey, Kind, Node};

/// How far numbers may differ where a case does not say.
const WITHIN: f64 = 1e-6;

/// A value that a case expects.
#[derive(Clone, Debug, PartialEq)]
enum Wanted {
    Number(f64),
    Text(String),
}

/// A cell of a table.
#[derive(Clone, Debug)]
struct CellWanted {
    file: String,
    row: f64,
    column: String,
    value: Wanted,
}

/// An axis of a position.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Letter {
    Linear(Axis),
    Rotary(RotaryAxis),
}

impl Letter {
    /// The coordinate in a position: the tool tip and the rotary axes.
    fn of(self, tip: glam::DVec3, angles: glam::DVec3) -> f64 {
        match self {
            Self::Linear(axis) => axis.of(tip),
            Self::Rotary(axis) => axis.of(angles),
        }
    }

    pub(super) const fn letter(self) -> char {
        match self {
            Self::Linear(axis) => axis.letter(),
            Self::Rotary(axis) => axis.letter(),
        }
    }
}

/// A movement or pause of the cycle: its verb, its coordinates and its other values.
#[derive(Clone, Debug)]
pub(super) struct Action {
    pub(super) verb: String,
    pub(super) coords: Vec<(Letter, f64)>,
    pub(super) amount: Option<f64>,
    pub(super) feed: Option<f64>,
}

/// What a case expects.
#[derive(Clone, Debug)]
pub(super) struct Expectation {
    within: f64,
    q: Vec<(QRef, Wanted)>,
    position: Vec<(Letter, f64)>,
    errors: Option<Vec<String>>,
    messages: Option<Vec<String>>,
    end: Option<Status>,
    table: Vec<CellWanted>,
    log: Vec<String>,
    /// Movements: all of them, those at the beginning, those at the end.
    actions: [Option<Vec<Action>>; 3],
    spindle: Option<Vec<String>>,
    /// What is left of the blank.
    pub(super) part: Option<Part>,
}

/// The keys of movements: all, the first ones, the last ones.
const MOVES: [&str; 3] = ["moves", "first_moves", "last_moves"];
const KEYS: &[&str] = &[
    "q", "position", "errors", "messages", "end", "table", "log", MOVES[0], MOVES[1], MOVES[2], "spindle", "within",
    "part",
];

pub(super) struct Reader<'r> {
    source: &'r Arc<Source>,
    found: Vec<Diagnostic>,
}

impl Reader<'_> {
    fn place(&self, node: &Node) -> Place {
        Place::new(self.source, node.span)
    }

    pub(super) fn expected(&mut self, node: &Node, expected: &'static str) {
        let shown = node.shown(self.source);
        let diagnostic = Diagnostic::error("spec-expected", self.place(node));
        self.found.push(diagnostic.arg("expected", expected).arg("found", shown));
    }

    pub(super) fn entries<'n>(&mut self, node: &'n Node, known: Option<&[&str]>) -> Vec<(&'n str, &'n Node)> {
        let Kind::Map(entries) = &node.kind else {
            self.expected(node, "mapping");
            return Vec::new();
        };
        for (key, _) in entries {
            if known.is_some_and(|known| !known.contains(&&*key.text)) {
                let place = Place::new(self.source, key.span);
                let all = known.unwrap_or_default().join(", ");
                let diagnostic = Diagnostic::error("spec-unknown-key", place);
                self.found.push(diagnostic.arg("key", &*key.text).arg("known", all));
            }
        }
        entries.iter().map(|(key, node)| (&*key.text, node)).collect()
    }

    pub(super) fn items<'n>(&mut self, node: &'n Node) -> &'n [Node] {
        if !matches!(node.kind, Kind::List(_)) {
            self.expected(node, "list");
        }
        node.items()
    }

    pub(super) fn number(&mut self, node: &Node) -> Option<f64> {
        let number = node.text().and_then(|text| text.parse::<f64>().ok()).filter(|number| number.is_finite());
        if number.is_none() {
            self.expected(node, "number");
        }
        number
    }

    fn text(&mut self, node: &Node) -> Option<String> {
        if node.text().is_none() {
            self.expected(node, "text");
        }
        node.text().map(str::to_owned)
    }

    fn texts(&mut self, node: &Node) -> Vec<String> {
        self.items(node).iter().filter_map(|item| self.text(item)).collect()
    }

    fn wanted(&mut self, node: &Node) -> Option<Wanted> {
        let text = node.text();
        if text.is_none() {
            self.expected(node, "number");
        }
        text.map(|text| text.parse().map_or_else(|_| Wanted::Text(text.to_owned()), Wanted::Number))
    }

    fn axis(&mut self, key: &str, node: &Node) -> Option<(Letter, f64)> {
        let mut letters = key.chars();
        let rotary = |letter| RotaryAxis::from_letter(letter).map(Letter::Rotary);
        let known = |letter| Axis::from_letter(letter).map(Letter::Linear).or_else(|| rotary(letter));
        let axis = letters.next().and_then(known).filter(|_| letters.next().is_none());
        if axis.is_none() {
            self.expected(node, "axis");
        }
        Some((axis?, self.number(node)?))
    }

    fn coords(&mut self, node: &Node) -> Vec<(Letter, f64)> {
        self.entries(node, None).into_iter().filter_map(|(key, value)| self.axis(key, value)).collect()
    }

    fn cell(&mut self, node: &Node) -> Option<CellWanted> {
        self.entries(node, Some(&["file", "row", "column", "value"]));
        let get = |key: &'static str| node.get(key);
        let [Some(file), Some(row), Some(column), Some(value)] = ["file", "row", "column", "value"].map(get) else {
            self.expected(node, "cell");
            return None;
        };
        let (file, row) = (self.text(file)?, self.number(row)?);
        Some(CellWanted { file, row, column: self.text(column)?, value: self.wanted(value)? })
    }

    /// `{rapid: {Z: 2}}`, `{feed: {Z: -5}, at: 150}`, `{arc: {X: 1, Y: 2}, angle: 60}`, `{dwell: 0.5}`, `{probe: {X:
    /// 1}}`,
    /// `{turn: {C: 30}}`.
    fn action(&mut self, node: &Node) -> Option<Action> {
        const VERBS: [&str; 6] = ["rapid", "feed", "arc", "turn", "dwell", "probe"];
        self.entries(node, Some(&["rapid", "feed", "arc", "turn", "dwell", "probe", "at", "angle"]));
        let Some((verb, value)) = VERBS.into_iter().find_map(|verb| node.get(verb).map(|value| (verb, value))) else {
            self.expected(node, "action");
            return None;
        };
        let feed = match node.get("at") {
            Some(feed) => Some(self.number(feed)?),
            None => None,
        };
        let (mut coords, mut amount) = (Vec::new(), None);
        if verb == "dwell" {
            amount = Some(self.number(value)?);
        } else {
            coords = self.coords(value);
        }
        if let Some(angle) = node.get("angle") {
            amount = Some(self.number(angle)?);
        }
        Some(Action { verb: verb.to_owned(), coords, amount, feed })
    }
}

impl Expectation {
    /// Reads the tree of `expect`.
    pub(super) fn read(node: &Node, source: &Arc<Source>) -> Result<Self, Vec<Diagnostic>> {
        let mut r = Reader { source, found: Vec::new() };
        r.entries(node, Some(KEYS));
        let within = node.get("within").map_or(Some(WITHIN), |node| r.number(node)).unwrap_or(WITHIN);
        let mut q = Vec::new();
        if let Some(node) = node.get("q") {
            for (key, value) in r.entries(node, None) {
                match QRef::parse(key) {
                    Some(target) => q.extend(r.wanted(value).map(|wanted| (target, wanted))),
                    None => r.expected(value, "q-parameter"),
                }
            }
        }
        let position = node.get("position").map_or_else(Vec::new, |node| r.coords(node));
        let errors = node.get("errors").map(|node| r.texts(node));
        let messages = node.get("messages").map(|node| r.texts(node));
        let mut end = None;
        if let Some(node) = node.get("end") {
            end = node.text().and_then(Status::by_word);
            if end.is_none() {
                r.expected(node, "end-word");
            }
        }
        let mut table = Vec::new();
        if let Some(node) = node.get("table") {
            table = r.items(node).iter().filter_map(|item| r.cell(item)).collect();
        }
        let log = node.get("log").map_or_else(Vec::new, |node| r.texts(node));
        let spindle = node.get("spindle").map(|node| r.texts(node));
        let actions = MOVES.map(|key| {
            let listed = node.get(key);
            listed.map(|node| r.items(node).iter().filter_map(|item| r.action(item)).collect())
        });
        let part = node.get("part").map(|node| Part::read(node, &mut r));
        if r.found.is_empty() {
            Ok(Self { within, q, position, errors, messages, end, table, log, actions, spindle, part })
        } else {
            Err(r.found)
        }
    }

    /// The same without movements, for engines that do not report them.
    pub(super) fn without_moves(&self) -> Self {
        Self { actions: MOVES.map(|_| None), ..self.clone() }
    }

    /// Whether the case expects that the engine refuses it.
    pub(super) fn wants_refusal(&self) -> bool {
        self.end == Some(Status::Unsupported)
    }

    /// What differs. Movements are those of the cycle of the case.
    pub(super) fn compare(&self, key: CycleKey, outcome: &Outcome, events: &[Event]) -> Vec<Mismatch> {
        let mut differs = Vec::new();
        if let Some(end) = self.end.filter(|end| *end != outcome.status) {
            differs.push(Mismatch::new("end", end.as_str(), outcome.status.as_str()));
        }
        let codes: Vec<&str> = outcome.fault.iter().map(|fault| &*fault.code).collect();
        let none = Vec::new();
        let errors = self.errors.as_ref().unwrap_or(&none);
        if errors != &codes {
            let found = outcome.fault.as_ref().map_or_else(show::nothing, show::fault);
            differs.push(Mismatch::new("errors", show::list(errors), found));
        }
        self.compare_messages(events, &mut differs);
        for (q, wanted) in &self.q {
            self.compare_value(&format!("q.{q}"), wanted, outcome.params.get(*q).as_ref(), &mut differs);
            if q.kind == QKind::Ql {
                differs.push(Mismatch::new(format!("q.{q}"), "a global parameter", "a local one"));
            }
        }
        for (axis, wanted) in &self.position {
            let found = axis.of(outcome.position, outcome.angles);
            if !self.near(*wanted, found) {
                let what = format!("position.{}", axis.letter());
                differs.push(Mismatch::new(what, wanted, show::number(found)));
            }
        }
        self.compare_tables(events, &mut differs);
        for piece in &self.log {
            let all: Vec<&String> = outcome.logs.iter().map(|(_, text)| text).chain(&outcome.screens).collect();
            if !all.iter().any(|text| text.contains(piece.as_str())) {
                let all: Vec<&str> = all.into_iter().map(String::as_str).collect();
                differs.push(Mismatch::new("log", piece, all.join("\n")));
            }
        }
        self.compare_actions(key, events, &mut differs);
        self.compare_spindle(key, events, &mut differs);
        differs
    }

    fn near(&self, a: f64, b: f64) -> bool {
        (a - b).abs() <= self.within
    }

    fn compare_value(&self, what: &str, wanted: &Wanted, found: Option<&Content>, differs: &mut Vec<Mismatch>) {
        let (same, shown) = match (wanted, found) {
            (Wanted::Number(a), Some(Content::Number(b))) => (self.near(*a, *b), b.to_string()),
            (Wanted::Text(a), Some(Content::Text(b))) => (**a == **b, b.to_string()),
            (Wanted::Number(a), Some(Content::Text(b))) => (a.to_string() == **b, b.to_string()),
            (_, Some(Content::Number(b))) => (false, b.to_string()),
            (_, None) => (false, show::nothing()),
        };
        if !same {
            let expected = match wanted {
                Wanted::Number(number) => number.to_string(),
                Wanted::Text(text) => text.clone(),
            };
            differs.push(Mismatch::new(what, expected, shown));
        }
    }

    fn compare_messages(&self, events: &[Event], differs: &mut Vec<Mismatch>) {
        let Some(messages) = &self.messages else { return };
        let found: Vec<&str> = events
            .iter()
            .filter_map(|event| match &event.kind {
                EventKind::Message { id, .. } => Some(&**id),
                _ => None,
            })
            .collect();
        if messages != &found {
            differs.push(Mismatch::new("messages", show::list(messages), show::list(&found)));
        }
    }

    fn compare_tables(&self, events: &[Event], differs: &mut Vec<Mismatch>) {
        for cell in &self.table {
            let last = events.iter().rev().find_map(|event| match &event.kind {
                EventKind::Table { file, row, column, value }
                    if *file == cell.file && *row == cell.row && *column == cell.column =>
                {
                    Some(value)
                }
                _ => None,
            });
            let what = format!("table.{}.{}.{}", cell.file, cell.row, cell.column);
            self.compare_value(&what, &cell.value, last, differs);
        }
    }

    fn compare_actions(&self, key: CycleKey, events: &[Event], differs: &mut Vec<Mismatch>) {
        let found: Vec<&EventKind> = of_cycle(key, events).filter(|kind| verb(kind).is_some()).collect();
        for (what, wanted) in MOVES.iter().zip(&self.actions) {
            let Some(wanted) = wanted else { continue };
            let skipped = if *what == MOVES[2] { found.len().saturating_sub(wanted.len()) } else { 0 };
            let found = found.get(skipped..).unwrap_or_default();
            let whole = *what == MOVES[0];
            let several = if whole { wanted.len() != found.len() } else { wanted.len() > found.len() };
            let pairs = wanted.len().max(if whole { found.len() } else { 0 });
            let differing = (0..pairs).filter(|index| match (wanted.get(*index), found.get(*index)) {
                (Some(action), Some(kind)) => !self.same(action, kind),
                _ => true,
            });
            // After the first difference of lists that are not equally long everything may be shifted.
            for index in differing.take(if several { 1 } else { pairs }) {
                let expected = wanted.get(index).map_or_else(show::nothing, show::action);
                let found = found.get(index).map_or_else(show::nothing, |kind| show::event(kind));
                differs.push(Mismatch::new(format!("{what}.{}", index + 1), expected, found));
            }
            if several {
                let expected: Vec<String> = wanted.iter().map(show::action).collect();
                let found: Vec<String> = found.iter().map(|kind| show::event(kind)).collect();
                differs.push(Mismatch::new(*what, show::lines(&expected), show::lines(&found)));
            }
        }
    }

    fn compare_spindle(&self, key: CycleKey, events: &[Event], differs: &mut Vec<Mismatch>) {
        let Some(wanted) = &self.spindle else { return };
        let found: Vec<String> = of_cycle(key, events).filter_map(spindle_words).collect();
        if *wanted != found {
            differs.push(Mismatch::new("spindle", show::list(wanted), show::list(&found)));
        }
    }

    fn same(&self, action: &Action, kind: &EventKind) -> bool {
        let near = |tip, angles| action.coords.iter().all(|(axis, value)| self.near(*value, axis.of(tip, angles)));
        let at = |point: glam::DVec3| near(point, glam::DVec3::NAN);
        let amount = |found: f64| action.amount.is_none_or(|wanted| self.near(wanted, found));
        let feed_is = |found: f64| action.feed.is_none_or(|wanted| self.near(wanted, found));
        verb(kind) == Some(action.verb.as_str())
            && match kind {
                EventKind::Move { kind: MoveKind::Arc { angle, .. }, to, feed, turned, .. } => {
                    at(OnDiameter::programmed(*turned, *to)) && amount(*angle) && feed_is(*feed)
                }
                EventKind::Move { to, feed, turned, .. } => at(OnDiameter::programmed(*turned, *to)) && feed_is(*feed),
                EventKind::Turn { axes, feed, .. } => {
                    let turned = axes.iter().fold(glam::DVec3::NAN, |all, axis| axis.axis.with(all, axis.to));
                    near(glam::DVec3::NAN, turned) && feed_is(*feed)
                }
                EventKind::Dwell(seconds) => amount(*seconds),
                EventKind::Probe(probing) => probing.contact.is_some_and(|(touched, _)| at(touched)),
                _ => false,
            }
    }
}

/// What the cycle of the case did, in order.
fn of_cycle(key: CycleKey, events: &[Event]) -> impl Iterator<Item = &EventKind> {
    let own = move |event: &&Event| event.at.cycle.as_ref().is_some_and(|(found, _)| *found == key);
    events.iter().filter(own).map(|event| &event.kind)
}

/// What cases call something that is done with the spindle or the coolant.
pub(super) fn spindle_words(kind: &EventKind) -> Option<String> {
    match kind {
        EventKind::Spindle { orient: Some(angle), .. } => Some(format!("orient {angle}")),
        EventKind::Spindle { direction: 0, .. } => Some("stop".to_owned()),
        EventKind::Spindle { direction, speed, .. } => {
            let sense = if *direction > 0 { "clockwise" } else { "counter-clockwise" };
            Some(format!("{sense} {speed}"))
        }
        EventKind::Coolant(on) => Some(if *on { "coolant on" } else { "coolant off" }.to_owned()),
        _ => None,
    }
}

/// The verb of an event that cases list.
pub(super) const fn verb(kind: &EventKind) -> Option<&'static str> {
    match kind {
        EventKind::Move { kind: MoveKind::Rapid, .. } => Some("rapid"),
        EventKind::Move { kind: MoveKind::Feed, .. } => Some("feed"),
        EventKind::Move { kind: MoveKind::Arc { .. }, .. } => Some("arc"),
        EventKind::Turn { .. } => Some("turn"),
        EventKind::Dwell(_) => Some("dwell"),
        EventKind::Probe(_) => Some("probe"),
        _ => None,
    }
}
