//! How far a translation follows its source: missing, left over, stale, and asking for too much.
//!
//! Each translation has a file `source.lock` with a line a text: `id[.attribute] text [meaning] =translation`: a number
//! for the words of the source text which it translates, one for what the specifications mean by it, and one for the
//! translation that was accepted (`accept`). A mended slip of the pen leaves the first as it is: words of more than three
//! letters count by their consonants. A variant counts as a translation of whatever the source language says in the same
//! scope. Invariant: nothing is changed.
use std::collections::{BTreeSet, HashMap, HashSet};
use std::sync::Arc;

use fluent_syntax::ast::{self, Pattern};

use super::language::{Form, Key, Language, Scope};
use super::lock::Recorded;
use super::moved::moved;
use super::pattern::{self, Node, visit};
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
    /// An argument, or the key of another text, where the finding is about one.
    pub argument: Option<String>,
    /// What changed in the source text since it was translated, where that is known: `“earlier” → “now”`.
    pub change: Option<String>,
}

/// A text of the source language.
#[derive(Clone, Debug)]
pub struct SourceText {
    /// The message with its suffixes and `.attribute`, or `topics/` and the name of a page.
    pub key: String,
    /// The message without suffixes and attribute.
    pub id: String,
    /// Where its name is.
    pub place: Place,
    /// What it says, in Fluent or Markdown.
    pub text: String,
}

/// A text with its translation.
#[derive(Clone, Debug)]
pub struct Pair {
    /// The message with its suffixes and `.attribute`; terms begin with `-`.
    pub key: String,
    /// The message without suffixes and attribute.
    pub id: String,
    /// Where the name of the source text is.
    pub source: Place,
    /// Where the name of the translation is.
    pub target: Option<Place>,
}

fn pair(text: &Text, source: Option<Place>, target: Option<Place>) -> Option<Pair> {
    Some(Pair { key: text.key.clone(), id: text.id.to_owned(), source: source?, target })
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
    /// Translations that have got the words of another text since they were accepted.
    pub moved: Vec<Finding>,
    /// Texts with the words of the source language, which no list allows.
    pub same: Vec<Finding>,
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
        self.append(&mut all, &self.moved, "locale-moved", warn);
        self.append(&mut all, &self.same, "locale-same-as-source", warn);
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
            let diagnostic = match &finding.argument {
                Some(argument) => diagnostic.arg("name", argument.as_str()),
                None => diagnostic,
            };
            all.push(match (&finding.change, code) {
                (change, "locale-stale") => diagnostic.arg("change", change.as_deref().unwrap_or("none")),
                _ => diagnostic,
            });
        }
    }
}

/// A text of a language with what is needed to compare it.
pub(super) struct Text<'l> {
    pub(super) key: String,
    pub(super) id: &'l str,
    pub(super) attribute: Option<&'l str>,
    pub(super) form: &'l Form,
    pub(super) pattern: &'l Pattern<&'l str>,
}

pub(super) fn texts(language: &Language) -> Vec<Text<'_>> {
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
pub(super) fn counterpart<'l>(other: &'l Language, text: &Text) -> Option<&'l Form> {
    let key = Key { id: text.id, attribute: text.attribute };
    match text.form.suffixes.as_slice() {
        // One suffix may be a cycle or a control; taken as either it selects the same variants.
        [one] => other.find(key, Scope { cycle: Some(one), control: None }),
        [cycle, control] => other.find(key, Scope::new(cycle, control)),
        _ => other.find(key, Scope::NONE),
    }
}

pub(super) fn hash(pattern: &Pattern<&str>) -> u32 {
    signature(&serialized(pattern))
}

/// The pattern as a file has it, in the layout of Fluent's own serializer, without indentation of the first line.
pub(super) fn written(pattern: &Pattern<&str>) -> String {
    let text = serialized(pattern);
    text.trim_end().strip_prefix("x =").map_or_else(String::new, |text| text.trim_start_matches(' ').to_owned())
}

/// The pattern as the value of a message `x`.
fn serialized(pattern: &Pattern<&str>) -> String {
    let message = ast::Message {
        id: ast::Identifier { name: "x" },
        value: Some(pattern.clone()),
        attributes: Vec::new(),
        comment: None,
    };
    fluent_syntax::serializer::serialize(&ast::Resource { body: vec![ast::Entry::Message(message)] })
}

