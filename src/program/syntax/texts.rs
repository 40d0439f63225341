//! Formulas with functions on texts, and formulas of contours.
//!
//! A function on texts is read by its own words; for the formula around it, it is one operand.
use super::cursor::{Cursor, Read};
use super::statement::{ContourFormula, TextCall};
use super::statements::opt_contour_name;
use super::terms::{NamedWord, SyntaxError};
use super::tree::BlockKind;
use super::words::{self, Takes, Vocabulary};
use crate::base::diag::Span;

/// Functions on texts, and whether they give a text.
const FUNCTIONS: [(&[u8], bool); 11] = [
    (b"TOCHAR", true),
    (b"SUBSTR", true),
    (b"SYSSTR", true),
    (b"CFGREAD", true),
    (b"TOUPPER", true),
    (b"TOLOWER", true),
    (b"TONUMB", false),
    (b"INSTR", false),
    (b"STRLEN", false),
    (b"STRCOMP", false),
    (b"SYSREAD", false),
];

const ARGUMENTS: Vocabulary = &[
    ("DAT", Takes::Value),
    ("DECIMALS", Takes::Value),
    ("SRC_", Takes::Value),
    ("SEA_", Takes::Value),
    ("KEY_", Takes::Value),
    ("TAG_", Takes::Value),
    ("ATR_", Takes::Value),
    ("BEG", Takes::Value),
    ("LEN", Takes::Value),
    ("ID", Takes::Value),
    ("NR", Takes::Value),
    ("IDX", Takes::Value),
];

/// A formula with one operand in the place of each function on texts, and these; nothing if there are none.
pub(super) fn opt_calls(cursor: &Cursor<'_>, text: Span, written: &str) -> Read<Option<(String, Vec<TextCall>)>> {
    let mut calls = Vec::new();
    let mut operands = written.to_owned();
    let mut at = text.start;
    let mut quoted = false;
    while at < text.end {
        let ahead = Cursor { at, end: text.end, ..*cursor };
        let byte = ahead.byte();
        quoted ^= byte == b'"';
        if quoted || !byte.is_ascii_alphabetic() {
            at += 1;
            continue;
        }
        let word = ahead.peek_word();
        at = word.span.end;
        while ahead.byte_at(at).is_ascii_alphanumeric() {
            at += 1;
        }
        let Some(&(_, gives_text)) = FUNCTIONS.iter().find(|(name, _)| word.is(name)) else { continue };
        let mut inside = Cursor { at: word.span.end, ..ahead };
        if !inside.opt_mark(b'(') {
            return Err(inside.expected("("));
        }
        let words = arguments(&mut inside)?;
        calls.push(TextCall { name: word.span, words });
        let operand = if gives_text { "QS0" } else { "Q0" };
        let (from, to) = (word.span.start - text.start, inside.at - text.start);
        operands.replace_range(from..to, &format!("{operand:<width$}", width = to - from));
        at = inside.at;
    }
    Ok((!calls.is_empty()).then_some((operands, calls)))
}

/// The words of a function up to its closing bracket.
fn arguments(cursor: &mut Cursor<'_>) -> Read<Vec<NamedWord>> {
    let mut found = Vec::new();
    loop {
        if cursor.opt_mark(b')') {
            return Ok(found);
        }
        if let Some(word) = words::opt_named(cursor, &[ARGUMENTS])? {
            found.push(word);
        } else if let Some(value) = words::opt_value(cursor)? {
            found.push(words::nameless(value));
        } else {
            return Err(cursor.expected("closing-bracket"));
        }
    }
}

/// `QC10 = ( QC1 | QC2 ) \ QC3`.
pub(super) fn contour_formula(cursor: &mut Cursor<'_>) -> Read<BlockKind> {
    let (target, target_span) = opt_contour_name(cursor).ok_or_else(|| cursor.expected("contour-name"))?;
    if !cursor.opt_mark(b'=') {
        return Err(cursor.expected("="));
    }
    cursor.blanks();
    let start = cursor.at;
    let mut reads = Vec::new();
    let mut depth = 0_usize;
    loop {
        while cursor.opt_mark(b'(') {
            depth += 1;
        }
        reads.push(opt_contour_name(cursor).ok_or_else(|| contour_error(cursor, "contour-name"))?);
        while depth > 0 && cursor.opt_mark(b')') {
            depth -= 1;
        }
        if cursor.done() {
            break;
        }
        if !matches!(cursor.byte(), b'&' | b'|' | b'^' | b'\\') {
            return Err(contour_error(cursor, "contour-operator"));
        }
        // Union without overlap is printed as `|\`.
        cursor.at += 1 + usize::from(cursor.byte() == b'|' && cursor.byte_at(cursor.at + 1) == b'\\');
    }
    if depth > 0 {
        return Err(contour_error(cursor, "closing-bracket"));
    }
    let text = Span::new(start, cursor.at);
    Ok(BlockKind::ContourFormula(Box::new(ContourFormula { target, target_span, text, reads })))
}

fn contour_error(cursor: &mut Cursor<'_>, expected: &'static str) -> SyntaxError {
    cursor.blanks();
    cursor.expected(expected)
}
