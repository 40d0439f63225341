//! Laws of probing and drilling over random worlds: what a cycle measures is the truth of the scene, wherever the
//! part lies and however the coordinates are shifted and turned; drilling always ends.
//!
//! Truths are calculated here from the scene's numbers, with plain trigonometry and nothing of the engine.
#![expect(clippy::disallowed_methods, reason = "truths are calculated with plain trigonometry")]

use ciklo::base::diag::Source;
use ciklo::base::expr::QRef;
use ciklo::engine::run::{Content, Engine, EventKind, Limits, MoveKind, Outcome, Status};
use ciklo::engine::scene::Scene;
use ciklo::program::syntax;
use ciklo::tools::conform::LogTexts;
use proptest::prelude::*;

use crate::built;
use built::built;

fn run(control: &str, program: &str, scene: &str) -> (Outcome, Vec<EventKind>) {
    let world = built();
    let on = world.catalogue.on(control).expect("a control");
    let parsed = Scene::parse(&Source::new("scene.yaml", scene), &world.files);
    let scene = parsed.unwrap_or_else(|found| panic!("{found:?}\n{scene}"));
    let texts = LogTexts::new(world.locales.language("en").expect("English"), control, &world.files);
    let tree = syntax::parse(&Source::new("LAW.H", program));
    let mut events = Vec::new();
    let engine = Engine::new(&tree, on, &scene, &texts).with_catalogue(&world.catalogue);
    let outcome = engine.with_limits(Limits::default()).run(&mut |event| events.push(event.kind));
    (outcome, events)
}

fn q(outcome: &Outcome, number: u16) -> f64 {
    match outcome.params.get(QRef::q(number)) {
        Some(Content::Number(number)) => number,
        other => panic!("Q{number} is {other:?}; {:?}", outcome.fault),
    }
}

fn turned(x: f64, y: f64, degrees: f64) -> (f64, f64) {
    let (s, c) = degrees.to_radians().sin_cos();
    (x * c - y * s, x * s + y * c)
}

/// A hole in a plate and the systems around it. The hole is given in the coordinates of the active preset.
#[derive(Clone, Debug)]
struct Hole {
    centre: (f64, f64),
    diameter: f64,
    /// How far the nominal centre and diameter are off.
    error: (f64, f64, f64),
    ball: f64,
    offset: (f64, f64),
    preset: (f64, f64, f64, f64),
    shift: (f64, f64),
    rotation: f64,
    /// The part turned about its own axes; the hole stays upright.
    part_turn: f64,
}

prop_compose! {
    fn hole()(
        centre in (-60.0..60.0, -60.0..60.0),
        diameter in 20.0..60.0,
        error in (-0.8..0.8, -0.8..0.8, -0.5..0.5),
        ball in 0.5..3.0,
        offset in (-0.2..0.2, -0.2..0.2),
        preset in (-200.0..200.0, -200.0..200.0, -100.0..0.0, -180.0..180.0),
        shift in (-50.0..50.0, -50.0..50.0),
        rotation in -180.0..180.0,
        part_turn in -180.0..180.0,
    ) -> Hole {
        Hole { centre, diameter, error, ball, offset, preset, shift, rotation, part_turn }
    }
}

impl Hole {
    fn scene(&self) -> String {
        let (x, y, z, turn) = self.preset;
        // The hole is placed by turning and shifting a part whose hole is elsewhere.
        let (hx, hy) = (7.0, -3.0);
        let (rx, ry) = turned(hx, hy, self.part_turn);
        let (sx, sy) = (self.centre.0 - rx, self.centre.1 - ry);
        format!(
            "scene: 1\ntools: [{{T: 1, L: 100, R: {ball}, TP_NO: 1}}]\n\
             probe: {{NO: 1, ball_radius: {ball}, DIST: 20, SET_UP: 2, CAL_OF1: {o1}, CAL_OF2: {o2}}}\n\
             presets: {{active: 1, rows: [{{NO: 1, X: {x}, Y: {y}, Z: {z}, SPC: {turn}}}, {{NO: 12}}]}}\n\
             datums: [{{D: 12}}]\nstart: [0, 0, 80]\nparts:\n  - place: {{shift: [{sx}, {sy}, 0], rotate: [0, 0, {part}]}}\n    \
             solid: {{difference: [{{box: {{min: [-150, -150, -30], max: [150, 150, 0]}}}}, \
             {{cylinder: {{centre: [{hx}, {hy}], diameter: {d}, from: -40, to: 10}}}}]}}\n",
            ball = self.ball,
            o1 = self.offset.0,
            o2 = self.offset.1,
            part = self.part_turn,
            d = self.diameter,
        )
    }

