//! Cycles of the old form: their fields as words of DIN/ISO, and the words as fields.
//!
//! Invariant: which word is which field is in the specification; nothing here knows a cycle.
use super::codes::{Coded, Codes};
use super::lower::{Lowering, Written};
use super::words::{AXES, PLAIN, Words};
use crate::base::diag::Span;
use crate::program::fields;
use crate::program::syntax::{Block, NamedWord, OldCycleLine, Program, Value, ValueKind};
use crate::spec::{CycleKey, Field, IsoWord, Param, ParameterKind, Shape};

/// What is written before a value where no language has been chosen for its word.
const NO_LABEL: &str = "VALUE:";

/// Writes the lines of a form.
pub(super) fn lower(
    lowering: &mut Lowering<'_, '_>,
    block: &Block,
    words: &mut Words<'_>,
    coded: Coded<'_>,
    form: usize,
) -> Written {
    let key = coded.cycle.key;
    words.take("G");
    let lines = coded.cycle.file.forms.get(form).map_or(&[][..], |form| form.lines.as_slice());
    for line in lines {
        let fields: Vec<(&Param, &Field)> =
            coded.cycle.fields(form).filter(|(_, field)| field.line == line.line).collect();
        let mut number = line.line;
        loop {
            let start = lowering.out.text.len();
            lowering.begin(block);
            lowering.out.put(&format!("{key}.{number}"));
            if number == 0
                && let Some(name) = lowering.labels.and_then(|labels| labels.name(key))
            {
                lowering.out.put(&format!(" {name}"));
            }
            let mut count = 0;
            for (param, field) in &fields {
                let word = coded.words.iter().find(|word| word.field.as_str() == field.id.as_str());
                let Some(word) = word else { continue };
                count += self::field(lowering, words, key, (param, field), word, line.repeat);
            }
            // A form with nothing to enter has its first line all the same.
            if count == 0 && number > 1 {
                lowering.unwrite(start);
                break;
            }
            lowering.end();
            if !line.repeat || count == 0 {
                break;
            }
            number += 1;
        }
    }
    words.take("G");
    lowering.modal(words);
    Ok(())
}

/// Writes one field; how many words it took.
fn field(
    lowering: &mut Lowering<'_, '_>,
    words: &mut Words<'_>,
    key: CycleKey,
    (param, field): (&Param, &Field),
    word: &IsoWord,
    one: bool,
) -> usize {
    let Some(name) = &word.word else {
        return match field.shape {
            Shape::Axes => axes(lowering, words),
            _ => lowering.values(words, &PLAIN, if one { 1 } else { usize::MAX }, field.incremental),
        };
    };
    let Some(first) = words.take(name) else { return 0 };
    match field.shape {
        Shape::Labelled => {
            let label = lowering.labels.and_then(|labels| labels.field(key, field));
            lowering.out.put(&format!(" {} ", label.as_deref().unwrap_or(NO_LABEL)));
        }
        Shape::Word => {
            let incremental = field.incremental && !lowering.absolute_in(words);
            lowering.out.put(if incremental { " I" } else { " " });
            lowering.out.put(field.word.as_deref().unwrap_or_default());
        }
        Shape::Row => lowering.out.put(" #"),
        Shape::Q if matches!(first.value.kind, ValueKind::Number(_)) => lowering.out.put(" Q"),
        _ => lowering.out.put(" "),
    }
    lowering.out.copy(first.value.span);
    let list = param.kind == ParameterKind::LabelList;
    if !(list || field.shape == Shape::Position) {
        return 1;
    }
    let mut count = 1;
    let digits = name.trim_start_matches('P');
    for number in digits.parse::<u32>().unwrap_or(1) + 1.. {
        let Some(next) = words.take(&format!("P{number:02}")) else { break };
        lowering.out.put(if list { "/" } else { " " });
        lowering.out.copy(next.value.span);
        count += 1;
    }
    count
}

fn axes(lowering: &mut Lowering<'_, '_>, words: &mut Words<'_>) -> usize {
    let mut count = 0;
    for name in AXES {
        let Some(word) = words.find(name).filter(|word| word.value.kind == ValueKind::Missing) else { continue };
        words.take(name);
        lowering.out.put(" ");
        lowering.out.copy(word.span);
        count += 1;
    }
    count
}

/// A field with the words that it is written with.
struct Filled<'c> {
    param: &'c Param,
    field: &'c Field,
    words: Vec<NamedWord>,
}

