//! `source.lock` of a language: what each of its texts was translated from.
use std::collections::BTreeMap;
use std::sync::Arc;

use crate::base::diag::{Diagnostic, Place, Source};

/// What a translation was made from.
#[derive(Debug, Default)]
pub(super) struct Lock(pub(super) BTreeMap<String, Recorded>);

/// What a translation was made from: the source text, and what the specifications meant by it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Recorded {
    pub(super) text: u32,
    pub(super) meaning: Option<u32>,
}

impl Lock {
    pub(super) fn read(source: &Arc<Source>, diagnostics: &mut Vec<Diagnostic>) -> Self {
        let mut lines = BTreeMap::new();
        let mut at = 0;
        for line in source.text().split_inclusive('\n') {
            let content = line.trim();
            let words: Vec<&str> = content.split_whitespace().collect();
            let read = |at: usize| {
                let hash = words.get(at).filter(|hash| hash.len() == 8);
                hash.and_then(|hash| u32::from_str_radix(hash, 16).ok())
            };
            match (words.as_slice(), read(1), read(2)) {
                ([], ..) => {}
                ([id, _], Some(text), None) => {
                    lines.insert((*id).to_owned(), Recorded { text, meaning: None });
                }
                ([id, _, _], Some(text), Some(meaning)) => {
                    lines.insert((*id).to_owned(), Recorded { text, meaning: Some(meaning) });
                }
                _ if content.starts_with('#') => {}
                _ => {
                    let place = Place::new(source, at..at + line.trim_end().len());
                    diagnostics.push(Diagnostic::error("locale-lock-line", place));
                }
            }
            at += line.len();
        }
        Self(lines)
    }
}
