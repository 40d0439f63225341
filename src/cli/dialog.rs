//! `ciklo dialog`: what a control asks for a cycle.
use clap::ArgMatches;

use super::session::Session;
use super::{Command, Failure, Outcome, arguments, cycle, session};
use crate::language::locale::Ui;
use crate::output::dialog;

pub(super) const COMMAND: Command =
    Command { name: "dialog", usage: "CYCLE --control CONTROL [--lang LANG] [--format FORMAT]", arguments: own, run };

fn own(ui: &Ui) -> Vec<clap::Arg> {
    vec![
        arguments::words(ui, "cycle", "CYCLE", "cli-arg-cycle"),
        arguments::control(ui),
        arguments::language(ui),
        arguments::format(ui, &["text", "json"]),
    ]
}

fn run(session: &mut Session, matches: &ArgMatches) -> Result<Outcome, Failure> {
    let (catalogue, locales) = (session.catalogue()?, session.locales()?);
    let on = cycle::control(&catalogue, &arguments::text(matches, "control"))?;
    let language = cycle::language_for(&locales, on, &session.ui, matches)?;
    let cycle = cycle::find(on, &arguments::all(matches, "cycle").join(" "))?;
    let dialog = dialog::dialog(on, cycle, language).map_err(session::in_texts(&locales))?;
    let text = match arguments::chosen_format(matches) {
        "json" => session::json(&dialog)?,
        _ => dialog::render(&dialog, language).map_err(session::in_texts(&locales))?,
    };
    session.output.print(&text)?;
    Ok(Outcome::Clean)
}
