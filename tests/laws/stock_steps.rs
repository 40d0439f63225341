//! Laws of machining over random legal parameters: the part that a cycle leaves is the nominal solid, nothing else is
//! cut, rapid traverse touches no material, and no step is deeper than the program allows.
//!
//! Nominal solids are put together here from the parameters, with plain trigonometry. A failure shrinks to a small
//! program and its scene, which `ciklo run --stock` executes.
#![expect(clippy::disallowed_methods, reason = "truths are calculated with plain trigonometry")]
use std::fmt::Write as _;

use ciklo::base::diag::Source;
use ciklo::engine::geometry::{Axis, Frame, WorkingPlane};
use ciklo::engine::run::{Engine, NoTexts, Status};
use ciklo::engine::scene::Scene;
use ciklo::engine::solid::{Path, Shape};
use ciklo::engine::stock::{Batch, Cut, Cutter, Machining, Report, Stock, Tip};
use ciklo::program::syntax;
use glam::{DVec2, DVec3};
use proptest::prelude::*;

use crate::built;
use built::{Built, built};

/// How far a surface may lie beside its place, mm; what the run adds up stays far below.
const NEAR: f64 = 1e-4;
/// Half the extent of the blank in the plane, and its height.
const HALF: f64 = 50.0;
const HEIGHT: f64 = 30.0;
/// Size of the columns.
const RESOLUTION: f64 = 1.3;

/// The tool axis, the tool, and the surface of the blank along the tool axis.
#[derive(Clone, Debug)]
struct Setup {
    axis: Axis,
    radius: f64,
    /// Angle of the point; 0 for a flat tool.
    point: f64,
    surface: f64,
    clearance: f64,
    second: f64,
}

prop_compose! {
    fn setup()(
        axis in prop::sample::select(Axis::ALL.to_vec()),
        radius in 1.0..6.0_f64, point in prop_oneof![Just(0.0), Just(118.0), 60.0..150.0],
        surface in -10..10, clearance in 1.0..5.0, second in prop_oneof![Just(0.0), 6.0..40.0],
    ) -> Setup {
        Setup { axis, radius, point, surface: f64::from(surface), clearance, second }
    }
}

impl Setup {
    fn plane(&self) -> WorkingPlane {
        WorkingPlane::of_tool_axis(self.axis)
    }

    fn at(&self, x: f64, y: f64, z: f64) -> DVec3 {
        self.plane().lift(DVec2::new(x, y), z)
    }

    /// The words of a position.
    fn words(&self, x: f64, y: f64) -> String {
        let plane = self.plane();
        format!("{}{x:+} {}{y:+}", plane.main.letter(), plane.secondary.letter())
    }

    /// A program around a definition and its calls.
    fn program(&self, body: &str) -> String {
        let (min, max) = (self.at(-HALF, -HALF, self.surface - HEIGHT), self.at(HALF, HALF, self.surface));
        let letter = self.axis.letter();
        format!(
            "BEGIN PGM LAW MM\nBLK FORM 0.1 {letter} X{:+} Y{:+} Z{:+}\nBLK FORM 0.2 X{:+} Y{:+} Z{:+}\n\
             TOOL CALL 1 {letter} S2000 F300\nL {letter}+100 R0 FMAX M3\n{body}L {letter}+100 R0 FMAX M30\nEND PGM LAW MM\n",
            min.x, min.y, min.z, max.x, max.y, max.z
        )
    }

    fn scene(&self) -> String {
        let start = self.at(0.0, 0.0, 100.0);
        format!(
            "scene: 1\ntools: [{{T: 1, L: 100, R: {}, T-ANGLE: {}}}]\nstart: [{}, {}, {}]\n",
            self.radius, self.point, start.x, start.y, start.z
        )
    }

    /// Height of the tool's point.
    fn tip(&self) -> f64 {
        if self.point > 0.0 { self.radius / (self.point / 2.0).to_radians().tan() } else { 0.0 }
    }

