//! Programs in another language: names, labels and printed words of cycles are replaced, no other
//! byte changes.
//!
//! Cycles and parameters are known by their numbers; what is there is replaced only if it is the
//! name or label of the same cycle or parameter in some language, so a programmer's own comments
//! stay. A definition that a control wrote in a language that is not known here is read by its numbers
//! alone ([`Speech::Foreign`]). Invariant: a block number, a blank, a tab, a `~` or a line end is never
//! touched, and the place where a label begins stays.
use std::collections::BTreeMap;

use crate::base::diag::{Arg, Diagnostic, Place, Severity, Span};
use crate::check::{Against, Definition, Facts, ParamLabels, Speech, is_label, is_label_by_place, speech};
use crate::program::syntax::Program;
use crate::program::syntax::encoding::Encoding;

/// A program in another language.
#[derive(Debug)]
pub struct Translation {
    /// Its text.
    pub text: String,
    /// What was replaced, in the order of the text.
    pub changes: Vec<Change>,
    /// Labels that a language lacks or that the file's encoding cannot write, which stay as they are; and, once, that
    /// there are definitions in a language that is not known.
    pub diagnostics: Vec<Diagnostic>,
    /// How many definitions are in each language, by its tag.
    pub sources: BTreeMap<String, usize>,
}

/// Something replaced.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Change {
    /// Its place in the old text.
    pub span: Span,
    /// The old text.
    pub from: String,
    /// The new text.
    pub to: String,
}

/// A label in the place of another one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Replacement<'a> {
    /// The place of the old one.
    pub span: Span,
    /// The new one.
    pub to: &'a str,
}

/// The findings of a translation, besides the replacements.
#[derive(Debug, Default)]
pub struct Told {
    /// As in [`Translation`].
    pub diagnostics: Vec<Diagnostic>,
    /// As in [`Translation`].
    pub sources: BTreeMap<String, usize>,
}

/// Writes a program's names and labels in the language `to`. If `against` names the language of the program, only what
/// is in that language is replaced.
pub fn translate(program: &Program, against: &Against<'_>, to: &str, encoding: Encoding) -> Translation {
    write(program, against, to, encoding, false)
}

/// As [`translate`], and whatever has the form of a label in the place of a label is taken as one, in a language that is not known
/// here or of an older software: cycles and parameters are known by their numbers anyway. A label of another
/// parameter of the cycle stays, for it may report a mistake.
pub fn relabel(program: &Program, against: &Against<'_>, to: &str, encoding: Encoding) -> Translation {
    write(program, against, to, encoding, true)
}

fn write(program: &Program, against: &Against<'_>, to: &str, encoding: Encoding, relabel: bool) -> Translation {
    let text = program.source().text();
    let (mut out, mut at) = (String::with_capacity(text.len()), 0);
    let (changes, Told { diagnostics, sources }) = replacing(program, against, to, encoding, relabel, |all| {
        let write = |own: Replacement<'_>| {
            out.push_str(text.get(at..own.span.start).unwrap_or_default());
            out.push_str(own.to);
            at = own.span.end;
            Change { span: own.span, from: program.slice(own.span).to_owned(), to: own.to.to_owned() }
        };
        all.map(write).collect()
    });
    out.push_str(text.get(at..).unwrap_or_default());
    Translation { text: out, changes, diagnostics, sources }
}

/// Hands over what [`translate`] replaces, or what [`relabel`] does, in the order of the text: long programs have
/// millions of labels, and all that is replaced takes as much room as the program.
pub fn replacing<'a, T>(
    program: &'a Program,
    against: &Against<'a>,
    to: &str,
    encoding: Encoding,
    relabel: bool,
    then: impl FnOnce(&mut dyn Iterator<Item = Replacement<'a>>) -> T,
) -> (T, Told) {
    let facts = Facts::spoken(program, against);
    let mut writer = Writer { facts: &facts, to, encoding, changes: Vec::new(), diagnostics: Vec::new(), left: None };
    let mut sources = BTreeMap::new();
    // The first definition in a language that is not known, and how many there are.
    let mut foreign: Option<(Span, usize)> = None;
    let mut definitions = facts.described();
    let of_next = || {
        let (definition, _) = definitions.next()?;
        if definition.torn {
            writer.torn(&definition);
            return Some(Vec::new());
        }
        let spoken = speech(&facts, &definition);
        // Whose language is given is not read by its numbers.
        let unknown = spoken == Speech::Foreign && against.language.is_none();
        if unknown {
            foreign.get_or_insert((definition.view.head, 0)).1 += 1;
        }
        if let Speech::In(tag) = spoken {
            *sources.entry(tag).or_default() += 1;
        }
        writer.definition(&definition, relabel || unknown);
        let mut changes = std::mem::take(&mut writer.changes);
        changes.sort_by_key(|change| change.span.start);
        Some(changes)
    };
    let mut all = std::iter::from_fn(of_next).flatten();
    let done = then(&mut all);
    // What no one has asked for is reported all the same.
    all.for_each(drop);
    let mut diagnostics = writer.diagnostics;
    if let Some((first, count)) = writer.left {
        let place = Place::new(program.source(), first);
        let note = Diagnostic { severity: Severity::Note, ..Diagnostic::error("labels-not-known", place) };
        diagnostics.push(note.arg("count", Arg::Number(count as f64)));
    }
    if let Some((first, count)) = foreign {
        let place = Place::new(program.source(), first);
        let note = Diagnostic { severity: Severity::Note, ..Diagnostic::error("labels-of-unknown-language", place) };
        diagnostics.push(note.arg("count", Arg::Number(count as f64)));
    }
    (done, Told { diagnostics, sources })
}

