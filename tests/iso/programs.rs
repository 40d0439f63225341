//! Blocks of random programs that both languages have.
use proptest::prelude::*;

fn number() -> impl Strategy<Value = String> {
    prop_oneof![
        (-999..999_i32).prop_map(|n| format!("{n:+}")),
        (-9999..9999_i32).prop_map(|n| format!("{:+}", f64::from(n) / 100.0)),
        (0..99_i32).prop_map(|n| n.to_string()),
        (1..99_u8).prop_map(|n| format!("+Q{n}")),
        (1..9_u8).prop_map(|n| format!("-QL{n}")),
    ]
}

fn coordinates(axes: &'static [&'static str]) -> impl Strategy<Value = String> {
    proptest::collection::vec((proptest::sample::select(axes), any::<bool>(), number()), 1..4).prop_map(|words| {
        words.iter().map(|(axis, inc, n)| format!(" {}{axis}{n}", if *inc { "I" } else { "" })).collect()
    })
}

fn tail() -> impl Strategy<Value = String> {
    let compensation = proptest::sample::select(vec!["", " R0", " RL", " RR"]);
    let feed = proptest::sample::select(vec!["", " F500", " FAUTO", " F+Q5"]);
    let functions = proptest::sample::select(vec!["", " M3", " M8 M13", " M99", " M140 MB MAX", " M91"]);
    (compensation, feed, functions).prop_map(|(a, b, c)| format!("{a}{b}{c}"))
}

const LINEAR: &[&str] = &["X", "Y", "Z", "A", "B", "C", "U", "V", "W"];
const PLANE: &[&str] = &["X", "Y"];

/// A number that is a radius after `R`: a bare `R0` is a word of its own, which switches the compensation off.
fn radius() -> impl Strategy<Value = String> {
    number().prop_map(|number| if number == "0" { "+0".to_owned() } else { number })
}

