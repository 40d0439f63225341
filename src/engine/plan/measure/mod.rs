//! What the values of runs measure: lengths, angles, feeds, times, plain numbers; and whether a length is a
//! coordinate or a distance.
//!
//! Adding two coordinates, comparing a feed with a length, moving to a distance or milling at an angle is a slip: of
//! the formula or of the dictionary, which then would convert a parameter wrongly in a program in inches. Units go from
//! parameters, fields and known names through formulas, named values, series, fragments and strategies to where they
//! are used. Invariant: a value of which nothing is known passes.
mod value;

use std::collections::BTreeMap;

use super::names::{MAX_INLINED, as_name};
use crate::base::diag::{Diagnostic, Place};
use crate::base::expr::{Dialect, Expr, QRef, parse};
use crate::engine::strategy::registry;
use crate::spec::{
    Action, Argument, Case, Catalogue, Cycle, Entries, Formula, Guard, Item, Name, OnControl, Param, ParameterKind,
    Quantity, Reference, Series, Verb,
};

/// How deep fragments may use each other here.
const DEEPEST: usize = 8;

/// A unit: the exponents of length, time and angle. What has none is a number, a count or a factor.
type Unit = [i8; 3];

const fn unit(quantity: Quantity) -> Unit {
    match quantity {
        Quantity::Length => [1, 0, 0],
        Quantity::Feed => [1, -1, 0],
        Quantity::Time => [0, 1, 0],
        Quantity::Speed => [0, -1, 0],
        Quantity::Angle => [0, 0, 1],
        Quantity::Count | Quantity::Factor | Quantity::Number | Quantity::Text | Quantity::None => [0; 3],
    }
}

/// What is known of a value.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
struct Measure {
    unit: Option<Unit>,
    /// A coordinate (absolute) or a distance (incremental).
    reference: Option<Reference>,
}

const LENGTH: Measure = plain(unit(Quantity::Length));
const COORDINATE: Measure = Measure { reference: Some(Reference::Absolute), ..LENGTH };
const DISTANCE: Measure = Measure { reference: Some(Reference::Incremental), ..LENGTH };
const FEED: Measure = plain(unit(Quantity::Feed));
const ANGLE: Measure = plain(unit(Quantity::Angle));
const NUMBER: Measure = plain([0; 3]);

const fn plain(unit: Unit) -> Measure {
    Measure { unit: Some(unit), reference: None }
}

/// Looks at the formulas of every cycle of every control.
pub(super) fn formulas(catalogue: &Catalogue, found: &mut Vec<Diagnostic>) {
    for on in catalogue.controls.values() {
        for cycle in on.cycles.values() {
            let conditions = &cycle.file.conditions;
            let names = BTreeMap::new();
            let mut reader = Reader { catalogue, on, cycle, conditions, names, inside: 0, inlined: 0, found };
            reader.parameters();
            reader.entries(&cycle.file.lets);
            for (_, formula) in &conditions.0 {
                reader.formula(formula);
            }
            reader.guards(&cycle.file.guards);
            for doubt in &cycle.file.doubts {
                reader.formula(&doubt.when);
            }
            cycle.file.run.iter().for_each(|item| reader.item(item));
        }
    }
}

struct Reader<'r> {
    catalogue: &'r Catalogue,
    on: &'r OnControl,
    cycle: &'r Cycle,
    /// The conditions of the cycle or fragment.
    conditions: &'r Entries<Formula>,
    names: BTreeMap<String, Measure>,
    /// In how many fragments.
    inside: usize,
    /// How many fragments were gone through.
    inlined: usize,
    found: &'r mut Vec<Diagnostic>,
}

/// Kinds of entries that measure nothing: texts, axes, numbers of rows and parameters.
const fn has_unit(kind: ParameterKind) -> bool {
    use ParameterKind::{Integer, Number, NumberOrName, Position};
    matches!(kind, Number | Integer | NumberOrName | Position)
}

