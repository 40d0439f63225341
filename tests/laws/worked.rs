//! The milling programs that the manuals print, as `examples/` has them: each runs to its end on its blank and leaves the
//! part that it intends, without a finding; what no manual's program needs yet is refused with its name.
//!
//! The parts are calculated here, column by column, from the drawings' dimensions.
#![expect(clippy::disallowed_methods, reason = "truths are calculated with plain trigonometry")]
use std::fs;
use std::path::Path;

use ciklo::base::diag::Source;
use ciklo::engine::run::{Engine, NoTexts, Outcome, Status};
use ciklo::engine::scene::Scene;
use ciklo::engine::stock::{Machining, Report, Stock};
use ciklo::program::syntax;
use ciklo::spec::Catalogue;
use glam::{DVec2, DVec3};

/// Columns so near to an edge are not judged, mm.
const EDGE: f64 = 0.02;
/// What a height may be wrong, mm.
const NEAR: f64 = 1e-6;

struct Data {
    files: ciklo::base::data::Files,
    catalogue: &'static Catalogue,
}

impl Data {
    fn new() -> Self {
        let files = ciklo::base::data::embedded();
        let catalogue = &crate::built::built().catalogue;
        Self { files, catalogue }
    }

    fn run(&self, text: &str, scene: &str) -> (Outcome, Option<(Stock, Report)>) {
        self.run_with(text, scene, &[])
    }

    /// Runs a program that others belong to, each with its name.
    fn run_with(&self, text: &str, scene: &str, others: &[(&str, &str)]) -> (Outcome, Option<(Stock, Report)>) {
        let on = self.catalogue.on("tnc640").expect("a control");
        let scene = Scene::parse(&Source::new("scene.yaml", scene), &self.files).expect("a scene");
        let program = syntax::parse(&Source::new("WORKED.H", text));
        let mut machining = Machining::new(&program, &scene, Some(0.7)).ok();
        let others: Vec<_> =
            others.iter().map(|(name, text)| (*name, syntax::parse(&Source::new("OTHER.H", *text)))).collect();
        let engine = Engine::new(&program, on, &scene, &NoTexts).with_catalogue(self.catalogue);
        let engine = others.iter().fold(engine, |engine, (name, program)| engine.with_program(name, program));
        let outcome = engine.run(&mut |event| {
            if let Some(machining) = &mut machining {
                machining.see(&event);
            }
        });
        (outcome, machining.map(Machining::finish))
    }
}

/// The stretches of material of a column; nothing where it stands too near to an edge.
type Column = Option<Vec<[f64; 2]>>;

/// A program, where its tool stands at the end, and the part.
struct Worked {
    name: &'static str,
    end: DVec3,
    part: fn(DVec2) -> Column,
}

const fn at(x: f64, y: f64) -> DVec2 {
    DVec2::new(x, y)
}

/// Through holes of a radius in a plate between two heights.
fn holes(place: DVec2, centres: &[DVec2], radius: f64, plate: [f64; 2]) -> Column {
    let far = centres.iter().map(|centre| centre.distance(place)).fold(f64::INFINITY, f64::min);
    if (far - radius).abs() < EDGE {
        return None;
    }
    Some(if far < radius { Vec::new() } else { vec![plate] })
}

/// The corners of four holes, drilled through from a surface that lies 10 mm lower.
fn c200(place: DVec2) -> Column {
    holes(place, &[at(10.0, 10.0), at(10.0, 90.0), at(90.0, 90.0), at(90.0, 10.0)], 3.0, [-20.0, -10.0])
}

const EIGHT: [DVec2; 8] = [
    at(10.0, 10.0),
    at(40.0, 30.0),
    at(20.0, 55.0),
    at(10.0, 90.0),
    at(90.0, 90.0),
    at(80.0, 65.0),
    at(80.0, 30.0),
    at(90.0, 10.0),
];

/// The tap is wider than the drill and than what the centre drill leaves.
fn pattern(place: DVec2) -> Column {
    holes(place, &EIGHT, 3.0, [-20.0, 0.0])
}

