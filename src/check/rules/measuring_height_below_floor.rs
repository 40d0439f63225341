//! A measuring height below the floor that the program itself mills where it measures.
//!
//! A cycle that mills around or inside a centre leaves a floor at the surface and the depth; a ball whose centre is
//! measured below that floor is in the workpiece. Only cycles that name a centre, a surface and a depth are
//! compared, by the numbers that mean these in every cycle (003:117), so that cycles which the manuals show and do not
//! describe count, too. Silent where anything else may have cut deeper there or moved the coordinates, and where a
//! value is a parameter.
use std::collections::HashMap;

use crate::base::diag::{Arg, Diagnostic, Severity};
use crate::check::blank::is_unmoved;
use crate::check::contours::place_of_call;
use crate::check::cycle::probes_around;
use crate::check::floors::bottom;
use crate::check::guards::Written;
use crate::check::program::{bits, with_meaning};
use crate::check::{Definition, Facts, Pending, Rule};
use crate::program::syntax::ValueKind;
use crate::spec::{Cycle, Group, Known};

pub(super) const RULE: Rule = Rule { code: "measuring-height-below-floor", severity: Severity::Warning, run };

/// What a probing cycle measures, by the meanings of its parameters: where, and how deep.
const MEASURED: [&str; 3] = ["probing-centre-main", "probing-centre-minor", "measuring-height"];
/// The parameters by which a cycle says where it mills: centre, surface, depth.
const MILLED: [&str; 4] = ["Q216", "Q217", "Q203", "Q201"];

/// So many cycles that measure are compared with what was milled before.
const MOST: usize = 1 << 7;

/// A floor about a centre.
struct Floor {
    height: f64,
    cycle: String,
}

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    if facts.flow.programs || facts.flow.opaque {
        return;
    }
    called(rule, facts, found);
    by_definition(rule, facts, found);
}

/// Pockets and holes at places that the blocks of their calls name, and the height at which their middle is probed then:
/// below the lowest floor there.
fn called(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    let contours = facts.shaped().next().map_or(usize::MAX, |(index, _)| index);
    let measures = |cycle: &Cycle| MEASURED.iter().all(|meaning| with_meaning(cycle, meaning).is_some());
    let measuring = facts.definitions.iter().filter(|own| own.related_cycle().is_some_and(measures));
    for own in measuring.take(MOST) {
        let related = own.as_related_cycle();
        let definition = facts.read(&related);
        let Some(cycle) = definition.cycle() else { continue };
        let block = definition.view.first;
        let written = Written::of(facts, &definition, cycle);
        let [Some(main), Some(minor), Some(height)] = MEASURED.map(|meaning| with_meaning(cycle, meaning)) else {
            continue;
        };
        let value = |param| written.number_of(param);
        let (Some(main), Some(minor), Some(measured)) = (value(main), value(minor), value(height)) else { continue };
        // Contours may be of any depth.
        if contours < block || !facts.run.before(block).is_some_and(|modal| is_unmoved(&modal)) {
            continue;
        }
        let mut lowest: Option<(f64, String)> = None;
        let mut open = false;
        for call in facts.run.calls.iter().filter(|call| call.block < block) {
            let own = match call.modal.pending {
                Pending::Definition(index) => facts.definitions.get(index as usize),
                Pending::None | Pending::Unknown => None,
            };
            let Some(own) = own.filter(|_| is_unmoved(&call.modal)) else {
                open = true;
                continue;
            };
            let related = own.as_related_cycle();
            let read = facts.read(&related);
            let floor = bottom(&read);
            let place = place_of_call(facts, call.block);
            let here = place.is_some_and(|[x, y]| (x - main).abs() <= SAME && (y - minor).abs() <= SAME);
            match floor {
                Some(floor) if here => {
                    if lowest.as_ref().is_none_or(|(own, _)| floor < *own) {
                        lowest = Some((floor, own.key.to_string()));
                    }
                }
                // What ends above the height is no matter, wherever it is.
                Some(floor) => open |= floor <= measured && place.is_none(),
                None => open = true,
            }
        }
        let Some((floor, milling)) = lowest.filter(|(floor, _)| measured < *floor && !open) else { continue };
        let item = definition.items.iter().find(|item| item.param.is_some_and(|own| std::ptr::eq(own, height)));
        if let Some(item) = item {
            let finding = rule.at(facts, item.value_span).arg("parameter", item.name.as_ref());
            let finding = finding.arg("cycle", definition.key.to_string()).arg("value", item.printed.as_ref());
            found.push(finding.arg("milling", milling).arg("floor", Arg::Number(floor)));
        }
    }
}

/// Places that are so near are the same, mm or inch.
const SAME: f64 = 0.01;

/// Cycles that name the centre about which they mill.
fn by_definition(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    // The lowest floor about each centre.
    let mut floors: HashMap<[u64; 2], Floor> = HashMap::new();
    // A hole may be in the floor, which only matters to what probes inside.
    let mut drilled = false;
    for definition in &facts.definitions {
        let group = definition.related_cycle().map(|cycle| cycle.file.group);
        match definition.known {
            Known::Described(cycle) if is_harmless(cycle) => {}
            _ if matches!(group, Some(Group::Drilling | Group::Threads | Group::Patterns)) => drilled = true,
            Known::Described(_) => return,
            _ => {
                let Some((centre, floor)) = floor(&facts.read(definition)) else { return };
                if floors.get(&centre).is_none_or(|lowest| floor.height < lowest.height) {
                    floors.insert(centre, floor);
                }
            }
        }
    }
    for (definition, cycle) in facts.described() {
        let written = Written::of(facts, &definition, cycle);
        let is = |meaning: &str| with_meaning(cycle, meaning);
        if drilled && !probes_around(cycle) {
            continue;
        }
        let [Some(main), Some(minor), Some(height)] = MEASURED.map(is) else { continue };
        let value = |param| written.number_of(param);
        let (Some(main), Some(minor), Some(measured)) = (value(main), value(minor), value(height)) else { continue };
        let Some(floor) = floors.get(&[main, minor].map(bits)) else { continue };
        let item = definition.items.iter().find(|item| item.param.is_some_and(|own| std::ptr::eq(own, height)));
        if let (Some(item), true) = (item, measured < floor.height) {
            let finding = rule.at(facts, item.value_span).arg("parameter", item.name.as_ref());
            let finding = finding.arg("cycle", definition.key.to_string()).arg("value", item.printed.as_ref());
            found.push(finding.arg("milling", floor.cycle.as_str()).arg("floor", Arg::Number(floor.height)));
        }
    }
}

/// Whether a cycle neither takes material nor moves the coordinates.
fn is_harmless(cycle: &Cycle) -> bool {
    matches!(cycle.file.group, Group::Measuring | Group::Calibration | Group::ToolMeasurement)
}

/// The floor of a cycle that says where it mills, and what distinguishes its centre.
fn floor(definition: &Definition<'_>) -> Option<([u64; 2], Floor)> {
    let number = |name: &&str| {
        let item = definition.items.iter().find(|item| item.name.as_ref() == *name)?;
        match item.value?.kind {
            ValueKind::Number(number) => Some(number),
            _ => None,
        }
    };
    let [main, minor, surface, depth] = MILLED.each_ref().map(number);
    Some(([main?, minor?].map(bits), Floor { height: surface? + depth?, cycle: definition.key.to_string() }))
}
