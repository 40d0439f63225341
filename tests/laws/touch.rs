//! Laws of single touches, whatever cycle makes them: what a probe that triggers differently in each direction finds, where
//! its shaft touches, and that a touch that fails leaves everything as it was.
//!
//! Truths are calculated here from the scene's numbers, with plain trigonometry and nothing of the engine.
#![expect(clippy::disallowed_methods, reason = "truths are calculated with plain trigonometry")]
use std::collections::{BTreeMap, BTreeSet};

use ciklo::base::diag::Source;
use ciklo::base::expr::QRef;
use ciklo::engine::run::{Content, Engine, Event, EventKind, Outcome, Status};
use ciklo::engine::scene::Scene;
use ciklo::program::syntax;
use ciklo::spec::{Cycle, Keyword};
use ciklo::tools::conform::{self, LogTexts, Partner, Selection, Silence, World};
use proptest::prelude::*;
use serde_json::Value;

use crate::built;
use built::built;

fn run(control: &str, program: &str, scene: &str) -> (Outcome, Vec<Event>) {
    let data = built();
    let on = data.catalogue.on(control).expect("a control");
    let parsed = Scene::parse(&Source::new("scene.yaml", scene), &data.files);
    let scene = parsed.unwrap_or_else(|found| panic!("{found:?}\n{scene}"));
    let texts = LogTexts::new(data.locales.language("en").expect("English"), control, &data.files);
    let tree = syntax::parse(&Source::new("LAW.H", program));
    let mut events = Vec::new();
    let engine = Engine::new(&tree, on, &scene, &texts).with_catalogue(&data.catalogue);
    let outcome = engine.run(&mut |event| events.push(event));
    (outcome, events)
}

fn q(outcome: &Outcome, number: u16) -> f64 {
    match outcome.params.get(QRef::q(number)) {
        Some(Content::Number(number)) => number,
        other => panic!("Q{number} is {other:?}; {:?}", outcome.fault),
    }
}

/// The circle with the least sum of squared distances from points: Gauss and Newton, by the normal equations.
fn least_squares(points: &[(f64, f64)]) -> (f64, f64, f64) {
    let count = points.len() as f64;
    let mut c = [points.iter().map(|p| p.0).sum::<f64>() / count, points.iter().map(|p| p.1).sum::<f64>() / count, 0.0];
    c[2] = points.iter().map(|p| (p.0 - c[0]).hypot(p.1 - c[1])).sum::<f64>() / count;
    for _ in 0..200 {
        let (mut m, mut v) = ([[0.0; 3]; 3], [0.0; 3]);
        for p in points {
            let away = (p.0 - c[0]).hypot(p.1 - c[1]);
            let row = [-(p.0 - c[0]) / away, -(p.1 - c[1]) / away, -1.0];
            for i in 0..3 {
                v[i] -= row[i] * (away - c[2]);
                for j in 0..3 {
                    m[i][j] += row[i] * row[j];
                }
            }
        }
        let det = |m: [[f64; 3]; 3]| {
            m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) - m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0])
                + m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0])
        };
        let whole = det(m);
        for i in 0..3 {
            let mut with = m;
            for j in 0..3 {
                with[j][i] = v[j];
            }
            c[i] += det(with) / whole;
        }
    }
    (c[0], c[1], c[2])
}

/// The sphere with the least sum of squared distances from points, centre and radius: Gauss and Newton, by elimination.
fn least_sphere(points: &[[f64; 3]]) -> [f64; 4] {
    let mut sphere = [0.0; 4];
    for k in 0..3 {
        sphere[k] = points.iter().map(|p| p[k]).sum::<f64>() / points.len() as f64;
    }
    for _ in 0..500 {
        let mut rows = [[0.0; 5]; 4];
        for p in points {
            let away = [0, 1, 2].map(|k| p[k] - sphere[k]);
            let distance = away.iter().map(|c| c * c).sum::<f64>().sqrt();
            let row = [-away[0] / distance, -away[1] / distance, -away[2] / distance, -1.0];
            for i in 0..4 {
                for j in 0..4 {
                    rows[i][j] += row[i] * row[j];
                }
                rows[i][4] -= row[i] * (distance - sphere[3]);
            }
        }
        for i in 0..4 {
            let pivot = (i..4).max_by(|a, b| rows[*a][i].abs().total_cmp(&rows[*b][i].abs())).expect("a row");
            rows.swap(i, pivot);
            for other in 0..4 {
                if other != i {
                    let share = rows[other][i] / rows[i][i];
                    let from = rows[i];
                    rows[other].iter_mut().zip(from).for_each(|(value, from)| *value -= share * from);
                }
            }
        }
        for i in 0..4 {
            sphere[i] += rows[i][4] / rows[i][i];
        }
    }
    sphere
}

