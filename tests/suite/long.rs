//! Programs of a size and a shape for which anything that grows with the square of the length would take minutes.
use ciklo::base::diag::Source;
use ciklo::check::{Against, LabelBook, check};
use ciklo::program::syntax::{Block, BlockKind, Program, parse};

use crate::built::built;

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
    count_on("tnc640", code, bodies)
}

/// The same on a control.
fn count_on(control: &str, code: &str, bodies: &[String]) -> Vec<usize> {
    let (catalogue, locales) = (&built().catalogue, &*built().locales);
    let on = catalogue.on(control).expect("the control");
    let labels = LabelBook::new(on, locales);
    let against = Against { catalogue, on, labels: &labels, language: None, software: None, readers: &[] };
    let found = |body: &String| check(&program(body), &against).iter().filter(|own| own.code == code).count();
    bodies.iter().map(found).collect()
}

/// So many texts one behind the other.
fn each(times: usize, text: impl Fn(usize) -> String) -> String {
    (1..=times).map(text).collect()
}

/// A definition with further parameters.
fn with(definition: &str, parameters: usize, text: impl Fn(usize) -> String) -> String {
    format!("{}{}\n", definition.trim_end(), each(parameters, |at| format!(" ~\n{}", text(at))))
}

/// A definition that leaves nothing to be said but that it is not called.
const DRILLING: &str = "5 CYCL DEF 200 DRILLING Q200=2 Q201=-15 Q206=250 Q202=5 Q210=0 Q203=0 Q204=50 Q211=0\n";
const CONTOUR: &str = "5 CYCL DEF 14.0 CONTOUR\n6 CYCL DEF 14.1 CONTOUR LABEL 1\n";
const CONTOUR_DATA: &str = "7 CYCL DEF 20 CONTOUR DATA Q1=-20 Q2=1 Q3=0.2 Q4=0.1 Q5=0 Q6=2 Q7=80 Q8=0.5 Q9=1\n";
const ROUGHING: &str = "8 CYCL DEF 22 ROUGH-OUT Q10=5 Q11=100 Q12=750 Q18=0 Q19=0 Q208=9999\n";

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

#[test]
fn data_of_contours_are_found_for_each_cycle_that_works_with_them() {
    let cycles = ROUGHING.repeat(MANY);
    let several = format!("{CONTOUR_DATA}{ROUGHING}").repeat(MANY / 2);
    let long = with(CONTOUR_DATA, MANY, |_| "Q9=1".to_owned());
    let bodies = [format!("{CONTOUR_DATA}{cycles}"), several, format!("{long}{cycles}")];
    assert_eq!(count("defined-but-never-called", &bodies), [MANY, MANY / 2, MANY]);
}

#[test]
fn contours_are_looked_at_once_for_each_cycle() {
    let contour = |element: &str| format!("6 M30\n7 LBL 1\n{}9 LBL 0\n", element.repeat(MANY));
    let called = format!("{ROUGHING}9 CYCL CALL\n");
    let line = contour("8 L IX+1 IY+1 RL\n");
    let readers = format!("{CONTOUR}{CONTOUR_DATA}{}{line}", called.repeat(MANY));
    let lists = format!("{CONTOUR_DATA}{}{line}", format!("{CONTOUR}{called}").repeat(MANY));
    let one = |element: &str| format!("{CONTOUR}{CONTOUR_DATA}{called}{}", contour(element));
    // What is said of the first point is said where it stands, too.
    let bodies = [readers, lists, one("8 L X+1 Y+1 Z+1 RL\n"), one(DRILLING)];
    assert_eq!(count("contour-wrong", &bodies), [1, 1, MANY, MANY]);
    let blanks = "5 FUNCTION TURNDATA BLANK LBL 1\n".repeat(MANY);
    let turned = format!("{blanks}6 M30\n7 LBL 1\n{}9 LBL 0\n", each(MANY, |at| format!("8 L Z+{at} X+1\n")));
    assert_eq!(count("contour-wrong", &[turned]), [MANY]);
}

#[test]
fn contours_without_an_end_are_all_told() {
    let list = each(MANY - 1, |at| format!("/{}", at + 1));
    let labels = each(MANY, |at| format!("7 LBL {at}\n8 L X+1 Y+1 RL\n"));
    let body = format!("{}{list}\n{CONTOUR_DATA}{ROUGHING}9 CYCL CALL\n6 M30\n{labels}", CONTOUR.trim_end());
    assert_eq!(count("subprogram-without-end", &[body]), [MANY]);
}

#[test]
fn positions_behind_calls_are_looked_for_once() {
    let calls = "8 M99\n".repeat(MANY);
    let body = format!("{CONTOUR}{CONTOUR_DATA}{ROUGHING}{calls}9 L X+1\n6 M30\n7 LBL 1\n8 L X+1 Y+1 RL\n9 LBL 0\n");
    assert_eq!(count("position-after-contour", &[body]), [MANY]);
}

