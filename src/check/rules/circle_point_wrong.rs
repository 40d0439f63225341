//! A point whose two coordinates are both calculated with the sine, or both with the cosine, of the same angle: it lies on a
//! straight line and not on a circle. One formula was copied and not changed. Also one whose coordinates are calculated with the
//! cosine of one angle and the sine of another.
//!
//! Only between two labels, where both parameters certainly come from such formulas, each has no other angle in it, and the
//! other function of the angle is nowhere: a point in space has all of them.
use std::collections::HashMap;

use crate::base::diag::{Diagnostic, Severity, Span};
use crate::base::expr::{Expr, Func, Node, QRef};
use crate::check::{Facts, Rule};
use crate::program::syntax::{Amount, Axis, BlockKind, CallForm, Coord, FnAssign, FnOp, Formula, Operand};

pub(super) const RULE: Rule = Rule { code: "circle-point-wrong", severity: Severity::Warning, run };

/// More angles in one value are not compared.
const MOST: usize = 4;
/// More values are not kept at a time: a point has few.
const KEPT: usize = 64;

/// A function of an angle, as it is written.
#[derive(Clone, PartialEq)]
struct Part {
    sine: bool,
    angle: String,
}

/// A parameter with the functions that are in its value, and the place where it was calculated.
type Values = HashMap<QRef, (Vec<Part>, Span)>;

/// A section between two labels.
#[derive(Default)]
struct Section {
    values: Values,
    /// All functions of angles in it.
    parts: Vec<Part>,
    /// The points that look wrong: the place of the later formula, its parameter, the other one, the function.
    points: Vec<(Span, QRef, QRef, [Part; 2])>,
}

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let calculates = |kind: &BlockKind| match kind {
        BlockKind::FnAssign(own) => matches!(own.op, FnOp::Sin | FnOp::Cos),
        BlockKind::Formula(own) => has_angle(&own.expr),
        _ => false,
    };
    if !facts.marked().any(|(_, block)| calculates(&block.kind)) {
        return;
    }
    let mut section = Section::default();
    for block in facts.program.blocks() {
        match &block.kind {
            BlockKind::Lbl(_) => std::mem::take(&mut section).judge(rule, facts, found),
            BlockKind::FnAssign(own) => section.assign(facts, own),
            BlockKind::Formula(own) => section.calculate(facts, own),
            BlockKind::Motion(motion) if !section.values.is_empty() && motion.outline().has_coords() => {
                section.meet(&motion.words().coords);
            }
            BlockKind::CyclCall(call) => {
                if let CallForm::Position(coords) = &call.form {
                    section.meet(coords);
                }
            }
            _ => {}
        }
    }
    section.judge(rule, facts, found);
}

impl Section {
    /// An assignment by FN.
    fn assign(&mut self, facts: &Facts<'_>, own: &FnAssign) {
        let mut parts = Vec::new();
        if matches!(own.op, FnOp::Sin | FnOp::Cos) {
            let part = Part { sine: own.op == FnOp::Sin, angle: plain(facts.text(own.a.span)) };
            self.parts.push(part.clone());
            parts.push(part);
        } else {
            for operand in std::iter::once(&own.a).chain(&own.b) {
                self.take(operand, &mut parts);
            }
        }
        self.set(own.target, parts, own.target_span);
    }

    fn take(&self, operand: &Operand, parts: &mut Vec<Part>) {
        if let Amount::Q { q, .. } = operand.amount {
            self.add(q, parts);
        }
    }

    /// Adds what is in the value of a parameter.
    fn add(&self, q: QRef, parts: &mut Vec<Part>) {
        for part in self.values.get(&q).map(|(own, _)| own.as_slice()).unwrap_or_default() {
            if !parts.contains(part) && parts.len() < MOST {
                parts.push(part.clone());
            }
        }
    }

