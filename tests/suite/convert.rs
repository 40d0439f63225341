//! Programs for another control: what the other control then says of them, that they come back, and that they do the same.
use std::collections::BTreeMap;

use ciklo::base::diag::{Arg, Severity, Source};
use ciklo::base::expr::QRef;
use ciklo::check::{Against, LabelBook, check};
use ciklo::engine::run::{Engine, Event, EventKind, Status};
use ciklo::language::label::{self, Request as BlockRequest};
use ciklo::program::syntax::encoding::{Charset, Encoding};
use ciklo::program::syntax::{Program, functions, parse};
use ciklo::spec::OnControl;
use ciklo::tools::compare::compare;
use ciklo::tools::conform::{LogTexts, World, executed};
use ciklo::tools::convert::{Conversion, Form, Request, convert};

use crate::built;
use built::{Built, built};

const UTF_8: Encoding = Encoding { charset: Charset::Utf8, bom: false };

impl Built {
    fn books(&self) -> BTreeMap<&str, LabelBook<'_>> {
        self.catalogue.controls.iter().map(|(id, on)| (id.as_str(), LabelBook::new(on, &self.locales))).collect()
    }

    fn against<'a>(&'a self, books: &'a BTreeMap<&str, LabelBook<'a>>, control: &str) -> Against<'a> {
        let on = self.catalogue.on(control).expect("the control");
        Against {
            catalogue: &self.catalogue,
            on,
            labels: &books[control],
            language: None,
            software: None,
            readers: &[],
        }
    }

    fn convert(
        &self,
        books: &BTreeMap<&str, LabelBook<'_>>,
        (from, to): (&str, &str),
        form: Form,
        text: &str,
    ) -> Conversion {
        let (from, to) = (self.against(books, from), self.against(books, to));
        convert(&program(text), &Request { from, to, locales: &self.locales, form, encoding: UTF_8 })
    }

    /// A program that defines a cycle as the control's manual prints it.
    fn definition(&self, on: &OnControl, cycle: &ciklo::spec::Cycle) -> Option<String> {
        let language = self.locales.language(on.control.language.as_str()).expect("its language");
        let block = label::block(on, cycle, language, &BlockRequest { number: Some(2), ..BlockRequest::default() });
        Some(format!("0 BEGIN PGM A MM\n1 TOOL CALL 1 Z S1000\n{}9 END PGM A MM\n", block.ok()?))
    }
}

/// Examples that move otherwise on another control by what its manual says: the TNC 640 goes on beyond the first side of
/// a slot only as far as it must, and how often a point is measured stands in data that each control names otherwise.
const OTHERWISE: [&str; 5] = [
    "TCH PROBE 425 slot-within-limits",
    "TCH PROBE 425 slot-too-wide-in-y",
    "TCH PROBE 425 log-",
    "TCH PROBE 427 measured-three-times",
    "TCH PROBE 427 probe-data-of-machine-parameters",
];

fn program(text: &str) -> Program {
    parse(&Source::new("program.h", text))
}

fn codes(conversion: &Conversion) -> Vec<(&'static str, Severity)> {
    conversion.found.iter().map(|found| (found.code, found.severity)).collect()
}

/// All pairs of different controls.
fn pairs(data: &Built) -> Vec<(&str, &str)> {
    let ids: Vec<&str> = data.catalogue.controls.keys().map(String::as_str).collect();
    ids.iter().flat_map(|from| ids.iter().map(move |to| (*from, *to))).filter(|(from, to)| from != to).collect()
}

/// What a control objects to in the shape of a definition.
const SHAPE: [&str; 9] = [
    "unknown-parameter",
    "missing-parameter",
    "duplicate-parameter",
    "misordered-parameter",
    "unknown-cycle",
    "cycle-not-covered",
    "cycle-not-on-control",
    "label-of-another-language",
    "label-of-another-parameter",
];

