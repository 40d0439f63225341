//! `ciklo texts accept`: translations recorded as good for the English texts of today.
use std::path::Path;

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

/// What accepting texts changes: files of the working copy, and what is said about it.
pub(super) struct Locks {
    /// Paths below the working copy with their new texts.
    pub(super) files: Vec<(String, String)>,
    said: Vec<(String, Accepted)>,
}

impl Locks {
    /// Accepts texts of the languages that are named, of all without a name.
    pub(super) fn of(texts: &Texts, languages: &[String], which: Accept) -> Result<Self, Failure> {
        let chosen = texts.chosen(languages)?;
        let mut all = Vec::new();
        for tag in texts.chosen(&[])? {
            // Of a language that was not chosen nothing is accepted, but the English that it depends on is kept.
            let which = if chosen.contains(&tag) { which } else { Accept::Named(&[]) };
            all.push((texts.locales.accept(&tag, &texts.meanings, which)?, tag));
        }
        known(&all, which)?;
        let locks: Vec<String> = all.iter().map(|(accepted, _)| accepted.lock.clone()).collect();
        let originals = texts.locales.originals(&locks)?;
        let mut files = vec![(format!("locales/{SOURCE_LANGUAGE}/accepted.lock"), originals)];
        let mut said = Vec::new();
        for (accepted, tag) in all.into_iter().filter(|(_, tag)| chosen.contains(tag)) {
            files.push((format!("locales/{tag}/source.lock"), accepted.lock.clone()));
            said.push((tag, accepted));
        }
        Ok(Self { files, said })
    }

    /// Says what was accepted and what was not.
    pub(super) fn report(&self, session: &mut Session) {
        self.said.iter().for_each(|(tag, accepted)| report(session, tag, accepted));
    }
}

fn write(session: &mut Session, option: &str, languages: &[String], which: Accept) -> Result<Outcome, Failure> {
    let root = writable(session, option)?;
    let locks = Locks::of(&Texts::of(&session::working_copy(&root)?), languages, which)?;
    put(&root, &locks.files)?;
    locks.report(session);
    Ok(Outcome::Clean)
}

/// Writes files of the working copy, all of them or none.
pub(super) fn put(root: &Path, files: &[(String, String)]) -> Result<(), Failure> {
    let mut all = Vec::new();
    for (path, text) in files {
        let target = system::inside(root, path);
        if let Some(folder) = target.parent() {
            system::create_directory(folder)?;
        }
        all.push((target, text.as_bytes()));
    }
    Ok(system::write_all(&all)?)
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
    let lists = [
        ("cli-texts-left", &accepted.stale),
        ("cli-texts-new", &accepted.unrecorded),
        ("cli-texts-moved", &accepted.moved),
    ];
    for (message, open) in lists.into_iter().filter(|(_, open)| !open.is_empty()) {
        let more = if open.len() > SHOWN { ", …" } else { "" };
        let keys = open.iter().take(SHOWN).map(String::as_str).collect::<Vec<_>>().join(", ");
        let args = Args::new().text("language", tag).number("count", open.len() as f64);
        let line = session.ui.text(message, &args.text("keys", format!("{keys}{more}")));
        session.output.remark(&line);
    }
}
