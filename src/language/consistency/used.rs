//! Whether every parameter of a cycle does something: its run or its checks calculate with it, or a
//! sentence about the run names it.
use std::collections::{BTreeMap, BTreeSet, HashSet};

use crate::base::diag::Diagnostic;
use crate::language::locale::{Key, Language, Locales, Scope};
use crate::spec::{self, Catalogue, Cycle, OnControl};

/// Reports parameters that nothing uses. Texts are those of the source language.
pub(super) fn check(catalogue: &Catalogue, locales: &Locales, found: &mut Vec<Diagnostic>) {
    let Some(source) = locales.source() else { return };
    for on in catalogue.controls.values() {
        let texts = on.fragments.values().map(|own| (own.fragment.as_str(), own.fragment.place.source.text()));
        let fragments: BTreeMap<&str, Uses> = texts.map(|(name, text)| (name, Uses::of(text))).collect();
        for cycle in on.cycles.values().filter(|cycle| !cycle.described.as_used) {
            let named = named(cycle, on, source);
            let formulas = formulas(cycle, &fragments);
            for param in &cycle.params {
                let Some(q) = param.q else { continue };
                let calculated = formulas.contains(q.to_string().as_str());
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

/// What the text of a specification uses: its words, among them the names of fragments, and its Q parameters.
struct Uses<'t> {
    words: HashSet<&'t str>,
    parameters: BTreeSet<&'t str>,
}

impl<'t> Uses<'t> {
    fn of(text: &'t str) -> Self {
        let words = text.split(|c: char| !c.is_ascii_alphanumeric() && c != '-' && c != '_').collect();
        let mut parameters = BTreeSet::new();
        for line in text.lines() {
            // The definition of a parameter and the values of examples are no use of it.
            let line = line.trim_start();
            if ["- {q:", "- q:", "given:", "values:", "why:", "q: {"].iter().any(|head| line.starts_with(head)) {
                continue;
            }
            if line.starts_with("examples:") {
                break;
            }
            let found = line.split(|c: char| !c.is_ascii_alphanumeric()).filter(|word| word.starts_with('Q'));
            parameters.extend(found);
        }
        Self { words, parameters }
    }
}

/// The Q parameters that occur in the formulas of the cycle and of the fragments that it uses, directly or through others.
fn formulas<'t>(cycle: &'t Cycle, fragments: &BTreeMap<&'t str, Uses<'t>>) -> BTreeSet<&'t str> {
    let own = Uses::of(cycle.file.name.place.source.text());
    let mut used = own.parameters;
    let mut waiting = vec![&own.words];
    let mut rest: Vec<(&str, &Uses)> = fragments.iter().map(|(name, uses)| (*name, uses)).collect();
    while let Some(words) = waiting.pop() {
        rest.retain(|(name, uses)| {
            let is_used = words.contains(name);
            if is_used {
                used.extend(&uses.parameters);
                waiting.push(&uses.words);
            }
            !is_used
        });
    }
    used
}
