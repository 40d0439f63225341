//! YAML as a tree in which every key and value knows its place.
//!
//! Invariant: knows the YAML language and nothing of cycles. Anchors, aliases and tags are refused,
//! because a specification must read the same from every place.
use std::collections::HashMap;
use std::sync::Arc;

use saphyr_parser::{Event, Parser, ScalarStyle};

use crate::base::diag::{Diagnostic, Place, Source, Span};

/// Deeper nesting than this is refused.
const MAX_DEPTH: usize = 64;

/// A value with its place.
#[derive(Clone, Debug)]
pub struct Node {
    /// Its place.
    pub span: Span,
    /// What it is.
    pub kind: Kind,
}

/// The kinds of values.
#[derive(Clone, Debug)]
pub enum Kind {
    /// A scalar and whether it was written without quotation marks.
    Scalar(Arc<str>, bool),
    /// A list.
    List(Vec<Node>),
    /// A mapping in the order of the file.
    Map(Vec<(Key, Node)>),
}

/// A key of a mapping.
#[derive(Clone, Debug)]
pub struct Key {
    /// Its text.
    pub text: Arc<str>,
    /// Its place.
    pub span: Span,
}

impl Node {
    /// The value of a key, if this is a mapping that has it.
    pub fn get(&self, key: &str) -> Option<&Node> {
        match &self.kind {
            Kind::Map(entries) => entries.iter().find(|(k, _)| &*k.text == key).map(|(_, node)| node),
            _ => None,
        }
    }

    /// The text, if this is a scalar.
    pub fn text(&self) -> Option<&str> {
        match &self.kind {
            Kind::Scalar(text, _) => Some(text),
            _ => None,
        }
    }

    /// The items, if this is a list; a mapping or scalar has none.
    pub fn items(&self) -> &[Node] {
        match &self.kind {
            Kind::List(items) => items,
            _ => &[],
        }
    }

    /// What messages show of it: its text, or the beginning of a list or mapping as the file has it.
    pub fn shown(&self, source: &Source) -> String {
        if let Some(text) = self.text() {
            return text.to_owned();
        }
        let written = source.text().get(self.span.start..self.span.end).unwrap_or_default().trim();
        let line = written.lines().next().unwrap_or_default();
        let short: String = line.chars().take(SHOWN).collect();
        if short.len() < written.len() { format!("{short} …") } else { short }
    }
}

/// So many characters of a list or mapping are shown.
const SHOWN: usize = 40;

/// Characters to bytes: the parser counts characters, sources count bytes.
struct Bytes(Option<Vec<usize>>);

impl Bytes {
    fn new(text: &str) -> Self {
        if text.is_ascii() {
            return Self(None);
        }
        let mut starts: Vec<usize> = text.char_indices().map(|(at, _)| at).collect();
        starts.push(text.len());
        Self(Some(starts))
    }

    fn span(&self, span: saphyr_parser::Span) -> Span {
        let at = |index: usize| match &self.0 {
            None => index,
            Some(starts) => starts.get(index).or(starts.last()).copied().unwrap_or(index),
        };
        Span::new(at(span.start.index()), at(span.end.index()))
    }
}

enum Open {
    List(Span, Vec<Node>),
    Map(Span, Vec<(Key, Node)>, Option<Key>, Places),
}

/// Where each key of a mapping is: they are not compared with each other.
type Places = HashMap<Arc<str>, Span>;

/// Reads one document. Mistakes go to `found`; nothing comes back if there is no tree.
pub fn read(source: &Arc<Source>, found: &mut Vec<Diagnostic>) -> Option<Node> {
    let bytes = Bytes::new(source.text());
    let mut open: Vec<Open> = Vec::new();
    let mut root = None;
    let refuse = |span: Span, what: &'static str| {
        Diagnostic::error("spec-yaml-feature", Place::new(source, span)).arg("feature", what)
    };
    for event in Parser::new_from_str(source.text()) {
        let (event, span) = match event {
            Ok((event, span)) => (event, bytes.span(span)),
            Err(error) => {
                let at = bytes.span(saphyr_parser::Span::empty(*error.marker()));
                let after = source.text().get(at.start..).and_then(|rest| rest.chars().next());
                let end = at.start + after.map_or(0, char::len_utf8);
                found.push(
                    Diagnostic::error("spec-yaml-syntax", Place::new(source, at.start..end))
                        .arg("reason", error.info()),
                );
                return None;
            }
        };
        let node = match event {
            Event::Scalar(text, style, anchor, tag) => {
                if anchor != 0 || tag.is_some() {
                    found.push(refuse(span, "anchor"));
                }
                Node { span, kind: Kind::Scalar(text.as_ref().into(), style == ScalarStyle::Plain) }
            }
            Event::SequenceStart(..) | Event::MappingStart(..) if open.len() >= MAX_DEPTH => {
                found.push(refuse(span, "depth"));
                return None;
            }
            Event::SequenceStart(anchor, tag) => {
                if anchor != 0 || tag.is_some() {
                    found.push(refuse(span, "anchor"));
                }
                open.push(Open::List(span, Vec::new()));
                continue;
            }
            Event::MappingStart(anchor, tag) => {
                if anchor != 0 || tag.is_some() {
                    found.push(refuse(span, "anchor"));
                }
                open.push(Open::Map(span, Vec::new(), None, Places::new()));
                continue;
            }
            Event::SequenceEnd | Event::MappingEnd => match open.pop() {
                Some(Open::List(start, items)) => close(start, span, Kind::List(items)),
                Some(Open::Map(start, entries, ..)) => close(start, span, Kind::Map(entries)),
                None => continue,
            },
            Event::Alias(_) => {
                found.push(refuse(span, "alias"));
                Node { span, kind: Kind::Scalar("".into(), true) }
            }
            _ => continue,
        };
        match open.last_mut() {
            None if root.is_some() => found.push(refuse(node.span, "second-document")),
            None => root = Some(node),
            Some(Open::List(_, items)) => items.push(node),
            Some(Open::Map(_, _, key @ None, places)) => {
                let Kind::Scalar(text, _) = &node.kind else {
                    found.push(refuse(node.span, "structured-key"));
                    return None;
                };
                let first = places.get(text);
                if let Some(first) = first {
                    found.push(
                        Diagnostic::error("spec-duplicate-key", Place::new(source, node.span))
                            .arg("key", &**text)
                            .related("first-place", Place::new(source, *first)),
                    );
                }
                if first.is_none() {
                    places.insert(Arc::clone(text), node.span);
                }
                *key = Some(Key { text: Arc::clone(text), span: node.span });
            }
            Some(Open::Map(_, entries, key, _)) => {
                if let Some(key) = key.take() {
                    entries.push((key, node));
                }
            }
        }
    }
    if root.is_none() {
        found.push(refuse(Span::new(0, 0), "no-document"));
    }
    root
}

fn close(start: Span, end: Span, kind: Kind) -> Node {
    // A block collection's end is reported where the next token starts: its last child ends it.
    let last = match &kind {
        Kind::List(items) => items.last().map(|node| node.span.end),
        Kind::Map(entries) => entries.last().map(|(_, node)| node.span.end),
        Kind::Scalar(..) => None,
    };
    let end = if end.end > end.start { end.end } else { last.unwrap_or(end.end) };
    Node { span: Span::new(start.start, end.max(start.start)), kind }
}
