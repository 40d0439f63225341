//! `FN 26: TABOPEN`, `FN 27: TABWRITE` and `FN 28: TABREAD`: cells of a freely definable table.
//!
//! Invariant: one table is open; what is written is a cell of it and an event.
use crate::base::expr::{QKind, QRef};
use crate::engine::flow::state::Run;
use crate::engine::params::Content;
use crate::engine::report::ending::Done;
use crate::engine::report::event::EventKind;
use crate::engine::report::fault::Fault;
use crate::engine::table::{Cell, TableError, TableKind};
use crate::program::syntax::{Statement, Value, ValueKind};

/// So many columns are written or read at once.
const MOST: usize = 8;

fn missing() -> Fault {
    Fault::program("value-missing")
}

/// Parameters one after the other, from the first one on.
pub(super) fn in_succession(first: QRef, count: usize) -> impl Iterator<Item = QRef> {
    (first.number..).take(count).map(move |number| QRef { kind: first.kind, number })
}

impl Run<'_, '_> {
    /// `FN 26: TABOPEN TNC:\DIR\TAB1.TAB`.
    pub(super) fn open_table(&mut self, statement: &Statement) -> Done {
        let written = statement.words.first().map_or("", |word| self.slice(word.value.span)).to_owned();
        let name = self.path_of(&written)?;
        let table = self.drives.world.table_named(&name)?;
        if table.kind() != TableKind::Free {
            return Err(TableError::NoTable { file: name }.into());
        }
        self.access.open = Some(table.file().to_owned());
        Ok(())
    }

    fn open_file(&self) -> Result<String, Fault> {
        self.access.open.clone().ok_or_else(|| Fault::program("open-table-missing"))
    }

    /// The names of columns in a text, not more than a block may name.
    fn columns_in(&self, value: &Value) -> Result<Vec<String>, Fault> {
        let text = match value.kind {
            ValueKind::Text(span) => self.slice(span).to_owned(),
            ValueKind::Q { q, .. } if q.kind == QKind::Qs => self.params.text(q)?.to_string(),
            _ => return Err(Fault::program("text-or-number")),
        };
        let columns: Vec<String> = text.split(',').map(|name| name.trim().to_owned()).collect();
        if columns.len() > MOST {
            return Err(Fault::program("parameter-out-of-range").arg("value", columns.len() as f64));
        }
        Ok(columns)
    }

    /// `FN 27: TABWRITE 5 / "RADIUS,DEPTH" = Q5`: the columns of a row get the values from this parameter on.
    pub(super) fn write_open_table(&mut self, statement: &Statement) -> Done {
        let [row, columns, first] = &*statement.words else { return Err(missing().into()) };
        let ValueKind::Q { q: first, negative: false } = first.value.kind else { return Err(missing().into()) };
        let (file, row, columns) = (self.open_file()?, self.number_of(&row.value)?, self.columns_in(&columns.value)?);
        for (q, column) in in_succession(first, columns.len()).zip(columns) {
            let value = match q.kind {
                QKind::Qs => Content::Text(self.params.text(q)?),
                _ => Content::Number(self.params.number(q)?),
            };
            let cell = match &value {
                Content::Text(text) => Cell::Text(text.to_string()),
                Content::Number(number) => Cell::Number(*number),
            };
            self.drives.world.named_table_to_write(&file)?.set(row, &column, &cell)?;
            self.drives.report.report(EventKind::Table { file: file.clone(), row, column, value });
        }
        Ok(())
    }

    /// `FN 28: TABREAD Q10 = 6 / "X,Y"`: parameters from this one on get the values of the columns of a row.
    pub(super) fn read_open_table(&mut self, statement: &Statement) -> Done {
        let [first, row, columns] = &*statement.words else { return Err(missing().into()) };
        let ValueKind::Q { q: first, negative: false } = first.value.kind else { return Err(missing().into()) };
        let (file, row, columns) = (self.open_file()?, self.number_of(&row.value)?, self.columns_in(&columns.value)?);
        for (q, column) in in_succession(first, columns.len()).zip(columns) {
            let table = self.drives.world.table_named(&file)?;
            let value = match q.kind {
                QKind::Qs => Content::Text(table.text(row, &column)?.into()),
                _ => match table.number(row, &column)? {
                    Some(number) => Content::Number(number),
                    // Nothing was entered.
                    None => {
                        let found = String::new();
                        return Err(TableError::BadNumber { file, row, column, found }.into());
                    }
                },
            };
            self.set(q, value)?;
        }
        Ok(())
    }
}
