//! Any text in place of a specification is read with every mistake at its place; nothing overflows or hangs.
#![no_main]
use ciklo::spec::Catalogue;
use libfuzzer_sys::fuzz_target;

const CONTROL: &str = include_str!("../../tests/small/cycle-specs/controls/small.yaml");

fuzz_target!(|text: &str| {
    let files = vec![
        ("cycle-specs/controls/small.yaml".to_owned(), CONTROL.to_owned()),
        ("cycle-specs/drilling/901-fuzz.yaml".to_owned(), text.to_owned()),
    ];
    let (catalogue, found) = Catalogue::load(&files);
    for finding in found.into_iter().chain(ciklo::engine::plan::check(&catalogue)) {
        if let Some(place) = finding.place {
            let text = place.source.text();
            assert!(text.get(place.span.start..place.span.end).is_some());
        }
    }
});
