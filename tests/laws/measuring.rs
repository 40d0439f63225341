//! Laws of measuring and calibrating over random worlds: every value that a cycle reports is the truth of the scene,
//! on every control, for every probe axis, in shifted and turned systems, with any ball, offset and pre-travel.
//!
//! Truths are calculated here from the scene's numbers, with plain trigonometry and nothing of the engine.
#![expect(clippy::disallowed_methods, reason = "truths are calculated with plain trigonometry")]
use std::fmt::Write as _;

use ciklo::base::diag::Source;
use ciklo::base::expr::QRef;
use ciklo::engine::run::{Content, Engine, EventKind, Outcome, Status};
use ciklo::engine::scene::Scene;
use ciklo::program::syntax;
use ciklo::tools::conform::LogTexts;
use proptest::prelude::*;

use crate::built;
use built::built;

const CONTROLS: [&str; 3] = ["tnc640", "tnc320", "tnc426-430"];

fn run(control: &str, program: &str, scene: &str) -> (Outcome, Vec<EventKind>) {
    let data = built();
    let on = data.catalogue.on(control).expect("a control");
    let parsed = Scene::parse(&Source::new("scene.yaml", scene), &data.files);
    let scene = parsed.unwrap_or_else(|found| panic!("{found:?}\n{scene}"));
    let texts = LogTexts::new(data.locales.language("en").expect("English"), control, &data.files);
    let tree = syntax::parse(&Source::new("LAW.H", program));
    let mut events = Vec::new();
    let engine = Engine::new(&tree, on, &scene, &texts).with_catalogue(&data.catalogue);
    let outcome = engine.run(&mut |event| events.push(event.kind));
    (outcome, events)
}

fn q(outcome: &Outcome, number: u16) -> f64 {
    match outcome.params.get(QRef::q(number)) {
        Some(Content::Number(number)) => number,
        other => panic!("Q{number} is {other:?}; {:?}", outcome.fault),
    }
}

/// The last value that a cell got.
fn cell(events: &[EventKind], wanted: &str) -> Option<f64> {
    events.iter().rev().find_map(|event| match event {
        EventKind::Table { column, value: Content::Number(value), .. } if column == wanted => Some(*value),
        _ => None,
    })
}

type Flat = (f64, f64);
type Point = [f64; 3];

fn turned((x, y): Flat, degrees: f64) -> Flat {
    let (s, c) = degrees.to_radians().sin_cos();
    (x * c - y * s, x * s + y * c)
}

fn dot(a: Point, b: Point) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn cross(a: Point, b: Point) -> Point {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

fn unit(a: Point) -> Point {
    let length = dot(a, a).sqrt();
    a.map(|x| x / length)
}

fn angle_of((x, y): Flat) -> f64 {
    y.atan2(x).to_degrees()
}

/// The machine, its probe and the systems around the part, all by main, minor and tool axis.
#[derive(Clone, Debug)]
struct Setup {
    control: usize,
    /// 0: probe axis Z, 1: Y, 2: X.
    axis: usize,
    ball: f64,
    pre_travel: f64,
    offset: Flat,
    track: bool,
    /// Where the preset lies and how it is turned about the probe axis.
    preset: Point,
    basic: f64,
    shift: Point,
    rotation: f64,
    inch: bool,
}

prop_compose! {
    fn setup()(
        control in 0..3usize, axis in 0..3usize, ball in 0.5..3.0, pre_travel in 0.0..0.05, offset in (-0.2..0.2, -0.2..0.2),
        track in any::<bool>(), preset in proptest::array::uniform3(-150.0..150.0), basic in -180.0..180.0,
        shift in proptest::array::uniform3(-40.0..40.0), rotation in -180.0..180.0, inch in any::<bool>(),
    ) -> Setup {
        // The manual of the third control names no cycle for a rotation.
        let rotation = if control == 2 { 0.0 } else { rotation };
        Setup { control, axis, ball, pre_travel, offset, track, preset, basic, shift, rotation, inch }
    }
}

impl Setup {
    fn control(&self) -> &'static str {
        CONTROLS[self.control]
    }

    /// Axis letters of main, minor and tool axis.
    fn letters(&self) -> [&'static str; 3] {
        [["X", "Y", "Z"], ["Z", "X", "Y"], ["Y", "Z", "X"]][self.axis]
    }

    /// A vector by axis letter, as YAML.
    fn yaml(&self, point: Point) -> String {
        let [a, b, c] = self.letters();
        format!("{{{a}: {}, {b}: {}, {c}: {}}}", point[0], point[1], point[2])
    }

    /// A vector in the order X, Y, Z.
    fn xyz(&self, point: Point) -> Point {
        let at = |letter: &str| self.letters().iter().position(|known| *known == letter).expect("an axis");
        [point[at("X")], point[at("Y")], point[at("Z")]]
    }

    /// A vector in the order main, minor, tool.
    fn of_xyz(&self, xyz: Point) -> Point {
        self.letters().map(|letter| xyz[["X", "Y", "Z"].iter().position(|known| *known == letter).expect("an axis")])
    }

    /// A scene whose solid is given in the coordinates of the program.
    fn scene(&self, solid: &str) -> String {
        self.scene_with(solid, "", "")
    }

    fn scene_with(&self, solid: &str, probe: &str, more: &str) -> String {
        let [a, b, c] = self.letters();
        let turn = ["SPC", "SPB", "SPA"][self.axis];
        let mut scene = format!(
            "scene: 1\ntools: [{{T: 1, NAME: PROBE, L: {}, R: {}, TP_NO: 1}}, {{T: 5, R: 6}}]\n",
            120.0 - self.pre_travel,
            self.ball - self.pre_travel,
        );
        let probe = if probe.is_empty() {
            format!(
                "CAL_OF1: {}, CAL_OF2: {}, length: 120, pre_travel: {}, TRACK: \"{}\"",
                self.offset.0,
                self.offset.1,
                self.pre_travel,
                if self.track { "ON" } else { "OFF" },
            )
        } else {
            probe.to_owned()
        };
        let _ = writeln!(scene, "probe: {{NO: 1, ball_radius: {}, DIST: 20, SET_UP: 2, {probe}}}", self.ball);
        let _ = writeln!(
            scene,
            "presets: {{active: 1, rows: [{{NO: 1, {a}: {}, {b}: {}, {c}: {}, {turn}: {}}}]}}\nstart: {}",
            self.preset[0],
            self.preset[1],
            self.preset[2],
            self.basic,
            self.yaml([self.shift[0], self.shift[1], self.shift[2] + 150.0]),
        );
        let rotate = self.xyz([0.0, 0.0, self.rotation]);
        let _ = writeln!(
            scene,
            "parts:\n  - place: {{shift: {}, rotate: {rotate:?}}}\n    solid: {solid}",
            self.yaml(self.shift)
        );
        scene + more
    }

    /// A length as the program writes it.
    fn len(&self, mm: f64) -> f64 {
        if self.inch { mm / 25.4 } else { mm }
    }

    /// A length that the program has, in mm.
    fn mm(&self, length: f64) -> f64 {
        if self.inch { length * 25.4 } else { length }
    }

    fn result(&self, outcome: &Outcome, number: u16) -> f64 {
        self.mm(q(outcome, number))
    }

    /// The beginning of every program: tool call, datum shift, rotation.
    fn head(&self) -> String {
        let [a, b, c] = self.letters();
        format!(
            "BEGIN PGM LAW {}\nTOOL CALL 1 {c}\nCYCL DEF 7.0 SHIFT\nCYCL DEF 7.1 {a}{:+}\nCYCL DEF 7.2 {b}{:+}\nCYCL DEF 7.3 {c}{:+}\n\
             {}",
            if self.inch { "INCH" } else { "MM" },
            self.len(self.shift[0]),
            self.len(self.shift[1]),
            self.len(self.shift[2]),
            if self.rotation == 0.0 {
                String::new()
            } else {
                format!("CYCL DEF 10.0 ROTATION\nCYCL DEF 10.1 ROT{:+}\n", self.rotation)
            },
        )
    }

    /// A definition with lengths in the program's unit and numbers as they are.
    fn definition(&self, cycle: u32, lengths: &[(u16, f64)], numbers: &[(u16, f64)]) -> String {
        let mut text = format!("TCH PROBE {cycle}\n");
        for (number, value) in lengths {
            let _ = writeln!(text, "Q{number}={}", self.len(*value));
        }
        for (number, value) in numbers {
            let _ = writeln!(text, "Q{number}={value}");
        }
        text
    }

    fn measured(&self, definition: &str, solid: &str) -> (Outcome, Vec<EventKind>) {
        let found = run(self.control(), &format!("{}{definition}", self.head()), &self.scene(solid));
        assert_eq!(found.0.status, Status::Done, "{:?}\n{definition}\n{solid}", found.0.fault);
        found
    }

    /// What some controls have beside the others.
    fn only(&self, controls: &[&str], parameters: &[(u16, f64)]) -> Vec<(u16, f64)> {
        if controls.contains(&self.control()) { parameters.to_vec() } else { Vec::new() }
    }
}