#[test]
fn the_other_control_finds_its_own_definition() {
    let data = built();
    let books = data.books();
    let (mut converted, mut refused) = (0, 0);
    for (from, to) in pairs(data) {
        let (own, other) = (data.catalogue.controls.get(from).expect("a control"), data.against(&books, to));
        for cycle in own.cycles.values() {
            let Some(text) = data.definition(own, cycle) else { continue };
            let conversion = data.convert(&books, (from, to), Form::AsWritten, &text);
            if codes(&conversion).iter().any(|(_, severity)| *severity == Severity::Error) {
                refused += 1;
                assert!(conversion.edits.len() <= 1, "{from} → {to} {}", cycle.key);
                continue;
            }
            // What its manual does not describe cannot be judged.
            if !other.on.cycles.contains_key(&cycle.key) {
                continue;
            }
            converted += 1;
            let mut against = other;
            against.language = Some(own.control.language.as_str());
            let found = check(&program(&conversion.text), &against);
            // What the printed block leaves out is missing on both.
            let left_out = |found: &ciklo::base::diag::Diagnostic| match found.get("parameter") {
                Some(Arg::Text(name)) => QRef::parse(name).is_some_and(|q| cycle.param(q).is_some()),
                _ => false,
            };
            let own = |found: &&ciklo::base::diag::Diagnostic| found.code == "missing-parameter" && left_out(found);
            let shape = found.iter().filter(|found| SHAPE.contains(&found.code));
            let objections: Vec<_> = shape.filter(|found| !own(found)).collect();
            assert!(objections.is_empty(), "{from} → {to}\n{}\n{objections:#?}", conversion.text);
        }
    }
    assert!(converted > 250 && refused > 80, "{converted} converted, {refused} refused");
}

/// A manual that treats touch probes only does not prove that its control has no drilling cycles; one that lists them all does.
#[test]
fn cycles_that_a_manual_does_not_treat_are_not_denied() {
    let data = built();
    let books = data.books();
    let own = data.catalogue.controls.get("tnc640").expect("a control");
    let definition = |name: &str| data.definition(own, own.by_name(name).expect("the cycle")).expect("its block");
    let drilling = definition("drilling");
    for (to, expected) in [
        ("tnc320", ("convert-cycle-not-covered", Severity::Warning)),
        ("tnc426-430", ("convert-cycle-not-covered", Severity::Warning)),
    ] {
        let there = data.convert(&books, ("tnc640", to), Form::AsWritten, &drilling);
        assert_eq!((codes(&there), there.text.as_str()), (vec![expected], drilling.as_str()), "{to}");
        let back = data.convert(&books, (to, "tnc640"), Form::AsWritten, &drilling);
        assert_eq!((codes(&back), back.text.as_str()), (vec![expected], drilling.as_str()), "{to}");
    }
    // The manual of the TNC 320 lists all its probing cycles, and 444 is not among them.
    let probing = definition("probing-3d");
    let there = data.convert(&books, ("tnc640", "tnc320"), Form::AsWritten, &probing);
    assert_eq!(codes(&there), [("convert-cycle-not-on-control", Severity::Error)]);
}

#[test]
fn what_lost_nothing_comes_back() {
    let data = built();
    let books = data.books();
    let mut came_back = 0;
    for (from, to) in pairs(data) {
        let (own, against) = (data.catalogue.controls.get(from).expect("a control"), data.against(&books, from));
        for cycle in own.cycles.values() {
            let Some(text) = data.definition(own, cycle) else { continue };
            let there = data.convert(&books, (from, to), Form::AsWritten, &text);
            // Added with a value that only the older control's programs have, or dropped: it is another program.
            if codes(&there).iter().any(|(_, severity)| *severity > Severity::Note) {
                continue;
            }
            let back = data.convert(&books, (to, from), Form::AsWritten, &there.text);
            let differences = compare(&program(&text), &program(&back.text), &against);
            assert!(differences.is_empty(), "{from} → {to} → {from}\n{text}\n{}\n{}", there.text, back.text);
            came_back += 1;
        }
    }
    assert!(came_back > 200, "{came_back}");
}

