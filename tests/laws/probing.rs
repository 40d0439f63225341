//! Laws of the misalignment and datum cycles over random scenes: what they report is the truth of the scene, and what
//! they write puts the program where the workpiece is, whatever the control, the probe axis and the systems in effect.
//!
//! Truths are calculated here from the scene's numbers, with plain trigonometry and nothing of the engine. Coordinates
//! are main, secondary and probe axis of the working plane.
#![expect(clippy::disallowed_methods, reason = "truths are calculated with plain trigonometry")]
use std::fmt::Write as _;

use ciklo::base::diag::Source;
use ciklo::base::expr::QRef;
use ciklo::engine::run::{Content, Engine, EventKind, NoTexts, Outcome, Status};
use ciklo::engine::scene::Scene;
use ciklo::program::syntax;
use proptest::prelude::*;

use crate::built;
use built::{Built, built};

type Flat = (f64, f64);

const LETTERS: [&str; 3] = ["X", "Y", "Z"];
const TURNS: [&str; 3] = ["A", "B", "C"];
const CONTROLS: [&str; 3] = ["tnc640", "tnc320", "tnc426-430"];

fn turned(p: Flat, degrees: f64) -> Flat {
    let (s, c) = degrees.to_radians().sin_cos();
    (p.0 * c - p.1 * s, p.0 * s + p.1 * c)
}

fn plus(a: Flat, b: Flat) -> Flat {
    (a.0 + b.0, a.1 + b.1)
}

fn minus(a: Flat, b: Flat) -> Flat {
    (a.0 - b.0, a.1 - b.1)
}

fn near(a: f64, b: f64) -> bool {
    (a - b).abs() < 1e-6
}

/// The angle of the same line between -90 and 90.
fn line(degrees: f64) -> f64 {
    degrees - 180.0 * (degrees / 180.0).round()
}

/// A machine with its systems in effect. The preset's basic rotation is in effect unless a cycle ends it.
#[derive(Clone, Debug)]
struct Place {
    control: &'static str,
    /// The probe axis: 0 X, 1 Y, 2 Z.
    tool: usize,
    ball: f64,
    pre_travel: f64,
    offset: Flat,
    origin: (f64, f64, f64),
    basic: f64,
    shift: (f64, f64, f64),
    rotation: f64,
    /// The axis of the table in machine coordinates.
    centre: Flat,
}

prop_compose! {
    fn place()(
        control in 0..3usize, tool in 0..3usize, ball in 0.5..3.0, pre_travel in 0.0..0.05, offset in (-0.2..0.2, -0.2..0.2),
        origin in (-200.0..200.0, -200.0..200.0, -100.0..100.0), basic in -170.0..170.0, plain in any::<bool>(),
        shift in (-50.0..50.0, -50.0..50.0, -20.0..20.0), rotation in -170.0..170.0, straight in any::<bool>(),
        centre in (-100.0..100.0, -100.0..100.0),
    ) -> Place {
        let basic = if plain || CONTROLS[control] == "tnc426-430" { 0.0 } else { basic };
        // The manual of the oldest control knows no cycle that rotates.
        let rotation = if straight || CONTROLS[control] == "tnc426-430" { 0.0 } else { rotation };
        Place { control: CONTROLS[control], tool, ball, pre_travel, offset, origin, basic, shift, rotation, centre }
    }
}

