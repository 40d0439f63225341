//! The text of a table: lines, headings and the characters of cells.
//!
//! Invariant: columns count characters, and a column reaches from the start of its heading to the start of
//! the next one; the last reaches to the end of the line.
use super::{Quantity, Table, TableKind, TableUnit};
use crate::base::diag::{Arg, Diagnostic, Place, Source};
use std::collections::HashSet;
use std::sync::Arc;

/// A line and what ends it.
#[derive(Clone, Debug)]
pub(super) struct Line {
    pub(super) text: String,
    pub(super) end: String,
}

impl Line {
    pub(super) fn new(text: String) -> Self {
        Self { text, end: "\n".to_owned() }
    }
}

/// A column of a file.
#[derive(Clone, Debug)]
pub(super) struct Heading {
    pub(super) name: String,
    /// First character.
    pub(super) start: usize,
    /// Width in characters; nothing for the last column.
    pub(super) width: Option<usize>,
    pub(super) quantity: Quantity,
}

/// The room of a last column, whose end no heading marks.
const LAST_ROOM: usize = 80;
/// Decimals that are written at most.
const DECIMALS: usize = 9;

impl Heading {
    /// The characters of the cell, blanks included.
    pub(super) fn cell<'l>(&self, line: &'l str) -> &'l str {
        let (from, to) = self.bytes(line);
        line.get(from..to).unwrap_or_default()
    }

    /// The bytes of the cell in its line.
    pub(super) fn bytes(&self, line: &str) -> (usize, usize) {
        let byte = |char: usize| line.char_indices().nth(char).map_or(line.len(), |(at, _)| at);
        (byte(self.start), self.width.map_or(line.len(), |width| byte(self.start + width)))
    }

    /// Characters that a value may have; a blank separates it from the next column.
    pub(super) fn room(&self) -> usize {
        self.width.map_or(LAST_ROOM, |width| width.saturating_sub(1))
    }

    /// Replaces the cell and nothing else. Blanks at the end of the line stay away if they were away.
    pub(super) fn put(&self, line: &mut String, text: &str) {
        let mut chars: Vec<char> = line.chars().collect();
        let short = chars.len() < self.start + self.width.unwrap_or(0);
        let width = self.width.unwrap_or_else(|| chars.len().saturating_sub(self.start)).max(text.chars().count());
        if chars.len() < self.start + width {
            chars.resize(self.start + width, ' ');
        }
        let cell = text.chars().chain(std::iter::repeat(' '));
        for (slot, new) in chars.iter_mut().skip(self.start).take(width).zip(cell) {
            *slot = new;
        }
        *line = chars.into_iter().collect();
        if short || self.width.is_none() {
            line.truncate(line.trim_end_matches(' ').len());
        }
    }
}

/// The standard columns of a kind, and the line that heads them.
pub(super) fn standard(kind: TableKind) -> (Vec<Heading>, String) {
    with_columns(kind, &[])
}

/// The standard columns of a kind and others after them, each so wide, and the line that heads them.
pub(super) fn with_columns(kind: TableKind, others: &[(String, usize)]) -> (Vec<Heading>, String) {
    let (mut headings, mut line, mut start) = (Vec::new(), String::new(), 0);
    let own = kind.columns().iter().map(|column| (column.name, column.width, column.quantity));
    let others = others.iter().map(|(name, width)| (name.as_str(), *width, Quantity::Text));
    for (name, width, quantity) in own.chain(others) {
        line.push_str(&format!("{name:<width$}"));
        headings.push(Heading { name: name.to_owned(), start, width: Some(width), quantity });
        start += width;
    }
    if let Some(last) = headings.last_mut() {
        last.width = None;
    }
    line.truncate(line.trim_end().len());
    (headings, line)
}

