//! `ciklo check`: what a control would object to in programs.
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Mutex, PoisonError};

use clap::ArgMatches;

use super::cache::{self, Cache};
use super::progress::Progress;
use super::project::{Library, Shelf, Standing};
use super::session::Session;
use super::{Command, Failure, Outcome, annotations, arguments, cycle, mend, program};
use crate::base::diag::{Diagnostic, Place, Severity, Source};
use crate::base::parallel::together;
use crate::check::{self, Against, Config, LabelBook, Settings};
use crate::language::locale::{Args, Language, Locales, Scope, Ui};
use crate::program::table::{self, TableKind};
use crate::spec::{Catalogue, OnControl};
use crate::system;

pub(super) const COMMAND: Command = Command {
    name: "check",
    usage: "PATH… [--control CONTROL] [--lang LANG] [--config FILE] [--table FILE]… [--fail-on LEVEL] [--fix] \
            [--no-cache] [--format FORMAT]",
    arguments: own,
    run,
};

/// Extensions of the programs that are looked for in folders.
pub(super) const PROGRAMS: [&str; 2] = ["h", "i"];
/// Extensions of the tables that are looked for in folders.
pub(super) const TABLES: [&str; 5] = ["t", "tp", "pr", "d", "pnt"];
/// The file with settings, looked for in the folder of each program and above it.
const CONFIG: &str = "ciklo.toml";

fn own(ui: &Ui) -> Vec<clap::Arg> {
    vec![
        arguments::words(ui, "file", "PATH", "cli-check-path"),
        arguments::valued(ui, "control", "CONTROL", "cli-check-control"),
        arguments::valued(ui, "lang", "LANG", "cli-check-lang"),
        arguments::valued(ui, "config", "FILE", "cli-check-config"),
        arguments::several(ui, "table", "FILE", "cli-check-table"),
        arguments::fail_on(ui),
        arguments::switch(ui, "fix", "cli-check-fix"),
        arguments::switch(ui, "no-cache", "cli-check-no-cache"),
        arguments::format(ui, &["text", "json", "sarif", "github"]).help(ui.text("cli-check-format", &Args::new())),
    ]
}

/// A program to check.
pub(super) struct Job<'c> {
    pub(super) path: PathBuf,
    pub(super) on: &'c OnControl,
    pub(super) settings: Settings,
    /// Whether it is named itself, not found in a folder.
    pub(super) named: bool,
}

/// What came of it.
type Checked = Result<(Vec<Diagnostic>, usize, bool), Failure>;

