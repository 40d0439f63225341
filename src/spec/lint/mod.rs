//! What can be wrong with specifications beyond their form: each file of checks looks at one part.
//!
//! Invariant: knows no language and no engine; whether texts exist is checked where texts are, and
//! whether a run compiles is checked where runs are compiled.
mod example;
mod figure;
mod habit;
mod names;
mod parameter;
mod reference;
mod run;
mod worked;
pub use habit::equals;
pub(super) use run::walk;

use std::collections::BTreeSet;

use super::catalogue::{Catalogue, Cycle, OnControl};
use crate::base::diag::{Diagnostic, dedupe};
use names::{slug, unused_name};

/// All findings about the catalogue; what several controls share shows once.
pub fn lint(catalogue: &Catalogue) -> Vec<Diagnostic> {
    let mut found = Vec::new();
    for on in catalogue.controls.values() {
        reference::control(on, &mut found);
        worked::worked(on, &mut found);
        for cycle in on.cycles.values() {
            lint_cycle(cycle, on, &mut found);
        }
    }
    reference::errata(catalogue, &mut found);
    habit::habits(catalogue, &mut found);
    reference::topics(catalogue, &mut found);
    reference::pages(catalogue, &mut found);
    parameter::limits(catalogue, &mut found);
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
    figure::figures(cycle, on, found);
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
