//! A size that is corrected by what was measured, the wrong way round: the deviation is added, or it is that of the other side;
//! or not the deviation but the measured size itself is taken away.
//!
//! A deviation is the actual size less the nominal one: what is too large is made smaller by taking it away from the size
//! with which it is machined again, be it a pocket or a stud. Only of parameters that are corrected by themselves, or
//! are a number and the deviation, and are a size of a pocket, a stud or a slot; or where the deviation of the other side of
//! the same rectangle is taken away. Also a deviation of a diameter or a width that is the oversize of a radius at a tool
//! call without being halved, or with the wrong sign.
use std::collections::{BTreeMap, BTreeSet};

use crate::base::diag::{Diagnostic, Severity, Span};
use crate::base::expr::{Node, Op, QRef};
use crate::check::cycle::{probes, probes_around, removes_material};
use crate::check::program::assigned;
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
    radius(rule, facts, found);
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

/// A multiple of a deviation that a parameter has.
#[derive(Clone, Copy)]
struct Share {
    deviation: QRef,
    factor: f64,
    /// What is measured gets smaller by machining.
    around: bool,
    span: Span,
}

/// Deviations of diameters and widths that correct a radius by all of them and not by half, or the wrong way round: a
/// tool that is called with a positive oversize stays away from the contour.
fn radius(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    if !facts.marked().any(|(_, block)| oversize(block).is_some()) {
        return;
    }
    let mut shares = Shares::default();
    let mut definitions = facts.definitions.iter().peekable();
    let mut used = Vec::new();
    for (index, block) in facts.marked() {
        while let Some(own) = definitions.next_if(|own| own.view.first < index) {
            shares.measure(own);
        }
        if let Some((q, sign, span)) = oversize(block)
            && let Some(around) = shares.deviations.get(&q)
        {
            used.push(Share { deviation: q, factor: sign, around: *around, span });
        }
        shares.assign(block);
    }
    // A tool call may come before the measurement, in a loop.
    let called = facts.marked().filter_map(|(_, block)| oversize(block));
    used.extend(called.filter_map(|(q, sign, _)| {
        let share = shares.own.get(&q).copied().flatten()?;
        Some(Share { factor: sign * share.factor, ..share })
    }));
    let mut reported: BTreeSet<usize> = BTreeSet::new();
    for (own, what) in used.iter().filter_map(|own| Some((own, own.fault()?))) {
        if reported.insert(own.span.start) {
            let finding = rule.at(facts, own.span).arg("what", what).arg("parameter", own.deviation.to_string());
            found.push(finding.arg("other", ""));
        }
    }
}

/// The parameter that is the oversize of a radius at a tool call, its sign and its place.
fn oversize(block: &Block) -> Option<(QRef, f64, Span)> {
    let BlockKind::ToolCall(call) = &block.kind else { return None };
    match call.dr?.amount {
        Amount::Q { q, negative } => Some((q, if negative { -1.0 } else { 1.0 }, call.dr?.span)),
        _ => None,
    }
}

impl Share {
    /// What is wrong with it as the oversize of a radius.
    fn fault(&self) -> Option<&'static str> {
        // What is too large is machined further with a stud by less oversize, with a pocket by more.
        let turned = (self.factor > 0.0) == self.around;
        match self.factor.abs() {
            1.0 => Some("radius"),
            0.5 if turned => Some("turned"),
            _ => None,
        }
    }
}

/// What is known of deviations on the way through the text.
#[derive(Default)]
struct Shares {
    /// Those that measurements give, and whether what is measured gets smaller by machining.
    deviations: BTreeMap<QRef, bool>,
    /// The parameters with a share of one; nothing of those that are unsure.
    own: BTreeMap<QRef, Option<Share>>,
}

impl Shares {
    fn measure(&mut self, own: &Defined<'_>) {
        let Some(cycle) = own.related_cycle().filter(|cycle| probes(cycle)) else { return };
        let around = probes_around(cycle) || cycle.file.name.as_str().contains("ridge");
        let deviations = cycle.file.results.iter().filter(|own| DEVIATIONS.contains(&own.is.as_str()));
        self.deviations.extend(deviations.filter_map(|own| Some((own.q?, around))));
    }

