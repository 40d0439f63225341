//! `ciklo check`: what a control would object to in programs.
use std::collections::BTreeMap;

use clap::ArgMatches;

use super::cache::{self, Cache};
use super::dry_run::DryRun;
use super::jobs::{Job, Jobs, jobs};
use super::program::Understood;
use super::progress::Progress;
use super::project::{CheckedProgram, Library, Tables};
use super::session::Session;
use super::{Command, Failure, Outcome, annotations, arguments, mend, program};
use crate::base::data::Files;
use crate::base::diag::{Diagnostic, Place, Severity};
use crate::base::parallel;
use crate::check::{self, Against, LabelBook};
use crate::language::locale::{Args, Language, Ui};
use crate::program::table::{self, TableKind};
use crate::system;

pub(super) const COMMAND: Command = Command {
    name: "check",
    usage: "PATH… [--control CONTROL] [--lang LANG] [--config FILE] [--table FILE]… [--fail-on LEVEL] [--fix] \
            [--no-cache] [--no-execution] [--format FORMAT]",
    arguments: own,
    run,
};

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
        arguments::switch(ui, "no-execution", "cli-check-no-execution"),
        arguments::format(ui, &["text", "json", "sarif", "github"]).help(ui.text("cli-check-format", &Args::new())),
    ]
}

/// What came of one file.
struct Checked {
    found: Vec<Diagnostic>,
    /// How many fixes were made.
    fixed: usize,
    /// Whether something is bad enough to fail.
    fails: bool,
}

/// What the checks of all files share.
struct Shared<'s> {
    library: &'s Library,
    tables: &'s Tables,
    cache: Option<&'s Cache>,
    /// The files of machines, unless programs shall not be executed.
    files: Option<&'s Files>,
    fix: bool,
    fail_on: Option<Severity>,
    /// How programs are executed whose tools are known.
    dry_run: Option<DryRun<'s>>,
}

