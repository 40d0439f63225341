//! Laws of contours, slots and ridges on cylinders: what the axes of the machine do is taken back to the workpiece here,
//! by plain trigonometry, and compared with the contour in the development.
//!
//! Machines: a table that turns about X or Y under a vertical spindle, and a head that lays the tool across a table that
//! turns about Z. A coordinate that grows takes the tool right-handed about its axis over the workpiece.
#![expect(clippy::disallowed_methods, reason = "truths are calculated with plain trigonometry")]
use std::f64::consts::PI;
use std::fmt::Write as _;

use ciklo::base::diag::Source;
use ciklo::engine::run::{Engine, Event, EventKind, MoveKind, NoTexts, Outcome, Status};
use ciklo::engine::scene::Scene;
use ciklo::program::syntax;
use glam::{DVec2, DVec3};
use proptest::prelude::*;

use crate::built::{Built, built};

/// Chords lie within 0.001 mm of their arcs, and so does the contour of this file.
const NEAR: f64 = 0.0035;
/// How far above the rotary axis the tool is at the start, mm.
const START: f64 = 250.0;
/// Between two places of the tool that are looked at, mm on the surface of the cylinder, where they are farther apart than
/// on a floor. Half of it must be less than what the smallest tool of 1.5 has beside its centre [`NEAR`] below its rim:
/// the root of 1.5² - (1.5 - 0.0035)² is 0.102.
const STEP: f64 = 0.2;

/// A machine: its name in scenes, how the program lays the tool across the rotary axis, and the directions while that is
/// at 0: along the tool, along the rotary axis.
struct Machine {
    letter: char,
    text: &'static str,
    tilts: bool,
    up: DVec3,
    along: DVec3,
}

const AXES: &str = "axes: [{axis: X, min: -1000, max: 1000, rapid: 20000}, {axis: Y, min: -1000, max: 1000, rapid: 20000}, {axis: Z, min: -1000, max: 1000, rapid: 15000}]";

fn machine(kind: usize) -> Machine {
    match kind {
        0 => Machine {
            letter: 'A',
            text: "rotary: [{axis: A, carries: workpiece, rapid: 3600, centre: CENTRE}]",
            tilts: false,
            up: DVec3::Z,
            along: DVec3::X,
        },
        1 => Machine {
            letter: 'B',
            text: "rotary: [{axis: B, carries: workpiece, rapid: 3600, centre: CENTRE}]",
            tilts: false,
            up: DVec3::Z,
            along: DVec3::Y,
        },
        _ => Machine {
            letter: 'C',
            text: "rotary: [{axis: C, carries: workpiece, rapid: 3600, centre: CENTRE}, {axis: B, carries: tool, min: -120, max: 120, rapid: 3600}], pivot: 120",
            tilts: true,
            up: DVec3::X,
            along: DVec3::Z,
        },
    }
}

/// A tool on the workpiece: its tip and its direction, as components along the tool at 0, in the direction of growing
/// coordinates, and along the rotary axis.
#[derive(Clone, Copy, Debug)]
struct Pose {
    tip: DVec3,
    up: DVec2,
    rapid: bool,
    /// Where it is on the machine: angle in degrees and the tip as above, without the turn.
    angle: f64,
    seen: DVec3,
}

impl Pose {
    fn new(machine: &Machine, centre: DVec3, tip: DVec3, angle: f64, rapid: bool) -> Self {
        let arm = tip - centre;
        let seen = DVec3::new(arm.dot(machine.up), arm.dot(machine.along.cross(machine.up)), arm.dot(machine.along));
        let (sine, cosine) = angle.to_radians().sin_cos();
        let tip = DVec3::new(seen.x * cosine - seen.y * sine, seen.x * sine + seen.y * cosine, seen.z);
        Self { tip, up: DVec2::new(cosine, sine), rapid, angle, seen }
    }

    /// The distance of a point from the axis of the tool, and how far above the tip it is.
    fn sees(&self, point: DVec3) -> (f64, f64) {
        let arm = point - self.tip;
        let height = arm.x * self.up.x + arm.y * self.up.y;
        ((arm - DVec3::new(self.up.x, self.up.y, 0.0) * height).length(), height)
    }
}

