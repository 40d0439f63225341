//! Heads of cycle definitions, parameter lines, and the fields of the old form.
//!
//! Invariant: a cycle is known by keyword and number only; names and labels are kept as they are
//! printed and never decide anything.
use super::cursor::{Cursor, Read, skip_blanks, trim};
use super::definition::{Assignment, CycleDef, CycleKeyword, OldCycleLine};
use super::parameters::Parameters;
use super::statement::GlobalDef;
use super::terms::SHORTEST_LABEL;
use super::terms::{Axis, NamedWord, Operand, Parameter, Value, ValueKind};
use super::tree::BlockKind;
use super::words::from_operand;
use crate::base::diag::Span;

/// Whether a block's content starts like a cycle definition.
pub(super) fn starts_definition(text: &str, content: Span) -> bool {
    let mut cursor = Cursor::new(text, content);
    match cursor.byte() {
        b'C' | b'c' | b'T' | b't' => keyword(&mut cursor).is_some(),
        b'G' | b'g' => is_global(&mut cursor),
        _ => false,
    }
}

fn is_global(cursor: &mut Cursor<'_>) -> bool {
    cursor.opt_keyword(b"GLOBAL") && cursor.opt_keyword(b"DEF")
}

/// `CYCL`, or `CYCLE`, as some write.
pub(super) fn opt_cycl(cursor: &mut Cursor<'_>) -> bool {
    cursor.opt_keyword(b"CYCL") || cursor.opt_keyword(b"CYCLE")
}

fn keyword(cursor: &mut Cursor<'_>) -> Option<CycleKeyword> {
    if opt_cycl(cursor) {
        return cursor.opt_keyword(b"DEF").then_some(CycleKeyword::CyclDef);
    }
    (cursor.opt_keyword(b"TCH") && cursor.opt_keyword(b"PROBE")).then_some(CycleKeyword::TchProbe)
}

/// The first line of a definition, or a line of the old form.
pub(super) fn head(cursor: &mut Cursor<'_>) -> Read<BlockKind> {
    let start = cursor.at;
    if is_global(cursor) {
        cursor.blanks();
        let here = *cursor;
        let Some(number) = cursor.opt_whole() else { return Err(here.expected("cycle-number")) };
        let head = Span::new(start, cursor.at);
        let name = name(cursor)?;
        let definition = GlobalDef { number, head, name, parameters: Vec::new(), errors: Vec::new() };
        return Ok(BlockKind::GlobalDef(Box::new(definition)));
    }
    cursor.at = start;
    let Some(keyword) = keyword(cursor) else {
        cursor.blanks();
        return Err(cursor.expected("cycle-word"));
    };
    cursor.blanks();
    let here = *cursor;
    let Some(number) = cursor.opt_whole() else { return Err(here.expected("cycle-number")) };
    // Some post-processors leave a blank before the point: `CYCL DEF9 .0`.
    let point = skip_blanks(cursor.bytes, cursor.at, cursor.end);
    if cursor.byte_at(point) == b'.' && cursor.byte_at(point + 1).is_ascii_digit() {
        cursor.at = point;
    }
    let old = matches!(cursor.byte(), b'.' | b',') && cursor.byte_at(cursor.at + 1).is_ascii_digit();
    if !old && matches!(cursor.byte(), b'.' | b',') {
        return Err(cursor.expected("cycle-number"));
    }
    if !old {
        let head = Span::new(start, cursor.at);
        let (name, parameters) = name_and_parameters(cursor)?;
        let parameters = Parameters::from(parameters.as_slice());
        let definition = CycleDef { keyword, number, head, name, parameters, errors: Vec::new() };
        return Ok(BlockKind::CycleDef(Box::new(definition)));
    }
    cursor.at += 1;
    let Some(line) = cursor.opt_whole() else { return Err(here.expected("cycle-number")) };
    let head = Span::new(start, cursor.at);
    let name = if line == 0 { old_name(cursor)? } else { None };
    let words = words(cursor)?;
    Ok(BlockKind::OldCycleLine(Box::new(OldCycleLine { keyword, number, line, head, name, words })))
}

