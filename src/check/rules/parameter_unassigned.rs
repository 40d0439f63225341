//! A parameter that is read before anything gives it a value, on every way that the run can take.
//!
//! Only the freely available parameters Q0 to Q99, QS0 to QS99 and local ones are looked at, each once, and only in
//! programs with a blank, or with tools and M2 or M30: others are called, and their callers may fill parameters.
//! Nothing is reported after calls of other programs and cycles of the machine builder. Results of cycles are looked
//! at, too, where a program without jumps reads them before the first cycle that has them, or where a program that
//! probes reads one that none of its cycles has.
use std::collections::{BTreeMap, BTreeSet};

use crate::base::diag::{Diagnostic, Severity, Span};
use crate::base::expr::{QKind, QRef};
use crate::check::program::reads;
use crate::check::{Facts, Rule};
use crate::program::syntax::{Block, BlockKind, CycleForm, ValueKind};
use crate::spec::{Keyword, Known};

pub(super) const RULE: Rule = Rule { code: "parameter-unassigned", severity: Severity::Warning, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let mut reported = BTreeSet::new();
    for (q, span) in &facts.run.unset {
        if reported.insert(*q) {
            found.push(rule.at(facts, *span).arg("parameter", q.to_string()));
        }
    }
    for (q, span) in early(facts).into_iter().chain(foreign(facts)) {
        if reported.insert(q) {
            found.push(rule.at(facts, span).arg("parameter", q.to_string()));
        }
    }
}

/// Where cycles put what they measure (001: 12562).
const RESULTS: std::ops::RangeInclusive<u16> = 141..=199;
/// So many parameters a cycle fills from the one on that its definition names.
const FILLED: u16 = 4;

/// What is read of the results of cycles after one that probes, and no cycle of the program has.
fn foreign(facts: &Facts<'_>) -> Vec<(QRef, Span)> {
    let Some(probing) = facts.definitions.iter().find(|own| own.key.keyword == Keyword::TchProbe) else {
        return Vec::new();
    };
    let unclear = |own: &crate::check::Defined<'_>| {
        own.torn
            || matches!(own.known, Known::Builders)
            || own.key.keyword == Keyword::TchProbe && own.related_cycle().is_none()
    };
    let statement = || facts.marked().any(|(_, block)| matches!(block.kind, BlockKind::Statement(_)));
    if facts.flow.unread.may_assign() || facts.definitions.iter().any(unclear) || statement() {
        return Vec::new();
    }
    // Other programs may give them values, after their calls and after what these may lead back to.
    let leaves =
        |block: &Block| matches!(block.kind, BlockKind::CallPgm(_) | BlockKind::Lbl(_) | BlockKind::CallLbl(_));
    let end = match facts.flow.programs {
        true if !facts.begins() => return Vec::new(),
        true => facts.marked().find(|(_, block)| leaves(block)).map_or(0, |(index, _)| index),
        false => usize::MAX,
    };
    let mut known: BTreeSet<QRef> = BTreeSet::new();
    for definition in &facts.definitions {
        let of_cycle = definition.related_cycle().into_iter().flat_map(|cycle| &cycle.file.results);
        known.extend(of_cycle.filter_map(|result| result.q));
        let CycleForm::Lines(lines) = &definition.view.form else { continue };
        for value in lines.iter().flat_map(|line| &line.words).map(|word| word.value.kind) {
            if let ValueKind::Q { q, .. } = value {
                known.extend((0..FILLED).map(|next| QRef { number: q.number.saturating_add(next), ..q }));
            }
        }
    }
    let (mut found, mut read) = (Vec::new(), Vec::new());
    for (index, block) in facts.program.blocks().iter().enumerate().take(end) {
        read.clear();
        // What is read before may be left from another program.
        if index > probing.view.last {
            reads(block, &mut read);
        }
        let result = |q: &QRef| q.kind == QKind::Q && RESULTS.contains(&q.number);
        found.extend(read.iter().filter(|(q, _)| result(q)));
        known.extend(match &block.kind {
            BlockKind::FnAssign(assign) => Some(assign.target),
            BlockKind::Formula(formula) => Some(formula.target),
            _ => None,
        });
    }
    found.retain(|(q, _)| !known.contains(q));
    found
}

/// The results that are read before the cycle that has them, in a program that goes straight on.
fn early(facts: &Facts<'_>) -> Vec<(QRef, Span)> {
    if facts.flow.jumps || facts.flow.programs || facts.flow.unread.may_assign() {
        return Vec::new();
    }
    let mut results: BTreeMap<QRef, usize> = BTreeMap::new();
    for definition in &facts.definitions {
        let of_cycle = definition.related_cycle().into_iter().flat_map(|cycle| &cycle.file.results);
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
