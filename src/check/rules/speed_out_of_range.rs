//! A spindle speed or feed in a tool call that is negative, or above what a control lets anybody enter.
//!
//! The manuals print greatest speeds and feeds for the parameters of cycles; the widest of them is the limit here.
//! Silent where no manual of the control, nor of another one, prints any.
use crate::base::diag::{Arg, Diagnostic, Severity};
use crate::check::{Facts, Rule};
use crate::program::syntax::{BlockKind, FeedKind};
use crate::spec::MM_PER_INCH;

pub(super) const RULE: Rule = Rule { code: "speed-out-of-range", severity: Severity::Warning, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let limits = facts.against.labels.limits(facts.against.catalogue);
    for (_, block) in facts.marked() {
        let BlockKind::ToolCall(call) = &block.kind else { continue };
        let fed = match call.feed.as_ref().map(|feed| &feed.kind) {
            Some(FeedKind::Value(feed)) => Some(feed),
            _ => None,
        };
        let unit = if facts.inch { MM_PER_INCH } else { 1.0 };
        let written = [(call.speed.as_ref(), limits.speed, 1.0, "speed"), (fed, limits.feed, unit, "feed")];
        for (operand, limit, unit, what) in written {
            let Some((operand, limit)) = operand.zip(limit) else { continue };
            let Some(value) = facts.number(operand) else { continue };
            let side = match value * unit {
                value if value < 0.0 => "below",
                value if value > limit => "above",
                _ => continue,
            };
            let finding = rule.at(facts, operand.span).arg("what", what).arg("side", side);
            let finding = finding.arg("value", Arg::Number(value));
            found.push(finding.arg("limit", Arg::Number(limit / unit)));
        }
    }
}
