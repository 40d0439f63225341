//! A jump back whose counter fulfils its condition on no pass: the loop is executed once and never repeated.
//!
//! Only where the counter has a number before the loop, is changed by a known step, and is compared with a number that is
//! written in the jump: what a parameter limits may be one pass by intention. Silent where anything else may lead into the
//! loop or write the counter.
use crate::base::diag::{Diagnostic, Severity};
use crate::base::expr::{QKind, QRef};
use crate::check::loops::{Loop, set_once};
use crate::check::{Facts, Rule, Use, Way};
use crate::program::syntax::{Amount, BlockKind, FnJump, Relation};

pub(super) const RULE: Rule = Rule { code: "loop-runs-once", severity: Severity::Warning, run };

/// How often a block may be looked at on average.
const PATIENCE: usize = 48;

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let hidden = facts.flow.skips || facts.flow.programs || facts.flow.unread.any() || !facts.calls.is_empty();
    if hidden || facts.run.graph.uses.iter().any(|own| own.mark.is_none()) {
        return;
    }
    let mut patience = facts.program.blocks().len().saturating_mul(PATIENCE).saturating_add(100_000);
    for own in facts.run.graph.uses.iter().filter(|own| own.way == Way::Jump) {
        let Some(block) = facts.program.blocks().get(own.block) else { continue };
        let BlockKind::FnJump(jump) = &block.kind else { continue };
        let Some(rest) = patience.checked_sub(facts.program.blocks().len().saturating_mul(2)) else { return };
        patience = rest;
        if once(facts, own, jump, &mut patience) {
            found.push(rule.at(facts, facts.content(block)));
        }
    }
}

/// Whether the jump is never taken: its counter passes the number after the first pass, and only moves away from it.
fn once<'p>(facts: &Facts<'p>, own: &Use, jump: &FnJump, patience: &'p mut usize) -> bool {
    let graph = &facts.run.graph;
    let target = own.mark.as_ref().and_then(|mark| graph.block_of(mark));
    let Some(from) = target.filter(|from| *from <= own.block) else { return false };
    let blocks = from..=own.block;
    // One way leads into the loop.
    let others = |other: &Use| {
        let to = other.mark.as_ref().and_then(|mark| graph.block_of(mark));
        other.block != own.block && to.is_some_and(|to| blocks.contains(&to)) && !blocks.contains(&other.block)
    };
    if graph.uses.iter().any(others) {
        return false;
    }
    let (q, end, left) = match (jump.a.amount, jump.b.amount) {
        (Amount::Q { q, negative: false }, Amount::Number(end)) => (q, end, true),
        (Amount::Number(end), Amount::Q { q, negative: false }) => (q, end, false),
        _ => return false,
    };
    if !is_free(q) {
        return false;
    }
    let mut body = Loop::new(patience);
    body.add(facts, from, own.block);
    if body.open || !body.exits.is_empty() {
        return false;
    }
    let (Some(by), Some(start)) = (body.step_of(facts, q, &blocks), set_once(facts, q, &blocks)) else { return false };
    let first = start + by;
    // The condition as one on the counter.
    match (jump.relation, left) {
        (Relation::Less, true) | (Relation::Greater, false) => by != 0.0 && first >= end,
        (Relation::Greater, true) | (Relation::Less, false) => by != 0.0 && first <= end,
        _ => false,
    }
}

/// Whether only the program writes a parameter.
fn is_free(q: QRef) -> bool {
    q.kind == QKind::Ql || (q.kind == QKind::Q && q.number < 100)
}