/// A number as tables print it; a decimal comma is understood.
pub(super) fn number(text: &str) -> Option<f64> {
    let plain = text.bytes().all(|b| b.is_ascii_digit() || matches!(b, b'+' | b'-' | b'.' | b','));
    let number: f64 = text.replacen(',', ".", 1).parse().ok()?;
    (plain && number.is_finite()).then_some(number)
}

/// The shortest printed form with as many decimals as there is room for.
pub(super) fn print(number: f64, room: usize) -> Option<String> {
    if !number.is_finite() {
        return None;
    }
    (0..=DECIMALS).rev().find_map(|decimals| {
        let text = format!("{number:.decimals$}");
        let short = if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.') } else { &text };
        let short = if short == "-0" { "0" } else { short };
        (short.len() <= room).then(|| short.to_owned())
    })
}

/// Cuts a text into lines with their starts; a last line without end counts if it is not empty.
fn lines_of(text: &str) -> Vec<(usize, Line)> {
    let (mut lines, mut at) = (Vec::new(), 0);
    for line in text.split_inclusive('\n') {
        let bare = line.strip_suffix('\n').unwrap_or(line);
        let bare = bare.strip_suffix('\r').unwrap_or(bare);
        let end = line.get(bare.len()..).unwrap_or_default().to_owned();
        lines.push((at, Line { text: bare.to_owned(), end }));
        at += line.len();
    }
    lines
}

struct Reader<'s> {
    source: &'s Arc<Source>,
    found: Vec<Diagnostic>,
}

impl Reader<'_> {
    fn error(&mut self, code: &'static str, start: usize, end: usize, args: Vec<(&'static str, Arg)>) {
        let place = Place::new(self.source, start..end);
        self.found.push(Diagnostic { args, ..Diagnostic::error(code, place) });
    }
}

pub(super) fn parse(kind: TableKind, source: &Arc<Source>) -> Result<Table, Vec<Diagnostic>> {
    match read(kind, source) {
        (Some(table), found) if found.is_empty() => Ok(table),
        (_, found) => Err(found),
    }
}

/// The table as far as it can be read, which is nothing without names of columns, and its mistakes.
pub(super) fn read(kind: TableKind, source: &Arc<Source>) -> (Option<Table>, Vec<Diagnostic>) {
    let numbered = lines_of(source.text());
    let mut reader = Reader { source, found: Vec::new() };
    let line =
        |at: usize| numbered.get(at).map_or(("", source.text().len()), |(start, line)| (line.text.as_str(), *start));
    let (first, _) = line(0);
    let described = described(&numbered);
    let heading = numbered.iter().zip(&described).skip(1).position(|(_, described)| !described).map_or(1, |at| at + 1);
    let (second, second_at) = line(heading);
    let unit = header(first.trim_start_matches('\u{feff}'));
    if unit.is_none() {
        reader.error("table-no-header", 0, first.len(), vec![("extension", kind.extension().into())]);
    }
    let headings = headings(kind, second);
    let Some(key) = headings.iter().find(|heading| heading.quantity == Quantity::Key).cloned() else {
        let name = kind.columns().first().map_or("", |column| column.name);
        reader.error("table-no-heading", second_at, second_at + second.len(), vec![("column", name.into())]);
        return (None, reader.found);
    };
    let end = numbered.iter().skip(1).position(|(_, line)| line.text.trim() == "[END]").map(|at| at + 1);
    if end.is_none() {
        // After the existing text.
        let last = numbered.iter().rfind(|(_, line)| !line.text.trim().is_empty());
        let end = last.map_or(source.text().len(), |(start, line)| start + line.text.trim_end().len());
        reader.error("table-no-end", end, end, Vec::new());
    }
    let end = end.unwrap_or(numbered.len());
    let rows = rows(&mut reader, &numbered, heading + 1..end, &described, &headings, &key);
    let lines = numbered.into_iter().map(|(_, line)| line).collect();
    let file = file_of(source.name());
    let unit = unit.unwrap_or(TableUnit::Mm);
    let rising = rows.is_sorted_by(|a, b| a.0 < b.0);
    (Some(Table { kind, file, unit, headings, heading, lines, rows, rising, end }), reader.found)
}

