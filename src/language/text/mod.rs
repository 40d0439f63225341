//! The texts of a cycle on a control in a language: names, labels, helps, sentences.
//!
//! Readers ask here with ids of the specification; scope and arguments are set up once for a cycle.
//! Invariant: nothing here formats a page, and a text that is missing is never replaced: it is
//! recorded as a fault, and the caller fails at the end.
mod param;
mod run;

use std::borrow::Cow;
use std::cell::RefCell;

use crate::base::diag::{Diagnostic, Place};
use crate::language::locale::{Args, Digits, Language, LocaleError, Scope};
use crate::spec::{Cycle, Name, Note, NoteKind, OnControl, Outcome, Param};

pub use param::ParamText;
pub use run::{Bullet, Numbered, Repeat, RunPart, Step};

/// What separates the variants of one attribute, such as `.nc-aliases`.
const ALIAS_SEPARATOR: char = '|';

/// The names that the texts of a cycle may use, by argument: `cycle`, `q-<meaning>`, `mp-<datum>` …
#[derive(Debug)]
pub struct Vocabulary(Vec<(String, String)>);

/// The name of a cycle in NC blocks and its other printed forms, by the cycle's name alone.
pub fn nc_names(on: &OnControl, cycle: &str, language: &Language) -> Vec<String> {
    let scope = Scope::new(cycle, on.id());
    let text = |attribute| language.plain((&*format!("cycle-{cycle}"), attribute), &scope).ok().map(one_line);
    let own = text("nc").map(Cow::into_owned);
    let others = text("nc-aliases").map_or_else(Vec::new, |list| aliases(&list));
    own.into_iter().chain(others).collect()
}

impl Vocabulary {
    /// The names for a cycle on a control, in the words of a language where they are words.
    pub fn of(on: &OnControl, cycle: &Cycle, language: &Language) -> Self {
        let mut names = vec![
            ("cycle".to_owned(), cycle.key.number.to_string()),
            ("control".to_owned(), on.id().to_owned()),
            ("control-name".to_owned(), on.control.title.clone()),
        ];
        names.extend(
            on.control.data.0.iter().map(|(datum, name)| (format!("mp-{}", datum.as_str()), name.text.to_string())),
        );
        let model = cycle.file.like.as_ref().and_then(|like| on.by_name(like.as_str()));
        for param in &cycle.params {
            let name = param_name(param, cycle, language);
            let stands_for = param.field.as_ref().and_then(|field| field.stands_for);
            if let Some(replaced) = stands_for.and_then(|q| model?.param(q)) {
                names.push((format!("q-{}", replaced.is.as_str()), name.clone()));
            }
            names.push((format!("q-{}", param.is.as_str()), name));
        }
        Self(names)
    }

    fn args(&self) -> Args<'_> {
        self.0.iter().fold(Args::new(), |args, (name, value)| args.text(name, value.as_str()))
    }
}

/// What texts call a parameter: its Q number, or the word printed for a field of the old form.
fn param_name(param: &Param, cycle: &Cycle, language: &Language) -> String {
    if let Some(q) = param.q {
        return q.to_string();
    }
    let scope = Scope::new(cycle.name(), &cycle.control);
    let id = format!("parameter-{}", param.is.as_str());
    let word = language.plain((id.as_str(), "word"), &scope).or_else(|_| language.plain(id.as_str(), &scope));
    word.map_or_else(|_| param.label_in(cycle.key.number), |word| word.trim_end_matches([':', ' ']).to_owned())
}

/// What the control checks before it executes a cycle.
#[derive(Clone, Debug)]
pub struct GuardText<'a> {
    /// What happens if the check fails.
    pub outcome: Outcome,
    /// What is checked.
    pub text: Cow<'a, str>,
    /// The printed name of the machine datum that switches the check off.
    pub switched_off_by: Option<&'a str>,
}

/// The sentence of a guard or error of a cycle in the first of the languages that has it.
pub fn guard_sentence(on: &OnControl, cycle: &Cycle, code: &str, languages: &[&Language]) -> Option<String> {
    let key = format!("guard-{code}");
    languages.iter().find_map(|language| {
        let vocabulary = Vocabulary::of(on, cycle, language);
        let text = CycleText::new(on, cycle, language, &vocabulary);
        let sentence = text.find(&key)?.into_owned();
        text.faults().is_empty().then_some(sentence)
    })
}

