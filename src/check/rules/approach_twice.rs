//! An approach to a contour (APPR) while radius compensation is certainly active: the contour before it was not left.
use crate::base::diag::{Diagnostic, Severity};
use crate::check::{Aspect, Facts, Rule, Tri};
use crate::program::syntax::{BlockKind, Path};

pub(super) const RULE: Rule = Rule { code: "approach-twice", severity: Severity::Warning, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    for (index, block) in facts.shaped() {
        if let BlockKind::Motion(motion) = &block.kind
            && matches!(motion.path(), Path::Appr(_))
            && facts.run.before(index).is_some_and(|modal| modal.is(Aspect::Compensation) == Tri::Yes)
        {
            found.push(rule.at(facts, facts.content(block)));
        }
    }
}
