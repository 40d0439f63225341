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
use crate::program::syntax::{Block, BlockKind, CycleForm, StatementKind, ValueKind};
use crate::spec::{Keyword, Known};

pub(super) const RULE: Rule = Rule { code: "parameter-unassigned", severity: Severity::Warning, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let mut reported = BTreeSet::new();
    for (q, span) in &facts.run.unset {
        if reported.insert(*q) {
            found.push(rule.at(facts, *span).arg("parameter", q.to_string()));
        }
    }
    for (q, span) in early(facts).into_iter().chain(foreign(facts)).chain(of_cycles(facts)) {
        if reported.insert(q) {
            found.push(rule.at(facts, span).arg("parameter", q.to_string()));
        }
    }
}

/// What is read of the parameters of cycles that no definition of the program has, and nothing in it writes.
///
/// They keep their values from one program to the next, so only those are looked at that no cycle of the program has at
/// all: a typing error in the number of another parameter.
fn of_cycles(facts: &Facts<'_>) -> Vec<(QRef, Span)> {
    let statement =
        |own: &StatementKind| !matches!(own, StatementKind::Plane | StatementKind::Trans | StatementKind::BlkForm);
    let leaves = facts.marked().any(|(_, block)| match &block.kind {
        BlockKind::Statement(own) => statement(&own.kind),
        BlockKind::CallPgm(_) => true,
        _ => false,
    });
    let builders = facts.definitions.iter().any(|own| own.torn || own.related_cycle().is_none());
    if leaves || builders || !facts.begins() || facts.flow.programs || facts.flow.unread.may_assign() {
        return Vec::new();
    }
    let mut known: BTreeSet<QRef> = facts.given.keys().copied().collect();
    for cycle in facts.definitions.iter().filter_map(|own| own.related_cycle()) {
        known.extend(cycle.params.iter().filter_map(|param| param.q));
        known.extend(cycle.file.results.iter().filter_map(|result| result.q));
    }
    let (mut found, mut read) = (Vec::new(), Vec::new());
    for block in facts.program.blocks() {
        read.clear();
        reads(block, &mut read);
        found.extend(read.iter().filter(|(q, _)| q.kind == QKind::Q && OF_CYCLES.contains(&q.number)));
        match &block.kind {
            BlockKind::FnAssign(assign) => _ = known.insert(assign.target),
            BlockKind::Formula(formula) => _ = known.insert(formula.target),
            BlockKind::CycleDef(cycle) => known.extend(cycle.parameters.iter().map(|own| own.q)),
            _ => {}
        }
    }
    found.retain(|(q, _)| !known.contains(q));
    found
}

/// The parameters of cycles (001: 12441-12455).
const OF_CYCLES: std::ops::RangeInclusive<u16> = 200..=599;

/// Where cycles put what they measure (001: 12562); no manual gives those from 123 on anything else.
const RESULTS: std::ops::RangeInclusive<u16> = 123..=199;
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
    let statement = || {
        facts.marked().any(|(_, block)| match &block.kind {
            BlockKind::Statement(own) => !matches!(own.kind, StatementKind::Plane | StatementKind::Trans),
            _ => false,
        })
    };
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
            // These only read.
            BlockKind::Statement(own) if matches!(own.kind, StatementKind::Plane | StatementKind::Trans) => None,
            // What it reads of the control may go into any of them.
            BlockKind::Statement(_) => return found,
            _ => None,
        };
        target.and_then(|target| results.remove(&target));
    }
    found
}
