//! What a control or a reader would object to in a table file.
//!
//! Invariant: only what a manual prints is asked for; a column that no manual describes is reported and not checked.
use super::text::{self, Heading};
use super::{Quantity, Table, TableKind, TableUnit, column, doubt};
use crate::base::diag::{Diagnostic, Place, Severity, Source};
use std::sync::Arc;

/// Everything that can be said against a table: what cannot be read, columns that occur twice or that no manual
/// describes, numbers out of their range, words that a column does not take, what is hardly meant.
pub fn check(kind: TableKind, source: &Arc<Source>) -> Vec<Diagnostic> {
    let (table, mut found) = text::read(kind, source);
    // Manuals print tables without BEGIN; the control writes it.
    if let Some(finding) = found.iter_mut().find(|finding| finding.code == "table-no-header" && is_titled(source)) {
        finding.severity = Severity::Warning;
    }
    if let Some(table) = table {
        found.extend(columns(&table, source));
        found.extend(cells(&table, source));
        doubt::told_of(&table, source, &mut found);
    }
    found.sort_by_key(|finding| finding.place.as_ref().map(|place| place.span));
    found
}

/// Whether a table begins with its name and the unit.
fn is_titled(source: &Source) -> bool {
    let first = source.text().lines().next().unwrap_or_default().trim_start_matches('\u{feff}');
    match first.split_whitespace().collect::<Vec<_>>().as_slice() {
        [name, unit] => name.contains('.') && ["MM", "INCH"].iter().any(|own| unit.eq_ignore_ascii_case(own)),
        _ => false,
    }
}

/// What can be said of a table that no manual describes: that only its frame was checked, and whether it is whole.
pub fn check_other(source: &Arc<Source>) -> Vec<Diagnostic> {
    let text = source.text();
    let first = text.lines().next().unwrap_or_default().len();
    let finding = Diagnostic::error("table-not-described", Place::new(source, 0..first));
    let mut found = vec![Diagnostic { severity: Severity::Note, ..finding }];
    if !text.lines().any(|line| line.trim() == "[END]") {
        let end = text.trim_end().len();
        found.push(Diagnostic {
            severity: Severity::Warning,
            ..Diagnostic::error("table-no-end", Place::new(source, end..end))
        });
    }
    found
}

fn columns(table: &Table, source: &Arc<Source>) -> Vec<Diagnostic> {
    let at = table.lines.iter().take(table.heading).map(|line| line.text.len() + line.end.len()).sum::<usize>();
    let text = table.lines.get(table.heading).map_or("", |line| line.text.as_str());
    let (mut found, mut unknown) = (Vec::new(), Vec::new());
    for (index, heading) in table.headings.iter().enumerate() {
        let (from, _) = heading.bytes(text);
        let place = Place::new(source, at + from..at + from + heading.name.len());
        let same = |own: &Heading| column::same_name(&own.name, &heading.name);
        if table.headings.iter().take(index).any(same) {
            found.push(Diagnostic::error("table-duplicate-column", place).arg("column", heading.name.as_str()));
        } else if table.kind.column(&heading.name).is_none() && !table.kind.is_written(&heading.name) {
            unknown.push((heading.name.as_str(), place));
        }
    }
    // Tables of a control have dozens: reported as one finding, at the first.
    if let Some((_, place)) = unknown.first() {
        let names: Vec<&str> = unknown.iter().map(|(name, _)| *name).collect();
        let finding = Diagnostic::error("table-unknown-column", place.clone()).arg("column", names.join(", "));
        found.push(Diagnostic { severity: Severity::Note, ..finding }.arg("count", names.len()));
    }
    found
}

fn cells(table: &Table, source: &Arc<Source>) -> Vec<Diagnostic> {
    let mut found = Vec::new();
    let mut start = 0;
    let mut rows = table.rows.iter().peekable();
    for (index, line) in table.lines.iter().enumerate() {
        if let Some((row, _)) = rows.next_if(|(_, at)| *at == index) {
            for heading in &table.headings {
                let cell = heading.cell(&line.text);
                let written = cell.trim();
                if written.is_empty() || takes(table, heading, written) {
                    continue;
                }
                let from = start + heading.bytes(&line.text).0 + (cell.len() - cell.trim_start().len());
                let place = Place::new(source, from..from + written.len());
                let finding = Diagnostic::error("table-value-not-allowed", place).arg("column", heading.name.as_str());
                found.push(finding.arg("row", *row).arg("found", written));
            }
        }
        start += line.text.len() + line.end.len();
    }
    found
}

/// Whether a column takes what is written in it, as far as manuals say.
fn takes(table: &Table, heading: &Heading, written: &str) -> bool {
    let Some(column) = table.kind.column(&heading.name) else { return true };
    if let Some(words) = table.kind.words(column.name) {
        return words.iter().any(|word| word.eq_ignore_ascii_case(written));
    }
    let (Some((least, most)), Some(number)) = (table.kind.range(column.name), text::number(written)) else {
        return true;
    };
    let inch = table.unit == TableUnit::Inch && column.quantity == Quantity::Length;
    inch || (least..=most).contains(&number)
}