#[test]
fn everything_between_definitions_keeps_its_bytes() {
    let data = built();
    let books = data.books();
    let text = "\u{feff}0  BEGIN PGM A MM\r\n;Q200=2 here\r\n\r\n1 TOOL CALL 1 Z S1000\r\n2  TCH PROBE 425 URAN ~\r\n\t\
        Q328=+75 ;own words ~\r\n\tQ329=-12.5 ; X~\r\n\tQ310=+0 ;\t ~\r\n\tQ272=1 ~\r\n\tQ261=-5~\r\n\tQ260=+10 ~\r\n\t\
        Q311=+25 ~\r\n\tQ288=+25.05 ~\r\n\tQ289=+25 ~\r\n\tQ281=+1 ~\r\n\tQ309=+0 ~\r\n\tQ330=+0 ;x\r\n\
        L  X+1   R0 FMAX ; y\r\n4 END PGM A MM";
    let there = data.convert(&books, ("tnc320", "tnc640"), Form::AsWritten, text);
    // The TNC 640 has Q320 and Q301 in addition, behind Q330 (001: 13212-13234).
    let (head, tail) = text.split_once(";x\r\n").expect("the last parameter");
    assert!(there.text.starts_with(&format!("{head};x ~\r\n\tQ320=0 ;")), "{}", there.text);
    assert!(there.text.ends_with(tail), "{}", there.text);
    assert_eq!(codes(&there), [("convert-parameter-added", Severity::Note); 2]);
    let back = data.convert(&books, ("tnc640", "tnc320"), Form::AsWritten, &there.text);
    assert_eq!(back.text, text);
    assert_eq!(codes(&back), [("convert-parameter-dropped", Severity::Note); 2]);
}

#[test]
fn older_programs_get_what_the_control_writes_when_it_reads_them() {
    let data = built();
    let books = data.books();
    let own = data.catalogue.controls.get("tnc426-430").expect("a control");
    let cycle = own.by_name("datum-inside-circle").expect("the cycle");
    let text = data.definition(own, cycle).expect("its block");
    let there = data.convert(&books, ("tnc426-430", "tnc640"), Form::AsWritten, &text);
    // Q303 = −1: the transfer of the measured value is not defined in programs of the TNC 4xx (001: 11216-11232).
    assert!(there.text.contains("Q303=-1 ;"), "{}", there.text);
    assert!(codes(&there).contains(&("convert-parameter-added", Severity::Warning)));
}

#[test]
fn tool_measurement_changes_its_form_and_comes_back() {
    let data = built();
    let books = data.books();
    let old = "0 BEGIN PGM A MM\n1 TOOL CALL 1 Z\n2 TCH PROBE 33.0 MERITEV ORODJA\n3 TCH PROBE 33.1 PREVERITE: 1 Q5\n4 TCH PROBE 33.2 VIŠINA: +120\n5 TCH PROBE 33.3 MERITEV REZIL: 1\n6 END PGM A MM\n";
    let new = data.convert(&books, ("tnc640", "tnc640"), Form::New, old);
    assert_eq!(codes(&new), [("convert-form", Severity::Note)]);
    // The values of the four lines; the result, which the new form leaves in Q199, goes on to Q5.
    for part in ["2 TCH PROBE 483 ", "Q340=1 ;", "Q260=+120 ;", "Q341=1 ;", "3 FN 0: Q5 = +Q199\n6 END PGM"] {
        assert!(new.text.contains(part), "{part}\n{}", new.text);
    }
    let back = data.convert(&books, ("tnc640", "tnc640"), Form::Old, &new.text);
    for part in ["2 TCH PROBE 33.0 ", "33.1 ", ": 1 Q199\n", ": +120\n", ": 1\n"] {
        assert!(back.text.contains(part), "{part}\n{}", back.text);
    }
    // A comment between the lines would be lost.
    let commented = old.replace("+120\n", "+120 ;high\n");
    let stays = data.convert(&books, ("tnc640", "tnc640"), Form::New, &commented);
    assert_eq!(stays.text, commented);
    assert_eq!(codes(&stays), [("convert-form-stays", Severity::Error)]);
}

