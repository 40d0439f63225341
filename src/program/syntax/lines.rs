//! Physical lines and their outer parts: skip mark, block number, content, comment, joint.
//!
//! Invariant: a line belongs to no block yet; of its content only the place is known.
use memchr::memchr2;

use super::cursor::{skip_blanks, trim};
use super::terms::SyntaxError;
use crate::base::diag::Span;

/// A block that is longer, in bytes, is not read: controls take a small part of that, and its words need much more
/// room than its text.
pub(super) const LONGEST_BLOCK: usize = 1 << 20;

/// A physical line.
#[derive(Clone, Copy, Debug)]
pub(super) struct Line {
    /// Its first byte.
    pub(super) start: usize,
    /// The first byte of the next line.
    pub(super) next: usize,
    pub(super) skip: bool,
    pub(super) number: Option<u32>,
    /// What is between number and comment, trimmed, without a `~` at its end.
    pub(super) content: Span,
    /// From `;` on, trimmed, without a `~` at its end.
    pub(super) comment: Option<Span>,
    /// Whether a `~` joins the next line.
    pub(super) joined: bool,
    /// Whether it is after a comment: the next line may be text of the comment.
    pub(super) wraps: bool,
    /// Whether another `~` is before the one that joins, with nothing but blanks between them.
    pub(super) twice: bool,
}

impl Line {
    /// Whether it holds nothing but blanks.
    pub(super) fn is_blank(&self) -> bool {
        let empty = self.content.start == self.content.end && self.comment.is_none();
        empty && self.number.is_none() && !self.skip && !self.joined
    }

    /// Whether it holds a comment only.
    pub(super) fn is_comment(&self) -> bool {
        self.content.start == self.content.end && self.comment.is_some()
    }
}

/// The line that starts at a byte; nothing at the end of the text.
pub(super) fn line_at(bytes: &[u8], start: usize) -> Option<Line> {
    let rest = bytes.get(start..).filter(|rest| !rest.is_empty())?;
    let length = memchr2(b'\n', b'\r', rest).unwrap_or(rest.len());
    let eol = match (rest.get(length), rest.get(length + 1)) {
        (Some(b'\r'), Some(b'\n')) => 2,
        (Some(_), _) => 1,
        (None, _) => 0,
    };
    let end = start + length;
    let mut line = Line {
        start,
        next: end + eol,
        skip: false,
        number: None,
        content: Span::new(end, end),
        comment: None,
        joined: false,
        wraps: false,
        twice: false,
    };
    let at = head(bytes, end, &mut line);
    parts(bytes, Span::new(at, end), &mut line);
    Some(line)
}

/// What a block says, without number and comment.
pub(super) fn content_of(bytes: &[u8], block: Span) -> Span {
    let Some(first) = line_at(bytes, block.start) else { return Span::new(block.start, block.start) };
    let mut last = first;
    while last.next < block.end
        && let Some(line) = line_at(bytes, last.next)
    {
        last = line;
    }
    Span::new(first.content.start, last.content.end.max(first.content.start))
}

/// Reads skip mark and number; the start of the content.
fn head(bytes: &[u8], end: usize, line: &mut Line) -> usize {
    let mut at = skip_blanks(bytes, line.start, end);
    at = skip_mark(bytes, at, end, line);
    if let Some((number, after)) = block_number(bytes, at, end, line.skip) {
        line.number = Some(number);
        at = skip_mark(bytes, skip_blanks(bytes, after, end), end, line);
    }
    at
}

fn skip_mark(bytes: &[u8], at: usize, end: usize, line: &mut Line) -> usize {
    if at < end && bytes[at] == b'/' && !line.skip {
        line.skip = true;
        return skip_blanks(bytes, at + 1, end);
    }
    at
}

/// Digits are a block number if a blank or the start of a block follows them, and not if they are all there is, with or
/// without a joint. Some programs from elsewhere write `N` before them.
/// After a skip mark the block may follow directly.
fn block_number(bytes: &[u8], at: usize, end: usize, skipped: bool) -> Option<(u32, usize)> {
    let marked = matches!(bytes.get(at), Some(b'N' | b'n'));
    let at = at + usize::from(marked && at + 1 < end);
    let mut value: u32 = 0;
    let mut after = at;
    while after < end && bytes[after].is_ascii_digit() {
        value = value.checked_mul(10)?.checked_add(u32::from(bytes[after] - b'0'))?;
        after += 1;
    }
    let content = skip_blanks(bytes, after, end);
    let follows = |b: &u8| matches!(b, b';' | b'*' | b'/') || (skipped && b.is_ascii_alphabetic());
    let apart = content > after || bytes.get(after).is_some_and(follows);
    let alone = content >= end || (bytes[content] == b'~' && skip_blanks(bytes, content + 1, end) >= end);
    if after == at || !apart || alone {
        return None;
    }
    Some((value, after))
}

/// Divides what follows the number into content, comment and joint.
fn parts(bytes: &[u8], span: Span, line: &mut Line) {
    let structure = bytes.get(span.start) == Some(&b'*');
    let comment = if structure { None } else { comment_start(bytes, span) };
    let content = trim(bytes, Span::new(span.start, comment.unwrap_or(span.end)));
    let (content, joint_before) = without_joint(bytes, content, structure);
    let comment = comment.map(|start| trim(bytes, Span::new(start, span.end)));
    let (comment, joint_behind) = match comment {
        Some(comment) => {
            let (comment, joined) = without_joint(bytes, comment, false);
            (Some(comment), joined)
        }
        None => (None, false),
    };
    line.content = content;
    line.comment = comment;
    line.joined = joint_before || joint_behind;
    line.twice = (joint_before && ends_once(bytes, content))
        || (joint_behind && comment.is_some_and(|own| ends_once(bytes, own)));
    line.wraps = joint_behind;
}

fn without_joint(bytes: &[u8], span: Span, never: bool) -> (Span, bool) {
    if never || span.end == span.start || bytes.get(span.end - 1) != Some(&b'~') {
        return (span, false);
    }
    (trim(bytes, Span::new(span.start, span.end - 1)), true)
}

/// Whether one `~` is at the end; more are an ornament.
fn ends_once(bytes: &[u8], span: Span) -> bool {
    let (before, once) = without_joint(bytes, span, false);
    once && !without_joint(bytes, before, false).1
}

/// The first `;` outside of quotation marks.
fn comment_start(bytes: &[u8], span: Span) -> Option<usize> {
    let line = bytes.get(span.start..span.end)?;
    let (mut quoted, mut from) = (false, 0);
    while let Some(at) = line.get(from..).and_then(|rest| memchr2(b'"', b';', rest)).map(|at| from + at) {
        if line.get(at) == Some(&b'"') {
            quoted = !quoted;
        } else if !quoted {
            return Some(span.start + at);
        }
        from = at + 1;
    }
    None
}

/// What is wrong with a block that is longer than any may be: the word with which it becomes so.
pub(super) fn too_long(text: &str, content: Span) -> SyntaxError {
    let is_gap = |at: usize| text.as_bytes().get(at).is_none_or(|byte| matches!(byte, b' ' | b'\t'));
    let last = content.start + LONGEST_BLOCK;
    let first = (content.start..last).rev().find(|at| is_gap(*at)).map_or(content.start, |at| at + 1);
    let end = (first + 1..content.end.min(first + LONGEST_BLOCK)).find(|at| is_gap(*at)).unwrap_or(content.end);
    SyntaxError { code: "syntax-unexpected", span: Span::new(first, end), expected: "end" }
}
