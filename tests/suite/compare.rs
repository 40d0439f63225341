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
use ciklo::tools::compare::{Difference, Statement, compare, statements};
use ciklo::tools::translate::translate;
use proptest::prelude::*;

use crate::cases;

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
        let labels = LabelBook::new(on, self.locales);
        then(&Against { catalogue: self.catalogue, on, labels: &labels, language: None, software: None, readers: &[] })
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

/// Blocks of a program and what they are compared with: the same numbers, signs and blanks in another spelling.
#[test]
fn numbers_have_one_spelling() {
    let data = Data::new();
    for (written, same) in [
        ("CALL  PGM TNC:\\A\\01.H ", "CALL PGM TNC:\\A\\01.H"),
        ("L X+10.000 Y-0,50 F MAX M03", "L X10 Y-.5 FMAX M3"),
        ("Q1 = + 5.", "q1 =5"),
        ("Q1 = Q2 + 5", "Q1=Q2+5.0"),
        ("Q1 = Q2 + +5", "Q1 = Q2 + 5"),
        ("L X+Q1", "L XQ1"),
        ("FN 0: Q1 = +-5", "FN 0: Q1 = -5"),
        ("C X+1 DR+ R0", "C X1 DR+  R0"),
    ] {
        assert!(data.same("tnc640", &block(written), &block(same)), "{written}");
    }
}

#[test]
fn what_means_something_stays() {
    let data = Data::new();
    for (one, other) in [
        ("CALL PGM 01", "CALL PGM 1"),
        ("L X+10", "L X-10"),
        ("L X+1", "L X+10"),
        ("L X1 0", "L X10"),
        ("C DR+", "C DR-"),
        ("Q1 = Q2 + 3", "Q1 = Q2 - 3"),
        ("Q1 = Q2 + 3", "Q1 = Q23"),
        ("Q1 = Q2 + Q3", "Q1 = Q2 Q3"),
        ("Q1 = PI + 3", "Q1 = PI 3"),
        ("Q1 = ( 1 + 2 ) + 3", "Q1 = ( 1 + 2 ) 3"),
        ("QS1 = \"a  b\"", "QS1 = \"a b\""),
        ("QS1 = \"a\"", "QS1 = \"A\""),
        ("LBL \"01\"", "LBL \"1\""),
    ] {
        assert!(!data.same("tnc640", &block(one), &block(other)), "{one}");
    }
}

/// A program with that block.
fn block(text: &str) -> String {
    format!("0 BEGIN PGM A MM\n1 {text}\n2 END PGM A MM\n")
}

laws! {
    #![proptest_config(cases::config(150))]

    /// What is not in a difference is equal in both programs, and a program has no difference from itself.
    #[test]
    fn between_the_differences_all_is_equal(
        a in proptest::collection::vec(0..6_u8, 0..40),
        b in proptest::collection::vec(0..6_u8, 0..40),
    ) {
        let program = |steps: &[u8]| {
            let blocks: String = steps.iter().map(|step| format!("L X+{step}\n")).collect();
            parse(&Source::new("a.h", format!("BEGIN PGM A MM\n{blocks}END PGM A MM\n")))
        };
        let (one, other) = (program(&a), program(&b));
        Data::new().with("tnc640", |against| {
            let found = compare(&one, &other, against);
            let kept = |program, side: &dyn Fn(&Difference) -> Vec<usize>| {
                let gone: Vec<usize> = found.iter().flat_map(side).collect();
                let all = statements(program, against).into_iter();
                all.filter(|own| !gone.contains(&own.line)).map(|own| own.text).collect::<Vec<_>>()
            };
            let lines = |own: &[Statement]| own.iter().map(|own| own.line).collect();
            prop_assert_eq!(kept(&one, &|own| lines(&own.a)), kept(&other, &|own| lines(&own.b)));
            prop_assert!(found.iter().all(|own| !own.a.is_empty() || !own.b.is_empty()));
            prop_assert!(compare(&one, &one, against).is_empty());
            Ok(())
        })?;
    }
}

/// Programs that have hardly a block in common are compared as quickly as others.
#[test]
fn long_programs_without_a_common_block_are_compared() {
    let program = |step: &dyn Fn(usize) -> usize| {
        let blocks: String = (0..20_000).map(|at| format!("L X+{}\n", step(at))).collect();
        parse(&Source::new("a.h", format!("BEGIN PGM A MM\n{blocks}END PGM A MM\n")))
    };
    let differ = |one: &dyn Fn(usize) -> usize, other: &dyn Fn(usize) -> usize| {
        let (one, other) = (program(one), program(other));
        Data::new().with("tnc640", |against| !compare(&one, &other, against).is_empty())
    };
    assert!(differ(&|at| at % 7, &|at| (at * 3) % 11));
    assert!(differ(&|at| at, &|at| 20_000 - at));
}
