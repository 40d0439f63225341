//! The pages in `docs/` name every key that they are about: whoever adds one describes it there.
use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

use ciklo::base::data;
use ciklo::engine::run::CODES;
use ciklo::engine::stock::{FindingKind, Report};
use ciklo::language::label;
use ciklo::output::dialog;
use ciklo::spec::schema;
use ciklo::tools::conform::{self, Selection, World};
use serde_json::Value;

fn page(name: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs").join(name);
    fs::read_to_string(path).unwrap_or_else(|error| panic!("docs/{name}: {error}"))
}

/// Whether the page has the word by itself, not as a part of another one.
fn says(page: &str, word: &str) -> bool {
    let part = |c: char| c.is_alphanumeric() || c == '-' || c == '_';
    page.match_indices(word).any(|(at, _)| {
        let (before, after) = (&page[..at], &page[at + word.len()..]);
        !before.ends_with(part) && !after.starts_with(part)
    })
}

/// All keys of all objects in a value.
fn keys(value: &Value, found: &mut BTreeSet<String>) {
    match value {
        Value::Object(entries) => {
            found.extend(entries.keys().cloned());
            entries.values().for_each(|value| keys(value, found));
        }
        Value::Array(values) => values.iter().for_each(|value| keys(value, found)),
        _ => {}
    }
}

fn assert_described(keys: &BTreeSet<String>, name: &str) {
    let page = page(name);
    let silent: Vec<_> = keys.iter().filter(|key| !says(&page, key)).collect();
    assert!(!keys.is_empty() && silent.is_empty(), "docs/{name} does not say what these are: {silent:?}");
}

/// The names of properties anywhere in a JSON Schema.
fn properties(schema: &Value, found: &mut BTreeSet<String>) {
    match schema {
        Value::Object(entries) => {
            if let Some(own) = entries.get("properties").and_then(Value::as_object) {
                found.extend(own.keys().cloned());
            }
            entries.values().for_each(|value| properties(value, found));
        }
        Value::Array(values) => values.iter().for_each(|value| properties(value, found)),
        _ => {}
    }
}

#[test]
fn the_form_of_specifications_is_described() {
    let mut found = BTreeSet::new();
    properties(&schema(), &mut found);
    assert_described(&found, "spec-format.md");
}

#[test]
fn events_are_described() {
    let mut found = BTreeSet::new();
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/engine/run");
    for entry in fs::read_dir(folder).expect("the runs") {
        let path = entry.expect("an entry").path();
        if path.extension().is_some_and(|extension| extension == "events") {
            let text = fs::read_to_string(&path).expect("events");
            for event in text.lines().filter(|line| line.starts_with('{')) {
                let event: Value = serde_json::from_str(event).expect("an event is JSON");
                // What stands inside of these has names from programs: axes, arguments of codes.
                found.extend(event.as_object().expect("an event is an object").keys().cloned());
                found.extend(event["event"].as_str().map(str::to_owned));
            }
        }
    }
    assert_described(&found, "events.md");
}

#[test]
fn dialogs_and_label_tables_are_described() {
    let catalogue = &crate::built::built().catalogue;
    let locales = &*crate::built::built().locales;
    let english = locales.language("en").expect("English is there");
    let (mut dialogs, mut labels) = (BTreeSet::new(), BTreeSet::new());
    for on in catalogue.controls.values() {
        let bundle = dialog::bundle(on, english).expect("all texts are there");
        keys(&serde_json::to_value(bundle).expect("it is JSON"), &mut dialogs);
        let table = label::table(on, english).expect("all labels are there");
        keys(&serde_json::to_value(table).expect("it is JSON"), &mut labels);
    }
    assert_described(&dialogs, "dialogs.md");
    assert_described(&labels, "labels.md");
}

#[test]
fn the_report_of_a_stock_is_described() {
    let mut found = BTreeSet::new();
    keys(&Report::example().to_json(), &mut found);
    found.extend(FindingKind::ALL.map(|kind| kind.as_str().to_owned()));
    assert_described(&found, "stock.md");
}

#[test]
fn the_conformance_report_is_described() {
    let files = data::embedded();
    let catalogue = &crate::built::built().catalogue;
    let locales = &*crate::built::built().locales;
    let (report, _) = conform::run(&World { catalogue, locales, files: &files }, &Selection::of(&["itnc530"]));
    let mut found = BTreeSet::new();
    keys(&serde_json::to_value(report).expect("it is JSON"), &mut found);
    assert_described(&found, "conform.md");
}

#[test]
fn faults_of_contours_are_described() {
    let ours = |code: &str| {
        ["compensation-", "contour-", "rounding-", "approach-", "tangent-"].iter().any(|head| code.starts_with(head))
    };
    let found: BTreeSet<String> = CODES
        .iter()
        .map(|(code, _)| (*code).to_owned())
        .filter(|code| ours(code) || code == "unsupported-compensation")
        .collect();
    assert_described(&found, "contours.md");
}
