//! The files that a checked program refers to: the programs that it calls, and the tables that are named.
//!
//! Invariant: a name means a file only where a control would find it: without a folder it is next to the calling
//! program; with folders it ends the path of a file that is checked, too.
//! Whatever cannot be read is as good as not known.
use std::collections::{BTreeMap, BTreeSet, HashMap};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, OnceLock, PoisonError};

use super::jobs::Job;
use super::neighbours::Neighbours;
use super::{Failure, execution, program};
use crate::base::data::Files;
use crate::base::diag::{Diagnostic, Severity};
use crate::check::{self, Against, Called, Callee, Machine, Observed, Project, Rows, ToolName};
use crate::engine::run::Programs;
use crate::engine::scene::Scene;
use crate::program::syntax::Program;
use crate::program::table::{Table, TableKind};
use crate::system::{self, Folder};
use crate::tools::rehearse::Rehearsal;

/// Extension of programs whose name has none.
const EXTENSION: &str = "h";

/// The programs that are checked, and those that they call. Each has one path here ([`system::spelled`]).
pub(super) struct Library {
    /// The files that are checked as they were given, each with its path.
    spelled: HashMap<PathBuf, PathBuf>,
    /// Their parts from the last to the first, given and spelled, by the last one in small letters.
    named: HashMap<String, Vec<(Vec<String>, PathBuf)>>,
    /// Folders that were looked into; nothing of those that cannot be.
    folders: Mutex<HashMap<PathBuf, Option<Arc<Folder>>>>,
    /// What names with folders mean.
    asked: Mutex<HashMap<String, Option<PathBuf>>>,
    /// What is known of called programs, by control.
    controls: Mutex<BTreeMap<String, Arc<Calling>>>,
}

/// What programs do and call on a control, each found out once.
#[derive(Default)]
struct Calling {
    /// What a called program does; nothing of one that cannot be read.
    callees: Cells<Option<Arc<Callee>>>,
    /// The files that a program calls.
    calls: Cells<Arc<BTreeSet<PathBuf>>>,
    /// The number of the circle that a program is in, if it is in one.
    circles: Mutex<HashMap<PathBuf, Option<usize>>>,
}

/// Something of each file, which whatever comes first finds out while others wait.
struct Cells<T>(Mutex<HashMap<PathBuf, Arc<OnceLock<T>>>>);

impl<T> Default for Cells<T> {
    fn default() -> Self {
        Self(Mutex::default())
    }
}

impl<T: Clone> Cells<T> {
    fn cell(&self, path: &Path) -> Arc<OnceLock<T>> {
        let mut all = held(&self.0);
        match all.get(path) {
            Some(cell) => Arc::clone(cell),
            None => Arc::clone(all.entry(path.to_owned()).or_default()),
        }
    }

    /// What is known already.
    fn known(&self, path: &Path) -> Option<T> {
        held(&self.0).get(path)?.get().cloned()
    }
}

fn held<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

/// What a name means.
enum Found {
    Unknown,
    Missing,
    File(PathBuf),
}

impl Library {
    pub(super) fn new(files: Vec<PathBuf>) -> Self {
        let mut directories: HashMap<PathBuf, PathBuf> = HashMap::new();
        let mut spelled = HashMap::new();
        let mut named: HashMap<String, Vec<(Vec<String>, PathBuf)>> = HashMap::new();
        for given in files {
            let directory = given.parent().map(Path::to_owned).unwrap_or_default();
            // Folders are asked once: there may be thousands of files in one.
            let known = directories.get(&directory).zip(given.file_name());
            let whole = match known.filter(|_| given != Path::new("-")) {
                Some((directory, name)) => directory.join(name),
                None => system::spelled(&given),
            };
            if let Some(own) = whole.parent().filter(|own| own.is_absolute()) {
                directories.entry(directory).or_insert_with(|| own.to_owned());
            }
            for path in [&given, &whole] {
                let parts: Vec<String> =
                    path.components().rev().map(|part| part.as_os_str().to_string_lossy().into_owned()).collect();
                if let Some(last) = parts.first() {
                    named.entry(last.to_ascii_lowercase()).or_default().push((parts, whole.clone()));
                }
            }
            spelled.insert(given, whole);
        }
        let (folders, asked, controls) = (Mutex::default(), Mutex::default(), Mutex::default());
        Self { spelled, named, folders, asked, controls }
    }

    /// The path of a file that is checked.
    fn spelled(&self, given: &Path) -> PathBuf {
        self.spelled.get(given).map_or_else(|| system::spelled(given), Clone::clone)
    }