fn run(session: &mut Session, matches: &ArgMatches) -> Result<Outcome, Failure> {
    let (catalogue, locales) = (session.catalogue()?, session.locales()?);
    let readers: Vec<&Language> =
        [locales.language(session.ui.tag()).ok(), locales.source()].into_iter().flatten().collect();
    let Jobs { jobs, empty, mut troubles, tables: named } = jobs(session, matches, &catalogue, &locales)?;
    let (fix, fail_on) = (matches.get_flag("fix"), arguments::chosen_fail_on(matches));
    // Other data than that of this program gives other findings.
    let cached = jobs.len() >= cache::LEAST && !fix && !matches.get_flag("no-cache") && session.data().is_none();
    let cache = if cached { Cache::open(session.ui.tag()) } else { None };
    let library = Library::new(jobs.iter().map(|job| job.path.clone()).collect());
    let mut tables = Shelf::new(&arguments::all(matches, "table"))?;
    for table in jobs.iter().flat_map(|job| &job.settings.tables) {
        tables.add(std::slice::from_ref(table)).map_err(|failure| match failure {
            Failure::Trouble(mut trouble) => {
                trouble.place = named.get(table).cloned();
                Failure::Trouble(trouble)
            }
            failure => failure,
        })?;
    }
    let progress = Progress::new(session.ui.text("cli-checking", &Args::new()), jobs.len());
    let results = all(&jobs, &progress, |job, books| {
        let labels = books.entry(job.on.id().to_owned()).or_insert_with(|| LabelBook::new(job.on, &locales));
        let language = job.settings.language.as_deref();
        let against = Against { catalogue: &catalogue, on: job.on, labels, language, readers: &readers };
        let table = TableKind::of_file(&job.path.to_string_lossy());
        let (mut found, fixed) = if let Some(kind) = table {
            let file = program::source(&job.path)?;
            let other = !job.named && !program::is_table(&file);
            (if other { Vec::new() } else { table::check(kind, &file.source) }, 0)
        } else if let Some(other) = if job.named { program::other_table(&job.path)? } else { None } {
            (table::check_other(&other), 0)
        } else if fix {
            let place = Standing::new(&library, &tables, job, &against);
            mend::file(&job.path, &against, &place, &job.settings)?
        } else {
            let place = Standing::new(&library, &tables, job, &against);
            (found_in(job, &catalogue, &place, cache.as_ref())?, 0)
        };
        job.settings.apply(&mut found);
        let least = fail_on.or(job.settings.fail_on).unwrap_or(Severity::Error);
        let fails = found.iter().any(|diagnostic| diagnostic.severity >= least);
        Ok((found, fixed, fails))
    });
    drop(progress);
    if let Some(cache) = cache {
        cache.close();
    }
    let mut fails = !empty.is_empty();
    let (mut found, mut fixed, mut wrong) = (empty, 0, 0);
    for result in results {
        match result {
            Ok((own, mended, failed)) => {
                fails |= failed;
                fixed += mended;
                wrong += usize::from(own.iter().any(|diagnostic| diagnostic.severity == Severity::Error));
                found.extend(own);
            }
            // The other files are checked all the same.
            Err(Failure::Trouble(trouble)) => troubles.push(*trouble),
            Err(failure) => return Err(failure),
        }
    }
    let troubled = !troubles.is_empty();
    // Nothing was found only where everything could be read.
    let silent = found.is_empty() && troubled;
    let format = arguments::chosen_format(matches);
    match format {
        "sarif" => annotations::sarif(session, found)?,
        "github" => annotations::github(session, found)?,
        _ if silent => {}
        _ => session.report(found, format)?,
    }
    if matches!(format, "text" | "github") {
        if fix {
            let line = session.ui.text("cli-fixed", &Args::new().number("count", fixed as f64));
            session.output.remark(&line);
        }
        if !jobs.is_empty() && !silent {
            let args = Args::new().number("files", jobs.len() as f64).number("wrong", wrong as f64);
            let line = session.ui.text("cli-checked", &args);
            session.output.remark(&line);
        }
    }
    let last = troubles.pop();
    troubles.iter().for_each(|trouble| session.output.complain(trouble, &session.ui));
    match last {
        Some(trouble) => Err(trouble.into()),
        None => Ok(if fails { Outcome::Errors } else { Outcome::Clean }),
    }
}

/// What is found in a program, now or when it was checked before.
fn found_in(
    job: &Job<'_>,
    catalogue: &Catalogue,
    place: &Standing<'_>,
    cache: Option<&Cache>,
) -> Result<Vec<Diagnostic>, Failure> {
    let against = place.against();
    let bytes = system::read(&job.path)?;
    // What was found without tables says nothing of a check with them.
    let cache = cache.filter(|_| !place.has_tables());
    let known = cache.map(|cache| (cache, cache.key(&job.path, &bytes, job.on.id(), against.language)));
    if let Some(found) = known.and_then(|(cache, key)| cache.find(key, || program::source_of(&job.path, &bytes))) {
        return Ok(found);
    }
    let file = program::understood_bytes(&job.path, bytes, catalogue);
    let found = file.findings(check::check_in(&file.program, against, place));
    // What other files say is not remembered.
    if let Some((cache, key)) = known.filter(|_| !place.asked()) {
        cache.keep(key, &found);
    }
    Ok(found)
}

/// The programs that are meant.
struct Jobs<'c> {
    /// Each with its control and settings.
    jobs: Vec<Job<'c>>,
    /// What says that a folder has none.
    empty: Vec<Diagnostic>,
    /// What could not be found.
    troubles: Vec<Diagnostic>,
    /// Where tables are named.
    tables: BTreeMap<String, Place>,
}

/// What says that nothing was checked of what a name stands for.
pub(super) fn no_programs(name: &str) -> Diagnostic {
    Diagnostic::global("check-no-programs").arg("path", name)
}

