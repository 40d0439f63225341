//! The execution of a program that arguments ask for: its control, its text, the programs that it may call, its scene.
//!
//! Everything is read here, once, in this order; commands that execute a program go on from here.
//! Invariant: what a program does is the engine's affair; what is shown of it, that of the command.
use std::collections::BTreeSet;
use std::path::Path;
use std::rc::Rc;

use clap::ArgMatches;

use super::neighbours::Neighbours;
use super::program::Understood;
use super::session::Session;
use super::{Failure, Outcome, arguments, cycle, program};
use crate::base::data::Files;
use crate::base::diag::{Diagnostic, Severity, Source};
use crate::engine::run::{
    Engine, Event, EventKind, Fault, Outcome as Ended, Programs as _, Status, Texts, program_key,
};
use crate::engine::scene::guess::{BALL, Guess, GuessedTool, INSERT, Origin, RECESSING};
use crate::engine::scene::{Beside, Scene};
use crate::engine::stock::Blank;
use crate::language::locale::{Args, Digits, Locales, Ui};
use crate::language::text;
use crate::program::syntax::{BlockKind, Program};
use crate::program::table::{Table, TableKind};
use crate::spec::{Catalogue, CycleKey, OnControl};
use crate::system;

/// Digits of lengths in remarks.
const SHOWN: Digits = Digits { minimum: 0, maximum: Some(4) };
/// The extension of masks of formatted output.
const MASKS: &str = "A";
/// The scene before anything is known of it.
const NOTHING: &str = "scene: 1\n";

/// `--tool-table FILE`.
pub(super) fn tool_table(ui: &Ui) -> clap::Arg {
    arguments::several(ui, "tool-table", "FILE", "cli-run-tool-table")
}

/// A program with everything that its run needs besides the scene.
pub(super) struct Execution<'c> {
    pub(super) catalogue: &'c Catalogue,
    pub(super) on: &'c OnControl,
    /// The path as it was given.
    pub(super) path: String,
    pub(super) file: Understood,
    /// The data, for machines and the templates of logs.
    pub(super) files: Rc<Files>,
    /// The programs that it may call.
    neighbours: Neighbours<'c>,
}

impl<'c> Execution<'c> {
    /// That of the arguments.
    pub(super) fn new(session: &Session, catalogue: &'c Catalogue, matches: &ArgMatches) -> Result<Self, Failure> {
        let on = cycle::control(catalogue, &arguments::text(matches, "control"))?;
        let path = arguments::text(matches, "file");
        let file = program::understand(Path::new(&path), catalogue)?;
        let neighbours = Neighbours::new(Path::new(&path), catalogue);
        Ok(Self { catalogue, on, path, file, files: session.engine_files()?, neighbours })
    }

    /// The scene of `--scene`, with the tools of `--tool-table`, or without it the one that the program lets guess; and
    /// the tables that the program selects.
    pub(super) fn scene(&self, session: &mut Session, matches: &ArgMatches) -> Result<Scene, Failure> {
        let given = matches.get_one::<String>("scene").map(|path| read_scene(path, &self.files)).transpose()?;
        let tables = tools(matches)?;
        let mut scene = match given {
            Some(scene) => scene,
            None => self.assumed(session, tool_table_of(&tables))?,
        };
        for table in tables {
            match table.kind() {
                TableKind::Turning => scene.turning_tools = table,
                _ => scene.tools = table,
            }
        }
        selected(Path::new(&self.path), self.file.program.source().text(), &mut scene)?;
        Ok(scene)
    }