/// A move of all axes over a cylinder of a radius: its poses, in steps.
fn poses(events: &[EventKind], machine: &Machine, centre: DVec3, radius: f64) -> Vec<Vec<Pose>> {
    let mut angle = 0.0;
    let mut all = Vec::new();
    // Without a move before the cycle the tool has not left where the scene puts it.
    let mut here = centre + machine.up * START;
    for (n, event) in events.iter().enumerate() {
        let turned = |event: &EventKind| match event {
            EventKind::Turn { axes, together, rapid, .. } => axes
                .iter()
                .find(|axis| axis.axis.letter() == machine.letter)
                .map(|axis| (axis.machine, *together, *rapid)),
            _ => None,
        };
        let (from, to, after, rapid) = match event {
            EventKind::Move { kind, path, .. } => {
                let after = events.get(n + 1).and_then(turned).filter(|(_, together, _)| *together);
                let rapid = matches!(kind, MoveKind::Rapid);
                (path.at(0.0), path.at(1.0), after.map_or(angle, |(after, ..)| after), rapid)
            }
            EventKind::Turn { .. } => match turned(event) {
                Some((after, false, rapid)) => (here, here, after, rapid),
                _ => continue,
            },
            _ => continue,
        };
        let widest = (to - centre).length().max(radius);
        let far = (to - from).length() + (after - angle).to_radians().abs() * widest;
        let count = (far / STEP).ceil().max(1.0);
        let pose = |n: usize| {
            let share = n as f64 / count;
            Pose::new(machine, centre, from.lerp(to, share), angle + (after - angle) * share, rapid)
        };
        all.push((0..=count as usize).map(pose).collect());
        (angle, here) = (after, to);
    }
    all
}

/// A contour in the development: corners, rounded or not, and points on it with their directions.
#[derive(Clone, Debug)]
struct Contour {
    corners: Vec<DVec2>,
    rounding: f64,
    /// With their directions, and how far the next corner is away where there is one.
    points: Vec<(DVec2, DVec2, f64)>,
}

impl Contour {
    fn new(start: DVec2, legs: &[(f64, f64)], rounding: f64) -> Self {
        let mut corners = vec![start];
        for (heading, length) in legs {
            let last = corners[corners.len() - 1];
            corners.push(last + DVec2::from_angle(heading.to_radians()) * *length);
        }
        // As they are written in the program.
        let corners: Vec<DVec2> = corners.iter().map(|at| (*at * 1e4).round() / 1e4).collect();
        let mut points = Vec::new();
        let mut cut = 0.0;
        for n in 1..corners.len() {
            let (from, to) = (corners[n - 1], corners[n]);
            let along = (to - from).normalize();
            let next = corners.get(n + 1).map(|next| (*next - to).normalize());
            let turn = next.map_or(0.0, |next| along.angle_to(next));
            let trim = if rounding > 0.0 { rounding * (turn.abs() / 2.0).tan() } else { 0.0 };
            let (first, last) = (from + along * cut, to - along * trim);
            let count = (first.distance(last) / STEP).ceil().max(1.0);
            points.extend((0..=count as usize).map(|k| {
                let at = first.lerp(last, k as f64 / count);
                let ends = if n == 1 { f64::INFINITY } else { at.distance(from) };
                let begins = if next.is_none() { f64::INFINITY } else { at.distance(to) };
                (at, along, ends.min(begins))
            }));
            if rounding > 0.0 && turn.abs() > 1e-9 {
                let centre = last + along.perp() * rounding * turn.signum();
                let count = (rounding * turn.abs() / 0.02).ceil();
                points.extend((1..count as usize).map(|k| {
                    let turned = DVec2::from_angle(turn * k as f64 / count);
                    (centre + turned.rotate(last - centre), turned.rotate(along), 0.0)
                }));
            }
            cut = trim;
        }
        Self { corners, rounding, points }
    }

    fn distance(&self, at: DVec2) -> f64 {
        // Between two points the contour is straight, or nearly.
        let near = |pair: &[(DVec2, DVec2, f64)]| {
            let (from, way) = (pair[0].0, pair[1].0 - pair[0].0);
            let share = if way.length_squared() > 0.0 {
                ((at - from).dot(way) / way.length_squared()).clamp(0.0, 1.0)
            } else {
                0.0
            };
            (from + way * share).distance(at)
        };
        self.points.windows(2).map(near).fold(f64::INFINITY, f64::min)
    }

