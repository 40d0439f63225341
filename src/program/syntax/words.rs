//! Words with values, read against the vocabulary of their block.
//!
//! Invariant: of two names that fit, the longer one is meant (`P1X`, not `P1`), and a letter after a name that is no
//! parameter makes it another word.
use super::cursor::{Cursor, Read};
use super::terms::{Amount, NamedWord, Operand, Value, ValueKind};
use crate::base::diag::Span;

/// What is after a name.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Takes {
    /// Nothing.
    Nothing,
    /// A number or a parameter.
    Value,
    /// A number, perhaps with an exponent (`-0.413 E+2`), or a parameter.
    Exponent,
    /// A number or a parameter, or nothing.
    Maybe,
    /// A sign.
    Sign,
    /// A number, a parameter, a text or a name, also after `=`.
    Any,
}

/// The names that a block knows, in capitals, with what they take.
pub(super) type Vocabulary = &'static [(&'static str, Takes)];

/// A word of the vocabulary, if one is here.
pub(super) fn opt_named(cursor: &mut Cursor<'_>, vocabulary: &[Vocabulary]) -> Read<Option<NamedWord>> {
    cursor.blanks();
    let start = cursor.at;
    let rest = cursor.bytes.get(start..cursor.end).unwrap_or_default();
    let mut best: Option<(usize, Takes)> = None;
    for &(name, takes) in vocabulary.iter().copied().flatten() {
        let length = name.len();
        let begins = rest.get(..length).is_some_and(|written| written.eq_ignore_ascii_case(name.as_bytes()));
        if begins && best.is_none_or(|(longest, _)| longest < length) && ends_word(cursor, start + length, name, takes)
        {
            best = Some((length, takes));
        }
    }
    let Some((length, takes)) = best else { return Ok(None) };
    let name = Span::new(start, start + length);
    cursor.at = name.end;
    let value = value(cursor, takes)?;
    Ok(Some(NamedWord { span: Span::new(start, value.span.end.max(name.end)), name, value }))
}

/// Whether a name may end at a byte.
fn ends_word(cursor: &Cursor<'_>, at: usize, name: &str, takes: Takes) -> bool {
    let mut ahead = Cursor { at, ..*cursor };
    let next = ahead.byte();
    if next.is_ascii_digit() {
        return takes != Takes::Nothing && !name.ends_with(|c: char| c.is_ascii_digit());
    }
    let letter = next.is_ascii_alphabetic() || next == b'_' || next >= 0x80;
    !letter || (takes != Takes::Nothing && ahead.opt_q().is_some()) || cursor.text.get(at..).is_some_and(is_blank_start)
}

fn is_blank_start(rest: &str) -> bool {
    rest.starts_with('\u{a0}')
}

fn value(cursor: &mut Cursor<'_>, takes: Takes) -> Read<Value> {
    let missing = Value { span: Span::new(cursor.at, cursor.at), kind: ValueKind::Missing };
    match takes {
        Takes::Nothing => Ok(missing),
        Takes::Value => {
            let _ = cursor.opt_mark(b':') || cursor.opt_mark(b'=');
            opt_value(cursor)?.ok_or_else(|| cursor.expected("value"))
        }
        Takes::Exponent => {
            let value = opt_value(cursor)?.ok_or_else(|| cursor.expected("value"))?;
            with_exponent(cursor, value)
        }
        Takes::Maybe => Ok(opt_value(cursor)?.unwrap_or(missing)),
        Takes::Sign => match sign(cursor) {
            Some(value) => Ok(value),
            None => Err(cursor.expected("sign")),
        },
        Takes::Any => {
            let _ = cursor.opt_mark(b'=') || cursor.opt_mark(b':');
            if let Some(value) = opt_value(cursor)? {
                return Ok(value);
            }
            let printed = printed(cursor);
            if printed.start == printed.end { Err(cursor.expected("name")) } else { Ok(word_value(cursor, printed)) }
        }
    }
}

/// A number with the exponent after it, if there is one.
fn with_exponent(cursor: &mut Cursor<'_>, value: Value) -> Read<Value> {
    let ValueKind::Number(number) = value.kind else { return Ok(value) };
    let mut ahead = *cursor;
    ahead.blanks();
    if !matches!(ahead.byte(), b'E' | b'e') {
        return Ok(value);
    }
    ahead.at += 1;
    let negative = ahead.byte() == b'-';
    ahead.at += usize::from(matches!(ahead.byte(), b'+' | b'-'));
    let Some(exponent) = ahead.opt_whole() else { return Err(ahead.expected("number")) };
    let sign = if negative { "-" } else { "" };
    // Read as one number, it is rounded once.
    let scaled = format!("{number}e{sign}{exponent}").parse::<f64>().ok().filter(|scaled| scaled.is_finite());
    let Some(scaled) = scaled else { return Err(cursor.expected("value")) };
    *cursor = ahead;
    Ok(Value { span: Span::new(value.span.start, ahead.at), kind: ValueKind::Number(scaled) })
}

fn sign(cursor: &mut Cursor<'_>) -> Option<Value> {
    cursor.blanks();
    let sign = cursor.byte();
    matches!(sign, b'+' | b'-').then(|| {
        cursor.at += 1;
        Value { span: Span::new(cursor.at - 1, cursor.at), kind: ValueKind::Sign(sign == b'-') }
    })
}