/// A stud of 90 by 80, a pocket of diameter 50 in it, two slots of 8 on a circle of diameter 70.
fn c210(place: DVec2) -> Column {
    let arm = place - at(50.0, 50.0);
    let outside = (arm.x.abs() - 45.0).max(arm.y.abs() - 40.0);
    let pocket = arm.length() - 25.0;
    // The slots reach from 45 to 135 degrees and from 225 to 315: seen from above, the upper half is mirrored.
    let upper = at(arm.x, arm.y.abs());
    let angle = upper.y.atan2(upper.x).to_degrees();
    let middle = if (45.0..=135.0).contains(&angle) {
        (upper.length() - 35.0).abs()
    } else {
        let ends = [45.0_f64, 135.0].map(|end| at(end.to_radians().cos(), end.to_radians().sin()) * 35.0);
        ends.iter().map(|end| end.distance(upper)).fold(f64::INFINITY, f64::min)
    };
    let slot = middle - 4.0;
    if [outside, pocket, slot].iter().any(|distance| distance.abs() < EDGE) {
        return None;
    }
    Some(vec![[
        -40.0,
        if outside > 0.0 || pocket < 0.0 {
            -30.0
        } else if slot < 0.0 {
            -20.0
        } else {
            0.0
        },
    ]])
}

/// Ten holes on a circle of diameter 50, five on an arc of diameter 70: a point of 118 degrees ends at 15 mm.
fn circles(place: DVec2) -> Column {
    let on = |centre: DVec2, radius: f64, angle: f64| {
        centre + at(angle.to_radians().cos(), angle.to_radians().sin()) * radius
    };
    let mut centres: Vec<DVec2> = (0..10).map(|n| on(at(30.0, 70.0), 25.0, 36.0 * f64::from(n))).collect();
    centres.extend((0..5).map(|n| on(at(90.0, 25.0), 35.0, 90.0 + 30.0 * f64::from(n))));
    let far = centres.iter().map(|centre| centre.distance(place)).fold(f64::INFINITY, f64::min);
    if (far - 4.0).abs() < EDGE {
        return None;
    }
    let slope = 1.0 / 59.0_f64.to_radians().tan();
    Some(vec![[-40.0, if far < 4.0 { -15.0 + far * slope } else { 0.0 }]])
}

/// Everything above 35 is gone.
fn c230(_: DVec2) -> Column {
    Some(vec![[0.0, 35.0]])
}

/// Eight pentagons, from 30 to 60 mm away from the middle; the mill of radius 2 went once around each, on its way from
/// the middle and back.
fn coordinates(place: DVec2) -> Column {
    let mut cut = false;
    for turn in 0..8 {
        let (s, c) = (f64::from(turn) * 45.0).to_radians().sin_cos();
        let arm = place - at(65.0, 65.0);
        let own = at(arm.x * c + arm.y * s, arm.y * c - arm.x * s);
        // Outside of the pentagon, a band of the tool's diameter; from the middle to the side at X+30, a groove.
        let beside = pentagon(own);
        let groove = at(own.x - own.x.clamp(0.0, 28.0), own.y).length() - 2.0;
        if beside.abs() < EDGE || (beside - 4.0).abs() < EDGE || groove.abs() < EDGE {
            return None;
        }
        cut |= (beside > 0.0 && beside < 4.0) || groove < 0.0;
    }
    Some(vec![[-20.0, if cut { -5.0 } else { 0.0 }]])
}

/// The distance of a point from the pentagon of the contour, negative inside: corners at (30, ±10), (50, ±10) and
/// (60, 0); the one at (30, 10) and the tip have a radius of 5.
fn pentagon(point: DVec2) -> f64 {
    let bend = 5.0 / 2.0_f64.sqrt();
    let (tip, round) = (at(60.0 - 2.0 * bend, 0.0), at(35.0, 5.0));
    let sides = [
        (at(30.0, -10.0), at(30.0, 5.0)),
        (at(35.0, 10.0), at(50.0, 10.0)),
        (at(50.0, 10.0), at(60.0 - bend, bend)),
        (at(60.0 - bend, -bend), at(50.0, -10.0)),
        (at(50.0, -10.0), at(30.0, -10.0)),
    ];
    let far = |(a, b): &(DVec2, DVec2)| {
        let way = *b - *a;
        point.distance(*a + way * ((point - *a).dot(way) / way.length_squared()).clamp(0.0, 1.0))
    };
    let mut distance = sides.iter().map(far).fold(f64::INFINITY, f64::min);
    let from_tip = point - tip;
    if from_tip.x > from_tip.y.abs() {
        distance = distance.min((from_tip.length() - 5.0).abs());
    }
    let from_round = point - round;
    if from_round.x < 0.0 && from_round.y > 0.0 {
        distance = distance.min((from_round.length() - 5.0).abs());
    }
    let slant = 60.0 - point.y.abs();
    let inside = point.x > 30.0
        && point.y.abs() < 10.0
        && point.x < slant
        && !(from_tip.x > from_tip.y.abs() && from_tip.length() > 5.0)
        && !(from_round.x < 0.0 && from_round.y > 0.0 && from_round.length() > 5.0);
    if inside { -distance } else { distance }
}