    /// The files of a folder.
    fn folder(&self, directory: &Path) -> Option<Arc<Folder>> {
        let mut all = held(&self.folders);
        if let Some(known) = all.get(directory) {
            return known.clone();
        }
        let own = Folder::of(directory).ok().map(Arc::new);
        all.insert(directory.to_owned(), own.clone());
        own
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
            let is_own = from.file_name().is_some_and(|own| own.to_string_lossy().eq_ignore_ascii_case(&last));
            let Some(folder) = from.parent().and_then(|directory| self.folder(directory)) else {
                return Found::Unknown;
            };
            let own = is_own.then(|| from.to_owned());
            return own.or_else(|| folder.file(&last)).map_or(Found::Missing, Found::File);
        }
        let known = held(&self.asked).get(name).cloned();
        let found = known.unwrap_or_else(|| {
            let folders: Vec<&str> = folders.iter().rev().filter(|part| !is_drive(part, name)).copied().collect();
            let found = self.ending(&last, &folders);
            held(&self.asked).insert(name.to_owned(), found.clone());
            found
        });
        found.map_or(Found::Unknown, Found::File)
    }

    /// The only file whose path ends with some folders, reported from the last to the first, and a name.
    fn ending(&self, last: &str, folders: &[&str]) -> Option<PathBuf> {
        let ends = |(parts, _): &&(Vec<String>, PathBuf)| {
            let mut own = parts.iter().skip(1);
            folders.iter().all(|part| own.next().is_some_and(|own| own.eq_ignore_ascii_case(part)))
        };
        let mut all = self.named.get(&last.to_ascii_lowercase())?.iter().filter(ends).map(|(_, path)| path);
        let only = all.next()?;
        all.all(|other| other == only).then(|| only.clone())
    }

    /// What is known of programs on a control.
    fn on(&self, against: &Against<'_>) -> Arc<Calling> {
        let mut all = held(&self.controls);
        match all.get(against.on.id()) {
            Some(known) => Arc::clone(known),
            None => Arc::clone(all.entry(against.on.id().to_owned()).or_default()),
        }
    }

    /// What a program does that is called.
    fn callee(&self, path: &Path, against: &Against<'_>) -> Option<Arc<Callee>> {
        let on = self.on(against);
        // What a program calls is known before it is looked at itself, however deep calls are nested.
        let mut way = vec![path.to_owned()];
        while let Some(next) = way.last().cloned() {
            if on.callees.known(&next).is_some() {
                way.pop();
                continue;
            }
            let round = self.circle(&next, against).is_some();
            let length = way.len();
            if !round {
                let calls = self.calls(&next, against);
                way.extend(calls.iter().filter(|called| on.callees.known(called).is_none()).cloned());
            }
            if way.len() == length {
                on.callees.cell(&next).get_or_init(|| self.read(&next, against, round).map(Arc::new));
                way.pop();
            }
        }
        on.callees.known(path).flatten()
    }

    fn read(&self, path: &Path, against: &Against<'_>, round: bool) -> Option<Callee> {
        let bytes = system::read(path).ok()?;
        let file = program::understood_bytes(path, bytes, against.catalogue);
        // What goes round may do anything.
        if round {
            return Some(Callee::anything(&file.program));
        }
        Some(Callee::of(&file.program, against, Some(&CalledProgram { library: self, path, against })))
    }

    /// The files that a program calls.
    fn calls(&self, path: &Path, against: &Against<'_>) -> Arc<BTreeSet<PathBuf>> {
        let cell = self.on(against).calls.cell(path);
        let calls = cell.get_or_init(|| {
            let mut calls = BTreeSet::new();
            if let Ok(bytes) = system::read(path) {
                let file = program::understood_bytes(path, bytes, against.catalogue);
                for name in check::named(&file.program, against) {
                    if let Found::File(called) = self.file(path, &name) {
                        calls.insert(called);
                    }
                }
            }
            Arc::new(calls)
        });
        Arc::clone(calls)
    }

    /// The circle of calls that a program is in: the same for all programs of the circle, and nothing if it does not
    /// lead back to itself.
    fn circle(&self, path: &Path, against: &Against<'_>) -> Option<usize> {
        let on = self.on(against);
        if let Some(known) = held(&on.circles).get(path) {
            return *known;
        }
        // Everything that it leads to and that was not looked at: what was looked at does not lead here.
        let (mut seen, mut open) = (BTreeMap::new(), vec![path.to_owned()]);
        while let Some(next) = open.pop() {
            if seen.contains_key(&next) || held(&on.circles).contains_key(&next) {
                continue;
            }
            let calls = self.calls(&next, against);
            open.extend(calls.iter().cloned());
            seen.insert(next, calls);
        }
        let mut circles = held(&on.circles);
        // Others may have looked at some of them meanwhile, and then at all that these lead to.
        seen.retain(|path, _| !circles.contains_key(path));
        let index: HashMap<&PathBuf, usize> = seen.keys().enumerate().map(|(index, path)| (path, index)).collect();
        let inner: Vec<Vec<usize>> =
            seen.values().map(|calls| calls.iter().filter_map(|called| index.get(called).copied()).collect()).collect();
        let groups = check::circles(&inner);
        let mut members: HashMap<usize, usize> = HashMap::new();
        groups.iter().for_each(|group| *members.entry(*group).or_default() += 1);
        let base = circles.len();
        for ((path, calls), group) in seen.iter().zip(groups) {
            let round = members.get(&group).is_some_and(|count| *count > 1) || calls.contains(path);
            circles.insert(path.clone(), round.then_some(base + group));
        }
        circles.get(path).copied().flatten()
    }
}