/// The texts of one cycle on one control in one language.
pub struct CycleText<'a> {
    /// The control.
    pub on: &'a OnControl,
    /// The cycle.
    pub cycle: &'a Cycle,
    /// The language.
    pub language: &'a Language,
    scope: Scope<'a>,
    args: Args<'a>,
    faults: RefCell<Vec<Diagnostic>>,
}

impl<'a> CycleText<'a> {
    /// The texts of `cycle`; `vocabulary` is that of the same cycle, control and language.
    pub fn new(on: &'a OnControl, cycle: &'a Cycle, language: &'a Language, vocabulary: &'a Vocabulary) -> Self {
        let scope = Scope::new(cycle.name(), on.id());
        Self { on, cycle, language, scope, args: vocabulary.args(), faults: RefCell::default() }
    }

    /// What was missing so far.
    pub fn faults(self) -> Vec<Diagnostic> {
        self.faults.into_inner()
    }

    /// The text of a key such as `cycle-drilling.purpose`. If there is none, that is recorded as a
    /// fault at `place` and the text is empty.
    pub fn get(&self, key: &str, place: &Place) -> Cow<'a, str> {
        self.language
            .text(key, &self.scope, &self.args)
            .map(one_line)
            .unwrap_or_else(|error| self.missing(error, Some(place)))
    }

    /// The text of a key that need not exist. One that exists and cannot be formatted is a fault.
    pub fn find(&self, key: &str) -> Option<Cow<'a, str>> {
        if !self.language.has(key, &self.scope) {
            return None;
        }
        let text = self.language.text(key, &self.scope, &self.args).map(one_line);
        Some(text.unwrap_or_else(|error| self.missing(error, None)))
    }

    /// A text that belongs to no cycle, with arguments of its own.
    pub fn general(&self, key: &str, args: &Args) -> Cow<'a, str> {
        self.language.text(key, &self.scope, args).map(one_line).unwrap_or_else(|error| self.missing(error, None))
    }

    fn missing(&self, error: LocaleError, place: Option<&Place>) -> Cow<'a, str> {
        let mut diagnostic = Diagnostic::from(error);
        if diagnostic.place.is_none() {
            diagnostic.place = place.cloned();
        }
        // The text is good for other controls; what it asks for is in the profile of this one.
        if diagnostic.code == "locale-missing-argument" {
            diagnostic = diagnostic.related("for-this-control", self.on.control.control.place.clone());
        }
        let diagnostic = diagnostic.arg("cycle", self.cycle.key.to_string()).arg("control", self.on.id());
        self.faults.borrow_mut().push(diagnostic);
        Cow::Borrowed("")
    }

    /// A text by the id of a specification: `named("note", id)` is `note-<id>`.
    fn named(&self, kind: &str, name: &Name) -> Cow<'a, str> {
        self.get(&format!("{kind}-{}", name.as_str()), &name.place)
    }

    fn of_cycle(&self, attribute: &str) -> String {
        format!("cycle-{}{attribute}", self.cycle.name())
    }

    /// The name of the cycle.
    pub fn name(&self) -> Cow<'a, str> {
        self.get(&self.of_cycle(""), &self.cycle.file.name.place)
    }

    /// The name of one of several forms.
    pub fn form(&self, form: &Name) -> Cow<'a, str> {
        self.named("form", form)
    }

    /// The name in NC blocks.
    pub fn nc_name(&self) -> Cow<'a, str> {
        self.get(&self.of_cycle(".nc"), &self.cycle.file.name.place)
    }

    /// Other printed forms of the name in NC blocks.
    pub fn nc_name_aliases(&self) -> Vec<String> {
        self.find(&self.of_cycle(".nc-aliases")).map_or_else(Vec::new, |list| aliases(&list))
    }

    /// What the cycle is for, a paragraph a line.
    pub fn purpose(&self) -> Cow<'a, str> {
        self.get(&self.of_cycle(".purpose"), &self.cycle.file.name.place)
    }

    /// The phrase of a condition, completing "only if".
    pub fn condition(&self, condition: &Name) -> Cow<'a, str> {
        self.named("condition", condition)
    }

    /// The text of a choice.
    pub fn choice(&self, choice: &Name) -> Cow<'a, str> {
        self.named("choice", choice)
    }

    /// The meaning of a result.
    pub fn result(&self, meaning: &Name) -> Cow<'a, str> {
        self.named("result", meaning)
    }

    /// The title of a figure.
    pub fn figure(&self, name: &Name) -> Cow<'a, str> {
        self.named("figure", name)
    }

    /// The name that the control gives to a machine datum, `SET_UP`; its id if it has none.
    pub fn datum<'t>(&'t self, id: &'t str) -> &'t str {
        let data = &self.on.control.data.0;
        data.iter().find(|(own, _)| own.as_str() == id).map_or(id, |(_, name)| name.as_str())
    }

    /// A word that belongs to no cycle.
    pub fn word(&self, id: &str) -> Cow<'a, str> {
        self.general(id, &Args::new())
    }

    /// The name of a table.
    pub fn table(&self, table: &Name) -> Cow<'a, str> {
        self.named("table", table)
    }

    /// The title of an example.
    pub fn title(&self, title: &Name) -> Cow<'a, str> {
        self.named("title", title)
    }

    /// The notes with their kinds, in the order of the specification.
    pub fn notes(&self) -> Vec<(NoteKind, Cow<'a, str>)> {
        self.cycle.file.notes.iter().map(|note| (note.kind, self.note(note))).collect()
    }

    /// The text of a note of the cycle.
    pub fn note(&self, note: &Note) -> Cow<'a, str> {
        self.named("note", &note.note)
    }

    /// What the control checks and refuses, guards of fragments included.
    pub fn guards(&self) -> Vec<GuardText<'a>> {
        let mut texts = Vec::new();
        let mut seen = Vec::new();
        self.collect_guards(&self.cycle.file.guards, &mut seen, &mut texts);
        texts
    }

    fn collect_guards(
        &self,
        guards: &'a [crate::spec::Guard],
        seen: &mut Vec<&'a str>,
        texts: &mut Vec<GuardText<'a>>,
    ) {
        for guard in guards {
            let Some(name) = guard.code.as_ref().or(guard.r#use.as_ref()) else { continue };
            if seen.contains(&name.as_str()) {
                continue;
            }
            seen.push(name.as_str());
            if guard.code.is_some() {
                let datum = guard.switched_off_by.as_ref();
                texts.push(GuardText {
                    outcome: guard.then.unwrap_or(Outcome::Error),
                    text: self.named("guard", name),
                    switched_off_by: datum.map(|datum| self.on.datum(datum.as_str()).unwrap_or(datum.as_str())),
                });
            } else if let Some(fragment) = self.on.fragments.get(name.as_str()) {
                self.collect_guards(&fragment.guards, seen, texts);
            }
        }
    }

    /// The number as prose shows it.
    pub fn number(&self, value: f64) -> String {
        self.language.numbers().prose(value, Digits::default()).unwrap_or_default()
    }
}

