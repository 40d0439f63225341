//! The words of blocks that are no cycles, as the file of the language describes them.
//!
//! Invariant: only words and numbers as they are written are looked at; a parameter is no number here.
use std::collections::BTreeMap;

use super::blocks::each_function;
use super::reading::Reading;
use crate::base::diag::Span;
use crate::base::expr::QRef;
use crate::program::syntax::{Block, BlockKind, MFunction, Statement, StatementKind};
use crate::spec::BlockWords;

/// The words of a block, or of an M function or a function on texts in one.
pub(in crate::check) struct Words<'f> {
    /// What is known of such blocks; what is more special comes after.
    pub(in crate::check) known: Vec<&'f BlockWords>,
    /// Its words with their places.
    tokens: Vec<(&'f str, Span)>,
}

/// A word as it is written with what follows it.
pub(in crate::check) struct WordValue<'f> {
    /// The value: a number or another word.
    pub(in crate::check) value: &'f str,
    /// The place of both.
    pub(in crate::check) span: Span,
}

impl WordValue<'_> {
    /// The number, if it is one.
    pub(in crate::check) fn number(&self) -> Option<f64> {
        let digits = self.value.trim_start_matches(['+', '-']);
        let plain = digits.bytes().all(|byte| byte.is_ascii_digit() || matches!(byte, b'.' | b','));
        (plain && digits.bytes().any(|byte| byte.is_ascii_digit())).then_some(())?;
        self.value.replace(',', ".").parse().ok()
    }
}

/// The M functions of which something is known.
pub(in crate::check) fn functions(facts: &Reading<'_>) -> Vec<u16> {
    let number = |own: &BlockWords| own.block.strip_prefix('M').and_then(|own| own.parse().ok());
    facts.against.catalogue.blocks.iter().filter_map(number).collect()
}

/// Whether a block has one of them.
pub(in crate::check) fn has_function(block: &Block, functions: &[u16]) -> bool {
    let mut any = false;
    each_function(block, |number| any |= functions.contains(&number));
    any
}

/// The words of everything in a block of which something is known.
pub(in crate::check) fn of<'f>(facts: &'f Reading<'_>, block: &'f Block) -> Vec<Words<'f>> {
    let mut found = Vec::new();
    match &block.kind {
        BlockKind::Statement(own) => found.extend(statement(facts, block, own)),
        BlockKind::Sel(_) | BlockKind::CallPgm(_) => {
            let span = facts.content(block);
            let text = facts.program.slice(span);
            found.extend(known(facts, move |name| is_begun(text, name), span));
        }
        BlockKind::TextFormula(own) => {
            for call in &own.calls {
                let end = call.words.last().map_or(call.name.end, |word| word.span.end);
                let name = facts.text(call.name).trim();
                found.extend(known(facts, |block| block.eq_ignore_ascii_case(name), Span::new(call.name.start, end)));
            }
        }
        _ => {}
    }
    for function in facts.functions(block).iter() {
        found.extend(with_function(facts, function));
    }
    found
}

/// The texts of text parameters that are given one text in the program, in one place.
pub(in crate::check) fn texts<'f>(facts: &Reading<'f>) -> BTreeMap<QRef, &'f str> {
    let mut found: BTreeMap<QRef, Option<&str>> = BTreeMap::new();
    for (_, block) in facts.marked() {
        let (target, text) = match &block.kind {
            BlockKind::Formula(own) => (own.target, facts.text(own.text).trim()),
            BlockKind::TextFormula(own) => (own.target, ""),
            // Other programs and what cannot be read may give them others.
            BlockKind::CallPgm(_) | BlockKind::Unknown(_) => return BTreeMap::new(),
            _ => continue,
        };
        let literal = text.strip_prefix('"').and_then(|rest| rest.strip_suffix('"')).filter(|own| !own.contains('"'));
        found.entry(target).and_modify(|own| *own = None).or_insert(literal);
    }
    found.into_iter().filter_map(|(q, text)| Some((q, text?))).collect()
}

fn known<'f>(facts: &'f Reading<'_>, is: impl Fn(&str) -> bool + 'f, span: Span) -> Option<Words<'f>> {
    let known: Vec<&BlockWords> = facts.against.catalogue.blocks.iter().filter(|own| is(&own.block)).collect();
    if known.is_empty() {
        return None;
    }
    Some(Words { known, tokens: tokens(facts.program.slice(span), span.start) })
}

