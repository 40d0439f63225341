//! What formulas measure: lengths, angles, feeds, times; and whether a length is a coordinate or a distance.
//!
//! Adding two coordinates, comparing a feed with a length or moving to a distance is a slip. Invariant: only
//! what the dictionary says is used; a value of which nothing is known passes.
use std::collections::BTreeMap;

use super::super::catalogue::{Catalogue, Cycle, OnControl};
use super::super::decode::{Entries, Formula, Name};
use super::super::form::{Action, Argument, Item};
use super::super::vocabulary::{Quantity, Reference, Verb};
use crate::diag::{Diagnostic, Place};
use crate::expr::{Dialect, Expr, Func, Node, Op, QRef, parse};

/// What is known of a value.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
struct Measure {
    quantity: Option<Quantity>,
    /// A coordinate (absolute) or a distance (incremental).
    reference: Option<Reference>,
}

const LENGTH: Measure = Measure { quantity: Some(Quantity::Length), reference: None };
const COORDINATE: Measure = Measure { quantity: Some(Quantity::Length), reference: Some(Reference::Absolute) };
const DISTANCE: Measure = Measure { quantity: Some(Quantity::Length), reference: Some(Reference::Incremental) };

const fn plain(quantity: Quantity) -> Measure {
    Measure { quantity: Some(quantity), reference: None }
}

pub(super) fn formulas(catalogue: &Catalogue, found: &mut Vec<Diagnostic>) {
    for on in catalogue.controls.values() {
        for cycle in on.cycles.values() {
            let mut reader = Reader { catalogue, on, cycle, names: BTreeMap::new(), found };
            reader.entries(&cycle.file.lets);
            for (_, formula) in &cycle.file.conditions.0 {
                reader.formula(formula);
            }
            for formula in cycle.file.guards.iter().filter_map(|guard| guard.when.as_ref()) {
                reader.formula(formula);
            }
            cycle.file.run.iter().for_each(|item| reader.item(item));
        }
    }
}

struct Reader<'r> {
    catalogue: &'r Catalogue,
    on: &'r OnControl,
    cycle: &'r Cycle,
    names: BTreeMap<String, Measure>,
    found: &'r mut Vec<Diagnostic>,
}

