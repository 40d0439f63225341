//! Closed outlines of lines and arcs, with roundings and chamfers at their corners, level and rising.
use std::f64::consts::TAU;
use std::fmt::Write as _;

use ciklo::engine::run::Status;
use ciklo::engine::stock::Stock;
use glam::DVec2;
use proptest::prelude::*;

use super::path::{NEAR, Piece, View, config, far, run, view};

/// Points looked at on each piece of a path.
const SAMPLES: usize = 40;
/// Where level contours are milled.
const LEVEL: f64 = -5.0;

/// A corner: nothing, a rounding, or a chamfer if it is one of lines.
#[derive(Clone, Copy, Debug)]
enum Corner {
    Sharp,
    Round(f64),
    Broken(f64),
}

/// A closed outline about the origin: corners, and how far each edge bulges to the left, as a share of its length.
#[derive(Clone, Debug)]
pub(super) struct Outline {
    points: Vec<DVec2>,
    bulges: Vec<f64>,
    corners: Vec<Corner>,
    pub(super) left: bool,
    pub(super) tool: f64,
    /// The height at the end of each edge.
    heights: Option<Vec<f64>>,
    pub(super) view: View,
}

prop_compose! {
    pub(super) fn outline(rising: bool)(
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
        heights in prop::collection::vec((-90..10).prop_map(|tenths| f64::from(tenths) / 10.0), corners), view in view(),
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
        Outline { points, bulges, corners, left, tool, heights: rising.then_some(heights), view }
    }
}

impl Outline {
    /// The program: edge n leads to point n + 1, where corner n is.
    fn program(&self, compensation: &str) -> Program {
        let [begin, away] = [self.begin(), DVec2::splat(95.0)].map(|place| self.view.words(place));
        self.program_between(&format!("L {begin} {compensation} F500"), &format!("L {away} R0"))
    }

    /// The middle of the first edge.
    pub(super) fn begin(&self) -> DVec2 {
        (self.points[0] + self.points[1]) / 2.0
    }

    /// The direction of the first edge.
    pub(super) fn heading(&self) -> DVec2 {
        (self.points[1] - self.points[0]).normalize()
    }

    /// The contour between the blocks that lead to it and away from it.
    pub(super) fn program_between(&self, enter: &str, leave: &str) -> Program {
        let count = self.points.len();
        let (view, letter) = (&self.view, self.view.axis.letter());
        let mut text = view.head(LEVEL);
        let first = text.lines().count() + enter.lines().count();
        let begin = self.begin();
        let _ = writeln!(text, "{enter}");
        let height = |n: usize| {
            let height = self.heights.as_ref().map(|heights| heights[n]);
            height.map_or_else(String::new, |height| format!(" {letter}{height:+}"))
        };
        for n in 0..count {
            let (from, to) = (self.points[n], self.points[(n + 1) % count]);
            let _ = if self.bulges[n] == 0.0 {
                writeln!(text, "L {}{}", view.words(to), height(n))
            } else {
                let radius = radius(from, to, self.bulges[n]);
                // To the left of the chord means clockwise.
                let direction = if self.bulges[n] > 0.0 { '-' } else { '+' };
                writeln!(text, "CR {}{} R{radius:+} DR{direction}", view.words(to), height(n))
            };
            let _ = match self.corners[n] {
                Corner::Sharp => Ok(()),
                Corner::Round(radius) => writeln!(text, "RND R{radius}"),
                Corner::Broken(leg) => writeln!(text, "CHF {leg}"),
            };
        }
        let level = if self.heights.is_some() { format!(" {letter}{LEVEL:+}") } else { String::new() };
        let _ = writeln!(text, "L {}{level}", view.words(begin));
        let last = text.lines().count() + 1;
        let text = text + &format!("{leave}\nL {letter}+50 R0 FMAX M30\nEND PGM LAW MM\n");
        Program { text, first, last }
    }
}

/// A program with the lines of the way to the contour and of the way from it.
pub(super) struct Program {
    pub(super) text: String,
    pub(super) first: usize,
    pub(super) last: usize,
}