/// What a parameter measures.
fn of_param(param: &Param) -> Measure {
    if has_unit(param.kind) {
        Measure { unit: Some(unit(param.quantity)), reference: param.reference }
    } else {
        // A direction may be added to a position, and a text measures nothing.
        Measure::default()
    }
}

/// What the column of a table measures, as far as runs write or read it.
fn of_column(column: &str) -> Measure {
    match column {
        "main" | "minor" | "tool" | "L" | "R" | "R2" | "DL" | "DR" | "DR2" | "LTOL" | "RTOL" | "LBREAK" | "RBREAK"
        | "R-OFFS" | "L-OFFS" | "R_OFFS" | "L_OFFS" => LENGTH,
        "ANGLE" | "T-ANGLE" | "ROT" | "SPC" => ANGLE,
        _ => Measure::default(),
    }
}

impl<'r> Reader<'r> {
    /// Gives old-style fields their names, and refuses units where nothing is measured.
    fn parameters(&mut self) {
        for param in &self.cycle.params {
            if let Some(field) = &param.field {
                let mut measure = of_param(param);
                if param.kind == ParameterKind::Position {
                    measure.reference = None;
                }
                self.names.insert(as_name(field.id.as_str()), measure);
            }
            // Who chooses from whole numbers chooses a way of working, and whole numbers alone count something.
            let chosen = param.choices.len() > 1
                && param.choices.iter().all(|choice| choice.value.as_str().parse::<i32>().is_ok());
            let counts = chosen || param.kind == ParameterKind::Integer || !has_unit(param.kind);
            if counts && unit(param.quantity) != [0; 3] {
                let cycle = self.cycle.key.to_string();
                let diagnostic = Diagnostic::error("spec-measure", param.place.clone());
                self.found.push(diagnostic.arg("reason", "not-a-number").arg("cycle", cycle));
            }
        }
    }

    fn entries(&mut self, lets: &Entries<Formula>) {
        for (name, formula) in &lets.0 {
            let measure = self.formula(formula);
            self.names.insert(name.as_str().to_owned(), measure);
        }
    }

    fn formula(&mut self, formula: &Formula) -> Measure {
        self.value(&formula.expr, &formula.place)
    }

    fn report(&mut self, place: &Place, expr: &Expr, text: &'static str) {
        // A parameter whose odd reference the errata explain says nothing.
        let of_reference = matches!(text, "distance-as-coordinate" | "coordinate-as-distance" | "coordinates-added");
        let explained = of_reference
            && expr
                .q_refs()
                .into_iter()
                .any(|q| self.cycle.param(q).is_some_and(|param| self.catalogue.explains(self.on, self.cycle, param)));
        if !explained {
            self.found.push(
                Diagnostic::error("spec-measure", place.clone())
                    .arg("reason", text)
                    .arg("cycle", self.cycle.key.to_string()),
            );
        }
    }

    /// A value must measure that.
    fn claim(&mut self, formula: &Formula, wanted: Quantity) -> Measure {
        let measure = self.formula(formula);
        self.demand(&formula.expr, &formula.place, measure, wanted);
        measure
    }

    fn demand(&mut self, expr: &Expr, place: &Place, measure: Measure, wanted: Quantity) {
        if measure.unit.is_none_or(|own| own == unit(wanted)) {
            return;
        }
        let reason = match wanted {
            Quantity::Length => "not-a-length",
            Quantity::Angle => "not-an-angle",
            Quantity::Feed => "not-a-feed",
            Quantity::Time => "not-a-time",
            Quantity::Speed => "not-a-speed",
            Quantity::Count | Quantity::Factor | Quantity::Number | Quantity::Text | Quantity::None => "not-a-number",
        };
        self.report(place, expr, reason);
    }

