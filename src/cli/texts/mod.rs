//! `ciklo texts`: how far translations are, and which of them are accepted.
mod accept;
mod status;

use std::path::{Path, PathBuf};

use clap::ArgMatches;
use clap::builder::PossibleValuesParser;

pub(super) use accept::changed as accept_changed;

use super::session::{self, Session};
use super::{Command, Failure, Outcome, arguments};
use crate::base::diag::Diagnostic;
use crate::language::consistency;
use crate::language::locale::{Locales, Meanings, SOURCE_LANGUAGE, Ui};
use crate::spec::Catalogue;

pub(super) const COMMAND: Command = Command {
    name: "texts",
    usage: "status|accept [--data DIR] [--lang LANG]… [--file FILE]… [--text KEY]… [--changed] [--all] [--format FORMAT]",
    arguments: own,
    run,
};

/// What the command can do, in the order of the help.
const ACTIONS: [&str; 2] = ["status", "accept"];

fn own(ui: &Ui) -> Vec<clap::Arg> {
    let action = arguments::argument(ui, "action", "cli-texts-action").value_name("ACTION").required(true);
    vec![
        action.value_parser(PossibleValuesParser::new(ACTIONS)).hide_possible_values(true),
        arguments::several(ui, "lang", "LANG", "cli-texts-lang"),
        arguments::several(ui, "file", "FILE", "cli-texts-file"),
        arguments::several(ui, "text", "KEY", "cli-texts-text"),
        arguments::switch(ui, "changed", "cli-texts-changed").conflicts_with("text"),
        arguments::switch(ui, "all", "cli-texts-all").conflicts_with_all(["text", "changed"]),
        arguments::format(ui, &["text", "json"]),
    ]
}

fn run(session: &mut Session, matches: &ArgMatches) -> Result<Outcome, Failure> {
    match arguments::text(matches, "action").as_str() {
        "accept" => accept::run(session, matches),
        _ => status::run(session, matches),
    }
}

/// The texts and what the specifications mean by them; mistakes in them are for `ciklo lint`.
struct Texts {
    catalogue: Catalogue,
    locales: Locales,
    meanings: Meanings,
}

impl Texts {
    fn of(files: &[(String, String)]) -> Self {
        let (locales, _) = Locales::load(files.iter().map(|(path, text)| (path, text)));
        let (catalogue, _) = Catalogue::load(files);
        let meanings = consistency::meanings(&catalogue);
        Self { catalogue, locales, meanings }
    }

    /// The translations asked for; all without a choice.
    fn chosen(&self, asked: &[String]) -> Result<Vec<String>, Failure> {
        for tag in asked {
            self.locales.language(tag)?;
        }
        let tags = self.locales.tags().filter(|tag| *tag != SOURCE_LANGUAGE);
        Ok(tags.filter(|tag| asked.is_empty() || asked.iter().any(|own| own == tag)).map(str::to_owned).collect())
    }
}

/// The working copy in which something is written: that of `--data`, or the present directory if it is one.
fn writable(session: &Session, option: &str) -> Result<PathBuf, Failure> {
    let here = Path::new(".");
    match session.data().or_else(|| session::is_working_copy(here).then_some(here)) {
        Some(root) => Ok(root.to_owned()),
        None => Err(Diagnostic::global("needs-data").arg("option", option).into()),
    }
}