    /// The subprogram, of which the view makes the contour; `degree` is how long one is where X is in degrees.
    fn program(&self, side: &str, degree: Option<f64>, view: &View) -> String {
        let mut text = "LBL 1\n".to_owned();
        for (n, at) in self.corners.iter().enumerate() {
            let at = view.before(*at);
            let x = degree.map_or(at.x, |degree| at.x * view.scale / degree);
            let _ = writeln!(text, "L X{x:+.12} Y{:+.12} {}", at.y, if n == 0 { side } else { "" });
            if self.rounding > 0.0 && n > 0 && n + 1 < self.corners.len() {
                let _ = writeln!(text, "RND R{}", self.rounding / view.scale);
            }
        }
        text + "LBL 0\n"
    }
}

/// Mirroring in X and Y, then a rotation, of the development, and scaling of everything but the tool.
#[derive(Clone, Copy, Debug)]
struct View {
    mirror: [bool; 2],
    turn: f64,
    scale: f64,
}

impl View {
    /// The point of the program of which it makes a point.
    fn before(&self, at: DVec2) -> DVec2 {
        let at = DVec2::from_angle(-self.turn.to_radians()).rotate(at) / self.scale;
        let flip = |yes: bool, value: f64| if yes { -value } else { value };
        DVec2::new(flip(self.mirror[0], at.x), flip(self.mirror[1], at.y))
    }

    fn flips(&self) -> bool {
        self.mirror[0] != self.mirror[1]
    }

    /// Blocks: what is defined later acts on what is defined before.
    fn blocks(&self) -> String {
        let mut text = String::new();
        if self.turn != 0.0 {
            let _ = writeln!(text, "CYCL DEF 10.0 ROTATION\nCYCL DEF 10.1 ROT{:+}", self.turn);
        }
        if self.mirror != [false; 2] {
            let letters = [("X", self.mirror[0]), ("Y", self.mirror[1])].into_iter().filter(|(_, yes)| *yes);
            let letters: Vec<&str> = letters.map(|(letter, _)| letter).collect();
            let _ = writeln!(text, "CYCL DEF 8.0 MIRROR IMAGE\nCYCL DEF 8.1 {}", letters.join(" "));
        }
        if self.scale != 1.0 {
            let _ = writeln!(text, "CYCL DEF 11.0 SCALING\nCYCL DEF 11.1 SCL {}", self.scale);
        }
        text
    }
}

fn views() -> impl Strategy<Value = View> {
    let turn = prop_oneof![2 => Just(0.0), 1 => (-180.0..180.0_f64).prop_map(f64::round)];
    let scale = prop_oneof![2 => Just(1.0), 1 => Just(0.5), 1 => Just(1.25)];
    (any::<[bool; 2]>(), any::<bool>(), turn, scale).prop_map(|(mirror, plain, turn, scale)| View {
        mirror: mirror.map(|yes| yes && !plain),
        turn,
        scale,
    })
}

/// What a case is about.
#[derive(Clone, Debug)]
struct Case {
    view: View,
    kind: usize,
    centre: DVec3,
    radius: f64,
    depth: f64,
    infeed: f64,
    tool: f64,
    allowance: f64,
    contour: Contour,
    left: bool,
    degrees: bool,
}

