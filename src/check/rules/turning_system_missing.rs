//! A turning cycle that is called after a tool call without the cycle that aligns the turning system.
//!
//! That cycle acts from its definition up to the next tool call, and the manual wants it before every call of a turning
//! cycle (TNC 640, 001: 7318-7324, 7394). Only reported of programs that define it before another call, once for each
//! tool call.
use std::collections::BTreeSet;

use crate::base::diag::{Diagnostic, Severity};
use crate::check::cycle::Effect;
use crate::check::{Aspect, Defined, Facts, Loaded, Pending, Rule, Tri};
use crate::spec::Group;

pub(super) const RULE: Rule = Rule { code: "turning-system-missing", severity: Severity::Warning, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let mut aligning: Option<&Defined<'_>> = None;
    let mut reported = BTreeSet::new();
    for call in &facts.run.calls {
        let Pending::Definition(index) = call.modal.pending else { continue };
        let Loaded::By(tool) = call.modal.loaded else { continue };
        let certain = call.modal.is(Aspect::Aligned) == Tri::No && call.modal.is(Aspect::Turning) == Tri::Yes;
        let Some(definition) = facts.definitions.get(index as usize).filter(|_| certain) else { continue };
        if definition.related_cycle().is_none_or(|cycle| cycle.file.group != Group::Turning) {
            continue;
        }
        if aligning.is_none() {
            let is_one = |own: &&Defined<'_>| own.related_cycle().is_some_and(|cycle| Effect::of_cycle(cycle).aligns());
            aligning = facts.definitions.iter().find(is_one);
        }
        let Some(own) = aligning else { return };
        if reported.insert(tool) {
            let finding = rule.at(facts, call.span).arg("cycle", definition.key.to_string());
            found.push(finding.arg("aligning", own.key.to_string()));
        }
    }
}
