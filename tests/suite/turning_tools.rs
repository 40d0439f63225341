//! Tools of turning: the table of their own, corrections in the program, precession angle and reversed tool; and the
//! program of the manual with turning cycles.
//!
//! Expected numbers are calculated beside them from lengths and radii alone.
use ciklo::base::diag::Source;
use ciklo::engine::run::{Engine, Event, EventKind, NoTexts, Outcome, Status};
use ciklo::engine::scene::Scene;
use ciklo::engine::table::{Cell, Table, TableKind};
use ciklo::program::syntax;
use glam::DVec3;

fn run(program: &str, scene: &str) -> (Outcome, Vec<Event>) {
    run_beside("", program, scene)
}

/// The same with a program beside it, `RING.H`.
fn run_beside(ring: &str, program: &str, scene: &str) -> (Outcome, Vec<Event>) {
    let files = ciklo::base::data::embedded();
    let catalogue = &crate::built::built().catalogue;
    let on = catalogue.on("tnc640").expect("a control");
    let scene = Scene::parse(&Source::new("scene.yaml", format!("scene: 1\n{scene}\n")), &files).expect("a scene");
    let program = syntax::parse(&Source::new("TURN.H", program));
    let ring = syntax::parse(&Source::new("RING.H", ring));
    let mut events = Vec::new();
    let engine = Engine::new(&program, on, &scene, &NoTexts).with_catalogue(catalogue).with_program("RING.H", &ring);
    let outcome = engine.run(&mut |event| events.push(event));
    (outcome, events)
}

/// The ends of all moves, in the program and in the machine.
fn ends(events: &[Event]) -> Vec<(DVec3, DVec3)> {
    let json = events.iter().map(Event::to_json).filter(|event| event["event"] == "move");
    let point = |value: &serde_json::Value| {
        let [x, y, z] = ["X", "Y", "Z"].map(|axis| value[axis].as_f64().expect("a coordinate"));
        DVec3::new(x, y, z)
    };
    json.map(|event| (point(&event["to"]), point(&event["machine"]))).collect()
}

fn near(found: DVec3, expected: DVec3) {
    assert!(found.distance(expected) < 1e-9, "{found} instead of {expected}");
}

/// Cycle 811: a shoulder of diameter 50 down to Z-55, finished only, from X75 Z2.
fn shoulder(insert: &str) -> (Outcome, Vec<Event>) {
    let program = "TOOL CALL 1 Z S500 F200\nFUNCTION MODE TURN\nL X+75 Z+2 R0 FMAX\n\
                   CYCL DEF 811\nQ215=2\nQ460=2\nQ493=50\nQ494=-55\nQ463=3\nQ478=200\nQ483=0\nQ484=0\nQ505=100\nQ506=0\n\
                   CYCL CALL\n";
    run(program, &format!("turning_tools: [{{T: 1, ZL: 100, XL: 20, {insert}}}]\nstart: [60, 0, 50]"))
}

/// The lowest Z of the moves of a run.
fn lowest(events: &[Event]) -> f64 {
    ends(events).iter().map(|(to, _)| to.z).fold(f64::INFINITY, f64::min)
}

#[test]
fn the_orientation_says_where_the_tip_is() {
    // The side of the nose touches the wall at Z-55: the tip is there, or the centre, which is the radius before it.
    for (insert, expected) in [
        ("RS: 0.4, TO: 1", -55.0),
        ("RS: 0.4, TO: 2", -54.6),
        ("RS: 0.4, DRS: 0.1, TO: 2", -54.5),
        ("RS: 0.4, TO: 9", -54.6),
        ("RS: 0.4", -55.0),
    ] {
        let (outcome, events) = shoulder(insert);
        assert_eq!(outcome.status, Status::Done, "{insert}: {:?}", outcome.fault);
        assert!((lowest(&events) - expected).abs() < 1e-9, "{insert}: {}", lowest(&events));
    }
    // The centre of the nose runs on the diameter and the radius of the nose.
    let (_, events) = shoulder("RS: 0.4, TO: 9");
    let least = ends(&events).iter().map(|(to, _)| to.x).fold(f64::INFINITY, f64::min);
    assert!((least - 25.4).abs() < 1e-9, "{least}");
    for away in ["TO: 3", "TO: 5", "TO: 6", "TO: 7"] {
        let (outcome, _) = shoulder(&format!("RS: 0.4, {away}"));
        assert_eq!(outcome.fault.map(|fault| fault.code.to_string()).as_deref(), Some("insert-direction"), "{away}");
    }
}

