//! `ciklo lint`: everything that can be wrong with specifications and languages.
use std::collections::HashSet;
use std::path::Path;

use clap::ArgMatches;

use super::session::Session;
use super::{Command, Failure, Outcome, arguments, session};
use crate::accord;
use crate::diag::Diagnostic;
use crate::engine::plan;
use crate::label;
use crate::locale::{Args, Language, LocaleError, Locales, SOURCE_LANGUAGE, Scope, Ui};
use crate::manual;
use crate::spec::{self, Catalogue};
use crate::system;

pub(super) const COMMAND: Command =
    Command { name: "lint", usage: "[--data DIR] [--format FORMAT] [--accept-translations]", arguments: own, run };

const ACCEPT: &str = "accept-translations";

fn own(ui: &Ui) -> Vec<clap::Arg> {
    vec![arguments::format(ui, &["text", "json"]), arguments::switch(ui, ACCEPT, "cli-lint-accept")]
}

fn run(session: &mut Session, matches: &ArgMatches) -> Result<Outcome, Failure> {
    if matches.get_flag(ACCEPT) {
        return accept(session);
    }
    let files = session.files()?;
    let (locales, mut found) = Locales::load(files.iter().map(|(path, text)| (path, text)));
    let (catalogue, mistakes) = Catalogue::load(&files);
    found.extend(mistakes);
    found.extend(spec::lint(&catalogue));
    found.extend(plan::check(&catalogue));
    found.extend(languages(&locales)?);
    found.extend(texts(&catalogue, &locales));
    found.extend(languages_of_controls(&catalogue, &locales));
    found.extend(label::check(&catalogue, &locales));
    found.extend(accord::check(&catalogue, &locales));
    let site = pages(&catalogue, &locales, &files, &found);
    found.extend(site);
    let errors = session.report(found, arguments::chosen_format(matches))?;
    Ok(if errors { Outcome::Errors } else { Outcome::Clean })
}

/// Writes down that every translation is good as it stands, in the working copy given or in the
/// present directory if it is one.
fn accept(session: &mut Session) -> Result<Outcome, Failure> {
    let here = Path::new(".");
    let Some(root) = session.data().or_else(|| session::is_working_copy(here).then_some(here)) else {
        return Err(Diagnostic::global("needs-data").arg("option", format!("--{ACCEPT}")).into());
    };
    let files = session::working_copy(root)?;
    let (locales, _) = Locales::load(files.iter().map(|(path, text)| (path, text)));
    for tag in locales.tags().filter(|tag| *tag != SOURCE_LANGUAGE) {
        let path = root.join("locales").join(tag).join("source.lock");
        system::write(&path, locales.accepted(tag)?.as_bytes())?;
        let args = Args::new().text("path", path.display().to_string());
        let line = session.ui.text("cli-written", &args);
        session.output.remark(&line);
    }
    Ok(Outcome::Clean)
}

fn languages(locales: &Locales) -> Result<Vec<Diagnostic>, LocaleError> {
    let mut found = Vec::new();
    for tag in locales.tags() {
        found.extend(locales.audit(tag)?.diagnostics());
    }
    Ok(found)
}

/// Texts that a cycle needs and the source language lacks (a translation that lacks what the source
/// has is found by comparing them), and variants for cycles or controls that do not exist.
fn texts(catalogue: &Catalogue, locales: &Locales) -> Vec<Diagnostic> {
    let mut found = Vec::new();
    if let Some(source) = locales.source() {
        for on in catalogue.controls.values() {
            for cycle in on.cycles.values() {
                let scope = Scope::new(cycle.name(), on.id());
                let place = &cycle.file.name.place;
                let keys = spec::texts(cycle, on).into_iter().map(|text| text.key());
                found.extend(keys.filter(|key| !source.has(key, &scope)).map(|key| {
                    Diagnostic::error("locale-missing-text", place.clone())
                        .arg("key", key)
                        .arg("language", source.tag())
                }));
            }
        }
    }
    locales.iter().for_each(|language| variants(catalogue, language, &mut found));
    crate::diag::dedupe(&mut found);
    found
}

/// What only shows when everything is written: texts that use what the control does not give them,
/// mistakes of the templates. Texts known to be missing are not told again.
fn pages(catalogue: &Catalogue, locales: &Locales, files: &[(String, String)], told: &[Diagnostic]) -> Vec<Diagnostic> {
    let text = |diagnostic: &Diagnostic| {
        let arg = |wanted| diagnostic.args.iter().find(|(name, _)| *name == wanted).map(|(_, arg)| format!("{arg:?}"));
        (arg("language"), arg("key"))
    };
    let missing: HashSet<_> = told.iter().filter(|one| one.code.starts_with("locale-missing-")).map(text).collect();
    if catalogue.controls.is_empty() {
        return Vec::new();
    }
    let request = manual::Request { catalogue, locales, files, controls: &[], languages: &[] };
    let mut found = manual::build(&request, &|_, _| Ok(())).err().unwrap_or_default();
    found.retain(|diagnostic| diagnostic.code != "locale-missing-text" || !missing.contains(&text(diagnostic)));
    found
}

/// The language of a control's manual, which a dialog or block has if none is asked for.
fn languages_of_controls(catalogue: &Catalogue, locales: &Locales) -> Vec<Diagnostic> {
    let known = locales.tags().collect::<Vec<_>>().join(", ");
    let languages = catalogue.controls.values().map(|on| &on.control.language);
    let unknown = languages.filter(|language| locales.language(language.as_str()).is_err()).map(|language| {
        let diagnostic = Diagnostic::error("unknown-language", language.place.clone());
        diagnostic.arg("language", language.as_str()).arg("known", known.as_str())
    });
    unknown.collect()
}

fn variants(catalogue: &Catalogue, language: &Language, found: &mut Vec<Diagnostic>) {
    for (suffix, place) in language.suffixes() {
        let mut controls = catalogue.controls.iter();
        if !controls.any(|(id, on)| id == suffix || on.by_name(suffix).is_some()) {
            found.push(Diagnostic::error("locale-unknown-suffix", place).arg("name", suffix));
        }
    }
}
