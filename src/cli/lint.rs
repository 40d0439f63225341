//! `ciklo lint`: everything that can be wrong with specifications and languages.
use std::collections::{BTreeMap, HashSet};

use clap::ArgMatches;

use super::session::Session;
use super::{Command, Failure, Outcome, arguments, conform as conform_cmd, consequences, session, texts as texts_cmd};
use crate::base::diag::{Arg, Diagnostic, Severity, Source};
use crate::check::{self, Against, LabelBook};
use crate::engine::plan;
use crate::language::consistency;
use crate::language::label;
use crate::language::locale::render::render;
use crate::language::locale::{Args, Language, LocaleError, Locales, NO_FILE, Scope, Ui};
use crate::output::figure;
use crate::output::manual;
use crate::program::syntax;
use crate::spec::{self, Catalogue, Keyword, OnControl};
use crate::tools::conform::{self, Selection, World};

pub(super) const COMMAND: Command = Command {
    name: "lint",
    usage: "[--data DIR] [--only CYCLE]… [--summary] [--format FORMAT] [--fail-on LEVEL] [--accept-translations]",
    arguments: own,
    run,
};

/// So many findings follow the counts of a summary.
const NEXT: usize = 20;
const ACCEPT: &str = "accept-translations";
/// What is found where a language lacks a text.
const MISSING: [&str; 3] = ["locale-missing-translation", "locale-missing-text", "manual-topic-missing"];
/// If more of them are missing in a language, they are counted and not named.
const MOST_MISSING: usize = 100;

fn own(ui: &Ui) -> Vec<clap::Arg> {
    vec![
        arguments::format(ui, &["text", "json"]),
        arguments::fail_on(ui),
        arguments::several(ui, "only", "CYCLE", "cli-lint-only"),
        arguments::switch(ui, "summary", "cli-lint-summary"),
        arguments::switch(ui, ACCEPT, "cli-lint-accept").conflicts_with_all(["only", "summary"]),
    ]
}

fn run(session: &mut Session, matches: &ArgMatches) -> Result<Outcome, Failure> {
    if matches.get_flag(ACCEPT) {
        return texts_cmd::accept_changed(session, &format!("--{ACCEPT}"));
    }
    let files = session.files()?;
    let (locales, mut found) = Locales::load(files.iter().map(|(path, text)| (path, text)));
    let (catalogue, mistakes) = Catalogue::load(&files);
    found.extend(mistakes);
    found.extend(spec::lint(&catalogue));
    found.extend(plan::check(&catalogue));
    found.extend(languages(&catalogue, &locales)?);
    found.extend(texts(&catalogue, &locales));
    found.extend(languages_of_controls(&catalogue, &locales));
    let only = conform_cmd::cycles(&arguments::all(matches, "only"))?;
    found.extend(examples(&catalogue, &locales, &files, &only));
    let chosen = Selection { cycles: &only, ..Selection::default() };
    let world = World { catalogue: &catalogue, locales: &locales, files: &files };
    found.extend(figure::check(&catalogue, &world, &|cycle| chosen.has_cycle(cycle)));
    if only.is_empty() {
        found.extend(label::check(&catalogue, &locales));
        found.extend(consistency::check(&catalogue, &locales));
        found.extend(printed(&catalogue, &locales));
        let site = pages(&catalogue, &locales, &files, &found);
        found.extend(site);
    } else {
        let chosen = Selection { cycles: &only, ..Selection::default() };
        consequences::only(&mut found, &catalogue, &|cycle| chosen.has_cycle(cycle), &spec_files(&files, &only));
        let line = session.ui.text("cli-lint-narrow", &Args::new());
        session.output.remark(&line);
    }
    consequences::without_uses(&mut found);
    let least = arguments::chosen_fail_on(matches).unwrap_or(Severity::Error);
    let fails = found.iter().any(|diagnostic| diagnostic.severity >= least);
    if matches.get_flag("summary") {
        return summary(session, found).map(|()| if fails { Outcome::Errors } else { Outcome::Clean });
    }
    let format = arguments::chosen_format(matches);
    session.report(if format == "json" { found } else { folded(found) }, format)?;
    Ok(if fails { Outcome::Errors } else { Outcome::Clean })
}