#[test]
fn a_reversed_tool_is_one_of_the_other_side() {
    let program = |reversed: u8| {
        format!(
            "TOOL CALL 1 Z S500 F200\nFUNCTION MODE TURN\nCYCL DEF 800\nQ497=0\nQ498={reversed}\nL X+75 Z+2 R0 FMAX\n\
             CYCL DEF 811\nQ215=2\nQ460=2\nQ493=50\nQ494=-55\nQ463=3\nQ478=200\nQ483=0\nQ484=0\nQ505=100\nQ506=0\nCYCL CALL\n"
        )
    };
    let scene = "turning_tools: [{T: 1, ZL: 100, XL: 20, RS: 0.4, TO: 7, ORI: 10}]\nstart: [60, 0, 50]";
    assert_eq!(run(&program(0), scene).0.status, Status::Error);
    let (outcome, events) = run(&program(1), scene);
    assert_eq!(outcome.status, Status::Done, "{:?}", outcome.fault);
    assert!((lowest(&events) + 55.0).abs() < 1e-9);
    // The angle of the insert, and half a turn more.
    let turned: Vec<f64> = events.iter().filter_map(|event| event.to_json()["orient"].as_f64()).collect();
    assert_eq!(turned, [10.0, 190.0]);
}

#[test]
fn the_measured_corner_of_a_recessing_insert_is_that_of_its_orientation() {
    // The insert is 3 mm wide: measured at its upper corner, or in the middle, all in the groove is so much higher.
    let groove = |insert: &str| -> Vec<DVec3> {
        let program = "TOOL CALL 1 Z S500 F200\nFUNCTION MODE TURN\nL X+75 Z-25 R0 FMAX\nCYCL DEF 861\nQ215=0\nQ460=2\n\
                       Q493=50\nQ494=-50\nQ478=200\nQ483=0.4\nQ484=0.2\nQ505=100\nQ463=0\nCYCL CALL\n";
        let scene = format!("turning_tools: [{{T: 1, ZL: 100, CUTWIDTH: 3, RS: 0.2, {insert}}}]\nstart: [60, 0, 50]");
        let (outcome, events) = run(program, &scene);
        assert_eq!(outcome.status, Status::Done, "{insert}: {:?}", outcome.fault);
        ends(&events).into_iter().map(|(to, _)| to).filter(|to| to.x < 37.4).collect()
    };
    let lower = groove("TO: 1");
    assert!(lower.len() > 10);
    for (insert, by) in [("TO: 3", 3.0), ("TO: 2", 1.5)] {
        let other = groove(insert);
        assert_eq!(other.len(), lower.len(), "{insert}");
        lower.iter().zip(&other).for_each(|(one, two)| near(*two, *one + DVec3::Z * by));
    }
    // The corner in front ends on the second flank, also of an insert that is 0.5 mm wider.
    for (insert, by) in [("TO: 1", 0.0), ("TO: 3, DCW: 0.5", 3.5)] {
        let deepest = groove(insert).iter().map(|to| to.z - by).fold(f64::INFINITY, f64::min);
        assert!((deepest + 50.0).abs() < 1e-9, "{insert}: {deepest}");
    }
}

#[test]
fn corrections_in_the_program_move_the_tip_up_to_the_next_tool_call() {
    let scene = "turning_tools:\n  - {T: 1, ZL: 100, XL: 20, RS: 0.4, TO: 1}\n  - {T: 2, ZL: 90, XL: 15, RS: 0.4, TO: 7}\n\
                 start: [60, 0, 50]";
    let program = "TOOL CALL 1 Z S500 F200\nFUNCTION MODE TURN\n\
                   FUNCTION TURNDATA CORR-TCS:Z/X DZL:0.2 DXL:0.1\nL X+50 Z+2 R0 FMAX\n\
                   FUNCTION TURNDATA CORR-WPL:Z/X DXL:-0.3\nL X+50 Z+2 R0 FMAX\n\
                   TOOL CALL 2 Z S500 F200\nL X+50 Z+2 R0 FMAX\n\
                   FUNCTION TURNDATA CORR-TCS:Z/X DZL:0.2 DXL:0.1\nL X+50 Z+2 R0 FMAX\n\
                   FUNCTION TURNDATA CORR-WPL:Z/X DZL:0.2 DXL:0.1\nL X+50 Z+2 R0 FMAX\n\
                   FUNCTION MODE MILL\nL X+50 Z+2 R0 FMAX\n";
    let (outcome, events) = run(program, scene);
    assert_eq!(outcome.status, Status::Done, "{:?}", outcome.fault);
    let expected = [
        // An outside tool that is longer stays further out and higher.
        (25.0, 25.1, 2.2),
        (25.0, 24.7, 2.0),
        (25.0, 25.0, 2.0),
        // An inside tool stays further in; in the system of the workpiece values count along its axes.
        (25.0, 24.9, 2.2),
        (25.0, 25.1, 2.2),
        // Diameters are those of turning.
        (50.0, 50.0, 2.0),
    ];
    let found = ends(&events);
    assert_eq!(found.len(), expected.len());
    for ((to, machine), (x, machine_x, z)) in found.into_iter().zip(expected) {
        near(to, DVec3::new(x, 0.0, 2.0));
        near(machine, DVec3::new(machine_x, 0.0, z));
    }
    // The radius of the nose is corrected, too: its centre runs 0.4 + 0.1 above the diameter.
    let program = "TOOL CALL 3 Z S500 F200\nFUNCTION MODE TURN\nFUNCTION TURNDATA CORR-TCS:Z/X DRS:0.1\nL X+75 Z+2 R0 FMAX\n\
                   CYCL DEF 811\nQ215=2\nQ460=2\nQ493=50\nQ494=-55\nQ463=3\nQ478=200\nQ483=0\nQ484=0\nQ505=100\nQ506=0\n\
                   CYCL CALL\n";
    let (_, events) = run(program, "turning_tools: [{T: 3, ZL: 90, RS: 0.4, TO: 9}]\nstart: [60, 0, 50]");
    let least = ends(&events).iter().map(|(to, _)| to.x).fold(f64::INFINITY, f64::min);
    assert!((least - 25.5).abs() < 1e-9, "{least}");
    let refused = "TOOL CALL 1 Z\nFUNCTION MODE TURN\nFUNCTION TURNDATA CORR-TCS:Z/X DYL:0.1\n";
    assert_eq!(run(refused, scene).0.status, Status::Unsupported);
}

