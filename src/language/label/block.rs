//! Cycle definitions as a control prints them.
//!
//! Invariant: the layout comes from the profile (`block:`) and the form of the cycle; a value that
//! was not given is that of the printed example.
use std::borrow::Cow;

use crate::base::diag::{Arg, Diagnostic};
use crate::base::expr::{QKind, QRef};
use crate::language::locale::Language;
use crate::language::text::{CycleText, with_texts};
use crate::spec::{Cycle, Field, NcExample, OnControl, Param, ParameterKind, Refusal, Shape, refusal};

/// What is asked of a block.
#[derive(Clone, Copy, Debug, Default)]
pub struct Request<'r> {
    /// Values by `Q…` or field id; the others come from the printed example.
    pub values: &'r [(String, String)],
    /// Optional fields to leave out.
    pub without: &'r [String],
    /// The form, if the cycle has several; the first one without it.
    pub form: Option<&'r str>,
    /// The number of the first block; that of the printed example without it.
    pub number: Option<u32>,
}

/// The block of a cycle as its control prints it, a line ending after each line.
///
/// # Errors
/// Every value that the cycle does not take, and every text that is missing.
pub fn block(on: &OnControl, cycle: &Cycle, language: &Language, request: &Request) -> Result<String, Vec<Diagnostic>> {
    with_texts(on, cycle, language, |text| block_of(text, request))?
}

/// A printed example of the cycle: its block without the blocks around it.
///
/// # Errors
/// As [`block`].
pub fn example(
    on: &OnControl,
    cycle: &Cycle,
    language: &Language,
    example: &NcExample,
) -> Result<String, Vec<Diagnostic>> {
    with_texts(on, cycle, language, |text| example_of(text, example))?
}

/// As [`block`], with texts that are set up.
///
/// # Errors
/// Every value that the cycle does not take.
pub fn block_of(text: &CycleText, request: &Request) -> Result<String, Vec<Diagnostic>> {
    let form = form_of(text.cycle, request.form)?;
    let mut faults = Vec::new();
    let mut values = Values::default();
    for (name, value) in request.values {
        if let Some(param) = find(text.cycle, form, name, &mut faults) {
            values.give(param, name, value, text, &mut faults);
        }
    }
    if !faults.is_empty() {
        return Err(faults);
    }
    let example = text.cycle.file.nc_examples.iter().find(|example| matches_form(text.cycle, example, form));
    let number = request.number.or(example.and_then(|example| example.number));
    values.finish(example, request.without);
    print(text, form, number, &values)
}

/// As [`example`], with texts that are set up.
///
/// # Errors
/// A value that is missing.
pub fn example_of(text: &CycleText, example: &NcExample) -> Result<String, Vec<Diagnostic>> {
    let form = form_of(text.cycle, example.form.as_ref().map(|form| form.as_str()))?;
    let mut values = Values::default();
    values.finish(Some(example), &[]);
    print(text, form, example.number, &values)
}

fn form_of(cycle: &Cycle, form: Option<&str>) -> Result<usize, Vec<Diagnostic>> {
    let Some(form) = form else { return Ok(0) };
    let at = cycle.file.forms.iter().position(|own| own.form.as_str() == form);
    at.ok_or_else(|| {
        let forms: Vec<&str> = cycle.file.forms.iter().map(|own| own.form.as_str()).collect();
        let diagnostic = Diagnostic::global("block-unknown-form").arg("form", form);
        vec![diagnostic.arg("cycle", cycle.key.to_string()).arg("forms", forms.join(", "))]
    })
}

fn matches_form(cycle: &Cycle, example: &NcExample, form: usize) -> bool {
    let asked = example.form.as_ref().map_or(0, |name| {
        cycle.file.forms.iter().position(|own| own.form.as_str() == name.as_str()).unwrap_or(usize::MAX)
    });
    asked == form
}

/// The parameter that a name means: `Q200` in any case, or the id of a field, with `-2`, `-3` … for
/// the further lines of one that may be repeated.
fn find<'c>(cycle: &'c Cycle, form: usize, name: &str, faults: &mut Vec<Diagnostic>) -> Option<&'c Param> {
    let q = QRef::parse(name);
    let is_it = |param: &&Param| match &param.field {
        None => q.is_some() && (param.q == q || param.q_of_name() == q),
        Some(field) => field.form == form && (field.id.as_str() == name || (field.repeat && repeated(field, name))),
    };
    let found = cycle.params.iter().find(is_it);
    if found.is_none() {
        let own = |param: &Param| match &param.field {
            None => param.q.map(|q| q.to_string()),
            Some(field) => (field.form == form).then(|| field.id.as_str().to_owned()),
        };
        let known: Vec<String> = cycle.params.iter().filter_map(own).collect();
        let diagnostic = Diagnostic::global("block-unknown-parameter").arg("name", name);
        faults.push(diagnostic.arg("cycle", cycle.key.to_string()).arg("known", known.join(", ")));
    }
    found
}

