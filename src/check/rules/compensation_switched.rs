//! A contour that changes from RL to RR or back without a block between them that has no compensation.
//!
//! Only reported where the two come one after the other in the text, with movements between them and nothing that
//! another way of the run could come in by.
use crate::base::diag::{Diagnostic, Place, Severity};
use crate::check::{Facts, Rule};
use crate::program::syntax::{Block, BlockKind, Compensates, Compensation, Path};

pub(super) const RULE: Rule = Rule { code: "compensation-switched", severity: Severity::Warning, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let blocks = facts.program.blocks();
    let mut last: Option<(usize, Compensation)> = None;
    for (index, block) in facts.shaped() {
        let BlockKind::Motion(motion) = &block.kind else { continue };
        if block.skip || matches!(motion.path(), Path::Dep(_)) {
            last = None;
        } else if matches!(motion.path(), Path::Appr(_)) {
            let beside = |side: &Compensation| matches!(side, Compensation::Rl | Compensation::Rr);
            last = motion.words().compensation.filter(beside).map(|side| (index, side));
        } else if motion.outline().compensates() == Compensates::Beside
            && let Some(side) = motion.words().compensation
            && let Some((first, _)) = last.replace((index, side)).filter(|(_, other)| *other != side)
            && let Some([before, between @ ..]) = blocks.get(first..index)
            && !between.iter().any(resets)
        {
            let place = Place::new(facts.program.source(), before.span);
            found.push(rule.at(facts, facts.content(block)).related("first-place", place));
        }
    }
}

/// Whether a block may end the compensation before it, or be come to from elsewhere.
fn resets(block: &Block) -> bool {
    match &block.kind {
        BlockKind::Motion(motion) => {
            block.skip || matches!(motion.outline().compensates(), Compensates::Off | Compensates::Along)
        }
        BlockKind::Empty | BlockKind::Comment | BlockKind::Structure(_) | BlockKind::Functions(_) => false,
        _ => true,
    }
}