    /// An assignment by formula.
    fn calculate(&mut self, facts: &Facts<'_>, own: &Formula) {
        let mut parts = Vec::new();
        self.look(facts.text(own.text), &own.expr, &mut parts);
        self.set(own.target, parts, own.target_span);
    }

    fn look(&mut self, text: &str, expr: &Expr, parts: &mut Vec<Part>) {
        match &expr.node {
            Node::Q(q) => self.add(*q, parts),
            Node::Unary(_, inner) => self.look(text, inner, parts),
            Node::Binary(_, left, right) => {
                self.look(text, left, parts);
                self.look(text, right, parts);
            }
            Node::Call(func @ (Func::Sin | Func::Cos), inner) => {
                let angle = inner.first().and_then(|own| text.get(own.span.start..own.span.end));
                let part = Part { sine: *func == Func::Sin, angle: plain(angle.unwrap_or_default()) };
                self.parts.push(part.clone());
                if !parts.contains(&part) && parts.len() < MOST {
                    parts.push(part);
                }
            }
            Node::Call(_, inner) => inner.iter().for_each(|own| self.look(text, own, parts)),
            Node::Number(_) | Node::Text(_) | Node::Name(_) => {}
        }
    }

    fn set(&mut self, target: QRef, parts: Vec<Part>, span: Span) {
        // The angle may be another one from here on.
        let name = target.to_string();
        self.values.retain(|_, (own, _)| !own.iter().any(|part| part.angle == name));
        if parts.is_empty() {
            self.values.remove(&target);
            return;
        }
        if self.values.len() >= KEPT {
            self.values.clear();
        }
        self.values.insert(target, (parts, span));
    }

    /// A movement to a point.
    fn meet(&mut self, coords: &[Coord]) {
        let value = |axis: Axis| {
            let coord = coords.iter().find(|own| own.axis == axis)?;
            let Amount::Q { q, .. } = coord.value.amount else { return None };
            let (parts, span) = self.values.get(&q)?;
            match parts.as_slice() {
                [only] => Some((q, only.clone(), *span)),
                _ => None,
            }
        };
        let (Some((x, one, first)), Some((y, other, second))) = (value(Axis::X), value(Axis::Y)) else { return };
        let angles = one.sine != other.sine && one.angle != other.angle;
        if x != y && (one == other || angles) && self.points.len() < MOST {
            let (later, span, before) = if first.start > second.start { (x, first, y) } else { (y, second, x) };
            let parts = if first.start > second.start { [one, other] } else { [other, one] };
            self.points.push((span, later, before, parts));
        }
    }

    /// The section is over.
    fn judge(self, rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
        let other = |own: &Part| self.parts.iter().any(|part| part.angle == own.angle && part.sine != own.sine);
        let alone = |parts: &[Part; 2]| parts.iter().all(|part| !other(part));
        if let Some((span, later, before, parts)) = self.points.iter().find(|(.., parts)| alone(parts)) {
            let finding = rule.at(facts, *span).arg("parameter", later.to_string()).arg("other", before.to_string());
            let [one, two] = parts;
            let what = if one == two { "function" } else { "angle" };
            let value = if one == two { if one.sine { "SIN" } else { "COS" } } else { one.angle.as_str() };
            found.push(finding.arg("what", what).arg("value", value.to_owned()).arg("angle", two.angle.clone()));
        }
    }
}

/// Whether a sine or a cosine is in a formula.
fn has_angle(expr: &Expr) -> bool {
    match &expr.node {
        Node::Unary(_, inner) => has_angle(inner),
        Node::Binary(_, left, right) => has_angle(left) || has_angle(right),
        Node::Call(func, inner) => matches!(func, Func::Sin | Func::Cos) || inner.iter().any(has_angle),
        _ => false,
    }
}

/// An angle without what writers do differently.
fn plain(text: &str) -> String {
    let text: String = text.chars().filter(|own| !own.is_whitespace()).collect();
    text.trim_start_matches(['+', '(']).trim_end_matches(')').to_ascii_uppercase()
}
