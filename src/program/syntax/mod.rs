//! Klartext and DIN/ISO programs: a lossless parser that never fails.
//!
//! [`parse`] divides a text into blocks; their spans follow one another and cover it, so
//! printing an untouched program gives the same text back, and [`encoding`] the same bytes. What no
//! rule reads becomes a block of kind `unknown` with an error. Invariant: this module knows how
//! blocks are written and no cycle: numbers, labels and names mean nothing here.
mod assemble;
mod blocks;
mod body;
mod cursor;
mod cycle;
mod definition;
mod document;
mod element;
pub mod encoding;
mod flow;
mod functions;
mod iso;
mod iso_doubts;
mod iso_read;
mod iso_words;
pub mod json;
mod lines;
mod motion;
mod parameters;
mod path;
mod plain;
mod statement;
mod statements;
mod terms;
mod texts;
mod tree;
mod view;
mod words;

pub use document::{Document, Piece};
pub use element::{Compensates, Element, Outline, axis_twice, is_misplaced, misfitting};
pub use functions::functions;
pub use iso::{Dialect, IsoBlock, IsoKind, is_of_language, is_older, is_path};
pub use parameters::Parameters;
pub use path::{Approach, Path};
pub use statement::*;
pub use terms::SHORTEST_LABEL;
pub use tree::*;
pub use view::{CycleForm, CycleView};

use std::sync::Arc;

use crate::base::diag::{Diagnostic, Place, Severity, Source, Span};

/// How many characters of the text an error quotes.
const MAX_FOUND: usize = 40;

/// A program: its text in blocks.
#[derive(Clone, Debug)]
pub struct Program {
    source: Arc<Source>,
    blocks: Vec<Block>,
    warnings: Vec<SyntaxError>,
    dialect: Dialect,
}

/// Reads a program. Any text is one; unreadable blocks are [`BlockKind::Unknown`].
pub fn parse(source: &Arc<Source>) -> Program {
    let iso = iso::is_iso(source.text(), source.name());
    read(source, if iso { Dialect::Iso } else { Dialect::Klartext })
}

/// Reads a program of a dialect that is known.
fn read(source: &Arc<Source>, dialect: Dialect) -> Program {
    let assembled = match dialect {
        Dialect::Klartext => assemble::assemble(source),
        Dialect::Iso => iso_read::assemble(source),
    };
    let mut warnings = assembled.warnings;
    warnings.sort_by_key(|warning| warning.span.start);
    Program { source: Arc::clone(source), blocks: assembled.blocks, warnings, dialect }
}

impl Program {
    /// The source.
    pub fn source(&self) -> &Arc<Source> {
        &self.source
    }

    /// The language that it is written in, known by its first block and the name of its file.
    pub const fn dialect(&self) -> Dialect {
        self.dialect
    }

    /// The blocks, in order.
    pub fn blocks(&self) -> &[Block] {
        &self.blocks
    }

    /// The program's text, put together from its blocks.
    pub fn text(&self) -> String {
        self.blocks.iter().map(|block| self.slice(block.span)).collect()
    }

    /// The text at a place.
    pub fn slice(&self, span: Span) -> &str {
        self.source.text().get(span.start..span.end).unwrap_or_default()
    }

    /// What a block says, without its number, its end and a comment after it; the joints of its lines and comments
    /// between them stay.
    pub fn content(&self, block: &Block) -> Span {
        match self.dialect {
            Dialect::Iso => iso_read::content_of(self.source.text(), block.span),
            Dialect::Klartext => lines::content_of(self.source.text().as_bytes(), block.span),
        }
    }

    /// The same program with what `each` writes into its blocks: where they are in the program that this one was made
    /// from, and what could not be said here.
    pub fn with_blocks(mut self, each: &mut dyn FnMut(&mut Block)) -> Self {
        self.blocks.iter_mut().for_each(each);
        self
    }

    /// How many physical lines the text has.
    pub fn lines(&self) -> usize {
        self.blocks.iter().map(|block| block.lines).sum()
    }