impl Place {
    /// The letter of an axis of the plane: 0 main, 1 secondary, 2 probe axis.
    fn letter(&self, axis: usize) -> &'static str {
        LETTERS[(self.tool + 1 + axis) % 3]
    }

    fn at(&self, p: Flat, height: f64) -> String {
        format!("{{{}: {}, {}: {}, {}: {height}}}", self.letter(0), p.0, self.letter(1), p.1, self.letter(2))
    }

    fn of(&self, machine: glam::DVec3) -> (Flat, f64) {
        let all = machine.to_array();
        let axis = |axis: usize| all[(self.tool + 1 + axis) % 3];
        ((axis(0), axis(1)), axis(2))
    }

    /// Machine coordinates of a point of the program under a basic rotation.
    fn machine(&self, p: Flat, basic: f64) -> Flat {
        let of_preset = plus((self.shift.0, self.shift.1), turned(p, self.rotation));
        plus((self.origin.0, self.origin.1), turned(of_preset, basic))
    }

    /// Coordinates of the program of a point of the machine.
    fn program(&self, machine: Flat, basic: f64) -> Flat {
        let of_preset = turned(minus(machine, (self.origin.0, self.origin.1)), -basic);
        turned(minus(of_preset, (self.shift.0, self.shift.1)), -self.rotation)
    }

    /// The scene with a solid that has its own coordinates: `at` in the program, turned by `turn`, under a basic rotation.
    fn scene(&self, solid: &str, at: Flat, turn: f64, basic: f64, more: &str) -> String {
        let machine = self.machine(at, basic);
        let of_preset = turned(minus(machine, (self.origin.0, self.origin.1)), -self.basic);
        let angle = basic - self.basic + self.rotation + turn;
        let start = turned(minus(self.machine(at, basic), (self.origin.0, self.origin.1)), -self.basic);
        let axes: Vec<String> =
            LETTERS.iter().map(|axis| format!("{{axis: {axis}, min: -5000, max: 5000, rapid: 9000}}")).collect();
        format!(
            "scene: 1\nmachine: {{spindle: {tool}, axes: [{}], rotary: [{{axis: {turns}, carries: workpiece, centre: {}, rapid: 3600}}]}}\n\
             tools: [{{T: 1, L: {length}, R: {effective}, TP_NO: 1}}]\n\
             probe: {{NO: 1, ball_radius: {ball}, length: 100, pre_travel: {pre_travel}, DIST: 40, SET_UP: 2, CAL_OF1: {}, CAL_OF2: {}}}\n\
             presets: {{active: 1, rows: [{{NO: 1, {m}: {}, {n}: {}, {tool}: {}, SP{turns}: {}}}, {{NO: 12}}]}}\n\
             datums: [{{D: 12}}]\nstart: {}\n{more}parts:\n  - place: {{shift: {}, rotate: {{{turns}: {angle}}}}}\n    solid: {solid}\n",
            axes.join(", "),
            self.at(self.centre, 0.0),
            self.offset.0,
            self.offset.1,
            self.origin.0,
            self.origin.1,
            self.origin.2,
            self.basic,
            self.at(start, self.shift.2 + 90.0),
            self.at(of_preset, self.shift.2),
            tool = self.letter(2),
            m = self.letter(0),
            n = self.letter(1),
            turns = TURNS[self.tool],
            ball = self.ball,
            pre_travel = self.pre_travel,
            effective = self.ball - self.pre_travel,
            length = 100.0 - self.pre_travel,
        )
    }

    fn head(&self) -> String {
        let (m, n, t) = (self.letter(0), self.letter(1), self.letter(2));
        let mut text = format!(
            "BEGIN PGM LAW MM\nTOOL CALL 1 {t}\nCYCL DEF 7.0 SHIFT\nCYCL DEF 7.1 {m}{:+}\nCYCL DEF 7.2 {n}{:+}\nCYCL DEF 7.3 {t}{:+}\n",
            self.shift.0, self.shift.1, self.shift.2
        );
        if self.rotation != 0.0 {
            let _ = writeln!(text, "CYCL DEF 10.0 ROTATION\nCYCL DEF 10.1 ROT{:+}", self.rotation);
        }
        text
    }

    /// A definition with the parameters that the cycle has on the control; those not given are 0.
    fn cycle(&self, number: u32, values: &[(u16, f64)]) -> String {
        let on = built().catalogue.on(self.control).expect("a control");
        let found = on.cycles.iter().find(|(key, _)| key.number == number && key.to_string().starts_with("TCH PROBE"));
        let mut text = format!("TCH PROBE {number}\n");
        for param in &found.expect("the control has the cycle").1.params {
            let q = param.q.expect("a Q parameter");
            let value = values.iter().rev().find(|(known, _)| *known == q.number).map_or(0.0, |(_, value)| *value);
            let _ = writeln!(text, "{q}={value}");
        }
        text
    }

    fn run(&self, program: &str, scene: &str) -> (Outcome, Vec<EventKind>) {
        let Built { files, catalogue, .. } = built();
        let parsed = Scene::parse(&Source::new("scene.yaml", scene), files);
        let scene = parsed.unwrap_or_else(|found| panic!("{found:?}\n{scene}"));
        let tree = syntax::parse(&Source::new("LAW.H", program));
        let mut events = Vec::new();
        let engine = Engine::new(&tree, catalogue.on(self.control).expect("a control"), &scene, &NoTexts);
        let outcome = engine.with_catalogue(catalogue).run(&mut |event| events.push(event.kind));
        (outcome, events)
    }

    fn block(&self, low: Flat, high: Flat, from: f64, to: f64) -> String {
        format!("{{box: {{min: {}, max: {}}}}}", self.at(low, from), self.at(high, to))
    }

    fn cylinder(&self, centre: Flat, diameter: f64, from: f64, to: f64) -> String {
        let (m, n, t) = (centre.0, centre.1, self.letter(2));
        format!("{{cylinder: {{axis: {t}, centre: [{m}, {n}], diameter: {diameter}, from: {from}, to: {to}}}}}")
    }

    fn plate_without(&self, holes: &[String]) -> String {
        let plate = self.block((-150.0, -150.0), (150.0, 150.0), -30.0, 0.0);
        format!("{{difference: [{plate}, {}]}}", holes.join(", "))
    }

    fn plate_with(&self, studs: &[String]) -> String {
        let plate = self.block((-150.0, -150.0), (150.0, 150.0), -60.0, -30.0);
        format!("{{union: [{plate}, {}]}}", studs.join(", "))
    }
}

fn q(outcome: &Outcome, number: u16) -> f64 {
    match outcome.params.get(QRef::q(number)) {
        Some(Content::Number(number)) => number,
        other => panic!("Q{number} is {other:?}; {:?}", outcome.fault),
    }
}

