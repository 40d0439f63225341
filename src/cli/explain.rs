//! `ciklo explain`: what a code means.
use clap::ArgMatches;

use super::session::Session;
use super::{Command, Failure, Outcome, arguments};
use crate::diag::Diagnostic;
use crate::locale::{Args, Ui};

pub(super) const COMMAND: Command = Command { name: "explain", usage: "[CODE]", arguments: own, run };

/// The messages of diagnostics have this before the code.
const PREFIX: &str = "diag-";

fn own(ui: &Ui) -> Vec<clap::Arg> {
    vec![arguments::argument(ui, "code", "cli-explain-code").value_name("CODE")]
}

fn run(session: &mut Session, matches: &ArgMatches) -> Result<Outcome, Failure> {
    let codes = session.ui.codes(PREFIX);
    let Some(code) = matches.get_one::<String>("code") else {
        for code in codes {
            session.output.print(&format!("{code}\n"))?;
        }
        return Ok(Outcome::Clean);
    };
    if !codes.contains(&code.as_str()) {
        return Err(Diagnostic::global("unknown-code").arg("code", code.as_str()).into());
    }
    let key = format!("{PREFIX}{code}");
    session.output.print(&format!("{code}\n  {}\n", session.ui.sketch(&key)))?;
    if let Some(more) = session.ui.find(&format!("explain-{code}"), &Args::new()) {
        session.output.print(&format!("\n{more}\n"))?;
    }
    Ok(Outcome::Clean)
}