    /// The lines that continue the comment of a block's first line: those after what the block says.
    pub fn wrapped(&self, block: &Block) -> Option<Span> {
        let comment = block.comment().filter(|_| block.lines > 1)?;
        let said = match &block.kind {
            BlockKind::Formula(formula) => formula.text.end,
            BlockKind::TextFormula(formula) => formula.text.end,
            BlockKind::Motion(element) => {
                let motion = element.words();
                let words = motion.coords.iter().map(|coord| coord.span.end);
                let words = words.chain(motion.functions.iter().map(|function| function.span.end));
                words.chain(motion.feed.map(|feed| feed.span.end)).max()?
            }
            _ => return None,
        };
        let rest = Span::new(comment.end, self.content(block).end);
        (said <= comment.start && rest.start < rest.end).then_some(rest)
    }

    /// Text after a tab that is no part of the block, as printed listings have it.
    pub fn remark(&self, block: &Block) -> Option<Span> {
        let at = self.warnings.partition_point(|warning| warning.span.start < block.span.start);
        let own = self.warnings.get(at..)?.iter().take_while(|warning| warning.span.start < block.span.end);
        own.into_iter().find(|warning| warning.code == assemble::REMARK).map(|warning| warning.span)
    }

    /// What cannot be read: of each unknown block and of each unreadable line in a cycle the error.
    pub fn errors(&self) -> impl Iterator<Item = &SyntaxError> {
        self.blocks.iter().flat_map(|block| match &block.kind {
            BlockKind::Unknown(error) => std::slice::from_ref(&**error),
            BlockKind::CycleDef(cycle) => cycle.errors.as_slice(),
            BlockKind::GlobalDef(definition) => definition.errors.as_slice(),
            BlockKind::Iso(block) => block.errors.as_slice(),
            _ => &[],
        })
    }

    /// Errors and warnings, in the order of the text.
    pub fn diagnostics(&self) -> Vec<Diagnostic> {
        let errors = self.errors().map(|error| (Severity::Error, error));
        let severity = |error: &SyntaxError| match error.code {
            // Posts of shops write the long word for years: their controls do not refuse it.
            assemble::REFUSED => Severity::Error,
            assemble::SPELLING if error.expected != "CYCL" => Severity::Error,
            _ => Severity::Warning,
        };
        // A word without its value once is a mistake; twice it is how older controls print what was not entered.
        let empty = |error: &&SyntaxError| error.code == assemble::SPELLING && error.expected == "value";
        let mut all_empty = self.warnings.iter().filter(empty);
        let habit = all_empty.next().is_some() && (all_empty.next().is_some() || self.has_empty_function());
        let counted = self.warnings.iter().filter(|error| !(habit && empty(error)));
        let warnings = counted.map(|error| (severity(error), error));
        let mut all: Vec<_> = errors.chain(warnings).collect();
        all.sort_by_key(|(_, error)| error.span.start);
        all.into_iter().map(|(severity, error)| self.diagnostic(severity, error)).collect()
    }

    /// Whether a block ends with an `M` without a number, as older controls print it.
    fn has_empty_function(&self) -> bool {
        let ends = |line: &str| matches!(line.trim_end().as_bytes(), [.., b' ' | b'\t', b'M' | b'm']);
        let mut moving = self.blocks.iter().filter(|block| matches!(block.kind, BlockKind::Motion(_)));
        moving.any(|block| ends(self.slice(block.span)))
    }

    fn diagnostic(&self, severity: Severity, error: &SyntaxError) -> Diagnostic {
        let visible = |c: char| if c.is_control() { char::REPLACEMENT_CHARACTER } else { c };
        let found: String = self.slice(error.span).trim().chars().map(visible).take(MAX_FOUND).collect();
        let code = if found.is_empty() { "syntax-incomplete" } else { error.code };
        let place = Place::new(&self.source, error.span);
        let diagnostic = Diagnostic { severity, ..Diagnostic::error(code, place) };
        diagnostic.arg("found", found).arg("expected", error.expected)
    }

    /// The cycle definitions: each with Q parameters, and the lines of each of the old form as one.
    pub fn cycles(&self) -> Vec<CycleView<'_>> {
        let mut all = Vec::new();
        self.each_cycle(|view| all.push(view));
        all
    }

    /// Hands over the cycle definitions one by one.
    pub fn each_cycle<'p>(&'p self, each: impl FnMut(CycleView<'p>)) {
        view::each_cycle(&self.blocks, each);
    }
}
