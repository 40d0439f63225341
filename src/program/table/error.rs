//! What can go wrong with a cell, as a value.
//!
//! Invariant: every error names the file and the row or column that it is about.
use crate::base::diag::Diagnostic;

/// Why a table cannot answer or be changed.
#[derive(Clone, Debug, PartialEq)]
pub enum TableError {
    /// There is no such table.
    NoTable {
        /// The name that was asked for.
        file: String,
    },
    /// There is no such row.
    NoRow {
        /// The table.
        file: String,
        /// The number of the row.
        row: f64,
    },
    /// There is no such column.
    NoColumn {
        /// The table.
        file: String,
        /// The column.
        column: String,
    },
    /// A cell holds no number where one is needed.
    BadNumber {
        /// The table.
        file: String,
        /// The number of the row.
        row: f64,
        /// The column.
        column: String,
        /// What the cell holds.
        found: String,
    },
    /// The value has no room in the column, or no printed form.
    TooWide {
        /// The table.
        file: String,
        /// The number of the row.
        row: f64,
        /// The column.
        column: String,
    },
    /// Text is to be written into a column of numbers.
    TextInNumbers {
        /// The table.
        file: String,
        /// The number of the row.
        row: f64,
        /// The column.
        column: String,
    },
    /// The number of a row cannot be changed.
    KeyColumn {
        /// The table.
        file: String,
        /// The number of the row.
        row: f64,
        /// The column.
        column: String,
    },
}

impl TableError {
    pub(super) fn no_column(file: String, column: &str) -> Self {
        Self::NoColumn { file, column: column.to_owned() }
    }

    pub(super) fn too_wide(file: String, row: f64, column: String) -> Self {
        Self::TooWide { file, row, column }
    }

    pub(super) fn text_in_numbers(file: String, row: f64, column: String) -> Self {
        Self::TextInNumbers { file, row, column }
    }

    pub(super) fn key_column(file: String, row: f64, column: String) -> Self {
        Self::KeyColumn { file, row, column }
    }

    /// The code of its diagnostic.
    pub const fn code(&self) -> &'static str {
        match self {
            Self::NoTable { .. } => "table-missing",
            Self::NoRow { .. } => "table-no-row",
            Self::NoColumn { .. } => "table-no-column",
            Self::BadNumber { .. } => "table-bad-number",
            Self::TooWide { .. } => "table-too-wide",
            Self::TextInNumbers { .. } => "table-text-in-numbers",
            Self::KeyColumn { .. } => "table-key-column",
        }
    }

    /// The same as a finding about no file of the user; give it a place if there is one.
    pub fn diagnostic(&self) -> Diagnostic {
        let new = Diagnostic::global(self.code());
        match self {
            Self::NoTable { file } => new.arg("file", file.as_str()),
            Self::NoRow { file, row } => new.arg("file", file.as_str()).arg("row", *row),
            Self::NoColumn { file, column } => new.arg("file", file.as_str()).arg("column", column.as_str()),
            Self::BadNumber { file, row, column, found } => new
                .arg("file", file.as_str())
                .arg("row", *row)
                .arg("column", column.as_str())
                .arg("found", found.as_str()),
            Self::TooWide { file, row, column }
            | Self::TextInNumbers { file, row, column }
            | Self::KeyColumn { file, row, column } => {
                new.arg("file", file.as_str()).arg("row", *row).arg("column", column.as_str())
            }
        }
    }
}
