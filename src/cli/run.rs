//! `ciklo run`: a program executed in a scene.
use std::collections::BTreeMap;
use std::path::Path;

use clap::ArgMatches;

use super::neighbours::Neighbours;
use super::session::Session;
use super::{Command, Failure, Outcome, arguments, cycle, envelope, program, scene, stock};
use crate::base::diag::{Diagnostic, Source};
use crate::check::{self, Against, LabelBook};
use crate::engine::run::{Content, Engine, Event, EventKind, Outcome as Ended, Status};
use crate::engine::scene::Scene;
use crate::engine::stock::Watch;
use crate::language::locale::{Args, Digits, Language, Locales, Ui};
use crate::language::text;
use crate::program::table::{Table, TableKind};
use crate::spec::{Catalogue, CycleKey, OnControl};
use crate::system;
use crate::tools::conform::LogTexts;

pub(super) const COMMAND: Command = Command {
    name: "run",
    usage: "FILE --control CONTROL [--scene FILE] [--tool-table FILE] [--out DIR] [--events] [--envelope] \
            [--stock FILE] [--resolution MM] [--format FORMAT] [--skip-blocks] [--lang LANG]",
    arguments: own,
    run,
};

/// Digits of a result in the summary, a nanometre; events have them all.
const SHOWN: Digits = Digits { minimum: 0, maximum: Some(6) };

fn own(ui: &Ui) -> Vec<clap::Arg> {
    let [of_part, of_columns] = stock::own(ui);
    vec![
        arguments::file(ui),
        arguments::control(ui),
        arguments::valued(ui, "scene", "FILE", "cli-run-scene"),
        scene::tool_table(ui),
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
    let on = cycle::control(&catalogue, &arguments::text(matches, "control"))?;
    let path = arguments::text(matches, "file");
    let file = program::understand(Path::new(&path), &catalogue)?;
    let language = language(&file, &catalogue, &locales, on, &session.ui, matches)?;
    let neighbours = Neighbours::new(Path::new(&path), &catalogue);
    let files = session.engine_files()?;
    let mut scene = scene_of(session, &file, on, &neighbours, matches)?;
    selected(Path::new(&path), file.program.source().text(), &mut scene)?;
    let texts = LogTexts::new(language, on.id(), &files);
    let mut engine =
        Engine::new(&file.program, on, &scene, &texts).with_catalogue(&catalogue).with_programs(&neighbours);
    if matches.get_flag("skip-blocks") {
        engine = engine.skipping_blocks();
    }
    if matches.get_flag("envelope") {
        let result = engine.with_envelope().run(&mut |_| {});
        let outcome = envelope::show(session, on, &locales, &result, arguments::chosen_format(matches))?;
        return neighbours.readable().map(|()| outcome);
    }
    let mut teller = Teller { events: matches.get_flag("events"), set: BTreeMap::new(), failed: None, written: Ok(()) };
    let part = stock::wanted(matches);
    let followed = part.is_some() || scene.stock.is_some();
    let mut watch = followed.then(|| stock::begin(&file, &scene, matches)).transpose()?.map(Watch::new);
    let output = &mut *session.output;
    let result = match &mut watch {
        Some(watch) => engine.run(&mut |event| watch.see(event, &mut |event| teller.tell(&event, output))),
        None => engine.observe(&mut |event| teller.tell(event, output)),
    };
    let format = arguments::chosen_format(matches);
    if !teller.events && format != "json" {
        summary(session, &teller.set, result.status)?;
    }
    match (part, watch) {
        (Some(path), Some(watch)) => stock::end(session, path, watch.finish(), format)?,
        (None, Some(watch)) if !teller.events && format != "json" => stock::findings(session, &watch.finish().1)?,
        _ => {}
    }
    if let Some(out) = matches.get_one::<String>("out") {
        save(session, Path::new(out), result.tables.iter().chain(&result.logs))?;
    }
    // What was asked for as files is written, whatever became of standard output.
    teller.written?;
    fault(session, &file, on, &locales, &result, teller.failed);
    neighbours.readable()?;
    Ok(match result.status {
        Status::Done | Status::Stopped => Outcome::Clean,
        Status::Error | Status::Limit | Status::Unsupported => Outcome::Errors,
    })
}

/// Says why a run ended before its end, in the sentence of the specification where the cycle ended it.
pub(super) fn fault(
    session: &mut Session,
    file: &program::Understood,
    on: &OnControl,
    locales: &Locales,
    result: &Ended,
    failed: Option<CycleKey>,
) {
    let Some(diagnostic) = result.diagnostic.clone().map(|diagnostic| file.at_home(diagnostic)) else { return };
    let sentence = result.fault.as_ref().filter(|fault| fault.of_cycle).and_then(|fault| {
        let cycle = on.cycles.get(&failed?)?;
        let readers = [locales.language(session.ui.tag()).ok()?];
        text::guard_sentence(on, cycle, &fault.code, &readers)
    });
    match sentence {
        Some(sentence) => session.output.complain(&diagnostic.arg("message", sentence), &session.ui),
        None => session.output.complain(&diagnostic, &session.ui),
    }
}

/// The cycle that an event says to have ended with an error.
pub(super) fn failed(event: &Event) -> Option<CycleKey> {
    match &event.kind {
        EventKind::Error { .. } => event.at.cycle.as_ref().map(|(key, _)| *key),
        _ => None,
    }
}

/// The language of the logs: that of `--lang`, or of the program's labels, or of this program's own texts.
fn language<'l>(
    file: &program::Understood,
    catalogue: &Catalogue,
    locales: &'l Locales,
    on: &OnControl,
    ui: &Ui,
    matches: &ArgMatches,
) -> Result<&'l Language, Failure> {
    if matches.contains_id("lang") {
        return cycle::language_for(locales, on, ui, matches);
    }
    let labels = LabelBook::new(on, locales);
    let against = Against { catalogue, on, labels: &labels, language: None, software: None, readers: &[] };
    match check::language(&file.program, &against) {
        Some(tag) => cycle::language(locales, &tag),
        None => cycle::language_for(locales, on, ui, matches),
    }
}