/// One finding for all that is missing in a language in which hardly anything is there yet.
fn folded(mut found: Vec<Diagnostic>) -> Vec<Diagnostic> {
    let language = |one: &Diagnostic| match one.get("language") {
        Some(Arg::Text(tag)) if MISSING.contains(&one.code) => Some(tag.to_string()),
        _ => None,
    };
    let mut counts: BTreeMap<String, usize> = BTreeMap::new();
    found.iter().filter_map(language).for_each(|tag| *counts.entry(tag).or_default() += 1);
    counts.retain(|_, count| *count > MOST_MISSING);
    found.retain(|one| language(one).is_none_or(|tag| !counts.contains_key(&tag)));
    let all = counts
        .into_iter()
        .map(|(tag, count)| Diagnostic::global("locale-unfinished").arg("language", tag).arg("count", count as f64));
    found.extend(all);
    found
}

/// Counts by file, then the first findings.
fn summary(session: &mut Session, mut found: Vec<Diagnostic>) -> Result<(), Failure> {
    found.sort_by(|a, b| (b.severity, session::place_key(a)).cmp(&(a.severity, session::place_key(b))));
    let counts = consequences::by_file(&found, &session.ui);
    session.output.print(&counts)?;
    for diagnostic in found.iter().take(NEXT) {
        session.output.print(&format!("\n{}", render(diagnostic, &session.ui, false)))?;
    }
    session.totals(&found);
    Ok(())
}

/// The files that hold, by their names, the specifications of cycles: one that cannot be read has no cycle.
fn spec_files(files: &[(String, String)], only: &[(Option<Keyword>, u32)]) -> Vec<String> {
    let names = files.iter().map(|(path, _)| path).filter(|path| path.starts_with("cycle-specs/"));
    let is_one = |path: &&String| {
        let file = path.rsplit('/').next().unwrap_or_default();
        only.iter().any(|(_, number)| file.strip_prefix(&number.to_string()).is_some_and(|rest| rest.starts_with('-')))
    };
    names.filter(is_one).cloned().collect()
}

fn languages(catalogue: &Catalogue, locales: &Locales) -> Result<Vec<Diagnostic>, LocaleError> {
    let meanings = consistency::meanings(catalogue);
    let mut found = Vec::new();
    for tag in locales.tags() {
        found.extend(locales.audit_with(tag, &meanings)?.diagnostics());
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
                for key in keys.filter(|key| !source.has(key, &scope)) {
                    // No other language can be compared with a text that the source lacks.
                    for language in locales.iter().filter(|language| !language.has(&key, &scope)) {
                        let missing = Diagnostic::error("locale-missing-text", place.clone());
                        let missing = missing.arg("key", key.as_str()).arg("language", language.tag());
                        found.push(missing.arg("file", NO_FILE));
                    }
                }
            }
        }
    }
    locales.iter().for_each(|language| variants(catalogue, language, &mut found));
    unused(catalogue, locales, &mut found);
    crate::base::diag::dedupe(&mut found);
    found
}

/// What the messages of the specifications begin with.
const OF_SPECS: [&str; 14] = [
    "cycle-",
    "parameter-",
    "step-",
    "say-",
    "until-",
    "condition-",
    "choice-",
    "result-",
    "note-",
    "title-",
    "message-",
    "figure-",
    "program-",
    "comment-",
];
/// Messages that begin like those of the specifications and are not theirs.
const NOT_OF_SPECS: [&str; 1] = ["cycle-group-"];

/// Texts of the source language that no specification and no other text uses.
fn unused(catalogue: &Catalogue, locales: &Locales, found: &mut Vec<Diagnostic>) {
    let Some(source) = locales.source().filter(|_| !catalogue.controls.is_empty()) else { return };
    let mut used: HashSet<String> = HashSet::new();
    for on in catalogue.controls.values() {
        used.extend(on.cycles.values().flat_map(|cycle| spec::texts(cycle, on)).map(|text| text.id));
    }
    let referred = source.referred();
    for (key, suffixes) in source.keys() {
        let ours = OF_SPECS.iter().any(|prefix| key.id.starts_with(prefix))
            && !NOT_OF_SPECS.iter().any(|prefix| key.id.starts_with(prefix));
        if !ours
            || key.attribute.is_some()
            || !suffixes.is_empty()
            || used.contains(key.id)
            || referred.contains(key.id)
        {
            continue;
        }
        if let Some((_, place)) = source.raw(key, Scope::NONE) {
            found.push(Diagnostic::warning("locale-unused", place).arg("key", key.id));
        }
    }
}

