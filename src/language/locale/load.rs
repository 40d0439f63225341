//! Reading the files of all languages: parsing, variants, duplicates, units and lists; pages of prose as they are.
//!
//! Invariant: a mistake costs the message it is in, never the file, and each has its place.
use std::collections::{BTreeMap, BTreeSet, HashMap};
use std::ops::Range;
use std::sync::Arc;

use fluent::FluentResource;
use fluent_syntax::ast::{self, Pattern};
use fluent_syntax::parser::{ErrorKind, ParserError};
use unic_langid::LanguageIdentifier;

use super::check;
use super::entries::{Entries, OnDemand};
use super::function::{Forms, ListForm};
use super::language::{Entry, Form, Language, Parts};
use super::lock::{Lock, Originals, list};
use super::pattern::{Node, Template, visit};
use crate::base::data::Prepared;
use crate::base::demand::Deferred;
use crate::base::diag::{Diagnostic, Mistakes, Place, Source, Span};
use crate::base::parallel;

/// The file of a language that holds its units and lists.
const UNITS: &str = "units.ftl";
/// The file of a language that records which source texts its translations were made from.
const LOCK: &str = "source.lock";
/// The file of the source language that keeps what its texts said when they were translated.
const ORIGINALS: &str = "accepted.lock";
/// The file of a language that lists what may be the same as in the source language.
const ALIKE: &str = "same-as-source.txt";
/// The folder of a language that holds its pages of prose.
const TOPICS: &str = "topics/";
/// What a page of prose ends in.
const PROSE: &str = ".md";
/// Fluent's parser recurses with each brace; no real message nests this deep.
const DEEPEST_NESTING: usize = 64;

/// Fluent's plural rules overflow with the digits of a longer number.
const MOST_DIGITS_TOGETHER: usize = 18;

/// All languages among the files, with all mistakes in them.
pub(super) fn languages<P, T>(
    files: impl IntoIterator<Item = (P, T)>,
) -> (BTreeMap<String, Arc<Language>>, Vec<Diagnostic>)
where
    P: AsRef<str>,
    T: AsRef<[u8]>,
{
    let mut diagnostics = Vec::new();
    let mut grouped: BTreeMap<String, Vec<(String, Arc<Source>)>> = BTreeMap::new();
    for (path, bytes) in files {
        let Some((tag, name)) = address(path.as_ref()) else { continue };
        match std::str::from_utf8(bytes.as_ref()) {
            Ok(text) => {
                let text = text.strip_prefix('\u{feff}').unwrap_or(text);
                grouped.entry(tag.to_owned()).or_default().push((name.to_owned(), Source::new(path.as_ref(), text)));
            }
            Err(_) => diagnostics.push(Diagnostic::error("locale-encoding", start(&Source::new(path.as_ref(), "")))),
        }
    }
    let grouped: Vec<(String, Vec<(String, Arc<Source>)>)> = grouped.into_iter().collect();
    let read = parallel::map(&grouped, |(tag, sources)| {
        let mut found = Vec::new();
        let language = language(tag, sources.clone(), &mut found);
        (language, found)
    });
    let mut languages = BTreeMap::new();
    for ((tag, _), (language, found)) in grouped.into_iter().zip(read) {
        diagnostics.extend(found);
        languages.extend(language.map(|language| (tag, Arc::new(language))));
    }
    (languages, diagnostics)
}

/// One language of all its files.
fn language(tag: &str, mut sources: Vec<(String, Arc<Source>)>, found: &mut Vec<Diagnostic>) -> Option<Language> {
    sources.sort_by(|(a, _), (b, _)| a.cmp(b));
    let language = Language::new(Reader::new(found).read(tag, sources)?);
    check::language(&language, found);
    Some(language)
}

/// Language and name of a file of ours below `locales/`.
fn address(path: &str) -> Option<(&str, &str)> {
    let inside = match path.rfind("/locales/") {
        Some(at) => path.get(at + "/locales/".len()..)?,
        None => path.strip_prefix("locales/")?,
    };
    let (tag, name) = inside.split_once('/')?;
    // A folder by itself is a language that has nothing yet.
    (name.is_empty() || name.ends_with(".ftl") || [LOCK, ORIGINALS, ALIKE].contains(&name) || topic(name).is_some())
        .then_some((tag, name))
}

/// The topic of a page of prose: `topics/threads.md` is `threads`.
fn topic(name: &str) -> Option<&str> {
    name.strip_prefix(TOPICS)?.strip_suffix(PROSE).filter(|topic| !topic.contains('/'))
}

fn start(source: &Arc<Source>) -> Place {
    Place::new(source, Span::default())
}

