//! Laws of coordinate transformations over random programs: in whatever order datum shift, mirroring, rotation, scaling
//! and tilting are defined, redefined and reset, in coordinates, increments and rows of tables, by cycles and by other
//! blocks, with any preset and tool axis, a position of the program lies where the product of their matrices says, and
//! cycles leave what they are asked for in the scaled and mirrored system.
//!
//! The matrices are multiplied here, with plain trigonometry and nothing of the engine.
#![expect(clippy::disallowed_methods, reason = "truths are calculated with plain trigonometry")]

use ciklo::base::diag::Source;
use ciklo::engine::run::{Engine, EventKind, MoveKind, NoTexts, Outcome, Status};
use ciklo::engine::scene::Scene;
use ciklo::program::syntax;
use proptest::prelude::*;

use crate::built;
use built::built;

fn run(program: &str, scene: &str) -> (Outcome, Vec<EventKind>) {
    let world = built();
    let on = world.catalogue.on("tnc640").expect("a control");
    let scene = Scene::parse(&Source::new("scene.yaml", scene), &world.files);
    let scene = scene.unwrap_or_else(|found| panic!("{found:?}"));
    let tree = syntax::parse(&Source::new("LAW.H", program));
    let mut events = Vec::new();
    let engine = Engine::new(&tree, on, &scene, &NoTexts).with_catalogue(&world.catalogue);
    let outcome = engine.run(&mut |event| events.push(event.kind));
    (outcome, events)
}

/// Three rows of four numbers.
type Matrix = [[f64; 4]; 3];

const UNIT: Matrix = [[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0]];

fn times(a: &Matrix, b: &Matrix) -> Matrix {
    let mut product = [[0.0; 4]; 3];
    for row in 0..3 {
        for column in 0..4 {
            let own = if column == 3 { a[row][3] } else { 0.0 };
            product[row][column] = own + (0..3).map(|k| a[row][k] * b[k][column]).sum::<f64>();
        }
    }
    product
}

fn diagonal(factors: [f64; 3], about: [f64; 3]) -> Matrix {
    let mut matrix = UNIT;
    for k in 0..3 {
        matrix[k][k] = factors[k];
        matrix[k][3] = about[k] - factors[k] * about[k];
    }
    matrix
}

fn turn(axis: usize, degrees: f64) -> Matrix {
    let (s, c) = degrees.to_radians().sin_cos();
    let (a, b) = ((axis + 1) % 3, (axis + 2) % 3);
    let mut matrix = UNIT;
    (matrix[a][a], matrix[a][b], matrix[b][a], matrix[b][b]) = (c, -s, s, c);
    matrix
}

fn at(matrix: &Matrix, point: [f64; 3]) -> [f64; 3] {
    std::array::from_fn(|row| matrix[row][3] + (0..3).map(|k| matrix[row][k] * point[k]).sum::<f64>())
}

/// What is in effect on top of the preset, with its numbers: redefined it keeps its place.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Change {
    Shift([f64; 3]),
    Mirror([bool; 3]),
    Rotate(f64),
    Scale(f64),
    ScaleAxes([f64; 3], [f64; 3]),
    Tilt([f64; 3]),
}

/// A block of a program that changes the system, and what it asks for.
#[derive(Clone, Copy, Debug)]
enum Op {
    /// Coordinates by axis, each with whether it counts from the shift in effect; as cycle or as `TRANS DATUM`.
    Shift([Option<(f64, bool)>; 3], bool),
    /// A row of the datum table, as cycle or as `TRANS DATUM`.
    Row(usize, bool),
    NoShift,
    Mirror([bool; 3]),
    Rotate(f64, bool),
    Scale(f64),
    ScaleAxes(f64, f64, f64, f64),
    /// Spatial angles, by cycle or by `PLANE`.
    Tilt([i32; 3], bool),
    PlaneReset,
    Preset(usize),
}

const ROWS: [[f64; 3]; 3] = [[0.0, 0.0, 0.0], [12.5, -7.25, 3.0], [-40.0, 18.125, 0.0]];
/// Shift and angle about Z of the presets.
const PRESETS: [([f64; 3], f64); 3] = [([0.0; 3], 0.0), ([20.0, -35.5, 10.0], 30.0), ([-15.0, 4.0, -22.0], -117.0)];

