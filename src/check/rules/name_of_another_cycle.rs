//! A definition with the printed name of another cycle: number or name is not the one that is meant.
//!
//! Controls read the number only. Silent where the name is one of the cycle itself in any language, or is none that is
//! known; a part of names is known if only cycles of one other group have it in theirs. Cycles that the control's
//! manuals only name are known by that name and by those that another control's manuals have; there a name that is a
//! part of an own one, or has an own one in it, is passed over, too.
use std::collections::HashMap;

use crate::base::diag::{Diagnostic, Severity};
use crate::check::cycle::fold;
use crate::check::{Defined, Facts, Rule};
use crate::spec::{CycleKey, Known};

pub(super) const RULE: Rule = Rule { code: "name-of-another-cycle", severity: Severity::Warning, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    // Long programs have the same names again and again.
    let mut known: HashMap<(CycleKey, &str), Option<CycleKey>> = HashMap::new();
    for definition in facts.definitions.iter().filter(|own| !facts.has_usual_labels(own)) {
        let Some(span) = definition.view.name else { continue };
        let name = facts.text(span);
        let other = *known.entry((definition.key, name)).or_insert_with(|| other(facts, definition, &fold(name)));
        if let Some(other) = other {
            let finding = rule.at(facts, span).arg("name", name).arg("cycle", definition.key.to_string());
            found.push(finding.arg("other", other.to_string()));
        }
    }
}

/// The other cycle to which the name of a definition belongs.
fn other(facts: &Facts<'_>, definition: &Defined<'_>, folded: &str) -> Option<CycleKey> {
    if matches!(definition.known, Known::Named(_)) {
        return named_elsewhere(facts, definition.key, folded);
    }
    let labels = facts.labels(definition)?;
    if folded.is_empty() || labels.languages.iter().any(|own| own.name.matches_folded(folded)) {
        return None;
    }
    match facts.against.labels.named(folded) {
        [other, ..] => Some(*other),
        [] => part_of_another(facts, definition, folded),
    }
}

/// The least letters of a part of a name that says a group.
const LEAST: usize = 5;

/// The first cycle of the only group whose cycles have a name within theirs, if that is another one.
fn part_of_another(facts: &Facts<'_>, definition: &Defined<'_>, folded: &str) -> Option<CycleKey> {
    let own = definition.cycle()?;
    let touches = |name: &str| name.contains(folded) || folded.contains(name);
    if folded.chars().count() < LEAST || has_name(facts, definition.key, touches) {
        return None;
    }
    let others = facts.against.on.cycles.keys().filter(|other| other.keyword == own.key.keyword);
    let having = others.filter(|other| has_name(facts, **other, |name| name.contains(folded)));
    let having = having.filter_map(|other| facts.against.on.cycles.get(other));
    let mut first = None;
    for other in having {
        let before = *first.get_or_insert(other);
        if other.file.group != before.file.group || other.file.group == own.file.group {
            return None;
        }
    }
    first.map(|other| other.key)
}

/// The other cycle that the name of one that the control's manuals only name belongs to.
fn named_elsewhere(facts: &Facts<'_>, key: CycleKey, folded: &str) -> Option<CycleKey> {
    let is_own = |own: &str| own.contains(folded) || folded.contains(own);
    if folded.is_empty() || has_name(facts, key, is_own) {
        return None;
    }
    let named = facts.against.on.control.named.iter().map(|own| CycleKey::new(own.keyword, own.number));
    named
        .filter(|other| *other != key && other.keyword == key.keyword)
        .find(|other| has_name(facts, *other, |own| own == folded))
}

/// Whether one of the names of a cycle, as the overviews of the control's manuals or another control's manuals in any
/// language have it, is such.
fn has_name(facts: &Facts<'_>, key: CycleKey, is: impl Fn(&str) -> bool) -> bool {
    let against = &facts.against;
    if against.on.named(key).is_some_and(|named| is(&fold(&named.name))) {
        return true;
    }
    let names = against.labels.names_anywhere(against.catalogue, key);
    names.is_some_and(|names| names.iter().any(|name| is(name)))
}