impl Case {
    fn run(&self, cycle: &str) -> (Outcome, Vec<EventKind>) {
        let machine = machine(self.kind);
        let Built { files, catalogue, .. } = built();
        let DVec3 { x, y, z } = self.centre;
        let text = machine.text.replace("CENTRE", &format!("[{x}, {y}, {z}]"));
        let scene = format!(
            "scene: 1\nmachine: {{spindle: Z, {AXES}, {text}}}\ntools: [{{T: 1, L: 80, R: {}}}]\n\
             presets: {{active: 1, rows: [{{NO: 1, X: {x}, Y: {y}, Z: {z}}}]}}\nstart: [0, 0, {START}]\n",
            self.tool
        );
        let parsed = Scene::parse(&Source::new("scene.yaml", scene.clone()), files);
        let scene = parsed.unwrap_or_else(|found| panic!("{found:?}\n{scene}"));
        let side = if self.left != self.view.flips() { "RL" } else { "RR" };
        let degree = self.degrees.then_some(self.radius * PI / 180.0);
        let tilt = if machine.tilts { "L X+250 Y+0 R0 FMAX\nPLANE SPATIAL SPA+0 SPB+90 SPC+0 TURN FMAX\n" } else { "" };
        let program = format!(
            "BEGIN PGM LAW MM\nTOOL CALL 1 Z S2000\n{tilt}L {}+0 R0 FMAX M3\nCYCL DEF 14.0 CONTOUR\nCYCL DEF 14.1 CONTOUR LABEL 1\n\
             {}{cycle}CYCL CALL\nM30\n{}END PGM LAW MM\n",
            machine.letter,
            self.view.blocks(),
            self.contour.program(side, degree, &self.view)
        );
        let tree = syntax::parse(&Source::new("LAW.H", program));
        let mut events = Vec::new();
        let engine = Engine::new(&tree, catalogue.on("tnc640").expect("a control"), &scene, &NoTexts);
        let outcome = engine.with_catalogue(catalogue).run(&mut |event| events.push(event));
        // Where the tool is when the cycle begins, and what it does.
        let begins = events.iter().position(|event| event.at.cycle.is_some()).unwrap_or(events.len());
        let is_move = |event: &&Event| matches!(event.kind, EventKind::Move { .. });
        let before = events[..begins].iter().rfind(is_move).filter(|_| !machine.tilts).cloned();
        let own = events.drain(begins..).filter(|event| event.at.cycle.is_some());
        let events = before.into_iter().chain(own).map(|event| event.kind).collect();
        (outcome, events)
    }

    fn common(&self) -> String {
        format!(
            "Q1={} Q3={} Q6={} Q10={} Q11=100 Q12=250 Q16={} Q17={}",
            -self.depth / self.view.scale,
            self.allowance / self.view.scale,
            self.clearance() / self.view.scale,
            self.infeed / self.view.scale,
            self.radius / self.view.scale,
            i32::from(!self.degrees)
        )
    }

    fn clearance(&self) -> f64 {
        self.tool + 1.0
    }

    fn floor(&self) -> f64 {
        self.radius - self.depth
    }

    /// Whether a height is a level of an infeed.
    fn is_level(&self, height: f64) -> bool {
        let infeeds = (self.radius - height) / self.infeed;
        (infeeds - infeeds.round()).abs() < 1e-9 || (height - self.floor()).abs() < 1e-9
    }

    /// The moves, with what holds for each cycle: at rapid traverse the tool goes along itself, or over the cylinder;
    /// at a feed down, or along a level.
    fn moves(&self, events: &[EventKind]) -> Vec<Vec<Pose>> {
        let all = poses(events, &machine(self.kind), self.centre, self.radius);
        for made in &all {
            let (first, last) = (made[0], made[made.len() - 1]);
            let straight = (first.angle - last.angle).abs() < 1e-9
                && (first.seen.y - last.seen.y).abs() < 1e-9
                && (first.seen.z - last.seen.z).abs() < 1e-9;
            let lowest = first.seen.x.min(last.seen.x);
            if first.rapid {
                let clear = lowest > self.radius + self.clearance() - 1e-6;
                assert!(clear || (straight && last.seen.x > first.seen.x), "rapid {first:?} to {last:?}");
            } else {
                assert!(straight || self.is_level(first.seen.x) && self.is_level(last.seen.x), "{first:?} to {last:?}");
            }
        }
        all
    }

    /// The places of the tool in which it mills at the floor.
    fn on_floor(&self, events: &[EventKind]) -> Vec<Pose> {
        let all = self.moves(events).into_iter().flatten();
        all.filter(|pose| !pose.rapid && (pose.seen.x - self.floor()).abs() < 1e-9).collect()
    }

