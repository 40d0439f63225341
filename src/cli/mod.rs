//! The command `ciklo`: one file a command, and what they share.
//!
//! Exit codes: 0 clean, 1 errors were found in what was given, 2 the command could not be carried out
//! (wrong words on the command line, a file that cannot be read or written). Whether someone reads the result
//! to its end changes none of them. Invariant: only this module and `system` touch files, environment and
//! terminal, and no command holds knowledge that a library module could hold.

mod annotations;
mod arguments;
mod block;
mod build;
mod by_klartext;
mod cache;
mod certify;
mod check;
mod compare;
mod completions;
mod conform;
mod consequences;
mod convert;
mod coverage;
mod cycle;
mod dialect;
mod dialog;
mod dry_run;
mod envelope;
mod execution;
mod explain;
mod export;
mod figure;
mod fmt;
mod jobs;
mod lint;
mod man;
mod mend;
mod neighbours;
mod parse;
mod plot;
mod program;
mod progress;
mod project;
mod run;
mod scene;
mod schema;
mod serve;
mod session;
mod stock;
mod texts;
mod translate;
mod usage;

use std::ffi::OsString;
use std::process::ExitCode;

use clap::ArgMatches;

use crate::base::diag::Diagnostic;
use crate::language::locale::{Locales, Ui};
use crate::system;
use crate::tools::exchange::Pseudo;
use session::{Output, Session};

/// How a command ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Outcome {
    /// Nothing was wrong.
    Clean,
    /// Errors were found and reported.
    Errors,
}

/// Why a command could not be carried out.
#[derive(Debug)]
enum Failure {
    /// Something outside, or a wrong word.
    Trouble(Box<Diagnostic>),
    /// The data that everything is made from has mistakes.
    Data(Vec<Diagnostic>),
}

impl From<Diagnostic> for Failure {
    fn from(diagnostic: Diagnostic) -> Self {
        Self::Trouble(Box::new(diagnostic))
    }
}

impl From<system::Trouble> for Failure {
    fn from(trouble: system::Trouble) -> Self {
        Diagnostic::from(trouble).into()
    }
}

impl From<crate::language::locale::LocaleError> for Failure {
    fn from(error: crate::language::locale::LocaleError) -> Self {
        Diagnostic::from(error).into()
    }
}

/// What a command has to say about itself.
struct Command {
    name: &'static str,
    /// The words after the name; placeholders are in capitals.
    usage: &'static str,
    arguments: fn(&Ui) -> Vec<clap::Arg>,
    run: fn(&mut Session, &ArgMatches) -> Result<Outcome, Failure>,
}

/// All commands, in the order of the help.
static COMMANDS: &[Command] = &[
    build::COMMAND,
    serve::COMMAND,
    dialog::COMMAND,
    figure::COMMAND,
    block::COMMAND,
    parse::COMMAND,
    check::COMMAND,
    translate::COMMAND,
    convert::COMMAND,
    compare::COMMAND,
    fmt::COMMAND,
    certify::COMMAND,
    run::COMMAND,
    plot::COMMAND,
    scene::COMMAND,
    conform::COMMAND,
    coverage::COMMAND,
    lint::COMMAND,
    texts::COMMAND,
    schema::COMMAND,
    explain::COMMAND,
    export::COMMAND,
    completions::COMMAND,
    man::COMMAND,
];

const EXIT_ERRORS: u8 = 1;
const EXIT_TROUBLE: u8 = 2;

/// Carries out a command line, the program's name first.
pub fn main(words: impl IntoIterator<Item = OsString>) -> ExitCode {
    system::outlive_limits();
    let words: Vec<OsString> = words.into_iter().collect();
    let pseudo = usage::pseudo(&words);
    let locales = session::interface(pseudo);
    let mut output = Output::new();
    // The pseudo-language is there to be seen, whatever language scripts or aliases ask for.
    let asked = pseudo.map(|kind| kind.tag().to_owned()).or_else(|| usage::interface_language(&words));
    let environment = ["LC_ALL", "LC_MESSAGES", "LANG"].map(system::variable);
    let environment: Vec<Option<&str>> = environment.iter().map(Option::as_deref).collect();
    let copy = usage::data(&words).and_then(|root| session::interface_of(&root, pseudo));
    let ui = match &copy {
        Some(copy) => Ui::of_copy(copy, &locales, asked.as_deref(), &environment),
        None => Ui::new(&locales, asked.as_deref(), &environment),
    };
    let ui = match ui {
        Ok(ui) => ui,
        Err(error) => {
            let ui = Ui::new(&locales, None, &environment).unwrap_or_else(|_| Ui::source(&locales));
            output.complain(&error.into(), &ui);
            return ExitCode::from(EXIT_TROUBLE);
        }
    };
    let result = match usage::command_line(&ui).try_get_matches_from(words) {
        Ok(matches) => carry_out(&ui, &mut output, &matches, &locales, pseudo),
        Err(error) => usage::explain(&error, &ui, &mut output),
    };
    let result = result.and_then(|outcome| output.finish().map(|()| outcome));
    match result {
        Ok(Outcome::Clean) => ExitCode::SUCCESS,
        Ok(Outcome::Errors) => ExitCode::from(EXIT_ERRORS),
        Err(Failure::Trouble(diagnostic)) => {
            output.complain(&diagnostic, &ui);
            ExitCode::from(EXIT_TROUBLE)
        }
        Err(Failure::Data(diagnostics)) => {
            diagnostics.iter().for_each(|diagnostic| output.complain(diagnostic, &ui));
            ExitCode::from(EXIT_ERRORS)
        }
    }
}

fn carry_out(
    ui: &Ui,
    output: &mut Output,
    matches: &ArgMatches,
    interface: &Locales,
    pseudo: Option<Pseudo>,
) -> Result<Outcome, Failure> {
    let Some((name, own)) = matches.subcommand() else { return Ok(Outcome::Clean) };
    let Some(command) = COMMANDS.iter().find(|command| command.name == name) else { return Ok(Outcome::Clean) };
    let data = matches.get_one::<std::path::PathBuf>(arguments::DATA);
    let data = data.map(std::path::PathBuf::as_path);
    let mut session = Session::new(*ui, output, interface, data).with_pseudo(pseudo);
    let outcome = (command.run)(&mut session, own);
    session.sound().and(outcome)
}