/// Two round pockets that overlap, 20 deep, with a square and a triangular island.
fn c21(place: DVec2) -> Column {
    let pocket = (place.distance(at(35.0, 50.0)) - 25.0).min(place.distance(at(65.0, 50.0)) - 25.0);
    let square = (place.x - 35.0).abs().max((place.y - 50.0).abs()) - 8.0;
    // The triangle has its base at Y+42, 16 wide, and is 16 high.
    let (arm, slope) = (at((place.x - 65.0).abs(), place.y - 42.0), at(16.0, 8.0) / 320.0_f64.sqrt());
    let triangle = (-arm.y).max((arm - at(8.0, 0.0)).dot(slope));
    if [pocket, square, triangle].iter().any(|distance| distance.abs() < EDGE) {
        return None;
    }
    let island = square < 0.0 || triangle < 0.0;
    Some(vec![[-40.0, if pocket < 0.0 && !island { -20.0 } else { 0.0 }]])
}

/// What a tool of radius 10 sweeps 20 deep whose centre is 10 mm on the left of the contour.
fn c25(place: DVec2) -> Column {
    // The contour: a line at 45 degrees, an arc that goes on tangentially about (-22.5, 47.5), a line upwards from the
    // corner (5, 75), two lines with roundings of 7.5 between them.
    let half = 10.0 / 2.0_f64.sqrt();
    let slant = 50.0_f64.hypot(15.0);
    let beside = at(15.0, 50.0) / slant * 10.0;
    let bend = 7.5 * (15.0_f64.atan2(50.0) / 2.0).tan();
    let lines = [
        (at(-half, 15.0 + half), at(5.0 - half, 20.0 + half)),
        (at(-5.0, 75.0), at(-5.0, 87.5)),
        (at(12.5, 105.0), at(50.0 - bend, 105.0)),
        (at(50.0, 95.0) + at(50.0, -15.0) / slant * bend + beside, at(100.0, 80.0) + beside),
    ];
    let arcs = [
        (at(-22.5, 47.5), 27.5 * 2.0_f64.sqrt() - 10.0, [-45.0, 45.0]),
        (at(5.0, 75.0), 10.0, [180.0, 225.0]),
        (at(12.5, 87.5), 17.5, [90.0, 180.0]),
        (at(50.0 - bend, 87.5), 17.5, [90.0 - 15.0_f64.atan2(50.0).to_degrees(), 90.0]),
    ];
    let mut far = f64::INFINITY;
    for (a, b) in lines {
        let along = ((place - a).dot(b - a) / (b - a).length_squared()).clamp(0.0, 1.0);
        far = far.min(place.distance(a.lerp(b, along)));
    }
    for (centre, radius, [first, last]) in arcs {
        let arm = place - centre;
        let angle = arm.y.atan2(arm.x).to_degrees();
        let angle = if angle < first - 90.0 { angle + 360.0 } else { angle };
        if (first..=last).contains(&angle) {
            far = far.min((arm.length() - radius).abs());
        }
    }
    if (far - 10.0).abs() < EDGE {
        return None;
    }
    Some(vec![[-40.0, if far < 10.0 { -20.0 } else { 0.0 }]])
}

