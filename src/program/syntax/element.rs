//! Contour elements, read in full when they are first asked for.
//!
//! Programs of CAM systems are millions of them, and few readers look at every word. The parser checks each and keeps
//! where it is and an outline of it. Invariant: what is read later is what the parser accepted, and the outline
//! says nothing that the words do not say.
use std::ops::Deref;
use std::sync::{Arc, OnceLock};

use super::cursor::{Cursor, Read};
use super::motion;
use super::path::{Path, PathCode};
use super::plain::PlainElement;
use super::terms::{Amount, Axis, Compensation, Coord, FeedKind, MFunction, Motion, Operand};
use crate::base::diag::{Source, Span};

/// A contour element or positioning; its words are those of the [`Motion`] that it stands for.
#[derive(Clone)]
pub struct Element {
    source: Arc<Source>,
    read: OnceLock<Box<Motion>>,
    /// Where the words after the name begin.
    start: u32,
    /// How long they are.
    length: u8,
    path: PathCode,
    outline: Outline,
    /// The number of its M function, if it has one only, or [`SEVERAL`]; of one that has none, whether it ends with the
    /// letter alone.
    function: u8,
}

/// Stands for M functions whose numbers are not kept.
pub(super) const SEVERAL: u8 = u8::MAX;

/// What the words of an element are, as far as it is kept together with their place.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Outline(u8);

/// Whether and how an element says its radius compensation.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Compensates {
    /// It does not.
    #[default]
    Unsaid,
    /// `R0`.
    Off,
    /// `RL` or `RR`.
    Beside,
    /// `R+` or `R-`.
    Along,
}

/// What an outline says.
#[derive(Clone, Copy, Default)]
pub(super) struct Sketch {
    pub(super) functions: bool,
    pub(super) parameters: bool,
    pub(super) coords: bool,
    /// Whether coordinates want a look: an axis twice, one that the path does not have, or a centre in another plane.
    pub(super) odd: bool,
    /// Whether the feed is `FMAX`, if one is said.
    pub(super) feed: Option<bool>,
    pub(super) compensates: Compensates,
}

impl Outline {
    const FUNCTIONS: u8 = 1;
    const PARAMETERS: u8 = 1 << 1;
    const COORDS: u8 = 1 << 2;
    const ODD: u8 = 1 << 3;
    const RAPID: u8 = 1 << 4;
    const FEED: u8 = 1 << 5;
    const COMPENSATION: u8 = 6;

    /// The outline of words.
    pub fn of(motion: &Motion) -> Self {
        let q = |operand: &Operand| matches!(operand.amount, Amount::Q { .. });
        let feed = motion.feed.map(|feed| feed.kind);
        let fed_by_q = match &feed {
            Some(FeedKind::Value(own) | FeedKind::PerRevolution(own) | FeedKind::PerTooth(own)) => q(own),
            _ => false,
        };
        let parameters =
            motion.coords.iter().any(|coord| q(&coord.value)) || motion.radius.as_ref().is_some_and(q) || fed_by_q;
        let compensates = match motion.compensation {
            None => Compensates::Unsaid,
            Some(Compensation::R0) => Compensates::Off,
            Some(Compensation::Rl | Compensation::Rr) => Compensates::Beside,
            Some(Compensation::Longer | Compensation::Shorter) => Compensates::Along,
        };
        Self::new(Sketch {
            functions: !motion.functions.is_empty(),
            parameters,
            coords: !motion.coords.is_empty(),
            odd: axis_twice(&motion.coords).is_some()
                || is_odd(motion.path, axes_of(&motion.coords))
                || lacks_end(motion.path, motion.coords.is_empty())
                || misfit(motion.path, motion.counter_clockwise.is_some(), feed.is_some(), compensates).is_some(),
            feed: feed.map(|feed| feed == FeedKind::Max),
            compensates,
        })
    }

    /// The outline that says so.
    pub(super) const fn new(sketch: Sketch) -> Self {
        const fn bit(is: bool, bit: u8) -> u8 {
            if is { bit } else { 0 }
        }
        Self(
            bit(sketch.functions, Self::FUNCTIONS)
                | bit(sketch.parameters, Self::PARAMETERS)
                | bit(sketch.coords, Self::COORDS)
                | bit(sketch.odd, Self::ODD)
                | bit(matches!(sketch.feed, Some(true)), Self::RAPID)
                | bit(matches!(sketch.feed, Some(false)), Self::FEED)
                | ((sketch.compensates as u8) << Self::COMPENSATION),
        )
    }

