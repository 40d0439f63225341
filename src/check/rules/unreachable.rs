//! Blocks that the run never comes to: after the end of the main part, and no label leads there.
//!
//! A subprogram that nothing calls may wait for its call, so that is a note; a contour that no cycle names, in a program
//! whose cycles name others, is a warning, and so is a subprogram that was certainly to be called: a call of another one
//! has the remark that stands beside its label, or another one is called twice in a row and does the same again. Silent where a subprogram does not return,
//! which is reported by a rule of its own, and in pieces of programs. Where one calls itself, only what is between the
//! subprograms after the end of the main part is reported.
use crate::base::diag::{Diagnostic, Severity};
use crate::check::program::is_silent;
use crate::check::{Facts, Rule, Way};
use crate::program::syntax::{Axis, Block, BlockKind, Label, Path};

pub(super) const RULE: Rule = Rule { code: "unreachable", severity: Severity::Warning, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    if !facts.begins() || !facts.run.endless_parts().is_empty() {
        return;
    }
    if facts.run.recursive_calls().next().is_some() {
        return after_parts(rule, facts, found);
    }
    let blocks = facts.program.blocks();
    let contours = facts.run.graph.uses.iter().any(|own| own.way == Way::Named);
    let mut ended = false;
    // One part in one piece is reported once.
    let mut reported = false;
    for (from, to, modal) in facts.run.stretches() {
        if modal.is_some() {
            ended |= facts.end.is_some_and(|end| end < to);
            reported = false;
            continue;
        }
        // What a block that cannot be read ends may be come to all the same.
        reported |= from.checked_sub(1).and_then(|at| blocks.get(at)).is_some_and(Block::is_unread);
        for block in blocks.get(from..to).unwrap_or_default() {
            ended |= matches!(block.kind, BlockKind::EndPgm(_));
            if ended {
                reported = false;
                continue;
            }
            let label = match &block.kind {
                BlockKind::Empty | BlockKind::Comment | BlockKind::Structure(_) => continue,
                BlockKind::Lbl(label) if label.target == Label::END => {
                    reported = false;
                    continue;
                }
                BlockKind::Lbl(_) => true,
                // An end after an end does no harm.
                _ if facts.ends(block) => continue,
                _ => false,
            };
            if !reported {
                reported = true;
                let finding = rule.at(facts, facts.content(block)).arg("part", if label { "label" } else { "block" });
                let forgotten = contours && is_contour(facts, block) || !contours && is_forgotten(facts, block);
                let waits = label && !forgotten;
                found.push(Diagnostic { severity: if waits { Severity::Note } else { finding.severity }, ..finding });
            }
        }
    }
}

/// Whether a label is that of a contour: nothing but elements without feed follows to LBL 0.
fn is_contour(facts: &Facts<'_>, label: &Block) -> bool {
    let blocks = facts.program.blocks();
    let at = blocks.partition_point(|own| own.span.start <= label.span.start);
    let mut elements = 0;
    for block in blocks.get(at..).unwrap_or_default() {
        match &block.kind {
            BlockKind::Motion(motion) => {
                if motion.outline().is_rapid() || motion.outline().has_feed() || motion.has_functions() {
                    return false;
                }
                elements += 1;
            }
            _ if block.ends_subprogram() => return elements > 2,
            _ if is_silent(block) => {}
            _ => return false,
        }
    }
    false
}

/// Whether a subprogram that machines was to be called where another one is.
fn is_forgotten(facts: &Facts<'_>, label: &Block) -> bool {
    let blocks = facts.program.blocks();
    let at = blocks.partition_point(|own| own.span.start < label.span.start);
    let machines = facts.subprogram(at).is_some_and(|body| body.iter().any(is_work));
    machines && (is_remarked(facts, label) || is_repeated(facts))
}

