//! A formula with a slip that its use shows: a sum of two squares that is a length, so that the square root is missing, or a
//! path beside a size to which the radius of the tool is added once and from which it is taken away once.
//!
//! Only in the order of the text between two labels, where the same parameters have not been written since. A height may be
//! a sum of squares.
use std::collections::{BTreeMap, BTreeSet};

use crate::base::diag::{Diagnostic, Severity, Span};
use crate::base::expr::{Expr, Func, Node, Op, QKind, QRef};
use crate::check::program::reads;
use crate::check::{Facts, Rule};
use crate::program::syntax::{Amount, Axis, Block, BlockKind, FnAssign, FnOp, Operand};

pub(super) const RULE: Rule = Rule { code: "formula-wrong", severity: Severity::Warning, run };

/// The parameter in which the control keeps the radius of the tool.
const RADIUS: QRef = QRef { kind: QKind::Q, number: 108 };
/// So much may be left for finishing, mm or inch.
const ALLOWANCE: f64 = 1.0;
/// So many parts a sum may have, and so many sums are kept.
const MOST: usize = 8;
const KEPT: usize = 32;

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    if !facts.marked().any(|(_, block)| matches!(block.kind, BlockKind::FnAssign(_) | BlockKind::Formula(_))) {
        return;
    }
    let mut squares = Squares::default();
    let mut ways = Ways::default();
    for (index, block) in facts.program.blocks().iter().enumerate() {
        if let Some((q, span)) = squares.see(facts, block) {
            found.push(rule.at(facts, span).arg("what", "square").arg("parameter", q.to_string()));
        }
        if let Some((q, span)) = ways.see(facts, index, block) {
            found.push(rule.at(facts, span).arg("what", "radius").arg("parameter", q.to_string()));
        }
    }
}

/// Parameters that are squares, and sums of two of them with their places.
#[derive(Default)]
struct Squares {
    squares: BTreeSet<QRef>,
    sums: BTreeMap<QRef, Span>,
}

impl Squares {
    /// Takes a block: the sum that it uses as a length.
    fn see(&mut self, facts: &Facts<'_>, block: &Block) -> Option<(QRef, Span)> {
        match &block.kind {
            BlockKind::Lbl(_) => *self = Self::default(),
            BlockKind::FnAssign(own) => {
                let (square, sum) = (is_product(own), self.adds(own));
                self.set(own.target, square, sum.then_some(own.target_span));
            }
            BlockKind::Formula(own) => {
                let text = facts.text(own.text);
                let (square, sum) = (is_square(text, &own.expr), self.is_sum(text, &own.expr));
                self.set(own.target, square, sum.then_some(own.target_span));
            }
            BlockKind::Motion(motion) if !self.sums.is_empty() && motion.outline().has_parameters() => {
                let words = motion.words();
                let flat = words.coords.iter().filter(|own| matches!(own.axis, Axis::X | Axis::Y | Axis::Pr));
                let mut lengths = flat.map(|own| own.value).chain(words.radius);
                return lengths.find_map(|own| match own.amount {
                    Amount::Q { q, .. } => Some((q, self.sums.remove(&q)?)),
                    _ => None,
                });
            }
            _ => {}
        }
        None
    }

    fn set(&mut self, target: QRef, square: bool, sum: Option<Span>) {
        self.sums.remove(&target);
        self.squares.remove(&target);
        if square && self.squares.len() < KEPT {
            self.squares.insert(target);
        }
        self.sums.extend(sum.map(|span| (target, span)));
    }

    fn adds(&self, own: &FnAssign) -> bool {
        let square = |own: &Operand| matches!(own.amount, Amount::Q { q, .. } if self.squares.contains(&q));
        matches!(own.op, FnOp::Add | FnOp::Sub) && square(&own.a) && own.b.as_ref().is_some_and(square)
    }

    fn is_sum(&self, text: &str, expr: &Expr) -> bool {
        let square = |own: &Expr| is_square(text, own) || matches!(&own.node, Node::Q(q) if self.squares.contains(q));
        matches!(&expr.node, Node::Binary(Op::Add | Op::Sub, left, right) if square(left) && square(right))
    }
}

/// Whether a block multiplies a parameter by itself.
fn is_product(own: &FnAssign) -> bool {
    let parameter = matches!(own.a.amount, Amount::Q { .. });
    own.op == FnOp::Mul && parameter && own.b.as_ref().is_some_and(|other| other.amount == own.a.amount)
}

/// Whether a formula is a square of something that is not just a number.
fn is_square(text: &str, expr: &Expr) -> bool {
    let written = |own: &Expr| text.get(own.span.start..own.span.end).unwrap_or_default().trim();
    let number = |own: &Expr| matches!(own.node, Node::Number(_));
    match &expr.node {
        Node::Call(Func::Sq, inner) => inner.first().is_some_and(|own| !number(own)),
        Node::Binary(Op::Mul, left, right) => written(left) == written(right) && !number(left),
        Node::Binary(Op::Pow, left, right) => {
            matches!(right.node, Node::Number(power) if power == 2.0) && !number(left)
        }
        _ => false,
    }
}

/// A sum of parameters, each with its factor, and of a number.
#[derive(Clone, Default, PartialEq)]
struct Sum {
    parts: BTreeMap<QRef, f64>,
    number: f64,
}

impl Sum {
    fn of(q: QRef) -> Self {
        Self { parts: BTreeMap::from([(q, 1.0)]), number: 0.0 }
    }

    fn times(mut self, factor: f64) -> Self {
        self.parts.values_mut().for_each(|own| *own *= factor);
        self.number *= factor;
        self
    }

