//! The words of a block of DIN/ISO.
//!
//! Invariant: what a word means is not known here beyond what may follow its letter and number.
use super::cursor::{Cursor, Read, trim};
use super::iso::IsoBlock;
use super::motion;
use super::terms::{Axis, NamedWord, Parameter, Value, ValueKind};
use super::words::{from_operand, nameless, opt_value};
use crate::base::diag::Span;

/// D functions whose words are those of the language; of the others what is after the number
/// is kept as it is printed.
const WORDED: std::ops::RangeInclusive<u16> = 0..=14;
/// The code that gives a tool its length and radius.
const TOOL_DEFINITION: f64 = 99.0;
/// The first code that is the number of a cycle.
const FIRST_OF_CYCLES: u16 = 100;

/// Whether a block is written as in Klartext: its first word is a word, or it assigns a value.
pub(super) fn is_klartext(cursor: &Cursor<'_>) -> bool {
    let word = cursor.peek_name();
    let mut ahead = *cursor;
    if ahead.opt_q().is_some() || ahead.peek_word().is(b"QC") {
        return true;
    }
    let letters = word.as_bytes();
    letters.len() > 2 && !matches!(letters, b"FMAX" | b"FAUTO") || matches!(letters, b"IF" | b"FN")
}

/// One word, or a text in brackets.
pub(super) fn word(cursor: &mut Cursor<'_>, block: &mut IsoBlock) -> Read<()> {
    let start = cursor.at;
    if cursor.byte() == b'(' {
        let inside = cursor.text.get(start..cursor.end).unwrap_or_default();
        let length = inside.find(')').ok_or_else(|| cursor.expected("closing-bracket"))?;
        cursor.at = start + length + 1;
        block.remarks.push(Span::new(start, cursor.at));
        return Ok(());
    }
    if let Some(parameter) = opt_parameter(cursor)? {
        block.parameters.push(parameter);
        return Ok(());
    }
    if cursor.opt_mark(b',') {
        let value = from_operand(cursor.operand()?);
        block.words.push(NamedWord {
            span: Span::new(start, value.span.end),
            name: Span::new(start, start + 1),
            value,
        });
        return Ok(());
    }
    if cursor.opt_mark(b':') || ends_before_remark(cursor) {
        return Ok(());
    }
    let letters = cursor.peek_name();
    let name = |length: usize| Span::new(start, start + length);
    let length = match letters.as_bytes() {
        b"M" => {
            block.functions.extend(motion::opt_function(cursor)?);
            return Ok(());
        }
        b"G" => {
            cursor.at = start + 1;
            cursor.blanks();
            let value = code(cursor)?;
            block.words.push(NamedWord { span: Span::new(start, value.span.end), name: name(1), value });
            if let ValueKind::Number(number) = value.kind
                && number >= f64::from(FIRST_OF_CYCLES)
            {
                block.name = cycle_name(cursor);
            }
            return Ok(());
        }
        b"D" => {
            cursor.at = start + 1;
            let value = code(cursor)?;
            block.words.push(NamedWord { span: Span::new(start, value.span.end), name: name(1), value });
            let is_worded = |number: u16| WORDED.contains(&number) || matches!(number, 18 | 19 | 29);
            let worded = matches!(value.kind, ValueKind::Number(number) if is_worded(number as u16));
            cursor.opt_mark(b':');
            if !worded {
                cursor.blanks();
                let rest = cursor.rest();
                if rest.start < rest.end {
                    block.words.push(nameless(Value { span: rest, kind: ValueKind::Word }));
                }
            }
            return Ok(());
        }
        b"P" => {
            cursor.at = start + 1;
            let digits = cursor.opt_whole().ok_or_else(|| cursor.expected("number"))?;
            let name = Span::new(start, cursor.at);
            let value = if digits > 99 { None } else { entry(cursor)? };
            let value = value.ok_or_else(|| cursor.expected("value"))?;
            block.words.push(NamedWord { span: Span::new(start, value.span.end), name, value });
            return Ok(());
        }
        b"DR"
            if cursor.byte_at(start + 2) == b'2' && matches!(cursor.byte_at(start + 3), b'+' | b'-' | b'Q' | b'q') =>
        {
            3
        }
        b"DL" | b"DR" | b"ID" | b"NR" => 2,
        b"IDX" => 3,
        b"FMAX" | b"FAUTO" => 1,
        b"PAT" => {
            cursor.at = start + 3;
            let value = Value { span: name(3), kind: ValueKind::Word };
            block.words.push(nameless(value));
            return Ok(());
        }
        [
            b'A' | b'B' | b'C' | b'E' | b'F' | b'H' | b'I' | b'J' | b'K' | b'L' | b'R' | b'S' | b'T' | b'U' | b'V'
            | b'W' | b'X' | b'Y' | b'Z',
        ] => 1,
        _ => {
            // A value alone: the parameter that a D function sets, a name.
            return match opt_value(cursor)? {
                Some(value) => {
                    block.words.push(nameless(value));
                    Ok(())
                }
                None => Err(cursor.expected("word")),
            };
        }
    };
    cursor.at = start + length;
    // After a label a comma is no decimal sign: `L1,0`. After G99 it is a length.
    let defines = |word: &NamedWord| {
        cursor.byte_at(word.name.start).eq_ignore_ascii_case(&b'G')
            && word.value.kind == ValueKind::Number(TOOL_DEFINITION)
    };
    let calls = letters.is(b"L") && !block.words.iter().any(defines);
    let read = if calls { label(cursor)? } else { opt_value(cursor)? };
    let value = match read {
        Some(value) => value,
        None => bare(cursor, letters.as_bytes())?,
    };
    // No value follows its letter directly.
    let nothing = Value { span: Span::new(start + length, start + length), ..value };
    let value = if value.kind == ValueKind::Missing { nothing } else { value };
    let end = value.span.end;
    block.words.push(NamedWord { span: Span::new(start, end), name: name(length), value });
    Ok(())
}

