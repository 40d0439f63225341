//! Programs for another control: what the other control then says of them, that they come back, and that they do the same.
use std::collections::BTreeMap;

use ciklo::check::{Against, LabelBook, check};
use ciklo::compare::compare;
use ciklo::conform::{LogTexts, World, executed};
use ciklo::convert::{Conversion, Form, Request, convert};
use ciklo::data;
use ciklo::diag::{Arg, Severity, Source};
use ciklo::engine::run::{Engine, Event, EventKind, Status};
use ciklo::expr::QRef;
use ciklo::label::{self, Request as BlockRequest};
use ciklo::locale::Locales;
use ciklo::spec::{Catalogue, OnControl};
use ciklo::syntax::encoding::{Charset, Encoding};
use ciklo::syntax::{Program, parse};

const UTF_8: Encoding = Encoding { charset: Charset::Utf8, bom: false };

struct Data {
    files: Vec<(String, String)>,
    catalogue: Catalogue,
    locales: Locales,
}

impl Data {
    fn new() -> Self {
        let files: Vec<(String, String)> =
            data::embedded().into_iter().map(|(path, text)| (path.to_string(), text.to_string())).collect();
        let (catalogue, _) = Catalogue::load(&files);
        let (locales, _) = Locales::load(files.iter().map(|(path, text)| (path, text)));
        Self { files, catalogue, locales }
    }

    fn books(&self) -> BTreeMap<&str, LabelBook<'_>> {
        self.catalogue.controls.iter().map(|(id, on)| (id.as_str(), LabelBook::new(on, &self.locales))).collect()
    }

    fn against<'a>(&'a self, books: &'a BTreeMap<&str, LabelBook<'a>>, control: &str) -> Against<'a> {
        let on = self.catalogue.on(control).expect("the control");
        Against { catalogue: &self.catalogue, on, labels: &books[control], language: None, readers: &[] }
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
fn pairs(data: &Data) -> Vec<(&str, &str)> {
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
    let data = Data::new();
    let books = data.books();
    let (mut converted, mut refused) = (0, 0);
    for (from, to) in pairs(&data) {
        let (own, other) = (&data.catalogue.controls[from], data.against(&books, to));
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
            let left_out = |found: &ciklo::diag::Diagnostic| match found.get("parameter") {
                Some(Arg::Text(name)) => QRef::parse(name).is_some_and(|q| cycle.param(q).is_some()),
                _ => false,
            };
            let own = |found: &&ciklo::diag::Diagnostic| found.code == "missing-parameter" && left_out(found);
            let shape = found.iter().filter(|found| SHAPE.contains(&found.code));
            let objections: Vec<_> = shape.filter(|found| !own(found)).collect();
            assert!(objections.is_empty(), "{from} → {to}\n{}\n{objections:#?}", conversion.text);
        }
    }
    assert!(converted > 250 && refused > 100, "{converted} converted, {refused} refused");
}

#[test]
fn what_lost_nothing_comes_back() {
    let data = Data::new();
    let books = data.books();
    let mut came_back = 0;
    for (from, to) in pairs(&data) {
        let (own, against) = (&data.catalogue.controls[from], data.against(&books, from));
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
    let data = Data::new();
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
    let data = Data::new();
    let books = data.books();
    let own = &data.catalogue.controls["tnc426-430"];
    let cycle = own.by_name("datum-inside-circle").expect("the cycle");
    let text = data.definition(own, cycle).expect("its block");
    let there = data.convert(&books, ("tnc426-430", "tnc640"), Form::AsWritten, &text);
    // Q303 = −1: the transfer of the measured value is not defined in programs of the TNC 4xx (001: 11216-11232).
    assert!(there.text.contains("Q303=-1 ;"), "{}", there.text);
    assert!(codes(&there).contains(&("convert-parameter-added", Severity::Warning)));
}

#[test]
fn tool_measurement_changes_its_form_and_comes_back() {
    let data = Data::new();
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
    let data = Data::new();
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
