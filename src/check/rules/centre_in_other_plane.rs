//! An arc in another plane than its centre: CC names one pair of axes, C leads through another one.
//!
//! Only reported where CC names two axes and the arc after it in the text names two others.
use crate::base::diag::{Diagnostic, Place, Severity};
use crate::check::{Facts, Rule};
use crate::program::syntax::{Axis, Block, BlockKind, Motion, Path};

pub(super) const RULE: Rule = Rule { code: "centre-in-other-plane", severity: Severity::Warning, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    for (index, block) in facts.marked() {
        let BlockKind::Motion(motion) = &block.kind else { continue };
        if motion.path() != Path::Cc || !motion.outline().has_odd_coords() {
            continue;
        }
        let centre = main_axes(&motion.words());
        let after = facts.program.blocks().get(index + 1..).unwrap_or_default();
        let Some((arc, axes)) = first_arc(after) else { continue };
        if centre.len() == 2 && axes.len() == 2 && axes.iter().any(|axis| !centre.contains(axis)) {
            let place = Place::new(facts.program.source(), block.span);
            found.push(rule.at(facts, facts.content(arc)).related("first-place", place));
        }
    }
}

/// The first arc about the centre before another one is set.
fn first_arc(blocks: &[Block]) -> Option<(&Block, Vec<Axis>)> {
    let mut motions = blocks.iter().filter_map(|block| match &block.kind {
        BlockKind::Motion(motion) if matches!(motion.path(), Path::C | Path::Cc | Path::Fpol) => Some((block, motion)),
        _ => None,
    });
    let (block, motion) = motions.next()?;
    (motion.path() == Path::C).then(|| (block, main_axes(&motion.words())))
}

fn main_axes(motion: &Motion) -> Vec<Axis> {
    let main = |axis: &Axis| matches!(axis, Axis::X | Axis::Y | Axis::Z);
    motion.coords.iter().map(|coord| coord.axis).filter(main).collect()
}