    /// A point at a height over the axis of the cylinder, beside a point of the centre path: in the plane across the
    /// radius there, at right angles to the path as it is at that height. Component order as of [`Pose::tip`].
    fn at_wall(&self, (at, along, _): (DVec2, DVec2, f64), height: f64, beside: f64) -> DVec3 {
        let normal = DVec2::new(along.x * height / self.radius, along.y).normalize().perp() * beside;
        let (sine, cosine) = (at.x / self.radius).sin_cos();
        DVec3::new(height * cosine - normal.x * sine, height * sine + normal.x * cosine, at.y + normal.y)
    }
}

fn contours(rounded: bool) -> impl Strategy<Value = Contour> {
    let heading = prop_oneof![3 => 12.0..168.0_f64, 1 => Just(90.0_f64), 1 => Just(15.0_f64)];
    let first = prop_oneof![3 => 12.0..168.0_f64, 1 => Just(90.0_f64), 1 => Just(0.0_f64)];
    let legs = proptest::collection::vec((heading, 22.0..40.0_f64), 0..3);
    let rounding = if rounded { prop_oneof![Just(0.0), 2.0..4.0_f64].boxed() } else { Just(0.0).boxed() };
    (-40.0..40.0_f64, -60.0..60.0_f64, (first, 22.0..40.0_f64), legs, rounding).prop_map(
        |(x, y, first, rest, rounding)| {
            let legs: Vec<(f64, f64)> = std::iter::once(first).chain(rest).collect();
            // A corner takes its share of both legs: half of one that has a corner at either end.
            let room = |n: usize| legs[n].1 / if n == 0 || n + 1 == legs.len() { 1.0 } else { 2.0 };
            let fits =
                |n: usize| room(n - 1).min(room(n)) / ((legs[n].0 - legs[n - 1].0).to_radians().abs() / 2.0).tan();
            let widest = (1..legs.len()).map(fits).fold(f64::INFINITY, f64::min);
            let rounding = (rounding.min(0.9 * widest) * 100.0_f64).floor() / 100.0;
            Contour::new(DVec2::new(x, y), &legs, rounding)
        },
    )
}

fn cases(rounded: bool) -> impl Strategy<Value = Case> {
    let centre = (-80.0..80.0_f64, -80.0..80.0_f64, -80.0..80.0_f64);
    let depth = (1.0..9.0_f64, 0.8..5.0_f64);
    (
        (0..3usize, centre, 35.0..70.0_f64, depth, 1.5..4.0_f64, 0.0..0.6_f64),
        (contours(rounded), any::<bool>(), any::<bool>(), views()),
    )
        .prop_map(
            |((kind, (x, y, z), radius, (depth, infeed), tool, allowance), (contour, left, degrees, view))| {
                let rounded = |value: f64| (value * 1e3).round() / 1e3;
                Case {
                    view,
                    kind,
                    centre: DVec3::new(rounded(x), rounded(y), rounded(z)),
                    radius: rounded(radius),
                    depth: rounded(depth),
                    infeed: rounded(infeed),
                    tool: rounded(tool),
                    allowance: rounded(allowance),
                    contour,
                    left,
                    degrees,
                }
            },
        )
}

