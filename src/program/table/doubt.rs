//! What is hardly meant in a table: nothing here keeps it from being read.
//!
//! Invariant: what controls write themselves is accepted.
use super::text::{self, Heading};
use super::{Quantity, Table, TableUnit};
use crate::base::diag::{Arg, Diagnostic, Place, Severity, Source};
use std::ops::Range;
use std::sync::Arc;

/// Where the findings go, and what they are about.
struct Doubts<'t> {
    table: &'t Table,
    source: &'t Arc<Source>,
    found: &'t mut Vec<Diagnostic>,
}

/// A row with its line and where that begins.
struct Row<'t> {
    key: f64,
    line: &'t str,
    start: usize,
}

/// Reports everything in a table that is probably not intended.
pub(super) fn told_of(table: &Table, source: &Arc<Source>, found: &mut Vec<Diagnostic>) {
    let mut doubts = Doubts { table, source, found };
    doubts.header();
    doubts.headings();
    let mut starts = Vec::with_capacity(table.lines.len());
    let mut at = 0;
    for line in &table.lines {
        starts.push(at);
        at += line.text.len() + line.end.len();
    }
    let row = |(key, index): &(f64, usize)| {
        let line = table.lines.get(*index)?;
        Some(Row { key: *key, line: line.text.as_str(), start: *starts.get(*index)? })
    };
    let rows: Vec<Row<'_>> = table.rows.iter().filter_map(row).collect();
    for pair in rows.windows(2) {
        if let [before, own] = pair
            && own.key < before.key
        {
            doubts.tell("order", own.span(), [("row", own.key.into()), ("found", before.key.into())]);
        }
    }
    rows.iter().for_each(|row| doubts.row(row));
    doubts.odd_ones(&rows);
    doubts.same_points(&rows);
    for (line, start) in table.lines.iter().zip(&starts).skip(table.end + 1) {
        let text = line.text.trim();
        if !text.is_empty() && !text.starts_with([';', '#']) {
            doubts.tell("after-end", *start..start + line.text.len(), []);
            break;
        }
    }
}

impl Row<'_> {
    fn span(&self) -> Range<usize> {
        self.start..self.start + self.line.trim_end().len()
    }
}

