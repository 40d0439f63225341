//! Another engine put to the cases: one that is right passes, one that is wrong is caught wherever a case looks.
use std::time::Duration;

use ciklo::base::data::{self, Files};
use ciklo::language::locale::Locales;
use ciklo::spec::{Catalogue, Example, Kind};
use ciklo::system::{Answering, NoAnswer};
use ciklo::tools::conform::{self, Answer, Moved, Partner, Report, Selection, Silence, Verdict, World};

const CONTROL: &str = "tnc320";

struct Data {
    files: Files,
    catalogue: &'static Catalogue,
    locales: &'static Locales,
}

impl Data {
    fn new() -> Self {
        let files = data::embedded();
        let catalogue = &crate::built::built().catalogue;
        let locales = &*crate::built::built().locales;
        Self { files, catalogue, locales }
    }

    fn world(&self) -> World<'_> {
        World { catalogue: self.catalogue, locales: self.locales, files: &self.files }
    }

    fn example(&self, case: &conform::CaseReport) -> &Example {
        let on = self.catalogue.on(&case.control).unwrap();
        let cycle = on.cycles.values().find(|cycle| cycle.name() == case.cycle && cycle.key.number == case.number);
        on.cases_of(cycle.unwrap()).find(|example| example.name.as_str() == case.case).unwrap()
    }
}

/// Our engine behind the protocol, whose answers are spoilt.
struct Spoilt<'w> {
    world: World<'w>,
    spoil: fn(&mut Answer),
}

impl Partner for Spoilt<'_> {
    fn ask(&mut self, line: &str) -> Result<String, Silence> {
        let mut answer: Answer = serde_json::from_str(&conform::serve(&self.world, line)).unwrap();
        (self.spoil)(&mut answer);
        Ok(serde_json::to_string(&answer).unwrap())
    }
}

fn put(data: &Data, spoil: fn(&mut Answer)) -> Report {
    put_on(data, CONTROL, spoil)
}

fn put_on(data: &Data, control: &str, spoil: fn(&mut Answer)) -> Report {
    let (report, mistakes) =
        conform::run_foreign(&data.world(), &Selection::of(&[control]), &mut Spoilt { world: data.world(), spoil });
    assert!(mistakes.is_empty());
    report
}

#[test]
fn an_engine_that_is_right_passes_as_ours_does() {
    let data = Data::new();
    let (ours, _) = conform::run(&data.world(), &Selection::of(&[CONTROL]));
    let theirs = put(&data, |_| {});
    assert_eq!(ours.cases.len(), theirs.cases.len());
    for (one, other) in ours.cases.iter().zip(&theirs.cases) {
        assert_eq!((&one.case, &one.verdict), (&other.case, &other.verdict), "{} {}", one.number, one.case);
    }
    assert!(theirs.cases.len() > 100);
}

/// Whether a case names that key at all, be it with an empty list.
fn names(example: &Example, key: &str) -> bool {
    example.expect.as_ref().is_some_and(|tree| tree.0.get(key).is_some())
}

/// Whether a case expects something of that key: a value that is not empty.
fn expects(example: &Example, key: &str) -> bool {
    let node = example.expect.as_ref().and_then(|tree| tree.0.get(key));
    node.is_some_and(|node| match &node.kind {
        Kind::Map(entries) => !entries.is_empty(),
        Kind::List(items) => !items.is_empty(),
        Kind::Scalar(..) => true,
    })
}

fn another_value(value: &mut serde_json::Value) {
    *value = match value.as_f64() {
        Some(number) => (number + 7.0).into(),
        None => "something else".into(),
    };
}

/// Whether a text has what only a reader of the source code would understand.
fn is_internal(text: &str) -> bool {
    ["NaN", "Some(", "None", "Text(", "Number(", "{ "].iter().any(|piece| text.contains(piece))
}

