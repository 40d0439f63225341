//! `ciklo explain`: what a code means.
use clap::ArgMatches;

use super::session::Session;
use super::{Command, Failure, Outcome, arguments};
use crate::base::diag::Diagnostic;
use crate::language::locale::{Args, Ui};

pub(super) const COMMAND: Command = Command { name: "explain", usage: "[CODE]", arguments: own, run };

/// The messages of diagnostics have this before the code.
const PREFIX: &str = "diag-";
/// The sentences of the specifications' guards, whose codes the checker uses as well.
const GUARD: &str = "guard-";

fn own(ui: &Ui) -> Vec<clap::Arg> {
    vec![arguments::argument(ui, "code", "cli-explain-code").value_name("CODE")]
}

fn run(session: &mut Session, matches: &ArgMatches) -> Result<Outcome, Failure> {
    let locales = session.locales()?;
    let whole = Ui::new(&locales, Some(session.ui.tag()), &[]).unwrap_or_else(|_| Ui::source(&locales));
    let mut codes = session.ui.codes(PREFIX);
    let guards: Vec<&str> = whole.codes(GUARD).into_iter().filter(|code| !code.contains("__")).collect();
    let Some(code) = matches.get_one::<String>("code") else {
        codes.extend(guards);
        codes.sort_unstable();
        codes.dedup();
        for code in codes {
            session.output.print(&format!("{code}\n"))?;
        }
        return Ok(Outcome::Clean);
    };
    let guard = guards.contains(&code.as_str()) && !codes.contains(&code.as_str());
    if !guard && !codes.contains(&code.as_str()) {
        return Err(Diagnostic::global("unknown-code").arg("code", code.as_str()).into());
    }
    let (ui, prefix) = if guard { (&whole, GUARD) } else { (&session.ui, PREFIX) };
    session.output.print(&format!("{code}\n  {}\n", ui.sketch(&format!("{prefix}{code}"))))?;
    let explained = if guard { "guard" } else { code.as_str() };
    if let Some(more) = session.ui.find(&format!("explain-{explained}"), &Args::new()) {
        session.output.print(&format!("\n{more}\n"))?;
    }
    Ok(Outcome::Clean)
}
