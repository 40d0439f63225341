//! Laws of the tool setter: whatever tool and setter the scene has, the entries and parameters are what is true.
use std::fmt::Write as _;

use ciklo::base::diag::Source;
use ciklo::base::expr::QRef;
use ciklo::engine::run::{Content, Engine, Event, EventKind, NoTexts, Outcome, Status};
use ciklo::engine::scene::Scene;
use ciklo::program::syntax;
use proptest::prelude::*;

use crate::built::{Built, built};
use crate::cases::config;

/// What is calculated here and by the engine may differ by so much, mm.
const SAME: f64 = 1e-6;

fn mm(range: std::ops::Range<f64>) -> impl Strategy<Value = f64> {
    range.prop_map(|value| (value * 1000.0).round() / 1000.0)
}

/// A tool and a setter.
#[derive(Clone, Debug)]
struct Shop {
    length: f64,
    radius: f64,
    /// By how much each edge differs in length and radius.
    edges: Vec<(f64, f64)>,
    first: f64,
    /// Half of its width, as a share of the tool radius.
    share: f64,
    cube: bool,
    at: (f64, f64, f64),
}

prop_compose! {
    fn shop()(
        length in mm(50.0..180.0), radius in mm(4.0..40.0), edges in prop::collection::vec((mm(-0.6..0.6), mm(-0.4..0.4)), 1..7),
        first in mm(0.0..360.0), share in 0.2..0.7_f64, cube in any::<bool>(), at in (mm(-300.0..300.0), mm(-300.0..300.0), mm(-200.0..100.0)),
    ) -> Shop {
        Shop { length, radius, edges, first, share, cube, at }
    }
}

impl Shop {
    /// So small that no neighbour of an edge is over the face, nor over a corner of it.
    fn half(&self) -> f64 {
        let corner = if self.cube { std::f64::consts::SQRT_2 } else { 1.0 };
        (self.radius * self.share / corner * 100.0).round() / 100.0
    }

    fn scene(&self, aside: Option<f64>) -> String {
        let mut edges = String::new();
        for (long, wide) in &self.edges {
            let _ = write!(edges, "{{length: {}, radius: {}}}, ", self.length + long, self.radius + wide);
        }
        let face = if self.cube { "cube" } else { "diameter" };
        let aside = aside.map_or_else(String::new, |aside| format!(", R-OFFS: {aside}"));
        format!(
            "scene: 1\nmachine_parameters: {{probingFeed: 100, maxPeriphSpeedMeas: 129, measureTolerance1: 0.005, \
             offsetToolAxis: 3, safetyDistStylus: 5}}\ntool_setter: {{at: [{}, {}, {}], {face}: {}}}\n\
             tools: [{{T: 1, L: {}, R: {}, CUT: {}, LTOL: 0.1, LBREAK: 0.3, RTOL: 0.1, RBREAK: 0.3, edges: [{edges}], \
             first_edge: {}{aside}}}]\nstart: [0, 0, 250]\n",
            self.at.0,
            self.at.1,
            self.at.2,
            2.0 * self.half(),
            self.length,
            self.radius,
            self.edges.len(),
            self.first,
        )
    }
}

fn run(scene: &str, program: &str) -> Result<(Outcome, Vec<Event>), TestCaseError> {
    let Built { files, catalogue, .. } = built();
    let on = catalogue.on("tnc640").expect("a control");
    let scene = Scene::parse(&Source::new("scene.yaml", scene), files).expect("a scene");
    let tree = syntax::parse(&Source::new("LAW.H", program));
    let mut events = Vec::new();
    let outcome = Engine::new(&tree, on, &scene, &NoTexts).run(&mut |event| events.push(event));
    prop_assert_eq!(outcome.status, Status::Done, "{:?}", outcome.fault);
    Ok((outcome, events))
}

/// The last number that was written into a column.
fn written(events: &[Event], wanted: &str) -> Option<f64> {
    events.iter().rev().find_map(|event| match &event.kind {
        EventKind::Table { column, value: Content::Number(value), .. } if column == wanted => Some(*value),
        _ => None,
    })
}

fn near(found: Option<f64>, wanted: f64) -> Result<(), TestCaseError> {
    prop_assert!(found.is_some_and(|found| (found - wanted).abs() < SAME), "{:?} and not {}", found, wanted);
    Ok(())
}

