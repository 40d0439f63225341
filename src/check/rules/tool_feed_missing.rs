//! FAUTO, or AUTO as a value of a cycle, where the tool call has no feed or the feed 0.
//!
//! Only reported where no way of the run has given a feed in a tool call, or where earlier tools had one and this call has
//! none.
use memchr::memmem;

use crate::base::diag::{Diagnostic, Severity, Span};
use crate::check::{Aspect, Facts, Loaded, Rule, Tri};
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
        let missing = facts.run.before(index).is_some_and(|modal| match modal.is(Aspect::ToolFeed) {
            Tri::No => true,
            Tri::Unknown => lacks_feed(facts, modal.loaded),
            Tri::Yes => false,
        });
        if !missing {
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

/// Whether the call of a tool has no feed, though others have one: it is hardly left out on purpose.
fn lacks_feed(facts: &Facts<'_>, loaded: Loaded) -> bool {
    let Loaded::By(block) = loaded else { return false };
    let call = facts.program.blocks().get(block as usize).map(|block| &block.kind);
    matches!(call, Some(BlockKind::ToolCall(call)) if call.feed.is_none() && call.tool.is_some())
}