fn statement<'f>(facts: &'f Reading<'_>, block: &Block, own: &Statement) -> Option<Words<'f>> {
    let end = own.words.last().map_or(own.head.end, |word| word.span.end);
    let span = Span::new(own.head.start, end.max(facts.content(block).end.min(block.span.end)));
    if let StatementKind::Fn(number) = own.kind {
        return known(
            facts,
            move |name| name.strip_prefix("FN ").and_then(|own| own.parse().ok()) == Some(number),
            span,
        );
    }
    let text = facts.program.slice(span);
    known(facts, move |name| is_begun(text, name), span)
}

/// Whether a text begins with the words.
fn is_begun(text: &str, words: &str) -> bool {
    let mut own = text.split_ascii_whitespace();
    let same = |one: &str, other: &str| one.eq_ignore_ascii_case(other) || is_long_form(one, other);
    words.split(' ').all(|word| own.next().is_some_and(|own| same(word, own)))
}

/// `RELATIV` may be written out.
fn is_long_form(word: &str, written: &str) -> bool {
    word == "RELATIV" && written.eq_ignore_ascii_case("RELATIVE")
}

fn with_function<'f>(facts: &'f Reading<'_>, function: &MFunction) -> Option<Words<'f>> {
    let number = function.number;
    known(facts, move |name| name.strip_prefix('M').and_then(|own| own.parse().ok()) == Some(number), function.span)
}

/// The words of a text with their places, without comments; brackets separate them.
fn tokens(text: &str, start: usize) -> Vec<(&str, Span)> {
    let (mut found, mut quoted, mut from) = (Vec::new(), false, None);
    let bytes = text.as_bytes();
    for (at, byte) in bytes.iter().copied().enumerate() {
        let ends = !quoted && (byte.is_ascii_whitespace() || matches!(byte, b'(' | b')' | b';' | b'~'));
        // A blank may be missing after the sign of an assignment: `=ID20`.
        let assigned = |first: usize| first + 1 == at && bytes.get(first) == Some(&b'=') && byte.is_ascii_alphabetic();
        quoted ^= byte == b'"';
        match (ends, from) {
            (true, Some(first)) => {
                found.push((text.get(first..at).unwrap_or_default(), Span::new(start + first, start + at)));
                from = None;
            }
            (false, None) => from = Some(at),
            (false, Some(first)) if !quoted && assigned(first) => {
                found.push((text.get(first..at).unwrap_or_default(), Span::new(start + first, start + at)));
                from = Some(at);
            }
            _ => {}
        }
        if ends && byte == b';' {
            return found;
        }
    }
    if let Some(first) = from {
        found.push((text.get(first..).unwrap_or_default(), Span::new(start + first, start + text.len())));
    }
    found
}

impl<'f> Words<'f> {
    /// Whether a word is there.
    pub(in crate::check) fn has(&self, word: &str) -> bool {
        self.tokens.iter().any(|(token, _)| after(token, word).is_some_and(is_value))
    }

    /// What is missing: a word of those that are needed, or one of a list. What says more about the block goes first.
    pub(in crate::check) fn lacking(&self) -> Option<String> {
        self.known.iter().rev().find_map(|known| {
            let needed = known.needs.iter().find(|word| !self.has(word)).cloned();
            let asked = |pair: &String| {
                let (first, second) = pair.split_once(' ')?;
                (self.has(first) && !self.has(second) && !self.has(&format!("{second}MAX"))).then(|| second.to_owned())
            };
            let needed = needed.or_else(|| known.asks.iter().find_map(asked));
            let mut lists = known.one_of.iter().chain(&known.any_of);
            let none = |list: &&String| !list.split(' ').any(|word| self.has(word));
            let needed = needed.or_else(|| lists.find(none).map(|list| list.replace(' ', ", ")));
            let contained =
                |list: &&String| !list.split(' ').any(|own| self.tokens.iter().any(|(token, _)| token.contains(own)));
            needed.or_else(|| known.contains.iter().find(contained).map(|list| list.replace(' ', ", ")))
        })
    }

    /// A word after which nothing follows where something must, with its place.
    pub(in crate::check) fn without_value(&self) -> Option<(&'f str, Span)> {
        let stands = |at: usize| {
            let next = self.tokens.iter().skip(at + 1).find(|(token, _)| !matches!(*token, "=" | ":"));
            next.map(|(token, _)| token.trim_start_matches([':', '=']))
        };
        let value = |text: &str| {
            let digit = |byte: &u8| byte.is_ascii_digit() || matches!(byte, b'+' | b'-' | b'.' | b'"');
            text.bytes().next().is_some_and(|first| digit(&first))
                || matches!(text.as_bytes(), [b'Q' | b'q', rest @ ..] if rest.iter().any(u8::is_ascii_digit))
        };
        self.tokens.iter().enumerate().find_map(|(at, (token, span))| {
            let rest = |word: &String| after(token, word).map(|rest| rest.trim_start_matches([':', '=']));
            let alone = |word: &String| rest(word) == Some("");
            let known = || self.known.iter();
            let valueless = known().any(|known| known.valued.iter().any(alone)) && !stands(at).is_some_and(value);
            let last = known().any(|known| known.goes_on.iter().any(alone)) && stands(at).is_none();
            (valueless || last).then_some((token.trim_end_matches([':', '=']), *span))
        })
    }