/// Two circles, radius 30 about (30, 30) and radius 20, 55 mm away from it at 60 degrees, and a channel of 20 between their
/// centres: all corners of the pocket are outside corners of the material, so that a tool of radius 7.5 reaches them.
fn c20(place: DVec2) -> Column {
    let (centre, way) = (at(30.0, 30.0), at(0.5, 0.75_f64.sqrt()));
    let arm = place - centre;
    let (along, across) = (arm.dot(way), arm.perp_dot(way).abs());
    let channel = (across - 10.0).max(-along).max(along - 55.0);
    let pocket = (arm.length() - 30.0).min(arm.distance(way * 55.0) - 20.0).min(channel);
    if pocket.abs() < EDGE {
        return None;
    }
    Some(vec![[-40.0, if pocket < 0.0 { -20.0 } else { 0.0 }]])
}

const WORKED: &[Worked] = &[
    Worked { name: "c200", end: DVec3::new(90.0, 10.0, 250.0), part: c200 },
    Worked { name: "pattern", end: DVec3::new(90.0, 10.0, 100.0), part: pattern },
    Worked { name: "table", end: DVec3::new(20.0, 55.0, 100.0), part: pattern },
    Worked { name: "c210", end: DVec3::new(50.0, 50.0, 250.0), part: c210 },
    // The last hole: 35 mm from (90, 25) at 210 degrees.
    Worked { name: "circles", end: DVec3::new(59.689_110_867_544_6, 7.5, 250.0), part: circles },
    // Where roughing ends the manual leaves open.
    Worked { name: "c20", end: DVec3::new(f64::NAN, f64::NAN, 250.0), part: c20 },
    // The 25th line leads away from X+0 again; line and steps end a radius beside the surface and at its border.
    // Where the last wall is left the manual leaves open.
    Worked { name: "c21", end: DVec3::new(f64::NAN, f64::NAN, 250.0), part: c21 },
    // The tool is beside the end of the contour: (15, 50) / 52.2 mm is upright to its last line.
    Worked { name: "c25", end: DVec3::new(102.873_478_855_663_45, 89.578_262_852_211_51, 250.0), part: c25 },
    Worked { name: "c230", end: DVec3::new(110.0, 90.0, 250.0), part: c230 },
    Worked { name: "coordinates", end: DVec3::new(65.0, 65.0, 250.0), part: coordinates },
];

#[test]
fn worked_programs_leave_their_parts() {
    let data = Data::new();
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples");
    for worked in WORKED {
        let read = |end: &str| fs::read_to_string(folder.join(format!("{}{end}", worked.name))).expect("an example");
        let (outcome, part) = data.run(&read(".h"), &read(".scene.yaml"));
        assert_eq!(outcome.status, Status::Done, "{}: {:?}", worked.name, outcome.fault);
        let ends = outcome.position.to_array().into_iter().zip(worked.end.to_array());
        let ends_well =
            ends.filter(|(_, wanted)| wanted.is_finite()).all(|(found, wanted)| (found - wanted).abs() < NEAR);
        assert!(ends_well, "{} ends at {}", worked.name, outcome.position);
        let (stock, report) = part.expect("a blank");
        assert!(report.findings.is_empty(), "{}: {:?}", worked.name, report.findings);
        let (mut judged, mut all) = (0, 0);
        let (columns, rows) = stock.size();
        for (row, column) in (0..rows).flat_map(|row| (0..columns).map(move |column| (row, column))) {
            let place = stock.place(column, row);
            all += 1;
            let Some(wanted) = (worked.part)(place) else { continue };
            judged += 1;
            let found = stock.column(column, row);
            let same = found.len() == wanted.len()
                && found.iter().zip(&wanted).all(|(a, b)| (a[0] - b[0]).abs() < NEAR && (a[1] - b[1]).abs() < NEAR);
            assert!(same, "{} at {place}: {found:?} is not {wanted:?}", worked.name);
        }
        assert!(judged * 10 >= all * 9, "{}: only {judged} of {all} columns were judged", worked.name);
    }
}

