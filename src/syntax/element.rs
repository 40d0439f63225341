//! Contour elements, read in full when they are first asked for.
//!
//! Programs of CAM systems are millions of them, and few readers look at every word. The parser checks each and keeps
//! where it stands. Invariant: what is read later is what the parser accepted.
use std::ops::Deref;
use std::sync::{Arc, OnceLock};

use super::cursor::{Cursor, Read};
use super::motion;
use super::path::Path;
use super::tree::Motion;
use crate::diag::{Source, Span};

/// The bit of a length that says that M functions are among the words.
const FUNCTIONS: u16 = 1 << 15;

/// A contour element or positioning; its words are those of the [`Motion`] that it stands for.
#[derive(Clone)]
pub struct Element {
    source: Arc<Source>,
    read: OnceLock<Box<Motion>>,
    /// Where the words behind the name begin.
    start: u32,
    /// How long they are.
    length: u16,
    path: Path,
}

/// What the parser needs to check elements one by one.
pub(super) struct Checker<'s> {
    source: &'s Arc<Source>,
    words: Motion,
}

impl<'s> Checker<'s> {
    pub(super) fn new(source: &'s Arc<Source>) -> Self {
        Self { source, words: Motion::new(Path::L) }
    }

    /// The words of the element that was checked last.
    pub(super) const fn words(&self) -> &Motion {
        &self.words
    }

    /// Checks the words of a contour element, its name being read.
    pub(super) fn element(&mut self, cursor: &mut Cursor<'_>, path: Path) -> Read<Element> {
        let span = Span::new(cursor.at, cursor.end);
        self.words.clear(path);
        motion::motion(cursor, &mut self.words)?;
        let functions = if self.words.functions.is_empty() { 0 } else { FUNCTIONS };
        let length = u16::try_from(span.end - span.start).ok().filter(|length| *length < FUNCTIONS);
        let (read, start, length) = match (u32::try_from(span.start), length) {
            (Ok(start), Some(length)) => (OnceLock::new(), start, length),
            // Too far away or too long to be found again by small numbers.
            _ => (OnceLock::from(Box::new(self.words.clone())), 0, 0),
        };
        Ok(Element { source: Arc::clone(self.source), read, start, length: length | functions, path })
    }
}

impl Element {
    /// The kind of contour element.
    pub const fn path(&self) -> Path {
        self.path
    }

    /// Whether M functions are among its words; known without reading them.
    pub const fn has_functions(&self) -> bool {
        self.length & FUNCTIONS != 0
    }

    /// Its words, read anew and not kept: for those who look at each element of a long program once.
    pub fn words(&self) -> Motion {
        self.read.get().map_or_else(|| self.again(), |read| (**read).clone())
    }

    fn again(&self) -> Motion {
        let start = self.start as usize;
        let span = Span::new(start, start + usize::from(self.length & !FUNCTIONS));
        let mut words = Motion::new(self.path);
        // It was read once without an error.
        let _ = motion::motion(&mut Cursor::new(self.source.text(), span), &mut words);
        words
    }
}

impl Deref for Element {
    type Target = Motion;

    fn deref(&self) -> &Motion {
        self.read.get_or_init(|| Box::new(self.again()))
    }
}

impl std::fmt::Debug for Element {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        self.deref().fmt(f)
    }
}