fn near(a: f64, b: f64) -> bool {
    (a - b).abs() < 1e-6
}

fn same_angle(a: f64, b: f64) -> bool {
    let gap = (a - b).rem_euclid(360.0);
    gap.min(360.0 - gap) < 1e-6
}

/// A block with what is cut out of it.
fn block(setup: &Setup, cut: &str) -> String {
    let (low, high) = (setup.yaml([-150.0, -150.0, -40.0]), setup.yaml([150.0, 150.0, 0.0]));
    format!("{{difference: [{{box: {{min: {low}, max: {high}}}}}, {cut}]}}")
}

fn cylinder(setup: &Setup, centre: Flat, diameter: f64, from: f64, to: f64) -> String {
    let axis = setup.letters()[2];
    format!(
        "{{cylinder: {{axis: {axis}, centre: [{}, {}], diameter: {diameter}, from: {from}, to: {to}}}}}",
        centre.0, centre.1
    )
}

fn cuboid(setup: &Setup, min: Point, max: Point) -> String {
    format!("{{box: {{min: {}, max: {}}}}}", setup.yaml(min), setup.yaml(max))
}

fn half_space(setup: &Setup, point: Point, normal: Point) -> String {
    format!("{{half_space: {{point: {}, normal: {}}}}}", setup.yaml(point), setup.yaml(normal))
}

/// The same below the datum, so that the probe can travel above it.
fn wall(setup: &Setup, point: Point, normal: Point) -> String {
    format!("{{difference: [{}, {}]}}", half_space(setup, point, normal), half_space(setup, [0.0; 3], [0.0, 0.0, -1.0]))
}

const NO_LIMITS: [(u16, f64); 3] = [(281, 0.0), (309, 0.0), (330, 0.0)];