/// The name, and the parameters that some write on the same line: `CYCL DEF 200 DRILLING Q200=2 Q201=-5`.
fn name_and_parameters(cursor: &mut Cursor<'_>) -> Read<(Option<Span>, Vec<Parameter>)> {
    cursor.blanks();
    let Some(first) = inline_parameter(cursor) else { return Ok((name(cursor)?, Vec::new())) };
    let end = trim(cursor.bytes, Span::new(cursor.at, first)).end;
    let joint = end > cursor.at && cursor.byte_at(end - 1) == b'~';
    let name = name(&mut Cursor { end: end - usize::from(joint), ..*cursor })?;
    cursor.at = first;
    let mut parameters = Vec::new();
    while !cursor.done() {
        let Assignment { span, q, q_span, value, .. } = one_parameter(cursor)?;
        parameters.push(Parameter { span, q, q_span, value, label: None });
        cursor.opt_mark(b'~');
    }
    Ok((name, parameters))
}

/// Where the first parameter of a line begins, if there is one.
fn inline_parameter(cursor: &Cursor<'_>) -> Option<usize> {
    let text = cursor.text.get(cursor.at..cursor.end)?;
    let marks = text.match_indices('=').map(|(at, _)| cursor.at + at);
    // The parameter before the first mark, if any.
    let mark = marks.into_iter().next()?;
    let before = trim(cursor.bytes, Span::new(cursor.at, mark));
    let word = cursor.bytes.get(before.start..before.end)?;
    let length = word.iter().rev().take_while(|byte| byte.is_ascii_alphanumeric()).count();
    let mut q = Cursor { at: before.end - length, end: before.end, ..*cursor };
    let start = q.at;
    (q.opt_q().is_some() && q.at == before.end).then_some(start)
}

/// What is left is a name; text after a tab is none.
fn name(cursor: &mut Cursor<'_>) -> Read<Option<Span>> {
    cursor.blanks();
    let rest = cursor.text.get(cursor.at..cursor.end).unwrap_or_default();
    if let Some(tab) = rest.trim_end().find('\t') {
        cursor.at += tab + 1;
        cursor.blanks();
        return Err(cursor.expected("end"));
    }
    let span = cursor.rest();
    Ok((span.start < span.end).then_some(span))
}

/// The name on line 0 ends where a parameter begins: the fields of some cycles start on that line.
fn old_name(cursor: &mut Cursor<'_>) -> Read<Option<Span>> {
    cursor.blanks();
    let start = cursor.at;
    let mut at = start;
    while at < cursor.end {
        let mut ahead = Cursor { at, ..*cursor };
        if ahead.opt_q().is_some() {
            break;
        }
        let rest = cursor.text.as_bytes().get(at..cursor.end).unwrap_or_default();
        let word = rest.iter().position(|b| matches!(b, b' ' | b'\t')).unwrap_or(rest.len());
        at = skip_blanks(cursor.text.as_bytes(), at + word.max(1), cursor.end);
    }
    let mut named = Cursor { end: at, ..*cursor };
    let found = name(&mut named);
    cursor.at = if found.is_ok() { at } else { named.at };
    found
}

/// The fields up to the end of the block.
fn words(cursor: &mut Cursor<'_>) -> Read<Vec<NamedWord>> {
    let mut found = Vec::new();
    loop {
        let before = cursor.at;
        if cursor.done() {
            return Ok(found);
        }
        let here = *cursor;
        let word = word(cursor)?;
        let blanks = cursor.text.as_bytes().get(before..here.at).unwrap_or_default();
        // A listing's remark follows a tab; only a field with its value attached continues there.
        if !found.is_empty() && blanks.contains(&b'\t') && !reads_as_field(cursor.text, &word) {
            return Err(here.expected("end"));
        }
        // Most lines have one or none; long programs have many lines.
        if found.is_empty() {
            found.reserve_exact(1);
        }
        match axis_in_label(cursor.text, &word) {
            Some(pair) => found.extend(pair),
            None => found.push(word),
        }
    }
}

