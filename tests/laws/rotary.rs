//! Laws of the cycles that straighten a workpiece by a rotary axis, on every machine that comes with the program: table or
//! head, vertical and horizontal probe axis.
//!
//! Truths follow from what the files of the machines say, by plain trigonometry: a coordinate that grows turns the tool
//! right-handed about its axis relative to the workpiece, so an axis ends as much farther as the workpiece was turned.
#![expect(clippy::disallowed_methods, reason = "truths are calculated with plain trigonometry")]
use std::fmt::Write as _;
use std::sync::OnceLock;

use ciklo::base::diag::Source;
use ciklo::base::expr::QRef;
use ciklo::engine::geometry::RotaryAxis;
use ciklo::engine::machine::Machine;
use ciklo::engine::run::{Content, Engine, EventKind, NoTexts, Outcome, Status};
use ciklo::engine::scene::Scene;
use ciklo::program::syntax;
use proptest::prelude::*;

use crate::built;
use built::{Built, built};

const CONTROLS: [&str; 3] = ["tnc640", "tnc320", "tnc426-430"];

/// The machines that come with the program, by name.
fn machines() -> &'static [Machine] {
    static ALL: OnceLock<Vec<Machine>> = OnceLock::new();
    ALL.get_or_init(|| {
        let files = &built().files;
        let all: Vec<Machine> =
            Machine::names(files).iter().map(|name| Machine::named(name, files).expect("a machine")).collect();
        assert!(all.len() >= 4);
        all
    })
}

fn has(machine: &Machine, letter: char) -> bool {
    RotaryAxis::from_letter(letter).is_some_and(|axis| machine.rotary(axis).is_some())
}

/// A definition with the parameters that the cycle has on the control; those not given are 0.
fn cycle(control: &str, number: u32, values: &[(u16, f64)]) -> String {
    let on = built().catalogue.on(control).expect("a control");
    let found = on.cycles.iter().find(|(key, _)| key.number == number && key.to_string().starts_with("TCH PROBE"));
    let mut text = format!("TCH PROBE {number}\n");
    for param in &found.expect("the control has the cycle").1.params {
        let q = param.q.expect("a Q parameter");
        let value = values.iter().rev().find(|(known, _)| *known == q.number).map_or(0.0, |(_, value)| *value);
        let _ = writeln!(text, "{q}={value}");
    }
    text
}

fn scene(machine: &Machine, start: &str, solid: &str, turn: &str) -> String {
    format!(
        "scene: 1\nmachine: {}\ntools: [{{T: 1, L: 99.97, R: 1.97, TP_NO: 1}}]\n\
         probe: {{NO: 1, ball_radius: 2, length: 100, pre_travel: 0.03, DIST: 40, SET_UP: 2, CAL_OF1: 0.04, CAL_OF2: -0.03}}\n\
         presets: {{active: 1, rows: [{{NO: 1}}, {{NO: 12}}]}}\ndatums: [{{D: 12}}]\nstart: {start}\nparts:\n  - place: {{rotate: {turn}}}\n    solid: {solid}\n",
        machine.name
    )
}

fn run(control: &str, program: &str, scene: &str) -> (Outcome, Vec<EventKind>) {
    let Built { files, catalogue, .. } = built();
    let parsed = Scene::parse(&Source::new("scene.yaml", scene), files);
    let scene = parsed.unwrap_or_else(|found| panic!("{found:?}\n{scene}"));
    let tree = syntax::parse(&Source::new("LAW.H", program));
    let mut events = Vec::new();
    let engine = Engine::new(&tree, catalogue.on(control).expect("a control"), &scene, &NoTexts);
    let outcome = engine.with_catalogue(catalogue).run(&mut |event| events.push(event.kind));
    (outcome, events)
}

fn code(outcome: &Outcome) -> &str {
    outcome.fault.as_ref().map_or("", |fault| &fault.code)
}

/// Where the last axis that turned stands in machine coordinates; where it stood at the start if none did.
fn stands(events: &[EventKind], start: f64) -> f64 {
    let last = events.iter().rev().find_map(|event| match event {
        EventKind::Turn { axes, .. } => axes.first().map(|axis| axis.machine),
        _ => None,
    });
    last.unwrap_or(start)
}

fn q150(outcome: &Outcome) -> f64 {
    match outcome.params.get(QRef::q(150)) {
        Some(Content::Number(number)) => number,
        other => panic!("Q150 is {other:?}"),
    }
}

fn near(a: f64, b: f64) -> bool {
    (a - b).abs() < 1e-6
}

fn turned(p: (f64, f64), degrees: f64) -> (f64, f64) {
    let (s, c) = degrees.to_radians().sin_cos();
    (p.0 * c - p.1 * s, p.0 * s + p.1 * c)
}

