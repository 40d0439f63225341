//! Programs in another language: names, labels and printed words of cycles are replaced, no other
//! byte changes.
//!
//! Cycles and parameters are known by their numbers; what stands there is replaced only if it is the
//! name or label of the same cycle or parameter in some language, so a programmer's own comments
//! stay. Invariant: a block number, a blank, a tab, a `~` or a line end is never touched, and the
//! place where a label begins stays.
use crate::check::{Against, Facts, ParamLabels};
use crate::diag::{Diagnostic, Place, Span};
use crate::syntax::Program;
use crate::syntax::encoding::Encoding;

/// A program in another language.
#[derive(Debug)]
pub struct Translation {
    /// Its text.
    pub text: String,
    /// What was replaced, in the order of the text.
    pub changes: Vec<Change>,
    /// Labels that a language lacks or that the file's encoding cannot write; these stay as they are.
    pub diagnostics: Vec<Diagnostic>,
}

/// Something replaced.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Change {
    /// Its place in the old text.
    pub span: Span,
    /// What stood there.
    pub from: String,
    /// What stands there now.
    pub to: String,
}

/// Writes a program's names and labels in the language `to`.
pub fn translate(program: &Program, against: &Against<'_>, to: &str, encoding: Encoding) -> Translation {
    write(program, against, to, encoding, false)
}

/// As [`translate`], and whatever has the form of a label where one stands is one, in a language that is not known
/// here or of an older software: cycles and parameters are known by their numbers anyway. A label of another
/// parameter of the cycle stays, for it may tell of a mistake.
pub fn relabel(program: &Program, against: &Against<'_>, to: &str, encoding: Encoding) -> Translation {
    write(program, against, to, encoding, true)
}

/// Whether a text looks like a label: letters in capitals, no longer than labels of the control are.
fn is_label(text: &str, most: u32) -> bool {
    let letters = text.chars().filter(|c| c.is_alphabetic());
    letters.count() > 1 && !text.chars().any(char::is_lowercase) && text.chars().count() <= most as usize
}

fn write(program: &Program, against: &Against<'_>, to: &str, encoding: Encoding, relabel: bool) -> Translation {
    let facts = Facts::of(program, against);
    let mut writer = Writer { facts: &facts, to, encoding, changes: Vec::new(), diagnostics: Vec::new() };
    let most = against.on.control.label.max_length;
    for (definition, _) in facts.described() {
        let Some(labels) = facts.labels(&definition) else { continue };
        let own = |pick: &dyn Fn(&crate::check::LanguageLabels) -> Option<usize>| {
            labels.languages.iter().any(|language| pick(language).is_some())
        };
        let target = labels.language(to);
        let key = definition.key.to_string();
        if let Some(name) = definition.view.name {
            let known = own(&|language| language.name.matches(facts.text(name)).then_some(0));
            let known = known || (relabel && is_label(facts.text(name), most));
            writer.replace(name, known, target.map(|target| &target.name), &key, &key);
        }
        for item in &definition.items {
            let (Some(index), Some(span)) = (item.index, item.label) else { continue };
            let known = own(&|language| language.params.get(index)?.matches(facts.text(span)).then_some(index));
            let other = || own(&|language| language.params.iter().position(|label| label.matches(facts.text(span))));
            let known = known || (relabel && is_label(facts.text(span), most) && !other());
            writer.replace(span, known, target.and_then(|target| target.params.get(index)), &item.name, &key);
        }
    }
    let Writer { mut changes, diagnostics, .. } = writer;
    changes.sort_by_key(|change| change.span.start);
    Translation { text: changed(program.source().text(), &changes), changes, diagnostics }
}

struct Writer<'f, 'a> {
    facts: &'f Facts<'a>,
    to: &'f str,
    encoding: Encoding,
    changes: Vec<Change>,
    diagnostics: Vec<Diagnostic>,
}

impl Writer<'_, '_> {
    /// Replaces what stands at `span` by the label, if it is one that is known.
    fn replace(&mut self, span: Span, known: bool, label: Option<&ParamLabels>, parameter: &str, cycle: &str) {
        let from = self.facts.text(span);
        if !known {
            return;
        }
        let place = Place::new(self.facts.program.source(), span);
        let Some(to) = label.and_then(|label| label.label.as_deref()) else {
            let missing =
                Diagnostic::error("label-missing", place).arg("language", self.to).arg("parameter", parameter);
            self.diagnostics.push(missing.arg("cycle", cycle));
            return;
        };
        if from == to {
            return;
        }
        if let Err(character) = self.encoding.encode(to) {
            let foreign = Diagnostic::error("label-not-encodable", place).arg("label", to);
            self.diagnostics.push(foreign.arg("character", character.to_string()));
            return;
        }
        self.changes.push(Change { span, from: from.to_owned(), to: to.to_owned() });
    }
}

fn changed(text: &str, changes: &[Change]) -> String {
    let mut out = String::with_capacity(text.len());
    let mut at = 0;
    for change in changes {
        out.push_str(text.get(at..change.span.start).unwrap_or_default());
        out.push_str(&change.to);
        at = change.span.end;
    }
    out.push_str(text.get(at..).unwrap_or_default());
    out
}