/// The DIN/ISO block of a definition in the old form, without its number; the place of what DIN/ISO has no word for.
pub(super) fn raise(
    program: &Program,
    lines: &[&OldCycleLine],
    codes: &Codes<'_>,
    key: CycleKey,
    explicit: bool,
) -> Result<String, Span> {
    let whole = lines.first().map_or(Span::new(0, 0), |line| line.head);
    for (code, coded) in codes.forms(key) {
        if let Some(filled) = coded.form.and_then(|form| filled(program, lines, coded, form)) {
            return write(program, code, coded, &filled, explicit);
        }
    }
    Err(whole)
}

/// The fields of a form, if all that is written are fields of it.
fn filled<'c>(program: &Program, lines: &[&OldCycleLine], coded: Coded<'c>, form: usize) -> Option<Vec<Filled<'c>>> {
    let all: Vec<(&Param, &Field)> = coded.cycle.fields(form).collect();
    let mut found: Vec<Filled<'c>> = Vec::new();
    for line in lines {
        let own: Vec<_> = all.iter().filter(|(_, field)| fields::stands_on(field, line)).collect();
        let (mut rest, mut from) = (line.words.as_slice(), 0);
        while !rest.is_empty() {
            let left = own.get(from..)?;
            let (at, count) = fields::first(program, left.iter().map(|(_, field)| *field), rest)?;
            let (param, field) = left.get(at)?;
            found.push(Filled { param, field, words: rest.get(..count)?.to_vec() });
            rest = rest.get(count..)?;
            from += at + 1;
        }
    }
    Some(found)
}

fn write(
    program: &Program,
    code: &str,
    coded: Coded<'_>,
    filled: &[Filled<'_>],
    explicit: bool,
) -> Result<String, Span> {
    let known = |own: &Filled<'_>| coded.words.iter().any(|word| word.field.as_str() == own.field.id.as_str());
    if let Some(strange) = filled.iter().find(|own| !known(own)) {
        return Err(strange.words.first().map_or(Span::new(0, 0), |word| word.span));
    }
    let mut out = code.to_owned();
    for word in coded.words {
        let own = filled.iter().filter(|own| own.field.id.as_str() == word.field.as_str());
        for filled in own {
            entry(program, word, filled, explicit, &mut out)?;
        }
    }
    Ok(out)
}

fn entry(program: &Program, word: &IsoWord, own: &Filled<'_>, explicit: bool, out: &mut String) -> Result<(), Span> {
    let text = |span: Span| program.slice(span);
    let Some(name) = &word.word else {
        for own in &own.words {
            coordinate(text(own.span), explicit, out);
        }
        return Ok(());
    };
    let Some(first) = own.words.first() else { return Ok(()) };
    let value = text(first.value.span);
    match own.field.shape {
        Shape::Position => {
            let digits = name.trim_start_matches('P').parse::<u32>().unwrap_or(1);
            for (own, number) in own.words.iter().zip(digits..) {
                out.push_str(&format!(" P{number:02} {}", text(own.span)));
            }
            return Ok(());
        }
        Shape::AxisDirection => out.push_str(&format!(" {name} {}", text(first.span))),
        Shape::Q => out.push_str(&format!(" {name} {}", value.trim_start_matches(['Q', 'q']))),
        Shape::Word => {
            let incremental = own.field.incremental && text(first.name).starts_with(['I', 'i']);
            out.push_str(match (incremental, explicit && own.field.incremental) {
                (true, _) => " G91",
                (_, true) => " G90",
                _ => "",
            });
            out.push_str(&format!(" {}", joined(name, value)));
        }
        _ if own.param.kind == ParameterKind::LabelList => {
            for (label, number) in
                value.split('/').map(|label| label.trim_matches(|c: char| c.is_whitespace() || c == '~')).zip(1..)
            {
                out.push_str(&format!(" P{number:02} {label}"));
            }
        }
        _ if is_entry(first.value, value) => out.push_str(&format!(" {}", joined(name, value))),
        _ => return Err(first.span),
    }
    Ok(())
}

/// `F1.5`, but `P01 12`.
fn joined(name: &str, value: &str) -> String {
    if name.len() > 1 { format!("{name} {value}") } else { format!("{name}{value}") }
}

/// Whether a value can follow a word of DIN/ISO: a number, a text, a path.
fn is_entry(value: Value, text: &str) -> bool {
    !matches!(value.kind, ValueKind::Word) || text.starts_with(|c: char| c.is_ascii_alphabetic())
}

/// A coordinate of Klartext with the code that says what it counts from.
pub(super) fn coordinate(written: &str, explicit: bool, out: &mut String) {
    let absolute = written.strip_prefix(['I', 'i']);
    out.push_str(match (absolute, explicit) {
        (Some(_), _) => " G91",
        (None, true) => " G90",
        (None, false) => "",
    });
    out.push(' ');
    out.push_str(absolute.unwrap_or(written));
}
