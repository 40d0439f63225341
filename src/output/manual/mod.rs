//! The manual as a static site, and the same pages as books: a page a cycle for every control and language, topics,
//! notes for many cycles, worked programs, lists, comparisons, a search, dialog bundles and label tables. No network is
//! needed to read it, and scripts only help: to search, copy and filter.
//!
//! Invariant: a pure function from specifications, locales and templates to paths and bytes; the
//! same input gives the same bytes, whatever thread makes a page. Who writes files is not known here.
mod book;
mod compare;
mod cycle;
mod defined;
mod edition;
mod escape;
pub mod for_control;
pub mod highlight;
mod index;
mod inline;
mod links;
mod lists;
mod notes;
mod overview;
mod page;
#[cfg(feature = "pdf")]
mod print;
mod programs;
pub mod search;
mod site;
mod stem;
mod topic;
mod translation_state;
mod view;

use std::collections::{BTreeMap, BTreeSet};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Mutex, OnceLock};

use minijinja::syntax::SyntaxConfig;
use minijinja::{Environment, UndefinedBehavior};
use serde::Serialize;

use crate::base::diag::Diagnostic;
use crate::base::parallel;
use crate::check::LabelBook;
use crate::language::label;
use crate::language::locale::{Args, Language, Locales};
use crate::output::dialog;
use crate::output::export;
use crate::spec::{Catalogue, OnControl};

use edition::Edition;
use search::Found;
use site::{Figures, template_fault};

pub use book::Book;
pub use edition::{path_of_cycle, path_of_topic};
pub use site::Site;

/// What a site is made from.
#[derive(Clone, Copy)]
pub struct Request<'a> {
    /// The specifications.
    pub catalogue: &'a Catalogue,
    /// The languages.
    pub locales: &'a Locales,
    /// All data files; templates and assets are those below `templates/`.
    pub files: &'a [(String, String)],
    /// The ids of the controls; all of them if there is none.
    pub controls: &'a [String],
    /// The tags of the languages; all of them if there is none.
    pub languages: &'a [String],
    /// The address that the site will have, such as `https://example.org/manual/`, if it is known.
    pub base_url: Option<&'a str>,
}

/// Takes each file of the site, as its path below the output directory and its bytes. It is called from
/// several threads, in no particular order.
pub type Sink<'s> = dyn Fn(&str, &[u8]) -> Result<(), Diagnostic> + Sync + 's;

type Put<'p> = dyn Fn(&str, &[u8]) -> Result<(), Vec<Diagnostic>> + Sync + 'p;

/// What was built.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Built {
    /// Pages.
    pub pages: usize,
    /// Files, pages included.
    pub files: usize,
}

/// One file to make.
#[derive(Clone, Copy)]
enum Job {
    Index,
    Missing,
    Overview(usize),
    Parameters(usize),
    Keywords(usize),
    Glossary(usize),
    Notes(usize),
    Programs(usize),
    Search(usize),
    Topic(usize, usize),
    Comparison(usize),
    Cycle(usize, usize),
    Dialogs(usize),
    Labels(usize),
    Export(usize),
}

/// Builds a whole site.
///
/// # Errors
/// Everything that is missing or wrong, in a stable order; what was handed to the sink until then is
/// of no use.
pub fn build(request: &Request, sink: &Sink) -> Result<Built, Vec<Diagnostic>> {
    Site::new(request)?.write(sink)
}

