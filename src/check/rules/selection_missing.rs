//! CALL SELECTED PGM or CALL SELECTED CYCLE that no SEL PGM or SEL CYCLE precedes.
//!
//! Only said where no way of the run has selected a program.
use crate::check::{Aspect, Facts, Rule, Tri};
use crate::diag::{Diagnostic, Severity};
use crate::syntax::{BlockKind, StatementKind};

pub(super) const RULE: Rule = Rule { code: "selection-missing", severity: Severity::Warning, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    for (index, block) in facts.marked() {
        let BlockKind::Statement(own) = &block.kind else { continue };
        if own.kind == StatementKind::CallSelected
            && facts.run.before(index).is_some_and(|modal| modal.is(Aspect::Selected) == Tri::No)
            && !facts.text(facts.content(block)).to_ascii_uppercase().contains("CONTOUR")
        {
            found.push(rule.at(facts, facts.content(block)));
        }
    }
}