/// What a machine does of an event: movements, touches, spindle, coolant and waiting; not the parameters, tables and logs
/// of a control.
fn does(kind: &EventKind) -> Option<String> {
    let printed = format!("{kind:?}");
    let head = printed.split([' ', '(']).next().unwrap_or_default();
    ["Move", "Probe", "Spindle", "Dwell", "Coolant", "Orient", "Touch"].contains(&head).then_some(printed)
}

#[test]
fn converted_examples_move_the_same() {
    let data = built();
    let books = data.books();
    let world = World { catalogue: &data.catalogue, locales: &data.locales, files: &data.files };
    let (mut same, mut differ) = (0, Vec::new());
    for (from, to) in [("tnc640", "tnc320"), ("tnc320", "tnc640"), ("tnc426-430", "tnc640"), ("itnc530", "tnc640")] {
        for case in executed(&world, &[from]) {
            let there = data.convert(&books, (from, to), Form::AsWritten, case.program.text());
            if codes(&there).iter().any(|(_, severity)| *severity > Severity::Note) {
                continue;
            }
            let run = |on: &OnControl, text: &str| {
                let language = data.locales.language(on.control.language.as_str()).expect("its language");
                let texts = LogTexts::new(language, on.id(), &data.files);
                let program = program(text);
                let mut events = Vec::new();
                let engine = Engine::new(&program, on, &case.scene, &texts).with_catalogue(&data.catalogue);
                let outcome = engine.run(&mut |event: Event| events.extend(does(&event.kind)));
                (outcome.status, events)
            };
            let other = data.catalogue.on(to).expect("the control");
            let (a, b) = (run(case.on, case.program.text()), run(other, &there.text));
            // What stops one of them is another rule of the control, not another movement.
            if a.0 != Status::Done || b.0 != Status::Done {
                continue;
            }
            if a == b {
                same += 1;
            } else {
                differ.push(format!("{} {}", case.cycle.key, case.name));
            }
        }
    }
    let unexplained: Vec<_> = differ.iter().filter(|name| !OTHERWISE.iter().any(|own| name.starts_with(own))).collect();
    assert!(unexplained.is_empty(), "{unexplained:#?}");
    assert!(OTHERWISE.iter().all(|own| differ.iter().any(|name| name.starts_with(own))), "{differ:#?}");
    assert!(same > 250, "{same}");
}

