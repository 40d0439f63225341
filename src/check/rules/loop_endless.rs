//! A jump back that nothing in the loop can end: its condition always holds, or compares what the loop does not change,
//! or changes it away from the end, or steps over it.
//!
//! So does a counter that each pass calculates anew from what the loop does not change.
//! Also a jump out of a loop that waits for a counter which nothing counts.
//!
//! Silent where the loop stops for the operator, calls programs, has another way out, may be changed by what cannot be
//! read, or takes too long to look through.
use std::collections::BTreeMap;
use std::ops::RangeInclusive;

use crate::base::diag::{Diagnostic, Severity};
use crate::base::expr::{Node, Op, QKind, QRef};
use crate::check::loops::{Loop, numbers_of, set_once};
use crate::check::program::reads;
use crate::check::{Facts, Rule, Use, Way};
use crate::program::syntax::{Amount, Block, BlockKind, FnJump, FnOp, Operand, Relation};

pub(super) const RULE: Rule = Rule { code: "loop-endless", severity: Severity::Warning, run };

/// How near the number of steps must come to a whole one.
const NEAR: f64 = 1e-6;
/// How often a block may be looked at on average.
const PATIENCE: usize = 48;

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let mut patience = facts.program.blocks().len().saturating_mul(PATIENCE).saturating_add(100_000);
    for own in facts.run.graph.uses.iter().filter(|own| own.way == Way::Jump) {
        let Some(block) = facts.program.blocks().get(own.block) else { continue };
        let BlockKind::FnJump(jump) = &block.kind else { continue };
        if !block.skip && never_ends(facts, own, jump, &mut patience) {
            found.push(rule.at(facts, facts.content(block)).arg("what", "jump").arg("parameter", ""));
        }
    }
    for (block, q) in uncounted(facts) {
        found.push(rule.at(facts, facts.content(block)).arg("what", "counter").arg("parameter", q.to_string()));
    }
}

/// The jumps out of loops that compare a counter with a limit which nothing counts: it is given a number once, before the
/// loop, and read nowhere else.
fn uncounted<'p>(facts: &Facts<'p>) -> Vec<(&'p Block, QRef)> {
    let blocks = facts.program.blocks();
    let waits = |block: &'p Block| {
        let BlockKind::FnJump(jump) = &block.kind else { return None };
        let grows = matches!(jump.relation, Relation::Less | Relation::Greater) && !block.skip;
        match (jump.a.amount, jump.b.amount) {
            (Amount::Q { q, .. }, Amount::Number(_)) if grows && q.kind == QKind::Q && q.number < 100 => Some(q),
            _ => None,
        }
    };
    let mut jumps: Vec<(usize, &'p Block, QRef)> =
        facts.marked().filter_map(|(index, block)| Some((index, block, waits(block)?))).collect();
    let hidden = facts.flow.skips || facts.flow.programs || facts.flow.unread.any() || !facts.calls.is_empty();
    if jumps.is_empty() || hidden || !facts.begins() {
        return Vec::new();
    }
    // How many loops a block is in.
    let mut loops = vec![0_i32; blocks.len() + 1];
    for own in facts.run.graph.uses.iter().filter(|own| own.way == Way::Jump) {
        let from = own.mark.as_ref().and_then(|mark| facts.run.graph.block_of(mark));
        if let Some(from) = from.filter(|from| *from < own.block) {
            loops[from] += 1;
            loops[own.block] -= 1;
        }
    }
    let mut depth = 0;
    for own in &mut loops {
        depth += *own;
        *own = depth;
    }
    let in_loop = |at: usize| loops.get(at).is_some_and(|own| *own > 0);
    jumps.retain(|(index, ..)| in_loop(*index));
    // Where each of them is written, if that is once and by a number, and how often it is read.
    let mut written: BTreeMap<QRef, Vec<(usize, bool)>> = BTreeMap::new();
    let mut counted: BTreeMap<QRef, usize> = BTreeMap::new();
    let mut read = Vec::new();
    for (index, block) in facts.marked() {
        match &block.kind {
            BlockKind::FnAssign(own) => {
                written.entry(own.target).or_default().push((index, own.op == FnOp::Set));
            }
            BlockKind::Formula(own) => {
                let number = matches!(own.expr.node, Node::Number(_));
                written.entry(own.target).or_default().push((index, number));
            }
            BlockKind::Statement(_) | BlockKind::TextFormula(_) => return Vec::new(),
            _ => {}
        }
    }
    for block in blocks {
        read.clear();
        reads(block, &mut read);
        for (q, _) in &read {
            *counted.entry(*q).or_default() += 1;
        }
    }
    jumps.retain(|(index, _, q)| {
        let once =
            written.get(q).is_some_and(|all| matches!(all.as_slice(), [(at, true)] if at < index && !in_loop(*at)));
        once && counted.get(q) == Some(&1)
    });
    jumps.into_iter().map(|(_, block, q)| (block, q)).collect()
}

