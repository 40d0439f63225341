//! Programs run in scenes, compared with the events that they must tell.
//!
//! - `tests/engine/run/*.h` beside `*.scene.yaml` and `*.events`; the first line of a program names its control.
//!   `UPDATE=1 cargo test --test suite engine` rewrites the events; a file that no program uses is a failure.
//! - `tests/engine/contours.txt`: contours and the moves that geometry asks for.
//! - `tests/engine/faults.txt`: sections `=== CODE`, each a program (and `--- scene` with a scene) that must end with
//!   that code; every code of the engine has a section.
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::{env, fs};

use ciklo::base::diag::Source;
use ciklo::engine::run::{
    At, CODES, Class, Content, Engine, Event, EventKind, Limits, Lines, MoveKind, Outcome, Status,
};
use ciklo::engine::scene::Scene;
use ciklo::language::locale::Locales;
use ciklo::program::syntax;
use ciklo::spec::Catalogue;
use ciklo::tools::conform::LogTexts;

struct World {
    files: ciklo::base::data::Files,
    catalogue: &'static Catalogue,
    locales: &'static Locales,
}

impl World {
    fn new() -> Self {
        let files = ciklo::base::data::embedded();
        let catalogue = &crate::built::built().catalogue;
        let locales = &*crate::built::built().locales;
        Self { files, catalogue, locales }
    }

    fn run(&self, name: &str, program: &str, scene: &str, limits: Limits) -> (Outcome, Vec<Event>) {
        let control = program.lines().next().and_then(|line| line.strip_prefix("; control: ")).unwrap_or("tnc640");
        let on = self.catalogue.on(control).unwrap_or_else(|| panic!("{name}: no control {control}"));
        let parsed = Scene::parse(&Source::new("scene.yaml", scene), &self.files);
        let scene = parsed.unwrap_or_else(|found| panic!("{name}: the scene says {found:?}"));
        let language = self.locales.language("en").expect("the source language");
        let texts = LogTexts::new(language, on.id(), &self.files);
        let tree = syntax::parse(&Source::new(name, program));
        let sub = syntax::parse(&Source::new("SUB.H", "BEGIN PGM SUB MM\nCALL PGM SUB2\nEND PGM SUB MM\n"));
        let sub2 = syntax::parse(&Source::new("SUB2.H", "BEGIN PGM SUB2 MM\nCALL PGM SUB\nEND PGM SUB2 MM\n"));
        let engine = Engine::new(&tree, on, &scene, &texts).with_catalogue(self.catalogue).with_limits(limits);
        let engine = engine.with_program("SUB.H", &sub).with_program("TNC:\\SUB2", &sub2);
        let mut events = Vec::new();
        let outcome = engine.run(&mut |event| events.push(event));
        (outcome, events)
    }
}

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/engine")
}

fn lines(events: &[Event], outcome: &Outcome) -> String {
    let mut text: String = events.iter().map(|event| format!("{}\n", event.to_json())).collect();
    assert_eq!(written(events), text);
    for (file, content) in outcome.tables.iter().chain(&outcome.logs) {
        text.push_str(&format!("= {file}\n{content}"));
    }
    text
}

/// The events as lines, as a command writes them.
fn written(events: &[Event]) -> String {
    let mut lines = Lines::default();
    events.iter().for_each(|event| lines.add(event));
    String::from_utf8(lines.bytes().to_vec()).expect("UTF-8")
}

