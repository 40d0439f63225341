//! A parameter that the same definition has had before, be it as a number and as a name.
use std::collections::HashMap;

use crate::check::{Facts, Item, Rule};
use crate::diag::{Diagnostic, Place, Severity};

pub(super) const RULE: Rule = Rule { code: "duplicate-parameter", severity: Severity::Error, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    for definition in &facts.definitions {
        let mut seen: HashMap<String, &Item<'_>> = HashMap::new();
        for item in &definition.items {
            let repeats = item.param.is_some_and(|param| param.field.as_ref().is_some_and(|field| field.repeat));
            let q = item.param.and_then(|param| param.q);
            let first = *seen.entry(q.map_or_else(|| item.name.to_string(), |q| q.to_string())).or_insert(item);
            // Fields without a printed word have no name to tell them apart by.
            let named = item.name.starts_with('Q') || item.name.ends_with(':');
            if named && !repeats && !std::ptr::eq(first, item) {
                let place = Place::new(facts.program.source(), first.span);
                let finding = rule.at(facts, item.span).arg("parameter", item.name.as_ref());
                found.push(finding.arg("cycle", definition.key.to_string()).related("first-place", place));
            }
        }
    }
}
