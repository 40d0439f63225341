//! A movement at feed before any block has programmed a feed.
//!
//! Reported once a program, and only in programs that name their blank or their tools. After cycles, other programs and
//! functions that may bring a feed nothing is reported.
use crate::base::diag::{Diagnostic, Severity};
use crate::check::{Aspect, Facts, Rule, Tri};
use crate::program::syntax::{BlockKind, Path};

pub(super) const RULE: Rule = Rule { code: "feed-missing", severity: Severity::Error, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    for (from, to, modal) in facts.run.stretches() {
        if modal.is_none_or(|modal| modal.is(Aspect::Feed) != Tri::No) {
            continue;
        }
        for block in facts.program.blocks().get(from..to).unwrap_or_default() {
            let BlockKind::Motion(motion) = &block.kind else { continue };
            let moves = !matches!(motion.path(), Path::Cc | Path::Fpol) && motion.outline().has_coords();
            if moves && !motion.outline().has_feed() && !motion.outline().is_rapid() {
                found.push(rule.at(facts, facts.content(block)));
                return;
            }
        }
    }
}