/// Passes the `*` that ends a block before a text in brackets.
fn ends_before_remark(cursor: &mut Cursor<'_>) -> bool {
    let mut ahead = *cursor;
    let ends = ahead.opt_mark(b'*') && {
        ahead.blanks();
        ahead.byte() == b'('
    };
    cursor.at = if ends { ahead.at } else { cursor.at };
    ends
}

/// A label: number, name or parameter.
fn label(cursor: &mut Cursor<'_>) -> Read<Option<Value>> {
    cursor.blanks();
    let start = cursor.at;
    match cursor.opt_whole() {
        Some(number) => {
            let span = Span::new(start, cursor.at);
            Ok(Some(Value { span, kind: ValueKind::Number(f64::from(number)) }))
        }
        None => opt_value(cursor),
    }
}

/// What follows a letter and is no number: `MAX` and `AUTO` after a feed, a sign or nothing after an axis.
fn bare(cursor: &mut Cursor<'_>, letter: &[u8]) -> Read<Value> {
    let start = cursor.at;
    if letter.first() == Some(&b'F') {
        let word = cursor.peek_word();
        if word.is(b"MAX") || word.is(b"AUTO") {
            cursor.at = word.span.end;
            return Ok(Value { span: word.span, kind: ValueKind::Word });
        }
    }
    if Axis::by_name(letter).is_none() {
        return Err(cursor.expected("value"));
    }
    let sign = cursor.byte();
    if matches!(sign, b'+' | b'-') {
        cursor.at += 1;
        return Ok(Value { span: Span::new(start, cursor.at), kind: ValueKind::Sign(sign == b'-') });
    }
    Ok(Value { span: Span::new(start, start), kind: ValueKind::Missing })
}

fn code(cursor: &mut Cursor<'_>) -> Read<Value> {
    let start = cursor.at;
    let number = cursor.opt_whole().filter(|number| *number < 1000).ok_or_else(|| cursor.expected("number"))?;
    Ok(Value { span: Span::new(start, cursor.at), kind: ValueKind::Number(f64::from(number)) })
}