/// The place of a slice of the text that a resource owns.
pub(super) fn span_in(text: &str, slice: &str) -> Span {
    let offset = (slice.as_ptr() as usize).saturating_sub(text.as_ptr() as usize).min(text.len());
    Span::new(offset, (offset + slice.len()).min(text.len()))
}

/// All languages of the embedded files.
pub(super) fn open(data: &'static Prepared, mistakes: &Mistakes) -> BTreeMap<String, Arc<Language>> {
    let language = |&(tag, records): &(&'static str, &'static [u8])| {
        let id = tag.parse().ok()?;
        let forms = Deferred::new(move || Arc::new(embedded_forms(tag, data)));
        let lock = Deferred::new(move || {
            let path = format!("locales/{tag}/{LOCK}");
            let (path, text) = data.below(&path).next()?;
            Some(Lock::read(&Source::embedded(path, text), &mut Vec::new()))
        });
        let originals = Deferred::new(move || {
            let path = format!("locales/{tag}/{ORIGINALS}");
            let found = data.below(&path).next();
            found.map_or_else(Originals::default, |(path, text)| {
                Originals::read(&Source::embedded(path, text), &mut Vec::new())
            })
        });
        let alike = Deferred::new(move || {
            let path = format!("locales/{tag}/{ALIKE}");
            data.below(&path).flat_map(|(_, text)| list(text)).collect()
        });
        let topics = Deferred::new(move || {
            let folder = format!("locales/{tag}/{TOPICS}");
            let pages = data.below(&folder).filter_map(|(path, text)| {
                let (_, name) = address(path)?;
                Some((topic(name)?.to_owned(), Source::embedded(path, text)))
            });
            pages.collect()
        });
        let entries = Entries::OnDemand(OnDemand::new(data, records, mistakes.clone()));
        let parts = Parts { tag: tag.to_owned(), id, entries, forms, lock, originals, alike, topics };
        Some((tag.to_owned(), Arc::new(Language::new(parts))))
    };
    data.messages.iter().filter_map(language).collect()
}

fn embedded_forms(tag: &str, data: &'static Prepared) -> Forms {
    let mut forms = Forms::of(tag);
    let path = format!("locales/{tag}/{UNITS}");
    if let Some((path, text)) = data.below(&path).next() {
        let source = Source::embedded(path, text);
        let mut found = Vec::new();
        let mut reader = Reader::new(&mut found);
        let resource = reader.parse(&source, 0..text.len());
        reader.units(&source, &resource, &mut forms);
    }
    forms
}

pub(super) struct Reader<'d> {
    diagnostics: &'d mut Vec<Diagnostic>,
    pub(super) entries: HashMap<String, Entry>,
    defined: HashMap<String, Place>,
}

impl<'d> Reader<'d> {
    pub(super) fn new(diagnostics: &'d mut Vec<Diagnostic>) -> Self {
        Self { diagnostics, entries: HashMap::new(), defined: HashMap::new() }
    }

    fn read(mut self, tag: &str, sources: Vec<(String, Arc<Source>)>) -> Option<Parts> {
        let Ok(id) = tag.parse::<LanguageIdentifier>() else {
            let place = sources.first().map(|(_, source)| start(source))?;
            self.diagnostics.push(Diagnostic::error("locale-tag", place).arg("tag", tag));
            return None;
        };
        let mut lock = None;
        let (mut originals, mut alike) = (Originals::default(), BTreeSet::new());
        let mut topics = BTreeMap::new();
        let mut forms = Forms::of(tag);
        for (name, source) in sources {
            if name.is_empty() {
                continue;
            }
            if name == LOCK {
                lock = Some(Lock::read(&source, self.diagnostics));
            } else if name == ORIGINALS {
                originals = Originals::read(&source, self.diagnostics);
            } else if name == ALIKE {
                alike = list(source.text());
            } else if let Some(topic) = topic(&name) {
                topics.insert(topic.to_owned(), source);
            } else if self.shallow(&source) && self.short_numbers(&source) {
                let resource = self.parse(&source, 0..source.text().len());
                self.collect(&source, &resource, 0);
                if name == UNITS {
                    self.units(&source, &resource, &mut forms);
                }
            }
        }
        let entries = Entries::Read(self.entries);
        Some(Parts {
            tag: tag.to_owned(),
            id,
            entries,
            forms: Arc::new(forms).into(),
            lock: lock.into(),
            originals: originals.into(),
            alike: alike.into(),
            topics: topics.into(),
        })
    }