    const fn has(self, bit: u8) -> bool {
        self.0 & bit != 0
    }

    /// Whether M functions are among the words.
    pub const fn has_functions(self) -> bool {
        self.has(Self::FUNCTIONS)
    }

    /// Whether a coordinate, the radius or the feed is a parameter.
    pub const fn has_parameters(self) -> bool {
        self.has(Self::PARAMETERS)
    }

    /// Whether it has coordinates.
    pub const fn has_coords(self) -> bool {
        self.has(Self::COORDS)
    }

    /// Whether coordinates want a look: an axis twice, one that the path does not have, or a centre in another plane.
    pub const fn has_odd_coords(self) -> bool {
        self.has(Self::ODD)
    }

    /// Whether it says `FMAX`.
    pub const fn is_rapid(self) -> bool {
        self.has(Self::RAPID)
    }

    /// Whether it says a feed that is not `FMAX`.
    pub const fn has_feed(self) -> bool {
        self.has(Self::FEED)
    }

    /// Its radius compensation.
    pub const fn compensates(self) -> Compensates {
        match self.0 >> Self::COMPENSATION {
            0 => Compensates::Unsaid,
            1 => Compensates::Off,
            2 => Compensates::Beside,
            _ => Compensates::Along,
        }
    }
}

/// The first coordinate whose axis is named before, and where that is.
pub fn axis_twice(coords: &[Coord]) -> Option<(&Coord, &Coord)> {
    coords.iter().enumerate().find_map(|(at, coord)| {
        let first = coords.iter().take(at).find(|first| first.axis == coord.axis)?;
        Some((first, coord))
    })
}

/// The axes of coordinates, a bit each.
fn axes_of(coords: &[Coord]) -> u16 {
    coords.iter().fold(0, |axes, coord| axes | axis_bit(coord.axis))
}

/// The bit of an axis among those of a block.
pub(super) const fn axis_bit(axis: Axis) -> u16 {
    1 << axis as u16
}

/// Whether a block names coordinates that its path does not have, or lacks the one without which it leads nowhere:
/// polar ones belong to polar paths, an arc about the pole ends at an angle, and a centre lies in a plane.
const fn misplaced(path: Path, axes: u16) -> bool {
    let (radius, angle) = (axes & axis_bit(Axis::Pr) != 0, axes & axis_bit(Axis::Pa) != 0);
    let straight = axes & (axis_bit(Axis::X) | axis_bit(Axis::Y) | axis_bit(Axis::Z));
    match path {
        Path::Lp | Path::Ctp => axes != 0 && !radius && !angle,
        Path::Cp => radius || !angle,
        Path::Cc => radius || angle || straight.count_ones() > 2,
        Path::L | Path::Ln | Path::C | Path::Cr | Path::Ct => radius || angle,
        Path::Rnd | Path::Chf => axes != 0,
        _ => false,
    }
}

/// The same, or a centre that lies in another plane than that of X and Y.
pub(super) const fn is_odd(path: Path, axes: u16) -> bool {
    misplaced(path, axes) || (matches!(path, Path::Cc) && axes & axis_bit(Axis::Z) != 0)
}

/// A word that the path of an element does not have: only arcs go round, and nothing moves where a centre is set.
pub(super) const fn misfit(path: Path, turns: bool, feed: bool, compensates: Compensates) -> Option<&'static str> {
    let straight = matches!(path, Path::L | Path::Ln | Path::Lp | Path::Rnd | Path::Chf | Path::Cc);
    let tangential = matches!(path, Path::Ct | Path::Ctp);
    match compensates {
        _ if turns && (straight || tangential) => Some("DR"),
        _ if feed && matches!(path, Path::Cc) => Some("F"),
        Compensates::Unsaid => None,
        _ if matches!(path, Path::Cc) => Some("R0, RL, RR"),
        _ => None,
    }
}

/// Whether it says no end, and cannot end where it begins.
pub(super) const fn lacks_end(path: Path, endless: bool) -> bool {
    endless && matches!(path, Path::Cr | Path::Ct)
}

/// A word that the path of an element does not have.
pub fn misfitting(motion: &Motion) -> Option<&'static str> {
    let turns = motion.counter_clockwise.is_some();
    misfit(motion.path, turns, motion.feed.is_some(), Outline::of(motion).compensates())
}

