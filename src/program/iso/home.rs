//! Where the text of a program that was written anew comes from.
//!
//! Invariant: pieces follow one another and cover the text; a place inside of a piece that was copied has its
//! exact place at home, any other place that of the block it was made from.
use std::sync::Arc;

use crate::base::diag::{Diagnostic, Edit, Place, Source, Span};
use crate::program::syntax::Program;

/// A stretch of the new text.
#[derive(Clone, Copy, Debug)]
pub(super) struct Piece {
    /// Where it ends; it begins where the piece before it ends.
    pub(super) end: usize,
    /// What it was made from.
    pub(super) home: Span,
    /// Whether it is a copy.
    pub(super) copied: bool,
}

/// Findings of the checker about how a program is written begin so; those of the program itself are reported instead.
const SYNTAX: &str = "syntax-";
/// The note about numbers that do not rise.
const NUMBERS: &str = "block-numbers";
/// A block that Klartext has no equivalent of is no mistake.
const NO_EQUIVALENT: &str = "klartext-no-equivalent";

/// A DIN/ISO program in Klartext.
#[derive(Debug)]
pub struct Lowered {
    /// The program in Klartext; its blocks have the lines and numbers of those that they were made from.
    pub program: Program,
    /// What Klartext has no equivalent of, and what could not be read.
    pub diagnostics: Vec<Diagnostic>,
    pub(super) source: Arc<Source>,
    pub(super) pieces: Vec<Piece>,
    /// Whether the block numbers of the file rise.
    pub(super) rising: bool,
}

impl Lowered {
    /// The place that a place of the Klartext was made from.
    pub fn home(&self, span: Span) -> Span {
        if let Some(exact) = self.exact(span) {
            return exact;
        }
        let touched = self.touched(span);
        let copied = touched.iter().filter(|piece| piece.copied).map(|piece| piece.home);
        let all = touched.iter().map(|piece| piece.home);
        let join = |a: Span, b: Span| Span::new(a.start.min(b.start), a.end.max(b.end));
        copied.reduce(join).or_else(|| all.reduce(join)).unwrap_or_default()
    }

    /// The place of something that was copied; nothing for other places.
    pub fn exact(&self, span: Span) -> Option<Span> {
        let at = self.pieces.partition_point(|piece| piece.end <= span.start);
        // An empty place may be after the last byte of a copy.
        let before = at.checked_sub(1).filter(|_| span.start == span.end);
        [Some(at), before].into_iter().flatten().find_map(|at| {
            let piece = self.pieces.get(at).filter(|piece| piece.copied)?;
            let start = self.start(at);
            let inside = start <= span.start && span.end <= piece.end;
            inside.then(|| Span::new(piece.home.start + (span.start - start), piece.home.start + (span.end - start)))
        })
    }

    /// The blocks that a place of the Klartext was made from, whole.
    pub fn blocks(&self, span: Span) -> Span {
        let join = |a: Span, b: Span| Span::new(a.start.min(b.start), a.end.max(b.end));
        self.touched(span).iter().map(|piece| piece.home).reduce(join).unwrap_or_default()
    }

    fn start(&self, at: usize) -> usize {
        at.checked_sub(1).and_then(|before| self.pieces.get(before)).map_or(0, |piece| piece.end)
    }

    fn touched(&self, span: Span) -> &[Piece] {
        let first =
            self.pieces.partition_point(|piece| piece.end <= span.start).min(self.pieces.len().saturating_sub(1));
        let last = self.pieces.partition_point(|piece| piece.end < span.end).min(self.pieces.len().saturating_sub(1));
        self.pieces.get(first..=last.max(first)).unwrap_or_default()
    }

    /// A place as the reader of the DIN/ISO program sees it.
    fn place(&self, place: Place) -> Place {
        if Arc::ptr_eq(&place.source, self.program.source()) {
            return Place::new(&self.source, self.home(place.span));
        }
        place
    }

    /// A finding as the reader of the DIN/ISO program sees it; a fix is kept where its text was copied.
    pub fn at_home(&self, diagnostic: Diagnostic) -> Diagnostic {
        let fix = diagnostic.fix.and_then(|fix| Some(Edit { span: self.exact(fix.span)?, ..fix }));
        let place = diagnostic.place.map(|place| self.place(place));
        let related = diagnostic.related.into_iter().map(|(caption, place)| (caption, self.place(place))).collect();
        Diagnostic { place, related, fix, ..diagnostic }
    }

    /// The findings of the checker at home, with what is wrong in the DIN/ISO program itself.
    pub fn findings(&self, found: Vec<Diagnostic>, own: Vec<Diagnostic>) -> Vec<Diagnostic> {
        // Several blocks of Klartext have the number of the block that they were made from.
        let theirs = found.into_iter().filter(|finding| !finding.code.starts_with(SYNTAX));
        let theirs = theirs.filter(|finding| !(self.rising && finding.code == NUMBERS));
        let own = own.into_iter().filter(|finding| finding.code != NO_EQUIVALENT);
        let mut all: Vec<Diagnostic> = theirs.map(|finding| self.at_home(finding)).chain(own).collect();
        all.sort_by_key(|finding| finding.place.as_ref().map(|place| (place.span.start, place.span.end)));
        all
    }
}
