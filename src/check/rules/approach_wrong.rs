//! An approach or a departure that the control cannot calculate, or that spoils the contour: the start or end point is
//! inside of the arc that leads to the contour, or the tool has plunged at the first point of a contour. Also a contour that
//! is approached with APPR and not left with DEP before the tool moves along its axis, be it after the call of a subprogram.
//!
//! Places are followed from label to label in programs with a box as their blank. Without a known radius of the tool it is
//! taken to be at most 10 mm. Each is said once a program.
use crate::base::diag::{Arg, Diagnostic, Severity};
use crate::check::incident::Incident;
use crate::check::program::is_silent;
use crate::check::travel::incidents;
use crate::check::{Aspect, Facts, Rule, Tri, Way};
use crate::program::syntax::{Axis, Block, BlockKind, Compensates, Path};

pub(super) const RULE: Rule = Rule { code: "approach-wrong", severity: Severity::Warning, run };

/// So many subprograms are looked at that end beside a contour.
const PATIENCE: usize = 64;

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let (mut arc, mut plunged) = (false, false);
    for (span, own) in incidents(facts) {
        let (what, radius, said) = match own {
            Incident::ArcInMaterial(radius) => ("arc", *radius, &mut arc),
            Incident::ContourStartsAtPlunge => ("plunged", 0.0, &mut plunged),
            _ => continue,
        };
        if !std::mem::replace(said, true) {
            found.push(rule.at(facts, *span).arg("what", what).arg("value", Arg::Number(radius)));
        }
    }
    if let Some(block) = left(facts) {
        found.push(rule.at(facts, facts.content(block)).arg("what", "left").arg("value", Arg::Number(0.0)));
    }
}

/// The first block that moves the tool along its axis, without compensation, from a contour that was approached with APPR.
fn left<'a>(facts: &Facts<'a>) -> Option<&'a Block> {
    facts.shaped().next()?;
    let (mut open, mut patience) = (false, PATIENCE);
    for (from, to, modal) in facts.run.stretches() {
        let upright = modal.is_some_and(|modal| modal.is(Aspect::OtherAxis) != Tri::Yes);
        for block in facts.program.blocks().get(from..to).unwrap_or_default().iter().filter(|own| !is_silent(own)) {
            let motion = match &block.kind {
                BlockKind::Motion(motion) if upright && !block.skip => motion,
                // A repeated part goes on with what follows it.
                BlockKind::CallLbl(call) if call.repeat.is_some() => continue,
                BlockKind::Functions(_) if !facts.ends(block) => continue,
                _ => {
                    if open && block.ends_subprogram() && patience > 0 {
                        patience -= 1;
                        if is_lifted_after(facts, block) {
                            return Some(block);
                        }
                    }
                    open = false;
                    continue;
                }
            };
            let compensates = motion.outline().compensates();
            match motion.path() {
                Path::Appr(_) => open = compensates == Compensates::Beside,
                Path::Dep(_) => open = false,
                _ if open && compensates == Compensates::Off => {
                    open = false;
                    if matches!(motion.words().coords.as_slice(), [only] if only.axis == Axis::Z) {
                        return Some(block);
                    }
                }
                _ => {}
            }
        }
    }
    None
}

/// Whether each call of the subprogram that a block ends is directly followed by a movement along the tool axis without
/// compensation.
fn is_lifted_after(facts: &Facts<'_>, end: &Block) -> bool {
    let blocks = facts.program.blocks();
    let graph = &facts.run.graph;
    let at = blocks.partition_point(|block| block.span.start < end.span.start);
    // The label of the subprogram is the last one before its end.
    let start =
        blocks.get(..at).and_then(|before| before.iter().rposition(|block| matches!(block.kind, BlockKind::Lbl(_))));
    let Some(start) = start else { return false };
    let calls = graph.uses.iter().filter(|own| own.mark.as_ref().and_then(|mark| graph.block_of(mark)) == Some(start));
    let mut any = false;
    for call in calls {
        let after = blocks.get(call.block + 1..).unwrap_or_default();
        let lifts = match after.iter().find(|block| !is_silent(block)).map(|block| &block.kind) {
            Some(BlockKind::Motion(motion)) => {
                let words = motion.words();
                motion.path() == Path::L
                    && motion.outline().compensates() == Compensates::Off
                    && matches!(words.coords.as_slice(), [only] if only.axis == Axis::Z)
            }
            _ => false,
        };
        if call.way != Way::Call || !lifts {
            return false;
        }
        any = true;
    }
    any
}