/// Whether a block of a subprogram machines.
fn is_work(block: &Block) -> bool {
    match &block.kind {
        BlockKind::Motion(motion) => {
            let outline = motion.outline();
            outline.has_coords() && !outline.is_rapid() || motion.functions().iter().any(|own| own.number == 99)
        }
        BlockKind::CyclCall(_) => true,
        _ => false,
    }
}

/// Whether a call of another subprogram has the remark of this one.
fn is_remarked(facts: &Facts<'_>, label: &Block) -> bool {
    /// Shorter remarks may be anything.
    const LEAST: usize = 4;
    let remark = |block: &Block| {
        let text = facts.text(block.comment()?).trim_start_matches(';').trim().to_uppercase();
        (text.len() >= LEAST).then_some(text)
    };
    let Some(own) = remark(label) else { return false };
    let blocks = facts.program.blocks();
    blocks.iter().enumerate().filter(|(_, block)| matches!(block.kind, BlockKind::CallLbl(_))).any(|(at, block)| {
        let called = || facts.run.graph.called_from(at).and_then(|label| blocks.get(label));
        remark(block).as_ref() == Some(&own) && called().is_some_and(|other| remark(other).as_ref() != Some(&own))
    })
}

/// Whether a subprogram is called twice in a row in the main part, and certainly does the same both times.
fn is_repeated(facts: &Facts<'_>) -> bool {
    let mut last = None;
    for (at, block) in facts.program.blocks().iter().enumerate() {
        match &block.kind {
            _ if facts.ends(block) => return false,
            _ if is_silent(block) || retracts(block) => {}
            BlockKind::CallLbl(call) if call.repeat.is_none() && !block.skip => {
                let label = facts.run.graph.called_from(at);
                let again = |label: usize| facts.subprogram(label).is_some_and(is_same_again);
                if label.is_some() && label == last && label.is_some_and(again) {
                    return true;
                }
                last = label;
            }
            _ => last = None,
        }
    }
    false
}

/// Whether a block only moves the tool along its axis at rapid.
fn retracts(block: &Block) -> bool {
    let BlockKind::Motion(motion) = &block.kind else { return false };
    let straight = motion.path() == Path::L && motion.outline().is_rapid() && motion.outline().has_coords();
    straight && motion.words().coords.iter().all(|own| own.axis == Axis::Z && !own.incremental)
}

/// Whether a subprogram does the same each time, whatever was before: every axis has its place first, and nothing is
/// calculated or transformed.
fn is_same_again(body: &[Block]) -> bool {
    let mut placed: Vec<Axis> = Vec::new();
    body.iter().all(|block| match &block.kind {
        BlockKind::Motion(motion) if motion.path() == Path::Cc => true,
        BlockKind::Motion(motion) => motion.words().coords.iter().all(|coord| {
            let known = placed.contains(&coord.axis);
            placed.push(coord.axis);
            known || !coord.incremental
        }),
        BlockKind::CallLbl(call) => call.repeat.is_some(),
        BlockKind::Lbl(_) | BlockKind::Functions(_) | BlockKind::CyclCall(_) => true,
        _ => is_silent(block),
    })
}

/// The blocks after the end of the main part that are in no subprogram, in a program that only calls.
fn after_parts(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let others =
        facts.run.graph.uses.iter().any(|own| !matches!(own.way, Way::Call | Way::Named) || own.mark.is_none());
    if others || facts.flow.skips || facts.flow.unread.any() {
        return;
    }
    let blocks = facts.program.blocks();
    let Some(main) = blocks.iter().position(|block| facts.ends(block)) else { return };
    let (mut inside, mut reported) = (false, false);
    for block in blocks.get(main + 1..).unwrap_or_default() {
        match &block.kind {
            BlockKind::EndPgm(_) => return,
            BlockKind::Empty | BlockKind::Comment | BlockKind::Structure(_) => {}
            BlockKind::Lbl(label) => (inside, reported) = (label.target != Label::END, false),
            _ if facts.ends(block) || inside || reported => {}
            _ => {
                reported = true;
                found.push(rule.at(facts, facts.content(block)).arg("part", "block"));
            }
        }
    }
}
