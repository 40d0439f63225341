//! SQL on the tables of the scene: parameters bound to columns, queries, and the rows that they give.
//!
//! Invariant: a table changes only with `COMMIT`, as a whole or not at all; what goes wrong after the query is the result 1
//! in the parameter of the block, as on a control, and not a fault.
use std::cmp::Ordering;
use std::sync::Arc;

use super::query::{self, Condition, Operand, Query};
use crate::base::expr::{QKind, QRef};
use crate::engine::flow::access::{ResultSet, Row};
use crate::engine::flow::state::Run;
use crate::engine::params::Content;
use crate::engine::report::ending::Done;
use crate::engine::report::event::EventKind;
use crate::engine::report::fault::Fault;
use crate::engine::table::{Cell, Quantity, Table, TableError};
use crate::program::syntax::{NamedWord, Statement, ValueKind};

/// What a block gives back: it was done, or it was not.
const WELL: f64 = 0.0;
const WRONG: f64 = 1.0;

/// Something that the server cannot do: the result of the block says it.
struct Refused;

impl Run<'_, '_> {
    /// `SQL BIND`, queries, `SQL FETCH` and the other commands.
    pub(super) fn sql(&mut self, statement: &Statement) -> Done {
        let words = &*statement.words;
        let missing = || Fault::program("value-missing");
        let first = words.first().ok_or_else(missing)?;
        let command = self.slice(first.name).trim().to_ascii_uppercase();
        let parameter = words.iter().find_map(|word| match word.value.kind {
            ValueKind::Q { q, negative: false } if self.slice(word.name).trim().is_empty() => Some(q),
            _ => None,
        });
        let q = parameter.ok_or_else(missing)?;
        let text = words.iter().find_map(|word| match word.value.kind {
            ValueKind::Text(span) => Some(self.slice(span)),
            _ => None,
        });
        let done = match command.as_str() {
            "BIND" => return self.bind(q, text),
            "" => {
                let set = self.query(text.ok_or_else(missing)?)?;
                self.access.handles += 1;
                self.access.results.insert(self.access.handles, set);
                return Ok(self.set(q, Content::Number(f64::from(self.access.handles)))?);
            }
            "SELECT" => {
                let set = self.query(text.ok_or_else(missing)?)?;
                let cell = set.rows.first().and_then(|row| row.cells.first()).map(|(cell, _)| cell.clone());
                let column = set.columns.first().cloned().unwrap_or_default();
                return match self.give_cell(q, &set.file, &column, &cell.unwrap_or(Cell::Empty)) {
                    Ok(done) => done,
                    Err(Refused) => Err(Fault::program("text-or-number").into()),
                };
            }
            "FETCH" => self.fetch(words),
            "UPDATE" => self.update(words),
            "INSERT" => self.insert(words),
            "COMMIT" => self.commit(words),
            "ROLLBACK" => self.roll_back(words),
            _ => {
                return Err(Fault::unsupported("unsupported-block").arg("word", format!("SQL {command}")).into());
            }
        }?;
        let result = if done.is_ok() { WELL } else { WRONG };
        Ok(self.set(q, Content::Number(result))?)
    }

    /// `SQL BIND Q881 "TAB.COLUMN"`; without a column the parameter stands for none any more.
    fn bind(&mut self, q: QRef, text: Option<&str>) -> Done {
        let Some(text) = text else {
            self.access.bound.remove(&q);
            return Ok(());
        };
        let (table, column) = text.trim().rsplit_once('.').ok_or_else(|| Fault::program("value-missing"))?;
        let table = table.trim().trim_matches('\'');
        self.drives.world.table_named(table)?;
        self.access.bound.insert(q, (table.to_owned(), column.trim().to_owned()));
        Ok(())
    }

    /// The statement with the values of the parameters that it names as `:'Q2'`.
    fn with_values(&self, text: &str) -> Result<String, Fault> {
        let (mut whole, mut rest) = (String::new(), text);
        while let Some((before, after)) = rest.split_once(":'") {
            let Some((name, after)) = after.split_once('\'') else { break };
            let q = QRef::parse(name.trim()).ok_or_else(|| Fault::program("block-unreadable").arg("found", name))?;
            whole.push_str(before);
            match self.params.get(q) {
                Some(Content::Number(number)) => whole.push_str(&number.to_string()),
                Some(Content::Text(text)) => whole.push_str(&format!("'{text}'")),
                None => return Err(crate::base::expr::EvalError::Undefined(q).into()),
            }
            rest = after;
        }
        whole.push_str(rest);
        Ok(whole)
    }