impl<'a> Site<'a> {
    /// Prepares templates, contents and words.
    ///
    /// # Errors
    /// Controls and languages that do not exist, templates that cannot be read, names that are missing.
    pub fn new(request: &Request<'a>) -> Result<Self, Vec<Diagnostic>> {
        let templates = environment(request.files).map_err(|found| vec![found])?;
        let pairs = pairs(request)?;
        let source = request.locales.source();
        let controls = request.catalogue.controls.values();
        let all: BTreeMap<&str, &str> = controls.map(|on| (on.id(), on.control.title.as_str())).collect();
        let made = Mutex::new(Vec::new());
        let faults = in_parallel(pairs.len(), &|at| {
            let Some((on, language)) = pairs.get(at) else { return Ok(()) };
            let edition = Edition::new(&request.catalogue.topics, on, language, source, &all)?;
            lock(&made).push((at, edition));
            Ok(())
        });
        if !faults.is_empty() {
            return Err(faults);
        }
        let mut editions = made.into_inner().unwrap_or_else(std::sync::PoisonError::into_inner);
        editions.sort_by_key(|(at, _)| *at);
        let assets = request.files.iter().filter_map(|(path, text)| {
            Some((path.strip_prefix("templates/").filter(|path| path.starts_with("assets/"))?, text.as_str()))
        });
        let editions: Vec<Edition> = editions.into_iter().map(|(_, edition)| edition).collect();
        let comparisons = compare::all(&editions);
        let mut labels = BTreeMap::new();
        for edition in &editions {
            labels.entry(edition.on.id()).or_insert_with(|| LabelBook::new(edition.on, request.locales));
        }
        Ok(Self {
            editions,
            comparisons,
            source,
            catalogue: request.catalogue,
            locales: request.locales,
            labels,
            templates,
            endless: OnceLock::new(),
            base_url: request.base_url.map(|base| format!("{}/", base.trim_end_matches('/'))),
            assets: assets.collect(),
            figures: Figures::new(request.catalogue.controls.values(), request.files),
            is_book: false,
            is_draft: false,
            is_served: false,
        })
    }

    fn jobs(&self) -> Vec<Job> {
        let mut jobs = vec![Job::Index, Job::Missing];
        for (at, edition) in self.editions.iter().enumerate() {
            jobs.extend([
                Job::Overview(at),
                Job::Parameters(at),
                Job::Keywords(at),
                Job::Glossary(at),
                Job::Notes(at),
                Job::Search(at),
            ]);
            if !edition.on.worked.is_empty() {
                jobs.push(Job::Programs(at));
            }
            jobs.extend([Job::Dialogs(at), Job::Labels(at), Job::Export(at)]);
            jobs.extend((0..edition.entries.len()).map(|entry| Job::Cycle(at, entry)));
            jobs.extend((0..edition.topics.len()).map(|topic| Job::Topic(at, topic)));
        }
        jobs.extend((0..self.comparisons.len()).map(Job::Comparison));
        jobs
    }

    /// How many pages the site has.
    pub fn pages(&self) -> usize {
        self.jobs().iter().filter(|job| !matches!(job, Job::Dialogs(_) | Job::Labels(_) | Job::Export(_))).count()
    }

    /// Makes every file and hands it to the sink.
    ///
    /// # Errors
    /// Every text that is missing, every mistake of a template, and what the sink reports.
    pub fn write(&self, sink: &Sink) -> Result<Built, Vec<Diagnostic>> {
        let jobs = self.jobs();
        let files = AtomicUsize::new(0);
        let paths = Mutex::new(BTreeSet::new());
        let put = |path: &str, bytes: &[u8]| {
            files.fetch_add(1, Ordering::Relaxed);
            if path.ends_with(".html") && path != index::MISSING {
                lock(&paths).insert(path.to_owned());
            }
            sink(path, bytes).map_err(|found| vec![found])
        };
        for (path, text) in self.assets.iter().filter(|(path, _)| *path != book::STYLE) {
            put(path, text.as_bytes())?;
        }
        let found = Mutex::new(Vec::new());
        let collect = |edition: usize, order: usize, page: Found| lock(&found).push((edition, order, page));
        let faults = in_parallel(jobs.len(), &|at| jobs.get(at).map_or(Ok(()), |job| self.make(*job, &put, &collect)));
        if !faults.is_empty() {
            return Err(faults);
        }
        let mut found = found.into_inner().unwrap_or_else(std::sync::PoisonError::into_inner);
        found.sort_by_key(|(edition, order, _)| (*edition, *order));
        self.write_search(found, &put)?;
        if let Some(sitemap) = self.sitemap(&lock(&paths).clone()) {
            put("sitemap.xml", sitemap.as_bytes())?;
        }
        Ok(Built { pages: self.pages(), files: files.into_inner() })
    }