    /// The hole that the tool leaves at a place.
    fn hole(&self, x: f64, y: f64, floor: f64) -> Shape {
        let at = |z: f64| self.at(x, y, z);
        let round = Shape::Cylinder { from: at(self.surface + 60.0), to: at(floor + self.tip()), radius: self.radius };
        if self.point == 0.0 {
            return round;
        }
        let cone =
            Shape::Cone { from: at(floor + self.tip()), to: at(floor), radius_from: self.radius, radius_to: 0.0 };
        Shape::Union(vec![round, cone])
    }

    fn part(&self, holes: Vec<Shape>) -> Shape {
        let min = self.at(-HALF, -HALF, self.surface - HEIGHT);
        let mut shapes = vec![Shape::Box { min, max: self.at(HALF, HALF, self.surface) }];
        shapes.extend(holes);
        Shape::Difference(shapes)
    }

    /// Machines and asks for what every run must keep to.
    fn machined(&self, body: &str) -> Result<(Stock, Report, String), TestCaseError> {
        let Built { files, catalogue, .. } = built();
        let (program, scene) = (self.program(body), self.scene());
        let both = format!("\n{program}\n{scene}");
        let on = catalogue.on("tnc640").expect("a control");
        let read = Scene::parse(&Source::new("scene.yaml", scene.as_str()), files).expect("a scene");
        let tree = syntax::parse(&Source::new("LAW.H", program.as_str()));
        let mut machining = Machining::new(&tree, &read, Some(RESOLUTION)).expect("a stock");
        let outcome =
            Engine::new(&tree, on, &read, &NoTexts).with_catalogue(catalogue).run(&mut |event| machining.see(&event));
        prop_assert_eq!(outcome.status, Status::Done, "{:?}{}", outcome.fault, both);
        let (stock, report) = machining.finish();
        prop_assert!(report.findings.is_empty(), "{:?}{}", report.findings, both);
        prop_assert!((report.blank - report.removed - stock.volume()).abs() < 1e-4, "volumes{}", both);
        Ok((stock, report, both))
    }

    /// The same, and the part is the blank without the holes.
    fn leaves(&self, body: &str, holes: Vec<Shape>, deepest: f64) -> Result<(), TestCaseError> {
        let (stock, report, both) = self.machined(body)?;
        let deviation = stock.compare(&self.part(holes), NEAR).expect("a comparison");
        prop_assert!(deviation.is_none(), "{:?}{}", deviation, both);
        prop_assert!(report.depth.value <= deepest + 1e-6, "{:?} is deeper than {}{}", report.depth, deepest, both);
        Ok(())
    }
}

fn places() -> impl Strategy<Value = Vec<(f64, f64)>> {
    prop::collection::vec((-40.0..40.0, -40.0..40.0), 1..4)
}

fn calls(setup: &Setup, places: &[(f64, f64)]) -> String {
    places.iter().fold(String::new(), |mut text, (x, y)| {
        let _ = writeln!(text, "L {} R0 FMAX M99", setup.words(*x, *y));
        text
    })
}

/// The parameters of a cycle: numbers and values.
fn definition(cycle: u16, values: &[(u16, f64)]) -> String {
    values.iter().fold(format!("CYCL DEF {cycle}\n"), |mut text, (q, value)| {
        let _ = writeln!(text, "Q{q}={value:+}");
        text
    })
}

fn drilling(setup: &Setup, depth: f64, infeed: f64) -> String {
    let Setup { clearance, surface, second, .. } = *setup;
    definition(
        200,
        &[
            (200, clearance),
            (201, -depth),
            (206, 250.0),
            (202, infeed),
            (210, 0.0),
            (203, surface),
            (204, second),
            (211, 0.1),
        ],
    )
}

