//! A number in a comment that the blocks belonging to it do not have, while they have one that a slip of the keyboard makes of
//! it: two digits are exchanged. Also a result that differs from the one that the comment beside it states, a scaling factor
//! that does not fit the shrinkage which a comment states in percent, one hole more or less than a comment counts, and a result
//! (Q100 to Q199) in place of the one that the comment names.
//!
//! A comment belongs to the blocks up to the next one, or to the block beside which it is; one before the first tool call
//! belongs to all, where only numbers of three digits or more are compared. Half and twice a number are the same one: a
//! diameter and a radius. Longer programs are written by posts.
use crate::base::diag::{Diagnostic, Severity, Span};
use crate::base::expr::{QKind, QRef};
use crate::check::incident::Incident;
use crate::check::program::{reads, remark};
use crate::check::slip::exchanged;
use crate::check::travel::incidents;
use crate::check::{Facts, Rule};
use crate::program::syntax::{Block, BlockKind, ValueKind};

pub(super) const RULE: Rule = Rule { code: "comment-contradicts", severity: Severity::Warning, run };

/// Longer programs are written by posts.
const MOST: usize = 2_000;
/// So many digits make a number that no other one resembles by chance: nearby, and in the whole program.
const DIGITS: [usize; 2] = [2, 3];
/// Numbers that are so near are the same.
const SAME: f64 = 1e-6;
/// The greatest shrinkage, percent.
const SHRINKAGE: f64 = 10.0;
/// The parameters that hold results.
const RESULTS: std::ops::Range<u16> = 100..200;
/// So many holes are worth counting.
const HOLES: [usize; 2] = [3, 1 << 8];
/// What holes and threads are called in the languages of manuals and shops, by the beginning of the word.
const HOLE_WORDS: [&str; 16] = [
    "HOLE", "BORE", "THREAD", "TAP", "BOHRUNG", "LOCH", "LÖCHER", "GEWINDE", "REI", "KIERTE", "LUKN", "IZVRTIN",
    "FORI", "FURO", "TROU", "ROSCA",
];

/// A number as it is written.
#[derive(Clone, Copy, Debug)]
struct Written {
    value: f64,
    span: Span,
    digits: usize,
}

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let blocks = facts.program.blocks();
    if blocks.len() > MOST {
        return;
    }
    let header = blocks.iter().position(|block| matches!(block.kind, BlockKind::ToolCall(_))).unwrap_or(blocks.len());
    for (index, block) in blocks.iter().enumerate() {
        let Some(text) = comment(facts, block) else { continue };
        let alone = is_remark(block);
        let end = match alone {
            true if index < header => blocks.len(),
            true => {
                // The tool call below a comment belongs to it.
                let called = blocks.get(index + 1).is_some_and(|own| matches!(own.kind, BlockKind::ToolCall(_)));
                let from = index + 1 + usize::from(called);
                from + blocks.iter().skip(from).position(ends_part).unwrap_or(blocks.len())
            }
            false => index + 1,
        };
        let part = blocks.get(if alone { index + 1 } else { index }..end.min(blocks.len())).unwrap_or_default();
        let least = DIGITS[usize::from(alone && index < header)];
        if let Some((span, value, other)) = exchanged_digits(facts, text, part, least) {
            found.push(rule.comparison(facts, span, "digits", value, other));
        }
        if alone && let Some((span, value, other)) = other_parameter(text, part) {
            let finding = rule.at(facts, span).arg("what", "parameter").arg("value", value.to_string());
            found.push(finding.arg("other", other.to_string()));
        }
        if let Some((value, other)) = other_result(facts, index, text) {
            found.push(rule.comparison(facts, facts.content(block), "result", value, other));
        }
    }
    if let Some((span, value, other)) = shrinkage(facts) {
        found.push(rule.comparison(facts, span, "scale", value, other));
    }
    if let Some((span, value, other)) = holes(facts, header) {
        found.push(rule.comparison(facts, span, "holes", value, other));
    }
}

/// The words of a block's comment.
fn comment<'a>(facts: &Facts<'a>, block: &Block) -> Option<&'a str> {
    remark(block).map(|span| facts.text(span))
}

/// Whether a block is a comment alone.
const fn is_remark(block: &Block) -> bool {
    matches!(block.kind, BlockKind::Comment | BlockKind::Structure(_))
}

/// Whether a block begins another part: a comment, a tool call, a label.
fn ends_part(block: &Block) -> bool {
    is_remark(block) || matches!(block.kind, BlockKind::ToolCall(_) | BlockKind::Lbl(_) | BlockKind::EndPgm(_))
}

