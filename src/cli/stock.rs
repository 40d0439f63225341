//! The stock of a run on the command line: the report, and the finished part as a file.
use std::path::Path;

use clap::ArgMatches;

use super::program::Understood;
use super::session::{self, Session};
use super::{Failure, arguments};
use crate::base::diag::Diagnostic;
use crate::engine::scene::Scene;
use crate::engine::stock::{Blank, Finding, Machining, Report, Stock, StockTrouble};
use crate::language::locale::{Args, Digits, Ui};
use crate::system;

/// The name of the option for the part.
const STOCK: &str = "stock";
/// The name of the option for the size of the columns.
const RESOLUTION: &str = "resolution";

/// Digits of lengths, times and volumes in the report for people.
const SHOWN: Digits = Digits { minimum: 0, maximum: Some(3) };
const ROUGH: Digits = Digits { minimum: 1, maximum: Some(1) };

/// `--stock FILE` and `--resolution MM`.
pub(super) fn own(ui: &Ui) -> [clap::Arg; 2] {
    [arguments::valued(ui, STOCK, "FILE", "cli-run-stock"), resolution(ui)]
}

/// `--resolution MM`.
pub(super) fn resolution(ui: &Ui) -> clap::Arg {
    arguments::valued(ui, RESOLUTION, "MM", "cli-arg-resolution")
}

/// Where the part is to be written.
pub(super) fn wanted(matches: &ArgMatches) -> Option<&str> {
    matches.get_one::<String>(STOCK).map(String::as_str)
}

/// The blank of the scene or the program, ready for the first event.
pub(super) fn begin(file: &Understood, scene: &Scene, matches: &ArgMatches) -> Result<Machining, Failure> {
    let resolution = match matches.get_one::<String>(RESOLUTION) {
        None => None,
        Some(text) => {
            let wrong = || Diagnostic::global("stock-resolution").arg("found", text.as_str());
            Some(text.parse::<f64>().ok().filter(|mm| *mm > 0.0 && mm.is_finite()).ok_or_else(wrong)?)
        }
    };
    let program = &file.program;
    Machining::new(program, scene, resolution)
        .map_err(|trouble| file.at_home(trouble.diagnostic_in(program, scene)).into())
}

/// The same, or nothing where neither the scene nor the program has a blank.
pub(super) fn begin_if_any(
    file: &Understood,
    scene: &Scene,
    matches: &ArgMatches,
) -> Result<Option<Machining>, Failure> {
    match Blank::find(&file.program, scene) {
        Err(StockTrouble::Missing) => Ok(None),
        _ => begin(file, scene, matches).map(Some),
    }
}

/// Writes the part and prints the report.
pub(super) fn end(session: &mut Session, path: &str, part: (Stock, Report), format: &str) -> Result<(), Failure> {
    let (stock, report) = part;
    let Some(bytes) = stock.to_stl() else { return Err(Diagnostic::global("stock-resolution-mesh").into()) };
    system::write(Path::new(path), &bytes)?;
    let line = session.ui.text("cli-written", &Args::new().text("path", path));
    session.output.remark(&line);
    match format {
        "json" => session.output.print(&session::json(&report.to_json())?),
        _ => reported(session, &report),
    }
}

fn reported(session: &mut Session, report: &Report) -> Result<(), Failure> {
    let ui = session.ui;
    let numbers = ui.numbers();
    let number = |value: f64, digits| numbers.nc(value, digits).unwrap_or_else(|| value.to_string());
    let short = |value| number(value, SHOWN);
    let time = |seconds| number(seconds, ROUGH);
    let line = |id: &str, args: Args| format!("{}\n", ui.text(id, &args));
    let mut text = String::new();
    text += &line(
        "cli-stock-time",
        Args::new()
            .text("all", time(report.time_feed + report.time_rapid + report.time_dwell))
            .text("feed", time(report.time_feed))
            .text("rapid", time(report.time_rapid))
            .text("dwell", time(report.time_dwell)),
    );
    text += &line(
        "cli-stock-length",
        Args::new()
            .text("feed", short(report.length_feed))
            .text("cut", short(report.length_cut))
            .text("rapid", short(report.length_rapid)),
    );
    let volume = Args::new().text("removed", short(report.removed)).text("blank", short(report.blank));
    text += &line("cli-stock-volume", volume);
    let greatest =
        [("cli-stock-depth", &report.depth), ("cli-stock-width", &report.width), ("cli-stock-rate", &report.rate)];
    for (id, greatest) in greatest {
        if greatest.line > 0 {
            let args = Args::new().text("value", short(greatest.value)).number("line", greatest.line as f64);
            text += &line(id, args);
        }
    }
    session.output.print(&text)?;
    findings(session, report)
}

/// What was found in the material, a line each.
pub(super) fn findings(session: &mut Session, report: &Report) -> Result<(), Failure> {
    let ui = session.ui;
    let numbers = ui.numbers();
    let short = |value: f64| numbers.nc(value, SHOWN).unwrap_or_else(|| value.to_string());
    let line = |id: &str, args: Args| format!("{}\n", ui.text(id, &args));
    let mut text = String::new();
    for Finding { kind, line: at, program, amount, count } in &report.findings {
        let args = Args::new()
            .text("kind", kind.as_str())
            .number("line", *at as f64)
            .text("program", &**program)
            .text("amount", short(*amount))
            .number("count", *count as f64);
        text += &line("cli-stock-finding", args);
    }
    if report.more > 0 {
        text += &line("cli-stock-more", Args::new().number("count", report.more as f64));
    }
    session.output.print(&text)
}
