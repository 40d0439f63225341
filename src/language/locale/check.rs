//! What can be known to be wrong in a language without formatting anything.
//!
//! Fluent passes over several mistakes in silence (an unknown function in a selector, a term called
//! with a case that it does not have, an argument that a term was not given); they are found here.
//! Invariant: only one language is examined; comparing languages is the audit's work.
use std::collections::{BTreeMap, BTreeSet, HashMap, HashSet};

use fluent_syntax::ast::{CallArguments, InlineExpression, Pattern};

use super::function::FUNCTIONS;
use super::language::{Entry, Form, Language};
use super::number::MOST_DIGITS;
use super::pattern::{Node, visit};
use crate::base::diag::Diagnostic;

/// Reports the mistakes of the language.
pub(super) fn language(language: &Language, diagnostics: &mut Vec<Diagnostic>) {
    let mut check = Check { language, terms: terms(language), diagnostics };
    let sorted: BTreeMap<&str, &Entry> = language.entries.iter().collect();
    for entry in sorted.values() {
        for form in entry.all().flat_map(|(_, forms)| forms) {
            if let Some(pattern) = language.pattern(form) {
                check.pattern(form, pattern);
            }
        }
    }
    check.cycles(sorted.keys().copied());
}

/// What a term takes: variables that it shows, and such that it only chooses by, with their keys in
/// each variant of the term.
#[derive(Default)]
struct Takes<'l> {
    shown: BTreeSet<&'l str>,
    chosen: BTreeMap<&'l str, Vec<Vec<&'l str>>>,
}

fn terms(language: &Language) -> HashMap<&str, Takes<'_>> {
    let mut terms = HashMap::new();
    for (id, entry) in language.entries.iter() {
        let Some(name) = id.strip_prefix('-') else { continue };
        let takes: &mut Takes = terms.entry(name).or_default();
        for pattern in entry.value.iter().filter_map(|form| language.pattern(form)) {
            let mut keys: BTreeMap<&str, Vec<&str>> = BTreeMap::new();
            visit(pattern, &mut |node| match node {
                Node::Shown(variable) => {
                    takes.shown.insert(variable);
                }
                Node::Chosen(variable, variants) => keys.entry(variable).or_default().extend(variants),
                Node::Message { .. } | Node::Term { .. } | Node::Function { .. } => {}
            });
            for (variable, variants) in keys {
                takes.chosen.entry(variable).or_default().push(variants);
            }
        }
    }
    terms
}

struct Check<'l, 'd> {
    language: &'l Language,
    terms: HashMap<&'l str, Takes<'l>>,
    diagnostics: &'d mut Vec<Diagnostic>,
}

