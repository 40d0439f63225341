//! The programs that a check is asked for, each with its control and the settings of the configuration file near it.
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use clap::ArgMatches;

use super::program::{PROGRAMS, TABLES};
use super::session::Session;
use super::{Failure, arguments, cycle};
use crate::base::diag::{Diagnostic, Place, Source};
use crate::check::{Config, Settings};
use crate::language::locale::{Locales, Scope};
use crate::spec::{Catalogue, OnControl};
use crate::system::{self, Below};

/// The file with settings, looked for in the folder of each program and above it.
const CONFIG: &str = "ciklo.toml";

/// A program to check.
pub(super) struct Job<'c> {
    pub(super) path: PathBuf,
    pub(super) on: &'c OnControl,
    /// The software version of the control, if it is known.
    pub(super) software: Option<String>,
    pub(super) settings: Settings,
    /// Whether it is named itself, not found in a folder.
    pub(super) named: bool,
}

/// The programs that are meant.
pub(super) struct Jobs<'c> {
    /// Each with its control and settings.
    pub(super) jobs: Vec<Job<'c>>,
    /// What says that a folder has none.
    pub(super) empty: Vec<Diagnostic>,
    /// What could not be found.
    pub(super) troubles: Vec<Diagnostic>,
    /// Where tables are named.
    pub(super) tables: BTreeMap<String, Place>,
}

/// What says that nothing was checked of what a name stands for.
pub(super) fn no_programs(name: &str) -> Diagnostic {
    Diagnostic::global("check-no-programs").arg("path", name)
}

/// The jobs that arguments and configuration files ask for.
pub(super) fn jobs<'c>(
    session: &mut Session,
    matches: &ArgMatches,
    catalogue: &'c Catalogue,
    locales: &Locales,
) -> Result<Jobs<'c>, Failure> {
    let asked = matches.get_one::<String>("control");
    let asked = asked.map(|id| cycle::control_and_software(catalogue, id)).transpose()?;
    let language = matches.get_one::<String>("lang").map(|tag| cycle::language(locales, tag)).transpose()?;
    let mut configs = Configs {
        given: matches.get_one::<String>("config").map(PathBuf::from),
        near: BTreeMap::new(),
        read: BTreeMap::new(),
        tables: BTreeMap::new(),
    };
    let (mut jobs, mut empty, mut troubles) = (Vec::new(), Vec::new(), Vec::new());
    for name in arguments::all(matches, "file") {
        // What is mended is only what lies in the folder.
        let links = !matches.get_flag("fix");
        let Below { files: paths, troubles: hidden, passed_over: over } =
            system::files_below(Path::new(&name), &[&PROGRAMS[..], &TABLES[..]].concat(), links);
        session.passed_over(&over);
        if paths.is_empty() && hidden.is_empty() {
            empty.push(no_programs(&name));
        }
        troubles.extend(hidden.into_iter().map(Diagnostic::from));
        let single = paths == [PathBuf::from(&name)];
        for path in paths {
            let mut settings = configs.of(&path, session, catalogue, locales)?;
            settings.language = language.map(|own| own.tag().to_owned()).or(settings.language);
            let named = settings.control.as_deref();
            let named = named.and_then(|id| cycle::control_and_software(catalogue, id).ok());
            match asked.clone().or(named) {
                Some((on, software)) => jobs.push(Job { path, on, software, settings, named: single }),
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
    let controls = |id: &str| cycle::control_and_software(catalogue, id).is_ok();
    let languages = |tag: &str| locales.language(tag).is_ok();
    Config::parse(&Source::new(name, text), &rules, &controls, &languages).map_err(Failure::Data)
}
