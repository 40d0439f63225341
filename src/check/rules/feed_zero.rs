//! A movement with the feed F0, be it that of a parameter where an execution shows it.
//!
//! Tool calls with F0 are passed over: they only unload a tool.
use crate::base::diag::{Diagnostic, Severity};
use crate::check::incident::Incident;
use crate::check::travel::first_incident;
use crate::check::{Facts, Rule};
use crate::program::syntax::{Amount, BlockKind, FeedKind};

pub(super) const RULE: Rule = Rule { code: "feed-zero", severity: Severity::Warning, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    for block in facts.program.blocks() {
        let BlockKind::Motion(motion) = &block.kind else { continue };
        if !motion.outline().has_feed() || !may_be_zero(facts.text(block.span)) {
            continue;
        }
        let Some(feed) = motion.words().feed else { continue };
        let (FeedKind::Value(own) | FeedKind::PerRevolution(own) | FeedKind::PerTooth(own)) = feed.kind else {
            continue;
        };
        if own.amount == Amount::Number(0.0) {
            found.push(rule.at(facts, feed.span));
        }
    }
    executed(rule, facts, found);
}

/// A movement for which a parameter has brought the feed 0.
fn executed(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let first = first_incident(facts, |own| (own == Incident::NoFeed).then_some(()));
    if let Some((span, ())) =
        first.filter(|_| found.iter().all(|own| own.code != rule.code && own.code != "feed-missing"))
    {
        found.push(rule.at(facts, span));
    }
}

/// Whether an `F` is in the text that no digit but 0 follows. Long programs have millions of feeds.
fn may_be_zero(text: &str) -> bool {
    let bytes = text.as_bytes();
    memchr::memchr2_iter(b'F', b'f', bytes).any(|at| {
        let mut after = bytes.get(at + 1..).unwrap_or_default().iter();
        !after.find(|byte| !matches!(byte, b' ' | b'+' | b'A'..=b'Z')).is_some_and(|byte| matches!(byte, b'1'..=b'9'))
    })
}
