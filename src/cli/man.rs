//! `ciklo man`: the pages for `man`, made from the help.
//!
//! The headings of such pages are those that `man` looks for, in English, so the pages are in English.
use std::path::Path;

use clap::ArgMatches;
use clap_mangen::Man;

use super::session::{Session, interface};
use super::{Command, Failure, Outcome, arguments, usage};
use crate::base::diag::Diagnostic;
use crate::language::locale::{Args, Ui};
use crate::system;

pub(super) const COMMAND: Command = Command { name: "man", usage: "[--out DIR]", arguments: own, run };

fn own(ui: &Ui) -> Vec<clap::Arg> {
    vec![arguments::valued(ui, "out", "DIR", "cli-man-out")]
}

fn run(session: &mut Session, matches: &ArgMatches) -> Result<Outcome, Failure> {
    let locales = interface(None);
    let root = usage::command_line(&Ui::source(&locales));
    let Some(out) = matches.get_one::<String>("out") else {
        let text = page(root)?;
        session.output.write(&text)?;
        return Ok(Outcome::Clean);
    };
    system::create_directory(Path::new(out))?;
    let commands: Vec<clap::Command> = root.get_subcommands().cloned().collect();
    let named = |command: clap::Command| {
        let name = format!("ciklo-{}", command.get_name());
        command.name(name)
    };
    for command in std::iter::once(root).chain(commands.into_iter().map(named)) {
        let path = system::inside(Path::new(out), &format!("{}.1", command.get_name()));
        system::write(&path, &page(command)?)?;
        let line = session.ui.text("cli-written", &Args::new().text("path", path.display().to_string()));
        session.output.remark(&line);
    }
    Ok(Outcome::Clean)
}

fn page(command: clap::Command) -> Result<Vec<u8>, Failure> {
    let mut text = Vec::new();
    let rendered = Man::new(command).render(&mut text);
    rendered.map_err(|error| Diagnostic::global("internal").arg("detail", error.to_string()))?;
    Ok(text)
}
