//! A movement with the feed F0.
//!
//! Tool calls with F0 are left alone: they only unload a tool.
use crate::check::{Facts, Rule};
use crate::diag::{Diagnostic, Severity};
use crate::syntax::{Amount, BlockKind, FeedKind};

pub(super) const RULE: Rule = Rule { code: "feed-zero", severity: Severity::Warning, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    for block in facts.program.blocks() {
        let BlockKind::Motion(motion) = &block.kind else { continue };
        let Some(feed) = motion.feed else { continue };
        let (FeedKind::Value(own) | FeedKind::PerRevolution(own) | FeedKind::PerTooth(own)) = feed.kind else {
            continue;
        };
        if own.amount == Amount::Number(0.0) {
            found.push(rule.at(facts, feed.span));
        }
    }
}
