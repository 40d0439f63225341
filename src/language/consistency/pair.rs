//! Texts that have changed places: the choices of a parameter, the results of a cycle.
//!
//! Which word of a language stands for which word of another is learned from all texts but the two in
//! question. If they fit better crosswise, one of the languages has swapped them.
use std::collections::{BTreeSet, HashMap};

use crate::base::diag::Diagnostic;
use crate::language::locale::{Key, Language, Locales, Scope};
use crate::spec::Catalogue;

/// How much better two texts must fit crosswise.
const MARGIN: f64 = 0.25;
/// Letters of a word that are compared; the rest is mostly its ending.
const LETTERS: usize = 6;

/// The words of a text, by their numbers in the language.
type Words = BTreeSet<u32>;

/// The texts of a language as sets of words.
struct Corpus<'l> {
    language: &'l Language,
    texts: HashMap<String, Words>,
}

/// A set of texts, by their numbers: one bit a text.
#[derive(Clone, Default)]
struct Texts(Vec<u64>);

/// In which texts of a language words occur.
struct Occurrences {
    /// All texts that the language has.
    all: Texts,
    /// Those with a word, of words that may have changed places.
    with: HashMap<u32, Texts>,
}

/// Message ids of texts that may have been exchanged.
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
    let pairs = pairs(catalogue);
    let corpora: Vec<Corpus> = locales.iter().map(Corpus::of).collect();
    let mut numbers = HashMap::new();
    let occurrences: Vec<Occurrences> = corpora.iter().map(|own| own.occurrences(&pairs, &mut numbers)).collect();
    for (one, other) in &pairs {
        // The languages with which each finds the pair swapped.
        let mut against = vec![Vec::new(); corpora.len()];
        for a in 0..corpora.len() {
            for b in 0..a {
                let table = Table { one: &occurrences[a], other: &occurrences[b] };
                if table.swapped(&corpora[a].texts, &corpora[b].texts, one, other) {
                    against[a].push(corpora[b].language.tag());
                    against[b].push(corpora[a].language.tag());
                }
            }
        }
        // One language alone may have its words for it nowhere else.
        let Some(most) = against.iter().map(Vec::len).max().filter(|most| *most > 1) else { continue };
        for (at, with) in against.iter().enumerate().filter(|(_, with)| with.len() == most) {
            let Some((_, place)) = corpora[at].language.raw(Key::from(one.as_str()), Scope::NONE) else { continue };
            found.push(
                Diagnostic::warning(super::SWAPPED, place)
                    .arg("language", corpora[at].language.tag())
                    .arg("key", one.as_str())
                    .arg("other", other.as_str())
                    .arg("others", with.join(", ")),
            );
        }
    }
}

impl<'l> Corpus<'l> {
    fn of(language: &'l Language) -> Self {
        let mut numbers: HashMap<String, u32> = HashMap::new();
        let mut texts = HashMap::new();
        for (key, suffixes) in language.keys() {
            if !suffixes.is_empty() || key.attribute.is_some_and(|name| name != "help" && name != "purpose") {
                continue;
            }
            let Some((text, _)) = language.raw(key, Scope::NONE) else { continue };
            let words = text.split(|c: char| !c.is_alphanumeric() && c != '‹' && c != '›');
            let words = words.filter(|word| !word.is_empty()).map(|word| {
                let stem: String = word.to_lowercase().chars().take(LETTERS).collect();
                let next = numbers.len() as u32;
                *numbers.entry(stem).or_insert(next)
            });
            texts.insert(key.to_string(), words.collect());
        }
        Self { language, texts }
    }

    /// Where the words of the texts that may have changed places occur. `numbers` are those of the texts of all languages.
    fn occurrences<'c>(
        &'c self,
        pairs: &BTreeSet<(String, String)>,
        numbers: &mut HashMap<&'c str, usize>,
    ) -> Occurrences {
        let ids = pairs.iter().flat_map(|(one, other)| [one, other]);
        let wanted: Words = ids.filter_map(|id| self.texts.get(id)).flatten().copied().collect();
        let mut found = Occurrences { all: Texts::default(), with: HashMap::new() };
        for (id, words) in &self.texts {
            let next = numbers.len();
            let number = *numbers.entry(id).or_insert(next);
            found.all.insert(number);
            for word in words.intersection(&wanted) {
                found.with.entry(*word).or_default().insert(number);
            }
        }
        found
    }
}

impl Texts {
    fn insert(&mut self, number: usize) {
        let (at, bit) = (number / 64, number % 64);
        if self.0.len() <= at {
            self.0.resize(at + 1, 0);
        }
        self.0[at] |= 1 << bit;
    }

    /// How many texts are in both.
    fn common(&self, other: &Self) -> f64 {
        f64::from(self.0.iter().zip(&other.0).map(|(one, other)| (one & other).count_ones()).sum::<u32>())
    }
}

/// How often words of two languages occur in texts with the same id.
struct Table<'o> {
    one: &'o Occurrences,
    other: &'o Occurrences,
}

impl Table<'_> {
    /// How strongly two words go together in all texts but those that are left out, from 0 to 1.
    fn strength(&self, word: u32, other: u32, left_out: &[(&Words, &Words)]) -> f64 {
        let (Some(with_one), Some(with_other)) = (self.one.with.get(&word), self.other.with.get(&other)) else {
            return 0.0;
        };
        let count = |has: &dyn Fn(&(&Words, &Words)) -> bool| left_out.iter().filter(|pair| has(pair)).count() as f64;
        let both = with_one.common(with_other) - count(&|pair| pair.0.contains(&word) && pair.1.contains(&other));
        if both <= 0.0 {
            return 0.0;
        }
        let one = with_one.common(&self.other.all) - count(&|pair| pair.0.contains(&word));
        let two = with_other.common(&self.one.all) - count(&|pair| pair.1.contains(&other));
        2.0 * both / (one + two)
    }

    fn swapped(&self, one: &HashMap<String, Words>, other: &HashMap<String, Words>, a: &str, b: &str) -> bool {
        let (Some(a1), Some(b1), Some(a2), Some(b2)) = (one.get(a), one.get(b), other.get(a), other.get(b)) else {
            return false;
        };
        let left_out = [(a1, a2), (b1, b2)];
        // Only words that distinguish the two count.
        let fit = |from: &Words, not: &Words, to: &Words, nor: &Words| -> f64 {
            let best = |word: &u32| {
                to.difference(nor).map(|other| self.strength(*word, *other, &left_out)).fold(0.0, f64::max)
            };
            from.difference(not).map(best).sum()
        };
        let crosswise = fit(a1, b1, b2, a2) + fit(b1, a1, a2, b2);
        // Most pairs do not fit crosswise at all.
        crosswise > MARGIN && crosswise > fit(a1, b1, a2, b2) + fit(b1, a1, b2, a2) + MARGIN
    }
}
