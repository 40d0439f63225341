//! A stud whose unmachined size is far smaller than the blank around it, where nothing has been milled before: the tool
//! plunges beside that size into solid material, and the rest of the blank stays there.
//!
//! Only at places that the block of the call names, of studs that begin at the top of a box, or in the middle of the top
//! of a cylinder.
use crate::base::diag::{Arg, Diagnostic, Severity};
use crate::check::blank::{Blank, diameter, is_unmoved, top};
use crate::check::contours::place_of_call;
use crate::check::program::{number, with_meaning};
use crate::check::{Facts, Pending, Rule};
use crate::spec::Group;

pub(super) const RULE: Rule = Rule { code: "stud-in-solid", severity: Severity::Warning, run };

/// The meanings of the unmachined sizes of a round and a rectangular stud, and of the finished ones.
const ROUND: [&str; 2] = ["blank-diameter", "finished-part-diameter"];
const SIDES: [&str; 2] = ["blank-first-side-length", "blank-second-side-length"];
/// The meanings of surface and angle.
const SURFACE: &str = "surface-coordinate";
const ANGLE: &str = "angle-of-rotation";
/// So far the blank may stick out on every side, mm: less is a rim that the tool takes away as well.
const RIM: f64 = 12.0;

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let Some((blank, round)) = blank(facts).filter(|_| facts.begins()) else { return };
    let unit = facts.millimetre();
    // The first thing that is machined: what follows finds an open floor.
    let first = facts.run.calls.iter().find(|call| is_unmoved(&call.modal));
    let milled = facts.shaped().next().map_or(usize::MAX, |(index, _)| index);
    let Some(call) = first.filter(|call| call.block < milled) else { return };
    let Pending::Definition(index) = call.modal.pending else { return };
    let Some(own) = facts.definitions.get(index as usize) else { return };
    let stud = own.related_cycle().filter(|cycle| cycle.file.group == Group::Pockets);
    let Some(cycle) = stud.filter(|cycle| [ROUND[0], SIDES[0]].iter().any(|own| with_meaning(cycle, own).is_some()))
    else {
        return;
    };
    let related = own.as_related_cycle();
    let read = facts.read(&related);
    let value = |meaning: &str| read.item(meaning).and_then(number);
    let at = place_of_call(facts, call.block);
    let (Some([x, y]), Some(surface)) = (at, value(SURFACE)) else { return };
    // A round blank is as wide everywhere only about its middle.
    if round && (x, y) != (0.0, 0.0) {
        return;
    }
    if surface < blank.high[2] - unit || surface > blank.high[2] + unit {
        return;
    }
    let around = [x - blank.low[0], blank.high[0] - x, y - blank.low[1], blank.high[1] - y];
    let least = around.into_iter().fold(f64::INFINITY, f64::min);
    let (meaning, half) = if with_meaning(cycle, ROUND[0]).is_some() {
        (ROUND[0], value(ROUND[0]).map(|own| own / 2.0))
    } else if value(ANGLE) == Some(0.0) {
        let [Some(long), Some(wide)] = SIDES.map(value) else { return };
        let (along, across) = (around[0].min(around[1]) - long / 2.0, around[2].min(around[3]) - wide / 2.0);
        (if along > across { SIDES[0] } else { SIDES[1] }, Some(least - along.min(across)))
    } else {
        return;
    };
    if let Some(half) = half.filter(|half| least - half > RIM * unit)
        && let Some(item) = read.item(meaning)
    {
        let finding = rule.at(facts, item.value_span).arg("value", Arg::Number(number(item).unwrap_or(2.0 * half)));
        found.push(finding.arg("other", Arg::Number(2.0 * least)));
    }
}

/// The blank, and whether it is a cylinder.
fn blank(facts: &Facts<'_>) -> Option<(Blank, bool)> {
    if let Some(blank) = Blank::of(facts.program) {
        return Some((blank, false));
    }
    let (radius, top) = (diameter(facts.program)? / 2.0, top(facts.program)?);
    Some((Blank { low: [-radius, -radius, f64::NEG_INFINITY], high: [radius, radius, top] }, true))
}
