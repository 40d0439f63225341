//! `ciklo fmt`: programs laid out anew where they stand.
use std::path::Path;

use clap::ArgMatches;

use super::session::Session;
use super::{Command, Failure, Outcome, arguments, mend, program};
use crate::base::diag::Diagnostic;
use crate::check::{Against, LabelBook};
use crate::language::locale::{Args, Ui};
use crate::program::layout;
use crate::program::table::{Table, TableKind};
use crate::system::{self, Seen};

pub(super) const COMMAND: Command = Command { name: "fmt", usage: "PATH… [--check]", arguments: own, run };

fn own(ui: &Ui) -> Vec<clap::Arg> {
    vec![arguments::words(ui, "file", "PATH", "cli-fmt-path"), arguments::switch(ui, "check", "cli-fmt-check")]
}

fn run(session: &mut Session, matches: &ArgMatches) -> Result<Outcome, Failure> {
    let (catalogue, locales) = (session.catalogue()?, session.locales()?);
    // Labels stay as they are, so any control can tell whether the program stays the same.
    let Some(on) = catalogue.controls.values().next() else { return Ok(Outcome::Clean) };
    let labels = LabelBook::new(on, &locales);
    let against = Against { catalogue: &catalogue, on, labels: &labels, language: None, software: None, readers: &[] };
    let (mut count, mut troubles) = (0, Vec::new());
    for name in arguments::all(matches, "file") {
        let extensions = [&program::PROGRAMS[..], &program::TABLES[..]].concat();
        let (paths, hidden) = system::files_below(Path::new(&name), &extensions);
        troubles.extend(hidden.into_iter().map(Diagnostic::from));
        for path in paths {
            let only_check = matches.get_flag("check");
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
fn table(session: &mut Session, path: &Path, kind: TableKind, only_check: bool) -> Result<bool, Failure> {
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
    if only_check {
        session.output.print(&format!("{}\n", path.display()))?;
        return Ok(true);
    }
    let bytes = file.encoding.encode(&new).map_err(|sign| program::unwritable(sign, &file.source))?;
    system::write_parts(path, Some(&seen), std::iter::once(&*bytes))?;
    let line = session.ui.text("cli-written", &Args::new().text("path", path.display().to_string()));
    session.output.remark(&line);
    Ok(true)
}

/// Lays out a file, or says only whether it would change.
fn file(session: &mut Session, path: &Path, against: &Against<'_>, only_check: bool) -> Result<bool, Failure> {
    let bytes = system::read(path)?;
    let seen = Seen::of(path, &bytes);
    let old = program::understood_bytes(path, bytes, against.catalogue);
    let encoding = old.encoding;
    let changes = !layout::is_laid_out(old.written());
    if path == Path::new("-") && !only_check {
        let text = layout::laid_out(old.written());
        let bytes = encoding.encode(&text).map_err(|sign| program::unwritable(sign, old.written().source()))?;
        session.output.write(&bytes)?;
        return Ok(changes);
    }
    if !changes {
        return Ok(false);
    }
    if only_check {
        session.output.print(&format!("{}\n", path.display()))?;
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
