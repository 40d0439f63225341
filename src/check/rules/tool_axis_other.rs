//! A tool axis that does not fit: PATTERN DEF with another one than Z,
//! a first tool call with another axis than the blank, or a later one whose tool is only moved along that of the blank.
//!
//! A pattern is reported where the axis is certain, also where it is called. An angular head may well have another axis
//! than the blank names, so only a program in which no tool has the axis of the blank is reported, and a tool that rapid
//! movements along one axis alone lift along that of the blank, and never along its own.
use crate::base::diag::{Diagnostic, Severity};
use crate::check::cycle::removes_material;
use crate::check::{Aspect, Defined, Facts, Rule, Tri};
use crate::program::syntax::{Axis, Block, BlockKind, CallForm, Path};

pub(super) const RULE: Rule = Rule { code: "tool-axis-other", severity: Severity::Warning, run };

/// So many movements say along which axis a tool is lifted.
const LIFTS: usize = 2;

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let (mut blank, mut first, mut fits): (_, Option<(&Block, Axis)>, _) = (None, None, false);
    // Whether there is a pattern of which the axis was right where it was defined.
    let mut pattern = false;
    let mut others: Vec<(usize, &Block, Axis)> = Vec::new();
    for (index, block) in facts.marked() {
        let other = || facts.run.before(index).is_some_and(|modal| modal.is(Aspect::OtherAxis) == Tri::Yes);
        match &block.kind {
            BlockKind::BlkForm(own) => blank = blank.or(own.axis),
            BlockKind::ToolCall(own) => {
                if let Some(axis) = own.axis {
                    fits |= blank.is_none_or(|blank| blank == axis);
                    first = first.or(Some((block, axis)));
                    if blank.is_some_and(|blank| blank != axis) {
                        others.push((index, block, axis));
                    }
                }
            }
            BlockKind::PatternDef(_) => {
                pattern = !other();
                if !pattern {
                    found.push(rule.at(facts, facts.content(block)).arg("what", "pattern").arg("axis", "Z"));
                }
            }
            BlockKind::Sel(_) => pattern = false,
            BlockKind::CyclCall(call) if matches!(call.form, CallForm::Pattern) && pattern && other() => {
                pattern = false;
                found.push(rule.at(facts, facts.content(block)).arg("what", "pattern").arg("axis", "Z"));
            }
            _ => {}
        }
    }
    // Without a blank the first tool says along which axis the workpiece is machined.
    let usual = first.map(|(_, axis)| axis).filter(|_| blank.is_none());
    if let Some(usual) = usual {
        others = called_otherwise(facts, usual);
    }
    let Some(blank) = blank.or(usual) else { return };
    // The blank of a part that is turned lies in the plane of turning, whatever is drilled into it.
    if facts.run.stretches().any(|(.., modal)| modal.is_some_and(|own| own.is(Aspect::Turning) == Tri::Yes)) {
        return;
    }
    if let (Some((block, _)), false, None) = (first, fits, usual) {
        found.push(rule.at(facts, facts.content(block)).arg("what", "blank").arg("axis", blank.name()));
        return;
    }
    for (index, block, axis) in others {
        // A single one will do where the tool machines.
        let least = if machines(facts, index) { 1 } else { LIFTS };
        if lifts(facts, index, blank) >= least && lifts(facts, index, axis) == 0 {
            found.push(rule.at(facts, facts.content(block)).arg("what", "lifted").arg("axis", blank.name()));
        }
    }
}

/// The tool calls with another axis than the usual one, where that is by far the usual one.
fn called_otherwise<'f>(facts: &'f Facts<'_>, usual: Axis) -> Vec<(usize, &'f Block, Axis)> {
    let calls = facts.marked().filter_map(|(index, block)| match &block.kind {
        BlockKind::ToolCall(own) => Some((index, block, own.axis?)),
        _ => None,
    });
    let (same, others): (Vec<_>, Vec<_>) = calls.partition(|(.., axis)| *axis == usual);
    if others.len() < same.len() { others } else { Vec::new() }
}

/// Whether a cycle that removes material is defined for the tool that a block calls.
fn machines(facts: &Facts<'_>, call: usize) -> bool {
    let next = facts
        .marked()
        .find(|(index, block)| *index > call && matches!(&block.kind, BlockKind::ToolCall(own) if own.tool.is_some()));
    let end = next.map_or(usize::MAX, |(index, _)| index);
    let own = facts.definitions.iter().filter(|own| (call..end).contains(&own.view.first));
    own.filter_map(Defined::related_cycle).any(removes_material)
}

/// How many rapid movements move the tool that a block calls along an axis and no other.
fn lifts(facts: &Facts<'_>, call: usize, axis: Axis) -> usize {
    let after = facts.program.blocks().get(call + 1..).unwrap_or_default();
    let part = after.iter().take_while(|block| !matches!(&block.kind, BlockKind::ToolCall(own) if own.tool.is_some()));
    let alone = |block: &&Block| {
        let BlockKind::Motion(motion) = &block.kind else { return false };
        motion.path() == Path::L
            && motion.outline().is_rapid()
            && matches!(motion.words().coords.as_slice(), [only] if only.axis == axis)
    };
    // The block that ends the program may lift, too.
    let mut ended = false;
    part.take_while(|block| !std::mem::replace(&mut ended, facts.ends(block))).filter(alone).count()
}