#[test]
fn a_blank_is_described_by_a_program_however_it_is_named() {
    // A cylinder of 60 down to Z-60, of which turning the shoulder of 50 takes one cut of 5 on the radius.
    let outline = "L X+0 Z+0\nL X+60\nL Z-60\nL X+0\nL Z+0\n";
    let ring = format!("BEGIN PGM RING MM\n{outline}END PGM RING MM\n");
    let ways = |blank: &str| {
        let program = format!(
            "QS1 = \"RING.H\"\nTOOL CALL 1 Z S500 F200\nFUNCTION MODE TURN\n{blank}\nL X+75 Z+2 R0 FMAX\nCYCL DEF 811\n\
             Q215=1\nQ460=2\nQ493=50\nQ494=-55\nQ463=5\nQ478=200\nQ483=0\nQ484=0\nQ505=100\nQ506=2\nCYCL CALL\nM30\n\
             LBL 20\n{outline}LBL 0\n"
        );
        let scene = "tools: [{T: 1, L: 80, R: 0}]\nstart: [37.5, 0, 2]";
        let (outcome, events) = run_beside(&ring, &program, scene);
        (outcome.fault.map(|fault| fault.code.to_string()), ends(&events))
    };
    let levels = |ends: &[(DVec3, DVec3)]| ends.iter().filter(|(to, _)| (to.z + 55.0).abs() < 1e-9).count();
    let (fault, wanted) = ways("FUNCTION TURNDATA BLANK LBL 20");
    assert_eq!((fault, levels(&wanted)), (None, 1));
    assert_eq!(levels(&ways("").1), 3, "from 75 it is 12.5 deep");
    for blank in [
        "TURNDATA BLANK RING.H",
        "TURNDATA BLANK TNC:\\PARTS\\RING.H ; a ring",
        "TURNDATA BLANK \"RING.H\"",
        "TURNDATA BLANK QS1",
        "TURNDATA BLANK FILE RING.H",
        "TURNDATA BLANK FILE = \"RING.H\"",
        "TURNDATA BLANK FILE=QS1",
        "TURNDATABLANK RING.H",
        "TURNDATABLANK LBL 20",
    ] {
        assert_eq!(ways(&format!("FUNCTION {blank}")), (None, wanted.clone()), "{blank}");
    }
    assert_eq!(ways("FUNCTION TURNDATA BLANK RINGS.H").0.as_deref(), Some("program-missing"));
}

#[test]
fn a_precession_angle_turns_the_way_about_the_rotary_axis() {
    let program = "TOOL CALL 1 Z S500 F200\nFUNCTION MODE TURN\nCYCL DEF 800\nQ497=30\nQ498=0\n\
                   L X+100 Y+0 Z+2 R0 FMAX\nTOOL CALL 2 Z S500 F200\nL X+100 Y+0 Z+2 R0 FMAX\n";
    let scene = "turning_tools: [{T: 1, ZL: 100, TO: 1}, {T: 2, ZL: 100, TO: 1}]\nstart: [60, 0, 50]";
    let (outcome, events) = run(program, scene);
    assert_eq!(outcome.status, Status::Done, "{:?}", outcome.fault);
    let found = ends(&events);
    // 50 cos 30 and 50 sin 30; the tool call ends it.
    near(found[0].1, DVec3::new(43.301_270_189_221_93, 25.0, 2.0));
    near(found[1].1, DVec3::new(50.0, 0.0, 2.0));
    let diameters: Vec<f64> = events.iter().filter_map(|event| event.to_json()["diameter"].as_f64()).collect();
    assert!(diameters.iter().all(|diameter| (diameter - 100.0).abs() < 1e-9), "{diameters:?}");
}

