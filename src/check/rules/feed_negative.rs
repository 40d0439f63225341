//! A movement or tool call with a negative feed.
use memchr::memmem;

use crate::base::diag::{Diagnostic, Severity};
use crate::check::{Facts, Rule};
use crate::program::syntax::{Amount, BlockKind, Feed, FeedKind};

pub(super) const RULE: Rule = Rule { code: "feed-negative", severity: Severity::Error, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let text = facts.program.source().text().as_bytes();
    let blocks = facts.program.blocks();
    let mut last = None;
    // Long programs have millions of feeds and none that is negative: the sign is looked for first.
    for at in memmem::find_iter(text, b"F-").chain(memmem::find_iter(text, b"f-")) {
        let block = blocks.partition_point(|block| block.span.end <= at);
        let Some(own) = blocks.get(block).filter(|_| last.replace(block) != Some(block)) else { continue };
        let feed = match &own.kind {
            BlockKind::Motion(motion) => motion.words().feed,
            BlockKind::CyclCall(call) => call.feed,
            _ => continue,
        };
        if let Some(Feed {
            span,
            kind: FeedKind::Value(value) | FeedKind::PerRevolution(value) | FeedKind::PerTooth(value),
        }) = feed
            && matches!(value.amount, Amount::Number(number) if number < 0.0)
        {
            found.push(rule.at(facts, span));
        }
    }
}