/// The scene of `--scene`, with the tools of `--tool-table`; without it the one that the program lets guess.
pub(super) fn scene_of(
    session: &mut Session,
    file: &program::Understood,
    on: &OnControl,
    neighbours: &Neighbours<'_>,
    matches: &ArgMatches,
) -> Result<Scene, Failure> {
    let Some(path) = matches.get_one::<String>("scene") else {
        return scene::assumed(session, file, on, neighbours, matches);
    };
    let files = session.engine_files()?;
    let mut scene = read_scene(path, &files)?;
    if let Some(tools) = scene::tools(matches)? {
        scene.tools = tools;
    }
    Ok(scene)
}

/// The scene in a file.
pub(super) fn read_scene(path: &str, files: &[(String, String)]) -> Result<Scene, Failure> {
    let bytes = system::read(Path::new(path))?;
    let text = String::from_utf8(bytes).map_err(|_| Diagnostic::global("data-encoding").arg("path", path))?;
    Scene::parse(&Source::new(path, text), files).map_err(Failure::Data)
}

pub(super) fn table(path: &Path, kind: TableKind) -> Result<Table, Failure> {
    let file = program::source(path)?;
    Table::parse(kind, &file.source).map_err(Failure::Data)
}

/// Adds the tables beside the program that the scene does not have, if the program selects any.
pub(super) fn selected(path: &Path, text: &str, scene: &mut Scene) -> Result<(), Failure> {
    let text = text.to_uppercase();
    for (call, kind) in [("SEL TABLE", TableKind::Datum), ("SEL PATTERN", TableKind::Points)] {
        if !text.contains(call) {
            continue;
        }
        for other in system::beside(path, kind.extension().trim_start_matches('.'))? {
            let own = if kind == TableKind::Datum { &mut scene.datums } else { &mut scene.points };
            let known = own.iter().any(|known| known.is_named(&other.to_string_lossy()));
            if !known && program::is_table(&program::source(&other)?) {
                own.push(table(&other, kind)?);
            }
        }
    }
    Ok(())
}

/// Tells events as they come, or remembers what the summary needs.
struct Teller {
    events: bool,
    set: BTreeMap<String, Content>,
    /// The cycle that ended with an error.
    failed: Option<CycleKey>,
    written: Result<(), Failure>,
}

impl Teller {
    fn tell(&mut self, event: &Event, output: &mut super::Output) {
        self.failed = failed(event).or(self.failed);
        if !self.events {
            // What a definition hands over is known from the program; what a step sets is a result.
            let handed_over = matches!(&event.at.cycle, Some((_, None)));
            if let (EventKind::Set { q, value }, false) = (&event.kind, handed_over) {
                self.set.insert(q.to_string(), value.clone());
            }
        } else if self.written.is_ok() {
            self.written = output.print(&event.to_line());
        }
    }
}

fn summary(session: &mut Session, set: &BTreeMap<String, Content>, status: Status) -> Result<(), Failure> {
    let numbers = session.ui.numbers();
    for (q, value) in set {
        let value = match value {
            Content::Number(number) => numbers.nc(*number, SHOWN).unwrap_or_else(|| number.to_string()),
            Content::Text(text) => format!("\"{text}\""),
        };
        session.output.print(&format!("{q} = {value}\n"))?;
    }
    let line = session.ui.text("cli-run-status", &Args::new().text("status", status.as_str()));
    session.output.print(&format!("{line}\n"))
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
