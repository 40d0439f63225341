//! NC blocks, labels and dialogs: the printed blocks of the manuals byte for byte, values that are
//! refused, and what a dialog says.
use std::path::Path;
use std::sync::LazyLock;

use ciklo::base::data;
use ciklo::base::expr::QRef;
use ciklo::language::label::{self, Request};
use ciklo::language::locale::Locales;
use ciklo::output::dialog;
use ciklo::spec::{Catalogue, Cycle, CycleKey, Entries, Field, Keyword, Name, NcExample, OnControl, Shape};
use proptest::prelude::*;

use crate::built::{Built, built};

struct Data {
    catalogue: Catalogue,
    locales: Locales,
}

impl Data {
    /// The small catalogue of `tests/small`, with the texts that do not belong to cycles.
    fn small() -> &'static Self {
        static SMALL: LazyLock<Data> = LazyLock::new(|| {
            let mut files = Vec::new();
            let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/small");
            collect(&root, &root, &mut files);
            let general = ["locales/en/text.ftl", "locales/en/units.ftl"];
            files.extend(data::embedded().into_iter().filter(|(path, _)| general.contains(&path.as_str())));
            Data::of(files)
        });
        &SMALL
    }

    fn of(files: Vec<(String, String)>) -> Self {
        let (catalogue, _) = Catalogue::load(&files);
        let (locales, _) = Locales::load(files);
        Self { catalogue, locales }
    }

    fn on(&self, control: &str) -> &OnControl {
        self.catalogue.on(control).unwrap_or_else(|| panic!("no control {control}"))
    }
}

fn collect(root: &Path, directory: &Path, files: &mut Vec<(String, String)>) {
    for entry in std::fs::read_dir(directory).expect("the directory is there") {
        let path = entry.expect("it can be read").path();
        if path.is_dir() {
            collect(root, &path, files);
        } else {
            let name = path.strip_prefix(root).expect("it is below").to_string_lossy().into_owned();
            files.push((name, std::fs::read_to_string(&path).expect("it is text")));
        }
    }
}

fn small_cycle(data: &Data, number: u32) -> &Cycle {
    data.on("small").cycles.get(&CycleKey::new(Keyword::CyclDef, number)).expect("a cycle")
}

fn block(number: u32, values: &[(&str, &str)], first: Option<u32>) -> Result<String, Vec<String>> {
    let data = Data::small();
    let values: Vec<(String, String)> = values.iter().map(|(k, v)| ((*k).to_owned(), (*v).to_owned())).collect();
    let request = Request { values: &values, number: first, ..Request::default() };
    let language = data.locales.language("en").expect("English is there");
    let result = label::block(data.on("small"), small_cycle(data, number), language, &request);
    result.map_err(|faults| faults.iter().map(|fault| fault.code.to_owned()).collect())
}

#[test]
fn a_block_shows_given_values_as_the_example_is_written() {
    assert_eq!(
        block(901, &[("q201", "-5.5"), ("QS204", "CD"), ("Q202", "PREDEF")], None).as_deref(),
        Ok("11 CYCL DEF 901 PECKING\nQ201=-5.5 ;DEPTH\nQ202=PREDEF ;MODE\nQ203=5 ;STEP DOWN\nQS204=\"CD\" ;NAME\n")
    );
}

#[test]
fn a_block_of_the_old_form_has_a_number_for_each_line() {
    assert_eq!(
        block(9, &[("angle", "I45"), ("height", "100")], Some(20)).as_deref(),
        Ok("20 CYCL DEF 9.0 TURNING ROUND Q5\n21 CYCL DEF 9.1 IROT+45\n22 CYCL DEF 9.2 HEIGHT: +100\n")
    );
}

