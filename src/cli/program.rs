//! Reading a program with what is needed to write it back.
//!
//! Invariant: any file is a program; only one that cannot be read at all is refused.
use std::path::Path;
use std::sync::Arc;

use super::Failure;
use crate::diag::{Diagnostic, Place, Source};
use crate::syntax::encoding::{self, Encoding};
use crate::syntax::{self, Program};
use crate::system;

/// A program file.
pub(super) struct File {
    pub(super) program: Program,
    pub(super) encoding: Encoding,
}

/// Reads a program; `-` is standard input.
pub(super) fn read(path: &Path) -> Result<File, Failure> {
    let decoded = encoding::decode(&system::read(path)?);
    let source = Source::new(path.display().to_string(), decoded.text);
    Ok(File { program: syntax::parse(&source), encoding: decoded.encoding })
}

/// What to say of a character that the file's encoding does not have.
pub(super) fn not_encodable(sign: char, file: &File) -> Diagnostic {
    unwritable(sign, file.program.source())
}

/// The same of the source of a program.
pub(super) fn unwritable(sign: char, source: &Arc<Source>) -> Diagnostic {
    let place = Place::new(source, 0..0);
    Diagnostic::error("not-encodable", place).arg("sign", sign.to_string())
}
