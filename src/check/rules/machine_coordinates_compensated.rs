//! A position in machine coordinates (M91, M92) while radius compensation is certainly active.
use crate::base::diag::{Diagnostic, Severity};
use crate::check::program::each_function;
use crate::check::{Aspect, Facts, Rule, Tri};
use crate::program::syntax::{BlockKind, Compensates};

pub(super) const RULE: Rule = Rule { code: "machine-coordinates-compensated", severity: Severity::Warning, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    for (index, block) in facts.marked() {
        let BlockKind::Motion(motion) = &block.kind else { continue };
        let mut machine = false;
        each_function(block, |number| machine |= matches!(number, 91 | 92));
        if !machine {
            continue;
        }
        let active = match motion.outline().compensates() {
            Compensates::Beside => true,
            Compensates::Unsaid => {
                facts.run.before(index).is_some_and(|modal| modal.is(Aspect::Compensation) == Tri::Yes)
            }
            Compensates::Off | Compensates::Along => false,
        };
        if active {
            found.push(rule.at(facts, facts.content(block)));
        }
    }
}
