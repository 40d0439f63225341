//! Dwell, program call, orientation and tolerance as programs use them, and the feed of the tool call wherever a cycle
//! takes it instead of a number.
use std::fmt::Write as _;

use ciklo::base::diag::Source;
use ciklo::base::expr::{QKind, QRef};
use ciklo::engine::run::{Engine, Event, EventKind, NoTexts, Outcome, Status};
use ciklo::engine::scene::Scene;
use ciklo::program::syntax;
use ciklo::spec::{Cycle, Keyword};

use crate::built;
use built::{Built, built};

const SCENE: &str = "scene: 1\ntools: [{T: 1, L: 80, R: 3}]\nstart: [0, 0, 50]\n";
const HEAD: &str = "TOOL CALL 1 Z S1000 F500\nL Z+20 R0 FMAX M3\n";

/// A program and those that it can call.
fn run(program: &str, others: &[(&str, &str)]) -> (Outcome, Vec<Event>) {
    let Built { files, catalogue, .. } = built();
    let on = catalogue.on("tnc640").expect("a control");
    let scene = Scene::parse(&Source::new("scene.yaml", SCENE), files).expect("a scene");
    let tree = syntax::parse(&Source::new("MAIN.H", program));
    let others: Vec<_> = others.iter().map(|(name, text)| (*name, syntax::parse(&Source::new(*name, *text)))).collect();
    let mut engine = Engine::new(&tree, on, &scene, &NoTexts).with_catalogue(catalogue);
    for (name, other) in &others {
        engine = engine.with_program(name, other);
    }
    let mut events = Vec::new();
    let outcome = engine.run(&mut |event| events.push(event));
    (outcome, events)
}

fn done(program: &str, others: &[(&str, &str)]) -> (Outcome, Vec<Event>) {
    let (outcome, events) = run(program, others);
    assert_eq!(outcome.status, Status::Done, "{program}{:?}", outcome.fault);
    (outcome, events)
}

fn q(outcome: &Outcome, number: u32) -> f64 {
    let number = u16::try_from(number).expect("a Q parameter");
    outcome.params.number(QRef { kind: QKind::Q, number }).expect("a value")
}

fn dwells(events: &[Event]) -> Vec<(usize, f64)> {
    let dwell = |event: &Event| match event.kind {
        EventKind::Dwell(seconds) => Some((event.at.line, seconds)),
        _ => None,
    };
    events.iter().filter_map(dwell).collect()
}

#[test]
fn a_dwell_acts_where_it_is_defined_and_changes_nothing() {
    let dwell = "CYCL DEF 9.0 DWELL TIME\nCYCL DEF 9.1 DWELL 1.5\n";
    let (outcome, events) = done(&format!("{HEAD}LBL 1\nL IX+10 F300\n{dwell}CALL LBL 1 REP 2\nL IX+10\n"), &[]);
    assert_eq!(dwells(&events), [(5, 1.5); 3]);
    assert_eq!(outcome.position.to_array(), [40.0, 0.0, 20.0]);
    let spindle = events.iter().filter(|event| matches!(event.kind, EventKind::Spindle { .. })).count();
    assert_eq!(spindle, 2, "the tool call and M3 only");
    let feed = events.iter().rev().find_map(|event| match event.kind {
        EventKind::Move { feed, .. } => Some(feed),
        _ => None,
    });
    assert_eq!(feed, Some(300.0));
    // The last cycle to be called is still the one before.
    let drill = "CYCL DEF 200\nQ200=2\nQ201=-5\nQ206=100\nQ202=5\nQ210=0\nQ203=0\nQ204=0\nQ211=0\n";
    let (_, events) = done(&format!("{HEAD}{drill}{dwell}CYCL CALL\n"), &[]);
    assert!(events.iter().any(|event| event.at.cycle.as_ref().is_some_and(|(key, _)| key.number == 200)
        && matches!(event.kind, EventKind::Move { .. })));
    // 0 to 3600 s.
    let (_, events) = done(&format!("{HEAD}CYCL DEF 9.0 DWELL TIME\nCYCL DEF 9.1 DWELL 3600\n"), &[]);
    assert_eq!(dwells(&events), [(4 - 1, 3600.0)]);
    let (outcome, events) = run(&format!("{HEAD}CYCL DEF 9.0 DWELL TIME\nCYCL DEF 9.1 DWELL 3601\n"), &[]);
    assert_eq!((outcome.status, dwells(&events).len()), (Status::Error, 0));
}

