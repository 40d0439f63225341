//! A cycle that begins at a height at which there is no material or still is some: above a face that the program has
//! milled lower, or above the blank where the same height with the other sign is the floor on which others work.
//!
//! Also a cycle of the first controls, whose surface lies by the set-up clearance below the place where it is called,
//! and which is called far too high, or at a height inside of the blank; and a pattern that sets another surface than
//! the cycle which it calls: that of the pattern acts.
//!
//! Also a cycle on the surface of a cylinder with another radius than the blank has about its axis.
//!
//! Also a cycle for holes, pockets or contours that meets nothing although it goes below the top of the blank, where an
//! execution shows it: a tool that the table knows has removed all of it before.
//!
//! Also a cycle in a tilted plane whose surface lies below everything that was machined before, while the other cycles at the
//! same places all have another surface.
//!
//! Only where numbers say all of it, in programs with a box as their blank; not after transformations, but that one, and
//! heights also in turned coordinates.
use std::cell::OnceCell;
use std::collections::{BTreeMap, BTreeSet};

use crate::base::diag::{Diagnostic, Severity, Span};
use crate::check::blank::{Blank, diameter, is_unmoved, keeps_heights, top};
use crate::check::cycle::removes_material;
use crate::check::first_way::FirstWay;
use crate::check::floors::{DEPTHS, SURFACE, bottom, lowest_before};
use crate::check::incident::Incident;
use crate::check::program::number;
use crate::check::travel::first_incident;
use crate::check::{Aspect, Facts, Pending, Rule, Tri};
use crate::program::syntax::{Amount, Axis, BlockKind, StatementKind};
use crate::spec::{Cycle, Group};

pub(super) const RULE: Rule = Rule { code: "surface-wrong", severity: Severity::Warning, run };

/// The meanings of a face that is milled: where it begins and ends, and its sides.
const FACE: [&str; 6] = [
    "starting-point-main",
    "starting-point-minor",
    "first-side-length",
    "second-side-length",
    "end-point-tool",
    "starting-point-tool",
];
/// The meaning of the radius of a cylinder on whose surface is machined.
const CYLINDER: &str = "cylinder-radius";
/// The meaning of the distance above the surface down to which the tool goes at rapid.
const CLEARANCE: &str = "set-up-clearance";
/// So many others make a surface unlike them.
const OTHERS: usize = 2;
/// A surface so much higher is no longer the milled one, mm.
const HIGHER: f64 = 1.0;
/// So much of the blank a face covers at least.
const MOST: f64 = 0.9;

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    unlike_others(rule, facts, found);
    same_blocks(rule, facts, found);
    let Some(top) = top(facts.program).filter(|_| facts.begins()) else { return };
    let unit = facts.millimetre();
    patterns(rule, facts, top, found);
    cylinders(rule, facts, found);
    let Some(blank) = Blank::of(facts.program) else { return };
    early(rule, facts, &blank, found);
    let mut seen = std::collections::HashSet::new();
    // The lowest face over the whole blank, and the surfaces and floors of the cycles.
    let mut face: Option<f64> = None;
    let mut reported = false;
    let (mut surfaces, mut floors) = (Vec::new(), Vec::new());
    for call in facts.run.calls.iter().filter(|call| keeps_heights(&call.modal)) {
        let Pending::Definition(index) = call.modal.pending else { continue };
        let Some(own) = facts.definitions.get(index as usize).filter(|_| seen.insert(index)) else { continue };
        let Some(cycle) = own.related_cycle() else { continue };
        let related = own.as_related_cycle();
        let read = facts.read(&related);
        let value = |meaning: &str| read.item(meaning).and_then(number);
        if cycle.file.group == Group::Surfaces {
            if let [Some(x), Some(y), Some(long), Some(wide), Some(end), _] = FACE.map(value) {
                let covers = |axis: usize, from: f64, side: f64| {
                    let (low, high) = (from.min(from + side), from.max(from + side));
                    high.min(blank.high[axis]) - low.max(blank.low[axis]) >= MOST * (blank.high[axis] - blank.low[axis])
                };
                if is_unmoved(&call.modal) && covers(0, x, long) && covers(1, y, wide) {
                    face = Some(face.map_or(end, |lowest| lowest.min(end)));
                }
            }
            continue;
        }
        let drills = matches!(cycle.file.group, Group::Drilling | Group::Threads | Group::Pockets);
        let Some((surface, item)) = read.item(SURFACE).and_then(|item| Some((number(item)?, item))) else { continue };
        if !drills {
            continue;
        }
        if let Some(face) = face.filter(|face| surface > face + HIGHER * unit && !reported) {
            reported = true;
            found.push(rule.comparison(facts, item.value_span, "faced", surface, face));
        }
        floors.extend(bottom(&read));
        surfaces.push((surface, item.value_span));
    }
    let in_air = first_incident(facts, |own| match own {
        Incident::InAir(height) => Some(height),
        _ => None,
    });
    if let Some((span, height)) = in_air.filter(|_| !reported) {
        found.push(rule.comparison(facts, span, "air", height, blank.high[2]));
    }
    let same = |one: f64, other: f64| (one - other).abs() <= 1e-6;
    let opposite = surfaces.iter().find(|(own, _)| {
        let below =
            surfaces.iter().any(|(other, _)| same(-own, *other)) || floors.iter().any(|floor| same(-own, *floor));
        *own > top + HIGHER * unit && -own < top && below
    });
    if let Some((surface, span)) = opposite {
        found.push(rule.comparison(facts, *span, "opposite", *surface, -surface));
    }
}