laws! {
    #![proptest_config(crate::cases::config(80))]

    /// 401, 402, 403 and 405 with a vertical probe: the C axis turns by what the workpiece is off, table or head; without
    /// one there is an error that names it.
    #[test]
    fn the_c_axis_straightens_a_workpiece(
        machine in 0..4usize, control in 0..3usize, kind in 0..4usize, turn in -6.0..6.0_f64, start in -80.0..80.0_f64, radius in 50.0..80.0_f64,
        nominal in 20.0..160.0_f64,
    ) {
        let (machine, control) = (&machines()[machine], CONTROLS[control]);
        // A head that is turned turns the offset of the ball, too, which the control does not know without TCPM.
        let start = if machine.pivot > 0.0 { 0.0 } else { start };
        // On the oldest control 401 and 402 know the basic rotation only.
        prop_assume!(control != "tnc426-430" || kind > 1);
        let plate = "box: {min: [-150, -150, -30], max: [150, 150, 0]}";
        let off = (0.3, -0.4);
        let mut values = vec![(261, -5.0), (320, 1.0), (260, 40.0), (312, 6.0), (402, 1.0)];
        let (number, solid) = match kind {
            0 => {
                let (one, two) = (turned((-radius, 0.0), turn), turned((radius, 0.0), turn));
                values.extend([(268, one.0 + off.0), (269, one.1), (270, two.0), (271, two.1 + off.1)]);
                (401, format!("{{difference: [{{{plate}}}, {{cylinder: {{centre: [{}, 0], diameter: 16, from: 0, to: -30}}}}, {{cylinder: {{centre: [{radius}, 0], diameter: 18, from: 0, to: -30}}}}]}}", -radius))
            }
            1 => {
                let (one, two) = (turned((-radius, 0.0), turn), turned((radius, 0.0), turn));
                values.extend([(268, one.0 + off.0), (269, one.1), (270, two.0), (271, two.1 + off.1), (313, 16.0), (314, 14.0), (315, -5.0)]);
                (402, format!("{{union: [{{box: {{min: [-150, -150, -60], max: [150, 150, -30]}}}}, {{cylinder: {{centre: [{}, 0], diameter: 16, from: -30, to: 0}}}}, {{cylinder: {{centre: [{radius}, 0], diameter: 14, from: -30, to: 0}}}}]}}", -radius))
            }
            2 => {
                // A face that looks to the minor axis, probed against it.
                let (one, two) = (turned((-radius, 60.0), turn), turned((radius, 60.0), turn));
                values.extend([(263, one.0), (264, one.1 + off.1), (265, two.0), (266, two.1), (272, 2.0), (267, -1.0)]);
                (403, "{box: {min: [-150, -60, -30], max: [150, 60, 0]}}".to_owned())
            }
            _ => {
                let goal = turned((radius, 0.0), nominal);
                let hole = turned((radius, 0.0), nominal);
                values.extend([(321, goal.0), (322, goal.1), (262, 16.0), (325, 20.0), (247, 85.0)]);
                (405, format!("{{difference: [{{{plate}}}, {{cylinder: {{centre: [{}, {}], diameter: 32, from: 0, to: -30}}}}]}}", hole.0, hole.1))
            }
        };
        let with_c = has(machine, 'C');
        let place = if with_c { format!("{{X: 0, Y: 0, Z: 60, C: {start}}}") } else { "[0, 0, 60]".to_owned() };
        let program = format!("BEGIN PGM LAW MM\nTOOL CALL 1 Z\n{}", cycle(control, number, &values));
        let (outcome, events) = run(control, &program, &scene(machine, &place, &solid, &format!("{{C: {turn}}}")));
        if !with_c {
            prop_assert_eq!(code(&outcome), "rotary-axis-missing");
            return Ok(());
        }
        prop_assert_eq!(outcome.status, Status::Done, "{} {}: {:?}", &machine.name, number, outcome.fault);
        prop_assert!(near(stands(&events, start), start + turn), "{} {number}: {} is not {start} and {turn}", machine.name, stands(&events, start));
        if number != 401 && number != 402 && control != "tnc426-430" {
            prop_assert!(near(q150(&outcome), turn), "{}", q150(&outcome));
        }
    }

    /// 403 levels a top by the A axis. A head whose C axis stands askew carries an A axis that does not suit, and so does
    /// a table that tilts with its C axis.
    #[test]
    fn the_a_axis_levels_a_top(machine in 0..4usize, control in 0..3usize, tilt in -8.0..8.0_f64, askew in any::<bool>(), other in -20.0..20.0_f64) {
        let (machine, control) = (&machines()[machine], CONTROLS[control]);
        let values = [(263, 0.0), (264, -40.0), (265, other), (266, 40.0), (272, 3.0), (267, -1.0), (261, 5.0), (320, 3.0), (260, 80.0), (301, 1.0), (312, 4.0)];
        let turn = if askew { 30.0 } else { 0.0 };
        let place = if has(machine, 'C') { format!("{{X: 0, Y: 0, Z: 100, C: {turn}}}") } else { "[0, 0, 100]".to_owned() };
        let solid = "{box: {min: [-90, -90, -30], max: [90, 90, 0]}}";
        let program = format!("BEGIN PGM LAW MM\nTOOL CALL 1 Z\n{}", cycle(control, 403, &values));
        let (outcome, events) = run(control, &program, &scene(machine, &place, solid, &format!("{{A: {tilt}}}")));
        if !has(machine, 'A') {
            prop_assert_eq!(code(&outcome), "rotary-axis-missing");
        } else if askew && machine.pivot > 0.0 {
            prop_assert_eq!(code(&outcome), "rotary-axis-unsuitable");
        } else {
            prop_assert_eq!(outcome.status, Status::Done, "{}: {:?}", &machine.name, outcome.fault);
            prop_assert!(near(stands(&events, 0.0), tilt), "{}: {} is not {tilt}", machine.name, stands(&events, 0.0));
        }
    }

    /// With a horizontal probe axis, Y or X, the C axis stands across it: 403 levels the face that the probe looks at.
    #[test]
    fn the_c_axis_levels_a_face_before_a_horizontal_probe(machine in 0..4usize, control in 0..3usize, turn in -8.0..8.0_f64, along_x in any::<bool>(), other in -20.0..20.0_f64) {
        let (machine, control) = (&machines()[machine], CONTROLS[control]);
        // The plane of Y is Z and X, that of X is Y and Z.
        let (tool, points) = if along_x {
            ("X", [(263, -40.0), (264, 0.0), (265, 40.0), (266, other)])
        } else {
            ("Y", [(263, 0.0), (264, -40.0), (265, other), (266, 40.0)])
        };
        let mut values = vec![(272, 3.0), (267, -1.0), (261, 65.0), (320, 3.0), (260, 150.0), (301, 1.0), (312, 6.0)];
        values.extend(points);
        let place = if along_x { "{X: 200, Y: 0, Z: 0}" } else { "{X: 0, Y: 200, Z: 0}" };
        let solid = "{box: {min: [-60, -60, -90], max: [60, 60, 90]}}";
        let program = format!("BEGIN PGM LAW MM\nTOOL CALL 1 {tool}\n{}", cycle(control, 403, &values));
        let (outcome, events) = run(control, &program, &scene(machine, place, solid, &format!("{{C: {turn}}}")));
        if !has(machine, 'C') {
            prop_assert_eq!(code(&outcome), "rotary-axis-missing");
            return Ok(());
        }
        prop_assert_eq!(outcome.status, Status::Done, "{}: {:?}", &machine.name, outcome.fault);
        prop_assert!(near(stands(&events, 0.0), turn), "{}: {} is not {turn}", machine.name, stands(&events, 0.0));
    }

    /// 405 with the probe axis Y: a radial hole comes within one per cent of the positive Y axis, as the manuals say, and
    /// exactly there when the cycle is repeated on a table.
    #[test]
    fn a_horizontal_hole_comes_onto_the_y_axis(machine in 0..4usize, control in 0..3usize, turn in -3.0..3.0_f64, begin in -90.0..90.0_f64, diameter in 24.0..34.0_f64) {
        let (machine, control) = (&machines()[machine], CONTROLS[control]);
        let values = [(321, 0.0), (322, 0.0), (262, diameter - 12.0), (325, begin), (247, 90.0), (261, 70.0), (260, 150.0)];
        let solid = format!("{{difference: [{{box: {{min: [-90, -90, -90], max: [90, 90, 90]}}}}, {{cylinder: {{axis: Y, diameter: {diameter}, from: 40, to: 90}}}}]}}");
        let table = machine.pivot == 0.0;
        let times = if table { 4 } else { 1 };
        let program = format!("BEGIN PGM LAW MM\nTOOL CALL 1 Y\n{}", cycle(control, 405, &values).repeat(times));
        let (outcome, events) = run(control, &program, &scene(machine, "{X: 0, Y: 200, Z: 0}", &solid, &format!("{{C: {turn}}}")));
        if !has(machine, 'C') {
            prop_assert_eq!(code(&outcome), "rotary-axis-missing");
            return Ok(());
        }
        prop_assert_eq!(outcome.status, Status::Done, "{}: {:?}", &machine.name, outcome.fault);
        let first = events.iter().find_map(|event| match event {
            EventKind::Turn { axes, .. } => axes.first().map(|axis| axis.machine),
            _ => None,
        });
        let first = first.unwrap_or(0.0);
        prop_assert!((first - turn).abs() <= 0.01 * turn.abs() + 1e-6, "{}: {first} is not near {turn}", machine.name);
        prop_assert!(!table || near(stands(&events, 0.0), turn), "{}: {} is not {turn}", machine.name, stands(&events, 0.0));
    }
}

