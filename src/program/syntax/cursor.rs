//! A place in a block's text, and the lexemes that blocks are made of.
//!
//! The text of a block may run over several lines joined by `~`; the cursor passes over the joints as
//! over blanks. Invariant: it never moves back, and every lexeme takes time in proportion to its length.
use super::terms::{Amount, Operand, SyntaxError};
use crate::base::diag::Span;
use crate::base::expr::{QKind, QRef};

/// Result of reading something.
pub(super) type Read<T> = Result<T, SyntaxError>;

/// The width of the blank that starts at a byte: 0 if none does.
pub(super) fn blank_width(bytes: &[u8], at: usize) -> usize {
    match bytes.get(at) {
        // Transfers fill up with NUL and begin and end with other marks; some editors end a file with Ctrl-Z.
        Some(b' ' | b'\t' | 0x0B | 0x0C | 0x00..=0x04 | 0x11..=0x14 | 0x1A) => 1,
        Some(0xC2) if bytes.get(at + 1) == Some(&0xA0) => 2,
        Some(0xEF) if bytes.get(at + 1..at + 3) == Some(&[0xBB, 0xBF]) => 3,
        _ => 0,
    }
}

/// The first byte from `at` on that is no blank, at most `end`.
pub(super) fn skip_blanks(bytes: &[u8], mut at: usize, end: usize) -> usize {
    while at < end {
        match blank_width(bytes, at) {
            0 => break,
            width => at += width,
        }
    }
    at.min(end)
}

/// `span` without blanks at its ends.
pub(super) fn trim(bytes: &[u8], span: Span) -> Span {
    let start = skip_blanks(bytes, span.start, span.end);
    let mut end = span.end;
    while end > start {
        let width = match bytes[end - 1] {
            b' ' | b'\t' | 0x0B | 0x0C | 0x00..=0x04 | 0x11..=0x14 | 0x1A => 1,
            0xA0 if end - start >= 2 && bytes[end - 2] == 0xC2 => 2,
            _ => break,
        };
        end -= width;
    }
    Span::new(start, end)
}

/// An ASCII word in capitals, cut after as many letters as the longest keyword has.
#[derive(Clone, Copy)]
pub(super) struct Word {
    letters: [u8; 16],
    len: usize,
    pub(super) span: Span,
}

impl Word {
    pub(super) fn as_bytes(&self) -> &[u8] {
        &self.letters[..self.len]
    }

    pub(super) fn is(&self, word: &[u8]) -> bool {
        self.as_bytes() == word
    }
}

/// Stands for the first letter of words that must not pass for a keyword.
const NO_KEYWORD: u8 = b'?';

fn foreign_letter(c: char) -> bool {
    !c.is_ascii() && c.is_alphabetic()
}

/// A place in the text of one block.
#[derive(Clone, Copy)]
pub(super) struct Cursor<'t> {
    pub(super) text: &'t str,
    pub(super) bytes: &'t [u8],
    pub(super) at: usize,
    pub(super) end: usize,
}

impl<'t> Cursor<'t> {
    pub(super) fn new(text: &'t str, span: Span) -> Self {
        Self { text, bytes: text.as_bytes(), at: span.start, end: span.end }
    }

    /// The byte here, 0 at the end. (A NUL of the text reads the same and fits no rule either.)
    #[inline]
    pub(super) fn byte(&self) -> u8 {
        self.byte_at(self.at)
    }

    #[inline]
    pub(super) fn byte_at(&self, at: usize) -> u8 {
        if at < self.end { self.bytes.get(at).copied().unwrap_or(0) } else { 0 }
    }

    /// Passes blanks and the joints of lines.
    #[inline]
    pub(super) fn blanks(&mut self) {
        // Most words follow directly or after one blank.
        self.at += usize::from(self.byte() == b' ');
        if !(self.byte().is_ascii_alphanumeric() || matches!(self.byte(), b'+' | b'-')) {
            self.more_blanks();
        }
    }

    fn more_blanks(&mut self) {
        loop {
            self.at = skip_blanks(self.bytes, self.at, self.end);
            match self.byte() {
                b'~' => match self.joint(self.at + 1) {
                    Some(next) => self.at = next,
                    None => return,
                },
                // Inside of a block's text a comment can only be one that a joint follows.
                b';' => self.at = self.line_end(self.at),
                b'\r' | b'\n' => self.at += 1,
                _ => return,
            }
        }
    }

    fn line_end(&self, from: usize) -> usize {
        let line = self.bytes.get(from..self.end).unwrap_or_default();
        line.iter().position(|b| matches!(b, b'\r' | b'\n')).map_or(self.end, |n| from + n)
    }