fn measure(cycle: u32, check: u8, teeth: u8) -> String {
    format!("TOOL CALL 1 Z\nTCH PROBE {cycle}\nQ340={check}\nQ260=220\nQ341={teeth}\n")
}

fn greatest(values: impl Iterator<Item = f64>) -> f64 {
    values.fold(f64::NEG_INFINITY, f64::max)
}

/// The value that is farthest from 0.
fn worst(values: impl Iterator<Item = f64>) -> f64 {
    values.fold(0.0, |worst: f64, value| if value.abs() > worst.abs() { value } else { worst })
}

/// 0 within the wear tolerance of 0.1, 1 worn, 2 broken: beyond 0.3.
fn status(deviations: &[f64]) -> f64 {
    let far = greatest(deviations.iter().map(|value| value.abs()));
    if far > 0.3 {
        2.0
    } else if far > 0.1 {
        1.0
    } else {
        0.0
    }
}

proptest! {
    #![proptest_config(config(150))]

    #[test]
    fn a_turning_tool_has_its_longest_and_its_widest_edge(shop in shop(), standing in any::<bool>()) {
        let aside = standing.then_some(0.0);
        let (_, events) = run(&shop.scene(aside), &measure(483, 0, 0))?;
        near(written(&events, "L"), shop.length + greatest(shop.edges.iter().map(|edge| edge.0)))?;
        near(written(&events, "R"), shop.radius + greatest(shop.edges.iter().map(|edge| edge.1)))?;
        near(written(&events, "DL"), 0.0)?;
        near(written(&events, "DR"), 0.0)?;
    }

    #[test]
    fn edge_by_edge_the_one_that_differs_most_decides(shop in shop()) {
        let (outcome, events) = run(&shop.scene(None), &measure(483, 1, 1))?;
        let (long, wide) = (worst(shop.edges.iter().map(|edge| edge.0)), worst(shop.edges.iter().map(|edge| edge.1)));
        // Of two edges that differ by the same either way, either may decide.
        let far = |value: Option<f64>| value.map(f64::abs);
        near(far(written(&events, "DL")), long.abs())?;
        near(far(written(&events, "DR")), wide.abs())?;
        near(outcome.params.number(QRef::q(115)).ok(), written(&events, "DL").unwrap_or(f64::NAN))?;
        near(outcome.params.number(QRef::q(116)).ok(), written(&events, "DR").unwrap_or(f64::NAN))?;
        // A deviation at a tolerance is on either side of it by rounding.
        prop_assume!([long, wide].iter().all(|value| (value.abs() - 0.1).abs() > SAME && (value.abs() - 0.3).abs() > SAME));
        near(outcome.params.number(QRef::q(199)).ok(), status(&[long, wide]))?;
    }

    #[test]
    fn after_a_calibration_it_does_not_matter_where_the_setter_is_believed(
        shop in shop(), off in (mm(-1.5..1.5), mm(-1.5..1.5), mm(-2.0..2.0)), misaligned in (mm(-0.2..0.2), mm(-0.2..0.2)), pushed in mm(0.0..0.2),
        half in mm(6.0..25.0),
    ) {
        let scene = shop.scene(None).replace(
            "machine_parameters: {",
            &format!("machine_parameters: {{centerPos: [{}, {}, {}], ", shop.at.0 + off.0, shop.at.1 + off.1, shop.at.2 + off.2),
        );
        let face = if shop.cube { "cube" } else { "diameter" };
        let before = format!("{face}: {}}}", 2.0 * shop.half());
        let scene = scene.replace(&before, &format!("{face}: {}, pre_travel: {pushed}}}", 2.0 * half)).replace(
            "tools: [",
            &format!("tools: [{{T: 9, L: 90, R: 10, CUT: 0, misaligned: [{}, {}]}}, ", misaligned.0, misaligned.1),
        );
        let program = format!("TOOL CALL 9 Z\nTCH PROBE 480\nQ260=220\n{}", measure(483, 0, 0));
        let (_, events) = run(&scene, &program)?;
        near(written(&events, "L"), shop.length + greatest(shop.edges.iter().map(|edge| edge.0)))?;
        near(written(&events, "R"), shop.radius + greatest(shop.edges.iter().map(|edge| edge.1)))?;
    }
}
