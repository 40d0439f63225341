//! Named values, guards and fragments.
//!
//! Invariant: a fragment sees its arguments, the known names and the cycle's Q parameters, never the names
//! of its caller.
use std::sync::Arc;

use super::names::{Binding, MAX_INLINED, Scope};
use super::types::type_of_word;
use super::{Block, Compiler, Guard, Inlined, Let, StandsFor};
use crate::base::diag::{Diagnostic, Place};
use crate::base::expr::Type;
use crate::spec::{self, Entries, Formula, Fragment, Moment, Name, Outcome, Param, ParameterKind, Shape};

/// The type of an old-style field in expressions.
fn field_type(param: &Param) -> Type {
    match param.field.as_ref().map(|field| field.shape) {
        Some(Shape::Position | Shape::AxisDirection | Shape::AxisCoordinate | Shape::Centre) => Type::Point,
        _ => match param.kind {
            ParameterKind::Axis | ParameterKind::AxisDirection => Type::Point,
            ParameterKind::Text | ParameterKind::LabelList => Type::Text,
            _ => Type::Number,
        },
    }
}

impl<'c> Compiler<'c> {
    /// Gives every old-style field a slot, and a name if expressions can use it.
    pub(super) fn old_fields(&mut self, scope: &mut Scope) {
        let cycle = self.cycle;
        for param in &cycle.params {
            let Some(field) = &param.field else { continue };
            let known = self.fields.iter().find(|(_, id)| *id == field.id.text).map(|(slot, _)| *slot);
            let slot = known.unwrap_or_else(|| {
                let slot = self.names.slot();
                self.fields.push((slot, Arc::clone(&field.id.text)));
                let name = super::names::as_name(field.id.as_str());
                self.bind_text(&name, &field.id.place, Binding::Maybe(slot, field_type(param)), scope);
                slot
            });
            if let Some(q) = field.stands_for {
                self.names.allow(q);
                let stands = StandsFor { q, slot, names_it: param.kind == ParameterKind::QNumber };
                if !self.stands_for.contains(&stands) {
                    self.stands_for.push(stands);
                }
            }
        }
    }

    /// Compiles named values in order; each sees those before it.
    pub(super) fn lets(&mut self, lets: &Entries<Formula>, scope: &mut Scope, into: &mut Vec<Let>) {
        for (name, formula) in &lets.0 {
            let calc = self.calc(formula, scope);
            let ty = calc.as_ref().map_or(Type::Number, |calc| calc.code.ty());
            let slot = self.names.slot();
            self.bind(name, Binding::Maybe(slot, ty), scope);
            into.extend(calc.map(|value| Let { slot, value }));
        }
    }