laws! {
    #![proptest_config(crate::cases::config(50))]

    /// A probe with lobes finds the least-squares circle of the points at which it triggers: those lie farther out by the
    /// pre-travel of their direction, and the control believes them as far out as the effective radius says.
    #[test]
    fn a_probe_with_lobes_finds_the_least_squares_circle(
        inside in any::<bool>(), diameter in 20.0..60.0_f64, ball in 1.0..3.0_f64, radial in 0.01..0.05_f64, share in 0.0..0.9_f64,
        lobes in 2..5u32, phase in -180.0..180.0_f64, start in -180.0..180.0_f64, step in 30.0..90.0_f64, three in any::<bool>(),
        track in any::<bool>(),
    ) {
        let (amplitude, effective) = (radial * share, ball - radial);
        let count = if three { 3 } else { 4 };
        let solid = if inside {
            format!("{{difference: [{{box: {{min: [-100, -100, -40], max: [100, 100, 0]}}}}, {{cylinder: {{diameter: {diameter}, from: -50, to: 10}}}}]}}")
        } else {
            format!("{{cylinder: {{diameter: {diameter}, from: -40, to: 0}}}}")
        };
        let scene = format!(
            "scene: 1\ntools: [{{T: 1, L: 120, R: {effective}, TP_NO: 1}}]\nprobe: {{NO: 1, ball_radius: {ball}, length: 120, DIST: 20, SET_UP: 2, TRACK: \"{}\", \
             pre_travel: {{radial: {radial}, amplitude: {amplitude}, lobes: {lobes}, phase: {phase}}}}}\nstart: [0, 0, 60]\nparts:\n  - solid: {solid}\n",
            if track { "ON" } else { "OFF" },
        );
        let cycle = if inside { "421" } else { "422" };
        let limits = if inside { "Q275=0\nQ276=0" } else { "Q277=0\nQ278=0" };
        let program = format!(
            "TOOL CALL 1 Z\nTCH PROBE {cycle}\nQ273=0\nQ274=0\nQ262={diameter}\nQ325={start}\nQ247={step}\nQ261=-5\nQ320=0\nQ260=30\nQ301=0\n{limits}\n\
             Q279=0\nQ280=0\nQ281=0\nQ309=0\nQ330=0\nQ423={count}\nQ365=1\n"
        );
        let (outcome, _) = run("tnc640", &program, &scene);
        prop_assert_eq!(outcome.status, Status::Done, "{:?}", outcome.fault);
        let points: Vec<(f64, f64)> = (0..count).map(|k| {
            let angle = start + step * f64::from(k);
            // Into the material: outwards in a hole. A tracked stylus always has its main axis there.
            let into = if track { 0.0 } else if inside { angle } else { angle + 180.0 };
            let pushed = radial + amplitude * (f64::from(lobes) * (into - phase)).to_radians().cos();
            let away = diameter / 2.0 - (ball - pushed) * if inside { 1.0 } else { -1.0 };
            (away * angle.to_radians().cos(), away * angle.to_radians().sin())
        }).collect();
        let (x, y, radius) = least_squares(&points);
        let truth = 2.0 * (radius + effective * if inside { 1.0 } else { -1.0 });
        let found = [151, 152, 153].map(|number| q(&outcome, number));
        prop_assert!([x, y, truth].iter().zip(found).all(|(truth, found)| (truth - found).abs() < 1e-6), "{found:?} is not {:?}", (x, y, truth));
    }

    /// 460 under noise: the effective radius is that of the least-squares sphere through the points on the diameter and the
    /// one above the centre, less the radius of the calibration sphere.
    #[test]
    fn a_calibration_sphere_is_the_least_squares_one(
        radius in 8.0..20.0_f64, ball in 1.0..3.0_f64, count in 3..9u32, angle in 0.0..360.0_f64, beside in (-0.3..0.3_f64, -0.3..0.3_f64),
        scatter in proptest::collection::vec(0.0..0.02_f64, 5..12), fixed in any::<bool>(),
    ) {
        let scene = format!(
            "scene: 1\ntools: [{{T: 1, L: 120, R: {}, TP_NO: 1}}]\nprobe: {{NO: 1, ball_radius: {ball}, length: 120, DIST: 20, SET_UP: 2, orientation: {}, scatter: {scatter:?}}}\n\
             start: [{}, {}, {}]\nparts:\n  - solid: {{sphere: {{radius: {radius}}}}}\n",
            ball + 0.01, if fixed { "fixed" } else { "any" }, beside.0, beside.1, radius + 5.0,
        );
        let program = format!("TOOL CALL 1 Z\nTCH PROBE 460\nQ407={radius}\nQ320=0\nQ301=1\nQ423={count}\nQ380={angle}\nQ433=0\nQ434=0\n");
        let (outcome, events) = run("tnc640", &program, &scene);
        prop_assert_eq!(outcome.status, Status::Done, "{:?}\n{}{}", outcome.fault, program, scene);
        let probed = |step: &str| -> Vec<[f64; 3]> {
            let of_step = |event: &&Event| event.at.cycle.as_ref().and_then(|(_, step)| step.as_deref()) == Some(step);
            let centre = |event: &Event| match &event.kind {
                EventKind::Probe(probing) => probing.contact.map(|(_, centre)| centre.to_array()),
                _ => None,
            };
            events.iter().filter(of_step).filter_map(centre).collect()
        };
        let mut points = probed("calibrate-radius-on-sphere");
        prop_assert_eq!(points.len(), count as usize);
        points.extend(probed("find-sphere-centre").last());
        let found = events.iter().rev().find_map(|event| match &event.kind {
            EventKind::Table { column, value: Content::Number(value), .. } if column == "R" => Some(*value),
            _ => None,
        });
        let (found, wanted) = (found.expect("a radius"), least_sphere(&points)[3] - radius);
        prop_assert!((found - wanted).abs() < 1e-9, "{found} is not {wanted}");
    }

    /// A ledge above the wall that is probed stops the shaft if it sticks out farther than the shaft stands from the wall
    /// when the ball triggers, and if the shaft reaches up to it.
    #[test]
    fn a_ledge_stops_the_shaft(
        ball in 1.0..3.0_f64, thin in 0.2..0.9_f64, pre_travel in 0.0..0.05_f64, out in 0.0..4.0_f64, length in 5.0..60.0_f64,
        height in -25.0..-15.0_f64, from_left in any::<bool>(), minor in any::<bool>(),
    ) {
        let shaft = ball * thin;
        let ledge = -10.0;
        // What is decided by less than the accuracy, or in the round upper end, is not asked.
        let room = (ball - pre_travel) - shaft;
        prop_assume!((room - out).abs() > 1e-4 && (height + length - ledge).abs() > shaft + 0.1 && height + ball < ledge - 0.1);
        let sense = if from_left { 1.0 } else { -1.0 };
        let axis = if minor { "Y" } else { "X" };
        let solid = |face: f64, low: f64, high: f64| {
            let (from, to) = if from_left { (face, 200.0) } else { (-200.0, face) };
            let range = if minor { (format!("-50, {from}"), format!("50, {to}")) } else { (format!("{from}, -50"), format!("{to}, 50")) };
            format!("  - solid: {{box: {{min: [{}, {low}], max: [{}, {high}]}}}}\n", range.0, range.1)
        };
        let far = -sense * 30.0;
        let start = if minor { format!("[0, {far}, 60]") } else { format!("[{far}, 0, 60]") };
        let scene = format!(
            "scene: 1\ntools: [{{T: 1, L: {}, R: {}, TP_NO: 1}}]\nprobe: {{NO: 1, ball_radius: {ball}, length: 150, DIST: 40, SET_UP: 2, pre_travel: {pre_travel}, \
             shaft: {{diameter: {}, length: {length}}}}}\nstart: {start}\nparts:\n{}{}",
            150.0 - pre_travel, ball - pre_travel, 2.0 * shaft, solid(0.0, -40.0, ledge), solid(-sense * out, ledge, 0.0),
        );
        let program = format!(
            "TOOL CALL 1 Z\nTCH PROBE 427\nQ263=0\nQ264=0\nQ261={height}\nQ320=15\nQ272={}\nQ267={sense}\nQ260=60\nQ281=0\nQ288=0\nQ289=0\nQ309=0\nQ330=0\n",
            if minor { 2 } else { 1 },
        );
        let (outcome, _) = run("tnc640", &program, &scene);
        if out > room && height + length > ledge {
            let fault = outcome.fault.expect("a collision");
            prop_assert_eq!(&*fault.code, "shaft-collision", "{}", scene);
        } else {
            prop_assert_eq!(outcome.status, Status::Done, "{:?}\n{}", outcome.fault, scene);
            prop_assert!(q(&outcome, 160).abs() < 1e-6, "{axis} {}", q(&outcome, 160));
        }
    }
}

