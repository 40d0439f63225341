//! Values in a program in inches that look like millimetres: feeds above 10 m/min, a blank of more than 3 m.
//!
//! Each is said once. Feeds that stand for rapid traverse (9998 and more) are left alone.
use crate::check::{Facts, Rule};
use crate::diag::{Arg, Diagnostic, Severity, Span};
use crate::syntax::{Amount, BlockKind, Feed, FeedKind};

pub(super) const RULE: Rule = Rule { code: "metric-values-in-inch", severity: Severity::Warning, run };

/// Feeds of programs in inches are in tenths of an inch per minute.
const FASTEST: std::ops::Range<f64> = 4000.0..9998.0;
/// The farthest corner of a blank, inches.
const FARTHEST: f64 = 120.0;

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    if !facts.inch {
        return;
    }
    let mut feed: Option<(Span, f64)> = None;
    let mut corner: Option<(Span, f64)> = None;
    for block in facts.program.blocks() {
        match &block.kind {
            BlockKind::Motion(motion) if feed.is_none() && motion.outline().has_feed() => {
                feed = fast(motion.words().feed.as_ref());
            }
            BlockKind::ToolCall(call) => feed = feed.or_else(|| fast(call.feed.as_ref())),
            BlockKind::BlkForm(form) => {
                let far = form.coords.iter().filter_map(|coord| match coord.value.amount {
                    Amount::Number(number) if number.abs() > FARTHEST => Some((coord.span, number)),
                    _ => None,
                });
                corner = corner.or_else(|| far.into_iter().next());
            }
            _ => {}
        }
    }
    for (span, value) in corner.into_iter().chain(feed) {
        found.push(rule.at(facts, span).arg("value", Arg::Number(value)));
    }
}

fn fast(feed: Option<&Feed>) -> Option<(Span, f64)> {
    match feed.map(|feed| (feed.span, feed.kind)) {
        Some((span, FeedKind::Value(operand))) => match operand.amount {
            Amount::Number(number) if FASTEST.contains(&number) => Some((span, number)),
            _ => None,
        },
        _ => None,
    }
}