    /// The words after the first one.
    pub(in crate::check) fn others(&self) -> impl Iterator<Item = (&'f str, Span)> {
        self.tokens.iter().skip(1).copied()
    }

    /// The numbers of words; nothing if one of them has none.
    pub(in crate::check) fn numbers<const N: usize>(&self, words: &str) -> Option<[f64; N]> {
        let mut found = [0.0; N];
        let mut names = words.split(' ');
        for place in &mut found {
            *place = self.each(names.next()?).next()?.number()?;
        }
        Some(found)
    }

    /// Whether it is a function that some word begins and that ends without any.
    pub(in crate::check) fn is_begun_by_some(&self) -> bool {
        self.known.iter().any(|known| !known.begun_by.is_empty())
    }

    /// Whether one of these words is there.
    pub(in crate::check) fn begins(&self) -> bool {
        self.known.iter().any(|known| known.begun_by.iter().any(|word| self.has(word)))
    }

    /// The words of which one begins it.
    pub(in crate::check) fn beginning(&self) -> Option<String> {
        self.known.iter().find(|known| !known.begun_by.is_empty()).map(|known| known.begun_by.join(", "))
    }

    /// What the first of them is called that is known of the block.
    pub(in crate::check) fn name(&self) -> Option<&'f str> {
        self.known.first().map(|known| known.block.as_str())
    }

    /// The text in quotation marks and its place.
    pub(in crate::check) fn quoted(&self) -> Option<(&'f str, Span)> {
        let is = |(token, _): &&(&str, Span)| token.starts_with('"');
        self.tokens.iter().find(is).map(|(token, span)| (token.trim_matches('"'), *span))
    }

    /// The last of its words, without quotation marks: the name of a file.
    pub(in crate::check) fn last_name(&self) -> Option<(&'f str, Span)> {
        self.tokens.last().map(|(token, span)| (token.trim_matches('"'), *span))
    }

    /// The first of all, to the end of the last one.
    pub(in crate::check) fn span(&self) -> Span {
        let ends = self.tokens.first().zip(self.tokens.last());
        ends.map_or(Span::new(0, 0), |((_, first), (_, last))| Span::new(first.start, last.end))
    }

    /// The word at a place.
    pub(in crate::check) fn at(&self, place: usize) -> Option<(&'f str, Span)> {
        self.tokens.get(place).copied()
    }

    /// A word each time that it is there, with what is after it.
    pub(in crate::check) fn each<'w>(&'w self, word: &'w str) -> impl Iterator<Item = WordValue<'f>> + 'w {
        self.tokens.iter().enumerate().filter_map(move |(at, (token, span))| {
            let rest = after(token, word).filter(|rest| is_value(rest) || word.ends_with('_'))?;
            let rest = rest.trim_start_matches([':', '=']);
            if !rest.is_empty() {
                return Some(WordValue { value: rest, span: *span });
            }
            let mut next = self.tokens.iter().skip(at + 1).filter(|(token, _)| !matches!(*token, "=" | ":"));
            let (value, end) = next.next()?;
            Some(WordValue { value: value.trim_start_matches('='), span: Span::new(span.start, end.end) })
        })
    }
}

/// What follows the word in its token.
fn after<'t>(token: &'t str, word: &str) -> Option<&'t str> {
    token.get(..word.len()).filter(|begin| begin.eq_ignore_ascii_case(word)).and_then(|_| token.get(word.len()..))
}

/// Whether that is a value, or none: a letter belongs to a longer word, but for a parameter.
fn is_value(rest: &str) -> bool {
    let mut bytes = rest.bytes();
    match bytes.next() {
        Some(b'Q' | b'q') => bytes.any(|byte| byte.is_ascii_digit()),
        Some(first) => {
            !first.is_ascii_alphabetic() && first != b'-'
                || matches!(rest.as_bytes(), [b'-', b'0'..=b'9' | b'.' | b'Q', ..])
        }
        None => true,
    }
}
