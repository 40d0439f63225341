//! Programs of a size and a shape for which anything that grows with the square of the length would take minutes.
use ciklo::check::{Against, LabelBook, check};
use ciklo::data;
use ciklo::diag::Source;
use ciklo::locale::Locales;
use ciklo::spec::Catalogue;
use ciklo::syntax::{Block, BlockKind, Program, parse};

/// How often things are repeated.
const MANY: usize = 20_000;

fn program(body: &str) -> Program {
    let head =
        "0 BEGIN PGM LONG MM\n1 BLK FORM 0.1 Z X+0 Y+0 Z-20\n2 BLK FORM 0.2 X+9 Y+9 Z+0\n3 TOOL CALL 1 Z S2000 F500\n";
    let text = format!("{head}{body}99999999 END PGM LONG MM\n");
    let program = parse(&Source::new("long.h", text.as_str()));
    assert_eq!(program.text(), text);
    program
}

/// How many findings of a code there are in each of some programs.
fn count(code: &str, bodies: &[String]) -> Vec<usize> {
    let files = data::embedded();
    let (catalogue, _) = Catalogue::load(&files);
    let (locales, _) = Locales::load(files);
    let on = catalogue.on("tnc640").expect("the control");
    let labels = LabelBook::new(on, &locales);
    let against = Against { catalogue: &catalogue, on, labels: &labels, language: None, readers: &[] };
    let found = |body: &String| check(&program(body), &against).iter().filter(|own| own.code == code).count();
    bodies.iter().map(found).collect()
}

#[test]
fn calls_that_are_nested_deep_are_recursive_only_in_a_circle() {
    let part = |at: usize, next: usize| format!("7 LBL \"N{at}\"\n8 CALL LBL \"N{next}\"\n9 LBL 0\n");
    let nested = |last: &str| {
        let parts: String = (0..MANY).map(|at| part(at, at + 1)).collect();
        format!("5 CALL LBL \"N0\"\n6 M30\n{parts}7 LBL \"N{MANY}\"\n{last}9 LBL 0\n")
    };
    let bodies = [nested("8 L X+1\n"), nested("8 CALL LBL \"N0\"\n")];
    assert_eq!(count("subprogram-recursive", &bodies), [0, MANY + 1]);
}

#[test]
fn labels_that_run_into_each_other_are_followed_as_far_as_patience_goes() {
    let calls: String = (0..MANY).map(|at| format!("5 CALL LBL \"N{at}\"\n")).collect();
    let labels: String = (0..MANY).map(|at| format!("7 LBL \"N{at}\"\n8 L X+{}\n", at % 100)).collect();
    let repeated = format!("{calls}6 M30\n{labels}7 LBL \"N0\"\n");
    assert_eq!(count("label-duplicate", &[format!("{calls}6 M30\n{labels}"), repeated]), [0, 1]);
}

#[test]
fn a_parameter_that_is_written_again_and_again_is_told_each_time() {
    let again = "Q200=2 ;SET-UP CLEARANCE\n".repeat(MANY);
    assert_eq!(count("duplicate-parameter", &[format!("5 CYCL DEF 200 DRILLING\n{again}")]), [MANY - 1]);
}

#[test]
#[cfg(target_pointer_width = "64")]
fn a_block_takes_little_room() {
    // A hundred megabytes of contour are three million of them, and commands hold six times the text at most.
    assert!(size_of::<Block>() <= 80, "{}", size_of::<Block>());
}

#[test]
fn long_lines_and_long_definitions_are_read_once() {
    let words = program(&format!("5 CYCL DEF 7.0 DATUM\n6 CYCL DEF 7.1 {}\n", "ABC ".repeat(MANY * 10)));
    let lines = words.blocks().iter().filter(|block| matches!(block.kind, BlockKind::OldCycleLine(_)));
    assert_eq!(lines.count(), 2);
    program(&format!("5 CONTOUR DEF\n{}{}", "I2 = LBL 5\n".repeat(MANY), "; a comment\n".repeat(MANY)));
    program(&format!("5 L X+1 ~\n{}", "~\n".repeat(MANY)));
    program(&format!("5 Q1 = {}1\n", "Q2 + ".repeat(MANY)));
    program(&format!("5 Q1 = {}1{}\n", "(".repeat(MANY), ")".repeat(MANY)));
}