    fn query(&self, text: &str) -> Result<ResultSet, Fault> {
        let text = self.with_values(text)?;
        let other = text.split_whitespace().next().filter(|word| !word.eq_ignore_ascii_case("SELECT"));
        if let Some(word) = other {
            return Err(Fault::unsupported("unsupported-block").arg("word", format!("SQL {word}")));
        }
        let query = query::read(&text).map_err(|found| Fault::program("block-unreadable").arg("found", found))?;
        let table = self.drives.world.table_named(&query.table)?;
        Ok(results(table, query)?)
    }

    /// The result set of the handle of a block, with its number.
    fn handle(&self, words: &[NamedWord]) -> Result<u32, Fault> {
        let word = words.iter().find(|word| self.slice(word.name).trim().eq_ignore_ascii_case("HANDLE"));
        let number = self.number_of(&word.ok_or_else(|| Fault::program("value-missing"))?.value)?;
        Ok(if (1.0..=f64::from(u32::MAX)).contains(&number) && number.fract() == 0.0 { number as u32 } else { 0 })
    }

    /// The row that a block names; the first one without `INDEX`.
    fn index(&self, words: &[NamedWord]) -> Result<Option<usize>, Fault> {
        let word = words.iter().find(|word| self.slice(word.name).trim().eq_ignore_ascii_case("INDEX"));
        let Some(word) = word else { return Ok(None) };
        let number = self.number_of(&word.value)?;
        let is_index = (0.0..f64::from(u32::MAX)).contains(&number) && number.fract() == 0.0;
        Ok(Some(if is_index { number as usize } else { usize::MAX }))
    }

    fn has_word(&self, words: &[NamedWord], name: &str) -> bool {
        words.iter().any(|word| self.slice(word.name).trim().to_ascii_uppercase().starts_with(name))
    }

    /// The parameters that stand for columns of a result set, with the places of these.
    fn bound_to(&self, set: &ResultSet) -> Vec<(QRef, usize)> {
        let of = |(q, (table, column)): (&QRef, &(String, String))| {
            let own = self.drives.world.table_named(table).is_ok_and(|table| table.file() == set.file);
            let place = set.columns.iter().position(|name| name.eq_ignore_ascii_case(column));
            place.filter(|_| own).map(|place| (*q, place))
        };
        self.access.bound.iter().filter_map(of).collect()
    }

    /// A parameter gets what a cell holds; without anything in it a number has no value, and a text no characters.
    fn give_cell(&mut self, q: QRef, file: &str, column: &str, cell: &Cell) -> Result<Done, Refused> {
        let scale = self.scale_of(file, column);
        let content = match (q.kind, cell) {
            (QKind::Qs, Cell::Empty) => Content::Text("".into()),
            (QKind::Qs, Cell::Text(text)) => Content::Text(text.as_str().into()),
            (QKind::Qs, Cell::Number(number)) => Content::Text((number / scale).to_string().into()),
            (_, Cell::Empty) => {
                self.params.forget(q);
                return Ok(Ok(()));
            }
            (_, Cell::Number(number)) => Content::Number(number / scale),
            (_, Cell::Text(text)) => match text.trim().replace(',', ".").parse::<f64>() {
                Ok(number) if number.is_finite() => Content::Number(number),
                _ => return Err(Refused),
            },
        };
        Ok(self.set(q, content).map_err(Into::into))
    }

    /// mm in the unit of the program, for columns of lengths and feeds.
    fn scale_of(&self, file: &str, column: &str) -> f64 {
        let quantity = self.drives.world.table_named(file).ok().and_then(|table| table.quantity(column));
        if matches!(quantity, Some(Quantity::Length | Quantity::Feed)) { self.drives.unit() } else { 1.0 }
    }

    fn fetch(&mut self, words: &[NamedWord]) -> Done<Result<(), Refused>> {
        if self.has_word(words, "UNDEFINE") {
            return Err(Fault::unsupported("unsupported-block").arg("word", "SQL FETCH UNDEFINE MISSING").into());
        }
        let index = self.index(words)?.unwrap_or(0);
        let Some(set) = self.access.results.get(&self.handle(words)?) else { return Ok(Err(Refused)) };
        let Some(row) = set.rows.get(index).cloned() else { return Ok(Err(Refused)) };
        let (file, columns, bound) = (set.file.clone(), set.columns.clone(), self.bound_to(set));
        for (q, place) in bound {
            let (Some(column), Some((cell, _))) = (columns.get(place), row.cells.get(place)) else { continue };
            match self.give_cell(q, &file, column, cell) {
                Ok(done) => done?,
                Err(refused) => return Ok(Err(refused)),
            }
        }
        Ok(Ok(()))
    }

