//! CYCL CALL PAT before anything has defined or selected a pattern.
use crate::base::diag::{Diagnostic, Severity};
use crate::check::{Aspect, Facts, Rule, Tri};
use crate::program::syntax::{BlockKind, CallForm};

pub(super) const RULE: Rule = Rule { code: "pattern-missing", severity: Severity::Error, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let mut last = None;
    for call in facts.run.calls.iter().filter(|call| call.modal.is(Aspect::Pattern) == Tri::No) {
        let block = facts.program.blocks().get(call.block);
        if let Some(BlockKind::CyclCall(written)) = block.map(|block| &block.kind)
            && matches!(written.form, CallForm::Pattern)
            && last.replace(call.span) != Some(call.span)
        {
            found.push(rule.at(facts, call.span).arg("name", "none"));
        }
    }
}