fn repeated(field: &Field, name: &str) -> bool {
    let rest = name.strip_prefix(field.id.as_str()).and_then(|rest| rest.strip_prefix('-'));
    rest.is_some_and(|rest| rest.parse::<u32>().is_ok())
}

/// Values by the upper-case name of a Q parameter or the id of a field.
#[derive(Default)]
struct Values<'v> {
    given: Vec<(String, Cow<'v, str>)>,
    without: Vec<&'v str>,
}

impl<'v> Values<'v> {
    fn give(&mut self, param: &Param, name: &str, value: &str, text: &CycleText, faults: &mut Vec<Diagnostic>) {
        // `QS409` is the name that `Q409` may hold instead of a number.
        let is_name = param.q_of_name().is_some_and(|q| QRef::parse(name) == Some(q));
        let name = param.q.map_or_else(|| name.to_owned(), |q| q.to_string());
        if self.given.iter().any(|(known, _)| *known == name) {
            faults.push(Diagnostic::global("block-duplicate-parameter").arg("name", name));
            return;
        }
        let value = if is_name { &*in_quotation_marks(value.trim()) } else { value.trim() };
        match refusal(param, value) {
            Some(refusal) => faults.push(refused(&name, value, param, &refusal, text)),
            None => self.given.push((name, Cow::Owned(as_printed(param, value)))),
        }
    }

    /// Fills in what an example has. Values that the program gives replace a whole repeated field.
    fn finish(&mut self, example: Option<&'v NcExample>, without: &'v [String]) {
        self.without = without.iter().map(String::as_str).collect();
        let Some(example) = example else { return };
        // `shift-2` is a further line of the field `shift`.
        let base = |name: &str| match name.rsplit_once('-') {
            Some((id, turn)) if turn.parse::<u32>().is_ok() => id.to_owned(),
            _ => name.to_owned(),
        };
        let given: Vec<String> = self.given.iter().map(|(name, _)| base(name)).collect();
        for (name, value) in &example.values.0 {
            if !given.contains(&base(name.as_str())) {
                self.given.push((name.text.to_string(), Cow::Borrowed(value.as_str())));
            }
        }
        let left_out = example.without.iter().map(|name| name.as_str());
        self.without.extend(left_out.filter(|name| !given.contains(&base(name))));
    }

    fn of(&self, name: &str) -> Option<&str> {
        self.given.iter().find(|(known, _)| known.as_str() == name).map(|(_, value)| &**value)
    }
}

fn refused(name: &str, value: &str, param: &Param, refusal: &Refusal, text: &CycleText) -> Diagnostic {
    let diagnostic = match refusal {
        Refusal::Kind => Diagnostic::global("block-wrong-kind").arg("kind", param.kind.as_str()),
        Refusal::Below(min) => Diagnostic::global("block-below-minimum").arg("min", *min),
        Refusal::Above(max) => Diagnostic::global("block-above-maximum").arg("max", *max),
        Refusal::TooLong(most) => {
            let kind = if param.lists_axes() { "axes" } else { param.kind.as_str() };
            Diagnostic::global("block-too-long").arg("most", f64::from(*most)).arg("kind", kind)
        }
        Refusal::NotOffered => {
            let values: Vec<&str> = param.choices.iter().map(|choice| choice.value.as_str()).collect();
            Diagnostic::global("block-not-offered").arg("offered", values.join(", "))
        }
    };
    let parameter = text.param(param).name.into_owned();
    diagnostic.arg("name", name).arg("value", Arg::Text(value.to_owned())).arg("parameter", parameter)
}

/// A given value as the control shows it: with a decimal point, with signs where the printed example has them, texts
/// in quotation marks.
pub fn as_printed(param: &Param, value: &str) -> String {
    let example = param.example.as_deref().unwrap_or_default();
    if param.kind == ParameterKind::Text {
        return in_quotation_marks(value).into_owned();
    }
    let pointed = with_point(param, value);
    let value = &*pointed;
    if !example.contains(['+', '-']) {
        return value.to_owned();
    }
    let words: Vec<String> = value.split_whitespace().map(with_sign).collect();
    words.join(" ")
}

/// A text as programs have it; one that is held in a parameter is given as the parameter's name.
fn in_quotation_marks(value: &str) -> Cow<'_, str> {
    let is_q = || QRef::parse(value).is_some_and(|q| q.kind == QKind::Qs);
    if value.starts_with('"') || is_q() { Cow::Borrowed(value) } else { Cow::Owned(format!("\"{value}\"")) }
}

/// `-30,5` as `-30.5`: programs may have either sign, one block has one. Texts and lists of labels have commas of their
/// own.
fn with_point<'v>(param: &Param, value: &'v str) -> Cow<'v, str> {
    if param.kind == ParameterKind::LabelList || value.contains('"') {
        return Cow::Borrowed(value);
    }
    Cow::Owned(value.replace(',', "."))
}

