//! A machining cycle called while the spindle stands.
//!
//! Said once a program. The spindle stands at the beginning and behind M0, M2, M5, M6 and M30; behind a tool
//! call and M functions of the machine builder nobody knows. Where blocks are repeated, called or
//! skipped, only a program that never turns the spindle on is objected to.
use crate::check::{Event, Facts, Rule};
use crate::diag::{Diagnostic, Severity};
use crate::spec::{Cycle, Group, Known, TakesEffect};

pub(super) const RULE: Rule = Rule { code: "spindle-off", severity: Severity::Warning, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let turns = |event: &Event| matches!(event, Event::SpindleOn | Event::SpindleUnknown);
    let uncertain = facts.flow.jumps && facts.events.iter().any(turns);
    if facts.flow.programs || facts.flow.opaque || uncertain {
        return;
    }
    // Nothing: nobody knows whether it turns.
    let (mut on, mut machining) = (Some(false), false);
    for event in &facts.events {
        match event {
            Event::SpindleOn => on = Some(true),
            Event::SpindleOff => on = Some(false),
            Event::SpindleUnknown => on = None,
            Event::Tool { .. } if on == Some(true) => on = None,
            Event::Define(index) => {
                let Some(definition) = facts.definitions.get(*index) else { continue };
                if definition.takes_effect() != Some(TakesEffect::OnDefinition) {
                    machining = matches!(definition.known, Known::Described(cycle) if removes_material(cycle));
                }
            }
            Event::Call { span, .. } if machining && on == Some(false) => {
                found.push(rule.at(facts, *span));
                return;
            }
            _ => {}
        }
    }
}

fn removes_material(cycle: &Cycle) -> bool {
    matches!(cycle.file.group, Group::Drilling | Group::Threads | Group::Pockets | Group::Contours | Group::Surfaces)
}