/// Whether a part of a path is the name of a drive: `TNC:`.
fn is_drive(part: &str, name: &str) -> bool {
    name.get(..part.len()).is_some_and(|head| head == part) && name.as_bytes().get(part.len()) == Some(&b':')
}

/// A called program with those that it may call.
struct CalledProgram<'l, 'a> {
    library: &'l Library,
    path: &'l Path,
    against: &'l Against<'a>,
}

impl Project for CalledProgram<'_, '_> {
    fn called(&self, name: &str) -> Called {
        let Found::File(path) = self.library.file(self.path, name) else { return Called::Unknown };
        match self.library.on(self.against).callees.known(&path).flatten() {
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
pub(super) struct Tables {
    tables: BTreeMap<String, Table>,
    /// Those that are for all programs.
    given: Vec<String>,
    /// What is wrong with them.
    found: Vec<Diagnostic>,
}

impl Tables {
    /// With the tables that are for all programs.
    pub(super) fn new(given: &[String]) -> Result<Self, Failure> {
        let mut tables = Self { tables: BTreeMap::new(), given: given.to_vec(), found: Vec::new() };
        tables.add(given)?;
        Ok(tables)
    }

    /// Whether no tables are named for any program.
    pub(super) fn is_empty(&self) -> bool {
        self.tables.is_empty()
    }

    /// What is wrong with the tables that were read.
    pub(super) fn found(&self) -> &[Diagnostic] {
        &self.found
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
            // A mistake in a table hides none in a program.
            let (table, found) = Table::read(kind, &file.source);
            let Some(table) = table else { return Err(Failure::Data(found)) };
            self.found.extend(found);
            self.tables.insert(name.clone(), table);
        }
        Ok(())
    }
}

/// A program that is checked, with the files that it may refer to.
pub(super) struct CheckedProgram<'s> {
    library: &'s Library,
    tables: Vec<&'s Table>,
    path: PathBuf,
    /// Whether its folder is checked as a whole.
    whole: bool,
    against: &'s Against<'s>,
    machine: &'s Machine,
    /// The files of machines, with which it is executed, if it shall be.
    files: Option<&'s Files>,
    /// Whether anything was asked that other files answer.
    asked: AtomicBool,
}

impl<'s> CheckedProgram<'s> {
    pub(super) fn new(
        library: &'s Library,
        tables: &'s Tables,
        job: &'s Job<'_>,
        against: &'s Against<'s>,
        files: Option<&'s Files>,
    ) -> Self {
        let names = tables.given.iter().chain(&job.settings.tables);
        let tables = names.filter_map(|name| tables.tables.get(name)).collect();
        let path = library.spelled(&job.path);
        Self {
            library,
            tables,
            path,
            whole: !job.named,
            against,
            machine: &job.settings.machine,
            files,
            asked: AtomicBool::new(false),
        }
    }

    /// The tables that were named for it.
    pub(super) fn named_tables(&self) -> &[&'s Table] {
        &self.tables
    }

    pub(super) const fn against(&self) -> &Against<'s> {
        self.against
    }

    /// Whether what was found depends on other files.
    pub(super) fn asked(&self) -> bool {
        self.asked.load(Ordering::Relaxed)
    }

    /// Whether what is found depends on more than the program: on tables, or on what the machine can do.
    pub(super) fn has_more(&self) -> bool {
        self.has_tables() || self.machine.is_known()
    }

    const fn has_tables(&self) -> bool {
        !self.tables.is_empty()
    }

    /// A table that lies beside the program, if it can be read.
    fn table_beside(&self, kind: TableKind, name: &str) -> Option<Table> {
        let own = Path::new(name);
        let extension = kind.extension().trim_start_matches('.');
        let other = own.extension().is_some_and(|own| !own.eq_ignore_ascii_case(extension));
        if other || name.contains(['\\', '/', ':']) || self.path == Path::new("-") {
            return None;
        }
        self.asked.store(true, Ordering::Relaxed);
        let stem = own.file_stem()?;
        let mut all = system::beside(&self.path, extension).ok()?.into_iter();
        let path = all.find(|other| other.file_stem().is_some_and(|other| other.eq_ignore_ascii_case(stem)))?;
        Table::parse(kind, &program::source(&path).ok()?.source).ok()
    }