/// Steps of a flat tool in a block of 16 mm: each goes on from the last one, now and then with another tool.
fn steps() -> impl Strategy<Value = Vec<(Path, Cutter)>> {
    let step = (0.0..360.0_f64, 0.02..0.6_f64, -0.3..0.1_f64, any::<bool>(), 0..12_u8);
    let tools = (2.0..5.0_f64, prop_oneof![Just(Tip::Round(2.0)), Just(Tip::Point(0.6)), Just(Tip::Flat)]);
    (tools, prop::collection::vec(step, 1..60)).prop_map(|((radius, tip), steps)| {
        let flat = Cutter { radius, tip: Tip::Flat, neck: None, edges: 0.0 };
        let other = Cutter { radius: 2.0, tip, neck: None, edges: 0.0 };
        let mut at = DVec3::new(8.0, 8.0, -1.0);
        let way = |(towards, length, rise, arc, kind): (f64, f64, f64, bool, u8)| {
            let angle = towards.to_radians();
            let there = DVec3::new(angle.cos(), angle.sin(), 0.0);
            let from = at;
            let path = if arc {
                let (centre, sweep) = (from - there * 4.0, (length / 4.0).to_degrees());
                Path::Arc { centre, axis: DVec3::Z, from, sweep, rise }
            } else {
                Path::line(from, from + there * length + DVec3::Z * rise)
            };
            at = path.at(1.0);
            (path, if kind == 0 { other } else { flat })
        };
        steps.into_iter().map(way).collect()
    })
}

/// What is left of the block, and what each step did; the steps are carried out so many at a time.
fn stepped(steps: &[(Path, Cutter)], together: usize) -> (Stock, Vec<Cut>) {
    let [min, max] = [DVec3::new(0.0, 0.0, -30.0), DVec3::new(16.0, 16.0, 0.0)];
    let blank = Shape::Box { min, max };
    let mut stock = Stock::new(&blank, [min, max], Frame::IDENTITY, Axis::Z, 0.1).expect("a stock");
    let (mut batch, mut cuts) = (Batch::default(), Vec::new());
    for steps in steps.chunks(together) {
        steps.iter().for_each(|(path, cutter)| stock.add(&mut batch, path, DVec3::Z, cutter, false));
        cuts.extend(stock.carry_out(&mut batch));
    }
    (stock, cuts)
}

