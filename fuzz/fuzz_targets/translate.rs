//! A program that is checked and translated through all languages comes back, and only labels and names change.
#![no_main]
use std::sync::OnceLock;

use ciklo::check::{Against, LabelBook, check};
use ciklo::base::data;
use ciklo::base::diag::Source;
use ciklo::language::locale::Locales;
use ciklo::spec::Catalogue;
use ciklo::program::syntax::encoding::{Charset, Encoding};
use ciklo::program::syntax::parse;
use ciklo::tools::translate::translate;
use libfuzzer_sys::fuzz_target;

struct Data {
    catalogue: Catalogue,
    locales: Locales,
}

fn loaded() -> &'static Data {
    static DATA: OnceLock<Data> = OnceLock::new();
    DATA.get_or_init(|| {
        let files = data::embedded();
        Data { catalogue: Catalogue::load(&files).0, locales: Locales::load(files).0 }
    })
}

fuzz_target!(|text: &str| {
    static BOOK: OnceLock<LabelBook<'static>> = OnceLock::new();
    let data = loaded();
    let Some(on) = data.catalogue.on("tnc640") else { return };
    let labels = BOOK.get_or_init(|| LabelBook::new(on, &data.locales));
    let against = Against { catalogue: &data.catalogue, on, labels, language: None, software: None, readers: &[] };
    let utf_8 = Encoding { charset: Charset::Utf8, bom: false };
    let program = |text: &str| parse(&Source::new("fuzz.h", text));
    for finding in check(&program(text), &against) {
        let span = finding.place.expect("a place").span;
        assert!(text.get(span.start..span.end).is_some());
    }
    // Variants of labels become the label on the first way.
    let first = translate(&program(text), &against, "fi", utf_8).text;
    let mut now = first.clone();
    for to in ["sl", "it", "pt", "en", "fi"] {
        let there = translate(&program(&now), &against, to, utf_8).text;
        assert_eq!(there.matches('\n').count(), now.matches('\n').count());
        now = there;
    }
    assert_eq!(now, first);
});