    /// The end of the line if only blanks or a comment follow.
    fn joint(&self, from: usize) -> Option<usize> {
        let at = skip_blanks(self.bytes, from, self.end);
        match self.byte_at(at) {
            b'\r' | b'\n' => Some(at),
            b';' => Some(self.line_end(at)),
            _ => None,
        }
    }

    /// Passes blanks; whether nothing is left.
    pub(super) fn done(&mut self) -> bool {
        self.blanks();
        self.at >= self.end
    }

    /// What was found here, for an error: a word, a number or a character.
    fn found(&self) -> Span {
        let start = self.at.min(self.end);
        let alike = |b: u8| b.is_ascii_alphanumeric() || b >= 0x80;
        let mut end = start;
        while end < self.end && alike(self.byte_at(end)) {
            end += 1;
        }
        if end == start && start < self.end {
            end = start + 1;
        }
        Span::new(start, end)
    }

    /// An error here: what was found is not what is expected.
    pub(super) fn expected(&self, expected: &'static str) -> SyntaxError {
        SyntaxError { code: "syntax-unexpected", span: self.found(), expected }
    }

    /// Fails unless nothing is left.
    pub(super) fn finish(&mut self) -> Read<()> {
        if self.done() { Ok(()) } else { Err(self.expected("end")) }
    }

    /// Whether a word goes on at a byte.
    fn is_letter_at(&self, at: usize) -> bool {
        let byte = self.byte_at(at);
        byte.is_ascii_alphabetic()
            || (byte >= 0x80 && self.text.get(at..self.end).is_some_and(|rest| rest.starts_with(foreign_letter)))
    }

    /// The word of ASCII letters here, without moving.
    pub(super) fn peek_word(&self) -> Word {
        let mut word = Word { letters: [0; 16], len: 0, span: Span::new(self.at, self.at) };
        let mut at = self.at;
        let rest = self.bytes.get(at..self.end).unwrap_or_default();
        for &byte in rest {
            if !byte.is_ascii_alphabetic() {
                break;
            }
            if word.len < word.letters.len() {
                word.letters[word.len] = byte.to_ascii_uppercase();
                word.len += 1;
            } else {
                word.letters[0] = NO_KEYWORD;
            }
            at += 1;
        }
        // A keyword does not go on with other letters: `CÍRCULO` is no circle.
        if word.len > 0
            && self.byte_at(at) >= 0x80
            && self.text.get(at..self.end).is_some_and(|rest| rest.starts_with(foreign_letter))
        {
            word.letters[0] = NO_KEYWORD;
        }
        word.span.end = at;
        word
    }

    /// The word here without the letters of a parameter after it: `F` of `FQL5`, `X` of `XQ1`.
    pub(super) fn peek_name(&self) -> Word {
        let mut word = self.peek_word();
        if !self.byte_at(word.span.end).is_ascii_digit() {
            return word;
        }
        let letters = match word.as_bytes() {
            [.., b'Q', b'L' | b'R' | b'S'] => 2,
            [.., b'Q'] => 1,
            _ => 0,
        };
        if letters < word.len {
            word.len -= letters;
            word.span.end -= letters;
        }
        word
    }

    /// Passes blanks and the keyword, if it is here as a whole word.
    pub(super) fn opt_keyword(&mut self, keyword: &[u8]) -> bool {
        self.blanks();
        // Most words that are asked for differ in their first letter.
        if !self.byte().eq_ignore_ascii_case(keyword.first().unwrap_or(&0)) {
            return false;
        }
        let end = self.at + keyword.len();
        let written = self.bytes.get(self.at..end.min(self.end)).unwrap_or_default();
        let hit = written.eq_ignore_ascii_case(keyword) && !self.is_letter_at(end);
        if hit {
            self.at = end;
        }
        hit
    }

    /// Passes blanks and the keyword or fails.
    pub(super) fn keyword(&mut self, keyword: &'static str) -> Read<()> {
        if self.opt_keyword(keyword.as_bytes()) { Ok(()) } else { Err(self.expected(keyword)) }
    }

    /// Passes blanks and the mark, if it is here.
    pub(super) fn opt_mark(&mut self, mark: u8) -> bool {
        self.blanks();
        let hit = self.byte() == mark && self.at < self.end;
        self.at += usize::from(hit);
        hit
    }

    /// A whole number without a sign, directly here.
    pub(super) fn opt_whole(&mut self) -> Option<u32> {
        let start = self.at;
        let mut value: u32 = 0;
        let mut at = start;
        while self.byte_at(at).is_ascii_digit() {
            value = value.checked_mul(10)?.checked_add(u32::from(self.byte_at(at) - b'0'))?;
            at += 1;
        }
        self.at = at;
        (at > start).then_some(value)
    }