const AXES: [&str; 3] = ["X", "Y", "Z"];

/// The system as the manual says that it is.
#[derive(Clone, Debug, Default)]
struct Model {
    preset: usize,
    changes: Vec<Change>,
    /// The tool axis.
    tool: usize,
}

impl Model {
    fn find(&self, like: &Change) -> Option<usize> {
        self.changes.iter().position(|known| std::mem::discriminant(known) == std::mem::discriminant(like))
    }

    fn put(&mut self, change: Change, neutral: bool) {
        match (self.find(&change), neutral) {
            (Some(at), true) => drop(self.changes.remove(at)),
            (Some(at), false) => self.changes[at] = change,
            (None, true) => {}
            (None, false) => self.changes.push(change),
        }
    }

    fn shift(&self) -> [f64; 3] {
        self.changes.iter().find_map(|c| if let Change::Shift(by) = c { Some(*by) } else { None }).unwrap_or_default()
    }

    fn apply(&mut self, op: &Op) {
        match *op {
            Op::Shift(coords, _) => {
                let now = self.shift();
                let by = std::array::from_fn(|k| match coords[k] {
                    None => now[k],
                    Some((value, incremental)) => value + if incremental { now[k] } else { 0.0 },
                });
                self.put(Change::Shift(by), by == [0.0; 3]);
            }
            Op::Row(row, _) => self.put(Change::Shift(ROWS[row]), ROWS[row] == [0.0; 3]),
            Op::NoShift => self.put(Change::Shift([0.0; 3]), true),
            Op::Mirror(axes) => self.put(Change::Mirror(axes), axes == [false; 3]),
            Op::Rotate(angle, incremental) => {
                let now = self.changes.iter().find_map(|c| if let Change::Rotate(a) = c { Some(*a) } else { None });
                let angle = angle + if incremental { now.unwrap_or(0.0) } else { 0.0 };
                self.put(Change::Rotate(angle), angle == 0.0);
            }
            Op::Scale(factor) => self.put(Change::Scale(factor), factor == 1.0),
            Op::ScaleAxes(x, y, cx, cy) => {
                self.put(Change::ScaleAxes([x, y, 1.0], [cx, cy, 0.0]), [x, y] == [1.0, 1.0]);
            }
            Op::Tilt(angles, _) => self.put(Change::Tilt(angles.map(f64::from)), angles == [0; 3]),
            Op::PlaneReset => self.put(Change::Tilt([0.0; 3]), true),
            Op::Preset(row) => {
                // The manual (line 6478) names what ends; a tilted plane stays.
                self.preset = row;
                self.changes.retain(|change| matches!(change, Change::Tilt(_)));
            }
        }
    }

    fn matrix(&self) -> Matrix {
        let (origin, angle) = PRESETS[self.preset];
        let mut frame = times(&diagonal([1.0; 3], [0.0; 3]), &turn(2, angle));
        (0..3).for_each(|k| frame[k][3] = origin[k]);
        for change in &self.changes {
            let next = match *change {
                Change::Shift(by) => {
                    let mut matrix = UNIT;
                    (0..3).for_each(|k| matrix[k][3] = by[k]);
                    matrix
                }
                Change::Mirror(axes) => diagonal(axes.map(|axis| if axis { -1.0 } else { 1.0 }), [0.0; 3]),
                Change::Rotate(angle) => turn(self.tool, angle),
                Change::Scale(factor) => diagonal([factor; 3], [0.0; 3]),
                Change::ScaleAxes(factors, about) => diagonal(factors, about),
                Change::Tilt([a, b, c]) => times(&turn(2, c), &times(&turn(1, b), &turn(0, a))),
            };
            frame = times(&frame, &next);
        }
        frame
    }

    /// Scaling by axes beside tilting is an oblique system: the plane has no rotary positions there.
    fn is_oblique(&self) -> bool {
        let (scaled, tilted) = (Change::ScaleAxes([1.0; 3], [0.0; 3]), Change::Tilt([0.0; 3]));
        self.find(&scaled).is_some() && self.find(&tilted).is_some()
    }
}

