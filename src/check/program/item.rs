//! A parameter or field of a definition as it is written, with its specification.
use std::borrow::Cow;

use crate::base::diag::Span;
use crate::base::expr::QRef;
use crate::program::syntax::Value;
use crate::spec::{Cycle, Param, Refusal};

/// A parameter or field as written.
pub struct Item<'a> {
    /// Its specification, if the cycle is described and has it.
    pub param: Option<&'a Param>,
    /// How messages call it: `Q200`, `31.2 HEIGHT:`.
    pub name: Cow<'a, str>,
    /// All of it up to the end of the value.
    pub span: Span,
    /// The value's place.
    pub value_span: Span,
    /// The value in capitals as the specification's examples are written: `+60`, `X+60`, `#5`, `"AB"`.
    pub printed: Cow<'a, str>,
    /// The value, if it is a single one.
    pub value: Option<Value>,
    /// The number that the parameter written for it certainly has.
    pub number: Option<f64>,
    /// The printed label, or the printed word of an old-style field.
    pub label: Option<Span>,
    /// The place of its specification among the cycle's parameters.
    pub index: Option<usize>,
    /// Why its parameter refuses the value.
    pub(in crate::check) refusal: Option<Refusal>,
}

/// Finds parameters in a cycle; most are written in its order.
#[derive(Default)]
pub(in crate::check) struct Place {
    next: usize,
}

impl Place {
    /// The place of the parameter among those of the cycle.
    pub(in crate::check) fn of(&mut self, cycle: &Cycle, q: QRef) -> Option<usize> {
        let is_next = cycle.params.get(self.next).is_some_and(|param| param.q == Some(q));
        let found = if is_next { Some(self.next) } else { cycle.place_of(q) };
        self.next = found.map_or(self.next, |at| at + 1);
        found
    }
}

/// A text in capitals.
pub(in crate::check) fn capitals(text: &str) -> Cow<'_, str> {
    let is_capital = |byte: &u8| byte.is_ascii() && !byte.is_ascii_lowercase();
    if text.as_bytes().iter().all(is_capital) { Cow::Borrowed(text) } else { Cow::Owned(text.to_uppercase()) }
}

/// The place of a parameter in its cycle.
pub(in crate::check) fn index_of(cycle: Option<&Cycle>, param: Option<&Param>) -> Option<usize> {
    cycle?
        .params
        .iter()
        .zip(0..)
        .find(|(own, _)| param.is_some_and(|param| std::ptr::eq(*own, param)))
        .map(|(_, at)| at)
}
