//! The files around a program that is checked: the programs that it calls, and the tables that are named.
//!
//! Invariant: a name means a file only where a control would find it: without a folder it stands beside the calling
//! program; with folders it ends the path of a file that is checked, too.
//! Whatever cannot be read is as good as not known.
use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, PoisonError};

use super::check::Job;
use super::{Failure, program};
use crate::check::{self, Against, Among, Called, Callee, Rows, ToolName};
use crate::diag::{Diagnostic, Severity};
use crate::system;
use crate::table::{Table, TableKind};

/// Extension of programs whose name has none.
const EXTENSION: &str = "h";
/// So deep calls are followed.
const DEEPEST: usize = 32;

/// The programs that are checked, and those that they call.
pub(super) struct Library {
    files: Vec<PathBuf>,
    /// What is known of called programs, by control and path.
    callees: Mutex<BTreeMap<(String, PathBuf), Arc<Callee>>>,
    /// The files that a program calls.
    calls: Mutex<BTreeMap<PathBuf, Arc<BTreeSet<PathBuf>>>>,
}

/// What a name means.
enum Found {
    Unknown,
    Missing,
    File(PathBuf),
}

impl Library {
    pub(super) fn new(files: Vec<PathBuf>) -> Self {
        Self { files, callees: Mutex::default(), calls: Mutex::default() }
    }

    /// The file that a name in a program means.
    fn file(&self, from: &Path, name: &str) -> Found {
        // Parameters may hold any name.
        let parameter = |name: &str| {
            let number = name.strip_prefix(['Q', 'q']).and_then(|rest| rest.strip_prefix(['S', 's']));
            number.is_some_and(|number| !number.is_empty() && number.bytes().all(|b| b.is_ascii_digit()))
        };
        if from == Path::new("-") || name.is_empty() || parameter(name) {
            return Found::Unknown;
        }
        let parts: Vec<&str> = name.split(['\\', '/', ':']).filter(|part| !matches!(*part, "" | ".")).collect();
        let Some((last, folders)) = parts.split_last() else { return Found::Unknown };
        let last = if last.contains('.') { (*last).to_owned() } else { format!("{last}.{EXTENSION}") };
        if folders.is_empty() && !name.contains(['\\', '/', ':']) {
            let extension = last.rsplit_once('.').map_or("", |(_, extension)| extension);
            let Ok(beside) = system::beside(from, extension) else { return Found::Unknown };
            let named =
                |path: &Path| path.file_name().is_some_and(|own| own.to_string_lossy().eq_ignore_ascii_case(&last));
            let own = named(from).then(|| from.to_owned());
            return own.or_else(|| beside.into_iter().find(|path| named(path))).map_or(Found::Missing, Found::File);
        }
        let ends = |path: &&PathBuf| {
            let mut own = path.components().rev().map(|part| part.as_os_str().to_string_lossy().into_owned());
            let mut asked = std::iter::once(last.as_str())
                .chain(folders.iter().rev().filter(|part| !is_drive(part, name)).copied());
            asked.all(|part| own.next().is_some_and(|own| own.eq_ignore_ascii_case(part)))
        };
        let mut all = self.files.iter().filter(ends);
        match (all.next(), all.next()) {
            (Some(only), None) => Found::File(only.clone()),
            _ => Found::Unknown,
        }
    }

    /// What a program does that is called, so many calls deep.
    fn callee(&self, path: &Path, against: &Against<'_>, depth: usize) -> Option<Arc<Callee>> {
        let key = (against.on.id().to_owned(), path.to_owned());
        let known = |map: &Mutex<BTreeMap<_, Arc<Callee>>>| {
            map.lock().unwrap_or_else(PoisonError::into_inner).get(&key).map(Arc::clone)
        };
        if let Some(callee) = known(&self.callees) {
            return Some(callee);
        }
        let bytes = system::read(path).ok()?;
        let file = program::understood_bytes(path, bytes, against.catalogue);
        // What goes round, or on for too long, may do anything.
        let callee = if depth > DEEPEST || self.leads(path, path, against) {
            Callee::anything(&file.program)
        } else {
            let inside = Inside { library: self, path, against, depth: depth + 1 };
            Callee::of(&file.program, against, Some(&inside))
        };
        let callee = Arc::new(callee);
        self.callees.lock().unwrap_or_else(PoisonError::into_inner).insert(key, Arc::clone(&callee));
        Some(callee)
    }

    /// The files that a program calls.
    fn calls(&self, path: &Path, against: &Against<'_>) -> Arc<BTreeSet<PathBuf>> {
        if let Some(known) = self.calls.lock().unwrap_or_else(PoisonError::into_inner).get(path) {
            return Arc::clone(known);
        }
        let mut calls = BTreeSet::new();
        if let Ok(bytes) = system::read(path) {
            let file = program::understood_bytes(path, bytes, against.catalogue);
            for name in check::named(&file.program, against) {
                if let Found::File(called) = self.file(path, &name) {
                    calls.insert(called);
                }
            }
        }
        let calls = Arc::new(calls);
        self.calls.lock().unwrap_or_else(PoisonError::into_inner).insert(path.to_owned(), Arc::clone(&calls));
        calls
    }

    /// Whether a program calls another one, be it through others.
    fn leads(&self, from: &Path, to: &Path, against: &Against<'_>) -> bool {
        let (mut seen, mut open) = (BTreeSet::from([from.to_owned()]), vec![from.to_owned()]);
        while let Some(path) = open.pop() {
            for next in self.calls(&path, against).iter() {
                if next == to {
                    return true;
                }
                if seen.insert(next.clone()) {
                    open.push(next.clone());
                }
            }
        }
        false
    }
}