fn lines(op: &Op) -> String {
    let coords = |coords: &[Option<(f64, bool)>; 3]| -> Vec<String> {
        let word = |(k, coord): (usize, &Option<(f64, bool)>)| {
            coord.map(|(value, incremental)| format!("{}{}{value:+}", if incremental { "I" } else { "" }, AXES[k]))
        };
        coords.iter().enumerate().filter_map(word).collect()
    };
    match op {
        Op::Shift(axes, false) => {
            let words = coords(axes).into_iter().enumerate();
            let written: String = words.map(|(k, word)| format!("CYCL DEF 7.{} {word}\n", k + 1)).collect();
            format!("CYCL DEF 7.0 D\n{written}")
        }
        Op::Shift(axes, true) => format!("TRANS DATUM AXIS {}\n", coords(axes).join(" ")),
        Op::Row(row, false) => format!("CYCL DEF 7.0 D\nCYCL DEF 7.1 #{row}\n"),
        Op::Row(row, true) => format!("TRANS DATUM TABLE TABLINE{row}\n"),
        Op::NoShift => "TRANS DATUM RESET\n".to_owned(),
        Op::Mirror(axes) => {
            let words: Vec<&str> = (0..3).filter(|k| axes[*k]).map(|k| AXES[k]).collect();
            let second = if words.is_empty() { String::new() } else { format!("CYCL DEF 8.1 {}\n", words.join(" ")) };
            format!("CYCL DEF 8.0 M\n{second}")
        }
        Op::Rotate(angle, incremental) => {
            format!("CYCL DEF 10.0 R\nCYCL DEF 10.1 {}ROT{angle:+}\n", if *incremental { "I" } else { "" })
        }
        Op::Scale(factor) => format!("CYCL DEF 11.0 S\nCYCL DEF 11.1 SCL {factor}\n"),
        Op::ScaleAxes(x, y, cx, cy) => format!("CYCL DEF 26.0 S\nCYCL DEF 26.1 X {x} Y {y} CCX{cx:+} CCY{cy:+}\n"),
        Op::Tilt([a, b, c], false) => format!("CYCL DEF 19.0 W\nCYCL DEF 19.1 A{a:+} B{b:+} C{c:+}\n"),
        Op::Tilt([a, b, c], true) => format!("PLANE SPATIAL SPA{a:+} SPB{b:+} SPC{c:+} STAY\n"),
        Op::PlaneReset => "PLANE RESET STAY\n".to_owned(),
        Op::Preset(row) => format!("CYCL DEF 247 P\nQ339={row}\n"),
    }
}

fn number() -> impl Strategy<Value = f64> {
    (-400_000_i32..400_000).prop_map(|n| f64::from(n) / 10_000.0)
}

fn factor() -> impl Strategy<Value = f64> {
    prop_oneof![4 => (2_000_i32..30_000).prop_map(|n| f64::from(n) / 10_000.0), 1 => Just(1.0)]
}

fn op() -> impl Strategy<Value = Op> {
    let coord = prop::option::weighted(0.7, (prop_oneof![4 => number(), 1 => Just(0.0)], any::<bool>()));
    let some = |coords: &[Option<(f64, bool)>; 3]| coords.iter().any(Option::is_some);
    prop_oneof![
        3 => ([coord.clone(), coord.clone(), coord].prop_filter("something", some), any::<bool>())
            .prop_map(|(coords, trans)| Op::Shift(coords, trans)),
        1 => (0_usize..3, any::<bool>()).prop_map(|(row, trans)| Op::Row(row, trans)),
        1 => Just(Op::NoShift),
        2 => any::<[bool; 3]>().prop_map(Op::Mirror),
        2 => (prop_oneof![4 => -180_i32..180, 1 => Just(0)], any::<bool>())
            .prop_map(|(angle, incremental)| Op::Rotate(f64::from(angle), incremental)),
        2 => factor().prop_map(Op::Scale),
        2 => (factor(), factor(), number(), number()).prop_map(|(x, y, cx, cy)| Op::ScaleAxes(x, y, cx, cy)),
        2 => ([-40_i32..40, -40_i32..40, -90_i32..90], any::<bool>()).prop_map(|(angles, plane)| Op::Tilt(angles, plane)),
        1 => Just(Op::Tilt([0; 3], false)),
        1 => Just(Op::PlaneReset),
        1 => (0_usize..3).prop_map(Op::Preset),
    ]
}

