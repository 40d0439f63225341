//! Lines as controls and CAM systems print most of them, read letter by letter.
//!
//! Long programs are millions of `12 L X+1.5 Y-2 R0 F500` and `Q200=2 ;LABEL`. Invariant: what is accepted here is what
//! the readers of lines, contour elements and parameters read in it, and all else is left to them.
use memchr::memchr3;

use super::cursor::Cursor;
use super::definition::Assignment;
use super::element::{Compensates, Outline, SEVERAL, Sketch, axis_bit, is_odd, lacks_end, misfit};
use super::lines::{LONGEST_BLOCK, Line};
use super::path::PathCode;
use super::terms::{Axis, Value, ValueKind};
use crate::base::diag::Span;
use crate::base::expr::{QKind, QRef};

/// A contour element on a line of its own, without a comment.
pub(super) struct PlainElement {
    /// The first byte of the next line.
    pub(super) next: usize,
    /// The block number.
    pub(super) number: Option<u32>,
    /// Where the words after the name are.
    pub(super) words: Span,
    pub(super) path: PathCode,
    pub(super) outline: Outline,
    /// The number of its M function, if it has one only.
    pub(super) function: u8,
}

/// Digits of the longest block number that is read here.
const MOST_DIGITS: usize = 9;

/// M functions to which words after them belong.
const WITH_WORDS: [u16; 8] = [94, 103, 112, 118, 124, 128, 138, 197];

/// A place in the text; after its end there is nothing but ends of lines.
#[derive(Clone, Copy)]
struct Scan<'t> {
    bytes: &'t [u8],
    at: usize,
}

impl Scan<'_> {
    #[inline]
    fn byte(&self) -> u8 {
        self.ahead(0)
    }

    /// The byte so many after this one.
    #[inline]
    fn ahead(&self, by: usize) -> u8 {
        self.bytes.get(self.at + by).copied().unwrap_or(b'\n')
    }

    #[inline]
    fn spaces(&mut self) {
        while self.byte() == b' ' {
            self.at += 1;
        }
    }

    /// Whether a word may end at the byte so many after this one.
    #[inline]
    fn ends(&self, by: usize) -> bool {
        matches!(self.ahead(by), b' ' | b'\n' | b'\r')
    }

    /// Passes so many letters if a word ends there.
    #[inline]
    fn word(&mut self, length: usize) -> Option<()> {
        let ends = self.ends(length);
        self.at += length;
        ends.then_some(())
    }

    /// Passes digits: how many.
    #[inline]
    fn digits(&mut self) -> usize {
        let start = self.at;
        while self.byte().is_ascii_digit() {
            self.at += 1;
        }
        self.at - start
    }

    /// Passes a number with or without a sign that ends a word, after so many letters.
    #[inline]
    fn value(&mut self, letters: usize) -> Option<()> {
        self.at += letters;
        self.at += usize::from(matches!(self.byte(), b'+' | b'-'));
        let mut digits = self.digits();
        if self.byte() == b'.' {
            self.at += 1;
            digits += self.digits();
        }
        (digits > 0 && self.ends(0)).then_some(())
    }

    /// A whole number of a few digits.
    #[inline]
    fn whole(&mut self, most: usize) -> Option<u32> {
        let mut value = 0;
        let start = self.at;
        while self.byte().is_ascii_digit() {
            if self.at - start >= most {
                return None;
            }
            value = value * 10 + u32::from(self.byte() - b'0');
            self.at += 1;
        }
        (self.at > start).then_some(value)
    }

    /// The first byte of the next line, at the end of this one.
    #[inline]
    fn next_line(&self) -> usize {
        let two = self.byte() == b'\r' && self.bytes.get(self.at + 1) == Some(&b'\n');
        (self.at + 1 + usize::from(two)).min(self.bytes.len())
    }
}

/// What was found in the words so far.
#[derive(Default)]
struct Words {
    sketch: Sketch,
    /// The axes that are named, a bit each.
    axes: u16,
    /// The number of the only M function.
    function: u8,
    turns: bool,
    radius: bool,
}

impl Words {
    #[inline]
    fn coord(&mut self, axis: Axis) {
        let bit = axis_bit(axis);
        self.sketch.coords = true;
        self.sketch.odd |= self.axes & bit != 0;
        self.axes |= bit;
    }

