//! Recording which translations are good for the source texts of today.
//!
//! Invariant: a text whose source has changed is recorded only if it is named, or if the translation itself was changed
//! since it was last recorded; one that has got the words of another text, only if it is named. Nothing is written: the fresh files are texts.
use std::collections::BTreeSet;

use super::audit::{self, Meanings, counterpart, digest, texts, topic_key};
use super::lock::{Originals, Recorded};
use super::moved::moved;
use super::{LocaleError, Locales, SOURCE_LANGUAGE};

/// Which translations are accepted.
#[derive(Clone, Copy, Debug)]
pub enum Accept<'a> {
    /// Those that are new, and those that were changed since they were accepted.
    Changed,
    /// Those with these keys, or with a key that begins like one that ends in `*`.
    Named(&'a [String]),
    /// All, also those whose source has changed and that have not.
    All,
}

impl Accept<'_> {
    fn names(self, key: &str) -> bool {
        match self {
            Self::Changed => false,
            Self::Named(keys) => {
                keys.iter().any(|own| own.strip_suffix('*').map_or(own == key, |head| key.starts_with(head)))
            }
            Self::All => true,
        }
    }
}

/// What was accepted of a language.
#[derive(Clone, Debug, Default)]
pub struct Accepted {
    /// The new `source.lock`.
    pub lock: String,
    /// The keys of texts that were stale or new and are accepted, in order.
    pub taken: Vec<String>,
    /// The keys of texts that remain stale, in order.
    pub stale: Vec<String>,
    /// The keys of texts that remain without a record, in order.
    pub unrecorded: Vec<String>,
    /// The keys of texts that have got the words of another one and keep their record, in order.
    pub moved: Vec<String>,
}

impl Accepted {
    /// Whether a text keeps its record because it has the words of another one.
    fn keep(&mut self, key: &str, recorded: Option<&Recorded>, which: Accept) -> bool {
        let Some(then) = recorded.filter(|_| !which.names(key)) else { return false };
        self.moved.push(key.to_owned());
        self.lock += &then.line(key);
        true
    }

    fn decide(&mut self, key: &str, recorded: Option<&Recorded>, now: Recorded, which: Accept) {
        let record = match recorded {
            None if which.names(key) || matches!(which, Accept::Changed) => {
                self.taken.push(key.to_owned());
                now
            }
            None => return self.unrecorded.push(key.to_owned()),
            Some(then) => {
                let meant = then.meaning.zip(now.meaning).is_none_or(|(then, now)| then == now);
                let is_stale = then.text != now.text || !meant;
                // A line of an earlier version does not say what the translation was.
                let touched = matches!(which, Accept::Changed) && then.translation != now.translation;
                if is_stale && !touched && !which.names(key) {
                    self.stale.push(key.to_owned());
                    *then
                } else {
                    if is_stale {
                        self.taken.push(key.to_owned());
                    }
                    now
                }
            }
        };
        self.lock += &record.line(key);
    }
}

impl Locales {
    /// Accepts translations of a language.
    ///
    /// # Errors
    /// If the language or the source language was not loaded.
    pub fn accept(&self, tag: &str, meanings: &Meanings, which: Accept) -> Result<Accepted, LocaleError> {
        let (source, translation) = (self.language(SOURCE_LANGUAGE)?, self.language(tag)?);
        let mut accepted = Accepted::default();
        let recorded = |key: &str| translation.lock.as_ref().and_then(|lock| lock.0.get(key));
        let moved = moved(source, translation);
        for text in texts(translation) {
            if let Some(original) = counterpart(source, &text).and_then(|form| source.pattern(form)) {
                if moved.contains_key(&text.key) && accepted.keep(&text.key, recorded(&text.key), which) {
                    continue;
                }
                let now = Recorded {
                    text: audit::hash(original),
                    meaning: meanings.get(text.id).copied(),
                    translation: Some(digest(&audit::written(text.pattern))),
                };
                accepted.decide(&text.key, recorded(&text.key), now, which);
            }
        }
        for (name, page) in translation.topics() {
            if let Some(original) = source.topic(name) {
                let now = Recorded {
                    text: audit::signature(original.text()),
                    meaning: None,
                    translation: Some(digest(page.text())),
                };
                let key = topic_key(name);
                accepted.decide(&key, recorded(&key), now, which);
            }
        }
        Ok(accepted)
    }

    /// The source texts that the translations of all languages were made from, as `accepted.lock` of the source language
    /// keeps them: those of today, and of earlier ones those that a translation still depends on.
    ///
    /// # Errors
    /// If the source language was not loaded.
    pub fn originals(&self, locks: &[String]) -> Result<String, LocaleError> {
        let source = self.language(SOURCE_LANGUAGE)?;
        let mut kept = Originals::default();
        let mut wanted: BTreeSet<(String, u32)> = BTreeSet::new();
        for line in locks.iter().flat_map(|lock| lock.lines()) {
            let mut words = line.split_whitespace();
            let hash = |word: &str| u32::from_str_radix(word, 16).ok();
            if let (Some(key), Some(hash)) = (words.next(), words.next().and_then(hash)) {
                wanted.insert((key.to_owned(), hash));
            }
        }
        for language in self.iter() {
            for text in texts(language) {
                let Some(original) = counterpart(source, &text).and_then(|form| source.pattern(form)) else { continue };
                let hash = audit::hash(original);
                if wanted.remove(&(text.key.clone(), hash)) {
                    kept.keep(&text.key, hash, &audit::written(original));
                }
            }
        }
        for (name, page) in source.topics() {
            let (key, hash) = (topic_key(name), audit::signature(page.text()));
            if wanted.remove(&(key.clone(), hash)) {
                kept.keep(&key, hash, page.text());
            }
        }
        for (key, hash) in wanted {
            if let Some(text) = source.originals.get(&key, hash) {
                kept.keep(&key, hash, text);
            }
        }
        Ok(kept.file())
    }
}
