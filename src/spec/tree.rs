//! Trees as bytes: the form in which the build script hands over what it has read from YAML.
//!
//! A value is its kind, where it is in the file (first byte and length) and what it holds; numbers take seven bits a
//! byte, the lowest first. Invariant: what is read is what was written, places included.
use super::yaml::{Key, Kind, Node};
use crate::base::diag::Span;

const PLAIN: u8 = 0;
const QUOTED: u8 = 1;
const LIST: u8 = 2;
const MAP: u8 = 3;

/// The keys of a cycle that only its pages and its conformance cases ask for.
const LATER: [&str; 3] = ["figures", "not_shown", "examples"];

/// A cycle without what few ask for, and that; the second is nothing for other trees.
#[allow(dead_code, reason = "the build script writes, the program reads")]
pub(crate) fn parted(tree: Node) -> (Node, Option<Node>) {
    let span = tree.span;
    match tree.kind {
        Kind::Map(entries) if entries.iter().any(|(key, _)| &*key.text == "cycle") => {
            let (later, now) = entries.into_iter().partition(|(key, _)| LATER.contains(&&*key.text));
            (Node { span, kind: Kind::Map(now) }, Some(Node { span, kind: Kind::Map(later) }))
        }
        kind => (Node { span, kind }, None),
    }
}

/// Appends a tree.
#[allow(dead_code, reason = "the build script writes, the program reads")]
pub(crate) fn write(node: &Node, out: &mut Vec<u8>) {
    let kind = match &node.kind {
        Kind::Scalar(_, true) => PLAIN,
        Kind::Scalar(_, false) => QUOTED,
        Kind::List(_) => LIST,
        Kind::Map(_) => MAP,
    };
    out.push(kind);
    write_span(node.span, out);
    match &node.kind {
        Kind::Scalar(text, _) => write_text(text, out),
        Kind::List(items) => {
            write_number(items.len(), out);
            items.iter().for_each(|item| write(item, out));
        }
        Kind::Map(entries) => {
            write_number(entries.len(), out);
            for (key, value) in entries {
                write_span(key.span, out);
                write_text(&key.text, out);
                write(value, out);
            }
        }
    }
}

fn write_span(span: Span, out: &mut Vec<u8>) {
    write_number(span.start, out);
    write_number(span.end - span.start, out);
}

fn write_text(text: &str, out: &mut Vec<u8>) {
    write_number(text.len(), out);
    out.extend_from_slice(text.as_bytes());
}

fn write_number(mut number: usize, out: &mut Vec<u8>) {
    while number > 0x7f {
        out.push(0x80 | (number & 0x7f) as u8);
        number >>= 7;
    }
    out.push(number as u8);
}

/// Reads a tree; nothing if the bytes are none.
#[allow(dead_code, reason = "the build script writes, the program reads")]
pub(crate) fn read(bytes: &[u8]) -> Option<Node> {
    Reader(bytes).node()
}

struct Reader<'b>(&'b [u8]);

impl<'b> Reader<'b> {
    fn node(&mut self) -> Option<Node> {
        let kind = self.byte()?;
        let span = self.span()?;
        let kind = match kind {
            PLAIN | QUOTED => Kind::Scalar(self.text()?.into(), kind == PLAIN),
            LIST => {
                let count = self.number()?;
                let mut items = Vec::with_capacity(count.min(self.0.len()));
                for _ in 0..count {
                    items.push(self.node()?);
                }
                Kind::List(items)
            }
            _ => {
                let count = self.number()?;
                let mut entries = Vec::with_capacity(count.min(self.0.len()));
                for _ in 0..count {
                    entries.push(self.entry()?);
                }
                Kind::Map(entries)
            }
        };
        Some(Node { span, kind })
    }

    fn entry(&mut self) -> Option<(Key, Node)> {
        let span = self.span()?;
        let text = self.text()?.into();
        Some((Key { text, span }, self.node()?))
    }

    fn span(&mut self) -> Option<Span> {
        let start = self.number()?;
        Some(Span::new(start, start + self.number()?))
    }

    fn text(&mut self) -> Option<&'b str> {
        let length = self.number()?;
        let (text, rest) = self.0.split_at_checked(length)?;
        self.0 = rest;
        std::str::from_utf8(text).ok()
    }

    fn number(&mut self) -> Option<usize> {
        let (mut number, mut shift) = (0, 0);
        loop {
            let byte = self.byte()?;
            number |= usize::from(byte & 0x7f) << shift;
            if byte < 0x80 {
                return Some(number);
            }
            shift += 7;
        }
    }

    fn byte(&mut self) -> Option<u8> {
        let (first, rest) = self.0.split_first()?;
        self.0 = rest;
        Some(*first)
    }
}
