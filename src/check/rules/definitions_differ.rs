//! Two definitions of a cycle that rough and finish the same pocket or slot, and do not describe the same one: one size
//! differs; the same of a turned contour. Also one that infeeds ten times as much as the other, and two that only rough
//! and leave the same allowance; and one that infeeds at least twice its depth, though the depth is greater than the
//! diameter of its tool.
//!
//! Only where all the other sizes are equal, so that both certainly mean the same, and where no other definition goes
//! with either of them.
use std::collections::{HashMap, HashSet};

use crate::base::diag::{Diagnostic, Severity, Span};
use crate::check::program::number;
use crate::check::tools::Tools;
use crate::check::{Facts, Loaded, Pending, Rule};
use crate::spec::{CycleKey, Group};

pub(super) const RULE: Rule = Rule { code: "definitions-differ", severity: Severity::Warning, run };

/// An infeed that is so many times the depth takes all of it at once by a slip, where it is so many times as deep as the tool is
/// wide.
const FAR: (f64, f64) = (1.5, 1.5);

/// The meaning of the choice between roughing and finishing, with the values for roughing alone and for both.
const OPERATIONS: [&str; 2] = ["machining-operation", "turning-operation"];
const ROUGHING: f64 = 1.0;
const BOTH: f64 = 0.0;
/// The meanings of what is the same for roughing and finishing.
const SIZES: [&str; 24] = [
    "first-side-length",
    "second-side-length",
    "stud-first-side-length",
    "stud-second-side-length",
    "finished-part-diameter",
    "corner-radius",
    "circle-diameter",
    "slot-length",
    "milled-slot-width",
    "pitch-circle-diameter",
    "pitch-circle-centre-main",
    "pitch-circle-centre-minor",
    "slot-starting-angle",
    "slot-opening-angle",
    "angle-of-rotation",
    "pocket-position",
    "depth",
    "surface-coordinate",
    "contour-start-diameter",
    "contour-start-z",
    "contour-end-diameter",
    "contour-end-z",
    "circumferential-surface-angle",
    "face-angle",
];
/// The meanings of the depth, of an infeed and of what roughing leaves.
const DEPTH: &str = "depth";
const INFEED: &str = "plunging-depth";
const ALLOWANCES: [&str; 2] = ["side-allowance", "floor-allowance"];
/// So much more one infeeds than the other by a slip.
const SLIP: f64 = 10.0;
/// More definitions are written by posts; each is compared with all the others.
const MOST: usize = 1 << 8;
/// What counts as the same, mm or inch.
const SAME: f64 = 1e-6;

/// A definition of a pocket or a slot.
struct Pocket {
    key: CycleKey,
    /// Whether it is a turned contour.
    turned: bool,
    operation: (f64, Span),
    /// The sizes that its cycle has, in the order of their meanings.
    sizes: Vec<(f64, Span)>,
    depth: f64,
    infeed: Option<(f64, Span)>,
    allowances: [f64; 2],
    /// The tool of its first call.
    tool: Option<Loaded>,
}

impl Pocket {
    /// The places of the sizes that differ; nothing if both cannot be the same.
    fn differs(&self, other: &Self) -> Option<Vec<usize>> {
        (self.key == other.key && self.sizes.len() == other.sizes.len()).then(|| {
            let apart = |at: &usize| (self.sizes[*at].0 - other.sizes[*at].0).abs() > SAME;
            (0..self.sizes.len()).filter(apart).collect()
        })
    }

    fn is_same(&self, other: &Self) -> bool {
        self.differs(other).is_some_and(|own| own.is_empty())
    }

    const fn roughs(&self) -> bool {
        self.operation.0 == ROUGHING
    }