    /// Whether nothing is nested so deeply that parsing it would need more stack than there is.
    fn shallow(&mut self, source: &Arc<Source>) -> bool {
        let mut depth = 0_usize;
        let mut begins_line = true;
        for (at, byte) in source.text().bytes().enumerate() {
            if begins_line && !matches!(byte, b' ' | b'}' | b'\t' | b'\r' | b'\n') {
                depth = 0;
            }
            begins_line = byte == b'\n';
            // Arguments of functions nest as placeables do.
            depth = match byte {
                b'{' | b'(' => depth + 1,
                b'}' | b')' => depth.saturating_sub(1),
                _ => depth,
            };
            if depth > DEEPEST_NESTING {
                let place = Place::new(source, at..at + 1);
                self.diagnostics.push(Diagnostic::error("locale-nesting", place).arg("most", DEEPEST_NESTING));
                return false;
            }
        }
        true
    }

    fn short_numbers(&mut self, source: &Arc<Source>) -> bool {
        let mut run = 0;
        for (at, byte) in source.text().bytes().enumerate() {
            run = if byte.is_ascii_digit() { run + 1 } else { 0 };
            if run > MOST_DIGITS_TOGETHER {
                let place = Place::new(source, at + 1 - run..at + 1);
                self.diagnostics.push(Diagnostic::error("locale-long-number", place).arg("most", MOST_DIGITS_TOGETHER));
                return false;
            }
        }
        true
    }

    /// Parses a stretch of a file.
    pub(super) fn parse(&mut self, source: &Arc<Source>, span: Range<usize>) -> Arc<FluentResource> {
        let start = span.start;
        let text = source.text().get(span).unwrap_or_default();
        let (resource, errors) = match FluentResource::try_new(text.to_owned()) {
            Ok(resource) => (resource, Vec::new()),
            Err(damaged) => damaged,
        };
        self.diagnostics.extend(errors.iter().map(|error| syntax_error(source, error, start)));
        for (at, mark) in text.match_indices(['\u{2068}', '\u{2069}']) {
            let place = Place::new(source, start + at..start + at + mark.len());
            self.diagnostics.push(Diagnostic::error("locale-isolation-mark", place));
        }
        Arc::new(resource)
    }

    /// Takes over the messages of a stretch that begins at this byte of its file.
    pub(super) fn collect(&mut self, source: &Arc<Source>, resource: &Arc<FluentResource>, start: usize) {
        let span_of = |text: &str| {
            let span = span_in(resource.source(), text);
            Span::new(start + span.start, start + span.end)
        };
        for (entry, node) in resource.entries().enumerate() {
            let (name, sign, value, attributes) = match node {
                ast::Entry::Message(message) => (message.id.name, "", message.value.as_ref(), &message.attributes),
                ast::Entry::Term(term) => (term.id.name, "-", Some(&term.value), &term.attributes),
                _ => continue,
            };
            let place = Place::new(source, span_of(name));
            // Fluent keeps messages and terms in one table, so `x` and `-x` exclude each other.
            if self.is_double(name, &place) {
                continue;
            }
            let Some((base, suffixes)) = self.suffixes(name, &place) else { continue };
            let form = |attribute, span, refers| Form {
                suffixes: suffixes.clone(),
                source: Arc::clone(source),
                resource: Arc::clone(resource),
                entry,
                attribute,
                refers,
                span,
            };
            let mut forms = Vec::new();
            if let Some(pattern) = value {
                forms.push((None, form(None, place.span, refers(pattern))));
            }
            for (index, attribute) in attributes.iter().enumerate() {
                let span = span_of(attribute.id.name);
                let refers = refers(&attribute.value);
                forms.push((Some(attribute.id.name), form(Some(index), span, refers)));
            }
            self.add(source, format!("{sign}{base}"), forms);
        }
    }

    fn add(&mut self, source: &Arc<Source>, id: String, forms: Vec<(Option<&str>, Form)>) {
        let mut seen: HashMap<&str, Span> = HashMap::new();
        let entry = self.entries.entry(id).or_default();
        for (attribute, form) in forms {
            let Some(name) = attribute else {
                entry.value.push(form);
                continue;
            };
            if let Some(first) = seen.insert(name, form.span) {
                self.diagnostics.push(
                    Diagnostic::error("locale-duplicate", Place::new(source, form.span))
                        .arg("key", name)
                        .related("first-definition", Place::new(source, first)),
                );
                continue;
            }
            match entry.attributes.iter_mut().find(|(own, _)| **own == *name) {
                Some((_, forms)) => forms.push(form),
                None => entry.attributes.push((name.into(), vec![form])),
            }
        }
    }

