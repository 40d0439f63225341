//! Events as lines of JSON, written straight into bytes.
//!
//! Invariant: the bytes are those that the tree of the same event gives. What an event has in it is `json.rs`'s affair.
use std::sync::Arc;

use glam::DVec3;

use super::event::{At, Event};
use super::json::{Object, plain};
use crate::spec::CycleKey;

/// How many numbers are remembered with their digits, a power of two: a move begins where the one before it ended, and
/// heights and feeds come again and again.
const REMEMBERED: usize = 512;
/// As many characters as a number has at most.
const LONGEST: usize = 24;

/// How many points and steps are remembered with their texts.
const PLACES: usize = 4;

/// A number with its digits.
#[derive(Clone, Copy)]
struct Written {
    bits: u64,
    digits: [u8; LONGEST],
    length: u8,
}

/// A point with its text.
#[derive(Clone, Default)]
struct WrittenPoint {
    bits: [u64; 3],
    text: Vec<u8>,
}

/// A step of a cycle with its members.
#[derive(Clone, Default)]
struct WrittenStep {
    cycle: Option<(CycleKey, Option<Arc<str>>)>,
    text: Vec<u8>,
}

/// Lines of events, one after the other.
pub struct Lines {
    bytes: Vec<u8>,
    numbers: Box<[Written]>,
    points: [WrittenPoint; PLACES],
    steps: [WrittenStep; PLACES],
    /// How many points and steps were kept so far: the oldest one gives way.
    kept: [usize; 2],
}

impl Default for Lines {
    fn default() -> Self {
        let mut digits = [b' '; LONGEST];
        digits[..3].copy_from_slice(b"0.0");
        let zero = Written { bits: 0, digits, length: 3 };
        let numbers = vec![zero; REMEMBERED].into_boxed_slice();
        Self { bytes: Vec::new(), numbers, points: Default::default(), steps: Default::default(), kept: [0; 2] }
    }
}

impl Lines {
    /// Adds the line of an event.
    pub fn add(&mut self, event: &Event) {
        let start = self.bytes.len();
        event.members(self);
        // What is before the first member opens the object; before the others it parts them.
        if let Some(first) = self.bytes.get_mut(start) {
            *first = b'{';
        }
        self.bytes.extend_from_slice(b"}\n");
    }

    /// What was added since they were emptied.
    pub fn bytes(&self) -> &[u8] {
        &self.bytes
    }

    /// Forgets the lines.
    pub fn clear(&mut self) {
        self.bytes.clear();
    }

    /// Writes the members of a step and keeps them.
    fn add_step(&mut self, at: &At) {
        let start = self.bytes.len();
        at.step_members(self);
        let Some(oldest) = self.steps.get_mut(self.kept[1] % PLACES) else { return };
        oldest.cycle.clone_from(&at.cycle);
        oldest.text.clear();
        oldest.text.extend_from_slice(self.bytes.get(start..).unwrap_or_default());
        self.kept[1] += 1;
    }

    /// Writes a point and keeps its text.
    fn add_point(&mut self, bits: [u64; 3]) {
        let start = self.bytes.len();
        for (before, bits) in ["{\"X\":", ",\"Y\":", ",\"Z\":"].iter().zip(bits) {
            self.bytes.extend_from_slice(before.as_bytes());
            self.digits(f64::from_bits(bits));
        }
        self.bytes.push(b'}');
        let Some(oldest) = self.points.get_mut(self.kept[0] % PLACES) else { return };
        oldest.bits = bits;
        oldest.text.clear();
        oldest.text.extend_from_slice(self.bytes.get(start..).unwrap_or_default());
        self.kept[0] += 1;
    }

    #[inline]
    fn key(&mut self, key: &str) {
        self.bytes.extend_from_slice(b",\"");
        self.bytes.extend_from_slice(key.as_bytes());
        self.bytes.extend_from_slice(b"\":");
    }

    #[inline]
    fn digits(&mut self, number: f64) {
        let bits = number.to_bits();
        // The uppermost bits of the product depend on all bits of the number, which mostly ends with zeros.
        let place = (bits.wrapping_mul(0x9E37_79B9_7F4A_7C15) >> (64 - REMEMBERED.ilog2())) as usize;
        let Some(kept) = self.numbers.get_mut(place) else { return };
        if kept.bits != bits {
            *kept = write(number);
        }
        // As many bytes as a copy of fixed length has, then the rest is cut off.
        self.bytes.extend_from_slice(&kept.digits);
        self.bytes.truncate(self.bytes.len() - (LONGEST - usize::from(kept.length)));
    }

