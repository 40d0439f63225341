//! A small tree of an XML file, read by `quick-xml`.
//!
//! Refused are document types and with them entities, encodings other than UTF-8, and depth without end.
use quick_xml::events::{BytesStart, Event};
use quick_xml::{Reader, XmlVersion};

/// Elements nested deeper than this are refused.
const DEEPEST: usize = 64;

/// A file that cannot be read, from this byte on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Unreadable {
    /// The byte.
    pub at: usize,
    /// A word for the reason: `form`, `document-type`, `entity`, `encoding`, `depth`, or another of who reads the file.
    pub what: &'static str,
}

/// An element, or with an empty name a stretch of text.
#[derive(Debug, Default)]
pub(crate) struct Node {
    /// The name without its prefix.
    pub(crate) name: String,
    pub(crate) words: String,
    attributes: Vec<(String, String)>,
    pub(crate) children: Vec<Node>,
    /// The byte at which it begins.
    pub(crate) at: usize,
}

impl Node {
    pub(crate) fn attribute(&self, name: &str) -> Option<&str> {
        self.attributes.iter().find(|(own, _)| own == name).map(|(_, value)| value.as_str())
    }

    pub(crate) fn child(&self, name: &str) -> Option<&Self> {
        self.children.iter().find(|child| child.name == name)
    }

    /// All text in it.
    pub(crate) fn text(&self) -> String {
        self.children
            .iter()
            .map(|child| if child.name.is_empty() { child.words.clone() } else { child.text() })
            .collect()
    }

    fn say(&mut self, words: &str, at: usize) {
        match self.children.last_mut() {
            Some(last) if last.name.is_empty() => last.words += words,
            _ => self.children.push(Self { words: words.to_owned(), at, ..Self::default() }),
        }
    }
}

/// The root element of a file.
pub(crate) fn parse(text: &str) -> Result<Node, Unreadable> {
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    let mut reader = Reader::from_str(text);
    let mut open: Vec<Node> = vec![Node::default()];
    loop {
        let at = usize::try_from(reader.buffer_position()).unwrap_or(usize::MAX).min(text.len());
        let refused = |what| Unreadable { at, what };
        let event = reader.read_event().map_err(|_| refused("form"))?;
        let Some(last) = open.last_mut() else { return Err(refused("form")) };
        match event {
            Event::Start(start) => {
                let node = element(&start, at)?;
                if open.len() > DEEPEST {
                    return Err(refused("depth"));
                }
                open.push(node);
            }
            Event::Empty(start) => last.children.push(element(&start, at)?),
            Event::End(_) => {
                let (Some(node), Some(parent)) = (open.pop(), open.last_mut()) else { return Err(refused("form")) };
                parent.children.push(node);
            }
            Event::Text(words) => last.say(&words, at),
            Event::CData(words) => last.say(&words, at),
            Event::GeneralRef(name) => {
                let entity = format!("&{};", &*name);
                last.say(&quick_xml::escape::unescape(&entity).map_err(|_| refused("entity"))?, at);
            }
            Event::DocType(_) => return Err(refused("document-type")),
            Event::Decl(declaration) => {
                if let Some(Ok(encoding)) = declaration.encoding()
                    && !encoding.eq_ignore_ascii_case("utf-8")
                {
                    return Err(refused("encoding"));
                }
            }
            Event::Comment(_) | Event::PI(_) => {}
            Event::Eof if open.len() == 1 => break,
            Event::Eof => return Err(refused("form")),
        }
    }
    let root = open.pop().and_then(|top| top.children.into_iter().find(|child| !child.name.is_empty()));
    root.ok_or(Unreadable { at: 0, what: "form" })
}

fn element(start: &BytesStart, at: usize) -> Result<Node, Unreadable> {
    let refused = |what| Unreadable { at, what };
    let mut attributes = Vec::new();
    for attribute in start.attributes() {
        let attribute = attribute.map_err(|_| refused("form"))?;
        let value = attribute.normalized_value(XmlVersion::Implicit1_0).map_err(|_| refused("entity"))?.into_owned();
        attributes.push((attribute.key.local_name().as_ref().to_owned(), value));
    }
    Ok(Node { name: start.local_name().as_ref().to_owned(), attributes, at, ..Node::default() })
}