    /// What the bound parameters hold, by the place of their columns.
    fn bound_cells(&self, set: &ResultSet) -> Vec<(usize, Cell)> {
        let of = |(q, place): (QRef, usize)| {
            let column = set.columns.get(place).map_or("", String::as_str);
            let cell = match self.params.get(q) {
                Some(Content::Number(number)) => Cell::Number(number * self.scale_of(&set.file, column)),
                Some(Content::Text(text)) => Cell::Text(text.to_string()),
                None => Cell::Empty,
            };
            (place, cell)
        };
        self.bound_to(set).into_iter().map(of).collect()
    }

    fn update(&mut self, words: &[NamedWord]) -> Done<Result<(), Refused>> {
        let (handle, index) = (self.handle(words)?, self.index(words)?.unwrap_or(0));
        let resets = self.has_word(words, "RESET");
        let Some(set) = self.access.results.get(&handle) else { return Ok(Err(Refused)) };
        let cells = self.bound_cells(set);
        let row = self.access.results.get_mut(&handle).and_then(|set| set.rows.get_mut(index));
        let Some(row) = row else { return Ok(Err(Refused)) };
        if resets {
            row.cells.iter_mut().for_each(|cell| *cell = (Cell::Empty, true));
        }
        for (place, cell) in cells {
            if let Some(own) = row.cells.get_mut(place) {
                *own = (cell, true);
            }
        }
        Ok(Ok(()))
    }

    fn insert(&mut self, words: &[NamedWord]) -> Done<Result<(), Refused>> {
        let handle = self.handle(words)?;
        let Some(set) = self.access.results.get(&handle) else { return Ok(Err(Refused)) };
        let cells = self.bound_cells(set);
        let mut row = Row { number: None, cells: vec![(Cell::Empty, false); set.columns.len()] };
        for (place, cell) in cells {
            if let Some(own) = row.cells.get_mut(place) {
                *own = (cell, true);
            }
        }
        if let Some(set) = self.access.results.get_mut(&handle) {
            set.rows.push(row);
        }
        Ok(Ok(()))
    }

    fn commit(&mut self, words: &[NamedWord]) -> Done<Result<(), Refused>> {
        let Some(set) = self.access.results.remove(&self.handle(words)?) else { return Ok(Err(Refused)) };
        let Ok(table) = self.drives.world.table_named(&set.file) else { return Ok(Err(Refused)) };
        let mut table = table.clone();
        let Ok(written) = write(&mut table, &set) else { return Ok(Err(Refused)) };
        if written.is_empty() {
            return Ok(Ok(()));
        }
        *self.drives.world.named_table_to_write(&set.file)? = table;
        for (row, column, cell) in written {
            let value = match cell {
                Cell::Number(number) => Content::Number(number),
                Cell::Text(text) => Content::Text(text.into()),
                Cell::Empty => Content::Text(Arc::from("")),
            };
            self.drives.report.report(EventKind::Table { file: set.file.clone(), row, column, value });
        }
        Ok(Ok(()))
    }

    /// `SQL ROLLBACK`: the result set ends; with `INDEX` one row of it stays, as the first.
    fn roll_back(&mut self, words: &[NamedWord]) -> Done<Result<(), Refused>> {
        let (handle, index) = (self.handle(words)?, self.index(words)?);
        let Some(index) = index else {
            return Ok(self.access.results.remove(&handle).map(|_| ()).ok_or(Refused));
        };
        let Some(set) = self.access.results.get_mut(&handle) else { return Ok(Err(Refused)) };
        let Some(row) = set.rows.get(index).cloned() else { return Ok(Err(Refused)) };
        set.rows = vec![row];
        Ok(Ok(()))
    }
}