/// The only number of a part with two digits exchanged, if the right one is in a comment and not in the part.
fn exchanged_digits(facts: &Facts<'_>, text: &str, part: &[Block], least: usize) -> Option<(Span, f64, f64)> {
    let said = numbers(text, 0);
    let said: Vec<Written> = said.into_iter().filter(|own| own.digits >= least).collect();
    if said.is_empty() {
        return None;
    }
    let all: Vec<Written> = part.iter().flat_map(|block| in_block(facts, block)).collect();
    let same = |one: f64, other: f64| (one.abs() - other.abs()).abs() <= SAME;
    let has = |value: f64| all.iter().any(|own| [1.0, 0.5, 2.0].iter().any(|by| same(own.value * by, value)));
    said.iter().filter(|own| !has(own.value)).find_map(|own| {
        let stated = |value: f64| said.iter().any(|other| same(other.value, value));
        let mut slips = all.iter().filter(|other| exchanged(other.value.abs(), own.value) && !stated(other.value));
        let first = slips.next()?;
        slips.all(|other| same(other.value, first.value)).then_some((first.span, first.value, own.value))
    })
}

/// The numbers of a block without its comments.
fn in_block(facts: &Facts<'_>, block: &Block) -> Vec<Written> {
    if is_remark(block) {
        return Vec::new();
    }
    let span = Span::new(facts.content(block).start, block.span.end);
    let lines = facts.text(span).split_inclusive('\n').scan(span.start, |at, line| {
        let from = *at;
        *at += line.len();
        Some((from, line))
    });
    lines.flat_map(|(from, line)| numbers(line.split(';').next().unwrap_or_default(), from)).collect()
}

/// The numbers in a text without those of parameters, tools, functions, labels, feeds and speeds.
fn numbers(text: &str, start: usize) -> Vec<Written> {
    let bytes = text.as_bytes();
    let mut found = Vec::new();
    let mut at = 0;
    while at < bytes.len() {
        let begin = at;
        let is_part = |sign: &u8| sign.is_ascii_digit() || matches!(sign, b'.' | b',');
        if !bytes[at].is_ascii_digit() {
            at += 1;
            continue;
        }
        while bytes.get(at).is_some_and(is_part) {
            at += 1;
        }
        let own = text[begin..at].trim_end_matches(['.', ',']);
        let before = text[..begin].trim_end_matches(['+', '-']).chars().next_back();
        let hidden = before.is_some_and(|sign| "QLSFMTN".contains(sign.to_ascii_uppercase()));
        // The number of a cycle is its name.
        let hidden = hidden || ["CYCL DEF", "TCH PROBE"].iter().any(|own| text[..begin].trim_end().ends_with(own));
        let Ok(value) = own.replace(',', ".").parse::<f64>() else { continue };
        let digits = own.trim_start_matches(['0', '.', ',']).bytes().filter(u8::is_ascii_digit).count();
        if !hidden {
            found.push(Written { value, span: Span::new(start + begin, start + begin + own.len()), digits });
        }
    }
    found
}

/// The result of a block and the one that its comment states after an equals sign, if they differ.
fn other_result(facts: &Facts<'_>, index: usize, text: &str) -> Option<(f64, f64)> {
    let blocks = facts.program.blocks();
    let target = |block: &Block| match &block.kind {
        BlockKind::FnAssign(own) => Some(own.target),
        BlockKind::Formula(own) => Some(own.target),
        _ => None,
    };
    let q = target(blocks.get(index)?)?;
    let (_, stated) = text.rsplit_once('=')?;
    let stated = stated.trim().trim_end_matches("MM").trim();
    let digits = stated.rsplit_once(['.', ',']).map_or(0, |(_, digits)| digits.len());
    let value: f64 = stated.replace(',', ".").parse().ok()?;
    // The first block that reads it shows what it is.
    let mut read = Vec::new();
    for block in blocks.get(index + 1..)? {
        read.clear();
        reads(block, &mut read);
        if let Some((_, span)) = read.iter().find(|(own, _)| *own == q) {
            let own = facts.known_at(*span, false)?;
            let last = (0..digits).fold(0.5, |last, _| last / 10.0);
            return ((own - value).abs() > last + SAME).then_some((own, value));
        }
        if target(block) == Some(q) {
            return None;
        }
    }
    None
}

/// A result that the first block of a part reads, while the comment above names another one that no block of the part reads.
fn other_parameter(text: &str, part: &[Block]) -> Option<(Span, QRef, QRef)> {
    let upper = text.to_ascii_uppercase();
    let words = upper.split(|sign: char| !sign.is_ascii_alphanumeric());
    let named = words.filter_map(|word| word.strip_prefix('Q')?.parse::<u16>().ok()).map(QRef::q);
    let is_result = |q: &QRef| q.kind == QKind::Q && RESULTS.contains(&q.number);
    let mut named = named.filter(is_result);
    let (only, None) = (named.next()?, named.next()) else { return None };
    let mut all = Vec::new();
    part.iter().for_each(|block| reads(block, &mut all));
    let first = part.iter().find(|block| !is_remark(block) && !matches!(block.kind, BlockKind::Empty))?;
    let mut read = Vec::new();
    reads(first, &mut read);
    let mut read = read.into_iter().filter(|(q, _)| is_result(q));
    let ((other, span), None) = (read.next()?, read.next()) else { return None };
    (!all.iter().any(|(q, _)| *q == only)).then_some((span, other, only))
}