/// A label and its value with the letter of an axis between them, `KOT X: +30`, as the axis and the label: elsewhere
/// the axis comes first (TNC 640, 001: 12706, 12708, 13733).
fn axis_in_label(text: &str, word: &NamedWord) -> Option<[NamedWord; 2]> {
    let written = text.get(word.name.start..word.name.end)?.strip_suffix(':')?;
    let [.., blank, letter @ b'X'..=b'Z'] = written.as_bytes() else { return None };
    if *blank != b' ' || !(b'X'..=b'Z').contains(letter) {
        return None;
    }
    let end = word.name.start + written.len();
    let axis = Span::new(end - 1, end);
    let label = Span::new(word.name.start, word.name.start + written.get(..written.len() - 1)?.trim_end().len());
    let missing = Value { span: Span::new(end, end), kind: ValueKind::Missing };
    Some([NamedWord { span: axis, name: axis, value: missing }, NamedWord { name: label, ..*word }])
}

fn reads_as_field(text: &str, word: &NamedWord) -> bool {
    let colon = text.get(word.name.start..word.name.end).is_some_and(|name| name.ends_with(':'));
    colon || (word.value.kind != ValueKind::Missing && word.value.span.start == word.name.end)
}

fn word(cursor: &mut Cursor<'_>) -> Read<NamedWord> {
    let start = cursor.at;
    let (name, value) = if cursor.opt_mark(b'#') {
        let name = Span::new(start, cursor.at);
        let operand = cursor.operand()?;
        (name, from_operand(operand))
    } else if cursor.opt_mark(b'/') {
        let name = Span::new(start, cursor.at);
        let value = field_value(cursor, name)?;
        (name, value)
    } else if let Some(operand) = cursor.opt_operand() {
        (Span::new(start, start), number_or_list(cursor, operand, true))
    } else {
        let name = field_name(cursor)?;
        let value = field_value(cursor, name)?;
        (name, value)
    };
    Ok(NamedWord { span: Span::new(start, cursor.at.max(name.end)), name, value })
}

/// `1/2/3`: several numbers with bars are one value, after a label without a colon also `1 /2 /3`.
fn number_or_list(cursor: &mut Cursor<'_>, first: Operand, apart: bool) -> Value {
    let mut end = first.span.end;
    loop {
        cursor.at = end;
        if apart {
            cursor.blanks();
        }
        if cursor.byte() != b'/' {
            break;
        }
        cursor.at += 1;
        match (cursor.opt_operand(), cursor.opt_text()) {
            (Some(next), _) => end = next.span.end,
            (None, Ok(Some(name))) => end = name.end + 1,
            _ => break,
        }
    }
    cursor.at = end;
    if end == first.span.end {
        return from_operand(first);
    }
    Value { span: Span::new(first.span.start, end), kind: ValueKind::Word }
}

/// Whether the value of a field starts at a byte: a number, a sign, a parameter.
fn value_at(cursor: &Cursor<'_>, at: usize) -> bool {
    let mut ahead = Cursor { at, ..*cursor };
    matches!(cursor.byte_at(at), b'+' | b'#') || cursor.number_at(at) || ahead.opt_q().is_some() || minus_at(cursor, at)
}

/// A hyphen between letters belongs to a name; otherwise it is a minus.
fn minus_at(cursor: &Cursor<'_>, at: usize) -> bool {
    let mut ahead = Cursor { at: at + 1, ..*cursor };
    let next = cursor.byte_at(at + 1);
    cursor.byte_at(at) == b'-' && (!(next.is_ascii_alphabetic() || next >= 0x80) || ahead.opt_q().is_some())
}

/// The end of one word of a name that starts at a byte.
fn name_part(cursor: &Cursor<'_>, start: usize) -> usize {
    let rest = cursor.text.get(start..cursor.end).unwrap_or_default();
    for (offset, c) in rest.char_indices() {
        let at = start + offset;
        let part = c.is_alphabetic() || matches!(c, '.' | '_' | '(' | ')' | '°' | 'º' | 'ª' | '&') || c == '-';
        if !part || (c == '-' && minus_at(cursor, at)) || (offset > 0 && cursor.number_at(at)) {
            return at;
        }
    }
    cursor.end
}

