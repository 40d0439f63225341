//! A tangential arc (CT, CTP) without a contour element in the plane before it:
//! there is nothing that it could be tangential to.
//!
//! Only reported where what comes before it in the text is a tool call, a cycle, or a movement along the tool axis
//! alone, with the tool axis Z, and after the starting point of a contour that a cycle reads.
use std::collections::BTreeSet;

use crate::base::diag::{Diagnostic, Severity};
use crate::check::contours;
use crate::check::program::is_silent;
use crate::check::{Aspect, Facts, Rule, Tri};
use crate::program::syntax::{Axis, Block, BlockKind, Path};

pub(super) const RULE: Rule = Rule { code: "arc-without-tangent", severity: Severity::Error, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    for (index, block) in facts.shaped() {
        let BlockKind::Motion(motion) = &block.kind else { continue };
        if !matches!(motion.path(), Path::Ct | Path::Ctp) || block.skip {
            continue;
        }
        let passed = |own: &&Block| is_silent(own) || matches!(own.kind, BlockKind::Functions(_)) || is_centre(own);
        let before = facts.program.blocks().get(..index).unwrap_or_default();
        let Some(before) = before.iter().rev().find(|own| !passed(own)) else { continue };
        let z = facts.run.before(index).is_some_and(|modal| modal.is(Aspect::OtherAxis) == Tri::No);
        if z && leads_nowhere(before) {
            found.push(rule.at(facts, facts.content(block)));
        }
    }
    // The same contour may be read by several cycles.
    let mut after_start: BTreeSet<usize> = BTreeSet::new();
    for listed in contours::listed(facts) {
        after_start.extend(listed.contours.iter().filter_map(|contour| second(contour)).map(|block| block.span.start));
    }
    let arcs = facts.shaped().filter(|(_, block)| after_start.contains(&block.span.start));
    found.extend(arcs.map(|(_, block)| rule.at(facts, facts.content(block))));
}

/// The element that begins at the starting point of a contour, if it is a tangential arc.
fn second(contour: &[Block]) -> Option<&Block> {
    let mut movements = contour.iter().filter(|block| matches!(block.kind, BlockKind::Motion(_)) && !is_centre(block));
    let (first, second) = (movements.next()?, movements.next()?);
    let BlockKind::Motion(motion) = &second.kind else { return None };
    let tangential = matches!(motion.path(), Path::Ct | Path::Ctp) && !first.skip && !second.skip;
    (tangential && !leads_nowhere(first)).then_some(second)
}

fn is_centre(block: &Block) -> bool {
    matches!(&block.kind, BlockKind::Motion(motion) if matches!(motion.path(), Path::Cc))
}

/// Whether a block does not lead through the plane of X and Y.
fn leads_nowhere(block: &Block) -> bool {
    match &block.kind {
        BlockKind::ToolCall(_) | BlockKind::CycleDef(_) | BlockKind::OldCycleLine(_) | BlockKind::CyclCall(_) => true,
        BlockKind::Motion(motion) if motion.path() == Path::L => {
            let words = motion.words();
            !words.coords.is_empty() && words.coords.iter().all(|coord| coord.axis == Axis::Z)
        }
        _ => false,
    }
}
