//! A block with an `R` or `F` without a value, or one that ends with an `M` without a number, as older controls and their posts
//! print them.
//!
//! They do nothing. Each is said once a program.
use memchr::memmem;

use crate::check::{Facts, Rule};
use crate::diag::{Diagnostic, Severity, Span};
use crate::syntax::BlockKind;

pub(super) const RULE: Rule = Rule { code: "empty-word", severity: Severity::Note, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    for (letter, place) in [("R", alone(facts, &ALONE_R)), ("M", function(facts)), ("F", alone(facts, &ALONE_F))] {
        found.extend(place.map(|span| rule.at(facts, span).arg("word", letter)));
    }
}

/// The first `M` at the end of a block.
fn function(facts: &Facts<'_>) -> Option<Span> {
    let text = facts.program.source().text().as_bytes();
    for (_, block) in facts.marked() {
        if !matches!(block.kind, BlockKind::Motion(_) | BlockKind::CyclCall(_)) {
            continue;
        }
        let end = block.comment().map_or(block.span.end, |comment| comment.start);
        let line = text.get(block.span.start..end).unwrap_or_default().trim_ascii_end();
        if let [.., b' ' | b'\t', b'M' | b'm'] = line {
            let at = block.span.start + line.len();
            return Some(Span::new(at - 1, at));
        }
    }
    None
}

/// An `R` by itself.
const ALONE_R: [&[u8]; 4] = [b" R ", b" R\r", b" R\n", b" R\t"];
/// An `F` by itself.
const ALONE_F: [&[u8]; 4] = [b" F ", b" F\r", b" F\n", b" F\t"];
/// So many of each are looked at: others are words of comments.
const FEW: usize = 1000;

/// The first letter by itself in a movement; a feed may stand behind its `F` and a blank.
fn alone(facts: &Facts<'_>, words: &[&[u8]]) -> Option<Span> {
    let blocks = facts.program.blocks();
    let text = facts.program.source().text().as_bytes();
    // Long programs have few of them, if any: what stands behind the letter is looked for with it.
    let places = words.iter().flat_map(|word| memmem::find_iter(text, word).take(FEW));
    let mut places: Vec<usize> = places.collect();
    places.sort_unstable();
    for at in places {
        let block = blocks.partition_point(|block| block.span.end <= at);
        let moves = |block: &&crate::syntax::Block| {
            let before_comment = block.comment().is_none_or(|comment| at < comment.start);
            let unfed = || matches!(&block.kind, BlockKind::Motion(own) if text.get(at + 1) != Some(&b'F') || own.words().feed.is_none());
            block.span.start <= at && before_comment && unfed()
        };
        if blocks.get(block).is_some_and(|block| moves(&block)) {
            return Some(Span::new(at + 1, at + 2));
        }
    }
    None
}
