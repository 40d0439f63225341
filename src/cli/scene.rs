//! `ciklo scene`: a scene file for a program that has none, to be corrected; and the same for commands that run without.
use std::collections::BTreeSet;
use std::path::Path;

use clap::ArgMatches;

use super::neighbours::Neighbours;
use super::program::Understood;
use super::session::Session;
use super::{Command, Failure, Outcome, arguments, cycle, program, run};
use crate::base::data::Files;
use crate::base::diag::{Diagnostic, Severity, Source};
use crate::engine::run::{Programs as _, program_key};
use crate::engine::scene::Scene;
use crate::engine::scene::guess::{BALL, Guess, GuessedTool, Line, Origin};
use crate::engine::stock::Blank;
use crate::language::locale::{Args, Digits, Ui};
use crate::program::syntax::{BlockKind, Program};
use crate::program::table::{Table, TableKind};
use crate::spec::OnControl;
use crate::system;

pub(super) const COMMAND: Command =
    Command { name: "scene", usage: "FILE --control CONTROL [--tool-table FILE] [--out FILE]", arguments: own, run };

/// Digits of lengths in remarks.
const SHOWN: Digits = Digits { minimum: 0, maximum: Some(4) };
/// The scene before anything is known of it.
const NOTHING: &str = "scene: 1\n";

fn own(ui: &Ui) -> Vec<clap::Arg> {
    vec![
        arguments::file(ui),
        arguments::control(ui),
        tool_table(ui),
        arguments::valued(ui, "out", "FILE", "cli-scene-out"),
    ]
}

/// `--tool-table FILE`.
pub(super) fn tool_table(ui: &Ui) -> clap::Arg {
    arguments::valued(ui, "tool-table", "FILE", "cli-run-tool-table")
}

/// The tool table of `--tool-table`.
pub(super) fn tools(matches: &ArgMatches) -> Result<Option<Table>, Failure> {
    matches.get_one::<String>("tool-table").map(|path| run::table(Path::new(path), TableKind::Tool)).transpose()
}

fn run(session: &mut Session, matches: &ArgMatches) -> Result<Outcome, Failure> {
    let catalogue = session.catalogue()?;
    let on = cycle::control(&catalogue, &arguments::text(matches, "control"))?;
    let path = arguments::text(matches, "file");
    let file = program::understand(Path::new(&path), &catalogue)?;
    let neighbours = Neighbours::new(Path::new(&path), &catalogue);
    let files = session.engine_files()?;
    let guess = guess(&file, on, &neighbours, tools(matches)?.as_ref(), &files)?;
    let ui = session.ui;
    let name = |line: Line<'_>| remark(line, &path, &ui);
    let text = guess.to_yaml(&name);
    match matches.get_one::<String>("out") {
        Some(out) => {
            system::write(Path::new(out), text.as_bytes())?;
            let line = ui.text("cli-written", &Args::new().text("path", out.as_str()));
            session.output.remark(&line);
        }
        None => session.output.print(&text)?,
    }
    neighbours.readable()?;
    Ok(Outcome::Clean)
}

/// The scene of a program that has none. What is assumed is said, once.
pub(super) fn assumed(
    session: &mut Session,
    file: &Understood,
    on: &OnControl,
    neighbours: &Neighbours<'_>,
    matches: &ArgMatches,
) -> Result<Scene, Failure> {
    let files = session.engine_files()?;
    let table = tools(matches)?;
    let guess = guess(file, on, neighbours, table.as_ref(), &files)?;
    let text = guess.to_yaml(&|_| String::new());
    let mut scene = Scene::parse(&Source::new("scene", text), &files).map_err(Failure::Data)?;
    if let Some(table) = table {
        scene.tools = table;
    }
    let ui = session.ui;
    let mut parts: Vec<String> = guess.tools.iter().filter_map(|tool| assumption(tool, &ui)).collect();
    if guess.tools.iter().any(|tool| tool.probes) {
        parts.push(ui.text("cli-scene-probe", &Args::new().text("ball", length(BALL, &ui))));
    }
    if parts.is_empty() {
        parts.push(ui.text("cli-scene-no-tools", &Args::new()));
    }
    let diagnostic = Diagnostic { severity: Severity::Note, ..Diagnostic::global("scene-assumed") };
    session.output.complain(&diagnostic.arg("assumed", parts.join("; ")), &ui);
    Ok(scene)
}

fn guess(
    file: &Understood,
    on: &OnControl,
    neighbours: &Neighbours<'_>,
    table: Option<&Table>,
    files: &Files,
) -> Result<Guess, Failure> {
    let nothing = Scene::parse(&Source::new("scene", NOTHING), files).map_err(Failure::Data)?;
    let blank = Blank::find(&file.program, &nothing).ok().map(|blank| blank.bounds);
    let mut programs: Vec<&Program> = vec![&file.program];
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
    Ok(Guess::of(on, &programs, blank, table))
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
        (Origin::Assumed, false) => Some(ui.text("cli-scene-tool", &args.text("radius", length(radius, ui)))),
        _ => None,
    }
}

/// The comment on a line of a scene file.
fn remark(line: Line<'_>, path: &str, ui: &Ui) -> String {
    let text = |id: &str| ui.text(id, &Args::new().text("path", path));
    match line {
        Line::Head => text("cli-scene-head"),
        Line::Tool(tool) => match tool.origin {
            Origin::Program => "TOOL DEF".to_owned(),
            Origin::Table => text("cli-scene-from-table"),
            Origin::Assumed => text("cli-scene-is-assumed"),
        },
        Line::Probe => text("cli-scene-is-assumed"),
        Line::Blank => "BLK FORM".to_owned(),
    }
}