/// Whether the coordinates of an element are not those that its path has.
pub fn is_misplaced(motion: &Motion) -> bool {
    misplaced(motion.path, axes_of(&motion.coords))
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
        let function = match self.words.functions.as_slice() {
            [] => u8::from(ends_with_letter(cursor.bytes, span)),
            [only] => u8::try_from(only.number).unwrap_or(SEVERAL),
            _ => SEVERAL,
        };
        let (read, start, length) = match (u32::try_from(span.start), u8::try_from(span.end - span.start)) {
            (Ok(start), Ok(length)) => (OnceLock::new(), start, length),
            // Too far away or too long to be found again by small numbers.
            _ => (OnceLock::from(Box::new(self.words.clone())), 0, 0),
        };
        let outline = Outline::of(&self.words);
        let path = PathCode::of(path);
        Ok(Element { source: Arc::clone(self.source), read, start, length, path, outline, function })
    }

    /// The same of a line in the usual words; nothing if it is too far away or too long for small numbers.
    pub(super) fn plain(&self, own: &PlainElement) -> Option<Element> {
        let PlainElement { words, path, outline, function, .. } = *own;
        let start = u32::try_from(words.start).ok()?;
        let length = u8::try_from(words.end - words.start).ok()?;
        Some(Element { source: Arc::clone(self.source), read: OnceLock::new(), start, length, path, outline, function })
    }
}

fn ends_with_letter(bytes: &[u8], span: Span) -> bool {
    matches!(bytes.get(span.start..span.end), Some([.., b' ' | b'\t', b'M' | b'm']))
}

impl Element {
    /// The kind of contour element.
    pub const fn path(&self) -> Path {
        self.path.path()
    }

    /// What is known of its words without reading them.
    pub const fn outline(&self) -> Outline {
        self.outline
    }

    /// Whether it has no M function and ends with the letter of one.
    pub const fn ends_with_letter(&self) -> bool {
        !self.has_functions() && self.function != 0
    }

    /// Whether M functions are among its words; known without reading them.
    pub const fn has_functions(&self) -> bool {
        self.outline.has_functions()
    }

    /// The numbers of its M functions, in the order written; most often known without reading them.
    pub fn each_function(&self, mut each: impl FnMut(u16)) {
        match self.function {
            _ if !self.has_functions() => {}
            SEVERAL => self.functions().iter().for_each(|function| each(function.number)),
            only => each(u16::from(only)),
        }
    }

    /// Its M functions, read anew and not kept.
    pub fn functions(&self) -> Vec<MFunction> {
        if self.has_functions() { self.words().functions } else { Vec::new() }
    }

    /// The place of its M function, if it has one only and ends with it; nothing if that cannot be said without reading
    /// its words.
    pub fn last_function(&self) -> Option<(u16, Span)> {
        let (number, start) = (self.function, self.start as usize);
        if !self.has_functions() || number == SEVERAL || self.read.get().is_some() {
            return None;
        }
        let text = self.source.text().as_bytes().get(start..start + usize::from(self.length))?.trim_ascii_end();
        let at = text.iter().rposition(|byte| !byte.is_ascii_digit())?;
        let (letter, digits) = text.get(at..)?.split_first()?;
        let written = digits.iter().try_fold(0_u8, |all, digit| all.checked_mul(10)?.checked_add(digit - b'0'))?;
        let is_function = matches!(letter, b'M' | b'm') && !digits.is_empty() && written == number;
        let starts_word = at == 0 || matches!(text.get(at - 1), Some(b' ' | b'\t'));
        (is_function && starts_word).then(|| (u16::from(number), Span::new(start + at, start + at + 1 + digits.len())))
    }

    /// Its words, read anew and not kept: for those who look at each element of a long program once.
    pub fn words(&self) -> Motion {
        let mut words = Motion::new(self.path());
        self.read_into(&mut words);
        words
    }

    /// Its words in place of others, whose room they take.
    pub fn read_into(&self, words: &mut Motion) {
        if let Some(read) = self.read.get() {
            words.clone_from(read);
            return;
        }
        words.clear(self.path());
        let start = self.start as usize;
        let span = Span::new(start, start + usize::from(self.length));
        // It was read once without an error.
        let _ = motion::motion(&mut Cursor::new(self.source.text(), span), words);
    }
}

impl Deref for Element {
    type Target = Motion;

    fn deref(&self) -> &Motion {
        self.read.get_or_init(|| Box::new(self.words()))
    }
}

impl std::fmt::Debug for Element {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        self.deref().fmt(f)
    }
}
