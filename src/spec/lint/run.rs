//! Runs: their tree is well formed, ids are unique, conditions and guards are complete and used.
use std::collections::BTreeSet;
use std::sync::Arc;

use super::super::catalogue::{Cycle, OnControl};
use super::super::decode::{Entries, Formula, Name};
use super::super::form::{Fragment, Guard};
use super::super::run_form::{Action, Argument, Case, ConditionUse, Item};
use super::super::vocabulary::Verb;
use crate::base::diag::{Diagnostic, Place};
use crate::base::expr::QRef;

pub(super) fn run(cycle: &Cycle, on: &OnControl, found: &mut Vec<Diagnostic>) {
    let mut steps = Vec::new();
    for item in &cycle.file.run {
        walk(item, &mut |item| {
            tree(item, found);
            steps.extend([&item.step, &item.until].into_iter().flatten().cloned());
        });
    }
    steps.iter().for_each(|step| super::names::slug(step, found));
    super::names::duplicates(&steps, found);
    if steps.is_empty() {
        found.push(Diagnostic::error("spec-no-steps", cycle.file.name.place.clone()));
    }
    let mut used = BTreeSet::new();
    used.extend(cycle.params.iter().filter_map(|param| param.effective.as_ref().map(|name| Arc::clone(&name.text))));
    for item in &cycle.file.run {
        walk(item, &mut |item| cases(&item.choose, &cycle.file.conditions, &mut used, found));
    }
    for (name, _) in &cycle.file.conditions.0 {
        super::names::slug(name, found);
        if !used.contains(&name.text) {
            found.push(Diagnostic::warning("spec-unused", name.place.clone()).arg("name", name.as_str()));
        }
    }
    guards(&cycle.file.guards, on, found);
    results(cycle, found);
    for fragment in on.fragments.values() {
        let mut used = BTreeSet::new();
        cases(&fragment.choose, &fragment.conditions, &mut used, found);
        guards(&fragment.guards, on, found);
    }
}

/// Calls `visit` for the item and every item in it.
pub(in crate::spec) fn walk(item: &Item, visit: &mut dyn FnMut(&Item)) {
    visit(item);
    for inner in item.body.items.iter().chain(&item.items).chain(&item.between) {
        walk(inner, visit);
    }
}

/// An item is exactly one of step, section and series, and has only what belongs to it.
fn tree(item: &Item, found: &mut Vec<Diagnostic>) {
    let heads = [item.step.is_some(), item.group.is_some(), item.each.is_some()];
    let wrong = |what: &'static str| Diagnostic::error("spec-run-item", item.place.clone()).arg("reason", what);
    if heads.iter().filter(|head| **head).count() != 1 {
        found.push(wrong("one-head"));
        return;
    }
    let series_only =
        item.series.is_some() || item.until.is_some() || !item.between.is_empty() || item.collect.is_some();
    if item.each.is_none() && series_only {
        found.push(wrong("series-keys"));
    }
    if item.each.is_some() && (item.series.is_none() || item.body.items.is_empty() || !item.body.actions.is_empty()) {
        found.push(wrong("series-body"));
    }
    if item.step.is_some() && (!item.items.is_empty() || !item.body.items.is_empty()) {
        found.push(wrong("step-body"));
    }
    if item.group.is_some() && (item.items.is_empty() || !item.body.actions.is_empty() || !item.body.items.is_empty()) {
        found.push(wrong("group-body"));
    }
    if item.step.is_none() && (!item.choose.is_empty() || !item.then.is_empty() || item.by.is_some()) {
        found.push(wrong("step-keys"));
    }
}

fn cases(cases: &[Case], known: &Entries<Formula>, used: &mut BTreeSet<Arc<str>>, found: &mut Vec<Diagnostic>) {
    for (index, case) in cases.iter().enumerate() {
        if case.case.is_empty() && index + 1 < cases.len() {
            found.push(Diagnostic::error("spec-otherwise-last", case.place.clone()));
        }
        if let Some(earlier) = cases[..index].iter().find(|other| covers(&other.case, &case.case)) {
            found.push(
                Diagnostic::error("spec-case-never-reached", case.place.clone())
                    .related("first-place", earlier.place.clone()),
            );
        }
        for ConditionUse { condition, .. } in &case.case {
            used.insert(Arc::clone(&condition.text));
            if known.get(condition.as_str()).is_none() {
                found.push(
                    Diagnostic::error("spec-unknown-condition", condition.place.clone())
                        .arg("name", condition.as_str()),
                );
            }
        }
    }
}