laws! {
    #![proptest_config(crate::cases::config(50))]

    /// The tool points at the rotary axis; on the development of the surface its centre is its radius and the allowance
    /// beside the contour, on the side that the program says; the feed is that along the development.
    #[test]
    fn a_contour_is_followed_on_the_cylinder(case in cases(true)) {
        let (outcome, events) = case.run(&format!("CYCL DEF 27 CYLINDER SURFACE {}\n", case.common()));
        prop_assert_eq!(outcome.status, Status::Done, "{:?}", outcome.fault);
        let (mut milled, mut far) = (0, 0.0);
        for made in case.moves(&events) {
            prop_assert!(made.iter().all(|pose| pose.seen.y.abs() < 1e-6));
            let developed = |pose: &Pose| DVec2::new(pose.angle.to_radians() * case.radius, pose.seen.z);
            let (first, last) = (made[0], made[made.len() - 1]);
            let along = developed(&first).distance(developed(&last)) > 1e-6;
            if first.rapid || !along {
                continue;
            }
            far += developed(&first).distance(developed(&last));
            for pose in &made {
                milled += 1;
                let distance = case.contour.distance(developed(pose));
                prop_assert!((distance - case.tool - case.allowance).abs() < NEAR, "{distance} at {:?}", developed(pose));
            }
            // On its side, where the nearest point is not a corner.
            let middle = developed(&made[made.len() / 2]);
            let (near, heading, corner) = *case.contour.points.iter().min_by(|(a, ..), (b, ..)| {
                a.distance_squared(middle).total_cmp(&b.distance_squared(middle))
            }).expect("points");
            let side = heading.perp_dot(middle - near);
            prop_assert!(corner < 1.0 || (side > 0.0) == case.left, "{middle} beside {near} along {heading}");
        }
        prop_assert!(milled > 10 && far > 0.0);
        // Time: what the moves take at their feeds is the way on the development at Q12.
        let mut minutes = 0.0;
        for (n, event) in events.iter().enumerate() {
            minutes += match event {
                EventKind::Move { kind: MoveKind::Feed, path, feed, .. } if *feed != 100.0 => path.length() / feed,
                EventKind::Turn { axes, feed, rapid: false, together: false } => {
                    axes.iter().map(|axis| (axis.to - axis.from).abs()).sum::<f64>() / feed
                }
                _ => 0.0,
            };
            // Both axes of one move take the same time.
            if let (EventKind::Move { kind: MoveKind::Feed, path, feed, .. }, Some(EventKind::Turn { axes, feed: turning, together: true, .. })) = (event, events.get(n + 1)) {
                let way = (axes[0].to - axes[0].from).abs();
                prop_assert!((path.length() / feed - way / turning).abs() < 1e-9);
            }
        }
        prop_assert!((minutes * 250.0 - far).abs() < 1e-6 * far.max(1.0), "{minutes} min for {far} mm");
    }

    /// The tool never leaves the slot that a tool of its width would mill, and comes within the tolerance of its walls at
    /// every depth; exactly where the path is straight round the cylinder or along it.
    #[test]
    fn a_slot_is_as_wide_as_it_shall_be(case in cases(true), wider in 0.0..1.8_f64, tolerance in prop_oneof![Just(0.0), 0.01..0.1_f64]) {
        let width = 2.0 * (case.tool * (1.0 + wider / 2.0) + case.allowance);
        let width = (width * 1e3).ceil() / 1e3;
        let (outcome, events) =
            case.run(&format!("CYCL DEF 28 CYLINDER SURFACE {} Q20={} Q21={}\n", case.common(), width / case.view.scale, tolerance / case.view.scale));
        prop_assert_eq!(outcome.status, Status::Done, "{:?}", outcome.fault);
        let half = width / 2.0 - case.allowance;
        for pose in case.moves(&events).into_iter().flatten().filter(|pose| !pose.rapid) {
            // A tool as wide as the slot whose axis is parallel, and that has this one in it.
            let round = pose.angle.to_radians() * case.radius;
            let holds = case.contour.points.windows(2).any(|pair| {
                let (from, to) = (pair[0].0, pair[1].0);
                let (least, most) = (from.x.min(to.x) - 1e-3, from.x.max(to.x) + 1e-3);
                let share = if (to.x - from.x).abs() < 1e-6 { (pose.seen.z - from.y) / (to.y - from.y) } else { (round - from.x) / (to.x - from.x) };
                let at = from.lerp(to, share.clamp(0.0, 1.0));
                // Along the axis a chord is farther from an oblique path than across it.
                let spare = NEAR * (from.distance(to) / (to.x - from.x).abs()).min(10.0);
                let inside = DVec2::new(pose.seen.y, pose.seen.z - at.y).length() <= half - case.tool + spare;
                (least..=most).contains(&round) && inside
            });
            prop_assert!(holds, "{pose:?} leaves the slot");
        }
        let floor = case.on_floor(&events);
        for (n, point) in case.contour.points.iter().enumerate().filter(|(n, (.., corner))| n % 7 == 3 && *corner > half * 4.0) {
            let straight = point.1.x.abs() < 1e-9 || point.1.y.abs() < 1e-9;
            if tolerance == 0.0 && !straight {
                continue;
            }
            // Near the ends the wall is round as the tool is.
            let ends = [case.contour.corners[0], case.contour.corners[case.contour.corners.len() - 1]];
            if ends.iter().any(|end| end.distance(point.0) < 2.0 * half) {
                continue;
            }
            for height in [case.floor() + 1e-3, case.radius - case.depth / 2.0, case.radius] {
                for side in [1.0, -1.0] {
                    let milled = case.at_wall(*point, height, side * (half - tolerance - NEAR));
                    let is_milled = floor.iter().any(|pose| {
                        let (far, above) = pose.sees(milled);
                        far < case.tool && above > -1e-9
                    });
                    prop_assert!(is_milled, "point {n} at {height}, side {side}");
                }
            }
        }
    }

    /// The ridge stays as it shall be, and its walls are milled: exactly on the surface, deeper down exactly where the
    /// path is straight round the cylinder or along it.
    #[test]
    fn a_ridge_stays_and_its_walls_are_milled(case in cases(true), width in 3.0..9.0_f64) {
        // Where the path comes back beside its beginning there is no room for the starting point.
        let legs: Vec<DVec2> = case.contour.corners.windows(2).map(|pair| pair[1] - pair[0]).collect();
        prop_assume!(legs.iter().all(|leg| legs[0].angle_to(*leg).abs() < 75.0_f64.to_radians()));
        let width = (width * 1e3).round() / 1e3;
        let (outcome, events) =
            case.run(&format!("CYCL DEF 29 CYLINDER SURFACE RIDGE {} Q20={}\n", case.common(), width / case.view.scale));
        prop_assert_eq!(outcome.status, Status::Done, "{:?}", outcome.fault);
        let half = width / 2.0 + case.allowance;
        let floor = case.on_floor(&events);
        // An oblique path is steeper at the floor by this at the worst, and there the tool comes nearer.
        let ratio = case.floor() / case.radius;
        let steeper = ((1.0 - ratio) / (2.0 * ratio.sqrt())).atan();
        let oblique = (half + 2.0 * case.tool) * (1.0 - steeper.cos());
        // Inside an acute corner the tool comes to the walls only so many times its distance from the path away from it.
        let turns = legs.windows(2).map(|pair| pair[0].angle_to(pair[1]).abs());
        let acute = turns.fold(0.0_f64, |most, turn| most.max((turn / 2.0).tan()));
        for (n, point) in case.contour.points.iter().enumerate().filter(|(n, _)| n % 5 == 2) {
            // Beside a corner the tool is on the way of another element, too.
            let along_axis = point.1.x.abs() < 1e-9 || point.1.y.abs() < 1e-9;
            let straight = along_axis && point.2 > (half + case.tool) * 3.0;
            for height in [case.floor() + 1e-3, case.radius - case.depth / 2.0, case.radius] {
                let lost = if straight || height == case.radius { 0.0 } else { oblique };
                for side in [1.0, -1.0] {
                    let kept = case.at_wall(*point, height, side * (half - lost - 2.0 * NEAR).max(0.0));
                    let cut = floor.iter().find(|pose| {
                        let (far, above) = pose.sees(kept);
                        far < case.tool - 1e-9 && above > -1e-9
                    });
                    prop_assert!(cut.is_none(), "point {n} at {height}, side {side}: {cut:?}");
                }
            }
            let inner = (half + case.tool) * (1.1 * acute + 1.0).max(3.0) + case.contour.rounding * acute.max(1.0);
            if point.2 > inner {
                for side in [1.0, -1.0] {
                    let milled = case.at_wall(*point, case.radius, side * (half + 2.0 * NEAR));
                    prop_assert!(floor.iter().any(|pose| pose.sees(milled).0 < case.tool), "point {n}, side {side}");
                }
            }
        }
        // The way begins and ends at the starting point, half the width and the diameter of the tool beside the path.
        let (begin, heading, _) = case.contour.points[0];
        let beside = heading.perp() * (half + 2.0 * case.tool) * if case.left { 1.0 } else { -1.0 };
        for pose in [floor[0], floor[floor.len() - 1]] {
            let at = DVec2::new(pose.seen.y, pose.seen.z - begin.y);
            prop_assert!(at.distance(beside) < 1e-6 && (pose.angle.to_radians() * case.radius - begin.x).abs() < 1e-6, "{pose:?}");
        }
    }
}