impl Doubts<'_> {
    fn tell<const N: usize>(&mut self, what: &str, span: Range<usize>, args: [(&'static str, Arg); N]) {
        let finding = Diagnostic::error("table-doubtful", Place::new(self.source, span)).arg("what", what);
        let finding = Diagnostic { severity: Severity::Warning, ..finding };
        self.found.push(args.into_iter().fold(finding, |finding, (name, value)| finding.arg(name, value)));
    }

    /// The unit and the file that the first line names.
    fn header(&mut self) {
        let line = self.table.lines.first().map_or("", |line| line.text.as_str());
        let words: Vec<&str> = line.trim_start_matches('\u{feff}').split_whitespace().collect();
        if words.first() != Some(&"BEGIN") {
            return;
        }
        let is_unit = |word: &&str| word.eq_ignore_ascii_case("MM") || word.eq_ignore_ascii_case("INCH");
        if !words.iter().any(is_unit) {
            self.tell("unit", 0..line.len(), []);
        }
        let extension = self.table.kind.extension();
        let named = words.iter().skip(1).filter_map(|word| word.rsplit_once('.')).map(|(_, extension)| extension);
        let other = named.take(1).find(|own| !own.is_empty() && !own.eq_ignore_ascii_case(&extension[1..]));
        if let Some(other) = other {
            self.tell("kind", 0..line.len(), [("found", format!(".{other}").into()), ("column", extension.into())]);
        }
    }

    fn headings(&mut self) {
        let (table, at) = (self.table, self.table.heading);
        let start: usize = table.lines.iter().take(at).map(|line| line.text.len() + line.end.len()).sum();
        let length = table.lines.get(at).map_or(0, |line| line.text.trim_end().len());
        for name in table.kind.needed() {
            if table.heading(name).is_err() {
                self.tell("column", start..start + length, [("column", (*name).into())]);
            }
        }
    }

    /// A point at which a hole is already.
    fn same_points(&mut self, rows: &[Row<'_>]) {
        if self.table.kind != super::TableKind::Points {
            return;
        }
        let place = |row: &Row<'_>| {
            let number = |name: &str| {
                self.table.heading(name).ok().and_then(|own| text::number(own.cell(row.line).trim())).map(f64::to_bits)
            };
            Some([number("X")?, number("Y")?, number("Z").unwrap_or_default()])
        };
        let mut first: std::collections::BTreeMap<[u64; 3], f64> = std::collections::BTreeMap::new();
        let mut twice = Vec::new();
        for row in rows {
            let Some(at) = place(row) else { continue };
            match first.get(&at) {
                Some(before) => twice.push((row.key, *before, row.span())),
                None => drop(first.insert(at, row.key)),
            }
        }
        for (key, before, span) in twice {
            self.tell("same", span, [("row", key.into()), ("found", before.into())]);
        }
    }

    /// The only text in a column of numbers that no manual describes.
    fn odd_ones(&mut self, rows: &[Row<'_>]) {
        for heading in self.table.headings.iter().filter(|own| self.table.kind.column(&own.name).is_none()) {
            let (mut numbers, mut texts) = (0, Vec::new());
            for row in rows {
                let cell = heading.cell(row.line);
                let written = cell.trim();
                if text::number(written).is_some() {
                    numbers += 1;
                } else if written.chars().any(char::is_alphabetic) {
                    let from = row.start + heading.bytes(row.line).0 + (cell.len() - cell.trim_start().len());
                    texts.push((row.key, from..from + written.len(), written));
                }
            }
            if let [(key, span, written)] = texts.as_slice()
                && numbers >= 2
            {
                let args =
                    [("row", (*key).into()), ("column", heading.name.as_str().into()), ("found", (*written).into())];
                self.tell("value", span.clone(), args);
            }
        }
    }

    fn row(&mut self, row: &Row<'_>) {
        let table = self.table;
        for (at, heading) in table.headings.iter().enumerate() {
            let Some(column) = table.kind.column(&heading.name) else { continue };
            let cell = heading.cell(row.line);
            let written = cell.trim();
            let from = row.start + heading.bytes(row.line).0 + (cell.len() - cell.trim_start().len());
            let span = from..from + written.len();
            let args =
                || [("row", row.key.into()), ("column", heading.name.as_str().into()), ("found", written.into())];
            if is_astride(heading, row.line) && heading.quantity != Quantity::Text {
                let next = table.headings.get(at + 1).map_or("", |next| next.name.as_str());
                self.tell(
                    "astride",
                    span,
                    [("row", row.key.into()), ("column", heading.name.as_str().into()), ("found", next.into())],
                );
                continue;
            }
            let Some(number) = text::number(written) else {
                if written.is_empty()
                    && table.kind.needed().contains(&column.name)
                    && table.kind == super::TableKind::Points
                {
                    self.tell("empty", row.span(), [("row", row.key.into()), ("column", heading.name.as_str().into())]);
                }
                continue;
            };
            let measured = matches!(column.quantity, Quantity::Length | Quantity::Feed);
            let inch = table.unit == TableUnit::Inch && measured;
            let outside = table.kind.usual(column).is_some_and(|(least, most)| !(least..=most).contains(&number));
            // What a control refuses is reported already.
            let refused = table.kind.range(column.name).is_some_and(|(least, most)| !(least..=most).contains(&number));
            if (outside && !inch && !refused) || (table.kind.is_whole(column) && number.fract() != 0.0) {
                self.tell("value", span, args());
            }
        }
        let number = |name: &str| {
            let heading = table.heading(name).ok()?;
            text::number(heading.cell(row.line).trim()).map(|number| (number, heading))
        };
        if table.kind == super::TableKind::Tool && row.key == 0.0 {
            let measured = ["L", "R"].into_iter().find(|name| number(name).is_some_and(|(number, _)| number != 0.0));
            if let Some((name, (_, heading))) = measured.and_then(|name| Some((name, number(name)?))) {
                let (from, to) = heading.bytes(row.line);
                self.tell("zero", row.start + from..row.start + to, [("row", row.key.into()), ("column", name.into())]);
            }
        }
        // A probe that is faster than it may be, or that stops before it touches anything.
        for (less, more) in [("FMAX", "F"), ("DIST", "SET_UP")] {
            if table.kind == super::TableKind::Probe
                && let (Some((own, heading)), Some((other, _))) = (number(less), number(more))
                && own < other
                && own > 0.0
            {
                let (from, to) = heading.bytes(row.line);
                let args = [("row", row.key.into()), ("column", less.into()), ("found", more.into())];
                self.tell("less", row.start + from..row.start + to, args);
            }
        }
        if let (Some((radius, _)), Some((corner, heading))) = (number("R"), number("R2"))
            && corner > radius
            && radius > 0.0
        {
            let (from, to) = heading.bytes(row.line);
            self.tell("corner", row.start + from..row.start + to, [("row", row.key.into())]);
        }
    }
}

/// Whether a number continues after the end of its column.
fn is_astride(heading: &Heading, line: &str) -> bool {
    let end = heading.bytes(line).1;
    let before = line.get(..end).and_then(|text| text.chars().next_back());
    let after = line.get(end..).and_then(|text| text.chars().next());
    let digit = |c: char| c.is_ascii_digit() || c == '.' || c == ',';
    before.is_some_and(digit) && after.is_some_and(digit)
}
