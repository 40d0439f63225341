//! `ciklo texts export`: the texts of a language as a file for translators.
use std::collections::{BTreeSet, HashMap};
use std::path::Path;

use clap::ArgMatches;

use super::shared::{Texts, language};
use crate::base::diag::Diagnostic;
use crate::cli::session::Session;
use crate::cli::{Failure, Outcome, arguments, conform};
use crate::language::locale::{Args, SOURCE_LANGUAGE};
use crate::output::manual;
use crate::spec;
use crate::system;
use crate::tools::conform::Selection;
use crate::tools::exchange::{self, About, Form, Remark, State, Unit};

pub(super) fn run(session: &mut Session, matches: &ArgMatches) -> Result<Outcome, Failure> {
    let texts = Texts::of(&session.files()?);
    let (text, count) = match arguments::chosen_format(matches) {
        "tmx" => memory(&texts, matches)?,
        word @ ("tbx" | "csv") => terms(session, &texts, matches, word)?,
        "xliff2" => units(session, &texts, matches, Form::Xliff2)?,
        "po" => units(session, &texts, matches, Form::Po)?,
        _ => units(session, &texts, matches, Form::Xliff)?,
    };
    match matches.get_one::<String>("out") {
        Some(path) => {
            system::write(Path::new(path), text.as_bytes())?;
            let line = session.ui.text("cli-written", &Args::new().text("path", path.as_str()));
            session.output.remark(&line);
        }
        None => session.output.print(&text)?,
    }
    let line = session.ui.text("cli-texts-exported", &Args::new().number("count", count as f64));
    session.output.remark(&line);
    Ok(Outcome::Clean)
}

/// The texts of a language for translators.
fn units(session: &Session, texts: &Texts, matches: &ArgMatches, form: Form) -> Result<(String, usize), Failure> {
    let tag = language(&arguments::text(matches, "to"))?;
    let mut units = exchange::units(&texts.locales, &texts.meanings, &tag)?;
    let (stale, missing) = (matches.get_flag("stale"), matches.get_flag("missing"));
    let chosen = Chosen::of(texts, matches)?;
    units.retain(|unit: &Unit| {
        let is_open = match unit.state {
            Some(State::Missing) => missing,
            Some(_) => stale,
            None => false,
        };
        (is_open || !stale && !missing) && chosen.has(unit)
    });
    let mut teller = Teller::new(session, matches, texts, &tag);
    for unit in &mut units {
        unit.most = teller.about.most(&unit.message, &unit.key);
        let lines = teller.tell(&unit.message, &unit.key);
        unit.notes.extend(lines);
        if matches.get_flag("copy-source") && unit.target.is_empty() {
            unit.target.clone_from(&unit.source);
        }
    }
    Ok((exchange::write(&units, &tag, form), units.len()))
}

/// What is accepted, of one language or all.
fn memory(texts: &Texts, matches: &ArgMatches) -> Result<(String, usize), Failure> {
    let mut entries = exchange::entries(&texts.locales, &texts.meanings, &languages(texts, matches)?)?;
    let chosen = Chosen::of(texts, matches)?;
    entries.retain(|entry| chosen.has(&entry.unit));
    Ok((exchange::tmx(&entries), entries.len()))
}

/// Glossary and dictionary of parameters, in one language and English or in all.
fn terms(session: &Session, texts: &Texts, matches: &ArgMatches, form: &str) -> Result<(String, usize), Failure> {
    let tags = languages(texts, matches)?;
    let mut concepts = exchange::concepts(&texts.locales, &tags);
    let first = tags.first().map_or(SOURCE_LANGUAGE, String::as_str);
    let mut teller = Teller::new(session, matches, texts, first);
    for concept in &mut concepts {
        concept.context = teller.tell(&concept.id, &concept.id);
    }
    let text = if form == "tbx" { exchange::tbx(&concepts) } else { exchange::csv(&concepts) };
    Ok((text, concepts.len()))
}

/// The language of `--to`, or all translations.
fn languages(texts: &Texts, matches: &ArgMatches) -> Result<Vec<String>, Failure> {
    let to = matches.get_one::<String>("to").map(|tag| language(tag)).transpose()?;
    texts.chosen(&to.into_iter().collect::<Vec<_>>())
}