    /// Whether a number without sign starts at a byte: digits, or a fraction without them.
    pub(super) fn number_at(&self, at: usize) -> bool {
        let byte = self.byte_at(at);
        byte.is_ascii_digit() || (matches!(byte, b'.' | b',') && self.byte_at(at + 1).is_ascii_digit())
    }

    /// Whether a signed number starts here, or a sign before a parameter.
    pub(super) fn starts_value(&self) -> bool {
        self.number_at(self.at) || matches!(self.byte(), b'+' | b'-')
    }

    /// A number without sign: `5`, `5.`, `.5`, `2,4`.
    pub(super) fn opt_number(&mut self) -> Option<f64> {
        if !self.number_at(self.at) {
            return None;
        }
        let start = self.at;
        let (mut mantissa, mut digits, mut places, mut point) = (0_u64, 0_usize, 0_usize, false);
        loop {
            match self.byte() {
                b @ b'0'..=b'9' => {
                    digits += usize::from(mantissa > 0 || b > b'0');
                    places += usize::from(point);
                    mantissa = mantissa.wrapping_mul(10).wrapping_add(u64::from(b - b'0'));
                }
                b'.' | b',' if !point => point = true,
                _ => break,
            }
            self.at += 1;
        }
        // Up to 15 digits both parts of the quotient are exact, so the quotient is rounded once.
        if digits <= 15 && places <= 22 {
            return Some(mantissa as f64 / POWERS[places]);
        }
        let text = self.text.get(start..self.at).unwrap_or_default().replace(',', ".");
        Some(text.parse().unwrap_or(f64::NAN)).filter(|value: &f64| value.is_finite())
    }

    /// A Q parameter directly here: `Q1`, `QL3`, `QS400`.
    pub(super) fn opt_q(&mut self) -> Option<QRef> {
        if !matches!(self.byte(), b'Q' | b'q') {
            return None;
        }
        let (kind, letters) = match self.byte_at(self.at + 1) {
            b'0'..=b'9' => (QKind::Q, 1),
            b'L' | b'l' => (QKind::Ql, 2),
            b'R' | b'r' => (QKind::Qr, 2),
            b'S' | b's' => (QKind::Qs, 2),
            _ => return None,
        };
        let mut ahead = Cursor { at: self.at + letters, ..*self };
        let number = u16::try_from(ahead.opt_whole()?).ok()?;
        self.at = ahead.at;
        Some(QRef { kind, number })
    }

    /// A signed number or parameter: `+5`, `-Q3`, `+ Q1`; two signs stand for their product, three for a mistake.
    pub(super) fn opt_operand(&mut self) -> Option<Operand> {
        let mut ahead = *self;
        ahead.blanks();
        let start = ahead.at;
        let (mut negative, mut signs) = (false, 0);
        while let sign @ (b'+' | b'-') = ahead.byte() {
            negative ^= sign == b'-';
            signs += 1;
            ahead.at += 1;
            ahead.blanks();
            if signs > 2 || ahead.at - start > 8 {
                return None;
            }
        }
        let amount = if let Some(value) = ahead.opt_number() {
            Amount::Number(if negative { -value } else { value })
        } else {
            Amount::Q { negative, q: ahead.opt_q()? }
        };
        self.at = ahead.at;
        Some(Operand { span: Span::new(start, ahead.at), amount })
    }

    /// A signed number or numeric parameter, or an error.
    pub(super) fn operand(&mut self) -> Read<Operand> {
        let before = *self;
        match self.opt_operand() {
            Some(Operand { amount: Amount::Q { q: QRef { kind: QKind::Qs, .. }, .. }, .. }) | None => {
                *self = before;
                self.blanks();
                Err(self.expected("value"))
            }
            Some(operand) => Ok(operand),
        }
    }

    /// A text in quotation marks; the span of what is between them.
    pub(super) fn opt_text(&mut self) -> Read<Option<Span>> {
        self.blanks();
        if self.byte() != b'"' {
            return Ok(None);
        }
        let start = self.at + 1;
        let inside = self.bytes.get(start..self.end).unwrap_or_default();
        match inside.iter().position(|b| matches!(b, b'"' | b'\n' | b'\r')) {
            Some(length) if inside.get(length) == Some(&b'"') => {
                self.at = start + length + 1;
                Ok(Some(Span::new(start, start + length)))
            }
            _ => Err(SyntaxError {
                code: "syntax-unclosed-text",
                span: Span::new(self.at, self.end),
                expected: "quotation-mark",
            }),
        }
    }

    /// The rest as written, without blanks at its ends.
    pub(super) fn rest(&mut self) -> Span {
        let span = trim(self.bytes, Span::new(self.at, self.end));
        self.at = self.end;
        span
    }
}

const POWERS: [f64; 23] = [
    1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20,
    1e21, 1e22,
];
