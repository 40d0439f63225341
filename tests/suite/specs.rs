//! Specifications: the registry test over all embedded files, and files with mistakes beside what
//! must be said of them (`tests/specs/`, in the form of `support/mistakes.rs`).
use ciklo::base::diag::{Diagnostic, Severity};
use ciklo::spec::{Catalogue, lint, schema};

use crate::mistakes;

#[test]
fn every_file_reads_and_is_free_of_errors() {
    let (catalogue, mut found) = Catalogue::load(&ciklo::base::data::embedded());
    found.extend(lint(&catalogue));
    let (errors, warnings): (Vec<_>, Vec<_>) = found.iter().partition(|d| d.severity == Severity::Error);
    let show = |list: &[&Diagnostic]| list.iter().map(|found| mistakes::line(found)).collect::<Vec<_>>().join("\n");
    println!("{} warnings:\n{}", warnings.len(), show(&warnings));
    assert!(errors.is_empty(), "{} errors:\n{}", errors.len(), show(&errors));
}

#[test]
fn every_mistake_is_found_at_its_place_in_one_run() {
    let own = |found: &Diagnostic, path: &str| found.place.as_ref().is_some_and(|place| place.source.name() == path);
    mistakes::compare("tests/specs", lint, own).unwrap_or_else(|failures| panic!("{failures}"));
}

#[test]
fn every_file_fits_the_schema() {
    let mut compiler = boon::Compiler::new();
    let mut schemas = boon::Schemas::new();
    compiler.add_resource("file:///schema.json", schema()).expect("the schema is JSON");
    let id = compiler.compile("file:///schema.json", &mut schemas).expect("the schema is a JSON Schema");
    let mut seen = 0;
    for (path, text) in ciklo::base::data::embedded() {
        if !path.starts_with("cycle-specs/") || path.contains("/machines/") || !path.ends_with(".yaml") {
            continue;
        }
        let value: serde_json::Value = serde_yaml::from_str(&text).expect("YAML");
        schemas.validate(&value, id).unwrap_or_else(|error| panic!("{path}: {error:#}"));
        seen += 1;
    }
    assert!(seen > 0, "no file was looked at");
}
