//! Laws of contours over random outlines of lines, arcs, roundings and chamfers, on both sides and in both directions:
//! the tool's centre keeps the distance of its radius, reaches every point of the outline that it can reach, and leaves
//! the nominal part.
//!
//! Distances are calculated here from points, with plain trigonometry. Roundings and chamfers are proven first, on the
//! path without compensation, against the corners of the outline.
#![expect(clippy::disallowed_methods, reason = "truths are calculated with plain trigonometry")]
use std::f64::consts::TAU;
use std::fmt::Write as _;
use std::sync::OnceLock;

use ciklo::diag::Source;
use ciklo::engine::run::{Engine, EventKind, MoveKind, NoTexts, Status};
use ciklo::engine::scene::Scene;
use ciklo::engine::stock::Machining;
use ciklo::spec::Catalogue;
use ciklo::syntax;
use glam::DVec2;
use proptest::prelude::*;

/// What a distance may be wrong, mm.
const NEAR: f64 = 1e-6;
/// Points looked at on each piece of a path.
const SAMPLES: usize = 40;

fn world() -> &'static (ciklo::data::Files, Catalogue) {
    static WORLD: OnceLock<(ciklo::data::Files, Catalogue)> = OnceLock::new();
    WORLD.get_or_init(|| {
        let files = ciklo::data::embedded();
        let (catalogue, _) = Catalogue::load(&files);
        (files, catalogue)
    })
}

/// A piece of a path in the plane.
#[derive(Clone, Copy, Debug)]
struct Piece {
    line: usize,
    from: DVec2,
    to: DVec2,
    /// Centre, radius and signed angle of an arc.
    arc: Option<(DVec2, f64, f64)>,
}

impl Piece {
    fn at(&self, t: f64) -> DVec2 {
        match self.arc {
            None => self.from + (self.to - self.from) * t,
            Some((centre, _, angle)) => {
                let (s, c) = (angle * t).sin_cos();
                let arm = self.from - centre;
                centre + DVec2::new(arm.x * c - arm.y * s, arm.x * s + arm.y * c)
            }
        }
    }

    fn heading(&self, at: DVec2) -> DVec2 {
        match self.arc {
            None => (self.to - self.from).normalize(),
            Some((centre, _, angle)) => (at - centre).perp().normalize() * angle.signum(),
        }
    }

    /// The distance of a point from it.
    fn distance(&self, point: DVec2) -> f64 {
        let ends = point.distance(self.from).min(point.distance(self.to));
        match self.arc {
            None => {
                let way = self.to - self.from;
                let t = ((point - self.from).dot(way) / way.length_squared()).clamp(0.0, 1.0);
                point.distance(self.from + way * t)
            }
            Some((centre, radius, angle)) => {
                let (a, b) = (self.from - centre, point - centre);
                let turn = ((b.y.atan2(b.x) - a.y.atan2(a.x)) * angle.signum()).rem_euclid(TAU);
                if turn <= angle.abs() { (b.length() - radius).abs().min(ends) } else { ends }
            }
        }
    }
}

fn far(path: &[Piece], point: DVec2) -> f64 {
    path.iter().map(|piece| piece.distance(point)).fold(f64::INFINITY, f64::min)
}

/// A corner: nothing, a rounding, or a chamfer if it is one of lines.
#[derive(Clone, Copy, Debug)]
enum Corner {
    Sharp,
    Round(f64),
    Broken(f64),
}

/// A closed outline about the origin: corners, and how far each edge bulges to the left, as a share of its length.
#[derive(Clone, Debug)]
struct Outline {
    points: Vec<DVec2>,
    bulges: Vec<f64>,
    corners: Vec<Corner>,
    left: bool,
    tool: f64,
}

prop_compose! {
    fn outline()(
        corners in 3..8_usize, clockwise in any::<bool>(), left in any::<bool>(), tool in 0.5..5.0_f64,
    )(
        radii in prop::collection::vec(prop_oneof![3 => 38.0..55.0_f64, 1 => 18.0..30.0_f64], corners),
        shifts in prop::collection::vec(-0.15..0.15_f64, corners),
        bulges in prop::collection::vec(prop_oneof![2 => Just(0.0), 1 => 0.05..0.3_f64, 1 => -0.3..-0.05_f64], corners),
        kinds in prop::collection::vec(prop_oneof![
            1 => Just(Corner::Sharp),
            1 => (0.3..7.0_f64).prop_map(Corner::Round),
            1 => (0.3..5.0_f64).prop_map(Corner::Broken),
        ], corners),
        clockwise in Just(clockwise), left in Just(left), tool in Just(tool),
    ) -> Outline {
        let count = radii.len();
        let mut points: Vec<DVec2> = (0..count).map(|n| {
            let angle = TAU * (n as f64 + shifts[n]) / count as f64;
            let point = DVec2::new(angle.cos(), angle.sin()) * radii[n];
            // As a program says it.
            DVec2::new((point.x * 1e3).round() / 1e3, (point.y * 1e3).round() / 1e3)
        }).collect();
        if clockwise {
            points.reverse();
        }
        // The first edge is straight: the contour begins and ends in its middle.
        let mut bulges = bulges;
        bulges[0] = 0.0;
        let straight = |n: usize| bulges[n % count] == 0.0;
        let corners = kinds.iter().enumerate().map(|(n, kind)| match kind {
            Corner::Broken(_) if !straight(n) || !straight(n + 1) => Corner::Sharp,
            kind => *kind,
        }).collect();
        Outline { points, bulges, corners, left, tool }
    }
}

