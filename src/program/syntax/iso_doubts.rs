//! What is wrong in blocks of DIN/ISO that are understood nevertheless.
//!
//! Invariant: blocks are only inspected, none is read here.
use super::iso::{IsoBlock, IsoKind, is_path};
use super::terms::{Axis, NamedWord, SyntaxError, ValueKind};
use super::tree::{Block, BlockKind};
use crate::base::diag::Span;

/// Codes of which a block has one: each says what the others of its group would say otherwise.
fn group(code: u16) -> Option<u8> {
    match code {
        17..=20 => Some(1),
        40..=44 => Some(2),
        70 | 71 => Some(3),
        _ if is_path(code) => Some(0),
        _ => None,
    }
}

/// The second of two codes of a block that exclude each other.
pub(super) fn excluded(text: &str, block: &IsoBlock) -> Option<SyntaxError> {
    let codes = || block.words.iter().filter_map(|word| Some((word, code(text, word)?)));
    // What is written between G90 and G91 belongs to the first of them.
    let pair = block.words.windows(2).find_map(|pair| match pair {
        [one, other] => {
            let (first, second) = (code(text, one)?, code(text, other)?);
            (first != second && [first, second].iter().all(|code| matches!(code, 90 | 91))).then_some(other)
        }
        _ => None,
    });
    if let Some(word) = pair {
        return Some(SyntaxError { code: "syntax-excluding-codes", span: word.span, expected: "word" });
    }
    codes().enumerate().find_map(|(at, (word, own))| {
        let group = group(own)?;
        let other = codes().take(at).any(|(_, other)| other != own && self::group(other) == Some(group));
        other.then_some(SyntaxError { code: "syntax-excluding-codes", span: word.span, expected: "word" })
    })
}

fn code(text: &str, word: &NamedWord) -> Option<u16> {
    match word.value.kind {
        ValueKind::Number(number) if text.get(word.name.start..word.name.end)?.eq_ignore_ascii_case("G") => {
            Some(number as u16)
        }
        _ => None,
    }
}

/// A word that no block of its kind has: a number without a letter where all words have one, as after a second decimal
/// point, a second axis of a movement along one, or an operand more than a D function takes.
pub(super) fn stray(text: &str, block: &IsoBlock) -> Option<Span> {
    let taken = match block.kind {
        // Along one axis.
        IsoKind::Path(Some(7)) => {
            let named = |word: &&NamedWord| text.get(word.name.start..word.name.end).unwrap_or_default();
            let axis = |word: &&NamedWord| Axis::by_name(named(word).to_ascii_uppercase().as_bytes()).is_some();
            return block.words.iter().filter(axis).nth(1).map(|word| word.span);
        }
        IsoKind::Path(_)
        | IsoKind::Centre
        | IsoKind::Chamfer
        | IsoKind::Rounding
        | IsoKind::Blend(_)
        | IsoKind::Blank(_) => {
            let nameless = |word: &&NamedWord| word.name.start == word.name.end;
            let mut numbers = block.words.iter().filter(|word| matches!(word.value.kind, ValueKind::Number(_)));
            return numbers.find(nameless).map(|word| word.span);
        }
        // The function, its target and one operand, or two; two operands and a label.
        IsoKind::Function(0 | 5..=7) => 3,
        IsoKind::Function(1..=4 | 8..=13) => 4,
        _ => return None,
    };
    block.words.get(taken).map(|word| word.span)
}

/// The first text in brackets: comments of the controls are after a semicolon.
pub(super) fn remark(blocks: &[Block]) -> Option<SyntaxError> {
    blocks.iter().find_map(|block| match &block.kind {
        BlockKind::Iso(own) => {
            let span = *own.remarks.first()?;
            Some(SyntaxError { code: "syntax-bracket-comment", span, expected: "block" })
        }
        _ => None,
    })
}

/// The blocks without the `*` at their end, in a program in which most have it.
pub(super) fn without_end(text: &str, blocks: &[Block]) -> Vec<SyntaxError> {
    let acting =
        |block: &&Block| !matches!(block.kind, BlockKind::Empty | BlockKind::Comment | BlockKind::Structure(_));
    let ended = |block: &&Block| text.get(block.span.start..block.span.end).is_none_or(|own| own.contains('*'));
    let (with, all) = (blocks.iter().filter(acting).filter(ended).count(), blocks.iter().filter(acting).count());
    if with == all || with * 2 <= all {
        return Vec::new();
    }
    let lacking = blocks.iter().filter(acting).filter(|block| !ended(block));
    lacking
        .map(|block| {
            let own = text.get(block.span.start..block.span.end).unwrap_or_default();
            let end = block.span.start + own.trim_end().len();
            SyntaxError { code: "syntax-incomplete", span: Span::new(end, end), expected: "*" }
        })
        .collect()
}
