//! The layout of programs: done twice it changes nothing more, and the program stays the same.
use std::fs;
use std::path::{Path, PathBuf};

use ciklo::base::diag::{Source, edited};
use ciklo::check::{Against, LabelBook};
use ciklo::program::layout::layout;
use ciklo::program::syntax::{Program, parse};
use ciklo::tools::compare::compare;

fn parsed(text: &str) -> Program {
    parse(&Source::new("program.h", text))
}

fn laid_out(text: &str) -> String {
    edited(text, &layout(&parsed(text)))
}

/// All programs among the tests' data.
fn programs() -> Vec<PathBuf> {
    let mut open = vec![Path::new(env!("CARGO_MANIFEST_DIR")).join("tests")];
    let mut found = Vec::new();
    while let Some(directory) = open.pop() {
        for entry in fs::read_dir(directory).expect("a folder") {
            let path = entry.expect("an entry").path();
            if path.is_dir() {
                open.push(path);
            } else if path.extension().is_some_and(|own| own.eq_ignore_ascii_case("h") || own == "nc") {
                found.push(path);
            }
        }
    }
    found.sort();
    found
}

#[test]
fn a_layout_is_final_and_the_program_the_same() {
    let catalogue = &crate::built::built().catalogue;
    let locales = &*crate::built::built().locales;
    let on = catalogue.on("tnc640").expect("the control");
    let labels = LabelBook::new(on, locales);
    let against = Against { catalogue, on, labels: &labels, language: None, software: None, readers: &[] };
    let programs = programs();
    assert!(programs.len() > 100);
    for path in programs {
        let Ok(text) = fs::read_to_string(&path) else { continue };
        for text in [text.clone(), text.replace('\n', "\r\n")] {
            let once = laid_out(&text);
            assert_eq!(laid_out(&once), once, "{}", path.display());
            let found = compare(&parsed(&text), &parsed(&once), &against);
            assert!(found.is_empty(), "{}: {found:?}", path.display());
        }
    }
}

#[test]
fn numbers_columns_and_signs() {
    let before = "\
5 BEGIN PGM A MM
7 L X10 Y-5 IZ.5 R0 FMAX M3
7 CYCL DEF 200 DRILLING ~
 Q200=2;SET-UP CLEARANCE ~
\tQ201=-15.25 \t;DEPTH ~
  Q1234=+100.12345 ;LONG
L XQ5 Y+Q6 ; no number
3 ; X10
2 Q1 = 5 + 3
1 CYCL CALL POS X5 Y+5 Z0
/ 9 END PGM A MM
";
    let after = "\
5 BEGIN PGM A MM
6 L X+10 Y-5 IZ+.5 R0 FMAX M3
7 CYCL DEF 200 DRILLING ~
    Q200=2           ;SET-UP CLEARANCE ~
    Q201=-15.25      ;DEPTH ~
    Q1234=+100.12345 ;LONG
L X+Q5 Y+Q6 ; no number
8 ; X10
9 Q1 = 5 + 3
10 CYCL CALL POS X+5 Y+5 Z+0
/ 11 END PGM A MM
";
    assert_eq!(laid_out(before), after);
}

/// Bytes that are no text before a number are not mistaken for it.
#[test]
fn a_number_behind_other_bytes_stays() {
    let text = "%A G71 *\nN10 G00 X+5*\n\0\0N13 G01 X+9*\nN20 M02*\nN99999999 %A G71 *\n";
    let program = parse(&Source::new("part.i", text));
    assert_eq!(edited(text, &layout(&program)), text);
}

/// A first block with the number of the last one gives no step, and numbers that would reach it stay.
#[test]
fn numbers_stay_below_that_of_the_last_block() {
    let lines = |numbers: [u32; 3]| {
        let [a, b, c] = numbers;
        format!("%T G71 *\nN{a} G00 X+1 *\nN{b} G01 X+2 *\nN{c} G01 X+3 *\nN99999999 %T G71 *\n")
    };
    for (before, after) in [
        ([99_999_999, 10, 20], [99_999_999, 10, 20]),
        ([99_999_999, 10, 25], [99_999_999, 10, 25]),
        ([10, 99_999_990, 7], [10, 99_999_990, 7]),
        ([5, 8, 8], [5, 8, 11]),
    ] {
        let laid = |text: &str| {
            let program = parse(&Source::new("part.i", text));
            edited(text, &layout(&program))
        };
        let once = laid(&lines(before));
        assert_eq!(once, lines(after));
        assert_eq!(laid(&once), once);
    }
}

/// The lines of a definition that cannot be read whole keep what looks like their numbers, for it may be anything.
#[test]
fn the_numbers_in_a_torn_definition_stay() {
    let text = "0 BEGIN PGM A MM\n1 CYCL DEF 200 DRILLING ~\n2 Q200=2 ;SET-UP CLEARANCE ~\n7Q1K010 ;DEPTH ~\n9 Q203=0 ;SURFACE\n12 END PGM A MM\n";
    let after = "0 BEGIN PGM A MM\n1 CYCL DEF 200 DRILLING ~\n2 Q200=2 ;SET-UP CLEARANCE ~\n7Q1K010 ;DEPTH ~\n9 Q203=0 ;SURFACE\n2 END PGM A MM\n";
    let squeezed = |text: &str| text.split_whitespace().collect::<Vec<_>>().join(" ");
    assert_eq!(squeezed(&laid_out(text)), squeezed(after));
}
