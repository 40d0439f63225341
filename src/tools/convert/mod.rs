//! Programs for another control: cycle definitions are rewritten as the other control has them.
//!
//! Cycles are known by their numbers, parameters by theirs. What the other control lacks goes, what it has in
//! addition comes with the value that does the same, and each is reported; a cycle that it does not have stays and
//! is refused. Other blocks stay as they are; functions that the other control's manual does not show are reported.
//! Invariants: a block that needs nothing keeps its bytes, and nothing is lost in silence.
mod forms;
mod functions;
mod lines;
mod parameters;

use crate::base::diag::{Diagnostic, Edit, Place, Severity, Span, edited};
use crate::check::{Against, Definition, Facts, LanguageLabels};
use crate::language::locale::Locales;
use crate::program::syntax::encoding::Encoding;
use crate::program::syntax::{CycleForm, Program};
use crate::spec::{Cycle, CycleKey, Known, Param};

/// Which form a cycle gets that both controls have in two forms, such as TCH PROBE 31 and 481.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Form {
    /// The one that the program has, as far as the other control has it.
    #[default]
    AsWritten,
    /// Q parameters.
    New,
    /// A block a line.
    Old,
}

/// What a conversion needs to know.
#[derive(Clone, Copy)]
pub struct Request<'a> {
    /// The control that the program was written for.
    pub from: Against<'a>,
    /// The control that it shall run on.
    pub to: Against<'a>,
    /// The texts of all languages.
    pub locales: &'a Locales,
    /// The form of cycles that have two.
    pub form: Form,
    /// The encoding of the file: a label that it cannot write is left.
    pub encoding: Encoding,
}

/// A program for another control.
#[derive(Debug)]
pub struct Conversion {
    /// Its text.
    pub text: String,
    /// What was rewritten, in the order of the old text.
    pub edits: Vec<Edit>,
    /// What was added, dropped, doubted and refused, in the order of the old text. Errors are what cannot run on the
    /// other control and stays as it was.
    pub found: Vec<Diagnostic>,
}

/// Rewrites a program for another control.
pub fn convert(program: &Program, request: &Request<'_>) -> Conversion {
    let (mut edits, mut found) = (Vec::new(), Vec::new());
    each(program, request, &mut |step| match step {
        Step::Edit(edit) => edits.push(edit),
        Step::Found(diagnostic) => found.push(diagnostic),
    });
    Conversion { text: edited(program.source().text(), &edits), edits, found }
}

/// A part of a conversion.
#[derive(Debug)]
pub enum Step {
    /// Something rewritten.
    Edit(Edit),
    /// A finding.
    Found(Diagnostic),
}

/// Rewrites a program and hands over what is rewritten and what is reported, each in the order of the text: of a long
/// program there are more findings than there is text.
pub fn each(program: &Program, request: &Request<'_>, take: &mut dyn FnMut(Step)) {
    let facts = Facts::spoken(program, &request.from);
    let mut writer = Writer { program, facts: &facts, request, edits: Vec::new(), found: Vec::new() };
    let syntax = program.diagnostics().into_iter().map(|own| (key(&own, Teller::Parser), own));
    writer.functions();
    let functions = std::mem::take(&mut writer.found).into_iter().map(|own| (key(&own, Teller::Functions), own));
    let mut others: Vec<_> = syntax.chain(functions).collect();
    others.sort_by_key(|(key, _)| *key);
    let mut others = others.into_iter().peekable();
    for definition in facts.readings() {
        writer.definition(&definition);
        writer.edits.sort_by_key(|edit| edit.span);
        writer.edits.drain(..).for_each(|edit| take(Step::Edit(edit)));
        writer.found.sort_by_key(|own| key(own, Teller::Definitions));
        for own in writer.found.drain(..) {
            let before = key(&own, Teller::Definitions);
            while let Some((_, other)) = others.next_if(|(key, _)| *key < before) {
                take(Step::Found(other));
            }
            take(Step::Found(own));
        }
    }
    others.for_each(|(_, own)| take(Step::Found(own)));
}

