//! Verbs: each action typed into what the engine does.
//!
//! Invariant: one verb, one meaning; a modifier or key that means nothing to the verb is a mistake.
use std::sync::Arc;

use super::act::{Act, Cancel, Cooling, Do, Fitted, SpindleTurn, StrategyCall, Target, Transform};
use super::names::{Binding, Scope};
use super::{Calc, Compiler, Let, Slot};
use crate::base::diag::{Diagnostic, Place};
use crate::base::expr::{QKind, QRef, Type};
use crate::engine::strategy::registry::{self, Strategy};
use crate::engine::strategy::signature::AT;
use crate::engine::table::TableKind;
use crate::spec::{Action, Argument, Entries, Formula, Name, ParameterKind, Verb};

/// The axes of the working plane as keys of a target.
const AXES: [&str; 3] = ["main", "minor", "tool"];

impl Compiler<'_> {
    pub(super) fn action(&mut self, action: &Action, scope: &mut Scope) -> Option<Do> {
        let when = self.when(action.when.as_ref(), scope);
        self.modifiers(action);
        let act = self.act(action, scope);
        Some(Do { when: when?, act: act?, place: action.place.clone() })
    }

    /// Reports modifiers that the verb does not take.
    fn modifiers(&mut self, action: &Action) {
        use Verb::{Ask, Feed, Fit, Log, Probe, Strategy, Table, Use};
        let verb = action.verb;
        let takes_feed = matches!(verb, Feed | Verb::Arc | Strategy);
        let binds = matches!(verb, Probe | Fit | Table | Use | Strategy | Ask);
        let takes_values = matches!(verb, Use | Strategy | Log);
        let mut refuse = |given: bool, takes: bool, modifier: &'static str| {
            if given && !takes {
                let diagnostic = Diagnostic::error("plan-modifier", action.place.clone());
                self.found.push(diagnostic.arg("verb", verb.as_str()).arg("modifier", modifier));
            }
        };
        refuse(action.at.is_some(), takes_feed, "at");
        refuse(action.bind.is_some(), binds, "as");
        refuse(!action.with.0.is_empty(), takes_values, "with");
    }

    fn act(&mut self, action: &Action, scope: &mut Scope) -> Option<Act> {
        let (argument, place) = (&action.argument, &action.place);
        Some(match action.verb {
            Verb::Rapid => Act::Rapid(self.target(argument, place, scope)?),
            Verb::Feed => {
                let target = self.target(argument, place, scope);
                let feed = match &action.at {
                    Some(at) => self.typed(at, Type::Number, scope),
                    None => {
                        self.missing_argument(place, "at");
                        None
                    }
                };
                Act::Feed(target?, feed?)
            }
            Verb::Arc => self.arc(action, scope)?,
            Verb::Dwell => Act::Dwell(self.argument(argument, Type::Number, scope, place)?),
            Verb::Probe => self.probe(action, scope)?,
            Verb::Call => match self.one(argument, "last-cycle", place)?.as_str() {
                "last-cycle" => Act::CallLast,
                _ => return self.wrong_act(place, "last-cycle"),
            },
            Verb::Set => Act::Set(self.set(argument, place, scope)?),
            Verb::Store => self.store(argument, place, scope)?,
            Verb::Let => Act::Let(self.let_names(argument, place, scope)?),
            Verb::Transform => Act::Transform(self.transform(argument, place, scope)?),
            Verb::Table => self.table(action, scope)?,
            Verb::Log => {
                let screen = matches!(argument, Argument::Many(_));
                let name = if screen {
                    let entries = self.entries(argument, &["screen"], place)?;
                    self.required_word(entries, "screen", place)?
                } else {
                    self.one(argument, "id", place)?
                };
                let with = self.values(&action.with, scope);
                Act::Log { name: name.text, screen, with }
            }
            Verb::Fit => self.fit(action, scope)?,
            Verb::Lock => Act::Lock(self.argument(argument, Type::Number, scope, place)?),
            Verb::Spindle => match self.one(argument, "spindle-word", place)?.as_str() {
                "clockwise" => Act::Spindle(SpindleTurn::Clockwise),
                "counter-clockwise" => Act::Spindle(SpindleTurn::CounterClockwise),
                "stop" => Act::Spindle(SpindleTurn::Stop),
                _ => return self.wrong_act(place, "spindle-word"),
            },
            Verb::Orient => Act::Orient(self.argument(argument, Type::Number, scope, place)?),
            Verb::Coolant => match self.one(argument, "coolant-word", place)?.as_str() {
                "flood" => Act::Coolant(Cooling::On),
                "stop" => Act::Coolant(Cooling::Off),
                _ => return self.wrong_act(place, "coolant-word"),
            },
            Verb::Fail => {
                let code = self.one(argument, "id", place)?.text;
                self.code(&code);
                Act::Fail(code)
            }
            Verb::Message => Act::Message(self.one(argument, "id", place)?.text),
            Verb::Ask => {
                let id = self.one(argument, "id", place)?.text;
                let into = action.bind.as_ref().map(|name| self.result(name, Type::Bool, scope));
                Act::Ask { id, into }
            }
            Verb::Use => {
                let name = self.one(argument, "id", place)?;
                Act::Use(Box::new(self.inline(&name, &action.with, action.bind.as_ref(), place, scope)?))
            }
            Verb::Strategy => self.strategy(action, scope)?,
            Verb::Synchronized => self.synchronized(argument, place, scope)?,
            Verb::Remember => Act::Remember(self.remembered(argument, place, scope)?),
        })
    }

    fn wrong_act(&mut self, place: &Place, expected: &'static str) -> Option<Act> {
        self.wrong(place, expected);
        None
    }

    /// A slot for the result of an action.
    fn result(&mut self, name: &Name, ty: Type, scope: &mut Scope) -> usize {
        let slot = self.names.slot();
        self.bind(name, Binding::Maybe(slot, ty), scope);
        slot
    }

    fn open_result(&mut self, name: Option<&Name>, scope: &mut Scope) {
        if let Some(name) = name {
            let slot = self.names.slot();
            self.bind(name, Binding::Open(slot), scope);
        }
    }

    /// The entries of a mapping whose keys are all known.
    fn entries<'a>(&mut self, argument: &'a Argument, keys: &[&str], place: &Place) -> Option<&'a Entries<Argument>> {
        let Argument::Many(entries) = argument else {
            self.wrong(place, "mapping");
            return None;
        };
        for (key, _) in &entries.0 {
            if !keys.contains(&key.as_str()) {
                self.unknown_argument(key, keys.iter().copied());
            }
        }
        Some(entries)
    }

    /// The value of a key that must be there.
    fn required(
        &mut self,
        entries: &Entries<Argument>,
        key: &str,
        ty: Type,
        place: &Place,
        scope: &Scope,
    ) -> Option<Calc> {
        match entries.get(key) {
            Some(argument) => self.argument(argument, ty, scope, place),
            None => {
                self.missing_argument(place, key);
                None
            }
        }
    }

    /// The word of a key that must be there.
    fn required_word(&mut self, entries: &Entries<Argument>, key: &str, place: &Place) -> Option<Name> {
        match entries.get(key) {
            Some(argument) => self.one(argument, "id", place),
            None => {
                self.missing_argument(place, key);
                None
            }
        }
    }

    fn target(&mut self, argument: &Argument, place: &Place, scope: &Scope) -> Option<Target> {
        let entries = self.entries(argument, &["main", "minor", "tool", "to"], place)?;
        if let Some(point) = entries.get("to") {
            if entries.0.len() > 1 {
                self.wrong(place, "point-or-axes");
            }
            return self.argument(point, Type::Point, scope, place).map(Target::Point);
        }
        if entries.0.is_empty() {
            self.wrong(place, "point-or-axes");
            return None;
        }
        let mut axes = [None, None, None];
        for (axis, key) in axes.iter_mut().zip(AXES) {
            if let Some(argument) = entries.get(key) {
                *axis = Some(self.argument(argument, Type::Number, scope, place)?);
            }
        }
        Some(Target::Axes(axes))
    }

    fn arc(&mut self, action: &Action, scope: &Scope) -> Option<Act> {
        let place = &action.place;
        let entries = self.entries(&action.argument, &["centre", "to", "direction"], place)?;
        let centre = self.required(entries, "centre", Type::Point, place, scope);
        let to = self.required(entries, "to", Type::Point, place, scope);
        let direction = self.required(entries, "direction", Type::Number, place, scope);
        let feed = match &action.at {
            Some(at) => Some(self.typed(at, Type::Number, scope)?),
            None => None,
        };
        Some(Act::Arc { centre: centre?, to: to?, direction: direction?, feed })
    }

    fn synchronized(&mut self, argument: &Argument, place: &Place, scope: &Scope) -> Option<Act> {
        let entries = self.entries(argument, &["tool", "pitch", "speed_factor"], place)?;
        let tool = self.required(entries, "tool", Type::Number, place, scope);
        let pitch = self.required(entries, "pitch", Type::Number, place, scope);
        let speed_factor = match entries.get("speed_factor") {
            Some(factor) => Some(self.argument(factor, Type::Number, scope, place)?),
            None => None,
        };
        Some(Act::Synchronized { tool: tool?, pitch: pitch?, speed_factor })
    }

    fn probe(&mut self, action: &Action, scope: &mut Scope) -> Option<Act> {
        self.probes = true;
        let entries = self.entries(&action.argument, &["towards", "turned"], &action.place)?;
        let towards = self.required(entries, "towards", Type::Point, &action.place, scope);
        let turned = match entries.get("turned") {
            Some(argument) => Some(self.argument(argument, Type::Number, scope, &action.place)?),
            None => None,
        };
        let into = action.bind.as_ref().map(|name| self.result(name, Type::Point, scope));
        Some(Act::Probe { towards: towards?, turned, into })
    }

    fn set(&mut self, argument: &Argument, place: &Place, scope: &Scope) -> Option<Vec<(QRef, Calc)>> {
        let Argument::Many(entries) = argument else {
            self.wrong(place, "mapping");
            return None;
        };
        let mut values = Vec::new();
        for (key, argument) in &entries.0 {
            let Some(q) = QRef::parse(key.as_str()) else {
                self.wrong(&key.place, "q-parameter");
                continue;
            };
            let ty = if q.kind == QKind::Qs { Type::Text } else { Type::Number };
            values.extend(self.argument(argument, ty, scope, place).map(|calc| (q, calc)));
            self.names.allow(q);
        }
        Some(values)
    }

    fn remembered(&mut self, argument: &Argument, place: &Place, scope: &Scope) -> Option<Vec<(Arc<str>, Calc)>> {
        let Argument::Many(entries) = argument else {
            self.wrong(place, "mapping");
            return None;
        };
        let mut values = Vec::new();
        for (name, argument) in &entries.0 {
            let formula = self.one(argument, "expression", place).and_then(|text| self.formula(&text));
            let calc = formula.and_then(|formula| self.calc(&formula, scope));
            values.extend(calc.map(|calc| (Arc::clone(&name.text), calc)));
        }
        Some(values)
    }

    fn store(&mut self, argument: &Argument, place: &Place, scope: &Scope) -> Option<Act> {
        let entries = self.entries(argument, &["field", "next", "value"], place)?;
        let field = self.required_word(entries, "field", place);
        let value = self.required(entries, "value", Type::Number, place, scope);
        let next = match entries.get("next") {
            Some(argument) => Some(self.argument(argument, Type::Number, scope, place)?),
            None => None,
        };
        let field = self.field(&field?, Some(ParameterKind::QNumber))?;
        Some(Act::Store { field, next, value: value? })
    }

    /// The id of an old-style field of this cycle.
    fn field(&mut self, name: &Name, kind: Option<ParameterKind>) -> Option<Arc<str>> {
        let is_it = |param: &&crate::spec::Param| param.field.as_ref().is_some_and(|field| field.id == *name);
        match self.cycle.params.iter().find(is_it) {
            Some(param) if kind.is_none_or(|kind| kind == param.kind) => Some(Arc::clone(&name.text)),
            Some(_) => {
                self.wrong(&name.place, "q-number-field");
                None
            }
            None => {
                let diagnostic = Diagnostic::error("plan-unknown-field", name.place.clone());
                self.found.push(diagnostic.arg("name", name.as_str()));
                None
            }
        }
    }

    fn let_names(&mut self, argument: &Argument, place: &Place, scope: &mut Scope) -> Option<Vec<Let>> {
        let Argument::Many(entries) = argument else {
            self.wrong(place, "mapping");
            return None;
        };
        let mut lets = Vec::new();
        for (name, argument) in &entries.0 {
            let value = self.one(argument, "expression", place).and_then(|text| self.formula(&text));
            let calc = value.and_then(|formula| self.calc(&formula, scope));
            let ty = calc.as_ref().map_or(Type::Number, |calc| calc.code.ty());
            let slot = self.result(name, ty, scope);
            lets.extend(calc.map(|value| Let { slot, value }));
        }
        Some(lets)
    }

    fn transform(&mut self, argument: &Argument, place: &Place, scope: &Scope) -> Option<Transform> {
        let keys = [
            "datum-shift",
            "datum-row",
            "rotation",
            "mirroring",
            "scaling",
            "axis-scaling",
            "tilting",
            "preset",
            "cancel",
        ];
        let entries = self.entries(argument, &keys, place)?;
        let [(key, argument)] = entries.0.as_slice() else {
            self.wrong(place, "one-transform");
            return None;
        };
        if key.as_str() == "preset" {
            return self.argument(argument, Type::Number, scope, place).map(Transform::Preset);
        }
        if key.as_str() == "cancel" {
            return self.cancel(argument, place);
        }
        if key.as_str() == "axis-scaling" {
            let entries = self.entries(argument, &["factors", "centre"], place)?;
            let (factors, centre) =
                (self.required_word(entries, "factors", place)?, self.required_word(entries, "centre", place)?);
            return Some(Transform::AxisScaling(self.field(&factors, None)?, self.field(&centre, None)?));
        }
        let name = self.one(argument, "id", place)?;
        let field = self.field(&name, None)?;
        match key.as_str() {
            "mirroring" => Some(Transform::Mirroring(field)),
            "scaling" => Some(Transform::Scaling(field)),
            "tilting" => Some(Transform::Tilting(field)),
            "datum-shift" => Some(Transform::DatumShift(field)),
            "datum-row" => Some(Transform::DatumRow(field)),
            "rotation" => Some(Transform::Rotation(field)),
            _ => None,
        }
    }

    fn cancel(&mut self, argument: &Argument, place: &Place) -> Option<Transform> {
        let Argument::List(words) = argument else {
            self.wrong(place, "list");
            return None;
        };
        let mut ended = Vec::new();
        for word in words {
            let word = self.one(word, "cancel-word", place)?;
            match Cancel::by_word(word.as_str()) {
                Some(cancel) => ended.push(cancel),
                None => self.wrong(&word.place, "cancel-word"),
            }
        }
        Some(Transform::Cancel(ended))
    }

    fn table(&mut self, action: &Action, scope: &mut Scope) -> Option<Act> {
        let place = &action.place;
        let entries = self.entries(&action.argument, &["table", "row", "column", "add", "value"], place)?;
        let table = self.required_word(entries, "table", place);
        let row = self.required(entries, "row", Type::Number, place, scope);
        let column = self.required_word(entries, "column", place);
        let (table, column) = (table?, column?.text);
        let Some(table) = TableKind::by_word(table.as_str()) else {
            let known = TableKind::ALL.map(TableKind::as_str).join(", ");
            let diagnostic = Diagnostic::error("plan-unknown-table", table.place.clone());
            self.found.push(diagnostic.arg("name", table.as_str()).arg("known", known));
            return None;
        };
        let written = match (entries.get("add"), entries.get("value")) {
            (None, None) => None,
            (Some(argument), None) => Some((argument, true)),
            (None, Some(argument)) => Some((argument, false)),
            (Some(_), Some(_)) => return self.wrong_act(place, "add-or-value"),
        };
        match (written, &action.bind) {
            (None, Some(name)) => {
                let into = self.result(name, Type::Number, scope);
                Some(Act::ReadTable { table, row: row?, column, into })
            }
            (Some((argument, add)), None) => {
                let value = self.argument(argument, Type::Number, scope, place)?;
                Some(Act::WriteTable { table, row: row?, column, value, add })
            }
            _ => self.wrong_act(place, "read-or-write"),
        }
    }

    fn values(&mut self, with: &Entries<Formula>, scope: &Scope) -> Vec<(Arc<str>, Calc)> {
        let mut values = Vec::new();
        for (name, formula) in &with.0 {
            values.extend(self.calc(formula, scope).map(|calc| (Arc::clone(&name.text), calc)));
        }
        values
    }

    fn fit(&mut self, action: &Action, scope: &mut Scope) -> Option<Act> {
        let place = &action.place;
        let entries = self.entries(&action.argument, &["circle", "sphere", "and"], place)?;
        let sphere = entries.get("sphere").is_some();
        let shape = if sphere { "sphere" } else { "circle" };
        let also = match entries.get("and") {
            Some(_) => Some(self.required(entries, "and", Type::Point, place, scope)?),
            None => None,
        };
        let points = match entries.get(shape) {
            Some(Argument::List(items)) => {
                let points = items.iter().map(|item| self.argument(item, Type::Point, scope, place));
                Some(Fitted::Points(points.collect::<Option<Vec<_>>>()?))
            }
            _ => None,
        };
        let list = if points.is_none() { Some(self.required_word(entries, shape, place)?) } else { None };
        let Some(name) = &action.bind else {
            self.missing_argument(place, "as");
            return None;
        };
        let (centre, radius) = (self.names.slot(), self.names.slot());
        let full = |field: &str| format!("{}.{field}", name.as_str());
        self.bind_text(&full("centre"), &name.place, Binding::Maybe(centre, Type::Point), scope);
        self.bind_text(&full("radius"), &name.place, Binding::Maybe(radius, Type::Number), scope);
        let (Some(list), None) = (list, &points) else {
            return points.map(|points| Act::Fit { sphere, points, also, centre, radius });
        };
        match scope.get(list.as_str()) {
            Some(Binding::List(list, Type::Point)) => {
                Some(Act::Fit { sphere, points: Fitted::List(list), also, centre, radius })
            }
            Some(_) => self.wrong_act(&list.place, "list-of-points"),
            None => {
                let diagnostic = Diagnostic::error("plan-unknown-name", list.place.clone());
                self.found.push(diagnostic.arg("name", list.as_str()));
                None
            }
        }
    }

    fn strategy(&mut self, action: &Action, scope: &mut Scope) -> Option<Act> {
        let name = self.one(&action.argument, "id", &action.place)?;
        let strategy = match registry::by_name(name.as_str()) {
            Some(strategy) => strategy,
            None => {
                let diagnostic = Diagnostic::error("plan-unknown-strategy", name.place.clone());
                let near = registry::near(name.as_str()).join(", ");
                self.found.push(diagnostic.arg("name", name.as_str()).arg("near", near));
                self.open_strategy(action, scope);
                return None;
            }
        };
        self.probes |= strategy.probes;
        self.known_arguments(strategy, action);
        let mut with = Vec::with_capacity(strategy.parameters.len());
        for parameter in strategy.parameters {
            let given = if parameter.is_feed_of_path() { action.at.as_ref() } else { action.with.get(parameter.name) };
            with.push(match given {
                Some(formula) => Some(self.typed(formula, parameter.ty, scope)?),
                None if parameter.required => {
                    self.missing_argument(&action.place, parameter.name);
                    return None;
                }
                None => None,
            });
        }
        let results = match &action.bind {
            Some(bind) => self.results_of(strategy, bind, scope),
            None => Vec::new(),
        };
        Some(Act::Strategy(StrategyCall { strategy, with, results }))
    }

    /// One that the engine does not have: its arguments are formulas, and its results may have any name.
    fn open_strategy(&mut self, action: &Action, scope: &mut Scope) {
        self.values(&action.with, scope);
        if let Some(at) = &action.at {
            self.typed(at, Type::Number, scope);
        }
        self.open_result(action.bind.as_ref(), scope);
    }

    /// Reports what a strategy does not take.
    fn known_arguments(&mut self, strategy: &Strategy, action: &Action) {
        let named = || strategy.parameters.iter().filter(|parameter| !parameter.is_feed_of_path());
        for (key, _) in &action.with.0 {
            if !named().any(|parameter| parameter.name == key.as_str()) {
                self.unknown_argument(key, named().map(|parameter| parameter.name));
            }
        }
        if let Some(at) = &action.at
            && named().count() == strategy.parameters.len()
        {
            let diagnostic = Diagnostic::error("plan-modifier", at.place.clone());
            self.found.push(diagnostic.arg("verb", strategy.name).arg("modifier", AT));
        }
    }

    /// Slots for the results of a strategy, as fields of a name.
    fn results_of(&mut self, strategy: &Strategy, bind: &Name, scope: &mut Scope) -> Vec<Slot> {
        if strategy.outputs.is_empty() {
            self.wrong(&bind.place, "no-result");
        }
        let mut results = Vec::with_capacity(strategy.outputs.len());
        for output in strategy.outputs {
            let slot = self.names.slot();
            let full = format!("{}.{}", bind.as_str(), output.name);
            self.bind_text(&full, &bind.place, Binding::Maybe(slot, Type::Number), scope);
            results.push(slot);
        }
        results
    }
}