/// `60` as `+60`, `X60` as `X+60`, `I45` as `I+45`; whatever has a sign or is no number stays.
fn with_sign(word: &str) -> String {
    let letters = word.len() - word.trim_start_matches(|c: char| "IXYZABCUVW".contains(c)).len();
    let (head, number) = word.split_at(letters);
    if number.starts_with(|c: char| c.is_ascii_digit()) { format!("{head}+{number}") } else { word.to_owned() }
}

fn print(text: &CycleText, form: usize, number: Option<u32>, values: &Values) -> Result<String, Vec<Diagnostic>> {
    if text.cycle.is_old_style() { print_lines(text, form, number, values) } else { print_block(text, number, values) }
}

fn print_block(text: &CycleText, number: Option<u32>, values: &Values) -> Result<String, Vec<Diagnostic>> {
    let mut faults = Vec::new();
    let mut lines = vec![format!("{}{} {}", prefix(number), text.cycle.key, text.nc_name())];
    for param in &text.cycle.params {
        let Some(q) = param.q else { continue };
        let Some(value) = values.of(&q.to_string()).or(param.example.as_deref()) else {
            faults.push(no_value(text.cycle, &q.to_string()));
            continue;
        };
        let is_text = value.starts_with('"') || QRef::parse(value).is_some_and(|q| q.kind == QKind::Qs);
        let q = param.q_of_name().filter(|_| is_text).unwrap_or(q);
        lines.push(format!("{q}={value} ;{}", text.label_of(param).unwrap_or_default()));
    }
    if !faults.is_empty() {
        return Err(faults);
    }
    let mark = continuation(text.on, text.cycle).map(|mark| format!(" {mark}"));
    let end = mark.unwrap_or_default() + "\n";
    let mut block = lines.join(&end);
    block.push('\n');
    Ok(block)
}

/// The sign at the end of every line that is continued, in cycles of the manuals whose
/// controls print it.
pub fn continuation<'o>(on: &'o OnControl, cycle: &Cycle) -> Option<&'o str> {
    let layout = on.control.block.as_ref()?;
    let sources = &cycle.described.sources;
    let applies = sources.iter().all(|source| layout.manuals.contains(&source.manual));
    applies.then_some(layout.continuation.as_str())
}

fn print_lines(text: &CycleText, form: usize, number: Option<u32>, values: &Values) -> Result<String, Vec<Diagnostic>> {
    let Some(lines) = text.cycle.file.forms.get(form).map(|form| &form.lines) else { return Ok(String::new()) };
    let mut printed = Vec::new();
    let mut faults = Vec::new();
    for line in lines {
        let fields: Vec<_> = text.cycle.fields(form).filter(|(_, field)| field.line == line.line).collect();
        for turn in 1.. {
            let words = fields.iter().filter_map(|(param, field)| word(text, param, field, turn, values, &mut faults));
            let mut words: Vec<String> = words.collect();
            if line.line == 0 {
                words.insert(0, text.nc_name().into_owned());
            }
            if words.is_empty() {
                break;
            }
            printed.push((line.line + turn - 1, words.join(" ")));
            if !line.repeat {
                break;
            }
        }
    }
    if !faults.is_empty() {
        return Err(faults);
    }
    let mut block = String::new();
    for ((line, words), at) in printed.iter().zip(0..) {
        let number = number.map(|number| number.saturating_add(at));
        block.push_str(&format!("{}{}.{line} {words}\n", prefix(number), text.cycle.key));
    }
    Ok(block)
}

/// A field with its value, as it is printed in the given turn of its line (1 for lines that are not
/// repeated); nothing if it is left out.
fn word(
    text: &CycleText,
    param: &Param,
    field: &Field,
    turn: u32,
    values: &Values,
    faults: &mut Vec<Diagnostic>,
) -> Option<String> {
    let id = field.id.as_str();
    if values.without.contains(&id) {
        return None;
    }
    let value = match turn {
        1 => values.of(id).or(param.example.as_deref()),
        turn => values.of(&format!("{id}-{turn}")),
    };
    let Some(value) = value else {
        if turn == 1 && !field.optional {
            faults.push(no_value(text.cycle, id));
        }
        return None;
    };
    let label = text.label_of(param).unwrap_or_default();
    Some(match (field.shape, value.strip_prefix('I')) {
        (Shape::Labelled, _) => format!("{label} {value}"),
        (Shape::Word, Some(value)) => format!("I{label}{value}"),
        (Shape::Word, None) => format!("{label}{value}"),
        _ => value.to_owned(),
    })
}

fn no_value(cycle: &Cycle, name: &str) -> Diagnostic {
    Diagnostic::global("block-no-value").arg("name", name).arg("cycle", cycle.key.to_string())
}

fn prefix(number: Option<u32>) -> String {
    number.map_or_else(String::new, |number| format!("{number} "))
}
