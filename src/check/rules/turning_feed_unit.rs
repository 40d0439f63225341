//! A feed of a turning cycle that fits the other unit: millimetres for a revolution while M136 is not active, or for a
//! minute while it is.
//!
//! With M136 before the cycle the control reads its feeds in mm for a revolution, without it in mm/min (TNC 640, 001:
//! 7308, 7321, 7524). Only reported where M136 is known at the call, of values that no one means in the unit that acts,
//! and of programs in mm.
use std::collections::BTreeSet;

use crate::base::diag::{Diagnostic, Severity};
use crate::check::{Aspect, Facts, Pending, Rule};
use crate::program::syntax::ValueKind;
use crate::spec::Group;

pub(super) const RULE: Rule = Rule { code: "turning-feed-unit", severity: Severity::Warning, run };

/// The meanings of the feeds.
const FEEDS: [&str; 2] = ["turning-roughing-feed", "turning-finishing-feed"];
/// Less than this is no feed of a minute, mm.
const LEAST: f64 = 1.0;
/// More than this is no feed of a revolution, mm.
const GREATEST: f64 = 20.0;

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    if facts.inch {
        return;
    }
    let (mut seen, mut reported) = (BTreeSet::new(), BTreeSet::new());
    for call in &facts.run.calls {
        let Pending::Definition(index) = call.modal.pending else { continue };
        let Some(revolution) = call.modal.is(Aspect::PerRevolution).known() else { continue };
        let Some(definition) = facts.definitions.get(index as usize) else { continue };
        if definition.related_cycle().is_none_or(|cycle| cycle.file.group != Group::Turning) {
            continue;
        }
        if !seen.insert((index, revolution)) {
            continue;
        }
        let related = definition.as_related_cycle();
        for item in &facts.read(&related).items {
            if item.param.is_none_or(|param| !FEEDS.contains(&param.is.as_str())) {
                continue;
            }
            let number = match item.value.map(|value| value.kind) {
                Some(ValueKind::Number(number)) => Some(number),
                _ => item.number,
            };
            let wrong = match (number, revolution) {
                (Some(number), true) => number > GREATEST,
                (Some(number), false) => 0.0 < number && number < LEAST,
                (None, _) => false,
            };
            if wrong && reported.insert(item.value_span.start) {
                let finding = rule.at(facts, item.value_span).arg("parameter", item.name.as_ref());
                let finding = finding.arg("value", item.printed.as_ref());
                found.push(finding.arg("what", if revolution { "revolution" } else { "minute" }));
            }
        }
    }
}