/// A block of Klartext that DIN/ISO has an equivalent of.
pub(crate) fn block() -> impl Strategy<Value = String> {
    let direction = || proptest::sample::select(vec!["DR+", "DR-"]);
    prop_oneof![
        6 => (coordinates(LINEAR), tail()).prop_map(|(at, tail)| format!("L{at}{tail}")),
        2 => coordinates(LINEAR).prop_map(|at| format!("L{at} FMAX M3")),
        1 => coordinates(PLANE).prop_map(|at| format!("CC{at}")),
        1 => Just("CC".to_owned()),
        1 => (coordinates(PLANE), direction(), tail()).prop_map(|(at, d, tail)| format!("C{at} {d}{tail}")),
        1 => (coordinates(PLANE), radius(), direction()).prop_map(|(at, r, d)| format!("CR{at} R{r} {d}")),
        1 => (coordinates(PLANE), tail()).prop_map(|(at, tail)| format!("CT{at}{tail}")),
        1 => (coordinates(&["PR", "PA", "Z"]), tail()).prop_map(|(at, tail)| format!("LP{at}{tail}")),
        1 => (coordinates(&["PA", "Z"]), direction()).prop_map(|(at, d)| format!("CP{at} {d}")),
        1 => coordinates(&["PR", "PA"]).prop_map(|at| format!("CTP{at}")),
        1 => (proptest::sample::select(vec!["X", "IY", "Z", "IC"]), number(), proptest::sample::select(vec!["", " R+", " R-", " R0"]), tail())
            .prop_map(|(axis, at, along, tail)| format!("{axis}{at}{along}{}", if along.is_empty() { tail } else { " F250 M8".to_owned() })),
        1 => number().prop_map(|at| format!("X{at} R+ FMAX")),
        1 => number().prop_map(|r| format!("RND R{r} F100")),
        1 => number().prop_map(|r| format!("CHF {r}")),
        1 => (1..99_u8, number()).prop_map(|(t, dl)| format!("TOOL CALL {t} Z S2000 F100 DL{dl} DR2+0.1")),
        1 => Just("TOOL CALL \"A B\" Y S+Q3".to_owned()),
        1 => Just("TOOL CALL S1000".to_owned()),
        1 => number().prop_map(|l| format!("TOOL DEF 5 L{l} R+3")),
        1 => Just("TOOL DEF 12".to_owned()),
        1 => (1..99_u8).prop_map(|n| format!("LBL {n}")),
        1 => Just("LBL \"A 1\"".to_owned()),
        1 => (1..99_u8).prop_map(|n| format!("CALL LBL {n} REP {n}/{n}")),
        1 => Just("CALL LBL \"A 1\"".to_owned()),
        1 => Just("CALL LBL QS5 REP +Q6".to_owned()),
        1 => (0..5_u8, number(), number()).prop_map(|(op, a, b)| match op {
            0 => format!("FN 0: Q5 = {a}"),
            1 => format!("FN 1: Q5 = {a} + {b}"),
            2 => format!("FN 5: Q5 = SQRT {a}"),
            3 => format!("FN 13: Q5 = {a} ANG {b}"),
            _ => format!("FN 11: IF {a} GT {b} GOTO LBL 7"),
        }),
        1 => Just("FN 14: ERROR = 1000".to_owned()),
        1 => Just("FN 18: SYSREAD Q5 = ID210 NR4 IDX+Q3".to_owned()),
        1 => Just("FN 26: TABOPEN TNC:\\A.TAB".to_owned()),
        1 => number().prop_map(|a| format!("Q1 = ( Q2 + 3 ) * SIN {a}")),
        1 => Just("QS1 = \"a;b\" || QS2".to_owned()),
        1 => Just("CALL PGM TNC:\\A\\B.H".to_owned()),
        1 => Just("SEL TABLE \"A.D\"".to_owned()),
        1 => Just("CALL SELECTED PGM".to_owned()),
        1 => Just("CYCL CALL M3".to_owned()),
        1 => coordinates(&["X", "Y", "Z"]).prop_map(|at| format!("CYCL CALL POS{at} F300")),
        1 => Just("CYCL CALL PAT FMAX".to_owned()),
        1 => number().prop_map(|n| format!("CYCL DEF 200 DRILLING ~\n Q200={n} ;CLEARANCE ~\n Q201=-20 ~\n Q206=FAUTO")),
        1 => number().prop_map(|n| format!("TCH PROBE 400 X ~\n Q263={n} ;A ~\n Q264=+5")),
        1 => number().prop_map(|n| format!("CYCL DEF 7.0 DATUM\nCYCL DEF 7.1 X{n}\nCYCL DEF 7.2 IY+5")),
        1 => Just("CYCL DEF 7.0 DATUM\nCYCL DEF 7.1 #5".to_owned()),
        1 => Just("CYCL DEF 8.0 MIRROR\nCYCL DEF 8.1 X Z".to_owned()),
        1 => Just("CYCL DEF 10.0 ROTATION\nCYCL DEF 10.1 IROT-5".to_owned()),
        1 => Just("CYCL DEF 11.0 SCALING\nCYCL DEF 11.1 SCL 0.75".to_owned()),
        1 => Just("CYCL DEF 9.0 DWELL\nCYCL DEF 9.1 V.ZEIT 1.5".to_owned()),
        1 => Just("CYCL DEF 14.0 CONTOUR\nCYCL DEF 14.1 KONTUR 1/2/3".to_owned()),
        1 => Just("CYCL DEF 19.0 PLANE\nCYCL DEF 19.1 A+0 B+45 F500".to_owned()),
        1 => Just("CYCL DEF 32.0 TOLERANCE\nCYCL DEF 32.1 T0.05\nCYCL DEF 32.2 HSC-MODE:1 TA5".to_owned()),
        1 => Just("TCH PROBE 0.0 PLANE Q5 X-\nTCH PROBE 0.1 X+5 Y+0 Z-5".to_owned()),
        1 => Just("PLANE SPATIAL SPA+0 SPB+45 SPC+0 STAY".to_owned()),
        1 => Just("PATTERN DEF POS1( X+10 Y+20 Z+0 )".to_owned()),
        2 => proptest::sample::select(vec![
            "DECLARE CONTOUR QC1 = \"A.H\" DEPTH5", "DECLARE CONTOUR QC2 = LBL 5", "QC10 = ( QC1 | QC3 ) \\ QC2",
            "CONTOUR DEF P1 = \"A.H\" I2 = \"B.H\" DEPTH5", "SEL CONTOUR \"A\"", "SEL PATTERN \"P.PNT\"", "TRANS DATUM AXIS X+10", "TRANS DATUM RESET",
            "FUNCTION TCPM F TCP AXIS POS PATHCTRL AXIS", "FUNCTION MODE TURN", "PLANE RESET STAY", "PLANE VECTOR BX+0 BY+0 BZ+1 NX+0 NY+0 NZ+1 TURN FMAX", "M128 F500",
            "GLOBAL DEF 100 GENERAL ~\n Q200=+2 ;CLEARANCE ~\n Q204=50", "TCH PROBE 444 PROBING IN 3-D ~\n Q263=+0 ;A ~\n QS400=\"1-1\"",
            "SQL SELECT Q5 \"SELECT X FROM T\"", "FN 37: EXPORT Q25", "FN 20: WAIT FOR SYNC", "QL5 = QR3 + 1", "QS1 = SUBSTR( SRC_QS2 BEG0 LEN4 )",
        ]).prop_map(str::to_owned),
        1 => Just("; a comment * with stars **".to_owned()),
        1 => Just("* - a heading".to_owned()),
        1 => Just("STOP M8".to_owned()),
        1 => Just("M30".to_owned()),
    ]
}

