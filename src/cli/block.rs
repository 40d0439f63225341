//! `ciklo block`: the NC block of a cycle.
use clap::{ArgMatches, value_parser};

use super::session::{self, Session};
use super::{Command, Failure, Outcome, arguments, cycle};
use crate::language::label::{self, Request};
use crate::language::locale::Ui;

pub(super) const COMMAND: Command = Command {
    name: "block",
    usage: "CYCLE [NAME=VALUE]… --control CONTROL [--lang LANG] [--number N] [--form FORM] [--without FIELD]…",
    arguments: own,
    run,
};

fn own(ui: &Ui) -> Vec<clap::Arg> {
    vec![
        arguments::words(ui, "cycle", "CYCLE", "cli-block-values"),
        arguments::control(ui),
        arguments::language(ui),
        arguments::valued(ui, "number", "N", "cli-block-number").value_parser(value_parser!(u32)),
        arguments::valued(ui, "form", "FORM", "cli-block-form"),
        arguments::several(ui, "without", "FIELD", "cli-block-without"),
    ]
}

fn run(session: &mut Session, matches: &ArgMatches) -> Result<Outcome, Failure> {
    let (catalogue, locales) = (session.catalogue()?, session.locales()?);
    let on = cycle::control(&catalogue, &arguments::text(matches, "control"))?;
    let language = cycle::language_for(&locales, on, &session.ui, matches)?;
    let (values, words): (Vec<String>, Vec<String>) =
        arguments::all(matches, "cycle").into_iter().partition(|word| word.contains('='));
    let cycle = cycle::find(on, &words.join(" "))?;
    let values: Vec<(String, String)> = values
        .iter()
        .filter_map(|word| word.split_once('='))
        .map(|(name, value)| (name.trim().to_owned(), value.trim().to_owned()))
        .collect();
    let without = arguments::all(matches, "without");
    let request = Request {
        values: &values,
        without: &without,
        form: matches.get_one::<String>("form").map(String::as_str),
        number: matches.get_one::<u32>("number").copied(),
    };
    let block = label::block(on, cycle, language, &request).map_err(session::in_texts(&locales))?;
    session.output.print(&block)?;
    Ok(Outcome::Clean)
}
