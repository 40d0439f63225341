//! A coordinate that is the result of another axis: cycles and functions write the angles of A, B and C, and the places in X,
//! Y and Z that a probe has touched, into parameters of their own, one for each axis.
//!
//! Also a measured value less the nominal value that the same measurement has for another one, or compared with it: the
//! centre less the diameter, or a jump if the centre is less than the diameter.
//!
//! The spatial angles that a plane was measured with belong to SPA, SPB and SPC each.
//!
//! Only movements that name the parameter alone, in programs that do not write these parameters themselves.
use std::collections::BTreeMap;

use crate::base::diag::{Arg, Diagnostic, Severity, Span};
use crate::base::expr::{Node, Op, QKind, QRef};
use crate::check::cycle::probes;
use crate::check::program::{assigned, copied, number};
use crate::check::{Defined, Facts, Rule};
use crate::program::syntax::{
    Amount, Axis, Block, BlockKind, CycleKeyword, FnOp, Operand, Relation, StatementKind, ValueKind,
};

pub(super) const RULE: Rule = Rule { code: "result-of-other-axis", severity: Severity::Warning, run };

/// How the meanings of measured values end.
const ACTUAL: &str = "-actual";
/// Nominal values that differ by less are the same.
const SAME: f64 = 1e-6;
/// A limit is so near to the nominal value, as a part of it, and so far from that of the result that is compared.
const LIMITS: [f64; 2] = [0.01, 0.2];
/// The parameters with the results of axes: the touched place, then the angles that tilt the working plane.
const RESULTS: [(u16, Axis); 6] =
    [(115, Axis::X), (116, Axis::Y), (117, Axis::Z), (120, Axis::A), (121, Axis::B), (122, Axis::C)];

/// How the meanings of spatial angles that are measured begin.
const SPATIAL: &str = "spatial-angle-";

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    sizes(rule, facts, found);
    planes(rule, facts, found);
    // Most programs have none of them.
    let text = facts.program.source().text();
    if !RESULTS.iter().any(|(number, _)| text.contains(&format!("Q{number}"))) {
        return;
    }
    let of = |q: QRef| RESULTS.iter().find(|(number, _)| q.kind == QKind::Q && q.number == *number);
    let written = facts.program.blocks().iter().any(|block| match &block.kind {
        BlockKind::FnAssign(own) => of(own.target).is_some(),
        BlockKind::Formula(own) => of(own.target).is_some(),
        _ => false,
    });
    if written {
        return;
    }
    for block in facts.program.blocks() {
        let BlockKind::Motion(motion) = &block.kind else { continue };
        if !motion.outline().has_parameters() {
            continue;
        }
        for coord in &motion.words().coords {
            let Amount::Q { q, .. } = coord.value.amount else { continue };
            let Some((number, axis)) = of(q) else { continue };
            let alike = RESULTS.iter().filter(|(_, own)| is_linear(*own) == is_linear(*axis));
            if coord.axis != *axis && alike.into_iter().any(|(_, own)| *own == coord.axis) {
                let finding = rule.at(facts, coord.value.span).arg("what", "axis");
                let finding = finding.arg("parameter", format!("Q{number}"));
                found.push(finding.arg("axis", format!("{axis:?}")).arg("other", format!("{:?}", coord.axis)));
            }
        }
    }
}

/// Planes that name the spatial angle of another axis, in the words for angles or in a cycle for the working plane.
fn planes(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let spatial = |own: &&crate::spec::Cycle| own.file.results.iter().any(|own| own.is.as_str().starts_with(SPATIAL));
    let Some(cycle) = facts.definitions.iter().filter_map(Defined::related_cycle).find(spatial) else { return };
    let axis_of = |q: QRef| {
        let result = cycle.file.results.iter().find(|own| own.q == Some(q))?;
        result.is.as_str().strip_prefix(SPATIAL)?.chars().next().map(|axis| axis.to_ascii_uppercase())
    };
    let copies = copies(facts);
    for block in facts.program.blocks() {
        let words = match &block.kind {
            BlockKind::Statement(own) if own.kind == StatementKind::Plane => &own.words,
            BlockKind::OldCycleLine(own) if own.keyword == CycleKeyword::CyclDef => &own.words,
            _ => continue,
        };
        for word in words {
            let ValueKind::Q { q, negative: false } = word.value.kind else { continue };
            let q = copies.get(&q).copied().unwrap_or(q);
            let name = facts.text(word.name).trim().to_ascii_uppercase();
            let named = name.strip_prefix("SP").unwrap_or(&name);
            let other = match named {
                "A" => 'A',
                "B" => 'B',
                "C" => 'C',
                _ => continue,
            };
            if let Some(axis) = axis_of(q).filter(|axis| *axis != other) {
                let finding = rule.at(facts, word.value.span).arg("what", "axis").arg("parameter", q.to_string());
                found.push(finding.arg("axis", axis.to_string()).arg("other", other.to_string()));
            }
        }
    }
}