impl<'l> Check<'l, '_> {
    fn pattern(&mut self, form: &Form, pattern: &'l Pattern<&'l str>) {
        let mut nodes = Vec::new();
        visit(pattern, &mut |node| nodes.push(node));
        for node in nodes {
            match node {
                Node::Message { id, attribute } => self.reference(form, id.to_owned(), attribute),
                Node::Term { id, attribute, arguments } => {
                    self.reference(form, format!("-{id}"), attribute);
                    self.term_call(form, id, attribute, arguments);
                }
                Node::Function { id, arguments } => self.function_call(form, id, arguments),
                Node::Shown(_) | Node::Chosen(..) => {}
            }
        }
    }

    fn report(&mut self, form: &Form, code: &'static str, args: &[(&'static str, &str)]) {
        if let Some(place) = self.language.place(form) {
            let diagnostic = Diagnostic::error(code, place);
            self.diagnostics
                .push(args.iter().fold(diagnostic, |diagnostic, (name, value)| diagnostic.arg(name, *value)));
        }
    }

    fn reference(&mut self, form: &Form, id: String, attribute: Option<&str>) {
        let (base, suffix) = id.split_once("__").map_or((id.as_str(), None), |(base, suffix)| (base, Some(suffix)));
        let suffix = suffix.map(|suffix| format!("__{suffix}"));
        let known = self.language.entries.get(base).is_some_and(|entry| {
            let mut forms = entry.all().filter(|(key, _)| *key == attribute).flat_map(|(_, forms)| forms);
            forms.any(|form| suffix.as_ref().is_none_or(|suffix| form.suffix() == *suffix))
        });
        if !known {
            let name = attribute.map_or(id.clone(), |attribute| format!("{id}.{attribute}"));
            self.report(form, "locale-unknown-reference", &[("name", &name)]);
        }
    }

    fn term_call(&mut self, form: &Form, id: &str, attribute: Option<&str>, call: Option<&CallArguments<&str>>) {
        let base = id.split_once("__").map_or(id, |(base, _)| base);
        if attribute.is_some() {
            return;
        }
        let Some(takes) = self.terms.get(base) else { return };
        let named = call.map_or(&[][..], |call| call.named.as_slice());
        let mut wrong = Vec::new();
        for argument in named {
            let name = argument.name.name;
            let value = literal(&argument.value);
            match takes.chosen.get(name) {
                None if takes.shown.contains(name) => {}
                None => wrong.push(("locale-term-argument", name.to_owned(), String::new())),
                Some(variants) if variants.iter().any(|keys| !keys.contains(&value)) => {
                    wrong.push(("locale-term-value", name.to_owned(), value.to_owned()));
                }
                Some(_) => {}
            }
        }
        for name in &takes.shown {
            if !named.iter().any(|argument| argument.name.name == *name) {
                wrong.push(("locale-term-needs", (*name).to_owned(), String::new()));
            }
        }
        for (code, name, value) in wrong {
            self.report(form, code, &[("term", id), ("name", &name), ("value", &value)]);
        }
    }

    fn function_call(&mut self, form: &Form, id: &str, call: &CallArguments<&str>) {
        let Some((_, options)) = FUNCTIONS.iter().find(|(name, _)| *name == id) else {
            self.report(form, "locale-unknown-function", &[("name", id)]);
            return;
        };
        for argument in &call.named {
            let (name, value) = (argument.name.name, literal(&argument.value));
            let digits = name.ends_with("FractionDigits");
            let sound = options.contains(&name)
                && match (id, digits) {
                    (_, true) => value.parse::<u8>().is_ok_and(|count| count <= MOST_DIGITS),
                    ("LIST", _) => self.language.has(format!("list-{value}").as_str(), &super::Scope::NONE),
                    _ => ["cardinal", "ordinal"].contains(&value),
                };
            if !sound {
                self.report(form, "locale-function-option", &[("function", id), ("name", name), ("value", value)]);
            }
        }
        let count = if id == "UNIT" { 2 } else { 1 };
        if call.positional.len() != count {
            self.report(form, "locale-function-arguments", &[("function", id)]);
        }
        let unit = call.positional.get(1).filter(|_| id == "UNIT").map_or("", literal);
        if !unit.is_empty() && self.language.unit(0.0, unit, super::Digits::default()).is_none() {
            self.report(form, "locale-unknown-unit", &[("name", unit)]);
        }
    }

    /// Reports each text that contains itself, once for each way round.
    fn cycles<'i>(&mut self, ids: impl Iterator<Item = &'i str>) {
        let mut search =
            Search { language: self.language, finished: HashSet::new(), path: Vec::new(), found: Vec::new() };
        for id in ids {
            let attributes = self.language.entries.get(id).into_iter().flat_map(Entry::all);
            for (attribute, _) in attributes {
                search.enter((id.to_owned(), attribute.map(str::to_owned)));
            }
        }
        for ((id, _), form) in search.found {
            self.report(&form, "locale-cyclic", &[("key", &id), ("language", self.language.tag())]);
        }
    }
}

fn literal<'a>(expression: &InlineExpression<&'a str>) -> &'a str {
    match expression {
        InlineExpression::StringLiteral { value } | InlineExpression::NumberLiteral { value } => value,
        _ => "",
    }
}

/// A text by its full identifier (with suffixes, if a reference has them) and attribute.
type Text = (String, Option<String>);

/// Fluent resolves no more than this, so no sound text reaches deeper.
const DEEPEST_REFERENCE: usize = 100;

struct Search<'l> {
    language: &'l Language,
    finished: HashSet<Text>,
    path: Vec<Text>,
    found: Vec<(Text, Form)>,
}

impl Search<'_> {
    /// Follows the references of a text; `a__b` counts as a text apart from `a`.
    fn enter(&mut self, text: Text) {
        if self.finished.contains(&text) || self.path.len() > DEEPEST_REFERENCE {
            return;
        }
        let base = text.0.split_once("__").map_or(text.0.as_str(), |(base, _)| base);
        let suffix = text.0.strip_prefix(base).filter(|suffix| !suffix.is_empty());
        let Some(entry) = self.language.entries.get(base) else { return };
        let forms = entry.all().filter(|(attribute, _)| *attribute == text.1.as_deref()).flat_map(|(_, forms)| forms);
        let forms: Vec<&Form> = forms.filter(|form| suffix.is_none_or(|suffix| form.suffix() == suffix)).collect();
        self.path.push(text.clone());
        for form in forms {
            for target in self.language.pattern(form).map(targets).unwrap_or_default() {
                if self.path.contains(&target) {
                    self.found.push((target, form.clone()));
                } else {
                    self.enter(target);
                }
            }
        }
        self.path.pop();
        self.finished.insert(text);
    }
}

fn targets(pattern: &Pattern<&str>) -> Vec<Text> {
    let mut targets = Vec::new();
    visit(pattern, &mut |node| match node {
        Node::Message { id, attribute } => targets.push((id.to_owned(), attribute.map(str::to_owned))),
        Node::Term { id, attribute, .. } => targets.push((format!("-{id}"), attribute.map(str::to_owned))),
        Node::Shown(_) | Node::Chosen(..) | Node::Function { .. } => {}
    });
    targets
}