impl Outline {
    /// The program: edge n leads to point n + 1, where corner n is.
    fn program(&self, compensation: &str) -> String {
        let count = self.points.len();
        let mut text = "BEGIN PGM LAW MM\nBLK FORM 0.1 Z X-70 Y-70 Z-10\nBLK FORM 0.2 X+70 Y+70 Z+0\n\
            TOOL CALL 1 Z S1000 F500\nL X+90 Y+90 R0 FMAX M3\nL Z-5 R0 F200\n"
            .to_owned();
        let begin = (self.points[0] + self.points[1]) / 2.0;
        let _ = writeln!(text, "L X{:+} Y{:+} {compensation} F500", begin.x, begin.y);
        for n in 0..count {
            let (from, to) = (self.points[n], self.points[(n + 1) % count]);
            let _ = if self.bulges[n] == 0.0 {
                writeln!(text, "L X{:+} Y{:+}", to.x, to.y)
            } else {
                writeln!(text, "CR X{:+} Y{:+} R{:+} DR{}", to.x, to.y, radius(from, to, self.bulges[n]), {
                    // To the left of the chord means clockwise.
                    if self.bulges[n] > 0.0 { '-' } else { '+' }
                })
            };
            let _ = match self.corners[n] {
                Corner::Sharp => Ok(()),
                Corner::Round(radius) => writeln!(text, "RND R{radius}"),
                Corner::Broken(leg) => writeln!(text, "CHF {leg}"),
            };
        }
        let _ = writeln!(text, "L X{:+} Y{:+}", begin.x, begin.y);
        text + "L X+95 Y+95 R0\nL Z+50 R0 FMAX M30\nEND PGM LAW MM\n"
    }
}

/// The radius of an arc over a chord.
fn radius(from: DVec2, to: DVec2, bulge: f64) -> f64 {
    let chord = from.distance(to);
    let rise = chord * bulge.abs();
    ((chord * chord / 4.0 + rise * rise) / (2.0 * rise) * 1e6).round() / 1e6
}

struct Ran {
    code: String,
    status: Status,
    path: Vec<Piece>,
    stock: ciklo::engine::stock::Stock,
}

fn run(program: &str, tool: f64) -> Ran {
    let (files, catalogue) = world();
    let scene = format!("scene: 1\ntools: [{{T: 1, L: 100, R: {tool}}}]\n");
    let scene = Scene::parse(&Source::new("scene.yaml", scene.as_str()), files).expect("a scene");
    let tree = syntax::parse(&Source::new("LAW.H", program));
    let on = catalogue.on("tnc640").expect("a control");
    let mut machining = Machining::new(&tree, &scene, Some(1.1)).expect("a stock");
    let mut path = Vec::new();
    let outcome = Engine::new(&tree, on, &scene, &NoTexts).run(&mut |event| {
        machining.see(&event);
        if let EventKind::Move { kind, from, to, .. } = &event.kind
            && from.truncate() != to.truncate()
        {
            let (from, to) = (from.truncate(), to.truncate());
            let arc = match kind {
                MoveKind::Arc { centre, angle, .. } => {
                    let centre = centre.truncate();
                    Some((centre, from.distance(centre), angle.to_radians()))
                }
                _ => None,
            };
            path.push(Piece { line: event.at.line, from, to, arc });
        }
    });
    let code = outcome.fault.as_ref().map_or_else(String::new, |fault| fault.code.to_string());
    Ran { code, status: outcome.status, path, stock: machining.finish().0 }
}

/// Pieces of the contour: not the way to it nor away from it.
fn contour(program: &str, path: &[Piece]) -> Vec<Piece> {
    let lines: Vec<&str> = program.lines().collect();
    let last = lines.iter().position(|line| line.contains("X+95")).expect("the end") + 1;
    path.iter().filter(|piece| piece.line > 7 && piece.line < last).copied().collect()
}

