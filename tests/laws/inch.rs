//! Laws of programs in inches: the same part programmed in mm and in inches gives the same motions, and a probe finds
//! the same truth. Every example of the specifications is told in inches, and the definitions of all cycles with
//! parameters, with random values, are executed in both units.
use std::cell::{Cell, RefCell};
use std::collections::BTreeSet;

use ciklo::base::diag::Source;
use ciklo::engine::run::{Engine, Event, EventKind, Outcome, Status};
use ciklo::engine::scene::Scene;
use ciklo::program::syntax;
use ciklo::spec::{Cycle, Keyword, OnControl, Param, TakesEffect};
use ciklo::tools::conform::{self, LogTexts};
use proptest::prelude::*;
use serde_json::Value;

use crate::in_inches as inch;
use inch::{INCH, in_inches, with_lengths};

use crate::built;
use built::built;

/// How far the angles of arcs may lie apart, in degrees: those of short arcs follow from ends that are the same to less.
const SAME_ANGLE: f64 = 1e-6;
/// How far coordinates in mm and feeds may lie apart, in parts of themselves where they are greater than 1.
const SAME: f64 = 1e-9;
/// The same in turning, where an insert that fits to a hair is eased by the decimals that a program loses.
const SAME_IN_TURNING: f64 = 2e-6;

fn run(on: &OnControl, scene: &Scene, text: &str) -> (Outcome, Vec<Event>) {
    let world = built();
    let language = world.locales.language("en").expect("the source language");
    let texts = LogTexts::new(language, on.id(), &world.files);
    let program = syntax::parse(&Source::new("LAW.H", text));
    let mut events = Vec::new();
    let engine = Engine::new(&program, on, scene, &texts).with_catalogue(&world.catalogue);
    let outcome = engine.run(&mut |event| events.push(event));
    (outcome, events)
}

/// Where two documents differ by more than rounding.
fn apart(mm: &Value, inch: &Value, path: &str, same: f64) -> Option<String> {
    match (mm, inch) {
        (Value::Number(a), Value::Number(b)) => {
            let (a, b) = (a.as_f64()?, b.as_f64()?);
            let same = if path.ends_with(".angle") { SAME_ANGLE.max(same) } else { same };
            ((a - b).abs() > same * (1.0 + b.abs())).then(|| format!("{path}: {a} in mm, {b} in inches"))
        }
        (Value::Object(a), Value::Object(b)) if a.len() == b.len() => a
            .iter()
            .find_map(|(key, value)| apart(value, b.get(key).unwrap_or(&Value::Null), &format!("{path}.{key}"), same)),
        (Value::Array(a), Value::Array(b)) if a.len() == b.len() => {
            a.iter().zip(b).enumerate().find_map(|(i, (a, b))| apart(a, b, &format!("{path}[{i}]"), same))
        }
        _ => (mm != inch).then(|| format!("{path}: {mm} in mm, {inch} in inches")),
    }
}

/// What must be the same in both units: everything but the values of parameters and the texts of logs.
fn told(events: &[Event]) -> Vec<Value> {
    let same = |event: &&Event| !matches!(event.kind, EventKind::Set { .. } | EventKind::Log { .. });
    let json = |event: &Event| {
        let mut json = event.to_json();
        if let (EventKind::Error(_), Some(map)) = (&event.kind, json.as_object_mut()) {
            map.remove("args");
        }
        json
    };
    events.iter().filter(same).map(json).collect()
}

