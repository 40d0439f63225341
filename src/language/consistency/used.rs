//! Whether every parameter of a cycle does something: its run or its checks calculate with it, or a
//! sentence about the run names it.
use std::collections::BTreeSet;

use crate::base::diag::Diagnostic;
use crate::language::locale::{Key, Language, Locales, Scope};
use crate::spec::{self, Catalogue, Cycle, OnControl};

/// Reports parameters that nothing uses. Texts are those of the source language.
pub(super) fn check(catalogue: &Catalogue, locales: &Locales, found: &mut Vec<Diagnostic>) {
    let Some(source) = locales.source() else { return };
    for on in catalogue.controls.values() {
        for cycle in on.cycles.values().filter(|cycle| !cycle.described.as_used) {
            let named = named(cycle, on, source);
            let formulas = formulas(cycle, on);
            for param in &cycle.params {
                let Some(q) = param.q else { continue };
                let calculated = formulas.contains(&q.to_string());
                if !calculated
                    && !named.contains(&format!("q-{}", param.is.as_str()))
                    && !catalogue.explains(on, cycle, param)
                {
                    found.push(
                        Diagnostic::error("spec-unused-parameter", param.place.clone())
                            .arg("cycle", cycle.key.to_string())
                            .arg("q", q.to_string()),
                    );
                }
            }
        }
    }
}

/// The arguments that the sentences of the cycle name; helps and names of parameters are no use of them.
fn named(cycle: &Cycle, on: &OnControl, source: &Language) -> BTreeSet<String> {
    let scope = Scope::new(cycle.name(), on.id());
    let mut names = BTreeSet::new();
    for text in spec::texts(cycle, on) {
        if text.id.starts_with("parameter-") {
            continue;
        }
        let Some((raw, _)) = source.raw(Key { id: &text.id, attribute: text.attribute }, scope) else { continue };
        let mut rest = raw.as_str();
        while let Some((_, inside)) = rest.split_once('‹') {
            let Some((name, after)) = inside.split_once('›') else { break };
            names.insert(name.to_owned());
            rest = after;
        }
    }
    names
}

/// The Q parameters that occur in the formulas of the cycle and its fragments, as their files have them.
fn formulas(cycle: &Cycle, on: &OnControl) -> BTreeSet<String> {
    let mut used = BTreeSet::new();
    // Fragments may use further fragments; a name in a text is enough to look.
    let mut texts = vec![cycle.file.name.place.source.text()];
    let mut rest: Vec<_> = on.fragments.values().collect();
    loop {
        let named = |fragment: &&&spec::Fragment| texts.iter().any(|text| text.contains(fragment.fragment.as_str()));
        let more: Vec<_> = rest.iter().filter(named).map(|fragment| fragment.fragment.place.source.text()).collect();
        if more.is_empty() {
            break;
        }
        rest.retain(|fragment| !more.contains(&fragment.fragment.place.source.text()));
        texts.extend(more);
    }
    for line in texts.into_iter().flat_map(str::lines) {
        // The definition of a parameter and the values of examples are no use of it.
        let line = line.trim_start();
        if ["- {q:", "- q:", "given:", "values:", "why:", "q: {"].iter().any(|head| line.starts_with(head)) {
            continue;
        }
        if line.starts_with("examples:") {
            break;
        }
        let mut words = line.split(|c: char| !c.is_ascii_alphanumeric());
        used.extend(words.by_ref().filter(|word| word.starts_with('Q')).map(str::to_owned));
    }
    used
}
