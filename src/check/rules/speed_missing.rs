//! The spindle is turned on before any tool call has given a speed.
//!
//! Said once a program.
use crate::check::{Aspect, Facts, Rule, Tri};
use crate::diag::{Diagnostic, Severity};

pub(super) const RULE: Rule = Rule { code: "speed-missing", severity: Severity::Warning, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    for (from, to, modal) in facts.run.stretches() {
        if modal.is_none_or(|modal| modal.is(Aspect::Speed) != Tri::No || modal.is(Aspect::Tool) == Tri::No) {
            continue;
        }
        for block in facts.program.blocks().get(from..to).unwrap_or_default() {
            let functions = facts.functions(block);
            let on = functions.iter().find(|function| matches!(function.number, 3 | 4 | 13 | 14));
            if let Some(function) = on {
                found.push(rule.at(facts, function.span));
                return;
            }
        }
    }
}
