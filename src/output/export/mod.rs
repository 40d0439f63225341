//! The interchange form of everything that is known about the cycles of a control, in a language:
//! `ciklo-export/1`, described in `docs/export.md`.
//!
//! Invariant: the output follows from the specifications and texts alone, in one order.
use serde::Serialize;
use serde_json::{Number, Value};

use crate::base::diag::Diagnostic;
use crate::language::locale::Language;
use crate::language::text::{self, CycleText, Numbered, RunPart};
use crate::spec::{Cycle, OnControl, Param};

/// The name and version of the form.
pub const FORMAT: &str = "ciklo-export/1";

/// The kind of note that says what the control checks.
const GUARD: &str = "guard";

/// The export of a control in a language.
#[derive(Clone, Debug, Serialize)]
pub struct Export {
    /// [`FORMAT`].
    pub format: &'static str,
    /// The id of the control.
    pub control: String,
    /// The tag of the language.
    pub lang: String,
    /// The cycles that are described, by key.
    pub cycles: Vec<ExportedCycle>,
    /// The cycles that manuals only name, by key.
    pub named: Vec<NamedCycle>,
}

/// A cycle that is only named.
#[derive(Clone, Debug, Serialize)]
pub struct NamedCycle {
    /// `CYCL DEF` or `TCH PROBE`.
    pub keyword: &'static str,
    /// Its number.
    pub number: u32,
    /// The printed name, in the language of the manual.
    pub name: String,
}

/// A cycle.
#[derive(Clone, Debug, Serialize)]
pub struct ExportedCycle {
    /// `CYCL DEF` or `TCH PROBE`.
    pub keyword: &'static str,
    /// Its number.
    pub number: u32,
    /// DIN/ISO codes.
    pub iso: Vec<String>,
    /// Its name.
    pub name: String,
    /// Its name in NC blocks.
    pub nc_name: String,
    /// Printed variants of it.
    pub nc_name_aliases: Vec<String>,
    /// `on-call` or `on-definition`.
    pub takes_effect: &'static str,
    /// Software options.
    pub options: Vec<u32>,
    /// Its parameters, in the order of the dialog.
    pub parameters: Vec<ExportedParameter>,
    /// The Q parameters that it sets.
    pub results: Vec<ExportedResult>,
    /// Its run.
    pub steps: Vec<ExportedStep>,
    /// Its notes.
    pub notes: Vec<ExportedNote>,
}

/// A parameter.
#[derive(Clone, Debug, Serialize)]
pub struct ExportedParameter {
    /// `Q200`, or `31.2 height` for a field of the old form.
    pub q: String,
    /// What kind of entry.
    pub kind: &'static str,
    /// Its name.
    pub name: String,
    /// The question of the dialog.
    pub prompt: String,
    /// The NC label, or the printed word of a field; null for a field without one.
    pub label: Option<String>,
    /// Printed variants of it.
    pub label_aliases: Vec<String>,
    /// What it means.
    pub help: String,
    /// What it measures.
    pub quantity: &'static str,
    /// Its unit.
    pub unit: Option<&'static str>,
    /// `incremental`, `absolute` or null.
    pub reference: Option<&'static str>,
    /// The least value, inclusive.
    pub min: Option<Value>,
    /// The greatest value, inclusive.
    pub max: Option<Value>,
    /// The greatest number of characters of a text or a name.
    pub max_length: Option<u32>,
    /// The values offered.
    pub choices: Vec<ExportedChoice>,
    /// Words instead of a number.
    pub words: Vec<String>,
    /// The phrase of the condition under which it acts.
    pub effective: Option<String>,
    /// Its value on controls that lack it.
    pub neutral: Option<Value>,
    /// The printed example.
    pub example: Option<String>,
}

/// A choice.
#[derive(Clone, Debug, Serialize)]
pub struct ExportedChoice {
    /// An integer, or a text such as `>0`.
    pub value: Value,
    /// Its meaning.
    pub text: String,
}

/// A result.
#[derive(Clone, Debug, Serialize)]
pub struct ExportedResult {
    /// The Q parameter, or the field that names it.
    pub q: String,
    /// Its meaning.
    pub text: String,
}

/// A step.
#[derive(Clone, Debug, Serialize)]
pub struct ExportedStep {
    /// Its number.
    pub number: usize,
    /// Its id.
    pub id: String,
    /// Its text, a bullet a line after it.
    pub text: String,
}

/// A note.
#[derive(Clone, Debug, Serialize)]
pub struct ExportedNote {
    /// `danger`, `caution`, `note`, `machine-builder` or `guard`.
    pub kind: &'static str,
    /// Its text.
    pub text: String,
}

/// Everything about the cycles of a control in a language.
///
/// # Errors
/// Every text that is missing.
pub fn export(on: &OnControl, language: &Language) -> Result<Export, Vec<Diagnostic>> {
    let mut cycles = Vec::new();
    let mut faults = Vec::new();
    for cycle in on.cycles.values() {
        match text::with_texts(on, cycle, language, exported) {
            Ok(cycle) => cycles.push(cycle),
            Err(more) => faults.extend(more),
        }
    }
    if !faults.is_empty() {
        return Err(faults);
    }
    Ok(Export {
        format: FORMAT,
        control: on.id().to_owned(),
        lang: language.tag().to_owned(),
        cycles,
        named: named(on),
    })
}

