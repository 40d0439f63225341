//! Files of translators as they come back, whatever their form.
use super::fluent::{Piece, merged};
pub use crate::base::xml::Unreadable;

/// A form of files for translators.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Form {
    /// XLIFF 1.2.
    Xliff,
    /// XLIFF 2.0.
    Xliff2,
    /// Gettext PO.
    Po,
}

/// A unit as it comes back.
#[derive(Clone, Debug)]
pub struct Received {
    /// Its identifier.
    pub id: String,
    /// Where it is in the file.
    pub at: usize,
    /// Whether the translator says that it is done.
    pub is_final: bool,
    /// Its source; nothing if it cannot be understood.
    pub source: Option<Vec<Piece>>,
    /// Its translation; nothing if there is none, or if it cannot be understood.
    pub target: Option<Vec<Piece>>,
}

impl Received {
    /// Takes the unit for final if it has a translation, whatever state it has: some tools keep none. The words of the
    /// source are no translation.
    pub fn settle(&mut self) {
        let is_translated =
            self.target.as_ref().is_some_and(|target| !target.is_empty() && Some(target) != self.source.as_ref());
        self.is_final |= is_translated;
    }

    /// The same unit as it was exported, but for what a translator has changed: with the blanks between codes, and without
    /// the line breaks and blanks with which a tool has laid out its elements. Only where the source is then that of today,
    /// and neither text has lines of its own, is that certain.
    pub(super) fn into_exported_form(mut self, source: &[Piece], target: &[Piece]) -> Self {
        self = self.into_layout_of_export(source, target);
        self.source = self.source.map(|own| with_blanks(&own, source));
        self.target = self.target.map(|own| with_blanks(&own, target));
        self
    }

    fn into_layout_of_export(self, source: &[Piece], target: &[Piece]) -> Self {
        let has_lines =
            |pieces: &[Piece]| pieces.iter().any(|piece| matches!(piece, Piece::Text(words) if words.contains('\n')));
        if has_lines(source) || has_lines(target) {
            return self;
        }
        // A source without codes has no layout, and its translation only beside codes.
        if self.source.as_deref() == Some(source) {
            let own = self.target.map(|own| if has_inner_lines(&own) { own } else { without_layout(&own) });
            return Self { target: own, ..self };
        }
        let own = self.source.as_deref().map(without_layout);
        if own.as_deref().map(|own| with_blanks(own, source)).as_deref() != Some(source) {
            return self;
        }
        Self { source: own, target: self.target.as_deref().map(without_layout), ..self }
    }
}

/// Whether these are two codes with nothing but blanks between them.
fn is_blank_between(pieces: &[Piece]) -> bool {
    matches!(pieces, [Piece::Code(_), Piece::Text(blank), Piece::Code(_)] if blank.trim_matches(' ').is_empty())
}

/// Puts back blanks that are all there is between two codes: some tools lose them, and nobody takes them away alone.
fn with_blanks(pieces: &[Piece], model: &[Piece]) -> Vec<Piece> {
    let mut all: Vec<Piece> = Vec::with_capacity(pieces.len());
    for piece in pieces {
        if let (Some(Piece::Code(before)), Piece::Code(after)) = (all.last(), piece) {
            let is_here = |own: &&[Piece]| {
                is_blank_between(own)
                    && matches!(own, [Piece::Code(one), _, Piece::Code(other)] if one == before && other == after)
            };
            all.extend(model.windows(3).find(is_here).and_then(|own| own.get(1)).cloned());
        }
        all.push(piece.clone());
    }
    all
}

/// Whether there is a sign in the words that nobody sees: a control character, or one that turns the direction of what follows.
pub(super) fn has_hidden(pieces: &[Piece]) -> bool {
    let is_hidden = |c: char| match c {
        '\n' | '\t' | '\r' => false,
        '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}' => true,
        c => c.is_control(),
    };
    pieces.iter().any(|piece| matches!(piece, Piece::Text(words) if words.contains(is_hidden)))
}

/// Whether there are line breaks between words, and not only beside codes.
fn has_inner_lines(pieces: &[Piece]) -> bool {
    pieces.iter().any(|piece| matches!(piece, Piece::Text(words) if words.trim().contains('\n')))
}

/// Words without line breaks and the blanks after them.
fn without_layout(pieces: &[Piece]) -> Vec<Piece> {
    let words = |words: &str| {
        let mut lines = words.split('\n');
        let first = lines.next().unwrap_or_default().to_owned();
        lines.fold(first, |all, line| all + line.trim_start_matches([' ', '\t', '\r']))
    };
    let piece = |piece: &Piece| match piece {
        Piece::Text(text) => Piece::Text(words(text)),
        Piece::Code(code) => Piece::Code(code.clone()),
    };
    merged(pieces.iter().map(piece).collect())
}

/// A file from a translator.
#[derive(Clone, Debug, Default)]
pub struct Returned {
    /// The tag of the language, as the file says it.
    pub language: Option<String>,
    /// Its units.
    pub units: Vec<Received>,
}

/// The length of the placeable with which a text begins.
pub(super) fn code_length(text: &str) -> Option<usize> {
    let mut depth = 0_usize;
    let mut quoted = false;
    for (at, byte) in text.bytes().enumerate() {
        match byte {
            b'"' => quoted = !quoted,
            b'{' if !quoted => depth += 1,
            b'}' if !quoted => {
                depth = depth.checked_sub(1)?;
                if depth == 0 {
                    return Some(at + 1);
                }
            }
            _ => {}
        }
    }
    None
}