#[test]
fn lines_have_the_bytes_of_the_tree() {
    // More numbers than are remembered, of all sizes, some of them again, and none that JSON has.
    let sizes = (-320..308).flat_map(|exponent| [1.0, -7.3, 123_456_789.0].map(|m| m * 10_f64.powi(exponent)));
    let known = [0.0, -0.0, f64::NAN, f64::INFINITY, f64::MIN, f64::MIN_POSITIVE, 5e-324, 0.1 + 0.2];
    let numbers: Vec<f64> = sizes.chain((0..2_000).map(|n| f64::from(n) * 0.125)).chain(known).collect();
    let mut events: Vec<Event> = Vec::new();
    let mut add = |kind| events.push(Event { at: At::default(), kind });
    for number in numbers.iter().chain(&numbers) {
        add(EventKind::Dwell(*number));
    }
    for text in ["", "a \"b\" \\", "\u{1b}[31m\n\u{7f}", "ž, ä, 孔"] {
        add(EventKind::Log { file: None, text: text.to_owned() });
        add(EventKind::Table { file: text.into(), row: 1.5, column: "X".into(), value: Content::Text(text.into()) });
    }
    add(EventKind::Turn { axes: Vec::new(), feed: 1.0, rapid: true, together: false });
    let tree: String = events.iter().map(|event| format!("{}\n", event.to_json())).collect();
    assert!(written(&events) == tree, "a number or text is written otherwise");
}

#[test]
fn programs_tell_the_events_that_they_must() {
    let world = World::new();
    let root = folder().join("run");
    let mut used = BTreeSet::new();
    let mut failures = Vec::new();
    for entry in fs::read_dir(&root).expect("the folder of programs") {
        let path = entry.expect("an entry").path();
        if path.extension().is_none_or(|extension| extension != "h") {
            continue;
        }
        let program = fs::read_to_string(&path).expect("a program");
        let scene_file = path.with_extension("scene.yaml");
        let scene = fs::read_to_string(&scene_file).unwrap_or_else(|_| "scene: 1\n".to_owned());
        let name = path.file_name().expect("a name").to_string_lossy().into_owned();
        let (outcome, events) = world.run(&name, &program, &scene, Limits::default());
        let found = lines(&events, &outcome);
        let events_file = path.with_extension("events");
        used.extend([path.clone(), scene_file, events_file.clone()]);
        if env::var_os("UPDATE").is_some() {
            fs::write(&events_file, &found).expect("a writable file");
        } else if fs::read_to_string(&events_file).unwrap_or_default() != found {
            failures.push(format!("{name} tells\n{found}"));
        }
    }
    for entry in fs::read_dir(&root).expect("the folder of programs") {
        let path = entry.expect("an entry").path();
        assert!(used.contains(&path), "{} belongs to no program", path.display());
    }
    assert!(failures.is_empty(), "{}", failures.join("\n"));
}

#[test]
fn the_same_run_tells_the_same_bytes() {
    let world = World::new();
    let root = folder().join("run");
    let program = fs::read_to_string(root.join("probing.h")).expect("a program");
    let scene = fs::read_to_string(root.join("probing.scene.yaml")).expect("a scene");
    let run = || {
        let (outcome, events) = world.run("probing.h", &program, &scene, Limits::default());
        lines(&events, &outcome)
    };
    assert_eq!(run(), run());
}

#[test]
fn the_parameter_without_a_value_is_named_and_not_the_one_that_should_get_it() {
    let world = World::new();
    let program = "; control: tnc640\nCYCL DEF 247 DATUM SETTING ~\n  Q339=Q60 ;DATUM NUMBER\n";
    let (outcome, _) = world.run("named", program, "scene: 1\n", Limits::default());
    let fault = outcome.fault.expect("a fault");
    let named: Vec<_> = fault.args.iter().filter(|(name, _)| *name == "q").map(|(_, q)| q.clone()).collect();
    assert_eq!((&*fault.code, named), ("parameter-undefined", vec!["Q60".into()]));
}

