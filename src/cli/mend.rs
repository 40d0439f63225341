//! Writing programs anew where they are: the fixes of the checker and the layout of `ciklo fmt`.
//!
//! Invariant: a program is only written if it is proved to be the same to the control, if its encoding has
//! all characters, and if no one has changed the file meanwhile; then all at once.
use std::path::Path;

use super::Failure;
use super::program::{self, Understood};
use crate::base::diag::{Diagnostic, Edit, edited};
use crate::check::{self, Against, Project, Settings};
use crate::system::{self, Seen};
use crate::tools::compare;

/// What a program must still be when it is written anew.
pub(super) struct Original<'p> {
    path: &'p Path,
    /// The file as it was read.
    seen: Seen,
    /// What it comes to for a control.
    program: [u8; 32],
}

impl<'p> Original<'p> {
    /// That of a file.
    pub(super) fn of(path: &'p Path, seen: Seen, old: &Understood, against: &Against<'_>) -> Self {
        Self { path, seen, program: compare::fingerprint(&old.program, against) }
    }

    /// Puts the new program in the place of the old one. The two are not held at the same time: they may be long.
    pub(super) fn store(&self, new: &Understood, against: &Against<'_>) -> Result<(), Failure> {
        if compare::fingerprint(&new.program, against) != self.program {
            let path = self.path.display().to_string();
            return Err(Diagnostic::global("fix-changes-program").arg("path", path).into());
        }
        let text = new.written().source();
        let whole = new.encoding.encode(text.text()).map_err(|sign| program::unwritable(sign, text))?;
        system::write_parts(self.path, Some(&self.seen), std::iter::once(&*whole))?;
        Ok(())
    }
}

/// Fixes a file as far as that is safe: the program that is there then, what is found in it, and how many fixes were made.
pub(super) fn file(
    path: &Path,
    against: &Against<'_>,
    project: &dyn Project,
    settings: &Settings,
) -> Result<(Understood, Vec<Diagnostic>, usize), Failure> {
    if path == Path::new("-") {
        return Err(Diagnostic::global("fix-no-file").into());
    }
    let bytes = system::read(path)?;
    let seen = Seen::of(path, &bytes);
    let old = program::understood_bytes(path, bytes, against.catalogue);
    let encoding = old.encoding;
    let mut found = old.findings(check::check_in(&old.program, against, project));
    // What is switched off is not mended either.
    settings.apply(&mut found);
    let writable = |edit: &&Edit| encoding.encode(&edit.text).is_ok();
    let fixes = found.iter().filter_map(|diagnostic| diagnostic.fix.as_ref());
    let edits: Vec<Edit> = fixes.filter(writable).cloned().collect();
    if edits.is_empty() {
        return Ok((old, found, 0));
    }
    drop(found);
    let text = edited(old.written().source().text(), &edits);
    let original = Original::of(path, seen, &old, against);
    drop(old);
    let mended = program::understood(path, text, encoding, against.catalogue);
    original.store(&mended, against)?;
    let found = mended.findings(check::check_in(&mended.program, against, project));
    Ok((mended, found, edits.len()))
}
