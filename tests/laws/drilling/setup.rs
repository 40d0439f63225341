//! Programs, scenes and runs that the laws share.
use std::fmt::Write as _;

use crate::built::{Built, built};
use ciklo::base::diag::Source;
use ciklo::engine::geometry::{Axis, WorkingPlane};
use ciklo::engine::run::{Engine, Event, EventKind, MoveKind, NoTexts, Outcome, Status, Threaded};
use ciklo::engine::scene::Scene;
use ciklo::engine::solid::Shape;
use ciklo::engine::stock::{Machining, Report, Stock, Watch};
use ciklo::program::syntax;
use glam::{DVec2, DVec3};
use proptest::prelude::*;

/// How far a surface may lie beside its place, mm; what the run adds up stays far below.
pub(super) const NEAR: f64 = 1e-4;
/// Half the extent of the blank in the plane, and its height.
pub(super) const HALF: f64 = 24.0;
pub(super) const HEIGHT: f64 = 30.0;

/// The few cases that a law of these cycles tries.
pub(super) fn config() -> ProptestConfig {
    crate::cases::config(12)
}

/// What is in effect while the cycle is called.
#[derive(Clone, Copy, Debug)]
pub(super) enum Change {
    None,
    /// Mirrors the main or the secondary axis.
    Mirror(bool),
    Rotate(f64),
    Shift(f64, f64),
}

pub(super) fn change() -> impl Strategy<Value = Change> {
    prop_oneof![
        Just(Change::None),
        any::<bool>().prop_map(Change::Mirror),
        (-180.0..180.0).prop_map(Change::Rotate),
        (-4.0..4.0, -4.0..4.0).prop_map(|(x, y)| Change::Shift(x, y)),
    ]
}

/// The tool axis, the surface of the blank along it, clearances, and the coordinate system.
#[derive(Clone, Debug)]
pub(super) struct Setup {
    pub(super) axis: Axis,
    pub(super) surface: f64,
    pub(super) clearance: f64,
    pub(super) second: f64,
    pub(super) change: Change,
}

prop_compose! {
    pub(super) fn setup()(
        axis in prop::sample::select(Axis::ALL.to_vec()), surface in -10..10, clearance in 1.0..5.0,
        second in prop_oneof![Just(0.0), 6.0..40.0], change in change(),
    ) -> Setup {
        Setup { axis, surface: f64::from(surface), clearance, second, change }
    }
}

/// A run to its end.
pub(super) struct Made {
    pub(super) stock: Stock,
    pub(super) report: Report,
    pub(super) events: Vec<Event>,
    /// Program and scene.
    pub(super) text: String,
}

pub(super) fn run(program: &str, scene: &str) -> (Outcome, Vec<Event>) {
    let Built { files, catalogue, .. } = built();
    let on = catalogue.on("tnc640").expect("a control");
    let read = Scene::parse(&Source::new("scene.yaml", scene), files).expect("a scene");
    let tree = syntax::parse(&Source::new("LAW.H", program));
    let mut events = Vec::new();
    let engine = Engine::new(&tree, on, &read, &NoTexts).with_catalogue(catalogue);
    let outcome = engine.run(&mut |event| events.push(event));
    (outcome, events)
}

/// The run with its stock; events with what was found among them.
pub(super) fn machine(program: &str, scene: &str, resolution: f64) -> (Outcome, Vec<Event>, Stock, Report) {
    let Built { files, catalogue, .. } = built();
    let on = catalogue.on("tnc640").expect("a control");
    let read = Scene::parse(&Source::new("scene.yaml", scene), files).expect("a scene");
    let tree = syntax::parse(&Source::new("LAW.H", program));
    let mut watch = Watch::new(Machining::new(&tree, &read, Some(resolution)).expect("a stock"));
    let mut events = Vec::new();
    let engine = Engine::new(&tree, on, &read, &NoTexts).with_catalogue(catalogue);
    let outcome = engine.run(&mut |event| watch.see(event, &mut |event| events.push(event)));
    let (stock, report) = watch.finish();
    (outcome, events, stock, report)
}

impl Setup {
    pub(super) fn plane(&self) -> WorkingPlane {
        WorkingPlane::of_tool_axis(self.axis)
    }

