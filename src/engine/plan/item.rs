//! Items of a run: steps, sections, series, choices.
//!
//! Invariant: what is bound inside a series or a case is not seen outside of it; a list is.
use std::sync::Arc;

use super::act::{Block, Case, Collect, Item, Series, SeriesKind, Step};
use super::names::{Binding, Scope};
use super::{Calc, Compiler, Do, SentenceKind};
use crate::base::diag::{Diagnostic, Place};
use crate::base::expr::Type;
use crate::spec::{self, Action, Entries, Formula, Name};

impl SeriesKind {
    /// The fields of a member in the order of their slots.
    pub const fn members(&self) -> &'static [(&'static str, Type)] {
        match self {
            Self::Infeeds { .. } => &[
                ("i", Type::Number),
                ("count", Type::Number),
                ("first", Type::Bool),
                ("last", Type::Bool),
                ("from", Type::Number),
                ("to", Type::Number),
            ],
            Self::Angles { .. } => &[
                ("i", Type::Number),
                ("count", Type::Number),
                ("first", Type::Bool),
                ("last", Type::Bool),
                ("angle", Type::Number),
            ],
            Self::Count { .. } => {
                &[("i", Type::Number), ("count", Type::Number), ("first", Type::Bool), ("last", Type::Bool)]
            }
        }
    }
}

/// The keys of each kind of series, required ones first, and how many are required.
const SERIES: &[(&str, &[&str], usize)] = &[
    ("infeeds", &["from", "to", "by", "less", "least"], 3),
    ("angles", &["start", "step", "count"], 3),
    ("count", &["of"], 1),
];

