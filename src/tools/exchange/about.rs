//! What a translator is told about a text: what it is, unit and range, length and characters of labels, which cycles have
//! it, its page, and where the manuals describe it.
//!
//! A remark is a message of the program with its arguments; how it is shown is for `cli`.
use std::collections::{BTreeMap, BTreeSet, HashMap};

use crate::language::label::SIGNS;
use crate::language::locale::{Language, Locales};
use crate::language::text::{CycleText, Vocabulary};
use crate::spec::{self, Catalogue, Cycle, CycleKey, OnControl};

/// So many cycles of a control are named.
const NAMED: usize = 6;

/// Something said to a translator.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum Remark {
    /// A message of the program, with its arguments.
    Said(&'static str, Vec<(&'static str, String)>),
    /// The text is on the page of this cycle in the manual of this control.
    Cycle(String, CycleKey),
    /// The text is the page of this topic in the manual of this control.
    Topic(String, String),
}

/// What is said about all texts.
#[derive(Debug)]
pub struct About<'c> {
    catalogue: &'c Catalogue,
    /// The controls and cycles that need a message.
    uses: HashMap<String, BTreeMap<&'c str, Vec<CycleKey>>>,
    /// Units, and ranges with the controls that print them, of a parameter.
    values: HashMap<String, Values<'c>>,
    /// The greatest length of labels, prompts, and names of cycles, of those of the controls that have them, by key.
    most: HashMap<String, u32>,
}

#[derive(Debug, Default)]
struct Values<'c> {
    units: BTreeSet<String>,
    ranges: BTreeMap<String, BTreeSet<&'c str>>,
}

impl<'c> About<'c> {
    /// What the specifications say about the texts.
    pub fn new(catalogue: &'c Catalogue, locales: &Locales) -> Self {
        let mut about = Self { catalogue, uses: HashMap::new(), values: HashMap::new(), most: HashMap::new() };
        for on in catalogue.controls.values() {
            for cycle in on.cycles.values() {
                for text in spec::texts(cycle, on) {
                    let cycles = about.uses.entry(text.id).or_default().entry(on.id()).or_default();
                    if cycles.last() != Some(&cycle.key) {
                        cycles.push(cycle.key);
                    }
                }
                if let Some(source) = locales.source() {
                    about.parameters(on, cycle, source);
                }
            }
        }
        about
    }

    fn parameters(&mut self, on: &'c OnControl, cycle: &'c Cycle, source: &Language) {
        let vocabulary = Vocabulary::of(on, cycle, source);
        let text = CycleText::new(on, cycle, source, &vocabulary);
        let control = &on.control;
        if let Some(rules) = &control.cycle_name {
            self.limit(format!("cycle-{}.nc", cycle.name()), rules.max_length);
        }
        for param in &cycle.params {
            let id = format!("parameter-{}", param.is.as_str());
            if param.field.is_none() {
                self.limit(format!("{id}.label"), control.label.max_length);
            }
            if let Some(rules) = &control.prompt {
                // Where no other prompt is printed, it is the name with a sign behind it.
                let more = text.prompt_of(param).chars().count().saturating_sub(text.name_of(param).chars().count());
                if text.find(&format!("{id}.prompt")).is_none() {
                    self.limit(id.clone(), rules.max_length.saturating_sub(more as u32));
                }
            }
            let values = self.values.entry(id).or_default();
            values.units.extend(text.unit(param.quantity).map(|unit| unit.into_owned()));
            if let Some(range) = text.range(param) {
                values.ranges.entry(range).or_default().insert(on.control.title.as_str());
            }
        }
    }

    fn limit(&mut self, key: String, most: u32) {
        self.most.entry(key).and_modify(|known| *known = most.min(*known)).or_insert(most);
    }

    /// The greatest number of characters of a text, where there is one.
    pub fn most(&self, message: &str, key: &str) -> Option<u32> {
        let attribute = key.rsplit_once('.').map_or("", |(_, attribute)| attribute);
        let own = if attribute.is_empty() { message.to_owned() } else { format!("{message}.{attribute}") };
        self.most.get(&own).copied()
    }