/// Roundings and chamfers: radius, tangents, and where they lie.
fn corners_are_right(outline: &Outline, nominal: &[Piece]) -> Result<(), TestCaseError> {
    let count = outline.points.len();
    let mut line = 7;
    for n in 0..count {
        line += 1;
        let corner = outline.points[(n + 1) % count];
        let find = |line: usize| nominal.iter().position(|piece| piece.line == line);
        match outline.corners[n] {
            Corner::Sharp => {}
            Corner::Round(wanted) => {
                line += 1;
                let Some(index) = find(line) else { continue };
                let (piece, before, after) = (nominal[index], nominal[index - 1], nominal[index + 1]);
                let (_, radius, angle) = piece.arc.expect("an arc");
                prop_assert!((radius - wanted).abs() < NEAR, "{} is not {}", radius, wanted);
                prop_assert!(angle.abs() < TAU / 2.0, "a rounding of {}", angle);
                for (joint, other) in [(piece.from, before), (piece.to, after)] {
                    let (own, other) = (piece.heading(joint), other.heading(joint));
                    prop_assert!(own.distance(other) < NEAR, "no tangent at {}: {} {}", joint, own, other);
                    prop_assert!(joint.distance(corner) < wanted * 40.0);
                }
            }
            Corner::Broken(leg) => {
                line += 1;
                let Some(index) = find(line) else { continue };
                let piece = nominal[index];
                prop_assert!(piece.arc.is_none());
                for end in [piece.from, piece.to] {
                    prop_assert!((end.distance(corner) - leg).abs() < NEAR, "{} is {}", end, end.distance(corner));
                }
            }
        }
    }
    for pair in nominal.windows(2) {
        prop_assert!(pair[0].to.distance(pair[1].from) < NEAR, "a gap");
    }
    // What is no corner lies on the edges as they were programmed.
    for piece in nominal {
        for t in [0.0, 0.3, 1.0] {
            let point = piece.at(t);
            let near = (0..count).any(|n| {
                let (from, to) = (outline.points[n], outline.points[(n + 1) % count]);
                edge(from, to, outline.bulges[n]).distance(point) < 1e-5
            });
            let is_corner = outline
                .program("R0")
                .lines()
                .nth(piece.line - 1)
                .is_some_and(|text| text.contains("RND") || text.contains("CHF"));
            prop_assert!(near || is_corner, "{} lies on no edge", point);
        }
    }
    Ok(())
}

/// An edge as it is programmed.
fn edge(from: DVec2, to: DVec2, bulge: f64) -> Piece {
    if bulge == 0.0 {
        return Piece { line: 0, from, to, arc: None };
    }
    let radius = radius(from, to, bulge);
    let (chord, middle) = (to - from, (from + to) / 2.0);
    let height = (radius * radius - chord.length_squared() / 4.0).max(0.0).sqrt();
    // It bulges to the left, so the centre lies to the right, and the other way round.
    let centre = middle - chord.perp().normalize() * (height * bulge.signum());
    let angle = -2.0 * (chord.length() / 2.0 / radius).asin() * bulge.signum();
    Piece { line: 0, from, to, arc: Some((centre, radius, angle)) }
}

/// Whether the tool can stand there without cutting into the contour.
fn fits(nominal: &[Piece], centre: DVec2, tool: f64) -> bool {
    far(nominal, centre) >= tool - NEAR
}

fn keeps_its_distance(outline: &Outline) -> Result<(), TestCaseError> {
    let plain = outline.program("R0");
    let nominal = run(&plain, outline.tool);
    if nominal.code == "rounding-impossible" {
        return Err(TestCaseError::reject("no place for a rounding"));
    }
    prop_assert_eq!(nominal.status, Status::Done, "{}\n{}", nominal.code, plain);
    let nominal = contour(&plain, &nominal.path);
    corners_are_right(outline, &nominal)?;

    let program = outline.program(if outline.left { "RL" } else { "RR" });
    let ran = run(&program, outline.tool);
    let both = format!("\ntool radius {}\n{program}", outline.tool);
    let side = if outline.left { 1.0 } else { -1.0 };
    if ran.code == "compensation-too-large" {
        // Somewhere the tool beside the contour would cut into it.
        let cuts = nominal.iter().any(|piece| {
            (0..=SAMPLES).any(|n| {
                let point = piece.at(n as f64 / SAMPLES as f64);
                !fits(&nominal, point + piece.heading(point).perp() * (side * outline.tool), outline.tool)
            })
        });
        prop_assert!(cuts, "refused without a reason{}", both);
        return Ok(());
    }
    prop_assert_eq!(ran.status, Status::Done, "{}{}", ran.code, both);
    let path = contour(&program, &ran.path);
    // A control looks at neighbours only: where others are nearer, the outline is too narrow to judge.
    let lowest = path.iter().flat_map(|piece| (0..=SAMPLES).map(|n| piece.at(n as f64 / SAMPLES as f64)));
    for point in lowest {
        let distance = far(&nominal, point);
        if distance < outline.tool - NEAR {
            return Err(TestCaseError::reject("too narrow elsewhere"));
        }
        prop_assert!((distance - outline.tool).abs() < NEAR, "{} is {} away{}", point, distance, both);
    }
    for pair in path.windows(2) {
        prop_assert!(pair[0].to.distance(pair[1].from) < NEAR, "a gap{}", both);
    }
    // Each point of the outline that the tool can reach is reached.
    for piece in &nominal {
        for n in 0..=SAMPLES {
            let point = piece.at(n as f64 / SAMPLES as f64);
            let centre = point + piece.heading(point).perp() * (side * outline.tool);
            if fits(&nominal, centre, outline.tool) {
                let distance = far(&path, centre);
                prop_assert!(distance < NEAR, "{} is not reached, by {}{}", point, distance, both);
            }
        }
    }
    leaves_the_part(outline, &nominal, &ran.stock, &both)
}

