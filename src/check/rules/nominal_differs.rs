//! A round pocket, and a measurement at the same place whose nominal diameter is another one: one of the two is mistaken, and
//! the part is reported as scrap, or the probe does not find it.
//!
//! Only measurements after the pocket, at a place with numbers, where one round pocket is milled; larger by an allowance is the
//! same. Where steps of several diameters lie at one place, the height decides, so nothing is said.
use crate::base::diag::{Diagnostic, Severity};
use crate::check::blank::is_unmoved;
use crate::check::contours::place_of_call;
use crate::check::cycle::probes;
use crate::check::program::number;
use crate::check::{CycleCall, Facts, Pending, Rule};
use crate::spec::Group;

pub(super) const RULE: Rule = Rule { code: "nominal-differs", severity: Severity::Warning, run };

/// What is still to be taken away, or was measured anew, mm.
const ALLOWANCE: f64 = 1.5;
/// Places that are so near are the same, mm or inch.
const NEAR: f64 = 1e-3;
/// The meanings of the diameters of a round pocket and of a measurement, and of its centre.
const POCKET: &str = "circle-diameter";
const NOMINAL: &str = "probing-nominal-diameter";
const CENTRE: [&str; 2] = ["probing-centre-main", "probing-centre-minor"];

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let pockets = pockets(facts);
    if pockets.is_empty() {
        return;
    }
    for own in facts.definitions.iter().filter(|own| own.related_cycle().is_some_and(probes)) {
        let related = own.as_related_cycle();
        let read = facts.read(&related);
        let Some((item, nominal)) = read.item(NOMINAL).and_then(|item| Some((item, number(item)?))) else { continue };
        let [Some(x), Some(y)] = CENTRE.map(|meaning| read.item(meaning).and_then(number)) else { continue };
        let here = pockets.iter().filter(|(block, place, _)| {
            *block < own.view.first && (place[0] - x).abs() <= NEAR && (place[1] - y).abs() <= NEAR
        });
        let sizes: Vec<f64> = here.map(|(.., size)| *size).collect();
        let room = ALLOWANCE * facts.millimetre();
        let Some(first) = sizes.first().copied().filter(|first| sizes.iter().all(|own| (own - first).abs() <= room))
        else {
            continue;
        };
        if sizes.iter().all(|own| (own - nominal).abs() > room) {
            found.push(rule.comparison(facts, item.value_span, "diameter", nominal, first));
        }
    }
}

/// The round pockets that are called at known places without transformations: the block, the place, the diameter.
fn pockets(facts: &Facts<'_>) -> Vec<(usize, [f64; 2], f64)> {
    let calls = facts.run.calls.iter().filter(|call| is_unmoved(&call.modal));
    let of = |call: &CycleCall| {
        let Pending::Definition(index) = call.modal.pending else { return None };
        let own = facts.definitions.get(index as usize)?;
        own.related_cycle().filter(|cycle| cycle.file.group == Group::Pockets)?;
        let related = own.as_related_cycle();
        let size = facts.read(&related).item(POCKET).and_then(number)?;
        Some((call.block, place_of_call(facts, call.block)?, size))
    };
    calls.filter_map(of).collect()
}
