//! The coverage report: its documented keys over all data, and what it counts over a small catalogue.
use std::collections::{BTreeMap, BTreeSet};

use ciklo::base::data;
use ciklo::language::locale::Locales;
use ciklo::spec::{Catalogue, CycleKey, Keyword};
use ciklo::tools::coverage::{Coverage, Executed, LeftOut, coverage};
use serde_json::Value;

use crate::small;

fn report(files: &[(String, String)], executed: &Executed) -> Coverage {
    let (catalogue, _) = Catalogue::load(files);
    let (locales, _) = Locales::load(files.iter().map(|(path, text)| (path, text)));
    coverage(&catalogue, &locales, executed).expect("all languages can be compared")
}

/// The keys in the first column of each table of the page, by the heading before it.
fn documented() -> BTreeMap<String, BTreeSet<String>> {
    let mut tables = BTreeMap::new();
    let mut heading = "report".to_owned();
    for line in include_str!("../../docs/coverage.md").lines() {
        if let Some(word) = line.split("**").nth(1) {
            heading = word.to_owned();
        }
        if let Some(cell) = line.strip_prefix("| `").and_then(|rest| rest.split('|').next()) {
            let keys = cell.split(", `").map(|key| key.trim().trim_matches('`').to_owned());
            tables.entry(heading.clone()).or_insert_with(BTreeSet::new).extend(keys);
        }
    }
    tables
}

fn keys(value: &Value) -> BTreeSet<String> {
    value.as_object().expect("an object").keys().cloned().collect()
}

fn list<'v>(value: &'v Value, key: &str) -> &'v [Value] {
    value[key].as_array().expect("a list")
}

#[test]
fn every_object_has_the_documented_keys() {
    let page = documented();
    let report = serde_json::to_value(report(&data::embedded(), &Executed::new())).expect("it is JSON");
    assert_eq!(report["format"], "ciklo-coverage/1");
    assert_eq!(keys(&report), page["report"]);
    for control in list(&report, "controls") {
        assert_eq!(keys(control), page["control"]);
        assert_eq!(control["described"], list(control, "cycles").len());
        for cycle in list(control, "cycles") {
            assert_eq!(keys(cycle), page["cycle"]);
            assert!(list(cycle, "texts").iter().all(|texts| keys(texts) == page["texts"]));
        }
    }
}

#[test]
fn what_nobody_executed_or_translated_is_listed() {
    let mut files = small::files(|_| false);
    let report = report(&files, &Executed::new());
    let cycle = &report.controls[0].cycles[1];
    assert_eq!(cycle.number, 901);
    assert_eq!(cycle.unexecuted.len(), cycle.sentences, "without examples nothing is executed");
    assert!(!cycle.is_complete());
    assert!(cycle.texts[0].missing.is_empty(), "{:?}", cycle.texts[0].missing);

    let text = files.iter_mut().find(|(path, _)| path.ends_with("small.ftl")).expect("the texts");
    text.1 = text.1.replace("cycle-pecking =", "cycle-packing =");
    let key = (report.controls[0].control.clone(), CycleKey::new(Keyword::CyclDef, 901));
    let unprovoked = BTreeSet::from(["depth-zero".to_owned()]);
    let executed = Executed::from([(key, LeftOut { unexecuted: BTreeSet::new(), unprovoked })]);
    let report = self::report(&files, &executed);
    let cycle = &report.controls[0].cycles[1];
    assert!(cycle.unexecuted.is_empty());
    assert_eq!(cycle.unprovoked, ["depth-zero"]);
    assert!(cycle.texts[0].missing.contains(&"cycle-pecking".to_owned()), "{:?}", cycle.texts[0].missing);
}