#[test]
fn values_that_the_control_would_not_take_are_refused_together() {
    /// Values given, and the codes of their refusal.
    type Case = (&'static [(&'static str, &'static str)], &'static [&'static str]);
    let cases: &[Case] = &[
        (&[("Q201", "1")], &["block-above-maximum"]),
        (&[("Q201", "-100000")], &["block-below-minimum"]),
        (&[("Q201", "deep"), ("Q999", "1")], &["block-wrong-kind", "block-unknown-parameter"]),
        (&[("Q202", "-1")], &["block-not-offered"]),
        (&[("Q202", "1.5")], &["block-wrong-kind"]),
        (&[("Q203", "1"), ("q203", "2")], &["block-duplicate-parameter"]),
        (&[("QS204", "ABCDEF")], &["block-too-long"]),
        (&[("QS204", "\"A")], &["block-wrong-kind"]),
    ];
    for (values, codes) in cases {
        assert_eq!(block(901, values, None), Err(codes.iter().map(|code| (*code).to_owned()).collect()), "{values:?}");
    }
}

fn block_of_640(number: u32, keyword: Keyword, values: &[(&str, &str)]) -> Result<String, Vec<String>> {
    let data = built();
    let on = data.catalogue.on("tnc640").expect("the control");
    let values: Vec<(String, String)> = values.iter().map(|(k, v)| ((*k).to_owned(), (*v).to_owned())).collect();
    let request = Request { values: &values, ..Request::default() };
    let language = data.locales.language("en").expect("English is there");
    let result = label::block(on, on.cycles.get(&CycleKey::new(keyword, number)).expect("a cycle"), language, &request);
    result.map_err(|faults| faults.iter().map(|fault| fault.code.to_owned()).collect())
}

#[test]
fn a_name_stands_in_the_text_parameter_of_its_number() {
    let line = |values: &[(&str, &str)]| -> Result<String, Vec<String>> {
        let block = block_of_640(450, Keyword::TchProbe, values)?;
        Ok(block.lines().nth(2).unwrap_or_default().split(' ').next().unwrap_or_default().to_owned())
    };
    let cases: &[(&str, &str, Result<&str, &str>)] = &[
        ("Q409", "5", Ok("Q409=5")),
        ("Q409", "\"CD\"", Ok("QS409=\"CD\"")),
        ("qs409", "CD", Ok("QS409=\"CD\"")),
        ("QS409", "5", Ok("QS409=\"5\"")),
        ("QS409", "QS7", Ok("QS409=QS7")),
        ("Q409", "QS7", Ok("QS409=QS7")),
        ("Q409", "CD", Err("block-wrong-kind")),
        ("QS409", "ABCDEFGHIJKLMNOPQ", Err("block-too-long")),
    ];
    for (name, value, expected) in cases {
        let expected = expected.map(str::to_owned).map_err(|code| vec![code.to_owned()]);
        assert_eq!(line(&[(*name, *value)]), expected, "{name}={value}");
    }
    assert_eq!(line(&[("Q409", "5"), ("QS409", "CD")]), Err(vec!["block-duplicate-parameter".to_owned()]));
}

#[test]
fn each_label_of_a_list_is_looked_at() {
    let cases: &[(&str, Option<&str>)] = &[
        ("7", None),
        ("1/254", None),
        ("1/2/3/4/5/6/7/8/9/10/11/12", None),
        ("1/2/3/4/5/6/7/8/9/10/11/12/13", Some("block-too-long")),
        ("0/1", Some("block-below-minimum")),
        ("1/255", Some("block-above-maximum")),
        ("1/2.5", Some("block-wrong-kind")),
        ("1//2", Some("block-wrong-kind")),
        ("1/EDGE", Some("block-wrong-kind")),
        ("", Some("block-wrong-kind")),
    ];
    for (labels, code) in cases {
        let found = block_of_640(14, Keyword::CyclDef, &[("labels", labels)]).err();
        assert_eq!(found, code.map(|code| vec![code.to_owned()]), "{labels}");
    }
}

#[test]
fn values_known_only_when_the_program_runs_are_taken() {
    for value in ["Q1", "-Q1", "QL5"] {
        assert!(block(901, &[("Q203", value)], None).is_ok(), "{value}");
    }
    assert!(block(901, &[("Q202", "7")], None).is_ok(), "a choice may be a comparison");
}

laws! {
    #![proptest_config(crate::cases::config(256))]

    /// Whatever is given as a value, a block is refused or has a line for each parameter.
    #[test]
    fn no_value_breaks_the_lines_of_a_block(name in "(Q20[0-4]|QS204|q201)", value in any::<String>()) {
        if let Ok(text) = block(901, &[(&name, &value)], None) {
            prop_assert_eq!(text.lines().count(), 5);
        }
    }

    /// Every number of the range is taken as it is written, and every other one is refused.
    #[test]
    fn ranges_are_inclusive(hundredths in -2000_i32..=2000) {
        let value = format!("{}", f64::from(hundredths) / 100.0);
        let taken = block(901, &[("Q203", &value)], None).is_ok_and(|text| text.contains(&format!("Q203={value} ;")));
        prop_assert_eq!(taken, (0..=1000).contains(&hundredths));
    }
}

#[test]
fn a_dialog_asks_in_the_order_of_the_block_and_says_all_there_is() {
    let data = Data::small();
    let language = data.locales.language("en").expect("English is there");
    let dialog = dialog::dialog(data.on("small"), small_cycle(data, 901), language).expect("all texts are there");
    let shown = dialog::render(&dialog, language).expect("all captions are there");
    assert_eq!(shown, include_str!("../small/dialog-901.txt"));
}

#[test]
fn label_tables_quote_what_csv_must_quote() {
    let data = Data::small();
    let language = data.locales.language("en").expect("English is there");
    let mut rows = label::table(data.on("small"), language).expect("all texts are there");
    rows[0].name = "say \"this\", now".to_owned();
    let csv = label::csv(&rows);
    let mut lines = csv.split("\r\n");
    assert_eq!(lines.next(), Some("q,concept,cycle,name,label,aliases"));
    assert_eq!(lines.next(), Some("9.0 result,result-number,CYCL DEF 9,\"say \"\"this\"\", now\",,"));
    assert_eq!(lines.nth(2), Some("Q201,depth,CYCL DEF 901,Depth,DEPTH,DPTH"));
}

#[test]
fn labels_are_checked_for_characters_case_and_length() {
    let data = Data::small();
    let mut files = vec![("locales/en/small.ftl".to_owned(), String::new())];
    files[0].1 =
        std::fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/small/locales/en/small.ftl"))
            .expect("it is there")
            .replace(".label = DEPTH", ".label = DEPTH → DOWN")
            .replace(".label = MODE", ".label = Mode")
            .replace(".label = STEP DOWN", ".label = STEP DOWN, STEP BY STEP");
    let (locales, _) = Locales::load(files);
    let codes: Vec<&str> = label::check(&data.catalogue, &locales).iter().map(|found| found.code).collect();
    assert_eq!(codes, ["label-character", "label-lower-case", "label-too-long"]);
}

#[test]
fn prompts_and_names_of_cycles_are_checked_for_length() {
    let data = Data::small();
    let read =
        |path: &str| std::fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join(path)).expect("it is there");
    let (text, general) = (read("tests/small/locales/en/small.ftl"), read("locales/en/text.ftl"));
    let found = |from: &str, to: &str| -> Vec<String> {
        assert!(text.contains(from), "{from}");
        let files = [("locales/en/small.ftl", text.replace(from, to)), ("locales/en/text.ftl", general.clone())];
        let (locales, _) = Locales::load(files);
        let found = label::check(&data.catalogue, &locales);
        found.iter().map(|found| format!("{} {:?} {:?}", found.code, found.get("key"), found.get("length"))).collect()
    };
    // A sign behind the name makes it a prompt: 30 characters are permitted, 22 in the name of a cycle.
    assert!(found("= Depth\n", "= Depth of all of the ten holes\n").is_empty());
    let long = found("= Depth\n", "= Depth of each of the ten holes\n");
    assert!(!long.is_empty(), "31 characters");
    assert!(
        long.iter().all(|found| found.contains("prompt-too-long")
            && found.contains("parameter-depth")
            && found.contains("31"))
    );
    let printed = found("Which mode? 0/1", "Which of the two modes is it? 0/1");
    assert!(!printed.is_empty() && printed.iter().all(|found| found.contains("parameter-mode.prompt")));
    assert!(
        found(".nc = PECKING", ".nc = PECKING OF MANY HOLES 1").iter().all(|found| found.contains("label-too-long"))
    );
    assert!(!found(".nc = PECKING", ".nc = PECKING OF MANY HOLES 1").is_empty());
    assert!(found(".nc = PECKING", ".nc = PECKING OF MANY HOLES").is_empty());
}

#[test]
fn labels_of_all_data_can_be_printed() {
    let data = built();
    let found = label::check(&data.catalogue, &data.locales);
    let shown: Vec<String> = found.iter().map(|found| format!("{} {:?}", found.code, found.args)).collect();
    assert!(shown.is_empty(), "{shown:#?}");
}

/// The head of a printed block: `; control: tnc640 lang: sl source: 001:1825-1833 form: table`.
fn head(line: &str, key: &str) -> Option<String> {
    let mut words =
        line.split_whitespace().skip_while(|word| word.trim_end_matches(':') != key || !word.ends_with(':'));
    words.nth(1).map(str::to_owned)
}

#[test]
fn printed_blocks_are_reproduced_byte_for_byte() {
    let data = built();
    let directory = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/printed");
    let mut files = Vec::new();
    if directory.is_dir() {
        collect(&directory, &directory, &mut files);
    }
    let mut failures = Vec::new();
    files.sort();
    for (name, text) in &files {
        let (first, body) = text.split_once('\n').expect("a head and a block");
        let control = head(first, "control").expect("the head names the control");
        let language = head(first, "lang").expect("the head names the language");
        match reproduce(data, &control, &language, head(first, "form").as_deref(), body) {
            Reproduced::Exactly | Reproduced::Untranslated => {}
            Reproduced::Not(attempts) => failures.push(format!("{name}:\n{body}--- printed instead:\n{attempts}")),
        }
    }
    assert!(failures.is_empty(), "{}", failures.join("\n"));
}

/// What a head says to be corrected stands in the errata, under the id in brackets.
#[test]
fn corrections_of_printed_blocks_are_recorded() {
    let data = built();
    let directory = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/printed");
    let mut files = Vec::new();
    collect(&directory, &directory, &mut files);
    for (name, text) in &files {
        let Some((_, correction)) = text.lines().next().and_then(|head| head.split_once("corrected: ")) else {
            continue;
        };
        let id = correction.rsplit_once('(').map_or("", |(_, id)| id.trim_end_matches(')'));
        let recorded = data.catalogue.errata.iter().any(|erratum| erratum.id.as_str() == id);
        assert!(recorded, "{name}: cycle-specs/errata.yaml has no {id:?} for {correction:?}");
    }
}

enum Reproduced {
    Exactly,
    Untranslated,
    Not(String),
}

/// Prints every example of the cycle, and then the block with the values that the manual prints.
fn reproduce(data: &Built, control: &str, tag: &str, form: Option<&str>, body: &str) -> Reproduced {
    let on = data.catalogue.on(control).unwrap_or_else(|| panic!("no control {control}"));
    let cycle = on.cycles.values().find(|cycle| {
        let key = cycle.key.to_string();
        body.split_once(&key).is_some_and(|(_, rest)| rest.starts_with([' ', '.']))
    });
    let Some(cycle) = cycle else { return Reproduced::Not("(no such cycle on the control)\n".to_owned()) };
    let language = data.locales.language(tag).expect("the language is there");
    let mut attempts = String::new();
    let as_printed = values_of(cycle, form, body);
    for example in cycle.file.nc_examples.iter().chain([&as_printed]) {
        match label::example(on, cycle, language, example) {
            Ok(printed) if printed == body => return Reproduced::Exactly,
            Ok(printed) => attempts = printed,
            // A language that is still being translated is not held to the manuals.
            Err(_) if data.locales.audit(tag).is_ok_and(|audit| !audit.missing.is_empty()) => {
                return Reproduced::Untranslated;
            }
            Err(faults) => attempts = format!("{faults:?}\n"),
        }
    }
    Reproduced::Not(attempts)
}

/// The number, form and values of a printed block, as an example of the cycle.
fn values_of(cycle: &Cycle, form: Option<&str>, body: &str) -> NcExample {
    let place = cycle.file.place.clone();
    let name = |text: &str| Name { text: text.into(), place: place.clone() };
    let number = body.split(' ').next().and_then(|number| number.parse().ok());
    let mut values: Vec<(Name, String)> = Vec::new();
    let mut without = Vec::new();
    for line in body.lines().filter(|line| line.starts_with('Q')) {
        if let Some((q, (value, _))) = line.split_once('=').and_then(|(q, rest)| Some((q, rest.split_once(" ;")?))) {
            values.push((name(q), value.to_owned()));
        }
    }
    let at = cycle.file.forms.iter().position(|own| form.is_none_or(|form| own.form.as_str() == form)).unwrap_or(0);
    for (_, field) in cycle.fields(at) {
        let printed = printed_values(cycle, field, body);
        if printed.is_empty() {
            without.push(name(field.id.as_str()));
        }
        for (value, turn) in printed.into_iter().zip(1..) {
            let id = field.id.as_str();
            values.push((name(&if turn == 1 { id.to_owned() } else { format!("{id}-{turn}") }), value));
        }
    }
    let values = Entries(values);
    let form = form.map(name);
    NcExample { number, form, values, without, before: Vec::new(), after: Vec::new(), title: None, place }
}

fn printed_values(cycle: &Cycle, field: &Field, body: &str) -> Vec<String> {
    let starts = |line: &str, at: u32| {
        let key = format!("{}.{at} ", cycle.key);
        line.split_once(&key).map(|(_, rest)| rest.to_owned())
    };
    let mut values = Vec::new();
    for at in field.line..=if field.repeat { 99 } else { field.line } {
        let Some(rest) = body.lines().find_map(|line| starts(line, at)) else { break };
        let words: Vec<&str> = rest.split(' ').collect();
        let sign = |word: &&&str| word.starts_with(|c: char| "XYZABC".contains(c)) && word.ends_with(['+', '-']);
        let value = match field.shape {
            Shape::Labelled => {
                let behind_colon = words.iter().skip_while(|word| !word.ends_with(':')).nth(1);
                let last = words.last().filter(|_| words.len() > 1);
                behind_colon.or(last).map(|word| (*word).to_owned())
            }
            Shape::Q => words.iter().find(|word| QRef::parse(word).is_some()).map(|word| (*word).to_owned()),
            Shape::AxisDirection => words.iter().find(sign).map(|word| (*word).to_owned()),
            Shape::Word => {
                let word = field.word.as_deref().unwrap_or_default();
                rest.split_once(word).map(|(before, value)| format!("{before}{value}"))
            }
            _ => Some(rest),
        };
        values.extend(value);
    }
    values
}