    /// The engine that executes it.
    pub(super) fn engine<'e>(&'e self, scene: &'e Scene, texts: &'e dyn Texts) -> Engine<'e> {
        let engine = Engine::new(&self.file.program, self.on, scene, texts);
        engine.with_catalogue(self.catalogue).with_programs(&self.neighbours)
    }

    /// Whether everything that was called could be read.
    pub(super) fn readable(&self) -> Result<(), Failure> {
        self.neighbours.readable()
    }

    /// What the command comes to: why a run ended before its end is reported, in the sentence of the specification where
    /// the cycle ended it.
    pub(super) fn end(
        &self,
        session: &mut Session,
        locales: &Locales,
        result: &Ended,
        failed: Option<CycleKey>,
    ) -> Result<Outcome, Failure> {
        if let Some(diagnostic) = result.diagnostic.clone().map(|diagnostic| self.file.at_home(diagnostic)) {
            let fault = result.fault.as_ref();
            let diagnostic = match fault.and_then(|fault| sentence(self.on, locales, &session.ui, fault, failed)) {
                Some(sentence) => diagnostic.arg("message", sentence),
                None => diagnostic,
            };
            session.output.complain(&diagnostic, &session.ui);
        }
        self.readable()?;
        Ok(match result.status {
            Status::Done | Status::Stopped => Outcome::Clean,
            Status::Error | Status::Limit | Status::Unsupported => Outcome::Errors,
        })
    }

    /// What the program lets guess of a scene.
    pub(super) fn guess(&self, table: Option<&Table>) -> Result<Guess, Failure> {
        guess(self.on, &self.file.program, &self.neighbours, &self.files, table)
    }

    /// The scene of a program that has none. What is assumed is reported, once.
    fn assumed(&self, session: &mut Session, table: Option<&Table>) -> Result<Scene, Failure> {
        let guess = self.guess(table)?;
        let text = guess.to_yaml(&|_| String::new());
        let scene = Scene::parse(&Source::new("scene", text), &self.files).map_err(Failure::Data)?;
        let ui = session.ui;
        let mut parts: Vec<String> = guess.tools.iter().filter_map(|tool| assumption(tool, &ui)).collect();
        if guess.tools.iter().any(|tool| tool.probes) {
            parts.push(ui.text("cli-scene-probe", &Args::new().text("ball", length(BALL, &ui))));
        }
        if parts.is_empty() {
            parts.push(ui.text("cli-scene-no-tools", &Args::new()));
        }
        let diagnostic = Diagnostic { severity: Severity::Note, ..Diagnostic::global("assumed-scene") };
        session.output.complain(&diagnostic.arg("assumed", parts.join("; ")), &ui);
        Ok(scene)
    }
}

/// What a program and those that it calls let guess of a scene.
pub(super) fn guess(
    on: &OnControl,
    program: &Program,
    neighbours: &Neighbours<'_>,
    files: &Files,
    table: Option<&Table>,
) -> Result<Guess, Failure> {
    let nothing = Scene::parse(&Source::new("scene", NOTHING), files).map_err(Failure::Data)?;
    let blank = Blank::find(program, &nothing).ok().and_then(|blank| blank.guessed());
    let mut programs: Vec<&Program> = vec![program];
    let mut seen = BTreeSet::new();
    let mut next = 0;
    while let Some(program) = programs.get(next).copied() {
        for block in program.blocks() {
            let BlockKind::CallPgm(name) = &block.kind else { continue };
            let key = program_key(program.slice(*name));
            if seen.insert(key.clone()) {
                programs.extend(neighbours.program(&key));
            }
        }
        next += 1;
    }
    Ok(Guess::of(on, &programs, blank, table, files))
}

/// What the specification says of an error with which a cycle ends itself.
pub(super) fn sentence(
    on: &OnControl,
    locales: &Locales,
    ui: &Ui,
    fault: &Fault,
    cycle: Option<CycleKey>,
) -> Option<String> {
    let cycle = on.cycles.get(&cycle.filter(|_| fault.of_cycle)?)?;
    let readers = [locales.language(ui.tag()).ok()?];
    text::guard_sentence(on, cycle, &fault.code, &readers)
}

/// The cycle that an event says to have ended with an error.
pub(super) fn failed(event: &Event) -> Option<CycleKey> {
    match &event.kind {
        EventKind::Error { .. } => event.at.cycle.as_ref().map(|(key, _)| *key),
        _ => None,
    }
}

/// The tables of `--tool-table`: of tools or, by the name of the file, of turning tools.
pub(super) fn tools(matches: &ArgMatches) -> Result<Vec<Table>, Failure> {
    let kind = |path: &str| TableKind::of_file(path).filter(|kind| *kind == TableKind::Turning);
    let read = |path: &String| table(Path::new(path), kind(path).unwrap_or(TableKind::Tool));
    matches.get_many::<String>("tool-table").unwrap_or_default().map(read).collect()
}

