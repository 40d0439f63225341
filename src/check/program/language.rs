//! The language of a program's names and labels.
//!
//! Invariant: a text that a language lacks matches nothing; without any label that is known there is no language.
use super::definition::{Defined, Definition};
use super::item::Place;
use super::reading::Reading;
use crate::check::cycle::{Kept, LabelLanguages, LanguageLabels, ParamLabels, fold};
use crate::program::syntax::CycleForm;
use crate::spec::Cycle;

/// Which languages have a text as a name or label.
#[derive(Clone, Copy)]
struct Match<'a> {
    text: &'a str,
    /// Those that have it without regard to case and blanks.
    matching: LabelLanguages,
    /// Those that have it letter by letter.
    exact: LabelLanguages,
}

impl<'a> Match<'a> {
    fn of<'l>(
        text: &'a str,
        languages: &'l [LanguageLabels],
        own: impl Fn(&'l LanguageLabels) -> Option<&'l ParamLabels>,
    ) -> Self {
        let folded = fold(text);
        Self {
            text,
            matching: LabelLanguages::of(languages, |language| {
                own(language).is_some_and(|own| own.matches_folded(&folded))
            }),
            exact: LabelLanguages::of(languages, |language| own(language).is_some_and(|own| own.is_exactly(text))),
        }
    }
}

/// What was heard last of a cycle: its name and, by their places, the labels of its parameters. Definitions of a cycle
/// mostly have the same ones.
#[derive(Default)]
struct Memory<'a> {
    name: Option<Match<'a>>,
    labels: Vec<Option<Match<'a>>>,
}

/// What the names and labels of a program's definitions say.
pub(in crate::check) struct ProgramLanguage {
    /// The language that most of them belong to; among equals the language of the control's manual.
    pub(in crate::check) language: Option<String>,
    /// The languages that have all of a definition's letter by letter, none of one that has no labels.
    pub(in crate::check) usual: Vec<LabelLanguages>,
}

/// Listens to the names and labels of a program.
pub(in crate::check) fn language_of(reading: &Reading<'_>) -> ProgramLanguage {
    // Every cycle has the languages in the same order.
    let mut votes: Vec<(&str, usize)> = Vec::new();
    let mut memories: Vec<Memory<'_>> = Vec::new();
    let mut usual = Vec::with_capacity(reading.definitions.len());
    for definition in &reading.definitions {
        let Some(((cycle, kept), labels)) = definition.cycle().zip(definition.kept).zip(reading.labels(definition))
        else {
            usual.push(LabelLanguages::default());
            continue;
        };
        let languages = labels.languages.as_slice();
        if votes.is_empty() {
            votes = languages.iter().map(|language| (language.tag.as_str(), 0)).collect();
        }
        if memories.len() <= kept.place {
            memories.resize_with(kept.place + 1, Memory::default);
        }
        let Memory { name, labels } = &mut memories[kept.place];
        let (mut any, mut exact) = (false, LabelLanguages::ALL);
        let mut count = |matched: Match<'_>| {
            exact = exact.and(matched.exact);
            // Most names and labels belong to one language.
            for place in matched.matching.places() {
                if let Some((_, votes)) = votes.get_mut(place) {
                    *votes += 1;
                }
            }
        };
        if let Some(text) = definition.view.name.map(|name| reading.text(name)) {
            let known = name.filter(|known| known.text == text);
            let matched = known.unwrap_or_else(|| Match::of(text, languages, |language| Some(&language.name)));
            count(*name.insert(matched));
        }
        each_label(reading, definition, cycle, kept, |index, text| {
            any = true;
            if labels.len() <= index {
                labels.resize(index + 1, None);
            }
            let last = &mut labels[index];
            let known = last.filter(|known| known.text == text);
            let matched = known.unwrap_or_else(|| Match::of(text, languages, |language| language.params.get(index)));
            count(*last.insert(matched));
        });
        usual.push(if any { exact } else { LabelLanguages::default() });
    }
    let manual = reading.against.on.control.language.as_str();
    let best = votes.into_iter().filter(|(_, count)| *count > 0).max_by_key(|(tag, count)| (*count, *tag == manual));
    ProgramLanguage { language: best.map(|(tag, _)| tag.to_owned()), usual }
}

/// The labels of a definition with the places of their parameters in the cycle.
fn each_label<'a>(
    reading: &Reading<'a>,
    definition: &Defined<'a>,
    cycle: &'a Cycle,
    kept: &Kept,
    mut each: impl FnMut(usize, &'a str),
) {
    match &definition.view.form {
        CycleForm::Parameters(written) => {
            let mut place = Place::default();
            for parameter in &written.parameters {
                let own = place.of(cycle, parameter.q);
                if let (Some(own), Some(label)) = (own, parameter.label) {
                    each(own, reading.text(label));
                }
            }
        }
        CycleForm::Lines(_) => {
            if !kept.labelled {
                return;
            }
            for item in &Definition::of(reading.program, definition).items {
                if let (Some(own), Some(label)) = (item.index, item.label) {
                    each(own, reading.text(label));
                }
            }
        }
    }
}