    /// Passes a word; nothing if it is not one of those that most elements have.
    #[inline]
    fn take(&mut self, scan: &mut Scan<'_>, path: PathCode) -> Option<()> {
        let first = scan.byte();
        if let Some(axis) = axis(first) {
            self.coord(axis);
            return scan.value(1);
        }
        match first {
            b'R' => self.radius(scan, path),
            b'F' if self.sketch.feed.is_none() => self.feed(scan),
            b'M' => self.function(scan),
            b'I' => match axis(scan.ahead(1)) {
                Some(axis) => {
                    self.coord(axis);
                    scan.value(2)
                }
                None => {
                    self.coord(polar(scan.ahead(1), scan.ahead(2))?);
                    scan.value(3)
                }
            },
            b'P' => {
                self.coord(polar(first, scan.ahead(1))?);
                scan.value(2)
            }
            b'D' if scan.ahead(1) == b'R' && matches!(scan.ahead(2), b'+' | b'-') && !self.turns => {
                self.turns = true;
                scan.word(3)
            }
            b'N' | b'T' if path == PathCode::Ln && matches!(scan.ahead(1), b'X'..=b'Z') => scan.value(2),
            _ => None,
        }
    }

    fn radius(&mut self, scan: &mut Scan<'_>, path: PathCode) -> Option<()> {
        let compensation = match scan.ahead(1) {
            b'0' => Compensates::Off,
            b'L' | b'R' => Compensates::Beside,
            _ => Compensates::Unsaid,
        };
        if scan.ends(2) && compensation != Compensates::Unsaid && self.sketch.compensates == Compensates::Unsaid {
            self.sketch.compensates = compensation;
            return scan.word(2);
        }
        if path != PathCode::Cr || self.radius {
            return None;
        }
        self.radius = true;
        scan.value(1)
    }

    fn feed(&mut self, scan: &mut Scan<'_>) -> Option<()> {
        let rest = scan.bytes.get(scan.at + 1..).unwrap_or_default();
        self.sketch.feed = Some(false);
        if rest.first().is_some_and(u8::is_ascii_digit) {
            return scan.value(1);
        }
        if rest.starts_with(b"AUTO") {
            return scan.word(5);
        }
        self.sketch.feed = Some(true);
        if rest.starts_with(b"MAX") {
            scan.word(4)
        } else if rest.starts_with(b" MAX") {
            scan.word(5)
        } else {
            None
        }
    }

    fn function(&mut self, scan: &mut Scan<'_>) -> Option<()> {
        scan.at += 1;
        let number = u16::try_from(scan.whole(3)?).ok().filter(|number| !WITH_WORDS.contains(number))?;
        let several = std::mem::replace(&mut self.sketch.functions, true);
        self.function = if several { SEVERAL } else { u8::try_from(number).unwrap_or(SEVERAL) };
        scan.ends(0).then_some(())
    }
}

#[inline]
fn axis(letter: u8) -> Option<Axis> {
    Some(match letter {
        b'X' => Axis::X,
        b'Y' => Axis::Y,
        b'Z' => Axis::Z,
        b'A' => Axis::A,
        b'B' => Axis::B,
        b'C' => Axis::C,
        b'U' => Axis::U,
        b'V' => Axis::V,
        b'W' => Axis::W,
        _ => return None,
    })
}

fn polar(first: u8, second: u8) -> Option<Axis> {
    match (first, second) {
        (b'P', b'R') => Some(Axis::Pr),
        (b'P', b'A') => Some(Axis::Pa),
        _ => None,
    }
}

/// The contour element that is all of the line at a byte; nothing if it is not one in the usual words.
pub(super) fn element(bytes: &[u8], start: usize) -> Option<PlainElement> {
    let mut scan = Scan { bytes, at: start };
    scan.spaces();
    let mut number = None;
    if scan.byte().is_ascii_digit() {
        number = Some(scan.whole(MOST_DIGITS)?);
        if scan.byte() != b' ' {
            return None;
        }
        scan.spaces();
    }
    let (path, length) = match (scan.byte(), scan.ahead(1)) {
        (b'L', b' ') => (PathCode::L, 1),
        (b'L', b'N') => (PathCode::Ln, 2),
        (b'L', b'P') => (PathCode::Lp, 2),
        (b'C', b' ') => (PathCode::C, 1),
        (b'C', b'C') => (PathCode::Cc, 2),
        (b'C', b'R') => (PathCode::Cr, 2),
        (b'C', b'T') => (PathCode::Ct, 2),
        (b'C', b'P') => (PathCode::Cp, 2),
        _ => return None,
    };
    scan.word(length)?;
    let mut span = Span::new(scan.at, scan.at);
    let mut words = Words::default();
    loop {
        scan.spaces();
        if matches!(scan.byte(), b'\n' | b'\r') {
            break;
        }
        words.take(&mut scan, path)?;
        span.end = scan.at;
        if span.end - start > LONGEST_BLOCK {
            return None;
        }
    }
    let own = path.path();
    let Words { mut sketch, function, axes, turns, .. } = words;
    sketch.odd |= is_odd(own, axes)
        || lacks_end(own, !sketch.coords)
        || misfit(own, turns, sketch.feed.is_some(), sketch.compensates).is_some();
    Some(PlainElement { next: scan.next_line(), number, words: span, path, outline: Outline::new(sketch), function })
}

