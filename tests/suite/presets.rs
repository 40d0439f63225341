//! Values of definitions: presets of GLOBAL DEF, feeds by words, what is frozen when a cycle is defined and what is not.
use ciklo::base::diag::Source;
use ciklo::engine::run::{Engine, Event, EventKind, NoTexts, Outcome, Status};
use ciklo::engine::scene::Scene;
use ciklo::program::syntax;
use ciklo::spec::{Catalogue, Cycle, Keyword, OnControl, Param, TakesEffect};
use std::sync::OnceLock;

struct World {
    files: ciklo::base::data::Files,
    catalogue: &'static Catalogue,
}

fn world() -> &'static World {
    static WORLD: OnceLock<World> = OnceLock::new();
    WORLD.get_or_init(|| {
        let files = ciklo::base::data::embedded();
        let catalogue = &crate::built::built().catalogue;
        World { files, catalogue }
    })
}

const SCENE: &str = "scene: 1\ntools: [{T: 1, L: 80, R: 3, CUT: 4, ANGLE: 90, LCUTS: 40, T-ANGLE: 118}]\n";

fn run_on(on: &OnControl, text: &str) -> (Outcome, Vec<Event>) {
    let world = world();
    let scene = Scene::parse(&Source::new("scene.yaml", SCENE), &world.files).expect("a scene");
    let program = syntax::parse(&Source::new("A.H", text));
    let mut events = Vec::new();
    let engine = Engine::new(&program, on, &scene, &NoTexts).with_catalogue(world.catalogue);
    let outcome = engine.run(&mut |event| events.push(event));
    (outcome, events)
}

fn run(body: &str) -> (Outcome, Vec<Event>) {
    let on = world().catalogue.on("tnc640").expect("a control");
    run_on(on, &format!("BEGIN PGM A MM\nTOOL CALL 1 Z S1000 F500\n{body}END PGM A MM\n"))
}

/// The ends and feeds of all moves; the rapid rates of the machine stand for rapid traverse.
fn moves(body: &str) -> Vec<([f64; 3], f64)> {
    let (outcome, events) = run(body);
    assert!(outcome.fault.is_none(), "{:?}", outcome.fault);
    let moves = events.iter().filter_map(|event| match event.kind {
        EventKind::Move { to, feed, .. } => Some((to.to_array().map(|v| (v * 1000.0).round() / 1000.0), feed)),
        _ => None,
    });
    moves.collect()
}

/// What an event says without its place in the program.
fn told(events: &[Event]) -> Vec<String> {
    let mut all = Vec::new();
    for event in events {
        let mut json = event.to_json();
        if let Some(map) = json.as_object_mut() {
            map.remove("line");
        }
        all.push(json.to_string());
    }
    all
}

/// A definition with the printed values, one of them as given.
fn definition(cycle: &Cycle, own: &Param, value: &str) -> String {
    let printed = cycle.file.nc_examples.first();
    let mut text = format!("{} {}\n", cycle.key.keyword.as_str(), cycle.key.number);
    for param in &cycle.params {
        let Some(q) = param.q else { continue };
        let example = printed.and_then(|printed| printed.values.get(&q.to_string())).map(String::as_str);
        let Some(example) = param.example.as_deref().or(example) else { continue };
        text += &format!("{q}={}\n", if param.q == own.q { value } else { example });
    }
    text
}

/// Every parameter of every cycle that takes PREDEF does with a preset what it does with the value itself, and is
/// refused without one.
#[test]
fn a_preset_is_as_good_as_the_value() {
    let (mut compared, mut done) = (0, 0);
    for on in world().catalogue.controls.values() {
        for cycle in on.cycles.values() {
            for param in cycle.params.iter().filter(|param| param.words.iter().any(|word| word == "PREDEF")) {
                let Some(q) = param.q else { continue };
                let value = match param.choices.first() {
                    Some(choice) => choice.value.as_str().to_owned(),
                    None if param.is_measured() => "7.5".to_owned(),
                    None => "0.8".to_owned(),
                };
                let call = cycle.file.takes_effect == TakesEffect::OnCall;
                let program = |value: &str, presets: &str| {
                    let definition = definition(cycle, param, value);
                    let call = if call { "CYCL CALL M3\n" } else { "" };
                    format!("BEGIN PGM A MM\nTOOL CALL 1 Z S1000 F500\n{presets}{definition}{call}END PGM A MM\n")
                };
                let presets = format!("GLOBAL DEF 100 P\n{q}={value}\n");
                let (plain, by_preset) = (run_on(on, &program(&value, "")), run_on(on, &program("PREDEF", &presets)));
                let name = format!("{} {} {q}", on.id(), cycle.key);
                assert_eq!(told(&plain.1), told(&by_preset.1), "{name}");
                let without = run_on(on, &program("PREDEF", "")).0;
                assert_eq!(
                    without.fault.map(|f| f.code.to_string()).as_deref(),
                    Some("value-not-predefined"),
                    "{name}"
                );
                compared += 1;
                done += usize::from(plain.0.status == Status::Done && cycle.key.keyword == Keyword::CyclDef);
            }
        }
    }
    assert!(compared > 30 && done > 20, "{done} done of {compared}");
}