/// The tool table among these.
pub(super) fn tool_table_of(tables: &[Table]) -> Option<&Table> {
    tables.iter().find(|table| table.kind() == TableKind::Tool)
}

/// The scene in a file.
pub(super) fn read_scene(path: &str, files: &[(String, String)]) -> Result<Scene, Failure> {
    let bytes = system::read(Path::new(path))?;
    let text = String::from_utf8(bytes).map_err(|_| Diagnostic::global("data-encoding").arg("path", path))?;
    let beside = Folder(Path::new(path).parent().unwrap_or(Path::new("")));
    Scene::parse_beside(&Source::new(path, text), files, Some(&beside)).map_err(Failure::Data)
}

/// The folder of a scene.
struct Folder<'p>(&'p Path);

impl Beside for Folder<'_> {
    fn size(&self, name: &str) -> Option<u64> {
        system::size(&self.0.join(name))
    }

    fn bytes(&self, name: &str) -> Result<Vec<u8>, Diagnostic> {
        Ok(system::read_file(&self.0.join(name))?)
    }
}

fn table(path: &Path, kind: TableKind) -> Result<Table, Failure> {
    let file = program::source(path)?;
    Table::parse(kind, &file.source).map_err(Failure::Data)
}

/// Adds the tables next to the program that the scene does not have, if the program selects any.
pub(super) fn selected(path: &Path, text: &str, scene: &mut Scene) -> Result<(), Failure> {
    let bytes = text.as_bytes();
    // Long programs are not copied for this.
    let selects = |what: &str| {
        let first = what.bytes().next().unwrap_or_default();
        let begins = memchr::memchr2_iter(first, first.to_ascii_lowercase(), bytes);
        let mut same = begins.filter_map(|at| bytes.get(at..at + what.len()));
        same.any(|own| own.eq_ignore_ascii_case(what.as_bytes()))
    };
    let kinds = [
        (&["SEL TABLE"][..], TableKind::Datum),
        (&["SEL PATTERN"][..], TableKind::Points),
        (&["TABOPEN", "SQL"][..], TableKind::Free),
    ];
    for (calls, kind) in kinds {
        if !calls.iter().any(|call| selects(call)) {
            continue;
        }
        for other in system::beside(path, kind.extension().trim_start_matches('.'))? {
            let own = match kind {
                TableKind::Datum => &mut scene.datums,
                TableKind::Free => &mut scene.free_tables,
                _ => &mut scene.points,
            };
            let known = own.iter().any(|known| known.is_named(&other.to_string_lossy()));
            if !known && program::is_table(&program::source(&other)?) {
                own.push(table(&other, kind)?);
            }
        }
    }
    if selects("F-PRINT") {
        for other in system::beside(path, MASKS)? {
            let name = other.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
            if !scene.masks.iter().any(|(known, _)| known.eq_ignore_ascii_case(&name)) {
                scene.masks.push((name, program::source(&other)?.source.text().to_owned()));
            }
        }
    }
    Ok(())
}

fn length(value: f64, ui: &Ui) -> String {
    ui.numbers().nc(value, SHOWN).unwrap_or_else(|| value.to_string())
}

/// What is assumed of a tool, if anything is.
fn assumption(tool: &GuessedTool, ui: &Ui) -> Option<String> {
    let of = tool.name.clone().unwrap_or_else(|| tool.number.to_string());
    let [long, radius] = tool.size;
    let args = Args::new().text("tool", of).text("length", length(long, ui));
    match (tool.origin, tool.probes) {
        (Origin::Assumed, true) => Some(ui.text("cli-scene-probing-tool", &args)),
        (Origin::Assumed, false) if tool.recesses => {
            let [width, nose] = RECESSING.map(|value| length(value, ui));
            Some(ui.text("cli-scene-recessing-tool", &args.text("width", width).text("radius", nose)))
        }
        (Origin::Assumed, false) if tool.turns => {
            let [nose, angle, point] = INSERT.map(|value| length(value, ui));
            let args = args.text("radius", nose).text("angle", angle).text("point", point);
            Some(ui.text("cli-scene-turning-tool", &args))
        }
        (Origin::Assumed, false) => Some(ui.text("cli-scene-tool", &args.text("radius", length(radius, ui)))),
        _ => None,
    }
}