/// Whether the first case takes everything that the second would take.
fn covers(first: &[ConditionUse], second: &[ConditionUse]) -> bool {
    let same = |a: &ConditionUse, b: &ConditionUse| a.condition == b.condition && a.negated == b.negated;
    first.iter().all(|a| second.iter().any(|b| same(a, b)))
}

fn guards(guards: &[Guard], on: &OnControl, found: &mut Vec<Diagnostic>) {
    super::names::duplicates(guards.iter().filter_map(|guard| guard.code.as_ref()), found);
    for guard in guards {
        let own = [guard.code.is_some(), guard.when.is_some(), guard.then.is_some()];
        let complete = if guard.r#use.is_some() { own == [false; 3] } else { own == [true; 3] };
        if !complete {
            found.push(Diagnostic::error("spec-guard-keys", guard.place.clone()));
        }
        if let Some(code) = &guard.code {
            super::names::slug(code, found);
        }
        if let Some(name) = &guard.r#use {
            fragment_exists(name, on, found);
        }
    }
}

/// A result has a number that no parameter of the cycle has, and a run sets results and parameters only.
fn results(cycle: &Cycle, found: &mut Vec<Diagnostic>) {
    let report = |place: &Place, q: QRef, reason: &'static str| {
        let diagnostic = Diagnostic::error("spec-odd-result", place.clone()).arg("reason", reason);
        diagnostic.arg("q", q.to_string()).arg("cycle", cycle.key.to_string())
    };
    for result in &cycle.file.results {
        if let Some(q) = result.q.filter(|q| cycle.param(*q).is_some()) {
            found.push(report(&result.is.place, q, "parameter"));
        }
    }
    let fields: Vec<QRef> = cycle.params.iter().filter_map(|param| param.field.as_ref()?.stands_for).collect();
    let results = || cycle.file.results.iter().filter_map(|result| result.q);
    let is_known = |q: QRef| cycle.param(q).is_some() || fields.contains(&q) || results().any(|own| own == q);
    for item in &cycle.file.run {
        walk(item, &mut |item| {
            let in_cases = item.choose.iter().flat_map(|case| &case.actions);
            for action in item.body.actions.iter().chain(&item.then).chain(in_cases) {
                let (Verb::Set, Argument::Many(entries)) = (action.verb, &action.argument) else { continue };
                let set = entries.0.iter().filter_map(|(name, _)| Some((name, QRef::parse(name.as_str())?)));
                found
                    .extend(set.filter(|(_, q)| !is_known(*q)).map(|(name, q)| report(&name.place, q, "not-a-result")));
            }
        });
    }
}

fn fragment_exists(name: &Name, on: &OnControl, found: &mut Vec<Diagnostic>) {
    if !on.fragments.contains_key(name.as_str()) {
        found.push(Diagnostic::error("spec-unknown-fragment", name.place.clone()).arg("name", name.as_str()));
    }
}

fn action(action: &Action, used: &mut BTreeSet<Arc<str>>) {
    if let (Verb::Use, Argument::One(name)) = (action.verb, &action.argument) {
        used.insert(Arc::clone(&name.text));
    }
}

fn guard_uses(guards: &[Guard], used: &mut BTreeSet<Arc<str>>) {
    used.extend(guards.iter().filter_map(|guard| guard.r#use.as_ref().map(|name| Arc::clone(&name.text))));
}

/// The names of the fragments that a cycle uses.
pub(super) fn used_fragments(cycle: &Cycle, used: &mut BTreeSet<Arc<str>>) {
    guard_uses(&cycle.file.guards, used);
    for figure in cycle.file.figures.iter() {
        used.extend(figure.dimensions.iter().filter_map(|own| own.r#use.as_ref()).map(|name| Arc::clone(&name.text)));
    }
    for item in &cycle.file.run {
        walk(item, &mut |item| {
            let in_cases = item.choose.iter().flat_map(|case| &case.actions);
            item.body.actions.iter().chain(&item.then).chain(in_cases).for_each(|a| action(a, used));
        });
    }
}

/// The names of the fragments that a fragment uses.
pub(super) fn fragments_of_fragment(fragment: &Fragment, used: &mut BTreeSet<Arc<str>>) {
    guard_uses(&fragment.guards, used);
    let in_cases = fragment.choose.iter().flat_map(|case| &case.actions);
    fragment.actions.iter().chain(&fragment.then).chain(in_cases).for_each(|a| action(a, used));
}
