//! The stems of words, so that a search finds a word in any of its forms.
//!
//! Snowball knows English, Finnish, Italian and Portuguese. What it leaves, and all words of a language
//! that it does not know, lose the longest of the endings that the language lists in
//! `site-search.endings`. Invariant: equal words have equal stems; a stem is never shown to anybody.
use rust_stemmers::{Algorithm, Stemmer};

use crate::language::locale::{Language, Scope};

/// The shortest stem that stripping an ending may leave, in letters.
const SHORTEST: usize = 3;

/// How a language finds the stem of a word.
pub(super) struct Stems {
    snowball: Option<Stemmer>,
    /// The longest ending first.
    endings: Vec<String>,
}

impl Stems {
    pub(super) fn of(language: &Language) -> Self {
        let algorithm = match language.tag().split('-').next().unwrap_or_default() {
            "en" => Some(Algorithm::English),
            "fi" => Some(Algorithm::Finnish),
            "it" => Some(Algorithm::Italian),
            "pt" => Some(Algorithm::Portuguese),
            _ => None,
        };
        let listed = language.plain("site-search.endings", &Scope::NONE).unwrap_or_default();
        let mut endings: Vec<String> = listed.split_whitespace().map(str::to_owned).collect();
        endings.sort_by_key(|ending| std::cmp::Reverse(ending.chars().count()));
        Self { snowball: algorithm.map(Stemmer::create), endings }
    }

    /// The stem of a word in lower case.
    pub(super) fn stem(&self, word: &str) -> String {
        if word.chars().any(|c| c.is_ascii_digit()) {
            return word.to_owned();
        }
        let word = self.snowball.as_ref().map_or(word.into(), |stemmer| stemmer.stem(word));
        let fits = |stem: &&str| stem.chars().count() >= SHORTEST;
        let stripped = self.endings.iter().find_map(|ending| word.strip_suffix(ending.as_str()).filter(fits));
        stripped.unwrap_or(&word).to_owned()
    }
}

/// The words of a text: runs of letters and digits.
pub(super) fn words(text: &str) -> impl Iterator<Item = &str> {
    text.split(|c: char| !c.is_alphanumeric()).filter(|word| !word.is_empty())
}
