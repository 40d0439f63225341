//! What the catalogue does everywhere else: the Q number of a meaning, the value of a choice, the limits
//! of a quantity, the formula of a named value. Where one cycle does otherwise, it is more often a slip than a fact.
//!
//! Invariant: nothing is known here beforehand; the other cycles of the same control are the measure.
use std::collections::{BTreeMap, BTreeSet};

use super::super::catalogue::{Catalogue, Cycle, OnControl, Param};
use super::super::form::Choice;
use super::super::vocabulary::Quantity;
use crate::base::diag::Diagnostic;
use crate::base::expr::{Node, Op, QRef};

/// Uses that make a habit.
const HABIT: usize = 3;

pub(super) fn habits(catalogue: &Catalogue, found: &mut Vec<Diagnostic>) {
    for on in catalogue.controls.values() {
        numbers(on, catalogue, found);
        choices(on, found);
        limits(on, catalogue, found);
        formulas(on, found);
        on.cycles.values().for_each(|cycle| conditions(cycle, found));
    }
}

fn params(on: &OnControl) -> impl Iterator<Item = (&Cycle, &Param)> {
    on.cycles.values().flat_map(|cycle| cycle.params.iter().map(move |param| (cycle, param)))
}

/// The most frequent key, how often it occurs, and how often another one does.
fn usual<K: Ord + Clone>(uses: &BTreeMap<K, usize>) -> Option<(K, usize)> {
    uses.iter().max_by_key(|(_, count)| **count).map(|(key, count)| (key.clone(), *count))
}

/// A meaning that has one Q number in most cycles does not take the number of another meaning.
fn numbers(on: &OnControl, catalogue: &Catalogue, found: &mut Vec<Diagnostic>) {
    let mut by_meaning: BTreeMap<&str, BTreeMap<QRef, usize>> = BTreeMap::new();
    let mut by_q: BTreeMap<QRef, BTreeMap<&str, usize>> = BTreeMap::new();
    for (_, param) in params(on) {
        let Some(q) = param.q else { continue };
        *by_meaning.entry(param.is.as_str()).or_default().entry(q).or_default() += 1;
        *by_q.entry(q).or_default().entry(param.is.as_str()).or_default() += 1;
    }
    for (cycle, param) in params(on) {
        let Some(q) = param.q else { continue };
        let is = param.is.as_str();
        let (Some((own, uses)), Some((other, others))) =
            (by_meaning.get(is).and_then(usual), by_q.get(&q).and_then(usual))
        else {
            continue;
        };
        if own != q && uses >= HABIT && other != is && others >= HABIT && !catalogue.explains(on, cycle, param) {
            found.push(
                Diagnostic::error("spec-odd-q", param.place.clone())
                    .arg("cycle", cycle.key.to_string())
                    .arg("q", q.to_string())
                    .arg("name", is)
                    .arg("usual", own.to_string())
                    .arg("other", other),
            );
        }
    }
}

/// A choice has the same value wherever it is offered.
fn choices(on: &OnControl, found: &mut Vec<Diagnostic>) {
    let mut values: BTreeMap<&str, BTreeMap<&str, usize>> = BTreeMap::new();
    for choice in params(on).flat_map(|(_, param)| &param.choices) {
        *values.entry(choice.choice.as_str()).or_default().entry(choice.value.as_str()).or_default() += 1;
    }
    for choice in params(on).flat_map(|(_, param)| &param.choices) {
        let Some((value, uses)) = values.get(choice.choice.as_str()).and_then(usual) else { continue };
        if value != choice.value.as_str() && uses >= HABIT {
            found.push(
                Diagnostic::error("spec-odd-choice", choice.value.place.clone())
                    .arg("name", choice.choice.as_str())
                    .arg("value", choice.value.as_str())
                    .arg("usual", value),
            );
        }
    }
}

/// A limit that differs by one digit from one that the quantity has everywhere else.
fn limits(on: &OnControl, catalogue: &Catalogue, found: &mut Vec<Diagnostic>) {
    let ends = |param: &Param| [param.min, param.max].into_iter().flatten().map(text).collect::<Vec<_>>();
    // A meaning counts once, however many cycles have it.
    let mut meanings: BTreeMap<(Quantity, String), BTreeSet<&str>> = BTreeMap::new();
    for (_, param) in params(on) {
        for end in ends(param) {
            meanings.entry((param.quantity, end)).or_default().insert(param.is.as_str());
        }
    }
    let uses: BTreeMap<(Quantity, String), usize> =
        meanings.into_iter().map(|(limit, meanings)| (limit, meanings.len())).collect();
    for (cycle, param) in params(on) {
        for end in ends(param) {
            let own = uses.get(&(param.quantity, end.clone())).copied().unwrap_or(0);
            let near = uses.iter().find(|((quantity, other), count)| {
                *quantity == param.quantity && **count >= HABIT * own.max(1) && one_digit_apart(&end, other)
            });
            if let Some(((_, usual), _)) = near
                && own < HABIT
                && !catalogue.explains(on, cycle, param)
            {
                found.push(
                    Diagnostic::error("spec-odd-limit", param.place.clone())
                        .arg("value", end.as_str())
                        .arg("name", param.is.as_str())
                        .arg("usual", usual.as_str()),
                );
            }
        }
    }
}

