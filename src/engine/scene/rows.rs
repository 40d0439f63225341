//! Rows of tables as a scene writes them: mappings by column.
//!
//! Invariant: a scene's tables have the standard columns of their kind and nothing else.
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