impl Program {
    /// Pieces of the contour: not the way to it nor away from it.
    fn contour(&self, path: &[Piece]) -> Vec<Piece> {
        path.iter().filter(|piece| piece.line > self.first && piece.line < self.last).copied().collect()
    }

    fn line(&self, number: usize) -> &str {
        self.text.lines().nth(number - 1).unwrap_or_default()
    }

    fn is_corner(&self, number: usize) -> bool {
        let text = self.line(number);
        text.starts_with("RND") || text.starts_with("CHF")
    }
}

/// The radius of an arc over a chord.
fn radius(from: DVec2, to: DVec2, bulge: f64) -> f64 {
    let chord = from.distance(to);
    let rise = chord * bulge.abs();
    ((chord * chord / 4.0 + rise * rise) / (2.0 * rise) * 1e6).round() / 1e6
}

/// Roundings and chamfers: radius, tangents, and where they lie.
fn corners_are_right(outline: &Outline, program: &Program, nominal: &[Piece]) -> Result<(), TestCaseError> {
    let count = outline.points.len();
    let mut line = program.first;
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
            let is_corner = program.is_corner(piece.line);
            prop_assert!(near || is_corner, "{} lies on no edge", point);
        }
    }
    Ok(())
}

/// An edge as it is programmed.
fn edge(from: DVec2, to: DVec2, bulge: f64) -> Piece {
    if bulge == 0.0 {
        return Piece::flat(from, to, None);
    }
    let radius = radius(from, to, bulge);
    let (chord, middle) = (to - from, (from + to) / 2.0);
    let height = (radius * radius - chord.length_squared() / 4.0).max(0.0).sqrt();
    // It bulges to the left, so the centre lies to the right, and the other way round.
    let centre = middle - chord.perp().normalize() * (height * bulge.signum());
    let angle = -2.0 * (chord.length() / 2.0 / radius).asin() * bulge.signum();
    Piece::flat(from, to, Some((centre, radius, angle)))
}

/// Whether the tool can stand there without cutting into the contour.
fn fits(nominal: &[Piece], centre: DVec2, tool: f64) -> bool {
    far(nominal, centre) >= tool - NEAR
}

/// The height of each element is that of its block, a rounding lies at the height before it, and nothing jumps.
fn rises_as_programmed(outline: &Outline, program: &Program, path: &[Piece], both: &str) -> Result<(), TestCaseError> {
    let letter = outline.view.axis.letter();
    let mut height = LEVEL;
    for (index, piece) in path.iter().enumerate() {
        let word = program.line(piece.line).split_whitespace().find_map(|word| word.strip_prefix(letter));
        if let Some(Ok(value)) = word.filter(|_| !program.is_corner(piece.line)).map(str::parse::<f64>) {
            height = value;
        }
        prop_assert!((piece.heights[1] - height).abs() < NEAR, "{:?} is not at {}{}", piece, height, both);
        if let Some(before) = index.checked_sub(1).map(|before| path[before]) {
            let joint = before.heights[1] - piece.heights[0];
            prop_assert!(joint.abs() < NEAR && before.to.distance(piece.from) < NEAR, "a gap at {:?}{}", piece, both);
        }
    }
    Ok(())
}

/// Whether two neighbours meet anywhere else than where one ends and the other one begins.
fn cross(one: &Piece, other: &Piece) -> bool {
    let chords = |piece: &Piece| -> Vec<[DVec2; 2]> {
        (0..200).map(|n| [piece.at(f64::from(n) / 200.0), piece.at(f64::from(n + 1) / 200.0)]).collect()
    };
    let is_joint = |a: DVec2, b: DVec2| a.distance(b) < NEAR;
    let apart = |[a, b]: [DVec2; 2], p: DVec2, q: DVec2| (b - a).perp_dot(p - a) * (b - a).perp_dot(q - a) < 0.0;
    let others = chords(other);
    chords(one).into_iter().any(|[a, b]| {
        others.iter().any(|&[c, d]| !is_joint(a, d) && !is_joint(b, c) && apart([a, b], c, d) && apart([c, d], a, b))
    })
}

