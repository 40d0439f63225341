//! `ciklo texts status`: how far each translation is.
use clap::ArgMatches;
use serde_json::json;

use super::shared::Texts;
use crate::cli::session::Session;
use crate::cli::{Failure, Outcome, arguments};
use crate::language::locale::Args;
use crate::tools::exchange::{self, Count, LanguageStatus, State};

/// So many open texts of a language are named.
const NEXT: usize = 20;

pub(super) fn run(session: &mut Session, matches: &ArgMatches) -> Result<Outcome, Failure> {
    let texts = Texts::of(&session.files()?);
    let files = arguments::all(matches, "file");
    let mut all = Vec::new();
    for tag in texts.chosen(&arguments::all(matches, "lang"))? {
        let mut status = exchange::status(&texts.catalogue, &texts.locales, &texts.meanings, &tag)?;
        status.files.retain(|file, _| files.is_empty() || files.contains(file));
        status.open.retain(|open| files.is_empty() || files.contains(&open.file));
        all.push(status);
    }
    if arguments::chosen_format(matches) == "json" {
        session.print_json(&json!({ "format": "ciklo-texts-status/1", "languages": all }))?;
        return Ok(Outcome::Clean);
    }
    all.iter().try_for_each(|status| show(session, status, !files.is_empty()))?;
    Ok(Outcome::Clean)
}

/// A line for the language, one for each file in which something is open, and the next texts.
fn show(session: &mut Session, status: &LanguageStatus, all_files: bool) -> Result<(), Failure> {
    let line = line(session, &status.language, &status.total);
    session.output.print(&format!("{line}\n"))?;
    for (control, count) in &status.controls {
        print(session, control, count)?;
    }
    let is_open = |count: &Count| count.translated < count.texts || count.same_as_source + count.over_long > 0;
    for (group, count) in status.groups.iter().filter(|(_, count)| is_open(count)) {
        let name = session.ui.text("cli-texts-group", &Args::new().text("name", group.as_str()));
        print(session, &name, count)?;
    }
    for (file, count) in status.files.iter().filter(|(_, count)| all_files || is_open(count)) {
        print(session, file, count)?;
    }
    for open in status.open.iter().take(NEXT) {
        let state = match open.state {
            State::Missing => "missing",
            State::Stale => "stale",
            State::Unaccepted => "unaccepted",
            State::SameAsSource => "same",
        };
        let args = Args::new().text("state", state).text("key", open.key.as_str());
        let args = args.text("file", format!("{}:{}", open.file, open.line));
        let line = session.ui.text("cli-texts-open", &args.text("change", open.change.as_deref().unwrap_or("none")));
        session.output.print(&format!("    {line}\n"))?;
    }
    if let Some(more) = status.open.len().checked_sub(NEXT).filter(|more| *more > 0) {
        let line = session.ui.text("cli-texts-more", &Args::new().number("count", more as f64));
        session.output.print(&format!("    {line}\n"))?;
    }
    Ok(())
}

fn print(session: &mut Session, name: &str, count: &Count) -> Result<(), Failure> {
    let line = line(session, name, count);
    session.output.print(&format!("  {line}\n"))
}

fn line(session: &Session, name: &str, count: &Count) -> String {
    let args = Args::new()
        .text("name", name)
        .number("texts", count.texts as f64)
        .number("translated", count.translated as f64)
        .number("missing", count.missing as f64)
        .number("stale", count.stale as f64)
        .number("unaccepted", count.unaccepted as f64)
        .number("same", count.same_as_source as f64)
        .number("long", count.over_long as f64)
        .number("words", count.words_to_do as f64);
    session.ui.text("cli-texts-count", &args)
}