fn cell(events: &[EventKind], name: &str) -> Option<f64> {
    events.iter().rev().find_map(|event| match event {
        EventKind::Table { column, value: Content::Number(value), .. } if column == name => Some(*value),
        _ => None,
    })
}

/// The basic rotation about the probe axis that was told last.
fn basic_rotation(place: &Place, events: &[EventKind]) -> f64 {
    let told = events.iter().rev().find_map(|event| match event {
        EventKind::Transform(system) => Some(system.basic_rotation),
        _ => None,
    });
    told.map_or(place.basic, |angles| angles.to_array()[place.tool])
}

fn last_machine(events: &[EventKind]) -> glam::DVec3 {
    let last = events.iter().rev().find_map(|event| match event {
        EventKind::Move { machine, .. } => Some(*machine),
        _ => None,
    });
    last.expect("a move")
}

/// Values that most cycles share: measuring height, clearance height, way between the points.
fn common(high: bool) -> Vec<(u16, f64)> {
    vec![(261, -5.0), (320, 1.0), (260, 30.0), (301, f64::from(u8::from(high)))]
}

/// What a datum cycle measures: its number and values, a solid in its own coordinates, how far that is turned, the point
/// that becomes the datum (own coordinates), a place of its upper face, results, and the axis if there is only one.
struct Feature {
    number: u32,
    values: Vec<(u16, f64)>,
    solid: String,
    turn: f64,
    point: Flat,
    top: Flat,
    results: Vec<(u16, f64)>,
    axis: Option<usize>,
}

/// Random sizes and errors of a feature.
#[derive(Clone, Copy, Debug)]
struct Sizes {
    at: Flat,
    a: f64,
    b: f64,
    error: Flat,
    turn: f64,
    sense: bool,
    high: bool,
}

prop_compose! {
    fn sizes()(
        at in (-60.0..60.0, -60.0..60.0), a in 20.0..60.0, b in 20.0..60.0, error in (-0.8..0.8, -0.8..0.8),
        turn in -2.0..2.0, sense in any::<bool>(), high in any::<bool>(),
    ) -> Sizes {
        Sizes { at, a, b, error, turn, sense, high }
    }
}

impl Sizes {
    /// Where a point of the solid lies in the program, with the error of what the program knows.
    fn nominal(&self, own: Flat, turn: f64) -> Flat {
        plus(plus(self.at, turned(own, turn)), self.error)
    }

    /// Where it truly lies.
    fn truth(&self, own: Flat, turn: f64) -> Flat {
        plus(self.at, turned(own, turn))
    }
}

const KINDS: usize = 11;

