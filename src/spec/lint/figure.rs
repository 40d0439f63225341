//! Figures name what exists, and a cycle that has figures shows all its lengths, angles and positions in them.
use super::super::catalogue::{Cycle, OnControl};
use super::super::figures::not_in_figures;
use super::names::{duplicates, slug};
use crate::base::diag::{Diagnostic, Place};
use crate::base::expr::QRef;

pub(super) fn figures(cycle: &Cycle, on: &OnControl, found: &mut Vec<Diagnostic>) {
    let figures = &cycle.file.figures;
    // Several may be one row, if the choices need different examples.
    duplicates(figures.iter().filter(|figure| figure.each.is_none()).map(|figure| &figure.name), found);
    for figure in figures.iter() {
        slug(&figure.name, found);
        parameter(cycle, figure.each, &figure.place, found);
        for (name, _) in &figure.given.0 {
            super::example::named(cycle, name, found);
        }
        for dimension in &figure.dimensions {
            parameter(cycle, dimension.q, &dimension.place, found);
            dimension.field.iter().for_each(|field| super::example::named(cycle, field, found));
            if let Some(used) = dimension.r#use.as_ref().filter(|used| on.fragments.get(used.as_str()).is_none()) {
                found.push(Diagnostic::error("spec-unknown-fragment", used.place.clone()).arg("name", used.as_str()));
            }
        }
    }
    for reason in cycle.file.not_shown.iter() {
        parameter(cycle, reason.q, &reason.place, found);
        reason.field.iter().for_each(|field| super::example::named(cycle, field, found));
    }
    if !figures.is_empty() {
        found.extend(not_in_figures(on, cycle).into_iter().map(|param| {
            let diagnostic = Diagnostic::error("figure-parameter-not-shown", param.place.clone());
            diagnostic.arg("name", param.label_in(cycle.key.number)).arg("cycle", cycle.key.to_string())
        }));
    }
}

fn parameter(cycle: &Cycle, q: Option<QRef>, place: &Place, found: &mut Vec<Diagnostic>) {
    if let Some(q) = q.filter(|q| cycle.param(*q).is_none()) {
        let unknown = Diagnostic::error("spec-unknown-parameter", place.clone());
        found.push(unknown.arg("name", q.to_string()).arg("cycle", cycle.key.to_string()));
    }
}
