//! Writing programs anew where they stand: the fixes of the checker and the layout of `ciklo fmt`.
//!
//! Invariant: a program is only written if it is proved to be the same to the control, if its encoding has
//! all characters, and if nobody has changed the file meanwhile; then all at once.
use std::path::Path;

use super::Failure;
use super::program::{self, Understood};
use crate::check::{self, Against, Among, Settings};
use crate::compare;
use crate::diag::{Diagnostic, Edit, edited};
use crate::syntax::encoding::{self, Decoded};
use crate::system;

/// Fixes a file as far as that is safe: what is found in it then, and how many fixes were made.
pub(super) fn file(
    path: &Path,
    against: &Against<'_>,
    among: &dyn Among,
    settings: &Settings,
) -> Result<(Vec<Diagnostic>, usize), Failure> {
    if path == Path::new("-") {
        return Err(Diagnostic::global("fix-no-file").into());
    }
    let bytes = system::read(path)?;
    let decoded = encoding::decode(&bytes);
    let program = program::understood(path, &decoded, against.catalogue);
    let mut found = program.findings(check::check_among(&program.program, against, among));
    // What is switched off is not mended either.
    settings.apply(&mut found);
    let edits: Vec<Edit> = found.iter().filter_map(|diagnostic| diagnostic.fix.clone()).collect();
    let writable = |edit: &Edit| decoded.encoding.encode(&edit.text).is_ok();
    let edits: Vec<Edit> = edits.into_iter().filter(writable).collect();
    if edits.is_empty() {
        return Ok((found, 0));
    }
    let text = Decoded { text: edited(&decoded.text, &edits), encoding: decoded.encoding };
    let mended = program::understood(path, &text, against.catalogue);
    store(path, &bytes, &decoded, &program, &mended, against)?;
    Ok((mended.findings(check::check_among(&mended.program, against, among)), edits.len()))
}

/// Puts the new program in the place of the old one.
pub(super) fn store(
    path: &Path,
    bytes: &[u8],
    decoded: &Decoded,
    old: &Understood,
    new: &Understood,
    against: &Against<'_>,
) -> Result<(), Failure> {
    if !compare::compare(&old.program, &new.program, against).is_empty() {
        let diagnostic = Diagnostic::global("fix-changes-program").arg("path", path.display().to_string());
        return Err(diagnostic.into());
    }
    let text = new.written().source().text();
    let whole = decoded.encoding.encode(text).map_err(|sign| program::unwritable(sign, old.written().source()))?;
    if system::read(path)? != bytes {
        return Err(Diagnostic::global("fix-file-changed").arg("path", path.display().to_string()).into());
    }
    system::write(path, &whole)?;
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::check::LabelBook;
    use crate::data;
    use crate::locale::Locales;
    use crate::spec::Catalogue;

    #[test]
    fn a_file_that_somebody_changed_meanwhile_is_left_alone() {
        let files = data::embedded();
        let (catalogue, _) = Catalogue::load(&files);
        let (locales, _) = Locales::load(files);
        let on = catalogue.on("tnc640").unwrap();
        let labels = LabelBook::new(on, &locales);
        let against = Against { catalogue: &catalogue, on, labels: &labels, language: None, readers: &[] };
        let scratch = tempfile::tempdir().unwrap();
        let path = scratch.path().join("a.h");
        let (old, new) = ("1 L X+5 FMAX\n", "1  L X+5 FMAX\n");
        let put = |text: &str| {
            std::fs::write(&path, text).unwrap();
            let decoded = encoding::decode(old.as_bytes());
            let understood =
                |text: &str| program::understood(&path, &encoding::decode(text.as_bytes()), against.catalogue);
            store(&path, old.as_bytes(), &decoded, &understood(old), &understood(new), &against)
        };
        let Err(Failure::Trouble(trouble)) = put("1 L X+6 FMAX\n") else { panic!("it was written") };
        assert_eq!(trouble.code, "fix-file-changed");
        assert_eq!(std::fs::read_to_string(&path).unwrap(), "1 L X+6 FMAX\n");
        assert!(put(old).is_ok());
        assert_eq!(std::fs::read_to_string(&path).unwrap(), new);
    }
}
