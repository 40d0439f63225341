//! `source.lock` of a language: what each of its texts was translated from; `accepted.lock` of the source language: what
//! its texts said then; and the lists of words that may be the same in a translation.
use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write as _;
use std::sync::Arc;

use crate::base::diag::{Diagnostic, Place, Source};

/// What a translation was made from.
#[derive(Debug, Default)]
pub(super) struct Lock(pub(super) BTreeMap<String, Recorded>);

/// What a translation was made from: the source text, and what the specifications meant by it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Recorded {
    pub(super) text: u32,
    pub(super) meaning: Option<u32>,
    /// The translation as it was when it was accepted; nothing in files of earlier versions.
    pub(super) translation: Option<u32>,
}

impl Recorded {
    /// The line of a text with this key.
    pub(super) fn line(&self, key: &str) -> String {
        let mut line = format!("{key} {:08x}", self.text);
        if let Some(meaning) = self.meaning {
            let _ = write!(line, " {meaning:08x}");
        }
        if let Some(translation) = self.translation {
            let _ = write!(line, " ={translation:08x}");
        }
        line + "\n"
    }

    fn read(words: &[&str]) -> Option<Self> {
        let (translation, words) = match words.split_last() {
            Some((last, before)) if last.starts_with('=') => (Some(number(last.strip_prefix('=')?)?), before),
            _ => (None, words),
        };
        match words {
            [text] => Some(Self { text: number(text)?, meaning: None, translation }),
            [text, meaning] => Some(Self { text: number(text)?, meaning: Some(number(meaning)?), translation }),
            _ => None,
        }
    }
}

fn number(word: &str) -> Option<u32> {
    Some(word).filter(|word| word.len() == 8).and_then(|word| u32::from_str_radix(word, 16).ok())
}

impl Lock {
    pub(super) fn read(source: &Arc<Source>, diagnostics: &mut Vec<Diagnostic>) -> Self {
        let mut lines = BTreeMap::new();
        each_line(source, diagnostics, |content| {
            let words: Vec<&str> = content.split_whitespace().collect();
            let (id, rest) = words.split_first()?;
            lines.insert((*id).to_owned(), Recorded::read(rest)?);
            Some(())
        });
        Self(lines)
    }
}

/// What texts of the source language said when translations of them were accepted.
#[derive(Debug, Default)]
pub(super) struct Originals(BTreeMap<(String, u32), String>);

impl Originals {
    /// Reads lines of the form `key number "text"`.
    pub(super) fn read(source: &Arc<Source>, diagnostics: &mut Vec<Diagnostic>) -> Self {
        let mut texts = BTreeMap::new();
        each_line(source, diagnostics, |content| {
            let (key, rest) = content.split_once(' ')?;
            let (hash, text) = rest.split_once(' ')?;
            texts.insert((key.to_owned(), number(hash)?), serde_json::from_str(text).ok()?);
            Some(())
        });
        Self(texts)
    }

    pub(super) fn get(&self, key: &str, hash: u32) -> Option<&str> {
        self.0.get(&(key.to_owned(), hash)).map(String::as_str)
    }

    pub(super) fn keep(&mut self, key: &str, hash: u32, text: &str) {
        self.0.insert((key.to_owned(), hash), text.to_owned());
    }

    /// The file.
    pub(super) fn file(&self) -> String {
        let line = |((key, hash), text): (&(String, u32), &String)| {
            format!("{key} {hash:08x} {}\n", serde_json::Value::from(text.as_str()))
        };
        self.0.iter().map(line).collect()
    }
}

/// The lines of a list of words and keys of messages that may be the same in a translation.
pub(super) fn list(text: &str) -> BTreeSet<String> {
    let lines = text.lines().map(str::trim).filter(|line| !line.is_empty() && !line.starts_with('#'));
    lines.map(str::to_owned).collect()
}

/// Reads each line that is neither empty nor a comment, and reports those that cannot be read.
fn each_line(source: &Arc<Source>, diagnostics: &mut Vec<Diagnostic>, mut read: impl FnMut(&str) -> Option<()>) {
    let mut at = 0;
    for line in source.text().split_inclusive('\n') {
        let content = line.trim();
        if !content.is_empty() && read(content).is_none() && !content.starts_with('#') {
            let place = Place::new(source, at..at + line.trim_end().len());
            diagnostics.push(Diagnostic::error("locale-lock-line", place));
        }
        at += line.len();
    }
}
