//! Reading a program with what is needed to write it back.
//!
//! Invariant: any file is a program; only one that cannot be read at all is refused.
use std::path::Path;
use std::sync::Arc;

use super::Failure;
use crate::diag::{Diagnostic, Place, Source, Span};
use crate::iso::{Codes, Lowered, to_klartext};
use crate::spec::Catalogue;
use crate::syntax::encoding::{self, Decoded, Encoding};
use crate::syntax::{self, Dialect, Program};
use crate::system;

/// A program file.
pub(super) struct File {
    pub(super) program: Program,
    pub(super) encoding: Encoding,
}

/// A program file to be understood: one in DIN/ISO is told in Klartext.
pub(super) struct Understood {
    /// The program in Klartext.
    pub(super) program: Program,
    pub(super) encoding: Encoding,
    /// Of a program in DIN/ISO: as it is written, and where the Klartext comes from.
    iso: Option<(Program, Lowered)>,
}

impl Understood {
    fn new(program: Program, encoding: Encoding, catalogue: &Catalogue) -> Self {
        if program.dialect() == Dialect::Klartext {
            return Self { program, encoding, iso: None };
        }
        let lowered = to_klartext(&program, &Codes::new(catalogue), None);
        Self { program: lowered.program.clone(), encoding, iso: Some((program, lowered)) }
    }

    /// The program as it is written.
    pub(super) fn written(&self) -> &Program {
        self.iso.as_ref().map_or(&self.program, |(written, _)| written)
    }

    /// The blocks of the file that a block of the Klartext comes from.
    pub(super) fn slice(&self, span: Span) -> &str {
        match &self.iso {
            Some((written, lowered)) => written.slice(lowered.blocks(span)),
            None => self.program.slice(span),
        }
    }

    /// The findings of the checker where they are in the file.
    pub(super) fn findings(&self, found: Vec<Diagnostic>) -> Vec<Diagnostic> {
        match &self.iso {
            Some((_, lowered)) => lowered.findings(found, lowered.diagnostics.clone()),
            None => found,
        }
    }

    /// A finding about the Klartext where it is in the file.
    pub(super) fn at_home(&self, diagnostic: Diagnostic) -> Diagnostic {
        match &self.iso {
            Some((_, lowered)) => lowered.at_home(diagnostic),
            None => diagnostic,
        }
    }

    /// The place in the file of something that stands there letter by letter.
    pub(super) fn exact(&self, span: Span) -> Option<Span> {
        match &self.iso {
            Some((_, lowered)) => lowered.exact(span),
            None => Some(span),
        }
    }
}

/// Reads a program to be understood; `-` is standard input.
pub(super) fn understand(path: &Path, catalogue: &Catalogue) -> Result<Understood, Failure> {
    let File { program, encoding } = read(path)?;
    Ok(Understood::new(program, encoding, catalogue))
}

/// The same of a text.
pub(super) fn understood(path: &Path, decoded: &Decoded, catalogue: &Catalogue) -> Understood {
    let source = Source::new(path.display().to_string(), decoded.text.as_str());
    Understood::new(syntax::parse(&source), decoded.encoding, catalogue)
}

/// The same of the bytes of a file, which become the text if they can: copies of long programs cost.
pub(super) fn understood_bytes(path: &Path, bytes: Vec<u8>, catalogue: &Catalogue) -> Understood {
    let decoded = encoding::decode_owned(bytes);
    let source = Source::new(path.display().to_string(), decoded.text);
    Understood::new(syntax::parse(&source), decoded.encoding, catalogue)
}

/// Reads a program; `-` is standard input.
pub(super) fn read(path: &Path) -> Result<File, Failure> {
    let decoded = encoding::decode_owned(system::read(path)?);
    let source = Source::new(path.display().to_string(), decoded.text);
    Ok(File { program: syntax::parse(&source), encoding: decoded.encoding })
}

/// The text of a file with its encoding.
pub(super) struct Text {
    pub(super) source: Arc<Source>,
    pub(super) encoding: Encoding,
}

/// Whether it begins as tables do: other programs have files of these names as well.
pub(super) fn is_table(file: &Text) -> bool {
    file.source.text().trim_start_matches('\u{feff}').starts_with("BEGIN")
}

/// Reads the text of a file that is no program.
pub(super) fn source(path: &Path) -> Result<Text, Failure> {
    let decoded = encoding::decode_owned(system::read(path)?);
    Ok(Text { source: Source::new(path.display().to_string(), decoded.text), encoding: decoded.encoding })
}

/// The text of a program of which the bytes are there.
pub(super) fn source_of(path: &Path, bytes: &[u8]) -> Arc<Source> {
    Source::new(path.display().to_string(), encoding::decode(bytes).text)
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