    /// The share that a parameter is.
    fn of(&self, q: QRef, span: Span) -> Option<Share> {
        match self.deviations.get(&q) {
            Some(around) => Some(Share { deviation: q, factor: 1.0, around: *around, span }),
            None => self.own.get(&q).copied().flatten(),
        }
    }

    fn assign(&mut self, block: &Block) {
        let Some((target, span)) = assigned(block) else { return };
        let linear = linear(block);
        let others = linear.iter().flatten().filter(|(q, _)| *q != target);
        let part = |(q, factor): &(QRef, f64)| {
            let share = self.of(*q, span)?;
            Some(Share { factor: share.factor * factor, span, ..share })
        };
        let parts: Vec<Option<Share>> = others.map(part).collect();
        let keeps = linear.as_ref().is_some_and(|all| all.iter().all(|(q, own)| *q != target || *own == 1.0));
        match (parts.as_slice(), keeps) {
            // A number, as before the first measurement.
            ([], true) => {}
            ([Some(only)], true) => {
                let same = |before: &Share| before.factor == only.factor && before.around == only.around;
                let before = self.own.entry(target).or_insert(Some(*only));
                *before = before.filter(same);
            }
            _ => {
                self.own.insert(target, None);
            }
        }
    }
}

/// The parameters in what a block calculates, with their factors; nothing if it is no sum of multiples of them.
fn linear(block: &Block) -> Option<Vec<(QRef, f64)>> {
    let of = |amount: Amount| match amount {
        Amount::Q { q, negative } => Some((vec![(q, if negative { -1.0 } else { 1.0 })], 0.0)),
        Amount::Number(number) => Some((Vec::new(), number)),
        Amount::Text(_) => None,
    };
    let sum = match &block.kind {
        BlockKind::FnAssign(own) => {
            let b = || own.b.as_ref().and_then(|own| of(own.amount));
            match own.op {
                FnOp::Set => of(own.a.amount)?,
                FnOp::Add => add(of(own.a.amount)?, b()?, 1.0),
                FnOp::Sub => add(of(own.a.amount)?, b()?, -1.0),
                FnOp::Mul => times(of(own.a.amount)?, b()?)?,
                FnOp::Div => over(of(own.a.amount)?, b()?)?,
                _ => return None,
            }
        }
        BlockKind::Formula(own) => sum_of(&own.expr.node)?,
        _ => return None,
    };
    Some(sum.0)
}

/// Multiples of parameters, and a number.
type Sum = (Vec<(QRef, f64)>, f64);

fn add(mut one: Sum, other: Sum, sign: f64) -> Sum {
    one.0.extend(other.0.into_iter().map(|(q, factor)| (q, sign * factor)));
    (one.0, one.1 + sign * other.1)
}

fn scaled(sum: Sum, by: f64) -> Sum {
    (sum.0.into_iter().map(|(q, factor)| (q, factor * by)).collect(), sum.1 * by)
}

fn times(one: Sum, other: Sum) -> Option<Sum> {
    match (one.0.is_empty(), other.0.is_empty()) {
        (true, _) => Some(scaled(other, one.1)),
        (_, true) => Some(scaled(one, other.1)),
        _ => None,
    }
}

fn over(one: Sum, other: Sum) -> Option<Sum> {
    (other.0.is_empty() && other.1 != 0.0).then(|| scaled(one, 1.0 / other.1))
}

fn sum_of(node: &Node) -> Option<Sum> {
    Some(match node {
        Node::Number(number) => (Vec::new(), *number),
        Node::Q(q) => (vec![(*q, 1.0)], 0.0),
        Node::Unary(Op::Sub, inner) => scaled(sum_of(&inner.node)?, -1.0),
        Node::Unary(Op::Add, inner) => sum_of(&inner.node)?,
        Node::Binary(op, left, right) => {
            let (left, right) = (sum_of(&left.node)?, sum_of(&right.node)?);
            match op {
                Op::Add => add(left, right, 1.0),
                Op::Sub => add(left, right, -1.0),
                Op::Mul => times(left, right)?,
                Op::Div => over(left, right)?,
                _ => return None,
            }
        }
        _ => return None,
    })
}
