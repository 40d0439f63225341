//! A movement at feed before any tool call.
//!
//! Reported once a program, and only in programs that name their blank or their tools; movements in machine coordinates
//! (M91, M92), of rotary axes alone, and of the tool axis in a block that stops spindle or coolant are passed over.
use crate::base::diag::{Diagnostic, Severity};
use crate::check::{Aspect, Facts, Rule, Tri};
use crate::program::syntax::{Axis, BlockKind, Coord, Path};

pub(super) const RULE: Rule = Rule { code: "cutting-without-tool", severity: Severity::Warning, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    for (from, to, modal) in facts.run.stretches() {
        if modal.is_none_or(|modal| modal.is(Aspect::Tool) != Tri::No) {
            continue;
        }
        for block in facts.program.blocks().get(from..to).unwrap_or_default() {
            let BlockKind::Motion(motion) = &block.kind else { continue };
            if motion.outline().is_rapid() {
                continue;
            }
            let motion = motion.words();
            let machine = motion.functions.iter().any(|function| matches!(function.number, 91 | 92));
            let turns = |coord: &Coord| matches!(coord.axis, Axis::A | Axis::B | Axis::C | Axis::U | Axis::V | Axis::W);
            let moves = !matches!(motion.path, Path::Cc | Path::Fpol) && !motion.coords.iter().all(turns);
            // A tool that is still in the spindle is retracted along its axis.
            let retracts = motion.functions.iter().any(|function| matches!(function.number, 5 | 9))
                && motion.coords.iter().all(|coord| coord.axis == Axis::Z);
            if moves && !machine && !retracts {
                found.push(rule.at(facts, facts.content(block)));
                return;
            }
        }
    }
}
