//! A block with an `R` or `F` without a value, or one that ends with an `M` without a number, as older controls and
//! their posts print them.
//!
//! They do nothing. Each is reported once a program.
use memchr::memmem;

use crate::base::diag::{Diagnostic, Severity, Span};
use crate::check::{Facts, Rule};
use crate::program::syntax::{BlockKind, Element};

pub(super) const RULE: Rule = Rule { code: "empty-word", severity: Severity::Note, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    for (letter, place) in [("R", alone(facts, b" R")), ("M", function(facts)), ("F", alone(facts, b" F"))] {
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

/// So many of each are looked at: others are words of comments.
const FEW: usize = 1000;

/// The first letter by itself in a movement; a feed may come after its `F` and a blank.
fn alone(facts: &Facts<'_>, word: &[u8; 2]) -> Option<Span> {
    let blocks = facts.program.blocks();
    let text = facts.program.source().text().as_bytes();
    // Long programs have few of them, if any.
    let by_itself = |at: &usize| matches!(text.get(at + word.len()), Some(b' ' | b'\t' | b'\r' | b'\n'));
    for at in memmem::find_iter(text, word).filter(by_itself).take(FEW) {
        let block = blocks.partition_point(|block| block.span.end <= at);
        let moves = |block: &&crate::program::syntax::Block| {
            let before_comment = block.comment().is_none_or(|comment| at < comment.start);
            let fed = |own: &Element| text.get(at + 1) == Some(&b'F') && own.words().feed.is_some();
            let unfed = || matches!(&block.kind, BlockKind::Motion(own) if !fed(own));
            block.span.start <= at && before_comment && unfed()
        };
        if blocks.get(block).is_some_and(|block| moves(&block)) {
            return Some(Span::new(at + 1, at + 2));
        }
    }
    None
}