/// The texts that are asked for: of files, of cycles and of pages.
struct Chosen {
    files: Vec<String>,
    /// Messages and pages; nothing if all are asked for.
    used: Option<BTreeSet<String>>,
    /// Names of cycles that are not asked for: no variant for them is.
    others: BTreeSet<String>,
}

impl Chosen {
    fn of(texts: &Texts, matches: &ArgMatches) -> Result<Self, Failure> {
        let cycles = arguments::all(matches, "cycle");
        let topics = topics(texts, &arguments::all(matches, "topic"))?;
        let (mut all, others) = if cycles.is_empty() { Default::default() } else { used(texts, &cycles)? };
        let used = !cycles.is_empty() || !topics.is_empty();
        all.extend(topics);
        Ok(Self { files: arguments::all(matches, "file"), used: used.then_some(all), others })
    }

    fn has(&self, unit: &Unit) -> bool {
        (self.files.is_empty() || self.files.contains(&unit.file))
            && self.used.as_ref().is_none_or(|used| used.contains(&unit.message))
            && !suffixes(&unit.key).any(|suffix| self.others.contains(suffix))
    }
}

/// Puts into words what translators are told.
struct Teller<'t> {
    session: &'t Session<'t>,
    about: About<'t>,
    tag: &'t str,
    base: &'t str,
    known: HashMap<Remark, String>,
}

impl<'t> Teller<'t> {
    fn new(session: &'t Session<'_>, matches: &'t ArgMatches, texts: &'t Texts, tag: &'t str) -> Self {
        let about = About::new(&texts.catalogue, &texts.locales);
        let base = matches.get_one::<String>("base-url").map_or("", |url| url.trim_end_matches('/'));
        Self { session, about, tag, base, known: HashMap::new() }
    }

    /// The lines about a text.
    fn tell(&mut self, message: &str, key: &str) -> Vec<String> {
        let (ui, tag, base) = (self.session.ui, self.tag, self.base);
        let address = |path: String| if base.is_empty() { path } else { format!("{base}/{path}") };
        let line = |remark: &Remark| {
            let page = match remark {
                Remark::Said(text, args) => {
                    let args = args.iter().fold(Args::new(), |all, (name, value)| all.text(name, value.as_str()));
                    return ui.text(text, &args);
                }
                Remark::Cycle(control, key) => manual::path_of_cycle(control, tag, *key),
                Remark::Topic(control, topic) => manual::path_of_topic(control, tag, topic),
            };
            ui.text("cli-texts-note-page", &Args::new().text("page", address(page)))
        };
        let remarks = self.about.of(message, key).into_iter();
        remarks.map(|remark| self.known.entry(remark).or_insert_with_key(line).clone()).collect()
    }
}

/// The keys of pages of prose.
fn topics(texts: &Texts, names: &[String]) -> Result<Vec<String>, Failure> {
    let key = |name: &String| {
        let is_known = texts.locales.source().is_some_and(|source| source.topic(name).is_some());
        let unknown = || Diagnostic::global("texts-unknown-topic").arg("topic", name.as_str());
        is_known.then(|| format!("topics/{name}")).ok_or_else(|| Failure::from(unknown()))
    };
    names.iter().map(key).collect()
}

/// What a key names as cycle and control.
fn suffixes(key: &str) -> impl Iterator<Item = &str> {
    key.split('.').next().unwrap_or_default().split("__").skip(1)
}

/// The messages that cycles need on any control, and the names of all other cycles.
fn used(texts: &Texts, cycles: &[String]) -> Result<(BTreeSet<String>, BTreeSet<String>), Failure> {
    let only = conform::cycles(cycles)?;
    let chosen = Selection { cycles: &only, ..Selection::default() };
    let (mut ids, mut own, mut others) = (BTreeSet::new(), BTreeSet::new(), BTreeSet::new());
    let all = texts.catalogue.controls.values().flat_map(|on| on.cycles.values().map(move |cycle| (on, cycle)));
    for (on, cycle) in all {
        if chosen.has_cycle(cycle) {
            ids.extend(spec::texts(cycle, on).into_iter().map(|text| text.id));
            own.insert(cycle.name());
        } else {
            others.insert(cycle.name());
        }
    }
    let others = others.difference(&own).map(|name| (*name).to_owned()).collect();
    Ok((ids, others))
}