#[test]
fn functions_that_are_ended_are_compared_with_all_that_were_begun() {
    let ended = "5 L X+1 M120\n".repeat(MANY);
    assert_eq!(count("word-missing", &[ended.clone(), format!("5 L X+1 M120 LA5\n{ended}")]), [MANY, 0]);
}

#[test]
fn tools_are_found_again_among_many() {
    let define = |at: usize| format!("5 TOOL DEF {} L+0 R+3\n", at + 1);
    let call = |at: usize| format!("5 TOOL CALL {} Z S100 F100\n", at + 1);
    let again = each(MANY, |at| format!("5 TOOL DEF 2 L+0 R+{at}\n"));
    let behind = each(MANY, call) + &each(MANY, define);
    assert_eq!(count("tool-definition-wrong", &[each(MANY, define), again, behind]), [0, MANY - 1, MANY]);
    let pocket = "6 CYCL DEF 252 CIRCULAR POCKET Q215=0 Q223=5 Q368=0 Q207=500 Q351=1 Q201=-20 Q202=5 Q369=0 Q206=150 \
                  Q338=0 Q200=2 Q203=0 Q204=50 Q370=1 Q366=0 Q385=500\n7 L X+1 M99\n";
    let milled = each(MANY, |at| define(at) + &call(at)) + &each(MANY / 4, |at| call(at) + pocket);
    let one = format!("{}{}{pocket}{}", define(1), call(1), "7 L X+1 M99\n".repeat(MANY));
    assert_eq!(count("tool-wider-than-pocket", &[milled, one]), [MANY / 4, 1]);
}

#[test]
fn parameters_of_one_definition_are_told_apart_quickly() {
    let order = [211, 204, 203, 210, 202, 206, 201, 200];
    let falling = with("5 CYCL DEF 200 DRILLING\n", MANY, |at| format!("Q{}=1", order[at % order.len()]));
    let equal = with("5 CYCL DEF 200 DRILLING ~\nQ211=1\n", MANY, |_| "Q200=1".to_owned());
    assert_eq!(count("misordered-parameter", &[falling, equal]), [1, 1]);
    let same = with("5 CYCL DEF 9999 X\n", MANY, |at| format!("Q{at}=1 ;SAME LABEL"));
    let other = with("5 CYCL DEF 9999 X\n", MANY, |at| format!("Q{at}=1 ;LABEL {at:05}"));
    assert_eq!(count("label-twice", &[same, other]), [2 * (MANY - 1), 0]);
    let doubtful = with(DRILLING, MANY, |_| "Q202=0".to_owned());
    let called = format!("{}{}", with(DRILLING, MANY, |_| "Q211=0".to_owned()), "6 L X+1 M99\n".repeat(MANY));
    assert_eq!(count("duplicate-parameter", &[doubtful, called]), [MANY, MANY]);
}

#[test]
fn parameters_of_a_cycle_of_another_control_are_told_apart_quickly() {
    let twice = with("5 CYCL DEF 200 DRILLING\n", MANY, |_| "Q200=1".to_owned());
    let foreign = with("5 CYCL DEF 200 DRILLING ~\nQ200=1\n", MANY, |at| format!("Q{}=1", at + 1000));
    let found = count_on("tnc320", "differs-from-other-control", &[twice, foreign]);
    assert_eq!(found, [MANY - 1, 0]);
}

#[test]
fn values_for_all_cycles_are_found_for_each_parameter() {
    let general = "5 GLOBAL DEF 100 GENERAL ~\nQ200=2 ~\nQ204=50 ~\nQ253=750 ~\nQ208=999\n";
    let linked = DRILLING.replace("Q201=-15", "Q201=PREDEF").repeat(MANY);
    let given = DRILLING.replace("Q200=2", "Q200=PREDEF").repeat(MANY);
    let bodies = [linked, format!("{general}{given}"), format!("{}{given}", general.repeat(MANY))];
    assert_eq!(count("wrong-value-kind", &bodies), [MANY, 0, 0]);
    let again = format!("{}{}", DRILLING.repeat(MANY), general.repeat(MANY));
    let twice = with(general, MANY, |_| "Q200=2".to_owned());
    let foreign = with(general, MANY, |at| format!("Q{}=1", at + 300));
    assert_eq!(count("global-def-wrong", &[again, twice, foreign]), [MANY - 1, MANY, MANY]);
}