    /// The table of tools of a kind, where there is one only, and the row of a tool.
    fn tool_row(&self, kind: TableKind, tool: ToolName<'_>) -> Option<(&'s Table, f64)> {
        let mut tables = self.tables(kind);
        let (table, None) = (tables.next()?, tables.next()) else { return None };
        let row = match tool {
            ToolName::Number(number) => number,
            ToolName::Name(name) => table.find("NAME", name).ok()??,
        };
        Some((table, row))
    }

    fn tables(&self, kind: TableKind) -> impl Iterator<Item = &'s Table> {
        self.tables.iter().copied().filter(move |table| table.kind() == kind)
    }
}

impl Project for CheckedProgram<'_> {
    fn called(&self, name: &str) -> Called {
        self.asked.store(true, Ordering::Relaxed);
        let path = match self.library.file(&self.path, name) {
            Found::Unknown => return Called::Unknown,
            Found::Missing if self.whole => return Called::Missing(Severity::Warning),
            Found::Missing => return Called::Missing(Severity::Note),
            Found::File(path) => path,
        };
        // What calls itself directly is reported by a rule of its own.
        if path == self.path {
            return Called::Unknown;
        }
        let Some(callee) = self.library.callee(&path, self.against) else { return Called::Unknown };
        // This program calls that one: if that one leads here, they are in one circle.
        let circle = self.library.circle(&path, self.against);
        let round = circle.is_some() && circle == self.library.circle(&self.path, self.against);
        Called::Is { callee, round }
    }

    fn lacks_file(&self, name: &str) -> Option<Severity> {
        let (_, extension) = name.rsplit_once('.')?;
        self.asked.store(true, Ordering::Relaxed);
        let Found::Missing = self.library.file(&self.path, name) else { return None };
        let folder = self.library.folder(self.path.parent()?)?;
        // Where there is no table of that kind, they are kept elsewhere.
        folder.has_extension(extension).then_some(if self.whole { Severity::Warning } else { Severity::Note })
    }

    fn has_tool(&self, tool: ToolName<'_>) -> Option<bool> {
        let mut tables = self.tables(TableKind::Tool).peekable();
        tables.peek()?;
        let mut tables = tables.chain(self.tables(TableKind::Turning));
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
        let (table, row) = self.tool_row(TableKind::Tool, tool)?;
        table.number(row, column).ok()?
    }

    fn tool_word(&self, tool: ToolName<'_>, column: &str) -> Option<&str> {
        let (table, row) = self.tool_row(TableKind::Tool, tool)?;
        table.text(row, column).ok().map(str::trim).filter(|word| !word.is_empty())
    }

    fn turning_type(&self, tool: ToolName<'_>) -> Option<&str> {
        let (table, row) = self.tool_row(TableKind::Turning, tool)?;
        table.text(row, "TYPE").ok().map(str::trim).filter(|word| !word.is_empty())
    }

    fn turning_value(&self, tool: ToolName<'_>, column: &str) -> Option<f64> {
        let (table, row) = self.tool_row(TableKind::Turning, tool)?;
        table.number(row, column).ok()?
    }

    fn machine(&self) -> Option<&Machine> {
        Some(self.machine).filter(|machine| machine.is_known())
    }

    fn observed(&self, program: &Program) -> Vec<Observed> {
        let Some(files) = self.files else { return Vec::new() };
        let mut tables = self.tables(TableKind::Tool);
        let tools = tables.next().filter(|_| tables.next().is_none());
        let Against { on, catalogue, .. } = *self.against;
        let text = program.source().text();
        let beside = |scene: &mut Scene| {
            // A table that cannot be read is reported where it is checked.
            let _ = execution::selected(&self.path, text, scene);
            if !(scene.datums.is_empty() && scene.points.is_empty() && scene.free_tables.is_empty()) {
                self.asked.store(true, Ordering::Relaxed);
            }
        };
        let neighbours = Neighbours::new(&self.path, catalogue);
        // That other files count is known since the calls were looked up.
        let programs = Some(&neighbours as &dyn Programs);
        Rehearsal { on, catalogue, files, tools, programs }.observed(program, &beside)
    }

    fn knows_rows(&self) -> bool {
        true
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
            [] => self.table_beside(kind, name?).map(|table| table.has_row(row)),
            _ => None,
        }
    }
}