fn program(body: &str) -> String {
    format!("BEGIN PGM LAW MM\nTOOL CALL 1 Z S1000 F500\n{body}END PGM LAW MM\n")
}

fn near(a: f64, b: f64) -> bool {
    (a - b).abs() < 1e-6 * (1.0 + b.abs())
}

/// A machine with room, the presets and the datum table of the laws.
fn table() -> String {
    let presets: String = PRESETS
        .iter()
        .enumerate()
        .map(|(row, ([x, y, z], angle))| format!("{{NO: {row}, X: {x}, Y: {y}, Z: {z}, SPC: {angle}}}, "))
        .collect();
    let rows: String =
        ROWS.iter().enumerate().map(|(row, [x, y, z])| format!("{{D: {row}, X: {x}, Y: {y}, Z: {z}}}, ")).collect();
    format!(
        "scene: 1\nmachine:\n  axes: [{{axis: X, min: -99999, max: 99999, rapid: 9000}}, {{axis: Y, min: -99999, max: 99999, \
         rapid: 9000}}, {{axis: Z, min: -99999, max: 99999, rapid: 9000}}]\n  rotary: [{{axis: A, carries: workpiece, \
         rapid: 3600}}, {{axis: C, carries: workpiece, rapid: 3600}}]\ntools: [{{T: 1, L: 50, R: 2}}]\n\
         presets: {{rows: [{presets}]}}\ndatums: [{rows}]\nstart: {{Z: 0}}\n"
    )
}

