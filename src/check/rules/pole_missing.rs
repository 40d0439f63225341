//! A circle about a centre, or a movement in polar coordinates, before any CC.
//!
//! Said once a program, and only in programs that name their blank or their tools.
use crate::check::{Aspect, Facts, Rule, Tri};
use crate::diag::{Diagnostic, Severity};
use crate::syntax::{BlockKind, Path};

pub(super) const RULE: Rule = Rule { code: "pole-missing", severity: Severity::Error, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    for (from, to, modal) in facts.run.stretches() {
        if modal.is_none_or(|modal| modal.is(Aspect::Pole) != Tri::No) {
            continue;
        }
        for block in facts.program.blocks().get(from..to).unwrap_or_default() {
            let BlockKind::Motion(motion) = &block.kind else { continue };
            if matches!(motion.path(), Path::C | Path::Cp | Path::Lp | Path::Ctp) {
                found.push(rule.at(facts, facts.content(block)));
                return;
            }
        }
    }
}