laws! {
    #![proptest_config(crate::cases::config(50))]

    /// 444 in a tilted plane: the point is found in the coordinates of the plane, wherever the preset lies on the table and
    /// however the plane is tilted; once the axes stand elsewhere, a control that checks it refuses.
    #[test]
    fn a_point_in_a_tilted_plane(
        tilt in (-60.0..60.0_f64, -170.0..170.0_f64), preset in (-60.0..60.0_f64, -60.0..60.0_f64, -40.0..40.0_f64),
        point in (-30.0..30.0_f64, -30.0..30.0_f64, -20.0..20.0_f64), lean in 0.0..50.0_f64, around in -180.0..180.0_f64, off in -0.5..0.5_f64,
        pre_travel in 0.0..0.05_f64, offset in (-0.2..0.2_f64, -0.2..0.2_f64), askew in any::<bool>(), c_axis in any::<bool>(),
    ) {
        let c = if c_axis { tilt.1 } else { 0.0 };
        let (sin, cos) = (lean.to_radians().sin(), lean.to_radians().cos());
        let normal = [sin * around.to_radians().cos(), sin * around.to_radians().sin(), cos];
        let nominal = [point.0, point.1, point.2];
        let truth = [0, 1, 2].map(|i| nominal[i] + off * normal[i]);
        // The plane is tilted about the preset by A about X, then C about the fixed Z; the face of a block is given in it.
        let scene = format!(
            "scene: 1\nmachine: mill-table-ac\nmachine_parameters: {{chkTiltingAxes: 1}}\ntools: [{{T: 1, L: {}, R: {}, TP_NO: 1}}, {{T: 2, L: 100, R: 5}}]\n\
             probe: {{NO: 1, ball_radius: 2, length: 120, pre_travel: {pre_travel}, DIST: 20, SET_UP: 2, CAL_OF1: {}, CAL_OF2: {}}}\n\
             presets: {{active: 1, rows: [{{NO: 1, X: {}, Y: {}, Z: {}}}]}}\nstart: [0, 0, 300]\nparts:\n  - place: {{rotate: {{A: {}, C: {c}}}}}\n    \
             solid: {{union: [{{place: {{rotate: [0, {lean}, {around}], shift: {truth:?}}}, solid: {{box: {{min: [-12, -12, -20], max: [12, 12, 0]}}}}}}]}}\n",
            120.0 - pre_travel, 2.0 - pre_travel, offset.0, offset.1, preset.0, preset.1, preset.2, tilt.0,
        );
        let away = if askew { "L IA+3 FMAX\n" } else { "" };
        let program = format!(
            "BEGIN PGM LAW MM\nTOOL CALL 2 Z\nCYCL DEF 19.0 WORKING PLANE\nCYCL DEF 19.1 A{:+} B+0 C{c:+} F5000 ABST50\nL Z+200 FMAX\n{away}TOOL CALL 1 Z\nTCH PROBE 444\n\
             Q263={}\nQ264={}\nQ294={}\nQ581={}\nQ582={}\nQ583={}\nQ320=0\nQ260=100\nQS400=\"0.2-0.1\"\nQ309=0\n",
            tilt.0, point.0, point.1, point.2, normal[0], normal[1], normal[2],
        );
        let (outcome, _) = run("tnc640", &program, &scene);
        if askew {
            let fault = outcome.fault.expect("a refusal");
            prop_assert_eq!(&*fault.code, "rotary-axes-askew", "{}\n{}", program, scene);
            return Ok(());
        }
        prop_assert_eq!(outcome.status, Status::Done, "{:?}\n{}\n{}", outcome.fault, program, scene);
        let found = [151, 152, 153].map(|number| q(&outcome, number));
        prop_assert!(found.iter().zip(truth).all(|(found, truth)| (found - truth).abs() < 1e-6), "{found:?} is not {truth:?}");
        prop_assert!((q(&outcome, 164) - off).abs() < 1e-6);
    }
}

