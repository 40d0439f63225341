//! The interchange form: its keys and values over a small catalogue, and its promises over all data.
use crate::small as catalogue;

use ciklo::base::data::Files;
use ciklo::language::locale::Locales;
use ciklo::output::export::{self, Export};
use ciklo::spec::Catalogue;
use serde_json::{Value, json};

fn files() -> Files {
    catalogue::files(|path| ["locales/en/text.ftl", "locales/en/units.ftl"].contains(&path))
}

fn small() -> Result<Export, Vec<String>> {
    let files = files();
    let (catalogue, found) = Catalogue::load(&files);
    assert!(found.is_empty(), "{found:?}");
    let (locales, found) = Locales::load(files.iter().map(|(path, text)| (path, text)));
    assert!(found.is_empty(), "{found:?}");
    let on = catalogue.on("small").expect("the control is there");
    let result = export::export(on, locales.language("en").expect("English is there"));
    result.map_err(|faults| faults.iter().map(|fault| format!("{} {:?}", fault.code, fault.args)).collect())
}

#[test]
fn a_cycle_has_all_keys_in_the_documented_form() {
    let export = serde_json::to_value(small().expect("all texts are there")).expect("it is JSON");
    assert_eq!(export["format"], "ciklo-export/1");
    assert_eq!(export["named"], json!([{"keyword": "TCH PROBE", "number": 3, "name": "MERJENJE"}]));
    let pecking = &export["cycles"][1];
    assert_eq!(pecking["number"], 901);
    assert_eq!(pecking["iso"], json!(["G901"]));
    assert_eq!(pecking["nc_name"], "PECKING");
    assert_eq!(pecking["nc_name_aliases"], json!(["PECK DRILLING", "PECK"]));
    assert_eq!(pecking["options"], json!([8]));
    assert_eq!(
        pecking["parameters"][0],
        json!({
            "q": "Q201", "kind": "number", "name": "Depth", "prompt": "Depth?", "label": "DEPTH", "label_aliases": ["DPTH"],
            "help": "Distance to the bottom, in Q203 steps.", "quantity": "length", "unit": "mm", "reference": "incremental",
            "min": -99999.9999, "max": 0, "max_length": null, "choices": [], "words": [], "effective": null, "neutral": 0,
            "example": "-20"
        })
    );
    let mode = &pecking["parameters"][1];
    assert_eq!(mode["prompt"], "Which mode? 0/1");
    assert_eq!(mode["choices"][0], json!({"value": 0, "text": "Plain"}));
    assert_eq!(mode["choices"][1]["value"], ">0");
    assert_eq!(mode["effective"], "the depth is not 0");
    assert_eq!(mode["words"], json!(["PREDEF"]));
    assert_eq!(pecking["results"], json!([{"q": "Q150", "text": "Depth reached"}]));
}

#[test]
fn steps_are_numbered_through_and_repetitions_name_the_steps_of_their_series() {
    let export = serde_json::to_value(small().expect("all texts are there")).expect("it is JSON");
    let steps: Vec<(u64, &str, &str)> = export["cycles"][1]["steps"]
        .as_array()
        .expect("steps are a list")
        .iter()
        .map(|step| (step["number"].as_u64().unwrap_or(0), text(&step["id"]), text(&step["text"])))
        .collect();
    assert_eq!(
        steps,
        [
            (1, "approach", "The tool approaches.\n- In mode 0 it moves to SAFE_H first."),
            (2, "peck", "The tool pecks."),
            (3, "clear-chips", "The tool clears the chips.\n- In mode 0 it waits.\n- Otherwise it goes on."),
            (4, "depth-reached", "Steps 2 and 3 are repeated until the depth is reached."),
            (5, "tap", "The tool taps once."),
            (6, "all-tapped", "Step 5 is repeated until all is tapped."),
        ]
    );
}

#[test]
fn notes_keep_their_kinds_and_checks_of_the_control_follow() {
    let export = serde_json::to_value(small().expect("all texts are there")).expect("it is JSON");
    assert_eq!(
        export["cycles"][1]["notes"],
        json!([{"kind": "caution", "text": "Mind the tool: *see* `TNC:\\tool_a.t`, <b> & F_PREPOS, - \"1. not a list\"."}, {"kind": "guard", "text": "A depth of 0 is refused."}])
    );
}

#[test]
fn fields_of_the_old_form_are_named_by_line_and_id() {
    let export = serde_json::to_value(small().expect("all texts are there")).expect("it is JSON");
    let fields: Vec<Value> = export["cycles"][0]["parameters"]
        .as_array()
        .expect("parameters are a list")
        .iter()
        .map(|field| json!([field["q"], field["label"], field["example"]]))
        .collect();
    assert_eq!(
        fields,
        [
            json!(["9.0 result", null, "Q5"]),
            json!(["9.1 angle", "ROT", "+35"]),
            json!(["9.2 height", "HEIGHT:", "+120"])
        ]
    );
    assert_eq!(export["cycles"][0]["results"][0]["q"], "9.0 result");
}

#[test]
fn a_missing_text_is_an_error_with_its_place() {
    let mut files = files();
    for (path, text) in &mut files {
        if path == "locales/en/small.ftl" {
            *text = text.replace("step-tap = The tool taps once.", "");
        }
    }
    let (catalogue, _) = Catalogue::load(&files);
    let (locales, _) = Locales::load(files.iter().map(|(path, text)| (path, text)));
    let on = catalogue.on("small").expect("the control is there");
    let faults = export::export(on, locales.language("en").expect("English is there")).expect_err("a text is missing");
    let [fault] = faults.as_slice() else { panic!("{faults:?}") };
    assert_eq!(fault.code, "locale-missing-text");
    let place = fault.place.as_ref().expect("the specification asked for it");
    assert_eq!(place.source.name(), "cycle-specs/drilling/901-pecking.yaml");
}

#[test]
fn every_control_exports_in_every_complete_language() {
    let catalogue = &crate::built::built().catalogue;
    let locales = &*crate::built::built().locales;
    for language in locales.iter() {
        if !locales.audit(language.tag()).expect("the language is there").missing.is_empty() {
            continue;
        }
        for on in catalogue.controls.values() {
            let export = export::export(on, language).map_err(|faults| format!("{faults:#?}"));
            let export = export.unwrap_or_else(|faults| panic!("{} {}: {faults}", on.id(), language.tag()));
            assert_eq!(export.cycles.len(), on.cycles.len());
            for cycle in export.cycles {
                let key = format!("{} {}", cycle.keyword, cycle.number);
                assert!(!cycle.steps.is_empty(), "{key} has no step");
                assert!(cycle.steps.iter().zip(1..).all(|(step, number)| step.number == number), "{key}");
                let marks = ['\u{2068}', '\u{2069}'];
                assert!(cycle.steps.iter().all(|step| !step.text.contains(marks)), "{key}");
            }
        }
    }
}

fn text(value: &Value) -> &str {
    value.as_str().unwrap_or_default()
}
