//! A program that is edited: after a change only the blocks that it can reach are read again.
//!
//! The text is kept in pieces of some dozens of lines; each is a [`Program`] with places of its own. A piece begins
//! with a block that no block before it can take as a part, so reading it alone gives what reading the whole gives.
//! Invariant: the blocks of the pieces, one after the other, are those of the whole text.
use super::tree::{Block, BlockKind};
use super::{Dialect, Program, cycle, iso, parse};
use crate::base::diag::{Source, Span};
use crate::program::syntax::statement::StatementKind;

/// Lines of a piece, as long as there are places to divide it.
const USUAL: usize = 48;
/// From so many lines on a piece is divided.
const MOST: usize = 4 * USUAL;

/// A program that is edited.
#[derive(Clone, Debug)]
pub struct Document {
    name: String,
    pieces: Vec<Program>,
    /// A program in DIN/ISO is one piece.
    dialect: Dialect,
}

/// A part of a document.
#[derive(Clone, Copy, Debug)]
pub struct Piece<'d> {
    /// Where it begins in the whole text.
    pub start: usize,
    /// The lines before it.
    pub lines_before: usize,
    /// Its blocks; their places and lines count from the beginning of the piece.
    pub program: &'d Program,
}

impl Document {
    /// Reads a text.
    pub fn new(name: impl Into<String>, text: &str) -> Self {
        let name = name.into();
        let dialect = if iso::is_iso(text, &name) { Dialect::Iso } else { Dialect::Klartext };
        let mut document = Self { name, pieces: Vec::new(), dialect };
        document.pieces = document.read(text);
        document
    }

    /// Its parts in their order.
    pub fn pieces(&self) -> impl Iterator<Item = Piece<'_>> {
        let (mut start, mut lines_before) = (0, 0);
        self.pieces.iter().map(move |program| {
            let piece = Piece { start, lines_before, program };
            start += program.source().text().len();
            lines_before += program.lines();
            piece
        })
    }

    /// The whole text.
    pub fn text(&self) -> String {
        self.pieces.iter().map(|program| program.source().text()).collect()
    }

    /// Bytes of the text.
    pub fn len(&self) -> usize {
        self.pieces.iter().map(|program| program.source().text().len()).sum()
    }

    /// Whether there is no text.
    pub fn is_empty(&self) -> bool {
        self.pieces.is_empty()
    }

    /// All of it as one program.
    pub fn program(&self) -> Program {
        parse(&Source::new(self.name.as_str(), self.text()))
    }

    /// Replaces a stretch of the text by another text, and gives the part of the new text that was read again;
    /// nothing, and no change, if the stretch does not begin and end between two characters.
    pub fn edit(&mut self, range: Span, text: &str) -> Option<Span> {
        if range.start > range.end {
            return None;
        }
        let Some((mut first, mut start)) = self.piece_at(range.start) else {
            if range != Span::default() {
                return None;
            }
            *self = Self::new(std::mem::take(&mut self.name), text);
            return Some(Span::new(0, text.len()));
        };
        let mut last = first;
        let mut end = start + self.length(last);
        while end < range.end {
            last += 1;
            end += self.pieces.get(last)?.source().text().len();
        }
        let mut old = self.joined(first, last);
        let inside = range.start - start..range.end - start;
        old.get(inside.clone())?;
        old.replace_range(inside, text);
        // What the change has made a part of the block before it, or of that after it, is read with it.
        loop {
            let new = self.read(&old);
            let before = first.checked_sub(1).and_then(|at| self.pieces.get(at));
            if before.is_some_and(|before| new.first().is_none_or(|new| !is_separate(before, new))) {
                first -= 1;
                let own = self.pieces.get(first)?.source().text();
                start -= own.len();
                old.insert_str(0, own);
                continue;
            }
            let after = self.pieces.get(last + 1);
            if after.is_some_and(|after| new.last().is_none_or(|new| !is_separate(new, after))) {
                last += 1;
                old.push_str(self.pieces.get(last)?.source().text());
                continue;
            }
            self.pieces.splice(first..=last, new);
            if self.dialect != self.dialect_of_head() {
                let text = self.text();
                *self = Self::new(std::mem::take(&mut self.name), &text);
                return Some(Span::new(0, text.len()));
            }
            return Some(Span::new(start, start + old.len()));
        }
    }

    /// The dialect that the text begins with: its first line that is neither blank nor a comment decides.
    fn dialect_of_head(&self) -> Dialect {
        let speaks = |line: &str| !line.trim_start().is_empty() && !line.trim_start().starts_with(';');
        let texts = || self.pieces.iter().map(|program| program.source().text());
        let head = texts().find(|text| text.lines().any(speaks)).unwrap_or_default();
        if iso::is_iso(head, &self.name) { Dialect::Iso } else { Dialect::Klartext }
    }

    /// The piece that holds a byte, and where it begins. The end of a piece belongs to it.
    fn piece_at(&self, at: usize) -> Option<(usize, usize)> {
        let mut start = 0;
        for (index, program) in self.pieces.iter().enumerate() {
            let end = start + program.source().text().len();
            if at <= end {
                return Some((index, start));
            }
            start = end;
        }
        None
    }

    fn length(&self, index: usize) -> usize {
        self.pieces.get(index).map_or(0, |program| program.source().text().len())
    }

    fn joined(&self, first: usize, last: usize) -> String {
        self.pieces.get(first..=last).unwrap_or_default().iter().map(|program| program.source().text()).collect()
    }

    /// Reads a text and divides it, if it is long, between two of its blocks.
    fn read(&self, text: &str) -> Vec<Program> {
        if text.is_empty() {
            return Vec::new();
        }
        let parse = |text: &str| super::read(&Source::new(self.name.as_str(), text), self.dialect);
        let whole = parse(text);
        if whole.lines() < MOST || self.dialect == Dialect::Iso {
            return vec![whole];
        }
        let (mut cuts, mut lines) = (Vec::new(), 0);
        let blocks = whole.blocks();
        for (index, block) in blocks.iter().enumerate() {
            if lines >= USUAL && is_apart(&whole, blocks.get(..index).unwrap_or_default(), block) {
                cuts.push(block.span.start);
                lines = 0;
            }
            lines += block.lines;
        }
        cuts.push(text.len());
        let mut start = 0;
        let part = |end: usize| {
            let text = text.get(start..end).unwrap_or_default();
            start = end;
            parse(text)
        };
        cuts.into_iter().map(part).collect()
    }
}

