//! One language: its texts, looked up by cycle and control, and its ways of writing numbers and lists.
//!
//! Look-ups are compiled when the files are read: a text is found with one hash and a comparison a
//! variant, and text without placeables is handed out without formatting. References inside a text
//! see the same variants; a bundle with what a text refers to is made for each combination of a cycle and a
//! control that this distinguishes, when it is first needed. Invariant: what comes out is either the
//! whole text or an error.
use std::borrow::Cow;
use std::collections::{BTreeMap, BTreeSet, HashMap, HashSet};
use std::fmt;
use std::sync::{Arc, OnceLock, PoisonError, RwLock};

use fluent::concurrent::FluentBundle;
use fluent::resolver::ResolverError;
use fluent::resolver::errors::ReferenceKind;
use fluent::{FluentError, FluentResource};
use fluent_syntax::ast::{self, Pattern};
use unic_langid::LanguageIdentifier;

use super::args::Args;
use super::collation::Collation;
use super::entries::Entries;
use super::error::{Fault, LocaleError};
use super::function::{self, Forms};
use super::lock::{Lock, Originals};
use super::number::{Digits, Numbers};
use super::pattern;
use crate::base::demand::Deferred;
use crate::base::diag::{Place, Source, Span};

type Bundle = FluentBundle<Arc<FluentResource>>;

/// Which text: a message, or one of its attributes. `"id"` and `"id.attribute"` convert into it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Key<'a> {
    /// The message.
    pub id: &'a str,
    /// The attribute; the value of the message without one.
    pub attribute: Option<&'a str>,
}

impl<'a> From<&'a str> for Key<'a> {
    fn from(key: &'a str) -> Self {
        match key.split_once('.') {
            Some((id, attribute)) => Self { id, attribute: Some(attribute) },
            None => Self { id: key, attribute: None },
        }
    }
}

impl<'a> From<&'a String> for Key<'a> {
    fn from(key: &'a String) -> Self {
        Self::from(key.as_str())
    }
}

impl<'a> From<(&'a str, &'a str)> for Key<'a> {
    fn from((id, attribute): (&'a str, &'a str)) -> Self {
        Self { id, attribute: Some(attribute) }
    }
}

impl fmt::Display for Key<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.id)?;
        self.attribute.map_or(Ok(()), |attribute| write!(f, ".{attribute}"))
    }
}

/// For which cycle and control a text is wanted.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Scope<'a> {
    /// The key of the cycle.
    pub cycle: Option<&'a str>,
    /// The key of the control.
    pub control: Option<&'a str>,
}

impl<'a> Scope<'a> {
    /// No cycle and no control.
    pub const NONE: Scope<'static> = Scope { cycle: None, control: None };

    /// A cycle on a control.
    pub const fn new(cycle: &'a str, control: &'a str) -> Self {
        Self { cycle: Some(cycle), control: Some(control) }
    }

    /// A control, whatever the cycle.
    pub const fn control(control: &'a str) -> Self {
        Self { cycle: None, control: Some(control) }
    }

    /// How specific a variant with these suffixes is here, 0 being the base; nothing if it is for
    /// another scope. A cycle says more than a control.
    fn rank(self, suffixes: &[Box<str>]) -> Option<u8> {
        match suffixes {
            [] => Some(0),
            [one] if self.cycle == Some(one) => Some(2),
            [one] if self.control == Some(one) => Some(1),
            [cycle, control] if self.cycle == Some(cycle) && self.control == Some(control) => Some(3),
            _ => None,
        }
    }
}

/// One variant of a text: where it is, and for which scope.
#[derive(Clone)]
pub(super) struct Form {
    pub(super) suffixes: Vec<Box<str>>,
    pub(super) source: Arc<Source>,
    /// What the file, or a part of it, was parsed to.
    pub(super) resource: Arc<FluentResource>,
    /// The index of the message there.
    pub(super) entry: usize,
    pub(super) attribute: Option<usize>,
    /// Whether references to other messages or terms must be resolved.
    pub(super) refers: bool,
    pub(super) span: Span,
}