laws! {
    #![proptest_config(crate::cases::config(40))]

    /// `TABLE ROT`: a table that stands level takes over the rotation of the plane, so that its main axis is that of the
    /// machine and the axis ends at the angle of the plane; a table that is tilted is where it is without the words.
    #[test]
    fn a_level_table_turns_instead_of_the_coordinates(turn in -179..180_i32, tilt in 1..60_i32, datum in -40..40_i32) {
        let machine = Machine::named("mill-table-ac", &built().files).expect("a machine");
        let text = format!("scene: 1\nmachine: {}\ntools: [{{T: 1, L: 100, R: 5}}]\nstart: [0, 0, 300]\n", machine.name);
        let program = |angle: i32, words: &str| format!(
            "BEGIN PGM LAW MM\nTOOL CALL 1 Z S1000 F500\nCYCL DEF 7.0 DATUM SHIFT\nCYCL DEF 7.1 X+{}\n\
             PLANE SPATIAL SPA+{angle} SPB+0 SPC{turn:+} TURN FMAX {words}\n\
             L X+0 Y+0 Z+50 R0 FMAX\nL X+10 R0\nEND PGM LAW MM\n", datum.abs()
        );
        let ended = |program: &str| {
            let (outcome, events) = run("tnc640", program, &text);
            let places: Vec<_> = events.iter().filter_map(|event| match event {
                EventKind::Move { machine, .. } => Some(*machine),
                _ => None,
            }).collect();
            (outcome, places)
        };
        let (outcome, places) = ended(&program(0, "TABLE ROT"));
        prop_assert_eq!(outcome.status, Status::Done, "{:?}", outcome.fault);
        let way = places[places.len() - 1] - places[places.len() - 2];
        prop_assert!((way - glam::DVec3::X * 10.0).length() < 1e-9, "it went {way}");
        let off = (outcome.angles.z - f64::from(turn)).rem_euclid(360.0);
        prop_assert!(off.min(360.0 - off) < 1e-9, "C is at {}, not at {turn}", outcome.angles.z);
        let tilted = [ended(&program(tilt, "TABLE ROT")), ended(&program(tilt, "COORD ROT"))];
        prop_assert_eq!(tilted[0].0.status, Status::Done);
        prop_assert!((tilted[0].0.angles - tilted[1].0.angles).length() < 1e-9);
    }

    /// `M130`: in a tilted plane a straight block leads where it leads without the tilt.
    #[test]
    fn untilted_blocks_go_where_they_go_without_a_tilt(
        tilt in 1..60_i32, turn in -90..90_i32, x in -80..80_i32, y in -80..80_i32, z in 1..90_i32, shift in -30..30_i32
    ) {
        let machine = Machine::named("mill-table-ac", &built().files).expect("a machine");
        let text = format!("scene: 1\nmachine: {}\ntools: [{{T: 1, L: 100, R: 5}}]\nstart: [0, 0, 300]\n", machine.name);
        let ended = |plane: &str, word: &str| {
            let program = format!(
                "BEGIN PGM LAW MM\nTOOL CALL 1 Z S1000 F500\nCYCL DEF 7.0 DATUM SHIFT\nCYCL DEF 7.1 X{shift:+}\n{plane}\n\
                 L X{x:+} Y{y:+} R0 FMAX {word}\nL Z{z:+} FMAX {word}\nEND PGM LAW MM\n"
            );
            let (outcome, events) = run("tnc640", &program, &text);
            let last = events.iter().rev().find_map(|event| match event {
                EventKind::Move { machine, .. } => Some(*machine),
                _ => None,
            });
            (outcome, last.expect("a move"))
        };
        let plane = format!("PLANE SPATIAL SPA+{tilt} SPB+0 SPC{turn:+} TURN FMAX");
        let (level, tilted) = (ended("", ""), ended(&plane, "M130"));
        prop_assert_eq!(level.0.status, Status::Done);
        prop_assert_eq!(tilted.0.status, Status::Done, "{:?}", tilted.0.fault);
        prop_assert!((level.1 - tilted.1).length() < 1e-9, "{} is not {}", tilted.1, level.1);
    }
}
