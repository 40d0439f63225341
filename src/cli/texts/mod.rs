//! `ciklo texts`: how far translations are, which of them are accepted, files for translators and back.
mod accept;
mod export;
mod import;
mod shared;
mod status;

use clap::ArgMatches;
use clap::builder::PossibleValuesParser;

pub(super) use accept::changed as accept_changed;
pub(super) use shared::language as translation;

use super::session::Session;
use super::{Command, Failure, Outcome, arguments};
use crate::language::locale::Ui;

pub(super) const COMMAND: Command = Command {
    name: "texts",
    usage: "status|accept|export|import [FILE]… [--data DIR] [--lang LANG]… [--file FILE]… [--text KEY]… [--changed] [--all] [--to LANG] [--stale] [--missing] [--cycle CYCLE]… [--topic TOPIC]… [--copy-source] [--base-url URL] [--out FILE] [--any-state] [--dry-run] [--format FORMAT]",
    arguments: own,
    run,
};

/// What the command can do, in the order of the help.
const ACTIONS: [&str; 4] = ["status", "accept", "export", "import"];

/// Forms of reports, then those of files for translators.
const FORMATS: [&str; 8] = ["text", "json", "xliff", "xliff2", "po", "tmx", "tbx", "csv"];

fn own(ui: &Ui) -> Vec<clap::Arg> {
    let action = arguments::argument(ui, "action", "cli-texts-action").value_name("ACTION").required(true);
    vec![
        action.value_parser(PossibleValuesParser::new(ACTIONS)).hide_possible_values(true),
        arguments::argument(ui, "input", "cli-texts-input").value_name("FILE").num_args(0..),
        arguments::several(ui, "lang", "LANG", "cli-texts-lang"),
        arguments::several(ui, "file", "FILE", "cli-texts-file"),
        arguments::several(ui, "text", "KEY", "cli-texts-text"),
        arguments::switch(ui, "changed", "cli-texts-changed").conflicts_with("text"),
        arguments::switch(ui, "all", "cli-texts-all").conflicts_with_all(["text", "changed"]),
        arguments::valued(ui, "to", "LANG", "cli-texts-to"),
        arguments::switch(ui, "stale", "cli-texts-stale"),
        arguments::switch(ui, "missing", "cli-texts-missing"),
        arguments::several(ui, "cycle", "CYCLE", "cli-texts-cycle"),
        arguments::several(ui, "topic", "TOPIC", "cli-texts-topic"),
        arguments::switch(ui, "copy-source", "cli-texts-copy-source"),
        arguments::valued(ui, "base-url", "URL", "cli-texts-base-url"),
        arguments::valued(ui, "out", "FILE", "cli-texts-out"),
        arguments::switch(ui, "any-state", "cli-texts-any-state"),
        arguments::switch(ui, "dry-run", "cli-texts-dry-run"),
        arguments::valued(ui, "format", "FORMAT", "cli-texts-format").value_parser(FORMATS).hide_possible_values(true),
    ]
}

fn run(session: &mut Session, matches: &ArgMatches) -> Result<Outcome, Failure> {
    match arguments::text(matches, "action").as_str() {
        "accept" => accept::run(session, matches),
        "export" => export::run(session, matches),
        "import" => import::run(session, matches),
        _ => status::run(session, matches),
    }
}
