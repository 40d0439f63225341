//! NC examples and conformance cases name what exists.
use super::super::catalogue::Cycle;
use super::super::decode::Name;
use super::super::value::refusal;
use crate::base::diag::Diagnostic;
use crate::base::expr::QRef;

pub(super) fn examples(cycle: &Cycle, found: &mut Vec<Diagnostic>) {
    for example in &cycle.file.nc_examples {
        form_exists(cycle, example.form.as_ref(), found);
        for (name, value) in &example.values.0 {
            value_fits(cycle, name, value, found);
        }
        example.without.iter().for_each(|name| named(cycle, name, found));
    }
    super::names::duplicates(cycle.file.examples.iter().map(|example| &example.name), found);
    for example in cycle.file.examples.iter() {
        super::names::slug(&example.name, found);
        form_exists(cycle, example.form.as_ref(), found);
        // Conformance cases may give wrong values on purpose, so only the names are checked.
        example.given.0.iter().for_each(|(name, _)| named(cycle, name, found));
        if example.skip.is_none() && (example.scene.is_none() || example.expect.is_none()) {
            found.push(
                Diagnostic::error("spec-case-incomplete", example.name.place.clone())
                    .arg("name", example.name.as_str()),
            );
        }
        if example.proves.is_empty() {
            found.push(
                Diagnostic::error("spec-case-proves-nothing", example.name.place.clone())
                    .arg("name", example.name.as_str()),
            );
        }
    }
}

fn form_exists(cycle: &Cycle, form: Option<&Name>, found: &mut Vec<Diagnostic>) {
    if let Some(form) = form
        && !cycle.file.forms.iter().any(|known| known.form == *form)
    {
        found.push(Diagnostic::error("spec-unknown-form", form.place.clone()).arg("name", form.as_str()));
    }
}

pub(super) fn named(cycle: &Cycle, name: &Name, found: &mut Vec<Diagnostic>) {
    if find(cycle, name.as_str()).is_none() {
        found.push(
            Diagnostic::error("spec-unknown-parameter", name.place.clone())
                .arg("name", name.as_str())
                .arg("cycle", cycle.key.to_string()),
        );
    }
}

/// The parameter of a Q number or field id; a number after a repeated field's id (`shift-2`) is left off.
fn find<'c>(cycle: &'c Cycle, name: &str) -> Option<&'c super::super::catalogue::Param> {
    if let Some(q) = QRef::parse(name) {
        return cycle.param(q);
    }
    let is =
        |id: &str| cycle.params.iter().find(|param| param.field.as_ref().is_some_and(|field| field.id.as_str() == id));
    is(name).or_else(|| {
        let (id, turn) = name.rsplit_once('-')?;
        turn.parse::<u32>().ok()?;
        is(id)
    })
}

fn value_fits(cycle: &Cycle, name: &Name, value: &str, found: &mut Vec<Diagnostic>) {
    named(cycle, name, found);
    if let Some(param) = find(cycle, name.as_str())
        && refusal(param, value).is_some()
    {
        found.push(
            Diagnostic::error("spec-example-out-of-range", name.place.clone())
                .arg("name", param.is.as_str())
                .arg("value", value),
        );
    }
}