/// Runs each case as it is, and once more for each of its touches, which then finds nothing.
#[derive(Default)]
struct Failing {
    /// Cases that were seen on another control: number of the cycle and name.
    seen: BTreeSet<(String, String)>,
    cases: usize,
    failed: usize,
    tolerated: usize,
    wrong: Vec<String>,
    /// Results that a cycle had set when a later touch of it failed, by cycle.
    early: BTreeMap<u32, BTreeSet<String>>,
}

/// So late is a trigger that never comes.
const NEVER: f64 = 1e6;

impl Failing {
    /// The law for one touch: nothing of what the cycle would have written is there, and nothing happens afterwards.
    fn judge(&mut self, name: &str, request: &Value, late: &[f64]) {
        let mut scene = request["scene"].clone();
        scene["probe"]["scatter"] = late.into();
        let (control, program) =
            (request["control"].as_str().expect("a control"), request["program"].as_str().expect("a program"));
        let (outcome, events) = run(control, program, &scene.to_string());
        let is_miss = |event: &Event| matches!(&event.kind, EventKind::Probe(probing) if probing.contact.is_none());
        let Some(miss) = events.iter().position(is_miss) else {
            self.wrong.push(format!("{name}: no touch fails"));
            return;
        };
        self.failed += 1;
        let (before, after) = events.split_at(miss);
        let cycle = after[0].at.cycle.as_ref().map_or(0, |(key, _)| key.number);
        let same = |event: &&Event| event.at.line == after[0].at.line;
        let table = |event: &&Event| {
            matches!(event.kind, EventKind::Table { .. } | EventKind::Log { .. } | EventKind::Transform(_))
        };
        // Cycle 3 goes on where the manual says so; it tells the miss in its fourth parameter.
        if outcome.status == Status::Done && cycle == 3 {
            self.tolerated += 1;
            return;
        }
        let mut wrong =
            |what: &str| self.wrong.push(format!("{name}, touch {}: {what}: {:?}", late.len(), outcome.fault));
        if outcome.fault.as_ref().is_none_or(|fault| fault.code != "probe-no-contact") {
            wrong("it does not end with the error");
        }
        if before.iter().filter(same).any(|event| table(&event) && !matches!(event.kind, EventKind::Transform(_))) {
            wrong("tables or logs were written before");
        }
        if after.iter().skip(1).any(|event| !matches!(event.kind, EventKind::Error(_) | EventKind::End(_))) {
            wrong("something happens afterwards");
        }
        let told: BTreeSet<&str> = events
            .iter()
            .filter_map(|event| match &event.kind {
                EventKind::Table { file, .. } => Some(file.as_str()),
                _ => None,
            })
            .collect();
        if outcome.tables.iter().any(|(file, _)| !told.contains(file.as_str())) {
            wrong("a table was changed");
        }
        let Some(cycle) = built().catalogue.on(control).and_then(|on| {
            on.cycles.values().find(|known| after[0].at.cycle.as_ref().is_some_and(|(key, _)| known.key == *key))
        }) else {
            return;
        };
        let results: Vec<String> =
            cycle.file.results.iter().filter_map(|result| result.q).map(|q| q.to_string()).collect();
        for event in before.iter().filter(same) {
            if let EventKind::Set { q, .. } = &event.kind
                && results.contains(&q.to_string())
            {
                self.early.entry(cycle.key.number).or_default().insert(q.to_string());
            }
        }
    }
}

