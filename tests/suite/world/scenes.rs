//! Scenes: what is read, which defaults hold, and every mistake with its place.
use ciklo::base::data::embedded;
use ciklo::base::diag::Source;
use ciklo::engine::geometry::Frame;
use ciklo::engine::machine::Machine;
use ciklo::engine::scene::{Clock, ParameterValue, Scene};
use ciklo::engine::table::Cell;
use glam::{DVec2, DVec3, dvec3};

const FULL: &str = r#"
scene: 1
units: mm
clock: 2015-07-03T14:05:09
machine: mill-3-axis
machine_parameters: {measureTolerance1: 0.005, probingFeedCalc: ConstantFeed, centerPos: [10, 20, 30]}
tools:
  - {T: 5, NAME: DRILL, L: 80, R: 5, DR: 0.02, CUT: 2, "DIRECT.": "-"}
  - {T: 30, NAME: PROBE, L: 120, R: 2, TP_NO: 1}
probe: {NO: 1, TYPE: TS640, CAL_OF1: 0.01, F: 400, SET_UP: 3, DIST: 20, ball_radius: 2, offset: [0.02, -0.01]}
presets:
  active: 1
  rows: [{NO: 1, X: 100, Y: 50, Z: -20, SPC: 90}]
datums:
  - {D: 0}
  - {D: 1, X: 10, Y: 20, C: 45, DOC: "vise 2"}
start: {Z: 50}
stock: {box: {min: [0, 0, -20], max: [100, 80, 0]}}
parts:
  - solid:
      difference:
        - box: {min: [0, 0, -20], max: [100, 80, 0]}
        - cylinder: {axis: Z, centre: [50, 40], diameter: 20, from: 0, to: -20}
  - place: {shift: [0, 200, 0], rotate: [0, 0, 30]}
    solid: {sphere: {centre: [0, 0, 10], diameter: 25}}
answers:
  - continue
  - {to: confirm, say: no}
"#;

fn read(text: &str) -> Result<Scene, Vec<(&'static str, usize, usize)>> {
    Scene::parse(&Source::new("test.scene.yaml", text), &embedded()).map_err(|found| {
        found
            .iter()
            .map(|d| {
                let start = d.place.as_ref().map(|place| place.start());
                (d.code, start.map_or(0, |p| p.line), start.map_or(0, |p| p.column))
            })
            .collect()
    })
}

#[test]
fn a_full_scene_is_read() {
    let mut scene = read(FULL).expect("a sound scene");
    assert_eq!(scene.clock.to_string(), "2015-07-03T14:05:09");
    assert_eq!(scene.machine, Machine::named("mill-3-axis", &embedded()).expect("embedded"));
    assert_eq!(scene.machine_parameter("measureTolerance1"), Some(&ParameterValue::Number(0.005)));
    assert_eq!(scene.machine_parameter("probingFeedCalc"), Some(&ParameterValue::Text("ConstantFeed".to_owned())));
    assert_eq!(scene.machine_parameter("centerPos"), Some(&ParameterValue::List(vec![10.0, 20.0, 30.0])));
    assert_eq!(scene.tools.number(5.0, "DR"), Ok(Some(0.02)));
    assert_eq!(scene.tools.find("NAME", "PROBE"), Ok(Some(30.0)));
    assert_eq!(scene.probes.number(1.0, "F"), Ok(Some(400.0)));
    let probe = scene.probe.expect("a probe");
    assert_eq!((probe.row, probe.ball_radius, probe.offset), (1.0, 2.0, DVec2::new(0.02, -0.01)));
    assert_eq!(scene.datums[0].text(1.0, "DOC"), Ok("vise 2"));
    assert_eq!(scene.datums[0].get(0.0, "X"), Ok(Cell::Empty));
    assert_eq!(scene.active_preset, 1.0);
    assert!(scene.presets.has_row(0.0));
    // Preset 100, 50, -20 turned by 90 degrees: (0, 0, 50) stays on the axis.
    assert_eq!(scene.start, dvec3(100.0, 50.0, 30.0));
    assert_eq!(scene.answers.next("confirm").as_deref(), Some("continue"));
    assert_eq!(scene.answers.next("stop"), None);
    assert_eq!(scene.answers.next("confirm").as_deref(), Some("no"));
    assert!(scene.answers.is_empty());
}

