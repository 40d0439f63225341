//! `ciklo conform`: the examples of the specifications, executed.
use clap::ArgMatches;

use super::session::{self, Session};
use super::{Command, Failure, Outcome, arguments, cycle};
use std::time::Duration;

use crate::base::diag::{Diagnostic, Severity};
use crate::language::locale::{Args, Ui};
use crate::spec::Keyword;
use crate::system::{self, Answering, NoAnswer};
use crate::tools::conform::{
    self, CaseReport, CycleReport, Mismatch, Partner, Report, Selection, Silence, Verdict, World,
};

pub(super) const COMMAND: Command = Command {
    name: "conform",
    usage: "[--control CONTROL]… [--cycle CYCLE]… [--case NAME]… [--list] [--format FORMAT] \
            [--engine CMD [--time-limit SECONDS]] [--serve]",
    arguments: own,
    run,
};

/// How long another engine may take for a case, in seconds.
const TIME_LIMIT: Duration = Duration::from_secs(10);

fn own(ui: &Ui) -> Vec<clap::Arg> {
    vec![
        arguments::several(ui, "control", "CONTROL", "cli-build-control"),
        arguments::several(ui, "cycle", "CYCLE", "cli-conform-cycle"),
        arguments::several(ui, "case", "NAME", "cli-conform-case"),
        arguments::switch(ui, "list", "cli-conform-list").conflicts_with("engine"),
        arguments::format(ui, &["text", "json", "junit"]).help(ui.text("cli-arg-report", &Args::new())),
        arguments::valued(ui, "engine", "CMD", "cli-conform-engine"),
        arguments::valued(ui, "time-limit", "SECONDS", "cli-conform-time-limit")
            .requires("engine")
            .value_parser(time_limit),
        arguments::switch(ui, "serve", "cli-conform-serve")
            .conflicts_with_all(["engine", "control", "cycle", "case", "list"]),
    ]
}

fn run(session: &mut Session, matches: &ArgMatches) -> Result<Outcome, Failure> {
    let (catalogue, locales) = (session.whole_catalogue()?, session.whole_locales()?);
    let files = session.files()?;
    let controls = cycle::controls(&catalogue, &arguments::all(matches, "control"))?;
    let controls: Vec<&str> = controls.iter().map(String::as_str).collect();
    let cycles = cycles(&arguments::all(matches, "cycle"))?;
    let names = arguments::all(matches, "case");
    let cases: Vec<&str> = names.iter().map(String::as_str).collect();
    let chosen = Selection { controls: &controls, cycles: &cycles, cases: &cases };
    let world = World { catalogue: &catalogue, locales: &locales, files: &files };
    if matches.get_flag("serve") {
        return serve(session, &world);
    }
    let all = conform::listed(&world, &chosen);
    if all.is_empty() {
        return Err(Diagnostic::global("conform-no-case").into());
    }
    if matches.get_flag("list") {
        return list(session, &all, arguments::chosen_format(matches));
    }
    let (report, found) = match matches.get_one::<String>("engine") {
        None => conform::run(&world, &chosen),
        Some(command) => {
            let limit = matches.get_one::<Duration>("time-limit").copied().unwrap_or(TIME_LIMIT);
            let mut engine = Answering::new(command, limit);
            engine.begin()?;
            conform::run_foreign(&world, &chosen, &mut Foreign(engine, command))
        }
    };
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

/// The cycles that words name, by number alone or with the keyword.
pub(super) fn cycles(words: &[String]) -> Result<Vec<(Option<Keyword>, u32)>, Failure> {
    let known = |words: &String| {
        let (keyword, number) = cycle::parse(words)?;
        let found = Keyword::by_word(&keyword);
        (keyword.is_empty() || found.is_some()).then_some((found, number))
    };
    let read = |words| known(words).ok_or_else(|| Diagnostic::global("cycle-name").arg("cycle", words.as_str()).into());
    words.iter().map(read).collect()
}

/// The cases by name, with what each proves, not executed.
fn list(session: &mut Session, cases: &[CaseReport], format: &str) -> Result<Outcome, Failure> {
    #[derive(serde::Serialize)]
    struct Listed<'c> {
        control: &'c str,
        keyword: &'c str,
        number: u32,
        cycle: &'c str,
        case: &'c str,
        place: &'c str,
        #[serde(skip_serializing_if = "Option::is_none")]
        why: Option<&'c str>,
    }
    let listed = |case: &'_ CaseReport| -> String {
        let proves = case.clauses();
        let gap = if proves.is_empty() { "" } else { "  " };
        format!("{}  {} {}  {}{gap}{proves}\n", case.control, case.keyword, case.number, case.case)
    };
    let text = match format {
        "json" => {
            let all = cases.iter().map(|case| Listed {
                control: &case.control,
                keyword: case.keyword,
                number: case.number,
                cycle: &case.cycle,
                case: &case.case,
                place: &case.place,
                why: case.why.as_deref(),
            });
            session::json(&all.collect::<Vec<_>>())?
        }
        _ => cases.iter().map(listed).collect(),
    };
    session.output.print(&text)?;
    Ok(Outcome::Clean)
}