#[test]
fn the_table_of_turning_tools_is_read_from_its_file() {
    let text = "BEGIN TOOLTURN.TRN MM\nT    NAME        ZL       XL     DZL    TO  TYPE\n\
                12   ROUGH_80    120.5    -15    0.25   1   ROUGH\n[END]\n";
    let source = Source::new("toolturn.trn", text);
    let table = Table::parse(TableKind::of_file("toolturn.trn").expect("a kind"), &source).expect("a sound table");
    assert_eq!(table.kind(), TableKind::Turning);
    assert_eq!(table.number(12.0, "ZL"), Ok(Some(120.5)));
    assert_eq!(table.get(12.0, "TYPE"), Ok(Cell::Text("ROUGH".to_owned())));
    assert!(ciklo::program::table::check(TableKind::Turning, &source).is_empty());
    let wrong = text.replace("1   ROUGH", "10  MILL ");
    let found = ciklo::program::table::check(TableKind::Turning, &Source::new("toolturn.trn", wrong));
    let codes: Vec<_> = found.iter().map(|own| own.code).collect();
    assert_eq!(codes, ["table-value-not-allowed", "table-value-not-allowed"]);
    // Its length counts, oversize included.
    let program = "TOOL CALL \"ROUGH_80\" Z S500\n";
    let scene = "tools: [{T: 12, L: 99}]\nturning_tools: [{T: 12, NAME: ROUGH_80, ZL: 120.5, DZL: 0.25, TO: 1}]";
    let (outcome, events) = run(program, scene);
    assert_eq!(outcome.status, Status::Done, "{:?}", outcome.fault);
    let lengths: Vec<f64> = events
        .iter()
        .filter_map(|event| match &event.kind {
            EventKind::Spindle { tool: Some((tool, _)), .. } => Some(tool.length),
            _ => None,
        })
        .collect();
    assert_eq!(lengths, [120.75]);
}

/// Plain blocks with RL and RR: the nose runs along the contour in the plane of the rotary axis and X.
#[test]
fn radius_compensation_in_turning_leads_the_nose_along_the_contour() {
    // A cylinder of diameter 40 down to Z-30, and a cone of 45 degrees up to diameter 60.
    let program = |side: &str, start: &str, cone: &str| {
        format!(
            "TOOL CALL 1 Z S500 F200\nFUNCTION MODE TURN\nL X+{start} Z+2 R0 FMAX\nL X+40 Z+2 {side} F200\nL Z-30\n\
             L X+{cone} Z-40\nL X+{start} R0\n"
        )
    };
    let tool = |insert: &str| format!("turning_tools: [{{T: 1, ZL: 100, {insert}}}]\nstart: [60, 0, 50]");
    let root = 2.0_f64.sqrt();
    let radius = 0.8;
    // The centre is on X 20 + r and on the line that is r beside Z + X = -10; the tip is r in front of it and below it.
    let (outcome, events) = run(&program("RR", "80", "60"), &tool("RS: 0.8, TO: 1"));
    assert_eq!(outcome.status, Status::Done, "{:?}", outcome.fault);
    let way: Vec<DVec3> = ends(&events).iter().map(|(to, _)| *to).collect();
    near(way[1], DVec3::new(20.0, 0.0, 2.0 - radius));
    near(way[2], DVec3::new(20.0, 0.0, -30.0 - radius * (2.0 - root)));
    // Beside the end of the cone, r away at right angles to it.
    near(way[3], DVec3::new(30.0 + radius / root - radius, 0.0, -40.0 + radius / root - radius));
    // Measured in the centre of the nose, the way is that of the centre.
    let (_, events) = run(&program("RR", "80", "60"), &tool("RS: 0.8, TO: 9"));
    near(ends(&events)[2].0, DVec3::new(20.0 + radius, 0.0, -30.0 - radius * (1.0 - root)));
    // A bore that becomes narrower: the nose is on the other side, and its tip points outwards.
    let (outcome, events) = run(&program("RL", "10", "20"), &tool("RS: 0.8, TO: 7"));
    assert_eq!(outcome.status, Status::Done, "{:?}", outcome.fault);
    near(ends(&events)[2].0, DVec3::new(20.0, 0.0, -30.0 - radius * (2.0 - root)));
    // Arcs and roundings are in that plane: a corner of radius 5 between cylinder and face, the nose inside of it.
    let program = "TOOL CALL 1 Z S500 F200\nFUNCTION MODE TURN\nL X+80 Z+2 R0 FMAX\nL X+40 Z+2 RR F200\nL Z-30\nRND R5\n\
                   L X+60\nL X+80 R0\n";
    let (outcome, events) = run(program, &tool("RS: 0.8, TO: 1"));
    assert_eq!(outcome.status, Status::Done, "{:?}", outcome.fault);
    let way: Vec<DVec3> = ends(&events).iter().map(|(to, _)| *to).collect();
    near(way[2], DVec3::new(20.0, 0.0, -25.0 - radius));
    near(way[3], DVec3::new(25.0 - radius, 0.0, -30.0));
    let sweep: Vec<f64> = events.iter().filter_map(|event| event.to_json()["angle"].as_f64()).collect();
    assert!(sweep.len() == 1 && (sweep[0].abs() - 90.0).abs() < 1e-9, "{sweep:?}");
}

