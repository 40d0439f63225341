//! `ciklo conform`: the examples of the specifications, executed.
use clap::ArgMatches;

use super::session::{self, Session};
use super::{Command, Failure, Outcome, arguments, cycle};
use crate::conform::{self, CaseReport, CycleReport, Report, Verdict, World};
use crate::diag::Severity;
use crate::locale::{Args, Ui};

pub(super) const COMMAND: Command =
    Command { name: "conform", usage: "[--control CONTROL]… [--format FORMAT]", arguments: own, run };

fn own(ui: &Ui) -> Vec<clap::Arg> {
    vec![
        arguments::several(ui, "control", "CONTROL", "cli-build-control"),
        arguments::format(ui, &["text", "json", "junit"]).help(ui.text("cli-arg-report", &Args::new())),
    ]
}

fn run(session: &mut Session, matches: &ArgMatches) -> Result<Outcome, Failure> {
    let (catalogue, locales) = (session.catalogue()?, session.locales()?);
    let files = session.files()?;
    let controls = arguments::all(matches, "control");
    for id in &controls {
        cycle::control(&catalogue, id)?;
    }
    let controls: Vec<&str> = controls.iter().map(String::as_str).collect();
    let world = World { catalogue: &catalogue, locales: &locales, files: &files };
    let (report, found) = conform::run(&world, &controls);
    let text = match arguments::chosen_format(matches) {
        "json" => session::json(&report)?,
        "junit" => conform::junit(&report),
        _ => text(&report, &session.ui),
    };
    session.output.print(&text)?;
    let line = session.ui.text("cli-conform-summary", &counts(&report));
    session.output.remark(&line);
    found.iter().for_each(|diagnostic| session.output.complain(diagnostic, &session.ui));
    let wrong = found.iter().any(|diagnostic| diagnostic.severity == Severity::Error);
    Ok(if wrong || !report.is_clean() { Outcome::Errors } else { Outcome::Clean })
}

fn counts(report: &Report) -> Args<'static> {
    let count = |wanted: fn(&Verdict) -> bool| report.count(wanted) as f64;
    Args::new()
        .number("pass", count(|verdict| matches!(verdict, Verdict::Pass)))
        .number("fail", count(|verdict| matches!(verdict, Verdict::Fail { .. })))
        .number("out", count(|verdict| matches!(verdict, Verdict::OutOfSubset { .. })))
        .number("skipped", count(|verdict| matches!(verdict, Verdict::Skipped { .. })))
}

fn text(report: &Report, ui: &Ui) -> String {
    let mut text = String::new();
    for cycle in &report.cycles {
        text.push_str(&format!("{}  {} {} {}\n", cycle.control, cycle.keyword, cycle.number, cycle.name));
        let own = |case: &&CaseReport| {
            case.control == cycle.control && case.keyword == cycle.keyword && case.number == cycle.number
        };
        for case in report.cases.iter().filter(own) {
            text.push_str(&case_lines(case, ui));
        }
        text.push_str(&cycle_lines(cycle, ui));
    }
    text
}

fn case_lines(case: &CaseReport, ui: &Ui) -> String {
    let word = |name: &str| ui.text(&format!("cli-conform-{name}"), &Args::new());
    match &case.verdict {
        Verdict::Pass => format!("  {}  {}\n", word("pass"), case.case),
        Verdict::OutOfSubset { reason } => format!("  {}  {}: {reason}\n", word("out"), case.case),
        Verdict::Skipped { reason } => format!("  {}  {}: {reason}\n", word("skipped"), case.case),
        Verdict::Fail { mismatches } => {
            let mut lines = format!("  {}  {}\n", word("fail"), case.case);
            for found in mismatches {
                let args = Args::new()
                    .text("what", found.what.as_str())
                    .text("expected", found.expected.as_str())
                    .text("found", found.found.as_str());
                lines.push_str(&format!("      {}\n", ui.text("cli-conform-mismatch", &args)));
            }
            lines
        }
    }
}

fn cycle_lines(cycle: &CycleReport, ui: &Ui) -> String {
    let mut lines = String::new();
    let mut tell = |key: &str, ids: &[String], of: usize| {
        if !ids.is_empty() {
            let args =
                Args::new().number("count", ids.len() as f64).number("of", of as f64).text("ids", ids.join(", "));
            lines.push_str(&format!("    {}\n", ui.text(key, &args)));
        }
    };
    tell("cli-coverage-pending", &cycle.pending, cycle.pending.len());
    tell("cli-coverage-unexecuted", &cycle.unexecuted, cycle.executed.len() + cycle.unexecuted.len());
    tell("cli-coverage-unprovoked", &cycle.unprovoked, cycle.unprovoked.len());
    lines
}