/// How the runs of one program in both units differ.
fn difference(mm: &(Outcome, Vec<Event>), inch: &(Outcome, Vec<Event>), same: f64) -> Option<String> {
    let (a, b) = (told(&mm.1), told(&inch.1));
    let first = a.iter().zip(&b).find_map(|(a, b)| apart(a, b, &a["line"].to_string(), same));
    let lengths = || (a.len() != b.len()).then(|| format!("{} events in mm, {} in inches", a.len(), b.len()));
    let params = || {
        mm.0.params.numbers().find_map(|(number, value)| {
            let other = inch.0.params.numbers().find(|(known, _)| *known == number).map(|(_, value)| value);
            let Some(other) = other else { return Some(format!("Q{number} is {value} in mm and missing in inches")) };
            let near = |a: f64, b: f64| (a - b).abs() <= same * (1.0 + b.abs());
            let told = || format!("Q{number} is {value} in mm and {other} in inches");
            (!near(value, other) && !near(value, other * INCH)).then(told)
        })
    };
    first.or_else(lengths).or_else(params)
}

#[test]
fn every_example_does_the_same_in_inches() {
    let world = built();
    let all = conform::World { catalogue: &world.catalogue, locales: &world.locales, files: &world.files };
    let (mut compared, mut done, mut without, mut found) = (0, 0, 0, Vec::new());
    for case in conform::executed(&all, &[]) {
        let program = syntax::parse(&case.program);
        let Some(twin) = in_inches(&program, case.on, &world.catalogue) else {
            without += 1;
            continue;
        };
        let mm = run(case.on, &case.scene, case.program.text());
        let inches = run(case.on, &case.scene, &twin);
        compared += 1;
        done += usize::from(mm.0.status == Status::Done);
        let same = if case.program.text().contains("MODE TURN") { SAME_IN_TURNING } else { SAME };
        if let Some(what) = difference(&mm, &inches, same) {
            found.push(format!("{} {} {}: {what}", case.on.id(), case.cycle.key, case.name));
        }
    }
    assert!(found.is_empty(), "{} of {compared}:\n{}", found.len(), found.join("\n"));
    assert!(done > 500 && without * 10 < compared, "{done} done of {compared}, {without} without a twin");
}

/// Every example of a probing cycle, with lengths that lie a little beside those of its program: what is found, and what
/// cannot be found, is the same in both units.
#[test]
fn probes_find_the_same_beside_the_examples() {
    let world = built();
    let all = conform::World { catalogue: &world.catalogue, locales: &world.locales, files: &world.files };
    let (mut compared, mut done, mut found) = (0, 0, Vec::new());
    let mut cycles = BTreeSet::new();
    // The same numbers in every run: a plain generator of the minimal standard.
    let mut state = 20_151_103_u64;
    let mut beside = || {
        state = state * 48_271 % 2_147_483_647;
        1.0 + (state as f64 / 2_147_483_647.0 - 0.5) * 0.01
    };
    for case in conform::executed(&all, &[]).iter().filter(|case| case.cycle.key.keyword == Keyword::TchProbe) {
        let program = syntax::parse(&case.program);
        for _ in 0..4 {
            let Some(mm) = with_lengths(&program, case.on, &world.catalogue, &mut beside) else { break };
            let varied = syntax::parse(&Source::new("LAW.H", &mm));
            let Some(twin) = in_inches(&varied, case.on, &world.catalogue) else { break };
            let (mm, inches) = (run(case.on, &case.scene, &mm), run(case.on, &case.scene, &twin));
            compared += 1;
            if mm.0.status == Status::Done {
                done += 1;
                cycles.insert((case.on.id(), case.cycle.key));
            }
            if let Some(what) = difference(&mm, &inches, SAME) {
                found.push(format!("{} {} {}: {what}", case.on.id(), case.cycle.key, case.name));
            }
        }
    }
    assert!(found.is_empty(), "{} of {compared}:\n{}", found.len(), found.join("\n"));
    assert!(done > 900 && cycles.len() > 60, "{done} done of {compared}, of {} cycles", cycles.len());
}