/// The two pockets with two islands of `examples/c21.h`, roughed out and finished, with the contour from elsewhere.
fn c21_with(contour: &str, labels: &str) -> String {
    format!(
        "BEGIN PGM FORMULA MM\nBLK FORM 0.1 Z X+0 Y+0 Z-40\nBLK FORM 0.2 X+100 Y+100 Z+0\nTOOL CALL 2 Z S3000\n\
         L Z+250 R0 FMAX\n{contour}\n\
         CYCL DEF 20 CONTOUR DATA Q1=-20 Q2=1 Q3=+0.5 Q4=+0.5 Q5=+0 Q6=2 Q7=+100 Q8=0.1 Q9=-1\n\
         CYCL DEF 22 ROUGH-OUT Q10=5 Q11=100 Q12=350 Q18=0 Q19=150 Q208=30000\nCYCL CALL M3\n\
         CYCL DEF 23 FLOOR FINISHING Q11=100 Q12=200 Q208=30000\nCYCL CALL\n\
         CYCL DEF 24 SIDE FINISHING Q9=+1 Q10=5 Q11=100 Q12=400 Q14=+0\nCYCL CALL\n\
         L Z+250 R0 FMAX M2\n{labels}END PGM FORMULA MM\n"
    )
}

/// Programs that describe the contours of `c21`: circles by their parameters, a square and a triangle.
const SHAPES: &[(&str, &str)] = &[
    ("CIRCLE", "BEGIN PGM CIRCLE MM\nCC X+Q1 Y+Q2\nLP PR+Q3 PA+0 R0\nCP IPA+360 DR+\nEND PGM CIRCLE MM\n"),
    ("RIGHT", "BEGIN PGM RIGHT MM\nCC X+65 Y+50\nL X+90 Y+50\nC X+90 DR-\nEND PGM RIGHT MM\n"),
    ("SQUARE", "BEGIN PGM SQUARE MM\nL X+27 Y+58 R0\nL X+43\nL Y+42\nL X+27\nL Y+58\nEND PGM SQUARE MM\n"),
    ("TRIANGLE", "BEGIN PGM TRIANGLE MM\nL X+73 Y+42 R0\nL X+65 Y+58\nL X+57 Y+42\nL X+73\nEND PGM TRIANGLE MM\n"),
    (
        "MODEL",
        "BEGIN PGM MODEL MM\nFN 0: Q1 = +35\nFN 0: Q2 = +50\nFN 0: Q3 = +25\nDECLARE CONTOUR QC2 = \"CIRCLE\"\n\
         FN 0: Q1 = +65\nDECLARE CONTOUR QC1 = \"CIRCLE\"\nDECLARE CONTOUR QC3 = \"TRIANGLE\"\n\
         DECLARE CONTOUR QC4 = \"SQUARE\" DEPTH0\nQC10 = ( QC1 | QC2 ) \\ QC3 \\ QC4\nEND PGM MODEL MM\n",
    ),
];

/// A contour may come from a formula in another program, one in the same program, or a simple list; the part is the same.
#[test]
fn contours_of_formulas_leave_the_part_that_labels_leave() {
    let data = Data::new();
    let scene = fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/c21.scene.yaml")).expect("it");
    let circle = "LBL 5\nCC X+35 Y+50\nL X+60 Y+50\nC X+60 DR+\nLBL 0\n";
    let cases = [
        ("SEL CONTOUR \"MODEL\"", ""),
        (
            "DECLARE CONTOUR QC1 = \"RIGHT\"\nQ1=35\nQ2=50\nQ3=25\nDECLARE CONTOUR QC2 = \"CIRCLE\"\n\
             DECLARE CONTOUR QC3 = \"TRIANGLE\"\nDECLARE CONTOUR QC4 = \"SQUARE\"\n\
             QC5 = ( QC1 ^ QC2 ) | ( QC1 & QC2 )\nQC10 = QC5 \\ ( QC3 | QC4 )",
            "",
        ),
        ("CONTOUR DEF P1 = \"RIGHT\" P2 = LBL 5 I3 = \"TRIANGLE\" I4 = \"SQUARE\" DEPTH0", circle),
    ];
    for (contour, labels) in cases {
        let (outcome, part) = data.run_with(&c21_with(contour, labels), &scene, SHAPES);
        assert_eq!(outcome.status, Status::Done, "{contour}: {:?}", outcome.fault);
        let (stock, _) = part.expect("a blank");
        let (columns, rows) = stock.size();
        for (row, column) in (0..rows).flat_map(|row| (0..columns).map(move |column| (row, column))) {
            let place = stock.place(column, row);
            let Some(wanted) = c21(place) else { continue };
            let found = stock.column(column, row);
            let same = found.len() == 1 && (found[0][1] - wanted[0][1]).abs() < NEAR;
            assert!(same, "{contour}: at {place}: {found:?} is not {wanted:?}");
        }
    }
    // What comes to no area, or is not there, is said.
    let fault = |contour: &str| {
        let (outcome, _) = data.run_with(&c21_with(contour, ""), &scene, SHAPES);
        outcome.fault.map(|fault| fault.code.into_owned()).unwrap_or_default()
    };
    assert_eq!(fault("SEL CONTOUR \"NOWHERE\""), "program-missing");
    assert_eq!(fault("SEL CONTOUR \"SQUARE\""), "contour-not-defined");
    assert_eq!(fault("QC10 = QC7"), "contour-undeclared");
    assert_eq!(fault("DECLARE CONTOUR QC1 = \"SQUARE\"\nQC2 = QC1 \\ QC1"), "contour-not-defined");
}