fn jobs<'c>(
    session: &Session,
    matches: &ArgMatches,
    catalogue: &'c Catalogue,
    locales: &Locales,
) -> Result<Jobs<'c>, Failure> {
    let asked = matches.get_one::<String>("control").map(|id| cycle::control(catalogue, id)).transpose()?;
    let language = matches.get_one::<String>("lang").map(|tag| cycle::language(locales, tag)).transpose()?;
    let mut configs = Configs {
        given: matches.get_one::<String>("config").map(PathBuf::from),
        near: BTreeMap::new(),
        read: BTreeMap::new(),
        tables: BTreeMap::new(),
    };
    let (mut jobs, mut empty, mut troubles) = (Vec::new(), Vec::new(), Vec::new());
    for name in arguments::all(matches, "file") {
        let (paths, hidden) = system::files_below(Path::new(&name), &[&PROGRAMS[..], &TABLES[..]].concat());
        if paths.is_empty() && hidden.is_empty() {
            empty.push(no_programs(&name));
        }
        troubles.extend(hidden.into_iter().map(Diagnostic::from));
        let single = paths == [PathBuf::from(&name)];
        for path in paths {
            let mut settings = configs.of(&path, session, catalogue, locales)?;
            settings.language = language.map(|own| own.tag().to_owned()).or(settings.language);
            let named = settings.control.as_deref().and_then(|id| catalogue.on(id));
            match asked.or(named) {
                Some(on) => jobs.push(Job { path, on, settings, named: single }),
                None => {
                    troubles.push(Diagnostic::global("check-no-control").arg("path", path.display().to_string()));
                    return Ok(Jobs { jobs, empty, troubles, tables: configs.tables });
                }
            }
        }
    }
    Ok(Jobs { jobs, empty, troubles, tables: configs.tables })
}

/// Files with settings, each read once.
struct Configs {
    given: Option<PathBuf>,
    /// The file that is nearest to a folder.
    near: BTreeMap<PathBuf, Option<PathBuf>>,
    read: BTreeMap<PathBuf, Config>,
    /// Where a table was named first.
    tables: BTreeMap<String, Place>,
}

impl Configs {
    fn of(
        &mut self,
        path: &Path,
        session: &Session,
        catalogue: &Catalogue,
        locales: &Locales,
    ) -> Result<Settings, Failure> {
        let folder = match path.parent() {
            Some(folder) if folder != Path::new("") => folder.to_owned(),
            _ => PathBuf::from("."),
        };
        let file = match &self.given {
            Some(given) => Some(given.clone()),
            None => self.near.entry(folder).or_insert_with_key(|folder| system::nearest(folder, CONFIG)).clone(),
        };
        let Some(file) = file else { return Ok(Settings::default()) };
        if !self.read.contains_key(&file) {
            let bytes = if self.given.is_some() { system::read(&file) } else { system::read_file(&file) };
            let config = config(&file, bytes?, session, catalogue, locales)?;
            self.read.insert(file.clone(), config);
        }
        let root = match file.parent() {
            Some(root) if root != Path::new("") => root,
            _ => Path::new("."),
        };
        let Some(config) = self.read.get(&file) else { return Ok(Settings::default()) };
        let mut settings = config.of(&system::seen_from(root, path));
        // Tables are named from the folder of the file.
        for table in &mut settings.tables {
            let place = config.table(table).cloned();
            *table = root.join(&*table).to_string_lossy().into_owned();
            if let Some(place) = place {
                self.tables.entry(table.clone()).or_insert(place);
            }
        }
        Ok(settings)
    }
}

fn config(
    file: &Path,
    bytes: Vec<u8>,
    session: &Session,
    catalogue: &Catalogue,
    locales: &Locales,
) -> Result<Config, Failure> {
    let name = file.display().to_string();
    let text = String::from_utf8(bytes).map_err(|_| Diagnostic::global("data-encoding").arg("path", name.as_str()))?;
    let codes = session.ui.codes("diag-");
    let guard = |code: &str| {
        let key = format!("guard-{code}");
        locales.source().is_some_and(|language| language.has(key.as_str(), &Scope::NONE))
    };
    let rules = |code: &str| codes.contains(&code) || guard(code);
    let controls = |id: &str| catalogue.on(id).is_some();
    let languages = |tag: &str| locales.language(tag).is_ok();
    Config::parse(&Source::new(name, text), &rules, &controls, &languages).map_err(Failure::Data)
}

/// Carries out all jobs on all cores; what comes of them is in their order.
fn all<'l>(
    jobs: &[Job<'l>],
    progress: &Progress,
    work: impl Fn(&Job<'l>, &mut BTreeMap<String, LabelBook<'l>>) -> Checked + Sync,
) -> Vec<Checked> {
    let next = AtomicUsize::new(0);
    let results: Mutex<Vec<Option<Checked>>> = Mutex::new(jobs.iter().map(|_| None).collect());
    together(jobs.len(), || {
        let mut books = BTreeMap::new();
        loop {
            let index = next.fetch_add(1, Ordering::Relaxed);
            let Some(job) = jobs.get(index) else { break };
            let result = work(job, &mut books);
            progress.step();
            let mut all = results.lock().unwrap_or_else(PoisonError::into_inner);
            if let Some(cell) = all.get_mut(index) {
                *cell = Some(result);
            }
        }
    });
    results.into_inner().unwrap_or_else(PoisonError::into_inner).into_iter().flatten().collect()
}