laws! {
    #![proptest_config(crate::cases::config(1000))]

    /// After every block the event that tells the system has the product of the matrices, and a position lies there.
    #[test]
    fn positions_lie_where_the_product_of_the_matrices_says(
        ops in prop::collection::vec(op(), 1..10), point in [number(), number(), number()], tool in 0_usize..3,
    ) {
        let mut model = Model { tool, ..Model::default() };
        let mut body = format!("TOOL CALL 1 {} S1000 F500\n", AXES[tool]);
        let mut wanted = Vec::new();
        for op in &ops {
            let before = model.clone();
            model.apply(op);
            // A plane of another tool axis has positions that these two axes do not reach.
            if model.is_oblique() || (tool != 2 && model.find(&Change::Tilt([0.0; 3])).is_some()) {
                model = before;
                continue;
            }
            body.push_str(&lines(op));
            body.push_str(&format!("L X{:+} Y{:+} Z{:+} R0 FMAX\nL IX+1 FMAX\n", point[0], point[1], point[2]));
            wanted.push(model.matrix());
        }
        let (outcome, events) = run(&program(&body), &table());
        prop_assert_eq!(outcome.status, Status::Done, "{:?}\n{}", outcome.fault, body);
        // The first move of each pair ends at the point, the second one 1 further in X.
        let ends: Vec<[f64; 3]> = events.iter().filter_map(|event| match event {
            EventKind::Move { machine, .. } => Some(machine.to_array()),
            _ => None,
        }).collect();
        let further = [point[0] + 1.0, point[1], point[2]];
        let mut ends = ends.into_iter().peekable();
        for matrix in &wanted {
            let (there, next) = (at(matrix, point), at(matrix, further));
            let mut found = ends.next().expect("a move");
            // A block that leaves the tool where it is tells no move to the point.
            if (0..3).all(|k| near(found[k], next[k])) && !(0..3).all(|k| near(there[k], next[k])) {
                continue;
            }
            for k in 0..3 {
                prop_assert!(near(found[k], there[k]), "{found:?} is not {there:?}\n{body}");
            }
            found = ends.next().expect("a second move");
            for k in 0..3 {
                prop_assert!(near(found[k], next[k]), "{found:?} is not {next:?}\n{body}");
            }
        }
        let last = events.iter().rev().find_map(|event| match event {
            EventKind::Transform(system) => Some(system.matrix),
            _ => None,
        });
        if let (Some(found), Some(matrix)) = (last, wanted.last()) {
            for (row, own) in found.iter().zip(matrix) {
                for (a, b) in row.iter().zip(own) {
                    prop_assert!(near(*a, *b), "{found:?} is not {matrix:?}\n{body}");
                }
            }
        }
    }

    /// The widest circle of a round pocket leaves the scaled diameter, whatever is mirrored: the tool is not scaled.
    #[test]
    fn a_scaled_pocket_is_milled_with_the_tool_as_it_is(
        diameter in 30_i32..60, scale in factor(), mirrored in any::<bool>(), radius in 1_i32..4,
    ) {
        prop_assume!(f64::from(diameter) * scale > f64::from(4 * radius));
        let mirror = if mirrored { "CYCL DEF 8.0 M\nCYCL DEF 8.1 X\n" } else { "" };
        let body = format!(
            "{mirror}CYCL DEF 11.0 S\nCYCL DEF 11.1 SCL {scale}\nCYCL DEF 252 P\nQ215=1\nQ223={diameter}\nQ368=0\nQ207=500\n\
             Q351=+1\nQ201=-5\nQ202=5\nQ369=0\nQ206=150\nQ338=0\nQ200=2\nQ203=0\nQ204=10\nQ370=1\nQ366=0\nQ385=500\n\
             CYCL CALL M3\n"
        );
        let scene = format!("scene: 1\ntools: [{{T: 1, L: 50, R: {radius}}}]\nstart: {{Z: 50}}\n");
        let (outcome, events) = run(&program(&body), &scene);
        prop_assert_eq!(outcome.status, Status::Done, "{:?}\n{}", outcome.fault, body);
        let widest = events.iter().filter_map(|event| match event {
            EventKind::Move { kind: MoveKind::Arc { .. }, machine, .. } => Some(machine.x.hypot(machine.y)),
            _ => None,
        });
        let widest = widest.fold(0.0, f64::max);
        prop_assert!(near(widest, f64::from(diameter) / 2.0 * scale - f64::from(radius)), "{widest}");
        let whole = events.iter().find_map(|event| match event {
            EventKind::Move { kind: MoveKind::Arc { angle, .. }, .. } if angle.abs() == 360.0 => Some(*angle),
            _ => None,
        });
        prop_assert_eq!(whole, Some(360.0));
    }
}

/// What ends the system of a program: M2 and M30, and a preset (TNC 640 manual, lines 6251-6259 and 6478). A program that is
/// called leaves its system to the caller; a new tool axis turns the rotation with it.
#[test]
fn systems_end_where_the_manual_says() {
    let shift = "CYCL DEF 7.0 D\nCYCL DEF 7.1 X+10\nCYCL DEF 10.0 R\nCYCL DEF 10.1 ROT+90\n";
    let last = |body: &str| {
        let (outcome, events) = run(&program(body), &table());
        assert!(outcome.fault.is_none(), "{:?}", outcome.fault);
        let told = events.iter().rev().find_map(|event| match event {
            EventKind::Transform(system) => Some((system.datum.to_array(), system.rotation, system.preset)),
            _ => None,
        });
        (told.expect("a system"), outcome.position.to_array().map(|value| value.round()))
    };
    let begin = "L X+1 Y+2 Z+3 R0 FMAX\n";
    // 1, 2 from the datum at 10, turned back by 90°: 2, 9.
    assert_eq!(last(&format!("{begin}{shift}")), (([10.0, 0.0, 0.0], 90.0, 0.0), [2.0, 9.0, 3.0]));
    for end in ["M2\n", "M30\n", "L Z+3 FMAX M2\n"] {
        assert_eq!(last(&format!("{begin}{shift}{end}")), (([0.0; 3], 0.0, 0.0), [1.0, 2.0, 3.0]), "{end}");
    }
    assert_eq!(last(&format!("{begin}{shift}CYCL DEF 247 P\nQ339=0\n")), (([0.0; 3], 0.0, 0.0), [1.0, 2.0, 3.0]));
    // With the tool axis Y the rotation is one about Y: 1 - 10 along X and 3 along Z become -3 and -9.
    let (_, position) = last(&format!("{begin}{shift}TOOL CALL 1 Y S1000\n"));
    assert_eq!(position, [-3.0, 2.0, -9.0]);
}

