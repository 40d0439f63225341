//! A tool call in which speed and feed are exchanged: the speed is what its cycles and movements have as their feed rate, or
//! the feed is far more for a revolution than any tool, or any drill, takes.
//!
//! Only where the feed is greater than the speed, of tools that are called with both as numbers in programs in mm; taps,
//! whose feed is that of their pitch, are not looked at.
use std::collections::{HashMap, HashSet};

use crate::base::diag::{Arg, Diagnostic, Severity};
use crate::check::program::{number, with_meaning};
use crate::check::tools::kind_of_call;
use crate::check::{Facts, Loaded, Pending, Rule, ToolKind};
use crate::program::syntax::{BlockKind, FeedKind};
use crate::spec::Quantity;

pub(super) const RULE: Rule = Rule { code: "speed-and-feed-exchanged", severity: Severity::Warning, run };

/// More for a revolution no tool takes, mm, and what is doubtful where a feed of the cycles agrees.
const MOST: f64 = 8.0;
const DOUBTFUL: f64 = 1.5;
/// More for a revolution nobody drills, mm.
const DRILLED: f64 = 1.5;
/// The greatest speed that a feed may have been meant as.
const FASTEST: f64 = 60_000.0;
/// Longer programs are written by posts.
const LONGEST: usize = 3_000;
/// The meaning of a pitch.
const PITCH: &str = "thread-pitch";

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    if facts.inch {
        return;
    }
    // The feeds of the cycles that are called with a tool, and whether it cuts threads.
    let mut feeds: HashMap<u32, (Vec<f64>, bool)> = HashMap::new();
    let mut seen = HashSet::new();
    for call in &facts.run.calls {
        let (Pending::Definition(index), Loaded::By(tool)) = (call.modal.pending, call.modal.loaded) else { continue };
        let Some(own) = facts.definitions.get(index as usize).filter(|_| seen.insert((index, tool))) else { continue };
        let related = own.as_related_cycle();
        let read = facts.read(&related);
        let known = feeds.entry(tool).or_default();
        known.1 |= own
            .related_cycle()
            .is_some_and(|cycle| with_meaning(cycle, PITCH).is_some() || with_meaning(cycle, "thread-depth").is_some());
        let of_feeds = read.items.iter().filter(|item| item.param.is_some_and(|own| own.quantity == Quantity::Feed));
        known.0.extend(of_feeds.filter_map(number));
    }
    movements(facts, &mut feeds);
    for (index, block) in facts.marked() {
        let BlockKind::ToolCall(call) = &block.kind else { continue };
        let Some((speed, feed)) = call.speed.as_ref().zip(call.feed.as_ref()) else { continue };
        let FeedKind::Value(value) = feed.kind else { continue };
        let (Some(speed), Some(feed)) = (facts.number(speed), facts.number(&value)) else { continue };
        let known = u32::try_from(index).ok().and_then(|index| feeds.get(&index));
        // No spindle turns faster than that.
        if speed <= 0.0 || feed <= speed || feed > FASTEST || known.is_some_and(|(_, threads)| *threads) {
            continue;
        }
        let ratio = feed / speed;
        let same = |own: &f64| (own - speed).abs() <= 1e-6;
        let agrees = known.is_some_and(|(feeds, _)| feeds.iter().any(same) && !feeds.contains(&feed));
        let drills = kind_of_call(facts, index) == Some(ToolKind::Drill);
        if ratio > if drills { DRILLED } else { MOST } || (ratio > DOUBTFUL && agrees) {
            let finding = rule.at(facts, facts.content(block)).arg("value", Arg::Number(speed));
            found.push(finding.arg("other", Arg::Number(feed)));
        }
    }
}

/// Adds the feeds of the movements that follow tool calls in the text.
fn movements(facts: &Facts<'_>, feeds: &mut HashMap<u32, (Vec<f64>, bool)>) {
    let blocks = facts.program.blocks();
    let mut tool = None;
    for (index, block) in blocks.iter().enumerate().filter(|_| blocks.len() <= LONGEST) {
        match &block.kind {
            BlockKind::ToolCall(call) if call.tool.is_some() => tool = u32::try_from(index).ok(),
            BlockKind::Motion(motion) if motion.outline().has_feed() => {
                let Some(FeedKind::Value(value)) = motion.words().feed.map(|feed| feed.kind) else { continue };
                let number = facts.number(&value);
                if let Some((tool, feed)) = tool.zip(number) {
                    feeds.entry(tool).or_default().0.push(feed);
                }
            }
            _ => {}
        }
    }
}
