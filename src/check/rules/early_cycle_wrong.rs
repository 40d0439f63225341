//! A machining cycle of the first controls, which no manual here describes, with a value that it cannot work with: a
//! set-up clearance with another sign than the others, a depth above the surface, a plunging depth or a feed of 0, a slot
//! or pocket that is narrower than the tool, a round one that is wider than the blank, corners with a smaller radius than it,
//! a pitch or a feed that is not that of the tap, a deep hole that is drilled at once.
//!
//! What its words mean, their order says. Tools count as far as a tool table or a TOOL DEF gives their data, a pitch
//! also where their name does.
use std::collections::BTreeSet;

use crate::base::diag::{Diagnostic, Severity};
use crate::check::blank::Blank;
use crate::check::first_way::{Early, FirstWay, Placed};
use crate::check::program::Work;
use crate::check::tools::{Tool, Tools};
use crate::check::{Facts, Loaded, Rule};

pub(super) const RULE: Rule = Rule { code: "early-cycle-wrong", severity: Severity::Warning, run };

/// So much of the pitch one may differ from the other, and so much a floating tap holder makes up for.
const SAME: f64 = 0.02;
const FLOATING: f64 = 0.1;
/// No drill goes so many times its diameter deep at once.
const AT_ONCE: f64 = 8.0;
/// By how much a tool must be wider, mm or inch.
const TOLERANCE: f64 = 1e-3;

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let way = FirstWay::of(facts);
    let mut tell = |what: &'static str, (value, span): Placed, other: f64| {
        found.push(rule.comparison(facts, span, what, value, other));
    };
    // The oldest programs give the set-up clearance the sign of the depth.
    let signed = !way.early.iter().any(|own| own.clearance.is_some_and(|(value, _)| value > 0.0));
    for own in &way.early {
        if let Some(placed) = own.clearance.filter(|(value, _)| *value < 0.0 && !signed) {
            tell("clearance", placed, 0.0);
        }
        // The tool would move upwards.
        if let Some(placed) =
            own.depth.filter(|(depth, _)| *depth > 0.0 && own.clearance.is_some_and(|own| own.0 > 0.0))
        {
            tell("depth", placed, 0.0);
        }
        if let Some(placed) = own.infeed.filter(|(value, _)| *value == 0.0) {
            tell("infeed", placed, 0.0);
        }
        if let Some(placed) = own.feeds.iter().find(|(value, _)| *value == 0.0) {
            tell("feed", *placed, 0.0);
        }
    }
    if let Some(blank) = Blank::of(facts.program) {
        let room = (blank.high[0] - blank.low[0]).min(blank.high[1] - blank.low[1]);
        for (call, own) in way.called().filter(|(_, own)| own.work == Work::Milling) {
            match own.sides.as_slice() {
                // The pocket of a radius has one size.
                [only] if only.0.abs() > room => return tell("wide", *only, room),
                [x, y] if are_exchanged(&blank, call.place, [x.0, y.0]) => return tell("sides", *x, y.0),
                _ => {}
            }
        }
    }
    let Some(tools) = Tools::of(facts) else { return };
    let mut seen = BTreeSet::new();
    for (call, own) in way.called() {
        let loaded = call.tool.and_then(|block| u32::try_from(block).ok()).map(Loaded::By);
        let Some(tool) = loaded.and_then(|loaded| tools.get(loaded)) else { continue };
        if let Some((what, placed, other)) = misfit(own, tool).filter(|_| seen.insert(call.early)) {
            tell(what, placed, other);
        }
    }
}

/// Whether a pocket about a place goes over an edge of the blank, and would lie inside of it with its sides exchanged.
fn are_exchanged(blank: &Blank, place: [Option<f64>; 3], sides: [f64; 2]) -> bool {
    let [Some(x), Some(y), _] = place else { return false };
    let inside = |sides: [f64; 2]| {
        (0..2).all(|axis| {
            let (at, half) = ([x, y][axis], sides[axis].abs() / 2.0);
            blank.low[axis] <= at - half && at + half <= blank.high[axis]
        })
    };
    blank.holds(x, y) && !inside(sides) && inside([sides[1], sides[0]])
}

/// What does not fit the tool, and what it has.
fn misfit(own: &Early, tool: Tool) -> Option<(&'static str, Placed, f64)> {
    let differs = |value: f64, pitch: f64, by: f64| (value.abs() - pitch).abs() > by * pitch;
    match own.work {
        Work::Milling => {
            let narrowest = own.sides.iter().min_by(|one, other| one.0.abs().total_cmp(&other.0.abs()))?;
            let diameter = 2.0 * tool.radius;
            let round = own.corner.filter(|(radius, _)| *radius > 0.0 && *radius < tool.radius - TOLERANCE);
            let corner = round.map(|placed| ("corner", placed, tool.radius));
            (narrowest.0.abs() < diameter - TOLERANCE).then_some(("narrow", *narrowest, diameter)).or(corner)
        }
        Work::RigidTapping => {
            let (pitch, placed) = (tool.pitch?, own.pitch?);
            differs(placed.0, pitch, SAME).then_some(("pitch", placed, pitch))
        }
        Work::Tapping => {
            let (pitch, speed, placed) = (tool.pitch?, tool.speed.filter(|speed| *speed > 0.0)?, own.feeds.first()?);
            differs(placed.0 / speed, pitch, FLOATING).then_some(("tapped", *placed, pitch * speed))
        }
        Work::Drilling => {
            let (placed, depth, diameter) = (own.infeed?, own.depth?.0.abs(), 2.0 * tool.radius);
            let deep = placed.0.abs().min(depth) > AT_ONCE * diameter;
            deep.then_some(("peck", placed, diameter))
        }
    }
}
