//! What a command works with: the data, loaded when first needed, and the streams.
//!
//! Invariant: standard output carries the result and nothing else; everything about how it went goes
//! to standard error.
use std::cell::{OnceCell, RefCell};
use std::io::{self, BufWriter, StdoutLock, Write as _};
use std::path::{Path, PathBuf};
use std::rc::Rc;

use super::Failure;
use crate::base::data::{self, Files, Prepared};
use crate::base::diag::{Diagnostic, Mistakes, Severity, visible};
use crate::language::locale::render::{render, to_json_line};
use crate::language::locale::{Args, Locales, Ui};
use crate::spec::Catalogue;
use crate::system;
use crate::tools::exchange::{self, Pseudo};

/// The directories of a working copy that hold data.
const TOPS: [&str; 3] = ["cycle-specs", LOCALES, "templates"];
/// The folder of the languages.
const LOCALES: &str = "locales";
/// Where the files are that the engine needs.
const OF_ENGINE: [&str; 2] = ["cycle-specs/machines/", "templates/logs/"];
/// Files of a language that the program's own texts are in.
const INTERFACE: [&str; 5] = ["diag-", "explain-", "cli", "interface", "units"];

/// The program's own texts, in all languages.
pub(super) fn interface(pseudo: Option<Pseudo>) -> Locales {
    if let Some(data) = data::prepared().filter(|_| pseudo.is_none()) {
        return Locales::open(data);
    }
    let mut files = data::embedded();
    files.retain(|(path, _)| is_interface(path));
    let more = pseudo.map_or_else(Vec::new, |kind| exchange::pseudo(&files, kind));
    files.extend(more);
    Locales::load(files.iter().map(|(path, text)| (path, text))).0
}

/// The program's own texts as a working copy has them, in all languages that have a folder there; nothing if they cannot
/// be read, which the command itself reports.
pub(super) fn interface_of(root: &Path, pseudo: Option<Pseudo>) -> Option<Locales> {
    let mut files = system::read_tree(root, &[LOCALES]).ok()?;
    files.retain(|(path, _)| is_interface(path));
    let mut files: Files =
        files.into_iter().filter_map(|(path, bytes)| Some((path, String::from_utf8(bytes).ok()?))).collect();
    files.extend(languages_of(root, &Files::new()).ok()?);
    let more = pseudo.map_or_else(Vec::new, |kind| exchange::pseudo(&files, kind));
    files.extend(more);
    Some(Locales::load(files.iter().map(|(path, text)| (path, text))).0)
}

fn is_interface(path: &str) -> bool {
    path.rsplit('/').next().is_some_and(|name| INTERFACE.iter().any(|prefix| name.starts_with(prefix)))
}

/// An entry without a text for each folder of a language in which there is none of the files.
fn languages_of(root: &Path, files: &Files) -> Result<Files, Failure> {
    let tags = system::folders(&root.join(LOCALES))?.into_iter().map(|tag| format!("{LOCALES}/{tag}/"));
    let is_empty = |folder: &String| !files.iter().any(|(path, _)| path.starts_with(folder.as_str()));
    Ok(tags.filter(is_empty).map(|folder| (folder, String::new())).collect())
}

/// Standard output, buffered, and standard error.
///
/// Where no one reads standard output any more, what is printed is dropped: a command does the rest of its work and
/// ends as it would have ended.
pub(super) struct Output {
    stdout: BufWriter<StdoutLock<'static>>,
    colours: (bool, bool),
    closed: bool,
}

impl Output {
    pub(super) fn new() -> Self {
        Self { stdout: BufWriter::new(io::stdout().lock()), colours: system::colours(), closed: false }
    }

    /// Writes a part of the result.
    pub(super) fn print(&mut self, text: &str) -> Result<(), Failure> {
        self.write(text.as_bytes())
    }

    /// Writes a part of the result, byte by byte as it is.
    pub(super) fn write(&mut self, bytes: &[u8]) -> Result<(), Failure> {
        if self.closed {
            return Ok(());
        }
        let written = self.stdout.write_all(bytes);
        self.taken(written)
    }

    /// Writes out what is buffered.
    pub(super) fn finish(&mut self) -> Result<(), Failure> {
        if self.closed {
            return Ok(());
        }
        let flushed = self.stdout.flush();
        self.taken(flushed)
    }

    /// Whether no one reads standard output any more.
    pub(super) const fn is_closed(&self) -> bool {
        self.closed
    }

    fn taken(&mut self, written: io::Result<()>) -> Result<(), Failure> {
        match written {
            Err(error) if error.kind() == io::ErrorKind::BrokenPipe => {
                self.closed = true;
                Ok(())
            }
            written => written.map_err(|error| system::stdout_trouble(&error).into()),
        }
    }

    /// Reports a problem on standard error.
    pub(super) fn complain(&mut self, diagnostic: &Diagnostic, ui: &Ui) {
        // Order matters where both streams are one terminal; and with standard error gone, no one is left to report to.
        let _ = self.stdout.flush();
        let _ = io::stderr().write_all(render(diagnostic, ui, self.colours.1).as_bytes());
    }

