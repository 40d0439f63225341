//! A pattern at which no cycle is called, while one is called without it before the next pattern: `PAT` is missing in
//! the call, and the cycle works at one place only. Also a call without it among others with it, where the tool has not been
//! positioned since it was at the pattern.
use std::ops::Range;

use crate::base::diag::{Diagnostic, Severity, Span};
use crate::check::program::is_silent;
use crate::check::{Facts, Rule};
use crate::program::syntax::{Axis, BlockKind, CallForm};

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
    let mut uses: Vec<usize> = facts.run.graph.uses.iter().map(|own| own.block).collect();
    let mut calls: Vec<(usize, Span)> = facts.run.calls.iter().map(|call| (call.block, call.span)).collect();
    uses.sort_unstable();
    calls.sort_unstable_by_key(|(block, _)| *block);
    patterns.push(blocks.len());
    for pair in patterns.windows(2) {
        let [pattern, next] = *pair else { continue };
        // What is called or jumped to may call at the pattern.
        let first = uses.get(uses.partition_point(|block| *block < pattern));
        let leaves = called_anywhere && first.is_some_and(|block| *block < next);
        if (pattern..next).any(at_pattern) {
            unplaced(rule, facts, pattern..next, found);
            continue;
        }
        if leaves || facts.run.before(pattern).is_none() {
            continue;
        }
        let plain = calls.get(calls.partition_point(|(block, _)| *block < pattern));
        if let Some((_, span)) = plain.filter(|(block, _)| *block < next) {
            found.push(rule.at(facts, *span).arg("line", pattern_line(facts, pattern)));
        }
    }
}

/// A plain call after one at the pattern, with no movement in the plane in between.
fn unplaced(rule: &Rule, facts: &Facts<'_>, within: Range<usize>, found: &mut Vec<Diagnostic>) {
    let blocks = facts.program.blocks().get(within.clone()).unwrap_or_default();
    let mut at_pattern = false;
    for block in blocks.iter().filter(|block| !is_silent(block)) {
        match &block.kind {
            BlockKind::CyclCall(own) if matches!(own.form, CallForm::Pattern) => at_pattern = true,
            BlockKind::CyclCall(own) if matches!(own.form, CallForm::Plain) && at_pattern && !block.skip => {
                let finding = rule.at(facts, facts.content(block));
                return found.push(finding.arg("line", pattern_line(facts, within.start)));
            }
            BlockKind::Motion(motion) => {
                let words = motion.words();
                at_pattern &= words.coords.iter().all(|own| own.axis == Axis::Z);
            }
            BlockKind::ToolCall(_) | BlockKind::CycleDef(_) | BlockKind::OldCycleLine(_) | BlockKind::Functions(_) => {}
            _ => at_pattern = false,
        }
    }
}

/// The line of a pattern.
fn pattern_line(facts: &Facts<'_>, index: usize) -> usize {
    facts.program.blocks().get(index).map_or(0, |block| block.line)
}