laws! {
    #![proptest_config(crate::cases::config(50))]

    /// 420: the angle of a straight edge, probed along either axis from either side.
    #[test]
    fn the_angle_of_an_edge(setup in setup(), minor in any::<bool>(), minus in any::<bool>(), lean in -25.0..25.0_f64,
        at in (-40.0..40.0_f64, -40.0..40.0_f64), apart in 15.0..50.0_f64, back in any::<bool>(), above in any::<bool>()) {
        let sense = if minus { -1.0 } else { 1.0 };
        // The edge runs across the measuring axis, leaning a little; its material lies where the probe goes.
        let along = turned(if minor { (1.0, 0.0) } else { (0.0, 1.0) }, lean);
        let towards = if minor { (0.0, sense) } else { (sense, 0.0) };
        let normal = turned(along, 90.0);
        let flip = if normal.0 * towards.0 + normal.1 * towards.1 > 0.0 { -1.0 } else { 1.0 };
        let solid = wall(&setup, [at.0, at.1, 0.0], [normal.0 * flip, normal.1 * flip, 0.0]);
        // Points of the edge, with errors along the measuring axis.
        let way = if back { -apart } else { apart };
        let second = (at.0 + way * along.0, at.1 + way * along.1);
        let lengths = [(263, at.0), (264, at.1), (265, second.0 + 0.3 * towards.0), (266, second.1 + 0.3 * towards.1), (261, -5.0), (320, 1.0), (260, 30.0)];
        let numbers = [(272, if minor { 2.0 } else { 1.0 }), (267, sense), (301, f64::from(u8::from(above))), (281, 0.0)];
        let (outcome, _) = setup.measured(&setup.definition(420, &lengths, &numbers), &solid);
        let truth = angle_of((way * along.0, way * along.1));
        prop_assert!(same_angle(q(&outcome, 150), truth), "{} is not {truth}", q(&outcome, 150));
    }

    /// 421, 422: place and size of a circle, from three or four points anywhere on it.
    #[test]
    fn a_circle(setup in setup(), inside in any::<bool>(), centre in (-50.0..50.0_f64, -50.0..50.0_f64), diameter in 20.0..60.0_f64,
        error in (-0.5..0.5_f64, -0.5..0.5_f64, -0.5..0.5_f64), start in -180.0..180.0_f64, step in 25.0..90.0_f64, back in any::<bool>(),
        above in any::<bool>(), three in any::<bool>(), straight in any::<bool>()) {
        let step = if back { -step } else { step };
        let (cycle, greatest) = if inside { (421, 275) } else { (422, 277) };
        let solid = if inside {
            block(&setup, &cylinder(&setup, centre, diameter, -50.0, 10.0))
        } else {
            cylinder(&setup, centre, diameter, -40.0, 0.0)
        };
        let lengths = [(273, centre.0 + error.0), (274, centre.1 + error.1), (262, diameter + error.2), (261, -5.0), (320, 1.0),
            (260, 30.0), (greatest, 0.0), (greatest + 1, 0.0), (279, 0.0), (280, 0.0)];
        let mut numbers = vec![(325, start), (247, step), (301, f64::from(u8::from(above)))];
        numbers.extend(NO_LIMITS);
        numbers.extend(setup.only(&["tnc640", "tnc320"], &[(423, if three { 3.0 } else { 4.0 })]));
        numbers.extend(setup.only(&["tnc640"], &[(365, if straight { 0.0 } else { 1.0 })]));
        // On a straight line at clearance height nothing is in the way.
        let (outcome, _) = setup.measured(&setup.definition(cycle, &lengths, &numbers), &solid);
        let found = [151, 152, 153].map(|number| setup.result(&outcome, number));
        prop_assert!(near(found[0], centre.0) && near(found[1], centre.1) && near(found[2], diameter), "{found:?}");
        let deviations = [161, 162, 163].map(|number| setup.result(&outcome, number));
        prop_assert!(near(deviations[0], -error.0) && near(deviations[1], -error.1) && near(deviations[2], -error.2));
        prop_assert_eq!([180, 181, 182].map(|number| q(&outcome, number)), [1.0, 0.0, 0.0]);
    }

    /// 423, 424: place and sides of a rectangle.
    #[test]
    fn a_rectangle(setup in setup(), inside in any::<bool>(), centre in (-40.0..40.0_f64, -40.0..40.0_f64), sides in (12.0..80.0_f64, 12.0..80.0_f64),
        error in (-0.5..0.5_f64, -0.5..0.5_f64, -0.5..0.5_f64, -0.5..0.5_f64), above in any::<bool>()) {
        let (a, b) = (sides.0 / 2.0, sides.1 / 2.0);
        let solid = if inside {
            block(&setup, &cuboid(&setup, [centre.0 - a, centre.1 - b, -50.0], [centre.0 + a, centre.1 + b, 10.0]))
        } else {
            cuboid(&setup, [centre.0 - a, centre.1 - b, -40.0], [centre.0 + a, centre.1 + b, 0.0])
        };
        let lengths = [(273, centre.0 + error.0), (274, centre.1 + error.1), (282, sides.0 + error.2), (283, sides.1 + error.3),
            (261, -5.0), (320, 0.5), (260, 30.0), (284, 0.0), (285, 0.0), (286, 0.0), (287, 0.0), (279, 0.0), (280, 0.0)];
        let mut numbers = vec![(301, f64::from(u8::from(above)))];
        numbers.extend(NO_LIMITS);
        // A pocket into which the ball does not go is no pocket; one that is too narrow is probed from its centre.
        prop_assume!(!inside || a.min(b) > setup.ball + 1.5);
        prop_assume!(!inside || a.max(b) < 20.0 + setup.ball || a.min(b) > setup.ball + 4.0);
        let (outcome, _) = setup.measured(&setup.definition(if inside { 423 } else { 424 }, &lengths, &numbers), &solid);
        let found = [151, 152, 154, 155].map(|number| setup.result(&outcome, number));
        let truth = [centre.0, centre.1, sides.0, sides.1];
        prop_assert!(found.iter().zip(truth).all(|(found, truth)| near(*found, truth)), "{found:?} is not {truth:?}");
        let deviations = [161, 162, 164, 165].map(|number| setup.result(&outcome, number));
        prop_assert!(deviations.iter().zip([error.0, error.1, error.2, error.3]).all(|(found, error)| near(*found, -error)));
    }

    /// 425: the width of a slot and its middle.
    #[test]
    fn a_slot(setup in setup(), minor in any::<bool>(), middle in -40.0..40.0_f64, width in 12.0..30.0_f64, error in (-0.5..0.5_f64, -0.5..0.5_f64),
        other in -40.0..40.0_f64, beside in prop_oneof![Just(0.0), -20.0..20.0_f64], above in any::<bool>()) {
        let long = 120.0;
        let (low, high) = (middle - width / 2.0, middle + width / 2.0);
        let cut = if minor { ([-long, low, -50.0], [long, high, 10.0]) } else { ([low, -long, -50.0], [high, long, 10.0]) };
        let solid = block(&setup, &cuboid(&setup, cut.0, cut.1));
        let begin = if minor { (other, middle + error.0) } else { (middle + error.0, other) };
        let lengths = [(328, begin.0), (329, begin.1), (310, beside), (261, -5.0), (260, 30.0), (311, width + error.1), (288, 0.0), (289, 0.0)];
        let mut numbers = vec![(272, if minor { 2.0 } else { 1.0 })];
        numbers.extend(NO_LIMITS);
        numbers.extend(setup.only(&["tnc640"], &[(320, 0.0), (301, f64::from(u8::from(above)))]));
        let (outcome, _) = setup.measured(&setup.definition(425, &lengths, &numbers), &solid);
        let found = [156, 157, 166].map(|number| setup.result(&outcome, number));
        prop_assert!(near(found[0], width) && near(found[1], middle) && near(found[2], -error.1), "{found:?}");
    }

    /// 426: the width of a ridge and its middle, whichever side is given first.
    #[test]
    fn a_ridge(setup in setup(), minor in any::<bool>(), middle in -40.0..40.0_f64, width in 5.0..60.0_f64, error in (-0.5..0.5_f64, -0.5..0.5_f64),
        other in -40.0..40.0_f64, swap in any::<bool>()) {
        let long = 120.0;
        let (low, high) = (middle - width / 2.0, middle + width / 2.0);
        let ends = if minor { ([-long, low, -40.0], [long, high, 0.0]) } else { ([low, -long, -40.0], [high, long, 0.0]) };
        let solid = cuboid(&setup, ends.0, ends.1);
        let point = |at: f64| if minor { (other, at + error.0) } else { (at + error.0, other) };
        let (first, second) = if swap { (point(low), point(high)) } else { (point(high), point(low)) };
        let lengths = [(263, first.0), (264, first.1), (265, second.0), (266, second.1), (261, -5.0), (320, 1.0), (260, 30.0),
            (311, width + error.1), (288, 0.0), (289, 0.0)];
        let mut numbers = vec![(272, if minor { 2.0 } else { 1.0 })];
        numbers.extend(NO_LIMITS);
        let (outcome, _) = setup.measured(&setup.definition(426, &lengths, &numbers), &solid);
        let found = [156, 157, 166].map(|number| setup.result(&outcome, number));
        prop_assert!(near(found[0], width) && near(found[1], middle) && near(found[2], -error.1), "{found:?}");
    }

    /// 427 and 0: a coordinate in any axis and direction that can be probed from above.
    #[test]
    fn a_coordinate(setup in setup(), axis in 0..3usize, minus in any::<bool>(), face in -30.0..30.0_f64, at in (-40.0..40.0_f64, -40.0..40.0_f64), off in -0.5..0.5_f64) {
        let sense = if minus || axis == 2 { -1.0 } else { 1.0 };
        let mut point = [at.0, at.1, -10.0];
        point[axis] = face;
        let mut normal = [0.0; 3];
        normal[axis] = -sense;
        let solid = if axis == 2 { half_space(&setup, point, normal) } else { wall(&setup, point, normal) };
        point[axis] += off;
        let lengths = [(263, point[0]), (264, point[1]), (261, point[2]), (320, 1.0), (260, 50.0), (288, 0.0), (289, 0.0)];
        let mut numbers = vec![(272, axis as f64 + 1.0), (267, sense)];
        numbers.extend(NO_LIMITS);
        let mut before = point;
        before[axis] -= sense * (setup.ball + 3.0);
        before[2] -= setup.ball;
        let letters = setup.letters();
        let [a, b, c] = before.map(|value| setup.len(value));
        let reference = format!(
            "TCH PROBE 0.0 PLANE Q7 {}{}\nTCH PROBE 0.1 {}{a:+} {}{b:+} {}{c:+}\n",
            letters[axis], if sense < 0.0 { "-" } else { "+" }, letters[0], letters[1], letters[2],
        );
        let definition = setup.definition(427, &lengths, &numbers) + &reference;
        let (outcome, _) = setup.measured(&definition, &solid);
        prop_assert!(near(setup.result(&outcome, 160), face), "{} is not {face}", setup.result(&outcome, 160));
        prop_assert!(near(setup.result(&outcome, 7), face), "{} is not {face}", setup.result(&outcome, 7));
    }

    /// 430: the circle through the centres of three holes.
    #[test]
    fn a_bolt_hole_circle(setup in setup(), centre in (-30.0..30.0_f64, -30.0..30.0_f64), radius in 25.0..60.0_f64, hole in 14.0..20.0_f64,
        first in -180.0..180.0_f64, apart in (40.0..140.0_f64, 40.0..140.0_f64), error in (-0.3..0.3_f64, -0.3..0.3_f64, -0.3..0.3_f64)) {
        let angles = [first, first + apart.0, first + apart.0 + apart.1];
        let holes: Vec<String> = angles.iter().map(|angle| {
            let (x, y) = turned((radius, 0.0), *angle);
            cylinder(&setup, (centre.0 + x, centre.1 + y), hole, -50.0, 10.0)
        }).collect();
        let chord = |angle: f64| 2.0 * radius * (angle / 2.0).to_radians().sin();
        prop_assume!(chord(apart.0) > hole + 4.0 && chord(apart.1) > hole + 4.0 && chord(360.0 - apart.0 - apart.1) > hole + 4.0);
        let solid = block(&setup, &holes.join(", "));
        let lengths = [(273, centre.0 + error.0), (274, centre.1 + error.1), (262, 2.0 * (radius + error.2)), (261, -5.0), (260, 30.0),
            (288, 0.0), (289, 0.0), (279, 0.0), (280, 0.0)];
        let mut numbers = [(291, angles[0]), (292, angles[1]), (293, angles[2])].map(|(number, angle)| (number, (angle + 180.0).rem_euclid(360.0) - 180.0)).to_vec();
        numbers.extend(NO_LIMITS);
        let (outcome, _) = setup.measured(&setup.definition(430, &lengths, &numbers), &solid);
        let found = [151, 152, 153].map(|number| setup.result(&outcome, number));
        prop_assert!(near(found[0], centre.0) && near(found[1], centre.1) && near(found[2], 2.0 * radius), "{found:?}");
        let deviations = [161, 162, 163].map(|number| setup.result(&outcome, number));
        prop_assert!(near(deviations[0], -error.0) && near(deviations[1], -error.1) && near(deviations[2], -2.0 * error.2));
    }

    /// 431: the angles tilt the working plane so that it is parallel to the measured plane, with the main axis from the
    /// first point to the second.
    #[test]
    fn a_plane(setup in setup(), lean in 0.0..30.0_f64, around in -180.0..180.0_f64, height in -20.0..20.0_f64,
        points in proptest::array::uniform3((-40.0..40.0_f64, -40.0..40.0_f64))) {
        let away = turned((lean.to_radians().sin(), 0.0), around);
        let normal = [away.0, away.1, lean.to_radians().cos()];
        let level = |at: Flat| height - (normal[0] * at.0 + normal[1] * at.1) / normal[2];
        let side = (points[1].0 - points[0].0) * (points[2].1 - points[0].1) - (points[1].1 - points[0].1) * (points[2].0 - points[0].0);
        prop_assume!(side.abs() > 200.0);
        let solid = half_space(&setup, [0.0, 0.0, height], normal);
        let z = points.map(level);
        let lengths = [(263, points[0].0), (264, points[0].1), (294, z[0]), (265, points[1].0), (266, points[1].1), (295, z[1]),
            (296, points[2].0), (297, points[2].1), (298, z[2]), (320, 1.0), (260, 70.0)];
        let (outcome, _) = setup.measured(&setup.definition(431, &lengths, &[(281, 0.0)]), &solid);
        let (a, b) = (q(&outcome, 158).to_radians(), q(&outcome, 159).to_radians());
        if setup.control() == "tnc426-430" {
            // A about the main axis, then B about the minor axis, which stays where it is.
            let found = [a.cos() * b.sin(), -a.sin(), a.cos() * b.cos()];
            prop_assert!(found.iter().zip(normal).all(|(found, truth)| near(*found, truth)), "{found:?} is not {normal:?}");
            return Ok(());
        }
        // Sections: what rises along the minor axis turns about the main axis, what falls along the main axis about the minor one.
        prop_assert!(near(a.tan(), -normal[1] / normal[2]) && near(b.tan(), normal[0] / normal[2]));
        let spatial = [170, 171, 172].map(|number| q(&outcome, number).to_radians());
        // About X, then the fixed Y, then the fixed Z.
        let spin = |[x, y, z]: Point| {
            let (s, c) = spatial[0].sin_cos();
            let [x, y, z] = [x, y * c - z * s, y * s + z * c];
            let (s, c) = spatial[1].sin_cos();
            let [x, y, z] = [x * c + z * s, y, z * c - x * s];
            let (s, c) = spatial[2].sin_cos();
            [x * c - y * s, x * s + y * c, z]
        };
        let main = setup.of_xyz(spin(setup.xyz([1.0, 0.0, 0.0])));
        let tool = setup.of_xyz(spin(setup.xyz([0.0, 0.0, 1.0])));
        let along = unit([points[1].0 - points[0].0, points[1].1 - points[0].1, z[1] - z[0]]);
        let out = normal.map(|x| x * side.signum());
        prop_assert!(main.iter().zip(along).all(|(found, truth)| near(*found, truth)), "{main:?} is not {along:?}");
        prop_assert!(tool.iter().zip(out).all(|(found, truth)| near(*found, truth)), "{tool:?} is not {out:?}");
        prop_assert!(near(dot(cross(tool, main), along), 0.0));
    }

    /// 1 and 3: a point of a wall, probed at an angle: the ball touches with its centre one radius away from it.
    #[test]
    fn a_wall_at_an_angle(setup in setup(), angle in -180.0..180.0_f64, lean in -60.0..60.0_f64, from in (-40.0..40.0_f64, -40.0..40.0_f64),
        gap in 2.0..5.0_f64, back in 0.0..4.0_f64, machine in any::<bool>(), behind in any::<bool>()) {
        let way = turned((1.0, 0.0), angle);
        let normal = turned(way, 180.0 + lean);
        let clear = setup.ball + gap;
        let solid = wall(&setup, [from.0 - normal.0 * clear, from.1 - normal.1 * clear, 0.0], [normal.0, normal.1, 0.0]);
        let letters = setup.letters();
        let ball_height = -3.0;
        let [x, y, z] = [from.0, from.1, ball_height - (setup.ball - setup.pre_travel)].map(|value| setup.len(value));
        let position = format!("{}{x:+} {}{y:+} {}{z:+}", letters[0], letters[1], letters[2]);
        // The offset moves the ball before it moves: everything is measured from where the spindle stands.
        let mut program = format!("TCH PROBE 1.0 POLAR\nTCH PROBE 1.1 {} ANGLE: {angle:+}\nTCH PROBE 1.2 {position}\n", letters[0]);
        let path = if behind { -15.0 } else { 15.0 };
        let turn = if behind { 180.0 } else { 0.0 };
        let reference = u8::from(machine && setup.control() != "tnc426-430");
        // In the machine the direction counts from its axes.
        let angle = if reference == 1 { angle + setup.basic + setup.rotation } else { angle };
        let angle = (angle + turn + 180.0).rem_euclid(360.0) - 180.0;
        let _ = write!(program, "TCH PROBE 3.0 MEASURING\nTCH PROBE 3.1 Q20\nTCH PROBE 3.2 {} ANGLE: {angle:+}\n", letters[0]);
        if setup.control() == "tnc426-430" {
            let _ = writeln!(program, "TCH PROBE 3.3 DIST {:+} F100", setup.len(path));
        } else {
            let _ = writeln!(program, "TCH PROBE 3.3 DIST {:+} F100 MB{} REFERENCE SYSTEM: {reference}\nTCH PROBE 3.4 ERRORMODE0", setup.len(path), setup.len(back));
        }
        let (outcome, _) = setup.measured(&program, &solid);
        let touches = |found: Point| {
            // The ball centre is one effective radius from the wall, and on the line of the approach.
            let gap = (found[0] - from.0) * normal.0 + (found[1] - from.1) * normal.1 + clear;
            near(gap, setup.ball - setup.pre_travel)
        };
        // The plane of the machine axes turned by the system.
        let offset = setup.offset;
        let found = [115, 116, 117].map(|number| setup.result(&outcome, number));
        prop_assert!(near(found[2], ball_height), "{found:?}");
        prop_assert!(touches(found), "{found:?} {offset:?}");
        let mut found = [20, 21, 22].map(|number| setup.result(&outcome, number));
        if reference == 1 {
            let flat = turned((found[0] - setup.preset[0], found[1] - setup.preset[1]), -setup.basic);
            let flat = turned((flat.0 - setup.shift[0], flat.1 - setup.shift[1]), -setup.rotation);
            found = [flat.0, flat.1, found[2] - setup.preset[2] - setup.shift[2]];
        }
        prop_assert!(near(found[2], ball_height) && touches(found), "{found:?}");
        if setup.control() != "tnc426-430" {
            prop_assert_eq!(q(&outcome, 23), 0.0);
            // The tip stands back from the touch point, but not behind where it began.
            let stands = setup.letters().map(|letter| match letter { "X" => outcome.position.x, "Y" => outcome.position.y, _ => outcome.position.z });
            let way_back = (from.0 - stands[0]) * way.0 + (from.1 - stands[1]) * way.1;
            prop_assert!(way_back < 1e-6, "{way_back}");
        }
    }

    /// 444: a point of a slanted plane, along its normal.
    #[test]
    fn a_point_of_a_surface(setup in setup(), point in (-40.0..40.0_f64, -40.0..40.0_f64, -20.0..20.0_f64), lean in 0.0..60.0_f64,
        around in -180.0..180.0_f64, off in -0.5..0.5_f64, size in 0.5..5.0_f64) {
        let away = turned((lean.to_radians().sin(), 0.0), around);
        let normal = [away.0, away.1, lean.to_radians().cos()];
        let nominal = [point.0, point.1, point.2];
        let truth = [0, 1, 2].map(|i| nominal[i] + off * normal[i]);
        let setup = Setup { control: 0, ..setup };
        let solid = half_space(&setup, truth, normal);
        let lengths = [(263, point.0), (264, point.1), (294, point.2), (320, 0.0), (260, 70.0)];
        let mut definition = setup.definition(444, &lengths, &[(581, normal[0] * size), (582, normal[1] * size), (583, normal[2] * size), (309, 0.0)]);
        let _ = writeln!(definition, "QS400=\"{:.6}-{:.6}\"", setup.len(0.2), setup.len(0.1));
        let (outcome, _) = setup.measured(&definition, &solid);
        let found = [151, 152, 153].map(|number| setup.result(&outcome, number));
        prop_assert!(found.iter().zip(truth).all(|(found, truth)| near(*found, truth)), "{found:?} is not {truth:?}");
        prop_assert!(near(setup.result(&outcome, 164), off));
        let deviations = [161, 162, 163].map(|number| setup.result(&outcome, number));
        prop_assert!(deviations.iter().zip(normal).all(|(found, axis)| near(*found, off * axis)));
        prop_assume!((off - 0.2).abs() > 1e-4 && (off + 0.1).abs() > 1e-4);
        prop_assert_eq!(q(&outcome, 183), if off > 0.2 { 1.0 } else if off < -0.1 { 2.0 } else { 0.0 });
    }

    /// 460 to 463: whatever the tables say before, afterwards they have the effective radius, the offset and the length.
    #[test]
    fn a_calibration(setup in setup(), cycle in prop_oneof![Just(460u32), Just(462), Just(463)], size in 8.0..20.0_f64,
        off in (-0.3..0.3_f64, -0.3..0.3_f64), truth in (-0.05..0.05_f64, -0.05..0.05_f64), wrong in (-0.05..0.05_f64, -0.3..0.3_f64), points in 3..9u32,
        reference in 0.0..360.0_f64, above in any::<bool>(), turns in 0..3usize, length in any::<bool>()) {
        let setup = Setup { control: 0, track: false, ..setup };
        let inside = cycle == 462;
        let solid = match cycle {
            460 => format!("{{sphere: {{centre: {}, radius: {size}}}}}", setup.yaml([off.0, off.1, -30.0])),
            462 => block(&setup, &cylinder(&setup, off, 2.0 * size, -50.0, 10.0)),
            _ => cylinder(&setup, off, 2.0 * size, -60.0, 0.0),
        };
        let ball = setup.ball;
        prop_assume!(!inside || size > ball + 2.5);
        let orientation = ["fixed", "two", "any"][turns];
        let offset = (setup.offset.0, setup.offset.1);
        // Without a reversal the offset that the table has must be right.
        let believed = if turns == 0 { offset } else { (offset.0 + truth.0, offset.1 + truth.1) };
        let probe = format!(
            "CAL_OF1: {}, CAL_OF2: {}, offset: [{}, {}], length: {}, pre_travel: {}, orientation: {orientation}",
            believed.0, believed.1, offset.0, offset.1, 120.0 + wrong.1, setup.pre_travel,
        );
        // The table has a radius that is wrong by a little.
        let table_radius = ball - setup.pre_travel + wrong.0;
        let scene = setup.scene_with(&solid, &probe, "").replace(&format!("R: {}, TP_NO", ball - setup.pre_travel), &format!("R: {table_radius}, TP_NO"));
        let top = match cycle { 460 => size - 30.0 + 3.0, 462 => -8.0, _ => 3.0 };
        let letters = setup.letters();
        let head = format!("{}L {}+0 {}+0 R0 FMAX\nL {}{:+} R0 FMAX\n", setup.head(), letters[0], letters[1], letters[2], setup.len(top));
        let mut lengths = vec![(407, size), (320, 0.5)];
        let mut numbers = vec![(423, f64::from(points)), (380, reference)];
        if cycle != 462 {
            numbers.push((301, f64::from(u8::from(above))));
        }
        if cycle == 460 {
            numbers.push((433, f64::from(u8::from(length))));
            lengths.push((434, -30.0));
        }
        let (outcome, events) = run("tnc640", &format!("{head}{}", setup.definition(cycle, &lengths, &numbers)), &scene);
        prop_assert_eq!(outcome.status, Status::Done, "{:?}\n{}", outcome.fault, scene);
        let radius = cell(&events, "R").expect("a radius");
        prop_assert!(near(radius, ball - setup.pre_travel), "{radius} is not {}", ball - setup.pre_travel);
        match (cell(&events, "CAL_OF1"), cell(&events, "CAL_OF2")) {
            (Some(main), Some(minor)) => {
                prop_assert!(turns > 0);
                prop_assert!(near(main, offset.0) && near(minor, offset.1), "{main} {minor} is not {offset:?}");
            }
            _ => prop_assert!(turns == 0),
        }
        match cell(&events, "L") {
            Some(found) => prop_assert!(length && near(found, 120.0 + wrong.1 - setup.pre_travel), "{found}"),
            None => prop_assert!(!length || cycle != 460),
        }
    }

    /// 461: the length by a surface of known height. What follows is measured with it at once.
    #[test]
    fn a_length(setup in setup(), height in -20.0..20.0_f64, wrong in -0.5..0.5_f64, other in -3.0..3.0_f64) {
        let setup = Setup { control: 0, ..setup };
        let probe = format!("CAL_OF1: {}, CAL_OF2: {}, length: {}, pre_travel: {}", setup.offset.0, setup.offset.1, 120.0 + wrong, setup.pre_travel);
        let solid = format!("{{union: [{}, {}]}}", half_space(&setup, [0.0, 0.0, height], [0.0, 0.0, 1.0]),
            cuboid(&setup, [50.0, -20.0, height - 10.0], [90.0, 20.0, height + 3.0 + other]));
        let letters = setup.letters();
        let head = format!("{}L {}+0 {}+0 R0 FMAX\nL {}{:+} R0 FMAX\n", setup.head(), letters[0], letters[1], letters[2], setup.len(height + 8.0));
        let mut numbers = vec![(272, 3.0), (267, -1.0)];
        numbers.extend(NO_LIMITS);
        let after = setup.definition(427, &[(263, 70.0), (264, 0.0), (261, height + 3.0), (320, 3.0), (260, 50.0), (288, 0.0), (289, 0.0)], &numbers);
        let program = format!("{head}{}{after}", setup.definition(461, &[(434, height)], &[]));
        let (outcome, events) = run("tnc640", &program, &setup.scene_with(&solid, &probe, ""));
        prop_assert_eq!(outcome.status, Status::Done, "{:?}", outcome.fault);
        prop_assert!(near(cell(&events, "L").expect("a length"), 120.0 + wrong - setup.pre_travel));
        prop_assert!(near(setup.result(&outcome, 160), height + 3.0 + other), "{}", setup.result(&outcome, 160));
    }

    /// 2: the effective radius in a ring or on a stud whose place the machine parameters give.
    #[test]
    fn a_radius_on_a_known_part(setup in setup(), inside in any::<bool>(), size in 8.0..25.0_f64, wrong in -0.05..0.05_f64, depth in 2.0..8.0_f64) {
        let setup = Setup { control: 2, track: false, rotation: 0.0, ..setup };
        prop_assume!(!inside || size > setup.ball + 2.5);
        let solid = if inside {
            block(&setup, &cylinder(&setup, (0.0, 0.0), 2.0 * size, -50.0, 10.0))
        } else {
            cylinder(&setup, (0.0, 0.0), 2.0 * size, -60.0, 0.0)
        };
        // The part's centre in the machine: where the program's datum is.
        let (x, y) = turned((setup.shift[0], setup.shift[1]), setup.basic);
        let centre = setup.xyz([setup.preset[0] + x, setup.preset[1] + y, setup.preset[2] + setup.shift[2]]);
        let more = format!("machine_parameters: {{MP6180: {centre:?}, MP6185: {depth}}}\n");
        let radius = setup.ball - setup.pre_travel;
        let scene = setup.scene_with(&solid, "", &more).replace(&format!("R: {radius}, TP_NO"), &format!("R: {}, TP_NO", radius + wrong));
        let program = format!("{}TCH PROBE 2.0 CALIBRATE TS\nTCH PROBE 2.1 HEIGHT: {:+} R{:+} MEASURING MODE: {}\n",
            setup.head(), setup.len(50.0), setup.len(size), u8::from(!inside));
        let (outcome, events) = run("tnc426-430", &program, &scene);
        prop_assert_eq!(outcome.status, Status::Done, "{:?}\n{}", outcome.fault, scene);
        let found = cell(&events, "R").expect("a radius");
        prop_assert!(near(found, radius), "{found} is not {radius}");
    }
}