/// The cycles that the manuals of the control name without a specification here.
pub fn named(on: &OnControl) -> Vec<NamedCycle> {
    let described = |keyword, number| on.cycles.contains_key(&crate::spec::CycleKey::new(keyword, number));
    let mut list: Vec<_> = on.control.named.iter().filter(|named| !described(named.keyword, named.number)).collect();
    list.sort_by_key(|named| (named.keyword, named.number));
    let entry = |named: &&crate::spec::Named| NamedCycle {
        keyword: named.keyword.as_str(),
        number: named.number,
        name: named.name.clone(),
    };
    list.iter().map(entry).collect()
}

/// One cycle.
pub fn exported(text: &CycleText) -> ExportedCycle {
    let cycle = text.cycle;
    ExportedCycle {
        keyword: cycle.key.keyword.as_str(),
        number: cycle.key.number,
        iso: cycle.iso.clone(),
        name: text.name().into_owned(),
        nc_name: text.nc_name().into_owned(),
        nc_name_aliases: text.nc_name_aliases(),
        takes_effect: cycle.file.takes_effect.as_str(),
        options: cycle.described.options.clone(),
        parameters: cycle.params.iter().map(|param| parameter(text, param)).collect(),
        results: results(text, cycle),
        steps: steps(text),
        notes: notes(text),
    }
}

fn parameter(text: &CycleText, param: &Param) -> ExportedParameter {
    let texts = text.param(param);
    let choice = |(value, text): (&str, std::borrow::Cow<str>)| ExportedChoice {
        value: choice_value(value),
        text: text.into_owned(),
    };
    ExportedParameter {
        q: texts.q,
        kind: param.kind.as_str(),
        name: texts.name.into_owned(),
        prompt: texts.prompt.into_owned(),
        label: texts.label.map(std::borrow::Cow::into_owned),
        label_aliases: texts.label_aliases,
        help: texts.help.into_owned(),
        quantity: param.quantity.as_str(),
        unit: param.quantity.unit(),
        reference: param.reference.map(crate::spec::Reference::as_str),
        min: param.min.map(json_number),
        max: param.max.map(json_number),
        max_length: param.max_length,
        choices: texts.choices.into_iter().map(choice).collect(),
        words: param.words.clone(),
        effective: texts.effective.map(std::borrow::Cow::into_owned),
        neutral: param.neutral.map(json_number),
        example: param.example.clone(),
    }
}

/// A choice as JSON: a whole number as one, anything else as text.
pub fn choice_value(value: &str) -> Value {
    value.strip_prefix('+').unwrap_or(value).parse::<i64>().map_or_else(|_| Value::from(value), Value::from)
}

/// A number as JSON: whole numbers without a decimal point.
pub fn json_number(value: f64) -> Value {
    /// Beyond this not every whole number is a binary64.
    const EXACT: f64 = 9_007_199_254_740_992.0;
    if value.fract() == 0.0 && value.abs() < EXACT {
        return Value::from(value as i64);
    }
    Number::from_f64(value).map_or(Value::Null, Value::Number)
}

fn results(text: &CycleText, cycle: &Cycle) -> Vec<ExportedResult> {
    let entry = |outcome: &crate::spec::Outcomes| {
        Some(ExportedResult { q: result_name(cycle, outcome)?, text: text.result(&outcome.is).into_owned() })
    };
    cycle.file.results.iter().filter_map(entry).collect()
}

/// What a result is called: its Q parameter, or the field that names one.
pub fn result_name(cycle: &Cycle, outcome: &crate::spec::Outcomes) -> Option<String> {
    if let Some(q) = outcome.q {
        return Some(q.to_string());
    }
    let field = outcome.field.as_ref()?;
    let is_it = |param: &&Param| param.field.as_ref().is_some_and(|own| own.id.as_str() == field.as_str());
    cycle.params.iter().find(is_it).map(|param| param.label_in(cycle.key.number))
}

fn steps(text: &CycleText) -> Vec<ExportedStep> {
    let step = |step: Numbered| {
        let mut text = step.text.into_owned();
        for bullet in step.bullets {
            text.push_str("\n- ");
            text.push_str(&bullet.text);
        }
        ExportedStep { number: step.number, id: step.id.to_owned(), text }
    };
    RunPart::numbered(text.run()).into_iter().map(step).collect()
}

fn notes(text: &CycleText) -> Vec<ExportedNote> {
    let notes = text.notes().into_iter().map(|(kind, text)| (kind.as_str(), text));
    let guards = text.guards().into_iter().map(|guard| (GUARD, guard.text));
    notes.chain(guards).map(|(kind, text)| ExportedNote { kind, text: text.into_owned() }).collect()
}