/// Words of DIN/ISO that say where a movement goes, the codes for incremental and absolute values among them.
fn words(names: &'static [&'static str], counts: std::ops::Range<usize>) -> impl Strategy<Value = String> {
    let word = (proptest::sample::select(names), proptest::sample::select(vec!["", "", " G90", " G91"]), number());
    proptest::collection::vec(word, counts)
        .prop_map(|words| words.iter().map(|(name, mode, n)| format!("{mode} {name}{n}")).collect())
}

/// A block of DIN/ISO that Klartext has an equivalent of, whatever acts where it stands.
pub(crate) fn iso_block() -> impl Strategy<Value = String> {
    let path = || proptest::sample::select(vec!["", "G00", "G01", "G1 G90", "G01 G91"]);
    let comp = || proptest::sample::select(vec!["", " G40", " G41", " G42"]);
    let end = || proptest::sample::select(vec!["", " F300", " FQ5", " M3", " F50 M8 M13", " M99"]);
    prop_oneof![
        4 => (path(), comp(), words(LINEAR, 1..4), end()).prop_map(|(g, c, at, end)| format!("{g}{c}{at}{end}")),
        1 => (proptest::sample::select(vec!["G02", "G03"]), words(PLANE, 1..3), end())
            .prop_map(|(g, at, end)| format!("{g}{at}{end}")),
        1 => (number(), number(), words(PLANE, 1..3), proptest::sample::select(vec!["G02", "G03"]))
            .prop_map(|(i, j, at, g)| format!("I{i} J{j} {g}{at}")),
        1 => (proptest::sample::select(vec!["G02", "G03", "G05"]), words(PLANE, 1..3), number())
            .prop_map(|(g, at, r)| format!("G03 X+1 R+5 *\n{g}{at} R{r}")),
        1 => (words(PLANE, 1..3), end()).prop_map(|(at, end)| format!("G06{at}{end}")),
        1 => (proptest::sample::select(vec!["X", "Y", "Z", "B"]), number(), proptest::sample::select(vec!["", " G43", " G44", " G40"]))
            .prop_map(|(axis, at, along)| format!("G07{along} {axis}{at} F200 *\nG01")),
        1 => (proptest::sample::select(vec!["G10", "G11"]), words(&["R", "H", "Z"], 1..3)).prop_map(|(g, at)| format!("{g}{at}")),
        1 => (proptest::sample::select(vec!["G12", "G13"]), words(&["H", "Z"], 1..2)).prop_map(|(g, at)| format!("{g}{at}")),
        1 => words(&["R", "H"], 1..3).prop_map(|at| format!("G16{at}")),
        1 => words(&["I", "J", "K"], 1..3).prop_map(|at| at.trim().to_owned()),
        1 => Just("G29".to_owned()),
        1 => number().prop_map(|n| format!("G24 R{n}")),
        1 => number().prop_map(|n| format!("G25 R{n} F20")),
        1 => proptest::sample::select(vec!["G90", "G91", "G17", "G18", "G19", "G71", "G40"]).prop_map(str::to_owned),
        1 => (1..99_u8, number()).prop_map(|(t, dl)| format!("T{t} G17 S1000 F200 DL{dl} DR2+0.5 M3")),
        1 => Just("S500".to_owned()),
        1 => Just("G51 T5".to_owned()),
        1 => Just("G99 T7 L+10 R+2".to_owned()),
        1 => (1..99_u8, 0..9_u8).prop_map(|(l, n)| format!("G98 L{l} *\nL{l},{n}")),
        1 => Just("G98 L\"A\" *\nL\"A\",2".to_owned()),
        1 => (0..9_u8, number(), number()).prop_map(|(op, a, b)| match op {
            0 => format!("D00 Q5 P01 {a}"),
            1 => format!("D01 Q5 P01 {a} P02 {b}"),
            2 => format!("D2 Q5 P01 {a} P02 {b}"),
            3 => format!("D03 Q5 P01 {a} P02 {b}"),
            4 => format!("D04 Q5 P01 {a} P02 {b}"),
            5 => format!("D06 Q5 P01 {a}"),
            6 => format!("D08 Q5 P01 {a} P02 {b}"),
            7 => format!("D12 P01 {a} P02 {b} P03 5"),
            _ => format!("D10 P01 {a} P02 {b} P03 \"A\""),
        }),
        1 => proptest::sample::select(vec![
            "D14 P01 1000", "D18 Q25 ID210 NR4 IDX3", "D19 P01 +10 P02 +Q3", "D20: WAIT FOR SYNC", "D26: TABOPEN TNC:\\T.TAB",
            "D29 P01 1 P02 2", "D37: EXPORT Q5", "%:TAB: \"A.D\"", "%:PAT: \"A.PNT\"", "%:CNT: \"A.H\"", "%:PGM: \"A.I\"", "%<>%", "%TNC:\\A.I", "G38 M8", "M30",
            "G79 M3", "G79 \"PAT\" F500", "G79:G01 X+10 Y+20 Z+5 F400", "G04 F1.5", "G28 X Y", "G36 S90", "G37 P01 1 P02 2",
            "G39 P01 \"A.H\"", "G53 P01 12", "G54 G90 X+25 Y-12.5", "G54 G91 X+25", "G55 P01 10 P02 X- P03 X+25 P04 Y+10 P05 Z-20", "G62 T0.05 P01 0 P02 5",
            "G72 F0.98", "G73 G90 H+25", "G73 G91 H+25", "G80 A+0 B+45 C+0", "G200 Q200=2 Q201=-20 Q206=150",
            "G203 UNIVERSAL DRILLING\nQ200=+2 ;SET-UP CLEARANCE\nQ201=-20 ;DEPTH\nQ206=FAUTO", "G410 Q321=+50 Q322=+50", "; a comment", "Q1 = Q2 + 5", "* - a heading",
        ]).prop_map(str::to_owned),
    ]
}
