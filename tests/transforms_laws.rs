//! Laws of coordinate transformations over random programs: in whatever order datum shift, mirroring, rotation, scaling
//! and tilting are defined and redefined, a position of the program lies where the product of their matrices says, and
//! cycles leave what they are asked for in the scaled and mirrored system.
//!
//! The matrices are multiplied here, with plain trigonometry and nothing of the engine.
#![expect(clippy::disallowed_methods, reason = "truths are calculated with plain trigonometry")]
use std::sync::OnceLock;

use ciklo::diag::Source;
use ciklo::engine::run::{Engine, EventKind, MoveKind, NoTexts, Outcome, Status};
use ciklo::engine::scene::Scene;
use ciklo::spec::Catalogue;
use ciklo::syntax;
use proptest::prelude::*;

struct World {
    files: ciklo::data::Files,
    catalogue: Catalogue,
}

fn world() -> &'static World {
    static WORLD: OnceLock<World> = OnceLock::new();
    WORLD.get_or_init(|| {
        let files = ciklo::data::embedded();
        let (catalogue, _) = Catalogue::load(&files);
        World { files, catalogue }
    })
}

fn run(program: &str, scene: &str) -> (Outcome, Vec<EventKind>) {
    let world = world();
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

/// A definition: what it is, so that one of the same kind takes its place, its lines and its matrix.
#[derive(Clone, Debug)]
struct Step {
    kind: usize,
    lines: String,
    matrix: Matrix,
}

fn number() -> impl Strategy<Value = f64> {
    (-400_000_i32..400_000).prop_map(|n| f64::from(n) / 10_000.0)
}

fn factor() -> impl Strategy<Value = f64> {
    (2_000_i32..30_000).prop_map(|n| f64::from(n) / 10_000.0)
}

fn step(kind: usize) -> BoxedStrategy<Step> {
    let made = move |lines: String, matrix| Step { kind, lines, matrix };
    match kind {
        0 => (number(), number(), number())
            .prop_map(move |(x, y, z)| {
                let mut matrix = UNIT;
                (matrix[0][3], matrix[1][3], matrix[2][3]) = (x, y, z);
                made(format!("CYCL DEF 7.0 D\nCYCL DEF 7.1 X{x}\nCYCL DEF 7.2 Y{y}\nCYCL DEF 7.3 Z{z}\n"), matrix)
            })
            .boxed(),
        1 => (1_usize..8)
            .prop_map(move |axes| {
                let signs = std::array::from_fn(|k| if axes >> k & 1 == 1 { -1.0 } else { 1.0 });
                let words: String = ["X", "Y", "Z"]
                    .iter()
                    .enumerate()
                    .filter(|(k, _)| axes >> k & 1 == 1)
                    .map(|(_, w)| format!(" {w}"))
                    .collect();
                made(format!("CYCL DEF 8.0 M\nCYCL DEF 8.1{words}\n"), diagonal(signs, [0.0; 3]))
            })
            .boxed(),
        2 => (-180_i32..180)
            .prop_filter("turned", |angle| *angle != 0)
            .prop_map(move |angle| {
                made(format!("CYCL DEF 10.0 R\nCYCL DEF 10.1 ROT{angle:+}\n"), turn(2, f64::from(angle)))
            })
            .boxed(),
        3 => factor()
            .prop_map(move |f| made(format!("CYCL DEF 11.0 S\nCYCL DEF 11.1 SCL {f}\n"), diagonal([f; 3], [0.0; 3])))
            .boxed(),
        4 => (factor(), factor(), number(), number())
            .prop_map(move |(x, y, cx, cy)| {
                let lines = format!("CYCL DEF 26.0 S\nCYCL DEF 26.1 X {x} Y {y} CCX{cx:+} CCY{cy:+}\n");
                made(lines, diagonal([x, y, 1.0], [cx, cy, 0.0]))
            })
            .boxed(),
        _ => (-40_i32..40, -40_i32..40, -90_i32..90)
            .prop_filter("tilted", |angles| *angles != (0, 0, 0))
            .prop_map(move |(a, b, c)| {
                let lines = format!("CYCL DEF 19.0 W\nCYCL DEF 19.1 A{a:+} B{b:+} C{c:+}\n");
                let first = times(&turn(1, f64::from(b)), &turn(0, f64::from(a)));
                made(lines, times(&turn(2, f64::from(c)), &first))
            })
            .boxed(),
    }
}

fn program(body: &str) -> String {
    format!("BEGIN PGM LAW MM\nTOOL CALL 1 Z S1000 F500\n{body}END PGM LAW MM\n")
}

fn near(a: f64, b: f64) -> bool {
    (a - b).abs() < 1e-6 * (1.0 + b.abs())
}

const TABLE: &str = "scene: 1\nmachine: mill-table-ac\ntools: [{T: 1, L: 50, R: 2}]\nstart: {Z: 0}\n";

proptest! {
    #![proptest_config(ProptestConfig { cases: 400, ..ProptestConfig::default() })]

    #[test]
    fn positions_lie_where_the_product_of_the_matrices_says(
        steps in prop::collection::vec((0_usize..6).prop_flat_map(step), 1..8),
        point in [number(), number(), number()],
    ) {
        // What is redefined keeps its place.
        let mut in_effect: Vec<Step> = Vec::new();
        let mut body = String::new();
        for step in &steps {
            body.push_str(&step.lines);
            match in_effect.iter_mut().find(|known| known.kind == step.kind) {
                Some(known) => *known = step.clone(),
                None => in_effect.push(step.clone()),
            }
        }
        // Scaling about a point before tilting would be an oblique system: the plane has no rotary positions there.
        let skew = |kind: usize| in_effect.iter().position(|step| step.kind == kind);
        prop_assume!(!(skew(4).is_some() && skew(5).is_some()));
        let product = in_effect.iter().fold(UNIT, |product, step| times(&product, &step.matrix));
        let wanted = at(&product, point);
        prop_assume!(wanted.iter().all(|value| value.abs() < 990.0));
        body.push_str(&format!("L X{:+} Y{:+} Z{:+} R0 FMAX\n", point[0], point[1], point[2]));
        let (outcome, events) = run(&program(&body), TABLE);
        prop_assert_eq!(outcome.status, Status::Done, "{:?}\n{}", outcome.fault, body);
        let last = events.iter().rev().find_map(|event| match event {
            EventKind::Move { machine, .. } => Some(*machine),
            _ => None,
        });
        let found = last.expect("a move").to_array();
        for (found, wanted) in found.iter().zip(wanted) {
            prop_assert!(near(*found, wanted), "{found} is not {wanted}\n{body}");
        }
        for (found, wanted) in outcome.position.to_array().iter().zip(point) {
            prop_assert!((found - wanted).abs() < 1e-4, "{found} is not {wanted}\n{body}");
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
