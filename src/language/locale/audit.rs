//! How far a translation follows its source: missing, left over, stale, and asking for too much.
//!
//! Each translation has a file `source.lock` with a line a text: `id[.attribute] text [meaning]`: a number
//! for the words of the source text which it translates, and one for what the specifications mean by it. A
//! mended slip of the pen leaves the first as it is: words count by their consonants. A variant counts as a translation
//! of whatever the source language says in the same scope. Invariant: nothing is changed; the fresh lock is a text.
use std::collections::{BTreeSet, HashMap, HashSet};
use std::fmt::Write as _;
use std::sync::Arc;

use fluent_syntax::ast::{self, Pattern};

use super::language::{Form, Key, Language, Scope};
use super::pattern::{Node, visit};
use super::{LocaleError, Locales, SOURCE_LANGUAGE};
use crate::base::diag::{Diagnostic, Place, Source, Span};

/// Attributes that a language may have alone: whether there is one depends on what its manual prints,
/// or on its grammar.
const OWN: [&str; 7] = ["endings", "forbidden", "forms", "label-aliases", "nc-aliases", "prompt", "source"];

/// What the specifications mean by a message id: a number that changes with the meaning.
pub type Meanings = HashMap<String, u32>;

/// One text that the audit has something to say about.
#[derive(Clone, Debug)]
pub struct Finding {
    /// The message with its suffixes and `.attribute`; terms begin with `-`.
    pub key: String,
    /// The text in question; where it is missing, that of the source language.
    pub place: Option<Place>,
    /// An argument, where the finding is about one.
    pub argument: Option<String>,
}

/// How far one translation follows its source; each list is sorted by key.
#[derive(Clone, Debug, Default)]
pub struct Audit {
    /// The tag of the translation.
    pub language: String,
    /// How many texts the source has.
    pub total: usize,
    /// Texts of the source that the translation lacks.
    pub missing: Vec<Finding>,
    /// Texts of the translation that the source lacks.
    pub orphans: Vec<Finding>,
    /// Translations whose source has changed since they were accepted.
    pub stale: Vec<Finding>,
    /// Translations that were never accepted.
    pub unrecorded: Vec<Finding>,
    /// Arguments that a translation uses and its source does not.
    pub unknown_arguments: Vec<Finding>,
}

impl Audit {
    /// The findings as diagnostics: errors, except that what is stale, unrecorded or left over warns.
    pub fn diagnostics(&self) -> Vec<Diagnostic> {
        let warn = |code, place| Diagnostic::warning(code, place);
        let error = |code, place| Diagnostic::error(code, place);
        let mut all = Vec::new();
        self.append(&mut all, &self.missing, "locale-missing-translation", error);
        self.append(&mut all, &self.unknown_arguments, "locale-unknown-argument", error);
        self.append(&mut all, &self.orphans, "locale-orphan", warn);
        self.append(&mut all, &self.stale, "locale-stale", warn);
        self.append(&mut all, &self.unrecorded, "locale-unrecorded", warn);
        all
    }

    fn append(
        &self,
        all: &mut Vec<Diagnostic>,
        findings: &[Finding],
        code: &'static str,
        make: fn(&'static str, Place) -> Diagnostic,
    ) {
        for finding in findings {
            let Some(place) = finding.place.clone() else { continue };
            let diagnostic = make(code, place).arg("key", finding.key.as_str()).arg("language", self.language.as_str());
            all.push(match &finding.argument {
                Some(argument) => diagnostic.arg("name", argument.as_str()),
                None => diagnostic,
            });
        }
    }
}

/// A text of a language with what is needed to compare it.
struct Text<'l> {
    key: String,
    id: &'l str,
    attribute: Option<&'l str>,
    form: &'l Form,
    pattern: &'l Pattern<&'l str>,
}

fn texts(language: &Language) -> Vec<Text<'_>> {
    let mut texts = Vec::new();
    for (id, entry) in language.entries.iter() {
        for (attribute, forms) in entry.all() {
            // The attributes of a term are its grammar, a language's own business.
            if id.starts_with('-') && attribute.is_some() {
                continue;
            }
            for form in forms {
                let Some(pattern) = language.pattern(form) else { continue };
                let dotted = attribute.map(|attribute| format!(".{attribute}")).unwrap_or_default();
                texts.push(Text { key: format!("{id}{}{dotted}", form.suffix()), id, attribute, form, pattern });
            }
        }
    }
    texts.sort_by(|a, b| a.key.cmp(&b.key));
    texts
}