/// A scaling factor that is none for the only percentage in the comments.
fn shrinkage(facts: &Facts<'_>) -> Option<(Span, f64, f64)> {
    let percent = |block: &Block| {
        let (before, _) = comment(facts, block)?.split_once('%')?;
        let number =
            before.trim_end().rsplit(|sign: char| !(sign.is_ascii_digit() || sign == '.' || sign == ',')).next()?;
        number.replace(',', ".").parse::<f64>().ok().filter(|own| *own > 0.0 && *own <= SHRINKAGE)
    };
    let mut stated = facts.program.blocks().iter().filter_map(percent);
    let only = stated.next().filter(|first| stated.all(|other| other == *first))? / 100.0;
    let factors = facts.program.blocks().iter().filter_map(|block| match &block.kind {
        BlockKind::OldCycleLine(own) => own.words.iter().find(|word| facts.text(word.name).trim() == "SCL"),
        _ => None,
    });
    let mut factors = factors.filter_map(|word| match word.value.kind {
        ValueKind::Number(factor) if factor != 1.0 => Some((factor, word.value.span)),
        _ => None,
    });
    let (factor, span) = factors.next().filter(|_| factors.next().is_none())?;
    let fits = [1.0 + only, 1.0 - only, 1.0 / (1.0 + only), 1.0 / (1.0 - only)];
    // A percentage may be rounded.
    let near = |own: &f64| (own - factor).abs() <= 0.1 * only;
    (!fits.iter().any(near)).then_some((span, factor, only * 100.0))
}

/// The place of a tool call with which one hole more or less is made than comments count, with both numbers.
fn holes(facts: &Facts<'_>, header: usize) -> Option<(Span, f64, f64)> {
    let made: Vec<(Span, usize)> = incidents(facts)
        .iter()
        .filter_map(|(span, own)| match own {
            Incident::HolesMade(count) => Some((*span, *count)),
            _ => None,
        })
        .collect();
    let blocks = facts.program.blocks();
    let said = |part: &[Block]| -> Vec<usize> {
        part.iter().filter_map(|block| comment(facts, block)).flat_map(counts).collect()
    };
    let all = said(blocks.get(..header)?);
    let differs = |count: usize, said: &[usize]| {
        let fits = said.iter().any(|own| count.is_multiple_of(*own)) || said.iter().sum::<usize>() == count;
        said.iter().copied().find(|own| !fits && own.abs_diff(count) == 1)
    };
    // What the head of the program says is said of some tools.
    let head = || {
        let fits = |own: &usize| made.iter().any(|(_, count)| count.is_multiple_of(*own));
        let open: Vec<usize> = all.iter().copied().filter(|own| !fits(own)).collect();
        made.iter().find_map(|(span, count)| Some((*span, *count, differs(*count, &open)?)))
    };
    let own = made.iter().find_map(|(span, count)| {
        let at = blocks.iter().position(|block| facts.content(block) == *span)?;
        let calls = |block: &Block| matches!(block.kind, BlockKind::ToolCall(_));
        let end = blocks.iter().skip(at + 1).position(calls).map_or(blocks.len(), |next| at + 1 + next);
        let begin = at - blocks.get(..at)?.iter().rev().take_while(|block| is_remark(block)).count();
        Some((*span, *count, differs(*count, &said(blocks.get(begin..end)?))?))
    });
    let (span, made, said) = own.or_else(head)?;
    Some((span, made as f64, said as f64))
}

/// The numbers of holes in a comment: `6 HOLES`, `4 x M8`, `8X D6.6`.
fn counts(text: &str) -> Vec<usize> {
    let upper = text.to_uppercase();
    let words: Vec<&str> = upper.split_whitespace().collect();
    let named = |word: &str| {
        let size =
            word.strip_prefix(['M', 'D', 'Ø']).is_some_and(|rest| rest.starts_with(|own: char| own.is_ascii_digit()));
        size || HOLE_WORDS.iter().any(|own| word.starts_with(own))
    };
    let number = |word: &str| word.parse().ok().filter(|own| (HOLES[0]..=HOLES[1]).contains(own));
    let mut found = Vec::new();
    for (at, word) in words.iter().enumerate() {
        let (count, joined) = word.split_once(['X', '×']).unwrap_or((word, ""));
        let Some(count) = number(count) else { continue };
        let next = words.get(at + 1).copied().unwrap_or_default();
        let after = if word.len() == count.to_string().len() && matches!(next, "X" | "×" | "*") {
            words.get(at + 2).copied().unwrap_or_default()
        } else {
            next
        };
        if named(if joined.is_empty() { after } else { joined }) {
            found.push(count);
        }
    }
    found
}