/// What is printed without a blank.
fn printed(cursor: &mut Cursor<'_>) -> Span {
    cursor.blanks();
    let start = cursor.at;
    let rest = cursor.bytes.get(start..cursor.end).unwrap_or_default();
    let ends = |b: &u8| matches!(b, b' ' | b'\t' | b'\r' | b'\n' | b'~' | b';' | b'"');
    Span::new(start, start + rest.iter().position(ends).unwrap_or(rest.len()))
}

/// The name of a file without quotation marks, if one is here: it has an extension or a folder.
pub(super) fn opt_file(cursor: &mut Cursor<'_>) -> Option<NamedWord> {
    let span = printed(cursor);
    let written = cursor.text.get(span.start..span.end).unwrap_or_default();
    let is_file = written.contains(['.', '\\', '/']);
    is_file.then(|| nameless(word_value(cursor, span)))
}

fn word_value(cursor: &mut Cursor<'_>, span: Span) -> Value {
    cursor.at = span.end;
    Value { span, kind: ValueKind::Word }
}

pub(super) fn from_operand(operand: Operand) -> Value {
    let kind = match operand.amount {
        Amount::Number(number) => ValueKind::Number(number),
        Amount::Q { negative, q } => ValueKind::Q { negative, q },
        Amount::Text(text) => ValueKind::Text(text),
    };
    Value { span: operand.span, kind }
}

/// A number, a parameter of any kind or a text, if one is here.
pub(super) fn opt_value(cursor: &mut Cursor<'_>) -> Read<Option<Value>> {
    if let Some(text) = cursor.opt_text()? {
        return Ok(Some(Value { span: Span::new(text.start - 1, text.end + 1), kind: ValueKind::Text(text) }));
    }
    Ok(cursor.opt_operand().map(from_operand))
}

/// A value without a name.
pub(super) fn nameless(value: Value) -> NamedWord {
    NamedWord { span: value.span, name: Span::new(value.span.start, value.span.start), value }
}

/// A word of a block whose vocabulary grows with every version of a control: letters, perhaps a colon, perhaps a value;
/// or a value alone.
pub(super) fn opt_free(cursor: &mut Cursor<'_>) -> Read<Option<NamedWord>> {
    if let Some(value) = opt_value(cursor)? {
        return Ok(Some(nameless(value)));
    }
    let start = cursor.at;
    let mut at = start;
    while cursor.byte_at(at).is_ascii_alphabetic()
        || (at > start && matches!(cursor.byte_at(at), b'-' | b'_') && cursor.byte_at(at + 1).is_ascii_alphabetic())
    {
        let q = Cursor { at, ..*cursor }.opt_q();
        if at > start && q.is_some() {
            break;
        }
        let signed_q = cursor.byte_at(at) == b'-' && Cursor { at: at + 1, ..*cursor }.opt_q().is_some();
        if signed_q {
            break;
        }
        at += 1;
    }
    if at == start {
        return Ok(None);
    }
    cursor.at = at;
    let labelled = cursor.opt_mark(b':');
    let name = Span::new(start, if labelled { cursor.at } else { at });
    cursor.at = name.end;
    let value = match opt_value(cursor)? {
        Some(value) => Some(value),
        None if labelled => {
            let printed = printed(cursor);
            Some(word_value(cursor, printed))
        }
        None => sign(cursor),
    };
    let value = value.unwrap_or(Value { span: Span::new(name.end, name.end), kind: ValueKind::Missing });
    if value.kind == ValueKind::Missing {
        cursor.at = name.end;
    }
    Ok(Some(NamedWord { span: Span::new(start, value.span.end.max(name.end)), name, value }))
}

/// Words of the vocabulary and no others, up to the end.
pub(super) fn closed(cursor: &mut Cursor<'_>, vocabulary: &[Vocabulary]) -> Read<Vec<NamedWord>> {
    let mut words = Vec::new();
    while !cursor.done() {
        match opt_named(cursor, vocabulary)? {
            Some(word) => words.push(word),
            None => return Err(cursor.expected("block-word")),
        }
    }
    Ok(words)
}

/// Words of the vocabulary and, between them, values and the marks `=` and `/`, up to the end.
pub(super) fn open(cursor: &mut Cursor<'_>, vocabulary: &[Vocabulary]) -> Read<Vec<NamedWord>> {
    let mut words = Vec::new();
    while !cursor.done() {
        if matches!(cursor.byte(), b'=' | b'/' | b',') {
            cursor.at += 1;
        } else if let Some(word) = opt_named(cursor, vocabulary)? {
            words.push(word);
        } else if let Some(value) = opt_value(cursor)? {
            words.push(nameless(value));
        } else {
            return Err(cursor.expected("block-word"));
        }
    }
    Ok(words)
}

/// Words of any name, values and marks, up to the end.
pub(super) fn free(cursor: &mut Cursor<'_>) -> Read<Vec<NamedWord>> {
    let mut words = Vec::new();
    while !cursor.done() {
        if matches!(cursor.byte(), b'=' | b'/' | b',' | b'#') {
            cursor.at += 1;
        } else if let Some(word) = opt_free(cursor)? {
            words.push(word);
        } else {
            return Err(cursor.expected("block-word"));
        }
    }
    Ok(words)
}