/// Which lines are neither names of columns nor rows: blank ones, comments, and what describes the columns
/// (`#STRUCTBEGIN` to
/// `#STRUCTEND`).
fn described(lines: &[(usize, Line)]) -> Vec<bool> {
    let mut inside = false;
    let is_it = |(_, line): &(usize, Line)| {
        let text = line.text.trim();
        inside |= text == "#STRUCTBEGIN";
        let described = inside || text.is_empty() || text.starts_with([';', '#']);
        inside &= text != "#STRUCTEND";
        described
    };
    lines.iter().map(is_it).collect()
}

/// `BEGIN`, a name and perhaps the unit; then perhaps which version of the control wrote the file.
fn header(line: &str) -> Option<TableUnit> {
    let mut words = line.split_whitespace();
    let begins = words.next()? == "BEGIN";
    words.next()?;
    let inch = words.take_while(|word| !word.contains(':')).any(|word| word.eq_ignore_ascii_case("INCH"));
    begins.then_some(if inch { TableUnit::Inch } else { TableUnit::Mm })
}

/// The columns of a heading line by the places of its words.
fn headings(kind: TableKind, line: &str) -> Vec<Heading> {
    let mut found: Vec<Heading> = Vec::new();
    let (mut name, mut start) = (String::new(), 0);
    for (at, c) in line.chars().chain([' ']).enumerate() {
        if !c.is_whitespace() {
            if name.is_empty() {
                start = at;
            }
            name.push(c);
        } else if !name.is_empty() {
            let quantity = kind.column(&name).map_or(Quantity::Text, |column| column.quantity);
            if let Some(before) = found.last_mut() {
                before.width = Some(start - before.start);
            }
            found.push(Heading { name: std::mem::take(&mut name), start, width: None, quantity });
        }
    }
    found
}

/// The rows between heading and end; checks every cell of numbers.
fn rows(
    reader: &mut Reader<'_>,
    lines: &[(usize, Line)],
    range: std::ops::Range<usize>,
    described: &[bool],
    headings: &[Heading],
    key: &Heading,
) -> Vec<(f64, usize)> {
    let mut rows: Vec<(f64, usize)> = Vec::new();
    let mut seen: HashSet<u64> = HashSet::new();
    for (index, (start, line)) in lines.iter().enumerate().take(range.end).skip(range.start) {
        if described.get(index).is_some_and(|described| *described) {
            continue;
        }
        let text = key.cell(&line.text).trim();
        let Some(row) = number(text) else {
            reader.error("table-no-row-number", *start, start + line.text.len(), vec![("found", text.into())]);
            continue;
        };
        // 0 and -0 are one row.
        if !seen.insert((row + 0.0).to_bits()) {
            reader.error("table-duplicate-row", *start, start + line.text.len(), vec![("row", row.into())]);
        }
        rows.push((row, index));
        for heading in headings.iter().filter(|heading| heading.quantity != Quantity::Text) {
            let cell = heading.cell(&line.text);
            let text = cell.trim();
            if !(text.is_empty() || text == "-" || number(text).is_some()) {
                let from = start + heading.bytes(&line.text).0 + (cell.len() - cell.trim_start().len());
                let (file, column) = (reader.source.name().into(), heading.name.as_str().into());
                let args = vec![("file", file), ("row", row.into()), ("column", column), ("found", text.into())];
                reader.error("table-bad-number", from, from + text.len(), args);
            }
        }
    }
    rows
}

/// The name of a file without the folders of this computer; those of a control (`TNC:\table`) stay.
fn file_of(name: &str) -> String {
    let own = std::path::Path::new(name).file_name().filter(|_| !name.starts_with("TNC:"));
    own.map_or_else(|| name.to_owned(), |own| own.to_string_lossy().into_owned())
}
