//! FAUTO, or AUTO as a value of a cycle, where the tool call has no feed or the feed 0.
//!
//! Only said where no way of the run has given a feed in a tool call.
use memchr::memmem;

use crate::check::{Aspect, Facts, Rule, Tri};
use crate::diag::{Diagnostic, Severity, Span};
use crate::syntax::{Block, BlockKind, FeedKind, Path};

pub(super) const RULE: Rule = Rule { code: "tool-feed-missing", severity: Severity::Warning, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let text = facts.program.source().text().as_bytes();
    let blocks = facts.program.blocks();
    for at in memmem::find_iter(text, b"AUTO") {
        let index = blocks.partition_point(|block| block.span.end <= at);
        let Some(block) = blocks.get(index) else { continue };
        let without = facts.run.before(index).is_some_and(|modal| modal.is(Aspect::ToolFeed) == Tri::No);
        if let Some(span) = value(block, at).filter(|_| without) {
            found.push(rule.at(facts, span));
        }
    }
}

/// The value of a block that takes the feed of the tool call and has that letter.
fn value(block: &Block, at: usize) -> Option<Span> {
    let holds = |span: Span| (span.start <= at && at < span.end).then_some(span);
    match &block.kind {
        BlockKind::Motion(motion) if motion.path() != Path::Cc => {
            motion.words().feed.filter(|feed| feed.kind == FeedKind::Auto).and_then(|feed| holds(feed.span))
        }
        BlockKind::CycleDef(cycle) => cycle.parameters.iter().find_map(|own| holds(own.value.span)),
        _ => None,
    }
}