impl Form {
    /// The suffixes as written after the identifier.
    pub(super) fn suffix(&self) -> String {
        self.suffixes.iter().map(|suffix| format!("__{suffix}")).collect()
    }
}

/// All variants of a message or term (whose identifier begins with `-`).
#[derive(Clone, Default)]
pub(super) struct Entry {
    pub(super) value: Vec<Form>,
    pub(super) attributes: Vec<(Box<str>, Vec<Form>)>,
}

impl Entry {
    fn forms(&self, attribute: Option<&str>) -> &[Form] {
        match attribute {
            None => &self.value,
            Some(name) => {
                self.attributes.iter().find(|(own, _)| **own == *name).map_or(&[], |(_, forms)| forms.as_slice())
            }
        }
    }

    fn best(&self, attribute: Option<&str>, scope: Scope) -> Option<&Form> {
        let ranked = self.forms(attribute).iter().filter_map(|form| Some((scope.rank(&form.suffixes)?, form)));
        ranked.max_by_key(|(rank, _)| *rank).map(|(_, form)| form)
    }

    /// Each key of the entry with all of its forms.
    pub(super) fn all(&self) -> impl Iterator<Item = (Option<&str>, &[Form])> {
        let attributes = self.attributes.iter().map(|(name, forms)| (Some(&**name), forms.as_slice()));
        std::iter::once((None, self.value.as_slice())).chain(attributes)
    }
}

/// What the files of a language say; see `load`.
pub(super) struct Parts {
    pub(super) tag: String,
    pub(super) id: LanguageIdentifier,
    pub(super) entries: Entries,
    pub(super) forms: Deferred<Arc<Forms>>,
    pub(super) lock: Deferred<Option<Lock>>,
    /// What texts of the source language said when translations of them were accepted.
    pub(super) originals: Deferred<Originals>,
    /// Words and keys of texts that may be the same as in the source language.
    pub(super) alike: Deferred<BTreeSet<String>>,
    /// Pages of prose by topic.
    pub(super) topics: Deferred<BTreeMap<String, Arc<Source>>>,
}

/// The identifiers of the messages and terms that a text leads to, and the parts of the scope that they distinguish.
type Overlay = (BTreeSet<String>, Option<String>, Option<String>);

/// One language.
pub struct Language {
    pub(super) tag: String,
    pub(super) entries: Entries,
    pub(super) lock: Deferred<Option<Lock>>,
    pub(super) originals: Deferred<Originals>,
    pub(super) alike: Deferred<BTreeSet<String>>,
    pub(super) topics: Deferred<BTreeMap<String, Arc<Source>>>,
    id: LanguageIdentifier,
    forms: Deferred<Arc<Forms>>,
    collation: OnceLock<Collation>,
    /// For texts that refer to no others.
    base: OnceLock<Bundle>,
    overlays: RwLock<HashMap<Overlay, Arc<Bundle>>>,
}

impl Language {
    pub(super) fn new(parts: Parts) -> Self {
        Self {
            tag: parts.tag,
            entries: parts.entries,
            lock: parts.lock,
            originals: parts.originals,
            alike: parts.alike,
            topics: parts.topics,
            id: parts.id,
            forms: parts.forms,
            collation: OnceLock::new(),
            base: OnceLock::new(),
            overlays: RwLock::default(),
        }
    }

    /// The identifiers of the messages that were read so far, in order; terms begin with `-`.
    pub fn read_so_far(&self) -> Vec<&str> {
        self.entries.read()
    }

    /// The tag, such as `fi`.
    pub fn tag(&self) -> &str {
        &self.tag
    }

    /// The order of words.
    pub fn collation(&self) -> &Collation {
        self.collation.get_or_init(|| Collation::of(&self.tag))
    }