laws! {
    #![proptest_config(crate::cases::config(32))]

    /// What a flat tool has below it is remembered from step to step only while they are carried out together.
    #[test]
    fn steps_together_do_what_they_do_alone(steps in steps()) {
        let ((together, both), (alone, each)) = (stepped(&steps, steps.len()), stepped(&steps, 1));
        let (columns, rows) = together.size();
        for (column, row) in (0..rows).flat_map(|row| (0..columns).map(move |column| (column, row))) {
            let [a, b] = [&together, &alone].map(|stock| stock.top(column, row).expect("material"));
            prop_assert!((a - b).abs() < 1e-9, "column {column} of row {row}: {a} and {b}");
        }
        for (n, (a, b)) in both.iter().zip(&each).enumerate() {
            let volume = (a.volume - b.volume).abs() < 1e-9;
            let width = (a.width - b.width).abs() < 1e-9;
            prop_assert!(volume && width && (a.depth - b.depth).abs() < 1e-9, "step {n}: {a:?} and {b:?}");
            prop_assert!(a.volume < 1e-9 || (a.reach - b.reach).abs() < 1e-9, "step {n}: {a:?} and {b:?}");
        }
    }

    #[test]
    fn drilling_leaves_holes(setup in setup(), places in places(), depth in 0.5..40.0_f64, infeed in 0.5..20.0) {
        let holes = places.iter().map(|(x, y)| setup.hole(*x, *y, setup.surface - depth)).collect();
        let body = drilling(&setup, depth, infeed) + &calls(&setup, &places);
        setup.leaves(&body, holes, infeed.min(depth))?;
    }

    /// The manuals allow no negative surface here.
    #[test]
    fn reaming_leaves_holes(setup in setup(), places in places(), depth in 0.5..28.0_f64, back in prop_oneof![Just(0.0), 100.0..900.0]) {
        let setup = Setup { surface: setup.surface.abs(), ..setup };
        let Setup { clearance, surface, second, .. } = setup;
        let values = [(200, clearance), (201, -depth), (206, 100.0), (211, 0.5), (208, back), (203, surface), (204, second)];
        let holes = places.iter().map(|(x, y)| setup.hole(*x, *y, surface - depth)).collect();
        setup.leaves(&(definition(201, &values) + &calls(&setup, &places)), holes, depth)?;
    }

    #[test]
    fn universal_drilling_leaves_holes(
        setup in setup(), places in places(), depth in 0.5..29.0_f64, infeed in 1.0..12.0, less in 0.0..1.0, breaks in 0..4,
        share in 0.2..1.0, back in 0.1..0.4,
    ) {
        let Setup { clearance, surface, second, .. } = setup;
        let values = [
            (200, clearance), (201, -depth), (206, 150.0), (202, infeed), (210, 0.0), (203, surface), (204, second),
            (212, less), (213, f64::from(breaks)), (205, infeed * share), (211, 0.25), (208, 500.0), (256, back),
        ];
        let holes = places.iter().map(|(x, y)| setup.hole(*x, *y, surface - depth)).collect();
        setup.leaves(&(definition(203, &values) + &calls(&setup, &places)), holes, infeed.min(depth))?;
    }

    #[test]
    fn pecking_leaves_holes(
        setup in setup(), places in places(), depth in 0.5..29.0_f64, infeed in 1.0..12.0, less in 0.0..1.0, share in 0.2..1.0,
        breaks in prop_oneof![Just(0.0), 0.5..6.0], stops in (0.2..1.0, 0.2..1.0), back in 0.1..0.4,
    ) {
        let Setup { clearance, surface, second, .. } = setup;
        let values = [
            (200, clearance), (201, -depth), (206, 150.0), (202, infeed), (203, surface), (204, second), (212, less),
            (205, infeed * share), (258, stops.0), (259, stops.1), (257, breaks), (256, back), (211, 0.25), (379, 0.0),
            (253, 750.0),
        ];
        let holes = places.iter().map(|(x, y)| setup.hole(*x, *y, surface - depth)).collect();
        let deepest = if breaks > 0.0 { infeed.min(breaks) } else { infeed };
        setup.leaves(&(definition(205, &values) + &calls(&setup, &places)), holes, deepest.min(depth))?;
    }

    #[test]
    fn bore_milling_leaves_cylinders(
        setup in setup(), places in places(), depth in 0.5..29.0_f64, infeed in 0.2..6.0_f64, share in 1.02..1.98, climb in any::<bool>(),
    ) {
        let setup = Setup { point: 0.0, ..setup };
        let Setup { clearance, surface, second, radius, .. } = setup;
        let diameter = 2.0 * radius * share;
        let values = [
            (200, clearance), (201, -depth), (206, 150.0), (334, infeed), (203, surface), (204, second), (335, diameter),
            (342, 0.0), (351, if climb { 1.0 } else { -1.0 }),
        ];
        let hole = |(x, y): &(f64, f64)| Shape::Cylinder {
            from: setup.at(*x, *y, surface + 60.0),
            to: setup.at(*x, *y, surface - depth),
            radius: diameter / 2.0,
        };
        let holes = places.iter().map(hole).collect();
        // A quarter turn takes a place from the turn before to its own height, and goes on down while over it.
        setup.leaves(&(definition(208, &values) + &calls(&setup, &places)), holes, (1.25 * infeed).min(depth))?;
    }

    #[test]
    fn centring_leaves_cones(setup in setup(), places in places(), share in 0.1..0.95_f64, point in 60.0..150.0, by_depth in any::<bool>()) {
        let setup = Setup { point, ..setup };
        let Setup { clearance, surface, second, radius, .. } = setup;
        let (depth, diameter) = (setup.tip() * share, 2.0 * radius * share);
        let values = [
            (200, clearance), (343, if by_depth { 0.0 } else { 1.0 }), (201, -depth), (344, -diameter), (206, 250.0), (211, 0.1),
            (203, surface), (204, second),
        ];
        let holes = places.iter().map(|(x, y)| setup.hole(*x, *y, surface - depth)).collect();
        setup.leaves(&(definition(240, &values) + &calls(&setup, &places)), holes, depth)?;
    }

    #[test]
    fn circles_of_holes(
        setup in setup(), depth in 0.5..29.0_f64, infeed in 1.0..12.0, centre in (-10.0..10.0, -10.0..10.0), diameter in 10.0..60.0,
        start in -180.0..180.0, step in 20.0..60.0, count in 2..6_u8, high in any::<bool>(),
    ) {
        let Setup { clearance, surface, second, .. } = setup;
        let second = second.max(6.0);
        let values = [
            (216, centre.0), (217, centre.1), (244, diameter), (245, start), (246, 0.0), (247, step), (241, f64::from(count)),
            (200, clearance), (203, surface), (204, second), (301, f64::from(u8::from(high))), (365, 0.0),
        ];
        let place = |n: u8| {
            let angle = (start + step * f64::from(n)).to_radians();
            (centre.0 + diameter / 2.0 * angle.cos(), centre.1 + diameter / 2.0 * angle.sin())
        };
        let holes = (0..count).map(place).map(|(x, y)| setup.hole(x, y, surface - depth)).collect();
        setup.leaves(&(drilling(&setup, depth, infeed) + &definition(220, &values)), holes, infeed.min(depth))?;
    }

    #[test]
    fn lines_of_holes(
        setup in setup(), depth in 0.5..29.0_f64, infeed in 1.0..12.0, start in (-20.0..0.0, -20.0..0.0), pitch in (4.0..12.0, 4.0..12.0),
        count in (1..4_u8, 1..4_u8), turn in -90.0..90.0_f64, high in any::<bool>(),
    ) {
        let Setup { clearance, surface, second, .. } = setup;
        let second = second.max(6.0);
        let values = [
            (225, start.0), (226, start.1), (237, pitch.0), (238, pitch.1), (242, f64::from(count.0)), (243, f64::from(count.1)),
            (224, turn), (200, clearance), (203, surface), (204, second), (301, f64::from(u8::from(high))),
        ];
        let (s, c) = turn.to_radians().sin_cos();
        let mut holes = Vec::new();
        for row in 0..count.1 {
            for column in 0..count.0 {
                let (x, y) = (f64::from(column) * pitch.0, f64::from(row) * pitch.1);
                holes.push(setup.hole(start.0 + x * c - y * s, start.1 + x * s + y * c, surface - depth));
            }
        }
        setup.leaves(&(drilling(&setup, depth, infeed) + &definition(221, &values)), holes, infeed.min(depth))?;
    }

    /// A ruled surface that is level: all between its edges is cleared, and nothing farther away than the tool reaches.
    #[test]
    fn level_ruled_surfaces_are_cleared(
        setup in setup(), corner in (-30.0..0.0, -30.0..0.0), size in (5.0..30.0_f64, 5.0..30.0_f64), depth in 0.2..10.0_f64, share in 0.3..0.95_f64,
    ) {
        let setup = Setup { point: 0.0, ..setup };
        let radius = setup.radius;
        let floor = setup.surface - depth;
        let (x, y) = corner;
        // Lines so close together that the tool's discs leave nothing between them within the surface.
        let cuts = (size.1 / (2.0 * radius * share)).ceil() + 1.0;
        let values = [
            (225, x), (226, y), (227, floor), (228, x + size.0), (229, y), (230, floor), (231, x + size.0), (232, y + size.1),
            (233, floor), (234, x), (235, y + size.1), (236, floor), (240, cuts), (207, 500.0),
        ];
        let above = format!("L {}{:+} R0 FMAX\n", setup.axis.letter(), setup.surface + 10.0);
        let before = format!("L {} R0 FMAX\n", setup.words(x, y));
        let (stock, report, both) = setup.machined(&(definition(231, &values) + &before + &above + "CYCL CALL\n"))?;
        let pocket = |grow: f64| Shape::Box {
            min: setup.at(x - grow, y - grow, floor),
            max: setup.at(x + size.0 + grow, y + size.1 + grow, setup.surface + 60.0),
        };
        let inner = stock.compare(&setup.part(vec![pocket(0.0)]), NEAR).expect("a comparison");
        let outer = stock.compare(&setup.part(vec![pocket(radius)]), NEAR).expect("a comparison");
        prop_assert!(inner.left_over.is_none(), "{:?}{}", inner, both);
        prop_assert!(outer.gouged.is_none(), "{:?}{}", outer, both);
        prop_assert!(report.depth.value <= depth + 1e-6, "{:?}{}", report.depth, both);
    }
}