/// A random value of a parameter as it is written in mm.
fn written(param: &Param, example: &str, share: f64, pick: usize) -> String {
    let choices: Vec<&str> =
        param.choices.iter().map(|choice| choice.value.as_str()).filter(|v| v.parse::<f64>().is_ok()).collect();
    if let Some(choice) = choices.get(pick % choices.len().max(1)) {
        return (*choice).to_owned();
    }
    let Ok(number) = example.replace(',', ".").parse::<f64>() else { return example.to_owned() };
    if !param.is_measured() {
        return example.to_owned();
    }
    let value = (number * share * 10_000.0).round() / 10_000.0;
    format!("{value:+}")
}

/// The machining cycles with parameters that a manual prints values for.
fn machining() -> Vec<&'static Cycle> {
    let on = built().catalogue.on("tnc640").expect("a control");
    let own = |cycle: &&Cycle| cycle.key.keyword == Keyword::CyclDef && !cycle.is_old_style();
    on.cycles.values().filter(own).collect()
}

/// The ways to call a cycle: here, at the end of a block, at a position, on every form of a pattern.
const CALLS: [&str; 5] = [
    "CYCL CALL\n",
    "L X+12.5 Y-7.25 R0 FMAX M99\n",
    "CYCL CALL POS X+31.2 Y+4 Z+1.5 F700\n",
    "PATTERN DEF POS1 (X+25 Y+33,5 Z+2) ROW1 (X+5 Y+6 D+8.25 NUM2 ROT+20 Z+0)\nCYCL CALL PAT F900\n",
    "PATTERN DEF PAT1 (X+5 Y+3 DX+8.1 DY+9.7 NUMX2 NUMY2 ROT+15 ROTX+5 ROTY-8 Z+1) FRAME1 (X+0 Y+0 DX+7 DY+6 NUMX2 NUMY3 \
     ROT+0 ROTX+0 ROTY+0 Z+0) CIRC1 (X+25 Y+33 D80 START+45 NUM2 Z+0) PITCHCIRC1 (X+2 Y+3 D30.5 START+45 STEP+30 NUM2 Z-1)\n\
     CYCL CALL PAT F900\n",
];

const TOOLS: &str = "scene: 1\nmachine: mill-3-axis\nstart: {Z: 200}\n\
    tools: [{T: 1, L: 80, R: 3, CUT: 4, ANGLE: 30, LCUTS: 40}, {T: 2, L: 80, R: 1.5, CUT: 2, ANGLE: 90, T-ANGLE: 118}]\n";

#[test]
fn every_machining_cycle_does_the_same_in_inches() {
    let (done, cycles) = (Cell::new(0), RefCell::new(BTreeSet::new()));
    proptest!(crate::cases::config(300), |(
        which in 0_usize..1000, tool in 1_u8..3, shares in prop::collection::vec(0.5..1.6_f64, 40),
        picks in prop::collection::vec(0_usize..6, 40), mirrored in any::<bool>(), scale in prop::option::of(0.5..2.0_f64),
        way in 0_usize..CALLS.len(), global in any::<bool>(),
    )| {
        let all = machining();
        let cycle = all[which % all.len()];
        let on = built().catalogue.on("tnc640").expect("a control");
        let printed = cycle.file.nc_examples.first();
        let mut definition = format!("CYCL DEF {}\n", cycle.key.number);
        for (index, param) in cycle.params.iter().enumerate() {
            let Some(q) = param.q else { continue };
            let example = printed.and_then(|printed| printed.values.get(&q.to_string())).map(String::as_str);
            let Some(example) = param.example.as_deref().or(example) else { continue };
            definition += &format!("{q}={}\n", written(param, example, shares[index % 40], picks[index % 40]));
        }
        let call = if cycle.file.takes_effect == TakesEffect::OnCall { CALLS[way] } else { "" };
        let global = if global { "GLOBAL DEF 125 P\nQ345=0\n" } else { "" };
        let mirror = if mirrored { "CYCL DEF 8.0 M\nCYCL DEF 8.1 X\n" } else { "" };
        let scaling = scale.map_or_else(String::new, |f| format!("CYCL DEF 11.0 S\nCYCL DEF 11.1 SCL {f:.4}\n"));
        let drilling = "CYCL DEF 200\nQ200=2\nQ201=-15\nQ206=250\nQ202=5\nQ210=0\nQ203=+0\nQ204=50\nQ211=0\n";
        let program = format!(
            "BEGIN PGM LAW MM\nTOOL CALL {tool} Z S1000 F500 DR+0.1\n{global}{drilling}{mirror}{scaling}L X+10 Y+20 Z+100 R0 FMAX M3\n\
             {definition}{call}END PGM LAW MM\n"
        );
        let scene = Scene::parse(&Source::new("scene.yaml", TOOLS), &built().files).expect("a scene");
        // A contour of which one axis is in degrees has none.
        let twin = in_inches(&syntax::parse(&Source::new("LAW.H", &program)), on, &built().catalogue);
        let Some(twin) = twin else { return Ok(()) };
        let (mm, inches) = (run(on, &scene, &program), run(on, &scene, &twin));
        prop_assert_eq!(difference(&mm, &inches, SAME), None, "{}\n{}", program, twin);
        if mm.0.status == Status::Done {
            done.set(done.get() + 1);
            cycles.borrow_mut().insert(cycle.key);
        }
    });
    let cycles = cycles.borrow().len();
    assert!(done.get() > 100 && cycles > 20, "{} done, {cycles} cycles", done.get());
}

