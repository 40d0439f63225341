//! A definition with Q parameters of a cycle that no manual of this control describes, measured by that of another control:
//! a parameter is missing, or a value is one that the other control refuses.
//!
//! Newer software adds parameters at the end, so only those are missed behind which another one of the cycle stands.
//! Parameters in addition, names and labels are left alone.
use std::collections::HashMap;

use crate::check::guards::{self, Ready, Written};
use crate::check::values::{refused, shown};
use crate::check::{Defined, Facts, Rule};
use crate::diag::{Diagnostic, Severity};
use crate::spec::{Cycle, CycleKey, Known, OnControl, Outcome, Refusal};
use crate::syntax::{CycleForm, ValueKind};
use crate::text;

pub(super) const RULE: Rule = Rule { code: "unlike-elsewhere", severity: Severity::Warning, run };

/// What another control knows of a cycle.
struct Other<'a> {
    on: &'a OnControl,
    cycle: &'a Cycle,
    guards: Vec<Ready>,
}

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let mut others: HashMap<CycleKey, Option<Other<'_>>> = HashMap::new();
    for definition in &facts.definitions {
        let silent = matches!(definition.known, Known::Described(_) | Known::Builders);
        if silent || definition.torn || !matches!(definition.view.form, CycleForm::Parameters(_)) {
            continue;
        }
        if let Some(other) = others.entry(definition.key).or_insert_with(|| Other::of(facts, definition.key)) {
            other.compare(rule, facts, definition, found);
        }
    }
}

impl<'a> Other<'a> {
    /// The control with the highest id that describes the cycle.
    fn of(facts: &Facts<'a>, key: CycleKey) -> Option<Self> {
        facts.against.catalogue.controls.values().rev().find_map(|on| match on.known(key) {
            Known::Described(cycle) => Some(Self { on, cycle, guards: guards::of(on, cycle) }),
            _ => None,
        })
    }

    fn compare(&self, rule: &Rule, facts: &Facts<'a>, own: &Defined<'a>, found: &mut Vec<Diagnostic>) {
        let own = own.read_as(self.cycle);
        let read = facts.read(&own);
        let tell = |span, what: &'static str| {
            let finding = rule.at(facts, span).arg("what", what).arg("cycle", own.key.to_string());
            finding.arg("control", self.on.control.title.as_str())
        };
        let last = read.items.iter().filter_map(|item| item.index).max();
        for param in &read.missing {
            let place = self.cycle.params.iter().position(|own| std::ptr::eq(own, *param));
            if place < last {
                found.push(tell(own.view.head, "missing").arg("parameter", param.label_in(own.key.number)));
            }
        }
        for item in &read.items {
            let number = matches!(item.value.map(|value| value.kind), Some(ValueKind::Number(_) | ValueKind::Q { .. }));
            let refusal = refused(item, facts.inch).filter(|own| number && *own != Refusal::Kind);
            if refusal.is_some() {
                let finding = tell(item.value_span, "value").arg("parameter", item.name.as_ref());
                found.push(finding.arg("value", shown(item)));
            }
        }
        let written = Written::of(facts, &read, self.cycle);
        for ready in self.guards.iter().filter(|own| matches!(own.then, Some(Outcome::Error) | None)) {
            let (Some(code), Some(true)) = (&ready.code, written.holds(ready)) else { continue };
            let sentence = text::guard_sentence(self.on, self.cycle, code, facts.against.readers);
            let place = super::guard::place(&read, ready, &written).unwrap_or(own.view.head);
            found.push(tell(place, "guard").arg("message", sentence.unwrap_or_else(|| code.clone())));
        }
    }
}