/// A cycle for holes in a tilted plane that begins below all floors, unlike at least two others that the same blocks call.
fn unlike_others(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    if facts.program.blocks().len() > LONGEST {
        return;
    }
    let unit = facts.millimetre();
    let mut called: BTreeMap<usize, BTreeSet<usize>> = BTreeMap::new();
    for call in &facts.run.calls {
        let Pending::Definition(index) = call.modal.pending else { return };
        if call.modal.is(Aspect::Tilting) == Tri::Yes {
            called.entry(call.block).or_default().insert(index as usize);
        }
    }
    let value = |index: &usize, meaning: &str| {
        let own = facts.definitions.get(*index)?;
        let related = own.as_related_cycle();
        facts.read(&related).item(meaning).and_then(|item| Some((number(item)?, item.value_span)))
    };
    for all in called.values().filter(|all| all.len() > OTHERS) {
        for own in all {
            let Some((surface, span)) = value(own, SURFACE) else { continue };
            let others: Option<Vec<f64>> =
                all.iter().filter(|other| *other != own).map(|other| Some(value(other, SURFACE)?.0)).collect();
            let Some([first, rest @ ..]) = others.as_deref() else { continue };
            if rest.iter().any(|other| (other - first).abs() > 1e-6) {
                continue;
            }
            let begins = surface + value(own, CLEARANCE).map_or(0.0, |(clearance, _)| clearance.max(0.0));
            if begins < first - HIGHER * unit
                && lowest_before(facts, *own).is_some_and(|lowest| begins < lowest - HIGHER * unit)
            {
                found.push(rule.comparison(facts, span, "unlike", surface, *first));
                return;
            }
        }
    }
}

/// Programs of more blocks are not looked at for places that several cycles share.
const LONGEST: usize = 3_000;

/// What a definition does where it is called: where its surface is written, the height to which it comes down at rapid, and
/// that to which it goes, if it is known.
#[derive(Clone, Copy)]
struct Stroke {
    place: Span,
    height: f64,
    bottom: Option<f64>,
}

