//! `ciklo texts import`: files from translators, checked unit by unit. They are taken over together: each is checked on top
//! of those before it, and all that changes is written at the end.
use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;
use std::sync::Arc;

use clap::ArgMatches;

use super::accept::{self, Locks};
use super::shared::{Texts, language, writable};
use crate::base::data::Files;
use crate::base::diag::{Diagnostic, Place, Source};
use crate::cli::session::{self, Session};
use crate::cli::{Failure, Outcome, arguments};
use crate::language::locale::{Accept, Args, SOURCE_LANGUAGE};
use crate::spec::Catalogue;
use crate::system;
use crate::tools::exchange::{self, Imported, Received, Refusal, Row, Why};

/// Largest file that is read, in bytes.
const LARGEST: usize = 64 << 20;

/// A file with what is to be taken over into a language.
struct Part {
    source: Arc<Source>,
    tag: String,
    content: Content,
}

enum Content {
    Units(Vec<Received>),
    Terms(Vec<Row>),
}

pub(super) fn run(session: &mut Session, matches: &ArgMatches) -> Result<Outcome, Failure> {
    let root = writable(session, "texts import")?;
    let paths = arguments::all(matches, "input");
    if paths.is_empty() {
        return Err(Diagnostic::global("texts-no-file").into());
    }
    let to = matches.get_one::<String>("to").map(String::as_str);
    let mut parts = Vec::new();
    for path in &paths {
        parts.extend(read(path, to, matches.get_flag("any-state"))?);
    }
    let dry = matches.get_flag("dry-run");
    let mut work = Work { files: session::working_copy(&root)?, ..Work::default() };
    let (catalogue, _) = Catalogue::load(&work.files);
    let (mut found, mut lines) = (Vec::new(), Vec::new());
    for part in parts {
        let imported = match part.content {
            Content::Units(units) => exchange::import(&catalogue, &work.files, &part.tag, units)?,
            Content::Terms(rows) => exchange::import_terms(&catalogue, &work.files, &part.tag, &rows)?,
        };
        found.extend(imported.refused.iter().map(|refusal| diagnostic(session, &part.source, refusal)));
        lines.push(summary(session, &part.tag, dry, &imported));
        work.take(&part.tag, imported);
    }
    let is_sound = found.is_empty();
    let mut locks = Vec::new();
    if !dry {
        locks = work.accept()?;
        let changed: Vec<(String, String)> = work.changed.into_iter().collect();
        accept::put(&root, &changed)?;
    }
    session.report(found, arguments::chosen_format(matches))?;
    lines.iter().for_each(|line| session.output.remark(line));
    locks.iter().for_each(|locks| locks.report(session));
    Ok(if is_sound { Outcome::Clean } else { Outcome::Errors })
}

/// The texts as they are after what was taken over so far.
#[derive(Default)]
struct Work {
    files: Files,
    changed: BTreeMap<String, String>,
    /// The keys of texts that are final, by language.
    confirmed: BTreeMap<String, BTreeSet<String>>,
}

impl Work {
    fn take(&mut self, tag: &str, imported: Imported) {
        self.confirmed.entry(tag.to_owned()).or_default().extend(imported.confirmed);
        self.put(imported.files);
    }

    fn put(&mut self, files: Files) {
        for (path, text) in files {
            match self.files.iter_mut().find(|(own, _)| *own == path) {
                Some((_, own)) => own.clone_from(&text),
                None => self.files.push((path.clone(), text.clone())),
            }
            self.changed.insert(path, text);
        }
    }

    /// Records what is final as accepted.
    fn accept(&mut self) -> Result<Vec<Locks>, Failure> {
        let mut all = Vec::new();
        for (tag, keys) in std::mem::take(&mut self.confirmed).into_iter().filter(|(_, keys)| !keys.is_empty()) {
            let keys: Vec<String> = keys.into_iter().collect();
            let locks = Locks::of(&Texts::of(&self.files), &[tag], Accept::Named(&keys))?;
            self.put(locks.files.clone());
            all.push(locks);
        }
        Ok(all)
    }
}

