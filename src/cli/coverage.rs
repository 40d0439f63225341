//! `ciklo coverage`: what is complete and what is not.
use clap::ArgMatches;

use super::session::{self, Session};
use super::{Command, Failure, Outcome, arguments, cycle};
use crate::language::locale::{Args, Locales, Ui};
use crate::spec::{Catalogue, CycleKey};
use crate::tools::conform::{self, Selection, World};
use crate::tools::coverage::{self, CycleCoverage, Executed, LeftOut};

pub(super) const COMMAND: Command =
    Command {
        name: "coverage", usage: "[--control CONTROL]… [--lang LANG]… [--format FORMAT]", arguments: own, run
    };

/// How many ids a line of the text shows; JSON has them all.
const SHOWN: usize = 6;

fn own(ui: &Ui) -> Vec<clap::Arg> {
    vec![
        arguments::several(ui, "control", "CONTROL", "cli-build-control"),
        arguments::several(ui, "lang", "LANG", "cli-build-lang"),
        arguments::format(ui, &["text", "json"]),
    ]
}

fn run(session: &mut Session, matches: &ArgMatches) -> Result<Outcome, Failure> {
    let (catalogue, locales) = (session.whole_catalogue()?, session.whole_locales()?);
    let languages = arguments::all(matches, "lang");
    let controls = cycle::controls(&catalogue, &arguments::all(matches, "control"))?;
    for tag in &languages {
        cycle::language(&locales, tag)?;
    }
    let executed = executed(&catalogue, &locales, &session.files()?);
    let mut report = coverage::coverage(&catalogue, &locales, &executed)?;
    report.controls.retain(|control| controls.is_empty() || controls.contains(&control.control));
    for cycle in report.controls.iter_mut().flat_map(|control| &mut control.cycles) {
        cycle.texts.retain(|text| languages.is_empty() || languages.contains(&text.language));
    }
    if arguments::chosen_format(matches) == "json" {
        session.output.print(&session::json(&report)?)?;
        return Ok(Outcome::Clean);
    }
    for control in &report.controls {
        let args = Args::new()
            .text("control", control.control.as_str())
            .text("title", control.title.as_str())
            .number("described", control.described as f64)
            .number("named", control.named_only as f64);
        session.output.print(&format!("{}\n", session.ui.text("cli-coverage-control", &args)))?;
        for cycle in &control.cycles {
            for line in lines(cycle, &session.ui) {
                session.output.print(&line)?;
            }
        }
        session.output.print("\n")?;
    }
    Ok(Outcome::Clean)
}

/// Runs the examples to see what they leave out.
fn executed(catalogue: &Catalogue, locales: &Locales, files: &[(String, String)]) -> Executed {
    let (report, _) = conform::run(&World { catalogue, locales, files }, &Selection::default());
    let mut executed = Executed::new();
    for cycle in report.cycles {
        let keys = catalogue.on(&cycle.control).into_iter().flat_map(|on| on.cycles.keys());
        let own = |key: &&CycleKey| key.number == cycle.number && key.keyword.as_str() == cycle.keyword;
        if let Some(key) = keys.copied().find(|key| own(&key)) {
            let left_out = LeftOut {
                unexecuted: cycle.unexecuted.into_iter().collect(),
                unprovoked: cycle.unprovoked.into_iter().collect(),
            };
            executed.insert((cycle.control, key), left_out);
        }
    }
    executed
}

fn lines(cycle: &CycleCoverage, ui: &Ui) -> Vec<String> {
    let mut lines = vec![format!("  {} {} {}\n", cycle.keyword, cycle.number, cycle.name)];
    let mut tell = |key: &str, ids: &[String], of: usize, language: &str| {
        if !ids.is_empty() {
            let args = Args::new()
                .number("count", ids.len() as f64)
                .number("of", of as f64)
                .text("language", language)
                .text("ids", some(ids));
            lines.push(format!("      {}\n", ui.text(key, &args)));
        }
    };
    for text in &cycle.texts {
        tell("cli-coverage-missing", &text.missing, text.needed, &text.language);
        tell("cli-coverage-stale", &text.stale, text.needed, &text.language);
    }
    tell("cli-coverage-unexecuted", &cycle.unexecuted, cycle.sentences, "");
    tell("cli-coverage-unprovoked", &cycle.unprovoked, cycle.unprovoked.len(), "");
    tell("cli-coverage-figures", &cycle.not_in_figures, cycle.measurable, "");
    if cycle.is_complete() {
        lines.push(format!("      {}\n", ui.text("cli-coverage-complete", &Args::new())));
    }
    lines
}

fn some(ids: &[String]) -> String {
    let more = if ids.len() > SHOWN { ", …" } else { "" };
    let shown: Vec<&str> = ids.iter().take(SHOWN).map(String::as_str).collect();
    format!("{}{more}", shown.join(", "))
}
