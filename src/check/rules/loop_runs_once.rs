//! A jump back whose counter fulfils its condition on no pass: the loop is executed once and never repeated. Also one in a
//! loop or a subprogram that is executed several times and never sets the counter back: from the second time on the inner
//! loop is executed once. And a loop whose counter is calculated from another parameter in each pass, so that its first number
//! has no effect; and a jump back that compares the counter of a loop inside of its own one, which that loop sets
//! anew on each pass, or leaves beyond its end.
//!
//! Only where the counter has a number before the loop, is changed by a known step, and is compared with a number that is
//! written in the jump, or with a parameter that it moves towards: what a parameter limits may be one pass by intention. Silent where anything else may lead into the
//! loop or write the counter, but for a block that sets the counter to the limit where it has passed it: a jump back that waits
//! for a counter beyond that limit is never taken.
use crate::base::diag::{Diagnostic, Severity};
use crate::base::expr::{Node, Op, QKind, QRef};
use crate::check::loops::{Loop, set_once};
use crate::check::program::{assigned, is_silent, reads};
use crate::check::{Facts, Rule, Use, Way};
use crate::program::syntax::{Amount, Block, BlockKind, FnJump, FnOp, Operand, Relation};

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
        let uses = facts.run.graph.uses.len();
        let Some(rest) = patience.checked_sub(facts.program.blocks().len().saturating_mul(2) + 4 * uses) else {
            return;
        };
        patience = rest;
        let what = if once(facts, own, jump, &mut patience) {
            "never"
        } else if again(facts, own, jump, &mut patience) {
            "again"
        } else if is_calculated(facts, own, jump) {
            "other"
        } else {
            continue;
        };
        found.push(rule.at(facts, facts.content(block)).arg("what", what).arg("parameter", ""));
    }
    for (block, q) in shared(facts) {
        found.push(rule.at(facts, facts.content(block)).arg("what", "inner").arg("parameter", q.to_string()));
    }
}

/// A jump back with its label and the parameter that it compares.
struct Back {
    from: usize,
    to: usize,
    q: QRef,
    /// The number below which it goes on.
    below: Option<f64>,
}

/// The jumps back of loops whose counter an inner loop sets and counts as well.
fn shared<'p>(facts: &Facts<'p>) -> Vec<(&'p Block, QRef)> {
    /// Programs with more loops are written by posts.
    const MANY: usize = 1 << 6;
    let graph = &facts.run.graph;
    let blocks = facts.program.blocks();
    let back = |own: &Use| {
        let to = own.mark.as_ref().and_then(|mark| graph.block_of(mark)).filter(|to| *to < own.block)?;
        let block = blocks.get(own.block).filter(|block| !block.skip)?;
        let BlockKind::FnJump(jump) = &block.kind else { return None };
        let q = match (jump.relation, jump.a.amount, jump.b.amount) {
            (Relation::Less | Relation::Greater, Amount::Q { q, negative: false }, _) => q,
            (Relation::Less | Relation::Greater, _, Amount::Q { q, negative: false }) => q,
            _ => return None,
        };
        let below = match (jump.relation, jump.a.amount, jump.b.amount) {
            (Relation::Less, _, Amount::Number(limit)) | (Relation::Greater, Amount::Number(limit), _) => Some(limit),
            _ => None,
        };
        Some(Back { from: own.block, to, q, below }).filter(|_| is_free(q))
    };
    let loops: Vec<Back> = graph.uses.iter().filter(|own| own.way == Way::Jump).filter_map(back).collect();
    if loops.len() > MANY {
        return Vec::new();
    }
    let takes = |outer: &Back, inner: &Back| {
        let inside = outer.to < inner.to && inner.from < outer.from && inner.q == outer.q;
        // A counter that the inner loop leaves beyond the end of the outer one ends that, if it only grows.
        let beyond = outer.below.zip(inner.below).is_some_and(|(outer, inner)| inner >= outer);
        inside
            && is_only_stepped(blocks, inner.to..outer.from, outer.q)
            && (is_set(blocks, outer.to..inner.to, outer.q)
                || beyond && only_grows(blocks, inner.from..outer.from, outer.q))
    };
    let found = loops.iter().filter(|outer| loops.iter().any(|inner| takes(outer, inner)));
    found.filter_map(|outer| Some((blocks.get(outer.from)?, outer.q))).collect()
}