/// Columns beside the contour: on the tool's side they are gone wherever the tool fits, on the other one they stand.
fn leaves_the_part(
    outline: &Outline,
    nominal: &[Piece],
    stock: &ciklo::engine::stock::Stock,
    both: &str,
) -> Result<(), TestCaseError> {
    let (columns, rows) = stock.size();
    for row in 0..rows {
        for column in 0..columns {
            let place = stock.place(column, row);
            let distance = far(nominal, place);
            if !(0.01..outline.tool - 0.01).contains(&distance) {
                continue;
            }
            let nearest = nominal.iter().min_by(|a, b| a.distance(place).total_cmp(&b.distance(place)));
            let nearest = nearest.expect("a piece");
            // The foot of the place, searched for.
            let foot = foot(nearest, place);
            let away = (place - foot) / distance;
            let left = inside(nominal, place) == (area(nominal) > 0.0);
            let top = stock.top(column, row);
            if left == outline.left {
                let centre = foot + away * outline.tool;
                // The way to the contour and away from it cut more.
                if fits(nominal, centre, outline.tool) {
                    prop_assert!(top.is_some_and(|top| (top + 5.0).abs() < NEAR), "{} stands {:?}{}", place, top, both);
                }
            } else if !beside_lead(outline, place) {
                prop_assert!(top.is_some_and(|top| top.abs() < NEAR), "{} was cut {:?}{}", place, top, both);
            }
        }
    }
    Ok(())
}

/// Whether the way to the contour and away from it may cut there.
fn beside_lead(outline: &Outline, place: DVec2) -> bool {
    let middle = (outline.points[0] + outline.points[1]) / 2.0;
    let reach = 2.0 * outline.tool + 0.1;
    let ways = [DVec2::splat(90.0), DVec2::splat(95.0)]
        .map(|end| Piece { line: 0, from: middle, to: end, arc: None }.distance(place));
    ways.iter().any(|far| *far < reach) || place.distance(middle) < reach
}

fn foot(piece: &Piece, point: DVec2) -> DVec2 {
    let ends = if point.distance(piece.from) < point.distance(piece.to) { piece.from } else { piece.to };
    let foot = match piece.arc {
        None => {
            let way = piece.to - piece.from;
            piece.from + way * ((point - piece.from).dot(way) / way.length_squared()).clamp(0.0, 1.0)
        }
        Some((centre, radius, _)) => centre + (point - centre).normalize() * radius,
    };
    if (foot.distance(point) - piece.distance(point)).abs() < NEAR { foot } else { ends }
}

/// Points of the outline close together.
fn polygon(nominal: &[Piece]) -> Vec<DVec2> {
    nominal.iter().flat_map(|piece| (0..200).map(|n| piece.at(f64::from(n) / 200.0))).collect()
}

fn area(nominal: &[Piece]) -> f64 {
    let points = polygon(nominal);
    (0..points.len()).map(|n| points[n].perp_dot(points[(n + 1) % points.len()])).sum::<f64>() / 2.0
}

fn inside(nominal: &[Piece], place: DVec2) -> bool {
    let points = polygon(nominal);
    let crosses = |n: usize| {
        let (a, b) = (points[n], points[(n + 1) % points.len()]);
        (a.y > place.y) != (b.y > place.y) && place.x < a.x + (b.x - a.x) * (place.y - a.y) / (b.y - a.y)
    };
    (0..points.len()).filter(|n| crosses(*n)).count() % 2 == 1
}

proptest! {
    #![proptest_config(ProptestConfig {
        cases: std::env::var("CASES").ok().and_then(|cases| cases.parse().ok()).unwrap_or(48),
        max_global_rejects: 100_000,
        ..ProptestConfig::default()
    })]

    #[test]
    fn the_tool_keeps_the_distance_of_its_radius(outline in outline()) {
        keeps_its_distance(&outline)?;
    }
}