/// What the other language says in the scope of a text.
fn counterpart<'l>(other: &'l Language, text: &Text) -> Option<&'l Form> {
    let key = Key { id: text.id, attribute: text.attribute };
    match text.form.suffixes.as_slice() {
        // One suffix may be a cycle or a control; taken as either it selects the same variants.
        [one] => other.find(key, Scope { cycle: Some(one), control: None }),
        [cycle, control] => other.find(key, Scope::new(cycle, control)),
        _ => other.find(key, Scope::NONE),
    }
}

fn hash(pattern: &Pattern<&str>) -> u32 {
    let message = ast::Message {
        id: ast::Identifier { name: "x" },
        value: Some(pattern.clone()),
        attributes: Vec::new(),
        comment: None,
    };
    signature(&fluent_syntax::serializer::serialize(&ast::Resource { body: vec![ast::Entry::Message(message)] }))
}

/// A number for what a text says: arguments, numbers and code words as they are, other words by the set of
/// their consonants, so that a doubled letter, a turned pair or a wrong vowel changes nothing.
fn signature(text: &str) -> u32 {
    let mut hash = Fnv::default();
    for word in text.split(|c: char| !(c.is_alphanumeric() || matches!(c, '$' | '-' | '_'))) {
        let word = word.trim_matches('-');
        let exact = word.starts_with('$')
            || word.chars().any(|c| c.is_ascii_digit() || c == '_')
            || (word.chars().count() > 1 && !word.chars().any(char::is_lowercase));
        let sign: String = if exact {
            word.to_owned()
        } else {
            let lower = word.to_lowercase();
            let consonants: BTreeSet<char> =
                lower.chars().filter(|c| c.is_alphabetic() && !VOWELS.contains(*c)).collect();
            consonants.into_iter().collect()
        };
        if !sign.is_empty() {
            sign.bytes().chain([b' ']).for_each(|byte| hash.add(byte));
        }
    }
    hash.0
}

/// Vowels of the source language.
const VOWELS: &str = "aeiouy";

/// FNV-1a: only equality matters, and the lock must not change with a library's hash.
struct Fnv(u32);

impl Default for Fnv {
    fn default() -> Self {
        Self(0x811c_9dc5)
    }
}

impl Fnv {
    fn add(&mut self, byte: u8) {
        self.0 = (self.0 ^ u32::from(byte)).wrapping_mul(0x0100_0193);
    }
}

fn finding(language: &Language, key: &str, form: &Form, argument: Option<&str>) -> Finding {
    Finding { key: key.to_owned(), place: language.place(form), argument: argument.map(str::to_owned) }
}

/// The arguments that a text needs, through all messages that it refers to.
fn arguments<'l>(language: &'l Language, pattern: &'l Pattern<&'l str>) -> BTreeSet<&'l str> {
    let mut names = BTreeSet::new();
    let mut seen = HashSet::new();
    let mut waiting = vec![pattern];
    while let Some(pattern) = waiting.pop() {
        let mut referred = Vec::new();
        visit(pattern, &mut |node| match node {
            Node::Shown(name) | Node::Chosen(name, _) => {
                names.insert(name);
            }
            Node::Message { id, attribute } => referred.push((id, attribute)),
            Node::Term { .. } | Node::Function { .. } => {}
        });
        for (id, attribute) in referred {
            if seen.insert((id, attribute)) {
                let base = id.split_once("__").map_or(id, |(base, _)| base);
                let entry = language.entries.get(base).into_iter().flat_map(|entry| entry.all());
                let forms = entry.filter(|(key, _)| *key == attribute).flat_map(|(_, forms)| forms);
                waiting.extend(forms.filter_map(|form| language.pattern(form)));
            }
        }
    }
    names
}

impl Locales {
    /// Compares a translation with the source language; the source has nothing to be compared with.
    ///
    /// # Errors
    /// If the language or the source language was not loaded.
    pub fn audit(&self, tag: &str) -> Result<Audit, LocaleError> {
        self.audit_with(tag, &Meanings::new())
    }

