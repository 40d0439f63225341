//! A parameter that is given a number, or the result of a calculation, and read nowhere: what reads in its place has
//! another number, or the calculation was not finished.
//!
//! Only Q0 to Q99 and local parameters, in whole programs that call no others and machine by themselves: what others
//! read is not known. Any other mention of the parameter outside of comments counts as reading it.
use std::collections::BTreeMap;

use crate::base::diag::{Diagnostic, Severity, Span};
use crate::base::expr::{QKind, QRef};
use crate::check::{Facts, Rule};
use crate::program::syntax::{BlockKind, StatementKind};
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
            found.push(rule.at(facts, place).arg("parameter", q.to_string()));
        }
    }
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