/// Contours with compensation, roundings, chamfers, arcs, approaches and departures of every kind.
#[test]
fn contours_are_the_same_in_inches() {
    let done = Cell::new(0);
    proptest!(crate::cases::config(150), |(
        left in any::<bool>(), wide in 40.0..90.0_f64, high in 30.0..60.0_f64, round in 1.0..8.0_f64, chamfer in 0.5..6.0_f64,
        arc in 30.0..60.0_f64, lead in 0_usize..4, tool in 1_u8..3, delta in -0.5..0.5_f64, feed in 50.0..900.0_f64,
    )| {
        let at = |value: f64| format!("{value:+.4}");
        let (begin, side) = (["APPR LT X+0 Y+5 LEN8", "APPR LN X+0 Y+5 LEN8", "APPR CT X+0 Y+5 CCA90 R+6", "APPR LCT X+0 Y+5 R6"], if left { "RL" } else { "RR" });
        let end = ["DEP LT LEN8", "DEP LN LEN+8", "DEP CT CCA90 R+6", "DEP LCT X-30 Y-30 R6"];
        let program = format!(
            "BEGIN PGM LAW MM\nTOOL CALL {tool} Z S1000 F500 DR{}\nL X-40 Y-40 Z+50 R0 FMAX M3\nL Z-5 R0 F200\n\
             {} {side} F{feed:.3}\nL Y{}\nRND R{round:.4}\nL X{}\nCHF {chamfer:.4}\nL Y+20\nCR X{} Y+0 R{arc:.4} DR-\n\
             L X+0\nCC X+0 Y-10\nC X-10 Y-10 DR+\n{}\nL Z+50 R0 FMAX\nEND PGM LAW MM\n",
            at(delta), begin[lead], at(high), at(wide), at(wide - 15.0), end[lead],
        );
        let on = built().catalogue.on("tnc640").expect("a control");
        let scene = Scene::parse(&Source::new("scene.yaml", TOOLS), &built().files).expect("a scene");
        let twin = in_inches(&syntax::parse(&Source::new("LAW.H", &program)), on, &built().catalogue).expect("a twin");
        let (mm, inches) = (run(on, &scene, &program), run(on, &scene, &twin));
        prop_assert_eq!(difference(&mm, &inches, SAME), None, "{}\n{}", program, twin);
        done.set(done.get() + usize::from(mm.0.status == Status::Done));
    });
    assert!(done.get() > 100, "{} done", done.get());
}
