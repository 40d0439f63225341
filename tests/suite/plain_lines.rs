//! Lines in the usual words are read by a short way: it must tell what the long one tells, which is taken for the same line
//! behind a mark that counts as a blank.
use ciklo::base::diag::{Source, Span};
use ciklo::program::syntax::{Block, BlockKind, CycleDef, Parameter, Program, ValueKind, parse};
use proptest::prelude::*;

fn parsed(text: &str) -> Program {
    parse(&Source::new("plain.h", text))
}

/// What is told of a block, its text included.
fn told(program: &Program, block: &Block) -> String {
    let comment = block.comment().map(|span| program.slice(span));
    let kind = match &block.kind {
        BlockKind::Motion(element) => {
            let (mut functions, words) = (Vec::new(), element.words());
            element.each_function(|number| functions.push(number));
            let outline = ciklo::program::syntax::Outline::of(&words);
            assert_eq!(outline, element.outline(), "{:?}", program.slice(block.span));
            assert_eq!(functions, words.functions.iter().map(|own| own.number).collect::<Vec<_>>());
            assert_eq!(words.path, element.path());
            let coords: Vec<_> =
                words.coords.iter().map(|coord| (program.slice(coord.span), coord.value.amount)).collect();
            format!("{outline:?} {functions:?} {} {:?} {coords:?}", element.ends_with_letter(), words.path)
        }
        BlockKind::CycleDef(cycle) => definition(program, cycle),
        BlockKind::Unknown(error) => format!("{} {} {}", error.code, error.expected, program.slice(error.span)),
        kind => kind.name().to_owned(),
    };
    format!("{:?} {} {} {comment:?} {kind}", block.number, block.skip, block.lines)
}

fn definition(program: &Program, cycle: &CycleDef) -> String {
    let own = |own: Parameter| {
        let part = |span: Span| program.slice(span);
        let (q, value, label) = (part(own.q_span), part(own.value.span), own.label.map(part));
        let kind = match own.value.kind {
            ValueKind::Text(inside) => format!("text {}", part(inside)),
            kind => format!("{kind:?}"),
        };
        format!("{} {q} {value} {kind} {label:?} {}", own.q, part(own.span))
    };
    let errors: Vec<_> = cycle.errors.iter().map(|own| (own.code, own.expected, program.slice(own.span))).collect();
    format!("{} {:?} {errors:?}", cycle.number, cycle.parameters.iter().map(own).collect::<Vec<_>>())
}

fn same(text: &str) {
    let marked: String = text.split_inclusive('\n').map(|line| format!("\u{b}{line}")).collect();
    let (short, long) = (parsed(text), parsed(&marked));
    assert_eq!(short.text(), text);
    let all = |program: &Program| program.blocks().iter().map(|block| told(program, block)).collect::<Vec<_>>();
    assert_eq!(all(&short), all(&long), "{text:?}");
    let warnings = |program: &Program| program.diagnostics().iter().map(|own| own.code).collect::<Vec<_>>();
    assert_eq!(warnings(&short), warnings(&long), "{text:?}");
}

fn number() -> impl Strategy<Value = String> {
    prop_oneof![
        6 => "[+-]?[0-9]{1,4}(\\.[0-9]{0,4})?",
        1 => "[+-]?\\.[0-9]{1,3}",
        1 => "[+-]{0,3}[0-9]{0,20}[.,]?[0-9]{0,3}",
        1 => "[+-]? ?[0-9]{1,2}",
        1 => "[+-]?Q[LRS]?[0-9]{1,3}",
    ]
}

fn word() -> impl Strategy<Value = String> {
    prop_oneof![
        8 => ("I?([XYZABCUVW]|PR|PA)", number()).prop_map(|(name, number)| name + &number),
        1 => ("[A-Zxyz]{1,3}", number()).prop_map(|(name, number)| name + &number),
        2 => ("[NT][XYZ]", number()).prop_map(|(name, number)| name + &number),
        2 => "R[0LR]|R0[0.,]|RND|R",
        1 => ("R", number()).prop_map(|(name, number)| name + &number),
        2 => "FMAX|F MAX|FAUTO|F AUTO|F  MAX|FMAXM3|F|FU0\\.1|FZ0\\.2",
        2 => ("F", number()).prop_map(|(name, number)| name + &number),
        3 => "M0?[0-9]{1,3}\\.?|M 3|M",
        1 => "M(94|103|112|118|124|128|138|140|197)|MB MAX|LA5|DIST1|T0\\.01|A5",
        2 => "DR[+-]?|DR 1",
        1 => ";[A-Z ]{0,5}~?|~|\\*",
    ]
}

fn element() -> impl Strategy<Value = String> {
    let head = prop_oneof![4 => "[0-9]{1,7} {1,2}", 1 => "", 1 => " {1,3}", 1 => "/ ?|[0-9]{1,3}/? ?|N[0-9]{1,3} |[0-9]{9,11} "];
    let path = prop_oneof![6 => "L|C|CC|CR|LN|LP|CP|CT|CTP", 1 => "RND|CHF|LBL|APPR LCT|DEP CT|FL|FC|SPL|CYCL CALL|", 1 => "l|cc|LX|L\t"];
    let words = proptest::collection::vec(("| |  |\t", word()), 0..7);
    let end = prop_oneof![6 => "\n", 1 => "\r\n", 1 => " {1,2}\n", 1 => "\t\n|~\n| ;A\n|\r"];
    (head, path, words, end).prop_map(|(head, path, words, end)| {
        let words: String = words
            .into_iter()
            .map(|(blank, word)| if blank.is_empty() { format!(" {word}") } else { blank + &word })
            .collect();
        head + &path + &words + &end
    })
}

fn parameter() -> impl Strategy<Value = String> {
    let name = prop_oneof![8 => "Q[0-9]{3}", 1 => "Q[LRS]?[0-9]{1,6}", 1 => "q200"];
    let value = prop_oneof![8 => number(), 1 => "AUTO|FMAX|\"A\"|"];
    let label = prop_oneof![6 => ";[A-ZČŽ .]{0,9}[A-ZŽ0-9.]", 1 => ";[ A~;\\t\u{a0}\u{feff}\u{1}Ž]{0,6}", 2 => ""];
    let end = prop_oneof![4 => "\n", 3 => " ~\n", 1 => "~\r\n", 1 => "~ ~\n|~~\n|\r\n| \n|~ ;A\n|\r"];
    ("| {1,4}|5 ", name, " ?= ?|=", value, " ?", label, end)
        .prop_map(|(blank, name, sign, value, gap, label, end)| blank + &name + &sign + &value + &gap + &label + &end)
}

laws! {
    #![proptest_config(crate::cases::config(256))]

    #[test]
    fn contour_elements_are_read_alike(lines in proptest::collection::vec(element(), 1..5)) {
        same(&lines.concat());
    }

    #[test]
    fn parameters_are_read_alike(
        number in "|5 ",
        joint in "| ~| ;A ~",
        lines in proptest::collection::vec(prop_oneof![5 => parameter(), 1 => element(), 1 => ";[A-Z]{0,4}\n|\n|A B\n|9 L X+1\n"], 1..7),
    ) {
        same(&format!("{number}CYCL DEF 200 DRILLING{joint}\n{}", lines.concat()));
    }
}
