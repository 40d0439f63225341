//! `ciklo texts import`: a file from a translator, checked unit by unit.
use std::path::Path;
use std::sync::Arc;

use clap::ArgMatches;

use super::accept;
use super::shared::{Texts, language, writable};
use crate::base::diag::{Diagnostic, Place, Source};
use crate::cli::session::{self, Session};
use crate::cli::{Failure, Outcome, arguments};
use crate::language::locale::{Accept, Args};
use crate::spec::Catalogue;
use crate::system;
use crate::tools::exchange::{self, Refusal, Why};

/// Largest file that is read, in bytes.
const LARGEST: usize = 64 << 20;

pub(super) fn run(session: &mut Session, matches: &ArgMatches) -> Result<Outcome, Failure> {
    let root = writable(session, "texts import")?;
    let Some(path) = matches.get_one::<String>("input") else {
        return Err(Diagnostic::global("texts-no-file").into());
    };
    let bytes = system::read(Path::new(path))?;
    let text = std::str::from_utf8(&bytes).ok().filter(|text| text.len() <= LARGEST);
    let source = Source::new(path.as_str(), text.unwrap_or_default());
    let unreadable = |at: usize, what: &str| {
        Failure::from(Diagnostic::error("texts-file-unreadable", Place::new(&source, at..at)).arg("reason", what))
    };
    let text = text.ok_or_else(|| unreadable(0, "encoding"))?;
    let returned = exchange::read(text).map_err(|refused| unreadable(refused.at, refused.what))?;
    let tag = language(&match matches.get_one::<String>("to") {
        Some(tag) => tag.clone(),
        None => returned.language.unwrap_or_default(),
    })?;
    let files = session::working_copy(&root)?;
    let (catalogue, _) = Catalogue::load(&files);
    let imported = exchange::import(&catalogue, &files, &tag, returned.units)?;
    let found: Vec<Diagnostic> = imported.refused.iter().map(|refusal| diagnostic(session, &source, refusal)).collect();
    let is_sound = found.is_empty();
    let dry = matches.get_flag("dry-run");
    let mut locks = None;
    if !dry {
        let mut changed = imported.files.clone();
        if !imported.confirmed.is_empty() {
            let kept = files.into_iter().filter(|(path, _)| !imported.files.iter().any(|(own, _)| own == path));
            let after: Vec<(String, String)> = kept.chain(imported.files.iter().cloned()).collect();
            let named = Accept::Named(&imported.confirmed);
            let accepted = accept::Locks::of(&Texts::of(&after), std::slice::from_ref(&tag), named)?;
            changed.extend(accepted.files.iter().cloned());
            locks = Some(accepted);
        }
        accept::put(&root, &changed)?;
    }
    session.report(found, arguments::chosen_format(matches))?;
    let args = Args::new()
        .text("language", tag.as_str())
        .text("dry", if dry { "yes" } else { "no" })
        .number("taken", imported.taken.len() as f64)
        .number("unchanged", imported.unchanged as f64)
        .number("open", imported.passed_over as f64)
        .number("refused", imported.refused.len() as f64);
    let line = session.ui.text("cli-texts-imported", &args);
    session.output.remark(&line);
    if let Some(locks) = locks {
        locks.report(session);
    }
    Ok(if is_sound { Outcome::Clean } else { Outcome::Errors })
}

fn diagnostic(session: &Session, source: &Arc<Source>, refusal: &Refusal) -> Diagnostic {
    let code = match refusal.why {
        Why::Unknown => "texts-unit-unknown",
        Why::Twice => "texts-unit-twice",
        Why::SourceChanged => "texts-unit-source-changed",
        Why::NotRead => "texts-unit-not-read",
        Why::Codes { .. } => "texts-unit-codes",
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
        Why::Found(found) => diagnostic.arg("code", found.code).arg("finding", session.ui.diagnostic(found)),
        _ => diagnostic,
    }
}
