//! A movement at feed before any block has programmed a feed.
//!
//! Reported once a program, and only in programs that name their blank or their tools. After cycles, other programs and
//! functions that may bring a feed nothing is reported. In a subprogram its first call counts, as far as the run can
//! only go one way up to there.
use crate::base::diag::{Diagnostic, Severity};
use crate::check::program::needs_feed;
use crate::check::{Aspect, Facts, Rule, Tri};

pub(super) const RULE: Rule = Rule { code: "feed-missing", severity: Severity::Error, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let unfed = facts.run.stretches().find_map(|(from, to, modal)| {
        let blocks = facts.program.blocks().get(from..to).unwrap_or_default();
        let missing = modal.is_some_and(|modal| modal.is(Aspect::Feed) == Tri::No);
        blocks.iter().find(|block| missing && needs_feed(block))
    });
    let first = || facts.program.blocks().get(facts.run.unfed?);
    if let Some(block) = unfed.or_else(first) {
        found.push(rule.at(facts, facts.content(block)));
    }
}