#[test]
fn parts_stand_where_the_active_preset_puts_them() {
    let scene = read(FULL).expect("a sound scene");
    // The hole centre (50, 40, -5) turned by 90 degrees is (-40, 50, -5), shifted (60, 100, -25).
    let centre = dvec3(60.0, 100.0, -25.0);
    let found = scene.body.first_contact(2.0, centre, centre + dvec3(30.0, 0.0, 0.0)).expect("supported");
    let found = found.expect("a contact");
    // Radius 10 less ball radius 2.
    assert!((found.ball_centre - (centre + dvec3(8.0, 0.0, 0.0))).length() < 1e-9);
    // The sphere (0, 200, 10) is at (-200, 0, 10), shifted (-100, 50, -10).
    let above = dvec3(-100.0, 50.0, 100.0);
    let found = scene.body.first_contact(2.0, above, above - DVec3::Z * 200.0).expect("supported").expect("a contact");
    assert!((found.ball_centre.z - (-10.0 + 12.5 + 2.0)).abs() < 1e-9);
}

#[test]
fn a_minimal_scene_has_defaults() {
    let scene = read("scene: 1\n").expect("a sound scene");
    assert_eq!(scene.clock, Clock::DEFAULT);
    assert_eq!(scene.machine.name, "mill-3-axis");
    assert_eq!(scene.start, dvec3(0.0, 0.0, 100.0));
    assert_eq!(scene.active_preset, 0.0);
    assert_eq!(scene.probe, None);
    assert_eq!(scene.body.nearest(DVec3::ZERO), Ok(None));
    let probe = read("scene: 1\nprobe: {ball_radius: 3, CAL_OF2: 0.5}\n").expect("a sound scene");
    assert_eq!(probe.probes.number(1.0, "SET_UP"), Ok(Some(2.0)));
    // A probe of which nothing else is said is well calibrated.
    assert_eq!(probe.probe.map(|probe| probe.offset), Some(DVec2::new(0.0, 0.5)));
}

#[test]
fn inches_are_converted() {
    let text = "scene: 1\nunits: inch\ntools: [{T: 1, L: 2, CUT: 4}]\nstart: [1, 0, 2]\n";
    let scene = read(text).expect("a sound scene");
    assert_eq!(scene.tools.number(1.0, "L"), Ok(Some(50.8)));
    assert_eq!(scene.tools.number(1.0, "CUT"), Ok(Some(4.0)));
    assert_eq!(scene.start, dvec3(25.4, 0.0, 50.8));
}