#[test]
fn a_program_becomes_a_cycle() {
    let other = "BEGIN PGM HOLE MM\nQ5=Q5+1\nL IZ-3 R0 F100\nL IZ+3 FMAX\nEND PGM HOLE MM\n";
    let define = "Q5=0\nCYCL DEF 12.0 PGM CALL\nCYCL DEF 12.1 PGM HOLE.H\n";
    let calls = [
        ("L X+10 R0 FMAX M99\n", 1.0),
        ("L X+10 R0 FMAX\nCYCL CALL\nL X+20 M99\n", 2.0),
        ("L X+10 R0 FMAX M89\nL X+20\nL X+30 M99\nL X+40\n", 3.0),
        ("L X+10 R0 FMAX\n", 0.0),
    ];
    for (body, count) in calls {
        let (outcome, events) = done(&format!("{HEAD}{define}{body}"), &[("HOLE.H", other)]);
        assert_eq!(q(&outcome, 5), count, "{body}");
        let low =
            |event: &&Event| matches!(&event.kind, EventKind::Move { to, feed, .. } if to.z == 17.0 && *feed == 100.0);
        assert_eq!(events.iter().filter(low).count() as f64, count, "{body}");
        assert_eq!(outcome.position.z, 20.0, "{body}");
    }
    // Names of digits, of letters with digits, and without the extension.
    for name in ["50.H", "LOT31.H", "HOLE", "50", "LOT31"] {
        let file = if name.ends_with(".H") { name.to_owned() } else { format!("{name}.H") };
        let (outcome, _) = done(&format!("{HEAD}{}CYCL CALL\n", define.replace("HOLE.H", name)), &[(&file, other)]);
        assert_eq!(q(&outcome, 5), 1.0, "{name}");
    }
    // With its path, and one that is not there.
    let with_path = define.replace("HOLE.H", "TNC:\\PARTS\\HOLE.H");
    assert_eq!(q(&done(&format!("{HEAD}{with_path}CYCL CALL\n"), &[("HOLE.H", other)]).0, 5), 1.0);
    let (outcome, _) = run(&format!("{HEAD}{define}CYCL CALL\n"), &[]);
    assert_eq!(outcome.fault.map(|fault| fault.code.to_string()).as_deref(), Some("program-missing"));
    // One that calls itself ends, and not in a hang.
    let endless = "BEGIN PGM HOLE MM\nCYCL CALL\nEND PGM HOLE MM\n";
    let (outcome, _) = run(&format!("{HEAD}{define}CYCL CALL\n"), &[("HOLE.H", endless)]);
    assert!(matches!(outcome.status, Status::Limit | Status::Error), "{:?}", outcome.fault);
}

#[test]
fn an_orientation_is_kept_for_its_m_function() {
    let oriented = |body: &str| {
        let (_, events) = done(&format!("{HEAD}{body}"), &[]);
        let angle = |event: &Event| match event.kind {
            EventKind::Spindle { orient, .. } => orient,
            _ => None,
        };
        events.iter().filter_map(angle).collect::<Vec<_>>()
    };
    let define = |angle: f64| format!("CYCL DEF 13.0 ORIENTATION\nCYCL DEF 13.1 ANGLE {angle}\n");
    assert!(oriented(&define(30.0)).is_empty(), "the definition turns nothing");
    assert_eq!(oriented(&format!("{}M19\n", define(30.0))), [30.0]);
    assert_eq!(oriented(&format!("{}M19\n{}M19\n", define(30.0), define(45.5))), [30.0, 45.5]);
    // Boring uses the orientation for itself: after it the cycle must be programmed again.
    let bore =
        "CYCL DEF 202\nQ200=2\nQ201=-5\nQ206=100\nQ211=0\nQ208=100\nQ203=0\nQ204=0\nQ214=1\nQ336=70\nCYCL CALL\n";
    assert_eq!(oriented(&format!("{}{bore}M19\n{}M19\n", define(30.0), define(30.0))), [70.0, 70.0, 30.0]);
}

