//! Writing a text piece by piece, remembering where each comes from.
use crate::base::diag::Span;

use super::home::Piece;

/// A text in the making.
pub(super) struct Writer<'t> {
    /// The text that it is made from.
    from: &'t str,
    pub(super) text: String,
    pub(super) pieces: Vec<Piece>,
    /// What the pieces that are not copied are made from.
    pub(super) home: Span,
}

impl<'t> Writer<'t> {
    pub(super) fn new(from: &'t str) -> Self {
        Self { from, text: String::with_capacity(from.len() * 2), pieces: Vec::new(), home: Span::new(0, 0) }
    }

    /// Adds a text of one's own.
    pub(super) fn put(&mut self, text: &str) {
        if text.is_empty() {
            return;
        }
        self.text.push_str(text);
        let end = self.text.len();
        match self.pieces.last_mut().filter(|last| !last.copied && last.home == self.home) {
            Some(last) => last.end = end,
            None => self.pieces.push(Piece { end, home: self.home, copied: false }),
        }
    }

    /// Adds the text of a place.
    pub(super) fn copy(&mut self, span: Span) {
        let copied = self.from.get(span.start..span.end).unwrap_or_default();
        if copied.is_empty() {
            return;
        }
        self.text.push_str(copied);
        self.pieces.push(Piece { end: self.text.len(), home: span, copied: true });
    }

    /// Takes back what was added from a byte on.
    pub(super) fn truncate(&mut self, at: usize) {
        self.text.truncate(at);
        while self.pieces.last().is_some_and(|last| last.end > at) {
            self.pieces.pop();
        }
        let end = self.pieces.last().map_or(0, |last| last.end);
        if end < at {
            self.pieces.push(Piece { end: at, home: self.home, copied: false });
        }
    }
}