/// Whether no block of the one part could take lines of the other.
fn is_separate(before: &Program, after: &Program) -> bool {
    let ended = before.source().text().ends_with(['\n', '\r']);
    ended && after.blocks().first().is_some_and(|block| is_apart_from(before, before.blocks(), after, block))
}

fn is_apart(program: &Program, before: &[Block], block: &Block) -> bool {
    is_apart_from(program, before, program, block)
}

/// Whether a block begins where no block before it looks further: with a number, or as a block of one line after one
/// that is complete.
fn is_apart_from(program: &Program, before: &[Block], own: &Program, block: &Block) -> bool {
    let text = own.slice(block.span);
    let known = match &block.kind {
        // These may belong to what is before them, or to the definition that they are in.
        BlockKind::Empty | BlockKind::Comment | BlockKind::Structure(_) | BlockKind::Unknown(_) => false,
        BlockKind::OldCycleLine(line) => line.line == 0,
        _ => !cycle::starts_parameter(text, Span::new(after_number(text), text.len())),
    };
    if !known {
        return false;
    }
    if block.number.is_some() {
        return true;
    }
    let silent =
        |block: &&Block| !matches!(block.kind, BlockKind::Empty | BlockKind::Comment | BlockKind::Structure(_));
    let Some(last) = before.iter().rev().find(silent) else { return false };
    let complete = match &last.kind {
        BlockKind::Unknown(_) | BlockKind::PatternDef(_) => false,
        BlockKind::Statement(statement) => statement.kind != StatementKind::ContourDef,
        _ => true,
    };
    let after = program.source().text().get(last.span.start..before.last().map_or(last.span.end, |end| end.span.end));
    block.lines == 1 && complete && !text.contains('~') && after.is_some_and(|text| !text.contains('~'))
}

/// Where the content of a block's text begins, if a number is before it.
fn after_number(text: &str) -> usize {
    let mark = |c: char| c.is_ascii_digit() || c.is_whitespace() || matches!(c, '/' | 'N' | 'n' | '\u{feff}');
    text.len() - text.trim_start_matches(mark).len()
}