#[test]
fn differences_are_told_in_the_notation_of_the_cases() {
    let data = Data::new();
    let chosen = Selection { controls: &["tnc640"], cycles: &[(None, 200), (None, 208)], cases: &[] };
    let put = |spoil| conform::run_foreign(&data.world(), &chosen, &mut Spoilt { world: data.world(), spoil }).0;
    let report = put(|answer| {
        answer.position.clear();
        answer.q.clear();
        for moved in answer.moves.iter_mut().flatten() {
            (moved.feed, moved.angle) = (None, None);
            moved.to.remove("Z");
        }
    });
    let mut lists = 0;
    for case in &report.cases {
        let Verdict::Fail { mismatches } = &case.verdict else { continue };
        for found in mismatches {
            assert!(!is_internal(&found.expected) && !is_internal(&found.found), "{}: {found:?}", case.case);
            lists += usize::from(found.expected.starts_with('{'));
        }
    }
    assert!(lists > 0);
    // The first difference is named before the whole lists.
    let report = put(|answer| answer.moves.iter_mut().for_each(|moves| moves.truncate(1)));
    let differing = |case: &conform::CaseReport| match &case.verdict {
        Verdict::Fail { mismatches } => {
            let at = mismatches.iter().position(|found| found.what == "moves")?;
            mismatches.get(at.checked_sub(1)?).map(|first| first.what.clone())
        }
        _ => None,
    };
    let firsts: Vec<String> = report.cases.iter().filter_map(differing).collect();
    assert!(!firsts.is_empty() && firsts.iter().all(|first| first == "moves.2"), "{firsts:?}");
    assert!(conform::junit(&report).contains("why: "));
}

/// What an expectation is called, how its names begin, and what makes the answer wrong.
type Spoiler = (&'static str, &'static str, fn(&mut Answer));

#[test]
fn an_engine_that_is_wrong_is_caught_case_by_case() {
    let data = Data::new();
    let spoilers: [Spoiler; 9] = [
        ("q", "q.", |answer| answer.q.values_mut().for_each(another_value)),
        ("q", "q.", |answer| answer.q.clear()),
        ("position", "position.", |answer| answer.position.values_mut().for_each(|value| *value += 7.0)),
        ("errors", "errors", |answer| answer.errors = vec!["another-error".to_owned()]),
        ("table", "table.", |answer| answer.tables.iter_mut().for_each(|cell| another_value(&mut cell.value))),
        ("log", "log", |answer| answer.logs.clear()),
        ("messages", "messages", |answer| answer.messages.push("another-message".to_owned())),
        ("spindle", "spindle", |answer| answer.spindle.push("orient 1234".to_owned())),
        ("moves", "moves", |answer| {
            let wait = Moved { verb: "dwell".to_owned(), seconds: Some(1.0), ..Moved::default() };
            answer.moves.iter_mut().for_each(|moves| moves.push(wait.clone()));
        }),
    ];
    for (key, what, spoil) in spoilers {
        // Touch probes alone do nothing with the spindle.
        let report = put_on(&data, if key == "spindle" { "tnc640" } else { CONTROL }, spoil);
        let mut caught = 0;
        for case in &report.cases {
            let example = data.example(case);
            if example.skip.is_some() {
                continue;
            }
            let told = match &case.verdict {
                Verdict::Fail { mismatches } => mismatches.iter().any(|found| found.what.starts_with(what)),
                _ => false,
            };
            // An error that no case expects is one, too.
            if expects(example, key) || key == "errors" {
                assert!(told, "{key}: {} {} is not caught: {:?}", case.number, case.case, case.verdict);
                caught += 1;
            } else if !names(example, key) && (key != "moves" || !names(example, "last_moves")) {
                assert!(!matches!(case.verdict, Verdict::Fail { .. }), "{key}: {} {}", case.number, case.case);
            }
        }
        assert!(caught > 0, "no case expects {key}");
    }
}