    /// Writes a line about how it went to standard error.
    pub(super) fn remark(&mut self, line: &str) {
        let _ = self.stdout.flush();
        let _ = writeln!(io::stderr(), "{}", visible(line));
    }
}

/// One command being carried out.
pub(super) struct Session<'s> {
    pub(super) ui: Ui<'s>,
    pub(super) output: &'s mut Output,
    /// The program's own texts, which are those of the data if these are the embedded ones.
    interface: &'s Locales,
    data: Option<&'s Path>,
    pseudo: Option<Pseudo>,
    /// Whether the files are not those of the data.
    is_replaced: bool,
    files: OnceCell<Rc<Files>>,
    /// What is found in data while the command reads them.
    mistakes: RefCell<Vec<Mistakes>>,
}

impl<'s> Session<'s> {
    pub(super) fn new(ui: Ui<'s>, output: &'s mut Output, interface: &'s Locales, data: Option<&'s Path>) -> Self {
        let (files, mistakes) = (OnceCell::new(), RefCell::default());
        Self { ui, output, interface, data, pseudo: None, is_replaced: false, files, mistakes }
    }

    /// The same with a pseudo-language among the others.
    pub(super) fn with_pseudo(self, pseudo: Option<Pseudo>) -> Self {
        Self { pseudo, ..self }
    }

    /// The pseudo-language that was asked for.
    pub(super) const fn pseudo(&self) -> Option<Pseudo> {
        self.pseudo
    }

    /// Uses other files than those of the data from now on.
    pub(super) fn replace(&mut self, files: Files) {
        self.files = OnceCell::from(Rc::new(files));
        self.is_replaced = true;
    }

    /// Reads the files anew when they are next needed.
    pub(super) fn forget(&mut self) {
        self.files = OnceCell::new();
        self.is_replaced = false;
    }

    /// The state of the files of the working copy, if one is used: another one when they have changed.
    pub(super) fn state_of_data(&self) -> system::TreeState {
        self.data.map_or_else(Default::default, |root| system::state_of_tree(root, &TOPS))
    }

    /// The directory of the working copy, if one is used instead of the embedded data.
    pub(super) fn data(&self) -> Option<&'s Path> {
        self.data
    }

    /// The files that everything is made from.
    pub(super) fn files(&self) -> Result<Rc<Files>, Failure> {
        if let Some(files) = self.files.get() {
            return Ok(Rc::clone(files));
        }
        let mut files = match self.data {
            None => data::embedded(),
            Some(root) => working_copy(root)?,
        };
        let more = self.pseudo.map_or_else(Vec::new, |kind| exchange::pseudo(&files, kind));
        files.extend(more);
        Ok(Rc::clone(self.files.get_or_init(|| Rc::new(files))))
    }

    /// The files that the engine needs: machines and the templates of logs.
    pub(super) fn engine_files(&self) -> Result<Rc<Files>, Failure> {
        let Some(data) = self.prepared() else { return self.files() };
        let files = OF_ENGINE.iter().flat_map(|prefix| data.below(prefix));
        Ok(Rc::new(files.map(|(path, text)| (path.to_owned(), text.to_owned())).collect()))
    }

    /// The embedded files as they were prepared, if they are what everything is made from.
    fn prepared(&self) -> Option<&'static Prepared> {
        data::prepared().filter(|_| self.data.is_none() && self.pseudo.is_none() && !self.is_replaced)
    }

    /// The catalogue: of the embedded files, which were checked when they were made, what is asked for; of a working
    /// copy all, which must be without mistakes.
    pub(super) fn catalogue(&self) -> Result<Catalogue, Failure> {
        let Some(data) = self.prepared() else { return self.whole_catalogue() };
        let catalogue = Catalogue::open(data);
        self.mistakes.borrow_mut().push(catalogue.mistakes.clone());
        Ok(catalogue)
    }

    /// The languages, in the same way.
    pub(super) fn locales(&self) -> Result<Locales, Failure> {
        if self.prepared().is_none() {
            return self.whole_locales();
        }
        let locales = self.interface.clone();
        self.mistakes.borrow_mut().push(locales.mistakes().clone());
        Ok(locales)
    }

    /// The whole catalogue, which must be without mistakes.
    pub(super) fn whole_catalogue(&self) -> Result<Catalogue, Failure> {
        let (catalogue, found) = Catalogue::load(&self.files()?);
        sound(found).map(|()| catalogue)
    }

    /// All texts of the languages, which must be without mistakes.
    pub(super) fn whole_locales(&self) -> Result<Locales, Failure> {
        let (locales, found) = Locales::load(self.files()?.iter().map(|(path, text)| (path, text)));
        sound(found).map(|()| locales)
    }

    /// Whether the data that the command has read were without mistakes.
    pub(super) fn sound(&self) -> Result<(), Failure> {
        sound(self.mistakes.borrow().iter().flat_map(Mistakes::take).collect())
    }

    /// Prints a document, for people to read too, as it is made.
    pub(super) fn print_json(&mut self, document: &impl serde::Serialize) -> Result<(), Failure> {
        if self.output.closed {
            return Ok(());
        }
        if let Err(error) = serde_json::to_writer_pretty(&mut self.output.stdout, document) {
            let Some(kind) = error.io_error_kind() else {
                return Err(Diagnostic::global("internal").arg("detail", error.to_string()).into());
            };
            self.output.taken(Err(kind.into()))?;
        }
        self.output.print("\n")
    }

    /// Prints findings as the result of the command, in the order of files and places: as text with a
    /// count at the end and the command that explains them, or as JSON lines.
    pub(super) fn report(&mut self, mut found: Vec<Diagnostic>, format: &str) -> Result<(), Failure> {
        found.sort_by(|a, b| place_key(a).cmp(&place_key(b)));
        for diagnostic in &found {
            let text = match format {
                "json" => to_json_line(diagnostic, &self.ui) + "\n",
                _ => render(diagnostic, &self.ui, self.output.colours.0) + "\n",
            };
            self.output.print(&text)?;
        }
        if format != "json" {
            self.totals(&found);
        }
        Ok(())
    }

    /// Says what of a folder was passed over, if anything was.
    pub(super) fn passed_over(&mut self, paths: &[PathBuf]) {
        let Some(first) = paths.first() else { return };
        let note = Diagnostic { severity: Severity::Note, ..Diagnostic::global("passed-over") };
        let note = note.arg("path", first.display().to_string()).arg("more", (paths.len() - 1) as f64);
        self.output.complain(&note, &self.ui);
    }

    /// Says how many findings there are, and how more is learnt of the worst one.
    pub(super) fn totals(&mut self, found: &[Diagnostic]) {
        let count = |severity| found.iter().filter(|diagnostic| diagnostic.severity == severity).count();
        let (errors, warnings, notes) = (count(Severity::Error), count(Severity::Warning), count(Severity::Note));
        let args = Args::new().number("errors", errors as f64).number("warnings", warnings as f64);
        let line = self.ui.text("cli-summary", &args.number("notes", notes as f64));
        self.output.remark(&line);
        if let Some(worst) = found.iter().rev().max_by_key(|diagnostic| diagnostic.severity) {
            let line = self.ui.text("cli-explain-more", &Args::new().text("code", worst.code));
            self.output.remark(&line);
        }
    }
}