    /// The index of the search in each language; `found` are the pages in the order of the editions.
    fn write_search(&self, found: Vec<(usize, usize, Found)>, put: &Put<'_>) -> Result<(), Vec<Diagnostic>> {
        let mut controls: Vec<&OnControl> = Vec::new();
        let mut by_language: BTreeMap<&str, (&Language, Vec<(usize, Vec<Found>)>)> = BTreeMap::new();
        let mut found = found.into_iter().peekable();
        for (at, edition) in self.editions.iter().enumerate() {
            if !controls.iter().any(|on| on.id() == edition.on.id()) {
                controls.push(edition.on);
            }
            let mut own = Vec::new();
            while let Some((_, _, page)) = found.next_if(|(edition, _, _)| *edition == at) {
                own.push(page);
            }
            let (_, pages) =
                by_language.entry(edition.language.tag()).or_insert_with(|| (edition.language, Vec::new()));
            pages.push((controls.len() - 1, own));
        }
        let names: Vec<(&str, &str)> = controls.iter().map(|on| (on.id(), on.control.title.as_str())).collect();
        let languages: Vec<_> = by_language.into_iter().collect();
        let faults = in_parallel(languages.len(), &|at| {
            let Some((tag, (language, pages))) = languages.get(at) else { return Ok(()) };
            put(&search::index_file(tag), search::index(language, names.clone(), pages)?.as_bytes())
        });
        if faults.is_empty() { Ok(()) } else { Err(faults) }
    }

    fn make(&self, job: Job, put: &Put, collect: &dyn Fn(usize, usize, Found)) -> Result<(), Vec<Diagnostic>> {
        match job {
            Job::Index => put("index.html", index::page(self)?.as_bytes()),
            Job::Missing => put(index::MISSING, index::missing(self)?.as_bytes()),
            Job::Overview(at) => {
                let edition = &self.editions[at];
                put(&edition.path("index.html"), overview::page(self, edition)?.as_bytes())
            }
            Job::Parameters(at) => {
                let edition = &self.editions[at];
                put(&edition.path(edition::PARAMETERS), lists::parameters(self, edition)?.as_bytes())
            }
            Job::Keywords(at) => {
                let edition = &self.editions[at];
                put(&edition.path(lists::KEYWORDS), lists::keywords(self, edition)?.as_bytes())
            }
            Job::Glossary(at) => {
                let edition = &self.editions[at];
                for (order, term) in lists::terms(edition)?.into_iter().enumerate() {
                    let file = format!("{}#{}", edition::GLOSSARY, term.id);
                    let sentences = search::sentences(&format!("<main><p>{}</p></main>", term.definition));
                    collect(
                        at,
                        order + edition.entries.len() + edition.topics.len() + 1,
                        Found { file, title: term.term, sentences },
                    );
                }
                put(&edition.path(edition::GLOSSARY), lists::glossary(self, edition)?.as_bytes())
            }
            Job::Notes(at) => {
                let edition = &self.editions[at];
                let html = notes::page(self, edition)?;
                let title = edition.text("site-general-notes", &Args::new())?.into_owned();
                let order = edition.entries.len() + edition.topics.len();
                collect(at, order, Found { file: notes::PAGE.to_owned(), title, sentences: search::sentences(&html) });
                put(&edition.path(notes::PAGE), html.as_bytes())
            }
            Job::Programs(at) => {
                let edition = &self.editions[at];
                let html = programs::page(self, edition)?;
                let title = edition.text("site-worked-programs", &Args::new())?.into_owned();
                // After the terms of the glossary.
                let found = Found { file: programs::PAGE.to_owned(), title, sentences: search::sentences(&html) };
                collect(at, usize::MAX, found);
                put(&edition.path(programs::PAGE), html.as_bytes())
            }
            Job::Search(at) => {
                let edition = &self.editions[at];
                put(&edition.path(search::PAGE), search::page(self, edition)?.as_bytes())
            }
            Job::Topic(at, topic) => {
                let edition = &self.editions[at];
                let html = topic::page(self, edition, topic)?;
                let own = &edition.topics[topic];
                let sentences = search::sentences(&html);
                collect(
                    at,
                    edition.entries.len() + topic,
                    Found { file: own.file.clone(), title: own.title.clone(), sentences },
                );
                put(&edition.path(&own.file), html.as_bytes())
            }
            Job::Comparison(at) => {
                let comparison = &self.comparisons[at];
                put(&comparison.path, compare::page(self, comparison)?.as_bytes())
            }
            Job::Cycle(at, entry) => {
                let edition = &self.editions[at];
                let own = &edition.entries[entry];
                let html = cycle::page(self, edition, entry)?;
                let title = format!("{} {}", own.cycle.key, own.name);
                collect(at, entry, Found { file: own.file.clone(), title, sentences: search::sentences(&html) });
                put(&edition.path(&own.file), html.as_bytes())
            }
            Job::Dialogs(at) => {
                let edition = &self.editions[at];
                put(&edition.path("dialogs.json"), &json(&dialog::bundle(edition.on, edition.language)?)?)
            }
            Job::Labels(at) => {
                let edition = &self.editions[at];
                let rows = label::table(edition.on, edition.language)?;
                put(&edition.path("labels.json"), &json(&rows)?)?;
                put(&edition.path("labels.csv"), label::csv(&rows).as_bytes())
            }
            Job::Export(at) => {
                let edition = &self.editions[at];
                put(&edition.path("export.json"), &json(&export::export(edition.on, edition.language)?)?)
            }
        }
    }
}

