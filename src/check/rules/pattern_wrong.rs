//! A pattern (PATTERN DEF) with no machining position, with a negative diameter, a distance of 0, an angle of more than
//! a turn, the same position twice, or with more than nine positions.
//!
//! Also a call at the points of a table at rapid traverse, which the control does not take (001: 1663). TNC 640, 001:
//! 1428 and 1534-1549. Only reported of numbers, and of parameters that certainly have one.
use std::collections::HashSet;

use crate::base::diag::{Diagnostic, Severity};
use crate::check::program::bits;
use crate::check::{Facts, Rule};
use crate::program::syntax::{Block, BlockKind, CallForm, FeedKind, NamedWord, PatternItem, ValueKind};

pub(super) const RULE: Rule = Rule { code: "pattern-wrong", severity: Severity::Warning, run };

/// How many positions a pattern of single ones has at most.
const MOST: usize = 9;

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let selected = |(_, block): (usize, &Block)| match &block.kind {
        BlockKind::Sel(own) => facts.text(own.what).eq_ignore_ascii_case("PATTERN"),
        _ => false,
    };
    let table = facts.marked().any(selected);
    for (_, block) in facts.marked() {
        if let BlockKind::CyclCall(own) = &block.kind
            && table
            && let (CallForm::Pattern, Some(feed)) = (&own.form, &own.feed)
            && matches!(feed.kind, FeedKind::Max)
        {
            found.push(rule.at(facts, feed.span).arg("what", "rapid").arg("word", facts.text(feed.span)));
        }
        let BlockKind::PatternDef(own) = &block.kind else { continue };
        let named = |item: &&PatternItem, name: &str| form(facts, item) == name;
        if let Some(tenth) = own.items.iter().filter(|item| named(item, "POS")).nth(MOST) {
            found.push(rule.at(facts, tenth.name).arg("what", "many").arg("word", facts.text(tenth.name)));
        }
        let mut places = HashSet::new();
        for item in own.items.iter().filter(|item| named(item, "POS")) {
            if place(facts, item).is_some_and(|place| !places.insert(place.map(bits))) {
                found.push(rule.at(facts, item.name).arg("what", "same").arg("word", facts.text(item.name)));
            }
        }
        for item in &own.items {
            let circle = matches!(form(facts, item).as_str(), "CIRC" | "PITCHCIRC");
            for word in &item.words {
                let name = facts.text(word.name).trim().to_ascii_uppercase();
                let Some(number) = number(facts, word) else { continue };
                let what = match name.as_str() {
                    "NUM" | "NUMX" | "NUMY" if number < 1.0 || libm::trunc(number) != number => "count",
                    "D" if circle && number <= 0.0 => "diameter",
                    "D" | "DX" | "DY" if number == 0.0 && several(facts, item, &name) => "distance",
                    "ROT" | "ROTX" | "ROTY" | "START" if !(-360.0..=360.0).contains(&number) => "angle",
                    _ => continue,
                };
                found.push(rule.at(facts, word.span).arg("what", what).arg("word", name));
            }
        }
    }
}

/// Whether there is more than one position in the direction of a distance.
fn several(facts: &Facts<'_>, item: &PatternItem, distance: &str) -> bool {
    let count = distance.replace('D', "NUM");
    let named = |word: &&NamedWord| facts.text(word.name).trim().eq_ignore_ascii_case(&count);
    item.words.iter().find(named).and_then(|word| number(facts, word)).is_some_and(|count| count > 1.0)
}

/// The position that an item names with numbers.
fn place(facts: &Facts<'_>, item: &PatternItem) -> Option<[f64; 3]> {
    let coordinate = |axis: &str| {
        let named = |word: &&NamedWord| facts.text(word.name).trim().eq_ignore_ascii_case(axis);
        item.words.iter().find(named).and_then(|word| number(facts, word))
    };
    Some([coordinate("X")?, coordinate("Y")?, coordinate("Z")?])
}

/// The form of an item: its name without its number.
fn form(facts: &Facts<'_>, item: &PatternItem) -> String {
    facts.text(item.name).trim_end_matches(|c: char| c.is_ascii_digit()).to_ascii_uppercase()
}

fn number(facts: &Facts<'_>, word: &NamedWord) -> Option<f64> {
    match word.value.kind {
        ValueKind::Number(number) => Some(number),
        ValueKind::Q { negative, .. } => facts.known_at(word.value.span, negative),
        _ => None,
    }
}
