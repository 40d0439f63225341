//! A datum shift to what was measured in the untilted plane that is defined in a tilted one: the shift then goes along the
//! tilted axes, to another place.
//!
//! Only of values that probing cycles have measured while the plane was certainly not tilted, and which the shift takes as
//! they are.
use std::collections::BTreeSet;

use crate::base::diag::{Diagnostic, Severity};
use crate::base::expr::{Node, QRef};
use crate::check::cycle::{Effect, probes};
use crate::check::{Aspect, Defined, Facts, Rule, Tri};
use crate::program::syntax::{Amount, Block, BlockKind, CycleForm, FnOp, ValueKind};

pub(super) const RULE: Rule = Rule { code: "shift-in-tilted-plane", severity: Severity::Warning, run };

/// The ends of the meanings of results that are coordinates.
const COORDINATES: [&str; 4] = ["-value-in-probe-axis", "centre-main-actual", "centre-minor-actual", "-coordinate"];

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let shifts: Vec<&Defined<'_>> = facts.definitions.iter().filter(|own| shifts(own)).collect();
    let tilting = |own: &Defined<'_>| facts.run.before(own.view.first).map(|modal| modal.is(Aspect::Tilting));
    if !shifts.iter().any(|own| tilting(own) == Some(Tri::Yes)) {
        return;
    }
    let measured = measured(facts);
    for own in shifts.into_iter().filter(|own| tilting(own) == Some(Tri::Yes)) {
        let CycleForm::Lines(lines) = &own.view.form else { continue };
        let values = lines.iter().flat_map(|line| &line.words).filter_map(|word| match word.value.kind {
            ValueKind::Q { q, .. } if measured.contains(&q) => Some((q, word.value.span)),
            _ => None,
        });
        if let Some((q, span)) = values.into_iter().next() {
            found.push(rule.at(facts, span).arg("parameter", q.to_string()));
            return;
        }
    }
}

/// The parameters that only hold coordinates which were measured in the untilted plane.
fn measured(facts: &Facts<'_>) -> BTreeSet<QRef> {
    let (mut measured, mut others) = (BTreeSet::new(), BTreeSet::new());
    // The results of the measurements in the untilted plane.
    let mut results: BTreeSet<QRef> = BTreeSet::new();
    let mut definitions = facts.definitions.iter().peekable();
    for (index, block) in facts.marked() {
        while let Some(own) = definitions.next_if(|own| own.view.first < index) {
            let Some(cycle) = own.related_cycle().filter(|cycle| probes(cycle)) else { continue };
            let flat = facts.run.before(own.view.first).is_some_and(|modal| modal.is(Aspect::Tilting) == Tri::No);
            for result in &cycle.file.results {
                let Some(q) = result.q else { continue };
                match flat && COORDINATES.iter().any(|end| result.is.as_str().ends_with(end)) {
                    true => results.insert(q),
                    false => results.remove(&q),
                };
            }
        }
        if let Some((target, from)) = assigned(block) {
            match from.is_some_and(|from| results.contains(&from)) {
                true => measured.insert(target),
                false => others.insert(target),
            };
        }
    }
    measured.difference(&others).copied().collect()
}

/// The parameter that a block gives a value, and the one from which it takes it as it is.
fn assigned(block: &Block) -> Option<(QRef, Option<QRef>)> {
    match &block.kind {
        BlockKind::FnAssign(own) => {
            let from = match (own.op, own.a.amount) {
                (FnOp::Set, Amount::Q { q, negative: false }) => Some(q),
                _ => None,
            };
            Some((own.target, from))
        }
        BlockKind::Formula(own) => {
            let from = match own.expr.node {
                Node::Q(q) => Some(q),
                _ => None,
            };
            Some((own.target, from))
        }
        _ => None,
    }
}

/// Whether a definition shifts the datum.
fn shifts(own: &Defined<'_>) -> bool {
    let aspects = own.related_cycle().map(|cycle| Effect::of_cycle(cycle).aspects);
    aspects.is_some_and(|all| !all.is_empty() && all.iter().all(|(aspect, _)| *aspect == Aspect::DatumShift))
}
