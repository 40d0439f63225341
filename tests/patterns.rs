//! Patterns, point tables and calls at positions: where and how high the called cycle works, by numbers that were
//! calculated by hand from the manual's rules (TNC 640, lines 1216-1700).
use ciklo::diag::Source;
use ciklo::engine::run::{Engine, EventKind, MoveKind, NoTexts, Outcome};
use ciklo::engine::scene::Scene;
use ciklo::spec::Catalogue;
use ciklo::syntax;

const SCENE: &str = "scene: 1\ntools: [{T: 1, L: 80, R: 5, CUT: 4}]\n\
    points: {HOLES.PNT: [{NR: 0, X: 1, Y: 2, Z: 3}, {NR: 1, X: 5, Y: 5, FADE: Y}, {NR: 2, X: 7, Y: 5}]}\n";
const DRILL: &str =
    "CYCL DEF 200 D\nQ200=2 ;A\nQ201=-5 ;B\nQ206=150 ;C\nQ202=5 ;D\nQ210=0 ;E\nQ203=+1 ;F\nQ204=10 ;G\nQ211=0 ;H\n";

fn run(body: &str, other: Option<&str>) -> (Outcome, Vec<EventKind>) {
    let files = ciklo::data::embedded();
    let (catalogue, _) = Catalogue::load(&files);
    let on = catalogue.on("tnc640").expect("a control");
    let scene = Scene::parse(&Source::new("scene.yaml", SCENE), &files).expect("a scene");
    let main = format!("BEGIN PGM A MM\nTOOL CALL 1 Z S1000 F500\n{body}END PGM A MM\n");
    let main = syntax::parse(&Source::new("A.H", &main));
    let other = syntax::parse(&Source::new("SUB.H", other.unwrap_or("BEGIN PGM SUB MM\nEND PGM SUB MM\n")));
    let mut events = Vec::new();
    let engine = Engine::new(&main, on, &scene, &NoTexts).with_program("SUB.H", &other);
    let outcome = engine.run(&mut |event| events.push(event.kind));
    (outcome, events)
}

/// Where the tool plunges: the ends of the feed moves along the tool axis.
fn plunges(body: &str) -> Vec<[f64; 3]> {
    let (outcome, events) = run(body, None);
    assert!(outcome.fault.is_none(), "{:?}", outcome.fault);
    let ends = events.iter().filter_map(|event| match event {
        EventKind::Move { kind: MoveKind::Feed, from, to, .. } if to.z < from.z => Some(to.to_array()),
        _ => None,
    });
    // A thousandth is far more than rounding.
    ends.map(|point| point.map(|value| (value * 1000.0).round() / 1000.0)).collect()
}

fn on_pattern(pattern: &str) -> Vec<[f64; 3]> {
    plunges(&format!("{DRILL}PATTERN DEF {pattern}\nCYCL CALL PAT FMAX M3\n"))
}

#[test]
fn every_form_of_a_pattern_has_its_points() {
    // The surface of 1 and the coordinate of the point add up; the hole is 5 deep.
    assert_eq!(on_pattern("POS1 (X+25 Y+33,5 Z+0) POS2 (X+50 Y+75 Z+3)"), [[25.0, 33.5, -4.0], [50.0, 75.0, -1.0]]);
    assert_eq!(
        on_pattern("ROW1 (X+25 Y+30 D+8 NUM3 ROT+90 Z+0)"),
        [[25.0, 30.0, -4.0], [25.0, 38.0, -4.0], [25.0, 46.0, -4.0]]
    );
    // To and fro in lines; the minor axis is turned by 90° on top of the rotation of 0.
    assert_eq!(
        on_pattern("PAT1 (X+10 Y+20 DX+8 DY+5 NUMX2 NUMY2 ROT+0 ROTX+0 ROTY+0 Z+0)"),
        [[10.0, 20.0, -4.0], [18.0, 20.0, -4.0], [18.0, 25.0, -4.0], [10.0, 25.0, -4.0]]
    );
    // The whole by 90°, the main axis by another 90°: along -X and along -X.
    assert_eq!(
        on_pattern("PAT1 (X+10 Y+20 DX+8 DY+5 NUMX2 NUMY2 ROT+90 ROTX+90 ROTY+0 Z+0)"),
        [[10.0, 20.0, -4.0], [2.0, 20.0, -4.0], [-3.0, 20.0, -4.0], [5.0, 20.0, -4.0]]
    );
    // Around: 3 by 3 points without the one in the middle.
    let frame = on_pattern("FRAME1 (X+0 Y+0 DX+8 DY+10 NUMX3 NUMY3 ROT+0 ROTX+0 ROTY+0 Z+0)");
    let flat: Vec<[f64; 2]> = frame.iter().map(|[x, y, _]| [*x, *y]).collect();
    let around =
        [[0.0, 0.0], [8.0, 0.0], [16.0, 0.0], [16.0, 10.0], [16.0, 20.0], [8.0, 20.0], [0.0, 20.0], [0.0, 10.0]];
    assert_eq!(flat, around);
    assert_eq!(
        on_pattern("CIRC1 (X+25 Y+33 D80 START+90 NUM4 Z+0)"),
        [[25.0, 73.0, -4.0], [-15.0, 33.0, -4.0], [25.0, -7.0, -4.0], [65.0, 33.0, -4.0]]
    );
    let arc = [[65.0, 33.0, -4.0], [45.0, 67.641, -4.0]];
    assert_eq!(on_pattern("PITCHCIRC1 (X+25 Y+33 D80 START+0 STEP+60 NUM2 Z+0)"), arc);
    assert_eq!(on_pattern("PITCHCIRC1 (X+25 Y+33 D80 START+0 END+60 NUM2 Z+0)"), arc);
}

