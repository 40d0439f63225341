//! A call of a cycle that acts when it is defined and must not be called.
//!
//! Certain in two cases: only such cycles are defined before the call; or the call stands directly
//! behind the definition of a pattern, which has called the cycle before it by itself already.
//! Otherwise the call means the last cycle that is called, whatever was defined since. Silent where
//! blocks are repeated, called or skipped, and behind cycles of which nothing is known.
use crate::check::{Definition, Event, Facts, Rule};
use crate::diag::{Diagnostic, Severity};
use crate::spec::{Action, Argument, Body, Cycle, Item, Known, TakesEffect, Verb};

pub(super) const RULE: Rule = Rule { code: "call-of-def-active-cycle", severity: Severity::Error, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    if facts.flow.jumps || facts.flow.programs {
        return;
    }
    let (mut last, mut callable, mut blocks_since): (Option<&Definition<'_>>, bool, usize) = (None, false, 0);
    for event in &facts.events {
        match event {
            Event::Define(index) => {
                last = facts.definitions.get(*index);
                callable |= last.is_none_or(|last| last.takes_effect() != Some(TakesEffect::OnDefinition));
                blocks_since = 0;
            }
            Event::Block => blocks_since += 1,
            Event::Call { span, alone } => {
                let Some(last) = last.filter(|last| last.takes_effect() == Some(TakesEffect::OnDefinition)) else {
                    continue;
                };
                let pattern = matches!(last.known, Known::Described(cycle) if calls_last(cycle));
                if !callable || (pattern && *alone && blocks_since == 1) {
                    found.push(rule.at(facts, *span).arg("cycle", last.key.to_string()));
                }
            }
        }
    }
}

/// Whether a cycle calls the one that was defined before it.
pub(super) fn calls_last(cycle: &Cycle) -> bool {
    cycle.file.run.iter().any(item_calls)
}

fn item_calls(item: &Item) -> bool {
    let body: &Body = &item.body;
    let cases = item.choose.iter().flat_map(|case| &case.actions);
    body.actions.iter().chain(&item.then).chain(cases).any(action_calls)
        || body.items.iter().chain(&item.items).chain(&item.between).any(item_calls)
}

fn action_calls(action: &Action) -> bool {
    action.verb == Verb::Call && matches!(&action.argument, Argument::One(name) if name.as_str() == "last-cycle")
}