    fn guards(&mut self, guards: &'r [Guard]) {
        for guard in guards {
            if let Some(when) = &guard.when {
                self.formula(when);
            }
            if let Some(fragment) = &guard.r#use {
                self.inline(fragment, &guard.with, None, false);
            }
        }
    }

    /// Goes through a fragment with what its arguments measure; of the guards of a cycle only to its guards.
    fn inline(&mut self, name: &Name, with: &'r Entries<Formula>, bind: Option<&Name>, whole: bool) {
        // That there are too many was found when the run was compiled.
        if self.inside >= DEEPEST || self.inlined >= MAX_INLINED {
            return;
        }
        let Some(fragment) = self.on.fragments.get(name.as_str()) else { return };
        self.inlined += 1;
        // What the run has set is known to all.
        let is_set = |name: &String| name.starts_with('Q');
        let set = self.names.iter().filter(|(name, _)| is_set(name));
        let mut names: BTreeMap<String, Measure> = set.map(|(name, measure)| (name.clone(), *measure)).collect();
        for (name, formula) in &with.0 {
            names.insert(name.as_str().to_owned(), self.formula(formula));
        }
        std::mem::swap(&mut self.names, &mut names);
        let conditions = std::mem::replace(&mut self.conditions, &fragment.conditions);
        self.inside += 1;
        self.entries(&fragment.lets);
        self.guards(&fragment.guards);
        if whole {
            fragment.actions.iter().for_each(|action| self.action(action));
            self.cases(&fragment.choose);
            fragment.then.iter().for_each(|action| self.action(action));
        }
        self.inside -= 1;
        self.conditions = conditions;
        std::mem::swap(&mut self.names, &mut names);
        for (name, measure) in names {
            if is_set(&name) {
                self.names.insert(name, measure);
            } else if let Some(bind) = bind {
                self.names.insert(format!("{}.{name}", bind.as_str()), measure);
            }
        }
    }

    fn item(&mut self, item: &'r Item) {
        if let Some(when) = &item.when {
            self.formula(when);
        }
        if let Some(series) = &item.series {
            self.series(series, item.each.as_ref());
        }
        item.body.actions.iter().for_each(|action| self.action(action));
        self.cases(&item.choose);
        item.then.iter().for_each(|action| self.action(action));
        item.body.items.iter().chain(&item.items).for_each(|inner| self.item(inner));
        if let Some(collect) = &item.collect {
            let measure = self.formula(&collect.value);
            self.names.insert(collect.list.as_str().to_owned(), measure);
        }
        item.between.iter().for_each(|inner| self.item(inner));
    }

    fn cases(&mut self, cases: &'r [Case]) {
        for case in cases {
            for used in &case.case {
                if let Some(formula) = self.conditions.get(used.condition.as_str()) {
                    self.formula(formula);
                }
            }
            case.actions.iter().for_each(|action| self.action(action));
        }
    }

    fn series(&mut self, series: &Series, each: Option<&Name>) {
        let infeeds = series.kind.as_str() == "infeeds";
        for (name, formula) in &series.with.0 {
            let wanted = match name.as_str() {
                "start" | "step" if !infeeds => Quantity::Angle,
                "count" | "of" => Quantity::Count,
                _ => Quantity::Length,
            };
            let measure = self.claim(formula, wanted);
            match name.as_str() {
                "from" | "to" if infeeds && measure.reference == Some(Reference::Incremental) => {
                    self.report(&formula.place, &formula.expr, "distance-as-coordinate");
                }
                "by" | "less" | "least" if infeeds && measure.reference == Some(Reference::Absolute) => {
                    self.report(&formula.place, &formula.expr, "coordinate-as-distance");
                }
                _ => {}
            }
        }
        let Some(each) = each else { return };
        let members = [("from", COORDINATE), ("to", COORDINATE), ("angle", ANGLE), ("i", NUMBER), ("count", NUMBER)];
        for (field, measure) in members {
            self.names.insert(format!("{}.{field}", each.as_str()), measure);
        }
    }

    fn action(&mut self, action: &'r Action) {
        if let Some(when) = &action.when {
            self.formula(when);
        }
        if let Some(at) = &action.at {
            self.claim(at, Quantity::Feed);
        }
        match (action.verb, &action.argument) {
            (Verb::Let, Argument::Many(entries)) => {
                for (name, value) in &entries.0 {
                    if let Some((_, measure)) = self.argument(value) {
                        self.names.insert(name.as_str().to_owned(), measure);
                    }
                }
            }
            (Verb::Rapid | Verb::Feed, Argument::Many(entries)) => {
                for (_, value) in &entries.0 {
                    let Some((expr, measure)) = self.argument(value) else { continue };
                    self.demand(&expr, &action.place, measure, Quantity::Length);
                    if measure.reference == Some(Reference::Incremental) {
                        self.report(&action.place, &expr, "distance-as-coordinate");
                    }
                }
            }
            (Verb::Probe, Argument::Many(entries)) => {
                self.parts(action.verb, entries, &action.place);
                if let Some(bind) = &action.bind {
                    self.names.insert(bind.as_str().to_owned(), LENGTH);
                }
            }
            (
                Verb::Arc | Verb::Synchronized | Verb::Store | Verb::Transform | Verb::Remember,
                Argument::Many(entries),
            ) => {
                self.parts(action.verb, entries, &action.place);
            }
            (Verb::Table, Argument::Many(entries)) => self.table(entries, action),
            (Verb::Set, Argument::Many(entries)) => {
                for (name, value) in &entries.0 {
                    // What is set may be read later.
                    if let Some((_, measure)) = self.argument(value) {
                        self.names.insert(name.as_str().to_owned(), measure);
                    }
                }
            }
            (Verb::Dwell, value) => self.part(value, Quantity::Time, &action.place),
            (Verb::Orient, value) => self.part(value, Quantity::Angle, &action.place),
            (Verb::Lock, value) => self.part(value, Quantity::Number, &action.place),
            (Verb::Fit, Argument::Many(entries)) => self.fit(entries, action),
            (Verb::Use, Argument::One(name)) => self.inline(name, &action.with, action.bind.as_ref(), true),
            (Verb::Strategy, Argument::One(name)) => self.strategy(name, action),
            _ => action.with.0.iter().for_each(|(_, formula)| {
                self.formula(formula);
            }),
        }
    }

    fn part(&mut self, value: &Argument, wanted: Quantity, place: &Place) {
        if let Some((expr, measure)) = self.argument(value) {
            self.demand(&expr, place, measure, wanted);
        }
    }

    /// The named arguments of a verb.
    fn parts(&mut self, verb: Verb, entries: &Entries<Argument>, place: &Place) {
        for (name, value) in &entries.0 {
            let wanted = match (verb, name.as_str()) {
                (Verb::Arc, "centre" | "to") | (Verb::Synchronized, "tool" | "pitch") | (Verb::Probe, "towards") => {
                    Quantity::Length
                }
                (Verb::Probe, "turned") => Quantity::Angle,
                // The sign alone counts: that of an angle will do.
                (Verb::Arc, _) => {
                    if let Some((expr, measure)) = self.argument(value)
                        && measure.unit != ANGLE.unit
                    {
                        self.demand(&expr, place, measure, Quantity::Number);
                    }
                    continue;
                }
                (Verb::Synchronized, _) | (Verb::Store, "next") | (Verb::Transform, "preset") => Quantity::Number,
                (Verb::Store, "value") => {
                    drop(self.argument(value));
                    continue;
                }
                // What is kept measures what the strategy that recalls it gives.
                (Verb::Remember, name) => match registry::recalled(name) {
                    Some(quantity) => quantity,
                    None => continue,
                },
                (Verb::Transform, "datum-shift") => Quantity::Length,
                (Verb::Transform, "datum-row" | "scaling" | "mirroring") => Quantity::Number,
                (Verb::Transform, "rotation" | "tilting") => Quantity::Angle,
                (Verb::Transform, "axis-scaling") => {
                    if let Argument::Many(entries) = value {
                        let parts = [("factors", Quantity::Factor), ("centre", Quantity::Length)];
                        for (part, wanted) in parts {
                            entries.get(part).into_iter().for_each(|field| self.field(field, wanted));
                        }
                    }
                    continue;
                }
                _ => continue,
            };
            if verb == Verb::Transform && name.as_str() != "preset" {
                self.field(value, wanted);
            } else {
                self.part(value, wanted, place);
            }
        }
    }

    /// A field that is named by its id.
    fn field(&mut self, argument: &Argument, wanted: Quantity) {
        let Argument::One(Name { text, place }) = argument else { return };
        if let (Some(measure), Ok(expr)) =
            (self.names.get(&as_name(text)).copied(), parse(&as_name(text), Dialect::Spec))
        {
            self.demand(&expr, place, measure, wanted);
        }
    }

    fn table(&mut self, entries: &Entries<Argument>, action: &Action) {
        let column = match entries.get("column") {
            Some(Argument::One(name)) => of_column(name.as_str()),
            _ => Measure::default(),
        };
        if let Some(row) = entries.get("row") {
            self.part(row, Quantity::Number, &action.place);
        }
        for value in ["add", "value"].into_iter().filter_map(|key| entries.get(key)) {
            match column {
                LENGTH => self.part(value, Quantity::Length, &action.place),
                ANGLE => self.part(value, Quantity::Angle, &action.place),
                _ => drop(self.argument(value)),
            }
        }
        if let Some(bind) = &action.bind {
            self.names.insert(bind.as_str().to_owned(), column);
        }
    }

    fn fit(&mut self, entries: &Entries<Argument>, action: &Action) {
        let points = match entries.get("circle").or_else(|| entries.get("sphere")) {
            Some(Argument::List(points)) => points.iter().filter_map(|point| self.argument(point)).next(),
            Some(list) => self.argument(list),
            None => None,
        };
        if let Some(more) = entries.get("and") {
            self.part(more, Quantity::Length, &action.place);
        }
        if let (Some(bind), Some((expr, measure))) = (&action.bind, points) {
            self.demand(&expr, &action.place, measure, Quantity::Length);
            for field in ["centre", "radius"] {
                self.names.insert(format!("{}.{field}", bind.as_str()), LENGTH);
            }
        }
    }

    fn strategy(&mut self, name: &Name, action: &Action) {
        let Some(strategy) = registry::by_name(name.as_str()) else {
            action.with.0.iter().for_each(|(_, formula)| {
                self.formula(formula);
            });
            return;
        };
        for (name, formula) in &action.with.0 {
            match strategy.parameters.iter().find(|parameter| parameter.name == name.as_str()) {
                Some(parameter) => self.claim(formula, parameter.quantity),
                None => self.formula(formula),
            };
        }
        if let Some(bind) = &action.bind {
            for output in strategy.outputs {
                let measure = plain(unit(output.quantity));
                self.names.insert(format!("{}.{}", bind.as_str(), output.name), measure);
            }
        }
    }

    fn argument(&mut self, argument: &Argument) -> Option<(Expr, Measure)> {
        let Argument::One(Name { text, place }) = argument else { return None };
        let expr = parse(text, Dialect::Spec).ok()?;
        let measure = self.value(&expr, place);
        Some((expr, measure))
    }

    /// A parameter of the cycle, or the field that stands for it.
    fn q(&self, q: QRef) -> Measure {
        let field = |param: &&Param| param.field.as_ref().is_some_and(|field| field.stands_for == Some(q));
        let param = self.cycle.param(q).or_else(|| self.cycle.params.iter().find(field));
        param.map_or_else(|| self.names.get(&q.to_string()).copied().unwrap_or_default(), of_param)
    }
}
