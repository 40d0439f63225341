//! Loops that count: what the blocks of a loop do to what its jump compares.
//!
//! Invariant: a step is known only if nothing else in the loop writes the counter; a value before the loop only if it is
//! written once in the program, as a number.
use std::ops::RangeInclusive;

use super::program::{constant, each_function};
use super::{Facts, Way};
use crate::base::expr::{Node, Op, QKind, QRef};
use crate::program::syntax::{
    Amount, Block, BlockKind, CycleKeyword, FnJump, FnOp, Formula, Relation, StatementKind, ValueKind,
};

/// How deep subprograms in a loop are looked into.
const DEPTH: usize = 8;

/// By how much a parameter is changed.
#[derive(Clone, Copy)]
enum By {
    /// A number.
    Number(f64),
    /// A parameter, or what is left where it is taken away.
    Parameter { q: QRef, negative: bool },
}

/// An assignment that adds something to a parameter.
struct Step {
    target: QRef,
    by: By,
}

/// What the blocks of a loop do to what its condition compares.
pub(super) struct Loop<'p> {
    /// What they write.
    pub(super) written: Vec<QRef>,
    steps: Vec<Step>,
    /// The jumps out of it that wait for a value.
    pub(super) exits: Vec<&'p FnJump>,
    /// Something may end it, or change anything.
    pub(super) open: bool,
    /// How many blocks may still be looked at.
    pub(super) patience: &'p mut usize,
}

/// The number that the only assignment to a parameter outside of a loop gives it before the loop.
pub(super) fn set_once(facts: &Facts<'_>, q: QRef, blocks: &RangeInclusive<usize>) -> Option<f64> {
    if q.kind != QKind::Ql && (q.kind != QKind::Q || q.number >= 100) {
        return None;
    }
    let mut none = 0;
    let mut all = Loop::new(&mut none);
    let mut found = None;
    for (at, block) in facts.program.blocks().iter().enumerate().filter(|(at, _)| !blocks.contains(at)) {
        let before = all.written.len();
        all.block(facts, block);
        if !all.written.get(before..)?.contains(&q) {
            continue;
        }
        if found.replace(constant(block)?.1).is_some() || *blocks.start() < at {
            return None;
        }
    }
    found
}

/// All numbers that a program gives a parameter, if it gives it nothing else.
pub(super) fn numbers_of(facts: &Facts<'_>, q: QRef) -> Option<Vec<f64>> {
    if q.kind != QKind::Ql && (q.kind != QKind::Q || q.number >= 100) {
        return None;
    }
    let mut none = 0;
    let mut all = Loop::new(&mut none);
    let mut found = Vec::new();
    for block in facts.program.blocks() {
        let before = all.written.len();
        all.block(facts, block);
        if all.written.get(before..)?.contains(&q) {
            found.push(constant(block)?.1);
        }
    }
    Some(found).filter(|own| !own.is_empty())
}

/// The step that a formula is: a parameter and something added to it or taken away.
fn step(formula: &Formula) -> Option<Step> {
    let Node::Binary(op, left, right) = &formula.expr.node else { return None };
    let (own, by) = match (op, &left.node, &right.node) {
        (Op::Add | Op::Sub, Node::Q(own), by) if *own == formula.target => (*own, by),
        (Op::Add, by, Node::Q(own)) if *own == formula.target => (*own, by),
        _ => return None,
    };
    let negative = *op == Op::Sub;
    let by = match by {
        Node::Number(number) => By::Number(if negative { -number } else { *number }),
        Node::Q(q) if *q != own => By::Parameter { q: *q, negative },
        _ => return None,
    };
    Some(Step { target: own, by })
}

impl<'p> Loop<'p> {
    pub(super) fn new(patience: &'p mut usize) -> Self {
        Self { written: Vec::new(), steps: Vec::new(), exits: Vec::new(), open: false, patience }
    }

    /// By how much a parameter grows each time, if a step is the only thing that writes it.
    pub(super) fn step_of(&self, facts: &Facts<'_>, q: QRef, blocks: &RangeInclusive<usize>) -> Option<f64> {
        let step = self.steps.iter().find(|own| own.target == q)?;
        if self.written.iter().filter(|own| **own == q).count() != 1 {
            return None;
        }
        match step.by {
            By::Number(number) => Some(number),
            By::Parameter { q, .. } if self.written.contains(&q) => None,
            By::Parameter { q, negative } => set_once(facts, q, blocks).map(|own| if negative { -own } else { own }),
        }
    }