#[test]
fn parts_of_one_block_are_told_apart_quickly() {
    let places = |x: fn(usize) -> usize| {
        let place = |at| format!(" POS{at}( X+{} Y+1 Z+0 )", x(at));
        format!("5 PATTERN DEF{}\n", each(MANY, place))
    };
    // More than nine are told at the tenth.
    assert_eq!(count("pattern-wrong", &[places(|at| at), places(|_| 1)]), [1, MANY]);
    let contours = |number: fn(usize) -> usize| {
        let contour = |at| format!(" I{} = LBL 1", number(at));
        format!("5 CONTOUR DEF P1 = LBL 1{}\n7 LBL 1\n", each(MANY, contour))
    };
    assert_eq!(count("contour-def-wrong", &[contours(|at| at + 1), contours(|_| 1)]), [1, MANY + 1]);
    let axes = format!("5 TRANS DATUM AXIS{}\n", " X+1".repeat(MANY));
    let lines = format!("5 CYCL DEF 7.0 DATUM\n{}", each(MANY, |at| format!("6 CYCL DEF 7.{at} X+1\n")));
    assert_eq!(count("word-twice", &[axes, lines]), [MANY - 1, MANY - 1]);
}

#[test]
fn parameters_that_are_written_before_a_call_are_told_each_time() {
    let (call, written) = ("6 L X+1 M99\n", "7 Q203 = +10\n".repeat(MANY));
    let long = with(DRILLING, MANY, |_| "Q211=0".to_owned());
    let changes = "7 L X+1 RL\n7 Q203 = +1\n7 L X+1 R0\n7 Q204 = +2\n".repeat(MANY / 2);
    let bodies = [format!("{DRILLING}{call}{written}{call}"), format!("{long}{call}{changes}{call}")];
    assert_eq!(count("transfer-parameter-overwritten", &bodies), [MANY, MANY]);
}

#[test]
fn loops_are_looked_through_as_far_as_patience_goes() {
    let own = each(MANY, |at| format!("6 LBL {at}\n7 L IX+1\n8 FN 9: IF +0 EQU +0 GOTO LBL {at}\n"));
    let calls = "6 CALL LBL 2\n".repeat(MANY);
    let part = "7 L IX+1\n".repeat(MANY);
    let called = format!("5 LBL 1\n{calls}8 FN 9: IF +0 EQU +0 GOTO LBL 1\n9 M30\n7 LBL 2\n{part}7 LBL 0\n");
    let nested = each(MANY, |at| format!("6 LBL {at}\n"))
        + &each(MANY, |at| format!("8 FN 9: IF +QS1 EQU +0 GOTO LBL {}\n", MANY + 1 - at));
    assert_eq!(count("loop-endless", &[own, called, nested]), [MANY, 0, 0]);
}

#[test]
fn parts_with_many_ends_are_followed_once_for_all_calls() {
    let calls = "5 CALL LBL \"PART\"\n".repeat(MANY / 4);
    let ends = each(MANY / 4, |at| format!("6 FN 9: IF +Q1 EQU +Q2 GOTO LBL {at}\n7 LBL 0\n8 LBL {at}\n"));
    let body = |calls: &str| format!("{calls}5 M30\n6 LBL \"PART\"\n{ends}7 LBL 0\n");
    let bodies = [body("5 CALL LBL \"PART\"\n"), body(&calls)];
    assert_eq!(count("parameter-unassigned", &bodies), [2, 2]);
}

#[test]
fn what_comments_allow_is_taken_back_quickly() {
    let again = with("5 CYCL DEF 200 DRILLING\n", MANY, |_| "Q200=2".to_owned());
    let allowed = "; ciklo: allow duplicate-parameter it is meant\n".repeat(MANY);
    assert_eq!(count("duplicate-parameter", &[again.clone(), format!("{allowed}{again}")]), [MANY - 1, 0]);
}

#[test]
fn feeds_of_the_tool_are_told_at_each_parameter() {
    let feeds = with("5 CYCL DEF 200 DRILLING\n", MANY, |_| "Q206=AUTO".to_owned());
    assert_eq!(count("tool-feed-missing", &[format!("4 TOOL CALL 2 Z S100 F0\n{feeds}")]), [MANY]);
}

#[test]
fn heights_are_compared_with_the_floor_at_their_place() {
    let milled = |at| format!("5 CYCL DEF 213 STUD Q216={at} Q217=0 Q203=0 Q201=-2\n");
    let measured = |at| {
        format!(
            "6 TCH PROBE 424 MEASURE RECTANG. OUT Q273={at} Q274=0 Q282=80 Q283=60 Q261=-5 Q320=0 Q260=30 Q301=0 \
             Q284=0 Q285=0 Q286=0 Q287=0 Q279=0 Q280=0 Q281=0 Q309=0 Q330=0\n"
        )
    };
    let body = each(MANY / 2, milled) + &each(MANY / 2, measured);
    assert_eq!(count("measuring-height-below-floor", &[body]), [MANY / 2]);
}
