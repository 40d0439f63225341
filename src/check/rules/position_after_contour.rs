//! The first position in the plane after a contour cycle with one coordinate only, or an incremental one.
//!
//! Such a cycle ends elsewhere than it began, so a coordinate that is not written is not what it was before. Only
//! reported where the position comes after the call in the text and nothing leads away between them, with the tool axis
//! Z.
use std::ops::Range;

use crate::base::diag::{Diagnostic, Severity};
use crate::check::contours::wanted;
use crate::check::{Aspect, Facts, Pending, Rule, Tri};
use crate::program::syntax::{Axis, Block, BlockKind, Motion, Path};

pub(super) const RULE: Rule = Rule { code: "position-after-contour", severity: Severity::Warning, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    // The blocks after which the last position that was found comes first.
    let mut last: Option<(Range<usize>, Option<&Block>)> = None;
    for call in &facts.run.calls {
        let Pending::Definition(index) = call.modal.pending else { continue };
        let Some(definition) = facts.definitions.get(index as usize) else { continue };
        if !wanted(definition).is_some_and(|own| own.displaces) || call.modal.is(Aspect::OtherAxis) != Tri::No {
            continue;
        }
        let known = last.take().filter(|(blocks, _)| blocks.contains(&call.block));
        let (_, block) = last.insert(known.unwrap_or_else(|| {
            let after = facts.program.blocks().get(call.block + 1..).unwrap_or_default();
            let (passed, block) = first_position(after);
            (call.block..call.block + passed + 1, block)
        }));
        if let Some(block) = block {
            found.push(rule.at(facts, facts.content(block)).arg("cycle", definition.key.to_string()));
        }
    }
}

/// The first position in the plane, if it does not say all of it, and how many blocks are passed on the way to it.
fn first_position(after: &[Block]) -> (usize, Option<&Block>) {
    for (passed, block) in after.iter().enumerate() {
        match &block.kind {
            BlockKind::Motion(motion) => {
                let words = motion.words();
                if let Some(complete) = complete(&words) {
                    return (passed, (!complete && !block.skip).then_some(block));
                }
            }
            BlockKind::Empty
            | BlockKind::Comment
            | BlockKind::Structure(_)
            | BlockKind::Functions(_)
            | BlockKind::ToolCall(_)
            | BlockKind::ToolDef(_) => {}
            _ => return (passed, None),
        }
    }
    (after.len(), None)
}

/// Whether a position says both coordinates of the plane; nothing if it does not lead through the plane.
fn complete(motion: &Motion) -> Option<bool> {
    let machine = motion.functions.iter().any(|own| matches!(own.number, 91 | 92));
    let own = |axis| motion.coord(axis);
    let says = |axis| own(axis).is_some_and(|coord| !coord.incremental);
    match motion.path {
        Path::L if own(Axis::X).is_none() && own(Axis::Y).is_none() => None,
        Path::L | Path::Appr(_) => Some(machine || (says(Axis::X) && says(Axis::Y)) || motion.path != Path::L),
        Path::Cc => None,
        _ => Some(true),
    }
}