#[test]
fn solids_of_all_kinds() {
    let solid = |text: &str| read(&format!("scene: 1\nparts: [{{solid: {text}}}]\n"));
    let distance = |text: &str, p: DVec3| {
        solid(text).expect("a sound scene").body.nearest(p).expect("supported").expect("something").distance
    };
    // From (0, 0, 50): top of the cone at 20, sphere top at 12, plane at 5.
    assert!(
        (distance("{cone: {axis: Z, centre: [0, 0], diameter: 20, from: 0, to: 20}}", dvec3(0.0, 0.0, 50.0)) - 30.0)
            .abs()
            < 1e-12
    );
    assert!(
        (distance("{cone: {diameter: 20, diameter_to: 10, from: 0, to: 20}}", dvec3(0.0, 0.0, 50.0)) - 30.0).abs()
            < 1e-12
    );
    assert!((distance("{sphere: {centre: {Z: 2}, radius: 10}}", dvec3(0.0, 0.0, 50.0)) - 38.0).abs() < 1e-12);
    assert!(
        (distance("{half_space: {point: [0, 0, 5], normal: [0, 0, 7]}}", dvec3(3.0, 0.0, 50.0)) - 45.0).abs() < 1e-12
    );
    // The centre of a cylinder along Y is (Z, X), or named.
    for centre in ["[30, 10]", "{X: 10, Z: 30}"] {
        let text = format!("{{cylinder: {{axis: Y, centre: {centre}, diameter: 10, from: -5, to: 5}}}}");
        assert!((distance(&text, dvec3(10.0, 0.0, 50.0)) - 15.0).abs() < 1e-12);
    }
    let nested = "{union: [{place: {shift: [0, 0, 7]}, solid: {box: {min: [-1, -1, -1], max: [1, 1, 1]}}}, {sphere: {diameter: 2}}]}";
    assert!((distance(nested, dvec3(0.0, 0.0, 50.0)) - 42.0).abs() < 1e-12);
    let codes = |text: &str| solid(text).expect_err("mistakes").into_iter().map(|(code, ..)| code).collect::<Vec<_>>();
    assert_eq!(codes("{box: {min: [0, 0, 0], max: [1, 0, 1]}}"), ["scene-min-max"]);
    assert_eq!(codes("{cylinder: {diameter: 0, from: 1, to: 1}}"), ["scene-not-positive", "scene-no-length"]);
    assert_eq!(codes("{cone: {diameter: -1, from: 0, to: 1}}"), ["scene-not-positive"]);
    assert_eq!(codes("{sphere: {diameter: .inf}}"), ["scene-expected"]);
    assert_eq!(codes("{half_space: {normal: [0, 0, 0]}}"), ["scene-no-length"]);
    assert_eq!(codes("{torus: {}}"), ["scene-unknown-key"]);
    assert_eq!(codes("{box: {}, sphere: {}}"), ["scene-one-solid"]);
    assert_eq!(codes("{union: []}"), ["scene-expected"]);
}

#[test]
fn all_mistakes_are_told_at_their_places() {
    let text = "\
scene: 2
units: cubits
clock: 2015-02-30
machine: lathe
speed: 3
tools:
  - {T: 1, RADIUS: 3}
  - {NAME: X}
  - {T: 1}
  - {T: 2, L: long}
probe: {SET_UP: 2}
presets: {active: 4, rows: [{NO: 1, X: nan}]}
datums: {PART.X: [{D: 0}]}
stock: {sphere: {diameter: 3}}
parts: [{solid: 3, colour: red}]
answers: {stop: go}
";
    let expected = [
        ("scene-unknown-key", 5, 1),
        ("scene-version", 1, 8),
        ("scene-expected", 2, 8),
        ("scene-expected", 3, 8),
        ("scene-unknown-machine", 4, 10),
        ("scene-unknown-key", 7, 12),
        ("scene-missing-key", 8, 5),
        ("scene-repeated", 9, 5),
        ("scene-expected", 10, 15),
        ("scene-missing-key", 11, 8),
        ("scene-expected", 12, 40),
        ("table-no-row", 12, 19),
        ("scene-expected", 13, 18),
        ("scene-unknown-key", 14, 9),
        ("scene-unknown-key", 15, 20),
        ("scene-expected", 15, 17),
        ("scene-expected", 16, 10),
    ];
    assert_eq!(read(text).expect_err("mistakes"), expected);
    assert_eq!(read("").expect_err("mistakes")[0].0, "spec-yaml-feature");
    assert_eq!(read("units: mm").expect_err("mistakes"), [("scene-missing-key", 1, 1)]);
    assert_eq!(read("scene: [1").expect_err("mistakes")[0].0, "spec-yaml-syntax");
    assert_eq!(read("scene: 1\nstart: {X: 5000}").expect_err("mistakes"), [("scene-start-outside", 2, 8)]);
}