    const fn finishes(&self) -> bool {
        self.operation.0 > ROUGHING
    }
}

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let mut pockets = pockets(facts);
    if pockets.len() > MOST {
        pockets.clear();
    }
    let finding_of = |(value, span): (f64, Span), what, other| rule.comparison(facts, span, what, value, other);
    for (at, own) in pockets.iter().enumerate() {
        let others = || pockets.iter().enumerate().filter(move |(other, _)| *other != at).map(|(_, own)| own);
        if let Some((infeed, span)) = own.infeed
            && infeed > 2.0 * own.depth.abs()
            && let Some(usual) = others().filter(|other| own.is_same(other)).find_map(|other| other.infeed)
            && (infeed - SLIP * usual.0).abs() <= SAME
        {
            found.push(finding_of((infeed, span), "infeed", usual.0));
        }
        if own.roughs() && own.allowances.iter().any(|left| *left > 0.0) {
            let before = pockets.iter().take(at).find(|other| own.is_same(other) && other.roughs());
            let finished = others().any(|other| own.is_same(other) && !other.roughs());
            if let Some(before) = before.filter(|before| !finished && before.allowances == own.allowances)
                && own.tool.is_some()
                && own.tool != before.tool
            {
                let left = own.allowances[0].max(own.allowances[1]);
                found.push(finding_of(own.operation, "operation", left));
            }
        }
        if !own.finishes() || others().any(|other| own.is_same(other)) {
            continue;
        }
        let lone = |rough: &&Pocket| rough.roughs() && !pockets.iter().any(|own| own.finishes() && own.is_same(rough));
        let near: Vec<(usize, &Pocket)> = pockets
            .iter()
            .take(at)
            .filter(lone)
            .filter_map(|rough| match own.differs(rough)?.as_slice() {
                [only] if own.sizes.len() > 2 => Some((*only, rough)),
                _ => None,
            })
            .collect();
        if let [(size, rough)] = near.as_slice() {
            let what = if own.turned { "turned" } else { "size" };
            found.push(finding_of(own.sizes[*size], what, rough.sizes[*size].0));
        }
    }
    deep(rule, facts, found);
}

/// Definitions that infeed by at least twice their depth, although the tool is narrower than the depth: a digit too many.
fn deep(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let Some(tools) = Tools::of(facts) else { return };
    let mut seen = HashSet::new();
    for call in &facts.run.calls {
        let Pending::Definition(index) = call.modal.pending else { continue };
        let Some(own) = facts.definitions.get(index as usize).filter(|_| seen.insert(index)) else { continue };
        if own.related_cycle().is_none_or(|cycle| cycle.file.group != Group::Pockets) {
            continue;
        }
        let Some(tool) = tools.get(call.modal.loaded) else { continue };
        let related = own.as_related_cycle();
        let read = facts.read(&related);
        let value = |meaning: &str| read.item(meaning).and_then(number);
        // Finishing may go down at once.
        if value(OPERATIONS[0]).is_some_and(|operation| operation > ROUGHING) {
            continue;
        }
        let (Some(item), Some(infeed), Some(depth)) = (read.item(INFEED), value(INFEED), value(DEPTH)) else {
            continue;
        };
        let reported = found
            .iter()
            .any(|own| own.code == rule.code && own.place.as_ref().is_some_and(|place| place.span == item.value_span));
        let (depth, width) = (depth.abs(), 2.0 * tool.radius);
        let whole = infeed >= 2.0 * depth && depth > width || infeed >= FAR.0 * depth && depth > FAR.1 * width;
        if whole && !reported {
            found.push(rule.comparison(facts, item.value_span, "deep", infeed, depth));
        }
    }
}

/// The definitions of pockets and slots of which all sizes are known and which are called.
fn pockets(facts: &Facts<'_>) -> Vec<Pocket> {
    let mut pockets = Vec::new();
    // The tools of their first calls.
    let mut tools: HashMap<u32, Loaded> = HashMap::new();
    for call in &facts.run.calls {
        if let Pending::Definition(index) = call.modal.pending {
            tools.entry(index).or_insert(call.modal.loaded);
        }
    }
    for (index, own) in facts.definitions.iter().enumerate() {
        let Some(group) = own.related_cycle().map(|cycle| cycle.file.group) else { continue };
        let turned = group == Group::Turning;
        if !turned && group != Group::Pockets {
            continue;
        }
        let related = own.as_related_cycle();
        let read = facts.read(&related);
        let value = |meaning: &str| read.item(meaning).and_then(|item| Some((number(item)?, item.value_span)));
        let Some(operation) = OPERATIONS.into_iter().find_map(value) else { continue };
        // What is turned has no depth.
        let Some(depth) = value(DEPTH).map(|own| own.0).or(turned.then_some(0.0)) else { continue };
        let written: Vec<&str> = SIZES.into_iter().filter(|meaning| read.item(meaning).is_some()).collect();
        let Some(sizes) = written.into_iter().map(value).collect::<Option<Vec<_>>>() else { continue };
        let index = u32::try_from(index).unwrap_or(u32::MAX);
        let tool = tools.get(&index).copied();
        let allowances = ALLOWANCES.map(|meaning| value(meaning).map_or(0.0, |own| own.0));
        let infeed = value(INFEED);
        pockets.push(Pocket { key: own.key, turned, operation, sizes, depth, infeed, allowances, tool });
    }
    // What does both says nothing of another one.
    pockets.retain(|own| own.operation.0 >= BOTH);
    pockets
}
