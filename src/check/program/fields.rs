//! Old-style lines against the forms of a specification: which word is which field.
//!
//! Fields are known by their line, their shape and their order, never by the printed word, which is
//! another one in each language. Invariant: every written word is an item of the result.
use std::borrow::Cow;

use super::item::{Item, capitals, index_of};
use crate::base::diag::Span;
use crate::program::fields::{first, stands_on};
use crate::program::syntax::{NamedWord, OldCycleLine, Program, ValueKind};
use crate::spec::{Cycle, Field, Param, Shape};

/// A field with the parameter that it writes.
type Written<'a> = (&'a Param, &'a Field);

/// Which words are which fields of a form.
struct Fit<'a> {
    /// The words of each field, with it and their line.
    words: Vec<(&'a OldCycleLine, &'a [NamedWord], Option<Written<'a>>)>,
    missing: Vec<&'a Param>,
    /// Words that are no field.
    strange: usize,
}

/// Reads the lines by the form that fits them best.
///
/// Hands over the words, in the order written, and returns the fields that must be there and are not.
pub(in crate::check) fn matching<'a>(
    program: &'a Program,
    cycle: &'a Cycle,
    lines: &[&'a OldCycleLine],
    items: &mut Vec<Item<'a>>,
) -> Vec<&'a Param> {
    let mut best: Option<Fit<'_>> = None;
    for form in 0..cycle.file.forms.len() {
        let fit = by_form(program, cycle, form, lines);
        let misses = |fit: &Fit<'_>| fit.strange + fit.missing.len();
        if best.as_ref().is_none_or(|best| misses(&fit) < misses(best)) {
            best = Some(fit);
        }
        // Most definitions are written by the first form, to which nothing is strange.
        if best.as_ref().is_some_and(|best| misses(best) == 0) {
            break;
        }
    }
    // A cycle without lines has no field that a word could be, and lacks all its parameters.
    let best = best.unwrap_or_else(|| {
        let unread = by_form(program, cycle, usize::MAX, lines);
        Fit { missing: cycle.params.iter().collect(), ..unread }
    });
    items.extend(best.words.into_iter().filter_map(|(line, words, param)| item(program, cycle, line, words, param)));
    best.missing
}

fn by_form<'a>(program: &'a Program, cycle: &'a Cycle, form: usize, lines: &[&'a OldCycleLine]) -> Fit<'a> {
    let fields: Vec<Written<'_>> = cycle.fields(form).collect();
    let count = lines.iter().map(|line| line.words.len()).sum();
    let mut fit = Fit { words: Vec::with_capacity(count), missing: Vec::new(), strange: 0 };
    // The fields that a line may still have, and those that were found, by their order.
    let (mut open, mut found) = (Vec::with_capacity(fields.len()), vec![false; fields.len()]);
    for line in lines {
        open.clear();
        open.extend((0..fields.len()).filter(|place| stands_on(fields[*place].1, line)));
        let mut words = line.words.as_slice();
        while !words.is_empty() {
            let (place, count) = match first(program, open.iter().map(|place| fields[*place].1), words) {
                Some((at, count)) => (open.drain(..=at).next_back(), count),
                None if is_bare(program, open.iter().map(|place| fields[*place].1), line) => (open.pop(), 1),
                None => {
                    fit.strange += 1;
                    (None, 1)
                }
            };
            let (own, rest) = words.split_at(count.min(words.len()));
            if let Some(place) = place {
                found[place] = true;
            }
            fit.words.push((line, own, place.map(|place| fields[place])));
            words = rest;
        }
    }
    let lacking = fields.iter().zip(found).filter(|((_, field), found)| !found && !field.optional);
    fit.missing = lacking.map(|((param, _), _)| *param).collect();
    fit
}

/// Whether a line has nothing but a value, and can only have one, after a word that is printed:
/// what it means is clear.
fn is_bare<'f>(program: &Program, mut open: impl Iterator<Item = &'f Field>, line: &OldCycleLine) -> bool {
    let (Some(field), None, [word]) = (open.next(), open.next(), line.words.as_slice()) else { return false };
    let number = matches!(word.value.kind, ValueKind::Number(_) | ValueKind::Q { .. });
    field.shape == Shape::Labelled && number && program.slice(word.name).is_empty()
}

/// A text in capitals; most have no other letters than those of ASCII.
fn in_capitals(mut text: String) -> String {
    if !text.is_ascii() {
        return text.to_uppercase();
    }
    text.make_ascii_uppercase();
    text
}

/// A field as messages call it: `7.1 X`.
fn name_of(line: &OldCycleLine, word: &str) -> String {
    let mut name = String::with_capacity(8 + word.len());
    for (part, mark) in [(line.number, "."), (line.line, " ")] {
        match part {
            0..=9 => name.extend(char::from_digit(part, 10)),
            _ => name.push_str(&part.to_string()),
        }
        name.push_str(mark);
    }
    name.push_str(word);
    name.truncate(name.trim_end().len());
    name
}

fn item<'a>(
    program: &'a Program,
    cycle: &Cycle,
    line: &OldCycleLine,
    words: &'a [NamedWord],
    param: Option<Written<'a>>,
) -> Option<Item<'a>> {
    let (first, last) = words.first().zip(words.last())?;
    let span = Span::new(first.span.start, last.span.end);
    let name = program.slice(first.name);
    let shape = param.map(|(_, field)| field.shape);
    // `X + 5` is `X+5`.
    let closed_up = |text: &str| text.split_ascii_whitespace().collect::<String>();
    let value = program.slice(first.value.span);
    let printed = match shape {
        Some(Shape::Row) => Cow::Owned(format!("#{value}").to_uppercase()),
        Some(Shape::Position | Shape::AxisDirection | Shape::AxisCoordinate)
            if words.len() == 1 && first.name.end == first.value.span.start && !value.contains(char::is_whitespace) =>
        {
            capitals(program.slice(Span::new(first.name.start, first.value.span.end)))
        }
        Some(Shape::Position | Shape::AxisDirection | Shape::AxisCoordinate | Shape::Axes | Shape::Centre) => {
            let mut closed = String::with_capacity(span.end - span.start + words.len());
            for word in words {
                closed.push_str(if closed.is_empty() { "" } else { " " });
                closed.push_str(program.slice(word.name));
                closed.extend(program.slice(word.value.span).split_ascii_whitespace());
            }
            Cow::Owned(in_capitals(closed))
        }
        Some(Shape::Word) if name.starts_with(['I', 'i']) => Cow::Owned(format!("I{value}").to_uppercase()),
        _ if value.contains('/') && !value.contains('"') => Cow::Owned(closed_up(value).to_uppercase()),
        _ => capitals(value),
    };
    let label = (shape == Some(Shape::Labelled) && !name.is_empty()).then_some(first.name);
    Some(Item {
        index: index_of(Some(cycle), param.map(|(param, _)| param)),
        param: param.map(|(param, _)| param),
        name: Cow::Owned(name_of(line, name)),
        span,
        value_span: if words.len() == 1 && first.value.span.start < first.value.span.end {
            first.value.span
        } else {
            span
        },
        printed,
        value: (words.len() == 1 && shape != Some(Shape::Axes)).then_some(first.value),
        number: None,
        label,
        refusal: None,
    })
}
