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

/// Fixes a file as far as that is safe: what is found in it then, and how many fixes were made.
pub(super) fn file(
    path: &Path,
    against: &Against<'_>,
    project: &dyn Project,
    settings: &Settings,
) -> Result<(Vec<Diagnostic>, usize), Failure> {
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
        return Ok((found, 0));
    }
    drop(found);
    let text = edited(old.written().source().text(), &edits);
    let original = Original::of(path, seen, &old, against);
    drop(old);
    let mended = program::understood(path, text, encoding, against.catalogue);
    original.store(&mended, against)?;
    Ok((mended.findings(check::check_in(&mended.program, against, project)), edits.len()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::base::data;
    use crate::check::LabelBook;
    use crate::language::locale::Locales;
    use crate::spec::Catalogue;

    #[test]
    fn a_file_that_somebody_changed_meanwhile_is_left_alone() {
        let files = data::embedded();
        let (catalogue, _) = Catalogue::load(&files);
        let (locales, _) = Locales::load(files);
        let on = catalogue.on("tnc640").unwrap();
        let labels = LabelBook::new(on, &locales);
        let against =
            Against { catalogue: &catalogue, on, labels: &labels, language: None, software: None, readers: &[] };
        let scratch = tempfile::tempdir().unwrap();
        let path = scratch.path().join("a.h");
        let (old, new) = ("1 L X+5 FMAX\n", "1  L X+5 FMAX\n");
        let understood = |text: &str| program::understood_bytes(&path, text.into(), against.catalogue);
        let put = |text: &str| {
            std::fs::write(&path, text).unwrap();
            let original = Original::of(&path, Seen::of(&path, old.as_bytes()), &understood(old), &against);
            original.store(&understood(new), &against)
        };
        let Err(Failure::Trouble(trouble)) = put("1 L X+6 FMAX\n") else { panic!("it was written") };
        assert_eq!(trouble.code, "fix-file-changed");
        assert_eq!(std::fs::read_to_string(&path).unwrap(), "1 L X+6 FMAX\n");
        assert!(put(old).is_ok());
        assert_eq!(std::fs::read_to_string(&path).unwrap(), new);
    }
}
