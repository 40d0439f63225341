//! Segments of pages of prose: what is between the marks of blocks, with the marks inside of it as codes.
//!
//! Invariant: the span of a segment is a stretch of its file; outside of the spans is nothing that is translated.
use std::ops::Range;

use pulldown_cmark::{Event, Options, Parser, Tag, TagEnd};

use super::fluent::{Piece, merged};

/// A stretch of words: a paragraph, a heading, a cell, an item or a block of code.
#[derive(Clone, Debug)]
pub struct Segment {
    /// What it is: `p`, `h1` …, `cell`, `item`, `code`.
    pub kind: String,
    /// Its bytes in the file.
    pub span: Range<usize>,
    /// Its words and marks.
    pub pieces: Vec<Piece>,
}

/// What a block of code is called.
pub const CODE: &str = "code";

/// Signs that are marks in some places, and are words after a backslash.
const MARKS: [char; 10] = ['\\', '`', '*', '_', '[', ']', '<', '|', '#', '~'];

/// The segments of a page.
pub fn segments(page: &str) -> Vec<Segment> {
    let mut reader = Reader { page, all: Vec::new(), open: None, blocks: Vec::new() };
    for (event, range) in Parser::new_ext(page, Options::ENABLE_TABLES).into_offset_iter() {
        reader.take(&event, range);
    }
    reader.close();
    reader.all
}

/// The pieces of the words of one segment that stand alone.
pub fn inline(words: &str) -> Vec<Piece> {
    let line = format!("# {}", words.replace('\n', " "));
    let segment = segments(&line).into_iter().next();
    segment.map_or_else(Vec::new, |segment| segment.pieces)
}

/// The words of a segment in a file.
pub fn written(pieces: &[Piece], escaped: bool) -> String {
    let mut text = String::new();
    for piece in pieces {
        match piece {
            Piece::Code(code) => text += code,
            Piece::Text(words) if !escaped => text += words,
            Piece::Text(words) => {
                for sign in words.chars() {
                    if MARKS.contains(&sign) {
                        text.push('\\');
                    }
                    text.push(sign);
                }
            }
        }
    }
    text
}

struct Reader<'p> {
    page: &'p str,
    all: Vec<Segment>,
    open: Option<Open>,
    /// The blocks in which the reader is.
    blocks: Vec<String>,
}

struct Open {
    start: usize,
    /// Up to here the segment is read.
    at: usize,
    pieces: Vec<Piece>,
    /// A line has just ended: what begins the next one is no part of the words.
    broken: bool,
}

impl Reader<'_> {
    fn take(&mut self, event: &Event, range: Range<usize>) {
        let is_code = self.blocks.last().is_some_and(|block| block == CODE);
        match event {
            Event::Start(tag) if is_inline(tag) => {
                self.begin(range.start);
                self.mark(range.start);
            }
            Event::Start(tag) => {
                self.close();
                self.blocks.push(block(tag));
            }
            Event::End(TagEnd::Emphasis | TagEnd::Strong | TagEnd::Link | TagEnd::Image | TagEnd::Strikethrough) => {
                self.mark(range.end);
            }
            Event::End(_) => {
                self.close();
                self.blocks.pop();
            }
            Event::Text(_) if is_code => {
                self.begin(range.start);
                let words = self.page.get(range.clone()).unwrap_or_default().to_owned();
                self.say(Piece::Text(words), range.end);
            }
            Event::Text(_) => {
                self.begin(range.start);
                self.mark(range.start);
                let words = self.page.get(range.clone()).unwrap_or_default().to_owned();
                self.say(Piece::Text(words), range.end);
            }
            Event::SoftBreak => {
                self.mark(range.start);
                self.say(Piece::Text(" ".to_owned()), range.end);
                if let Some(open) = &mut self.open {
                    open.broken = true;
                }
            }
            Event::Code(_) | Event::InlineHtml(_) | Event::HardBreak => {
                self.begin(range.start);
                self.mark(range.start);
                self.mark(range.end);
            }
            _ => self.close(),
        }
    }

    fn begin(&mut self, at: usize) {
        self.open.get_or_insert_with(|| Open { start: at, at, pieces: Vec::new(), broken: false });
    }

    fn say(&mut self, piece: Piece, end: usize) {
        if let Some(open) = &mut self.open {
            open.pieces.push(piece);
            open.at = end.max(open.at);
            open.broken = false;
        }
    }

    /// What is between the words and this byte is a mark.
    fn mark(&mut self, to: usize) {
        let Some(open) = &mut self.open else { return };
        let between = self.page.get(open.at..to).unwrap_or_default().to_owned();
        let broken = std::mem::take(&mut open.broken);
        if between.is_empty() || broken && between.trim_matches([' ', '\t', '>']).is_empty() {
            open.at = to.max(open.at);
            return;
        }
        // A backslash makes a word of the sign after it.
        let piece = if between == "\\" { Piece::Text(between) } else { Piece::Code(between) };
        self.say(piece, to);
    }

    fn close(&mut self) {
        let Some(open) = self.open.take() else { return };
        let kind = self.blocks.last().cloned().unwrap_or_default();
        let pieces = merged(open.pieces);
        let end = open.at - self.page.get(open.start..open.at).map_or(0, |text| text.len() - text.trim_end().len());
        let has_words = |piece: &Piece| match piece {
            Piece::Text(words) | Piece::Code(words) => words.chars().any(char::is_alphanumeric),
        };
        if pieces.iter().any(has_words) {
            self.all.push(Segment { kind, span: open.start..end, pieces: trimmed(pieces) });
        }
    }
}

/// Pieces without blanks at both ends.
pub(super) fn trimmed(mut pieces: Vec<Piece>) -> Vec<Piece> {
    if let Some(Piece::Text(words)) = pieces.first_mut() {
        *words = words.trim_start().to_owned();
    }
    if let Some(Piece::Text(words)) = pieces.last_mut() {
        *words = words.trim_end().to_owned();
    }
    merged(pieces)
}

fn is_inline(tag: &Tag) -> bool {
    matches!(tag, Tag::Emphasis | Tag::Strong | Tag::Strikethrough | Tag::Link { .. } | Tag::Image { .. })
}

fn block(tag: &Tag) -> String {
    match tag {
        Tag::Heading { level, .. } => format!("h{}", *level as usize),
        Tag::TableCell => "cell".to_owned(),
        Tag::Item => "item".to_owned(),
        Tag::CodeBlock(_) => CODE.to_owned(),
        _ => "p".to_owned(),
    }
}