    /// What is said about the text with this key of this message.
    pub fn of(&self, message: &str, key: &str) -> Vec<Remark> {
        let mut all = vec![Remark::Said("cli-texts-note-kind", vec![("kind", kind(message, key).to_owned())])];
        if let Some(values) = self.values.get(message) {
            for unit in &values.units {
                all.push(Remark::Said("cli-texts-note-unit", vec![("unit", unit.clone())]));
            }
            for (range, controls) in &values.ranges {
                let controls = controls.iter().copied().collect::<Vec<_>>().join(", ");
                let args = vec![("range", range.clone()), ("controls", controls)];
                all.push(Remark::Said("cli-texts-note-range", args));
            }
        }
        let is_printed = [".label", ".nc", ".word"].iter().any(|attribute| key.ends_with(attribute));
        match self.most(message, key).map(|most| ("most", most.to_string())) {
            Some(most) if is_printed => {
                all.push(Remark::Said("cli-texts-note-label", vec![most, ("signs", SIGNS.to_owned())]));
            }
            Some(most) => all.push(Remark::Said("cli-texts-note-length", vec![most])),
            None if is_printed => {
                all.push(Remark::Said("cli-texts-note-capitals", vec![("signs", SIGNS.to_owned())]));
            }
            None => {}
        }
        // A variant is for the cycle and the control that its key names.
        let whole = key.split('.').next().unwrap_or_default();
        let suffixes: Vec<&str> = whole.split("__").skip(1).collect();
        for (control, cycles) in self.uses.get(message).into_iter().flatten() {
            let Some(on) = self.catalogue.controls.get(*control) else { continue };
            let names_cycle = |suffix: &str| !self.catalogue.controls.contains_key(suffix);
            if suffixes.iter().any(|suffix| !names_cycle(suffix) && suffix != control) {
                continue;
            }
            let is_for = |key: &&CycleKey| {
                let name = on.outlines.get(*key).map_or("", |outline| outline.name.as_str());
                suffixes.iter().all(|suffix| !names_cycle(suffix) || *suffix == name)
            };
            let cycles: Vec<CycleKey> = cycles.iter().filter(is_for).copied().collect();
            if cycles.is_empty() {
                continue;
            }
            let names: Vec<String> = cycles.iter().take(NAMED).map(ToString::to_string).collect();
            let more = cycles.len().saturating_sub(NAMED);
            let more = if more == 0 { "none".to_owned() } else { more.to_string() };
            let title = on.control.title.clone();
            let args = vec![("control", title.clone()), ("cycles", names.join(", ")), ("more", more)];
            all.push(Remark::Said("cli-texts-note-cycles", args));
            let Some(cycle) = cycles.first().and_then(|key| on.cycles.get(key)) else { continue };
            let sources = cycle.described.sources.iter().map(|it| format!("{}:{}", it.manual, it.lines));
            let args = vec![
                ("control", title),
                ("cycle", cycle.key.to_string()),
                ("lines", sources.collect::<Vec<_>>().join("; ")),
            ];
            all.push(Remark::Said("cli-texts-note-lines", args));
            all.push(Remark::Cycle((*control).to_owned(), cycle.key));
        }
        if let Some(topic) = message.strip_prefix("topics/") {
            all.extend(self.of_topic(topic));
        }
        all
    }

    fn of_topic(&self, name: &str) -> Vec<Remark> {
        let mut all = Vec::new();
        for topic in self.catalogue.topics.iter().filter(|topic| topic.topic.as_str() == name) {
            for described in &topic.controls {
                let id = described.control.as_str();
                let Some(on) = self.catalogue.controls.get(id) else { continue };
                let lines = described.sources.iter().map(|it| format!("{}:{}", it.manual, it.lines));
                let args = vec![
                    ("control", on.control.title.clone()),
                    ("cycle", name.to_owned()),
                    ("lines", lines.collect::<Vec<_>>().join("; ")),
                ];
                all.push(Remark::Said("cli-texts-note-lines", args));
                all.push(Remark::Topic(id.to_owned(), name.to_owned()));
            }
        }
        all
    }
}

/// Kinds of messages by what their identifiers begin with; the first that fits counts.
const KINDS: [(&str, &str); 31] = [
    ("-", "inserted"),
    ("topics/", "topic"),
    ("cycle-group-", "group"),
    ("cycle-", "cycle"),
    ("parameter-", "parameter"),
    ("step-", "step"),
    ("say-", "step"),
    ("until-", "until"),
    ("condition-", "condition"),
    ("group-", "step"),
    ("choice-", "choice"),
    ("result-", "result"),
    ("note-", "note"),
    ("guard-", "guard"),
    ("message-", "message"),
    ("figure-", "figure"),
    ("form-", "form"),
    ("table-", "table"),
    ("title-", "title"),
    ("program-", "title"),
    ("comment-", "comment"),
    ("term-", "term"),
    ("log-", "log"),
    ("diag-", "diagnostic"),
    ("explain-", "explanation"),
    ("gap-", "gap"),
    ("cli-", "command"),
    ("unit-", "unit"),
    ("list-", "list"),
    ("site-", "page"),
    ("page-", "page"),
];

/// What a text is, in a word.
fn kind(message: &str, key: &str) -> &'static str {
    let attribute = key.rsplit_once('.').map(|(_, attribute)| attribute).filter(|_| !message.starts_with("topics/"));
    match attribute {
        Some("label") => "label",
        Some("nc") => "nc",
        Some("word") => "word",
        Some("help") => "help",
        Some("purpose") => "purpose",
        Some("definition") => "definition",
        Some("prompt") => "prompt",
        Some("symbol") => "symbol",
        _ => KINDS.iter().find(|(head, _)| message.starts_with(head)).map_or("other", |(_, kind)| kind),
    }
}