/// Where touch points scatter, the circles are the least-squares ones: results that a script has calculated with SciPy.
#[test]
fn fits_are_the_least_squares_ones() {
    let text = include_str!("../references/measuring_fits.json");
    let cases: serde_json::Value = serde_json::from_str(text).expect("the references");
    let cases = cases.as_array().expect("a list");
    assert!(cases.len() > 200);
    for case in cases {
        let part = |name: &str| case[name].as_str().expect("a text");
        let (outcome, events) = run("tnc640", part("program"), part("scene"));
        assert_eq!(outcome.status, Status::Done, "{:?}\n{}\n{}", outcome.fault, part("program"), part("scene"));
        let same = |found: f64, wanted: &serde_json::Value, name: &str| {
            let wanted = wanted.as_f64().expect("a number");
            assert!(
                (found - wanted).abs() < 1e-9,
                "{name} is {found} and not {wanted}:\n{}\n{}",
                part("program"),
                part("scene")
            );
        };
        for (number, wanted) in case["q"].as_object().into_iter().flatten() {
            same(q(&outcome, number.parse().expect("a number")), wanted, number);
        }
        for (column, wanted) in case["cells"].as_object().into_iter().flatten() {
            same(cell(&events, column).expect("a cell"), wanted, column);
        }
    }
}

