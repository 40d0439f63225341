//! Values in a program in inches that look like millimetres: feeds above 10 m/min, feeds of contours with RL or RR, and
//! of cycles that plunge, of more than a millimetre a revolution, a blank of more than 3 m.
//!
//! Each is said once. Feeds that stand for rapid traverse (9998 and more) are left alone.
use crate::check::{Aspect, Defined, Facts, Rule, Tri};
use crate::diag::{Arg, Diagnostic, Severity, Span};
use crate::spec::{Cycle, Group, Quantity};
use crate::syntax::{Amount, BlockKind, Compensates, CycleDef, Feed, FeedKind, Operand, ValueKind};

pub(super) const RULE: Rule = Rule { code: "metric-values-in-inch", severity: Severity::Warning, run };

/// Feeds of programs in inches are in tenths of an inch per minute.
const FASTEST: std::ops::Range<f64> = 4000.0..9998.0;
/// From here on a feed is measured by the spindle speed.
const FAST: f64 = 1000.0;
/// The greatest feed a revolution, tenths of an inch.
const WIDEST: f64 = 0.4;
/// The meanings of feeds with which cycles plunge.
const CUTTING: [&str; 2] = ["plunging-feed", "contour-plunging-feed"];
/// The farthest corner of a blank, inches.
const FARTHEST: f64 = 120.0;

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    if !facts.inch {
        return;
    }
    let mut feed: Option<(Span, f64)> = None;
    let mut corner: Option<(Span, f64)> = None;
    // Thread cutters may well advance more than a millimetre a revolution.
    let cuts_threads = |own: &Cycle| own.file.group == Group::Threads;
    let kin = |index: usize| facts.definition_at(index).and_then(Defined::kin);
    let mut speed: Option<f64> = None;
    for (index, block) in facts.program.blocks().iter().enumerate() {
        match &block.kind {
            BlockKind::Motion(motion) if feed.is_none() && motion.outline().has_feed() => {
                let own = motion.words().feed;
                let cuts = || {
                    let modal = facts.run.before(index);
                    motion.outline().compensates() == Compensates::Beside
                        || motion.outline().compensates() == Compensates::Unsaid
                            && modal.is_some_and(|modal| modal.is(Aspect::Compensation) == Tri::Yes)
                };
                feed = fast(own.as_ref()).or_else(|| match own.map(|own| (own.span, own.kind)) {
                    Some((span, FeedKind::Value(Operand { amount: Amount::Number(number), .. }))) => {
                        (is_fast(number, speed) && cuts()).then_some((span, number))
                    }
                    _ => None,
                });
            }
            BlockKind::CycleDef(cycle) if feed.is_none() && speed.is_some() => {
                feed = kin(index).filter(|own| !cuts_threads(own)).and_then(|own| fast_in(own, cycle, speed));
            }
            BlockKind::ToolCall(call) => {
                speed = match call.speed.map(|own| own.amount) {
                    Some(Amount::Number(number)) if number > 0.0 => Some(number),
                    _ => None,
                };
                feed = feed.or_else(|| fast(call.feed.as_ref()));
            }
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

/// Whether a feed with which a cycle plunges is hardly one in tenths of an inch a minute.
fn is_fast(number: f64, speed: Option<f64>) -> bool {
    let wide = speed.is_some_and(|speed| (FAST..FASTEST.end).contains(&number) && number / speed > WIDEST);
    FASTEST.contains(&number) || wide
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

/// The first feed into the material among the parameters of a cycle that is too fast.
fn fast_in(cycle: &Cycle, written: &CycleDef, speed: Option<f64>) -> Option<(Span, f64)> {
    written.parameters.iter().find_map(|own| {
        let param = cycle.params.iter().find(|param| param.q == Some(own.q))?;
        let cuts = param.quantity == Quantity::Feed && CUTTING.contains(&param.is.as_str());
        match own.value.kind {
            ValueKind::Number(number) if cuts && is_fast(number, speed) => Some((own.value.span, number)),
            _ => None,
        }
    })
}
