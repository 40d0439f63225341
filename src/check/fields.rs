//! Old-style lines against the forms of a specification: which word is which field.
//!
//! Fields are known by their line, their shape and their order, never by the printed word, which is
//! another one in each language. Invariant: every written word is an item of the result.
use std::borrow::Cow;

use super::facts::{Item, index_of};
use super::labels::fold;
use crate::diag::Span;
use crate::spec::{Cycle, Field, Param, Shape};
use crate::syntax::{Axis, OldCycleLine, OldWord, Program, ValueKind};

/// A definition of the old form with its fields found.
pub(super) struct Matched<'a> {
    /// The words, in the order written.
    pub(super) items: Vec<Item<'a>>,
    /// Fields that must be there and are not.
    pub(super) missing: Vec<&'a Param>,
    /// Words that are no field.
    strange: usize,
}

/// Reads the lines by the form that fits them best.
pub(super) fn matching<'a>(program: &'a Program, cycle: &'a Cycle, lines: &[&'a OldCycleLine]) -> Matched<'a> {
    let forms = (0..cycle.file.forms.len()).map(|form| by_form(program, cycle, form, lines));
    let best = forms.min_by_key(|matched| matched.strange + matched.missing.len());
    // A cycle without lines has no field that a word could be, and lacks all its parameters.
    best.unwrap_or_else(|| {
        let unread = by_form(program, cycle, usize::MAX, lines);
        Matched { missing: cycle.params.iter().collect(), ..unread }
    })
}

fn by_form<'a>(program: &'a Program, cycle: &'a Cycle, form: usize, lines: &[&'a OldCycleLine]) -> Matched<'a> {
    let fields: Vec<(&Param, &Field)> = cycle.fields(form).collect();
    let mut matched = Matched { items: Vec::new(), missing: Vec::new(), strange: 0 };
    let mut found: Vec<&Param> = Vec::new();
    for line in lines {
        let belongs = |field: &Field| field.line == line.line || (field.repeat && line.line > field.line);
        let mut open: Vec<(&Param, &Field)> = fields.iter().copied().filter(|(_, field)| belongs(field)).collect();
        let mut words = line.words.as_slice();
        while let Some(word) = words.first() {
            let fitting = open.iter().position(|(_, field)| width(program, field, words) > 0);
            let (param, count) = match fitting {
                Some(at) => {
                    let (param, field) = open[at];
                    // Fields stand in their order: what was passed over is not written.
                    open.drain(..=at);
                    found.push(param);
                    (Some((param, field)), width(program, field, words))
                }
                None => {
                    matched.strange += 1;
                    (None, 1)
                }
            };
            let (own, rest) = words.split_at(count.min(words.len()));
            matched.items.push(item(program, cycle, line, own, word, param));
            words = rest;
        }
    }
    let is_missing =
        |param: &Param, field: &Field| !field.optional && !found.iter().any(|own| std::ptr::eq(*own, param));
    matched.missing =
        fields.iter().filter(|(param, field)| is_missing(param, field)).map(|(param, _)| *param).collect();
    matched
}

/// How many of the words make up the field: 0 if the first one does not.
fn width(program: &Program, field: &Field, words: &[OldWord]) -> usize {
    let Some(word) = words.first() else { return 0 };
    let name = program.slice(word.name);
    let fits = match field.shape {
        Shape::Row => name == "#",
        Shape::Q => name.is_empty() && matches!(word.value.kind, ValueKind::Q { negative: false, .. }),
        Shape::AxisDirection => is_axis(name, false) && matches!(word.value.kind, ValueKind::Sign(_)),
        Shape::AxisCoordinate => is_coordinate(program, word, field.incremental),
        Shape::Position => {
            return words.iter().take_while(|word| is_coordinate(program, word, field.incremental)).count();
        }
        Shape::Word => {
            let own = field.word.as_deref().unwrap_or_default();
            let plain = name.strip_prefix(['I', 'i']).filter(|_| field.incremental);
            name.eq_ignore_ascii_case(own) || plain.is_some_and(|plain| plain.eq_ignore_ascii_case(own))
        }
        Shape::Labelled => name.ends_with(':'),
    };
    usize::from(fits)
}

fn is_axis(name: &str, incremental: bool) -> bool {
    let upper = name.to_ascii_uppercase();
    let name = if incremental { upper.strip_prefix('I').unwrap_or(&upper) } else { &upper };
    name.len() == 1 && Axis::by_name(name.as_bytes()).is_some()
}

fn is_coordinate(program: &Program, word: &OldWord, incremental: bool) -> bool {
    let valued = matches!(word.value.kind, ValueKind::Number(_) | ValueKind::Q { .. });
    valued && is_axis(program.slice(word.name), incremental)
}

fn item<'a>(
    program: &'a Program,
    cycle: &Cycle,
    line: &OldCycleLine,
    words: &'a [OldWord],
    first: &OldWord,
    param: Option<(&'a Param, &'a Field)>,
) -> Item<'a> {
    let last = words.last().unwrap_or(first);
    let span = Span::new(first.span.start, last.span.end);
    let name = program.slice(first.name);
    let shape = param.map(|(_, field)| field.shape);
    let value = program.slice(first.value.span);
    let printed = match shape {
        Some(Shape::Row) => format!("#{value}"),
        Some(Shape::Position | Shape::AxisDirection | Shape::AxisCoordinate) => {
            let closed = |word: &OldWord| format!("{}{}", program.slice(word.name), program.slice(word.value.span));
            words.iter().map(closed).collect::<Vec<_>>().join(" ")
        }
        Some(Shape::Word) if name.starts_with(['I', 'i']) => format!("I{value}"),
        _ => value.to_owned(),
    };
    let label = (shape == Some(Shape::Labelled)).then_some(first.name);
    Item {
        index: index_of(Some(cycle), param.map(|(param, _)| param)),
        folded: label.map(|label| fold(program.slice(label))),
        param: param.map(|(param, _)| param),
        name: Cow::Owned(format!("{}.{} {name}", line.number, line.line).trim_end().to_owned()),
        span,
        value_span: if words.len() == 1 && first.value.span.start < first.value.span.end {
            first.value.span
        } else {
            span
        },
        printed: printed.to_uppercase(),
        value: (words.len() == 1).then_some(first.value),
        label,
        refusal: None,
    }
}
