//! A measuring height below the floor that the program itself mills where it measures.
//!
//! A cycle that mills around or inside a centre leaves a floor at the surface and the depth; a ball whose centre is
//! measured below that floor is in the workpiece. Only cycles that name a centre, a surface and a depth are
//! compared, by the numbers that mean these in every cycle (003:117), so that cycles which the manuals show and do not
//! describe count, too. Silent where anything else may have cut deeper there or moved the coordinates, and where a
//! value is a parameter.
use std::collections::HashMap;

use crate::base::diag::{Arg, Diagnostic, Severity};
use crate::check::guards::Written;
use crate::check::program::bits;
use crate::check::program::with_meaning;
use crate::check::{Definition, Facts, Rule};
use crate::program::syntax::ValueKind;
use crate::spec::{Cycle, Group, Known};

pub(super) const RULE: Rule = Rule { code: "measuring-height-below-floor", severity: Severity::Warning, run };

/// What a probing cycle measures, by the meanings of its parameters: where, and how deep.
const MEASURED: [&str; 3] = ["probing-centre-main", "probing-centre-minor", "measuring-height"];
/// The parameters by which a cycle says where it mills: centre, surface, depth.
const MILLED: [&str; 4] = ["Q216", "Q217", "Q203", "Q201"];

/// A floor about a centre.
struct Floor {
    height: f64,
    cycle: String,
}

fn run(rule: &Rule, facts: &Facts<'_>, found: &mut Vec<Diagnostic>) {
    if facts.flow.programs || facts.flow.opaque {
        return;
    }
    // The lowest floor about each centre.
    let mut floors: HashMap<[u64; 2], Floor> = HashMap::new();
    for definition in &facts.definitions {
        match definition.known {
            Known::Described(cycle) if is_harmless(cycle) => {}
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
        let is = |meaning: &&str| with_meaning(cycle, meaning);
        let [Some(main), Some(minor), Some(height)] = MEASURED.each_ref().map(is) else { continue };
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