/// The worked programs come out as they are written for.
#[test]
fn the_worked_programs_measure_their_workpieces() {
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("examples");
    let read = |name: &str| std::fs::read_to_string(folder.join(name)).expect("an example");
    let (outcome, _) = run("tnc640", &read("beams.h"), &read("beams.scene.yaml"));
    assert_eq!(outcome.status, Status::Done, "{:?}", outcome.fault);
    // Finished by as much less as it was roughed too large.
    assert!(near(q(&outcome, 1), 80.0 - 0.06) && near(q(&outcome, 2), 60.0 + 0.06));
    let (outcome, _) = run("tnc640", &read("bsmess.h"), &read("bsmess.scene.yaml"));
    assert_eq!(outcome.status, Status::Done, "{:?}", outcome.fault);
    let (file, log) = outcome.logs.first().expect("a log");
    assert_eq!(file, "TCHPR423.TXT");
    for piece in
        ["50.0905", "39.9347", "90.1200", "69.9920", "0.0905", "-0.0653", "0.1200", "-0.0080", "29-09-1997", "8:21:33"]
    {
        assert!(log.contains(piece), "{piece} is not in\n{log}");
    }
}

#[test]
fn deviations_of_a_tool_add_up() {
    let stud = "scene: 1\ntools: [{T: 1, L: 100, R: 2, TP_NO: 1}, {T: 5, R: 6, DR: 0.02, DL: 0.1, RBREAK: 0.2}]\n\
                probe: {NO: 1, ball_radius: 2}\nstart: [0, 0, 60]\nparts:\n  - solid: {cylinder: {diameter: 30.06, from: -30, to: 0.05}}\n";
    let stud_twice = "TCH PROBE 422\nQ273=0\nQ274=0\nQ262=30\nQ325=0\nQ247=90\nQ261=-5\nQ320=0\nQ260=20\nQ301=0\nQ277=30.1\nQ278=29.9\nQ279=0\nQ280=0\nQ281=0\nQ309=0\nQ330=5\n".repeat(2);
    let top = "TCH PROBE 427\nQ263=0\nQ264=0\nQ261=0\nQ320=0\nQ272=3\nQ267=-1\nQ260=20\nQ281=0\nQ288=0.1\nQ289=-0.1\nQ309=0\nQ330=5\n";
    let program = format!("TOOL CALL 1 Z\n{stud_twice}{}", top.repeat(2));
    let (outcome, events) = run("tnc426-430", &program, stud);
    assert_eq!(outcome.status, Status::Done, "{:?}", outcome.fault);
    // Within tolerance, and corrected all the same: 0.02 - 2 * 0.03. The top is 0.05 too high: the tool is shorter by it.
    assert!(near(cell(&events, "DR").expect("DR"), -0.04));
    assert!(near(cell(&events, "DL").expect("DL"), 0.0));
}