fn never_ends<'p>(facts: &Facts<'p>, own: &Use, jump: &FnJump, patience: &'p mut usize) -> bool {
    let target = own.mark.as_ref().and_then(|mark| facts.run.graph.block_of(mark));
    let Some(from) = target.filter(|from| *from <= own.block) else { return false };
    let decided = jump.decided();
    let free = |operand: &Operand| match operand.amount {
        Amount::Q { q, .. } => q.kind == QKind::Ql || (q.kind == QKind::Q && q.number < 100),
        Amount::Number(_) => true,
        Amount::Text(_) => false,
    };
    let numbers = !matches!(jump.relation, Relation::Undefined | Relation::Defined);
    let compares = || numbers && free(&jump.a) && free(&jump.b);
    if !decided.unwrap_or_else(compares) {
        return false;
    }
    let mut body = Loop::new(patience);
    body.add(facts, from, own.block);
    let exits = std::mem::take(&mut body.exits);
    body.open = body.open || !exits.iter().all(|exit| misses(facts, &mut body, exit, &(from..=own.block)));
    if body.open || decided.is_some() {
        return !body.open;
    }
    if jump.relation == Relation::NotEqual && misses(facts, &mut body, jump, &(from..=own.block)) {
        return true;
    }
    if ends_at_once(facts, &body, jump, &(from..=own.block)) {
        return false;
    }
    let changes = |operand: &Operand| match operand.amount {
        Amount::Q { q, .. } => body.written.contains(&q),
        _ => false,
    };
    match (changes(&jump.a), changes(&jump.b)) {
        (false, false) => true,
        (true, false) => {
            goes_away(facts, &body, jump, &(from..=own.block), true) || stays(facts, &body, jump, &(from..=own.block))
        }
        (false, true) => goes_away(facts, &body, jump, &(from..=own.block), false),
        (true, true) => false,
    }
}

/// Whether the only thing that the loop does to the side of a comparison is to move it away from the other side.
fn goes_away(facts: &Facts<'_>, body: &Loop<'_>, jump: &FnJump, blocks: &RangeInclusive<usize>, left: bool) -> bool {
    let side = if left { &jump.a } else { &jump.b };
    let Amount::Q { q, negative } = side.amount else { return false };
    let by = body.step_of(facts, q, blocks).or_else(|| body.sign_of_step(facts, q));
    let Some(by) = by else { return false };
    let grows = if negative { -by } else { by };
    match jump.relation {
        Relation::Less => (grows <= 0.0) == left || grows == 0.0,
        Relation::Greater => (grows >= 0.0) == left || grows == 0.0,
        _ => false,
    }
}

/// Whether each pass gives the left side of a comparison with a number the same value, for which it holds: the value is
/// calculated from what the loop does not change, instead of from the counter itself.
fn stays(facts: &Facts<'_>, body: &Loop<'_>, jump: &FnJump, blocks: &RangeInclusive<usize>) -> bool {
    let (Amount::Q { q, negative: false }, Amount::Number(limit)) = (jump.a.amount, jump.b.amount) else {
        return false;
    };
    let hidden = facts.flow.skips || facts.flow.programs || facts.flow.unread.any() || !facts.calls.is_empty();
    if hidden || body.written.iter().filter(|own| **own == q).count() != 1 {
        return false;
    }
    let assigns = |at: usize| Some((at, assigned(facts.program.blocks().get(at)?, q)?));
    let Some((at, (first, sign, other))) = blocks.clone().find_map(assigns) else { return false };
    // A jump over it would leave the value of before.
    let over = |own: &Use| {
        let target = own.mark.as_ref().and_then(|mark| facts.run.graph.block_of(mark));
        own.way == Way::Jump && blocks.contains(&own.block) && own.block < at && target.is_none_or(|to| to > at)
    };
    if facts.run.graph.uses.iter().any(over) {
        return false;
    }
    let values = |own: Amount| match own {
        Amount::Number(number) => Some(vec![number]),
        Amount::Q { q, negative } if !body.written.contains(&q) => {
            let sign = if negative { -1.0 } else { 1.0 };
            numbers_of(facts, q).map(|all| all.into_iter().map(|own| sign * own).collect())
        }
        Amount::Q { .. } | Amount::Text(_) => None,
    };
    let (Some(first), Some(other)) = (values(first), values(other)) else { return false };
    first.iter().flat_map(|a| other.iter().map(move |b| a + sign * b)).all(|own| match jump.relation {
        Relation::Less => own < limit,
        Relation::Greater => own > limit,
        Relation::NotEqual => own != limit,
        _ => false,
    })
}

