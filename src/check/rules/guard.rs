//! The guards of the specifications: what the control itself refuses, skips, doubts or asks.
//!
//! Each finding has the code of the guard. Only numbers and texts that the definition writes are
//! known; guards that a machine datum switches off count as active.
use std::collections::BTreeSet;
use std::sync::{Mutex, OnceLock, PoisonError};

use super::together;
use crate::check::guards::{Ready, Written, read_as};
use crate::check::{Definition, Facts, Item, Rule};
use crate::diag::{Diagnostic, Severity, Span};
use crate::spec::{Cycle, Outcome};
use crate::text;

pub(super) const RULE: Rule = Rule { code: "guard", severity: Severity::Error, run: together };

pub(super) fn each(_: &Rule, facts: &Facts<'_>, definition: &Definition<'_>, found: &mut Vec<Diagnostic>) {
    let Some((cycle, kept)) = definition.cycle().zip(definition.kept) else { return };
    let guards = facts.against.labels.guards_of(cycle, kept);
    if guards.is_empty() {
        return;
    }
    let written = Written::of(facts, definition, cycle);
    for ready in guards {
        if written.holds(ready) == Some(true) {
            found.extend(finding(facts, definition, cycle, ready, &written));
        }
    }
}

fn finding(
    facts: &Facts<'_>,
    definition: &Definition<'_>,
    cycle: &Cycle,
    ready: &Ready,
    written: &Written,
) -> Option<Diagnostic> {
    let code = ready.code.as_deref()?;
    let severity = match ready.then {
        Some(Outcome::Error) | None => Severity::Error,
        Some(Outcome::Skip | Outcome::Warn | Outcome::Confirm) => Severity::Warning,
    };
    let place = place(definition, ready, written).unwrap_or(definition.view.head);
    let rule = Rule { code: lasting(code), severity, run: together };
    let sentence = text::guard_sentence(facts.against.on, cycle, code, facts.against.readers);
    Some(rule.at(facts, place).arg("message", sentence.unwrap_or_else(|| code.to_owned())))
}

/// The first parameter written that the guard reads, rather one that measures something than one that chooses, and one
/// that its last condition reads.
pub(super) fn place(definition: &Definition<'_>, ready: &Ready, written: &Written) -> Option<Span> {
    let reads = ready.way(written)?.reads(written);
    let rank = |item: &Item<'_>| {
        let param = item.param?;
        let q = read_as(param)?;
        Some((!param.choices.is_empty(), reads.iter().position(|own| own.contains(&q))?))
    };
    let ranked = definition.items.iter().filter_map(|item| Some((rank(item)?, item)));
    ranked.min_by_key(|(rank, _)| *rank).map(|(_, item)| item.span)
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