/// A number for exactly this text.
pub(super) fn digest(text: &str) -> u32 {
    let mut hash = Fnv::default();
    text.bytes().for_each(|byte| hash.add(byte));
    hash.0
}

/// A number for what a text says: arguments, numbers, code words and short words (`no`, `not`, `on`) as they are, other
/// words by the set of their consonants, so that a doubled letter, a turned pair or a wrong vowel changes nothing.
pub(super) fn signature(text: &str) -> u32 {
    let mut hash = Fnv::default();
    for word in text.split(|c: char| !(c.is_alphanumeric() || matches!(c, '$' | '-' | '_'))) {
        let word = word.trim_matches('-');
        let exact = word.starts_with('$')
            || word.chars().any(|c| c.is_ascii_digit() || c == '_')
            || (word.chars().count() > 1 && !word.chars().any(char::is_lowercase));
        let lower = word.to_lowercase();
        let sign: String = if exact {
            word.to_owned()
        } else if SHORT.contains(&lower.chars().count()) && !is_article(&lower) {
            lower
        } else {
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

/// How many letters the short words have.
const SHORT: std::ops::RangeInclusive<usize> = 2..=3;
/// The letters, in their order, of short words that say nothing: the articles.
const ARTICLES: [&str; 2] = ["an", "eht"];
/// Vowels of the source language.
const VOWELS: &str = "aeiouy";

/// Whether a word is an article, with its letters in whatever order.
fn is_article(word: &str) -> bool {
    let mut letters: Vec<char> = word.chars().collect();
    letters.sort_unstable();
    ARTICLES.iter().any(|article| article.chars().eq(letters.iter().copied()))
}

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
    Finding { key: key.to_owned(), place: language.place(form), argument: argument.map(str::to_owned), change: None }
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

    /// Every text of the source language but terms, in the order of keys, then the pages of prose.
    ///
    /// # Errors
    /// If the source language was not loaded.
    pub fn sources(&self) -> Result<Vec<SourceText>, LocaleError> {
        let source = self.language(SOURCE_LANGUAGE)?;
        let messages = texts(source).into_iter().filter(|text| !text.id.starts_with('-')).filter_map(|text| {
            let place = source.place(text.form)?;
            Some(SourceText { id: text.id.to_owned(), text: written(text.pattern), key: text.key, place })
        });
        let pages = source.topics().map(|(name, page)| SourceText {
            key: topic_key(name),
            id: topic_key(name),
            place: Place::new(page, Span::default()),
            text: page.text().to_owned(),
        });
        Ok(messages.chain(pages).collect())
    }

    /// Every text that a translator works on, with its source: those of the source language and the variants that the
    /// translation has of its own. What a language may have alone is left out, and so is a variant that a wider text
    /// of the translation covers. Of a language that was not loaded nothing is translated.
    ///
    /// # Errors
    /// If the source language was not loaded.
    pub fn pairs(&self, tag: &str) -> Result<Vec<Pair>, LocaleError> {
        let source = self.language(SOURCE_LANGUAGE)?;
        let translation = self.languages.get(tag);
        let own: HashMap<String, Text> =
            translation.into_iter().flat_map(|own| texts(own)).map(|text| (text.key.clone(), text)).collect();
        let is_shared = |text: &Text| text.attribute.is_none_or(|name| !OWN.contains(&name));
        let originals = texts(source);
        let mut pairs = Vec::new();
        for text in originals.iter().filter(|text| is_shared(text)) {
            let target = own.get(&text.key);
            if target.is_none() && translation.is_some_and(|other| counterpart(other, text).is_some()) {
                continue;
            }
            let place = target.and_then(|target| translation?.place(target.form));
            pairs.extend(pair(text, source.place(text.form), place));
        }
        let known: HashSet<&str> = originals.iter().map(|text| text.key.as_str()).collect();
        for text in own.values().filter(|text| is_shared(text) && !known.contains(text.key.as_str())) {
            let original = counterpart(source, text).and_then(|form| source.place(form));
            pairs.extend(pair(text, original, translation.and_then(|other| other.place(text.form))));
        }
        pairs.sort_by(|a, b| {
            let at = |pair: &Pair| (pair.source.source.name().to_owned(), pair.source.span.start);
            at(a).cmp(&at(b)).then_with(|| a.key.cmp(&b.key))
        });
        Ok(pairs)
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
        let moved = moved(source, translation);
        for text in texts(translation) {
            if let Some(other) = moved.get(&text.key) {
                audit.moved.push(finding(translation, &text.key, text.form, Some(other)));
            }
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
}

/// The key of a page of prose in reports and lock files.
pub(super) fn topic_key(name: &str) -> String {
    format!("topics/{name}")
}

/// Compares the pages of prose.
fn topics(audit: &mut Audit, source: &Language, translation: &Language) {
    let whole = |name: &str, page: &Arc<Source>| Finding {
        key: topic_key(name),
        place: Some(Place::new(page, Span::default())),
        argument: None,
        change: None,
    };
    for (name, original) in source.topics() {
        audit.total += 1;
        let Some(page) = translation.topic(name) else {
            audit.missing.push(whole(name, original));
            continue;
        };
        match translation.lock.as_ref().and_then(|lock| lock.0.get(&topic_key(name))) {
            None => audit.unrecorded.push(whole(name, page)),
            Some(recorded) if recorded.text != signature(original.text()) => {
                let change = changed(source, &topic_key(name), recorded, original.text());
                audit.stale.push(Finding { change, ..whole(name, page) });
            }
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
                let change = changed(source, &text.key, recorded, &written(original));
                audit.stale.push(Finding { change, ..finding(translation, &text.key, text.form, None) });
            }
        }
    }
    if is_same(source, translation, original, text) {
        audit.same.push(finding(translation, &text.key, text.form, None));
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

/// What changed in a text since it was recorded, if the words of then were kept.
fn changed(source: &Language, key: &str, recorded: &Recorded, now: &str) -> Option<String> {
    let earlier = source.originals.get(key, recorded.text)?;
    difference(earlier, now)
}

/// The words by which two texts differ, between what they begin and end with.
fn difference(earlier: &str, now: &str) -> Option<String> {
    let (then, now): (Vec<&str>, Vec<&str>) = (earlier.split_whitespace().collect(), now.split_whitespace().collect());
    let begin = then.iter().zip(&now).take_while(|(a, b)| a == b).count();
    let most = then.len().min(now.len()).saturating_sub(begin);
    let end = then.iter().rev().zip(now.iter().rev()).take(most).take_while(|(a, b)| a == b).count();
    let part = |words: &[&str]| words.get(begin..words.len() - end).unwrap_or_default().join(" ");
    let (then, now) = (part(&then), part(&now));
    (then != now).then(|| format!("“{then}” → “{now}”"))
}

/// Shortest word that counts as one of a language, in letters.
const WORD: usize = 3;

/// Whether a text has the words of the source text, and no list says that it may.
fn is_same(source: &Language, translation: &Language, original: &Pattern<&str>, text: &Text) -> bool {
    if text.attribute.is_some_and(|name| OWN.contains(&name)) || written(original) != written(text.pattern) {
        return false;
    }
    let lists = [&*source.alike, &*translation.alike];
    let key = format!("{}{}", text.id, text.attribute.map(|name| format!(".{name}")).unwrap_or_default());
    let is_of = |line: &String| line.strip_suffix('*').map_or(*line == key, |head| key.starts_with(head));
    if lists.iter().any(|list| list.iter().any(is_of)) {
        return false;
    }
    let mut sketch = pattern::sketch(original, &|_| Some(String::new()));
    while let Some((before, inside)) = sketch.split_once('‹') {
        let after = inside.split_once('›').map_or("", |(_, after)| after);
        sketch = format!("{before} {after}");
    }
    let words = sketch.split(|c: char| !c.is_alphabetic());
    let is_word = |word: &str| word.chars().count() >= WORD && word.chars().any(char::is_lowercase);
    words.filter(|word| is_word(word)).any(|word| !lists.iter().any(|list| list.contains(word)))
}
