//! `ciklo compare`: whether two programs are the same to a control, and where they differ.
use std::path::Path;

use clap::ArgMatches;
use serde::Serialize;

use super::execution::read_scene;
use super::neighbours::Neighbours;
use super::session::{Session, json};
use super::{Command, Failure, Outcome, arguments, cycle, program};
use crate::check::{Against, LabelBook};
use crate::engine::run::{Engine, Status, Trace, Traced};
use crate::language::locale::{Args, Ui};
use crate::spec::{Catalogue, OnControl};
use crate::tools::compare::{self, Difference, Statement};
use crate::tools::conform::LogTexts;

pub(super) const COMMAND: Command = Command {
    name: "compare",
    usage: "A B [--control CONTROL] [--execute --scene FILE] [--format FORMAT]",
    arguments: own,
    run,
};

/// The format of the document.
const FORMAT: &str = "ciklo-compare/1";
/// Columns of a side; longer lines push the other side on.
const WIDEST: usize = 72;

fn own(ui: &Ui) -> Vec<clap::Arg> {
    vec![
        arguments::argument(ui, "a", "cli-compare-a").value_name("A").required(true),
        arguments::argument(ui, "b", "cli-compare-b").value_name("B").required(true),
        arguments::valued(ui, "control", "CONTROL", "cli-compare-control"),
        arguments::switch(ui, "execute", "cli-compare-execute").requires("scene"),
        arguments::valued(ui, "scene", "FILE", "cli-arg-scene"),
        arguments::format(ui, &["text", "json"]),
    ]
}

/// What the document says.
#[derive(Serialize)]
struct Report {
    format: &'static str,
    a: String,
    b: String,
    control: String,
    same: bool,
    differences: Vec<Sides<Vec<Place>>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    execution: Option<Execution>,
}

#[derive(Serialize)]
struct Sides<T> {
    a: T,
    b: T,
}

/// A block as it is printed.
#[derive(Serialize)]
struct Place {
    line: usize,
    text: Vec<String>,
}

/// What executing both reported.
#[derive(Serialize)]
struct Execution {
    same: bool,
    a: Ran,
    b: Ran,
    #[serde(skip_serializing_if = "Option::is_none")]
    first: Option<Sides<Option<Step>>>,
}

#[derive(Serialize)]
struct Ran {
    status: &'static str,
    events: usize,
    trace: String,
}

/// An event in which two traces differ.
#[derive(Serialize)]
struct Step {
    line: usize,
    event: serde_json::Value,
}

fn run(session: &mut Session, matches: &ArgMatches) -> Result<Outcome, Failure> {
    let (catalogue, locales) = (session.catalogue()?, session.locales()?);
    let names = [arguments::text(matches, "a"), arguments::text(matches, "b")];
    let understand = |name: &String| program::understand(Path::new(name), &catalogue);
    let files = [understand(&names[0])?, understand(&names[1])?];
    let on = match matches.get_one::<String>("control") {
        Some(id) => Some(cycle::control(&catalogue, id)?),
        None => cycle::likeliest(&files[0].program, &catalogue, &locales),
    };
    let Some(on) = on else { return Ok(Outcome::Clean) };
    let labels = LabelBook::new(on, &locales);
    let against = Against { catalogue: &catalogue, on, labels: &labels, language: None, software: None, readers: &[] };
    let differences = compare::compare(&files[0].program, &files[1].program, &against);
    let execution = match matches.get_flag("execute") {
        true => Some(execute(session, &catalogue, on, &names, &files, &arguments::text(matches, "scene"))?),
        false => None,
    };
    let [a, b] = names;
    let place = |side: usize, own: &Statement| Place {
        line: own.line,
        text: files[side].slice(own.span).lines().map(|line| line.trim_end().to_owned()).collect(),
    };
    let sides = |difference: &Difference| Sides {
        a: places(difference.a.iter().map(|own| place(0, own))),
        b: places(difference.b.iter().map(|own| place(1, own))),
    };
    let same = execution.as_ref().map_or(differences.is_empty(), |execution| execution.same);
    let differences = differences.iter().map(sides).collect();
    let report = Report { format: FORMAT, a, b, control: on.id().to_owned(), same, differences, execution };
    if arguments::chosen_format(matches) == "json" {
        let document = json(&report)?;
        session.output.print(&document)?;
    } else {
        tell(session, &report)?;
    }
    Ok(if report.same { Outcome::Clean } else { Outcome::Errors })
}

/// Each block once: a block of DIN/ISO may be several of Klartext.
fn places(all: impl Iterator<Item = Place>) -> Vec<Place> {
    let mut places: Vec<Place> = all.collect();
    places.dedup_by(|next, before| next.line == before.line && next.text == before.text);
    places
}

