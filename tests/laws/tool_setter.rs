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

laws! {
    #![proptest_config(config(50))]

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

laws! {
    #![proptest_config(config(50))]

    /// A fork head that is turned so that the tool is along the setter, wherever that faces: in a plane that is tilted
    /// there, and with the head turned about the vertical axis only.
    #[test]
    fn a_tilted_head_measures_a_setter_that_faces_it(
        shop in shop(), tilt in mm(-100.0..100.0), only_turned in any::<bool>(), teeth in any::<bool>(),
        misaligned in (mm(-0.2..0.2), mm(-0.2..0.2)), off in (mm(-0.1..0.1), mm(-0.1..0.1), mm(-0.1..0.1)),
    ) {
        let shop = Shop { cube: shop.cube && !only_turned, ..shop };
        let plain = shop.scene(None).replace("scene: 1\n", "scene: 1\nmachine: mill-head-ac\n");
        let rotate = if only_turned { String::new() } else { format!("rotate: [{tilt}, 0, 0], ") };
        let face = if shop.cube { "cube" } else { "diameter" };
        let before = format!("{face}: {}}}", 2.0 * shop.half());
        let scene = plain
            .replace("tool_setter: {", &format!("tool_setter: {{{rotate}"))
            .replace(&before, &format!("{face}: {}, pre_travel: 0.1}}", 2.0 * shop.half()))
            .replace(
                "machine_parameters: {",
                &format!("machine_parameters: {{centerPos: [{}, {}, {}], ", shop.at.0 + off.0, shop.at.1 + off.1, shop.at.2 + off.2),
            )
            .replace("tools: [", &format!("tools: [{{T: 9, L: 90, R: 10, CUT: 0, misaligned: [{}, {}]}}, ", misaligned.0, misaligned.1));
        let turn = if only_turned { format!("L C{tilt:+} R0 FMAX\n") } else { format!("PLANE SPATIAL SPA{tilt:+} SPB+0 SPC+0 TURN FMAX\n") };
        let (check, one_by_one) = if teeth { (1, 1) } else { (0, 0) };
        // A longer tool needs room along the tilted axis.
        let program = format!(
            "TOOL CALL 9 Z\n{turn}TCH PROBE 480\nQ260=100\nL IZ+150 R0 FMAX\nTOOL CALL 1 Z\nTCH PROBE 483\nQ340={check}\nQ260=100\nQ341={one_by_one}\n"
        );
        let (_, events) = run(&scene, &program)?;
        if teeth {
            let (long, wide) = (worst(shop.edges.iter().map(|edge| edge.0)), worst(shop.edges.iter().map(|edge| edge.1)));
            near(written(&events, "DL").map(f64::abs), long.abs())?;
            near(written(&events, "DR").map(f64::abs), wide.abs())?;
        } else {
            near(written(&events, "L"), shop.length + greatest(shop.edges.iter().map(|edge| edge.0)))?;
            near(written(&events, "R"), shop.radius + greatest(shop.edges.iter().map(|edge| edge.1)))?;
        }
    }
}

/// A head that is not quite as its model says: what of it is wrong.
#[derive(Clone, Copy, Debug)]
struct Astray {
    /// The line about which A turns is beside that of the model, mm, and out of its direction about Y or Z, degrees.
    centre: [f64; 3],
    askew: f64,
    about_z: bool,
    /// A stops beside where it should, degrees.
    beside: f64,
    drift: [f64; 3],
}

prop_compose! {
    fn astray()(
        centre in (mm(-0.1..0.1), mm(-0.1..0.1), mm(-0.1..0.1)), askew in mm(-0.2..0.2), about_z in any::<bool>(), beside in mm(-0.1..0.1),
        drift in (mm(-0.05..0.05), mm(-0.05..0.05), mm(-0.05..0.05)),
    ) -> Astray {
        Astray { centre: centre.into(), askew, about_z, beside, drift: drift.into() }
    }
}

/// What a vector is after a turn about an axis of length 1 by so many degrees.
fn turned_about(axis: [f64; 3], by: f64, v: [f64; 3]) -> [f64; 3] {
    let (s, c) = by.to_radians().sin_cos();
    let along: f64 = (0..3).map(|i| axis[i] * v[i]).sum();
    let cross = [axis[1] * v[2] - axis[2] * v[1], axis[2] * v[0] - axis[0] * v[2], axis[0] * v[1] - axis[1] * v[0]];
    [0, 1, 2].map(|i| v[i] * c + cross[i] * s + axis[i] * along * (1.0 - c))
}

impl Astray {
    /// The true tool axis seen from a setter that faces the tool as the model says, and by how much the point about
    /// which the head swivels is displaced.
    fn seen(&self, tilt: f64) -> ([f64; 3], [f64; 3]) {
        let (s, c) = self.askew.to_radians().sin_cos();
        let line = if self.about_z { [c, s, 0.0] } else { [c, 0.0, -s] };
        let truly = |v: [f64; 3]| turned_about(line, tilt + self.beside, v);
        let from_setter = |v: [f64; 3]| turned_about([1.0, 0.0, 0.0], -tilt, v);
        let back = truly(self.centre);
        let displaced = [0, 1, 2].map(|i| self.drift[i] + self.centre[i] - back[i]);
        (from_setter(truly([0.0, 0.0, 1.0])), from_setter(displaced))
    }
}

/// From the point about which the head of `mill-head-ac` swivels to the spindle nose.
const PIVOT: f64 = 150.0;

laws! {
    #![proptest_config(config(40))]

    /// The control reckons with its model while tool and head are as they are: a cylinder that leans is longer by its
    /// lower rim, and its side is touched by its rim or by that of the setter.
    #[test]
    fn a_head_with_errors_measures_what_its_model_makes_of_it(
        length in mm(50.0..180.0), radius in mm(4.0..20.0), long in mm(-0.6..0.6), wide in mm(-0.4..0.4), tilt in mm(-100.0..100.0),
        wrong in astray(), teeth in any::<bool>(),
    ) {
        let half = radius + 4.0;
        let (true_length, true_radius) = (length + long, radius + wide);
        let edge = format!("{{length: {true_length}, radius: {true_radius}}}");
        let edges = if teeth { format!("{edge}, {edge}, {edge}") } else { edge };
        let askew = if wrong.about_z { [0.0, 0.0, wrong.askew] } else { [0.0, wrong.askew, 0.0] };
        let scene = format!(
            "scene: 1\nmachine: mill-head-ac\nkinematics: {{errors: [{{axis: A, centre: {:?}, askew: {askew:?}, scatter: [{}]}}], drift: {:?}}}\n\
             machine_parameters: {{probingFeed: 100, maxPeriphSpeedMeas: 129, measureTolerance1: 0.005, offsetToolAxis: 3, safetyDistStylus: 5}}\n\
             tool_setter: {{at: [100, 50, -100], rotate: [{tilt}, 0, 0], cube: {}}}\n\
             tools: [{{T: 1, L: {length}, R: {radius}, R-OFFS: 0, CUT: {}, edges: [{edges}]}}]\nstart: [0, 0, 250]\n",
            wrong.centre, wrong.beside, wrong.drift, 2.0 * half, if teeth { 3 } else { 0 },
        );
        let program = |cycle: u32| format!(
            "TOOL CALL 1 Z\nPLANE SPATIAL SPA{tilt:+} SPB+0 SPC+0 TURN FMAX\nTCH PROBE {cycle}\nQ340=0\nQ260=100\nQ341=0\n"
        );
        let (axis, displaced) = wrong.seen(tilt);
        // Touching from above, the tip that the control knows is over the centre of the face.
        if !teeth {
            let (_, events) = run(&scene, &program(481))?;
            let rim = true_radius * axis[0].hypot(axis[1]);
            near(written(&events, "L"), (PIVOT + true_length) * axis[2] - PIVOT - displaced[2] + rim)?;
        }
        // From the side it is 3 below the face; the middle of the true tool end, but for the way across:
        let (_, events) = run(&scene, &program(482))?;
        let known = [0.0, 0.0, -3.0 + length + PIVOT];
        let end = [0, 1, 2].map(|i| known[i] + displaced[i] - axis[i] * (PIVOT + true_length));
        let foremost = if axis[0] >= 0.0 {
            end[0] - true_radius * (1.0 - axis[0] * axis[0]).sqrt()
        } else {
            let lean = axis[0] / axis[2];
            end[0] - lean * end[2] - true_radius * 1.0_f64.hypot(lean)
        };
        near(written(&events, "R"), -foremost)?;
    }
}

/// The tool of a scene with more columns.
fn with_columns(scene: &str, columns: &str) -> String {
    scene.replace("LTOL: 0.1,", &format!("LTOL: 0.1, {columns},"))
}

laws! {
    #![proptest_config(config(50))]

    /// Ball and bull-nose cutters as the tool table has them: put aside by R-OFFS so that their lowest point meets the
    /// face, and by L-OFFS so deep that their widest point meets the side (001:14899-14922).
    #[test]
    fn a_rounded_end_does_not_matter(shop in shop(), share in 0.1..1.0_f64, ball in any::<bool>()) {
        let corner = if ball { shop.radius } else { (shop.radius * share * 1000.0).round() / 1000.0 };
        let scene = shop.scene(Some(shop.radius - corner));
        let scene = with_columns(&scene, &format!("R2: {corner}, L-OFFS: {corner}"));
        let (_, events) = run(&scene, &measure(483, 0, 0))?;
        near(written(&events, "L"), shop.length + greatest(shop.edges.iter().map(|edge| edge.0)))?;
        near(written(&events, "R"), shop.radius + greatest(shop.edges.iter().map(|edge| edge.1)))?;
    }

    /// A tool that runs out is as wide as the circle that it cuts.
    #[test]
    fn a_turning_tool_that_runs_out_is_wider_by_it(shop in shop(), out in (mm(-0.2..0.2), mm(-0.2..0.2))) {
        let scene = shop.scene(None).replace("first_edge:", &format!("misaligned: [{}, {}], first_edge:", out.0, out.1));
        let (_, events) = run(&scene, &measure(483, 0, 0))?;
        near(written(&events, "L"), shop.length + greatest(shop.edges.iter().map(|edge| edge.0)))?;
        near(written(&events, "R"), shop.radius + greatest(shop.edges.iter().map(|edge| edge.1)) + out.0.hypot(out.1))?;
    }

    /// A trigger that comes late by the same each time makes tools shorter and narrower by that.
    #[test]
    fn a_late_trigger_is_found_as_if_the_tool_was_smaller(shop in shop(), late in mm(0.0..0.02)) {
        let face = if shop.cube { "cube" } else { "diameter" };
        let before = format!("{face}: {}}}", 2.0 * shop.half());
        let scene = shop.scene(None).replace(&before, &format!("{face}: {}, scatter: [{late}]}}", 2.0 * shop.half()));
        let (_, events) = run(&scene, &measure(483, 0, 0))?;
        near(written(&events, "L"), shop.length + greatest(shop.edges.iter().map(|edge| edge.0)) - late)?;
        near(written(&events, "R"), shop.radius + greatest(shop.edges.iter().map(|edge| edge.1)) - late)?;
    }

    /// A setter without a cable has no place that the control knows: the operator puts the calibration tool over it.
    #[test]
    fn a_setter_that_is_placed_by_hand_is_found(
        shop in shop(), beside in (mm(-1.0..1.0), mm(-1.0..1.0)), above in mm(0.5..4.5), misaligned in (mm(-0.2..0.2), mm(-0.2..0.2)),
        pushed in mm(0.0..0.2), half in mm(6.0..25.0),
    ) {
        let face = if shop.cube { "cube" } else { "diameter" };
        let before = format!("{face}: {}}}", 2.0 * shop.half());
        let at = (shop.at.0 + beside.0, shop.at.1 + beside.1, shop.at.2 + above);
        let scene = shop
            .scene(None)
            .replace(&before, &format!("{face}: {}, pre_travel: {pushed}}}", 2.0 * half))
            .replace("start: [0, 0, 250]", &format!("start: [{}, {}, {}]\nanswers: [continue]", at.0, at.1, at.2))
            .replace("tools: [", &format!("tools: [{{T: 9, L: 90, R: 10, CUT: 0, misaligned: [{}, {}]}}, ", misaligned.0, misaligned.1));
        let program = format!("TOOL CALL 9 Z\nTCH PROBE 484\n{}", measure(483, 0, 0));
        let (_, events) = run(&scene, &program)?;
        near(written(&events, "L"), shop.length + greatest(shop.edges.iter().map(|edge| edge.0)))?;
        near(written(&events, "R"), shop.radius + greatest(shop.edges.iter().map(|edge| edge.1)))?;
    }
}

/// The radius is measured, and the length is not found because the tool is put aside too far: the table of tools is what
/// it was.
#[test]
fn a_fault_in_the_middle_writes_no_table() {
    let scene = "scene: 1\nmachine_parameters: {probingFeed: 100, maxPeriphSpeedMeas: 129, measureTolerance1: 0.005, offsetToolAxis: 3, \
        safetyDistStylus: 5}\ntool_setter: {at: [0, 0, 0], diameter: 20}\n\
        tools: [{T: 1, L: 80, R: 5, CUT: 2, R-OFFS: 60, edges: [{length: 80.1, radius: 5.1}, {length: 80, radius: 5}]}]\nstart: [0, 0, 250]\n";
    let Built { files, catalogue, .. } = built();
    let on = catalogue.on("tnc640").expect("a control");
    let scene = Scene::parse(&Source::new("scene.yaml", scene), files).expect("a scene");
    for check in [0, 1] {
        let tree = syntax::parse(&Source::new("LAW.H", measure(483, check, 0)));
        let (mut touched, mut wrote) = (0, 0);
        let outcome = Engine::new(&tree, on, &scene, &NoTexts).run(&mut |event| match &event.kind {
            EventKind::Probe(probing) => touched += usize::from(probing.contact.is_some()),
            EventKind::Table { .. } => wrote += 1,
            _ => {}
        });
        assert_eq!(outcome.fault.map(|fault| fault.code.into_owned()).as_deref(), Some("probe-no-contact"));
        assert_eq!((touched, wrote, outcome.tables.len()), (1, 0, 0));
    }
}

/// While it is measured a tool turns against its cutting direction: one that cuts with M4 (DIRECT. +) with M3.
#[test]
fn a_tool_turns_against_its_cutting_direction() {
    let shop = Shop {
        length: 100.0,
        radius: 5.0,
        edges: vec![(0.0, 0.0), (0.0, 0.0)],
        first: 0.0,
        share: 0.5,
        cube: false,
        at: (100.0, 0.0, 0.0),
    };
    for (column, wanted) in [("DIRECT.: '-'", -1), ("DIRECT.: '+'", 1)] {
        let (_, events) = run(&with_columns(&shop.scene(None), column), &measure(483, 1, 0)).expect("it is measured");
        let turned = events.iter().filter_map(|event| match event.kind {
            EventKind::Spindle { direction, speed, orient: None, tool: None, .. } if speed > 0.0 => Some(direction),
            _ => None,
        });
        let turned: Vec<i8> = turned.filter(|direction| *direction != 0).collect();
        assert!(!turned.is_empty() && turned.iter().all(|direction| *direction == wanted), "{column}: {turned:?}");
    }
}

/// Speed and feed while the tool turns, by the formulas of the manual (001:14853-14897): the form, the radius, and the
/// tolerance in multiples of the least one.
#[test]
fn the_feed_keeps_the_tolerance_that_each_form_allows() {
    let forms: [(&str, &str, fn(f64) -> f64); 3] = [
        ("ConstantTolerance", "0", |_| 1.0),
        ("VariableTolreance", "1", |radius| {
            if radius <= 30.0 {
                1.0
            } else if radius <= 60.0 {
                2.0
            } else if radius <= 90.0 {
                3.0
            } else {
                4.0
            }
        }),
        ("ConstantFeed", "2", |radius| radius / 5.0),
    ];
    let Built { files, catalogue, .. } = built();
    let (greatest, least) = (120.0, 0.004);
    for (word, number, multiple) in forms {
        for radius in [4.0, 29.0, 30.0, 31.0, 60.0, 61.0, 90.0, 91.0, 118.0] {
            let of_control = [
                (
                    "tnc640",
                    format!(
                        "probingFeed: 100, maxPeriphSpeedMeas: {greatest}, measureTolerance1: {least}, offsetToolAxis: 3, safetyDistStylus: 5, probingFeedCalc: {word}"
                    ),
                ),
                (
                    "itnc530",
                    format!("MP6520: 100, MP6570: {greatest}, MP6510: {least}, MP6530: 3, MP6540: 5, MP6507: {number}"),
                ),
            ];
            for (control, parameters) in of_control {
                let scene = format!(
                    "scene: 1\nmachine_parameters: {{{parameters}}}\ntool_setter: {{at: [0, 0, -50], diameter: 2}}\n\
                     tools: [{{T: 1, L: 80, R: {radius}, CUT: 2, LTOL: 0.1, RTOL: 0.1}}]\nstart: [0, 0, 100]\n"
                );
                let scene = Scene::parse(&Source::new("scene.yaml", scene), files).expect("a scene");
                let tree = syntax::parse(&Source::new("LAW.H", measure(482, 1, 0)));
                let (mut speeds, mut feeds) = (Vec::new(), Vec::new());
                let on = catalogue.on(control).expect("a control");
                let outcome = Engine::new(&tree, on, &scene, &NoTexts).run(&mut |event| match event.kind {
                    EventKind::Spindle { direction: -1, speed, .. } => speeds.push(speed),
                    EventKind::Probe(probing) => feeds.push(probing.feed),
                    _ => {}
                });
                assert_eq!(outcome.status, Status::Done, "{control} {word} {radius}: {:?}", outcome.fault);
                let speed = greatest / (radius * 0.0063);
                let feed = multiple(radius) * least * speed;
                assert!(!feeds.is_empty() && !speeds.is_empty(), "{control} {word} {radius}");
                assert!(
                    speeds.iter().all(|found| (found - speed).abs() < 1e-9),
                    "{control} {word} {radius}: {speeds:?}, not {speed}"
                );
                assert!(
                    feeds.iter().all(|found| (found - feed).abs() < 1e-9),
                    "{control} {word} {radius}: {feeds:?}, not {feed}"
                );
            }
        }
    }
}

/// The form of a tool: how wide it is at a height above its lowest point.
#[derive(Clone, Copy, Debug)]
enum Form {
    Flat,
    Corner(f64),
    Point(f64),
}

fn width(form: Form, radius: f64, height: f64) -> f64 {
    match form {
        Form::Corner(corner) if height < corner => {
            radius - corner + (corner * corner - (corner - height) * (corner - height)).sqrt()
        }
        Form::Point(angle) => radius.min(height * (angle / 2.0).to_radians().tan()),
        _ => radius,
    }
}

laws! {
    #![proptest_config(config(150))]

    /// Against samples of the way: a tool that gets into the setter is a collision, whatever its form, and no other one.
    #[test]
    fn a_tool_that_gets_into_the_setter_collides(
        from in (mm(-80.0..80.0), mm(-80.0..80.0), mm(-40.0..40.0)), to in (mm(-80.0..80.0), mm(-80.0..80.0), mm(-40.0..40.0)),
        radius in mm(2.0..25.0), which in 0..3_u8, share in 0.1..1.0_f64, longer in mm(-2.0..2.0), half in mm(5.0..30.0),
        cube in any::<bool>(), feed in any::<bool>(),
    ) {
        let form = match which {
            0 => Form::Flat,
            1 => Form::Corner((radius * share * 1000.0).round() / 1000.0),
            _ => Form::Point((30.0 + 140.0 * share).round()),
        };
        let column = match form {
            Form::Flat => String::new(),
            Form::Corner(corner) => format!(", R2: {corner}"),
            Form::Point(angle) => format!(", T-ANGLE: {angle}"),
        };
        let face = if cube { "cube" } else { "diameter" };
        let scene = format!(
            "scene: 1\ntool_setter: {{at: [0, 0, 0], {face}: {}}}\ntools: [{{T: 1, L: 80, R: {radius}{column}, edges: [{{length: {}, radius: {radius}}}]}}]\n\
             start: [{}, {}, {}]\n",
            2.0 * half, 80.0 + longer, from.0, from.1, from.2
        );
        let speed = if feed { "F500" } else { "FMAX" };
        let program = format!("TOOL CALL 1 Z S100\nL X{:+} Y{:+} Z{:+} R0 {speed}\n", to.0, to.1, to.2);
        let depth = |share: f64| {
            let at = |a: f64, b: f64| a + (b - a) * share;
            let (x, y, above) = (at(from.0, to.0), at(from.1, to.1), at(from.2, to.2) - longer);
            let beside = if cube { (x.abs() - half).max(0.0).hypot((y.abs() - half).max(0.0)) } else { (x.hypot(y) - half).max(0.0) };
            // Its lowest point is so far below the face.
            let below = -above;
            (beside - width(form, radius, below.max(0.0))).max(-below)
        };
        let least = (0..=4000).map(|k| depth(f64::from(k) / 4000.0)).fold(f64::INFINITY, f64::min);
        // Samples lie up to 0.05 apart.
        prop_assume!(least.abs() > 0.2);
        let Built { files, catalogue, .. } = built();
        let on = catalogue.on("tnc640").expect("a control");
        let scene = Scene::parse(&Source::new("scene.yaml", scene), files).expect("a scene");
        let tree = syntax::parse(&Source::new("LAW.H", program));
        let outcome = Engine::new(&tree, on, &scene, &NoTexts).run(&mut |_| {});
        let code = outcome.fault.as_ref().map(|fault| fault.code.to_string());
        let wanted = (least < 0.0).then(|| "tool-setter-collision".to_owned());
        prop_assert_eq!(code, wanted, "{} mm", least);
    }
}
