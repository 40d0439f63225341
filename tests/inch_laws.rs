//! Laws of programs in inches: the same part programmed in mm and in inches gives the same motions, and a probe finds
//! the same truth. Every example of the specifications is told in inches, and the definitions of all cycles with
//! parameters, with random values, are executed in both units.
use std::sync::OnceLock;

use ciklo::conform::{self, LogTexts};
use ciklo::diag::Source;
use ciklo::engine::run::{Engine, Event, EventKind, Outcome, Status};
use ciklo::engine::scene::Scene;
use ciklo::locale::Locales;
use ciklo::spec::{Catalogue, Cycle, Keyword, OnControl, Param, TakesEffect};
use ciklo::syntax;
use proptest::prelude::*;
use serde_json::Value;

#[path = "support/inch.rs"]
mod inch;
use inch::{INCH, in_inches};

/// How far coordinates in mm and feeds may lie apart, in parts of themselves where they are greater than 1.
const SAME: f64 = 1e-9;

struct World {
    files: ciklo::data::Files,
    catalogue: Catalogue,
    locales: Locales,
}

fn world() -> &'static World {
    static WORLD: OnceLock<World> = OnceLock::new();
    WORLD.get_or_init(|| {
        let files = ciklo::data::embedded();
        let (catalogue, _) = Catalogue::load(&files);
        let (locales, _) = Locales::load(files.iter().map(|(path, text)| (path, text)));
        World { files, catalogue, locales }
    })
}

fn run(on: &OnControl, scene: &Scene, text: &str) -> (Outcome, Vec<Event>) {
    let world = world();
    let language = world.locales.language("en").expect("the source language");
    let texts = LogTexts::new(language, on.id(), &world.files);
    let program = syntax::parse(&Source::new("LAW.H", text));
    let mut events = Vec::new();
    let engine = Engine::new(&program, on, scene, &texts).with_catalogue(&world.catalogue);
    let outcome = engine.run(&mut |event| events.push(event));
    (outcome, events)
}

/// Where two documents differ by more than rounding.
fn apart(mm: &Value, inch: &Value, path: &str) -> Option<String> {
    match (mm, inch) {
        (Value::Number(a), Value::Number(b)) => {
            let (a, b) = (a.as_f64()?, b.as_f64()?);
            ((a - b).abs() > SAME * (1.0 + b.abs())).then(|| format!("{path}: {a} in mm, {b} in inches"))
        }
        (Value::Object(a), Value::Object(b)) if a.len() == b.len() => {
            a.iter().find_map(|(key, value)| apart(value, b.get(key).unwrap_or(&Value::Null), &format!("{path}.{key}")))
        }
        (Value::Array(a), Value::Array(b)) if a.len() == b.len() => {
            a.iter().zip(b).enumerate().find_map(|(i, (a, b))| apart(a, b, &format!("{path}[{i}]")))
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
fn difference(mm: &(Outcome, Vec<Event>), inch: &(Outcome, Vec<Event>)) -> Option<String> {
    let (a, b) = (told(&mm.1), told(&inch.1));
    let first = a.iter().zip(&b).find_map(|(a, b)| apart(a, b, &a["line"].to_string()));
    let lengths = || (a.len() != b.len()).then(|| format!("{} events in mm, {} in inches", a.len(), b.len()));
    let params = || {
        mm.0.params.numbers().find_map(|(number, value)| {
            let other = inch.0.params.numbers().find(|(known, _)| *known == number).map(|(_, value)| value);
            let Some(other) = other else { return Some(format!("Q{number} is {value} in mm and missing in inches")) };
            let near = |a: f64, b: f64| (a - b).abs() <= SAME * (1.0 + b.abs());
            let told = || format!("Q{number} is {value} in mm and {other} in inches");
            (!near(value, other) && !near(value, other * INCH)).then(told)
        })
    };
    first.or_else(lengths).or_else(params)
}

#[test]
fn every_example_does_the_same_in_inches() {
    let world = world();
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
        if let Some(what) = difference(&mm, &inches) {
            found.push(format!("{} {} {}: {what}", case.on.id(), case.cycle.key, case.name));
        }
    }
    assert!(found.is_empty(), "{} of {compared}:\n{}", found.len(), found.join("\n"));
    assert!(done > 500 && without * 10 < compared, "{done} done of {compared}, {without} without a twin");
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
    let on = world().catalogue.on("tnc640").expect("a control");
    let own = |cycle: &&Cycle| cycle.key.keyword == Keyword::CyclDef && !cycle.is_old_style();
    on.cycles.values().filter(own).collect()
}

const TOOLS: &str = "scene: 1\nmachine: mill-3-axis\nstart: {Z: 200}\n\
    tools: [{T: 1, L: 80, R: 3, CUT: 4, ANGLE: 30, LCUTS: 40}, {T: 2, L: 80, R: 1.5, CUT: 2, ANGLE: 90, T-ANGLE: 118}]\n";

proptest! {
    #![proptest_config(ProptestConfig { cases: 600, ..ProptestConfig::default() })]

    #[test]
    fn every_machining_cycle_does_the_same_in_inches(
        which in 0_usize..1000, tool in 1_u8..3, shares in prop::collection::vec(0.5..1.6_f64, 40),
        picks in prop::collection::vec(0_usize..6, 40), mirrored in any::<bool>(), scale in prop::option::of(0.5..2.0_f64),
    ) {
        let all = machining();
        let cycle = all[which % all.len()];
        let on = world().catalogue.on("tnc640").expect("a control");
        let printed = cycle.file.nc_examples.first();
        let mut definition = format!("CYCL DEF {}\n", cycle.key.number);
        for (index, param) in cycle.params.iter().enumerate() {
            let Some(q) = param.q else { continue };
            let example = printed.and_then(|printed| printed.values.get(&q.to_string())).map(String::as_str);
            let Some(example) = param.example.as_deref().or(example) else { continue };
            definition += &format!("{q}={}\n", written(param, example, shares[index % 40], picks[index % 40]));
        }
        let call = if cycle.file.takes_effect == TakesEffect::OnCall { "CYCL CALL\n" } else { "" };
        let mirror = if mirrored { "CYCL DEF 8.0 M\nCYCL DEF 8.1 X\n" } else { "" };
        let scaling = scale.map_or_else(String::new, |f| format!("CYCL DEF 11.0 S\nCYCL DEF 11.1 SCL {f:.4}\n"));
        let drilling = "CYCL DEF 200\nQ200=2\nQ201=-15\nQ206=250\nQ202=5\nQ210=0\nQ203=+0\nQ204=50\nQ211=0\n";
        let program = format!(
            "BEGIN PGM LAW MM\nTOOL CALL {tool} Z S1000 F500 DR+0.1\n{drilling}{mirror}{scaling}L X+10 Y+20 Z+100 R0 FMAX M3\n\
             {definition}{call}END PGM LAW MM\n"
        );
        let scene = Scene::parse(&Source::new("scene.yaml", TOOLS), &world().files).expect("a scene");
        let twin = in_inches(&syntax::parse(&Source::new("LAW.H", &program)), on, &world().catalogue).expect("a twin");
        let (mm, inches) = (run(on, &scene, &program), run(on, &scene, &twin));
        // A pattern that is called goes on with the cycle before it; what a specification leaves open stays open.
        prop_assert_eq!(difference(&mm, &inches), None, "{}\n{}", program, twin);
    }
}