impl Partner for Failing {
    fn ask(&mut self, line: &str) -> Result<String, Silence> {
        let answer = conform::serve(&world(), line);
        let request: Value = serde_json::from_str(line).expect("a request");
        if request["cycle"]["keyword"] != "TCH PROBE" || request["scene"]["probe"].is_null() || scans(&request) {
            return Ok(answer);
        }
        if is_worked(&request)
            || !self.seen.insert((request["cycle"]["number"].to_string(), request["case"].to_string()))
        {
            return Ok(answer);
        }
        let control = request["control"].as_str().expect("a control");
        let (_, events) = run(control, request["program"].as_str().expect("a program"), &request["scene"].to_string());
        let touches = events
            .iter()
            .filter(|event| matches!(&event.kind, EventKind::Probe(probing) if probing.contact.is_some()))
            .count();
        let own: Vec<f64> =
            request["scene"]["probe"]["scatter"].as_array().into_iter().flatten().filter_map(Value::as_f64).collect();
        self.cases += usize::from(touches > 0);
        for touch in 0..touches {
            let mut late: Vec<f64> =
                (0..touch).map(|k| own.get(k % own.len().max(1)).copied().unwrap_or(0.0)).collect();
            late.push(NEVER);
            let name = format!("{control} {} {}", request["cycle"]["number"], request["case"]);
            self.judge(&name, &request, &late);
        }
        Ok(answer)
    }
}