const DRILL: &str =
    "CYCL DEF 200\nQ200=2 ;A\nQ201=-5 ;B\nQ206=150 ;C\nQ202=5 ;D\nQ210=0 ;E\nQ203=+1 ;F\nQ204=10 ;G\nQ211=0 ;H\n";

/// A drilling cycle with that feed and depth.
fn drill(feed: &str, depth: &str) -> String {
    DRILL.replace("Q206=150", &format!("Q206={feed}")).replace("Q201=-5", &format!("Q201={depth}"))
}

/// The feed with which the drill goes into the material.
fn plunge(body: &str) -> f64 {
    let all = moves(body);
    let down = all.windows(2).find(|pair| pair[1].0[2] < 1.0).expect("a hole");
    down[1].1
}

/// S1000 and 4 teeth: 0.2 mm a turn are 200 mm/min, 0.1 mm a tooth 400 mm/min.
#[test]
fn feeds_by_words_are_those_of_the_definition() {
    assert_eq!(plunge(&format!("{}CYCL CALL M3\n", drill("FAUTO", "-5"))), 500.0);
    assert_eq!(plunge(&format!("TOOL CALL 1 Z S1000 FU0.2\n{}CYCL CALL M3\n", drill("FAUTO", "-5"))), 200.0);
    assert_eq!(plunge(&format!("TOOL CALL 1 Z S1000 FZ0.1\n{}CYCL CALL M3\n", drill("FAUTO", "-5"))), 400.0);
    assert_eq!(plunge(&format!("{}CYCL CALL M3\n", drill("FU0.2", "-5"))), 200.0);
    // The feed of the tool call at the moment of the definition stays, whatever the next call says.
    assert_eq!(plunge(&format!("{}TOOL CALL S2000 F900\nCYCL CALL M3\n", drill("FAUTO", "-5"))), 500.0);
    assert_eq!(plunge(&format!("{}TOOL CALL S2000\nCYCL CALL M3\n", drill("FU0.2", "-5"))), 200.0);
    // The F of the program is not the one of the cycle, and FAUTO brings back the one of the tool call.
    let all = moves("L X+1 R0 F700\nL X+2 R0\nL X+3 R0 FAUTO\nL X+4 R0 FU0.3\nL X+5 R0 FZ0.2\n");
    assert_eq!(all.iter().map(|(_, feed)| *feed).collect::<Vec<_>>(), [700.0, 700.0, 500.0, 300.0, 800.0]);
    // FMAX as the feed of a retraction is the rapid traverse of the machine, as of a block with FMAX.
    let out = |feed: &str| {
        let drill =
            "Q200=2\nQ201=-5\nQ206=150\nQ202=5\nQ210=0\nQ203=+0\nQ204=10\nQ212=0\nQ213=0\nQ205=0\nQ211=0\nQ256=0.2\n";
        let all = moves(&format!("CYCL DEF 203\n{drill}Q208={feed}\nCYCL CALL M3\n"));
        all.windows(2).find(|pair| pair[0].0[2] == -5.0).map(|pair| pair[1].1)
    };
    assert_eq!(out("250"), Some(250.0));
    assert_eq!(out("FMAX"), moves("L Z+90 FMAX\n").first().map(|(_, feed)| *feed));
}

/// A parameter that a definition took from another one keeps its value; the transfer parameter itself is the program's.
#[test]
fn values_are_frozen_when_the_cycle_is_defined() {
    let depth = |between: &str| {
        let body = format!("Q1 = - 5\n{}Q1 = - 8\n{between}CYCL CALL M3\n", drill("150", "Q1"));
        moves(&body).iter().map(|(to, _)| to[2]).fold(f64::MAX, f64::min)
    };
    assert_eq!(depth(""), -4.0);
    // Written by the program between definition and call, the value counts.
    assert_eq!(depth("Q201 = - 3\n"), -2.0);
    // The next definition reads the parameter again.
    assert_eq!(depth(&drill("150", "Q1")), -7.0);
}

