//! A definition of a cycle that no manual of this control describes, measured by that of another control: a parameter
//! is missing, doubled, foreign or after one that it precedes, its label is that of another parameter, or its value is
//! one that the other control refuses or that is hardly meant.
//!
//! Newer software adds Q parameters at the end, so only those are missed after which another one of the cycle is,
//! and of those in addition only parameters of other cycles that are amid the cycle's, or have a lower
//! number. Names and labels that no one knows are passed over.
use std::collections::{HashMap, HashSet};

use super::missing_parameter::gap;
use crate::base::diag::{Diagnostic, Severity, Span};
use crate::base::expr::{QKind, QRef};
use crate::check::cycle::fold;
use crate::check::cycle::{Ready, guards_of};
use crate::check::guards::{Written, place};
use crate::check::program::{refused, refused_by_all, shown};
use crate::check::{Defined, Definition, Facts, Item, Rule};
use crate::language::text;
use crate::program::syntax::{CycleForm, ValueKind};
use crate::spec::{Cycle, CycleKey, Known, OnControl, Outcome};

pub(super) const RULE: Rule = Rule { code: "differs-from-other-control", severity: Severity::Warning, run };

/// What another control knows of a cycle.
pub(super) struct Other<'a> {
    pub(super) on: &'a OnControl,
    pub(super) cycle: &'a Cycle,
    pub(super) guards: Vec<Ready>,
}

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let mut others: HashMap<CycleKey, Option<Other<'_>>> = HashMap::new();
    for definition in &facts.definitions {
        if definition.torn || matches!(definition.known, Known::Described(_) | Known::Builders) {
            continue;
        }
        match others.entry(definition.key).or_insert_with(|| Other::of(facts, definition.key)) {
            Some(other) => other.compare(rule, facts, definition, found),
            None => alone(rule, facts, definition, found),
        }
    }
}

/// A cycle that no one describes: a value that every cycle with the parameter refuses.
fn alone(rule: &Rule, facts: &Facts<'_>, own: &Defined<'_>, found: &mut Vec<Diagnostic>) {
    let CycleForm::Parameters(written) = &own.view.form else { return };
    for parameter in written.parameters.iter() {
        let number = match parameter.value.kind {
            ValueKind::Number(number) => Some(number),
            ValueKind::Q { negative, .. } => facts.known_at(parameter.value.span, negative),
            _ => None,
        };
        if number.is_some() && refused_by_all(facts, parameter.q, &parameter, number, ENOUGH) == Some(true) {
            let finding = rule.at(facts, parameter.value.span).arg("what", "alone").arg("cycle", own.key.to_string());
            let finding = finding.arg("parameter", parameter.q.to_string()).arg("control", "");
            found.push(finding.arg("value", facts.text(parameter.value.span).trim()));
        }
    }
}

/// So many cycles say what a parameter means.
const ENOUGH: usize = 3;

impl<'a> Other<'a> {
    /// The control with the highest id that describes the cycle.
    pub(super) fn of(facts: &Facts<'a>, key: CycleKey) -> Option<Self> {
        let (on, cycle) = facts.against.catalogue.describing(key)?;
        Some(Self { on, cycle, guards: guards_of(on, cycle) })
    }