/// Whether it is a worked program: its other cycles write what they have to before one fails.
fn is_worked(request: &Value) -> bool {
    let on = built().catalogue.on(request["control"].as_str().expect("a control")).expect("a known one");
    on.worked.iter().any(|worked| Some(worked.name()) == request["case"].as_str())
}

/// Whether it is of a cycle whose probe follows the workpiece: losing it there is no touch that fails.
fn scans(request: &Value) -> bool {
    let on = built().catalogue.on(request["control"].as_str().expect("a control")).expect("a known one");
    let number = request["cycle"]["number"].as_u64().expect("a number");
    let is_it = |cycle: &&Cycle| cycle.key.keyword == Keyword::TchProbe && u64::from(cycle.key.number) == number;
    on.cycles.values().find(is_it).is_some_and(|cycle| cycle.file.group.as_str() == "digitizing")
}

fn world() -> World<'static> {
    let data = built();
    World { catalogue: &data.catalogue, locales: &data.locales, files: &data.files }
}

/// Every touch of every example may fail: the program ends there with an error, tables, logs and the
/// systems in effect are what they were, and no later value is set.
#[test]
fn a_touch_that_fails_leaves_everything_as_it_was() {
    let mut failing = Failing::default();
    let (report, _) = conform::run_foreign(&world(), &Selection::default(), &mut failing);
    assert!(report.cases.len() > 900);
    assert!(failing.wrong.is_empty(), "{} of {}:\n{}", failing.wrong.len(), failing.failed, failing.wrong.join("\n"));
    println!(
        "{} cases, {} touches failed, {} tolerated; set early: {:?}",
        failing.cases, failing.failed, failing.tolerated, failing.early
    );
    assert!(
        failing.cases > 200 && failing.failed > 700 && failing.tolerated > 0,
        "{} {}",
        failing.cases,
        failing.failed
    );
}