    /// The way of writing numbers.
    pub fn numbers(&self) -> &Numbers {
        &self.forms.numbers
    }

    /// The number with its unit, as prose shows it: `0,5 mm`; nothing if the number is not finite or
    /// the language has no message `unit-<unit>`.
    pub fn unit(&self, value: f64, unit: &str, digits: Digits) -> Option<String> {
        let number = self.forms.numbers.prose(value, digits)?;
        Some(self.forms.units.get(unit)?.fill(&[&number]))
    }

    /// The page of prose about a topic, in Markdown.
    pub fn topic(&self, name: &str) -> Option<&Arc<Source>> {
        self.topics.get(name)
    }

    /// The topics with a page of prose, in alphabetical order.
    pub fn topics(&self) -> impl Iterator<Item = (&str, &Arc<Source>)> {
        self.topics.iter().map(|(name, source)| (name.as_str(), source))
    }

    /// The identifiers of all messages (without suffixes, without terms), in no order.
    pub fn ids(&self) -> impl Iterator<Item = &str> {
        self.entries.ids().filter(|id| !id.starts_with('-'))
    }

    /// The suffixes that variants have, for a check that each is a cycle or a control, with a place.
    pub fn suffixes(&self) -> Vec<(&str, Place)> {
        let mut all: Vec<(&str, Place)> = Vec::new();
        for form in self.entries.iter().flat_map(|(_, entry)| entry.all()).flat_map(|(_, forms)| forms) {
            for suffix in &form.suffixes {
                if let Some(place) = self.place(form) {
                    all.push((suffix, place));
                }
            }
        }
        all.sort_by(|(a, at), (b, bt)| (a, at.source.name(), at.span).cmp(&(b, bt.source.name(), bt.span)));
        all
    }

