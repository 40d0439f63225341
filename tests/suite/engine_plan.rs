//! Plans: the registry test over all embedded specifications, and runs with mistakes beside what must be
//! said of them (`tests/engine/plan/`, in the form of `support/mistakes.rs`).
use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

use ciklo::base::demand::{Deferred, Made, OnDemand};
use ciklo::engine::plan;
use ciklo::spec::{Catalogue, OnControl, Quantity};

use crate::mistakes;

#[test]
fn every_run_compiles_for_every_control() {
    let catalogue = &crate::built::built().catalogue;
    let found = plan::check(catalogue);
    let shown: Vec<String> = found.iter().map(mistakes::line).collect();
    assert!(found.is_empty(), "{} mistakes:\n{}", found.len(), shown.join("\n"));
}

#[test]
fn every_mistake_of_a_run_is_found_at_its_place() {
    mistakes::compare("tests/engine/plan", plan::check, |_, _| true).unwrap_or_else(|failures| panic!("{failures}"));
}

/// The catalogue with those cycles only that have a parameter of that meaning and a run that the engine executes.
fn with_meaning(catalogue: &Catalogue, meaning: &str) -> Catalogue {
    let mut reduced = Catalogue { errata: catalogue.errata.clone(), ..Catalogue::default() };
    for (id, on) in catalogue.controls.iter() {
        let cycles: OnDemand<_, _> = on
            .cycles
            .iter()
            .filter(|(_, cycle)| cycle.params.iter().any(|param| param.is.as_str() == meaning))
            .map(|(key, cycle)| (*key, cycle.clone()))
            .collect();
        if !cycles.is_empty() {
            let own = OnControl {
                control: on.control.clone(),
                cycles,
                fragments: on.fragments.clone(),
                outlines: BTreeMap::new(),
                meanings: Arc::default(),
                worked: Deferred::default(),
                made: Made::default(),
            };
            reduced.controls.insert(id.clone(), own);
        }
    }
    reduced
}

const fn has_no_unit(quantity: Quantity) -> bool {
    matches!(quantity, Quantity::Count | Quantity::Factor | Quantity::Number | Quantity::Text | Quantity::None)
}

/// The dictionary says what a parameter measures, and programs in inches are converted by that: said wrongly, it
/// contradicts what the runs do with the parameter.
#[test]
fn a_wrong_quantity_contradicts_the_runs() {
    let catalogue = &crate::built::built().catalogue;
    let meanings: BTreeSet<&str> = catalogue
        .controls
        .values()
        .flat_map(|on| on.cycles.values())
        .flat_map(|cycle| cycle.params.iter().map(|param| param.is.as_str()))
        .collect();
    let others = [Quantity::Length, Quantity::Angle, Quantity::Feed, Quantity::Time, Quantity::Speed, Quantity::Number];
    let (mut unheld, mut tried) = (Vec::new(), 0);
    for meaning in meanings {
        let mut reduced = with_meaning(catalogue, meaning);
        let params = |on: &OnControl| {
            let all = on.cycles.values().flat_map(|cycle| &cycle.params);
            all.filter(|param| param.is.as_str() == meaning).map(|param| param.quantity).next()
        };
        let Some(own) = reduced.controls.values().find_map(params) else { continue };
        let mut passed = Vec::new();
        for other in others {
            if other == own || has_no_unit(other) && has_no_unit(own) {
                continue;
            }
            let cycles = reduced.controls.values_mut().flat_map(|on| on.cycles.values_mut());
            for param in cycles.flat_map(|cycle| &mut cycle.params).filter(|param| param.is.as_str() == meaning) {
                param.quantity = other;
            }
            tried += 1;
            if !plan::check(&reduced).iter().any(|found| found.code == "spec-measure") {
                passed.push(other.as_str());
            }
        }
        if !passed.is_empty() {
            unheld.push(format!("{meaning} ({}): {}\n", own.as_str(), passed.join(" ")));
        }
    }
    assert!(tried > 500, "{tried} were tried");
    assert!(unheld.is_empty(), "no rule notices:\n{}", unheld.concat());
}