    /// A point of the machine.
    pub(super) fn at(&self, x: f64, y: f64, z: f64) -> DVec3 {
        self.plane().lift(DVec2::new(x, y), z)
    }

    /// Where a place of the program lies on the machine.
    pub(super) fn seen(&self, place: DVec2) -> DVec2 {
        match self.change {
            Change::None => place,
            Change::Mirror(true) => DVec2::new(-place.x, place.y),
            Change::Mirror(false) => DVec2::new(place.x, -place.y),
            Change::Rotate(angle) => DVec2::from_angle(angle.to_radians()).rotate(place),
            Change::Shift(x, y) => place + DVec2::new(x, y),
        }
    }

    /// Where a place of the machine lies in the program.
    pub(super) fn unseen(&self, place: DVec2) -> DVec2 {
        match self.change {
            Change::Rotate(angle) => DVec2::from_angle(-angle.to_radians()).rotate(place),
            Change::Shift(x, y) => place - DVec2::new(x, y),
            _ => self.seen(place),
        }
    }

    pub(super) const fn mirrors(&self) -> bool {
        matches!(self.change, Change::Mirror(_))
    }

    /// The blocks that put the change into effect.
    pub(super) fn changed(&self) -> String {
        let (main, secondary) = (self.plane().main.letter(), self.plane().secondary.letter());
        match self.change {
            Change::None => String::new(),
            Change::Mirror(first) => {
                format!("CYCL DEF 8.0 MIRROR IMAGE\nCYCL DEF 8.1 {}\n", if first { main } else { secondary })
            }
            Change::Rotate(angle) => format!("CYCL DEF 10.0 ROTATION\nCYCL DEF 10.1 ROT{angle:+}\n"),
            Change::Shift(x, y) => {
                format!("CYCL DEF 7.0 DATUM SHIFT\nCYCL DEF 7.1 {main}{x:+}\nCYCL DEF 7.2 {secondary}{y:+}\n")
            }
        }
    }

    /// The words of a position.
    pub(super) fn words(&self, place: DVec2) -> String {
        let plane = self.plane();
        format!("{}{:+} {}{:+}", plane.main.letter(), place.x, plane.secondary.letter(), place.y)
    }

    pub(super) fn calls(&self, places: &[DVec2]) -> String {
        places.iter().fold(String::new(), |mut text, place| {
            let _ = writeln!(text, "L {} R0 FMAX M99", self.words(*place));
            text
        })
    }

    /// Takes a tool, goes up and turns the spindle.
    pub(super) fn tool(&self, number: u8, speed: f64, turning: &str) -> String {
        let letter = self.axis.letter();
        format!("TOOL CALL {number} {letter} S{speed} F300\nL {letter}+150 R0 FMAX {turning}\n")
    }

    /// A program around tool calls, definitions and calls.
    pub(super) fn program(&self, body: &str) -> String {
        let (min, max) = (self.at(-HALF, -HALF, self.surface - HEIGHT), self.at(HALF, HALF, self.surface));
        let letter = self.axis.letter();
        format!(
            "BEGIN PGM LAW MM\nBLK FORM 0.1 {letter} X{:+} Y{:+} Z{:+}\nBLK FORM 0.2 X{:+} Y{:+} Z{:+}\n{}{body}\
             L {letter}+150 R0 FMAX M30\nEND PGM LAW MM\n",
            min.x,
            min.y,
            min.z,
            max.x,
            max.y,
            max.z,
            self.changed()
        )
    }

    pub(super) fn scene(&self, tools: &str) -> String {
        let start = self.at(0.0, 0.0, 150.0);
        format!("scene: 1\nstart: [{}, {}, {}]\ntools: [{tools}]\n", start.x, start.y, start.z)
    }

    pub(super) fn cylinder(&self, place: DVec2, from: f64, to: f64, radius: f64) -> Shape {
        let place = self.seen(place);
        Shape::Cylinder { from: self.at(place.x, place.y, from), to: self.at(place.x, place.y, to), radius }
    }

    /// A hole with a flat ground, open above.
    pub(super) fn hole(&self, place: DVec2, floor: f64, radius: f64) -> Shape {
        self.cylinder(place, self.surface + 60.0, floor, radius)
    }

