//! The controls' tables in their own file format: text in fixed columns.
//!
//! ```text
//! BEGIN PRESET.PR MM
//! NO      X                Y
//! 0       0                0
//! [END]
//! ```
//!
//! Invariant: an unchanged table gives back the very text it was read from; a change touches the
//! characters of its cell only. Numbers go in and out in mm, mm/min and degrees, whatever the table's unit.
mod check;
mod column;
mod doubt;
mod error;
mod text;

pub use check::{check, check_other};
pub use column::{Column, Quantity, TableKind};
pub use error::TableError;

use crate::base::diag::{Diagnostic, Source};
use std::sync::Arc;
use text::{Heading, Line};

/// mm of an inch.
const INCH: f64 = 25.4;

/// The unit of a table.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TableUnit {
    /// Millimetres.
    Mm,
    /// Inches.
    Inch,
}

/// The content of a cell.
#[derive(Clone, Debug, PartialEq)]
pub enum Cell {
    /// Nothing was entered (blank, or `-`).
    Empty,
    /// A number, in mm, mm/min or degrees by its column.
    Number(f64),
    /// Text.
    Text(String),
}

/// A table.
#[derive(Clone, Debug)]
pub struct Table {
    kind: TableKind,
    file: String,
    unit: TableUnit,
    headings: Vec<Heading>,
    /// The index of the line that names the columns.
    heading: usize,
    lines: Vec<Line>,
    /// Key and index of the line of each row, in the order of the file.
    rows: Vec<(f64, usize)>,
    /// Whether the keys of the rows rise, as they do in the controls' own files.
    rising: bool,
    /// The index of the line before which a new last row goes.
    end: usize,
}

impl Table {
    /// An empty table with the standard columns, in mm.
    pub fn new(kind: TableKind, file: &str) -> Self {
        let (headings, heading) = text::standard(kind);
        let lines = vec![Line::new(format!("BEGIN {file} MM")), Line::new(heading), Line::new("[END]".to_owned())];
        let file = file.to_owned();
        Self { kind, file, unit: TableUnit::Mm, headings, heading: 1, lines, rows: Vec::new(), rising: true, end: 2 }
    }

    /// An empty freely definable table with these columns, each so many characters wide, after the number of the row.
    pub fn free(file: &str, columns: &[(String, usize)]) -> Self {
        let (headings, heading) = text::with_columns(TableKind::Free, columns);
        let kind = TableKind::Free;
        let lines = vec![Line::new(format!("BEGIN {file} MM")), Line::new(heading), Line::new("[END]".to_owned())];
        let file = file.to_owned();
        Self { kind, file, unit: TableUnit::Mm, headings, heading: 1, lines, rows: Vec::new(), rising: true, end: 2 }
    }

    /// What a column holds, if the table has it.
    pub fn quantity(&self, column: &str) -> Option<Quantity> {
        self.heading(column).ok().map(|heading| heading.quantity)
    }

    /// Reads a table. The name of its file is that of the source without the folders of this computer.
    ///
    /// # Errors
    /// All mistakes with their places: no header, no heading, no `[END]`, no or a repeated row number, a
    /// number that is none.
    pub fn parse(kind: TableKind, source: &Arc<Source>) -> Result<Self, Vec<Diagnostic>> {
        text::parse(kind, source)
    }

    /// Reads a table as far as it can be read, which is nothing without names of columns; with its mistakes. A cell that is no
    /// number is as good as empty.
    pub fn read(kind: TableKind, source: &Arc<Source>) -> (Option<Self>, Vec<Diagnostic>) {
        text::read(kind, source)
    }

    /// The text of the file.
    pub fn to_text(&self) -> String {
        self.lines.iter().flat_map(|line| [line.text.as_str(), line.end.as_str()]).collect()
    }

    /// The text of the file with every cell at the beginning of its column and no blanks after the last one.
    pub fn laid_out(&self) -> String {
        let mut lines = self.lines.clone();
        for (_, at) in &self.rows {
            let Some(line) = lines.get_mut(*at) else { continue };
            let mut new = String::new();
            for heading in &self.headings {
                let text = heading.cell(&line.text).trim();
                if !text.is_empty() {
                    heading.put(&mut new, text);
                }
            }
            line.text = new.trim_end().to_owned();
        }
        lines.iter().flat_map(|line| [line.text.as_str(), line.end.as_str()]).collect()
    }

