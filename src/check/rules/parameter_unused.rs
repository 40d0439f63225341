//! A parameter that is given a number, or the result of a calculation, and read nowhere: what reads in its place has
//! another number, or the calculation was not finished. Also one that is given to a parameter after the last call of the
//! subprogram which reads it, where each call has its own numbers: the call stands before them.
//!
//! Only Q0 to Q99 and local parameters, in whole programs that call no others and machine by themselves: what others
//! read is not known. Any other mention of the parameter outside of comments counts as reading it.
use std::collections::{BTreeMap, BTreeSet};

use crate::base::diag::{Diagnostic, Severity, Span};
use crate::base::expr::{QKind, QRef};
use crate::check::program::{constant, reads, stops};
use crate::check::{Facts, Rule, Use, Way};
use crate::program::syntax::{Block, BlockKind, StatementKind};
use crate::spec::{Known, ParameterKind};

pub(super) const RULE: Rule = Rule { code: "parameter-unused", severity: Severity::Warning, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let shared = !facts.calls.is_empty() || facts.flow.programs || facts.flow.unread.any() || !facts.begins();
    if shared
        || facts.run.ends.is_empty()
        || facts.definitions.iter().any(|own| own.torn || matches!(own.known, Known::Builders))
    {
        return;
    }
    // Definitions that name a parameter by its number alone read or write it out of sight, and so do statements.
    let hidden = facts.definitions.iter().any(|own| own.has_kind(ParameterKind::QNumber));
    let statement = |kind: &StatementKind| {
        matches!(
            kind,
            StatementKind::Fn(_)
                | StatementKind::Sql
                | StatementKind::Indirect
                | StatementKind::Refused
                | StatementKind::CallSelected
        )
    };
    let mut tool = false;
    for (_, block) in facts.marked() {
        match &block.kind {
            BlockKind::Statement(own) if statement(&own.kind) => return,
            BlockKind::ToolCall(_) => tool = true,
            BlockKind::TextFormula(_) => return,
            _ => {}
        }
    }
    if hidden || !tool {
        return;
    }
    // Where each parameter is given a value first, and how often.
    let mut set: BTreeMap<QRef, (Span, usize)> = BTreeMap::new();
    for (_, block) in facts.marked() {
        let q = match &block.kind {
            BlockKind::FnAssign(own) => own.target,
            BlockKind::Formula(own) => own.target,
            _ => continue,
        };
        if !is_own(q) {
            continue;
        }
        set.entry(q).or_insert((facts.content(block), 0)).1 += 1;
    }
    if set.is_empty() {
        return;
    }
    let mut mentions: BTreeMap<QRef, usize> = BTreeMap::new();
    for block in facts.program.blocks() {
        each_mention(facts.text(block.span), |q| *mentions.entry(q).or_default() += 1);
    }
    for (q, (place, times)) in set {
        if mentions.get(&q).copied() == Some(times) {
            found.push(rule.at(facts, place).arg("what", "never").arg("parameter", q.to_string()));
        }
    }
    if let Some((place, q)) = late(facts) {
        found.push(rule.at(facts, place).arg("what", "late").arg("parameter", q.to_string()));
    }
}

/// The first number that is given to a parameter after the last call of a subprogram, or written over before the next
/// one, where there are as many of them as calls.
fn late(facts: &Facts<'_>) -> Option<(Span, QRef)> {
    /// So many calls make a row.
    const CALLS: usize = 2;
    let (blocks, graph) = (facts.program.blocks(), &facts.run.graph);
    let main = blocks.get(..blocks.iter().position(stops)?)?;
    let jumps = |own: &Use| own.block < main.len() && matches!(own.way, Way::Jump | Way::Repeat);
    let called: BTreeSet<usize> = (0..main.len()).filter_map(|at| graph.called_from(at)).collect();
    let [label] = Vec::from_iter(called)[..] else { return None };
    if graph.uses.iter().any(jumps) {
        return None;
    }
    let mut read = Vec::new();
    facts.subprogram(label)?.iter().for_each(|block| reads(block, &mut read));
    let mut own: BTreeSet<QRef> = facts.subprogram(label)?.iter().flat_map(|block| block_reads(facts, block)).collect();
    own.extend(read.iter().map(|(q, _)| *q));
    own.into_iter().filter(|q| is_own(*q)).find_map(|q| {
        // The numbers and the calls in the order of the text: a call is nothing.
        let mut order = Vec::new();
        for (at, block) in main.iter().enumerate() {
            if graph.called_from(at).is_some() {
                order.push(None);
                continue;
            }
            match constant(block) {
                Some((target, number)) if target == q => order.push(Some((facts.content(block), number))),
                _ if mentions(facts, block, q) => return None,
                _ => {}
            }
        }
        let calls = order.iter().filter(|own| own.is_none()).count();
        let lost = |pair: &[Option<(Span, f64)>]| match pair {
            [Some(own), Some(other)] => (own.1 != other.1).then_some(*own),
            _ => None,
        };
        let last = || order.last().copied().flatten();
        let unread = order.windows(2).find_map(lost).or_else(last).filter(|own| own.1 != 0.0);
        let fits = calls >= CALLS && order.len() == 2 * calls && order.first().is_some_and(Option::is_some);
        unread.filter(|_| fits).map(|(span, _)| (span, q))
    })
}

/// The parameters that the values of a definition name.
fn block_reads(facts: &Facts<'_>, block: &Block) -> Vec<QRef> {
    let mut found = Vec::new();
    if matches!(block.kind, BlockKind::CycleDef(_) | BlockKind::OldCycleLine(_)) {
        each_mention(facts.text(block.span), |q| found.push(q));
    }
    found
}

fn mentions(facts: &Facts<'_>, block: &Block, q: QRef) -> bool {
    let mut found = false;
    each_mention(facts.text(block.span), |own| found |= own == q);
    found
}

/// Whether only the program reads it.
fn is_own(q: QRef) -> bool {
    q.kind == QKind::Ql || (q.kind == QKind::Q && q.number < 100)
}

/// The parameters that a text names outside of comments.
fn each_mention(text: &str, mut each: impl FnMut(QRef)) {
    for line in text.lines() {
        let code = line.split(';').next().unwrap_or_default();
        let bytes = code.as_bytes();
        let mut at = 0;
        while let Some(byte) = bytes.get(at) {
            at += 1;
            if !byte.eq_ignore_ascii_case(&b'Q') {
                continue;
            }
            let kind = match bytes.get(at).map(u8::to_ascii_uppercase) {
                Some(b'L') => QKind::Ql,
                Some(b'R' | b'S') => continue,
                _ => QKind::Q,
            };
            at += usize::from(kind == QKind::Ql);
            let digits = bytes.get(at..).unwrap_or_default().iter().take_while(|byte| byte.is_ascii_digit()).count();
            if let Some(number) = code.get(at..at + digits).and_then(|own| own.parse().ok()) {
                each(QRef { kind, number });
            }
            at += digits;
        }
    }
}