/// The control looks at both elements of an inside corner: a tool that beside one of them would cut into the other one
/// should have been refused.
fn is_unseen(outline: &Outline, nominal: &[Piece], piece: &Piece, point: DVec2) -> bool {
    let Some(own) = nominal.iter().position(|other| other.line == piece.line) else { return true };
    let side = if outline.left { 1.0 } else { -1.0 };
    let inside =
        |before: &Piece, behind: &Piece| before.heading(before.to).perp_dot(behind.heading(behind.from)) * side > 1e-3;
    // An outline that crosses itself there has no inside.
    let near = |other: &Piece| other.distance(point) < outline.tool - NEAR && !cross(other, &nominal[own]);
    let before = own.checked_sub(1).map(|n| nominal[n]).filter(|other| inside(other, &nominal[own]));
    let behind = nominal.get(own + 1).copied().filter(|other| inside(&nominal[own], other));
    !before.iter().chain(&behind).any(near)
}

fn keeps_its_distance(outline: &Outline) -> Result<(), TestCaseError> {
    let plain = outline.program("R0");
    let nominal = run(&outline.view, &plain.text, outline.tool);
    if nominal.code == "rounding-impossible" {
        return Err(TestCaseError::reject("no place for a rounding"));
    }
    prop_assert_eq!(nominal.status, Status::Done, "{}{}", nominal.code, nominal.both);
    let nominal = plain.contour(&nominal.path);
    corners_are_right(outline, &plain, &nominal)?;
    rises_as_programmed(outline, &plain, &nominal, &plain.text)?;

    let program = outline.program(if outline.left { "RL" } else { "RR" });
    let ran = run(&outline.view, &program.text, outline.tool);
    let both = &ran.both;
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
    let path = program.contour(&ran.path);
    rises_as_programmed(outline, &program, &path, both)?;
    // A control looks at neighbours only: where others are nearer, the outline is too narrow to judge.
    for piece in &path {
        for point in (0..=SAMPLES).map(|n| piece.at(n as f64 / SAMPLES as f64)) {
            let distance = far(&nominal, point);
            if distance < outline.tool - NEAR {
                let unseen = is_unseen(outline, &nominal, piece, point);
                prop_assert!(unseen, "cuts into a neighbour at {}{}", point, both);
                return Err(TestCaseError::reject("too narrow elsewhere"));
            }
            prop_assert!((distance - outline.tool).abs() < NEAR, "{} is {} away{}", point, distance, both);
        }
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
    leaves_the_part(outline, &nominal, &ran.stock, both)
}

/// Columns beside the contour: on the tool's side they are gone wherever the tool fits, on the other one they stand.
fn leaves_the_part(outline: &Outline, nominal: &[Piece], stock: &Stock, both: &str) -> Result<(), TestCaseError> {
    let (columns, rows) = stock.size();
    for row in 0..rows {
        for column in 0..columns {
            let place = outline.view.back(stock.place(column, row));
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
            let top = stock.top(column, row).map(|top| top / outline.view.scale);
            if left == outline.left {
                let centre = foot + away * outline.tool;
                // The way to the contour and away from it cut more.
                let heights = outline.heights.as_deref().unwrap_or(&[]).iter();
                let low = heights.clone().copied().fold(LEVEL, f64::min).min(0.0);
                let high = heights.copied().fold(LEVEL, f64::max).min(0.0);
                if fits(nominal, centre, outline.tool) {
                    let fits = top.is_some_and(|top| (low - NEAR..=high + NEAR).contains(&top));
                    prop_assert!(fits, "{} stands {:?}{}", place, top, both);
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
    let ways = [DVec2::splat(90.0), DVec2::splat(95.0)].map(|end| Piece::flat(middle, end, None).distance(place));
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

laws! {
    #![proptest_config(config(24))]

    #[test]
    fn the_tool_keeps_the_distance_of_its_radius(outline in outline(false)) {
        keeps_its_distance(&outline)?;
    }

    #[test]
    fn a_rising_contour_keeps_it_in_its_plane(outline in outline(true)) {
        keeps_its_distance(&outline)?;
    }
}
