//! Rows of tables as a scene writes them: mappings by column.
//!
//! Invariant: a scene's tables have the standard columns of their kind and nothing else; freely definable ones have those
//! that their rows name.
use crate::engine::read::Reader;
use crate::engine::table::{Cell, Quantity, Table, TableKind};
use crate::spec::{Key, Node};

/// Adds the rows of a list to a table.
pub(super) fn rows(node: &Node, table: &mut Table, reader: &mut Reader<'_>) {
    for item in reader.items(node) {
        let entries = reader.entries(item);
        row(item, entries, None, table, reader);
    }
}

/// Adds one row; `default` is its number where the scene gives none. The number of the row.
pub(super) fn row<'n>(
    node: &'n Node,
    entries: impl IntoIterator<Item = &'n (Key, Node)>,
    default: Option<f64>,
    table: &mut Table,
    reader: &mut Reader<'_>,
) -> Option<f64> {
    let kind = table.kind();
    let key = kind.columns().first()?.name;
    let number = match (node.get(key), default) {
        (Some(number), _) => row_number(number, reader)?,
        (None, Some(default)) => default,
        (None, None) => {
            reader.need(node, key);
            return None;
        }
    };
    if table.has_row(number) {
        reader.report("scene-repeated", node, vec![("found", number.into())]);
        return None;
    }
    if table.add_row(number).is_err() {
        reader.expected(node, "row-number");
        return None;
    }
    for (name, value) in entries {
        if &*name.text != key {
            cell(kind, number, name, value, table, reader);
        }
    }
    Some(number)
}

/// The number of a row: not negative. A tool may have an index after the point.
pub(super) fn row_number(node: &Node, reader: &mut Reader<'_>) -> Option<f64> {
    let number = reader.number(node)?;
    if number >= 0.0 {
        return Some(number);
    }
    reader.expected(node, "row-number");
    None
}

fn cell(kind: TableKind, row: f64, name: &Key, value: &Node, table: &mut Table, reader: &mut Reader<'_>) {
    let Some(column) = kind.column(&name.text) else {
        let known: Vec<&str> = kind.columns().iter().map(|column| column.name).collect();
        reader.unknown_key(name, &known);
        return;
    };
    let content = match column.quantity {
        Quantity::Text => reader.text(value).map(|text| Cell::Text(text.to_owned())),
        Quantity::Length | Quantity::Feed => reader.length(value).map(Cell::Number),
        Quantity::Angle | Quantity::Number | Quantity::Key => reader.number(value).map(Cell::Number),
    };
    if let Some(content) = content
        && let Err(error) = table.set(row, column.name, &content)
    {
        let finding = error.diagnostic();
        reader.report(finding.code, value, finding.args);
    }
}

/// Characters of a column for numbers and of one for texts, the blank after it included.
const WIDTHS: [usize; 2] = [17, 33];

/// Freely definable tables by the name of their file; each has the columns of its rows, in the order in which they come.
pub(super) fn free_tables(node: &Node, reader: &mut Reader<'_>) -> Vec<Table> {
    let mut tables = Vec::new();
    for (name, list) in reader.entries(node) {
        if TableKind::of_file(&name.text) != Some(TableKind::Free) {
            reader.expected(list, "table-file");
            continue;
        }
        let items = reader.items(list);
        let mut columns: Vec<(String, usize)> = Vec::new();
        for (column, value) in items.iter().flat_map(|item| reader.entries(item)) {
            let text = value.text().unwrap_or_default();
            let [of_numbers, of_texts] = WIDTHS;
            let own = if text.trim().parse::<f64>().is_ok() { of_numbers } else { of_texts };
            let width = own.max(text.chars().count() + 1).max(column.text.chars().count() + 1);
            match columns.iter_mut().find(|(known, _)| known.eq_ignore_ascii_case(&column.text)) {
                Some((_, known)) => *known = width.max(*known),
                None if TableKind::Free.column(&column.text).is_some() => {}
                None => columns.push((column.text.to_string(), width)),
            }
        }
        let mut table = Table::free(&name.text, &columns);
        for item in items {
            free_row(item, &mut table, reader);
        }
        tables.push(table);
    }
    tables
}

fn free_row(item: &Node, table: &mut Table, reader: &mut Reader<'_>) {
    let key = TableKind::Free.columns().first().map_or("", |column| column.name);
    let Some(number) = reader.need(item, key).and_then(|node| row_number(node, reader)) else { return };
    if table.has_row(number) {
        reader.report("scene-repeated", item, vec![("found", number.into())]);
        return;
    }
    if table.add_row(number).is_err() {
        reader.expected(item, "row-number");
        return;
    }
    for (name, value) in reader.entries(item) {
        if &*name.text == key {
            continue;
        }
        let Some(text) = reader.text(value) else { continue };
        if let Err(error) = table.set(number, &name.text, &Cell::Text(text.to_owned())) {
            let finding = error.diagnostic();
            reader.report(finding.code, value, finding.args);
        }
    }
}
