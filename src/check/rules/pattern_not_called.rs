//! A pattern at which no cycle is called, while one is called without it before the next pattern: `PAT` is missing in
//! the call, and the cycle works at one place only.
use crate::base::diag::{Diagnostic, Severity};
use crate::check::{Facts, Rule};
use crate::program::syntax::{BlockKind, CallForm};

pub(super) const RULE: Rule = Rule { code: "pattern-not-called", severity: Severity::Warning, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let blocks = facts.program.blocks();
    let names = |index: &usize| match blocks.get(*index).map(|block| &block.kind) {
        Some(BlockKind::PatternDef(_)) => true,
        Some(BlockKind::Sel(own)) => facts.text(own.what).eq_ignore_ascii_case("PATTERN"),
        _ => false,
    };
    let at_pattern = |index: usize| match blocks.get(index).map(|block| &block.kind) {
        Some(BlockKind::CyclCall(own)) => matches!(own.form, CallForm::Pattern),
        _ => false,
    };
    let mut patterns: Vec<usize> = (0..blocks.len()).filter(names).collect();
    if patterns.is_empty() {
        return;
    }
    let called_anywhere = (0..blocks.len()).any(at_pattern);
    patterns.push(blocks.len());
    for pair in patterns.windows(2) {
        let [pattern, next] = *pair else { continue };
        let within = |index: usize| (pattern..next).contains(&index);
        // What is called or jumped to may call at the pattern.
        let leaves = called_anywhere && facts.run.graph.uses.iter().any(|own| within(own.block));
        if leaves || facts.run.before(pattern).is_none() || (pattern..next).any(at_pattern) {
            continue;
        }
        let plain = facts.run.calls.iter().find(|call| within(call.block));
        if let Some(call) = plain {
            found.push(rule.at(facts, call.span).arg("line", pattern_line(facts, pattern)));
        }
    }
}

/// The line of a pattern.
fn pattern_line(facts: &Facts<'_>, index: usize) -> usize {
    facts.program.blocks().get(index).map_or(0, |block| block.line)
}