laws! {
    #![proptest_config(crate::cases::config(50))]

    /// Nearly degenerate geometry: finite values, or an error that says why.
    #[test]
    fn bad_geometry_is_finite_or_explained(setup in setup(), step in -8.0..8.0_f64, flat in -10.0..1.0_f64, cycle in prop_oneof![Just(421u32), Just(431)]) {
        let (definition, solid) = if cycle == 421 {
            let lengths = [(273, 0.0), (274, 0.0), (262, 30.0), (261, -5.0), (320, 0.0), (260, 30.0), (275, 0.0), (276, 0.0), (279, 0.0), (280, 0.0)];
            let mut numbers = vec![(325, 10.0), (247, step * 10.0_f64.powf(flat.min(0.0))), (301, 0.0)];
            numbers.extend(NO_LIMITS);
            numbers.extend(setup.only(&["tnc640", "tnc320"], &[(423, 4.0)]));
            numbers.extend(setup.only(&["tnc640"], &[(365, 1.0)]));
            (setup.definition(421, &lengths, &numbers), block(&setup, &cylinder(&setup, (0.0, 0.0), 30.0, -50.0, 10.0)))
        } else {
            let aside = 10.0_f64.powf(flat);
            let lengths = [(263, 0.0), (264, 0.0), (294, 0.0), (265, 20.0), (266, 0.0), (295, 0.0), (296, 40.0), (297, aside), (298, 0.0), (320, 1.0), (260, 30.0)];
            (setup.definition(431, &lengths, &[(281, 0.0)]), half_space(&setup, [0.0; 3], [0.01, 0.02, 1.0]))
        };
        let (outcome, _) = run(setup.control(), &format!("{}{definition}", setup.head()), &setup.scene(&solid));
        match &outcome.fault {
            Some(fault) => prop_assert!(
                ["stepping-angle-too-small", "fit-collinear", "fit-failed", "plane-through-line", "points-on-one-line"].contains(&&*fault.code), "{:?}", fault
            ),
            None => {
                let results: &[u16] = if cycle == 421 { &[151, 152, 153] } else { &[158, 159] };
                prop_assert!(results.iter().all(|number| q(&outcome, *number).is_finite()));
            }
        }
    }
}