    /// The same, and whether the specifications still mean what they meant when a text was translated.
    ///
    /// # Errors
    /// If the language or the source language was not loaded.
    pub fn audit_with(&self, tag: &str, meanings: &Meanings) -> Result<Audit, LocaleError> {
        let (source, translation) = (self.language(SOURCE_LANGUAGE)?, self.language(tag)?);
        let mut audit = Audit { language: tag.to_owned(), ..Audit::default() };
        if tag == SOURCE_LANGUAGE {
            audit.total = texts(source).len() + source.topics.len();
            return Ok(audit);
        }
        for text in texts(source).iter().filter(|text| !text.id.starts_with('-')) {
            audit.total += 1;
            if counterpart(translation, text).is_none() {
                audit.missing.push(finding(source, &text.key, text.form, None));
            }
        }
        for text in texts(translation) {
            let original = counterpart(source, &text).and_then(|form| source.pattern(form));
            match original {
                Some(original) => compare(&mut audit, (source, original), (translation, meanings), &text),
                None if text.id.starts_with('-') || text.attribute.is_some_and(|name| OWN.contains(&name)) => {}
                None => audit.orphans.push(finding(translation, &text.key, text.form, None)),
            }
        }
        topics(&mut audit, source, translation);
        Ok(audit)
    }

    /// The lock file that accepts a translation as it is.
    ///
    /// # Errors
    /// If the language or the source language was not loaded.
    pub fn accepted(&self, tag: &str, meanings: &Meanings) -> Result<String, LocaleError> {
        let (source, translation) = (self.language(SOURCE_LANGUAGE)?, self.language(tag)?);
        let mut lock = String::new();
        for text in texts(translation) {
            if let Some(original) = counterpart(source, &text).and_then(|form| source.pattern(form)) {
                let _ = write!(lock, "{} {:08x}", text.key, hash(original));
                if let Some(meaning) = meanings.get(text.id) {
                    let _ = write!(lock, " {meaning:08x}");
                }
                lock.push('\n');
            }
        }
        for (name, _) in translation.topics() {
            if let Some(original) = source.topic(name) {
                let _ = writeln!(lock, "{} {:08x}", topic_key(name), signature(original.text()));
            }
        }
        Ok(lock)
    }
}

/// The key of a page of prose in reports and lock files.
fn topic_key(name: &str) -> String {
    format!("topics/{name}")
}

/// Compares the pages of prose.
fn topics(audit: &mut Audit, source: &Language, translation: &Language) {
    let whole = |name: &str, page: &Arc<Source>| Finding {
        key: topic_key(name),
        place: Some(Place::new(page, Span::default())),
        argument: None,
    };
    for (name, original) in source.topics() {
        audit.total += 1;
        let Some(page) = translation.topic(name) else {
            audit.missing.push(whole(name, original));
            continue;
        };
        match translation.lock.as_ref().and_then(|lock| lock.0.get(&topic_key(name))) {
            None => audit.unrecorded.push(whole(name, page)),
            Some(recorded) if recorded.text != signature(original.text()) => audit.stale.push(whole(name, page)),
            Some(_) => {}
        }
    }
    for (name, page) in translation.topics().filter(|(name, _)| source.topic(name).is_none()) {
        audit.orphans.push(whole(name, page));
    }
}

fn compare(
    audit: &mut Audit,
    (source, original): (&Language, &Pattern<&str>),
    (translation, meanings): (&Language, &Meanings),
    text: &Text,
) {
    let recorded = translation.lock.as_ref().and_then(|lock| lock.0.get(&text.key));
    match recorded {
        None => audit.unrecorded.push(finding(translation, &text.key, text.form, None)),
        Some(recorded) => {
            let meant = recorded.meaning.zip(meanings.get(text.id)).is_none_or(|(then, now)| then == *now);
            if recorded.text != hash(original) || !meant {
                audit.stale.push(finding(translation, &text.key, text.form, None));
            }
        }
    }
    // A term takes what its own language needs.
    if text.id.starts_with('-') {
        return;
    }
    let offered = arguments(source, original);
    for name in arguments(translation, text.pattern).difference(&offered) {
        audit.unknown_arguments.push(finding(translation, &text.key, text.form, Some(name)));
    }
}
