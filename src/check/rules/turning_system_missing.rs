//! A turning cycle that is called after a tool call without the cycle that aligns the turning system.
//!
//! That cycle acts from its definition up to the next tool call, and the manual wants it before every call of a turning
//! cycle (TNC 640, 001: 7318-7324, 7394). Reported once for each tool call.
use std::collections::BTreeSet;

use crate::base::diag::{Diagnostic, Severity};
use crate::check::cycle::Effect;
use crate::check::{Aspect, Defined, Facts, Loaded, Pending, Rule, Tri};
use crate::spec::{CycleKey, Group};

pub(super) const RULE: Rule = Rule { code: "turning-system-missing", severity: Severity::Warning, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let mut aligning: Option<String> = None;
    let mut reported = BTreeSet::new();
    for call in &facts.run.calls {
        let Pending::Definition(index) = call.modal.pending else { continue };
        let Loaded::By(tool) = call.modal.loaded else { continue };
        let certain = call.modal.is(Aspect::Aligned) == Tri::No && call.modal.is(Aspect::Turning) == Tri::Yes;
        let Some(definition) = facts.definitions.get(index as usize).filter(|_| certain) else { continue };
        if definition.related_cycle().is_none_or(|cycle| cycle.file.group != Group::Turning) {
            continue;
        }
        aligning = aligning.or_else(|| aligning_cycle(facts, definition));
        let Some(own) = &aligning else { return };
        if reported.insert(tool) {
            let finding = rule.at(facts, call.span).arg("cycle", definition.key.to_string());
            found.push(finding.arg("aligning", own.clone()));
        }
    }
}

/// The cycle that aligns the turning system: the one that the program defines elsewhere, or the one of the control.
fn aligning_cycle(facts: &Facts<'_>, turning: &Defined<'_>) -> Option<String> {
    let is_one = |own: &&Defined<'_>| own.related_cycle().is_some_and(|cycle| Effect::of_cycle(cycle).aligns());
    if let Some(own) = facts.definitions.iter().find(is_one) {
        return Some(own.key.to_string());
    }
    let on = facts.against.on;
    let mut keys = on.outlines.range(..turning.key).rev().map(|(key, _)| key);
    let aligns = |key: &&CycleKey| on.cycles.get(*key).is_some_and(|cycle| Effect::of_cycle(cycle).aligns());
    keys.find(aligns).map(ToString::to_string)
}
