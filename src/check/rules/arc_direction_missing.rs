//! An arc C, CR or CP that does not say which way round it goes.
//!
//! The manuals show DR in every such block, and of two arcs through the same points it is the only word that
//! distinguishes them apart.
use crate::base::diag::{Diagnostic, Severity};
use crate::check::{Facts, Rule};
use crate::program::syntax::{BlockKind, Motion, Path};

pub(super) const RULE: Rule = Rule { code: "arc-direction-missing", severity: Severity::Error, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    if !facts.turns {
        return;
    }
    let mut words = Motion::new(Path::L);
    for block in facts.program.blocks() {
        let BlockKind::Motion(motion) = &block.kind else { continue };
        if !matches!(motion.path(), Path::C | Path::Cr | Path::Cp) {
            continue;
        }
        motion.read_into(&mut words);
        if words.counter_clockwise.is_none() {
            found.push(rule.at(facts, facts.content(block)));
        }
    }
}
