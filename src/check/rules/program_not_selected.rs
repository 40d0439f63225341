//! CALL SELECTED PGM or CALL SELECTED CYCLE that no SEL PGM or SEL CYCLE precedes.
//!
//! Only reported where no way of the run has selected a program, or where the whole program selects none.
use crate::base::diag::{Diagnostic, Severity};
use crate::check::{Aspect, Facts, Rule, Tri};
use crate::program::syntax::{BlockKind, StatementKind};

pub(super) const RULE: Rule = Rule { code: "program-not-selected", severity: Severity::Warning, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let selects = facts.marked().any(|(_, block)| matches!(block.kind, BlockKind::Sel(_)));
    let selects = selects || facts.flow.unread.anything || !facts.begins();
    for (index, block) in facts.marked() {
        let BlockKind::Statement(own) = &block.kind else { continue };
        if own.kind == StatementKind::CallSelected
            && (!selects || facts.run.before(index).is_some_and(|modal| modal.is(Aspect::Selected) == Tri::No))
            && !facts.text(facts.content(block)).to_ascii_uppercase().contains("CONTOUR")
        {
            found.push(rule.at(facts, facts.content(block)));
        }
    }
}