fn feature(kind: usize, place: &Place, s: &Sizes) -> Feature {
    let mut values = common(s.high);
    let centre = s.nominal((0.0, 0.0), 0.0);
    let truth = s.truth((0.0, 0.0), 0.0);
    let narrow = |along: usize, from: f64, to: f64| {
        let (half, long) = (s.a / 2.0, 100.0);
        let side = if along == 0 { (half, long) } else { (long, half) };
        place.block((-side.0, -side.1), side, from, to)
    };
    let done = |number, values, solid, turn, results| Feature {
        number,
        values,
        solid,
        turn,
        point: (0.0, 0.0),
        top: (120.0, 0.0),
        results,
        axis: None,
    };
    match kind {
        // Slot and ridge: one axis.
        0 | 1 => {
            let along = usize::from(s.sense);
            values.extend([(321, centre.0), (322, centre.1), (311, s.a), (272, along as f64 + 1.0)]);
            let solid = if kind == 0 {
                place.plate_without(&[narrow(along, -40.0, 0.0)])
            } else {
                place.plate_with(&[narrow(along, -30.0, 0.0)])
            };
            // A touch of the ridge's ends or of the slot's is not meant: both are long.
            let results = vec![(166, s.a), (157, if along == 0 { truth.0 } else { truth.1 })];
            let top = if kind == 0 { (120.0, 120.0) } else { (0.0, 0.0) };
            Feature { axis: Some(along), top, ..done(408 + kind as u32, values, solid, 0.0, results) }
        }
        // Rectangles.
        2 | 3 => {
            values.extend([(321, centre.0), (322, centre.1), (323, s.a), (324, s.b)]);
            let own = |from, to| place.block((-s.a / 2.0, -s.b / 2.0), (s.a / 2.0, s.b / 2.0), from, to);
            let (solid, top) = if kind == 2 {
                (place.plate_without(&[own(-20.0, 0.0)]), (120.0, 0.0))
            } else {
                (place.plate_with(&[own(-30.0, 0.0)]), (0.0, 0.0))
            };
            let results = vec![(151, truth.0), (152, truth.1), (154, s.a), (155, s.b)];
            Feature { top, ..done(408 + kind as u32, values, solid, 0.0, results) }
        }
        // Circles.
        4 | 5 => {
            let step = if s.sense { 90.0 } else { -60.0 };
            values.extend([(321, centre.0), (322, centre.1), (262, s.a), (325, s.b * 3.0), (247, step)]);
            values.extend([(423, if s.high { 3.0 } else { 4.0 }), (365, 1.0)]);
            let (solid, top) = if kind == 4 {
                (place.plate_without(&[place.cylinder((0.0, 0.0), s.a, -40.0, 0.0)]), (120.0, 0.0))
            } else {
                (place.plate_with(&[place.cylinder((0.0, 0.0), s.a, -30.0, 0.0)]), (0.0, 0.0))
            };
            let results = vec![(151, truth.0), (152, truth.1), (153, s.a)];
            Feature { top, ..done(408 + kind as u32, values, solid, s.turn, results) }
        }
        // Outside corner: which one, the points 1 and 3 say.
        6 => {
            let (x, y) = (if s.sense { 1.0 } else { -1.0 }, if s.high { 1.0 } else { -1.0 });
            let (one, three) = ((-x * (10.0 + s.a), 0.0), (0.0, y * 10.0));
            let (first, third) = (s.nominal(one, s.turn), s.nominal(three, s.turn));
            values.extend([(263, first.0), (264, first.1), (326, s.a), (296, third.0), (297, third.1), (327, s.b)]);
            values.push((320, 4.0));
            let (low, high) = (
                (f64::min(-x * 140.0, 0.0), f64::min(y * 140.0, 0.0)),
                (f64::max(-x * 140.0, 0.0), f64::max(y * 140.0, 0.0)),
            );
            let solid = place.block(low, high, -30.0, 0.0);
            let results = vec![(151, truth.0), (152, truth.1)];
            Feature { top: (-x * 60.0, y * 60.0), ..done(414, values, solid, s.turn, results) }
        }
        // Inside corner.
        7 => {
            let corner = (s.a as usize + s.b as usize) % 4;
            let (x, y) = [(1.0, 1.0), (-1.0, 1.0), (-1.0, -1.0), (1.0, -1.0)][corner];
            values.extend([(263, centre.0), (264, centre.1), (326, s.a), (327, s.b), (308, corner as f64 + 1.0)]);
            values.push((320, 4.0));
            let room = place.block(
                (f64::min(x * 120.0, 0.0), f64::min(y * 120.0, 0.0)),
                (f64::max(x * 120.0, 0.0), f64::max(y * 120.0, 0.0)),
                -20.0,
                0.0,
            );
            let results = vec![(151, truth.0), (152, truth.1)];
            Feature { top: (-x * 40.0, -y * 40.0), ..done(415, values, place.plate_without(&[room]), s.turn, results) }
        }
        // Three holes on a circle.
        8 => {
            let angles = [s.b * 2.0, s.b * 2.0 + 100.0, s.b * 2.0 + 210.0];
            let diameter = s.a + 40.0;
            values.extend([(273, centre.0), (274, centre.1), (262, diameter)]);
            values.extend([(291, angles[0]), (292, angles[1]), (293, angles[2])]);
            let holes: Vec<String> = angles
                .iter()
                .map(|angle| place.cylinder(turned((diameter / 2.0, 0.0), *angle), 14.0, -40.0, 0.0))
                .collect();
            let results = vec![(151, truth.0), (152, truth.1), (153, diameter)];
            Feature { top: (0.0, 0.0), ..done(416, values, place.plate_without(&holes), 0.0, results) }
        }
        // Four holes across.
        9 => {
            let own = [(-s.a, -s.b), (s.a, -s.b), (s.a, s.b), (-s.a, s.b)];
            for (index, hole) in own.iter().enumerate() {
                let at = s.nominal(*hole, s.turn);
                let first = [268u16, 270, 316, 318][index];
                values.extend([(first, at.0), (first + 1, at.1)]);
            }
            let holes: Vec<String> = own.iter().map(|hole| place.cylinder(*hole, 16.0, -40.0, 0.0)).collect();
            let results = vec![(151, truth.0), (152, truth.1)];
            Feature { top: (0.0, 0.0), ..done(418, values, place.plate_without(&holes), s.turn, results) }
        }
        // A face in one axis.
        _ => {
            let along = usize::from(s.sense);
            let sense = if s.high { 1.0 } else { -1.0 };
            values.extend([(263, centre.0), (264, centre.1), (272, along as f64 + 1.0), (267, sense)]);
            let far = sense * 100.0;
            let (low, high) = if along == 0 {
                ((f64::min(far, 0.0), -100.0), (f64::max(far, 0.0), 100.0))
            } else {
                ((-100.0, f64::min(far, 0.0)), (100.0, f64::max(far, 0.0)))
            };
            Feature {
                axis: Some(along),
                top: (0.0, 0.0),
                ..done(419, values, place.block(low, high, -30.0, 0.0), 0.0, vec![])
            }
        }
    }
}