/// Examples as the manual prints them that the checker would object to.
fn printed(catalogue: &Catalogue, locales: &Locales) -> Vec<Diagnostic> {
    let mut found = Vec::new();
    let Some(source) = locales.source() else { return found };
    for on in catalogue.controls.values() {
        let labels = LabelBook::new(on, locales);
        let against = Against { catalogue, on, labels: &labels, language: None, software: None, readers: &[source] };
        worked(on, &against, &mut found);
        for cycle in on.cycles.values() {
            for example in &cycle.file.nc_examples {
                let Ok(block) = label::example(on, cycle, source, example) else { continue };
                // A part of a program: its labels and the cycle that it calls are elsewhere, and so is its tool.
                let checked = check::check(&syntax::parse(&Source::new("example", block)), &against);
                let refused = |one: &Diagnostic| one.severity == Severity::Error && one.code != "tool-missing";
                let errors = checked.into_iter().filter(refused);
                found.extend(errors.map(|error| {
                    Diagnostic::error("spec-example-guarded", example.place.clone())
                        .arg("code", error.code)
                        .arg("cycle", cycle.key.to_string())
                }));
            }
        }
    }
    crate::base::diag::dedupe(&mut found);
    found
}

/// Worked programs that the checker would warn of.
fn worked(on: &OnControl, against: &Against<'_>, found: &mut Vec<Diagnostic>) {
    for worked in on.worked.iter() {
        let program = syntax::parse(&Source::new("program", worked.text().to_owned()));
        let checked = check::check(&program, against).into_iter().filter(|one| one.severity >= Severity::Warning);
        found.extend(checked.map(|one| {
            let place = worked.example.name.place.clone();
            let diagnostic = Diagnostic::error("spec-example-guarded", place).arg("code", one.code);
            diagnostic.arg("cycle", worked.key.to_string())
        }));
    }
}

/// Examples for the engine that do not come out as they say.
fn examples(
    catalogue: &Catalogue,
    locales: &Locales,
    files: &[(String, String)],
    only: &[(Option<Keyword>, u32)],
) -> Vec<Diagnostic> {
    let chosen = Selection { cycles: only, ..Selection::default() };
    let (report, mut found) = conform::run(&World { catalogue, locales, files }, &chosen);
    for case in &report.cases {
        let mismatches = consequences::causes(case);
        let Some(on) = catalogue.on(&case.control) else { continue };
        let example =
            on.by_name(&case.cycle).and_then(|cycle| on.cases_of(cycle).find(|own| own.name.as_str() == case.case));
        let Some(place) = example.map(|example| example.place.clone()) else { continue };
        for mismatch in mismatches {
            found.push(
                Diagnostic::error("spec-example-fails", place.clone())
                    .arg("name", case.case.as_str())
                    .arg("control", case.control.as_str())
                    .arg("what", mismatch.what.as_str())
                    .arg("expected", mismatch.expected.as_str())
                    .arg("found", mismatch.found.as_str()),
            );
        }
    }
    crate::base::diag::dedupe(&mut found);
    found
}

/// What only shows when everything is written: texts that use what the control does not give them,
/// mistakes of the templates. Texts known to be missing are not reported again.
fn pages(
    catalogue: &Catalogue,
    locales: &Locales,
    files: &[(String, String)],
    reported: &[Diagnostic],
) -> Vec<Diagnostic> {
    let text = |diagnostic: &Diagnostic| {
        let arg = |wanted| diagnostic.args.iter().find(|(name, _)| *name == wanted).map(|(_, arg)| format!("{arg:?}"));
        (arg("language"), arg("key"))
    };
    let missing: HashSet<_> = reported.iter().filter(|one| one.code.starts_with("locale-missing-")).map(text).collect();
    if catalogue.controls.is_empty() {
        return Vec::new();
    }
    let request = manual::Request { catalogue, locales, files, controls: &[], languages: &[], base_url: None };
    let mut found = manual::build(&request, &|_, _| Ok(())).err().unwrap_or_default();
    locales.place_missing(&mut found);
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
