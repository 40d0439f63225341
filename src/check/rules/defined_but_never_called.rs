//! A cycle that acts when it is called, and is not called before the next one is defined.
//!
//! A pattern behind it calls it. Where blocks are repeated, called or skipped, only a program without
//! any call is objected to; where other programs are called, none: they may call it.
use super::call_of_def_active_cycle::calls_last;
use crate::check::{Definition, Event, Facts, Rule};
use crate::diag::{Diagnostic, Severity};
use crate::spec::{Known, TakesEffect};

pub(super) const RULE: Rule = Rule { code: "defined-but-never-called", severity: Severity::Warning, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    if facts.flow.programs || facts.flow.modal {
        return;
    }
    let calls = |event: &Event| match event {
        Event::Call { .. } => true,
        Event::Define(index) => facts.definitions.get(*index).is_some_and(calls_by_itself),
        _ => false,
    };
    if facts.flow.jumps && facts.events.iter().any(calls) {
        return;
    }
    let mut waiting: Option<&Definition<'_>> = None;
    let mut uncalled = Vec::new();
    for event in &facts.events {
        if calls(event) {
            waiting = None;
        } else if let Event::Define(index) = event
            && let Some(definition) = facts.definitions.get(*index)
            && definition.takes_effect() != Some(TakesEffect::OnDefinition)
        {
            uncalled.extend(waiting.take());
            // Of a cycle that is not described nobody knows when it acts.
            waiting = Some(definition).filter(|definition| definition.takes_effect().is_some());
        }
    }
    for definition in uncalled.into_iter().chain(waiting) {
        found.push(rule.at(facts, definition.view.head).arg("cycle", definition.key.to_string()));
    }
}

fn calls_by_itself(definition: &Definition<'_>) -> bool {
    matches!(definition.known, Known::Described(cycle) if calls_last(cycle))
}