/// A program with every function that a profile names, and some that none does.
const FUNCTIONS: &str = "0 BEGIN PGM A MM\n1 TOOL CALL \"T1\" Z S1000\n2 CYCL CALL PAT FMAX\n3 CYCL CALL POS X+1 Y+1 Z+0 FMAX\n\
    4 GLOBAL DEF 100 ALLG. ~\n    Q200=+2 ;A\n5 PATTERN DEF POS1 (X+1 Y+1 Z+0)\n6 SEL PATTERN \"P.PNT\"\n7 SEL TABLE \"D.D\"\n\
    8 SEL CONTOUR \"C\"\n9 DECLARE CONTOUR QC1 = \"A.H\"\n10 QC2 = QC1\n11 CONTOUR DEF P1 = \"A.H\"\n12 FL AN+60\n13 FPOL X+1 Y+1\n\
    14 FC DR- R30\n15 FSELECT 1\n16 PLANE SPATIAL SPA+0 SPB+90 SPC+0 TURN FMAX\n17 PLANE RESET STAY\n18 FUNCTION MODE TURN\n\
    19 FUNCTION TURNDATA SPIN VCONST:ON VC:150\n20 FUNCTION TCPM F TCP AXIS POS PATHCTRL AXIS\n21 FUNCTION RESET TCPM\n22 M128\n\
    23 FN 17: SYSWRITE ID 990 NR 6 =+1\n24 QL1 = QL2 + 1\n25 QS1 = \"a\" || QS2\n26 L X+1 M103 F5\n27 L X+1 M109\n28 L X+1 M110\n\
    29 L X+1 M120 LA5\n30 L X+1 M130\n31 M136\n32 M137\n33 L Z+1 M140 MB MAX\n34 M144\n35 M116\n36 TRANS DATUM AXIS X+10\n\
    37 LBL \"A\"\n38 CALL LBL \"A\" REP 2\n39 QR1 = 5 ;QL7 in a comment\n40 L X+1 FU0.1\n41 PLANE VECTOR BX0 BY0 BZ1 NX0 NY0 NZ1 STAY\n\
    42 APPR LCT X+1 Y+1 R5 RL\n43 L X+2\n44 DEP LT LEN5\n45 QS3 = SUBSTR( SRC_QS1 BEG0 LEN2 )\n46 LBL 5\n47 L X+1 Y+2 R0 FMAX M99\n\
    48 M3\n49 CYCL CALL\n50 FN 0: Q1 = +5\n51 Q2 = SIN 5\n52 Q5 SET UNDEFINED\n53 END PGM A MM\n";

/// Every function that the other control's manual does not show is told once with its number of uses, and what is shown and
/// what every control has is not.
#[test]
fn functions_that_a_manual_does_not_show_are_told() {
    let data = built();
    let books = data.books();
    let own = program(FUNCTIONS);
    assert!(own.diagnostics().is_empty(), "{:#?}", own.diagnostics());
    let used: std::collections::BTreeSet<String> =
        own.blocks().iter().flat_map(|block| functions(&own, block)).map(|(name, _)| name).collect();
    // What a profile names is found in programs: no entry is misspelt.
    for on in data.catalogue.controls.values() {
        for shown in on.control.functions.iter().flat_map(|shown| &shown.function) {
            assert!(used.contains(shown), "{} {shown}\n{used:?}", on.id());
        }
    }
    for (from, to) in pairs(data) {
        let conversion = data.convert(&books, (from, to), Form::AsWritten, FUNCTIONS);
        let told: BTreeMap<String, &str> = conversion
            .found
            .iter()
            .filter_map(|found| match found.get("function") {
                Some(Arg::Text(name)) => Some((name.to_string(), found.code)),
                _ => None,
            })
            .collect();
        let profile = &data.catalogue.controls.get(to).expect("a control").control.functions;
        for name in &used {
            let shown = profile.iter().find(|shown| shown.function.contains(name));
            let expected = match shown {
                None => Some("convert-function-not-shown"),
                Some(shown) => shown.option.map(|_| "convert-function-option"),
            };
            assert_eq!(told.get(name).copied(), expected, "{from} → {to} {name}");
        }
        assert_eq!(conversion.text, FUNCTIONS);
    }
    // 42 and 44, 37 and 38, 20 and 21, 24 (twice): what a reader counts.
    let conversion = data.convert(&books, ("tnc640", "tnc426-430"), Form::AsWritten, FUNCTIONS);
    let count = |name: &str| {
        let own = conversion
            .found
            .iter()
            .find(|found| matches!(found.get("function"), Some(Arg::Text(own)) if **own == *name));
        own.and_then(|found| match found.get("count") {
            Some(Arg::Number(count)) => Some(*count),
            _ => None,
        })
    };
    let expected = [
        ("LBL \"…\"", 2.0),
        ("FUNCTION TCPM", 2.0),
        ("QL", 2.0),
        ("TRANS DATUM", 1.0),
        ("APPR LCT", 1.0),
        ("QR", 1.0),
        ("SET UNDEFINED", 1.0),
    ];
    for (name, number) in expected {
        assert_eq!(count(name), Some(number), "{name}");
    }
    assert_eq!(count("M99"), None);
}
