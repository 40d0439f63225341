//! A parameter that is read before anything gives it a value, on every way that the run can take.
//!
//! Only the freely available parameters Q0 to Q99, QS0 to QS99 and local ones are looked at, each once, and only in
//! programs with a blank, or with tools and M2 or M30: others are called, and their callers may fill parameters.
//! Nothing is said behind calls of other programs and cycles of the machine builder. Results of cycles are looked at,
//! too, where a program without jumps reads them before the first cycle that has them.
use std::collections::{BTreeMap, BTreeSet};

use crate::check::flow::reads;
use crate::check::{Facts, Rule};
use crate::diag::{Diagnostic, Severity, Span};
use crate::expr::QRef;
use crate::syntax::BlockKind;

pub(super) const RULE: Rule = Rule { code: "parameter-unassigned", severity: Severity::Warning, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let mut told = BTreeSet::new();
    for (q, span) in &facts.run.unset {
        if told.insert(*q) {
            found.push(rule.at(facts, *span).arg("parameter", q.to_string()));
        }
    }
    for (q, span) in early(facts) {
        if told.insert(q) {
            found.push(rule.at(facts, span).arg("parameter", q.to_string()));
        }
    }
}

/// The results that are read before the cycle that has them, in a program that goes straight on.
fn early(facts: &Facts<'_>) -> Vec<(QRef, Span)> {
    if facts.flow.jumps || facts.flow.programs || facts.flow.unread.assignments || facts.flow.unread.anything {
        return Vec::new();
    }
    let mut results: BTreeMap<QRef, usize> = BTreeMap::new();
    for definition in &facts.definitions {
        let of_cycle = definition.kin().into_iter().flat_map(|cycle| &cycle.file.results);
        for q in of_cycle.filter_map(|result| result.q) {
            results.entry(q).or_insert(definition.view.first);
        }
    }
    let last = results.values().copied().max().unwrap_or_default();
    let (mut found, mut read) = (Vec::new(), Vec::new());
    for (index, block) in facts.program.blocks().get(..last).unwrap_or_default().iter().enumerate() {
        read.clear();
        reads(block, &mut read);
        found.extend(read.iter().filter(|(q, _)| results.get(q).is_some_and(|first| index < *first)));
        let target = match &block.kind {
            BlockKind::FnAssign(assign) => Some(assign.target),
            BlockKind::Formula(formula) => Some(formula.target),
            // What it reads of the control may go into any of them.
            BlockKind::Statement(_) => return found,
            _ => None,
        };
        target.and_then(|target| results.remove(&target));
    }
    found
}