    /// The centre in the program's coordinates: first shifted, then turned.
    fn truth(&self) -> (f64, f64) {
        turned(self.centre.0 - self.shift.0, self.centre.1 - self.shift.1, -self.rotation)
    }

    fn head(&self) -> String {
        format!(
            "BEGIN PGM LAW MM\nTOOL CALL 1 Z\nCYCL DEF 7.0 SHIFT\nCYCL DEF 7.1 X{:+}\nCYCL DEF 7.2 Y{:+}\n\
             CYCL DEF 10.0 ROTATION\nCYCL DEF 10.1 ROT{:+}\n",
            self.shift.0, self.shift.1, self.rotation
        )
    }

    fn nominal(&self) -> (f64, f64, f64) {
        let (x, y) = self.truth();
        (x + self.error.0, y + self.error.1, self.diameter + self.error.2)
    }
}

fn near(a: f64, b: f64) -> bool {
    (a - b).abs() < 1e-6
}

laws! {
    #![proptest_config(crate::cases::config(24))]

    /// A measured hole is the hole.
    #[test]
    fn a_measured_hole_is_the_hole(hole in hole(), start in -180.0..180.0, high in any::<bool>(), three in any::<bool>()) {
        let (x, y, d) = hole.nominal();
        let program = format!(
            "{}TCH PROBE 421\nQ273={x}\nQ274={y}\nQ262={d}\nQ325={start}\nQ247=+90\nQ261=-5\nQ320=0\nQ260=+20\nQ301={}\nQ275=0\nQ276=0\nQ279=0\nQ280=0\nQ281=0\nQ309=0\nQ330=0\nQ423={}\nQ365=1\n",
            hole.head(), u8::from(high), if three { 3 } else { 4 },
        );
        let (outcome, _) = run("tnc640", &program, &hole.scene());
        prop_assert_eq!(outcome.status, Status::Done, "{:?}", outcome.fault);
        let (x, y) = hole.truth();
        prop_assert!(near(q(&outcome, 151), x) && near(q(&outcome, 152), y), "{} {} is not {x} {y}", q(&outcome, 151), q(&outcome, 152));
        prop_assert!(near(q(&outcome, 153), hole.diameter));
    }

    /// The datum of 412 lies where the hole is: in the preset table in machine coordinates, and on the display.
    #[test]
    fn a_datum_in_a_hole_lies_in_the_hole(hole in hole(), start in -180.0..180.0, into_table in any::<bool>()) {
        let (x, y, d) = hole.nominal();
        let row = if into_table { 12 } else { 0 };
        let program = format!(
            "{}TCH PROBE 412\nQ321={x}\nQ322={y}\nQ262={d}\nQ325={start}\nQ247=+90\nQ261=-5\nQ320=0\nQ260=+20\nQ301=0\nQ305={row}\nQ331=+10\nQ332=-20\nQ303=+1\nQ381=0\nQ382=0\nQ383=0\nQ384=0\nQ333=0\n",
            hole.head(),
        );
        // The control with the shorter parameter list; what it lacks is filled with neutral values.
        let (outcome, events) = run("tnc320", &format!("{program}Q423=4\n"), &hole.scene());
        prop_assert_eq!(outcome.status, Status::Done, "{:?}", outcome.fault);
        let (px, py, _, turn) = hole.preset;
        let (mx, my) = turned(hole.centre.0, hole.centre.1, turn);
        if into_table {
            let cell = |name: &str| events.iter().rev().find_map(|event| match event {
                EventKind::Table { column, value: Content::Number(value), .. } if column == name => Some(*value),
                _ => None,
            });
            // The new preset has no basic rotation: the wanted coordinates count along the machine's axes.
            prop_assert!(near(cell("X").expect("X"), px + mx - 10.0));
            prop_assert!(near(cell("Y").expect("Y"), py + my + 20.0));
        } else {
            // The tool stands over the place of the last probing; the hole now has the coordinates 10, -20.
            let last = events.iter().rev().find_map(|event| match event {
                EventKind::Move { machine, .. } => Some(*machine),
                _ => None,
            }).expect("a move");
            let (dx, dy) = turned(last.x - px - mx, last.y - py - my, -(turn + hole.rotation));
            prop_assert!(near(outcome.position.x, 10.0 + dx) && near(outcome.position.y, -20.0 + dy));
        }
    }

    /// A point of a slanted plane, probed along its normal.
    #[test]
    fn a_probed_surface_is_the_surface(
        point in (-40.0..40.0, -40.0..40.0, -20.0..20.0),
        tilt in 0.0..60.0_f64, around in -180.0..180.0, off in -0.5..0.5, ball in 0.5..3.0,
    ) {
        let (s, c) = tilt.to_radians().sin_cos();
        let (ax, ay) = turned(1.0, 0.0, around);
        let normal = (ax * s, ay * s, c);
        let true_point = (point.0 + off * normal.0, point.1 + off * normal.1, point.2 + off * normal.2);
        let scene = format!(
            "scene: 1\ntools: [{{T: 1, L: 100, R: {ball}, TP_NO: 1}}]\nprobe: {{NO: 1, ball_radius: {ball}, DIST: 20, SET_UP: 2}}\n\
             start: [{}, {}, 90]\nparts:\n  - solid: {{half_space: {{point: [{}, {}, {}], normal: [{}, {}, {}]}}}}\n",
            point.0, point.1, true_point.0, true_point.1, true_point.2, normal.0, normal.1, normal.2,
        );
        let program = format!(
            "TOOL CALL 1 Z\nTCH PROBE 444\nQ263={}\nQ264={}\nQ294={}\nQ581={}\nQ582={}\nQ583={}\nQ320=0\nQ260=+80\nQS400=\"0.2-0.1\"\nQ309=0\n",
            point.0, point.1, point.2, normal.0, normal.1, normal.2,
        );
        let (outcome, _) = run("tnc640", &program, &scene);
        prop_assert_eq!(outcome.status, Status::Done, "{:?}", outcome.fault);
        prop_assert!(near(q(&outcome, 164), off));
        let found = [q(&outcome, 151), q(&outcome, 152), q(&outcome, 153)];
        prop_assert!(near(found[0], true_point.0) && near(found[1], true_point.1) && near(found[2], true_point.2), "{found:?}");
        let status = if off > 0.2 { 1.0 } else if off < -0.1 { 2.0 } else { 0.0 };
        prop_assert_eq!(q(&outcome, 183), status);
    }

    /// A face square to an axis, from each side, in a shifted system.
    #[test]
    fn a_probed_face_is_the_face(
        face in -30.0..30.0, axis in 0..3usize, minus in any::<bool>(), shift in -40.0..40.0, ball in 0.5..3.0,
    ) {
        let letter = ["X", "Y", "Z"][axis];
        prop_assume!(letter != "Z" || minus);
        let sense = if minus { -1.0 } else { 1.0 };
        let mut point = [0.0; 3];
        point[axis] = face;
        let mut normal = [0.0; 3];
        normal[axis] = -sense;
        let scene = format!(
            "scene: 1\ntools: [{{T: 1, L: 100, R: {ball}, TP_NO: 1}}]\nprobe: {{NO: 1, ball_radius: {ball}, DIST: 20, SET_UP: 2}}\n\
             start: [{0}, {0}, 90]\nparts:\n  - solid: {{half_space: {{point: {point:?}, normal: {normal:?}}}}}\n",
            -sense * 45.0,
        );
        let mut to = [-sense * 45.0, -sense * 45.0, 50.0];
        to[axis] = face - sense * (ball + 5.0);
        if letter == "Z" {
            to[axis] -= ball;
        }
        to[axis] -= shift;
        let program = format!(
            "TOOL CALL 1 Z\nCYCL DEF 7.0 SHIFT\nCYCL DEF 7.1 {letter}{shift:+}\nTCH PROBE 0.0 PLANE Q7 {letter}{}\nTCH PROBE 0.1 X{:+} Y{:+} Z{:+}\n",
            if minus { "-" } else { "+" }, to[0], to[1], to[2],
        );
        let (outcome, _) = run("tnc426-430", &program, &scene);
        prop_assert_eq!(outcome.status, Status::Done, "{:?}", outcome.fault);
        prop_assert!(near(q(&outcome, 7), face - shift), "{} is not {}", q(&outcome, 7), face - shift);
    }

    /// Drilling ends for any values: at the depth, or with an error before it moves down for ever.
    #[test]
    fn drilling_always_ends(
        depth in 0.001..200.0_f64, infeed in 0.0..60.0_f64, less in 0.0..5.0, least in 0.0..5.0, chips in 0.0..10.0,
    ) {
        let program = format!(
            "TOOL CALL 1 Z S1000 F100\nCYCL DEF 205\nQ200=2\nQ201=-{depth}\nQ206=150\nQ202={infeed}\nQ203=0\nQ204=0\nQ212={less}\nQ205={least}\nQ258=0.2\nQ259=0.2\nQ257={chips}\nQ256=0.2\nQ211=0\nQ379=0\nQ253=750\nCYCL CALL\n",
        );
        let (outcome, events) = run("tnc640", &program, "scene: 1\n");
        match outcome.status {
            Status::Done => {
                let deepest = events.iter().filter_map(|event| match event {
                    EventKind::Move { to, .. } => Some(to.z),
                    _ => None,
                }).fold(f64::INFINITY, f64::min);
                prop_assert!(near(deepest, -depth), "{deepest}");
            }
            Status::Error => prop_assert_eq!(&*outcome.fault.expect("a fault").code, "infeeds-never-reach-depth"),
            Status::Limit => prop_assert_eq!(&*outcome.fault.expect("a fault").code, "series-limit"),
            other => prop_assert!(false, "{other:?} {:?}", outcome.fault),
        }
    }

    /// The coordinates of simple pecking, calculated here: down by the infeed, up to the clearance, back to the
    /// clearance above the last depth.
    #[test]
    fn pecking_goes_where_arithmetic_says(holes in 1..8u32, infeed in 0.5..10.0_f64, rest in 0.05..1.0_f64, surface in -50.0..50.0_f64) {
        let depth = infeed * f64::from(holes - 1) + infeed * rest;
        let program = format!(
            "TOOL CALL 1 Z S1000 F100\nL Z+90 R0 FMAX\nCYCL DEF 200\nQ200=2\nQ201=-{depth}\nQ206=150\nQ202={infeed}\nQ210=0\nQ203={surface}\nQ204=0\nQ211=0\nCYCL CALL\n",
        );
        let (outcome, events) = run("tnc640", &program, "scene: 1\n");
        prop_assert_eq!(outcome.status, Status::Done, "{:?}", outcome.fault);
        let mut expected = vec![("rapid", surface + 2.0)];
        for hole in 1..=holes {
            let bottom = if hole == holes { depth } else { infeed * f64::from(hole) };
            expected.push(("feed", surface - bottom));
            expected.push(("rapid", surface + 2.0));
            if hole < holes && surface - bottom + 2.0 != surface + 2.0 {
                expected.push(("rapid", surface - bottom + 2.0));
            }
        }
        let found: Vec<(&str, f64)> = events.iter().skip(2).filter_map(|event| match event {
            EventKind::Move { kind: MoveKind::Rapid, to, .. } => Some(("rapid", to.z)),
            EventKind::Move { kind: MoveKind::Feed, to, .. } => Some(("feed", to.z)),
            _ => None,
        }).collect();
        prop_assert_eq!(expected.len(), found.len(), "{:?}", found);
        for ((kind, z), (found_kind, found_z)) in expected.iter().zip(&found) {
            prop_assert_eq!(kind, found_kind);
            prop_assert!(near(*z, *found_z), "{z} {found_z}");
        }
    }

    /// Any text runs to an end and tells it.
    #[test]
    fn any_program_ends(lines in proptest::collection::vec(
        prop_oneof![
            Just("L X+10 FMAX"), Just("LBL 1"), Just("LBL 2"), Just("LBL 0"), Just("CALL LBL 1"), Just("CALL LBL 2 REP 3"),
            Just("FN 1: Q1 = +Q1 + +1"), Just("FN 0: Q1 = +0"), Just("FN 9: IF +0 EQU +0 GOTO LBL 1"), Just("CYCL CALL"),
            Just("FN 12: IF +Q1 LT +5 GOTO LBL 2"), Just("TOOL CALL 1 Z S100 F100"), Just("M99"), Just("CYCL DEF 10.0 R"),
            Just("CYCL DEF 10.1 ROT+10"), Just("STOP"), Just("M30"), Just("CC"), Just("C X+0 DR+"), Just("???"),
        ], 0..30)) {
        let program: String = lines.iter().map(|line| format!("{line}\n")).collect();
        let world = built();
        let on = world.catalogue.on("tnc640").expect("a control");
        let scene = Scene::parse(&Source::new("scene.yaml", "scene: 1\n"), &world.files).expect("a scene");
        let texts = ciklo::engine::run::NoTexts;
        let tree = syntax::parse(&Source::new("LAW.H", program));
        let limits = Limits { blocks: 2_000, jumps: 200, depth: 8, members: 50, moves: 5_000 };
        let mut ends = 0;
        let outcome = Engine::new(&tree, on, &scene, &texts).with_limits(limits).run(&mut |event| {
            ends += usize::from(matches!(event.kind, EventKind::End(_)));
        });
        prop_assert_eq!(ends, 1);
        prop_assert!(outcome.fault.is_none_or(|fault| fault.class != ciklo::engine::run::Class::Internal));
    }
}
