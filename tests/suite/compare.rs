//! Comparing programs: pairs that are the same to a control and pairs that are not, and what every
//! translation and every layout leaves the same.
//!
//! `tests/compare/*.txt` has cases of three parts, each behind a line: `= same` or `= different`, then
//! `-- a` and `-- b` with a program each.
use std::fs;
use std::path::Path;

use ciklo::base::diag::Source;
use ciklo::check::{Against, LabelBook};
use ciklo::language::locale::Locales;
use ciklo::program::syntax::encoding::{Charset, Encoding};
use ciklo::program::syntax::parse;
use ciklo::spec::Catalogue;
use ciklo::tools::compare::compare;
use ciklo::tools::translate::translate;

const UTF_8: Encoding = Encoding { charset: Charset::Utf8, bom: false };

struct Data {
    catalogue: &'static Catalogue,
    locales: &'static Locales,
}

impl Data {
    fn new() -> Self {
        let catalogue = &crate::built::built().catalogue;
        let locales = &*crate::built::built().locales;
        Self { catalogue, locales }
    }

    fn with<T>(&self, control: &str, then: impl FnOnce(&Against<'_>) -> T) -> T {
        let on = self.catalogue.on(control).expect("the control");
        let labels = LabelBook::new(on, &self.locales);
        then(&Against { catalogue: &self.catalogue, on, labels: &labels, language: None, software: None, readers: &[] })
    }

    fn same(&self, control: &str, a: &str, b: &str) -> bool {
        let (a, b) = (parse(&Source::new("a.h", a)), parse(&Source::new("b.h", b)));
        let there = self.with(control, |against| compare(&a, &b, against));
        let back = self.with(control, |against| compare(&b, &a, against));
        assert_eq!(there.is_empty(), back.is_empty(), "it does not matter which comes first");
        there.is_empty()
    }
}

fn texts(directory: &str, extension: &str) -> Vec<(String, String)> {
    let directory = Path::new(env!("CARGO_MANIFEST_DIR")).join(directory);
    let mut paths: Vec<_> = fs::read_dir(directory).expect("a folder").map(|e| e.expect("an entry").path()).collect();
    paths.retain(|path| path.extension().is_some_and(|own| own == extension));
    paths.sort();
    let read = |path: &std::path::PathBuf| (path.display().to_string(), fs::read_to_string(path).expect("a text"));
    paths.iter().map(read).collect()
}

#[test]
fn pairs() {
    let data = Data::new();
    let mut count = 0;
    for (name, text) in texts("tests/compare", "txt") {
        for case in text.split("\n= ").skip(1) {
            let (verdict, rest) = case.split_once('\n').expect("a verdict");
            let (_, programs) = rest.split_once("-- a\n").expect("a first program");
            let (a, b) = programs.split_once("-- b\n").expect("a second program");
            // A case with nothing behind its last line ends with the blank line before the next one.
            let verdict_found = if data.same("tnc640", a, b) { "same" } else { "different" };
            assert_eq!(verdict.split(':').next(), Some(verdict_found), "{name}: {case}");
            count += 1;
        }
    }
    assert!(count >= 20);
}

#[test]
fn a_program_is_the_same_in_every_language() {
    let data = Data::new();
    for (name, text) in texts("tests/printed", "nc") {
        let control = text.split("control:").nth(1).and_then(|rest| rest.split_whitespace().next()).expect("a control");
        for to in data.locales.tags() {
            let program = parse(&Source::new("a.h", text.clone()));
            let translated = data.with(control, |against| translate(&program, against, to, UTF_8)).text;
            assert!(data.same(control, &text, &translated), "{name} in {to}");
        }
    }
}

/// Whatever number of a printed block becomes another one, that is seen.
#[test]
fn another_value_is_another_program() {
    let data = Data::new();
    for (name, text) in texts("tests/printed", "nc") {
        let control = text.split("control:").nth(1).and_then(|rest| rest.split_whitespace().next()).expect("a control");
        let Some((line, value)) =
            text.lines().find_map(|line| Some((line, line.strip_prefix('Q')?.split_once('=')?.1)))
        else {
            continue;
        };
        let changed = line.replace(&format!("={value}"), &format!("=1{}", value.trim_start_matches(['+', '-'])));
        if value.starts_with(|c: char| c.is_ascii_digit() || c == '+' || c == '-') {
            assert!(!data.same(control, &text, &text.replacen(line, &changed, 1)), "{name}: {changed}");
        }
    }
}