/// The parameter with a number as its value that is all of the line at a byte, its comment, the label in it and a joint
/// included; nothing if it is written in another way than usual.
pub(super) fn parameter(text: &str, start: usize) -> Option<(Line, Assignment, Option<Span>)> {
    let mut scan = Scan { bytes: text.as_bytes(), at: start };
    scan.spaces();
    let first = scan.at;
    if scan.byte() != b'Q' {
        return None;
    }
    scan.at += 1;
    let q = QRef { kind: QKind::Q, number: u16::try_from(scan.whole(5)?).ok()? };
    let q_span = Span::new(first, scan.at);
    if scan.byte() != b'=' {
        return None;
    }
    scan.at += 1;
    let from = scan.at;
    let negative = scan.byte() == b'-';
    scan.at += usize::from(matches!(scan.byte(), b'+' | b'-'));
    let mut cursor = Cursor::new(text, Span::new(scan.at, text.len()));
    let number = cursor.opt_number()?;
    let value =
        Value { span: Span::new(from, cursor.at), kind: ValueKind::Number(if negative { -number } else { number }) };
    let content = Span::new(first, cursor.at);
    scan.at = cursor.at;
    scan.spaces();
    let (comment, label, joined, next) = rest_of_line(&mut scan)?;
    let line = Line {
        start,
        next,
        skip: false,
        number: None,
        content,
        comment,
        joined,
        wraps: joined && comment.is_some(),
        twice: false,
    };
    Some((line, Assignment { span: content, q, q_span, value, tight: true }, label))
}

/// What is after a parameter: the comment, the label in it, whether a joint follows,
/// and where the next line begins.
fn rest_of_line(scan: &mut Scan<'_>) -> Option<(Option<Span>, Option<Span>, bool, usize)> {
    match scan.byte() {
        b'\n' | b'\r' => return Some((None, None, false, scan.next_line())),
        b'~' => {
            scan.at += 1;
            scan.spaces();
            return matches!(scan.byte(), b'\n' | b'\r').then(|| (None, None, true, scan.next_line()));
        }
        b';' => {}
        _ => return None,
    }
    let start = scan.at;
    let rest = scan.bytes.get(start..)?;
    let length = memchr3(b'\n', b'\r', b'\t', rest).unwrap_or(rest.len());
    let line = rest.get(..length)?;
    scan.at = start + length;
    if scan.byte() == b'\t' {
        return None;
    }
    let without_spaces = |line: &[u8]| line.len() - line.iter().rev().take_while(|byte| **byte == b' ').count();
    let mut end = without_spaces(line);
    let joined = line.get(end - 1) == Some(&b'~');
    if joined {
        end = without_spaces(line.get(..end - 1)?);
    }
    // Marks that count as blanks, and a second joint.
    let is_end = |byte: u8| byte != b'~' && byte != 0xA0 && (byte.is_ascii_graphic() || byte >= 0x80);
    let is_start = |byte: u8| byte != 0xC2 && byte != 0xEF && (byte.is_ascii_graphic() || byte >= 0x80);
    let blanks = line.get(1..end)?.iter().take_while(|byte| **byte == b' ').count();
    let label = Span::new(start + 1 + blanks, start + end);
    let plain = is_end(*line.get(end - 1)?) && (label.start == label.end || is_start(*line.get(1 + blanks)?));
    let comment = Span::new(start, start + end);
    plain.then(|| (Some(comment), (label.start < label.end).then_some(label), joined, scan.next_line()))
}