    /// Its kind.
    pub const fn kind(&self) -> TableKind {
        self.kind
    }

    /// The name of its file.
    pub fn file(&self) -> &str {
        &self.file
    }

    /// Its unit; cells are converted, so this matters to who shows the file only.
    pub const fn unit(&self) -> TableUnit {
        self.unit
    }

    /// Whether a path in a program means this table: drives and directories do not matter, nor does case. A name
    /// without an extension means a table of its kind.
    pub fn is_named(&self, path: &str) -> bool {
        let last = |name: &str| name.rsplit(['\\', '/', ':']).next().unwrap_or_default().to_ascii_uppercase();
        let (asked, own) = (last(path), last(&self.file));
        asked == own || (!asked.contains('.') && own.rsplit_once('.').is_some_and(|(stem, _)| stem == asked))
    }

    /// The numbers of the rows in the order of the file.
    pub fn rows(&self) -> impl Iterator<Item = f64> + '_ {
        self.rows.iter().map(|(key, _)| *key)
    }

    /// Whether there is such a row.
    pub fn has_row(&self, row: f64) -> bool {
        self.row_at(row).is_some()
    }

    /// The names of the columns in the order of the file.
    pub fn columns(&self) -> impl Iterator<Item = &str> {
        self.headings.iter().map(|heading| heading.name.as_str())
    }

    /// The row whose cell holds exactly this text, such as a tool by its NAME.
    ///
    /// # Errors
    /// [`TableError::NoColumn`], where the control does not know such a column either.
    pub fn find(&self, column: &str, text: &str) -> Result<Option<f64>, TableError> {
        let heading = match self.heading(column) {
            Err(_) if self.kind.column(column).is_some() => return Ok(None),
            heading => heading?,
        };
        let has = |line: &Line| heading.cell(&line.text).trim() == text;
        Ok(self.rows.iter().find(|(_, at)| self.lines.get(*at).is_some_and(has)).map(|(key, _)| *key))
    }

    /// The content of a cell.
    ///
    /// # Errors
    /// No such row or column, or a column of numbers holds something else.
    pub fn get(&self, row: f64, column: &str) -> Result<Cell, TableError> {
        let heading = match self.heading(column) {
            // Files of a control need not have every column: nothing was entered there.
            Err(_) if self.kind.column(column).is_some() => return self.line_of(row).map(|_| Cell::Empty),
            heading => heading?,
        };
        let line = self.lines.get(self.line_of(row)?).map_or("", |line| line.text.as_str());
        let text = heading.cell(line).trim();
        if text.is_empty() || text == "-" {
            return Ok(Cell::Empty);
        }
        let quantity = heading.quantity;
        if quantity == Quantity::Text {
            return Ok(Cell::Text(text.to_owned()));
        }
        let number = text::number(text).ok_or_else(|| self.bad_number(row, column, text))?;
        Ok(Cell::Number(number * self.factor(quantity)))
    }

    /// The number in a cell, if there is one.
    ///
    /// # Errors
    /// As for [`Table::get`]; text in a column of text is not a number.
    pub fn number(&self, row: f64, column: &str) -> Result<Option<f64>, TableError> {
        match self.get(row, column)? {
            Cell::Empty => Ok(None),
            Cell::Number(number) => Ok(Some(number)),
            Cell::Text(text) => text::number(&text).map(Some).ok_or_else(|| self.bad_number(row, column, &text)),
        }
    }

    /// The text of a cell as printed; empty if nothing was entered, or if the file lacks a column that the control knows.
    ///
    /// # Errors
    /// No such row or column.
    pub fn text(&self, row: f64, column: &str) -> Result<&str, TableError> {
        let heading = match self.heading(column) {
            Err(_) if self.kind.column(column).is_some() => return self.line_of(row).map(|_| ""),
            heading => heading?,
        };
        let line = self.line_of(row)?;
        Ok(self.lines.get(line).map_or("", |line| heading.cell(&line.text).trim()))
    }

    /// Writes a cell. A number is written with as many of nine decimals as its column has room for.
    ///
    /// # Errors
    /// No such row or column, the number of the row itself, text in a column of numbers, a number that is not
    /// finite, or something too wide for the column.
    pub fn set(&mut self, row: f64, column: &str, cell: &Cell) -> Result<(), TableError> {
        let heading = self.heading(column)?.clone();
        let line = self.line_of(row)?;
        let error = |error: fn(String, f64, String) -> TableError| error(self.file.clone(), row, heading.name.clone());
        let room = heading.room();
        let text = match cell {
            _ if heading.quantity == Quantity::Key => return Err(error(TableError::key_column)),
            Cell::Empty => String::new(),
            Cell::Number(number) => {
                let number = number / self.factor(heading.quantity);
                text::print(number, room).ok_or_else(|| error(TableError::too_wide))?
            }
            Cell::Text(_) if heading.quantity != Quantity::Text => return Err(error(TableError::text_in_numbers)),
            Cell::Text(text) if text.chars().any(char::is_control) => return Err(error(TableError::too_wide)),
            Cell::Text(text) if text.chars().count() > room => return Err(error(TableError::too_wide)),
            Cell::Text(text) => text.clone(),
        };
        if let Some(line) = self.lines.get_mut(line) {
            heading.put(&mut line.text, &text);
        }
        Ok(())
    }

    /// Adds an empty row in the order of the numbers; nothing happens if it is there.
    ///
    /// # Errors
    /// [`TableError::TooWide`] if the number has no room, or is not finite.
    pub fn add_row(&mut self, row: f64) -> Result<(), TableError> {
        if self.has_row(row) {
            return Ok(());
        }
        let Some(heading) = self.headings.iter().find(|heading| heading.quantity == Quantity::Key) else {
            return Err(TableError::no_column(self.file.clone(), self.kind.columns().first().map_or("", |c| c.name)));
        };
        let too_wide = || TableError::too_wide(self.file.clone(), row, heading.name.clone());
        let text = text::print(row, heading.room()).ok_or_else(too_wide)?;
        let at = match self.rows.last() {
            Some((last, _)) if self.rising && *last < row => None,
            _ => self.rows.iter().position(|(key, _)| *key > row),
        };
        let line = at.and_then(|at| self.rows.get(at)).map_or(self.end, |(_, line)| *line);
        let mut new = Line::new(String::new());
        if let Some(neighbour) = self.lines.first() {
            new.end.clone_from(&neighbour.end);
        }
        heading.put(&mut new.text, &text);
        self.lines.insert(line, new);
        if at.is_some() {
            for (_, index) in self.rows.iter_mut().filter(|(_, index)| *index >= line) {
                *index += 1;
            }
        }
        self.rows.insert(at.unwrap_or(self.rows.len()), (row, line));
        self.end += 1;
        Ok(())
    }

    fn heading(&self, column: &str) -> Result<&Heading, TableError> {
        let found = self.headings.iter().find(|heading| column::same_name(&heading.name, column));
        found.ok_or_else(|| TableError::no_column(self.file.clone(), column))
    }

    fn line_of(&self, row: f64) -> Result<usize, TableError> {
        let found = self.row_at(row).and_then(|at| self.rows.get(at));
        found.map(|(_, line)| *line).ok_or_else(|| TableError::NoRow { file: self.file.clone(), row })
    }

    /// Where a row is among the rows.
    fn row_at(&self, row: f64) -> Option<usize> {
        if !self.rising {
            return self.rows.iter().position(|(key, _)| *key == row);
        }
        let at = self.rows.partition_point(|(key, _)| *key < row);
        self.rows.get(at).filter(|(key, _)| *key == row).map(|_| at)
    }

    fn factor(&self, quantity: Quantity) -> f64 {
        match (self.unit, quantity) {
            (TableUnit::Inch, Quantity::Length | Quantity::Feed) => INCH,
            _ => 1.0,
        }
    }

    fn bad_number(&self, row: f64, column: &str, found: &str) -> TableError {
        let (file, column, found) = (self.file.clone(), column.to_owned(), found.to_owned());
        TableError::BadNumber { file, row, column, found }
    }
}
