//! Dialogs: what a control asks for a cycle, field by field.
//!
//! Invariant: a dialog is data; how a terminal shows it is in `render`.
mod render;

use serde::Serialize;
use serde_json::Value;

use crate::base::diag::Diagnostic;
use crate::language::locale::Language;
use crate::language::text::{CycleText, with_texts};
use crate::output::export::{choice_value, json_number};
use crate::spec::{Cycle, OnControl, Param, Reference};

pub use render::render;

/// The name and version of the bundle's form.
pub const FORMAT: &str = "ciklo-dialogs/1";

/// All dialogs of a control in a language.
#[derive(Clone, Debug, Serialize)]
pub struct Bundle {
    /// [`FORMAT`].
    pub format: &'static str,
    /// The id of the control.
    pub control: String,
    /// The tag of the language.
    pub lang: String,
    /// The dialogs, by key of the cycle.
    pub dialogs: Vec<Dialog>,
}

/// The dialog of a cycle.
#[derive(Clone, Debug, Serialize)]
pub struct Dialog {
    /// `CYCL DEF` or `TCH PROBE`.
    pub keyword: &'static str,
    /// The number of the cycle.
    pub number: u32,
    /// The name of the cycle.
    pub title: String,
    /// Its name in NC blocks.
    pub nc_name: String,
    /// The fields in the order in which they are asked for.
    pub fields: Vec<DialogField>,
}

/// One field.
#[derive(Clone, Debug, Serialize)]
pub struct DialogField {
    /// `Q200`, or `31.2 height` for a field of the old form.
    pub q: String,
    /// The form of the cycle that it belongs to, if there are several.
    pub form: Option<String>,
    /// The name of that form in the language.
    pub form_name: Option<String>,
    /// Its name.
    pub name: String,
    /// The question.
    pub prompt: String,
    /// What it means.
    pub help: String,
    /// What kind of entry.
    pub kind: &'static str,
    /// Its unit as the language writes it.
    pub unit: Option<String>,
    /// `incremental`, `absolute` or null.
    pub reference: Option<&'static str>,
    /// The range as the language writes numbers, with the unit.
    pub range: Option<String>,
    /// The least value.
    pub min: Option<Value>,
    /// The greatest value.
    pub max: Option<Value>,
    /// The greatest number of characters of a text.
    pub max_length: Option<u32>,
    /// The values offered.
    pub choices: Vec<DialogChoice>,
    /// Words instead of a number.
    pub words: Vec<String>,
    /// The phrase of the condition under which it acts.
    pub effective: Option<String>,
    /// Whether it may be left out.
    pub optional: bool,
    /// The value shown at first: that of the printed example.
    pub example: Option<String>,
}

/// A value that a field offers.
#[derive(Clone, Debug, Serialize)]
pub struct DialogChoice {
    /// An integer, or a text such as `>0`.
    pub value: Value,
    /// Its meaning.
    pub text: String,
}

/// The dialog of a cycle on a control in a language.
///
/// # Errors
/// Every text that is missing.
pub fn dialog(on: &OnControl, cycle: &Cycle, language: &Language) -> Result<Dialog, Vec<Diagnostic>> {
    with_texts(on, cycle, language, dialog_of)
}

/// All dialogs of a control in a language.
///
/// # Errors
/// Every text that is missing.
pub fn bundle(on: &OnControl, language: &Language) -> Result<Bundle, Vec<Diagnostic>> {
    let mut dialogs = Vec::new();
    let mut faults = Vec::new();
    for cycle in on.cycles.values() {
        match dialog(on, cycle, language) {
            Ok(dialog) => dialogs.push(dialog),
            Err(more) => faults.extend(more),
        }
    }
    if !faults.is_empty() {
        return Err(faults);
    }
    Ok(Bundle { format: FORMAT, control: on.id().to_owned(), lang: language.tag().to_owned(), dialogs })
}

/// The dialog, with texts that are set up.
pub fn dialog_of(text: &CycleText) -> Dialog {
    Dialog {
        keyword: text.cycle.key.keyword.as_str(),
        number: text.cycle.key.number,
        title: text.name().into_owned(),
        nc_name: text.nc_name().into_owned(),
        fields: text.cycle.params.iter().map(|param| field(text, param)).collect(),
    }
}

fn field(text: &CycleText, param: &Param) -> DialogField {
    let texts = text.param(param);
    let forms = &text.cycle.file.forms;
    let form = param.field.as_ref().filter(|_| forms.len() > 1).and_then(|field| forms.get(field.form));
    let choices = texts.choices.into_iter();
    DialogField {
        q: texts.q,
        form: form.map(|form| form.form.as_str().to_owned()),
        form_name: form.map(|form| text.form(&form.form).into_owned()),
        name: texts.name.into_owned(),
        prompt: texts.prompt.into_owned(),
        help: texts.help.into_owned(),
        kind: param.kind.as_str(),
        unit: text.unit(param.quantity).map(std::borrow::Cow::into_owned),
        reference: param.reference.map(Reference::as_str),
        range: text.range(param),
        min: param.min.map(json_number),
        max: param.max.map(json_number),
        max_length: param.max_length,
        choices: choices
            .map(|(value, text)| DialogChoice { value: choice_value(value), text: text.into_owned() })
            .collect(),
        words: param.words.clone(),
        effective: texts.effective.map(std::borrow::Cow::into_owned),
        optional: param.field.as_ref().is_some_and(|field| field.optional),
        example: param.example.clone(),
    }
}
