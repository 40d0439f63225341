//! `ciklo check`: what a control would object to in programs.
use std::path::Path;

use clap::ArgMatches;

use super::session::Session;
use super::{Command, Failure, Outcome, arguments, cycle, program};
use crate::check::{self, Against, LabelBook};
use crate::locale::{Language, Ui};

pub(super) const COMMAND: Command =
    Command { name: "check", usage: "FILE… --control CONTROL [--lang LANG] [--format FORMAT]", arguments: own, run };

fn own(ui: &Ui) -> Vec<clap::Arg> {
    vec![
        arguments::words(ui, "file", "FILE", "cli-arg-files"),
        arguments::control(ui),
        arguments::valued(ui, "lang", "LANG", "cli-check-lang"),
        arguments::format(ui, &["text", "json"]),
    ]
}

fn run(session: &mut Session, matches: &ArgMatches) -> Result<Outcome, Failure> {
    let (catalogue, locales) = (session.catalogue()?, session.locales()?);
    let on = cycle::control(&catalogue, &arguments::text(matches, "control"))?;
    let language = matches.get_one::<String>("lang").map(|tag| cycle::language(&locales, tag)).transpose()?;
    let readers: Vec<&Language> =
        [locales.language(session.ui.tag()).ok(), locales.source()].into_iter().flatten().collect();
    let against = Against {
        catalogue: &catalogue,
        on,
        labels: &LabelBook::new(on, &locales),
        language: language.map(Language::tag),
        readers: &readers,
    };
    let mut found = Vec::new();
    let mut unreadable = None;
    for name in arguments::all(matches, "file") {
        match program::read(Path::new(&name)) {
            Ok(file) => found.extend(check::check(&file.program, &against)),
            Err(Failure::Trouble(trouble)) => {
                // The other files are checked all the same.
                if let Some(before) = unreadable.replace(trouble) {
                    session.output.complain(&before, &session.ui);
                }
            }
            Err(failure) => return Err(failure),
        }
    }
    // Nothing was found only where everything could be read.
    let silent = found.is_empty() && unreadable.is_some();
    let errors = !silent && session.report(found, arguments::chosen_format(matches))?;
    match unreadable {
        Some(trouble) => Err(Failure::Trouble(trouble)),
        None => Ok(if errors { Outcome::Errors } else { Outcome::Clean }),
    }
}