    /// The sign of such a step by a parameter, as 1 or -1, if the program gives it only numbers of one sign.
    pub(super) fn sign_of_step(&self, facts: &Facts<'_>, q: QRef) -> Option<f64> {
        let step = self.steps.iter().find(|own| own.target == q)?;
        let only = self.written.iter().filter(|own| **own == q).count() == 1;
        let By::Parameter { q: by, negative } = step.by else { return None };
        if !only || self.written.contains(&by) || !(by.kind == QKind::Ql || by.kind == QKind::Q && by.number < 100) {
            return None;
        }
        let mut none = 0;
        let mut all = Loop::new(&mut none);
        let mut sign: Option<f64> = None;
        for block in facts.program.blocks() {
            let before = all.written.len();
            all.block(facts, block);
            if all.written.get(before..)?.contains(&by) {
                let own = constant(block).map(|(_, own)| own).filter(|own| *own != 0.0)?.signum();
                if sign.replace(own).is_some_and(|other| other != own) {
                    return None;
                }
            }
        }
        sign.map(|own| if negative { -own } else { own })
    }

    /// Adds what the blocks from one to another do.
    pub(super) fn add(&mut self, facts: &Facts<'p>, from: usize, to: usize) {
        self.add_to(facts, from, to, DEPTH);
    }

    fn add_to(&mut self, facts: &Facts<'p>, from: usize, to: usize, depth: usize) {
        if depth == 0 {
            self.open = true;
            return;
        }
        let graph = &facts.run.graph;
        for (at, block) in facts.program.blocks().iter().enumerate().take(to + 1).skip(from) {
            let Some(rest) = self.patience.checked_sub(1) else {
                self.open = true;
                return;
            };
            *self.patience = rest;
            self.block(facts, block);
            let mut uses = graph.uses_in(at).iter().filter(|own| own.way != Way::Named);
            let Some(own) = uses.next() else { continue };
            let target = own.mark.as_ref().and_then(|mark| graph.block_of(mark));
            match (own.way, target) {
                (Way::Call, Some(part)) => {
                    let after = facts.program.blocks().get(part..).unwrap_or_default();
                    let Some(end) = after.iter().position(Block::ends_subprogram) else {
                        self.open = true;
                        return;
                    };
                    if part <= at && at <= part + end {
                        self.open = true;
                        return;
                    }
                    self.add_to(facts, part, part + end, depth - 1);
                }
                (Way::Jump | Way::Repeat, Some(part)) if (from..=to).contains(&part) => {}
                (Way::Jump, Some(_)) => match &block.kind {
                    BlockKind::FnJump(jump) if jump.relation == Relation::Equal && !block.skip => self.exits.push(jump),
                    _ => self.open = true,
                },
                _ => self.open = true,
            }
            if self.open {
                return;
            }
        }
    }

    fn block(&mut self, facts: &Facts<'p>, block: &'p Block) {
        match &block.kind {
            BlockKind::FnAssign(assign) => {
                self.written.push(assign.target);
                let own = |amount: Amount| matches!(amount, Amount::Q { q, negative: false } if q == assign.target);
                let other = |amount: Amount, turned: bool| match amount {
                    Amount::Number(number) => Some(By::Number(if turned { -number } else { number })),
                    Amount::Q { q, negative } if q != assign.target => {
                        Some(By::Parameter { q, negative: negative != turned })
                    }
                    _ => None,
                };
                let by = match (assign.op, assign.b.as_ref().map(|b| b.amount)) {
                    (FnOp::Add, Some(b)) if own(assign.a.amount) => other(b, false),
                    (FnOp::Sub, Some(b)) if own(assign.a.amount) => other(b, true),
                    (FnOp::Add, Some(b)) if own(b) => other(assign.a.amount, false),
                    _ => None,
                };
                self.steps.extend(by.map(|by| Step { target: assign.target, by }));
            }
            BlockKind::Formula(formula) => {
                self.written.push(formula.target);
                self.steps.extend(step(formula));
            }
            BlockKind::TextFormula(formula) => self.written.push(formula.target),
            BlockKind::Statement(statement) => {
                let anything = matches!(
                    statement.kind,
                    StatementKind::Sql | StatementKind::Indirect | StatementKind::Refused | StatementKind::CallSelected
                );
                self.open |= anything;
                // These only read.
                let reads = matches!(
                    statement.kind,
                    StatementKind::Trans | StatementKind::Plane | StatementKind::BlkForm | StatementKind::ContourDef
                );
                for word in statement.words.iter().filter(|_| !reads) {
                    if let ValueKind::Q { q, .. } = word.value.kind {
                        self.written.push(q);
                    }
                }
            }
            // Probing cycles of the old form name the parameter of their result.
            BlockKind::OldCycleLine(line) if line.keyword != CycleKeyword::CyclDef => {
                for word in &line.words {
                    if let ValueKind::Q { q, .. } = word.value.kind {
                        self.written.push(q);
                    }
                }
            }
            BlockKind::CycleDef(cycle) => {
                for parameter in &cycle.parameters {
                    self.written.push(parameter.q);
                }
            }
            BlockKind::Stop(_) | BlockKind::CallPgm(_) | BlockKind::Unknown(_) | BlockKind::Iso(_) => self.open = true,
            _ => {}
        }
        self.open |= facts.ends(block);
        // Where the operator starts again, the loop is a series.
        each_function(block, |number| self.open |= matches!(number, 0 | 1 | 2 | 30));
    }
}
