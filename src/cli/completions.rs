//! `ciklo completions`: what a shell needs to complete words of the command line.
use clap::{ArgMatches, builder::PossibleValuesParser};
use clap_complete::{Shell, generate};

use super::session::Session;
use super::{Command, Failure, Outcome, arguments, usage};
use crate::language::locale::Ui;

pub(super) const COMMAND: Command = Command { name: "completions", usage: "SHELL", arguments: own, run };

/// The shells by name.
const SHELLS: [(&str, Shell); 5] = [
    ("bash", Shell::Bash),
    ("elvish", Shell::Elvish),
    ("fish", Shell::Fish),
    ("powershell", Shell::PowerShell),
    ("zsh", Shell::Zsh),
];

fn own(ui: &Ui) -> Vec<clap::Arg> {
    let shell = arguments::argument(ui, "shell", "cli-completions-shell").value_name("SHELL").required(true);
    vec![shell.value_parser(PossibleValuesParser::new(SHELLS.map(|(name, _)| name))).hide_possible_values(true)]
}

fn run(session: &mut Session, matches: &ArgMatches) -> Result<Outcome, Failure> {
    let name = arguments::text(matches, "shell");
    if let Some((_, shell)) = SHELLS.into_iter().find(|(own, _)| *own == name) {
        let mut script = Vec::new();
        generate(shell, &mut usage::command_line(&session.ui), "ciklo", &mut script);
        session.output.write(&script)?;
    }
    Ok(Outcome::Clean)
}