    /// Whether there is such a text for the scope.
    pub fn has<'k>(&self, key: impl Into<Key<'k>>, scope: &Scope) -> bool {
        self.find(key.into(), *scope).is_some()
    }

    /// The most specific text for the scope, formatted.
    ///
    /// # Errors
    /// Whatever would make the text incomplete; see [`Fault`].
    pub fn text<'k>(&self, key: impl Into<Key<'k>>, scope: &Scope, args: &Args) -> Result<Cow<'_, str>, LocaleError> {
        let key = key.into();
        let Some(form) = self.find(key, *scope) else {
            return Err(self.error(key, Fault::MissingText, None));
        };
        let Some(found) = self.pattern(form) else {
            return Err(self.error(key, Fault::MissingText, Some(form)));
        };
        if let Some(text) = pattern::plain(found) {
            return Ok(Cow::Borrowed(text));
        }
        let result =
            if form.refers { self.with_scope(found, *scope, args) } else { self.format(self.base(), found, args) };
        result.map(Cow::Owned).map_err(|fault| self.error(key, fault, Some(form)))
    }

    /// The same for a text without arguments.
    ///
    /// # Errors
    /// As [`Language::text`].
    pub fn plain<'k>(&self, key: impl Into<Key<'k>>, scope: &Scope) -> Result<Cow<'_, str>, LocaleError> {
        self.text(key, scope, &Args::new())
    }

    /// The text as it reads without arguments, for lists of texts: variables as `‹name›`, and the
    /// default of each selection.
    pub fn sketch<'k>(&self, key: impl Into<Key<'k>>) -> Option<String> {
        Some(pattern::sketch(self.pattern(self.find(key.into(), Scope::NONE)?)?, &|_| None))
    }

    /// The text with words in place of its arguments. Each selection takes its default; nothing where a word will not do,
    /// as in a function of a number.
    pub fn filled<'k>(&self, key: impl Into<Key<'k>>, word: &dyn Fn(&str) -> String) -> Option<String> {
        let key = key.into();
        let found = self.pattern(self.find(key, Scope::NONE)?)?;
        let mut names: Vec<&str> = Vec::new();
        pattern::visit(found, &mut |node| {
            if let pattern::Node::Shown(name) | pattern::Node::Chosen(name, _) = node {
                names.push(name);
            }
        });
        let args = names.into_iter().fold(Args::new(), |args, name| args.text(name, word(name)));
        self.text(key, &Scope::NONE, &args).ok().map(Cow::into_owned)
    }

    /// The text as its file has it, with the place: arguments as `‹name›`, terms filled in by their first
    /// form, and the default of each selection.
    pub fn raw(&self, key: Key, scope: Scope) -> Option<(String, Place)> {
        let form = self.find(key, scope)?;
        let term = |id: &str| {
            let key = format!("-{id}");
            let form = self.entries.get(&key)?.best(None, scope)?;
            Some(pattern::sketch(self.pattern(form)?, &|_| None))
        };
        Some((pattern::sketch(self.pattern(form)?, &term), self.place(form)?))
    }

    /// What the variants of the selections in a text say that are not the default ones, as [`Self::raw`] gives it: how each is
    /// chosen, and its text. Variants for categories of numbers are left out.
    pub fn variants(&self, key: Key, scope: Scope) -> Vec<(String, String)> {
        let Some(found) = self.find(key, scope).and_then(|form| self.pattern(form)) else { return Vec::new() };
        let term = |id: &str| {
            let form = self.entries.get(&format!("-{id}"))?.best(None, scope)?;
            Some(pattern::sketch(self.pattern(form)?, &|_| None))
        };
        pattern::variants(found, &term)
    }

    /// The place of a text, whatever its scope.
    pub(super) fn place_of(&self, key: Key) -> Option<Place> {
        let entry = self.entries.get(key.id)?;
        let (_, forms) = entry.all().find(|(attribute, _)| *attribute == key.attribute)?;
        self.place(forms.first()?)
    }

    /// The messages to which other texts refer.
    pub fn referred(&self) -> HashSet<String> {
        let mut ids = HashSet::new();
        for form in self.entries.iter().flat_map(|(_, entry)| entry.all()).flat_map(|(_, forms)| forms) {
            let Some(found) = self.pattern(form) else { continue };
            pattern::visit(found, &mut |node| {
                if let pattern::Node::Message { id, .. } = node {
                    ids.insert(id.split_once("__").map_or(id, |(base, _)| base).to_owned());
                }
            });
        }
        ids
    }

    /// Whether the text for the scope was written for it, and not for a wider one.
    pub fn is_exact(&self, key: Key, scope: Scope) -> bool {
        let wanted = usize::from(scope.cycle.is_some()) + usize::from(scope.control.is_some());
        let wanted = if scope.cycle == scope.control { wanted.min(1) } else { wanted };
        self.find(key, scope).is_some_and(|form| form.suffixes.len() == wanted)
    }

    /// Every text of the language but terms: its key, and the suffixes of its variant.
    pub fn keys(&self) -> impl Iterator<Item = (Key<'_>, &[Box<str>])> {
        let messages = self.entries.iter().filter(|(id, _)| !id.starts_with('-'));
        messages.flat_map(|(id, entry)| {
            let forms = entry.all().flat_map(|(attribute, forms)| forms.iter().map(move |form| (attribute, form)));
            forms.map(move |(attribute, form)| (Key { id, attribute }, form.suffixes.as_slice()))
        })
    }

    pub(super) fn find(&self, key: Key, scope: Scope) -> Option<&Form> {
        self.entries.get(key.id)?.best(key.attribute, scope)
    }

    pub(super) fn pattern<'f>(&self, form: &'f Form) -> Option<&'f Pattern<&'f str>> {
        let (value, attributes) = match form.resource.get_entry(form.entry)? {
            ast::Entry::Message(message) => (message.value.as_ref(), &message.attributes),
            ast::Entry::Term(term) => (Some(&term.value), &term.attributes),
            _ => return None,
        };
        form.attribute.map_or(value, |index| attributes.get(index).map(|attribute| &attribute.value))
    }

    pub(super) fn place(&self, form: &Form) -> Option<Place> {
        Some(Place::new(&form.source, form.span))
    }

    fn error(&self, key: Key, fault: Fault, form: Option<&Form>) -> LocaleError {
        let place = form.and_then(|form| self.place(form));
        LocaleError { language: self.tag.clone(), key: key.to_string(), fault, place }
    }

    fn with_scope(&self, pattern: &Pattern<&str>, scope: Scope, args: &Args) -> Result<String, Fault> {
        let ids = self.led_to(pattern);
        let forms =
            || ids.iter().filter_map(|id| self.entries.get(id)).flat_map(Entry::all).flat_map(|(_, forms)| forms);
        let relevant = |suffix: &&str| forms().any(|form| form.suffixes.iter().any(|own| **own == **suffix));
        let scope = Scope { cycle: scope.cycle.filter(relevant), control: scope.control.filter(relevant) };
        self.format(&self.overlay(ids, scope), pattern, args)
    }

    /// The messages and terms that a text refers to, those that they refer to, and so on.
    fn led_to(&self, pattern: &Pattern<&str>) -> BTreeSet<String> {
        let mut ids = BTreeSet::new();
        let mut waiting = vec![pattern];
        while let Some(pattern) = waiting.pop() {
            let mut fresh = Vec::new();
            pattern::visit(pattern, &mut |node| {
                let id = match node {
                    pattern::Node::Message { id, .. } => id.to_owned(),
                    pattern::Node::Term { id, .. } => format!("-{id}"),
                    _ => return,
                };
                let base = id.split_once("__").map_or(&*id, |(base, _)| base);
                if ids.insert(base.to_owned()) {
                    fresh.push(base.to_owned());
                }
            });
            let entries = fresh.iter().filter_map(|id| self.entries.get(id));
            let forms = entries.flat_map(Entry::all).flat_map(|(_, forms)| forms);
            waiting.extend(forms.filter_map(|form| self.pattern(form)));
        }
        ids
    }

    fn base(&self) -> &Bundle {
        self.base.get_or_init(|| bundle(&self.id, &[], &self.forms, None))
    }

    fn overlay(&self, ids: BTreeSet<String>, scope: Scope) -> Arc<Bundle> {
        let key: Overlay = (ids, scope.cycle.map(str::to_owned), scope.control.map(str::to_owned));
        // A poisoned lock still guards a whole map: insertion is its only change.
        if let Some(bundle) = self.overlays.read().unwrap_or_else(PoisonError::into_inner).get(&key) {
            return Arc::clone(bundle);
        }
        let entries: Vec<(&str, &Entry)> = key.0.iter().filter_map(|id| Some((&**id, self.entries.get(id)?))).collect();
        let mut resources: Vec<&Arc<FluentResource>> = Vec::new();
        for form in entries.iter().flat_map(|(_, entry)| entry.all()).flat_map(|(_, forms)| forms) {
            if !resources.iter().any(|known| Arc::ptr_eq(known, &form.resource)) {
                resources.push(&form.resource);
            }
        }
        let overrides = self.overrides(&entries, scope);
        let bundle = Arc::new(bundle(&self.id, &resources, &self.forms, Some(overrides)));
        self.overlays.write().unwrap_or_else(PoisonError::into_inner).insert(key, Arc::clone(&bundle));
        bundle
    }

    /// The messages that differ in this scope, under their plain identifiers, as Fluent source.
    fn overrides(&self, entries: &[(&str, &Entry)], scope: Scope) -> String {
        let mut body = Vec::new();
        for (id, entry) in entries {
            let differs =
                entry.all().any(|(key, _)| entry.best(key, scope).is_some_and(|form| !form.suffixes.is_empty()));
            if differs {
                body.extend(self.merged(id, entry, scope));
            }
        }
        fluent_syntax::serializer::serialize(&ast::Resource { body })
    }

    fn merged<'l>(&'l self, id: &'l str, entry: &'l Entry, scope: Scope) -> Option<ast::Entry<&'l str>> {
        let best = |key| entry.best(key, scope).and_then(|form| self.pattern(form)).cloned();
        let attributes = entry.attributes.iter().filter_map(|(name, _)| {
            Some(ast::Attribute { id: ast::Identifier { name: &**name }, value: best(Some(name))? })
        });
        let attributes = attributes.collect();
        Some(match id.strip_prefix('-') {
            Some(name) => ast::Entry::Term(ast::Term {
                id: ast::Identifier { name },
                value: best(None)?,
                attributes,
                comment: None,
            }),
            None => ast::Entry::Message(ast::Message {
                id: ast::Identifier { name: id },
                value: best(None),
                attributes,
                comment: None,
            }),
        })
    }

    fn format(&self, bundle: &Bundle, pattern: &Pattern<&str>, args: &Args) -> Result<String, Fault> {
        let mut errors = Vec::new();
        let ((written, text), fault) = function::with_slate(&self.forms, || {
            let mut text = String::new();
            let written = bundle.write_pattern(&mut text, pattern, Some(args.fluent()), &mut errors);
            (written, text)
        });
        match errors.into_iter().next().map(resolver_fault).or(fault) {
            Some(fault) => Err(fault),
            None if written.is_err() => Err(Fault::TooLong),
            None => Ok(text),
        }
    }
}

