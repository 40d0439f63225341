//! Blocks that the run never comes to: after the end of the main part, and no label leads there.
//!
//! A subprogram that nothing calls may wait for its call, so that is a note. Silent where a subprogram does not return,
//! which is reported by a rule of its own, and in pieces of programs. Where one calls itself, only what is between the
//! subprograms after the end of the main part is reported.
use crate::base::diag::{Diagnostic, Severity};
use crate::check::{Facts, Rule, Way};
use crate::program::syntax::{Block, BlockKind, Label};

pub(super) const RULE: Rule = Rule { code: "unreachable", severity: Severity::Warning, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    if !facts.begins() || !facts.run.endless_parts().is_empty() {
        return;
    }
    if facts.run.recursive_calls().next().is_some() {
        return after_parts(rule, facts, found);
    }
    let blocks = facts.program.blocks();
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
                found.push(Diagnostic { severity: if label { Severity::Note } else { finding.severity }, ..finding });
            }
        }
    }
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