/// A machine with a head B and a table C, as the programs on cylinders want it, and the cylinder: 80 high on the table.
const HEAD_AND_TABLE: &str = "scene: 1\nmachine: {spindle: Z, pivot: 150, \
    axes: [{axis: X, min: -1000, max: 1000, rapid: 20000}, {axis: Y, min: -1000, max: 1000, rapid: 20000}, {axis: Z, min: -1000, max: 1000, rapid: 15000}], \
    rotary: [{axis: C, carries: workpiece, rapid: 7200}, {axis: B, carries: tool, min: -120, max: 120, rapid: 3600}]}\n\
    tools: [{T: 1, L: 80, R: 3.5}]\nstart: [0, 0, 300]\nstock: {cylinder: {axis: Z, centre: [0, 0], diameter: 50, from: FROM, to: TO}}\n";

/// A program as the manual prints it.
fn printed(name: &str) -> String {
    let head = format!("BEGIN PGM {name} MM");
    let text = include_str!("../manuals/001.txt");
    let blocks = text.lines().filter_map(|line| line.split_once('\t')).map(|(_, block)| block.trim_end());
    let mut program = String::new();
    for block in blocks.skip_while(|block| !block.ends_with(&head)) {
        program += &format!("{block}\n");
        if block.contains("END PGM") {
            break;
        }
    }
    program
}

/// Both programs on cylinders run to their end, without a rapid move through material, and leave the cylinder where the
/// contours are not: a slot of 10, 7 deep, and a contour along whose inner side a tool of 7 goes.
#[test]
fn programs_on_cylinders_run_to_their_end() {
    let data = Data::new();
    for (name, misprint, from, to) in [("C27", ("", ""), 0, 80), ("C28", ("X+60 X+0", "X+60 Y+0"), -80, 0)] {
        let program = printed(name).replace(misprint.0, misprint.1);
        let scene = HEAD_AND_TABLE.replace("FROM", &from.to_string()).replace("TO", &to.to_string());
        let (outcome, machined) = data.run(&program, &scene);
        assert_eq!((outcome.status, outcome.fault), (Status::Done, None), "{name}");
        let (_, report) = machined.expect("a stock");
        assert!(report.findings.is_empty(), "{name}: {:?}", report.findings);
        // Round the cylinder, the way times the width times the mean of the circumferences at floor and surface.
        let wanted = match name {
            // 3.5 beside the contour: a rectangle of 13 by 33 with corners of 4, and from the beginning to the end twice.
            "C27" => (2.0 * (13.0 + 33.0) - 8.0 * 4.0 + 8.0 * std::f64::consts::PI) * 7.0,
            // 35 along, an oblique piece of 20 by 17.5, 17.5 along, and half a tool at both ends.
            _ => (35.0 + 17.5 + 17.5_f64.hypot(20.0) + 7.0) * 10.0,
        } * 7.0;
        let share = report.removed / wanted;
        assert!((0.8..1.1).contains(&share), "{name}: {} of {wanted}", report.removed);
    }
    // The first block of the printed contour names X twice.
    let (outcome, _) = data.run(&printed("C28"), &HEAD_AND_TABLE.replace("FROM", "-80").replace("TO", "0"));
    assert_eq!(outcome.fault.map(|fault| fault.code.into_owned()).as_deref(), Some("contour-begin-incomplete"));
}