/// A machine whose table tilts about X and turns about Z.
const FIVE_AXES: &str = "scene: 1\nmachine: mill-table-ac\ntools: [{T: 1, L: 80, R: 5}]\nstart: [0, 0, 200]\n";

/// Where X+10 Y+20 Z+30 of a plane lies in the machine; all rotary axes stay at 0 unless the block turns them.
fn placed_by(plane: &str) -> [f64; 3] {
    let program =
        format!("BEGIN PGM LAW MM\nTOOL CALL 1 Z S1000 F500\n{plane}\nL X+10 Y+20 Z+30 FMAX\nEND PGM LAW MM\n");
    let (outcome, events) = run(&program, FIVE_AXES);
    assert_eq!(outcome.status, Status::Done, "{plane}: {:?}", outcome.fault);
    let machine = events.iter().rev().find_map(|event| match event {
        EventKind::Move { machine, .. } => Some(*machine),
        _ => None,
    });
    machine.expect("a move").into()
}

fn meets(found: [f64; 3], wanted: [f64; 3]) -> bool {
    found.iter().zip(wanted).all(|(a, b)| (a - b).abs() < 1e-9)
}

const POINT: [f64; 3] = [10.0, 20.0, 30.0];

laws! {
    #![proptest_config(crate::cases::config(30))]

    /// The angles of Euler: about Z, then about the new X, then about the new Z.
    #[test]
    fn a_plane_by_euler_angles(a in -170.0..170.0f64, b in 1.0..60.0f64, c in 1.0..350.0f64) {
        let matrix = times(&times(&turn(2, a), &turn(0, b)), &turn(2, c));
        let found = placed_by(&format!("PLANE EULER EULPR{a:+.4} EULNU{b:.4} EULROT{c:.4} STAY"));
        prop_assert!(found.iter().zip(at(&matrix, POINT)).all(|(a, b)| (a - b).abs() < 0.01), "{found:?}");
    }

    /// The main axis runs as the base vector as far as it lies in the plane, the tool axis as the normal; three points
    /// in such a plane give the same.
    #[test]
    fn a_plane_by_vectors_and_by_points(base in [-1.0..1.0f64, -1.0..1.0, -0.3..0.3], tip in [-0.6..0.6f64, -0.6..0.6]) {
        let round = |value: f64| (value * 1e4).round() / 1e4;
        let (b, n) = (base.map(round), [round(tip[0]), round(tip[1]), 1.0]);
        prop_assume!(b[0].abs() + b[1].abs() > 0.3);
        let dot = |a: [f64; 3], b: [f64; 3]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
        let scaled = |v: [f64; 3], by: f64| v.map(|value| value * by);
        let z = scaled(n, 1.0 / dot(n, n).sqrt());
        let along = dot(b, z);
        let x: [f64; 3] = std::array::from_fn(|k| b[k] - along * z[k]);
        let x = scaled(x, 1.0 / dot(x, x).sqrt());
        let y = [z[1] * x[2] - z[2] * x[1], z[2] * x[0] - z[0] * x[2], z[0] * x[1] - z[1] * x[0]];
        let wanted: [f64; 3] = std::array::from_fn(|k| 10.0 * x[k] + 20.0 * y[k] + 30.0 * z[k]);
        let vectors = format!(
            "PLANE VECTOR BX{:+.4} BY{:+.4} BZ{:+.4} NX{:+.4} NY{:+.4} NZ{:+.4} STAY", b[0], b[1], b[2], n[0], n[1], n[2]
        );
        let found = placed_by(&vectors);
        prop_assert!(meets(found, wanted), "{vectors}: {found:?} is not {wanted:?}");
        let points: String = [[0.0; 3], scaled(x, 40.0), std::array::from_fn(|k| 15.0 * x[k] + 25.0 * y[k])]
            .iter()
            .enumerate()
            .map(|(n, p)| format!(" P{0}X{1:+.6} P{0}Y{2:+.6} P{0}Z{3:+.6}", n + 1, p[0], p[1], p[2]))
            .collect();
        let found = placed_by(&format!("PLANE POINTS{points} STAY"));
        prop_assert!(found.iter().zip(wanted).all(|(a, b)| (a - b).abs() < 1e-4), "{points}: {found:?} is not {wanted:?}");
    }

    /// By projected angles: the plane cuts the plane ZX in a line that falls by the first angle along X, and the plane YZ in
    /// one that rises by the second along Y. Its X axis is the first line, turned about the normal.
    #[test]
    fn a_plane_by_projected_angles(a in -80.0..80.0f64, b in -80.0..80.0f64, by in -180.0..180.0f64) {
        let (a, b) = ((a * 1e4).round() / 1e4, (b * 1e4).round() / 1e4);
        let ((sa, ca), (sb, cb)) = (a.to_radians().sin_cos(), b.to_radians().sin_cos());
        let unit = |v: [f64; 3]| {
            let length = v.iter().map(|value| value * value).sum::<f64>().sqrt();
            v.map(|value| value / length)
        };
        let cross = |a: [f64; 3], b: [f64; 3]| {
            [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
        };
        let first = [ca, 0.0, -sa];
        let normal = unit(cross(first, [0.0, cb, sb]));
        let across = cross(normal, first);
        let (s, c) = by.to_radians().sin_cos();
        let x: [f64; 3] = std::array::from_fn(|k| first[k] * c + across[k] * s);
        let y = cross(normal, x);
        let wanted: [f64; 3] = std::array::from_fn(|k| 10.0 * x[k] + 20.0 * y[k] + 30.0 * normal[k]);
        let found = placed_by(&format!("PLANE PROJECTED PROPR{a:+.4} PROMIN{b:+.4} ROT{by:+} STAY"));
        prop_assert!(meets(found, wanted), "{found:?} is not {wanted:?}");
        // Without a turn it is the plane of two spatial angles, the first of which is seen shorter in its projection.
        let about_x = (b.to_radians().tan() * ca).atan().to_degrees();
        let spatial = placed_by(&format!("PLANE SPATIAL SPA{about_x:+} SPB{a:+.4} SPC+0 STAY"));
        let found = placed_by(&format!("PLANE PROJECTED PROPR{a:+.4} PROMIN{b:+.4} ROT+0 STAY"));
        prop_assert!(meets(found, spatial), "{found:?} is not {spatial:?}");
    }

    /// A further angle turns about an axis of the plane that is active.
    #[test]
    fn a_plane_relative_to_the_one_before(a in -40.0..40.0f64, b in -40.0..40.0f64, by in -40.0..40.0f64, axis in 0..3usize) {
        let matrix = times(&times(&turn(1, b), &turn(0, a)), &turn(axis, by));
        let word = ["SPA", "SPB", "SPC"][axis];
        let found = placed_by(&format!("PLANE SPATIAL SPA{a:+} SPB{b:+} SPC+0 STAY\nPLANE RELATIV {word}{by:+} STAY"));
        prop_assert!(meets(found, at(&matrix, POINT)), "{found:?}");
    }
}

/// Of the two positions of the table the sign of the axis that tilts it chooses one.
#[test]
fn the_sequence_chooses_a_position() {
    for (word, sign) in [("SEQ+", 1.0), ("SEQ-", -1.0)] {
        let plane = format!("PLANE SPATIAL SPA+30 SPB+0 SPC+0 MB MAX TURN F2000 {word} COORD ROT");
        let program = format!("BEGIN PGM LAW MM\nTOOL CALL 1 Z S1000 F500\n{plane}\nEND PGM LAW MM\n");
        let (outcome, _) = run(&program, FIVE_AXES);
        assert_eq!(outcome.status, Status::Done, "{:?}", outcome.fault);
        let (a, c) = (outcome.angles.x, outcome.angles.z);
        assert!((a - sign * 30.0).abs() < 1e-9, "A {a}");
        assert!(((c + if sign > 0.0 { 0.0 } else { 180.0 }) / 360.0).fract().abs() < 1e-9, "C {c}");
    }
}