/// Whether blocks give a parameter a number.
fn is_set(blocks: &[Block], part: std::ops::Range<usize>, q: QRef) -> bool {
    blocks.get(part).unwrap_or_default().iter().any(|block| match &block.kind {
        BlockKind::FnAssign(own) => {
            own.target == q && own.op == FnOp::Set && matches!(own.a.amount, Amount::Number(_)) && !block.skip
        }
        BlockKind::Formula(own) => own.target == q && matches!(own.expr.node, Node::Number(_)) && !block.skip,
        _ => false,
    })
}

/// Whether blocks only add numbers to a parameter.
fn only_grows(blocks: &[Block], part: std::ops::Range<usize>, q: QRef) -> bool {
    blocks.get(part).unwrap_or_default().iter().all(|block| match &block.kind {
        BlockKind::FnAssign(own) if own.target == q => {
            let positive = |own: &Operand| matches!(own.amount, Amount::Number(number) if number > 0.0);
            own.op == FnOp::Add && (positive(&own.a) || own.b.as_ref().is_some_and(positive))
        }
        BlockKind::Formula(own) if own.target == q => {
            let positive = |own: &Node| matches!(own, Node::Number(number) if *number > 0.0);
            matches!(&own.expr.node, Node::Binary(Op::Add, left, right) if positive(&left.node) || positive(&right.node))
        }
        _ => true,
    })
}

/// Whether all that blocks write into a parameter is calculated from itself, and nothing writes it out of sight.
fn is_only_stepped(blocks: &[Block], part: std::ops::Range<usize>, q: QRef) -> bool {
    let mut read = Vec::new();
    blocks.get(part).unwrap_or_default().iter().all(|block| {
        let target = match &block.kind {
            BlockKind::FnAssign(own) => own.target,
            BlockKind::Formula(own) => own.target,
            BlockKind::CallLbl(_) | BlockKind::CallPgm(_) | BlockKind::Statement(_) | BlockKind::Unknown(_) => {
                return false;
            }
            _ => return true,
        };
        read.clear();
        reads(block, &mut read);
        target != q || read.iter().any(|(own, _)| *own == q)
    })
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
    let mut body = Loop::new(patience);
    body.add(facts, from, own.block);
    if body.open || !body.exits.is_empty() {
        return false;
    }
    if is_clamped(facts, from, own.block, jump, &body.written) {
        return true;
    }
    let of = |q: QRef, operand: &Operand| {
        let kept = is_free(q) && !body.written.contains(&q);
        set_once(facts, q, &blocks).or_else(|| facts.known(operand)).filter(|_| kept)
    };
    let (q, end, left, written) = match (jump.a.amount, jump.b.amount) {
        (Amount::Q { q, negative: false }, Amount::Number(end)) => (q, end, true, true),
        (Amount::Number(end), Amount::Q { q, negative: false }) => (q, end, false, true),
        (Amount::Q { q: a, negative: false }, Amount::Q { q: b, negative: false }) => {
            match (of(a, &jump.a), of(b, &jump.b)) {
                (None, Some(end)) => (a, end, true, false),
                (Some(end), None) => (b, end, false, false),
                _ => return false,
            }
        }
        _ => return false,
    };
    if !is_free(q) {
        return false;
    }
    let counter = if left { &jump.a } else { &jump.b };
    let Some(by) = body.step_of(facts, q, &blocks) else { return false };
    // Where other blocks write the counter too, the one way of the run says what it is after the only pass.
    let first = set_once(facts, q, &blocks).map(|start| start + by).or_else(|| facts.known(counter));
    let Some(first) = first else { return false };
    // The condition as one on the counter.
    match (jump.relation, left) {
        // What a parameter limits may be one pass by intention, unless the counter has not
        // come to it, or was there before the first pass.
        (Relation::Less, true) | (Relation::Greater, false) if !written => {
            by < 0.0 && first > end || by > 0.0 && first - by >= end
        }
        (Relation::Greater, true) | (Relation::Less, false) if !written => {
            by > 0.0 && first < end || by < 0.0 && first - by <= end
        }
        (Relation::Less, true) | (Relation::Greater, false) => by != 0.0 && first >= end,
        (Relation::Greater, true) | (Relation::Less, false) => by != 0.0 && first <= end,
        _ => false,
    }
}