    fn is_double(&mut self, name: &str, place: &Place) -> bool {
        if let Some(first) = self.defined.get(name) {
            self.diagnostics.push(
                Diagnostic::error("locale-duplicate", place.clone())
                    .arg("key", name)
                    .related("first-definition", first.clone()),
            );
            return true;
        }
        self.defined.insert(name.to_owned(), place.clone());
        false
    }

    fn suffixes<'n>(&mut self, name: &'n str, place: &Place) -> Option<(&'n str, Vec<Box<str>>)> {
        let mut segments = name.split("__");
        let base = segments.next().filter(|base| !base.is_empty());
        let suffixes: Vec<Box<str>> = segments.map(Box::from).collect();
        match base {
            Some(base) if suffixes.len() <= 2 && suffixes.iter().all(|suffix| !suffix.is_empty()) => {
                Some((base, suffixes))
            }
            _ => {
                self.diagnostics.push(Diagnostic::error("locale-variant", place.clone()).arg("key", name));
                None
            }
        }
    }

    fn units(&mut self, source: &Arc<Source>, resource: &FluentResource, forms: &mut Forms) {
        for node in resource.entries() {
            let ast::Entry::Message(message) = node else { continue };
            let id = message.id.name;
            let sound = if let Some(name) = id.strip_prefix("unit-") {
                message.value.as_ref().and_then(|value| Template::of(value, &["value"])).map(|template| {
                    forms.units.insert(name.to_owned(), template);
                })
            } else if let Some(name) = id.strip_prefix("list-") {
                list_form(message).map(|form| {
                    forms.lists.insert(name.to_owned(), form);
                })
            } else {
                Some(())
            };
            if sound.is_none() {
                let place = Place::new(source, span_in(resource.source(), id));
                self.diagnostics.push(Diagnostic::error("locale-unit-form", place).arg("key", id));
            }
        }
    }
}

fn list_form(message: &ast::Message<&str>) -> Option<ListForm> {
    let template = |pattern| Template::of(pattern, &["first", "last"]);
    let more = message.attributes.iter().find(|attribute| attribute.id.name == "more")?;
    Some(ListForm { last: template(message.value.as_ref()?)?, more: template(&more.value)? })
}

/// Whether the pattern refers to other messages or terms.
fn refers(pattern: &Pattern<&str>) -> bool {
    let mut any = false;
    visit(pattern, &mut |node| any |= matches!(node, Node::Message { .. } | Node::Term { .. }));
    any
}

fn syntax_error(source: &Arc<Source>, error: &ParserError, start: usize) -> Diagnostic {
    let (kind, detail) = describe(&error.kind);
    let place = Place::new(source, start + error.pos.start..start + error.pos.end);
    let diagnostic = Diagnostic::error("locale-syntax", place);
    diagnostic.arg("kind", kind).arg("detail", detail)
}

/// The kind as a word of the `kind` selector in `diag-locale-syntax`, and what belongs to it.
fn describe(kind: &ErrorKind) -> (&'static str, String) {
    let (word, detail) = match kind {
        ErrorKind::ExpectedToken(token) => return ("expected-token", token.to_string()),
        ErrorKind::ExpectedCharRange { range } => ("expected-character", range.as_str()),
        ErrorKind::ExpectedMessageField { entry_id } => ("empty-message", entry_id.as_str()),
        ErrorKind::ExpectedTermField { entry_id } => ("empty-term", entry_id.as_str()),
        ErrorKind::ForbiddenCallee => ("bad-function-name", ""),
        ErrorKind::MissingDefaultVariant => ("no-default", ""),
        ErrorKind::MissingValue => ("no-value", ""),
        ErrorKind::MultipleDefaultVariants => ("two-defaults", ""),
        ErrorKind::MessageReferenceAsSelector
        | ErrorKind::TermReferenceAsSelector
        | ErrorKind::MessageAttributeAsSelector
        | ErrorKind::ExpectedSimpleExpressionAsSelector => ("bad-selector", ""),
        ErrorKind::TermAttributeAsPlaceable => ("term-attribute", ""),
        ErrorKind::UnterminatedStringLiteral => ("open-string", ""),
        ErrorKind::PositionalArgumentFollowsNamed => ("argument-order", ""),
        ErrorKind::DuplicatedNamedArgument(name) => ("argument-twice", name.as_str()),
        ErrorKind::UnknownEscapeSequence(escape) | ErrorKind::InvalidUnicodeEscapeSequence(escape) => {
            ("bad-escape", escape.as_str())
        }
        ErrorKind::UnbalancedClosingBrace => ("closing-brace", ""),
        ErrorKind::ExpectedInlineExpression | ErrorKind::ExpectedLiteral => ("no-expression", ""),
    };
    (word, detail.to_owned())
}