/// A name: words up to a colon (included) or a value. The letter of an axis is a name of its own; after a label at the
/// end of the line it is the value of the label.
fn field_name(cursor: &mut Cursor<'_>) -> Read<Span> {
    let bytes = cursor.text.as_bytes();
    let start = cursor.at;
    let mut end = start;
    loop {
        let part = skip_blanks(bytes, end, cursor.end);
        // A tab ends the name, so does whatever is no letter.
        let tab = bytes.get(end..part).unwrap_or_default().contains(&b'\t');
        let starts = cursor.text.get(part..cursor.end).and_then(|t| t.chars().next()).is_some_and(char::is_alphabetic);
        if tab || !starts || (end > start && value_at(cursor, part)) {
            break;
        }
        // What is after the word for a program is its name, letters and digits as they come.
        if end > start && is_program(cursor, Span::new(start, end)) {
            break;
        }
        let part_end = name_part(cursor, part);
        if end > start && is_value_of_label(cursor, Span::new(start, end), Span::new(part, part_end)) {
            break;
        }
        if cursor.byte_at(part_end) == b':' {
            let path = cursor.byte_at(part_end + 1) == b'\\';
            end = if path { end } else { part_end + 1 };
            break;
        }
        let alone = end == start && is_axis(bytes.get(part..part_end).unwrap_or_default());
        end = part_end;
        if alone || value_at(cursor, part_end) {
            break;
        }
    }
    if end == start && !cursor.text.get(start..cursor.end).is_some_and(|t| t.starts_with(char::is_alphabetic)) {
        return Err(cursor.expected("field"));
    }
    cursor.at = end;
    Ok(Span::new(start, end))
}

/// Whether a word after a label without a colon is its value: the letter of an axis that ends the line.
fn is_value_of_label(cursor: &Cursor<'_>, label: Span, word: Span) -> bool {
    let bytes = cursor.text.as_bytes();
    let last = skip_blanks(bytes, word.end, cursor.end) >= cursor.end;
    // A label is looked through once only, at the end of the line.
    last && is_axis(bytes.get(word.start..word.end).unwrap_or_default()) && {
        let label = cursor.text.get(label.start..label.end).unwrap_or_default();
        label.chars().filter(|c| c.is_alphabetic()).nth(SHORTEST_LABEL - 1).is_some()
    }
}

fn is_axis(name: &[u8]) -> bool {
    let name = name.strip_prefix(b"I").unwrap_or(name);
    name.len() == 1 && Axis::by_name(&name.to_ascii_uppercase()).is_some()
}

/// Whether a label is the word for a program, the same in all languages, and not the first one of a label with a colon.
fn is_program(cursor: &Cursor<'_>, label: Span) -> bool {
    let own = cursor.text.get(label.start..label.end).is_some_and(|label| label.trim().eq_ignore_ascii_case("PGM"));
    let rest = cursor.text.get(label.end..cursor.end).unwrap_or_default();
    own && !rest.match_indices(':').any(|(at, _)| !rest.get(at + 1..).is_some_and(|after| after.starts_with('\\')))
}

/// The value of a field, its name being read.
fn field_value(cursor: &mut Cursor<'_>, name: Span) -> Read<Value> {
    let here = cursor.at;
    let last = cursor.text.as_bytes().get(name.start..name.end).and_then(<[u8]>::last);
    let labelled = matches!(last, Some(b':' | b'/'));
    let missing = Value { span: Span::new(here, here), kind: ValueKind::Missing };
    let at = skip_blanks(cursor.text.as_bytes(), here, cursor.end);
    let named = Span::new(at, printed_end(cursor, at));
    if is_program(cursor, name) && named.start < named.end && !matches!(cursor.byte_at(at), b'"' | b'\'') {
        cursor.at = named.end;
        return Ok(Value { span: named, kind: ValueKind::Word });
    }
    if let sign @ (b'+' | b'-') = cursor.byte_at(at)
        && !value_at(cursor, skip_blanks(cursor.text.as_bytes(), at + 1, cursor.end))
    {
        cursor.at = at + 1;
        return Ok(Value { span: Span::new(at, at + 1), kind: ValueKind::Sign(sign == b'-') });
    }
    if value_at(cursor, at) && cursor.byte_at(at) != b'#' {
        return match cursor.opt_operand() {
            Some(operand) => Ok(number_or_list(cursor, operand, !labelled)),
            None => Err(cursor.expected("value")),
        };
    }
    if let Some(text) = cursor.opt_text()? {
        return Ok(Value { span: Span::new(text.start - 1, text.end + 1), kind: ValueKind::Text(text) });
    }
    let span = Span::new(at, printed_end(cursor, at));
    let path =
        name.start == name.end || cursor.text.get(span.start..span.end).is_some_and(|printed| printed.contains(":\\"));
    let of_label = is_value_of_label(cursor, name, span);
    if (labelled || path || of_label) && span.start < span.end {
        cursor.at = span.end;
        return Ok(Value { span, kind: ValueKind::Word });
    }
    cursor.at = here;
    Ok(missing)
}

