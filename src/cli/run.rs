//! `ciklo run`: a program executed in a scene.
use std::cell::OnceCell;
use std::collections::BTreeMap;
use std::path::Path;

use clap::ArgMatches;

use super::execution::{Execution, failed, tool_table};
use super::session::Session;
use super::{Command, Failure, Outcome, arguments, cycle, envelope, stock};
use crate::base::diag::{Arg, Diagnostic};
use crate::base::expr::QRef;
use crate::check::{self, Against, LabelBook};
use crate::engine::run::{Content, Event, EventKind, Lines, Status, Texts};
use crate::engine::stock::Watch;
use crate::language::locale::{Args, Digits, Language, LocaleError, Locales, Scope, Ui};
use crate::spec::{CycleKey, OnControl};
use crate::system;
use crate::tools::conform::{self, LogTexts};

pub(super) const COMMAND: Command = Command {
    name: "run",
    usage: "FILE --control CONTROL [--scene FILE] [--tool-table FILE] [--out DIR] [--events] [--envelope] \
            [--stock FILE] [--resolution MM] [--format FORMAT] [--skip-blocks] [--lang LANG]",
    arguments: own,
    run,
};

/// Digits of a result in the summary, a nanometre; events have them all.
const SHOWN: Digits = Digits { minimum: 0, maximum: Some(6) };

/// Bytes of events that are handed on together.
const AT_A_TIME: usize = 1 << 16;

fn own(ui: &Ui) -> Vec<clap::Arg> {
    let [of_part, of_columns] = stock::own(ui);
    vec![
        arguments::file(ui),
        arguments::control(ui),
        arguments::valued(ui, "scene", "FILE", "cli-run-scene"),
        tool_table(ui),
        arguments::valued(ui, "out", "DIR", "cli-run-out"),
        arguments::switch(ui, "events", "cli-run-events"),
        of_part,
        of_columns,
        arguments::format(ui, &["text", "json"]),
        arguments::switch(ui, "skip-blocks", "cli-run-skip-blocks"),
        arguments::valued(ui, "lang", "LANG", "cli-run-lang"),
        arguments::switch(ui, "envelope", "cli-run-envelope").conflicts_with_all(["events", "out", "stock"]),
    ]
}

fn run(session: &mut Session, matches: &ArgMatches) -> Result<Outcome, Failure> {
    let (catalogue, locales) = (session.catalogue()?, session.locales()?);
    let execution = Execution::new(session, &catalogue, matches)?;
    let asked = matches.contains_id("lang").then(|| cycle::language_for(&locales, execution.on, &session.ui, matches));
    let language = asked.transpose()?.map_or_else(OnceCell::new, OnceCell::from);
    let scene = execution.scene(session, matches)?;
    let texts = Words { execution: &execution, locales: &locales, ui: session.ui, language };
    let mut engine = execution.engine(&scene, &texts);
    if matches.get_flag("skip-blocks") {
        engine = engine.skipping_blocks();
    }
    let format = arguments::chosen_format(matches);
    if matches.get_flag("envelope") {
        let result = engine.with_envelope().run(&mut |_| {});
        let outcome = envelope::show(session, execution.on, &locales, &result, format)?;
        return execution.readable().map(|()| outcome);
    }
    let part = stock::wanted(matches);
    let watched = part.is_some() || scene.stock.is_some();
    let mut watch = watched.then(|| stock::begin(&execution.file, &scene, matches)).transpose()?.map(Watch::new);
    let mut reporter = EventPrinter::new(matches.get_flag("events"));
    let output = &mut *session.output;
    let result = match &mut watch {
        Some(watch) => engine.run(&mut |event| watch.see(event, &mut |event| reporter.report(&event, output))),
        None => engine.observe(&mut |event| reporter.report(event, output)),
    };
    reporter.pass_on(output);
    let for_people = !reporter.events && format != "json";
    if for_people {
        let (on, tag) = (execution.on, session.ui.tag());
        summary(session, &reporter.set, result.status, &|q, key| meaning(q, key, on, &locales, tag))?;
    }
    match (part, watch) {
        (Some(path), Some(watch)) => stock::end(session, path, watch.finish(), format)?,
        (None, Some(watch)) if for_people => stock::findings(session, &watch.finish().1)?,
        _ => {}
    }
    if let Some(out) = matches.get_one::<String>("out") {
        save(session, Path::new(out), result.tables.iter().chain(&result.logs))?;
    }
    // What was asked for as files is written, whatever became of standard output.
    reporter.written?;
    execution.end(session, &locales, &result, reporter.failed)
}

