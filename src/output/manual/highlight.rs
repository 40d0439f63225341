//! NC blocks with their parts marked: block numbers, what a block is, Q parameters, texts, comments.
//!
//! Invariant: the characters of the program are not changed; a Q parameter leads to its row on the same page.
use super::escape::escape;
use crate::base::diag::{Source, Span};
use crate::program::syntax::{self, Block, BlockKind};

/// A program or a part of one as HTML; `has_row` says which Q parameters have a row on the page.
pub fn html(text: &str, has_row: &dyn Fn(&str) -> bool) -> String {
    let program = syntax::parse(&Source::new("example", text.to_owned()));
    let mut out = String::with_capacity(text.len() * 2);
    for block in program.blocks() {
        let head = head(block).filter(|head| head.start >= block.span.start && head.end <= block.span.end);
        let mut at = block.span.start;
        for line in program.slice(block.span).split_inclusive('\n') {
            let end = at + line.len();
            let own = head.filter(|head| head.start >= at && head.end <= end);
            let numbered = at == block.span.start && block.number.is_some();
            self::line(line, numbered, own.map(|head| (head.start - at, head.end - at)), has_row, &mut out);
            at = end;
        }
    }
    out
}

/// The words that say what a block is.
fn head(block: &Block) -> Option<Span> {
    match &block.kind {
        BlockKind::CycleDef(cycle) => Some(cycle.head),
        BlockKind::OldCycleLine(line) => Some(line.head),
        BlockKind::CyclCall(call) => Some(call.head),
        _ => None,
    }
}

/// A line, of which some bytes may be the head of its block.
fn line(line: &str, numbered: bool, head: Option<(usize, usize)>, has_row: &dyn Fn(&str) -> bool, out: &mut String) {
    let mut rest = line;
    if numbered {
        let indent = line.len() - line.trim_start().len();
        let digits = line[indent..].find(|c: char| !c.is_alphanumeric()).unwrap_or(line.len() - indent);
        escape(&line[..indent], out);
        span("b", &line[indent..indent + digits], out);
        rest = &line[indent + digits..];
    }
    if let Some((start, end)) = head {
        let before = line.len() - rest.len();
        if let (Some(space), Some(words), Some(after)) =
            (line.get(before..start), line.get(start..end), line.get(end..))
        {
            escape(space, out);
            span("k", words, out);
            rest = after;
        }
    }
    let comment = comment_of(rest);
    words(&rest[..comment], has_row, out);
    let comment = &rest[comment..];
    if !comment.is_empty() {
        let text = comment.trim_end_matches(['\r', '\n']);
        span("c", text, out);
        out.push_str(&comment[text.len()..]);
    }
}

/// Where the comment of a line begins: at the first semicolon that is not within a text.
fn comment_of(line: &str) -> usize {
    let mut quoted = false;
    for (at, c) in line.char_indices() {
        match c {
            '"' => quoted = !quoted,
            ';' if !quoted => return at,
            _ => {}
        }
    }
    line.len()
}

/// Words and values: Q parameters and texts are marked.
fn words(text: &str, has_row: &dyn Fn(&str) -> bool, out: &mut String) {
    let mut rest = text;
    while let Some(at) = rest.find(['Q', '"']) {
        let (before, found) = rest.split_at(at);
        escape(before, out);
        let length = match found.strip_prefix('"') {
            Some(inside) => inside.find('"').map_or(found.len(), |end| end + 2),
            None => found.find(|c: char| !c.is_ascii_alphanumeric()).unwrap_or(found.len()),
        };
        let (part, after) = found.split_at(length);
        let is_q = part.starts_with('Q') && part.ends_with(|c: char| c.is_ascii_digit());
        if part.starts_with('"') {
            span("t", part, out);
        } else if is_q && has_row(part) {
            out.push_str("<a class=\"q\" href=\"#");
            escape(part, out);
            out.push_str("\">");
            escape(part, out);
            out.push_str("</a>");
        } else if is_q {
            span("q", part, out);
        } else {
            escape(part, out);
        }
        rest = after;
    }
    escape(rest, out);
}

fn span(class: &str, text: &str, out: &mut String) {
    out.push_str("<span class=\"");
    out.push_str(class);
    out.push_str("\">");
    escape(text, out);
    out.push_str("</span>");
}