#[test]
fn machines_are_data() {
    let text =
        "scene: 1\nmachine: {name: small, spindle: Z, axes: [{axis: Z, min: 0, max: 9, rapid: 50}]}\nstart: {Z: 5}\n";
    let machine = read(text).expect("a sound scene").machine;
    assert_eq!(machine.rapid_feed(dvec3(0.0, 0.0, -3.0)), 50.0);
    let mill = Machine::named("mill-3-axis", &embedded()).expect("embedded");
    // 300 in X at 20000 takes 0.015 min, 400 in Z at 15000 takes 0.0267 min: 500 in that time.
    assert!((mill.rapid_feed(dvec3(300.0, 0.0, 400.0)) - 500.0 * 15000.0 / 400.0).abs() < 1e-9);
    assert_eq!(mill.beyond_limits(dvec3(0.0, 0.0, 2000.0)).map(|axis| axis.axis.letter()), Some('Z'));
    assert_eq!(mill.beyond_limits(DVec3::ZERO), None);
    let twice =
        "scene: 1\nmachine: {axes: [{axis: Z, min: 0, max: 9, rapid: 50}, {axis: Z, min: 9, max: 0, rapid: 0}]}\n";
    assert_eq!(read(twice).expect_err("mistakes"), [("scene-not-positive", 2, 89)]);
}

#[test]
fn machines_turn_workpiece_and_tool() {
    let mill = Machine::named("mill-table-ac", &embedded()).expect("embedded");
    // A table axis turns against its coordinate: with A 90 what was in front points up, with C 90 what was right is
    // behind the axis of C, wherever A stands.
    let table = mill.table(dvec3(90.0, 0.0, 90.0));
    assert!((table.point(DVec3::X) - dvec3(0.0, 0.0, 1.0)).length() < 1e-12, "{}", table.point(DVec3::X));
    assert_eq!(mill.table(dvec3(0.0, 0.0, 90.0)).point(DVec3::X), -DVec3::Y);
    assert_eq!(mill.turned_too_far(dvec3(121.0, 0.0, 4000.0)).map(|axis| axis.axis.letter()), Some('A'));
    let head = Machine::named("mill-head-ac", &embedded()).expect("embedded");
    assert_eq!(head.head(dvec3(0.0, 0.0, 90.0)).vector(DVec3::X), DVec3::Y);
    assert_eq!((head.table(dvec3(9.0, 9.0, 9.0)), head.pivot), (Frame::IDENTITY, 150.0));
    let eccentric = "scene: 1\nmachine: {axes: [{axis: X, min: -9, max: 9, rapid: 1}], \
        rotary: [{axis: C, carries: workpiece, about: +Z, centre: [10, 0, 0], rapid: 5}]}\nstart: {X: 1, C: 30}\n";
    let scene = read(eccentric).expect("a sound scene");
    assert_eq!(scene.start_angles, dvec3(0.0, 0.0, 30.0));
    assert!((scene.machine.table(DVec3::Z * 90.0).point(DVec3::ZERO) - dvec3(10.0, -10.0, 0.0)).length() < 1e-12);
    assert_eq!(read("scene: 1\nstart: {C: 5}\n").expect_err("mistakes"), [("scene-no-axis", 2, 12)]);
    let too_far = "scene: 1\nmachine: mill-table-ac\nstart: {A: 121}\n";
    assert_eq!(read(too_far).expect_err("mistakes"), [("scene-start-outside", 3, 8)]);
}

#[test]
fn clocks_are_dates_that_exist() {
    for text in ["2016-02-29", "2015-07-03T14:05", "2015-07-03 14:05:09Z"] {
        assert!(Clock::parse(text).is_some(), "{text}");
    }
    for text in
        ["", "2015-02-29", "2015-13-01", "2015-07-03T24:00", "2015-07-03T14", "+015-07-03", "2015-7-3-4", "noon"]
    {
        assert_eq!(Clock::parse(text), None, "{text}");
    }
}

#[test]
fn the_documented_scene_is_read() {
    let page = include_str!("../../../docs/scene.md");
    let mut blocks = page.split("```yaml\n").skip(1).map(|rest| rest.split("```").next().unwrap_or_default());
    let scene = read(blocks.next().expect("a scene")).expect("a sound scene");
    assert_eq!(scene.start, dvec3(100.0, 50.0, 30.0));
    let machine = Machine::parse(&Source::new("machine.yaml", blocks.next().expect("a machine"))).expect("a machine");
    assert_eq!(machine.axes.len(), 1);
}