/// A cycle that comes down at rapid to its set-up clearance where another one, called by the same block, has not been so
/// deep: it goes into the solid material.
fn same_blocks(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    // Longer programs are written by posts, which name each place once.
    if facts.program.blocks().len() > LONGEST {
        return;
    }
    let mut strokes: BTreeMap<u32, Option<Stroke>> = BTreeMap::new();
    let mut bottoms: BTreeMap<usize, f64> = BTreeMap::new();
    let mut open = BTreeSet::new();
    for call in facts.run.calls.iter().filter(|call| is_unmoved(&call.modal)) {
        let stroke = match call.modal.pending {
            Pending::Definition(index) => *strokes.entry(index).or_insert_with(|| stroke(facts, index)),
            Pending::None | Pending::Unknown => None,
        };
        let Some(own) = stroke else {
            open.insert(call.block);
            continue;
        };
        let before = bottoms.get(&call.block).copied().filter(|_| !open.contains(&call.block));
        if let Some(bottom) = before.filter(|bottom| own.height < bottom - HIGHER * facts.millimetre()) {
            return found.push(rule.comparison(facts, own.place, "below", own.height, bottom));
        }
        match own.bottom {
            Some(bottom) => {
                let lowest = bottoms.entry(call.block).or_insert(f64::INFINITY);
                *lowest = lowest.min(bottom);
            }
            None => {
                open.insert(call.block);
            }
        }
    }
}

fn stroke(facts: &Facts<'_>, index: u32) -> Option<Stroke> {
    let drills = |cycle: &&Cycle| matches!(cycle.file.group, Group::Drilling | Group::Threads);
    let own = facts.definitions.get(index as usize)?;
    own.related_cycle().filter(|cycle| drills(cycle))?;
    let related = own.as_related_cycle();
    let read = facts.read(&related);
    let value = |meaning: &str| read.item(meaning).and_then(number);
    let (place, surface) = (read.item(SURFACE)?.value_span, value(SURFACE)?);
    // What only centres is deeper than this by less than the diameter that it has.
    let centred = || value("centring-diameter").map(|own| -own.abs());
    let depth = DEPTHS.into_iter().find_map(value).filter(|depth| *depth != 0.0).or_else(centred);
    let height = surface + value(CLEARANCE).unwrap_or_default();
    Some(Stroke { place, height, bottom: depth.map(|depth| surface - depth.abs()) })
}

/// Patterns whose surface is more than a little above that of the cycles which they call: these begin in the air.
fn patterns(rule: &Rule, facts: &Facts<'_>, top: f64, found: &mut Vec<Diagnostic>) {
    let mut own_of = BTreeMap::new();
    for call in &facts.run.calls {
        let Some(pattern) = facts.definition_at(call.block).filter(|own| own.calls_last()) else { continue };
        let Pending::Definition(index) = call.modal.pending else { continue };
        own_of.entry(pattern.view.first).or_insert_with(|| (pattern, BTreeSet::new())).1.insert(index);
    }
    for (pattern, called) in own_of.into_values() {
        let related = pattern.as_related_cycle();
        let read = facts.read(&related);
        let Some((item, surface)) = read.item(SURFACE).and_then(|item| Some((item, number(item)?))) else { continue };
        // What begins above the blank is an example, not a part.
        if surface > top {
            continue;
        }
        let mut others = called.iter().filter_map(|index| {
            let own = facts.definitions.get(*index as usize)?;
            let related = own.as_related_cycle();
            facts.read(&related).item(SURFACE).and_then(number)
        });
        let Some(other) = others.next().filter(|other| surface - other > HIGHER * facts.millimetre()) else { continue };
        if others.all(|own| (own - other).abs() <= 1e-6) {
            found.push(rule.comparison(facts, item.value_span, "pattern", surface, other));
            return;
        }
    }
}