laws! {
    #![proptest_config(crate::cases::config(400))]

    /// A datum cycle reports the truth, and wherever its datum goes (display, preset table, datum table by either
    /// reference), the point has the wanted coordinates once that is in effect.
    #[test]
    fn a_datum_lies_where_the_workpiece_is(
        place in place(), sizes in sizes(), kind in 0..KINDS, target in 0..3usize,
        wanted in (-30.0..30.0, -30.0..30.0, -10.0..10.0), of_machine in any::<bool>(),
    ) {
        let old = place.control == "tnc426-430";
        prop_assume!(!old || !matches!(kind, 0 | 1 | 10));
        let target = if old && target == 1 { 2 } else { target };
        let made = feature(kind, &place, &sizes);
        // The height is set, too, where the control has that and no rule forbids it.
        let with_top = !old && target != 2 && made.number != 419;
        let mut values = made.values.clone();
        let row = if target == 0 { 0.0 } else { 12.0 };
        values.extend([(305, row), (303, if target == 2 { 0.0 } else { 1.0 })]);
        let coordinate = made.axis.map(|axis| if axis == 0 { wanted.0 } else { wanted.1 });
        values.extend([(331, wanted.0), (332, wanted.1), (405, coordinate.unwrap_or(0.0)), (333, coordinate.filter(|_| made.number == 419).unwrap_or(wanted.2))]);
        if with_top {
            let top = sizes.truth(made.top, made.turn);
            values.extend([(381, 1.0), (382, top.0), (383, top.1), (384, 0.5)]);
        }
        let mut program = place.head() + &place.cycle(made.number, &values);
        if target == 1 {
            let none = "CYCL DEF 7.0 SHIFT\nCYCL DEF 7.1 X+0\nCYCL DEF 7.2 Y+0\nCYCL DEF 7.3 Z+0\nCYCL DEF 10.0 ROTATION\nCYCL DEF 10.1 ROT+0\n";
            program += &format!("{none}CYCL DEF 247\nQ339=12\n");
        } else if target == 2 {
            program += "CYCL DEF 7.0 SHIFT\nCYCL DEF 7.1 #12\n";
        }
        let (m, n, t) = (place.letter(0), place.letter(1), place.letter(2));
        if with_top {
            program += &format!("L {t}{:+} FMAX\n", wanted.2 + 45.0);
        }
        program += &match made.axis {
            Some(0) => format!("L {m}{:+} FMAX\n", wanted.0),
            Some(_) => format!("L {n}{:+} FMAX\n", wanted.1),
            None => format!("L {m}{:+} {n}{:+} FMAX\n", wanted.0, wanted.1),
        };
        let more = if of_machine { "machine_parameters: {MP7475: 1}\n" } else { "" };
        let scene = place.scene(&made.solid, sizes.at, made.turn, place.basic, more);
        let (outcome, events) = place.run(&program, &scene);
        prop_assert_eq!(outcome.status, Status::Done, "{:?}\n{}\n{}", outcome.fault, program, scene);
        if !old {
            for (number, truth) in &made.results {
                prop_assert!(near(q(&outcome, *number), *truth), "Q{number} {} is not {truth}", q(&outcome, *number));
            }
        }
        let (found, height) = place.of(last_machine(&events));
        if with_top {
            let top = place.origin.2 + place.shift.2;
            prop_assert!(near(height, top + 45.0), "height {height} is not {}", top + 45.0);
        }
        // Only along an axis that the target has straight is one coordinate a statement about the workpiece alone.
        let point = place.machine(sizes.truth(made.point, made.turn), place.basic);
        let system = if target == 1 { 0.0 } else { place.basic + place.rotation };
        let off = turned(minus(found, point), -system);
        match made.axis {
            None => prop_assert!(near(off.0, 0.0) && near(off.1, 0.0), "{off:?}"),
            Some(axis) if target != 1 || (place.basic == 0.0 && place.rotation == 0.0) => {
                prop_assert!(near(if axis == 0 { off.0 } else { off.1 }, 0.0), "{off:?}");
            }
            Some(_) => {}
        }
    }
}