/// Cycles that act when they are defined stand between definition and call without becoming the one that is called; the
/// parameters that they share with it are theirs from then on.
#[test]
fn cycles_that_act_at_once_change_what_they_share() {
    let row =
        "CYCL DEF 221\nQ225=10\nQ226=0\nQ237=8\nQ238=5\nQ242=2\nQ243=1\nQ224=0\nQ200=3\nQ203=+6\nQ204=20\nQ301=1\n";
    let circle = "CYCL DEF 220\nQ216=50\nQ217=50\nQ244=80\nQ245=0\nQ246=360\nQ247=0\nQ241=1\nQ200=3\nQ203=+6\nQ204=20\nQ301=1\nQ365=0\n";
    for pattern in [row, circle] {
        let all = moves(&format!("{DRILL}M3\n{pattern}"));
        // Surface 6 of the pattern, not 1 of the cycle: holes end at 1; clearance 3: at 9; second clearance 20: at 26.
        let low = all.iter().map(|(to, _)| to[2]).fold(f64::MAX, f64::min);
        assert_eq!(low, 1.0);
        assert!(all.iter().any(|(to, _)| to[2] == 9.0));
        assert_eq!(all.last().map(|(to, _)| to[2]), Some(26.0));
        // The cycle called behind it still has the heights of the pattern, until it is defined again.
        let again = moves(&format!("{DRILL}M3\n{pattern}L X+0 Y+0 R0 FMAX\nCYCL CALL\n"));
        assert_eq!(again.iter().rev().map(|(to, _)| to[2]).find(|z| *z < 5.0), Some(1.0));
        let anew = moves(&format!("{DRILL}M3\n{pattern}{DRILL}CYCL CALL\n"));
        assert_eq!(anew.iter().rev().map(|(to, _)| to[2]).find(|z| *z < 5.0), Some(-4.0));
    }
    // A datum shift and a dwell change neither what is called nor its values.
    let body =
        format!("{DRILL}CYCL DEF 7.0 D\nCYCL DEF 7.1 Z+10\nCYCL DEF 9.0 D\nCYCL DEF 9.1 V.ZEIT 2\nCYCL CALL M3\n");
    assert_eq!(moves(&body).iter().map(|(to, _)| to[2]).fold(f64::MAX, f64::min), -4.0);
}

/// Presets that a program in inches defines are lengths in inches, for a program in mm that it calls, too.
#[test]
fn presets_are_in_the_unit_of_their_program() {
    let on = world().catalogue.on("tnc640").expect("a control");
    let pocket = |unit: f64| {
        let len = |mm: f64| mm / unit;
        format!(
            "CYCL DEF 252 P\nQ215=1\nQ223={}\nQ368=0\nQ207={}\nQ351=+1\nQ201={}\nQ202={}\nQ369=0\nQ206={}\nQ338=0\n\
             Q200=PREDEF\nQ203=0\nQ204=PREDEF\nQ370=1\nQ366=0\nQ385={}\nCYCL CALL M3\n",
            len(30.0),
            len(500.0),
            len(-5.0),
            len(5.0),
            len(100.0),
            len(500.0)
        )
    };
    let run = |main: &str, sub: &str| {
        let world = world();
        let scene = Scene::parse(&Source::new("scene.yaml", SCENE), &world.files).expect("a scene");
        let (main, sub) = (syntax::parse(&Source::new("A.H", main)), syntax::parse(&Source::new("SUB.H", sub)));
        let mut ends = Vec::new();
        let outcome = Engine::new(&main, on, &scene, &NoTexts).with_program("SUB.H", &sub).run(&mut |event| {
            if let EventKind::Move { to, .. } = event.kind {
                ends.push(to.to_array().map(|v| (v * 1e6).round() / 1e6));
            }
        });
        assert!(outcome.fault.is_none(), "{:?}", outcome.fault);
        ends
    };
    let presets = |unit: f64| format!("GLOBAL DEF 100 P\nQ200={}\nQ204={}\n", 3.0 / unit, 20.0 / unit);
    let mm =
        run(&format!("BEGIN PGM A MM\nTOOL CALL 1 Z S1000 F500\n{}{}END PGM A MM\n", presets(1.0), pocket(1.0)), "");
    let called = run(
        &format!("BEGIN PGM A INCH\nTOOL CALL 1 Z S1000 F20\n{}CALL PGM SUB\nEND PGM A INCH\n", presets(25.4)),
        &format!("BEGIN PGM SUB MM\n{}END PGM SUB MM\n", pocket(1.0)),
    );
    let inches = run(
        &format!("BEGIN PGM A INCH\nTOOL CALL 1 Z S1000 F20\n{}{}END PGM A INCH\n", presets(25.4), pocket(25.4)),
        "",
    );
    assert_eq!(mm, called);
    assert_eq!(mm, inches);
    assert!(mm.iter().any(|point| point[2] == 3.0) && mm.iter().any(|point| point[2] == 20.0));
}