/// Findings in texts; where one is missing, the place of the English text and the file in which it belongs are added.
pub(super) fn in_texts(locales: &Locales) -> impl Fn(Vec<Diagnostic>) -> Failure {
    |mut found| {
        locales.place_missing(&mut found);
        Failure::Data(found)
    }
}

/// A document, for people to read too.
pub(super) fn json(document: &impl serde::Serialize) -> Result<String, Failure> {
    let text = serde_json::to_string_pretty(document);
    // Only a map with keys that are no text cannot be written, and no document of ours has one.
    let text = text.map_err(|error| Diagnostic::global("internal").arg("detail", error.to_string()))?;
    Ok(text + "\n")
}

/// The order of findings: by file and place.
pub(super) fn place_key(diagnostic: &Diagnostic) -> (Option<&str>, usize, &'static str) {
    let place = diagnostic.place.as_ref();
    (place.map(|place| place.source.name()), place.map_or(0, |place| place.span.start), diagnostic.code)
}

fn sound(found: Vec<Diagnostic>) -> Result<(), Failure> {
    let errors: Vec<Diagnostic> = found.into_iter().filter(|it| it.severity == Severity::Error).collect();
    if errors.is_empty() { Ok(()) } else { Err(Failure::Data(errors)) }
}

/// Whether a directory looks like one with data.
pub(super) fn is_working_copy(root: &Path) -> bool {
    TOPS.iter().take(2).all(|top| root.join(top).is_dir())
}

pub(super) fn working_copy(root: &Path) -> Result<Files, Failure> {
    let tree = system::read_tree(root, &TOPS)?;
    if tree.is_empty() {
        return Err(Diagnostic::global("no-data").arg("path", root.display().to_string()).into());
    }
    if let Some(top) = TOPS.iter().find(|top| !root.join(top).is_dir()) {
        let lacks =
            Diagnostic::global("data-directory-missing").arg("path", root.display().to_string()).arg("name", *top);
        return Err(lacks.into());
    }
    let mut found = Vec::new();
    let mut files = Files::new();
    for (path, bytes) in tree {
        match String::from_utf8(bytes) {
            Ok(text) => files.push((path, text)),
            Err(_) => found.push(Diagnostic::global("data-encoding").arg("path", path.as_str())),
        }
    }
    files.extend(languages_of(root, &files)?);
    if found.is_empty() { Ok(files) } else { Err(Failure::Data(found)) }
}