struct Writer<'f, 'a> {
    facts: &'f Facts<'a>,
    to: &'f str,
    encoding: Encoding,
    changes: Vec<Replacement<'a>>,
    diagnostics: Vec<Diagnostic>,
    /// The first label that stays because no language has it, in a definition of which others are known; how many do.
    left: Option<(Span, usize)>,
}

impl<'a> Writer<'_, 'a> {
    /// A definition with a line that cannot be read stays as it is: what the line was to say is not known.
    fn torn(&mut self, definition: &Definition<'_>) {
        let written = definition.view.name.is_some() || definition.items.iter().any(|item| item.label.is_some());
        if written {
            let place = Place::new(self.facts.program.source(), definition.view.head);
            let stays = Diagnostic { severity: Severity::Warning, ..Diagnostic::error("translate-unread", place) };
            self.diagnostics.push(stays.arg("cycle", definition.key.to_string()));
        }
    }

    /// Replaces the name and the labels of a definition; with `by_number` also those that only have the form of labels.
    fn definition(&mut self, definition: &Definition<'_>, by_number: bool) {
        let facts = self.facts;
        let Some(labels) = facts.against.labels.cycle(definition.key) else { return };
        let most = facts.against.on.control.label.max_length;
        let from = facts.against.language;
        let own = |pick: &dyn Fn(&crate::check::LanguageLabels) -> bool| {
            labels.languages.iter().any(|language| from.is_none_or(|from| from == language.tag) && pick(language))
        };
        let target = labels.language(self.to);
        let key = definition.key.to_string();
        if let Some(name) = definition.view.name {
            let known = own(&|language| language.name.matches(facts.text(name)));
            let known = known || (by_number && is_label(facts.text(name), most));
            self.replace(name, known, target.map(|target| &target.name), &key, &key);
        }
        // What is like a label stays without a word only where no label is known: it is the programmer's then.
        let (mut replaced, mut left) = (false, Vec::new());
        for item in &definition.items {
            let (Some(index), Some(span)) = (item.index, item.label) else { continue };
            let label = facts.text(span);
            let known = own(&|language| language.params.get(index).is_some_and(|own| own.matches(label)));
            let other = || labels.languages.iter().any(|own| own.params.iter().any(|own| own.matches(label)));
            if !known && !by_number && from.is_none() && is_label(label, most) && !other() {
                left.push(span);
            }
            replaced |= known;
            let known = known || (by_number && is_label_by_place(label, most) && !other());
            self.replace(span, known, target.and_then(|target| target.params.get(index)), &item.name, &key);
        }
        if let Some(first) = left.first().filter(|_| replaced) {
            self.left.get_or_insert((*first, 0)).1 += left.len();
        }
    }

    /// Replaces the text of `span` by the label, if it is one that is known.
    fn replace(&mut self, span: Span, known: bool, label: Option<&'a ParamLabels>, parameter: &str, cycle: &str) {
        let from = self.facts.text(span);
        // What a parameter follows closed up ends at a mark that no label has; another label would run into it.
        let after = self.facts.program.source().text().get(span.end..);
        if !known || after.is_some_and(|rest| rest.starts_with(char::is_alphanumeric)) {
            return;
        }
        let place = Place::new(self.facts.program.source(), span);
        let Some(to) = label.and_then(|label| label.label.as_deref()) else {
            let missing =
                Diagnostic::error("label-missing", place).arg("language", self.to).arg("parameter", parameter);
            self.diagnostics.push(missing.arg("cycle", cycle));
            return;
        };
        // If the axis follows the word, the colon follows the axis: `KOT X: +15` (001: 13733).
        let to = match to.strip_suffix(':') {
            Some(word) if !from.ends_with(':') && after.is_some_and(is_axis_with_colon) => word,
            _ => to,
        };
        if from == to {
            return;
        }
        if let Err(character) = self.encoding.encode(to) {
            let foreign = Diagnostic::error("label-not-encodable", place).arg("label", to);
            self.diagnostics.push(foreign.arg("character", character.to_string()));
            return;
        }
        self.changes.push(Replacement { span, to });
    }
}

/// Whether a text goes on with the letter of an axis and a colon.
fn is_axis_with_colon(text: &str) -> bool {
    let mut after = text.trim_start_matches([' ', '\t']).chars();
    matches!((after.next(), after.next()), (Some('A'..='C' | 'U'..='Z' | 'a'..='c' | 'u'..='z'), Some(':')))
}