/// A formula with each Q number as what it means in the cycle; without the numbers, formulas of the same form are the same.
fn worded(cycle: &Cycle, formula: &str) -> (String, Vec<(QRef, String)>) {
    let (mut form, mut means) = (String::new(), Vec::new());
    let mut rest = formula;
    while let Some(first) = rest.chars().next() {
        let is_word = |c: char| c.is_ascii_alphanumeric() || matches!(c, '_' | '.');
        let length = rest.find(|c| !is_word(c)).unwrap_or(rest.len()).max(first.len_utf8());
        let (word, after) = rest.split_at(length);
        match QRef::parse(word) {
            Some(q) => {
                form.push('Q');
                means.push((q, cycle.param(q).map_or_else(|| q.to_string(), |param| param.is.as_str().to_owned())));
            }
            None => form.push_str(word),
        }
        rest = after;
    }
    (form, means)
}

/// A value of the same name is calculated in the same way in several cycles, and in one from another parameter, though that
/// has the usual one as well.
fn formulas(on: &OnControl, found: &mut Vec<Diagnostic>) {
    type Uses = BTreeMap<Vec<String>, usize>;
    let lets =
        || on.cycles.values().flat_map(|cycle| cycle.file.lets.0.iter().map(move |(name, own)| (cycle, name, own)));
    let words = |means: &[(QRef, String)]| means.iter().map(|(_, is)| is.clone()).collect::<Vec<_>>();
    let mut known: BTreeMap<(String, String), Uses> = BTreeMap::new();
    for (cycle, name, formula) in lets() {
        let (form, means) = worded(cycle, &formula.text);
        *known.entry((name.as_str().to_owned(), form)).or_default().entry(words(&means)).or_default() += 1;
    }
    for (cycle, name, formula) in lets() {
        let (form, means) = worded(cycle, &formula.text);
        let Some(uses) = known.get(&(name.as_str().to_owned(), form)) else { continue };
        let Some((most, count)) = usual(uses) else { continue };
        let own = uses.get(&words(&means)).copied().unwrap_or(0);
        if count < HABIT || own >= HABIT {
            continue;
        }
        let differ: Vec<_> = means.iter().zip(&most).filter(|((_, is), usual)| is != *usual).collect();
        let [((q, _), usual)] = differ.as_slice() else { continue };
        let Some(other) = cycle.params.iter().find(|param| param.is.as_str() == usual.as_str()) else { continue };
        found.push(
            Diagnostic::error("spec-odd-formula", formula.place.clone())
                .arg("cycle", cycle.key.to_string())
                .arg("name", name.as_str())
                .arg("q", q.to_string())
                .arg("usual", other.q.map_or_else(|| usual.to_string(), |q| q.to_string()))
                .related("said-here", other.place.clone()),
        );
    }
}

fn text(value: f64) -> String {
    format!("{value}")
}

/// Whether one text becomes the other by adding a character.
fn one_digit_apart(a: &str, b: &str) -> bool {
    let (short, long) = if a.len() < b.len() { (a, b) } else { (b, a) };
    if long.len() != short.len() + 1 || short.len() < 3 {
        return false;
    }
    (0..long.len())
        .any(|at| long.as_bytes()[at].is_ascii_digit() && long[..at] == short[..at] && long[at + 1..] == short[at..])
}

/// A condition `Q301 = 1` whose name is most like that of one choice means the value of that choice.
fn conditions(cycle: &Cycle, found: &mut Vec<Diagnostic>) {
    for (name, formula) in &cycle.file.conditions.0 {
        let Some((q, value)) = equals(&formula.expr.node) else { continue };
        let Some(param) = cycle.params.iter().find(|param| param.q == Some(q)) else { continue };
        let alike = |choice: &Choice| {
            let words: BTreeSet<&str> = choice.choice.as_str().split('-').collect();
            name.as_str().split('-').filter(|word| words.contains(word)).count()
        };
        let mut best: Vec<(usize, &Choice)> = param.choices.iter().map(|choice| (alike(choice), choice)).collect();
        best.sort_by_key(|(alike, _)| std::cmp::Reverse(*alike));
        let [(most, choice), rest @ ..] = best.as_slice() else { continue };
        let clear = *most > 0 && rest.first().is_none_or(|(next, _)| next < most);
        if clear && choice.value.as_str().parse() != Ok(value) {
            found.push(
                Diagnostic::error("spec-odd-condition", formula.place.clone())
                    .arg("name", name.as_str())
                    .arg("q", q.to_string())
                    .arg("found", value)
                    .arg("value", choice.value.as_str())
                    .related("said-here", choice.value.place.clone()),
            );
        }
    }
}

/// The parameter and the number of a formula such as `Q301 = 1`.
pub fn equals(node: &Node) -> Option<(QRef, f64)> {
    let Node::Binary(Op::Eq, left, right) = node else { return None };
    match (&left.node, &right.node) {
        (Node::Q(q), Node::Number(value)) => Some((*q, *value)),
        (Node::Q(q), Node::Unary(_, inner)) => match inner.node {
            Node::Number(value) => Some((*q, -value)),
            _ => None,
        },
        _ => None,
    }
}
