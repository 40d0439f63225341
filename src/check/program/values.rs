//! Why a parameter refuses what is written: found once, reported by several rules.
//!
//! A value that is another parameter is refused only if its number is certain wherever the run comes from.
use std::borrow::Cow;

use super::definition::Definition;
use super::item::{Item, capitals};
use super::reading::Reading;
use crate::base::expr::{QKind, QRef};
use crate::program::syntax::{Parameter, ValueKind};
use crate::spec::{MM_PER_INCH, Param, ParameterKind, Refusal, number_refusal_in, refusal};

/// Why the value is refused; `inch` says whether lengths of the program are inches.
pub(in crate::check) fn refused(item: &Item<'_>, inch: bool) -> Option<Refusal> {
    let param = item.param?;
    let kind = kind(item, param);
    match item.value.map(|value| value.kind) {
        Some(ValueKind::Missing) => return Some(Refusal::Kind),
        Some(ValueKind::Q { q, .. }) if q.kind == QKind::Qs => {
            let takes_text = matches!(kind, ParameterKind::Text | ParameterKind::NumberOrName);
            return (!takes_text).then_some(Refusal::Kind);
        }
        Some(ValueKind::Q { .. }) => {
            // What takes only a text or another parameter is not refused by a number that a parameter happens to have.
            let number = item.number.filter(|_| !matches!(kind, ParameterKind::Text | ParameterKind::QNumber))?;
            return number_refusal_in(param, number, if inch && param.is_measured() { MM_PER_INCH } else { 1.0 });
        }
        Some(ValueKind::Text(_)) if kind == ParameterKind::Number => return Some(Refusal::Kind),
        Some(ValueKind::Number(_)) if kind == ParameterKind::Text && param.q.is_some() => return Some(Refusal::Kind),
        // A text is in quotation marks.
        Some(ValueKind::Word) if kind == ParameterKind::Text && param.q.is_some() => {
            return (!param.words.iter().any(|word| *word == item.printed)).then_some(Refusal::Kind);
        }
        _ => {}
    }
    // The manuals print ranges in mm.
    if let (true, true, Some(ValueKind::Number(number))) =
        (inch, param.is_measured(), item.value.map(|value| value.kind))
    {
        return number_refusal_in(param, number, MM_PER_INCH);
    }
    match item.value.map(|value| value.kind) {
        Some(ValueKind::Number(number)) if is_plain(param, &item.printed) => number_refusal_in(param, number, 1.0),
        _ => refusal(param, &single_signed(&item.printed)),
    }
}

/// Whether a number is printed as every reader of numbers reads it, for a parameter that takes any number.
fn is_plain(param: &Param, printed: &str) -> bool {
    let digits = printed.as_bytes();
    let digits = digits.strip_prefix(b"+").or_else(|| digits.strip_prefix(b"-")).unwrap_or(digits);
    let takes = matches!(
        param.kind,
        ParameterKind::Number | ParameterKind::Integer | ParameterKind::NumberOrName | ParameterKind::QNumber
    );
    takes && param.field.is_none() && digits.first().is_some_and(u8::is_ascii_digit)
}

/// What kind of value belongs where the parameter is written: of one that takes a number or a name, the Q parameter
/// holds the number and the text parameter the name.
pub(in crate::check) fn kind(item: &Item<'_>, param: &Param) -> ParameterKind {
    match param.q_of_name() {
        Some(name) if item.name == name.to_string() => ParameterKind::Text,
        Some(_) => ParameterKind::Number,
        None => param.kind,
    }
}

/// Two signs stand for their product, as the control reads them, and a blank may come after a sign.
fn single_signed(printed: &str) -> Cow<'_, str> {
    if printed.starts_with(['+', '-']) && printed.contains(char::is_whitespace) {
        let closed: String = printed.split_whitespace().collect();
        return Cow::Owned(single_signed(&closed).into_owned());
    }
    let sign = |byte: u8| matches!(byte, b'+' | b'-');
    let doubled = printed.bytes().zip(printed.bytes().skip(1)).any(|(one, next)| sign(one) && sign(next));
    if !doubled {
        return Cow::Borrowed(printed);
    }
    [("+-", "-"), ("-+", "-"), ("--", "+"), ("++", "+")]
        .iter()
        .fold(printed.to_owned(), |text, (two, one)| text.replace(two, one))
        .into()
}

/// How messages show a value: what is written, with the number that it certainly has.
pub(in crate::check) fn shown(item: &Item<'_>) -> String {
    match item.number {
        Some(number) => format!("{} ({number})", item.printed),
        None => item.printed.to_string(),
    }
}

/// What distinguishes numbers: equal ones have the same.
pub(in crate::check) fn bits(number: f64) -> u64 {
    // 0 has two signs.
    (number + 0.0).to_bits()
}

/// The number that is certainly written for a parameter.
pub(in crate::check) fn number(item: &Item<'_>) -> Option<f64> {
    match item.value?.kind {
        ValueKind::Number(number) => Some(number),
        ValueKind::Q { .. } => item.number,
        _ => None,
    }
}

/// Whether every cycle with that parameter refuses a value, those of this control or, if it describes none with it, of
/// all; `number` is the certain number of a value that is a parameter. Nothing where fewer cycles than `least` have it.
pub(in crate::check) fn refused_by_all(
    reading: &Reading<'_>,
    q: QRef,
    written: &Parameter,
    number: Option<f64>,
    least: usize,
) -> Option<bool> {
    let mut params: Vec<&Param> = reading.against.on.all_written(q).collect();
    if params.is_empty() {
        params = reading.against.catalogue.controls.values().flat_map(|on| on.all_written(q)).collect();
    }
    if params.len() < least.max(1) {
        return None;
    }
    let printed = reading.text(written.value.span);
    let refuses = |param: &&Param| {
        let item = Item {
            param: Some(param),
            name: Cow::Owned(q.to_string()),
            span: written.span,
            value_span: written.value.span,
            printed: capitals(printed),
            value: Some(written.value),
            number,
            label: None,
            index: None,
            refusal: None,
        };
        refused(&item, reading.inch).is_some()
    };
    Some(params.iter().all(refuses))
}

/// Runs through the values of a definition that are refused.
pub(in crate::check) fn each_refused<'d, 'a>(
    definition: &'d Definition<'a>,
    mut tell: impl FnMut(&'d Item<'a>, &'a Param, &'d Refusal, String),
) {
    for item in &definition.items {
        if let (Some(param), Some(refusal)) = (item.param, &item.refusal) {
            tell(item, param, refusal, definition.key.to_string());
        }
    }
}