/// Whose finding comes first of those at one place.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Teller {
    Parser,
    Definitions,
    Functions,
}

/// The position of a finding among all.
fn key(own: &Diagnostic, teller: Teller) -> (Option<(usize, usize)>, Teller) {
    (own.place.as_ref().map(|place| (place.span.start, place.span.end)), teller)
}

struct Writer<'w, 'a> {
    program: &'w Program,
    facts: &'w Facts<'w>,
    request: &'w Request<'a>,
    edits: Vec<Edit>,
    found: Vec<Diagnostic>,
}

/// What a cycle of a program becomes.
enum Target<'c> {
    /// The cycle of the same number.
    Same(&'c Cycle),
    /// The cycle of the other form.
    Other(&'c Cycle),
    /// Nothing that is described.
    None,
}

impl<'a> Writer<'_, 'a> {
    fn definition(&mut self, definition: &Definition<'_>) {
        let Known::Described(own) = definition.known else {
            return self.undescribed(definition);
        };
        // What cannot be read is reported by the parser and stays.
        if definition.torn {
            return;
        }
        match self.target(own) {
            Target::Same(other) => match &definition.view.form {
                CycleForm::Parameters(_) => self.parameters(definition, own, other),
                CycleForm::Lines(_) => self.lines(definition, own, other),
            },
            Target::Other(other) => self.other_form(definition, own, other),
            Target::None => match self.request.to.on.known(own.key) {
                Known::Builders => {}
                Known::Named(_) => self.unsure(definition, &self.request.to.on.control.title),
                _ => self.lacking(definition),
            },
        }
    }

    /// A cycle that the first control's manual does not describe.
    fn undescribed(&mut self, definition: &Definition<'_>) {
        match (definition.known, self.request.to.on.known(definition.key)) {
            (Known::Builders, _) | (_, Known::Builders) => {}
            (_, Known::Unknown) => self.lacking(definition),
            (Known::Unknown, Known::Described(_)) => self.not_covered(definition, &self.request.from.on.control.title),
            (_, Known::Described(_)) => self.unsure(definition, &self.request.from.on.control.title),
            _ => self.unsure(definition, &self.request.to.on.control.title),
        }
    }

    fn target(&self, own: &Cycle) -> Target<'a> {
        let on = self.request.to.on;
        let same = on.cycles.get(&own.key);
        let other = if own.is_old_style() {
            own.file.like.as_ref().and_then(|like| on.by_name(like.as_str()))
        } else {
            on.follower_of(own.name())
        };
        let wants_other = match self.request.form {
            Form::AsWritten => false,
            Form::New => own.is_old_style(),
            Form::Old => !own.is_old_style(),
        };
        match (same, other) {
            (_, Some(other)) if wants_other => Target::Other(other),
            (Some(same), _) => Target::Same(same),
            (None, Some(other)) => Target::Other(other),
            (None, None) => Target::None,
        }
    }

    fn lacking(&mut self, definition: &Definition<'_>) {
        // A manual that treats other cycles only is no proof.
        if !self.request.to.on.covers(definition.key) {
            return self.not_covered(definition, &self.request.to.on.control.title);
        }
        let lacking = self.at("convert-cycle-not-on-control", Severity::Error, definition.view.head);
        self.found.push(
            lacking.arg("cycle", definition.key.to_string()).arg("control", self.request.to.on.control.title.as_str()),
        );
    }

    fn not_covered(&mut self, definition: &Definition<'_>, control: &str) {
        let silent = self.at("convert-cycle-not-covered", Severity::Warning, definition.view.head);
        self.found.push(silent.arg("cycle", definition.key.to_string()).arg("control", control));
    }

    fn unsure(&mut self, definition: &Definition<'_>, control: &str) {
        let unsure = self.at("convert-cycle-not-described", Severity::Warning, definition.view.head);
        self.found.push(unsure.arg("cycle", definition.key.to_string()).arg("control", control));
    }

    fn at(&self, code: &'static str, severity: Severity, span: Span) -> Diagnostic {
        let place = Place::new(self.program.source(), span);
        Diagnostic { severity, ..Diagnostic::error(code, place) }
    }

    /// Says that a value of the old definition is not there any more.
    fn dropped(&mut self, key: CycleKey, name: &str, value: &str, span: Span, neutral: bool) {
        let severity = if neutral { Severity::Note } else { Severity::Warning };
        let dropped = self.at("convert-parameter-dropped", severity, span).arg("parameter", name).arg("value", value);
        let dropped = dropped.arg("cycle", key.to_string()).arg("control", self.request.to.on.control.title.as_str());
        self.found.push(dropped.arg("neutral", if neutral { "yes" } else { "no" }));
    }

    /// Says that a value came in.
    fn added(&mut self, key: CycleKey, name: &str, value: &str, span: Span, import: bool) {
        let severity = if import { Severity::Warning } else { Severity::Note };
        let added = self.at("convert-parameter-added", severity, span).arg("parameter", name).arg("value", value);
        let added = added.arg("cycle", key.to_string()).arg("control", self.request.to.on.control.title.as_str());
        self.found.push(added.arg("import", if import { "yes" } else { "no" }));
    }

    /// Says that the other control needs a value that no one knows.
    fn no_value(&mut self, key: CycleKey, name: &str, span: Span) {
        let none = self.at("convert-no-value", Severity::Error, span).arg("parameter", name);
        self.found.push(none.arg("cycle", key.to_string()).arg("control", self.request.to.on.control.title.as_str()));
    }

    /// Says what the other control objects to in a value that the first one takes.
    fn judge(&mut self, key: CycleKey, name: &str, value: &str, span: Span, own: &Param, other: &Param) {
        let refused = |param: &Param| crate::spec::refusal(param, value).is_some();
        let code = if refused(other) && !refused(own) {
            "convert-value-refused"
        } else if choice(own, value).zip(choice(other, value)).is_some_and(|(own, other)| own != other) {
            "convert-value-differs-in-meaning"
        } else {
            return;
        };
        let severity = if code == "convert-value-refused" { Severity::Error } else { Severity::Warning };
        let judged = self.at(code, severity, span).arg("parameter", name).arg("value", value);
        self.found.push(judged.arg("cycle", key.to_string()).arg("control", self.request.to.on.control.title.as_str()));
    }

    /// The labels of a cycle in the language of the program, on one of the two controls.
    fn labels<'l>(&self, against: &Against<'l>, key: CycleKey) -> Option<&'l LanguageLabels> {
        against.labels.cycle(key)?.language(self.language())
    }

    /// The language that new labels are in: that of the program, else that of the other control's manual.
    fn language(&self) -> &str {
        self.facts.language.as_deref().unwrap_or(self.request.to.on.control.language.as_str())
    }

    /// Whether the encoding of the file has all characters of a text; says it if not.
    fn writable(&mut self, text: &str, span: Span) -> bool {
        let Err(character) = self.request.encoding.encode(text) else { return true };
        let foreign = self.at("label-not-encodable", Severity::Error, span).arg("label", text);
        self.found.push(foreign.arg("character", character.to_string()));
        false
    }
}

/// What a value chooses, by the id of its text.
fn choice<'p>(param: &'p Param, value: &str) -> Option<&'p str> {
    let number: f64 = value.trim().parse().ok()?;
    let same = |choice: &&crate::spec::Choice| choice.value.as_str().parse() == Ok(number);
    param.choices.iter().find(same).map(|choice| choice.choice.as_str())
}

/// A number as the other control prints it for a parameter.
fn printed(param: &Param, value: f64) -> String {
    crate::language::label::as_printed(param, &value.to_string())
}