#[test]
fn hidden_points_of_a_table_are_left_out() {
    let body = format!("{DRILL}SEL PATTERN \"TNC:\\PARTS\\HOLES.PNT\"\nCYCL CALL PAT F5000 M3\n");
    assert_eq!(plunges(&body), [[1.0, 2.0, -1.0], [7.0, 5.0, -4.0]]);
}

/// Between two points the tool goes to the greater of the height at the call and the second clearance.
#[test]
fn the_greater_height_is_that_between_points() {
    let between = |z: &str| {
        let body = format!(
            "{DRILL}L Z{z} R0 FMAX\nPATTERN DEF POS1 (X+10 Y+0 Z+0) POS2 (X+20 Y+0 Z+0)\nCYCL CALL PAT F5000 M3\n"
        );
        let (_, events) = run(&body, None);
        let to_second = events.iter().find_map(|event| match event {
            EventKind::Move { from, to, feed, .. } if from.x == 10.0 && to.x == 20.0 => Some((to.z, *feed)),
            _ => None,
        });
        to_second.expect("a move")
    };
    // 1 + 10 is the second clearance.
    assert_eq!(between("+5"), (11.0, 5000.0));
    assert_eq!(between("+30"), (30.0, 5000.0));
}

#[test]
fn a_call_at_a_position_shifts_the_surface() {
    let body =
        format!("{DRILL}L Z+50 R0 FMAX M3\nCYCL CALL POS X+10 Y+20 Z+5 FMAX\nCYCL CALL POS IX+1 Y+20 Z+0 F300\n");
    assert_eq!(plunges(&body), [[10.0, 20.0, 1.0], [11.0, 20.0, -4.0]]);
    // Below the surface of 1 + 30 the tool goes up to the second clearance first.
    let body = format!("{DRILL}L Z+20 R0 FMAX M3\nCYCL CALL POS X+10 Y+20 Z+30 FMAX\n");
    let (_, events) = run(&body, None);
    let moves: Vec<[f64; 3]> = events
        .iter()
        .filter_map(|event| if let EventKind::Move { to, .. } = event { Some(to.to_array()) } else { None })
        .collect();
    assert_eq!(moves.get(1..3), Some(&[[0.0, 0.0, 41.0], [10.0, 20.0, 41.0]][..]));
}

/// A program as a cycle has its datum at the point, and goes on behind the call.
#[test]
fn a_program_is_called_on_every_point() {
    let body = "CYCL DEF 12.0 PGM CALL\nCYCL DEF 12.1 PGM TNC:\\SUB.H\n\
        PATTERN DEF POS1 (X+10 Y+0 Z+0) POS2 (X+20 Y+5 Z+1)\nCYCL CALL PAT FMAX M3\nL X+1 Y+1 R0 FMAX\n";
    let (outcome, events) = run(body, Some("BEGIN PGM SUB MM\nL X+2 Y+3 Z-4 F100\nL Z+50 FMAX\nEND PGM SUB MM\n"));
    assert!(outcome.fault.is_none(), "{:?}", outcome.fault);
    let fed = events.iter().filter_map(|event| match event {
        EventKind::Move { kind: MoveKind::Feed, machine, .. } => Some(machine.to_array()),
        _ => None,
    });
    assert_eq!(fed.collect::<Vec<_>>(), [[12.0, 3.0, -4.0], [22.0, 8.0, -3.0]]);
    assert_eq!(outcome.position.to_array(), [1.0, 1.0, 51.0]);
}

/// Values of GLOBAL DEF and feeds are those of the moment of the definition.
#[test]
fn words_are_resolved_when_the_cycle_is_defined() {
    let pocket = "CYCL DEF 252 P\nQ215=1\nQ223=30\nQ368=0\nQ207=500\nQ351=+1\nQ201=-5\nQ202=5\nQ369=0\nQ206=FZ0.1\nQ338=0\n\
        Q200=PREDEF\nQ203=0\nQ204=PREDEF\nQ370=1\nQ366=0\nQ385=500\n";
    let body = format!(
        "1 GLOBAL DEF 100 GENERAL\nQ200=3 ;A\nQ204=20 ;B\n{pocket}2 GLOBAL DEF 100 GENERAL\nQ200=7 ;A\nQ204=40 ;B\nTOOL CALL S2000\nCYCL CALL M3\n"
    );
    let (outcome, events) = run(&body, None);
    assert!(outcome.fault.is_none(), "{:?}", outcome.fault);
    let moves: Vec<(f64, f64)> = events
        .iter()
        .filter_map(|event| if let EventKind::Move { to, feed, .. } = event { Some((to.z, *feed)) } else { None })
        .collect();
    // Second clearance 20, clearance 3, then 0.1 · 4 · 1000 mm/min.
    assert_eq!(moves.first().map(|m| m.0), Some(20.0));
    assert_eq!(moves.get(1).map(|m| m.0), Some(3.0));
    assert_eq!(moves.get(2), Some(&(-5.0, 400.0)));
}