/// Seconds as a time that passes: neither nothing nor for ever.
fn time_limit(text: &str) -> Result<Duration, String> {
    let seconds: f64 = text.parse().map_err(|_| text.to_owned())?;
    let limit = Duration::try_from_secs_f64(seconds).ok();
    limit.filter(|limit| !limit.is_zero()).ok_or_else(|| text.to_owned())
}

/// Another engine, in a process of its own.
struct Foreign<'c>(Answering, &'c str);

impl Partner for Foreign<'_> {
    fn name(&self) -> &str {
        self.1
    }

    fn ask(&mut self, line: &str) -> Result<String, Silence> {
        self.0.ask(line).map_err(|silence| match silence {
            NoAnswer::TimeLimit => Silence::TimeLimit,
            NoAnswer::TooLong => Silence::TooLong(system::LONGEST_LINE),
            NoAnswer::Ended(reason) => Silence::Ended(reason),
        })
    }
}

/// Answers requests of the protocol until there are no more.
fn serve(session: &mut Session, world: &World<'_>) -> Result<Outcome, Failure> {
    while let Some(line) = system::next_line()? {
        session.output.print(&format!("{}\n", conform::serve(world, &line)))?;
        session.output.finish()?;
        if session.output.is_closed() {
            break;
        }
    }
    Ok(Outcome::Clean)
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
            lines.extend(mismatches.iter().map(|found| mismatch(found, ui)));
            let mut more = |key: &str, text: &str| {
                if !text.is_empty() {
                    lines.push_str(&format!("      {}\n", ui.text(key, &Args::new().text("text", text))));
                }
            };
            more("cli-conform-proves", &case.clauses());
            more("cli-conform-why", case.why.as_deref().unwrap_or_default());
            more("cli-conform-place", &case.place);
            more("cli-conform-manual", &case.manual.join("; "));
            lines
        }
    }
}

/// What a report says in the language of the user, if it says it in words.
fn worded(text: &str, ui: &Ui) -> String {
    let rest = |known: &str| match text.strip_prefix(known) {
        Some(rest) if rest.is_empty() || known.ends_with(' ') => Some(rest.to_owned()),
        _ => None,
    };
    let known = conform::WORDS.iter().find_map(|(known, id)| Some((id, rest(known)?)));
    known.map_or_else(
        || text.to_owned(),
        |(id, rest)| ui.text(&format!("cli-conform-word-{id}"), &Args::new().text("rest", rest)),
    )
}

/// A difference in a line; lists next to each other, a line each.
fn mismatch(found: &Mismatch, ui: &Ui) -> String {
    if !found.expected.contains('\n') && !found.found.contains('\n') {
        let args = Args::new().text("what", found.what.as_str()).text("expected", worded(&found.expected, ui));
        return format!("      {}\n", ui.text("cli-conform-mismatch", &args.text("found", worded(&found.found, ui))));
    }
    let side = |text: &'_ str| text.lines().filter(|line| line.starts_with('{')).map(str::to_owned).collect();
    let (left, right): (Vec<String>, Vec<String>) = (side(&found.expected), side(&found.found));
    let args = Args::new().text("what", found.what.as_str());
    let args = args.number("expected", left.len() as f64).number("found", right.len() as f64);
    let mut lines = format!("      {}\n", ui.text("cli-conform-lists", &args));
    let width = left.iter().map(|line| line.chars().count()).max().unwrap_or_default();
    for index in 0..left.len().max(right.len()) {
        let cell = |side: &[String]| side.get(index).cloned().unwrap_or_else(|| "-".to_owned());
        lines.push_str(&format!("        {:>3}  {:width$}  | {}\n", index + 1, cell(&left), cell(&right)));
    }
    lines
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
    tell("cli-coverage-unexecuted", &cycle.unexecuted, cycle.executed.len() + cycle.unexecuted.len());
    tell("cli-coverage-unprovoked", &cycle.unprovoked, cycle.unprovoked.len());
    lines
}