/// Tables are in mm whatever the program is in: a datum found by a program in inches is the one found in mm.
#[test]
fn a_program_in_inches_writes_the_same_tables() {
    let scene = "scene: 1\ntools: [{T: 1, L: 100, R: 2, TP_NO: 1}, {T: 5, R: 6, RBREAK: 0.5}]\nprobe: {NO: 1, ball_radius: 2, DIST: 20}\n\
                 presets: {active: 1, rows: [{NO: 1, X: 12, Y: -7, Z: 3, SPC: 20}, {NO: 4, SPC: -11}]}\ndatums: [{D: 2, X: 1}]\nstart: [0, 0, 80]\nparts:\n  \
                 - solid: {difference: [{box: {min: [-150, -150, -30], max: [150, 150, 0]}}, {cylinder: {centre: [40.3, 30.2], diameter: 50.1, from: -40, to: 10}}]}\n";
    let cells = |inch: bool, row: u8, transfer: u8| {
        let len = |mm: f64| if inch { mm / 25.4 } else { mm };
        let lengths = [
            (321, 40.0),
            (322, 30.0),
            (262, 50.0),
            (261, -5.0),
            (320, 1.0),
            (260, 20.0),
            (331, 3.0),
            (332, -4.0),
            (382, 0.0),
            (383, 0.0),
            (384, 0.0),
            (333, 0.0),
        ];
        let mut program = format!("BEGIN PGM A {}\nTOOL CALL 1 Z\nTCH PROBE 412\n", if inch { "INCH" } else { "MM" });
        lengths.iter().for_each(|(number, value)| program.push_str(&format!("Q{number}={}\n", len(*value))));
        let _ = writeln!(program, "Q325=0\nQ247=90\nQ301=1\nQ305={row}\nQ303={transfer}\nQ381=0\nQ423=4\nQ365=1");
        program += "TCH PROBE 421\n";
        let lengths = [
            (273, 40.0),
            (274, 30.0),
            (262, 50.0),
            (261, -5.0),
            (320, 1.0),
            (260, 20.0),
            (275, 0.0),
            (276, 0.0),
            (279, 0.0),
            (280, 0.0),
        ];
        lengths.iter().for_each(|(number, value)| program.push_str(&format!("Q{number}={}\n", len(*value))));
        program += "Q325=0\nQ247=90\nQ301=0\nQ281=1\nQ309=0\nQ330=5\nQ423=4\nQ365=1\n";
        let (outcome, events) = run("tnc640", &program, scene);
        // The second cycle looks for the hole where it is no more once the display has changed.
        let done = outcome.status == Status::Done;
        let log = outcome.logs.first().map(|(_, log)| log.clone());
        let written: Vec<(String, f64)> = events
            .iter()
            .filter_map(|event| match event {
                EventKind::Table { column, value: Content::Number(value), .. } => Some((column.clone(), *value)),
                _ => None,
            })
            .collect();
        (done, written, log)
    };
    for (row, transfer) in [(4, 1), (2, 0), (0, 1)] {
        let (mm, inch) = (cells(false, row, transfer), cells(true, row, transfer));
        assert_eq!(mm.0, inch.0);
        assert_eq!(mm.1.len(), inch.1.len());
        for (a, b) in mm.1.iter().zip(&inch.1) {
            assert!(a.0 == b.0 && near(a.1, b.1), "{a:?} {b:?}");
        }
        if row != 0 {
            assert!(mm.1.iter().any(|(column, _)| column == "DR"));
            // The log has the values of the program.
            assert!(
                mm.2.expect("a log").contains("Diameter: 50.1000")
                    && inch.2.expect("a log").contains("Diameter: 1.9724")
            );
        }
    }
}
