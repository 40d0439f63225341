//! `ciklo.toml`: which control programs are for, and how bad each finding is.
//!
//! What is at the top is for all programs below the file's folder, `[[folder]]` for those that match its
//! `path`; what comes later wins. Invariant: a key, rule, control or severity that means nothing is an error
//! at its place; nothing is passed over.
use std::collections::BTreeMap;
use std::sync::Arc;

use toml::Spanned;
use toml::de::{DeTable, DeValue};

use super::allow::CODES;
use super::{Machine, RULES};
use crate::base::diag::{Diagnostic, Place, Severity, Source};
use crate::base::renamed;

/// The words for severities; `off` leaves the finding out.
const LEVELS: [(&str, Option<Severity>); 4] = [
    ("error", Some(Severity::Error)),
    ("warning", Some(Severity::Warning)),
    ("note", Some(Severity::Note)),
    ("off", None),
];

/// The word for all guards of the specifications.
const GUARD: &str = "guard";

/// What the file says.
#[derive(Clone, Debug, Default)]
pub struct Config {
    all: Settings,
    folders: Vec<(Vec<String>, Settings)>,
    /// Where each table is named.
    tables: BTreeMap<String, Place>,
}

/// What it says for one program.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Settings {
    /// The control.
    pub control: Option<String>,
    /// The language of the labels.
    pub language: Option<String>,
    /// The tables that its tools, presets and datums are in, as they are named.
    pub tables: Vec<String>,
    /// The least severe finding with which a check fails.
    pub fail_on: Option<Severity>,
    /// What the machine can do.
    pub machine: Machine,
    /// Severities by code; nothing for findings that are left out.
    pub rules: BTreeMap<String, Option<Severity>>,
}

/// Says whether a word is known.
pub type Known<'k> = &'k dyn Fn(&str) -> bool;

impl Config {
    /// Reads the file. `rules`, `controls` and `languages` say which words there are.
    ///
    /// # Errors
    /// Everything that is wrong with it.
    pub fn parse(
        source: &Arc<Source>,
        rules: Known<'_>,
        controls: Known<'_>,
        languages: Known<'_>,
    ) -> Result<Self, Vec<Diagnostic>> {
        let mut reader = Reader { source, rules, controls, languages, tables: BTreeMap::new(), found: Vec::new() };
        let mut config = Self::default();
        match DeTable::parse(source.text()) {
            Err(error) => {
                let span = error.span().unwrap_or(0..0);
                reader.found.push(Diagnostic::error("config-syntax", Place::new(source, span)));
            }
            Ok(table) => {
                config.all = reader.settings(table.get_ref(), &["folder"]);
                match table.get_ref().get("folder").map(|value| (value.get_ref(), value.span())) {
                    None => {}
                    Some((DeValue::Array(folders), _)) => {
                        config.folders.extend(folders.iter().filter_map(|folder| reader.folder(folder)));
                    }
                    Some((_, span)) => reader.wrong("config-value", span, "folder", "[[folder]]"),
                }
            }
        }
        config.tables = reader.tables;
        if reader.found.is_empty() { Ok(config) } else { Err(reader.found) }
    }

    /// Where a table is named first.
    pub fn table(&self, name: &str) -> Option<&Place> {
        self.tables.get(name)
    }

    /// What is said for a program; its path has `/` and begins in the folder of the file.
    pub fn of(&self, path: &str) -> Settings {
        let path: Vec<&str> = path.split('/').filter(|part| !matches!(*part, "" | ".")).collect();
        let mut settings = self.all.clone();
        for (_, own) in self.folders.iter().filter(|(pattern, _)| matches(pattern, &path)) {
            settings.control = own.control.clone().or(settings.control);
            settings.language = own.language.clone().or(settings.language);
            settings.fail_on = own.fail_on.or(settings.fail_on);
            if !own.tables.is_empty() {
                settings.tables.clone_from(&own.tables);
            }
            settings.machine.overlay(&own.machine);
            settings.rules.extend(own.rules.clone());
        }
        settings
    }
}