    #[inline]
    fn quoted(&mut self, text: &str) {
        let bytes = text.as_bytes();
        if bytes.iter().fold(false, |found, byte| found | (*byte < b' ') | (*byte == b'"') | (*byte == b'\\')) {
            return self.escaped(text);
        }
        self.bytes.push(b'"');
        self.bytes.extend_from_slice(bytes);
        self.bytes.push(b'"');
    }

    #[cold]
    fn escaped(&mut self, text: &str) {
        // A text can always be written.
        self.bytes.extend(serde_json::to_string(text).unwrap_or_default().bytes());
    }
}

/// Whether it is the same step: that of the same specification is the same text in memory.
fn same(a: &(CycleKey, Option<Arc<str>>), b: &(CycleKey, Option<Arc<str>>)) -> bool {
    let step = match (&a.1, &b.1) {
        (Some(a), Some(b)) => Arc::ptr_eq(a, b),
        (None, None) => true,
        _ => false,
    };
    step && a.0 == b.0
}

#[cold]
fn write(number: f64) -> Written {
    let mut buffer = zmij::Buffer::new();
    let text = if number.is_finite() { buffer.format_finite(number) } else { "null" };
    let mut written = Written { bits: number.to_bits(), digits: [b' '; LONGEST], length: text.len() as u8 };
    written.digits.iter_mut().zip(text.bytes()).for_each(|(digit, byte)| *digit = byte);
    written
}

impl Object for Lines {
    #[inline]
    fn text(&mut self, key: &str, text: &str) {
        self.key(key);
        self.quoted(text);
    }

    #[inline]
    fn number(&mut self, key: &str, number: f64) {
        self.key(key);
        self.digits(number);
    }

    #[inline]
    fn whole(&mut self, key: &str, whole: i64) {
        self.key(key);
        self.bytes.extend_from_slice(itoa::Buffer::new().format(whole).as_bytes());
    }

    fn truth(&mut self, key: &str, truth: bool) {
        self.key(key);
        self.bytes.extend_from_slice(if truth { b"true" } else { b"false" });
    }

    #[inline]
    fn null(&mut self, key: &str) {
        self.key(key);
        self.bytes.extend_from_slice(b"null");
    }

    #[inline]
    fn object(&mut self, key: &str, fill: impl FnOnce(&mut Self)) {
        self.key(key);
        let start = self.bytes.len();
        fill(self);
        match self.bytes.get_mut(start) {
            Some(first) => *first = b'{',
            None => self.bytes.push(b'{'),
        }
        self.bytes.push(b'}');
    }

    #[inline]
    fn place(&mut self, at: &At) {
        at.line_members(self);
        let Some(cycle) = &at.cycle else { return };
        match self.steps.iter().find(|known| known.cycle.as_ref().is_some_and(|known| same(known, cycle))) {
            Some(known) => self.bytes.extend_from_slice(&known.text),
            None => self.add_step(at),
        }
    }

    #[inline]
    fn point(&mut self, key: &str, point: DVec3) {
        self.key(key);
        let bits = [point.x, point.y, point.z].map(|number| plain(number).to_bits());
        match self.points.iter().find(|known| known.bits == bits && !known.text.is_empty()) {
            Some(known) => self.bytes.extend_from_slice(&known.text),
            None => self.add_point(bits),
        }
    }

    fn letters(&mut self, key: &str, letters: &[char]) {
        self.key(key);
        let start = self.bytes.len();
        for letter in letters {
            self.bytes.push(b',');
            self.quoted(letter.encode_utf8(&mut [0; 4]));
        }
        self.close_list(start);
    }

    fn rows(&mut self, key: &str, rows: &[[f64; 4]]) {
        self.key(key);
        let start = self.bytes.len();
        for row in rows {
            self.bytes.push(b',');
            let start = self.bytes.len();
            for number in row {
                self.bytes.push(b',');
                self.digits(*number);
            }
            self.close_list(start);
        }
        self.close_list(start);
    }
}

impl Lines {
    /// Makes a list of what was written from there on, each item after a comma.
    fn close_list(&mut self, start: usize) {
        match self.bytes.get_mut(start) {
            Some(first) => *first = b'[',
            None => self.bytes.push(b'['),
        }
        self.bytes.push(b']');
    }
}
