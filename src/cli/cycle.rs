//! Finding the control, the language and the cycle that words of the command line mean.
//!
//! Invariant: a word that means nothing, or two things, is an error that lists what there is.
use clap::ArgMatches;

use super::Failure;
use crate::base::diag::Diagnostic;
use crate::check::{self, Against, LabelBook};
use crate::language::locale::{Language, Locales, Ui};
use crate::program::syntax::Program;
use crate::spec::{Catalogue, Cycle, CycleKey, Known, OnControl, software};

/// The control of `--control`, by whichever of its names.
pub(super) fn control<'c>(catalogue: &'c Catalogue, id: &str) -> Result<&'c OnControl, Failure> {
    catalogue.on(id).ok_or_else(|| {
        let known: Vec<String> = catalogue.controls.values().map(|on| on.control.names()).collect();
        Diagnostic::global("unknown-control").arg("control", id).arg("known", known.join(", ")).into()
    })
}

/// The control of `--control` with the software version after `@`, if there is one.
pub(super) fn control_and_software<'c>(
    catalogue: &'c Catalogue,
    id: &str,
) -> Result<(&'c OnControl, Option<String>), Failure> {
    let Some((id, version)) = id.split_once('@') else { return control(catalogue, id).map(|on| (on, None)) };
    let on = control(catalogue, id)?;
    match software(version) {
        Some(_) => Ok((on, Some(version.to_owned()))),
        None => Err(Diagnostic::global("unknown-software").arg("found", version).into()),
    }
}

/// The ids of the controls of several `--control`.
pub(super) fn controls(catalogue: &Catalogue, names: &[String]) -> Result<Vec<String>, Failure> {
    names.iter().map(|name| control(catalogue, name).map(|on| on.id().to_owned())).collect()
}

/// The language with that tag.
pub(super) fn language<'l>(locales: &'l Locales, tag: &str) -> Result<&'l Language, Failure> {
    locales.language(tag).or_else(|_| locales.language(&tag.to_lowercase())).map_err(|_| {
        let known: Vec<&str> = locales.tags().collect();
        Diagnostic::global("unknown-language").arg("language", tag).arg("known", known.join(", ")).into()
    })
}

/// The language of `--lang`; without it that of the program's own texts, or of the control's manual if the data lack it.
pub(super) fn language_for<'l>(
    locales: &'l Locales,
    on: &OnControl,
    ui: &Ui,
    matches: &ArgMatches,
) -> Result<&'l Language, Failure> {
    match matches.get_one::<String>("lang") {
        Some(tag) => language(locales, tag),
        None => language(locales, ui.tag()).or_else(|_| language(locales, on.control.language.as_str())),
    }
}

/// The cycle that words mean: `412`, `TCH PROBE 412`, `tch-probe-412`.
pub(super) fn find<'c>(on: &'c OnControl, words: &str) -> Result<&'c Cycle, Failure> {
    let Some((keyword, number)) = parse(words) else {
        return Err(Diagnostic::global("cycle-name").arg("cycle", words).into());
    };
    let is_it = |key: &CycleKey| key.number == number && (keyword.is_empty() || key.keyword.as_str() == keyword);
    let found: Vec<&Cycle> = on.cycles.keys().filter(|key| is_it(key)).filter_map(|key| on.cycles.get(key)).collect();
    match found.as_slice() {
        [cycle] => Ok(cycle),
        [] => Err(absent(on, words, &is_it)),
        several => {
            let keys: Vec<String> = several.iter().map(|cycle| cycle.key.to_string()).collect();
            let diagnostic = Diagnostic::global("cycle-ambiguous").arg("cycle", number.to_string());
            Err(diagnostic.arg("control", on.id()).arg("keys", keys.join(", ")).into())
        }
    }
}

fn absent(on: &OnControl, words: &str, is_it: &dyn Fn(&CycleKey) -> bool) -> Failure {
    let named = on.control.named.iter().map(|named| CycleKey::new(named.keyword, named.number)).find(|key| is_it(key));
    let diagnostic = match named.map(|key| (key, on.known(key))) {
        Some((key, Known::Named(named))) => {
            let diagnostic = Diagnostic::global("cycle-only-named").arg("cycle", key.to_string());
            diagnostic.arg("name", named.name.as_str())
        }
        _ => Diagnostic::global("cycle-not-here").arg("cycle", words),
    };
    diagnostic.arg("control", on.id()).into()
}

/// Keyword (empty if only a number is given) and number.
pub(super) fn parse(words: &str) -> Option<(String, u32)> {
    let words = words.to_uppercase().replace(['-', '_'], " ");
    let mut words: Vec<&str> = words.split_whitespace().collect();
    let number = words.pop()?.parse().ok()?;
    Some((words.join(" "), number))
}

/// Findings that say that a control does not have a cycle as the program writes it.
const FOREIGN: [&str; 4] = ["unknown-cycle", "cycle-not-on-control", "cycle-not-covered", "cycle-not-described"];

/// The control that knows most cycles of the program and otherwise objects least to it.
pub(super) fn likeliest<'c>(program: &Program, catalogue: &'c Catalogue, locales: &Locales) -> Option<&'c OnControl> {
    catalogue.controls.values().min_by_key(|on| {
        let labels = LabelBook::new(on, locales);
        let against = Against { catalogue, on, labels: &labels, language: None, software: None, readers: &[] };
        let found = check::check(program, &against);
        (found.iter().filter(|diagnostic| FOREIGN.contains(&diagnostic.code)).count(), found.len())
    })
}
