//! Writing programs anew where they stand: the fixes of the checker and the layout of `ciklo fmt`.
//!
//! Invariant: a program is only written if it is proved to be the same to the control, if its encoding has
//! all characters, and if nobody has changed the file meanwhile; then all at once.
use std::path::Path;

use super::{Failure, program};
use crate::check::{self, Against, Settings};
use crate::compare;
use crate::diag::{Diagnostic, Edit, Source, edited};
use crate::syntax::encoding::{self, Decoded};
use crate::syntax::{self, Program};
use crate::system;

/// Fixes a file as far as that is safe: what is found in it then, and how many fixes were made.
pub(super) fn file(
    path: &Path,
    against: &Against<'_>,
    settings: &Settings,
) -> Result<(Vec<Diagnostic>, usize), Failure> {
    if path == Path::new("-") {
        return Err(Diagnostic::global("fix-no-file").into());
    }
    let bytes = system::read(path)?;
    let decoded = encoding::decode(&bytes);
    let program = parsed(path, &decoded.text);
    let mut found = check::check(&program, against);
    // What is switched off is not mended either.
    settings.apply(&mut found);
    let edits: Vec<Edit> = found.iter().filter_map(|diagnostic| diagnostic.fix.clone()).collect();
    let writable = |edit: &Edit| decoded.encoding.encode(&edit.text).is_ok();
    let edits: Vec<Edit> = edits.into_iter().filter(writable).collect();
    if edits.is_empty() {
        return Ok((found, 0));
    }
    let mended = parsed(path, &edited(&decoded.text, &edits));
    store(path, &bytes, &decoded, &program, &mended, against)?;
    Ok((check::check(&mended, against), edits.len()))
}

pub(super) fn parsed(path: &Path, text: &str) -> Program {
    syntax::parse(&Source::new(path.display().to_string(), text))
}

/// Puts the new program in the place of the old one.
pub(super) fn store(
    path: &Path,
    bytes: &[u8],
    decoded: &Decoded,
    old: &Program,
    new: &Program,
    against: &Against<'_>,
) -> Result<(), Failure> {
    if !compare::compare(old, new, against).is_empty() {
        let diagnostic = Diagnostic::global("fix-changes-program").arg("path", path.display().to_string());
        return Err(diagnostic.into());
    }
    let text = new.source().text();
    let whole = decoded.encoding.encode(text).map_err(|sign| program::unwritable(sign, old.source()))?;
    if system::read(path)? != bytes {
        return Err(Diagnostic::global("fix-file-changed").arg("path", path.display().to_string()).into());
    }
    system::write(path, &whole)?;
    Ok(())
}