/// Executes both programs in the same scene, each with its neighbours.
fn execute(
    session: &mut Session,
    catalogue: &Catalogue,
    on: &OnControl,
    names: &[String; 2],
    files: &[program::Understood; 2],
    scene: &str,
) -> Result<Execution, Failure> {
    let data = session.engine_files()?;
    let locales = session.locales()?;
    let scene = read_scene(scene, &data)?;
    // Logs of both are written in one language, so that labels do not decide.
    let texts = LogTexts::new(cycle::language(&locales, on.control.language.as_str())?, on.id(), &data);
    let mut traces = Vec::new();
    for (name, file) in names.iter().zip(files) {
        let neighbours = Neighbours::new(Path::new(name), catalogue);
        let engine =
            Engine::new(&file.program, on, &scene, &texts).with_catalogue(catalogue).with_programs(&neighbours);
        let mut trace = Trace::default();
        let outcome = engine.run(&mut |event| trace.push(event));
        if let Some(diagnostic) = &outcome.diagnostic {
            session.output.complain(&file.at_home(diagnostic.clone()), &session.ui);
        }
        neighbours.readable()?;
        traces.push((trace, outcome.status));
    }
    let (Some(b), Some(a)) = (traces.pop(), traces.pop()) else {
        return Err(crate::base::diag::Diagnostic::global("internal")
            .arg("detail", "two programs, not two traces")
            .into());
    };
    Ok(executed(&a, &b))
}

/// Traces are the same if they are equal and whole: the engine gave up in neither.
fn executed(a: &(Trace, Status), b: &(Trace, Status)) -> Execution {
    let whole = |status: Status| !matches!(status, Status::Limit | Status::Unsupported);
    let ran = |(trace, status): &(Trace, Status)| Ran {
        status: status.as_str(),
        events: trace.events.len(),
        trace: trace.fingerprint(),
    };
    let longest = a.0.events.len().max(b.0.events.len());
    let event = |trace: &Trace, at: usize| trace.events.get(at).map(|own| own.event.clone());
    let first = (0..longest).find(|&at| event(&a.0, at) != event(&b.0, at));
    let step = |own: &Traced| Step { line: own.line, event: serde_json::from_str(&own.event).unwrap_or_default() };
    Execution {
        same: first.is_none() && whole(a.1) && whole(b.1),
        a: ran(a),
        b: ran(b),
        first: first.map(|at| Sides { a: a.0.events.get(at).map(step), b: b.0.events.get(at).map(step) }),
    }
}

fn tell(session: &mut Session, report: &Report) -> Result<(), Failure> {
    let Some(execution) = &report.execution else {
        for difference in &report.differences {
            let rows = rows(report, difference);
            session.output.print(&rows)?;
        }
        let args = Args::new().number("count", report.differences.len() as f64);
        return say(session, "cli-compared", &args);
    };
    for (name, ran) in [(&report.a, &execution.a), (&report.b, &execution.b)] {
        session.output.print(&format!("{}  {name}\n", ran.trace))?;
    }
    if let Some(first) = &execution.first {
        for (name, step) in [(&report.a, &first.a), (&report.b, &first.b)] {
            let line = step
                .as_ref()
                .map_or_else(|| format!("{name}: -\n"), |own| format!("{name}:{}: {}\n", own.line, own.event));
            session.output.print(&line)?;
        }
    }
    let verdict = match (execution.same, &execution.first) {
        (true, _) => "same",
        (_, Some(_)) => "different",
        _ => "unproved",
    };
    let args = Args::new().text("verdict", verdict).number("count", execution.a.events as f64);
    say(session, "cli-compare-executed", &args)
}

fn say(session: &mut Session, id: &str, args: &Args) -> Result<(), Failure> {
    let line = session.ui.text(id, args);
    session.output.print(&format!("{line}\n"))
}

/// A difference with the lines of both programs side by side.
fn rows(report: &Report, difference: &Sides<Vec<Place>>) -> String {
    let lines = |name: &str, blocks: &[Place]| {
        let start = blocks.first().map_or_else(|| format!("{name}:"), |first| format!("{name}:{}", first.line));
        let texts = blocks.iter().flat_map(|block| block.text.iter().map(|line| line.replace('\t', " ")));
        std::iter::once(start).chain(texts).collect::<Vec<_>>()
    };
    let (left, right) = (lines(&report.a, &difference.a), lines(&report.b, &difference.b));
    let width = left.iter().map(|line| line.chars().count()).max().unwrap_or(0).min(WIDEST);
    let mut out = String::new();
    for at in 0..left.len().max(right.len()) {
        let (a, b) = (left.get(at), right.get(at));
        let sign = match (a, b) {
            _ if at == 0 => ' ',
            (Some(_), None) => '<',
            (None, _) => '>',
            _ if a == b => ' ',
            _ => '|',
        };
        let row = format!("{:width$} {sign} {}", a.map_or("", String::as_str), b.map_or("", String::as_str));
        out.push_str(row.trim_end());
        out.push('\n');
    }
    out.push('\n');
    out
}