/// The ends of the moves of a program that runs along a contour with an undercut: Z and X, and the angles of its arcs.
fn undercut(block: &str) -> (Vec<(f64, f64)>, Vec<f64>) {
    let program = format!(
        "TOOL CALL 1 Z S500 F200\nFUNCTION MODE TURN\nL X+40 Z+0 R0 FMAX\nL Z-30 F200\n{block}\nL X+60\nL Z-40\n"
    );
    let (outcome, events) = run(&program, "turning_tools: [{T: 1, ZL: 100, TO: 1}]\nstart: [60, 0, 50]");
    assert_eq!(outcome.status, Status::Done, "{block}: {:?}", outcome.fault);
    let angles = events.iter().filter_map(|event| event.to_json()["angle"].as_f64()).collect();
    (ends(&events).iter().map(|(to, _)| (to.z, to.x)).collect(), angles)
}

fn same_way(found: &[(f64, f64)], expected: &[(f64, f64)]) {
    assert_eq!(found.len(), expected.len(), "{found:?}");
    for (one, two) in found.iter().zip(expected) {
        assert!((one.0 - two.0).hypot(one.1 - two.1) < 1e-9, "{one:?} instead of {two:?} in {found:?}");
    }
}

#[test]
fn undercuts_have_the_shapes_of_the_standard() {
    let tan = |degrees: f64| degrees.to_radians().tan();
    // Form E, 2 mm deep and 15 mm broad, without radii: the slope of 15 degrees goes down in 2 / tan 15.
    let (way, _) = undercut("UDC TYPE_E R0 DEPTH2 BREADTH15");
    let down = 2.0 / tan(15.0);
    same_way(&way, &[(0.0, 20.0), (-15.0, 20.0), (-15.0 - down, 18.0), (-30.0, 18.0), (-30.0, 30.0), (-40.0, 30.0)]);
    // With radii of 1 mm: the tangents are tan 7.5 and 1 long, the arcs turn by 15 and by 90 degrees.
    let (way, angles) = undercut("UDC TYPE_E R1 DEPTH2 BREADTH15");
    let (cut, slope) = (tan(7.5), 15.0_f64.to_radians());
    same_way(
        &way,
        &[
            (0.0, 20.0),
            (-15.0, 20.0),
            (-15.0 - down + cut * slope.cos(), 18.0 + cut * slope.sin()),
            (-15.0 - down - cut, 18.0),
            (-29.0, 18.0),
            (-30.0, 19.0),
            (-30.0, 30.0),
            (-40.0, 30.0),
        ],
    );
    let turned: Vec<f64> = angles.iter().map(|angle| (angle.abs() * 1e6).round() / 1e6).collect();
    assert_eq!(turned, [15.0, 90.0]);
    // Form F of diameter 40 by DIN 509: 0.3 deep, 2.5 broad, 0.2 in the face at 8 degrees; radii of 0.6, here none.
    let (way, _) = undercut("UDC TYPE_F R0");
    let (down, rise) = (0.3 / tan(15.0), 0.2 / tan(8.0));
    same_way(
        &way,
        &[
            (0.0, 20.0),
            (-27.5, 20.0),
            (-27.5 - down, 19.7),
            (-30.2, 19.7),
            (-30.0, 19.7 + rise),
            (-30.0, 30.0),
            (-40.0, 30.0),
        ],
    );
    // The same with its radii has two arcs: 15 degrees, and 90 + 8.
    let (_, angles) = undercut("UDC TYPE_F");
    let turned: Vec<f64> = angles.iter().map(|angle| (angle.abs() * 1e6).round() / 1e6).collect();
    assert_eq!(turned, [15.0, 98.0]);
    // Form U with a chamfer of 0.5 at its edge.
    let (way, _) = undercut("UDC TYPE_U DEPTH3 BREADTH10 CHF0.5");
    same_way(
        &way,
        &[(0.0, 20.0), (-19.5, 20.0), (-20.0, 19.5), (-20.0, 17.0), (-30.0, 17.0), (-30.0, 30.0), (-40.0, 30.0)],
    );
    for refused in ["UDC TYPE_G R1", "UDC TYPE_U DEPTH3 BREADTH10 ANGLE5", "UDC TYPE_K BREADTH2", "GRV CONTOUR CENTER2"]
    {
        let program = format!("TOOL CALL 1 Z F200\nFUNCTION MODE TURN\nL X+40 Z+0 FMAX\nL Z-30\n{refused}\nL X+60\n");
        let (outcome, _) = run(&program, "start: [60, 0, 50]");
        assert_eq!(outcome.status, Status::Unsupported, "{refused}");
    }
}