fn json(value: &impl Serialize) -> Result<Vec<u8>, Vec<Diagnostic>> {
    let mut bytes = serde_json::to_vec_pretty(value)
        .map_err(|error| vec![Diagnostic::global("manual-json").arg("reason", error.to_string())])?;
    bytes.push(b'\n');
    Ok(bytes)
}

/// How many instructions of a template a page may take: a hundred times what the longest page needs. A template of a
/// working copy may loop without end.
const FUEL: u64 = 50_000_000;

fn environment(files: &[(String, String)]) -> Result<Environment<'_>, Diagnostic> {
    let mut templates = Environment::new();
    templates.set_fuel(Some(FUEL));
    templates.set_undefined_behavior(UndefinedBehavior::Strict);
    let syntax = SyntaxConfig::builder().trim_blocks(true).lstrip_blocks(true).keep_trailing_newline(true).build();
    templates.set_syntax(syntax.map_err(|error| template_fault("", &error))?);
    for (path, text) in files {
        let Some(name) = path.strip_prefix("templates/").filter(|name| name.ends_with(".html")) else { continue };
        templates.add_template(name, text).map_err(|error| template_fault(name, &error))?;
    }
    Ok(templates)
}

type Pair<'a> = (&'a OnControl, &'a Language);

fn pairs<'a>(request: &Request<'a>) -> Result<Vec<Pair<'a>>, Vec<Diagnostic>> {
    let mut faults = Vec::new();
    for id in request.controls.iter().filter(|id| request.catalogue.on(id).is_none()) {
        let known: Vec<String> = request.catalogue.controls.values().map(|on| on.control.names()).collect();
        faults.push(Diagnostic::global("unknown-control").arg("control", id.as_str()).arg("known", known.join(", ")));
    }
    for tag in request.languages {
        faults.extend(request.locales.language(tag).err().map(Diagnostic::from));
    }
    if !faults.is_empty() {
        return Err(faults);
    }
    let wanted = |list: &[String], id: &str| list.is_empty() || list.iter().any(|own| own == id);
    let mut pairs = Vec::new();
    for on in request.catalogue.controls.values().filter(|on| wanted(request.controls, on.id())) {
        let languages = request.locales.iter().filter(|language| wanted(request.languages, language.tag()));
        pairs.extend(languages.map(|language| (on, language)));
    }
    Ok(pairs)
}

/// Runs numbered jobs on all processors and gives what went wrong, sorted and once each.
fn in_parallel(jobs: usize, run: &(dyn Fn(usize) -> Result<(), Vec<Diagnostic>> + Sync)) -> Vec<Diagnostic> {
    let numbers: Vec<usize> = (0..jobs).collect();
    let results = parallel::map(&numbers, |at| run(*at));
    let mut faults: Vec<Diagnostic> = results.into_iter().filter_map(Result::err).flatten().collect();
    let key = |fault: &Diagnostic| {
        let place = fault.place.as_ref().map(|place| (place.source.name().to_owned(), place.span));
        let args = fault.args.iter().filter(|(name, _)| !["cycle", "control"].contains(name));
        (fault.code, place, args.map(|(name, value)| format!("{name}={value:?}")).collect::<String>())
    };
    faults.sort_by_cached_key(key);
    faults.dedup_by_key(|fault| key(fault));
    faults
}

/// A lock that a panic elsewhere left still guards a whole list.
fn lock<T>(mutex: &Mutex<T>) -> std::sync::MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(std::sync::PoisonError::into_inner)
}
