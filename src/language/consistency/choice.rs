//! Whether a choice has the value under which the run does what the choice says.
//!
//! Where a condition compares a parameter with a value (`Q341 = 1`), its name and the sentences of its
//! cases say what that value means. The choice whose texts have most of their words must have the value.
//! Words that stand for an order by themselves, such as `no` or `first`, are compared with the values, too.
use std::collections::{BTreeMap, BTreeSet};

use crate::base::diag::Diagnostic;
use crate::language::locale::{Key, Locales, Scope};
use crate::spec::{self, Catalogue, Choice, Cycle, Item, OnControl, Param};

/// Letters of a word that are compared; the rest is mostly its ending.
const LETTERS: usize = 6;
/// How much more a choice must share with a sentence than the one that has the value, in each language.
const MARGIN: f64 = 0.25;

/// Words of ids that are in this order in every list of choices.
const ORDERS: [&[&str]; 6] = [
    &["no", "not"],
    &["minus", "plus"],
    &["negative", "positive"],
    &["main", "minor", "tool"],
    &["a", "b", "c"],
    &["first", "second", "third", "fourth"],
];

/// Reports choices with the value of another one.
pub(super) fn check(catalogue: &Catalogue, locales: &Locales, found: &mut Vec<Diagnostic>) {
    for on in catalogue.controls.values() {
        for cycle in on.cycles.values() {
            for param in cycle.params.iter().filter(|param| param.choices.len() > 1) {
                if catalogue.explains(on, cycle, param) {
                    continue;
                }
                orders(param, found);
                sentences(on, cycle, param, locales, found);
            }
        }
    }
}

fn value(choice: &Choice) -> Option<f64> {
    choice.value.as_str().parse().ok()
}

/// Two choices that differ in one word of an order have values in that order; "no" is 0.
fn orders(param: &Param, found: &mut Vec<Diagnostic>) {
    for (at, one) in param.choices.iter().enumerate() {
        let words: Vec<&str> = one.choice.as_str().split('-').collect();
        let refused = words.first().is_some_and(|word| ORDERS[0].contains(word));
        let zero = param.choices.iter().any(|other| value(other) == Some(0.0));
        if refused && zero && value(one) != Some(0.0) {
            found.push(report(param, one, "0"));
        }
        for other in &param.choices[at + 1..] {
            let others: Vec<&str> = other.choice.as_str().split('-').collect();
            if words.len() != others.len() {
                continue;
            }
            let differ: Vec<(&str, &str)> =
                words.iter().zip(&others).filter(|(a, b)| a != b).map(|(a, b)| (*a, *b)).collect();
            let [(a, b)] = differ.as_slice() else { continue };
            let places = ORDERS.iter().find_map(|order| {
                let place = |word: &str| order.iter().position(|own| *own == word);
                Some((place(a)?, place(b)?))
            });
            let (Some((before, after)), Some(own), Some(next)) = (places, value(one), value(other)) else { continue };
            if (before < after) != (own < next) {
                found.push(report(param, one, other.value.as_str()));
            }
        }
    }
}

fn report(param: &Param, choice: &Choice, usual: &str) -> Diagnostic {
    Diagnostic::error("spec-odd-choice", choice.value.place.clone())
        .arg("name", choice.choice.as_str())
        .arg("value", choice.value.as_str())
        .arg("usual", usual)
        .related("said-here", param.place.clone())
}

/// What the cycle says under each value of the parameter, against what the choices say.
fn sentences(on: &OnControl, cycle: &Cycle, param: &Param, locales: &Locales, found: &mut Vec<Diagnostic>) {
    let Some(q) = param.q else { return };
    let mut by_value: BTreeMap<String, BTreeSet<String>> = BTreeMap::new();
    for (name, formula) in &cycle.file.conditions.0 {
        let Some(wanted) = spec::equals(&formula.expr.node).filter(|(own, _)| *own == q) else { continue };
        let ids = by_value.entry(format!("{}", wanted.1)).or_default();
        ids.insert(format!("={}", name.as_str()));
        for item in &cycle.file.run {
            says(item, name.as_str(), ids);
        }
    }
    let scope = Scope::new(cycle.name(), on.id());
    let mut votes: BTreeMap<(usize, usize), f64> = BTreeMap::new();
    for language in locales.iter() {
        let text = |id: &str| language.raw(Key { id, attribute: None }, scope).map(|(text, _)| text);
        let choices: Vec<BTreeSet<String>> = param
            .choices
            .iter()
            .map(|choice| {
                let own = text(&format!("choice-{}", choice.choice.as_str())).unwrap_or_default();
                words(&format!("{own} {}", choice.choice.as_str()))
            })
            .collect();
        for (wanted, ids) in &by_value {
            let Some(own) = param.choices.iter().position(|choice| value(choice) == wanted.parse().ok()) else {
                continue;
            };
            let said: BTreeSet<String> = ids
                .iter()
                .flat_map(|id| match id.strip_prefix('=') {
                    Some(name) => words(name),
                    None => words(&text(&format!("say-{id}")).unwrap_or_default()),
                })
                .collect();
            // Only words that few of the choices have distinguish them.
            let share = |at: usize| -> f64 {
                let common = choices[at].intersection(&said);
                let weight = |word: &String| 1.0 / choices.iter().filter(|other| other.contains(word)).count() as f64;
                // A long text has a word in common with anything.
                common.map(weight).sum::<f64>() / (choices[at].len().max(1) as f64).sqrt()
            };
            for other in (0..choices.len()).filter(|other| *other != own) {
                *votes.entry((own, other)).or_default() += share(other) - share(own);
            }
        }
    }
    for ((own, other), more) in votes {
        // The other one must be missed under its own value, too, or have no condition.
        let back = by_value.contains_key(param.choices[other].value.as_str());
        if more > MARGIN * locales.iter().count() as f64 * if back { 1.0 } else { 2.0 } {
            found.push(report(param, &param.choices[own], param.choices[other].value.as_str()));
        }
    }
}

/// The sentences that the item says if the condition holds.
fn says(item: &Item, condition: &str, ids: &mut BTreeSet<String>) {
    for case in &item.choose {
        let holds = case.case.iter().any(|used| used.condition.as_str() == condition && !used.negated);
        if holds {
            ids.extend(case.say.iter().map(|say| say.as_str().to_owned()));
        }
    }
    for inner in item.body.items.iter().chain(&item.items).chain(&item.between) {
        says(inner, condition, ids);
    }
}

fn words(text: &str) -> BTreeSet<String> {
    let words = text.split(|c: char| !c.is_alphanumeric()).filter(|word| word.chars().count() > 2);
    words.map(|word| word.to_lowercase().chars().take(LETTERS).collect()).collect()
}
