//! Radius compensation that begins in an arc: controls want a straight line or an approach before the contour.
//!
//! Only reported where compensation is certainly off before the block.
use crate::base::diag::{Diagnostic, Severity};
use crate::check::{Aspect, Facts, Rule, Tri};
use crate::program::syntax::{BlockKind, Compensates, Path};

pub(super) const RULE: Rule = Rule { code: "compensation-on-arc", severity: Severity::Error, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    for (index, block) in facts.shaped() {
        let BlockKind::Motion(motion) = &block.kind else { continue };
        let arc = matches!(motion.path(), Path::C | Path::Cr | Path::Ct | Path::Cp | Path::Ctp);
        if arc && motion.outline().compensates() == Compensates::Beside {
            let before = facts.run.before(index);
            if before.is_some_and(|modal| modal.is(Aspect::Compensation) == Tri::No) {
                found.push(rule.at(facts, facts.content(block)));
            }
        }
    }
}
