//! An approach to a contour (APPR) while radius compensation is certainly active: the contour before it was not left.
//!
//! Also a call of a subprogram that begins a contour with RL or RR while the compensation of the call before it is still
//! active: of two calls of the same subprogram, only the second one finds it so.
use std::collections::BTreeMap;

use crate::base::diag::{Diagnostic, Severity};
use crate::check::{Aspect, Facts, Rule, Tri};
use crate::program::syntax::{Block, BlockKind, Compensates, Path};

pub(super) const RULE: Rule = Rule { code: "approach-twice", severity: Severity::Warning, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    for (index, block) in facts.shaped() {
        if let BlockKind::Motion(motion) = &block.kind
            && matches!(motion.path(), Path::Appr(_))
            && facts.run.before(index).is_some_and(|modal| modal.is(Aspect::Compensation) == Tri::Yes)
        {
            found.push(rule.at(facts, facts.content(block)).arg("what", "approach"));
        }
    }
    let mut calls: BTreeMap<usize, bool> = BTreeMap::new();
    for (index, block) in facts.marked() {
        let BlockKind::CallLbl(call) = &block.kind else { continue };
        let Some(label) = facts.run.graph.called_from(index).filter(|_| call.repeat.is_none() && !block.skip) else {
            continue;
        };
        match facts.run.before(index).map(|modal| modal.is(Aspect::Compensation)) {
            Some(Tri::No) => {
                calls.insert(label, true);
            }
            Some(Tri::Yes) if calls.get(&label) == Some(&true) && begins(facts, label) => {
                found.push(rule.at(facts, facts.content(block)).arg("what", "call"));
                return;
            }
            _ => {}
        }
    }
}

/// Whether the first movement of a subprogram that says anything of compensation begins it.
fn begins(facts: &Facts<'_>, label: usize) -> bool {
    let says = |block: &Block| match &block.kind {
        BlockKind::Motion(motion) => {
            Some(motion.outline().compensates()).filter(|own| *own != Compensates::Unsaid && !block.skip)
        }
        _ => None,
    };
    let body = facts.subprogram(label).unwrap_or_default();
    body.iter().find_map(says) == Some(Compensates::Beside)
}