impl fmt::Debug for Language {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "Language({})", self.tag)
    }
}

fn bundle(
    id: &LanguageIdentifier,
    resources: &[&Arc<FluentResource>],
    forms: &Arc<Forms>,
    overrides: Option<String>,
) -> Bundle {
    let mut bundle = FluentBundle::new_concurrent(vec![id.clone()]);
    bundle.set_use_isolating(false);
    bundle.set_formatter(Some(function::show));
    // What is defined twice was reported when it was read, and no message is named like a function.
    let (units, lists) = (Arc::clone(forms), Arc::clone(forms));
    let _ = bundle.add_function("NUMBER", function::number_function);
    let _ = bundle.add_function("UNIT", move |positional, named| function::unit_function(&units, positional, named));
    let _ = bundle.add_function("LIST", move |positional, named| function::list_function(&lists, positional, named));
    for resource in resources {
        let _ = bundle.add_resource(Arc::clone(resource));
    }
    if let Some(overrides) = overrides {
        let resource = FluentResource::try_new(overrides).unwrap_or_else(|(resource, _)| resource);
        bundle.add_resource_overriding(Arc::new(resource));
    }
    bundle
}

fn resolver_fault(error: FluentError) -> Fault {
    let FluentError::ResolverError(error) = error else { return Fault::TooLong };
    let dotted = |id: String, attribute: Option<String>| match attribute {
        Some(attribute) => format!("{id}.{attribute}"),
        None => id,
    };
    match error {
        ResolverError::Reference(ReferenceKind::Variable { id }) => Fault::MissingArgument(id),
        ResolverError::Reference(ReferenceKind::Function { id }) => Fault::UnknownFunction(id),
        ResolverError::Reference(ReferenceKind::Message { id, attribute }) => {
            Fault::UnknownReference(dotted(id, attribute))
        }
        ResolverError::Reference(ReferenceKind::Term { id, attribute }) => {
            Fault::UnknownReference(dotted(format!("-{id}"), attribute))
        }
        ResolverError::NoValue(id) => Fault::UnknownReference(id),
        ResolverError::Cyclic => Fault::Cyclic,
        ResolverError::TooManyPlaceables | ResolverError::MissingDefault => Fault::TooLong,
    }
}
