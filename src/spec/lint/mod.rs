//! What can be wrong with specifications beyond their form: each file of checks looks at one part.
//!
//! Invariant: knows no language and no engine; whether texts exist is checked where texts are, and
//! whether a run compiles is checked where runs are compiled.
mod example;
mod habit;
mod parameter;
mod reference;
mod run;
pub use habit::equals;
pub(super) use run::walk;

use std::collections::BTreeSet;

use super::catalogue::{Catalogue, Cycle, OnControl};
use super::decode::Name;
use crate::base::diag::{Diagnostic, Place, Severity, dedupe};

/// All findings about the catalogue; what several controls share shows once.
pub fn lint(catalogue: &Catalogue) -> Vec<Diagnostic> {
    let mut found = Vec::new();
    for on in catalogue.controls.values() {
        reference::control(on, &mut found);
        for cycle in on.cycles.values() {
            lint_cycle(cycle, on, &mut found);
        }
    }
    reference::errata(catalogue, &mut found);
    habit::habits(catalogue, &mut found);
    reference::topics(catalogue, &mut found);
    unused(catalogue, &mut found);
    dedupe(&mut found);
    found
}

fn lint_cycle(cycle: &Cycle, on: &OnControl, found: &mut Vec<Diagnostic>) {
    slug(&cycle.file.name, found);
    parameter::parameters(cycle, found);
    parameter::lines(cycle, on, found);
    reference::cycle(cycle, on, found);
    run::run(cycle, on, found);
    example::examples(cycle, found);
}

/// Ids are kebab case: they become message ids.
fn slug(name: &Name, found: &mut Vec<Diagnostic>) {
    let good = name.as_str().starts_with(|c: char| c.is_ascii_lowercase())
        && name.as_str().bytes().all(|b| b.is_ascii_lowercase() || b.is_ascii_digit() || b == b'-')
        && !name.as_str().ends_with('-')
        && !name.as_str().contains("--");
    if !good {
        found.push(Diagnostic::error("spec-id-form", name.place.clone()).arg("name", name.as_str()));
    }
}

/// Reports every name that occurs twice in a list.
fn duplicates<'n>(names: impl IntoIterator<Item = &'n Name>, found: &mut Vec<Diagnostic>) {
    let mut seen: Vec<&Name> = Vec::new();
    for name in names {
        match seen.iter().find(|other| other.text == name.text) {
            Some(first) => found.push(
                Diagnostic::error("spec-duplicate-name", name.place.clone())
                    .arg("name", name.as_str())
                    .related("first-place", first.place.clone()),
            ),
            None => seen.push(name),
        }
    }
}

fn unused_name(name: &str, place: Place) -> Diagnostic {
    Diagnostic { severity: Severity::Warning, ..Diagnostic::error("spec-unused", place) }.arg("name", name)
}

/// Dictionary entries and fragments that nothing uses on any control.
fn unused(catalogue: &Catalogue, found: &mut Vec<Diagnostic>) {
    let mut meanings = BTreeSet::new();
    let mut fragments = BTreeSet::new();
    for cycle in catalogue.controls.values().flat_map(|on| on.cycles.values()) {
        meanings.extend(cycle.params.iter().map(|param| param.is.text.clone()));
        run::used_fragments(cycle, &mut fragments);
    }
    for on in catalogue.controls.values() {
        for fragment in on.fragments.values() {
            run::fragments_of_fragment(fragment, &mut fragments);
        }
    }
    for on in catalogue.controls.values() {
        for (name, meaning) in on.meanings.iter() {
            if !meanings.contains(name.as_str()) {
                found.push(unused_name(name, meaning.place.clone()));
            }
        }
        for (name, fragment) in on.fragments.iter() {
            if !fragments.contains(name.as_str()) {
                found.push(unused_name(name, fragment.fragment.place.clone()));
            }
        }
    }
}