impl Settings {
    /// Gives findings the severities that are asked for and leaves out those that are off.
    pub fn apply(&self, found: &mut Vec<Diagnostic>) {
        // The guards of the specifications have codes of their own, and one word for them all.
        let guard = |code: &str| {
            let own = RULES.iter().map(|rule| rule.code).chain(CODES).any(|own| own == code);
            if own || code.starts_with("syntax-") { None } else { self.rules.get(GUARD) }
        };
        found.retain_mut(|diagnostic| match self.rules.get(diagnostic.code).or_else(|| guard(diagnostic.code)) {
            Some(None) => false,
            Some(Some(severity)) => {
                diagnostic.severity = *severity;
                true
            }
            None => true,
        });
    }
}

struct Reader<'r> {
    source: &'r Arc<Source>,
    rules: Known<'r>,
    controls: Known<'r>,
    languages: Known<'r>,
    tables: BTreeMap<String, Place>,
    found: Vec<Diagnostic>,
}

impl Reader<'_> {
    fn wrong(&mut self, code: &'static str, span: std::ops::Range<usize>, key: &str, expected: &str) {
        let place = Place::new(self.source, span);
        self.found.push(Diagnostic::error(code, place).arg("key", key).arg("expected", expected));
    }

    fn settings(&mut self, table: &DeTable<'_>, others: &[&str]) -> Settings {
        let mut settings = Settings::default();
        for (key, value) in table {
            let name = key.get_ref().as_ref();
            match name {
                "control" => settings.control = self.word(name, value, self.controls),
                "fail-on" => {
                    settings.fail_on = self
                        .word(name, value, &|word| Severity::from_word(word).is_some())
                        .and_then(|word| Severity::from_word(&word));
                }
                "lang" => settings.language = self.word(name, value, self.languages),
                "tables" => match value.get_ref() {
                    DeValue::Array(names) => {
                        for value in names.iter() {
                            let Some(table) = self.word("tables", value, &|_| true) else { continue };
                            let place = Place::new(self.source, value.span());
                            self.tables.entry(table.clone()).or_insert(place);
                            settings.tables.push(table);
                        }
                    }
                    _ => self.wrong("config-value", value.span(), name, "tables = [\"…\"]"),
                },
                "machine" => match value.get_ref() {
                    DeValue::Table(machine) => settings.machine = self.machine(machine),
                    _ => self.wrong("config-value", value.span(), name, "[machine]"),
                },
                "rules" => match value.get_ref() {
                    DeValue::Table(rules) => self.levels(rules, &mut settings),
                    _ => self.wrong("config-value", value.span(), name, "[rules]"),
                },
                name if others.contains(&name) => {}
                name => self.wrong("config-unknown-key", key.span(), name, ""),
            }
        }
        settings
    }

    fn machine(&mut self, table: &DeTable<'_>) -> Machine {
        let mut machine = Machine::default();
        for (key, value) in table {
            let name = key.get_ref().as_ref();
            match name {
                "speed" => machine.speed = self.positive(name, value),
                "feed" => machine.feed = self.positive(name, value),
                "helix" => machine.helix = self.positive(name, value),
                "travel" => match value.get_ref() {
                    DeValue::Table(axes) => {
                        for (axis, ends) in axes {
                            self.travel(axis, ends, &mut machine);
                        }
                    }
                    _ => self.wrong("config-value", value.span(), name, "[machine.travel]"),
                },
                name => self.wrong("config-unknown-machine", key.span(), name, "speed, feed, helix, travel"),
            }
        }
        machine
    }

    /// The ends of an axis.
    fn travel(
        &mut self,
        key: &Spanned<std::borrow::Cow<'_, str>>,
        value: &Spanned<DeValue<'_>>,
        machine: &mut Machine,
    ) {
        let axis = key.get_ref().as_ref();
        if !Machine::AXES.contains(&axis) {
            return self.wrong("config-unknown-machine", key.span(), axis, &Machine::AXES.join(", "));
        }
        let ends = match value.get_ref() {
            DeValue::Array(ends) => ends.iter().map(|end| number(end.get_ref())).collect::<Option<Vec<_>>>(),
            _ => None,
        };
        match ends.as_deref() {
            Some([low, high]) if low < high => {
                machine.travel.insert(axis.to_owned(), [*low, *high]);
            }
            _ => self.wrong("config-value", value.span(), axis, &format!("{axis} = [-100, 500]")),
        }
    }

    /// A number above 0.
    fn positive(&mut self, key: &str, value: &Spanned<DeValue<'_>>) -> Option<f64> {
        let found = number(value.get_ref()).filter(|number| *number > 0.0);
        if found.is_none() {
            self.wrong("config-value", value.span(), key, &format!("{key} = 5000"));
        }
        found
    }

    fn levels(&mut self, rules: &DeTable<'_>, settings: &mut Settings) {
        for (key, value) in rules {
            let code = renamed::present(key.get_ref());
            let level = value.get_ref().as_str().and_then(|word| LEVELS.iter().find(|(own, _)| *own == word));
            if !(self.rules)(code) {
                self.wrong("config-unknown-rule", key.span(), code, "");
            }
            match level {
                Some((_, severity)) => {
                    settings.rules.insert(code.to_owned(), *severity);
                }
                None => self.wrong("config-value", value.span(), code, &LEVELS.map(|(word, _)| word).join(", ")),
            }
        }
    }

    fn word(&mut self, key: &str, value: &Spanned<DeValue<'_>>, known: Known<'_>) -> Option<String> {
        match value.get_ref().as_str() {
            Some(word) if known(word) => Some(word.to_owned()),
            _ => {
                self.wrong(
                    "config-unknown-word",
                    value.span(),
                    key,
                    self.source.text().get(value.span()).unwrap_or(""),
                );
                None
            }
        }
    }

    fn folder(&mut self, folder: &Spanned<DeValue<'_>>) -> Option<(Vec<String>, Settings)> {
        let DeValue::Table(table) = folder.get_ref() else {
            self.wrong("config-value", folder.span(), "folder", "[[folder]]");
            return None;
        };
        let settings = self.settings(table, &["path"]);
        let Some(path) = table.get("path").and_then(|value| value.get_ref().as_str()) else {
            self.wrong("config-value", folder.span(), "path", "path = \"…\"");
            return None;
        };
        Some((path.split('/').filter(|part| !matches!(*part, "" | ".")).map(str::to_owned).collect(), settings))
    }
}

