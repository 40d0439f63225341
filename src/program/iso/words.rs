//! The words of a DIN/ISO block, each to be written once, and how they are called in Klartext.
//!
//! Invariant: a block whose words are not all taken is refused.
use super::lower::{Refusal, Written};
use crate::base::diag::Span;
use crate::program::syntax::{IsoBlock, IsoKind, NamedWord, Program, ValueKind};

pub(super) const AXES: [&str; 9] = ["X", "Y", "Z", "A", "B", "C", "U", "V", "W"];
pub(super) const PLAIN: [(&str, &str); 9] =
    [("X", "X"), ("Y", "Y"), ("Z", "Z"), ("A", "A"), ("B", "B"), ("C", "C"), ("U", "U"), ("V", "V"), ("W", "W")];
pub(super) const CENTRE: [(&str, &str); 3] = [("I", "X"), ("J", "Y"), ("K", "Z")];
pub(super) const POLAR: [(&str, &str); 11] = [
    ("R", "PR"),
    ("H", "PA"),
    ("X", "X"),
    ("Y", "Y"),
    ("Z", "Z"),
    ("A", "A"),
    ("B", "B"),
    ("C", "C"),
    ("U", "U"),
    ("V", "V"),
    ("W", "W"),
];

/// The words of a block, each to be written once.
pub(super) struct Words<'p> {
    pub(super) program: &'p Program,
    pub(super) own: &'p IsoBlock,
    pub(super) used: Vec<bool>,
}

impl<'p> Words<'p> {
    pub(super) fn new(program: &'p Program, own: &'p IsoBlock) -> Self {
        Self { program, own, used: vec![false; own.words.len()] }
    }

    /// All words.
    pub(super) fn span(&self) -> Span {
        let spans = self.own.words.iter().map(|word| word.span);
        spans.reduce(|a, b| Span::new(a.start.min(b.start), a.end.max(b.end))).unwrap_or_default()
    }

    pub(super) fn code(&self, word: &NamedWord) -> Option<u16> {
        match word.value.kind {
            ValueKind::Number(number) if self.program.slice(word.name).eq_ignore_ascii_case("G") => Some(number as u16),
            _ => None,
        }
    }

    /// The coordinates of a motion, centre or call, if `G90` or `G91` of an earlier block says what they mean.
    pub(super) fn meant_by_mode(&self) -> Option<Span> {
        let moves = matches!(self.own.kind, IsoKind::Path(_) | IsoKind::Centre | IsoKind::Call);
        let own = self.own.words.iter().any(|word| matches!(self.code(word), Some(90 | 91)));
        let is_coordinate = |word: &&NamedWord| {
            let name = self.program.slice(word.name);
            let among = |(own, _): &(&str, &str)| name.eq_ignore_ascii_case(own);
            PLAIN.iter().chain(&CENTRE).any(among) || name.eq_ignore_ascii_case("H")
        };
        let mut coordinates = self.own.words.iter().filter(|_| moves && !own).filter(is_coordinate);
        let first = coordinates.next()?.span;
        Some(coordinates.fold(first, |all, word| Span::new(all.start, word.span.end)))
    }

    /// Codes that are not written yet, with their places.
    pub(super) fn codes(&self) -> Vec<(usize, u16)> {
        let left = self.own.words.iter().enumerate().filter(|(at, _)| !self.used[*at]);
        left.filter_map(|(at, word)| Some((at, self.code(word)?))).collect()
    }

    fn at(&self, name: &str) -> Option<usize> {
        self.own
            .words
            .iter()
            .enumerate()
            .position(|(at, word)| !self.used[at] && self.program.slice(word.name).eq_ignore_ascii_case(name))
    }

    pub(super) fn find(&self, name: &str) -> Option<NamedWord> {
        self.at(name).map(|at| self.own.words[at])
    }

    pub(super) fn has(&self, names: &[&str]) -> bool {
        names.iter().any(|name| self.at(name).is_some())
    }

    pub(super) fn take(&mut self, name: &str) -> Option<NamedWord> {
        let at = self.at(name)?;
        self.used[at] = true;
        Some(self.own.words[at])
    }

    pub(super) fn take_codes(&mut self, is_it: impl Fn(u16) -> bool) {
        for (at, code) in self.codes() {
            self.used[at] |= is_it(code);
        }
    }

    /// Refuses the block if something of it is left.
    pub(super) fn finish(&self) -> Written {
        let left = self.own.words.iter().zip(&self.used).find(|(_, used)| !**used);
        left.map_or(Ok(()), |(word, _)| Err(Refusal::Leftover(word.span)))
    }
}
