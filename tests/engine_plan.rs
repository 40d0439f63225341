//! Plans: the registry test over all embedded specifications, and runs with mistakes beside what must be
//! said of them (`tests/engine/plan/`, in the form of `support/mistakes.rs`).
use ciklo::engine::plan;
use ciklo::spec::Catalogue;

#[path = "support/mistakes.rs"]
mod mistakes;

#[test]
fn every_run_compiles_for_every_control() {
    let (catalogue, _) = Catalogue::load(&ciklo::data::embedded());
    let found = plan::check(&catalogue);
    let shown: Vec<String> = found.iter().map(mistakes::line).collect();
    assert!(found.is_empty(), "{} mistakes:\n{}", found.len(), shown.join("\n"));
}

#[test]
fn every_mistake_of_a_run_is_found_at_its_place() {
    mistakes::compare("tests/engine/plan", plan::check, |_, _| true).unwrap_or_else(|failures| panic!("{failures}"));
}
