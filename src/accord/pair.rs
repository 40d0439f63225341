//! Texts that have changed places: the choices of a parameter, the results of a cycle.
//!
//! Which word of a language stands for which word of another is learned from all texts but the two in
//! question. If they fit better crosswise, one of the languages has swapped them.
use std::collections::{BTreeMap, BTreeSet, HashMap};

use crate::diag::Diagnostic;
use crate::locale::{Key, Language, Locales, Scope};
use crate::spec::Catalogue;

/// How much better two texts must fit crosswise.
const MARGIN: f64 = 0.25;
/// Letters of a word that are compared; the rest is mostly its ending.
const LETTERS: usize = 6;

type Words = BTreeSet<String>;

/// Message ids of texts that may stand in each other's place.
fn pairs(catalogue: &Catalogue) -> BTreeSet<(String, String)> {
    let mut pairs = BTreeSet::new();
    let mut add = |ids: Vec<String>| {
        for (at, one) in ids.iter().enumerate() {
            pairs.extend(ids[..at].iter().filter(|other| *other != one).map(|other| (other.clone(), one.clone())));
        }
    };
    for cycle in catalogue.controls.values().flat_map(|on| on.cycles.values()) {
        for param in &cycle.params {
            add(param.choices.iter().map(|choice| format!("choice-{}", choice.choice.as_str())).collect());
        }
        add(cycle.file.results.iter().map(|result| format!("result-{}", result.is.as_str())).collect());
    }
    pairs
}

/// Reports pairs of texts that a language has swapped.
pub(super) fn check(catalogue: &Catalogue, locales: &Locales, found: &mut Vec<Diagnostic>) {
    let corpora: Vec<(&Language, HashMap<String, Words>)> =
        locales.iter().map(|language| (language, corpus(language))).collect();
    let tables: Vec<Vec<Table>> =
        corpora.iter().map(|(_, one)| corpora.iter().map(|(_, other)| Table::new(one, other)).collect()).collect();
    for (one, other) in pairs(catalogue) {
        // The languages with which each finds the pair swapped.
        let mut against = vec![Vec::new(); corpora.len()];
        for a in 0..corpora.len() {
            for b in 0..corpora.len() {
                if a != b && tables[a][b].swapped(&corpora[a].1, &corpora[b].1, &one, &other) {
                    against[a].push(corpora[b].0.tag());
                }
            }
        }
        // One language alone may have its words for it nowhere else.
        let Some(most) = against.iter().map(Vec::len).max().filter(|most| *most > 1) else { continue };
        for (at, with) in against.iter().enumerate().filter(|(_, with)| with.len() == most) {
            let Some((_, place)) = corpora[at].0.raw(Key::from(one.as_str()), Scope::NONE) else { continue };
            found.push(
                Diagnostic::warning("accord-swapped", place)
                    .arg("language", corpora[at].0.tag())
                    .arg("key", one.as_str())
                    .arg("other", other.as_str())
                    .arg("others", with.join(", ")),
            );
        }
    }
}

/// The words of every text of a language by its id.
fn corpus(language: &Language) -> HashMap<String, Words> {
    let mut all: HashMap<String, Words> = HashMap::new();
    for (key, suffixes) in language.keys() {
        if !suffixes.is_empty() || key.attribute.is_some_and(|name| name != "help" && name != "purpose") {
            continue;
        }
        if let Some((text, _)) = language.raw(key, Scope::NONE) {
            all.insert(key.to_string(), words(&text));
        }
    }
    all
}

fn words(text: &str) -> Words {
    let words = text.split(|c: char| !c.is_alphanumeric() && c != '‹' && c != '›').filter(|word| !word.is_empty());
    words.map(|word| word.to_lowercase().chars().take(LETTERS).collect()).collect()
}

/// How often words of two languages stand in texts with the same id.
struct Table {
    one: BTreeMap<String, f64>,
    other: BTreeMap<String, f64>,
    both: HashMap<String, HashMap<String, f64>>,
}

impl Table {
    fn new(one: &HashMap<String, Words>, other: &HashMap<String, Words>) -> Self {
        let mut table = Self { one: BTreeMap::new(), other: BTreeMap::new(), both: HashMap::new() };
        for (id, words) in one {
            let Some(others) = other.get(id) else { continue };
            for word in words {
                *table.one.entry(word.clone()).or_default() += 1.0;
                let row = table.both.entry(word.clone()).or_default();
                for other in others {
                    *row.entry(other.clone()).or_default() += 1.0;
                }
            }
            for word in others {
                *table.other.entry(word.clone()).or_default() += 1.0;
            }
        }
        table
    }

    /// How strongly two words go together in all texts but those that are left out, from 0 to 1.
    fn strength(&self, word: &str, other: &str, left_out: &[(&Words, &Words)]) -> f64 {
        let count = |has: &dyn Fn(&(&Words, &Words)) -> bool| left_out.iter().filter(|pair| has(pair)).count() as f64;
        let one = self.one.get(word).copied().unwrap_or(0.0) - count(&|pair| pair.0.contains(word));
        let two = self.other.get(other).copied().unwrap_or(0.0) - count(&|pair| pair.1.contains(other));
        let both = self.both.get(word).and_then(|row| row.get(other)).copied().unwrap_or(0.0)
            - count(&|pair| pair.0.contains(word) && pair.1.contains(other));
        if one + two <= 0.0 || both <= 0.0 { 0.0 } else { 2.0 * both / (one + two) }
    }

    fn swapped(&self, one: &HashMap<String, Words>, other: &HashMap<String, Words>, a: &str, b: &str) -> bool {
        let (Some(a1), Some(b1), Some(a2), Some(b2)) = (one.get(a), one.get(b), other.get(a), other.get(b)) else {
            return false;
        };
        let left_out = [(a1, a2), (b1, b2)];
        // Only what tells the two apart says anything.
        let fit = |from: &Words, not: &Words, to: &Words, nor: &Words| -> f64 {
            let best = |word: &String| {
                to.difference(nor).map(|other| self.strength(word, other, &left_out)).fold(0.0, f64::max)
            };
            from.difference(not).map(best).sum()
        };
        let straight = fit(a1, b1, a2, b2) + fit(b1, a1, b2, a2);
        let crosswise = fit(a1, b1, b2, a2) + fit(b1, a1, a2, b2);
        crosswise > straight + MARGIN
    }
}