impl Compiler<'_> {
    pub(super) fn items(&mut self, items: &[spec::Item], scope: &mut Scope) -> Vec<Item> {
        let mut compiled = Vec::new();
        for item in items {
            compiled.extend(self.item(item, scope));
            if let Some(step) = &item.step {
                self.watch(Some(&step.text), scope, &mut compiled);
            }
        }
        compiled
    }

    fn item(&mut self, item: &spec::Item, scope: &mut Scope) -> Option<Item> {
        if let Some(id) = &item.step {
            return self.step(item, id, scope).map(Item::Step);
        }
        if item.group.is_some() {
            let when = self.when(item.when.as_ref(), scope);
            let items = self.items(&item.items, scope);
            return Some(Item::Group { when: when?, items });
        }
        let name = item.each.as_ref()?;
        let mark = scope.mark();
        let series = self.series(item, name, scope);
        let lists: Vec<_> =
            scope.since(mark).iter().filter(|(_, binding)| matches!(binding, Binding::List(..))).cloned().collect();
        scope.leave(mark);
        lists.into_iter().for_each(|(name, binding)| scope.push(name, binding));
        series.map(|series| Item::Each(Box::new(series)))
    }

    fn step(&mut self, item: &spec::Item, id: &Name, scope: &mut Scope) -> Option<Step> {
        let sentence = self.sentence(SentenceKind::Step, &id.text);
        let when = self.when(item.when.as_ref(), scope);
        let conditions = &self.cycle.file.conditions;
        let first = self.acts(&item.body.actions, scope);
        let choose = self.cases(&item.choose, conditions, scope);
        let then = self.acts(&item.then, scope);
        Some(Step { id: Arc::clone(&id.text), sentence, when: when?, block: Block { first, choose, then } })
    }

    pub(super) fn acts(&mut self, actions: &[Action], scope: &mut Scope) -> Vec<Do> {
        actions.iter().filter_map(|action| self.action(action, scope)).collect()
    }

    /// Compiles the cases of a choice with the conditions of the cycle or fragment that they belong to.
    pub(super) fn cases(
        &mut self,
        cases: &[spec::Case],
        conditions: &Entries<Formula>,
        scope: &mut Scope,
    ) -> Vec<Case> {
        let mut compiled = Vec::new();
        let mut bound: Vec<Vec<(String, Binding)>> = Vec::new();
        for case in cases {
            let mut when = Vec::new();
            for used in &case.case {
                // Unknown conditions are reported where specifications are checked.
                let Some(formula) = conditions.get(used.condition.as_str()) else { continue };
                if self.inside.is_empty() {
                    self.used_conditions.insert(Arc::clone(&used.condition.text));
                }
                when.extend(self.typed(formula, Type::Bool, scope).map(|calc| (calc, used.negated)));
            }
            let say = case.say.as_ref().map(|say| self.sentence(SentenceKind::Say, &say.text));
            let mark = scope.mark();
            let acts = self.acts(&case.actions, scope);
            bound.push(scope.since(mark).to_vec());
            scope.leave(mark);
            compiled.push(Case { when, say, acts, exports: Vec::new() });
        }
        if cases.last().is_some_and(|case| case.case.is_empty()) {
            self.export(&bound, &mut compiled, scope);
        }
        compiled
    }

    /// A name that every case binds alike is seen after the choice.
    fn export(&mut self, bound: &[Vec<(String, Binding)>], cases: &mut [Case], scope: &mut Scope) {
        let Some((first, others)) = bound.split_first() else { return };
        for (name, binding) in first {
            let same = |names: &Vec<(String, Binding)>| {
                names.iter().find(|(other, found)| other == name && found.is_like(*binding)).map(|(_, found)| *found)
            };
            let Some(rest) = others.iter().map(same).collect::<Option<Vec<_>>>() else { continue };
            let Some(all) = std::iter::once(*binding).chain(rest).map(Binding::slot).collect::<Option<Vec<_>>>() else {
                continue;
            };
            let slot = self.names.slot();
            for (case, from) in cases.iter_mut().zip(all) {
                case.exports.push((from, slot));
            }
            scope.push(name.as_str(), binding.moved_to(slot));
        }
    }

    /// Conditions that no case uses stand for parameters; they are compiled to be checked.
    pub(super) fn unused_conditions(&mut self, scope: &Scope) {
        let cycle = self.cycle;
        for (name, formula) in &cycle.file.conditions.0 {
            if !self.used_conditions.contains(&name.text) {
                self.typed(formula, Type::Bool, scope);
            }
        }
    }

    fn series(&mut self, item: &spec::Item, name: &Name, scope: &mut Scope) -> Option<Series> {
        let when = self.when(item.when.as_ref(), scope);
        let kind = self.series_kind(item.series.as_ref()?, scope);
        // A list is seen by the items after the series; its type is known only after the body is compiled.
        let mark = scope.mark();
        let members = kind.as_ref().map_or(&[][..], SeriesKind::members);
        if kind.is_none() {
            // One mistake is enough: whatever the member is asked for, it has.
            let slot = self.names.slot();
            self.bind(name, Binding::Open(slot), scope);
        }
        let mut member = 0;
        for (index, (field, ty)) in members.iter().enumerate() {
            let slot = self.names.slot();
            if index == 0 {
                member = slot;
            }
            let full = format!("{}.{field}", name.as_str());
            self.bind_text(&full, &name.place, Binding::Value(slot, *ty), scope);
        }
        let body = self.items(&item.body.items, scope);
        let collect = item.collect.as_ref().map(|collect| self.collect(collect, scope));
        let before = scope.mark();
        let between = self.items(&item.between, scope);
        scope.leave(before);
        if let Some(Some((_, list))) = &collect {
            let lists = [list.clone()];
            scope.leave(mark);
            lists.into_iter().for_each(|(name, binding)| scope.push(name, binding));
        }
        let collect = match collect {
            None => None,
            Some(collect) => Some(collect?.0),
        };
        Some(Series { kind: kind?, member, when: when?, body, between, collect, place: item.place.clone() })
    }

    fn collect(&mut self, collect: &spec::Collect, scope: &mut Scope) -> Option<(Collect, (String, Binding))> {
        let value = self.calc(&collect.value, scope)?;
        let name = collect.list.as_str();
        let binding = match scope.get(name) {
            Some(binding @ Binding::List(_, ty)) if ty == value.code.ty() => binding,
            Some(_) => {
                let diagnostic = Diagnostic::error("plan-name-taken", collect.list.place.clone());
                self.found.push(diagnostic.arg("name", name));
                return None;
            }
            None => {
                self.lists += 1;
                Binding::List(self.lists - 1, value.code.ty())
            }
        };
        let Binding::List(list, _) = binding else { return None };
        Some((Collect { list, value }, (name.to_owned(), binding)))
    }

    fn series_kind(&mut self, series: &spec::Series, scope: &Scope) -> Option<SeriesKind> {
        let kind = series.kind.as_str();
        let Some((_, keys, required)) = SERIES.iter().find(|(known, ..)| *known == kind) else {
            let known = SERIES.iter().map(|(known, ..)| *known).collect::<Vec<_>>().join(", ");
            let diagnostic = Diagnostic::error("plan-unknown-series", series.kind.place.clone());
            self.found.push(diagnostic.arg("name", kind).arg("known", known));
            return None;
        };
        for (key, _) in &series.with.0 {
            if !keys.contains(&key.as_str()) {
                self.unknown_argument(key, keys.iter().copied());
            }
        }
        let mut calc = |key: &str| self.series_value(series, key, scope, &series.kind.place, keys, *required);
        Some(match kind {
            "infeeds" => {
                let (from, to, by, less, least) = (calc("from"), calc("to"), calc("by"), calc("less"), calc("least"));
                SeriesKind::Infeeds { from: from??, to: to??, by: by??, less: less?, least: least? }
            }
            "angles" => {
                let (start, step, count) = (calc("start"), calc("step"), calc("count"));
                SeriesKind::Angles { start: start??, step: step??, count: count?? }
            }
            _ => SeriesKind::Count { of: calc("of")?? },
        })
    }

    /// The value of a key of a series; nothing after a mistake, an inner nothing if it is not there.
    fn series_value(
        &mut self,
        series: &spec::Series,
        key: &str,
        scope: &Scope,
        place: &Place,
        keys: &[&str],
        required: usize,
    ) -> Option<Option<Calc>> {
        match series.with.get(key) {
            Some(formula) => self.typed(formula, Type::Number, scope).map(Some),
            None if keys.iter().position(|known| *known == key).is_some_and(|index| index >= required) => Some(None),
            None => {
                self.missing_argument(place, key);
                None
            }
        }
    }
}