/// The words of logs, in the language of `--lang`, or of the program's labels, or of this program's own texts. The labels
/// are read when the first log is written: most programs write none.
struct Words<'w, 'c> {
    execution: &'w Execution<'c>,
    locales: &'w Locales,
    ui: Ui<'w>,
    language: OnceCell<&'w Language>,
}

impl<'w> Words<'w, '_> {
    fn language(&self) -> Result<&'w Language, LocaleError> {
        if let Some(language) = self.language.get() {
            return Ok(language);
        }
        let Execution { catalogue, on, file, .. } = self.execution;
        let labels = LabelBook::new(on, self.locales);
        let against = Against { catalogue, on, labels: &labels, language: None, software: None, readers: &[] };
        let language = match check::language(&file.program, &against) {
            Some(tag) => self.locales.language(&tag),
            None => {
                self.locales.language(self.ui.tag()).or_else(|_| self.locales.language(on.control.language.as_str()))
            }
        };
        language.map(|language| *self.language.get_or_init(|| language))
    }
}

impl Texts for Words<'_, '_> {
    fn message(&self, id: &str, args: &[(&str, Arg)]) -> Result<String, Diagnostic> {
        LogTexts::new(self.language()?, self.execution.on.id(), &self.execution.files).message(id, args)
    }

    fn template(&self, name: &str) -> Option<(String, String)> {
        conform::template(&self.execution.files, name)
    }
}

/// Prints events as they come, or remembers what the summary needs.
struct EventPrinter {
    events: bool,
    /// Events as lines that were not handed on yet.
    lines: Lines,
    /// What was set, and by which cycle.
    set: BTreeMap<String, (Content, Option<CycleKey>)>,
    /// The cycle that ended with an error.
    failed: Option<CycleKey>,
    written: Result<(), Failure>,
}

impl EventPrinter {
    fn new(events: bool) -> Self {
        Self { events, lines: Lines::default(), set: BTreeMap::new(), failed: None, written: Ok(()) }
    }

    fn report(&mut self, event: &Event, output: &mut super::Output) {
        self.failed = failed(event).or(self.failed);
        if !self.events {
            // What a definition hands over is known from the program; what a step sets is a result.
            let handed_over = matches!(&event.at.cycle, Some((_, None)));
            if let (EventKind::Set { q, value }, false) = (&event.kind, handed_over) {
                let cycle = event.at.cycle.as_ref().map(|(key, _)| *key);
                self.set.insert(q.to_string(), (value.clone(), cycle));
            }
        } else if self.written.is_ok() {
            self.lines.add(event);
            if self.lines.bytes().len() >= AT_A_TIME {
                self.pass_on(output);
            }
        }
    }

    /// Hands the lines to standard output.
    fn pass_on(&mut self, output: &mut super::Output) {
        if self.written.is_ok() {
            self.written = output.write(self.lines.bytes());
        }
        self.lines.clear();
    }
}

fn summary(
    session: &mut Session,
    set: &BTreeMap<String, (Content, Option<CycleKey>)>,
    status: Status,
    meaning: &dyn Fn(&str, CycleKey) -> Option<String>,
) -> Result<(), Failure> {
    let numbers = session.ui.numbers();
    for (q, (value, cycle)) in set {
        let value = match value {
            Content::Number(number) => numbers.nc(*number, SHOWN).unwrap_or_else(|| number.to_string()),
            Content::Text(text) => format!("\"{text}\""),
        };
        let meaning = cycle.and_then(|key| meaning(q, key)).map(|text| format!(" ;{text}")).unwrap_or_default();
        session.output.print(&format!("{q} = {value}{meaning}\n"))?;
    }
    let line = session.ui.text("cli-run-status", &Args::new().text("status", status.as_str()));
    session.output.print(&format!("{line}\n"))
}

/// What a parameter that a cycle has set means, as the manual lists it among the results of the cycle.
fn meaning(q: &str, key: CycleKey, on: &OnControl, locales: &Locales, language: &str) -> Option<String> {
    let cycle = on.cycles.get(&key)?;
    let target = QRef::parse(q)?;
    let result = cycle.file.results.iter().find(|result| result.q == Some(target))?;
    let scope = Scope::new(cycle.name(), on.id());
    let text = locales.language(language).ok()?.plain(&format!("result-{}", result.is.as_str()), &scope).ok()?;
    Some(text.into_owned())
}

fn save<'f>(
    session: &mut Session,
    out: &Path,
    files: impl Iterator<Item = &'f (String, String)>,
) -> Result<(), Failure> {
    system::create_directory(out)?;
    for (name, text) in files {
        let path = system::inside(out, name);
        system::write(&path, text.as_bytes())?;
        let args = Args::new().text("path", path.display().to_string());
        let line = session.ui.text("cli-written", &args);
        session.output.remark(&line);
    }
    Ok(())
}