/// The value of `P01`: a number, a parameter, a text, or an axis with a coordinate or a direction.
fn entry(cursor: &mut Cursor<'_>) -> Read<Option<Value>> {
    if let Some(value) = opt_value(cursor)? {
        return Ok(Some(value));
    }
    let start = cursor.at;
    let letter = cursor.peek_name();
    let path = cursor.byte_at(letter.span.end) == b':';
    if Axis::by_name(letter.as_bytes()).is_none() || letter.as_bytes().len() != 1 || path {
        // A path, as it is printed.
        let rest = cursor.bytes.get(start..cursor.end).unwrap_or_default();
        let length = rest.iter().position(|b| b.is_ascii_whitespace() || *b == b'~').unwrap_or(rest.len());
        cursor.at = start + length;
        let begins = rest.first().is_some_and(u8::is_ascii_alphabetic);
        return Ok(begins.then_some(Value { span: Span::new(start, cursor.at), kind: ValueKind::Word }));
    }
    cursor.at = letter.span.end;
    if cursor.opt_operand().is_none() && matches!(cursor.byte(), b'+' | b'-') {
        cursor.at += 1;
    }
    Ok(Some(Value { span: Span::new(start, cursor.at), kind: ValueKind::Word }))
}

/// The name after the code of a cycle: words up to a parameter or the end of the line.
fn cycle_name(cursor: &mut Cursor<'_>) -> Option<Span> {
    cursor.blanks();
    let rest = cursor.bytes.get(cursor.at..cursor.end).unwrap_or_default();
    let line = rest.iter().position(|b| matches!(b, b'\r' | b'\n' | b'~' | b';' | b'(')).unwrap_or(rest.len());
    // Words of the language, such as `P01 2` or `X+10`, are no name.
    let first = cursor.text.get(cursor.at..cursor.at + line)?.split_whitespace().next()?;
    let letters = first.chars().take_while(|c| c.is_alphabetic() || matches!(c, '-' | '.')).count();
    let short = letters < super::terms::SHORTEST_LABEL;
    let spoken = letters > 0 && !first.contains(['=', '+']) && !(short && first.contains(|c: char| c.is_ascii_digit()));
    if !spoken {
        return None;
    }
    let begins_word = |at: usize| at > 0 && rest.get(at - 1).is_some_and(|b| matches!(b, b' ' | b'\t'));
    let is_parameter = |at: &usize| {
        let mut ahead = Cursor { at: cursor.at + at, ..*cursor };
        begins_word(*at) && ahead.opt_q().is_some() && ahead.opt_mark(b'=')
    };
    let length = (0..line).find(is_parameter).unwrap_or(line);
    let name = trim(cursor.bytes, Span::new(cursor.at, cursor.at + length));
    cursor.at = name.end;
    Some(name)
}

/// `Q200=+2`, if it is here.
pub(super) fn opt_parameter(cursor: &mut Cursor<'_>) -> Read<Option<Parameter>> {
    cursor.blanks();
    let start = cursor.at;
    let mut ahead = *cursor;
    let Some(q) = ahead.opt_q() else { return Ok(None) };
    let q_span = Span::new(start, ahead.at);
    if !ahead.opt_mark(b'=') {
        return Ok(None);
    }
    *cursor = ahead;
    let after = cursor.at;
    let missing = Value { span: Span::new(after, after), kind: ValueKind::Missing };
    let value = match opt_value(cursor)? {
        Some(value) => {
            // In `Q201= Q202=5` the first value is missing.
            let mut next = *cursor;
            let is_next = matches!(value.kind, ValueKind::Q { .. }) && next.opt_mark(b'=');
            cursor.at = if is_next { after } else { cursor.at };
            if is_next { missing } else { value }
        }
        None => {
            cursor.blanks();
            let word = cursor.peek_name();
            cursor.at = word.span.end;
            // A feed per turn or per tooth has its number after the word.
            let feed = matches!(word.as_bytes(), b"FU" | b"FZ") && cursor.opt_operand().is_some();
            let span = Span::new(word.span.start, if feed { cursor.at } else { word.span.end });
            cursor.at = if span.start < span.end { span.end } else { after };
            if span.start < span.end { Value { span, kind: ValueKind::Word } } else { missing }
        }
    };
    Ok(Some(Parameter { span: Span::new(start, value.span.end.max(after)), q, q_span, value, label: None }))
}