laws! {
    #![proptest_config(crate::cases::config(200))]

    /// Two cycles that write one row of the preset table each leave the other's coordinates: 417 the height, 412 the rest.
    #[test]
    fn cycles_share_a_row_of_the_preset_table(place in place(), sizes in sizes(), height in -3.0..3.0_f64, wanted in (-30.0..30.0, -30.0..30.0)) {
        prop_assume!(place.control != "tnc426-430");
        let made = feature(4, &place, &sizes);
        let top = sizes.truth(made.top, made.turn);
        let first = [(263, top.0), (264, top.1), (294, 0.5), (320, 0.0), (260, 30.0), (305, 12.0), (333, height), (303, 1.0)];
        let mut second = made.values.clone();
        second.extend([(305, 12.0), (303, 1.0), (331, wanted.0), (332, wanted.1)]);
        let program = place.head() + &place.cycle(417, &first) + &place.cycle(412, &second);
        let scene = place.scene(&made.solid, sizes.at, made.turn, place.basic, "");
        let (outcome, events) = place.run(&program, &scene);
        prop_assert_eq!(outcome.status, Status::Done, "{:?}", outcome.fault);
        let point = place.machine(sizes.truth((0.0, 0.0), 0.0), place.basic);
        let truth = [point.0 - wanted.0, point.1 - wanted.1, place.origin.2 + place.shift.2 - height];
        for (axis, truth) in truth.into_iter().enumerate() {
            let found = cell(&events, place.letter(axis)).expect("written");
            prop_assert!(near(found, truth), "{} {found} is not {truth}", place.letter(axis));
        }
        prop_assert_eq!(events.iter().filter(|event| matches!(event, EventKind::Table { .. })).count(), 3);
    }

    /// The basic rotation of 400, 401 and 402 is the misalignment less the known angle, in effect or in the table; an old
    /// one does not matter. Turned by the table instead, the workpiece lies straight afterwards.
    #[test]
    fn a_misalignment_is_found_and_ended(
        place in place(), at in (-40.0..40.0, -40.0..40.0), turn in -12.0..12.0_f64, known in -5.0..5.0_f64,
        kind in 0..3usize, target in 0..3usize, high in any::<bool>(), along in any::<bool>(), apart in 40.0..100.0_f64,
    ) {
        let old = place.control == "tnc426-430";
        let target = if old || (kind == 0 && target == 2) { 0 } else { target };
        let second = turned((apart, 0.0), turn);
        let near_it = |p: Flat| plus(plus(at, p), (0.3, -0.4));
        let mut values = common(high);
        values.extend([(307, known), (305, if target == 1 { 12.0 } else { 0.0 }), (402, if target == 2 { 1.0 } else { 0.0 }), (337, 0.0)]);
        let (number, solid) = match kind {
            0 if along => {
                // Measured along the main axis: a face that lies along the secondary one.
                let (one, two) = (near_it(turned((0.0, 10.0), turn)), near_it(turned((0.0, 10.0 + apart), turn)));
                values.extend([(263, one.0), (264, one.1), (265, two.0), (266, two.1), (272, 1.0), (267, 1.0), (307, known + 90.0)]);
                (400, place.block((0.0, -150.0), (150.0, 150.0), -30.0, 0.0))
            }
            0 => {
                let (one, two) = (near_it(turned((10.0, 0.0), turn)), near_it(turned((10.0 + apart, 0.0), turn)));
                values.extend([(263, one.0), (264, one.1), (265, two.0), (266, two.1), (272, 2.0), (267, 1.0)]);
                (400, place.block((-150.0, 0.0), (150.0, 150.0), -30.0, 0.0))
            }
            1 => {
                let (one, two) = (near_it((0.0, 0.0)), near_it(second));
                values.extend([(268, one.0), (269, one.1), (270, two.0), (271, two.1)]);
                (401, place.plate_without(&[place.cylinder((0.0, 0.0), 16.0, -40.0, 0.0), place.cylinder((apart, 0.0), 14.0, -40.0, 0.0)]))
            }
            _ => {
                let (one, two) = (near_it((0.0, 0.0)), near_it(second));
                values.extend([(268, one.0), (269, one.1), (270, two.0), (271, two.1), (313, 16.0), (314, 14.0), (315, -4.0)]);
                (402, place.plate_with(&[place.cylinder((0.0, 0.0), 16.0, -30.0, 0.0), place.cylinder((apart, 0.0), 14.0, -30.0, 0.0)]))
            }
        };
        let truth = line(turn - known);
        let mut program = place.head() + &place.cycle(number, &values);
        // The basic rotation ends before the first movement, so positions are those without one.
        let scene = place.scene(&solid, at, turn, 0.0, "");
        if target == 2 {
            // The table has turned the workpiece back; there, the same cycle finds it straight.
            let again = |p: Flat| {
                let machine = place.machine(plus(at, p), 0.0);
                let moved = plus(place.centre, turned(minus(machine, place.centre), -truth));
                plus(place.program(moved, 0.0), (-0.2, 0.5))
            };
            let (one, two) = (again((0.0, 0.0)), again(second));
            values.extend([(268, one.0), (269, one.1), (270, two.0), (271, two.1), (402, 0.0)]);
            let height = place.letter(2);
            program += &format!("L {height}+60 FMAX\n{}", place.cycle(number, &values));
        }
        let (outcome, events) = place.run(&program, &scene);
        prop_assert_eq!(outcome.status, Status::Done, "{:?}\n{}\n{}", outcome.fault, program, scene);
        match target {
            0 => prop_assert!(near(basic_rotation(&place, &events), truth), "{} is not {truth}", basic_rotation(&place, &events)),
            1 => {
                let found = cell(&events, &format!("SP{}", TURNS[place.tool])).expect("written");
                prop_assert!(near(found, truth) && near(basic_rotation(&place, &events), 0.0));
            }
            _ => {
                prop_assert!(near(outcome.angles.to_array()[place.tool], truth), "{:?} is not {truth}", outcome.angles);
                prop_assert!(near(basic_rotation(&place, &events), 0.0), "{}", basic_rotation(&place, &events));
            }
        }
    }

    /// 403 turns the rotary axis by what the face is off, in the plane and out of it, and zeroes what it is told to zero.
    #[test]
    fn a_rotary_axis_straightens_a_face(
        place in place(), at in (-40.0..40.0, -40.0..40.0), turn in -12.0..12.0_f64, wanted in -10.0..10.0_f64,
        along in any::<bool>(), zero in 0..3usize, start in -90.0..90.0_f64,
    ) {
        let old = place.control == "tnc426-430";
        let axis = TURNS[place.tool];
        // Q380 is for the C axis only.
        let wanted = if old || axis != "C" { 0.0 } else { wanted };
        let zero = if old { 0 } else { zero };
        let near_it = |p: Flat| plus(plus(at, turned(p, turn)), (0.3, -0.4));
        let mut values = common(false);
        let base = if along { 90.0 } else { 0.0 };
        let (one, two) = if along { ((0.0, 10.0), (0.0, 70.0)) } else { ((10.0, 0.0), (70.0, 0.0)) };
        let (one, two) = (near_it(one), near_it(two));
        values.extend([(263, one.0), (264, one.1), (265, two.0), (266, two.1), (272, if along { 1.0 } else { 2.0 }), (267, 1.0)]);
        values.extend([(312, place.tool as f64 + 4.0), (337, f64::from(u8::from(zero > 0))), (305, 12.0), (303, if zero == 1 { 1.0 } else { 0.0 }), (380, base + wanted)]);
        values.push((320, 3.0));
        let solid = if along { place.block((0.0, -150.0), (150.0, 150.0), -30.0, 0.0) } else { place.block((-150.0, 0.0), (150.0, 150.0), -30.0, 0.0) };
        let scene = place.scene(&solid, at, turn, place.basic, "");
        let at_start = scene.find("start: {").expect("a start") + "start: {".len();
        let scene = format!("{}{axis}: {start}, {}", &scene[..at_start], &scene[at_start..]);
        let (outcome, events) = place.run(&(place.head() + &place.cycle(403, &values)), &scene);
        prop_assert_eq!(outcome.status, Status::Done, "{:?}\n{}", outcome.fault, scene);
        let truth = line(turn - wanted);
        if !old {
            prop_assert!(near(q(&outcome, 150), truth));
        }
        let shown = outcome.angles.to_array()[place.tool];
        prop_assert!(near(shown, if zero > 0 { 0.0 } else { start + truth }), "{shown}");
        if zero > 0 {
            prop_assert!(near(cell(&events, axis).expect("written"), start + truth));
        }
    }

    /// A tilted top is levelled about the main or the secondary axis.
    #[test]
    fn a_rotary_axis_levels_a_top(
        place in place(), tilt in -8.0..8.0_f64, about_main in any::<bool>(), other in -30.0..30.0_f64,
    ) {
        let place = Place { basic: 0.0, rotation: 0.0, ..place };
        let place = Place { centre: place.machine((0.0, 0.0), 0.0), ..place };
        let axis = TURNS[(place.tool + if about_main { 1 } else { 2 }) % 3];
        let number = TURNS.iter().position(|known| *known == axis).expect("an axis");
        let solid = place.block((-60.0, -60.0), (60.0, 60.0), -30.0, 0.0);
        let scene = place.scene(&solid, (0.0, 0.0), 0.0, 0.0, "");
        let turns = TURNS[place.tool];
        let scene = scene
            .replace(&format!("rotate: {{{turns}: 0}}"), &format!("rotate: {{{axis}: {tilt}}}"))
            .replace(&format!("rotary: [{{axis: {turns}"), &format!("rotary: [{{axis: {axis}"));
        // The line may run aslant over the top: what counts is its direction across the rotary axis.
        let (one, two) = if about_main { ((0.0, -30.0), (other, 30.0)) } else { ((-30.0, 0.0), (30.0, other)) };
        let mut values = common(true);
        values.extend([(263, one.0), (264, one.1), (265, two.0), (266, two.1), (272, 3.0), (267, -1.0), (261, 6.0), (312, number as f64 + 4.0), (380, 7.0)]);
        values[2] = (260, 60.0);
        let (outcome, _) = place.run(&(place.head() + &place.cycle(403, &values)), &scene);
        // The angle of Q380 acts for a C axis, whatever it turns about.
        let wanted = if axis == "C" && place.control != "tnc426-430" { 7.0 } else { 0.0 };
        prop_assert_eq!(outcome.status, Status::Done, "{:?}\n{}", outcome.fault, scene);
        let found = outcome.angles.to_array()[number];
        prop_assert!(near(found, tilt - wanted), "{found} is not {}", tilt - wanted);
    }

    /// 405 brings the hole to where it should be, seen from the table's axis, and keeps the display by the datum row.
    #[test]
    fn a_hole_is_turned_to_its_place(
        place in place(), radius in 40.0..90.0_f64, nominal in 20.0..160.0_f64, off in -3.0..3.0_f64,
        diameter in 24.0..40.0_f64, onto_axis in any::<bool>(), into_row in any::<bool>(), before in -40.0..40.0_f64,
    ) {
        // The table turns about the datum; the cycle turns C.
        let place = Place { tool: 2, basic: 0.0, rotation: 0.0, ..place };
        let place = Place { centre: place.machine((0.0, 0.0), 0.0), ..place };
        let nominal = if onto_axis { 0.0 } else { nominal };
        let hole = turned((radius, 0.0), nominal + off);
        let expected = turned((radius, 0.0), nominal);
        let mut values = common(false);
        let minor = if onto_axis { 0.0 } else { expected.1 };
        values.extend([(321, expected.0), (322, minor), (262, diameter - 14.0), (325, 10.0), (247, 80.0), (337, if into_row { 12.0 } else { 0.0 })]);
        values[1] = (320, 0.0);
        let scene = place.scene(&place.plate_without(&[place.cylinder(hole, diameter, -40.0, 0.0)]), (0.0, 0.0), 0.0, 0.0, "");
        let scene = scene.replace("datums: [{D: 12}]", &format!("datums: [{{D: 12, C: {before}}}]"));
        let (outcome, events) = place.run(&(place.head() + &place.cycle(405, &values)), &scene);
        prop_assert_eq!(outcome.status, Status::Done, "{:?}\n{}", outcome.fault, scene);
        let goal = if onto_axis { 90.0 } else { nominal };
        let truth = nominal + off - goal;
        prop_assert!(near(q(&outcome, 150), truth), "{} is not {truth}", q(&outcome, 150));
        let shown = outcome.angles.z;
        prop_assert!(near(shown, if into_row { truth } else { 0.0 }), "{shown}");
        if into_row {
            prop_assert!(near(cell(&events, "C").expect("written"), before + truth));
        }
    }

    /// Where points nearly coincide or lines are nearly parallel, there is a finite result or an explained error.
    #[test]
    fn bad_geometry_is_finite_or_explained(place in place(), apart in -9.0..1.0_f64, squeeze in -12.0..0.5_f64, kind in 0..2usize) {
        let place = Place { basic: 0.0, ..place };
        let (apart, squeeze) = (10f64.powf(apart), 10f64.powf(squeeze));
        let mut values = common(true);
        let (number, solid) = if kind == 0 {
            values.extend([(263, 0.0), (264, 0.0), (265, apart), (266, 0.0), (272, 2.0), (267, 1.0)]);
            (400, place.block((-150.0, 0.0), (150.0, 150.0), -30.0, 0.0))
        } else {
            // Four holes nearly on one line.
            let own = [(-60.0, 0.0), (-20.0, squeeze), (20.0, 0.0), (60.0, 0.0)];
            for (index, hole) in own.iter().enumerate() {
                let first = [268u16, 270, 316, 318][index];
                values.extend([(first, hole.0), (first + 1, hole.1)]);
            }
            let holes: Vec<String> = own.iter().map(|hole| place.cylinder(*hole, 16.0, -40.0, 0.0)).collect();
            (418, place.plate_without(&holes))
        };
        let scene = place.scene(&solid, (0.0, 0.0), 0.0, 0.0, "");
        let (outcome, events) = place.run(&(place.head() + &place.cycle(number, &values)), &scene);
        match outcome.fault {
            None => {
                let told = events.iter().rev().find_map(|event| match event {
                    EventKind::Transform(system) => Some(*system),
                    _ => None,
                });
                prop_assert!(told.is_none_or(|system| system.origin.is_finite() && system.basic_rotation.is_finite()));
                prop_assert!(outcome.position.is_finite());
            }
            Some(fault) => prop_assert!(
                ["direction-undefined", "lines-parallel", "axis-limit"].contains(&&*fault.code), "{:?}", fault
            ),
        }
    }
}

