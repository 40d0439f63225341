//! A tap where no hole was drilled, in a program that drills others; a tap that goes deeper than its hole; a thread
//! mill outside of a stud that goes into the floor around it.
//!
//! Only where the places and depths of all holes are known, in programs with a box as their blank and without
//! transformations; of cycles of the first controls also only without repetitions. A hole that goes through the blank
//! is deep enough. Each is said once a program.
use std::collections::{BTreeMap, BTreeSet};

use crate::base::diag::{Diagnostic, Severity, Span};
use crate::check::blank::Blank;
use crate::check::first_way::{EarlyCall, FirstWay};
use crate::check::incident::Incident;
use crate::check::program::{Work, number};
use crate::check::travel::incidents;
use crate::check::{Facts, Pending, Rule, is_milling};
use crate::spec::Group;

pub(super) const RULE: Rule = Rule { code: "tap-without-hole", severity: Severity::Warning, run };

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    for (span, own) in incidents(facts) {
        let (what, value, other) = match own {
            Incident::NoHole([x, y]) => ("missing", *x, *y),
            Incident::HoleTooShallow { tap, hole } => ("shallow", *tap, *hole),
            Incident::ThreadIntoFloor { thread, floor } => ("floor", *thread, *floor),
            _ => continue,
        };
        found.push(rule.comparison(facts, *span, what, value, other));
    }
    early(rule, facts, found);
    if !found.iter().any(|own| own.code == rule.code) {
        same_blocks(rule, facts, found);
    }
}

/// What a definition does to a hole.
#[derive(Clone, Copy)]
enum Does {
    /// It drills down to a height.
    Drills(f64),
    /// It drills, and how deep is not known, or nobody knows what it does.
    Anything,
    /// It taps: where its depth is written, to which height, and how deep below its surface.
    Taps(Span, f64, f64),
    Nothing,
}

/// A tap that goes deeper than the drill which is called by the same blocks, in whatever plane: not where the blank is so thin
/// that the hole may go through it.
fn same_blocks(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    /// Longer programs are written by posts, which name each place once.
    const LONGEST: usize = 3_000;
    let short = facts.begins() && facts.program.blocks().len() <= LONGEST;
    let Some(blank) = Blank::of(facts.program).filter(|_| short) else { return };
    let thinnest = (0..3).map(|axis| blank.high[axis] - blank.low[axis]).fold(f64::INFINITY, f64::min);
    let mut known: BTreeMap<u32, Does> = BTreeMap::new();
    // The deepest drill of each block.
    let mut drilled: BTreeMap<usize, f64> = BTreeMap::new();
    let mut open = BTreeSet::new();
    for call in &facts.run.calls {
        let does = match call.modal.pending {
            Pending::Definition(index) => *known.entry(index).or_insert_with(|| does(facts, index)),
            Pending::None | Pending::Unknown => Does::Anything,
        };
        match does {
            Does::Drills(bottom) => {
                let lowest = drilled.entry(call.block).or_insert(f64::INFINITY);
                *lowest = lowest.min(bottom);
            }
            Does::Anything => {
                open.insert(call.block);
            }
            Does::Taps(place, bottom, depth) => {
                let hole = drilled.get(&call.block).copied().filter(|_| !open.contains(&call.block));
                if let Some(hole) = hole.filter(|hole| bottom < *hole && depth < thinnest) {
                    return found.push(rule.comparison(facts, place, "shallow", bottom, hole));
                }
            }
            Does::Nothing => {}
        }
    }
}

fn does(facts: &Facts<'_>, index: u32) -> Does {
    let own = facts.definitions.get(index as usize);
    let Some((own, cycle)) = own.and_then(|own| Some((own, own.related_cycle()?))) else { return Does::Anything };
    let related = own.as_related_cycle();
    let read = facts.read(&related);
    let value = |meaning: &str| read.item(meaning).and_then(number);
    let surface = value("surface-coordinate");
    match cycle.file.group {
        Group::Drilling if is_milling(cycle) => Does::Anything,
        Group::Drilling => match surface.zip(value("depth")) {
            Some((surface, depth)) => Does::Drills(surface + depth),
            None => Does::Anything,
        },
        Group::Threads if !is_milling(cycle) => match (surface.zip(value("thread-depth")), read.item("thread-depth")) {
            (Some((surface, depth)), Some(item)) => Does::Taps(item.span, surface + depth, depth.abs()),
            _ => Does::Nothing,
        },
        _ => Does::Nothing,
    }
}

/// Holes so close are the same one, mm.
const NEAR: f64 = 0.1;

/// The same of holes that early cycles drill and tap.
fn early(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let way = FirstWay::of(facts);
    let Some(blank) = Blank::of(facts.program).filter(|_| way.complete && way.only && !way.others) else { return };
    let place = |call: &EarlyCall| Some([call.place[0]?, call.place[1]?]);
    let near = |one: [f64; 2], other: [f64; 2]| {
        (0..2).all(|axis| (one[axis] - other[axis]).abs() <= NEAR * facts.millimetre())
    };
    // Their places, and how deep they go.
    let (mut holes, mut taps) = (Vec::new(), Vec::new());
    for (call, own) in way.called() {
        let Some(place) = place(call) else { return };
        let bottom = call.place[2]
            .zip(own.clearance)
            .zip(own.depth.filter(|(depth, _)| *depth < 0.0))
            .map(|((z, (above, _)), (depth, _))| z - above.abs() + depth);
        match own.work {
            Work::Tapping | Work::RigidTapping => taps.push((place, bottom, call.span)),
            Work::Drilling => holes.push((place, bottom)),
            Work::Milling => holes.push((place, None)),
        }
    }
    let over = |place: [f64; 2]| holes.iter().filter(move |(own, _)| near(*own, place));
    if !taps.iter().any(|(place, ..)| over(*place).next().is_some()) {
        return;
    }
    if let Some(([x, y], _, span)) = taps.iter().find(|(place, ..)| over(*place).next().is_none()) {
        found.push(rule.comparison(facts, *span, "missing", *x, *y));
    }
    let short = taps.iter().find_map(|(place, tap, span)| {
        let bottoms: Option<Vec<f64>> = over(*place).map(|(_, bottom)| *bottom).collect();
        let lowest = bottoms?.into_iter().reduce(f64::min)?;
        let tap = tap.filter(|tap| *tap < lowest && lowest > blank.low[2])?;
        Some((*span, tap, lowest))
    });
    if let Some((span, tap, hole)) = short {
        found.push(rule.comparison(facts, span, "shallow", tap, hole));
    }
}