/// A called program has local parameters of its own each time; the one that called it has its own again, and what was
/// exported to it.
#[test]
fn local_parameters_belong_to_a_call() {
    let world = World::new();
    let on = world.catalogue.on("tnc640").expect("a control");
    let scene = Scene::parse(&Source::new("scene.yaml", "scene: 1\n"), &world.files).expect("a scene");
    let texts = LogTexts::new(world.locales.language("en").expect("the source language"), on.id(), &world.files);
    let main = "BEGIN PGM MAIN MM\nQ20 = 0\nQL1 = 1\nQL2 = 2\nCALL PGM PART\nCALL PGM PART\nQ10 = QL1\nQ11 = QL2\nEND PGM MAIN MM\n";
    // It counts calls that find a value in QL1: there are none.
    let part = "BEGIN PGM PART MM\nFN 9: IF QL1 IS UNDEFINED GOTO LBL 1\nQ20 = Q20 + 1\nLBL 1\nQL1 = 5\nQL2 = 7\n\
                FN 37: EXPORT QL2\nEND PGM PART MM\n";
    let (main, part) = (syntax::parse(&Source::new("MAIN.H", main)), syntax::parse(&Source::new("PART.H", part)));
    let engine = Engine::new(&main, on, &scene, &texts).with_program("PART.H", &part);
    let outcome = engine.run(&mut |_| {});
    assert_eq!(outcome.status, Status::Done, "{:?}", outcome.fault);
    let value = |number| outcome.params.numbers().find(|(own, _)| *own == number).map(|(_, value)| value);
    assert_eq!((value(10), value(11), value(20)), (Some(1.0), Some(7.0), Some(0.0)));
}

#[test]
fn names_labels_and_axes_are_read_as_they_are_checked() {
    let world = World::new();
    let memory = |value: &str| format!("; control: tnc640\nTCH PROBE 450 SAVE ~\n  Q410=1 ;MODE ~\n  {value} ;NAME\n");
    let contour = |list: &str| format!("; control: tnc640\nCYCL DEF 14.0 CONTOUR\nCYCL DEF 14.1 LABELS {list}\n");
    let lines = |pair: &str| {
        let head = "; control: tnc426-430\nTOOL CALL 1 Z\nTCH PROBE 7.0 LINES\nTCH PROBE 7.1 TIME: 0 X+0 Y+0\n";
        format!("{head}TCH PROBE 7.2 {pair}\nTCH PROBE 7.3 TRAVEL: 0.5 L.SPAC: +0.2 P.SPAC: 0.5\n")
    };
    // What is read goes on to the first thing that the engine does not have.
    let cases = [
        (memory("QS409=\"AB\""), "kinematics-not-saved"),
        (memory("Q409=5"), "kinematics-not-saved"),
        (memory("Q409=\"AB\""), "text-or-number"),
        (memory("QS409=5"), "text-or-number"),
        (contour("1/2/3"), ""),
        (contour("0/1"), "word-not-offered"),
        (contour("1/2.5"), "field-unknown"),
        (lines("ORDER: Y- / X-"), "probe-missing"),
        (lines("ORDER: Y- / X"), "field-unknown"),
        (lines("ORDER: A- / X-"), "probe-missing"),
        (lines("ORDER: U- / X-"), "unsupported-axis"),
        (lines("ORDER: Y-"), "field-missing"),
    ];
    for (program, code) in cases {
        let (outcome, _) = world.run("read", &program, "scene: 1\n", Limits::default());
        assert_eq!(outcome.fault.as_ref().map_or("", |fault| &fault.code), code, "{program}");
    }
}

/// A ring whose plunging arcs end where they begin but for rounding: they are full circles and not none.
#[test]
fn the_plunging_arcs_of_a_ring_are_full_circles() {
    let world = World::new();
    let program = "; control: tnc640\nTOOL CALL 1 Z S2000 F300\nL Z+60 R0 FMAX M3\n\
                   CYCL DEF 254 CIRCULAR SLOT Q215=+1 Q219=+8 Q368=+0 Q375=+47.921 Q367=+0 Q216=-10.558 Q217=-15.873 \
                   Q376=-124.21 Q248=+360 Q378=+0 Q377=+1 Q207=+500 Q351=+1 Q201=-6 Q202=+3 Q369=+0 Q206=+150 Q338=+0 \
                   Q200=+2 Q203=+0 Q204=+50 Q366=+2 Q385=+400\nCYCL CALL\n";
    let scene = "scene: 1\nmachine: mill-3-axis\ntools: [{T: 1, L: 80, R: 3, ANGLE: 5}]\nstart: [0, 0, 100]\n";
    let (outcome, events) = world.run("ring", program, scene, Limits::default());
    assert_eq!(outcome.status, Status::Done, "{:?}", outcome.fault);
    let lines = events.iter().map(|event| event.to_json());
    let angles: Vec<f64> = lines
        .filter(|event| event["step"] == "plunge-in-circular-slot" && event["kind"] == "arc")
        .filter_map(|event| event["angle"].as_f64())
        .collect();
    // Two levels of 3 mm, each reached on one round.
    assert_eq!(angles.iter().map(|angle| angle.abs()).collect::<Vec<_>>(), [360.0, 360.0]);
}