/// The parameters that are copies of one other parameter, and are written once.
fn copies(facts: &Facts<'_>) -> BTreeMap<QRef, QRef> {
    let mut copies: BTreeMap<QRef, Option<QRef>> = BTreeMap::new();
    for (_, block) in facts.marked() {
        let Some((target, _)) = assigned(block) else { continue };
        let of = copied(block);
        copies.entry(target).and_modify(|own| *own = None).or_insert(of);
    }
    copies.into_iter().filter_map(|(target, of)| Some((target, of?))).collect()
}

const fn is_linear(axis: Axis) -> bool {
    matches!(axis, Axis::X | Axis::Y | Axis::Z)
}

/// Measured values less the nominal value of another one of the same measurement: the centre less the nominal diameter.
fn sizes(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    // The results of the last measurement with their nominal values.
    let mut nominal: Vec<(QRef, f64)> = Vec::new();
    let mut definitions = facts.definitions.iter().peekable();
    for (index, block) in facts.marked() {
        while let Some(own) = definitions.next_if(|own| own.view.first < index) {
            let Some(cycle) = own.related_cycle().filter(|cycle| probes(cycle)) else { continue };
            let related = own.as_related_cycle();
            let read = facts.read(&related);
            let value = |q: QRef| read.items.iter().find(|item| item.param.is_some_and(|own| own.q == Some(q)));
            let actual = cycle.file.results.iter().filter(|own| own.is.as_str().ends_with(ACTUAL));
            let known = actual.filter_map(|own| Some((own.q?, value(own.of?).and_then(number)?)));
            nominal = known.collect();
        }
        let near = |one: f64, other: f64, part: f64| (one - other).abs() <= (part * one.abs()).max(SAME);
        let (difference, jump) = (difference(block), comparison(facts, block));
        // What is compared with a limit need not be the nominal value itself.
        let ([close, apart], Some((q, value, span))) =
            (if jump.is_some() { LIMITS } else { [0.0; 2] }, difference.or(jump))
        else {
            continue;
        };
        let Some((_, own)) = nominal.iter().find(|(known, _)| *known == q) else { continue };
        let other = nominal.iter().find(|(known, own)| *known != q && near(*own, value, close));
        if let Some((other, _)) = other.filter(|_| !near(value, *own, apart)) {
            let finding = rule.at(facts, span).arg("what", "size").arg("parameter", q.to_string());
            found.push(finding.arg("value", Arg::Number(value)).arg("other", other.to_string()));
        }
    }
}

/// A measured value and the number with which a jump compares it.
fn comparison(facts: &Facts<'_>, block: &Block) -> Option<(QRef, f64, Span)> {
    let BlockKind::FnJump(jump) = &block.kind else { return None };
    let q = |own: Amount| match own {
        Amount::Q { q, negative: false } => Some(q),
        _ => None,
    };
    let known = |one: &Operand, other: &Operand| Some((q(one.amount)?, facts.number(other)?));
    let (q, value) = known(&jump.a, &jump.b).or_else(|| known(&jump.b, &jump.a))?;
    let sized = matches!(jump.relation, Relation::Less | Relation::Greater) && value != 0.0;
    sized.then(|| (q, value, facts.content(block)))
}

/// A parameter and a number of which the difference is calculated.
fn difference(block: &Block) -> Option<(QRef, f64, Span)> {
    let of = |a: Amount, b: Amount| match (a, b) {
        (Amount::Q { q, negative: false }, Amount::Number(own))
        | (Amount::Number(own), Amount::Q { q, negative: false }) => Some((q, own)),
        _ => None,
    };
    match &block.kind {
        BlockKind::FnAssign(own) if own.op == FnOp::Sub => {
            let (q, value) = of(own.a.amount, own.b.as_ref()?.amount)?;
            Some((q, value, own.target_span))
        }
        BlockKind::Formula(own) => {
            let Node::Binary(Op::Sub, left, right) = &own.expr.node else { return None };
            let (q, value) = match (&left.node, &right.node) {
                (Node::Q(q), Node::Number(value)) | (Node::Number(value), Node::Q(q)) => (*q, *value),
                _ => return None,
            };
            Some((q, value, own.target_span))
        }
        _ => None,
    }
}