/// What a file has for each language.
fn read(path: &str, to: Option<&str>, any_state: bool) -> Result<Vec<Part>, Failure> {
    let bytes = system::read(Path::new(path))?;
    let text = std::str::from_utf8(&bytes).ok();
    let source = Source::new(path, text.unwrap_or_default());
    let unreadable = |at: usize, what: &str| {
        Failure::from(Diagnostic::error("texts-file-unreadable", Place::new(&source, at..at)).arg("reason", what))
    };
    if bytes.len() > LARGEST {
        return Err(unreadable(0, "size"));
    }
    let text = text.ok_or_else(|| unreadable(0, "encoding"))?;
    if text.trim_start_matches('\u{feff}').trim().is_empty() {
        return Err(unreadable(0, "empty"));
    }
    if !exchange::is_terms(text) {
        let returned = exchange::read(text).map_err(|refused| unreadable(refused.at, refused.what))?;
        let tag = language(&to.map(str::to_owned).or(returned.language).unwrap_or_default())?;
        let mut units = returned.units;
        if any_state {
            units.iter_mut().for_each(Received::settle);
        }
        return Ok(vec![Part { source, tag, content: Content::Units(units) }]);
    }
    let rows = exchange::read_terms(text).map_err(|refused| unreadable(refused.at, refused.what))?;
    let named: BTreeSet<&str> = rows.iter().map(|row| row.words.language.as_str()).collect();
    let named = named.into_iter().filter(|tag| *tag != SOURCE_LANGUAGE && to.is_none_or(|to| to == *tag));
    let tags = named.map(language).collect::<Result<Vec<_>, _>>()?;
    let part = |tag: String| {
        let is_own = |row: &&Row| [SOURCE_LANGUAGE, &tag].contains(&row.words.language.as_str());
        let rows = rows.iter().filter(is_own).cloned().collect();
        Part { source: Arc::clone(&source), content: Content::Terms(rows), tag }
    };
    Ok(tags.into_iter().map(part).collect())
}

fn summary(session: &Session, tag: &str, dry: bool, imported: &Imported) -> String {
    let args = Args::new()
        .text("language", tag)
        .text("dry", if dry { "yes" } else { "no" })
        .number("taken", imported.taken.len() as f64)
        .number("unchanged", imported.unchanged as f64)
        .number("open", imported.passed_over as f64)
        .number("refused", imported.refused.len() as f64);
    session.ui.text("cli-texts-imported", &args)
}

fn diagnostic(session: &Session, source: &Arc<Source>, refusal: &Refusal) -> Diagnostic {
    let code = match refusal.why {
        Why::Unknown => "texts-unit-unknown",
        Why::Twice => "texts-unit-twice",
        Why::SourceChanged => "texts-unit-source-changed",
        Why::NotRead => "texts-unit-not-read",
        Why::Codes { .. } => "texts-unit-codes",
        Why::Exchanged => "texts-unit-exchanged",
        Why::Swapped { .. } => "texts-unit-swapped",
        Why::Negation => "texts-unit-negation",
        Why::Markup => "texts-unit-markup",
        Why::Numbers { .. } => "texts-unit-numbers",
        Why::Incomplete => "texts-unit-incomplete",
        Why::Found(_) => "texts-unit-refused",
    };
    let place = Place::new(source, refusal.at..refusal.at);
    let diagnostic = Diagnostic::error(code, place).arg("key", refusal.id.as_str());
    match &refusal.why {
        Why::Codes { missing, foreign } | Why::Numbers { missing, foreign } => {
            let none = |list: &str| if list.is_empty() { "–".to_owned() } else { list.to_owned() };
            diagnostic.arg("missing", none(missing)).arg("foreign", none(foreign))
        }
        Why::Swapped { other } => diagnostic.arg("other", other.as_str()),
        Why::Found(found) => diagnostic.arg("code", found.code).arg("finding", session.ui.diagnostic(found)),
        _ => diagnostic,
    }
}