    fn plus(mut self, other: Self) -> Option<Self> {
        for (q, factor) in other.parts {
            *self.parts.entry(q).or_default() += factor;
        }
        self.parts.retain(|_, factor| *factor != 0.0);
        self.number += other.number;
        (self.parts.len() <= MOST).then_some(self)
    }

    /// Whether two sums are ways on both sides of the same size: all that both have is the same but the radius, and a number
    /// is no more than an allowance.
    fn is_across(&self, other: &Self) -> bool {
        let radius = |own: &Self| own.parts.get(&RADIUS).copied();
        let (Some(one), Some(two)) = (radius(self), radius(other)) else { return false };
        let size = |own: &Self| own.parts.iter().find(|(q, _)| **q != RADIUS).map(|(_, factor)| factor.signum());
        let turn = if size(self) == size(other) { 1.0 } else { -1.0 };
        let mut common = 0;
        for (q, factor) in self.parts.iter().filter(|(q, _)| **q != RADIUS) {
            match other.parts.get(q) {
                Some(own) if *own == turn * factor => common += 1,
                Some(_) => return false,
                None => {}
            }
        }
        common > 0 && one == -turn * two && (self.number - turn * other.number).abs() <= ALLOWANCE
    }
}

/// The ways beside a size that are calculated for one subprogram.
#[derive(Default)]
struct Ways {
    sums: BTreeMap<QRef, (Sum, Span)>,
    /// Those with which a subprogram was called.
    called: Vec<(QRef, usize, Sum)>,
}

impl Ways {
    /// Takes a block: the parameter whose way is on the other side than before.
    fn see(&mut self, facts: &Facts<'_>, index: usize, block: &Block) -> Option<(QRef, Span)> {
        let (target, span, sum) = match &block.kind {
            BlockKind::FnAssign(own) => (own.target, own.target_span, self.assigned(own)),
            BlockKind::Formula(own) => (own.target, own.target_span, self.calculated(&own.expr, MOST)),
            BlockKind::CallLbl(call) if call.repeat.is_none() => {
                let label = facts.run.graph.called_from(index)?;
                return self.call(facts, label);
            }
            BlockKind::Lbl(_) | BlockKind::CallLbl(_) | BlockKind::CallPgm(_) | BlockKind::ToolCall(_) => {
                *self = Self::default();
                return None;
            }
            _ => return None,
        };
        self.sums.retain(|_, (own, _)| !own.parts.contains_key(&target));
        self.called.retain(|(_, _, own)| !own.parts.contains_key(&target));
        self.sums.remove(&target);
        if let Some(sum) = sum.filter(|own| !own.parts.contains_key(&target))
            && self.sums.len() < KEPT
        {
            self.sums.insert(target, (sum, span));
        }
        None
    }

    /// A subprogram is called that reads some of the ways.
    fn call(&mut self, facts: &Facts<'_>, label: usize) -> Option<(QRef, Span)> {
        let mut read = Vec::new();
        facts.subprogram(label)?.iter().for_each(|block| reads(block, &mut read));
        let mut found = None;
        for (q, (sum, span)) in self.sums.iter().filter(|(q, _)| read.iter().any(|(own, _)| own == *q)) {
            if !sum.parts.contains_key(&RADIUS) {
                continue;
            }
            let across = |own: &&(QRef, usize, Sum)| own.0 == *q && own.1 == label && own.2.is_across(sum);
            found = found.or(self.called.iter().find(across).map(|_| (*q, *span)));
            if self.called.len() < KEPT {
                self.called.push((*q, label, sum.clone()));
            }
        }
        found
    }

    fn assigned(&self, own: &FnAssign) -> Option<Sum> {
        let value = |operand: &Operand| match operand.amount {
            Amount::Number(number) => Some(Sum { number, ..Sum::default() }),
            Amount::Q { q, negative } => Some(self.parameter(q).times(if negative { -1.0 } else { 1.0 })),
            Amount::Text(_) => None,
        };
        let (a, b) = (value(&own.a)?, own.b.as_ref().and_then(value));
        match own.op {
            FnOp::Set => Some(a),
            FnOp::Add => a.plus(b?),
            FnOp::Sub => a.plus(b?.times(-1.0)),
            FnOp::Mul => product(a, b?),
            FnOp::Div => quotient(a, &b?),
            _ => None,
        }
    }

    fn parameter(&self, q: QRef) -> Sum {
        self.sums.get(&q).map_or_else(|| Sum::of(q), |(own, _)| own.clone())
    }

    fn calculated(&self, expr: &Expr, deep: usize) -> Option<Sum> {
        let deep = deep.checked_sub(1)?;
        let each = |own: &Expr| self.calculated(own, deep);
        match &expr.node {
            Node::Number(number) => Some(Sum { number: *number, ..Sum::default() }),
            Node::Q(q) => Some(self.parameter(*q)),
            Node::Unary(Op::Sub, inner) => Some(each(inner)?.times(-1.0)),
            Node::Unary(Op::Add, inner) => each(inner),
            Node::Binary(op, left, right) => {
                let (left, right) = (each(left)?, each(right)?);
                match op {
                    Op::Add => left.plus(right),
                    Op::Sub => left.plus(right.times(-1.0)),
                    Op::Mul => product(left, right),
                    Op::Div => quotient(left, &right),
                    _ => None,
                }
            }
            _ => None,
        }
    }
}

/// A product of which one factor is a number.
fn product(one: Sum, other: Sum) -> Option<Sum> {
    match (one.parts.is_empty(), other.parts.is_empty()) {
        (true, _) => Some(other.times(one.number)),
        (_, true) => Some(one.times(other.number)),
        _ => None,
    }
}

fn quotient(one: Sum, by: &Sum) -> Option<Sum> {
    (by.parts.is_empty() && by.number != 0.0).then(|| one.times(by.number.recip()))
}
