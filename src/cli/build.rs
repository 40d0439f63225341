//! `ciklo build`: the manuals with their dialogs and labels.
use std::path::Path;
use std::rc::Rc;
use std::sync::Mutex;

use clap::ArgMatches;

use super::progress::Progress;
use super::session::{self, Session};
use super::{Command, Failure, Outcome, arguments, cycle, texts};
use crate::base::data::Files;
use crate::base::diag::Diagnostic;
use crate::language::locale::{Args, Locales, Ui};
use crate::output::manual::{Book, Request, Site};
use crate::spec::Catalogue;
use crate::system::{self, Staged};
use crate::tools::exchange;

pub(super) const COMMAND: Command = Command {
    name: "build",
    usage: "[--out DIR] [--control CONTROL]… [--lang LANG]… [--format FORMAT] [--base-url URL] [--draft]",
    arguments: own,
    run,
};

/// Where the manuals go if nothing is reported.
const OUT: &str = "out";

fn own(ui: &Ui) -> Vec<clap::Arg> {
    vec![
        arguments::valued(ui, "out", "DIR", "cli-build-out"),
        arguments::several(ui, "control", "CONTROL", "cli-build-control"),
        arguments::several(ui, "lang", "LANG", "cli-build-lang"),
        arguments::valued(ui, "format", "FORMAT", "cli-build-format").value_parser(["html", "epub", "pdf"]),
        arguments::valued(ui, "base-url", "URL", "cli-build-base-url"),
        arguments::switch(ui, "draft", "cli-build-draft"),
    ]
}

fn run(session: &mut Session, matches: &ArgMatches) -> Result<Outcome, Failure> {
    let format = matches.get_one::<String>("format").map_or("html", String::as_str);
    if format == "pdf" && !cfg!(feature = "pdf") {
        return Err(Diagnostic::global("pdf-not-built-in").into());
    }
    let data = Data::of(session, matches)?;
    let out = matches.get_one::<String>("out").map_or(OUT, String::as_str);
    let base_url = matches.get_one::<String>("base-url").map(String::as_str);
    if let Some(url) = base_url.filter(|url| !url.starts_with("https://") && !url.starts_with("http://")) {
        return Err(Diagnostic::global("not-an-address").arg("url", url).into());
    }
    let mut site = data.site(base_url)?;
    let locales = &data.locales;
    if format != "html" {
        let books = match format {
            #[cfg(feature = "pdf")]
            "pdf" => site.printed(),
            _ => site.books(),
        };
        return write_books(session, Path::new(out), &books.map_err(session::in_texts(locales))?);
    }
    let staged = Staged::new(Path::new(out))?;
    let progress = Progress::new(session.ui.text("cli-building", &Args::new()), site.pages());
    // A disk that is full is reported once, not for each file that did not fit.
    let trouble: Mutex<Option<Diagnostic>> = Mutex::new(None);
    let built = site.write(&|path, bytes| {
        progress.step();
        staged.write(path, bytes).map_err(|error| {
            let diagnostic = Diagnostic::from(error);
            if let Ok(mut first) = trouble.lock() {
                first.get_or_insert_with(|| diagnostic.clone());
            }
            diagnostic
        })
    });
    drop(progress);
    if let Some(diagnostic) = trouble.into_inner().ok().flatten() {
        return Err(diagnostic.into());
    }
    let built = built.map_err(session::in_texts(locales))?;
    staged.commit()?;
    let index = Path::new(out).join("index.html").display().to_string();
    let args = Args::new().number("pages", built.pages as f64).number("files", built.files as f64);
    let line = session.ui.text("cli-built", &args.text("path", index));
    session.output.remark(&line);
    Ok(Outcome::Clean)
}

/// What a site is made from, as the options of a command say it.
pub(super) struct Data {
    pub(super) catalogue: Catalogue,
    pub(super) locales: Locales,
    files: Rc<Files>,
    controls: Vec<String>,
    languages: Vec<String>,
    is_draft: bool,
}

impl Data {
    /// Reads it; `--control`, `--lang` and `--draft` say which part of it.
    pub(super) fn of(session: &mut Session, matches: &ArgMatches) -> Result<Self, Failure> {
        let mut languages = arguments::all(matches, "lang");
        let is_draft = matches.get_flag("draft");
        if is_draft {
            draft(session, &languages)?;
        }
        let (catalogue, locales) = (session.catalogue()?, session.whole_locales()?);
        let files = session.files()?;
        languages.extend(session.pseudo().filter(|_| languages.is_empty()).map(|kind| kind.tag().to_owned()));
        let controls = cycle::controls(&catalogue, &arguments::all(matches, "control"))?;
        for tag in &languages {
            cycle::language(&locales, tag)?;
        }
        Ok(Self { catalogue, locales, files, controls, languages, is_draft })
    }

    /// The site, ready to be written.
    pub(super) fn site<'d>(&'d self, base_url: Option<&'d str>) -> Result<Site<'d>, Failure> {
        let request = Request {
            catalogue: &self.catalogue,
            locales: &self.locales,
            files: &self.files,
            controls: &self.controls,
            languages: &self.languages,
            base_url,
        };
        let mut site = Site::new(&request).map_err(session::in_texts(&self.locales))?;
        if self.is_draft {
            site.mark_as_draft();
        }
        Ok(site)
    }
}

/// Fills the gaps of one language with the source texts, marked.
fn draft(session: &mut Session, languages: &[String]) -> Result<(), Failure> {
    let [tag] = languages else { return Err(Diagnostic::global("draft-language").into()) };
    let tag = texts::translation(tag)?;
    let (files, missing) = exchange::draft(&session.files()?, &tag)?;
    session.replace(files);
    let args = Args::new().text("language", tag).number("count", missing as f64);
    let line = session.ui.text("cli-draft", &args);
    session.output.remark(&line);
    Ok(())
}

/// Writes each book as a file of its own. What else is in the directory stays.
fn write_books(session: &mut Session, out: &Path, books: &[Book]) -> Result<Outcome, Failure> {
    system::create_directory(out)?;
    for book in books {
        let path = out.join(&book.name);
        system::write(&path, &book.bytes)?;
        let args = Args::new().text("path", path.display().to_string()).number("pages", book.pages as f64);
        let line = session.ui.text("cli-book-written", &args);
        session.output.remark(&line);
    }
    Ok(Outcome::Clean)
}
