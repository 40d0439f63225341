//! Gettext PO: the identifier of a unit is its context, placeables are in the text as Fluent has them.
use std::fmt::Write as _;

use super::fluent::Piece;
use super::markdown::{self, CODE};
use super::prose::TOPICS;
use super::received::{Received, Returned, Unreadable, code_length};
use super::unit::Unit;

/// The units of a language as a file.
pub(super) fn write(units: &[Unit], tag: &str) -> String {
    let mut text = format!(
        "msgid \"\"\nmsgstr \"\"\n\"Language: {tag}\\n\"\n\"MIME-Version: 1.0\\n\"\n\"Content-Type: text/plain; charset=UTF-8\\n\"\n\"Content-Transfer-Encoding: 8bit\\n\"\n"
    );
    for unit in units {
        text.push('\n');
        for note in &unit.notes {
            let _ = writeln!(text, "#. {}", note.replace('\n', " "));
        }
        let _ = writeln!(text, "#: {}", unit.file);
        let fuzzy = (unit.state.is_some() && !unit.target.is_empty()).then(|| "fuzzy".to_owned());
        let flags: Vec<String> = fuzzy.into_iter().chain(unit.most.map(|most| format!("max-length:{most}"))).collect();
        if !flags.is_empty() {
            let _ = writeln!(text, "#, {}", flags.join(", "));
        }
        let _ = writeln!(text, "msgctxt {}", quoted(&unit.id));
        let _ = writeln!(text, "msgid {}", quoted(&joined(&unit.source)));
        let _ = writeln!(text, "msgstr {}", quoted(&joined(&unit.target)));
    }
    text
}

/// Words and codes in one; braces in words are doubled.
fn joined(pieces: &[Piece]) -> String {
    let part = |piece: &Piece| match piece {
        Piece::Text(words) => words.clone(),
        Piece::Code(code) => code.clone(),
    };
    pieces.iter().map(part).collect()
}

fn quoted(text: &str) -> String {
    let escaped =
        |line: &str| line.replace('\\', "\\\\").replace('"', "\\\"").replace('\n', "\\n").replace('\t', "\\t");
    if !text.contains('\n') {
        return format!("\"{}\"", escaped(text));
    }
    let lines = text.split_inclusive('\n').map(|line| format!("\n\"{}\"", escaped(line)));
    format!("\"\"{}", lines.collect::<String>())
}

/// An entry as it is read.
#[derive(Default)]
struct Entry {
    at: Option<usize>,
    fuzzy: bool,
    context: Option<String>,
    id: Option<String>,
    text: Option<String>,
}

impl Entry {
    fn field(&mut self, word: &str) -> Option<&mut String> {
        match word {
            "msgctxt" => Some(self.context.get_or_insert_default()),
            "msgid" => Some(self.id.get_or_insert_default()),
            "msgstr" => Some(self.text.get_or_insert_default()),
            _ => None,
        }
    }

    fn received(self) -> Option<Received> {
        let id = self.context?;
        let text = self.text.unwrap_or_default();
        let pieces = |text: &str| match id.strip_prefix(TOPICS) {
            // Pages are Markdown; a block of code has no marks.
            Some(page) if page.contains(&format!("#{CODE}-")) => Some(vec![Piece::Text(text.to_owned())]),
            Some(_) => Some(markdown::inline(text)),
            None => split(text),
        };
        let (source, target) = (pieces(&self.id.unwrap_or_default()), pieces(&text));
        Some(Received {
            id,
            at: self.at.unwrap_or_default(),
            is_final: !self.fuzzy && !text.is_empty(),
            source,
            target,
        })
    }
}

/// The units of a file.
pub(super) fn read(text: &str) -> Result<Returned, Unreadable> {
    let field =
        |line: &'_ str| line.strip_prefix("msgstr ").unwrap_or(line).strip_prefix("\"Language: ").map(str::to_owned);
    let header = text.lines().find_map(field);
    let language =
        header.as_deref().and_then(|rest| rest.split(['\\', '"']).next()).map(|tag| tag.trim().replace('_', "-"));
    let mut units = Vec::new();
    let mut entry = Entry::default();
    let mut field = "";
    let mut at = 0;
    for line in text.split_inclusive('\n') {
        let (here, content) = (at, line.trim());
        at += line.len();
        let refused = Unreadable { at: here, what: "form" };
        if content.is_empty() || content.starts_with("#~") {
            continue;
        }
        if content.starts_with('#')
            || content.starts_with("msgctxt")
            || content.starts_with("msgid") && entry.text.is_some()
        {
            if entry.text.is_some() {
                units.extend(std::mem::take(&mut entry).received());
            }
            if content.starts_with('#') {
                entry.fuzzy |= content.starts_with("#,") && content.contains("fuzzy");
                continue;
            }
        }
        let (word, value) = match content.split_once(' ') {
            _ if content.starts_with('"') => (field, content),
            Some((word @ ("msgctxt" | "msgid" | "msgstr"), value)) => (word, value.trim()),
            _ => return Err(refused),
        };
        entry.at.get_or_insert(here);
        let Some(value) = unquoted(value) else { return Err(refused) };
        let Some(own) = entry.field(word) else { return Err(refused) };
        own.push_str(&value);
        field = match word {
            "msgctxt" => "msgctxt",
            "msgid" => "msgid",
            _ => "msgstr",
        };
    }
    units.extend(entry.received());
    Ok(Returned { language, units })
}

fn unquoted(text: &str) -> Option<String> {
    let inside = text.strip_prefix('"')?.strip_suffix('"')?;
    let mut out = String::new();
    let mut chars = inside.chars();
    while let Some(c) = chars.next() {
        match c {
            '\\' => out.push(match chars.next()? {
                'n' => '\n',
                't' => '\t',
                'r' => '\r',
                other @ ('"' | '\\') => other,
                _ => return None,
            }),
            '"' => return None,
            c => out.push(c),
        }
    }
    Some(out)
}

/// Words and codes of a text; nothing if braces do not match.
fn split(text: &str) -> Option<Vec<Piece>> {
    let mut pieces = Vec::new();
    let mut rest = text;
    while let Some(open) = rest.find(['{', '}']) {
        let (words, code) = rest.split_at(open);
        let length = code_length(code)?;
        if !words.is_empty() {
            pieces.push(Piece::Text(words.to_owned()));
        }
        let (code, after) = code.split_at(length);
        pieces.push(Piece::Code(code.to_owned()));
        rest = after;
    }
    if !rest.is_empty() {
        pieces.push(Piece::Text(rest.to_owned()));
    }
    Some(pieces)
}
