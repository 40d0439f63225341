//! `ciklo certify`: what a folder of programs says of the post-processor that wrote them.
use std::path::{Path, PathBuf};

use clap::ArgMatches;
use serde::Serialize;

use super::jobs::{Job, no_programs};
use super::program::PROGRAMS;
use super::progress::Progress;
use super::project::{CheckedProgram, Library, Tables};
use super::session::{Session, json};
use super::{Command, Failure, Outcome, arguments, cycle, program};
use crate::base::diag::{Diagnostic, Severity};
use crate::check::{Against, Facts, LabelBook, Settings, check_in};
use crate::language::locale::{Args, Ui};
use crate::system::{self, Below};
use crate::tools::certify::{CycleReport, ProgramReport, RuleReport, Tally, Verdict};

pub(super) const COMMAND: Command = Command {
    name: "certify",
    usage: "PATH… --control CONTROL [--fail-on LEVEL] [--format FORMAT]",
    arguments: own,
    run,
};

/// The format of the document.
const FORMAT: &str = "ciklo-certify/1";

fn own(ui: &Ui) -> Vec<clap::Arg> {
    vec![
        arguments::words(ui, "file", "PATH", "cli-certify-path"),
        arguments::control(ui),
        arguments::fail_on(ui),
        arguments::format(ui, &["text", "json"]),
    ]
}

#[derive(Serialize)]
struct Report<'r> {
    format: &'static str,
    control: &'r str,
    verdict: &'static str,
    programs: &'r [ProgramReport],
    cycles: Vec<CycleReport>,
    rules: Vec<RuleReport>,
}

fn run(session: &mut Session, matches: &ArgMatches) -> Result<Outcome, Failure> {
    let (catalogue, locales) = (session.catalogue()?, session.locales()?);
    let (on, software) = cycle::control_and_software(&catalogue, &arguments::text(matches, "control"))?;
    let labels = LabelBook::new(on, &locales);
    let against = Against {
        catalogue: &catalogue,
        on,
        labels: &labels,
        language: None,
        software: software.as_deref(),
        readers: &[],
    };
    let (mut jobs, mut empty, mut troubles) = (Vec::new(), Vec::new(), Vec::new());
    for name in arguments::all(matches, "file") {
        let Below { files: found, troubles: hidden, passed_over: over } =
            system::files_below(Path::new(&name), &PROGRAMS, true);
        if found.is_empty() && hidden.is_empty() {
            empty.push(no_programs(&name));
        }
        troubles.extend(hidden.into_iter().map(Diagnostic::from));
        session.passed_over(&over);
        let named = found == [PathBuf::from(&name)];
        jobs.extend(found.into_iter().map(|path| Job {
            path,
            on,
            software: software.clone(),
            settings: Settings::default(),
            named,
        }));
    }
    let library = Library::new(jobs.iter().map(|job| job.path.clone()).collect());
    let tables = Tables::new(&[])?;
    let files = session.engine_files()?;
    let progress = Progress::new(session.ui.text("cli-checking", &Args::new()), jobs.len());
    let mut tally = Tally::new(arguments::chosen_fail_on(matches).unwrap_or(Severity::Error));
    for job in &jobs {
        match program::understand(&job.path, &catalogue) {
            Ok(file) => {
                let program = CheckedProgram::new(&library, &tables, job, &against, Some(&files));
                let found = file.findings(check_in(&file.program, &against, &program));
                tally.add(&job.path.display().to_string(), &Facts::of(&file.program, &against), &found);
            }
            Err(Failure::Trouble(trouble)) => troubles.push(*trouble),
            Err(failure) => return Err(failure),
        }
        progress.step();
    }
    drop(progress);
    let verdict = match (tally.count(Verdict::Fail), tally.count(Verdict::OutOfSubset)) {
        (0, 0) if empty.is_empty() => Verdict::Pass,
        (0, 0) => Verdict::Fail,
        (0, _) => Verdict::OutOfSubset,
        _ => Verdict::Fail,
    };
    if arguments::chosen_format(matches) == "json" {
        let report = Report {
            format: FORMAT,
            control: on.id(),
            verdict: verdict.as_str(),
            programs: tally.programs(),
            cycles: tally.cycles(),
            rules: tally.rules(),
        };
        let document = json(&report)?;
        session.output.print(&document)?;
    } else {
        tell(session, &on.control.title, &tally)?;
    }
    empty.iter().for_each(|empty| session.output.complain(empty, &session.ui));
    let last = troubles.pop();
    troubles.iter().for_each(|trouble| session.output.complain(trouble, &session.ui));
    match last {
        Some(trouble) => Err(trouble.into()),
        None => Ok(if verdict == Verdict::Fail || !empty.is_empty() { Outcome::Errors } else { Outcome::Clean }),
    }
}

fn tell(session: &mut Session, control: &str, tally: &Tally) -> Result<(), Failure> {
    let mut lines = Vec::new();
    for own in tally.programs().iter().filter(|own| own.verdict != Verdict::Pass) {
        let args = Args::new().text("file", own.file.as_str()).text("verdict", own.verdict.as_str());
        let args = args.number("errors", own.errors as f64).number("warnings", own.warnings as f64);
        lines.push(session.ui.text("cli-certify-program", &args));
    }
    for own in tally.cycles() {
        let args = Args::new().text("cycle", own.cycle).text("verdict", own.verdict.as_str());
        let args = args.number("count", own.definitions as f64).number("wrong", own.wrong as f64);
        lines.push(session.ui.text("cli-certify-cycle", &args));
    }
    for own in tally.rules() {
        let args = Args::new()
            .text("rule", own.rule)
            .text("severity", session.ui.severity(own.severity))
            .text("first", own.first);
        let args = args.number("count", own.findings as f64).number("programs", own.programs as f64);
        lines.push(session.ui.text("cli-certify-rule", &args));
    }
    let count = |verdict| tally.count(verdict) as f64;
    let args = Args::new().text("control", control).number("count", tally.programs().len() as f64);
    let args = args.number("pass", count(Verdict::Pass)).number("fail", count(Verdict::Fail));
    lines.push(session.ui.text("cli-certified", &args.number("out", count(Verdict::OutOfSubset))));
    for line in lines {
        session.output.print(&format!("{line}\n"))?;
    }
    Ok(())
}