/// What GLOBAL DEF gives is taken by cycles whose printed parameters do not offer the word, too.
#[test]
fn drilling_takes_what_global_def_gives() {
    let world = World::new();
    let program = "; control: tnc640\nGLOBAL DEF 100 GENERAL ~\nQ200=2 ~\nQ204=50 ~\nQ253=750 ~\nQ208=999\n\
                   TOOL CALL 1 Z S2000 F300\nL Z+60 R0 FMAX M3\nCYCL DEF 200 DRILLING Q200=PREDEF Q201=-6 Q206=150 Q202=5 Q210=0 \
                   Q203=+0 Q204=PREDEF Q211=0\nL X+10 Y+10 FMAX M99\n";
    let scene = "scene: 1\nmachine: mill-3-axis\ntools: [{T: 1, L: 80, R: 3}]\nstart: [0, 0, 100]\n";
    let (outcome, _) = world.run("predef", program, scene, Limits::default());
    assert_eq!((outcome.status, outcome.position.z), (Status::Done, 50.0), "{:?}", outcome.fault);
}

/// The definition of an earlier software version has one feed rate for milling, which finishing takes as well.
#[test]
fn finishing_takes_the_feed_for_milling_where_a_definition_has_no_other() {
    let world = World::new();
    let program = "; control: tnc640\nTOOL CALL 1 Z S2000 F300\nL Z+60 R0 FMAX M3\n\
                   CYCL DEF 254 CIRCULAR SLOT Q215=+2 Q219=+14 Q368=+1 Q375=+40 Q367=+0 Q216=+0 Q217=+0 Q376=+0 Q248=+90 \
                   Q378=+0 Q377=+1 Q207=+470 Q351=+1 Q201=-4 Q202=+5 Q369=+0 Q206=+150 Q338=+0 Q200=+2 Q203=+0 Q204=+50 \
                   Q366=+0\nCYCL CALL\n";
    let scene = "scene: 1\nmachine: mill-3-axis\ntools: [{T: 1, L: 80, R: 5}]\nstart: [0, 0, 100]\n";
    let (outcome, events) = world.run("older", program, scene, Limits::default());
    assert_eq!(outcome.status, Status::Done, "{:?}", outcome.fault);
    let events = events.iter().map(|event| event.to_json()).filter(|event| event["step"] == "finish-slot-side");
    let feeds: Vec<f64> = events.filter_map(|event| event["feed"].as_f64()).collect();
    assert!(!feeds.is_empty() && feeds.iter().all(|feed| *feed == 470.0), "{feeds:?}");
}

/// Small limits, so that the programs that reach them are quick.
const LIMITS: Limits = Limits { blocks: 20_000, jumps: 1_000, depth: 5, members: 100, moves: 17_500 };