fn run(session: &mut Session, matches: &ArgMatches) -> Result<Outcome, Failure> {
    let (catalogue, locales) = (session.catalogue()?, session.locales()?);
    let readers: Vec<&Language> =
        [locales.language(session.ui.tag()).ok(), locales.source()].into_iter().flatten().collect();
    let Jobs { jobs, empty, mut troubles, tables: named } = jobs(session, matches, &catalogue, &locales)?;
    let fix = matches.get_flag("fix");
    // Other data than that of this program gives other findings.
    let cached = jobs.len() >= cache::LEAST && !fix && !matches.get_flag("no-cache") && session.data().is_none();
    let cache = if cached { Cache::open(session.ui.tag()) } else { None };
    let library = Library::new(jobs.iter().map(|job| job.path.clone()).collect());
    let tables = tables(matches, &jobs, &named)?;
    let fail_on = arguments::chosen_fail_on(matches);
    let executed = !matches.get_flag("no-execution");
    let files = executed.then(|| session.engine_files()).transpose()?;
    let files = files.as_deref();
    // What is left of the part is only followed where the tools are known.
    let dry_run = files.filter(|_| !tables.is_empty()).map(|files| DryRun { files, locales: &locales });
    let shared = Shared { library: &library, tables: &tables, cache: cache.as_ref(), files, fix, fail_on, dry_run };
    let progress = Progress::new(session.ui.text("cli-checking", &Args::new()), jobs.len());
    let results = all(&jobs, &progress, |job, books| {
        let labels = books.entry(job.on.id().to_owned()).or_insert_with(|| LabelBook::new(job.on, &locales));
        let language = job.settings.language.as_deref();
        shared.check(
            job,
            &Against {
                catalogue: &catalogue,
                on: job.on,
                labels,
                language,
                software: job.software.as_deref(),
                readers: &readers,
            },
        )
    });
    drop(progress);
    if let Some(cache) = cache {
        cache.close();
    }
    let mut all = Checked { fails: !empty.is_empty(), found: empty, fixed: 0 };
    all.fails |= !tables.found().is_empty();
    all.found.extend(tables.found().iter().cloned());
    let mut wrong = 0;
    for result in results {
        match result {
            Ok(own) => {
                all.fails |= own.fails;
                all.fixed += own.fixed;
                wrong += usize::from(own.found.iter().any(|diagnostic| diagnostic.severity == Severity::Error));
                all.found.extend(own.found);
            }
            // The other files are checked all the same.
            Err(Failure::Trouble(trouble)) => troubles.push(*trouble),
            Err(failure) => return Err(failure),
        }
    }
    // Nothing was found only where everything could be read.
    let silent = all.found.is_empty() && !troubles.is_empty();
    let format = arguments::chosen_format(matches);
    match format {
        "sarif" => annotations::sarif(session, all.found)?,
        "github" => annotations::github(session, all.found)?,
        _ if silent => {}
        _ => session.report(all.found, format)?,
    }
    if matches!(format, "text" | "github") {
        if fix {
            let line = session.ui.text("cli-fixed", &Args::new().number("count", all.fixed as f64));
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
        None => Ok(if all.fails { Outcome::Errors } else { Outcome::Clean }),
    }
}

/// The tables that arguments and configuration files name; a mistake is reported where the table is named.
fn tables(matches: &ArgMatches, jobs: &[Job<'_>], named: &BTreeMap<String, Place>) -> Result<Tables, Failure> {
    let mut tables = Tables::new(&arguments::all(matches, "table"))?;
    for table in jobs.iter().flat_map(|job| &job.settings.tables) {
        tables.add(std::slice::from_ref(table)).map_err(|failure| match failure {
            Failure::Trouble(mut trouble) => {
                trouble.place = named.get(table).cloned();
                Failure::Trouble(trouble)
            }
            failure => failure,
        })?;
    }
    Ok(tables)
}

impl Shared<'_> {
    /// Checks a file: a table, or a program, which is fixed first if that is wanted.
    fn check(&self, job: &Job<'_>, against: &Against<'_>) -> Result<Checked, Failure> {
        let (mut found, fixed) = match table(job)? {
            Some(found) => (found, 0),
            None => {
                let program = CheckedProgram::new(self.library, self.tables, job, against, self.files);
                if self.fix {
                    let (file, mut found, fixed) = mend::file(&job.path, against, &program, &job.settings)?;
                    self.execute(&file, job, &program, &mut found);
                    (found, fixed)
                } else {
                    (self.program(job, &program)?, 0)
                }
            }
        };
        job.settings.apply(&mut found);
        let least = self.fail_on.or(job.settings.fail_on).unwrap_or(Severity::Error);
        let fails = found.iter().any(|diagnostic| diagnostic.severity >= least);
        Ok(Checked { found, fixed, fails })
    }

    /// What is found in a program, now or when it was checked before.
    fn program(&self, job: &Job<'_>, program: &CheckedProgram<'_>) -> Result<Vec<Diagnostic>, Failure> {
        let against = program.against();
        let bytes = system::read(&job.path)?;
        // What was found without tables and limits of the machine says nothing of a check with them.
        let cache = self.cache.filter(|_| !program.has_more());
        let control = format!("{}@{}", job.on.id(), job.software.as_deref().unwrap_or_default());
        let known = cache.map(|cache| (cache, cache.key(&job.path, &bytes, &control, against.language)));
        if let Some(found) = known.and_then(|(cache, key)| cache.find(key, || program::source_of(&job.path, &bytes))) {
            return Ok(found);
        }
        let file = program::understood_bytes(&job.path, bytes, against.catalogue);
        let mut found = file.findings(check::check_in(&file.program, against, program));
        self.execute(&file, job, program, &mut found);
        // What depends on other files is not remembered.
        if let Some((cache, key)) = known.filter(|_| !program.asked()) {
            cache.keep(key, &found);
        }
        Ok(found)
    }

    /// Adds what the execution of a program shows, where it is executed.
    fn execute(&self, file: &Understood, job: &Job<'_>, program: &CheckedProgram<'_>, found: &mut Vec<Diagnostic>) {
        if let Some(dry_run) = &self.dry_run {
            dry_run.check(file, &job.path, program, found);
        }
    }
}

/// What is found in a file that is a table; nothing if it is none.
fn table(job: &Job<'_>) -> Result<Option<Vec<Diagnostic>>, Failure> {
    if let Some(kind) = TableKind::of_file(&job.path.to_string_lossy()) {
        let file = program::source(&job.path)?;
        let other = !job.named && !program::is_table(&file);
        return Ok(Some(if other { Vec::new() } else { table::check(kind, &file.source) }));
    }
    let other = if job.named { program::other_table(&job.path)? } else { None };
    Ok(other.map(|other| table::check_other(&other)))
}

/// Carries out all jobs on all cores; what comes of them is in their order.
fn all<'l>(
    jobs: &[Job<'l>],
    progress: &Progress,
    work: impl Fn(&Job<'l>, &mut BTreeMap<String, LabelBook<'l>>) -> Result<Checked, Failure> + Sync,
) -> Vec<Result<Checked, Failure>> {
    parallel::map_with(jobs, BTreeMap::new, |books, job| {
        let result = work(job, books);
        progress.step();
        result
    })
}