#[test]
fn undercuts_of_the_other_forms() {
    let tan = |degrees: f64| degrees.to_radians().tan();
    // Form H: a slope of 30 degrees from 10 mm before the face, and an arc of 2 mm that turns by 30 and by 90 degrees.
    let (way, angles) = undercut("UDC TYPE_H R2 BREADTH10 ANGLE30");
    let depth = 10.0 * tan(30.0);
    // The angle between slope and face is 60 degrees: the tangents are 2 / tan 30 long.
    let (cut, slope) = (2.0 / tan(30.0), 30.0_f64.to_radians());
    same_way(
        &way,
        &[
            (0.0, 20.0),
            (-20.0, 20.0),
            (-30.0 + cut * slope.cos(), 20.0 - depth + cut * slope.sin()),
            (-30.0, 20.0 - depth + cut),
            (-30.0, 30.0),
            (-40.0, 30.0),
        ],
    );
    assert!((angles[0].abs() - 120.0).abs() < 1e-9, "{angles:?}");
    // Form K at 45 degrees, sides 60 degrees apart, sharp, 3 mm deep along the axis: the sides leave the point at 15 degrees
    // and at 75 degrees to the axis.
    let (way, _) = undercut("UDC TYPE_K R0 DEPTH3 ANG_WIDTH60");
    let reach = 3.0 / tan(15.0) - 3.0;
    same_way(
        &way,
        &[(0.0, 20.0), (-30.0 + reach, 20.0), (-33.0, 17.0), (-30.0, 20.0 + reach), (-30.0, 30.0), (-40.0, 30.0)],
    );
    // With a round ground nothing comes further than 3 mm times the root of 2 from the corner.
    let (way, angles) = undercut("UDC TYPE_K R0.5 DEPTH3 ROT45 ANG_WIDTH60");
    assert!((angles[0].abs() - 120.0).abs() < 1e-9, "{angles:?}");
    let far = 3.0 * 2.0_f64.sqrt();
    let centre = (-30.0 - (far - 0.5) / 2.0_f64.sqrt(), 20.0 - (far - 0.5) / 2.0_f64.sqrt());
    for point in &way[2..4] {
        assert!(((point.0 - centre.0).hypot(point.1 - centre.1) - 0.5).abs() < 1e-9, "{point:?}");
    }
    // The undercut of a thread of 1.5 mm by DIN 76: 2.3 less in diameter, 5.2 broad, 0.8 of radius, 30 degrees.
    let (way, angles) = undercut("UDC THREAD PITCH1.5 R0");
    let down = 1.15 / tan(30.0);
    same_way(&way, &[(0.0, 20.0), (-24.8, 20.0), (-24.8 - down, 18.85), (-30.0, 18.85), (-30.0, 30.0), (-40.0, 30.0)]);
    assert!(angles.is_empty());
    let (_, angles) = undercut("UDC THREAD PITCH1.5");
    let turned: Vec<f64> = angles.iter().map(|angle| (angle.abs() * 1e6).round() / 1e6).collect();
    assert_eq!(turned, [30.0, 90.0]);
    // A pitch that the standard lacks has no sizes.
    let program = "TOOL CALL 1 Z F200\nFUNCTION MODE TURN\nL X+40 Z+0 FMAX\nL Z-30\nUDC THREAD PITCH1.6\nL X+60\n";
    let (outcome, _) = run(program, "start: [60, 0, 50]");
    assert_eq!(outcome.fault.map(|fault| fault.code.to_string()).as_deref(), Some("undercut-impossible"));
}

/// A contour that is described the other way round has the same undercut.
#[test]
fn an_undercut_does_not_depend_on_the_direction_of_the_contour() {
    for form in
        ["TYPE_E", "TYPE_F R0.4", "TYPE_H R1 BREADTH6 ANGLE20", "TYPE_K R0.5 DEPTH1 ANG_WIDTH40", "THREAD PITCH2"]
    {
        let (there, _) = undercut(&format!("UDC {form}"));
        let program = format!(
            "TOOL CALL 1 Z S500 F200\nFUNCTION MODE TURN\nL X+60 Z-40 R0 FMAX\nL Z-30 F200\nL X+40\nUDC {form}\nL Z+0\n"
        );
        let (outcome, events) = run(&program, "turning_tools: [{T: 1, ZL: 100, TO: 1}]\nstart: [60, 0, 50]");
        assert_eq!(outcome.status, Status::Done, "{form}: {:?}", outcome.fault);
        let mut back: Vec<(f64, f64)> = ends(&events).iter().map(|(to, _)| (to.z, to.x)).collect();
        back.reverse();
        same_way(&back, &there);
    }
}