/// What a block gives a parameter, if that is a sum or a difference of two values: the first one, the sign of the other one,
/// and that.
fn assigned(block: &Block, q: QRef) -> Option<(Amount, f64, Amount)> {
    match &block.kind {
        BlockKind::FnAssign(own) if own.target == q => {
            let sign = match own.op {
                FnOp::Set | FnOp::Add => 1.0,
                FnOp::Sub => -1.0,
                _ => return None,
            };
            Some((own.a.amount, sign, own.b.as_ref().map_or(Amount::Number(0.0), |own| own.amount)))
        }
        BlockKind::Formula(own) if own.target == q => {
            let value = |node: &Node| match node {
                Node::Number(number) => Some(Amount::Number(*number)),
                Node::Q(q) => Some(Amount::Q { q: *q, negative: false }),
                _ => None,
            };
            match &own.expr.node {
                Node::Binary(op @ (Op::Add | Op::Sub), left, right) => {
                    let sign = if *op == Op::Add { 1.0 } else { -1.0 };
                    Some((value(&left.node)?, sign, value(&right.node)?))
                }
                own => Some((value(own)?, 1.0, Amount::Number(0.0))),
            }
        }
        _ => None,
    }
}

/// Whether the jump is not taken after the first time: from values that are written once before the loop, and a step.
fn ends_at_once(facts: &Facts<'_>, body: &Loop<'_>, jump: &FnJump, blocks: &RangeInclusive<usize>) -> bool {
    let after_first = |operand: &Operand| match operand.amount {
        Amount::Number(number) => Some(number),
        Amount::Q { q, negative } => {
            let step = if body.written.contains(&q) { body.step_of(facts, q, blocks)? } else { 0.0 };
            let value = set_once(facts, q, blocks)? + step;
            Some(if negative { -value } else { value })
        }
        Amount::Text(_) => None,
    };
    let (Some(a), Some(b)) = (after_first(&jump.a), after_first(&jump.b)) else { return false };
    match jump.relation {
        Relation::Less => a >= b,
        Relation::Greater => a <= b,
        _ => false,
    }
}

/// Whether what a comparison with a fixed value waits for never comes: the only thing that counts is a step that passes
/// over it, from a start that is written once before the loop.
fn misses(facts: &Facts<'_>, body: &mut Loop<'_>, jump: &FnJump, blocks: &RangeInclusive<usize>) -> bool {
    let counts = |operand: &Operand| matches!(operand.amount, Amount::Q { q, .. } if body.written.contains(&q));
    let (counter, end) = match (counts(&jump.a), counts(&jump.b)) {
        (true, false) => (&jump.a, &jump.b),
        (false, true) => (&jump.b, &jump.a),
        _ => return false,
    };
    let Amount::Q { q, negative: false } = counter.amount else { return false };
    // The whole program is looked through for what writes both sides.
    let Some(rest) = body.patience.checked_sub(facts.program.blocks().len().saturating_mul(2)) else { return false };
    *body.patience = rest;
    // Nothing but the loop may decide which blocks are executed, or write parameters out of sight.
    let graph = &facts.run.graph;
    let outside = |own: &Use| own.way != Way::Call && own.way != Way::Named && !blocks.contains(&own.block);
    let hidden = facts.flow.skips || facts.flow.programs || facts.flow.unread.any() || !facts.calls.is_empty();
    if hidden || graph.uses.iter().any(outside) {
        return false;
    }
    let value = |operand: &Operand| match operand.amount {
        Amount::Number(number) => Some(number),
        Amount::Q { q, negative } => set_once(facts, q, blocks).map(|own| if negative { -own } else { own }),
        Amount::Text(_) => None,
    };
    let Some(by) = body.step_of(facts, q, blocks) else { return false };
    let (Some(start), Some(end)) = (set_once(facts, q, blocks), value(end)) else { return false };
    let times = (end - start) / by;
    by != 0.0 && (times < 0.0 || (times - libm::round(times)).abs() > NEAR)
}
