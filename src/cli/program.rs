//! Reading a program with what is needed to write it back.
//!
//! Invariant: any file is a program; only one that cannot be read at all is refused.
use std::borrow::Cow;
use std::path::Path;
use std::sync::Arc;

use super::Failure;
use super::session::Session;
use crate::base::diag::{Diagnostic, Place, Source, Span};
use crate::program::iso::{Codes, Lowered, to_klartext};
use crate::program::syntax::encoding::{self, Charset, Decoded, Encoding};
use crate::program::syntax::{self, BlockKind, Dialect, Program};
use crate::spec::Catalogue;
use crate::system::{self, Seen};

/// An encoding in which a text is its own bytes.
const UTF_8: Encoding = Encoding { charset: Charset::Utf8, bom: false };

/// Extensions of the programs that are looked for in folders.
pub(super) const PROGRAMS: [&str; 2] = ["h", "i"];
/// Extensions of the tables that are looked for in folders.
pub(super) const TABLES: [&str; 5] = ["t", "tp", "pr", "d", "pnt"];

/// What is found in a file without any block.
const EMPTY: &str = "program-empty";

/// A program file.
pub(super) struct File {
    pub(super) program: Program,
    pub(super) encoding: Encoding,
}

/// A program file to be understood: one in DIN/ISO is put into Klartext.
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
            Some((written, lowered)) => {
                let mut found = lowered.findings(found, lowered.diagnostics.clone());
                // A block that sets a mode only is none in Klartext, but the file has one.
                if written.blocks().iter().any(|block| !matches!(block.kind, BlockKind::Empty)) {
                    found.retain(|own| own.code != EMPTY);
                }
                found
            }
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

    /// The place in the file of something that is there letter by letter.
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

/// The same of a text and the encoding that it has in the file.
pub(super) fn understood(path: &Path, text: String, encoding: Encoding, catalogue: &Catalogue) -> Understood {
    let source = Source::new(path.display().to_string(), text);
    Understood::new(syntax::parse(&source), encoding, catalogue)
}

/// The same of the bytes of a file, which become the text if they can: copies of long programs cost.
pub(super) fn understood_bytes(path: &Path, bytes: Vec<u8>, catalogue: &Catalogue) -> Understood {
    let Decoded { text, encoding } = encoding::decode_owned(bytes);
    understood(path, text, encoding, catalogue)
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

/// The text of a table of a kind that no manual describes, such as those of pallets and of pockets: it begins with the
/// name of a file, and its own name is none of a program.
pub(super) fn other_table(path: &Path) -> Result<Option<Arc<Source>>, Failure> {
    let is_program = |own: &std::ffi::OsStr| PROGRAMS.iter().any(|it| own.eq_ignore_ascii_case(it));
    if path.extension().is_none_or(is_program) {
        return Ok(None);
    }
    let file = source(path)?;
    let first = file.source.text().trim_start_matches('\u{feff}').lines().next().unwrap_or_default();
    let mut words = first.split_whitespace();
    let begins = words.next() == Some("BEGIN");
    let named = words.next().is_some_and(|word| !word.eq_ignore_ascii_case("PGM"));
    Ok((begins && named && first.contains('.')).then_some(file.source))
}

/// Reads the text of a file that is no program.
pub(super) fn source(path: &Path) -> Result<Text, Failure> {
    Ok(text(path, system::read(path)?))
}

/// The same of the bytes of the file.
pub(super) fn text(path: &Path, bytes: Vec<u8>) -> Text {
    let decoded = encoding::decode_owned(bytes);
    Text { source: Source::new(path.display().to_string(), decoded.text), encoding: decoded.encoding }
}

/// The text of a program of which the bytes are there.
pub(super) fn source_of(path: &Path, bytes: &[u8]) -> Arc<Source> {
    Source::new(path.display().to_string(), encoding::decode(bytes).text)
}

/// The pieces of a text with some stretches replaced, in the order of the text.
pub(super) fn pieces<'t>(
    text: &'t str,
    replaced: impl Iterator<Item = (Span, &'t str)>,
) -> impl Iterator<Item = &'t str> {
    let length = text.len();
    let last = std::iter::once((Span::new(length, length), ""));
    let mut at = 0;
    replaced.chain(last).flat_map(move |(span, new)| {
        let from = std::mem::replace(&mut at, span.end);
        [text.get(from..span.start).unwrap_or_default(), new]
    })
}

/// Writes a text that is in pieces to a file, without putting it together if its encoding lets that. It is made
/// from a file that was read: if this is the one, no one may have changed it.
pub(super) fn write_pieces<'t>(
    path: &Path,
    from: &Seen,
    encoding: Encoding,
    pieces: impl Iterator<Item = &'t str>,
    source: &Arc<Source>,
) -> Result<(), Failure> {
    if encoding == UTF_8 {
        system::write_parts(path, Some(from), pieces.map(str::as_bytes))?;
    } else {
        let bytes = encoded(encoding, pieces, source)?;
        system::write_parts(path, Some(from), std::iter::once(&*bytes))?;
    }
    Ok(())
}

/// The same to standard output.
pub(super) fn print_pieces<'t>(
    session: &mut Session,
    encoding: Encoding,
    mut pieces: impl Iterator<Item = &'t str>,
    source: &Arc<Source>,
) -> Result<(), Failure> {
    if encoding == UTF_8 {
        return pieces.try_for_each(|piece| session.output.print(piece));
    }
    session.output.write(&encoded(encoding, pieces, source)?)
}

fn encoded<'t>(
    encoding: Encoding,
    pieces: impl Iterator<Item = &'t str>,
    source: &Arc<Source>,
) -> Result<Vec<u8>, Failure> {
    let text: String = pieces.collect();
    encoding.encode(&text).map(Cow::into_owned).map_err(|sign| unwritable(sign, source).into())
}

/// What to say of a character that the encoding of the file does not have.
pub(super) fn unwritable(sign: char, source: &Arc<Source>) -> Diagnostic {
    let place = Place::new(source, 0..0);
    Diagnostic::error("not-encodable", place).arg("sign", sign.to_string())
}
