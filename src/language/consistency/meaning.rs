//! What a specification means by an id: changes when a range, a unit, a choice, a condition or the actions of a
//! step change, and so says which texts must be read again.
//!
//! Invariant: wording, order of files and comments have no part in it.
use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write as _;

use crate::language::locale::Meanings;
use crate::spec::{Action, Argument, Case, Catalogue, Cycle, Entries, Formula, Item, Param};

/// For each message id what the specifications mean by it.
pub fn meanings(catalogue: &Catalogue) -> Meanings {
    let mut said: BTreeMap<String, BTreeSet<String>> = BTreeMap::new();
    for on in catalogue.controls.values() {
        for cycle in on.cycles.values() {
            for param in &cycle.params {
                said.entry(format!("parameter-{}", param.is.as_str())).or_default().insert(parameter(param));
                for choice in &param.choices {
                    let id = format!("choice-{}", choice.choice.as_str());
                    said.entry(id).or_default().insert(format!("{} {}", param.is.as_str(), choice.value.as_str()));
                }
            }
            for (name, formula) in &cycle.file.conditions.0 {
                said.entry(format!("condition-{}", name.as_str())).or_default().insert(formula.text.to_string());
            }
            for guard in &cycle.file.guards {
                if let (Some(code), Some(when)) = (&guard.code, &guard.when) {
                    said.entry(format!("guard-{}", code.as_str())).or_default().insert(when.text.to_string());
                }
            }
            for doubt in &cycle.file.doubts {
                let id = format!("guard-{}", doubt.code.as_str());
                said.entry(id).or_default().insert(doubt.when.text.to_string());
            }
            for item in &cycle.file.run {
                steps(item, cycle, &mut said);
            }
        }
    }
    said.into_iter().map(|(id, facts)| (id, sum(facts.iter()))).collect()
}

/// FNV-1a over the facts in their order.
fn sum<'f>(facts: impl Iterator<Item = &'f String>) -> u32 {
    let bytes = facts.flat_map(|fact| fact.bytes().chain(std::iter::once(b'\n')));
    bytes.fold(0x811c_9dc5, |hash, byte| (hash ^ u32::from(byte)).wrapping_mul(0x0100_0193))
}

fn parameter(param: &Param) -> String {
    let mut text =
        format!("{:?} {:?} {:?} {:?} {:?}", param.quantity, param.reference, param.min, param.max, param.max_length);
    for choice in &param.choices {
        let _ = write!(text, " {}={}", choice.value.as_str(), choice.choice.as_str());
    }
    for word in &param.words {
        let _ = write!(text, " {word}");
    }
    text
}

fn steps(item: &Item, cycle: &Cycle, said: &mut BTreeMap<String, BTreeSet<String>>) {
    if let Some(step) = &item.step {
        let mut text = String::new();
        item.body.actions.iter().chain(&item.then).for_each(|one| action(one, &mut text));
        said.entry(format!("step-{}", step.as_str())).or_default().insert(text);
        for case in &item.choose {
            if let Some(say) = &case.say {
                said.entry(format!("say-{}", say.as_str())).or_default().insert(bullet(case, &cycle.file.conditions));
            }
        }
    }
    if let (Some(until), Some(series)) = (&item.until, &item.series) {
        let mut text = series.kind.as_str().to_owned();
        for (name, formula) in &series.with.0 {
            let _ = write!(text, " {}={}", name.as_str(), formula.text);
        }
        said.entry(format!("until-{}", until.as_str())).or_default().insert(text);
    }
    for inner in item.body.items.iter().chain(&item.items).chain(&item.between) {
        steps(inner, cycle, said);
    }
}

fn bullet(case: &Case, conditions: &Entries<Formula>) -> String {
    let mut text = String::new();
    for used in &case.case {
        let formula = conditions.get(used.condition.as_str()).map_or("", |formula| &formula.text);
        let _ = write!(text, "{}({formula}) ", if used.negated { "not" } else { "" });
    }
    case.actions.iter().for_each(|one| action(one, &mut text));
    text
}

fn action(action: &Action, text: &mut String) {
    let _ = write!(text, "{}:", action.verb.as_str());
    argument(&action.argument, text);
    for formula in [&action.at, &action.when].into_iter().flatten() {
        let _ = write!(text, " {}", formula.text);
    }
    for (name, formula) in &action.with.0 {
        let _ = write!(text, " {}={}", name.as_str(), formula.text);
    }
    text.push(';');
}

fn argument(argument: &Argument, text: &mut String) {
    match argument {
        Argument::One(name) => text.push_str(name.as_str()),
        Argument::Many(entries) => {
            for (name, value) in &entries.0 {
                let _ = write!(text, " {}=", name.as_str());
                self::argument(value, text);
            }
        }
        Argument::List(list) => list.iter().for_each(|one| self::argument(one, text)),
    }
}