/// Whether a part of a path is the name of a drive: `TNC:`.
fn is_drive(part: &str, name: &str) -> bool {
    name.get(..part.len()).is_some_and(|head| head == part) && name.as_bytes().get(part.len()) == Some(&b':')
}

/// A called program with those around it.
struct Inside<'l, 'a> {
    library: &'l Library,
    path: &'l Path,
    against: &'l Against<'a>,
    depth: usize,
}

impl Among for Inside<'_, '_> {
    fn called(&self, name: &str) -> Called {
        let Found::File(path) = self.library.file(self.path, name) else { return Called::Unknown };
        match self.library.callee(&path, self.against, self.depth) {
            Some(callee) => Called::Is { callee, round: false },
            None => Called::Unknown,
        }
    }

    fn has_tool(&self, _: ToolName<'_>) -> Option<bool> {
        None
    }

    fn has_row(&self, _: Rows<'_>, _: f64) -> Option<bool> {
        None
    }
}

/// Tables, each read once.
pub(super) struct Shelf {
    tables: BTreeMap<String, Table>,
    /// Those that are for all programs.
    given: Vec<String>,
}

impl Shelf {
    /// With the tables that are for all programs.
    pub(super) fn new(given: &[String]) -> Result<Self, Failure> {
        let mut shelf = Self { tables: BTreeMap::new(), given: given.to_vec() };
        shelf.add(given)?;
        Ok(shelf)
    }

    /// Reads tables that were not read yet.
    pub(super) fn add(&mut self, names: &[String]) -> Result<(), Failure> {
        for name in names {
            if self.tables.contains_key(name) {
                continue;
            }
            let Some(kind) = TableKind::of_file(name) else {
                return Err(Diagnostic::global("check-no-table").arg("path", name.as_str()).into());
            };
            let file = program::source(Path::new(name))?;
            let table = Table::parse(kind, &file.source).map_err(Failure::Data)?;
            self.tables.insert(name.clone(), table);
        }
        Ok(())
    }
}

/// A program that is checked, with what stands around it.
pub(super) struct Standing<'s> {
    library: &'s Library,
    tables: Vec<&'s Table>,
    path: &'s Path,
    /// Whether its folder is checked as a whole.
    whole: bool,
    against: &'s Against<'s>,
    /// Whether anything was asked that other files answer.
    asked: AtomicBool,
}

impl<'s> Standing<'s> {
    pub(super) fn new(library: &'s Library, shelf: &'s Shelf, job: &'s Job<'_>, against: &'s Against<'s>) -> Self {
        let names = shelf.given.iter().chain(&job.settings.tables);
        let tables = names.filter_map(|name| shelf.tables.get(name)).collect();
        Self { library, tables, path: &job.path, whole: !job.named, against, asked: AtomicBool::new(false) }
    }

    pub(super) const fn against(&self) -> &Against<'s> {
        self.against
    }

    /// Whether what was found depends on other files.
    pub(super) fn asked(&self) -> bool {
        self.asked.load(Ordering::Relaxed)
    }

    /// Whether there are tables to ask.
    pub(super) const fn has_tables(&self) -> bool {
        !self.tables.is_empty()
    }

    fn tables(&self, kind: TableKind) -> impl Iterator<Item = &'s Table> {
        self.tables.iter().copied().filter(move |table| table.kind() == kind)
    }
}

impl Among for Standing<'_> {
    fn called(&self, name: &str) -> Called {
        self.asked.store(true, Ordering::Relaxed);
        let path = match self.library.file(self.path, name) {
            Found::Unknown => return Called::Unknown,
            Found::Missing if self.whole => return Called::Missing(Severity::Warning),
            Found::Missing => return Called::Missing(Severity::Note),
            Found::File(path) => path,
        };
        // What calls itself directly is told by itself.
        if path == self.path {
            return Called::Unknown;
        }
        match self.library.callee(&path, self.against, 0) {
            Some(callee) => Called::Is { callee, round: self.library.leads(&path, self.path, self.against) },
            None => Called::Unknown,
        }
    }

    fn has_tool(&self, tool: ToolName<'_>) -> Option<bool> {
        let mut tables = self.tables(TableKind::Tool).peekable();
        tables.peek()?;
        Some(tables.any(|table| match tool {
            ToolName::Number(number) => table.has_row(number) || table.has_row(number.trunc()),
            // A table that cannot be asked is not blamed.
            ToolName::Name(name) => table.find("NAME", name).map_or(true, |row| row.is_some()),
        }))
    }

    fn knows_tools(&self) -> bool {
        self.tables(TableKind::Tool).next().is_some()
    }

    fn tool_value(&self, tool: ToolName<'_>, column: &str) -> Option<f64> {
        let mut tables = self.tables(TableKind::Tool);
        let (table, None) = (tables.next()?, tables.next()) else { return None };
        let row = match tool {
            ToolName::Number(number) => number,
            ToolName::Name(name) => table.find("NAME", name).ok()??,
        };
        table.number(row, column).ok()?
    }

    fn knows_rows(&self) -> bool {
        self.has_tables()
    }

    fn has_row(&self, rows: Rows<'_>, row: f64) -> Option<bool> {
        let (kind, name) = match rows {
            Rows::Presets => (TableKind::Preset, None),
            Rows::Datums(name) => (TableKind::Datum, name),
        };
        let tables: Vec<&Table> =
            self.tables(kind).filter(|table| name.is_none_or(|name| table.is_named(name))).collect();
        match tables.as_slice() {
            [only] => Some(only.has_row(row)),
            _ => None,
        }
    }
}
