//! A size that is corrected by what was measured, the wrong way round: the deviation is added, or it is that of the other side;
//! or not the deviation but the measured size itself is taken away.
//!
//! A deviation is the actual size less the nominal one: what is too large is made smaller by taking it away from the size
//! with which it is machined again, be it a pocket or a stud. Only of parameters that are corrected by themselves, or
//! are a number and the deviation, and are a size of a pocket, a stud or a slot; or where the deviation of the other side of
//! the same rectangle is taken away.
use std::collections::{BTreeMap, BTreeSet};

use crate::base::diag::{Diagnostic, Severity, Span};
use crate::base::expr::{Node, Op, QRef};
use crate::check::cycle::{probes, removes_material};
use crate::check::{Defined, Facts, Rule};
use crate::program::syntax::{Amount, Block, BlockKind, FnOp, ValueKind};
use crate::spec::Keyword;

pub(super) const RULE: Rule = Rule { code: "correction-wrong", severity: Severity::Warning, run };

/// The meanings of deviations of sizes.
const DEVIATIONS: [&str; 4] = [MAIN, MINOR, "diameter-deviation", "measured-length-deviation"];
const MAIN: &str = "side-main-deviation";
const MINOR: &str = "side-minor-deviation";
/// The meanings of the sizes themselves, as they were measured.
const ACTUALS: [&str; 3] = ["diameter-actual", "side-main-actual", "side-minor-actual"];
/// The meanings of the sizes that cycles machine.
const SIZES: [&str; 8] = [
    FIRST,
    SECOND,
    "stud-first-side-length",
    "stud-second-side-length",
    "circle-diameter",
    "finished-part-diameter",
    "nominal-diameter",
    "milled-slot-width",
];
const FIRST: &str = "first-side-length";
const SECOND: &str = "second-side-length";
/// The parameters that are sides in every cycle that machines, be it described or not.
const SIDES: [(&str, &str); 2] = [("Q218", FIRST), ("Q219", SECOND)];

/// So many corrections by one measurement are compared.
const MOST: usize = 32;

/// A parameter that is changed by a deviation.
struct Correction {
    target: QRef,
    deviation: QRef,
    span: Span,
    added: bool,
    /// The first block of the measurement.
    measured: usize,
}

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let (results, corrections) = corrections(facts);
    if corrections.is_empty() {
        return;
    }
    let sizes = sizes(facts);
    let meanings: BTreeSet<(usize, &str)> = results.iter().map(|((at, _), meaning)| (*at, *meaning)).collect();
    let sizes_of = |own: &Correction| sizes.get(&own.target);
    for own in &corrections {
        let Some(sizes) = sizes_of(own) else {
            if own.added && unlike_other_side(own, &corrections, &results) {
                let finding = rule.at(facts, own.span).arg("what", "added").arg("parameter", own.target.to_string());
                found.push(finding.arg("other", own.deviation.to_string()));
            }
            continue;
        };
        let measured_size = results.get(&(own.measured, own.deviation)).is_some_and(|own| ACTUALS.contains(own));
        let finding_of = |what: &'static str| {
            let finding = rule.at(facts, own.span).arg("what", what).arg("parameter", own.target.to_string());
            finding.arg("other", own.deviation.to_string())
        };
        // An allowance may be added to what was measured.
        if own.added || measured_size {
            let what = if measured_size { "actual" } else { "added" };
            found.extend((own.added != measured_size).then(|| finding_of(what)));
            continue;
        }
        // The same deviation also corrects the side that it is of, and the other deviation no side.
        let meaning = |q: QRef| results.get(&(own.measured, q)).copied();
        let (Some(own_meaning), Some(only), 1) = (meaning(own.deviation), sizes.first(), sizes.len()) else { continue };
        let (side, other) = match own_meaning {
            MAIN => (FIRST, MINOR),
            MINOR => (SECOND, MAIN),
            _ => continue,
        };
        let first = corrections.partition_point(|other| other.measured < own.measured);
        let after = corrections.get(first..).unwrap_or_default();
        let same = || after.iter().take(MOST).take_while(|other| other.measured == own.measured);
        let twice = same()
            .any(|other| other.deviation == own.deviation && sizes_of(other).is_some_and(|sizes| sizes.contains(side)));
        let measured = meanings.contains(&(own.measured, other));
        let unused = !same().any(|second| meaning(second.deviation) == Some(other));
        if (*only == FIRST || *only == SECOND) && *only != side && twice && measured && unused {
            found.push(finding_of("side"));
        }
    }
}