/// Whether the counter of a loop, which begins with a number, is calculated from another parameter in it and never read before:
/// the number has no effect.
fn is_calculated(facts: &Facts<'_>, own: &Use, jump: &FnJump) -> bool {
    let blocks = facts.program.blocks();
    let target = own.mark.as_ref().and_then(|mark| facts.run.graph.block_of(mark));
    let Some(body) = target.filter(|from| *from <= own.block).and_then(|from| blocks.get(from..own.block)) else {
        return false;
    };
    let (Amount::Q { q, negative: false }, Relation::Less | Relation::Greater) = (jump.a.amount, jump.relation) else {
        return false;
    };
    let steps = |block: &Block| match &block.kind {
        BlockKind::FnAssign(own) if own.target == q => match (own.op, own.a.amount, own.b.as_ref()?.amount) {
            (FnOp::Add | FnOp::Sub, Amount::Q { q: other, .. }, Amount::Number(_)) => Some(other),
            _ => None,
        },
        BlockKind::Formula(own) if own.target == q => match &own.expr.node {
            Node::Binary(Op::Add | Op::Sub, one, by) => match (&one.node, &by.node) {
                (Node::Q(other), Node::Number(_)) => Some(*other),
                _ => None,
            },
            _ => None,
        },
        _ => None,
    };
    let mut written = body.iter().filter(|block| assigned(block).is_some_and(|(own, _)| own == q));
    let (Some(other), None) = (written.next().and_then(steps), written.next()) else { return false };
    let mut read = Vec::new();
    body.iter().for_each(|block| reads(block, &mut read));
    let range = target.unwrap_or_default()..=own.block;
    let begins = set_once(facts, q, &range).is_some();
    let changes = body.iter().any(|block| assigned(block).is_some_and(|(own, _)| own == other));
    is_free(q) && other != q && changes && begins && !read.iter().any(|(own, _)| *own == q)
}

/// Whether the loop sets its counter to the limit as soon as it has passed it, and jumps back only beyond the limit.
fn is_clamped(facts: &Facts<'_>, from: usize, to: usize, jump: &FnJump, written: &[QRef]) -> bool {
    let blocks = facts.program.blocks().get(from..=to).unwrap_or_default();
    blocks.iter().enumerate().any(|(at, block)| {
        let BlockKind::FnJump(inner) = &block.kind else { return false };
        let sides = sides(inner).into_iter().flat_map(|one| sides(jump).into_iter().map(move |other| (one, other)));
        sides.into_iter().any(|((q, keeps, limit), (other, goes_on, same))| {
            let turned =
                matches!((keeps, goes_on), (Relation::Greater, Relation::Less) | (Relation::Less, Relation::Greater));
            let fixed = !matches!(limit, Amount::Q { q, .. } if written.contains(&q));
            let twice = written.iter().filter(|own| **own == q).count() == 2;
            let steps = blocks.iter().take(at).any(|block| assigned(block).is_some_and(|(own, _)| own == q));
            q == other && limit == same && turned && fixed && twice && steps && sets(facts, from + at, q, limit)
        })
    })
}

/// A comparison seen from each of its operands that is a parameter: the parameter, the relation, and what it is compared with.
fn sides(jump: &FnJump) -> Vec<(QRef, Relation, Amount)> {
    let turned = match jump.relation {
        Relation::Less => Relation::Greater,
        Relation::Greater => Relation::Less,
        own => own,
    };
    let q = |own: Amount| match own {
        Amount::Q { q, negative: false } => Some(q),
        _ => None,
    };
    let (a, b) = (jump.a.amount, jump.b.amount);
    let all = [q(a).map(|own| (own, jump.relation, b)), q(b).map(|own| (own, turned, a))];
    all.into_iter().flatten().collect()
}

/// Whether a jump only passes over a block that gives a parameter this value.
fn sets(facts: &Facts<'_>, jump: usize, q: QRef, limit: Amount) -> bool {
    let target = facts.run.graph.uses_in(jump).iter().find(|own| own.way == Way::Jump);
    let target = target.and_then(|own| facts.run.graph.block_of(own.mark.as_ref()?));
    let Some(passed) = target.and_then(|to| facts.program.blocks().get(jump + 1..to)) else { return false };
    let mut passed = passed.iter().filter(|block| !is_silent(block));
    let only = passed.next().filter(|_| passed.next().is_none());
    only.is_some_and(|block| match &block.kind {
        BlockKind::FnAssign(own) => own.target == q && own.op == FnOp::Set && own.a.amount == limit,
        BlockKind::Formula(own) => match (&own.expr.node, limit) {
            (Node::Q(value), Amount::Q { q: limit, negative: false }) => own.target == q && *value == limit,
            (Node::Number(value), Amount::Number(limit)) => own.target == q && *value == limit,
            _ => false,
        },
        _ => false,
    })
}

