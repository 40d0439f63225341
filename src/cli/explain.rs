//! `ciklo explain`: what a code means.
use clap::ArgMatches;

use super::session::Session;
use super::{Command, Failure, Outcome, arguments};
use crate::base::diag::Diagnostic;
use crate::base::renamed;
use crate::language::locale::{Args, Ui};
use crate::spec::Catalogue;

pub(super) const COMMAND: Command = Command { name: "explain", usage: "[CODE]", arguments: own, run };

/// The messages of diagnostics have this before the code.
const PREFIX: &str = "diag-";
/// The sentences of the specifications' guards, whose codes the checker uses as well.
const GUARD: &str = "guard-";

/// Shown in a gap for which there is no word.
const UNKNOWN: &str = "…";

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
    let (old, code) = (code.as_str(), renamed::present(code));
    let guard = guards.contains(&code) && !codes.contains(&code);
    if !guard && !codes.contains(&code) {
        return Err(Diagnostic::global("unknown-code").arg("code", code).into());
    }
    if code != old {
        let line = session.ui.text("cli-explain-renamed", &Args::new().text("old", old).text("code", code));
        session.output.print(&format!("{line}\n\n"))?;
    }
    let (ui, prefix) = if guard { (&whole, GUARD) } else { (&session.ui, PREFIX) };
    let data = session.catalogue()?;
    let (key, word) = (format!("{prefix}{code}"), |name: &str| gap(name, &data, &whole, &session.ui));
    let sentence = ui.filled(&key, &word).unwrap_or_else(|| filled(&ui.sketch(&key), &word));
    session.output.print(&format!("{code}\n  {sentence}\n"))?;
    let explained = |code: &str| session.ui.find(&format!("explain-{code}"), &Args::new());
    if let Some(more) = explained(code).or_else(|| explained("guard").filter(|_| guard)) {
        session.output.print(&format!("\n{more}\n"))?;
    }
    Ok(Outcome::Clean)
}

/// A sentence with its gaps, `‹name›`, filled.
fn filled(sentence: &str, gap: &dyn Fn(&str) -> String) -> String {
    let mut text = String::with_capacity(sentence.len());
    let mut rest = sentence;
    while let Some((before, inside)) = rest.split_once('‹') {
        let Some((name, after)) = inside.split_once('›') else { break };
        text.push_str(before);
        text.push_str(&gap(name));
        rest = after;
    }
    text + rest
}

/// What a reader sees in a gap: a machine datum by the names that the controls print, a parameter by its name, anything
/// else by a word for it, or dots.
fn gap(name: &str, data: &Catalogue, whole: &Ui<'_>, ui: &Ui<'_>) -> String {
    if let Some(datum) = name.strip_prefix("mp-") {
        let printed = data.controls.values().flat_map(|on| &on.control.data.0);
        let mut names: Vec<&str> =
            printed.filter(|(own, _)| own.as_str() == datum).map(|(_, name)| &*name.text).collect();
        names.sort_unstable();
        names.dedup();
        return if names.is_empty() { UNKNOWN.to_owned() } else { names.join(" / ") };
    }
    // A text that refers to another one has it in place.
    if let Some(text) = whole.find(name, &Args::new()) {
        return text;
    }
    let word = match name.strip_prefix("q-") {
        Some(parameter) => whole.find(&format!("parameter-{parameter}"), &Args::new()),
        None => ui.find(&format!("gap-{name}"), &Args::new()),
    };
    word.map_or_else(|| UNKNOWN.to_owned(), |word| format!("‹{word}›"))
}
