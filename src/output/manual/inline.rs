//! Prose of the locales as HTML: bold, code and links within a line.
//!
//! Invariant: whatever the text is, what comes out is well-formed inline HTML and shows every
//! character of it; a link leads to a page that exists or is plain text.
use pulldown_cmark::{Event, Parser, Tag, TagEnd};

use super::edition::link_target;
use super::escape::escape;
use super::links::Linker;

/// Stands before the text while it is parsed, so that no line is taken for a list or a heading.
const GUARD: char = '\u{2060}';

/// The text as inline HTML.
pub(super) fn html(text: &str, linker: &Linker) -> String {
    let mut out = String::with_capacity(text.len() + 16);
    if !text.bytes().any(|byte| matches!(byte, b'*' | b'_' | b'`' | b'[' | b'\\')) {
        linker.text(text, &mut out);
        return out;
    }
    // A backslash is a character of paths here, and no escape as in Markdown.
    let guarded = format!("{GUARD}{}", text.replace('\\', "\\\\"));
    let mut open: Vec<bool> = Vec::new();
    for event in Parser::new(&guarded) {
        match event {
            Event::Text(text) | Event::Html(text) | Event::InlineHtml(text) => {
                let text = text.trim_start_matches(GUARD);
                if open.is_empty() { linker.text(text, &mut out) } else { escape(text, &mut out) }
            }
            Event::Code(code) => element("code", &code.replace("\\\\", "\\"), &mut out),
            Event::SoftBreak | Event::HardBreak => out.push(' '),
            Event::Start(Tag::Strong) => out.push_str("<strong>"),
            Event::End(TagEnd::Strong) => out.push_str("</strong>"),
            Event::Start(Tag::Emphasis) => out.push_str("<em>"),
            Event::End(TagEnd::Emphasis) => out.push_str("</em>"),
            Event::Start(Tag::Link { dest_url, .. }) => {
                let entry = link_target(&dest_url).and_then(|key| linker.edition.entry(key));
                if let Some(entry) = entry {
                    out.push_str(&format!("<a href=\"{}\">", entry.file));
                }
                open.push(entry.is_some());
            }
            Event::End(TagEnd::Link) if open.pop() == Some(true) => out.push_str("</a>"),
            _ => {}
        }
    }
    out
}

fn element(name: &str, text: &str, out: &mut String) {
    out.push('<');
    out.push_str(name);
    out.push('>');
    escape(text, out);
    out.push_str("</");
    out.push_str(name);
    out.push('>');
}
