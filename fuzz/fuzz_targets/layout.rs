//! A program that is laid out stays as it is when it is laid out again, and a control reads the same in it.
#![no_main]
use std::sync::OnceLock;

use ciklo::check::{Against, LabelBook};
use ciklo::tools::compare::compare;
use ciklo::base::data;
use ciklo::base::diag::{Source, edited};
use ciklo::program::layout::layout;
use ciklo::language::locale::Locales;
use ciklo::spec::Catalogue;
use ciklo::program::syntax::parse;
use libfuzzer_sys::fuzz_target;

fuzz_target!(|text: &str| {
    static DATA: OnceLock<(Catalogue, Locales)> = OnceLock::new();
    static BOOK: OnceLock<LabelBook<'static>> = OnceLock::new();
    let (catalogue, locales) = DATA.get_or_init(|| {
        let files = data::embedded();
        (Catalogue::load(&files).0, Locales::load(files).0)
    });
    let Some(on) = catalogue.on("tnc640") else { return };
    let labels = BOOK.get_or_init(|| LabelBook::new(on, locales));
    let against = Against { catalogue, on, labels, language: None, software: None, readers: &[] };
    for name in ["fuzz.h", "fuzz.i"] {
        let read = |text: &str| parse(&Source::new(name, text));
        let program = read(text);
        let once = edited(text, &layout(&program));
        let again = read(&once);
        assert_eq!(edited(&once, &layout(&again)), once);
        let differences = compare(&program, &again, &against);
        assert!(differences.is_empty(), "{once}\n{differences:?}");
    }
});