/// Whether the deviation of one side of a rectangle is added though that of the other side, of the same measurement, is taken
/// away from what it corrects: this needs no cycle that says what is corrected.
fn unlike_other_side(own: &Correction, all: &[Correction], results: &BTreeMap<(usize, QRef), &'static str>) -> bool {
    let meaning = |other: &Correction| results.get(&(other.measured, other.deviation)).copied();
    let side = match meaning(own) {
        Some(MAIN) => MINOR,
        Some(MINOR) => MAIN,
        _ => return false,
    };
    let first = all.partition_point(|other| other.measured < own.measured);
    let same = all.get(first..).unwrap_or_default().iter().take(MOST).filter(|other| other.measured == own.measured);
    let others: Vec<&Correction> = same.filter(|other| meaning(other) == Some(side)).collect();
    !others.is_empty() && others.iter().all(|other| !other.added && other.target != own.target)
}

/// The meanings of results, by the measurement and the parameter; and what they correct.
fn corrections(facts: &Facts<'_>) -> (BTreeMap<(usize, QRef), &'static str>, Vec<Correction>) {
    let (mut results, mut all) = (BTreeMap::new(), Vec::new());
    let mut measured = None;
    let mut definitions = facts.definitions.iter().peekable();
    for (index, block) in facts.marked() {
        while let Some(own) = definitions.next_if(|own| own.view.first < index) {
            let Some(cycle) = own.related_cycle().filter(|cycle| probes(cycle)) else { continue };
            for result in &cycle.file.results {
                let meaning = DEVIATIONS.into_iter().chain(ACTUALS).find(|own| *own == result.is.as_str());
                if let Some((meaning, q)) = meaning.zip(result.q) {
                    results.insert((own.view.first, q), meaning);
                    measured = Some(own.view.first);
                }
            }
        }
        let Some(measured) = measured else { continue };
        if let Some((target, deviation, added, span)) = correction(block)
            && results.contains_key(&(measured, deviation))
        {
            all.push(Correction { target, deviation, span, added, measured });
        }
    }
    (results, all)
}

/// A parameter to which another one is added, or from which it is taken away: both, whether it is added, and the place.
fn correction(block: &Block) -> Option<(QRef, QRef, bool, Span)> {
    let plain = |amount: Amount| match amount {
        Amount::Q { q, negative: false } => Some(q),
        _ => None,
    };
    let (target, span, added, a, b) = match &block.kind {
        BlockKind::FnAssign(own) => {
            let added = match own.op {
                FnOp::Add => true,
                FnOp::Sub => false,
                _ => return None,
            };
            let (a, b) = (own.a.amount, own.b.as_ref()?.amount);
            match (a, b) {
                (Amount::Number(_), Amount::Q { q, negative: false }) => {
                    return Some((own.target, q, added, own.target_span));
                }
                (Amount::Q { q, negative: false }, Amount::Number(_)) if added => {
                    return Some((own.target, q, added, own.target_span));
                }
                _ => {}
            }
            (own.target, own.target_span, added, plain(a)?, plain(b)?)
        }
        BlockKind::Formula(own) => {
            let Node::Binary(op @ (Op::Add | Op::Sub), left, right) = &own.expr.node else { return None };
            let (a, b) = match (&left.node, &right.node) {
                (Node::Q(a), Node::Q(b)) => (a, b),
                (Node::Number(_), Node::Q(q)) => return Some((own.target, *q, *op == Op::Add, own.target_span)),
                (Node::Q(q), Node::Number(_)) if *op == Op::Add => {
                    return Some((own.target, *q, true, own.target_span));
                }
                _ => return None,
            };
            (own.target, own.target_span, *op == Op::Add, *a, *b)
        }
        _ => return None,
    };
    if a == target {
        Some((target, b, added, span))
    } else if b == target && added {
        Some((target, a, added, span))
    } else {
        None
    }
}

/// The sizes that parameters are, by their meanings.
fn sizes(facts: &Facts<'_>) -> BTreeMap<QRef, BTreeSet<&'static str>> {
    let mut sizes: BTreeMap<QRef, BTreeSet<&'static str>> = BTreeMap::new();
    let machines = |own: &&Defined<'_>| match own.related_cycle() {
        Some(cycle) => removes_material(cycle),
        None => own.key.keyword == Keyword::CyclDef,
    };
    for own in facts.definitions.iter().filter(machines) {
        let related = own.as_related_cycle();
        for item in &facts.read(&related).items {
            let meaning = match item.param {
                Some(param) => SIZES.into_iter().find(|own| *own == param.is.as_str()),
                None => SIDES.into_iter().find(|(q, _)| *q == item.name.as_ref()).map(|(_, meaning)| meaning),
            };
            if let (Some(meaning), Some(ValueKind::Q { q, negative: false })) =
                (meaning, item.value.map(|own| own.kind))
            {
                sizes.entry(q).or_default().insert(meaning.trim_start_matches("stud-"));
            }
        }
    }
    sizes
}