#[test]
fn a_tolerance_is_told_until_it_is_reset() {
    let (outcome, events) = done(
        &format!(
            "{HEAD}CYCL DEF 32.0 TOLERANCE\nCYCL DEF 32.1 T0.05\nCYCL DEF 32.2 HSC-MODE:1 TA5\nL X+10 R0 F500\n\
             CYCL DEF 32.0 TOLERANCE\nCYCL DEF 32.1 T0.02\nL X+20\nCYCL DEF 32.0 TOLERANCE\nCYCL DEF 32.1\nL X+30\n"
        ),
        &[],
    );
    let tolerances: Vec<_> = events
        .iter()
        .filter_map(|event| match event.kind {
            EventKind::Tolerance(tolerance) => Some(tolerance),
            _ => None,
        })
        .collect();
    // With the tolerance alone the others are 0.
    assert_eq!(tolerances, [Some([0.05, 1.0, 5.0]), Some([0.02, 0.0, 0.0]), None]);
    assert_eq!(outcome.position.x, 30.0, "paths are those that are programmed");
}

/// Cycles of which a parameter may be the word, with the values of their printed examples.
fn with_word(word: &str) -> Vec<(&'static Cycle, Vec<u32>)> {
    let Built { catalogue, .. } = built();
    let on = catalogue.on("tnc640").expect("a control");
    let takes = |cycle: &'static Cycle| {
        let takes = cycle.params.iter().filter(|param| param.words.iter().any(|known| known == word));
        (cycle, takes.filter_map(|param| param.q).map(|q| u32::from(q.number)).collect::<Vec<_>>())
    };
    let cycles = on.cycles.values().filter(|cycle| cycle.key.keyword == Keyword::CyclDef).map(takes);
    cycles.filter(|(_, takes)| !takes.is_empty()).collect()
}

/// The definition, with the word for these parameters.
fn defined(cycle: &Cycle, takes: &[u32], word: &str) -> String {
    let mut text = format!("CYCL DEF {}\n", cycle.key.number);
    for own in &cycle.file.parameters {
        let Some(q) = own.q else { continue };
        let value = if takes.contains(&u32::from(q.number)) { word } else { own.example.as_deref().unwrap_or("0") };
        let _ = writeln!(text, "{q}={value}");
    }
    text
}

/// The feed of the tool call is taken when the cycle is defined; another tool call does not change it.
#[test]
fn the_feed_of_the_tool_call_is_taken_at_the_definition() {
    let all = with_word("FAUTO");
    assert!(all.len() > 30, "{}", all.len());
    for (cycle, takes) in all {
        let define = defined(cycle, &takes, "FAUTO");
        let number = cycle.key.number;
        let (outcome, _) = done(&format!("TOOL CALL 1 Z S1000 F321\n{define}TOOL CALL 1 Z S1000 F999\n"), &[]);
        for q_number in &takes {
            assert_eq!(q(&outcome, *q_number), 321.0, "cycle {number}, Q{q_number}");
        }
        let (outcome, _) = done(&format!("TOOL CALL 1 Z S1000 F321\n{define}TOOL CALL 1 Z S1000 F99.5\n{define}"), &[]);
        for q_number in &takes {
            assert_eq!(q(&outcome, *q_number), 99.5, "cycle {number}, Q{q_number}");
        }
        let (outcome, _) = run(&format!("TOOL CALL 1 Z S1000\n{define}"), &[]);
        let code = outcome.fault.map(|fault| fault.code.to_string());
        assert_eq!(code.as_deref(), Some("feed-missing"), "cycle {number}: no feed was called");
    }
}

/// A word that a parameter does not offer is refused in every cycle that offers none.
#[test]
fn words_that_are_not_offered_are_refused() {
    let Built { catalogue, .. } = built();
    let on = catalogue.on("tnc640").expect("a control");
    let mut looked = 0;
    for cycle in on.cycles.values().filter(|cycle| cycle.key.keyword == Keyword::CyclDef) {
        let none = cycle.params.iter().find(|param| param.words.is_empty() && param.field.is_none());
        let Some(q) = none.and_then(|param| param.q).filter(|q| q.kind == QKind::Q) else { continue };
        looked += 1;
        let define = defined(cycle, &[u32::from(q.number)], "FAUTO");
        let (outcome, _) = run(&format!("TOOL CALL 1 Z S1000 F321\n{define}"), &[]);
        let code = outcome.fault.map(|fault| fault.code.to_string());
        assert_eq!(code.as_deref(), Some("word-not-offered"), "cycle {}, {q}", cycle.key.number);
    }
    assert!(looked > 30, "{looked}");
}