/// A cylinder whose radius is not that of a round blank, nor half of what a box measures that lies about its axis, at Z 0:
/// the diameter was entered, or a digit is wrong.
fn cylinders(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    /// The axis lies so near to the middle of the blank, and the radius may be so much smaller, as a part of its height.
    const MIDDLE: f64 = 0.02;
    const TURNED: f64 = 0.6;
    let round = diameter(facts.program).map(|own| own / 2.0);
    let about_axis = |blank: &Blank| {
        let (low, high) = (blank.low[2], blank.high[2]);
        high > 0.0 && (low + high).abs() <= MIDDLE * (high - low)
    };
    let half = Blank::of(facts.program).filter(about_axis).map(|blank| blank.high[2]);
    let Some(most) = round.or(half) else { return };
    for own in &facts.definitions {
        let related = own.as_related_cycle();
        let read = facts.read(&related);
        let Some((item, radius)) = read.item(CYLINDER).and_then(|item| Some((item, number(item)?.abs()))) else {
            continue;
        };
        // Where a box lies is known only without transformations.
        let known = round.is_some() || facts.run.before(own.view.first).is_some_and(|modal| is_unmoved(&modal));
        if known && (radius > most + HIGHER * facts.millimetre() || radius < TURNED * most) {
            return found.push(rule.comparison(facts, item.value_span, "cylinder", radius, most));
        }
    }
}

/// An early cycle takes the place where it is called for the set-up clearance above the surface: one that is called so
/// high that its surface is in the air, or inside of the blank where nothing has that height as its floor.
fn early(rule: &Rule, facts: &Facts<'_>, blank: &Blank, found: &mut Vec<Diagnostic>) {
    let way = FirstWay::of(facts);
    let unit = facts.millimetre();
    let heights = OnceCell::new();
    let heights = || heights.get_or_init(|| Heights::of(facts, way)).as_ref();
    let mut said = BTreeSet::new();
    for (call, own) in way.called() {
        let (Some(z), Some((clearance, _)), Some((depth, _))) = (call.place[2], own.clearance, own.depth) else {
            continue;
        };
        if clearance == 0.0 || depth >= 0.0 {
            continue;
        }
        // The oldest programs give it the sign of the depth.
        let clearance = clearance.abs();
        let (surface, top) = (z - clearance, blank.high[2]);
        // What removes nothing at all is found elsewhere.
        if surface + depth >= top && facts.definition_at(own.first).is_some() {
            continue;
        }
        let beside = matches!(call.place, [Some(x), Some(y), _] if blank.lacks(x, y));
        let what = match () {
            () if surface > top + clearance.max(HIGHER * unit) => "high",
            () if z < top && !beside && heights().is_some_and(|all| !all.has(surface, unit)) => "low",
            () => continue,
        };
        if said.insert((call.early, what)) {
            found.push(rule.comparison(facts, call.span, what, z, surface));
        }
    }
}

/// The heights down to which a program machines.
struct Heights(Vec<f64>);

impl Heights {
    /// All of them; nothing where one is not known.
    fn of(facts: &Facts<'_>, way: &FirstWay) -> Option<Self> {
        let mut all = Vec::new();
        for block in facts.program.blocks() {
            match &block.kind {
                BlockKind::Motion(motion) => {
                    let words = motion.words();
                    let Some(coord) = words.coord(Axis::Z) else { continue };
                    let Amount::Number(value) = coord.value.amount else { return None };
                    match coord.incremental {
                        false => all.push(value),
                        // It only lifts the tool.
                        true if value > 0.0 => {}
                        true => return None,
                    }
                }
                BlockKind::Statement(own) if own.kind != StatementKind::BlkForm => return None,
                BlockKind::CallPgm(_) | BlockKind::Unknown(_) => return None,
                _ => {}
            }
        }
        for (call, own) in way.called() {
            all.push(call.place[2]? - own.clearance?.0.abs() + own.depth?.0);
        }
        for own in facts.definitions.iter().filter(|own| own.related_cycle().is_some_and(removes_material)) {
            let related = own.as_related_cycle();
            let read = facts.read(&related);
            all.push(bottom(&read)?);
        }
        Some(Self(all))
    }

    /// Whether a height is one of them, give or take a millimetre.
    fn has(&self, height: f64, unit: f64) -> bool {
        self.0.iter().any(|own| (own - height).abs() <= HIGHER * unit)
    }
}