/// The programs of the examples do what they are written for: the called program moves to the datum that was found.
#[test]
fn the_worked_programs_find_their_workpieces() {
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("examples");
    let read = |name: &str| std::fs::read_to_string(folder.join(name)).expect("an example");
    let Built { files, catalogue, .. } = built();
    let on = catalogue.on("tnc640").expect("a control");
    for (name, called, point, table) in [
        ("cyc401", "35K47", glam::dvec3(0.0, 0.0, 50.0), 21.0),
        ("cyc413", "35K47", glam::dvec3(25.2, 14.9, 50.3), 0.0),
        ("cyc416", "35KLZ", glam::dvec3(35.2, 34.9, 75.15), 0.0),
    ] {
        let scene =
            Scene::parse(&Source::new("scene.yaml", read(&format!("{name}.scene.yaml"))), files).expect("a scene");
        let main = syntax::parse(&Source::new("MAIN.H", read(&format!("{name}.h"))));
        let other = syntax::parse(&Source::new("OTHER.H", read(&format!("{called}.h"))));
        let mut events = Vec::new();
        let engine = Engine::new(&main, on, &scene, &NoTexts).with_program(called, &other);
        let outcome = engine.run(&mut |event| events.push(event.kind));
        assert_eq!(outcome.status, Status::Done, "{name}: {:?}", outcome.fault);
        assert!((last_machine(&events) - point).length() < 1e-6, "{name}: {}", last_machine(&events));
        let turned = events.iter().find_map(|event| match event {
            EventKind::Turn { axes, .. } => axes.first().map(|axis| axis.machine),
            _ => None,
        });
        assert!(near(turned.unwrap_or(0.0), table), "{name}: {turned:?}");
    }
}