impl Reader<'_> {
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
        // A parameter whose odd reference or quantity the errata explain says nothing.
        let explained = expr
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

    fn item(&mut self, item: &Item) {
        if let Some(series) = &item.series {
            for (name, formula) in &series.with.0 {
                let measure = self.formula(formula);
                let infeeds = series.kind.as_str() == "infeeds";
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
            if let Some(each) = &item.each {
                for field in ["from", "to"] {
                    self.names.insert(format!("{}.{field}", each.as_str()), COORDINATE);
                }
            }
        }
        let in_cases = item.choose.iter().flat_map(|case| &case.actions);
        let actions: Vec<&Action> = item.body.actions.iter().chain(in_cases).chain(&item.then).collect();
        actions.into_iter().for_each(|action| self.action(action));
        for inner in item.body.items.iter().chain(&item.items).chain(&item.between) {
            self.item(inner);
        }
    }

    fn action(&mut self, action: &Action) {
        if let Some(at) = &action.at
            && matches!(self.formula(at).quantity, Some(quantity) if quantity != Quantity::Feed)
        {
            self.report(&at.place, &at.expr, "not-a-feed");
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
                for (axis, value) in &entries.0 {
                    if !["main", "minor", "tool"].contains(&axis.as_str()) {
                        continue;
                    }
                    let Some((expr, measure)) = self.argument(value) else { continue };
                    if matches!(measure.quantity, Some(quantity) if quantity != Quantity::Length) {
                        self.report(&action.place, &expr, "not-a-length");
                    } else if measure.reference == Some(Reference::Incremental) {
                        self.report(&action.place, &expr, "distance-as-coordinate");
                    }
                }
            }
            (Verb::Dwell, value @ Argument::One(_)) => {
                if let Some((expr, measure)) = self.argument(value)
                    && matches!(measure.quantity, Some(quantity) if quantity != Quantity::Time)
                {
                    self.report(&action.place, &expr, "not-a-time");
                }
            }
            _ => {}
        }
    }

    fn argument(&mut self, argument: &Argument) -> Option<(Expr, Measure)> {
        let Argument::One(Name { text, place }) = argument else { return None };
        let expr = parse(text, Dialect::Spec).ok()?;
        let measure = self.value(&expr, place);
        Some((expr, measure))
    }

    fn q(&self, q: QRef) -> Measure {
        self.cycle.param(q).map_or_else(Measure::default, |param| match param.quantity {
            Quantity::None | Quantity::Text => Measure::default(),
            quantity => Measure { quantity: Some(quantity), reference: param.reference },
        })
    }

    fn name(&self, path: &[String]) -> Measure {
        let name = path.join(".");
        if let Some(measure) = self.names.get(&name) {
            return *measure;
        }
        match (path.first().map(String::as_str), path.get(1).map(String::as_str)) {
            (Some("here" | "start"), Some("main" | "minor" | "tool")) => COORDINATE,
            (Some("tool"), Some("radius" | "length" | "lcuts")) => DISTANCE,
            (Some("probe"), Some("set_up" | "dist" | "ball_radius")) => DISTANCE,
            (Some("probe"), Some("feed" | "fmax")) => plain(Quantity::Feed),
            (Some("tool"), Some("angle")) => plain(Quantity::Angle),
            _ => Measure::default(),
        }
    }

    fn value(&mut self, expr: &Expr, place: &Place) -> Measure {
        match &expr.node {
            Node::Number(_) | Node::Text(_) => Measure::default(),
            Node::Q(q) => self.q(*q),
            Node::Name(path) => self.name(path),
            Node::Unary(_, inner) => {
                let inner = self.value(inner, place);
                let reference = inner.reference.filter(|reference| *reference == Reference::Incremental);
                Measure { reference, ..inner }
            }
            Node::Binary(op, left, right) => {
                let (one, two) = (self.value(left, place), self.value(right, place));
                self.binary(*op, one, two, expr, place)
            }
            Node::Call(func, arguments) => {
                let measures: Vec<Measure> = arguments.iter().map(|argument| self.value(argument, place)).collect();
                self.call(*func, &measures, expr, place)
            }
        }
    }

    /// Whether two values can be added, compared or chosen from.
    fn alike(&mut self, one: Measure, two: Measure, expr: &Expr, place: &Place) -> bool {
        let differ = matches!((one.quantity, two.quantity), (Some(a), Some(b)) if a != b);
        if differ {
            self.report(place, expr, "different-quantities");
        }
        !differ
    }

    fn binary(&mut self, op: Op, one: Measure, two: Measure, expr: &Expr, place: &Place) -> Measure {
        use Reference::{Absolute, Incremental};
        let quantity = one.quantity.or(two.quantity);
        match op {
            Op::Add | Op::Sub => {
                if !self.alike(one, two, expr, place) {
                    return Measure::default();
                }
                let reference = match (op, one.reference, two.reference) {
                    (Op::Add, Some(Absolute), Some(Absolute)) => {
                        self.report(place, expr, "coordinates-added");
                        None
                    }
                    (Op::Sub, Some(Absolute), Some(Absolute)) => Some(Incremental),
                    (Op::Add, _, Some(Absolute)) | (_, Some(Absolute), _) => Some(Absolute),
                    (_, Some(Incremental), Some(Incremental)) => Some(Incremental),
                    _ => None,
                };
                Measure { quantity, reference }
            }
            Op::Mul | Op::Div => {
                let number = |measure: Measure| {
                    matches!(measure.quantity, None | Some(Quantity::Factor | Quantity::Count | Quantity::Number))
                };
                let distance = |measure: Measure| measure.reference.filter(|reference| *reference == Incremental);
                match (number(one), number(two)) {
                    (false, true) => Measure { quantity: one.quantity, reference: distance(one) },
                    (true, false) if op == Op::Mul => Measure { quantity: two.quantity, reference: distance(two) },
                    _ => Measure::default(),
                }
            }
            Op::Eq | Op::Ne | Op::Lt | Op::Le | Op::Gt | Op::Ge => {
                self.alike(one, two, expr, place);
                Measure::default()
            }
            _ => Measure::default(),
        }
    }

    fn call(&mut self, func: Func, measures: &[Measure], expr: &Expr, place: &Place) -> Measure {
        match (func, measures) {
            (Func::Abs, [one]) => Measure { reference: None, ..*one },
            (Func::Sin | Func::Cos | Func::Tan, [one]) => {
                if matches!(one.quantity, Some(quantity) if quantity != Quantity::Angle) {
                    self.report(place, expr, "not-an-angle");
                }
                Measure::default()
            }
            (Func::If, [_, one, two]) | (Func::Min | Func::Max, [one, two]) => {
                if !self.alike(*one, *two, expr, place) {
                    return Measure::default();
                }
                let reference = if one.reference == two.reference { one.reference } else { None };
                Measure { quantity: one.quantity.or(two.quantity), reference }
            }
            (Func::Dist | Func::Length, _) => LENGTH,
            _ => Measure::default(),
        }
    }
}