#[test]
fn an_end_of_another_kind_is_caught() {
    let data = Data::new();
    let report = put(&data, |answer| answer.end = if answer.end == "done" { "stopped" } else { "done" }.to_owned());
    for case in &report.cases {
        let example = data.example(case);
        if expects(example, "end") && example.skip.is_none() {
            assert!(matches!(case.verdict, Verdict::Fail { .. }), "{} {}", case.number, case.case);
        }
    }
    let report = put(&data, |answer| answer.end = "finished".to_owned());
    assert_eq!(report.count(|verdict| matches!(verdict, Verdict::Pass)), 0);
}

/// An engine that falls silent, in another way each time.
struct Silent(usize);

impl Partner for Silent {
    fn ask(&mut self, _: &str) -> Result<String, Silence> {
        self.0 += 1;
        match self.0 % 4 {
            0 => Err(Silence::TimeLimit),
            1 => Err(Silence::Ended("exit status: 3".to_owned())),
            2 => Ok("no JSON".to_owned()),
            _ => Ok(r#"{"id":0,"end":"done"}"#.to_owned()),
        }
    }
}

#[test]
fn silence_fails_the_case_and_not_the_run() {
    let data = Data::new();
    let (report, _) = conform::run_foreign(&data.world(), &Selection::of(&[CONTROL]), &mut Silent(0));
    let found: Vec<&str> = report
        .cases
        .iter()
        .filter_map(|case| match &case.verdict {
            Verdict::Fail { mismatches } => mismatches.first().map(|found| found.found.as_str()),
            _ => None,
        })
        .collect();
    assert_eq!(found.len(), report.cases.len() - report.count(|verdict| matches!(verdict, Verdict::Skipped { .. })));
    assert!(found[0].contains("exit status: 3") && found[3].contains("time limit") && found[2] == "0", "{found:?}");
}

#[cfg(unix)]
#[test]
fn a_command_that_hangs_or_ends_is_started_again() {
    let limit = Duration::from_secs(5);
    let mut ends = Answering::new("sh -c \"read a; echo first $a; read b; exit 3\"", limit);
    for _ in 0..2 {
        assert_eq!(ends.ask("one").unwrap(), "first one");
        let NoAnswer::Ended(status) = ends.ask("two").unwrap_err() else { panic!("it ended") };
        assert!(status.contains('3'), "{status}");
    }
    let mut hangs = Answering::new("sh -c \"read a; echo first; exec sleep 60\"", Duration::from_millis(1500));
    for _ in 0..2 {
        assert_eq!(hangs.ask("one").unwrap(), "first");
        assert!(matches!(hangs.ask("two"), Err(NoAnswer::TimeLimit)));
    }
    let missing = Answering::new("/there/is/no/such/engine", limit).ask("one");
    assert!(matches!(missing, Err(NoAnswer::Ended(_))));
}

#[test]
fn the_command_passes_its_own_cases() {
    let ciklo = env!("CARGO_BIN_EXE_ciklo");
    let engine = format!("\"{ciklo}\" conform --serve");
    let output = std::process::Command::new(ciklo)
        .args(["conform", "--control", "itnc530", "--control", "tnc426-430"])
        .args(["--engine", &engine, "--time-limit", "60", "--ui-lang", "en"])
        .output()
        .unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stdout));
    assert!(String::from_utf8_lossy(&output.stderr).contains(" 0 failed, 0 out of subset"));
    let output = std::process::Command::new(ciklo)
        .args(["conform", "--control", CONTROL, "--engine", &format!("\"{ciklo}\" --version"), "--ui-lang", "en"])
        .output()
        .unwrap();
    assert_eq!(output.status.code(), Some(1));
}

#[test]
fn the_protocol_is_described() {
    let page = include_str!("../../docs/conform-protocol.md");
    for word in [
        conform::PROTOCOL,
        "id",
        "control",
        "cycle",
        "case",
        "language",
        "program",
        "scene",
        "tables",
        "end",
        "errors",
        "q",
        "position",
        "messages",
        "logs",
        "spindle",
        "moves",
        "verb",
        "to",
        "feed",
        "angle",
        "seconds",
        "bad-request",
    ] {
        assert!(page.contains(word), "{word}");
    }
}
