//! Patterns, point tables and calls at positions: where and how high the called cycle works, by numbers that were
//! calculated by hand from the manual's rules (TNC 640, lines 1216-1700).
#![expect(clippy::disallowed_methods, reason = "truths are calculated with plain trigonometry")]

use ciklo::base::diag::Source;
use ciklo::engine::run::{Engine, EventKind, MoveKind, NoTexts, Outcome};
use ciklo::engine::scene::Scene;
use ciklo::program::syntax;
use proptest::prelude::*;

use crate::built;
use built::{Built, built};

const SCENE: &str = "scene: 1\ntools: [{T: 1, L: 80, R: 5, CUT: 4}]\n\
    points: {HOLES.PNT: [{NR: 0, X: 1, Y: 2, Z: 3}, {NR: 1, X: 5, Y: 5, FADE: Y}, {NR: 2, X: 7, Y: 5}]}\n";
const DRILL: &str =
    "CYCL DEF 200 D\nQ200=2 ;A\nQ201=-5 ;B\nQ206=150 ;C\nQ202=5 ;D\nQ210=0 ;E\nQ203=+1 ;F\nQ204=10 ;G\nQ211=0 ;H\n";

fn run(body: &str, other: Option<&str>) -> (Outcome, Vec<EventKind>) {
    let Built { files, catalogue, .. } = built();
    let on = catalogue.on("tnc640").expect("a control");
    let scene = Scene::parse(&Source::new("scene.yaml", SCENE), files).expect("a scene");
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
    plunges(&format!("{DRILL}PATTERN DEF {pattern}\nCYCL CALL PAT F5000 M3\n"))
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
        PATTERN DEF POS1 (X+10 Y+0 Z+0) POS2 (X+20 Y+5 Z+1)\nCYCL CALL PAT F5000 M3\nL X+1 Y+1 R0 FMAX\n";
    let (outcome, events) = run(body, Some("BEGIN PGM SUB MM\nL X+2 Y+3 Z-4 F100\nL Z+50 FMAX\nEND PGM SUB MM\n"));
    assert!(outcome.fault.is_none(), "{:?}", outcome.fault);
    let fed = events.iter().filter_map(|event| match event {
        EventKind::Move { kind: MoveKind::Feed, machine, .. } if machine.z < 0.0 => Some(machine.to_array()),
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

/// A row of main, minor and tool axis coordinates by the letters of the axes, for the tool axes Z, Y and X.
fn by_axis(tool: &str, point: [f64; 3]) -> [f64; 3] {
    let [main, minor, height] = point;
    match tool {
        "Z" => [main, minor, height],
        "Y" => [minor, height, main],
        _ => [height, main, minor],
    }
}

/// Where the tool is after each feed move.
fn fed(program: &str, scene: &str) -> Vec<[f64; 3]> {
    let Built { files, catalogue, .. } = built();
    let on = catalogue.on("tnc640").expect("a control");
    let scene = Scene::parse(&Source::new("scene.yaml", scene), files).expect("a scene");
    let program = syntax::parse(&Source::new("A.H", program));
    let mut events = Vec::new();
    let outcome = Engine::new(&program, on, &scene, &NoTexts).run(&mut |event| events.push(event.kind));
    assert!(outcome.fault.is_none(), "{:?}", outcome.fault);
    let ends = events.iter().filter_map(|event| match event {
        EventKind::Move { kind: MoveKind::Feed, to, .. } => Some(to.to_array()),
        _ => None,
    });
    ends.map(|point| point.map(|value| (value * 1000.0).round() / 1000.0)).collect()
}

/// Point tables and the pattern cycles work with every tool axis: the columns are axes, the surface counts along the tool.
#[test]
fn points_of_tables_are_those_of_the_tool_axis() {
    for tool in ["Z", "Y", "X"] {
        // Main 11, minor 22, surface 3 above the 1 of the cycle: the hole ends 5 deeper.
        let [x, y, z] = by_axis(tool, [11.0, 22.0, 3.0]);
        let scene = format!(
            "scene: 1\ntools: [{{T: 1, L: 80, R: 5}}]\npoints: {{H.PNT: [{{NR: 0, X: {x}, Y: {y}, Z: {z}}}]}}\n"
        );
        let program = format!(
            "BEGIN PGM A MM\nTOOL CALL 1 {tool} S1000 F500\n{DRILL}SEL PATTERN \"H.PNT\"\nCYCL CALL PAT F900 M3\nEND PGM A MM\n"
        );
        let found = fed(&program, &scene);
        assert!(found.contains(&by_axis(tool, [11.0, 22.0, -1.0])), "{tool}: {found:?}");
        // Two columns and two lines of 221, turned by 90°: 8 along the main axis become 8 along the minor one.
        let rows = "CYCL DEF 221\nQ225=10\nQ226=20\nQ237=8\nQ238=5\nQ242=2\nQ243=2\nQ224=90\nQ200=2\nQ203=0\nQ204=20\nQ301=1\n";
        let program = format!("BEGIN PGM A MM\nTOOL CALL 1 {tool} S1000 F500\nM3\n{DRILL}{rows}END PGM A MM\n");
        let bottoms: Vec<[f64; 3]> =
            [[10.0, 20.0], [10.0, 28.0], [5.0, 28.0], [5.0, 20.0]].map(|[a, b]| by_axis(tool, [a, b, -5.0])).to_vec();
        let found = fed(&program, &scene);
        let at_bottom: Vec<[f64; 3]> = found.into_iter().filter(|point| bottoms.contains(point)).collect();
        assert_eq!(at_bottom, bottoms, "{tool}");
    }
}

/// ROTX and ROTY turn the axes of the pattern on top of ROT, about the starting point.
#[test]
fn axes_of_a_pattern_turn_by_themselves() {
    let found = on_pattern("PAT1 (X+10 Y+20 DX+8 DY+5 NUMX3 NUMY2 ROT+30 ROTX+10 ROTY-20 Z+2)");
    // Main axis at 30° + 10°, minor axis at 90° + 30° - 20°; the surface lies at 1 + 2, the hole ends 5 deeper.
    let (main, minor) = ((40.0_f64).to_radians().sin_cos(), (100.0_f64).to_radians().sin_cos());
    let order = [(0.0, 0.0), (1.0, 0.0), (2.0, 0.0), (2.0, 1.0), (1.0, 1.0), (0.0, 1.0)];
    let wanted = order.map(|(column, line): (f64, f64)| {
        let x = 10.0 + 8.0 * column * main.1 + 5.0 * line * minor.1;
        let y = 20.0 + 8.0 * column * main.0 + 5.0 * line * minor.0;
        [x, y, -2.0].map(|value| (value * 1000.0).round() / 1000.0)
    });
    assert_eq!(found, wanted);
}

/// The heights and feeds of the moves beside the tool axis and along it at rapid, in their order.
fn heights(body: &str) -> Vec<f64> {
    let (outcome, events) = run(body, None);
    assert!(outcome.fault.is_none(), "{:?}", outcome.fault);
    events.iter().filter_map(|event| if let EventKind::Move { to, .. } = event { Some(to.z) } else { None }).collect()
}

/// How the tool is retracted: to the greater height, or to the one that GLOBAL DEF 125 chooses.
#[test]
fn a_definition_chooses_the_height_between_points() {
    let at = |choice: &str, z: &str| {
        let body = format!(
            "{choice}{DRILL}L Z{z} R0 FMAX\nPATTERN DEF POS1 (X+10 Y+0 Z+0) POS2 (X+20 Y+0 Z+0)\nCYCL CALL PAT F5000 M3\n"
        );
        let heights = heights(&body);
        // After the two holes: where the tool is at the end, and on its way from hole to hole (before -4 comes again).
        let first = heights.iter().position(|z| *z == -4.0).expect("a hole");
        let rest = &heights[first + 1..];
        let second = rest.iter().position(|z| *z == -4.0).expect("a second hole");
        (rest[..second].iter().copied().fold(f64::MIN, f64::max), *heights.last().expect("a move"))
    };
    // The second clearance lies at 1 + 10, the drill ends there.
    assert_eq!(at("", "+30"), (30.0, 11.0));
    assert_eq!(at("GLOBAL DEF 125 P\nQ345=0\n", "+30"), (11.0, 11.0));
    assert_eq!(at("GLOBAL DEF 125 P\nQ345=1\n", "+30"), (30.0, 30.0));
    assert_eq!(at("GLOBAL DEF 125 P\nQ345=1\n", "+5"), (11.0, 11.0));
}

/// The feed of a call on a pattern is that of the last F word unless it has one; that of a call at a position is its own.
#[test]
fn feeds_of_calls_end_where_the_manual_says() {
    let feeds = |calls: &str| {
        let body = format!("{DRILL}L Z+50 R0 F700 M3\nPATTERN DEF POS1 (X+10 Y+0 Z+0) POS2 (X+20 Y+0 Z+0)\n{calls}");
        let (outcome, events) = run(&body, None);
        assert!(outcome.fault.is_none(), "{:?}", outcome.fault);
        let across = events.iter().filter_map(|event| match event {
            EventKind::Move { kind: MoveKind::Feed, from, to, feed, .. } if from.x != to.x => Some((to.x, *feed)),
            _ => None,
        });
        across.collect::<Vec<_>>()
    };
    assert_eq!(feeds("CYCL CALL PAT\n"), [(10.0, 700.0), (20.0, 700.0)]);
    assert_eq!(feeds("CYCL CALL PAT F900\nL X+1 R0\n"), [(10.0, 900.0), (20.0, 900.0), (1.0, 900.0)]);
    assert_eq!(feeds("CYCL CALL POS X+5 Y+0 Z+0 F300\nL X+1 R0\n"), [(5.0, 300.0), (1.0, 700.0)]);
    // At rapid traverse, which the manual excludes between the points of a table only.
    assert_eq!(feeds("CYCL CALL PAT FMAX\n"), []);
    let (outcome, _) = run(&format!("{DRILL}SEL PATTERN \"HOLES.PNT\"\nCYCL CALL PAT FMAX\n"), None);
    assert_eq!(outcome.fault.map(|fault| fault.code.to_string()).as_deref(), Some("word-not-offered"));
}

/// M89 calls after every positioning block until M99 or a new machining cycle; a cycle that acts when it is defined does
/// not end it.
#[test]
fn a_modal_call_lasts_until_its_end() {
    let body = |end: &str| format!("{DRILL}L Z+50 R0 FMAX M3\nL X+1 R0 FMAX M89\nL X+2 R0 FMAX\n{end}L X+9 R0 FMAX\n");
    let holes = |end: &str| plunges(&body(end)).iter().map(|point| point[0]).collect::<Vec<_>>();
    assert_eq!(holes(""), [1.0, 2.0, 9.0]);
    assert_eq!(holes("M8\nCYCL DEF 9.0 D\nCYCL DEF 9.1 V.ZEIT 1\n"), [1.0, 2.0, 9.0]);
    assert_eq!(holes("L X+3 R0 FMAX M99\n"), [1.0, 2.0, 3.0]);
    assert_eq!(holes(DRILL), [1.0, 2.0]);
}

/// A cycle without a surface, or with a start of its own, has its datum at the point.
#[test]
fn the_start_of_a_cycle_counts_from_the_point() {
    let face = "CYCL DEF 230\nQ225=3\nQ226=4\nQ227=0\nQ218=20\nQ219=0\nQ240=1\nQ206=100\nQ207=400\nQ209=200\nQ200=2\n";
    let body = format!("{face}L Z+50 R0 FMAX M3\nCYCL CALL POS X+100 Y+50 Z+7 FMAX\n");
    let (outcome, events) = run(&body, None);
    assert!(outcome.fault.is_none(), "{:?}", outcome.fault);
    let cut = events.iter().find_map(|event| match event {
        EventKind::Move { kind: MoveKind::Feed, machine, from, to, .. } if from.x != to.x => Some(machine.to_array()),
        _ => None,
    });
    // With a radius of 5 the line ends 20 + 5 beyond 3 + 100, one radius above 4 + 50, at 0 + 7.
    assert_eq!(cut, Some([128.0, 59.0, 7.0]));
}

/// A table that a called program selects stays selected.
#[test]
fn a_called_program_selects_a_table() {
    let body = format!("{DRILL}CALL PGM SUB\nCYCL CALL PAT F5000 M3\n");
    let (outcome, events) = run(&body, Some("BEGIN PGM SUB MM\nSEL PATTERN \"HOLES.PNT\"\nEND PGM SUB MM\n"));
    assert!(outcome.fault.is_none(), "{:?}", outcome.fault);
    let bottoms = events
        .iter()
        .filter(|event| matches!(event, EventKind::Move { kind: MoveKind::Feed, from, to, .. } if to.z < from.z));
    assert_eq!(bottoms.count(), 2);
}

/// Where the hole of a cycle ends for each point of a pattern, for any tool axis.
fn bottoms(tool: &str, body: &str, height: f64) -> Vec<[f64; 3]> {
    let program = format!("BEGIN PGM A MM\nTOOL CALL 1 {tool} S1000 F500\nM3\n{DRILL}{body}END PGM A MM\n");
    let by_letters = fed(&program, "scene: 1\ntools: [{T: 1, L: 80, R: 5}]\n");
    // Letters back to main, minor and tool axis.
    let seen = by_letters.into_iter().map(|[x, y, z]| match tool {
        "Z" => [x, y, z],
        "Y" => [z, x, y],
        _ => [y, z, x],
    });
    seen.filter(|point| (point[2] - height).abs() < 1e-9).collect()
}

fn same(found: &[[f64; 3]], wanted: &[[f64; 2]]) -> bool {
    // Both are rounded to thousandths.
    let near = |a: &[f64; 3], b: &[f64; 2]| (a[0] - b[0]).abs() < 1.1e-3 && (a[1] - b[1]).abs() < 1.1e-3;
    found.len() == wanted.len() && found.iter().zip(wanted).all(|(a, b)| near(a, b))
}

laws! {
    #![proptest_config(crate::cases::config(100))]

    /// 220: on a circle, by steps or up to an end, every hole at its angle, for every tool axis.
    #[test]
    fn circles_of_holes_lie_where_their_numbers_say(
        tool in prop::sample::select(vec!["X", "Y", "Z"]), centre in (-50_i32..50, -50_i32..50), diameter in 10_i32..90, begin in -360_i32..360, end in -360_i32..360,
        step in prop_oneof![Just(0_i32), -60_i32..60], count in 1_i32..9, surface in -20_i32..20, over in 0..2, arc in 0..2,
    ) {
        prop_assume!(step != 0 || begin != end);
        let body = format!(
            "CYCL DEF 220\nQ216={}\nQ217={}\nQ244={diameter}\nQ245={begin}\nQ246={end}\nQ247={step}\nQ241={count}\nQ200=2\nQ203={surface}\n\
             Q204=20\nQ301={over}\nQ365={arc}\n", centre.0, centre.1,
        );
        // The last of several holes lies at the end, unless that is the first one again.
        let gaps = if (end - begin).abs() == 360 { count } else { (count - 1).max(1) };
        let each = if step == 0 { f64::from(end - begin) / f64::from(gaps) } else { f64::from(step) };
        let wanted: Vec<[f64; 2]> = (0..count).map(|n| {
            let (s, c) = (f64::from(begin) + f64::from(n) * each).to_radians().sin_cos();
            [f64::from(centre.0) + f64::from(diameter) / 2.0 * c, f64::from(centre.1) + f64::from(diameter) / 2.0 * s]
        }).collect();
        let found = bottoms(tool, &body, f64::from(surface) - 5.0);
        prop_assert!(same(&found, &wanted), "{} {:?} {:?}\n{}", tool, found, wanted, body);
    }

    /// 221: to and fro in lines, turned about the first point, for every tool axis.
    #[test]
    fn lines_of_holes_lie_where_their_numbers_say(
        tool in prop::sample::select(vec!["X", "Y", "Z"]), first in (-50_i32..50, -50_i32..50), gaps in (-20_i32..20, -20_i32..20), count in (1_i32..5, 1_i32..5),
        turn in -360_i32..360, surface in -20_i32..20, over in 0..2,
    ) {
        let body = format!(
            "CYCL DEF 221\nQ225={}\nQ226={}\nQ237={}\nQ238={}\nQ242={}\nQ243={}\nQ224={turn}\nQ200=2\nQ203={surface}\nQ204=20\nQ301={over}\n",
            first.0, first.1, gaps.0, gaps.1, count.0, count.1,
        );
        let (s, c) = f64::from(turn).to_radians().sin_cos();
        let mut wanted = Vec::new();
        for line in 0..count.1 {
            for n in 0..count.0 {
                let column = if line % 2 == 0 { n } else { count.0 - 1 - n };
                let (u, v) = (f64::from(column * gaps.0), f64::from(line * gaps.1));
                wanted.push([f64::from(first.0) + u * c - v * s, f64::from(first.1) + u * s + v * c]);
            }
        }
        let found = bottoms(tool, &body, f64::from(surface) - 5.0);
        prop_assert!(same(&found, &wanted), "{} {:?} {:?}\n{}", tool, found, wanted, body);
    }

    /// `CYCL CALL POS`: the coordinate of the tool axis adds to the surface, whichever axis that is.
    #[test]
    fn calls_at_positions_know_the_tool_axis(tool in prop::sample::select(vec!["X", "Y", "Z"]), place in (-50_i32..50, -50_i32..50), height in -20_i32..20) {
        let [x, y, z] = by_axis(tool, [f64::from(place.0), f64::from(place.1), f64::from(height)]);
        let up = format!("L {tool}+90 R0 FMAX\n");
        let body = format!("{up}CYCL CALL POS X{x:+} Y{y:+} Z{z:+} FMAX\n");
        let found = bottoms(tool, &body, f64::from(height) + 1.0 - 5.0);
        prop_assert!(same(&found, &[[f64::from(place.0), f64::from(place.1)]]), "{} {:?}\n{}", tool, found, body);
    }
}