/// The rows of a table that a query names.
fn results(table: &Table, query: Query) -> Result<ResultSet, TableError> {
    let file = table.file().to_owned();
    let known = |column: &String| match table.quantity(column) {
        Some(_) => Ok(()),
        None => Err(TableError::NoColumn { file: file.clone(), column: column.clone() }),
    };
    let columns: Vec<String> =
        if query.columns.is_empty() { table.columns().map(str::to_owned).collect() } else { query.columns };
    columns.iter().chain(query.order.iter().map(|(column, _)| column)).try_for_each(known)?;
    let mut numbers = Vec::new();
    for row in table.rows() {
        if query.condition.as_ref().map_or(Ok(true), |condition| holds(condition, table, row))? {
            numbers.push(row);
        }
    }
    let mut order: Result<(), TableError> = Ok(());
    numbers.sort_by(|a, b| {
        let by = |(column, down): &(String, bool)| {
            let (a, b) = match (table.get(*a, column), table.get(*b, column)) {
                (Ok(a), Ok(b)) => (a, b),
                (Err(error), _) | (_, Err(error)) => {
                    order = Err(error);
                    return Ordering::Equal;
                }
            };
            if *down { compared(&b, &a) } else { compared(&a, &b) }
        };
        query.order.iter().map(by).fold(Ordering::Equal, Ordering::then)
    });
    order?;
    let mut rows = Vec::new();
    for number in numbers {
        let cells = columns.iter().map(|column| Ok((table.get(number, column)?, false)));
        rows.push(Row { number: Some(number), cells: cells.collect::<Result<_, TableError>>()? });
    }
    Ok(ResultSet { file, columns, rows })
}

/// The number in a cell; texts of tables that only have texts are numbers if they can be read as such.
fn number_in(cell: &Cell) -> Option<f64> {
    let number = match cell {
        Cell::Number(number) => Some(*number),
        Cell::Text(text) => text.trim().replace(',', ".").parse().ok().filter(|number: &f64| number.is_finite()),
        Cell::Empty => None,
    };
    // 0 and -0 are one number.
    number.map(|number| number + 0.0)
}

/// Empty cells first, numbers by their size before texts by their letters.
fn compared(a: &Cell, b: &Cell) -> Ordering {
    match (number_in(a), number_in(b)) {
        (Some(a), Some(b)) => a.total_cmp(&b),
        (Some(_), None) => {
            if *b == Cell::Empty {
                Ordering::Greater
            } else {
                Ordering::Less
            }
        }
        (None, Some(_)) => {
            if *a == Cell::Empty {
                Ordering::Less
            } else {
                Ordering::Greater
            }
        }
        (None, None) => text_in(a).cmp(&text_in(b)),
    }
}

fn text_in(cell: &Cell) -> String {
    match cell {
        Cell::Text(text) => text.clone(),
        Cell::Number(number) => number.to_string(),
        Cell::Empty => String::new(),
    }
}

fn holds(condition: &Condition, table: &Table, row: f64) -> Result<bool, TableError> {
    Ok(match condition {
        Condition::Compared(column, relation, operand) => {
            let cell = table.get(row, column)?;
            let order = match operand {
                Operand::Number(number) => number_in(&cell).map(|own| own.total_cmp(&(number + 0.0))),
                Operand::Text(text) => (cell != Cell::Empty).then(|| text_in(&cell).as_str().cmp(text)),
            };
            // What is not there is neither equal nor unequal to anything.
            order.is_some_and(|order| relation.holds(order))
        }
        Condition::IsEmpty(column) => table.get(row, column)? == Cell::Empty,
        Condition::Not(inner) => !holds(inner, table, row)?,
        Condition::All(parts) => {
            let all = parts.iter().map(|part| holds(part, table, row)).collect::<Result<Vec<_>, _>>()?;
            all.into_iter().all(|holds| holds)
        }
        Condition::Any(parts) => {
            let all = parts.iter().map(|part| holds(part, table, row)).collect::<Result<Vec<_>, _>>()?;
            all.into_iter().any(|holds| holds)
        }
    })
}

/// Writes what a program has changed in a result set: rows, columns and new values.
fn write(table: &mut Table, set: &ResultSet) -> Result<Vec<(f64, String, Cell)>, Refused> {
    let is_key = |table: &Table, column: &str| table.quantity(column) == Some(Quantity::Key);
    let mut written = Vec::new();
    for row in &set.rows {
        let number = match row.number {
            Some(number) => number,
            None => {
                let own = set.columns.iter().zip(&row.cells).find(|(column, _)| is_key(table, column));
                let number = match own.and_then(|(_, (cell, _))| number_in(cell)) {
                    Some(number) => number,
                    None => table.rows().fold(-1.0, f64::max) + 1.0,
                };
                if table.has_row(number) {
                    return Err(Refused);
                }
                table.add_row(number).map_err(|_| Refused)?;
                number
            }
        };
        for (column, (cell, changed)) in set.columns.iter().zip(&row.cells) {
            if !changed {
                continue;
            }
            if is_key(table, column) {
                // The number of a row stays what it is.
                if number_in(cell).is_some_and(|own| own != number) {
                    return Err(Refused);
                }
                continue;
            }
            table.set(number, column, cell).map_err(|_| Refused)?;
            written.push((number, column.clone(), cell.clone()));
        }
    }
    Ok(written)
}