#[test]
fn every_fault_has_a_program_that_provokes_it() {
    let world = World::new();
    let text = fs::read_to_string(folder().join("faults.txt")).expect("the faults");
    let mut seen = BTreeSet::new();
    let mut failures = Vec::new();
    for section in text.split("=== ").skip(1) {
        let (head, body) = section.split_once('\n').expect("a head");
        let (program, scene) = body.split_once("--- scene\n").unwrap_or((body, "scene: 1\n"));
        let code = head.trim();
        let (outcome, events) = world.run(code, program, scene, LIMITS);
        let found = outcome.fault.as_ref().map_or("", |fault| &fault.code);
        if found != code {
            failures.push(format!("{code}: ended with {found:?} {:?}, {:?}", outcome.status, outcome.fault));
        }
        let last = events.last().map(|event| event.to_json().to_string()).unwrap_or_default();
        assert!(last.contains("\"event\":\"end\""), "{code}: no end is told");
        assert_ne!(outcome.status, Status::Done, "{code}");
        seen.insert(code.to_owned());
    }
    for (code, class) in CODES {
        if *class != Class::Internal && !seen.contains(*code) {
            failures.push(format!("{code}: no program provokes it"));
        }
    }
    for code in &seen {
        if !CODES.iter().any(|(known, _)| known == code) {
            failures.push(format!("{code}: not in the list of codes"));
        }
    }
    assert!(failures.is_empty(), "{}", failures.join("\n"));
}

#[test]
fn every_code_has_a_text_in_every_language() {
    let world = World::new();
    for language in world.locales.iter() {
        for (code, _) in CODES {
            let id = format!("diag-{code}");
            assert!(language.ids().any(|known| known == id), "{}: {id} is missing", language.tag());
        }
    }
}

/// The moves at feed of a program, as `contours.txt` has them.
fn feeds(events: &[Event]) -> Vec<(char, glam::DVec3, f64, f64)> {
    let of = |event: &Event| match &event.kind {
        EventKind::Move { kind: MoveKind::Feed, to, feed, .. } => Some(('L', *to, 0.0, *feed)),
        EventKind::Move { kind: MoveKind::Arc { angle, .. }, to, feed, .. } => Some(('A', *to, *angle, *feed)),
        _ => None,
    };
    events.iter().filter_map(of).collect()
}

#[test]
fn contours_go_where_geometry_says() {
    let world = World::new();
    let text = fs::read_to_string(folder().join("contours.txt")).expect("the contours");
    let mut failures = Vec::new();
    for section in text.split("=== ").skip(1) {
        let (head, body) = section.split_once('\n').expect("a head");
        let (program, wanted) = body.split_once("--- moves\n").expect("moves");
        let sizes: Vec<f64> = head.split(' ').rev().map_while(|word| word.parse().ok()).collect();
        let (radius, over) = if let [over, radius] = sizes[..] { (radius, over) } else { (5.0, 0.0) };
        let scene = format!("scene: 1\ntools: [{{T: 1, L: 100, R: {radius}, DR: {over}}}]\nstart: [0, 0, 0]\n");
        let program = format!("; control: tnc640\nTOOL CALL 1 Z S1000 F100\n{program}");
        let (outcome, events) = world.run(head, &program, &scene, Limits::default());
        let found = feeds(&events);
        let wanted: Vec<&str> = wanted.lines().filter(|line| !line.starts_with(';')).collect();
        let same = |line: &str, (kind, to, angle, feed): &(char, glam::DVec3, f64, f64)| {
            let mut words = line.split(' ');
            let is_kind = words.next() == Some(&kind.to_string());
            let rest: Vec<&str> = words.collect();
            let number = |n: usize| rest.get(n).and_then(|word| word.parse::<f64>().ok());
            let near = |n: usize, value: f64| number(n).is_some_and(|wanted: f64| (wanted - value).abs() < 1e-6);
            let is_angle = *kind == 'L' || near(3, *angle);
            let fed = rest.iter().find_map(|word| word.strip_prefix('F')?.parse::<f64>().ok());
            is_kind && near(0, to.x) && near(1, to.y) && near(2, to.z) && is_angle && fed.is_none_or(|fed| fed == *feed)
        };
        let fits = wanted.len() == found.len() && wanted.iter().zip(&found).all(|(line, found)| same(line, found));
        if !fits || outcome.status != Status::Done {
            failures.push(format!("{head}: {:?}\n{found:#?}", outcome.fault));
        }
    }
    assert!(failures.is_empty(), "{}", failures.join("\n"));
}
