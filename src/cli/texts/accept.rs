//! `ciklo texts accept`: translations recorded as good for the English texts of today.
use clap::ArgMatches;

use super::shared::{Texts, writable};
use crate::base::diag::Diagnostic;
use crate::cli::session::{self, Session};
use crate::cli::{Failure, Outcome, arguments};
use crate::language::locale::{Accept, Accepted, Args, SOURCE_LANGUAGE};
use crate::system;

/// So many keys are named of those that remain open.
const SHOWN: usize = 20;

pub(super) fn run(session: &mut Session, matches: &ArgMatches) -> Result<Outcome, Failure> {
    let named = arguments::all(matches, "text");
    let which = match (matches.get_flag("all"), matches.get_flag("changed"), named.is_empty()) {
        (true, ..) => Accept::All,
        (_, true, _) => Accept::Changed,
        (.., false) => Accept::Named(&named),
        _ => return Err(Diagnostic::global("texts-nothing-chosen").into()),
    };
    write(session, "texts accept", &arguments::all(matches, "lang"), which)
}

/// Accepts what is new or was changed, in all languages.
pub(in crate::cli) fn changed(session: &mut Session, option: &str) -> Result<Outcome, Failure> {
    write(session, option, &[], Accept::Changed)
}

/// Accepts the texts of a language that came back from a translator.
pub(super) fn named(session: &mut Session, tag: &str, keys: &[String]) -> Result<Outcome, Failure> {
    write(session, "texts import", &[tag.to_owned()], Accept::Named(keys))
}

fn write(session: &mut Session, option: &str, languages: &[String], which: Accept) -> Result<Outcome, Failure> {
    let root = writable(session, option)?;
    let texts = Texts::of(&session::working_copy(&root)?);
    let chosen = texts.chosen(languages)?;
    let mut all = Vec::new();
    for tag in texts.chosen(&[])? {
        // Of a language that was not chosen nothing is accepted, but the English that it depends on is kept.
        let which = if chosen.contains(&tag) { which } else { Accept::Named(&[]) };
        all.push((texts.locales.accept(&tag, &texts.meanings, which)?, tag));
    }
    known(&all, which)?;
    let folder = root.join("locales");
    let locks: Vec<String> = all.iter().map(|(accepted, _)| accepted.lock.clone()).collect();
    let originals = texts.locales.originals(&locks)?;
    system::write(&folder.join(SOURCE_LANGUAGE).join("accepted.lock"), originals.as_bytes())?;
    for (accepted, tag) in all.iter().filter(|(_, tag)| chosen.contains(tag)) {
        system::write(&folder.join(tag).join("source.lock"), accepted.lock.as_bytes())?;
        report(session, tag, accepted);
    }
    Ok(Outcome::Clean)
}

/// Refuses keys that no text has that could be accepted.
fn known(all: &[(Accepted, String)], which: Accept) -> Result<(), Failure> {
    let Accept::Named(keys) = which else { return Ok(()) };
    for key in keys {
        let head = key.strip_suffix('*').unwrap_or(key);
        let is_there = |line: &str| {
            let own = line.split(' ').next().unwrap_or_default();
            own == key || key.ends_with('*') && own.starts_with(head)
        };
        if !all.iter().any(|(accepted, _)| accepted.lock.lines().any(is_there)) {
            return Err(Diagnostic::global("texts-unknown-key").arg("key", key.as_str()).into());
        }
    }
    Ok(())
}

fn report(session: &mut Session, tag: &str, accepted: &Accepted) {
    let args = Args::new().text("language", tag).number("count", accepted.taken.len() as f64);
    let line = session.ui.text("cli-texts-accepted", &args);
    session.output.remark(&line);
    let open: Vec<&str> = accepted.stale.iter().chain(&accepted.unrecorded).map(String::as_str).collect();
    if !open.is_empty() {
        let more = if open.len() > SHOWN { ", …" } else { "" };
        let keys = open.iter().take(SHOWN).copied().collect::<Vec<_>>().join(", ");
        let args = Args::new().text("language", tag).number("count", open.len() as f64);
        let line = session.ui.text("cli-texts-left", &args.text("keys", format!("{keys}{more}")));
        session.output.remark(&line);
    }
}
