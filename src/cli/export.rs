//! `ciklo export`: all cycles of a control, as JSON.
use clap::ArgMatches;

use super::session::Session;
use super::{Command, Failure, Outcome, arguments, cycle, session};
use crate::language::locale::Ui;
use crate::output::export;

pub(super) const COMMAND: Command =
    Command { name: "export", usage: "--control CONTROL [--lang LANG]", arguments: own, run };

fn own(ui: &Ui) -> Vec<clap::Arg> {
    vec![arguments::control(ui), arguments::language(ui)]
}

fn run(session: &mut Session, matches: &ArgMatches) -> Result<Outcome, Failure> {
    let (catalogue, locales) = (session.catalogue()?, session.locales()?);
    let on = cycle::control(&catalogue, &arguments::text(matches, "control"))?;
    let language = cycle::language_for(&locales, on, &session.ui, matches)?;
    let export = export::export(on, language).map_err(session::in_texts(&locales))?;
    session.output.print(&session::json(&export)?)?;
    Ok(Outcome::Clean)
}