#[test]
fn recesses_lie_in_the_element_before_them() {
    // 10 wide about Z-15 and 5 deep, to the left of a contour that goes to lower Z: inwards. Chamfers of 1 at both edges.
    let (way, _) = undercut("GRV RADIAL CENTER-15 DEPTH-5 BREADTH10 CHF1 FAR_CHF1");
    same_way(
        &way,
        &[
            (0.0, 20.0),
            (-9.0, 20.0),
            (-10.0, 19.0),
            (-10.0, 15.0),
            (-20.0, 15.0),
            (-20.0, 19.0),
            (-21.0, 20.0),
            (-30.0, 20.0),
            (-30.0, 30.0),
            (-40.0, 30.0),
        ],
    );
    // Down to a diameter of 32 with walls that are 40 degrees apart, so 20 degrees each.
    let (way, angles) = undercut("GRV RADIAL CENTER-15 DIAM32 BREADTH10 ANG_WIDTH40 R0.5 RND1");
    let lean = 4.0 * 20.0_f64.to_radians().tan();
    assert!(way.iter().all(|(_, x)| *x >= 16.0 - 1e-9) && way.iter().any(|(_, x)| (*x - 16.0).abs() < 1e-9));
    let turned: Vec<f64> = angles.iter().map(|angle| (angle.abs() * 1e6).round() / 1e6).collect();
    assert_eq!(turned, [70.0, 70.0, 70.0]);
    let near = |point: (f64, f64)| way.iter().any(|own| (own.0 - point.0).hypot(own.1 - point.1) < 1e-9);
    assert!(near((-20.0, 20.0)), "{way:?}");
    let tangent = 0.5 * 35.0_f64.to_radians().tan();
    assert!(near((-10.0 - lean - tangent, 16.0)) && near((-20.0 + lean + tangent, 16.0)), "{way:?}");
    // In a face: the contour goes outwards at Z-30, and the part is to its left, at lower Z.
    let program = "TOOL CALL 1 Z S500 F200\nFUNCTION MODE TURN\nL X+20 Z-30 R0 FMAX\nL X+60 F200\n\
                   GRV AXIAL CENTER+40 DEPTH-3 BREADTH6\nL Z-40\n";
    let (outcome, events) = run(program, "turning_tools: [{T: 1, ZL: 100, TO: 1}]\nstart: [60, 0, 50]");
    assert_eq!(outcome.status, Status::Done, "{:?}", outcome.fault);
    let way: Vec<(f64, f64)> = ends(&events).iter().map(|(to, _)| (to.z, to.x)).collect();
    same_way(
        &way,
        &[(-30.0, 10.0), (-30.0, 17.0), (-33.0, 17.0), (-33.0, 23.0), (-30.0, 23.0), (-30.0, 30.0), (-40.0, 30.0)],
    );
    for missing in ["GRV RADIAL DEPTH-5 BREADTH10", "GRV RADIAL CENTER-15 BREADTH10", "GRV RADIAL CENTER-15 DEPTH-5"] {
        let program = format!("TOOL CALL 1 Z F200\nFUNCTION MODE TURN\nL X+40 Z+0 FMAX\nL Z-30\n{missing}\nL X+60\n");
        let (outcome, _) = run(&program, "start: [60, 0, 50]");
        assert_eq!(
            outcome.fault.map(|fault| fault.code.to_string()).as_deref(),
            Some("recess-impossible"),
            "{missing}"
        );
    }
}

/// `CUTLENGTH` of the table of turning tools is the length of the edges, and not `LCUTS` of the tool table.
#[test]
fn the_table_of_turning_tools_says_how_long_the_edges_are() {
    let length = |tools: &str| {
        let program = "TOOL CALL 1 Z S500 F200\nFUNCTION MODE TURN\nL X+75 Z+2 R0 FMAX\nCYCL DEF 811\nQ215=2\nQ460=2\n\
                       Q493=50\nQ494=-55\nQ463=3\nQ478=200\nQ483=0\nQ484=0\nQ505=100\nQ506=0\nCYCL CALL\n";
        let (outcome, events) = run(program, &format!("{tools}\nstart: [60, 0, 50]"));
        assert_eq!(outcome.status, Status::Done, "{tools}: {:?}", outcome.fault);
        let insert = events.iter().map(Event::to_json).find(|event| event["event"] == "insert").expect("an insert");
        insert["length"].as_f64().expect("a length")
    };
    let tool = "tools: [{T: 1, L: 100, R: 0, LCUTS: 8}]";
    assert_eq!(length("turning_tools: [{T: 1, ZL: 100, RS: 0.4, TO: 1, CUTLENGTH: 12}]"), 12.0);
    assert_eq!(length(&format!("{tool}\nturning_tools: [{{T: 1, ZL: 100, RS: 0.4, TO: 1, CUTLENGTH: 12}}]")), 12.0);
    assert_eq!(length(&format!("{tool}\nturning_tools: [{{T: 1, ZL: 100, RS: 0.4, TO: 1}}]")), 8.0);
    assert_eq!(length(tool), 8.0);
}

