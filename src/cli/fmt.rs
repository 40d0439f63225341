//! `ciklo fmt`: programs laid out anew where they are.
use std::path::Path;

use clap::ArgMatches;

use super::session::Session;
use super::{Command, Failure, Outcome, arguments, mend, program};
use crate::base::diag::{Diagnostic, visible};
use crate::check::{Against, LabelBook};
use crate::language::locale::{Args, Ui};
use crate::program::layout;
use crate::program::table::{Table, TableKind};
use crate::system::{self, Seen};

pub(super) const COMMAND: Command = Command { name: "fmt", usage: "PATH… [--check [--diff]]", arguments: own, run };

fn own(ui: &Ui) -> Vec<clap::Arg> {
    vec![
        arguments::words(ui, "file", "PATH", "cli-fmt-path"),
        arguments::switch(ui, "check", "cli-fmt-check"),
        arguments::switch(ui, "diff", "cli-fmt-diff").requires("check"),
    ]
}

fn run(session: &mut Session, matches: &ArgMatches) -> Result<Outcome, Failure> {
    let (catalogue, locales) = (session.catalogue()?, session.locales()?);
    // Labels stay as they are, so any control can say whether the program stays the same.
    let Some(on) = catalogue.controls.values().next() else { return Ok(Outcome::Clean) };
    let labels = LabelBook::new(on, &locales);
    let against = Against { catalogue: &catalogue, on, labels: &labels, language: None, software: None, readers: &[] };
    let (mut count, mut troubles) = (0, Vec::new());
    for name in arguments::all(matches, "file") {
        let extensions = [&program::PROGRAMS[..], &program::TABLES[..]].concat();
        let below = system::files_below(Path::new(&name), &extensions, false);
        troubles.extend(below.troubles.into_iter().map(Diagnostic::from));
        session.passed_over(&below.passed_over);
        for path in below.files {
            let only_check = matches.get_flag("check").then(|| matches.get_flag("diff"));
            let done = match TableKind::of_file(&path.to_string_lossy()) {
                Some(kind) => table(session, &path, kind, only_check),
                None => match program::other_table(&path) {
                    // The columns of a table are nothing that blocks have.
                    Ok(Some(_)) => Ok(false),
                    Ok(None) => file(session, &path, &against, only_check),
                    Err(failure) => Err(failure),
                },
            };
            match done {
                Ok(changed) => count += usize::from(changed),
                Err(Failure::Trouble(trouble)) => troubles.push(*trouble),
                // A table that cannot be read; the other files are laid out all the same.
                Err(Failure::Data(found)) => troubles.extend(found),
            }
        }
    }
    let last = troubles.pop();
    troubles.iter().for_each(|trouble| session.output.complain(trouble, &session.ui));
    match last {
        Some(trouble) => Err(trouble.into()),
        None => Ok(if matches.get_flag("check") && count > 0 { Outcome::Errors } else { Outcome::Clean }),
    }
}

/// Lays out a table; what is none stays as it is.
fn table(session: &mut Session, path: &Path, kind: TableKind, only_check: Option<bool>) -> Result<bool, Failure> {
    let bytes = system::read(path)?;
    let seen = Seen::of(path, &bytes);
    let file = program::text(path, bytes);
    if !program::is_table(&file) {
        return Ok(false);
    }
    let new = Table::parse(kind, &file.source).map_err(Failure::Data)?.laid_out();
    if new == file.source.text() {
        return Ok(false);
    }
    if let Some(diff) = only_check {
        named(session, path, diff.then_some((file.source.text(), new.as_str())))?;
        return Ok(true);
    }
    let bytes = file.encoding.encode(&new).map_err(|sign| program::unwritable(sign, &file.source))?;
    system::write_parts(path, Some(&seen), std::iter::once(&*bytes))?;
    let line = session.ui.text("cli-written", &Args::new().text("path", path.display().to_string()));
    session.output.remark(&line);
    Ok(true)
}

/// Lays out a file, or says only whether it would change.
fn file(session: &mut Session, path: &Path, against: &Against<'_>, only_check: Option<bool>) -> Result<bool, Failure> {
    let bytes = system::read(path)?;
    let seen = Seen::of(path, &bytes);
    let old = program::understood_bytes(path, bytes, against.catalogue);
    let encoding = old.encoding;
    let changes = !layout::is_laid_out(old.written());
    if path == Path::new("-") && only_check.is_none() {
        let text = layout::laid_out(old.written());
        let bytes = encoding.encode(&text).map_err(|sign| program::unwritable(sign, old.written().source()))?;
        session.output.write(&bytes)?;
        return Ok(changes);
    }
    if !changes {
        return Ok(false);
    }
    if let Some(diff) = only_check {
        let text = diff.then(|| layout::laid_out(old.written()));
        named(session, path, text.as_deref().map(|text| (old.written().source().text(), text)))?;
        return Ok(true);
    }
    let text = layout::laid_out(old.written());
    let original = mend::Original::of(path, seen, &old, against);
    drop(old);
    let new = program::understood(path, text, encoding, against.catalogue);
    original.store(&new, against)?;
    let line = session.ui.text("cli-written", &Args::new().text("path", path.display().to_string()));
    session.output.remark(&line);
    Ok(true)
}

/// Names a file that would change; with both of its texts, what would change in it.
fn named(session: &mut Session, path: &Path, texts: Option<(&str, &str)>) -> Result<(), Failure> {
    let text = match texts {
        None => format!("{}\n", visible(&path.to_string_lossy())),
        Some((old, new)) => difference(&visible(&path.to_string_lossy()), old, new),
    };
    session.output.print(&text)
}

/// What differs, in the form that `diff -U0` has.
fn difference(path: &str, old: &str, new: &str) -> String {
    let mut text = format!("--- {path}\n+++ {path}\n");
    let (old, new): (Vec<&str>, Vec<&str>) = (old.lines().collect(), new.lines().collect());
    let mut hunk = |at: usize, gone: &[&str], come: &[&str]| {
        text.push_str(&format!("@@ -{},{} +{},{} @@\n", at + 1, gone.len(), at + 1, come.len()));
        gone.iter().for_each(|line| text.push_str(&format!("-{line}\n")));
        come.iter().for_each(|line| text.push_str(&format!("+{line}\n")));
    };
    if old.len() != new.len() {
        // Lines were joined or parted: from the first to the last that differ.
        let same = |(a, b): &(&&str, &&str)| a == b;
        let first = old.iter().zip(&new).take_while(same).count();
        let most = old.len().min(new.len()) - first;
        let last = old.iter().rev().zip(new.iter().rev()).take(most).take_while(same).count();
        let middle = |lines: &'_ [&'_ str]| first..lines.len() - last;
        hunk(first, old.get(middle(&old)).unwrap_or_default(), new.get(middle(&new)).unwrap_or_default());
        return text;
    }
    let mut at = 0;
    while at < old.len() {
        let differing = old.iter().zip(&new).skip(at).take_while(|(a, b)| a != b).count();
        if differing > 0 {
            let lines = at..at + differing;
            hunk(at, old.get(lines.clone()).unwrap_or_default(), new.get(lines).unwrap_or_default());
        }
        at += differing + 1;
    }
    text
}