    /// The blank without some shapes.
    pub(super) fn part(&self, holes: Vec<Shape>) -> Shape {
        let min = self.at(-HALF, -HALF, self.surface - HEIGHT);
        let mut shapes = vec![Shape::Box { min, max: self.at(HALF, HALF, self.surface) }];
        shapes.extend(holes);
        Shape::Difference(shapes)
    }

    /// Machines and asks for what every run must keep to: it ends, nothing is found, no volume is lost.
    pub(super) fn machined(&self, body: &str, scene: &str, resolution: f64) -> Result<Made, TestCaseError> {
        let program = self.program(body);
        let text = format!("\n{program}\n{scene}");
        let (outcome, events, stock, report) = machine(&program, scene, resolution);
        prop_assert_eq!(outcome.status, Status::Done, "{:?}{}", outcome.fault, text);
        prop_assert!(report.findings.is_empty(), "{:?}{}", report.findings, text);
        prop_assert!((report.blank - report.removed - stock.volume()).abs() < 1e-4, "volumes{}", text);
        Ok(Made { stock, report, events, text })
    }
}

impl Made {
    /// The part is this one, and no step was deeper.
    pub(super) fn is(&self, part: &Shape, deepest: f64) -> Result<(), TestCaseError> {
        let deviation = self.stock.compare(part, NEAR).expect("a comparison");
        prop_assert!(deviation.is_none(), "{:?}{}", deviation, self.text);
        let depth = self.report.depth;
        prop_assert!(depth.value <= deepest + 1e-6, "{:?} is deeper than {}{}", depth, deepest, self.text);
        Ok(())
    }

    /// The part has nothing more than one and lacks nothing of another one.
    pub(super) fn is_between(&self, most: &Shape, least: &Shape) -> Result<(), TestCaseError> {
        let more = self.stock.compare(most, NEAR).expect("a comparison");
        prop_assert!(more.left_over.is_none(), "{:?}{}", more, self.text);
        let less = self.stock.compare(least, NEAR).expect("a comparison");
        prop_assert!(less.gouged.is_none(), "{:?}{}", less, self.text);
        Ok(())
    }

    /// The events of a cycle.
    pub(super) fn of_cycle(&self, cycle: u32) -> impl Iterator<Item = &Event> {
        self.events.iter().filter(move |event| of_cycle(event, cycle))
    }

    pub(super) fn threads(&self) -> Vec<Threaded> {
        threads(&self.events)
    }
}

pub(super) fn of_cycle(event: &Event, cycle: u32) -> bool {
    event.at.cycle.as_ref().is_some_and(|(key, _)| key.number == cycle)
}

pub(super) fn threads(events: &[Event]) -> Vec<Threaded> {
    let thread = |event: &Event| match &event.kind {
        EventKind::Thread(thread) => Some(*thread),
        _ => None,
    };
    events.iter().filter_map(thread).collect()
}

/// Height, feed and way of each move: `true` at rapid traverse.
pub(super) fn heights<'a>(setup: &Setup, events: impl Iterator<Item = &'a Event>) -> Vec<(f64, f64, bool)> {
    let axis = setup.axis;
    let moved = |event: &Event| match &event.kind {
        EventKind::Move { kind, to, feed, .. } => Some((axis.of(*to), *feed, *kind == MoveKind::Rapid)),
        _ => None,
    };
    events.filter_map(moved).collect()
}

/// The parameters of a cycle: numbers and values.
pub(super) fn definition(cycle: u32, values: &[(u16, f64)]) -> String {
    values.iter().fold(format!("CYCL DEF {cycle}\n"), |mut text, (q, value)| {
        let _ = writeln!(text, "Q{q}={value:+}");
        text
    })
}

/// Drilling in one infeed with the drill of tool 2.
pub(super) fn pre_drilled(setup: &Setup, place: DVec2, depth: f64) -> String {
    let values = [
        (200, setup.clearance),
        (201, -depth),
        (206, 250.0),
        (202, depth),
        (210, 0.0),
        (203, setup.surface),
        (204, 40.0),
        (211, 0.0),
    ];
    setup.tool(2, 2000.0, "M3") + &definition(200, &values) + &setup.calls(&[place])
}

pub(super) fn places() -> impl Strategy<Value = Vec<DVec2>> {
    prop::collection::vec((-15.0..15.0, -15.0..15.0).prop_map(DVec2::from), 1..3)
}