    fn compare(&self, rule: &Rule, facts: &Facts<'a>, own: &Defined<'a>, found: &mut Vec<Diagnostic>) {
        let lines = matches!(own.view.form, CycleForm::Lines(_));
        if lines != self.cycle.is_old_style() {
            return;
        }
        let own = own.read_as(self.cycle);
        let read = facts.read(&own);
        // Another cycle may have the number here.
        if !read.items.is_empty() && read.items.iter().all(|item| item.index.is_none()) {
            return;
        }
        let tell = |span, what: &'static str| {
            let finding = rule.at(facts, span).arg("what", what).arg("cycle", own.key.to_string());
            finding.arg("control", self.on.control.title.as_str())
        };
        let last = read.items.iter().filter_map(|item| item.index).max();
        for param in &read.missing {
            let place = self.cycle.params.iter().position(|own| std::ptr::eq(own, *param));
            if lines || place < last {
                found.push(tell(gap(&read, param), "missing").arg("parameter", param.label_in(own.key.number)));
            }
        }
        let mut before: Option<&Item<'_>> = None;
        let (mut names, last_known) = (HashSet::new(), read.items.iter().rposition(is_known));
        for (at, item) in read.items.iter().enumerate() {
            let name = item.name.as_ref();
            // Words for feeds are many, and PREDEF may stand for any parameter.
            let word = matches!(item.value.map(|value| value.kind), Some(ValueKind::Word));
            if (lines || !word) && refused(item, facts.inch).is_some() {
                found.push(tell(item.value_span, "value").arg("parameter", name).arg("value", shown(item)));
            }
            if lines {
                continue;
            }
            if !names.insert(name) {
                found.push(tell(item.span, "twice").arg("parameter", name));
            } else if item.index.is_none() && self.is_foreign(facts, item, Some(at) < last_known) {
                found.push(tell(item.span, "foreign").arg("parameter", name));
            } else if let Some(before) = before.filter(|before| item.index.is_some() && item.index < before.index) {
                found.push(tell(item.span, "order").arg("parameter", name).arg("before", before.name.as_ref()));
            }
            before = Some(item).filter(|item| is_known(item)).or(before);
        }
        self.labels(facts, &read, |span, item, other| {
            let finding = tell(span, "label").arg("label", facts.text(span)).arg("parameter", item.name.as_ref());
            found.push(finding.arg("other", other));
        });
        let written = Written::of(facts, &read, self.cycle);
        for ready in &self.guards {
            let (Some(code), Some(true)) = (&ready.code, written.holds(ready)) else { continue };
            let sentence = text::guard_sentence(self.on, self.cycle, code, facts.against.readers);
            let place = place(&read, ready, &written).unwrap_or(own.view.head);
            let what = if matches!(ready.then, Some(Outcome::Error) | None) { "guard" } else { "doubt" };
            found.push(tell(place, what).arg("message", sentence.unwrap_or_else(|| code.clone())));
        }
        super::doubtful_value::each(&super::doubtful_value::RULE, facts, &read, found);
        super::clearance_height_too_low::each(&super::clearance_height_too_low::RULE, facts, &read, found);
    }

    /// Whether a parameter that the cycle does not have belongs to another one, or comes before one that it has.
    fn is_foreign(&self, facts: &Facts<'_>, item: &Item<'_>, amid: bool) -> bool {
        let Some(q) = QRef::parse(&item.name).filter(|q| matches!(q.kind, QKind::Q | QKind::Qs)) else { return false };
        let controls = || facts.against.catalogue.controls.values();
        let has = controls().filter_map(|on| on.cycles.get(&self.cycle.key)).any(|own| own.written(q).is_some());
        // What newer software adds has a number above those of the cycle.
        let older = self.cycle.params.iter().filter_map(|param| param.q).any(|own| q.number < own.number);
        !has && (amid || older) && controls().any(|on| on.all_written(q).next().is_some())
    }

    /// Labels of another parameter of the cycle, in whatever language.
    fn labels<'d>(
        &self,
        facts: &Facts<'_>,
        read: &'d Definition<'_>,
        mut tell: impl FnMut(Span, &'d Item<'_>, String),
    ) {
        let mut labels = None;
        for item in &read.items {
            let (Some(own), Some(span)) = (item.index, item.label) else { continue };
            let labels = labels.get_or_insert_with(|| facts.against.labels.labels_elsewhere(self.on, self.cycle));
            let folded = fold(facts.text(span));
            let languages = || labels.languages.iter().map(|language| &language.params);
            if languages().any(|params| params.get(own).is_some_and(|label| label.matches_folded(&folded))) {
                continue;
            }
            let other = languages().find_map(|params| params.iter().position(|label| label.matches_folded(&folded)));
            if let Some(other) = other.and_then(|at| self.cycle.params.get(at)) {
                tell(span, item, other.label_in(self.cycle.key.number));
            }
        }
    }
}

fn is_known(item: &Item<'_>) -> bool {
    item.index.is_some()
}
