//! Laws of measuring the rotary axes: whatever machine, sphere and positions, what is found is what is wrong with the
//! machine, and a second measurement finds nothing.
use std::fmt::Write as _;

use ciklo::base::diag::Source;
use ciklo::base::expr::QRef;
use ciklo::engine::machine::Machine;
use ciklo::engine::run::{Engine, EventKind, Outcome, Status};
use ciklo::engine::scene::Scene;
use ciklo::program::syntax;
use ciklo::tools::conform::LogTexts;
use proptest::prelude::*;

use crate::built::{Built, built};
use crate::cases::config;

/// What is found may differ from what is wrong by so much, mm and degrees.
const SAME: f64 = 1e-6;

fn of(range: std::ops::Range<f64>) -> impl Strategy<Value = f64> {
    range.prop_map(|value| (value * 1000.0).round() / 1000.0)
}

/// An axis of a machine: letter, what it carries, the axis of the machine about which it turns, how far it goes.
type Axis = (char, &'static str, usize, f64);

/// Machines of one and of two rotary axes, of table and head.
const MACHINES: &[&[Axis]] = &[
    &[('C', "workpiece", 2, 359.0)],
    &[('A', "workpiece", 0, 120.0)],
    &[('A', "workpiece", 0, 110.0), ('C', "workpiece", 2, 359.0)],
    &[('B', "workpiece", 1, 110.0), ('C', "workpiece", 2, 359.0)],
    &[('B', "tool", 1, 100.0)],
    &[('C', "tool", 2, 300.0), ('A', "tool", 0, 100.0)],
    &[('C', "workpiece", 2, 359.0), ('B', "tool", 1, 100.0)],
];

/// What is wrong with an axis, and how it is measured.
#[derive(Clone, Copy, Debug)]
struct Wrong {
    centre: [f64; 3],
    askew: [f64; 3],
    /// The first and the last angle, as shares of how far it goes.
    range: (f64, f64),
    points: u32,
    /// Where it is while the other is measured, as a share.
    incidence: f64,
}

#[derive(Clone, Debug)]
struct Shop {
    machine: usize,
    axes: [Wrong; 2],
    sphere: [f64; 3],
    centre: [f64; 3],
    radius: f64,
    touched: u32,
    reference: f64,
    retracts: bool,
    drift: [f64; 3],
}

prop_compose! {
    fn wrong()(
        x in of(-0.3..0.3), y in of(-0.3..0.3), z in of(-0.3..0.3), a in of(-0.03..0.03), b in of(-0.03..0.03), c in of(-0.03..0.03),
        start in -1.0..1.0_f64, end in -1.0..1.0_f64, points in 1_u32..6, incidence in -0.8..0.8_f64,
    ) -> Wrong {
        Wrong { centre: [x, y, z], askew: [a, b, c], range: (start, end), points, incidence }
    }
}

prop_compose! {
    fn shop()(
        machine in 0..MACHINES.len(), axes in [wrong(), wrong()], x in of(-200.0..200.0), y in of(-200.0..200.0), z in of(-150.0..0.0),
        at in (of(-50.0..50.0), of(-50.0..50.0), of(-80.0..80.0)), radius in of(8.0..25.0), touched in 3_u32..9, reference in of(0.0..360.0),
        retracts in any::<bool>(), drift in (of(-0.2..0.2), of(-0.2..0.2), of(-0.2..0.2)),
    ) -> Shop {
        Shop {
            machine, axes, sphere: [x, y, z], centre: [at.0, at.1, at.2], radius, touched, reference, retracts,
            drift: [drift.0, drift.1, drift.2],
        }
    }
}

/// Without the coordinate along the axis, which nothing depends on.
fn across(mut v: [f64; 3], along: usize) -> [f64; 3] {
    v[along] = 0.0;
    v
}

impl Shop {
    fn axes(&self) -> impl Iterator<Item = (&Axis, &Wrong)> {
        MACHINES[self.machine].iter().zip(&self.axes)
    }

    fn scene(&self, askew: bool, drift: bool) -> String {
        let mut text = String::from(
            "scene: 1\nmachine:\n  machine: 1\n  name: shop\n  axes:\n    - {axis: X, min: -2000, max: 2000, rapid: 20000}\n    \
             - {axis: Y, min: -2000, max: 2000, rapid: 20000}\n    - {axis: Z, min: -2000, max: 2000, rapid: 20000}\n  pivot: 120\n  rotary:\n",
        );
        for ((letter, carries, along, far), _) in self.axes() {
            let centre = if *carries == "workpiece" { format!(", centre: {:?}", self.centre) } else { String::new() };
            let _ = along;
            let _ = writeln!(
                text,
                "    - {{axis: {letter}, carries: {carries}, min: -{far}, max: {far}, rapid: 5000{centre}}}"
            );
        }
        text.push_str("kinematics:\n  errors:\n");
        for ((letter, _, along, _), wrong) in self.axes() {
            let turned = if askew { across(wrong.askew, *along) } else { [0.0; 3] };
            let centre = across(wrong.centre, *along);
            let _ = writeln!(text, "    - {{axis: {letter}, centre: {centre:?}, askew: {turned:?}}}");
        }
        if drift {
            let _ = writeln!(text, "  drift: {:?}", self.drift);
        }
        let [x, y, z] = self.sphere;
        let _ = write!(
            text,
            "tools: [{{T: 1, NAME: PROBE, L: 100, R: 2, TP_NO: 1}}]\nprobe: {{NO: 1, ball_radius: 2, SET_UP: 5, F: 300, FMAX: 3000, DIST: 20}}\n\
             presets: {{active: 1, rows: [{{NO: 1, X: {x}, Y: {y}, Z: {z}}}]}}\nparts: [{{solid: {{sphere: {{centre: [0, 0, 0], radius: {}}}}}}}]\n\
             start: [0, 0, 100]\n",
            self.radius
        );
        text
    }

    /// The call of a cycle; `first` are parameters that only that one has.
    fn call(&self, cycle: u32, first: &str) -> String {
        let mut text = format!("TCH PROBE {cycle}\n{first}");
        // Higher than the sphere ever is.
        let height = if self.retracts { 600 } else { 0 };
        let _ = write!(text, "Q407={}\nQ320=0\nQ408={height}\nQ253=2000\nQ380={}\n", self.radius, self.reference);
        for (row, letter) in ['A', 'B', 'C'].into_iter().enumerate() {
            let q = 411 + 4 * row;
            let own = self.axes().find(|(axis, _)| axis.0 == letter);
            let (start, end, incidence, points) = own.map_or((0.0, 0.0, 0.0, 0), |((.., far), wrong)| {
                let angle = |share: f64| (share * far * 10.0).round() / 10.0;
                (angle(wrong.range.0), angle(wrong.range.1), angle(wrong.incidence), wrong.points)
            });
            let _ = write!(text, "Q{q}={start}\nQ{}={end}\nQ{}={incidence}\nQ{}={points}\n", q + 1, q + 2, q + 3);
        }
        let _ = writeln!(text, "Q423={}", self.touched);
        text.push_str(if cycle == 451 { "Q431=0\nQ432=0\n" } else { "Q432=0\n" });
        text
    }

    /// Whether the positions tell clearly where the axes are: one is far from 0 and, of those that shall tell directions,
    /// two are, from it and from each other.
    fn is_told(&self, directions: bool) -> bool {
        self.axes().all(|((.., far), wrong)| {
            let (start, end) = (wrong.range.0 * far, wrong.range.1 * far);
            let steps = f64::from(wrong.points.max(2) - 1);
            let angle = |at: u32| start + (end - start) / steps * f64::from(at);
            let away = |one: f64, other: f64| {
                let apart = (one - other).rem_euclid(360.0);
                apart.min(360.0 - apart) > 15.0
            };
            let angles: Vec<f64> = (0..wrong.points).map(angle).filter(|angle| away(*angle, 0.0)).collect();
            let two = angles.iter().any(|one| angles.iter().any(|other| away(*one, *other)));
            !angles.is_empty() && (!directions || two)
        })
    }
}

fn run(control: &str, scene: &str, program: &str) -> (Outcome, Machine) {
    let Built { files, catalogue, .. } = built();
    let on = catalogue.on(control).expect("a control");
    let scene = Scene::parse(&Source::new("scene.yaml", scene), files).expect("a scene");
    let program = format!("TOOL CALL 1 Z\n{program}");
    let tree = syntax::parse(&Source::new("LAW.H", &*program));
    let texts = LogTexts::new(built().locales.source().expect("English"), on.id(), files);
    let outcome = Engine::new(&tree, on, &scene, &texts).run(&mut |_| {});
    let written = outcome
        .tables
        .iter()
        .find(|(file, _)| file == "KINEMATICS.YAML")
        .map(|(file, text)| Machine::parse(&Source::new(file.as_str(), text.as_str())).expect("a machine"));
    let machine = written.unwrap_or_else(|| scene.machine.clone());
    (outcome, machine)
}

fn done(outcome: &Outcome) -> Result<(), TestCaseError> {
    prop_assert_eq!(outcome.status, Status::Done, "{:?}", outcome.fault);
    Ok(())
}

fn number(outcome: &Outcome, q: u16) -> f64 {
    outcome.params.number(QRef::q(q)).unwrap_or(f64::NAN)
}

/// The last measurement found nothing.
fn nothing(outcome: &Outcome) -> Result<(), TestCaseError> {
    for q in 141..=149 {
        let found = number(outcome, q);
        prop_assert!(found.abs() < SAME || (found == -1.0 && q < 147), "Q{} is {}", q, found);
    }
    Ok(())
}

fn near(found: [f64; 3], wanted: [f64; 3]) -> Result<(), TestCaseError> {
    let far = found.iter().zip(wanted).map(|(found, wanted)| (found - wanted).abs()).fold(0.0, f64::max);
    prop_assert!(far < SAME, "{:?} and not {:?}", found, wanted);
    Ok(())
}

/// By how much each axis was displaced and turned.
fn changes(shop: &Shop, machine: &Machine) -> Vec<([f64; 3], [f64; 3])> {
    let found = machine.rotary.iter().map(|axis| {
        let table = axis.carries == ciklo::engine::machine::Carried::Workpiece;
        let before = if table { shop.centre } else { [0.0; 3] };
        let now = axis.centre.to_array();
        ([now[0] - before[0], now[1] - before[1], now[2] - before[2]], axis.askew.to_array())
    });
    found.collect()
}

laws! {
    #![proptest_config(config(50))]

    #[test]
    fn the_places_of_the_axes_are_found_and_then_there_is_nothing_left(shop in shop()) {
        prop_assume!(shop.is_told(false));
        let program = shop.call(451, "Q406=1\n") + &shop.call(451, "Q406=0\n");
        let (outcome, machine) = run("tnc640", &shop.scene(false, false), &program);
        done(&outcome)?;
        nothing(&outcome)?;
        for (((_, _, along, _), wrong), (found, _)) in shop.axes().zip(changes(&shop, &machine)) {
            near(found, across(wrong.centre, *along))?;
        }
    }

    #[test]
    fn a_check_finds_the_errors_and_changes_nothing(shop in shop()) {
        prop_assume!(shop.is_told(false));
        let (outcome, machine) = run("tnc640", &shop.scene(false, false), &shop.call(451, "Q406=0\n"));
        done(&outcome)?;
        let mut sum = [0.0; 3];
        for ((_, _, along, _), wrong) in shop.axes() {
            let own = across(wrong.centre, *along);
            sum = [sum[0] + own[0], sum[1] + own[1], sum[2] + own[2]];
        }
        near([number(&outcome, 147), number(&outcome, 148), number(&outcome, 149)], sum)?;
        for (found, _) in changes(&shop, &machine) {
            near(found, [0.0; 3])?;
        }
    }

    #[test]
    fn directions_and_places_are_found(shop in shop()) {
        prop_assume!(shop.is_told(true));
        let program = shop.call(451, "Q406=2\n") + &shop.call(451, "Q406=0\n");
        let (outcome, machine) = run("itnc530", &shop.scene(true, false), &program);
        // That control refuses positions at 0. A sphere near an axis does not tell its direction, nor does a ball that is
        // on the axis of a head: nothing changes then, and the log says what was measured.
        let refused = outcome.fault.as_ref().map_or("", |fault| &fault.code);
        prop_assume!(refused != "measuring-position-at-zero");
        let written = outcome.tables.iter().any(|(file, _)| file == "KINEMATICS.YAML");
        if refused.is_empty() && !written {
            done(&outcome)?;
            prop_assert!(!outcome.logs.is_empty(), "no log");
            for (found, askew) in changes(&shop, &machine) {
                near(found, [0.0; 3])?;
                near(askew, [0.0; 3])?;
            }
            return Ok(());
        }
        // Or they do not tell the places with the directions that were found.
        prop_assume!(refused != "kinematics-undetermined");
        done(&outcome)?;
        nothing(&outcome)?;
        for (((_, _, along, _), wrong), (found, askew)) in shop.axes().zip(changes(&shop, &machine)) {
            near(askew, across(wrong.askew, *along))?;
            near(across(found, *along), across(wrong.centre, *along))?;
        }
    }

    #[test]
    fn a_drift_is_compensated_and_the_preset_stays_in_the_sphere(shop in shop()) {
        prop_assume!(shop.is_told(false));
        let program = shop.call(452, "") + &shop.call(452, "");
        let (outcome, machine) = run("tnc640", &shop.scene(false, true), &program);
        done(&outcome)?;
        nothing(&outcome)?;
        // The linear axes say less by the drift wherever the tool is: of the table and its axes, and of the preset.
        let less = shop.drift.map(|drift| -drift);
        near(machine.base.to_array(), less)?;
        for (((_, carries, along, _), wrong), (found, _)) in shop.axes().zip(changes(&shop, &machine)) {
            let own = across(wrong.centre, *along);
            let with = if *carries == "workpiece" { across(less, *along) } else { [0.0; 3] };
            near(found, [own[0] + with[0], own[1] + with[1], own[2] + with[2]])?;
        }
    }

    /// The machine has warmed up since its kinematics were corrected: the second run begins with the file of the first.
    #[test]
    fn a_drift_between_two_runs_is_found(shop in shop()) {
        prop_assume!(shop.is_told(false));
        let first = shop.scene(false, false);
        let (outcome, _) = run("tnc640", &first, &shop.call(451, "Q406=1\n"));
        done(&outcome)?;
        let file = outcome.tables.iter().find(|(file, _)| file == "KINEMATICS.YAML").map(|(_, text)| text.as_str());
        prop_assume!(file.is_some());
        let corrected: String = file.unwrap_or_default().lines().map(|line| format!("  {line}\n")).collect();
        let before = |mark: &str| first.find(mark).expect("a key");
        let second = format!(
            "scene: 1\nmachine:\n{corrected}kinematics:\n  drift: {:?}\n{}", shop.drift, &first[before("tools:")..]
        );
        let (outcome, machine) = run("tnc640", &second, &shop.call(452, ""));
        done(&outcome)?;
        near(machine.base.to_array(), shop.drift.map(|drift| -drift))?;
    }

    /// The machine parameter for the greatest change stops a correction that is not confirmed: nothing is written.
    #[test]
    fn a_correction_beyond_the_limit_is_not_made(shop in shop(), cycle in prop_oneof![Just(451_u32), Just(452)]) {
        prop_assume!(shop.is_told(false));
        let first = if cycle == 451 { "Q406=1\n" } else { "" };
        let greatest = shop.axes().flat_map(|((_, _, along, _), wrong)| across(wrong.centre, *along)).fold(0.0, |a: f64, b| a.max(b.abs()));
        prop_assume!(greatest > 0.01);
        for (limit, answer, written) in [(greatest * 0.9, "no", false), (greatest * 0.9, "yes", true), (greatest * 1.1, "no", true)] {
            let scene = shop.scene(false, false)
                + &format!("machine_parameters: {{maxModification: {limit}}}\nanswers: [{{to: kinematics-limit-exceeded, say: {answer}}}]\n");
            let (outcome, machine) = run("tnc640", &scene, &shop.call(cycle, first));
            let wrote = outcome.tables.iter().any(|(file, _)| file == "KINEMATICS.YAML");
            prop_assert_eq!(wrote, written, "limit {} of {}, {}: {:?}", limit, greatest, answer, outcome.fault);
            prop_assert_eq!(outcome.status, if written { Status::Done } else { Status::Stopped });
            if !written {
                for (found, _) in changes(&shop, &machine) {
                    near(found, [0.0; 3])?;
                }
            }
        }
    }

    /// A sphere that is found to have another radius than the entered one ends the cycle in the middle of its
    /// measurements: nothing is written.
    #[test]
    fn a_fault_in_the_middle_leaves_the_kinematics(shop in shop(), touches in 0_usize..18) {
        prop_assume!(shop.is_told(false));
        // One touch is late by 2 mm: of the reference measurement, or of the position after it, which there always is.
        let mut late = vec![0.0; 500];
        late[touches % (2 * (shop.touched as usize + 1))] = 2.0;
        let scene = shop.scene(false, false).replace("DIST: 20}", &format!("DIST: 20, scatter: {late:?}}}"))
            + "machine_parameters: {maxDevCalBall: 0.05}\n";
        let (outcome, _) = run("tnc640", &scene, &shop.call(451, "Q406=1\n"));
        let code = outcome.fault.as_ref().map(|fault| fault.code.to_string());
        prop_assert_eq!(code.as_deref(), Some("sphere-radius-differs"));
        prop_assert!(outcome.tables.iter().all(|(file, _)| file != "KINEMATICS.YAML"));
    }

    #[test]
    fn backlash_is_the_angle_between_two_sides(
        (lag, angle) in (of(0.005..0.08), of(20.0..170.0)), (x, y) in (of(60.0..200.0), of(-200.0..200.0)), over in of(0.3..3.0),
    ) {
        let scene = format!(
            "scene: 1\nmachine: mill-table-c\nkinematics: {{errors: [{{axis: C, backlash: {lag}}}]}}\n\
             tools: [{{T: 1, L: 100, R: 2, TP_NO: 1}}]\nprobe: {{NO: 1, ball_radius: 2, SET_UP: 5, F: 300, FMAX: 3000, DIST: 20}}\n\
             presets: {{active: 1, rows: [{{NO: 1, X: {x}, Y: {y}, Z: -50}}]}}\n\
             parts: [{{solid: {{sphere: {{centre: [0, 0, 0], radius: 12.5}}}}}}]\nstart: [0, 0, 60]\n"
        );
        let program = format!(
            "TCH PROBE 451\nQ406=1\nQ407=12.5\nQ320=0\nQ408=0\nQ253=2000\nQ380=0\nQ411=0\nQ412=0\nQ413=0\nQ414=0\nQ415=0\nQ416=0\nQ417=0\nQ418=0\n\
             Q419={}\nQ420={angle}\nQ421=0\nQ422=2\nQ423=4\nQ431=0\nQ432={over}\n",
            -angle
        );
        let Built { files, catalogue, .. } = built();
        let on = catalogue.on("tnc640").expect("a control");
        let scene = Scene::parse(&Source::new("scene.yaml", &*scene), files).expect("a scene");
        let program = format!("TOOL CALL 1 Z\n{program}");
        let tree = syntax::parse(&Source::new("LAW.H", &*program));
        let texts = LogTexts::new(built().locales.source().expect("English"), on.id(), files);
        let outcome = Engine::new(&tree, on, &scene, &texts).run(&mut |_| {});
        done(&outcome)?;
        let log = outcome.logs.first().map_or("", |(_, log)| log);
        // To four decimals, as logs are written.
        let wanted = format!("Mean backlash: {lag:.4}");
        prop_assert!(log.contains(&wanted), "{}: {}", wanted, log);
    }
}

#[test]
fn positions_next_to_the_reference_tell_nothing() {
    let wrong = Wrong { centre: [0.0; 3], askew: [0.0; 3], range: (0.0001, 0.0001), points: 1, incidence: 0.0 };
    let shop = Shop {
        machine: 0,
        axes: [wrong; 2],
        sphere: [100.0, 20.0, -50.0],
        centre: [0.0; 3],
        radius: 12.5,
        touched: 4,
        reference: 0.0,
        retracts: false,
        drift: [0.0; 3],
    };
    // 0.0001 of 360 degrees is written as 0.
    let program = shop.call(451, "Q406=1\n").replace("Q419=0\n", "Q419=0.05\n");
    let (outcome, _) = run("tnc640", &shop.scene(false, false), &program);
    assert_eq!(outcome.fault.map(|fault| fault.code.to_string()), Some("kinematics-undetermined".to_owned()));
}

/// The numbers of an axis in the cases that `kinematics_scatter.py` has calculated.
fn numbers(value: &serde_json::Value) -> Vec<f64> {
    value.as_array().expect("a list").iter().map(|number| number.as_f64().expect("a number")).collect()
}

/// Axes that stop beside their positions and a probe that triggers late: scatter before and after, and corrections, are
/// those of SciPy (`kinematics_scatter.py`, which made the file).
#[test]
fn scatter_and_corrections_equal_those_of_an_independent_fit() {
    let cases: serde_json::Value = serde_json::from_str(include_str!("kinematics_scatter.json")).expect("JSON");
    let cases = cases.as_array().expect("cases");
    assert!(cases.len() >= 6);
    for (number_of_case, case) in cases.iter().enumerate() {
        let mut scene = String::from(
            "scene: 1\nmachine:\n  machine: 1\n  name: shop\n  axes:\n    - {axis: X, min: -2000, max: 2000, rapid: 20000}\n    \
             - {axis: Y, min: -2000, max: 2000, rapid: 20000}\n    - {axis: Z, min: -2000, max: 2000, rapid: 20000}\n  rotary:\n",
        );
        let (mut errors, mut q) = (String::new(), String::new());
        let axes = case["axes"].as_array().expect("axes");
        for axis in axes {
            let (letter, centre) = (axis["letter"].as_str().expect("a letter"), numbers(&axis["centre"]));
            let _ = writeln!(
                scene,
                "    - {{axis: {letter}, carries: workpiece, min: -359, max: 359, rapid: 5000, centre: {centre:?}}}"
            );
            let (error, scatter) = (numbers(&axis["error"]), numbers(&axis["scatter"]));
            let _ = writeln!(errors, "    - {{axis: {letter}, centre: {error:?}, scatter: {scatter:?}}}");
        }
        for (row, letter) in ["A", "B", "C"].into_iter().enumerate() {
            let own = axes.iter().find(|axis| axis["letter"] == letter);
            let (start, end, count) = own.map_or((0.0, 0.0, 0), |axis| {
                let number = |key: &str| axis[key].as_f64().expect("a number");
                (number("start"), number("end"), axis["count"].as_u64().expect("a count"))
            });
            let first = 411 + 4 * row;
            let _ = write!(q, "Q{first}={start}\nQ{}={end}\nQ{}=0\nQ{}={count}\n", first + 1, first + 2, first + 3);
        }
        let sphere = numbers(&case["sphere"]);
        let (lateness, points) = (numbers(&case["probe_scatter"]), case["points"].as_u64().expect("a count"));
        let _ = write!(
            scene,
            "kinematics:\n  errors:\n{errors}tools: [{{T: 1, L: 100, R: 2, TP_NO: 1}}]\n\
             probe: {{NO: 1, ball_radius: 2, SET_UP: 5, F: 300, FMAX: 3000, DIST: 20, scatter: {lateness:?}}}\n\
             presets: {{active: 1, rows: [{{NO: 1, X: {}, Y: {}, Z: {}}}]}}\n\
             parts: [{{solid: {{sphere: {{radius: 12.5}}}}}}]\nstart: [0, 0, 100]\n",
            sphere[0], sphere[1], sphere[2]
        );
        let program = format!(
            "TCH PROBE 451\nQ406=1\nQ407=12.5\nQ320=0\nQ408=600\nQ253=2000\nQ380=0\n{q}Q423={points}\nQ431=0\nQ432=0\n"
        );
        let (outcome, _) = run("tnc640", &scene, &program);
        assert_eq!(outcome.status, Status::Done, "case {number_of_case}: {:?}", outcome.fault);
        for (q, wanted) in (141..).zip(numbers(&case["results"])) {
            let found = number(&outcome, q);
            assert!((found - wanted).abs() < SAME, "case {number_of_case}: Q{q} is {found}, not {wanted}");
        }
    }
}

/// Positions of a Hirth axis are those of its grid: the example of the manual (002:287-305), from -30 to 90 degrees in
/// four points with teeth every 3 degrees. The backlash of such an axis is not measured.
#[test]
fn a_hirth_axis_stops_on_its_grid() {
    let Built { files, catalogue, .. } = built();
    for control in ["tnc640", "itnc530"] {
        let on = catalogue.on(control).expect("a control");
        let scene = "scene: 1\nmachine:\n  machine: 1\n  name: grid\n  axes:\n    - {axis: X, min: -2000, max: 2000, rapid: 20000}\n    \
            - {axis: Y, min: -2000, max: 2000, rapid: 20000}\n    - {axis: Z, min: -2000, max: 2000, rapid: 20000}\n  rotary:\n    \
            - {axis: C, carries: workpiece, rapid: 5000, hirth: 3}\nkinematics:\n  errors: [{axis: C, centre: [0.02, -0.03, 0]}]\n\
            tools: [{T: 1, NAME: PROBE, L: 100, R: 2, TP_NO: 1}]\nprobe: {NO: 1, ball_radius: 2, SET_UP: 5, F: 300, FMAX: 3000, DIST: 20}\n\
            presets: {active: 1, rows: [{NO: 1, X: 200, Y: 50, Z: -100}]}\nparts: [{solid: {sphere: {radius: 12.5}}}]\nstart: [0, 0, 100]\n";
        let program = "TOOL CALL 1 Z\nTCH PROBE 451\nQ406=1\nQ407=12.5\nQ320=0\nQ408=100\nQ253=2000\nQ380=0\nQ411=0\nQ412=0\nQ413=0\nQ414=0\n\
            Q415=0\nQ416=0\nQ417=0\nQ418=0\nQ419=-30\nQ420=90\nQ421=0\nQ422=4\nQ423=4\nQ431=0\nQ432=2\n";
        let scene = Scene::parse(&Source::new("scene.yaml", scene), files).expect("a scene");
        let tree = syntax::parse(&Source::new("HIRTH.H", program));
        let texts = LogTexts::new(built().locales.source().expect("English"), on.id(), files);
        let mut angles = Vec::new();
        let outcome = Engine::new(&tree, on, &scene, &texts).run(&mut |event| {
            if let EventKind::Turn { axes, .. } = &event.kind {
                angles.extend(axes.iter().map(|axis| axis.to));
            }
        });
        assert_eq!(outcome.status, Status::Done, "{control}: {:?}", outcome.fault);
        assert_eq!(angles, [-30.0, 9.0, 51.0, 90.0, 0.0], "{control}");
        let found = [number(&outcome, 147), number(&outcome, 148)];
        assert!((found[0] - 0.02).abs() < SAME && (found[1] + 0.03).abs() < SAME, "{control}: {found:?}");
        let log = outcome.logs.iter().find(|(name, _)| name == "TCHPR451.TXT").map(|(_, text)| text.as_str());
        assert!(log.is_some_and(|log| log.contains("Mean backlash: -")), "{log:?}");
    }
}