/// A number, whole or not.
fn number(value: &DeValue<'_>) -> Option<f64> {
    match value {
        DeValue::Integer(own) => own.to_string().parse().ok(),
        DeValue::Float(own) => own.to_string().parse().ok().filter(|number: &f64| number.is_finite()),
        _ => None,
    }
}

/// Whether a pattern means a path or a folder above it: `*` and `?` stay in a part, `**` is any number of parts.
fn matches(pattern: &[String], path: &[&str]) -> bool {
    match (pattern.split_first(), path.split_first()) {
        (None, _) => true,
        (Some((first, rest)), _) if first == "**" => {
            (0..=path.len()).any(|from| path.get(from..).is_some_and(|path| matches(rest, path)))
        }
        (Some((first, rest)), Some((part, after))) => fits(first.as_bytes(), part.as_bytes()) && matches(rest, after),
        (Some(_), None) => false,
    }
}

fn fits(pattern: &[u8], text: &[u8]) -> bool {
    let (mut at, mut from) = (0, 0);
    // The last star, and how far the text went when it was met.
    let mut star: Option<(usize, usize)> = None;
    while from < text.len() {
        match pattern.get(at) {
            Some(b'*') => {
                star = Some((at, from));
                at += 1;
            }
            Some(sign) if *sign == b'?' || text.get(from) == Some(sign) => {
                at += 1;
                from += 1;
            }
            _ => match star {
                Some((place, met)) => {
                    star = Some((place, met + 1));
                    (at, from) = (place + 1, met + 1);
                }
                None => return false,
            },
        }
    }
    pattern.iter().skip(at).all(|sign| *sign == b'*')
}