/// Whether the counter of a loop goes on from where it was when a loop around it, or its subprogram, is executed again.
fn again<'p>(facts: &Facts<'p>, own: &Use, jump: &FnJump, patience: &'p mut usize) -> bool {
    let graph = &facts.run.graph;
    let start_of = |own: &Use| own.mark.as_ref().and_then(|mark| graph.block_of(mark));
    let Some(from) = start_of(own).filter(|from| *from <= own.block) else { return false };
    let (q, limit, left) = match (jump.a.amount, jump.b.amount) {
        (Amount::Q { q, negative: false }, limit) => (q, limit, true),
        (limit, Amount::Q { q, negative: false }) => (q, limit, false),
        _ => return false,
    };
    // The smallest loop around it, or the subprogram in which it is.
    let around = graph.uses.iter().filter(|outer| matches!(outer.way, Way::Jump | Way::Repeat));
    let around = around.filter_map(|outer| Some((start_of(outer)?, outer.block)));
    let around = around.filter(|(start, end)| *start < from && own.block < *end).max_by_key(|(start, _)| *start);
    let Some((start, end)) = around.or_else(|| called_again(facts, q, from, own.block)) else { return false };
    let mut body = Loop::new(patience);
    body.add(facts, start, end);
    let limited = match limit {
        Amount::Q { q, .. } => is_free(q) && !body.written.contains(&q),
        Amount::Number(_) => true,
        Amount::Text(_) => false,
    };
    if body.open || !limited || !is_free(q) {
        return false;
    }
    let Some(by) = body.step_of(facts, q, &(start..=end)) else { return false };
    // The step belongs to the inner loop.
    let steps = facts.program.blocks().get(from..=own.block).unwrap_or_default();
    let inside = steps.iter().any(|block| match &block.kind {
        BlockKind::FnAssign(own) => own.target == q,
        BlockKind::Formula(own) => own.target == q,
        _ => false,
    });
    inside
        && match (jump.relation, left) {
            (Relation::Less, true) | (Relation::Greater, false) => by > 0.0,
            (Relation::Greater, true) | (Relation::Less, false) => by < 0.0,
            _ => false,
        }
}

/// The subprogram around a loop, if it is called several times after the only block that sets the counter, which nothing
/// repeats: its label and its end.
fn called_again(facts: &Facts<'_>, q: QRef, from: usize, to: usize) -> Option<(usize, usize)> {
    let (graph, blocks) = (&facts.run.graph, facts.program.blocks());
    let calls = |start: usize| {
        let leads = move |own: &&Use| own.mark.as_ref().and_then(|mark| graph.block_of(mark)) == Some(start);
        graph.uses.iter().filter(|own| own.way == Way::Call).filter(leads)
    };
    let first = blocks.get(..from)?.iter().rposition(Block::ends_subprogram).map_or(0, |end| end + 1);
    let called = graph.uses.iter().filter(|own| own.way == Way::Call);
    let called = called.filter_map(|own| graph.block_of(own.mark.as_ref()?));
    let mut starts: Vec<usize> = called.filter(|start| (first..from).contains(start)).collect();
    starts.sort_unstable();
    let start = starts.windows(2).find(|pair| pair[0] == pair[1]).map(|pair| pair[0])?;
    let end = to + blocks.get(to..)?.iter().position(|block| block.ends_subprogram())?;
    set_once(facts, q, &(start..=end))?;
    let set = blocks.iter().take(start).position(|block| match &block.kind {
        BlockKind::FnAssign(own) => own.target == q,
        BlockKind::Formula(own) => own.target == q,
        _ => false,
    })?;
    let repeats = graph.uses.iter().any(|own| {
        let to = own.mark.as_ref().and_then(|mark| graph.block_of(mark));
        matches!(own.way, Way::Jump | Way::Repeat) && to.is_some_and(|to| to <= set) && set <= own.block
    });
    // In a subprogram it may be set again.
    let main =
        facts.run.main.contains(&set) || !blocks.iter().take(set).any(|block| matches!(block.kind, BlockKind::Lbl(_)));
    let after = calls(start).filter(|own| own.block > set).count();
    (!repeats && main && after > 1).then_some((start, end))
}

/// Whether only the program writes a parameter.
fn is_free(q: QRef) -> bool {
    q.kind == QKind::Ql || (q.kind == QKind::Q && q.number < 100)
}
