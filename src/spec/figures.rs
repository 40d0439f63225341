//! Which parameters the figures of a cycle show, and which they could.
use super::catalogue::{Cycle, OnControl, Param};
use super::figure_form::{Dimension, Figure};
use super::vocabulary::{ParameterKind, Quantity};

/// The dimensions of a figure with those of the fragments that it uses; of these, only the ones whose parameters the
/// cycle has and the figure does not show itself.
pub fn dimensions<'c>(on: &'c OnControl, cycle: &Cycle, figure: &'c Figure) -> Vec<&'c Dimension> {
    let mut all = Vec::new();
    for dimension in &figure.dimensions {
        let Some(used) = &dimension.r#use else {
            all.push(dimension);
            continue;
        };
        let shared = on.fragments.get(used.as_str()).map_or(&[][..], |fragment| &fragment.dimensions);
        let own = |shared: &Dimension| figure.dimensions.iter().any(|own| own.r#use.is_none() && own.q == shared.q);
        let has = |shared: &&Dimension| shared.q.is_some_and(|q| cycle.param(q).is_some()) && !own(shared);
        all.extend(shared.iter().filter(has));
    }
    all
}

/// The lengths, angles and positions of a cycle.
pub fn measurable(cycle: &Cycle) -> impl Iterator<Item = &Param> {
    cycle.params.iter().filter(|param| {
        matches!(param.kind, ParameterKind::Number | ParameterKind::Position)
            && matches!(param.quantity, Quantity::Length | Quantity::Angle)
    })
}

/// Those that no figure shows and for which the specification gives no reason.
pub fn not_in_figures<'c>(on: &OnControl, cycle: &'c Cycle) -> Vec<&'c Param> {
    let figures = &cycle.file.figures;
    let shown: Vec<&Dimension> = figures.iter().flat_map(|figure| dimensions(on, cycle, figure)).collect();
    let is_it =
        |param: &Param, q: Option<crate::base::expr::QRef>, field: Option<&super::decode::Name>| match &param.field {
            None => q.is_some() && q == param.q,
            Some(own) => field.is_some_and(|field| field.as_str() == own.id.as_str()),
        };
    measurable(cycle)
        .filter(|param| {
            let of_choice = figures.iter().any(|figure| figure.each.is_some() && figure.each == param.q);
            let excused = cycle.file.not_shown.iter().any(|own| is_it(param, own.q, own.field.as_ref()));
            let drawn = shown.iter().any(|own| is_it(param, own.q, own.field.as_ref()));
            !(of_choice || excused || drawn)
        })
        .collect()
}
