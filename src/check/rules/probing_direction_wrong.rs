//! An edge that is probed away from the part: the tool comes to it from the side on which the part is.
//!
//! Or a face that is probed upwards along the tool axis.
//!
//! Where the part is say the tops that the program drills or probes: all of them on the side from which the probe comes,
//! none on the other, and none below the measuring height. Only of edges at the datum, for walls of pockets are elsewhere,
//! and of those at a face of the blank.
//! Silent where coordinates are moved.
use std::borrow::Cow;

use crate::base::diag::{Diagnostic, Severity};
use crate::check::blank::{Blank, is_unmoved};
use crate::check::program::{number, with_meaning};
use crate::check::{Aspect, Defined, Definition, Facts, Pending, Rule, Tri};
use crate::program::syntax::{Amount, Axis, BlockKind};

pub(super) const RULE: Rule = Rule { code: "probing-direction-wrong", severity: Severity::Warning, run };

/// The meanings of what an edge is probed by.
const AXIS: &str = "measuring-axis";
const DIRECTION: &str = "traverse-direction";
const HEIGHT: &str = "measuring-height";
/// The meaning of an axis with its direction.
const PLAIN: &str = "probing-direction";
/// The meanings of the first point that is probed.
const POINT: [&str; 3] = ["first-point-main", "first-point-minor", "first-point-tool"];
/// The meaning of the surface on which a cycle begins.
const SURFACE: &str = "surface-coordinate";
/// A wider blank is not probed on the other side with such a stylus by going over it, mm.
const WIDE: f64 = 10.0;
/// How far a place is from an edge that is not at it, mm or inch.
const APART: f64 = 1.0;

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    upwards(rule, facts, found);
    let related: Vec<Cow<'_, Defined<'_>>> = facts
        .definitions
        .iter()
        .filter(|own| own.related_cycle().is_some_and(|cycle| with_meaning(cycle, DIRECTION).is_some()))
        .map(Defined::as_related_cycle)
        .collect();
    let edges: Vec<Definition<'_>> = related.iter().map(|own| facts.read(own)).collect();
    if edges.is_empty() || facts.flow.unread.any() {
        return;
    }
    let tops = tops(facts);
    for edge in &edges {
        let value = |meaning: &str| edge.item(meaning).and_then(number);
        let (Some(axis), Some(direction)) = (value(AXIS), value(DIRECTION)) else { continue };
        let axis = match axis {
            1.0 => 0,
            2.0 => 1,
            _ => continue,
        };
        let (Some(place), Some(height)) = (value(POINT[axis]), value(HEIGHT)) else { continue };
        if !facts.run.before(edge.view.first).is_some_and(|modal| is_unmoved(&modal)) {
            continue;
        }
        let places = || tops.iter().filter(|top| top[2].is_some_and(|top| top >= height)).filter_map(|top| top[axis]);
        let away = |side: f64| places().any(|own| (own - place) * side > APART);
        // Two places at least: a single one may be on another part.
        let many = place.abs() <= APART && places().filter(|own| (own - place).abs() > APART).count() > 1;
        // A face of the blank is touched from outside, unless the blank is narrow there.
        let body = Blank::of(facts.program).filter(|blank| height < blank.high[2] && height > blank.low[2]);
        let through = body.is_some_and(|blank| {
            let face = if direction < 0.0 { blank.low[axis] } else { blank.high[axis] };
            let wide = blank.high[axis] - blank.low[axis] > WIDE * facts.millimetre();
            (place - face).abs() <= APART && direction.abs() == 1.0 && wide
        });
        if (through || many && away(-direction) && !away(direction))
            && let Some(item) = edge.item(DIRECTION)
        {
            let finding = rule.at(facts, item.value_span).arg("what", "edge").arg("value", item.printed.as_ref());
            found.push(finding.arg("axis", if axis == 0 { "X" } else { "Y" }).arg("cycle", edge.key.to_string()));
        }
    }
}

/// Probing along the tool axis, upwards: no stylus reaches a face from below.
fn upwards(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let probes = |own: &&Defined<'_>| {
        own.related_cycle().is_some_and(|cycle| with_meaning(cycle, PLAIN).is_some())
            && facts.run.before(own.view.first).is_some_and(|modal| modal.is(Aspect::OtherAxis) == Tri::No)
    };
    for own in facts.definitions.iter().filter(probes) {
        let related = own.as_related_cycle();
        let read = facts.read(&related);
        let Some(item) = read.item(PLAIN) else { continue };
        let written = item.printed.trim();
        if written.eq_ignore_ascii_case("Z+") {
            let finding = rule.at(facts, item.value_span).arg("what", "up").arg("value", written);
            found.push(finding.arg("axis", "Z").arg("cycle", own.key.to_string()));
        }
    }
}

/// The places on top of the part that the program machines or probes: X, Y and the height, as far as they are known.
fn tops(facts: &Facts<'_>) -> Vec<[Option<f64>; 3]> {
    let mut tops = Vec::new();
    for own in facts.definitions.iter() {
        let Some(cycle) = own.related_cycle().filter(|cycle| with_meaning(cycle, POINT[2]).is_some()) else { continue };
        let unmoved = facts.run.before(own.view.first).is_some_and(|modal| is_unmoved(&modal));
        if unmoved && with_meaning(cycle, AXIS).is_none() {
            let related = own.as_related_cycle();
            let read = facts.read(&related);
            let top = POINT.map(|meaning| read.item(meaning).and_then(number));
            // Cycles for planes probe three points.
            tops.push(top);
        }
    }
    for call in facts.run.calls.iter().filter(|call| is_unmoved(&call.modal)) {
        let Pending::Definition(index) = call.modal.pending else { continue };
        let Some(own) = facts.definitions.get(index as usize) else { continue };
        let related = own.as_related_cycle();
        let surface = facts.read(&related).item(SURFACE).and_then(number);
        let Some(BlockKind::Motion(motion)) = facts.program.blocks().get(call.block).map(|block| &block.kind) else {
            continue;
        };
        let words = motion.words();
        let coord = |axis: Axis| {
            let coord = words.coord(axis).filter(|coord| !coord.incremental)?;
            match coord.value.amount {
                Amount::Number(number) => Some(number),
                _ => None,
            }
        };
        tops.push([coord(Axis::X), coord(Axis::Y), surface]);
    }
    // The points of edges along their own line are on the part, too.
    let edges = |own: &&Defined<'_>| own.related_cycle().is_some_and(|cycle| with_meaning(cycle, AXIS).is_some());
    for own in facts.definitions.iter().filter(edges) {
        let related = own.as_related_cycle();
        let read = facts.read(&related);
        let value = |meaning: &str| read.item(meaning).and_then(number);
        let (axis, height) = (value(AXIS), value(HEIGHT));
        let unmoved = facts.run.before(own.view.first).is_some_and(|modal| is_unmoved(&modal));
        match axis {
            Some(1.0) if unmoved => tops.push([None, value(POINT[1]), height]),
            Some(2.0) if unmoved => tops.push([value(POINT[0]), None, height]),
            _ => {}
        }
    }
    tops
}
