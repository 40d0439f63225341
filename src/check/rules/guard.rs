//! The guards of the specifications: what the control itself refuses, skips, doubts or asks.
//!
//! Each finding has the code of the guard. Only numbers and texts that the definition writes are
//! known; guards that a machine datum switches off count as active.
use std::collections::{BTreeMap, BTreeSet};
use std::sync::{Mutex, OnceLock, PoisonError};

use crate::check::guards::{self, Ready, Written, read_as};
use crate::check::{Definition, Facts, Item, Rule};
use crate::diag::{Diagnostic, Severity, Span};
use crate::spec::{Cycle, CycleKey, Outcome, Param};
use crate::text;

pub(super) const RULE: Rule = Rule { code: "guard", severity: Severity::Error, run };

fn run(_: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let mut known: BTreeMap<CycleKey, Vec<Ready<'_>>> = BTreeMap::new();
    for (definition, cycle) in facts.described() {
        let written = Written::of(facts, definition, cycle);
        let guards = known.entry(definition.key).or_insert_with(|| guards::of(facts.against.on, cycle));
        for ready in guards.iter() {
            if written.holds(ready) == Some(true) {
                found.extend(finding(facts, definition, cycle, ready));
            }
        }
    }
}

fn finding(facts: &Facts<'_>, definition: &Definition<'_>, cycle: &Cycle, ready: &Ready<'_>) -> Option<Diagnostic> {
    let code = ready.guard.code.as_ref()?;
    let severity = match ready.guard.then {
        Some(Outcome::Error) | None => Severity::Error,
        Some(Outcome::Skip | Outcome::Warn | Outcome::Confirm) => Severity::Warning,
    };
    let place = place(definition, ready).unwrap_or(definition.view.head);
    let rule = Rule { code: lasting(code.as_str()), severity, run };
    let sentence = text::guard_sentence(facts.against.on, cycle, code.as_str(), facts.against.readers);
    Some(rule.at(facts, place).arg("message", sentence.unwrap_or_else(|| code.as_str().to_owned())))
}

/// The first parameter written that the guard reads, rather one that measures something than one that chooses.
fn place(definition: &Definition<'_>, ready: &Ready<'_>) -> Option<Span> {
    let read = ready.condition.q_refs();
    let reads = |param: &Param| read_as(param).is_some_and(|q| read.contains(&q));
    let items = definition.items.iter().filter(|item| item.param.is_some_and(reads));
    let chooses = |item: &&Item<'_>| item.param.is_some_and(|param| !param.choices.is_empty());
    items.min_by_key(chooses).map(|item| item.span)
}

/// The code for as long as the program runs. There are as many as the specifications have guards.
fn lasting(code: &str) -> &'static str {
    static CODES: OnceLock<Mutex<BTreeSet<&'static str>>> = OnceLock::new();
    let mut codes = CODES.get_or_init(Mutex::default).lock().unwrap_or_else(PoisonError::into_inner);
    if let Some(known) = codes.get(code) {
        return known;
    }
    let lasting: &'static str = Box::leak(code.to_owned().into_boxed_str());
    codes.insert(lasting);
    lasting
}
