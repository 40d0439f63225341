//! The tables that a program reads and writes by itself: the open one, and the results of queries.
//!
//! Invariant: plain data; a result set is a copy of rows, and the table changes only when it is committed.
use std::collections::BTreeMap;

use crate::base::expr::QRef;
use crate::engine::table::Cell;

/// A row of a result set.
#[derive(Clone, Debug)]
pub(crate) struct Row {
    /// The number of the row in its table; nothing of one that was inserted.
    pub(crate) number: Option<f64>,
    /// By column: what it holds, and whether the program has written it.
    pub(crate) cells: Vec<(Cell, bool)>,
}

/// What a query has found.
#[derive(Clone, Debug)]
pub(crate) struct ResultSet {
    /// The file of the table.
    pub(crate) file: String,
    pub(crate) columns: Vec<String>,
    pub(crate) rows: Vec<Row>,
}

/// What a program has opened, bound and queried.
#[derive(Clone, Debug, Default)]
pub(crate) struct Access {
    /// The table that `FN 26` has opened.
    pub(crate) open: Option<String>,
    /// Parameters that stand for columns: the table as it is written, and the column.
    pub(crate) bound: BTreeMap<QRef, (String, String)>,
    /// Result sets by their handles.
    pub(crate) results: BTreeMap<u32, ResultSet>,
    /// How many queries there were: the last handle.
    pub(crate) handles: u32,
}
