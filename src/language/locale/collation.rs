//! The order of words in a language, and what counts as the same word when searching.
//!
//! Invariant: equal only means equal to a reader of that language, so ties are the caller's to break.
use std::cmp::Ordering;
use std::fmt;

use icu_collator::options::{CollatorOptions, Strength};
use icu_collator::{Collator, CollatorBorrowed, CollatorPreferences};
use icu_locale_core::Locale;

/// How a language sorts: `č š ž` after their base letters in Slovenian, `å ä ö` at the end in Finnish.
pub struct Collation {
    order: Option<CollatorBorrowed<'static>>,
    search: Option<CollatorBorrowed<'static>>,
}

impl Collation {
    /// That of the language; of the root locale where the tag is unknown.
    pub fn of(tag: &str) -> Self {
        let locale: Locale = tag.parse().unwrap_or(Locale::UNKNOWN);
        Self { order: collator(&locale, Strength::Tertiary), search: collator(&locale, Strength::Primary) }
    }

    /// Whether `a` comes before or after `b` in a list.
    pub fn compare(&self, a: &str, b: &str) -> Ordering {
        self.order.as_ref().map_or_else(|| a.cmp(b), |order| order.compare(a, b))
    }

    /// Whether a search for the one finds the other: case and such accents as make no letter of
    /// their own in the language are passed over.
    pub fn same(&self, a: &str, b: &str) -> bool {
        self.search.as_ref().map_or(a == b, |search| search.compare(a, b) == Ordering::Equal)
    }

    /// Sorts by the text that `key` gives, ties by the plain text.
    pub fn sort_by_key<T>(&self, items: &mut [T], key: impl Fn(&T) -> &str) {
        items.sort_by(|a, b| self.compare(key(a), key(b)).then_with(|| key(a).cmp(key(b))));
    }
}

fn collator(locale: &Locale, strength: Strength) -> Option<CollatorBorrowed<'static>> {
    let mut options = CollatorOptions::default();
    options.strength = Some(strength);
    Collator::try_new(CollatorPreferences::from(locale), options).ok()
}

impl fmt::Debug for Collation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("Collation")
    }
}