/// Fluent keeps the line breaks of its files; a text has none, except between paragraphs.
fn one_line(text: Cow<'_, str>) -> Cow<'_, str> {
    if !text.contains('\n') {
        return text;
    }
    // Not `split_whitespace`, which would eat no-break spaces.
    let joined = |paragraph: &str| {
        let words = paragraph.split([' ', '\n', '\t']).filter(|word| !word.is_empty());
        words.collect::<Vec<_>>().join(" ")
    };
    Cow::Owned(text.split("\n\n").map(joined).collect::<Vec<_>>().join("\n"))
}

/// The variants in a list such as `A | B`.
fn aliases(list: &str) -> Vec<String> {
    list.split(ALIAS_SEPARATOR).map(str::trim).filter(|alias| !alias.is_empty()).map(str::to_owned).collect()
}

/// Formats with the texts of a cycle and gives the result, or everything that was missing.
///
/// # Errors
/// One diagnostic for each text that is missing or cannot be formatted.
pub fn with_texts<T>(
    on: &OnControl,
    cycle: &Cycle,
    language: &Language,
    make: impl FnOnce(&CycleText) -> T,
) -> Result<T, Vec<Diagnostic>> {
    let vocabulary = Vocabulary::of(on, cycle, language);
    let text = CycleText::new(on, cycle, language, &vocabulary);
    let made = make(&text);
    let faults = text.faults();
    if faults.is_empty() { Ok(made) } else { Err(faults) }
}
