//! A parameter that certainly has a value which the word cannot take: a feed that is not positive,
//! an arc or corner without a radius.
use crate::base::diag::{Arg, Diagnostic, Severity, Span};
use crate::check::{Facts, Rule};
use crate::program::syntax::{Block, BlockKind, Feed, FeedKind, Path};

pub(super) const RULE: Rule = Rule { code: "meaningless-value", severity: Severity::Warning, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    // What is wrong with the block that was looked at last.
    let mut last = (usize::MAX, None);
    for span in facts.run.odd.iter().copied() {
        let at = facts.program.blocks().partition_point(|block| block.span.end <= span.start);
        let Some(block) = facts.program.blocks().get(at) else { continue };
        if last.0 != at {
            last = (at, wrong(facts, block));
        }
        if let Some((place, value)) = last.1.filter(|(place, _)| place.start <= span.start && span.end <= place.end) {
            found.push(rule.at(facts, place).arg("value", Arg::Number(value)));
        }
    }
}

/// What is wrong with a block: where, and the value.
fn wrong(facts: &Facts<'_>, block: &Block) -> Option<(Span, f64)> {
    match &block.kind {
        BlockKind::Motion(motion) => {
            let words = motion.words();
            let fed = words.feed.as_ref().and_then(|feed| fed(facts, feed));
            let round = matches!(words.path, Path::Cr | Path::Rnd | Path::Chf);
            let radius = words.radius.filter(|_| round).and_then(|own| Some((own.span, facts.known(&own)?)));
            let flat = |(_, value): &(Span, f64)| *value == 0.0 || (*value < 0.0 && words.path != Path::Cr);
            fed.or(radius.filter(flat))
        }
        BlockKind::ToolCall(call) => call.feed.as_ref().and_then(|feed| fed(facts, feed)),
        _ => None,
    }
}

/// A feed by a parameter that is certainly not positive.
fn fed(facts: &Facts<'_>, feed: &Feed) -> Option<(Span, f64)> {
    match &feed.kind {
        FeedKind::Value(own) | FeedKind::PerRevolution(own) | FeedKind::PerTooth(own) => {
            facts.known(own).filter(|value| *value <= 0.0).map(|value| (feed.span, value))
        }
        FeedKind::Max | FeedKind::Auto => None,
    }
}