/// The name after the mode is that of the kinematics: of the machine of the scene.
#[test]
fn the_mode_may_name_the_kinematics_of_the_machine() {
    for (block, status) in [
        ("FUNCTION MODE TURN", Status::Done),
        ("FUNCTION MODE TURN \"mill-turn\"", Status::Done),
        ("5 FUNCTION MODE TURN \"MILL-TURN\" ;\"other\"", Status::Done),
        ("FUNCTION MODE MILL \"MILL-TURN\"", Status::Done),
        ("FUNCTION MODE TURN \"AC_TURN\"", Status::Unsupported),
    ] {
        let (outcome, _) =
            run(&format!("TOOL CALL 1 Z\n{block}\nM30\n"), "machine: mill-turn\ntools: [{T: 1, L: 100, R: 2}]");
        assert_eq!(outcome.status, status, "{block}: {:?}", outcome.fault);
    }
}

/// A contour cycle turns the undercut: what its nose can reach.
#[test]
fn a_contour_with_an_undercut_is_turned() {
    let program = "TOOL CALL 1 Z S500 F200\nFUNCTION MODE TURN\nCYCL DEF 14.0 CONTOUR\nCYCL DEF 14.1 CONTOUR LABEL 2\n\
                   L X+75 Z+2 R0 FMAX\nCYCL DEF 810\nQ215=2\nQ460=2\nQ499=0\nQ463=3\nQ478=200\nQ483=0\nQ484=0\nQ505=100\n\
                   Q487=1\nQ488=0\nQ479=0\nQ480=0\nQ482=0\nQ506=0\nCYCL CALL\nM30\n\
                   LBL 2\nL X+40 Z+0\nL Z-30\nUDC TYPE_U DEPTH3 BREADTH10\nL X+60\nLBL 0\n";
    let (outcome, events) = run(program, "turning_tools: [{T: 1, ZL: 100, TO: 1}]\nstart: [60, 0, 50]");
    assert_eq!(outcome.status, Status::Done, "{:?}", outcome.fault);
    let reached = ends(&events).iter().any(|(to, _)| to.distance(DVec3::new(17.0, 0.0, -30.0)) < 1e-9);
    assert!(reached, "{:?}", ends(&events));
}

/// The program ABSATZ of the manual (001:10358-10429): a shoulder of 150 in 160 with chamfers of 2 mm, and a recess of
/// 142 with chamfers of 1 mm; the tools are without radius here.
#[test]
fn the_program_of_the_manual_turns_its_shoulder_and_its_recess() {
    let program = include_str!("../engine/run/absatz.h");
    let scene = "turning_tools:\n  - {T: 12, ZL: 100, TO: 1, TYPE: ROUGH}\n\
                 \x20 - {T: 15, ZL: 100, CUTWIDTH: 3, TO: 1, TYPE: RECESS}\nstart: [120, 0, 100]";
    let (outcome, events) = run(program, scene);
    assert_eq!(outcome.status, Status::Done, "{:?}", outcome.fault);
    let finished = |cycle: u64| -> Vec<DVec3> {
        let json = events.iter().map(Event::to_json);
        let own = json.filter(|event| event["cycle"] == cycle && event["kind"] != "rapid");
        own.filter_map(|event| {
            let at = |axis: &str| event["to"][axis].as_f64();
            Some(DVec3::new(at("X")?, 0.0, at("Z")?))
        })
        .collect()
    };
    let passes = |way: &[DVec3], points: &[(f64, f64)]| {
        let mut at = way.iter();
        for (diameter, z) in points {
            let point = DVec3::new(diameter / 2.0, 0.0, *z);
            assert!(at.any(|to| to.distance(point) < 1e-9), "{point} is not passed in this order");
        }
    };
    // Chamfer, surface, rounded corner, face and chamfer.
    passes(
        &finished(812),
        &[(146.0, 0.0), (150.0, -2.0), (150.0, -39.0), (152.0, -40.0), (156.0, -40.0), (160.0, -42.0)],
    );
    // Flanks at Z-12 and Z-18 with their chamfers, down to the floor: the corner in front is 3 mm ahead on the first one.
    let flanks = [(150.0, -14.0), (148.0, -15.0), (142.0, -15.0), (150.0, -19.0), (148.0, -18.0), (142.0, -18.0)];
    passes(&finished(862), &flanks);
    let near_floor = finished(862).iter().map(|to| to.x).fold(f64::INFINITY, f64::min);
    assert!((near_floor - 71.0).abs() < 1e-9, "{near_floor}");
}
