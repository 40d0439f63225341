//! FAUTO, or AUTO as a value of a cycle, where the tool call has no feed or the feed 0.
//!
//! Only reported where no way of the run has given a feed in a tool call.
use memchr::memmem;

use crate::base::diag::{Diagnostic, Severity, Span};
use crate::check::{Aspect, Facts, Rule, Tri};
use crate::program::syntax::{BlockKind, FeedKind, Path};

pub(super) const RULE: Rule = Rule { code: "tool-feed-missing", severity: Severity::Warning, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let text = facts.program.source().text().as_bytes();
    let blocks = facts.program.blocks();
    // The values of the definition that was looked at last.
    let mut values: (usize, Vec<Span>) = (usize::MAX, Vec::new());
    for at in memmem::find_iter(text, b"AUTO") {
        let index = blocks.partition_point(|block| block.span.end <= at);
        let Some(block) = blocks.get(index) else { continue };
        if facts.run.before(index).is_none_or(|modal| modal.is(Aspect::ToolFeed) != Tri::No) {
            continue;
        }
        let span = match &block.kind {
            BlockKind::Motion(motion) if motion.path() != Path::Cc => {
                let feed = motion.words().feed.filter(|feed| feed.kind == FeedKind::Auto);
                feed.map(|feed| feed.span)
            }
            BlockKind::CycleDef(cycle) => {
                if values.0 != index {
                    values = (index, cycle.parameters.iter().map(|own| own.value.span).collect());
                }
                values.1.get(values.1.partition_point(|own| own.end <= at)).copied()
            }
            _ => None,
        };
        if let Some(span) = span.filter(|span| (span.start..span.end).contains(&at)) {
            found.push(rule.at(facts, span));
        }
    }
}