/// The end of what is printed without a blank from a byte on.
fn printed_end(cursor: &Cursor<'_>, at: usize) -> usize {
    let rest = cursor.text.as_bytes().get(at..cursor.end).unwrap_or_default();
    at + rest.iter().position(|b| matches!(b, b' ' | b'\t' | b'\r' | b'\n' | b'~' | b';')).unwrap_or(rest.len())
}

/// Whether content starts like `Q200=`.
pub(super) fn starts_parameter(text: &str, content: Span) -> bool {
    let mut cursor = Cursor::new(text, content);
    cursor.blanks();
    matches!(cursor.byte(), b'Q' | b'q') && cursor.opt_q().is_some() && cursor.opt_mark(b'=')
}

/// Whether content starts like `Q200=` without a blank, as controls print parameters.
pub(super) fn starts_tight_parameter(text: &str, content: Span) -> bool {
    let mut cursor = Cursor::new(text, content);
    cursor.opt_q().is_some() && cursor.byte() == b'='
}

/// A parameter with a value that a cycle definition can hold, up to the end.
pub(super) fn parameter(cursor: &mut Cursor<'_>) -> Read<Assignment> {
    let assignment = one_parameter(cursor)?;
    cursor.finish()?;
    Ok(assignment)
}

fn one_parameter(cursor: &mut Cursor<'_>) -> Read<Assignment> {
    cursor.blanks();
    let start = cursor.at;
    let Some(q) = cursor.opt_q() else { return Err(cursor.expected("parameter")) };
    let q_span = Span::new(start, cursor.at);
    let tight = cursor.byte() == b'=';
    if !cursor.opt_mark(b'=') {
        return Err(cursor.expected("="));
    }
    let value = parameter_value(cursor)?;
    Ok(Assignment { span: Span::new(start, value.span.end.max(q_span.end + 1)), q, q_span, value, tight })
}

fn parameter_value(cursor: &mut Cursor<'_>) -> Read<Value> {
    if cursor.done() {
        return Ok(Value { span: Span::new(cursor.at, cursor.at), kind: ValueKind::Missing });
    }
    if let Some(text) = cursor.opt_text()? {
        return Ok(Value { span: Span::new(text.start - 1, text.end + 1), kind: ValueKind::Text(text) });
    }
    if let Some(operand) = cursor.opt_operand() {
        return Ok(from_operand(operand));
    }
    let word = cursor.peek_word();
    if word.span.start == word.span.end {
        return Err(cursor.expected("value"));
    }
    cursor.at = word.span.end;
    let end = match word.as_bytes() {
        // A feed per turn or per tooth has its number after the word.
        b"FU" | b"FZ" if cursor.opt_operand().is_some() => cursor.at,
        b"F" if cursor.opt_keyword(b"AUTO") || cursor.opt_keyword(b"MAX") => cursor.at,
        _ => word.span.end,
    };
    cursor.at = end;
    Ok(Value { span: Span::new(word.span.start, end), kind: ValueKind::Word })
}

/// The label in a comment: what is after `;`, up to a tab.
pub(super) fn label(text: &str, comment: Span) -> Option<Span> {
    let bytes = text.as_bytes();
    let inside = trim(bytes, Span::new(comment.start + 1, comment.end));
    let written = bytes.get(inside.start..inside.end)?;
    let end = written.iter().position(|&b| b == b'\t').map_or(inside.end, |tab| inside.start + tab);
    let label = trim(bytes, Span::new(inside.start, end));
    (label.start < label.end).then_some(label)
}
