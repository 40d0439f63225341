//! Parameters and old-style lines: numbers, ranges, choices and examples agree with each other.
use super::super::catalogue::{Catalogue, Cycle, OnControl, Param};
use super::super::value::refusal;
use super::super::vocabulary::{ParameterKind, Shape};
use crate::base::diag::Diagnostic;
use crate::base::expr::QKind;

pub(super) fn parameters(cycle: &Cycle, found: &mut Vec<Diagnostic>) {
    for (index, param) in cycle.params.iter().enumerate() {
        let earlier = cycle.params[..index].iter().find(|other| other.q.is_some() && other.q == param.q);
        if let (Some(first), Some(q)) = (earlier, param.q) {
            found.push(
                Diagnostic::error("spec-duplicate-parameter", param.place.clone())
                    .arg("q", q.to_string())
                    .related("first-place", first.place.clone()),
            );
        }
        range(param, found);
        choices(param, found);
        example(cycle, param, found);
        if let Some(condition) = &param.effective
            && cycle.file.conditions.get(condition.as_str()).is_none()
        {
            found.push(
                Diagnostic::error("spec-unknown-condition", condition.place.clone()).arg("name", condition.as_str()),
            );
        }
        let text_q = param.q.is_some_and(|q| q.kind == QKind::Qs);
        if text_q != (param.kind == ParameterKind::Text && param.q.is_some()) {
            found.push(Diagnostic::error("spec-text-parameter", param.place.clone()).arg("name", param.is.as_str()));
        }
    }
    if cycle.params.is_empty() != cycle.file.no_parameters {
        found.push(Diagnostic::error("spec-no-parameters", cycle.file.name.place.clone()));
    }
    if !cycle.file.parameters.is_empty() && !cycle.file.forms.is_empty() {
        found.push(Diagnostic::error("spec-both-forms", cycle.file.name.place.clone()));
    }
}

/// Words of blocks for which no number is left.
pub(super) fn limits(catalogue: &Catalogue, found: &mut Vec<Diagnostic>) {
    for limit in catalogue.blocks.iter().flat_map(|block| &block.limits) {
        if let (Some(min), Some(max)) = (limit.min, limit.max)
            && min >= max
        {
            found.push(Diagnostic::error("spec-empty-range", limit.place.clone()).arg("min", min).arg("max", max));
        }
    }
}

fn range(param: &Param, found: &mut Vec<Diagnostic>) {
    if let (Some(min), Some(max)) = (param.min, param.max)
        && min >= max
    {
        found.push(Diagnostic::error("spec-empty-range", param.place.clone()).arg("min", min).arg("max", max));
    }
    let numeric = !matches!(param.kind, ParameterKind::Text | ParameterKind::AxisDirection | ParameterKind::Axis);
    if !numeric && (param.min.is_some() || param.max.is_some()) {
        found.push(Diagnostic::error("spec-range-of-text", param.place.clone()).arg("name", param.is.as_str()));
    }
}

fn choices(param: &Param, found: &mut Vec<Diagnostic>) {
    for (index, choice) in param.choices.iter().enumerate() {
        super::names::slug(&choice.choice, found);
        if let Some(first) = param.choices[..index].iter().find(|other| other.value == choice.value) {
            found.push(
                Diagnostic::error("spec-duplicate-choice", choice.value.place.clone())
                    .arg("value", choice.value.as_str())
                    .related("first-place", first.value.place.clone()),
            );
        }
        let open = choice.value.as_str().starts_with(['<', '>']);
        if !open && choice.value.as_str().parse::<i64>().is_err() {
            found.push(
                Diagnostic::error("spec-expected", choice.value.place.clone())
                    .arg("expected", "whole-number")
                    .arg("found", choice.value.as_str()),
            );
        }
    }
}

fn example(cycle: &Cycle, param: &Param, found: &mut Vec<Diagnostic>) {
    let Some(text) = &param.example else {
        // A cycle that is known from its use alone, or an optional field, may come without a value.
        let optional = param.field.as_ref().is_some_and(|field| field.optional);
        let printed = &cycle.file.nc_examples;
        if !optional && !printed.is_empty() && printed.iter().all(|example| example.values.0.is_empty()) {
            found.push(Diagnostic::warning("spec-no-example", param.place.clone()).arg("name", param.is.as_str()));
        }
        return;
    };
    if refusal(param, text).is_some() {
        found.push(
            Diagnostic::error("spec-example-out-of-range", param.place.clone())
                .arg("name", param.is.as_str())
                .arg("value", text.as_str()),
        );
    }
}

pub(super) fn lines(cycle: &Cycle, on: &OnControl, found: &mut Vec<Diagnostic>) {
    super::names::duplicates(cycle.file.forms.iter().map(|form| &form.form), found);
    for form in 0..cycle.file.forms.len() {
        super::names::duplicates(cycle.fields(form).map(|(_, field)| &field.id), found);
    }
    let model = cycle.file.like.as_ref().and_then(|like| on.by_name(like.as_str()));
    for (param, field) in cycle.params.iter().filter_map(|param| param.field.as_ref().map(|field| (param, field))) {
        super::names::slug(&field.id, found);
        if (field.shape == Shape::Word) != field.word.is_some() {
            found.push(Diagnostic::error("spec-word-shape", param.place.clone()).arg("name", field.id.as_str()));
        }
        if let (Some(q), Some(model)) = (field.stands_for, model)
            && model.param(q).is_none()
            && !model.file.results.iter().any(|result| result.q == Some(q))
        {
            found.push(
                Diagnostic::error("spec-unknown-parameter", param.place.clone())
                    .arg("name", q.to_string())
                    .arg("cycle", model.key.to_string()),
            );
        }
    }
}