    /// Compiles guards; those of fragments are where they are used, their values go to `lets`.
    pub(super) fn guards(&mut self, guards: &[spec::Guard], scope: &Scope, lets: &mut Vec<Let>) -> Vec<Guard> {
        let mut compiled = Vec::new();
        for guard in guards {
            if let Some(name) = &guard.r#use {
                let Some((fragment, mut inner)) = self.enter(name, &guard.with, &guard.place, scope, lets) else {
                    continue;
                };
                self.lets(&fragment.lets, &mut inner, lets);
                let nested = self.guards(&fragment.guards, &inner, lets);
                compiled.extend(nested);
                self.inside.pop();
                continue;
            }
            compiled.extend(self.guard(guard, scope));
        }
        compiled
    }

    fn guard(&mut self, guard: &spec::Guard, scope: &Scope) -> Option<Guard> {
        let datum = guard.switched_off_by.as_ref();
        if let Some(datum) = datum
            && !self.inside.is_empty()
            && self.on.datum(datum.as_str()).is_none()
        {
            // Guards of cycles are checked with the specification; those of fragments only where they are used.
            let diagnostic = Diagnostic::error("spec-unknown-datum", datum.place.clone());
            self.found.push(diagnostic.arg("name", datum.as_str()).arg("control", self.on.id()));
        }
        let when = self.typed(guard.when.as_ref()?, Type::Bool, scope)?;
        self.code(&guard.code.as_ref()?.text);
        Some(Guard {
            code: Arc::clone(&guard.code.as_ref()?.text),
            when,
            then: guard.then.unwrap_or(Outcome::Error),
            switched_off_by: datum.map(|datum| Arc::clone(&datum.text)),
            at: guard.at.unwrap_or(Moment::Call),
        })
    }

    /// Looks up a fragment and binds its arguments; the caller pops `inside` when it is done.
    fn enter(
        &mut self,
        name: &Name,
        with: &Entries<Formula>,
        place: &Place,
        scope: &Scope,
        lets: &mut Vec<Let>,
    ) -> Option<(&'c Fragment, Scope)> {
        let on: &'c spec::OnControl = self.on;
        let Some(fragment) = on.fragments.get(name.as_str()) else {
            let diagnostic = Diagnostic::error("plan-unknown-fragment", name.place.clone());
            self.found.push(diagnostic.arg("name", name.as_str()));
            return None;
        };
        if self.inside.contains(&name.text) {
            let diagnostic = Diagnostic::error("plan-recursive-fragment", name.place.clone());
            self.found.push(diagnostic.arg("name", name.as_str()));
            return None;
        }
        self.inlined += 1;
        if self.inlined > MAX_INLINED {
            if self.inlined == MAX_INLINED + 1 {
                let diagnostic = Diagnostic::error("plan-too-many-fragments", name.place.clone());
                self.found.push(diagnostic.arg("limit", MAX_INLINED as f64));
            }
            return None;
        }
        let mut inner = Scope::default();
        for (argument, _) in &with.0 {
            if fragment.takes.get(argument.as_str()).is_none() {
                self.unknown_argument(argument, fragment.takes.0.iter().map(|(known, _)| known.as_str()));
            }
        }
        for (argument, word) in &fragment.takes.0 {
            let Some(ty) = type_of_word(word.as_str()) else {
                self.wrong(&word.place, "type-word");
                continue;
            };
            let slot = self.names.slot();
            match with.get(argument.as_str()) {
                Some(formula) => {
                    lets.extend(self.typed(formula, ty, scope).map(|value| Let { slot, value }));
                }
                None => self.missing_argument(place, argument.as_str()),
            }
            self.bind(argument, Binding::Maybe(slot, ty), &mut inner);
        }
        self.inside.push(Arc::clone(&name.text));
        Some((fragment, inner))
    }

    /// A fragment where an action uses it; `bind` makes the names of its actions fields of that name.
    pub(super) fn inline(
        &mut self,
        name: &Name,
        with: &Entries<Formula>,
        bind: Option<&Name>,
        place: &Place,
        scope: &mut Scope,
    ) -> Option<Inlined> {
        let mut lets = Vec::new();
        let (fragment, mut inner) = self.enter(name, with, place, scope, &mut lets)?;
        self.lets(&fragment.lets, &mut inner, &mut lets);
        let guards = self.guards(&fragment.guards, &inner, &mut lets);
        let mark = inner.mark();
        let first = self.acts(&fragment.actions, &mut inner);
        let choose = self.cases(&fragment.choose, &fragment.conditions, &mut inner);
        let then = self.acts(&fragment.then, &mut inner);
        self.inside.pop();
        if let Some(bind) = bind {
            for (field, binding) in inner.since(mark) {
                self.bind_text(&format!("{}.{field}", bind.as_str()), &bind.place, *binding, scope);
            }
        }
        Some(Inlined { lets, guards, block: Block { first, choose, then } })
    }

    pub(super) fn unknown_argument<'n>(&mut self, argument: &Name, known: impl Iterator<Item = &'n str>) {
        let known = known.collect::<Vec<_>>().join(", ");
        let diagnostic = Diagnostic::error("plan-unknown-argument", argument.place.clone());
        self.found.push(diagnostic.arg("name", argument.as_str()).arg("known", known));
    }

    pub(super) fn missing_argument(&mut self, place: &Place, argument: &str) {
        self.found.push(Diagnostic::error("plan-missing-argument", place.clone()).arg("name", argument));
    }
}
