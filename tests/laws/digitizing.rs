//! Laws of digitizing: whatever part lies in the range, the points of the file lie where the ball touches it, no farther from
//! each other than the cycle says, in lines at the line spacing, and the file can be run.
//!
//! Distances from parts are calculated here from the scene's numbers, with nothing of the engine.
#![expect(clippy::disallowed_methods, reason = "truths are calculated with plain trigonometry")]
use std::fmt::Write as _;

use ciklo::base::diag::{Diagnostic, Source};
use ciklo::engine::run::{Engine, Event, EventKind, NoTexts, Outcome, Status};
use ciklo::engine::scene::{Beside, Scene};
use ciklo::program::syntax;
use proptest::prelude::*;

use crate::built::{Built, built};
use crate::cases::config;

/// Coordinates of the file have four decimals.
const WRITTEN: f64 = 1e-4;

type Point = [f64; 3];

fn mm(range: std::ops::Range<f64>) -> impl Strategy<Value = f64> {
    range.prop_map(|value| (value * 1000.0).round() / 1000.0)
}

fn minus(a: Point, b: Point) -> Point {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

fn length(a: Point) -> f64 {
    (a[0] * a[0] + a[1] * a[1] + a[2] * a[2]).sqrt()
}

/// A part without an overhang above Z 0.
#[derive(Clone, Copy, Debug)]
enum Part {
    /// Half lengths, the height of its top, turned about Z.
    Block { half: [f64; 2], top: f64, turned: f64 },
    /// Radius, and how far its centre is below Z 0.
    Ball { radius: f64, below: f64 },
    /// Upright: radius, and the height of its top.
    Stud { radius: f64, top: f64 },
    /// Along X: radius, half its length, and how far its axis is below Z 0.
    Roll { radius: f64, half: f64, below: f64 },
    /// Triangles over a grid, down to Z -20: the heights of its crossings, line after line.
    Hill { heights: [f64; CROSSINGS * CROSSINGS] },
}

/// Crossings along a side of the grid of a hill.
const CROSSINGS: usize = 4;
/// From one crossing to the next, mm.
const CELL: f64 = 4.0;
/// Half the width of a hill.
const HALF: f64 = CELL * (CROSSINGS - 1) as f64 / 2.0;
/// Its lower end.
const FOOT: f64 = -20.0;

/// The triangles of the upper side of a hill.
fn slopes(heights: &[f64; CROSSINGS * CROSSINGS]) -> Vec<[Point; 3]> {
    let at = |i: usize, j: usize| [i as f64 * CELL - HALF, j as f64 * CELL - HALF, heights[j * CROSSINGS + i]];
    let cells = (0..CROSSINGS - 1).flat_map(|j| (0..CROSSINGS - 1).map(move |i| (i, j)));
    cells
        .flat_map(|(i, j)| {
            let (a, b, c, d) = (at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
            // The diagonals go both ways.
            if (i + j) % 2 == 0 { [[a, b, c], [a, c, d]] } else { [[a, b, d], [b, c, d]] }
        })
        .collect()
}

/// All triangles of a hill.
fn hill(heights: &[f64; CROSSINGS * CROSSINGS]) -> Vec<[Point; 3]> {
    let mut all = slopes(heights);
    let foot = |p: Point| [p[0], p[1], FOOT];
    let below: Vec<_> = all.iter().map(|three| three.map(foot)).collect();
    let last = CROSSINGS - 1;
    let at = |i: usize, j: usize| [i as f64 * CELL - HALF, j as f64 * CELL - HALF, heights[j * CROSSINGS + i]];
    for k in 0..last {
        for [a, b] in [
            [at(k, 0), at(k + 1, 0)],
            [at(k, last), at(k + 1, last)],
            [at(0, k), at(0, k + 1)],
            [at(last, k), at(last, k + 1)],
        ] {
            all.extend([[a, b, foot(b)], [a, foot(b), foot(a)]]);
        }
    }
    all.extend(below);
    all
}

/// STL files of hills, whose names are their heights.
struct Hills;

impl Beside for Hills {
    fn size(&self, _: &str) -> Option<u64> {
        None
    }

    fn bytes(&self, name: &str) -> Result<Vec<u8>, Diagnostic> {
        let heights: Vec<f64> =
            name.trim_end_matches(".stl").split('_').map(|word| word.parse().expect("a height")).collect();
        let mut text = "solid hill\n".to_owned();
        for three in hill(&heights.try_into().expect("all heights")) {
            text.push_str("facet normal 0 0 1 outer loop\n");
            for [x, y, z] in three {
                let _ = writeln!(text, "vertex {x} {y} {z}");
            }
            text.push_str("endloop endfacet\n");
        }
        Ok((text + "endsolid hill\n").into_bytes())
    }
}

fn dot(a: Point, b: Point) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// How far a point is from a triangle: the square of the distance is least where its weights are, none of them below 0.
fn from_triangle(p: Point, [a, b, c]: [Point; 3]) -> f64 {
    let on_side = |a: Point, b: Point| {
        let way = minus(b, a);
        let share = (dot(minus(p, a), way) / dot(way, way)).clamp(0.0, 1.0);
        length(minus(p, [0, 1, 2].map(|axis| a[axis] + way[axis] * share)))
    };
    let (u, v, w) = (minus(b, a), minus(c, a), minus(p, a));
    let (uu, uv, vv, wu, wv) = (dot(u, u), dot(u, v), dot(v, v), dot(w, u), dot(w, v));
    let whole = uu * vv - uv * uv;
    let (s, t) = ((vv * wu - uv * wv) / whole, (uu * wv - uv * wu) / whole);
    if s >= 0.0 && t >= 0.0 && s + t <= 1.0 {
        return length([0, 1, 2].map(|axis| w[axis] - s * u[axis] - t * v[axis]));
    }
    on_side(a, b).min(on_side(b, c)).min(on_side(c, a))
}

/// How far a point is from a hill; 0 inside of it.
fn from_hill(p: Point, heights: &[f64; CROSSINGS * CROSSINGS]) -> f64 {
    let side = |[ax, ay, _]: Point, [bx, by, _]: Point| (bx - ax) * (p[1] - ay) - (by - ay) * (p[0] - ax);
    let under = |[a, b, c]: &[Point; 3]| {
        let (u, v, w) = (side(*b, *c), side(*c, *a), side(*a, *b));
        u >= 0.0 && v >= 0.0 && w >= 0.0 && p[2] <= (u * a[2] + v * b[2] + w * c[2]) / (u + v + w) && p[2] >= FOOT
    };
    if slopes(heights).iter().any(under) {
        return 0.0;
    }
    hill(heights).into_iter().map(|triangle| from_triangle(p, triangle)).fold(f64::INFINITY, f64::min)
}

#[derive(Clone, Copy, Debug)]
struct Placed {
    part: Part,
    at: [f64; 2],
}

fn part() -> impl Strategy<Value = Part> {
    prop_oneof![
        (mm(2.0..7.0), mm(2.0..7.0), mm(0.5..6.0), mm(-90.0..90.0)).prop_map(|(a, b, top, turned)| Part::Block {
            half: [a, b],
            top,
            turned
        }),
        (mm(3.0..8.0), mm(0.0..2.0)).prop_map(|(radius, below)| Part::Ball { radius, below }),
        (mm(1.0..7.0), mm(0.5..6.0)).prop_map(|(radius, top)| Part::Stud { radius, top }),
        (mm(3.0..8.0), mm(2.0..8.0), mm(0.0..2.0)).prop_map(|(radius, half, below)| Part::Roll { radius, half, below }),
    ]
}

/// One hill.
fn hills() -> impl Strategy<Value = Shop> {
    let heights = prop::array::uniform16(mm(-2.0..6.0));
    (mm(1.0..4.0), heights, mm(-3.0..3.0), mm(-3.0..3.0)).prop_map(|(radius, heights, x, y)| Shop {
        radius,
        parts: vec![Placed { part: Part::Hill { heights }, at: [x, y] }],
    })
}

/// A hill whose inner crossings are above Z 0 and whose rim is below it.
#[derive(Clone, Debug)]
struct Bump {
    shop: Shop,
    /// Where its highest crossing is.
    peak: [f64; 2],
    peak_height: f64,
    /// Whether that is in the front row, at the lower Y.
    front: bool,
}

fn bumps() -> impl Strategy<Value = Bump> {
    let (rim, inner) = (prop::array::uniform16(mm(-2.0..-0.5)), prop::array::uniform4(mm(1.5..6.0)));
    (mm(1.0..4.0), rim, inner, mm(-3.0..3.0), mm(-3.0..3.0)).prop_map(|(radius, mut heights, inner, x, y)| {
        let places = [(1, 1), (2, 1), (1, 2), (2, 2)];
        for ((i, j), height) in places.into_iter().zip(inner) {
            heights[j * CROSSINGS + i] = height;
        }
        let highest = |best: usize, at: usize| if inner[at] > inner[best] { at } else { best };
        let best = (1..inner.len()).fold(0, highest);
        let (i, j) = places[best];
        let peak = [x + i as f64 * CELL - HALF, y + j as f64 * CELL - HALF].map(|at| (at * 1000.0).round() / 1000.0);
        let shop = Shop { radius, parts: vec![Placed { part: Part::Hill { heights }, at: [x, y] }] };
        Bump { shop, peak, peak_height: inner[best], front: j == 1 }
    })
}

prop_compose! {
    fn placed()(part in part(), x in mm(-6.0..6.0), y in mm(-6.0..6.0)) -> Placed {
        Placed { part, at: [x, y] }
    }
}

impl Placed {
    /// How far a point is from the part; 0 inside of it.
    fn distance(&self, point: Point) -> f64 {
        let [x, y, z] = [point[0] - self.at[0], point[1] - self.at[1], point[2]];
        let over = |value: f64, half: f64| (value.abs() - half).max(0.0);
        match self.part {
            Part::Block { half, top, turned } => {
                let (s, c) = turned.to_radians().sin_cos();
                let (u, v) = (x * c + y * s, y * c - x * s);
                length([over(u, half[0]), over(v, half[1]), (z - top).max(0.0)])
            }
            Part::Ball { radius, below } => (length([x, y, z + below]) - radius).max(0.0),
            Part::Stud { radius, top } => ((x.hypot(y) - radius).max(0.0)).hypot((z - top).max(0.0)),
            Part::Roll { radius, half, below } => ((y.hypot(z + below) - radius).max(0.0)).hypot(over(x, half)),
            Part::Hill { heights } => from_hill([x, y, z], &heights),
        }
    }

    fn solid(&self) -> String {
        let [x, y] = self.at;
        let shape = match self.part {
            Part::Block { half: [a, b], top, turned } => {
                return format!(
                    "{{place: {{shift: [{x}, {y}, 0], rotate: [0, 0, {turned}]}}, solid: {{box: {{min: [{}, {}, -20], max: [{a}, {b}, {top}]}}}}}}",
                    -a, -b
                );
            }
            Part::Ball { radius, below } => format!("sphere: {{centre: [0, 0, {}], radius: {radius}}}", -below),
            Part::Stud { radius, top } => {
                format!("cylinder: {{centre: [0, 0], radius: {radius}, from: -20, to: {top}}}")
            }
            Part::Roll { radius, half, below } => {
                // Across X the order is Y, Z.
                format!("cylinder: {{axis: X, centre: [0, {}], radius: {radius}, from: {}, to: {half}}}", -below, -half)
            }
            Part::Hill { heights } => format!("stl: {}.stl", heights.map(|height| height.to_string()).join("_")),
        };
        format!("{{place: {{shift: [{x}, {y}, 0]}}, solid: {{{shape}}}}}")
    }
}

/// How far a point is from all parts.
fn distance(parts: &[Placed], point: Point) -> f64 {
    parts.iter().map(|part| part.distance(point)).fold(f64::INFINITY, f64::min)
}

/// A ball over parts.
#[derive(Clone, Debug)]
struct Shop {
    radius: f64,
    parts: Vec<Placed>,
}

prop_compose! {
    fn shop(most: usize)(radius in mm(1.0..4.0), parts in prop::collection::vec(placed(), 1..=most)) -> Shop {
        Shop { radius, parts }
    }
}

impl Shop {
    fn scene(&self, points: &str) -> String {
        let solids: Vec<String> = self.parts.iter().map(Placed::solid).collect();
        format!(
            "scene: 1\ntools: [{{T: 1, L: 150, R: {0}, TP_NO: 1}}, {{T: 2, L: 80, R: {0}}}]\n\
             probe: {{NO: 1, ball_radius: {0}, F: 300, DIST: 20}}\nstart: [0, 0, 90]\n{points}\nparts: [{1}]\n",
            self.radius,
            solids.join(", ")
        )
    }

    /// How far the ball is from the part when the stylus is there; less than 0 in it.
    fn gap(&self, tip: Point) -> f64 {
        distance(&self.parts, [tip[0], tip[1], tip[2] + self.radius]) - self.radius
    }
}

fn execute(scene: &str, program: &str, with: Option<(&str, &str)>) -> (Outcome, Vec<Event>) {
    let Built { files, catalogue, .. } = built();
    let on = catalogue.on("tnc426-430").expect("a control");
    let parsed = Scene::parse_beside(&Source::new("scene.yaml", scene), files, Some(&Hills));
    let scene = parsed.unwrap_or_else(|found| panic!("{found:?}\n{scene}"));
    let tree = syntax::parse(&Source::new("LAW.H", program));
    let other = with.map(|(name, text)| (name, syntax::parse(&Source::new(format!("{name}.H"), text))));
    let mut events = Vec::new();
    let mut engine = Engine::new(&tree, on, &scene, &NoTexts);
    if let Some((name, other)) = &other {
        engine = engine.with_program(name, other);
    }
    let outcome = engine.run(&mut |event| events.push(event));
    (outcome, events)
}

/// A block of the file: where it goes, the letters that it has, and whether at rapid traverse.
#[derive(Clone, Debug)]
struct Block {
    to: Point,
    letters: String,
    rapid: bool,
}

/// The movements of a file of digitized data.
fn blocks(text: &str) -> Vec<Block> {
    let mut at = [0.0; 3];
    let mut found = Vec::new();
    for line in text.lines() {
        let mut words = line.split_ascii_whitespace().skip(1);
        if words.next() != Some("L") {
            continue;
        }
        let (mut rapid, mut letters) = (false, String::new());
        for word in words {
            match "XYZ".find(&word[..1]) {
                Some(axis) => {
                    at[axis] = word[1..].parse().expect("a coordinate");
                    letters.push_str(&word[..1]);
                }
                None => rapid |= word == "FMAX",
            }
        }
        found.push(Block { to: at, letters, rapid });
    }
    found
}

/// Runs the cycles and gives the file.
fn digitize(shop: &Shop, range: &str, cycle: &str, points: &str) -> Result<(String, Vec<Event>), TestCaseError> {
    let program = format!("0 BEGIN PGM LAW MM\nTOOL CALL 1 Z\n{range}{cycle}END PGM LAW MM\n");
    let (outcome, events) = execute(&shop.scene(points), &program, None);
    prop_assert_eq!(outcome.status, Status::Done, "{:?}\n{}\n{}", outcome.fault, program, shop.scene(points));
    let file = outcome.logs.iter().find(|(name, _)| name == "DATA.H");
    Ok((file.expect("the file").1.clone(), events))
}

/// The stylus touches the part at a point, or is at the end of the range and touches nothing.
fn touches(shop: &Shop, point: Point) -> Result<(), TestCaseError> {
    let gap = shop.gap(point);
    let on_floor = point[2].abs() < WRITTEN && gap > -WRITTEN;
    prop_assert!(gap.abs() < WRITTEN || on_floor, "{} mm from the part at {:?}", gap, point);
    Ok(())
}

/// Between two points a tool of the radius of the ball goes no deeper into the part than their chord lets it.
fn between(shop: &Shop, from: Point, to: Point) -> Result<(), TestCaseError> {
    let chord = length(minus(to, from));
    // Where the ball rolls over an edge, its centre goes on a circle of its radius.
    let sagitta = shop.radius - (shop.radius.powi(2) - chord.powi(2) / 4.0).max(0.0).sqrt();
    for share in [0.2, 0.4, 0.5, 0.7, 0.9] {
        let at = [0, 1, 2].map(|axis| from[axis] + (to[axis] - from[axis]) * share);
        prop_assert!(shop.gap(at) > -sagitta - WRITTEN, "{} mm in the part at {:?}", -shop.gap(at), at);
    }
    Ok(())
}

/// The file is a program: a tool of the radius of the ball goes to all of its points.
fn runs(shop: &Shop, file: &str, all: &[Block]) -> Result<(), TestCaseError> {
    let program = "0 BEGIN PGM MILL MM\nTOOL CALL 2 Z S4000\nL R0 F1500 M13\nCALL PGM DATA\nEND PGM MILL MM\n";
    let scene = shop.scene("").replace("probe:", "x_probe:").replace(", TP_NO: 1", "");
    let scene: Vec<&str> = scene.lines().filter(|line| !line.starts_with("x_probe")).collect();
    let (outcome, events) = execute(&scene.join("\n"), program, Some(("DATA", file)));
    prop_assert_eq!(outcome.status, Status::Done, "{:?}", outcome.fault);
    let went: Vec<Point> = events
        .iter()
        .filter_map(|event| match &event.kind {
            EventKind::Move { to, .. } => Some(to.to_array()),
            _ => None,
        })
        .collect();
    prop_assert_eq!(went.len(), all.len());
    for (went, block) in went.iter().zip(all).skip(1) {
        prop_assert!(length(minus(*went, block.to)) < 1e-9);
    }
    Ok(())
}

/// A block-shaped range about the origin.
fn range(x: f64, y: f64) -> String {
    format!(
        "TCH PROBE 5.0 RANGE\nTCH PROBE 5.1 PGM NAME: DATA\nTCH PROBE 5.2 Z X-{x} Y-{y} Z+0\nTCH PROBE 5.3 X+{x} Y+{y} Z+9\nTCH PROBE 5.4 HEIGHT: +40\n"
    )
}

/// How lines are asked for.
#[derive(Clone, Debug)]
struct Asked {
    along_y: bool,
    analog: bool,
    spacing: f64,
    points: f64,
    travel: f64,
    tolerance: f64,
    half: [f64; 2],
}

prop_compose! {
    fn asked()(
        along_y in any::<bool>(), analog in any::<bool>(), spacing in mm(1.5..5.0), points in mm(0.5..1.4), travel in mm(0.0..2.0),
        tolerance in prop_oneof![Just(0.0), mm(0.005..0.2)], x in mm(2.0..6.0), y in mm(1.0..4.0),
    ) -> Asked {
        Asked { along_y, analog, spacing, points, travel, tolerance, half: [x, y] }
    }
}

impl Asked {
    fn cycle(&self, meander: bool) -> String {
        let axis = if self.along_y { 'Y' } else { 'X' };
        let (number, name) = match (meander, self.analog) {
            (true, false) => (6, "MEANDER"),
            (true, true) => (16, "MEANDER"),
            (false, false) => (8, "LINE"),
            (false, true) => (18, "LINE"),
        };
        let angle = if self.analog { " ANGLE: 0" } else { "" };
        let height = if meander { "" } else { " HEIGHT: +12" };
        let (l, p) = (self.spacing, self.points);
        let mut text = format!("TCH PROBE {number}.0 {name}\nTCH PROBE {number}.1 DIRECTN: {axis}{angle}{height}\n");
        let _ = match self.analog {
            true => writeln!(
                text,
                "TCH PROBE {number}.2 F1000 FMIN500 MIN.L.SPAC: 0 L.SPAC: {l} P.SPAC: {p} TOL: {} DIST: 1",
                self.tolerance
            ),
            false => writeln!(text, "TCH PROBE {number}.2 TRAVEL: {} L.SPAC: {l} P.SPAC: {p}", self.travel),
        };
        text
    }

    /// Along and across the lines.
    fn axes(&self) -> (usize, usize) {
        if self.along_y { (1, 0) } else { (0, 1) }
    }

    /// Where the lines are, across.
    fn lines(&self) -> Vec<f64> {
        let half = self.half[self.axes().1];
        let mut lines = vec![-half];
        while let Some(last) = lines.last().copied().filter(|last| half - last > 1e-6) {
            lines.push((last + self.spacing).min(half));
        }
        lines
    }
}

fn lines_hold(shop: &Shop, asked: &Asked, meander: bool) -> Result<(), TestCaseError> {
    let (file, _) = digitize(shop, &range(asked.half[0], asked.half[1]), &asked.cycle(meander), "")?;
    let all = blocks(&file);
    let (along, across) = asked.axes();
    let (half, wanted) = (asked.half, asked.lines());
    let mut seen = vec![(f64::INFINITY, f64::NEG_INFINITY); wanted.len()];
    let mut before: Option<Point> = None;
    for block in &all {
        if block.rapid {
            before = None;
            continue;
        }
        let point = block.to;
        touches(shop, point)?;
        prop_assert!(
            (0..2).all(|axis| point[axis].abs() < half[axis] + WRITTEN) && (-WRITTEN..9.0).contains(&point[2])
        );
        let line = wanted.iter().position(|line| (line - point[across]).abs() < WRITTEN);
        let at_end = (point[along].abs() - half[along]).abs() < WRITTEN;
        prop_assert!(line.is_some() || (meander && at_end), "{:?} is on no line", point);
        if let Some((least, most)) = line.and_then(|line| seen.get_mut(line)) {
            *least = least.min(point[along]);
            *most = most.max(point[along]);
        }
        if let Some(before) = before {
            let far = length(minus(point, before));
            prop_assert!(far < asked.points + 3.0 * WRITTEN, "{} mm from {:?} to {:?}", far, before, point);
            between(shop, before, point)?;
        }
        before = Some(point);
    }
    for (least, most) in seen {
        let whole = (least + half[along]).abs() < WRITTEN && (most - half[along]).abs() < WRITTEN;
        prop_assert!(whole, "a line from {} to {}", least, most);
    }
    runs(shop, &file, &all)
}

/// The contour lines of a file: points of one height, from the first one back to it.
fn loops(all: &[Block]) -> Vec<Vec<Point>> {
    let mut found: Vec<Vec<Point>> = Vec::new();
    let mut feeds = all.iter().filter(|block| !block.rapid).peekable();
    while let Some(block) = feeds.next() {
        if block.letters == "Z" {
            found.push(Vec::new());
        } else if feeds.peek().is_none_or(|next| next.letters == "Z") {
            // Back to the starting point.
        } else if let Some(points) = found.last_mut() {
            points.push(block.to);
        }
    }
    found
}

/// How contour lines are asked for.
#[derive(Clone, Copy, Debug)]
struct Lines {
    analog: bool,
    points: f64,
    step: f64,
    travel: f64,
    to_the_right: bool,
    down: bool,
}

/// Contour lines around the highest crossing of a hill, which the stylus meets first.
fn around_a_hill(bump: Bump, how: Lines) -> Result<(), TestCaseError> {
    let Lines { analog, points, step, travel, to_the_right, down } = how;
    let Bump { shop, peak, peak_height, front } = bump;
    let top = ((peak_height - 0.8) * 1000.0).round() / 1000.0;
    let (number, sign) = (if analog { 17 } else { 7 }, if to_the_right { '+' } else { '-' });
    let spacing = if down { -step } else { step };
    let (start, approach) = if front { (-25, '+') } else { (25, '-') };
    let mut cycle = format!(
        "TCH PROBE {number}.0 CONTOUR LINES\nTCH PROBE {number}.1 TIME: 0 X{:+} Y{start:+}\nTCH PROBE {number}.2 ORDER: Y{approach} / X{sign}\n",
        peak[0]
    );
    let _ = match analog {
        true => writeln!(
            cycle,
            "TCH PROBE {number}.3 F1000 MIN.L.SPAC: 0 L.SPAC: {spacing:+} P.SPAC: {points} TOL: 0 DIST: 1"
        ),
        false => writeln!(cycle, "TCH PROBE {number}.3 TRAVEL: {travel} L.SPAC: {spacing:+} P.SPAC: {points}"),
    };
    let range = format!(
        "TCH PROBE 5.0 RANGE\nTCH PROBE 5.1 PGM NAME: DATA\nTCH PROBE 5.2 Z X-30 Y-30 Z+0\nTCH PROBE 5.3 X+30 Y+30 Z{top:+.3}\nTCH PROBE 5.4 HEIGHT: +40\n"
    );
    let (file, _) = digitize(&shop, &range, &cycle, "")?;
    let all = blocks(&file);
    let found = loops(&all);
    prop_assert_eq!(found.len(), (top / step + 1e-9).floor() as usize + 1);
    for (count, line) in found.iter().enumerate() {
        let way = step * count as f64;
        let height = if down { top - way } else { way };
        let (first, last) = (line[0], line[line.len() - 1]);
        prop_assert!(length(minus(first, last)) < 2.0 * WRITTEN, "not closed: {:?}", line);
        let mut turned = 0.0;
        for pair in line.windows(2) {
            let (a, b) = (pair[0], pair[1]);
            prop_assert!(shop.gap(b).abs() < WRITTEN, "{} mm from the part at {:?}", shop.gap(b), b);
            prop_assert!((b[2] - height).abs() < WRITTEN, "{:?} is not at {}", b, height);
            prop_assert!(length(minus(b, a)) < points + 3.0 * WRITTEN);
            between(&shop, a, b)?;
            let arm = |p: Point| [p[0] - peak[0], p[1] - peak[1]];
            let (a, b) = (arm(a), arm(b));
            turned += (a[0] * b[1] - a[1] * b[0]).atan2(a[0] * b[0] + a[1] * b[1]).to_degrees();
        }
        let wanted = if to_the_right == front { 360.0 } else { -360.0 };
        prop_assert!((turned - wanted).abs() < 1e-3, "turned by {} at {}", turned, height);
    }
    runs(&shop, &file, &all)?;
    Ok(())
}

laws! {
    #![proptest_config(config(50))]

    #[test]
    fn meanders_lie_on_the_part(shop in shop(2), asked in asked()) {
        lines_hold(&shop, &asked, true)?;
    }

    #[test]
    fn lines_lie_on_the_part(shop in shop(2), asked in asked()) {
        lines_hold(&shop, &asked, false)?;
    }

    #[test]
    fn meanders_lie_on_triangles(shop in hills(), asked in asked()) {
        lines_hold(&shop, &asked, true)?;
    }

    #[test]
    fn lines_lie_on_triangles(shop in hills(), asked in asked()) {
        lines_hold(&shop, &asked, false)?;
    }

    #[test]
    fn contour_lines_go_once_around_the_part(
        shop in shop(1), analog in any::<bool>(), points in mm(0.8..4.9), step in mm(0.8..3.0), travel in mm(0.0..2.0),
        to_the_right in any::<bool>(), down in any::<bool>(),
    ) {
        let Placed { part, at } = shop.parts[0];
        // The stylus touches the part from the side up to here.
        let top = match part {
            Part::Block { top, .. } | Part::Stud { top, .. } => top - 0.1,
            Part::Ball { radius, below } | Part::Roll { radius, below, .. } => radius - below - 1.5,
            Part::Hill { .. } => return Ok(()),
        };
        prop_assume!(top > 0.2);
        let (number, sign) = (if analog { 17 } else { 7 }, if to_the_right { '+' } else { '-' });
        let spacing = if down { -step } else { step };
        let mut cycle = format!(
            "TCH PROBE {number}.0 CONTOUR LINES\nTCH PROBE {number}.1 TIME: 0 X{:+} Y-25\nTCH PROBE {number}.2 ORDER: Y+ / X{sign}\n", at[0]
        );
        let _ = match analog {
            true => writeln!(cycle, "TCH PROBE {number}.3 F1000 MIN.L.SPAC: 0 L.SPAC: {spacing:+} P.SPAC: {points} TOL: 0 DIST: 1"),
            false => writeln!(cycle, "TCH PROBE {number}.3 TRAVEL: {travel} L.SPAC: {spacing:+} P.SPAC: {points}"),
        };
        let range = format!(
            "TCH PROBE 5.0 RANGE\nTCH PROBE 5.1 PGM NAME: DATA\nTCH PROBE 5.2 Z X-30 Y-30 Z+0\nTCH PROBE 5.3 X+30 Y+30 Z{top:+.3}\nTCH PROBE 5.4 HEIGHT: +40\n"
        );
        let (file, _) = digitize(&shop, &range, &cycle, "")?;
        let all = blocks(&file);
        let found = loops(&all);
        let top = (top * 1000.0).round() / 1000.0;
        prop_assert_eq!(found.len(), (top / step + 1e-9).floor() as usize + 1);
        for (count, points_of_line) in found.iter().enumerate() {
            let way = step * count as f64;
            let height = if down { top - way } else { way };
            let (first, last) = (points_of_line[0], points_of_line[points_of_line.len() - 1]);
            prop_assert!(length(minus(first, last)) < 2.0 * WRITTEN, "not closed: {:?}", points_of_line);
            let mut turned = 0.0;
            for pair in points_of_line.windows(2) {
                let (a, b) = (pair[0], pair[1]);
                prop_assert!((shop.gap(b)).abs() < WRITTEN, "{} mm from the part at {:?}", shop.gap(b), b);
                prop_assert!((b[2] - height).abs() < WRITTEN, "{:?} is not at {}", b, height);
                prop_assert!(length(minus(b, a)) < points + 3.0 * WRITTEN);
                let arm = |p: Point| [p[0] - at[0], p[1] - at[1]];
                let (a, b) = (arm(a), arm(b));
                turned += (a[0] * b[1] - a[1] * b[0]).atan2(a[0] * b[0] + a[1] * b[1]).to_degrees();
            }
            let wanted = if to_the_right { 360.0 } else { -360.0 };
            prop_assert!((turned - wanted).abs() < 1e-3, "turned by {}", turned);
        }
        runs(&shop, &file, &all)?;
    }

    /// Over triangles: around the highest crossing, which the stylus meets first.
    #[test]
    fn contour_lines_go_once_around_a_hill(
        bump in bumps(), analog in any::<bool>(), points in mm(0.3..1.2), step in mm(0.4..1.5), travel in mm(0.0..1.0),
        to_the_right in any::<bool>(), down in any::<bool>(),
    ) {
        let how = Lines { analog, points, step, travel, to_the_right, down };
        around_a_hill(bump, how)?;
    }

    /// A second stud beside the one that the stylus meets first: it goes around both where the ball does not fit between
    /// them, and around the first one only where it does, however narrow the gap.
    #[test]
    fn contour_lines_do_not_go_over_a_gap(
        radius in mm(1.0..4.0), studs in (mm(1.0..7.0), mm(1.0..7.0)), tops in (mm(0.5..6.0), mm(0.5..6.0)), turned in mm(20.0..160.0),
        gap in prop_oneof![mm(0.02..0.1), mm(0.1..1.5), mm(-0.1..-0.002), mm(-1.5..-0.1)], points in mm(0.3..4.9), analog in any::<bool>(),
        to_the_right in any::<bool>(),
    ) {
        // The ball stays so far from the axis of a stud.
        let around = |stud: f64, top: f64| stud + (radius.powi(2) - (radius - top).max(0.0).powi(2)).sqrt();
        let (first, second) = (around(studs.0, tops.0), around(studs.1, tops.1));
        let far = first + second + gap;
        let (s, c) = turned.to_radians().sin_cos();
        let at = [far * c, far * s].map(|at| (at * 1e5).round() / 1e5);
        // In front of the first stud there is nothing of the second one.
        prop_assume!(second < at[0].abs() || at[1] - (second.powi(2) - at[0].powi(2)).sqrt() > 0.1 - first);
        let stud = |radius: f64, top: f64, at: [f64; 2]| Placed { part: Part::Stud { radius, top }, at };
        let shop = Shop { radius, parts: vec![stud(studs.0, tops.0, [0.0; 2]), stud(studs.1, tops.1, at)] };
        let (number, sign) = (if analog { 17 } else { 7 }, if to_the_right { '+' } else { '-' });
        let manner = if analog { "F1000 MIN.L.SPAC: 0" } else { "TRAVEL: 0.1" };
        let end = if analog { " TOL: 0 DIST: 1" } else { "" };
        let cycle = format!(
            "TCH PROBE {number}.0 CONTOUR LINES\nTCH PROBE {number}.1 TIME: 0 X+0 Y-35\nTCH PROBE {number}.2 ORDER: Y+ / X{sign}\n\
             TCH PROBE {number}.3 {manner} L.SPAC: +0 P.SPAC: {points}{end}\n"
        );
        let range = "TCH PROBE 5.0 RANGE\nTCH PROBE 5.1 PGM NAME: DATA\nTCH PROBE 5.2 Z X-60 Y-60 Z+0\nTCH PROBE 5.3 X+60 Y+60 Z+1\nTCH PROBE 5.4 HEIGHT: +40\n";
        let (file, _) = digitize(&shop, range, &cycle, "")?;
        let found = loops(&blocks(&file));
        prop_assert_eq!(found.len(), 1);
        let mut turns = [0.0; 2];
        for pair in found[0].windows(2) {
            let (a, b) = (pair[0], pair[1]);
            prop_assert!(shop.gap(b).abs() < WRITTEN, "{} mm from the studs at {:?}", shop.gap(b), b);
            prop_assert!(length(minus(b, a)) < points + 3.0 * WRITTEN);
            between(&shop, a, b)?;
            for (turned, [x, y]) in turns.iter_mut().zip([[0.0; 2], at]) {
                let (a, b) = ([a[0] - x, a[1] - y], [b[0] - x, b[1] - y]);
                *turned += (a[0] * b[1] - a[1] * b[0]).atan2(a[0] * b[0] + a[1] * b[1]).to_degrees();
            }
        }
        let once = if to_the_right { 360.0 } else { -360.0 };
        let wanted = [once, if gap < 0.0 { once } else { 0.0 }];
        prop_assert!(turns.iter().zip(wanted).all(|(turned, wanted)| (turned - wanted).abs() < 1e-3), "{:?}", turns);
    }

    #[test]
    fn a_polygon_bounds_the_lines(
        shop in shop(1), angle in mm(-90.0..90.0), spacing in mm(1.5..4.0), points in mm(0.5..1.4),
        corners in prop::collection::vec(mm(2.0..6.0), 3..9),
    ) {
        // A star about the origin: not always convex.
        let count = corners.len() as f64;
        let place = |(index, far): (usize, &f64)| {
            let (s, c) = (360.0 * index as f64 / count).to_radians().sin_cos();
            [(far * c * 1000.0).round() / 1000.0, (far * s * 1000.0).round() / 1000.0]
        };
        let corners: Vec<[f64; 2]> = corners.iter().enumerate().map(place).collect();
        let rows = corners.iter().enumerate().map(|(nr, [x, y])| format!("{{NR: {nr}, X: {x}, Y: {y}}}"));
        let table = format!("points: {{TAB1.PNT: [{}]}}", rows.collect::<Vec<_>>().join(", "));
        let range = "TCH PROBE 15.0 RANGE\nTCH PROBE 15.1 PGM DIGIT.: DATA\nTCH PROBE 15.2 Z PGM RANGE: TAB1\nTCH PROBE 15.3 MIN: +0 MAX: +9 HEIGHT: +40\n";
        for (number, name, height) in [(16, "MEANDER", ""), (18, "LINE", " HEIGHT: +12")] {
            let cycle = format!(
                "TCH PROBE {number}.0 {name}\nTCH PROBE {number}.1 DIRECTN: X ANGLE: {angle}{height}\n\
                 TCH PROBE {number}.2 F1000 MIN.L.SPAC: 0 L.SPAC: {spacing} P.SPAC: {points} TOL: 0 DIST: 1\n"
            );
            let (file, _) = digitize(&shop, range, &cycle, &table)?;
            let (s, c) = angle.to_radians().sin_cos();
            let across = |p: [f64; 2]| p[1] * c - p[0] * s;
            let first = corners.iter().map(|p| across(*p)).fold(f64::INFINITY, f64::min);
            let last = corners.iter().map(|p| across(*p)).fold(f64::NEG_INFINITY, f64::max);
            for block in blocks(&file).iter().filter(|block| !block.rapid) {
                let point = block.to;
                touches(&shop, point)?;
                let flat = [point[0], point[1]];
                prop_assert!(outside(&corners, flat) < 3.0 * WRITTEN, "{:?} is not in {:?}", flat, corners);
                let way = (across(flat) - first) / spacing;
                let on_line = (way - way.round()).abs() * spacing < 3.0 * WRITTEN || (across(flat) - last).abs() < 3.0 * WRITTEN;
                prop_assert!(on_line || number == 16, "{:?} is on no line", flat);
            }
        }
    }
}

/// A position of a file with a rotary axis: the linear axis, the angle, the tool axis.
#[derive(Clone, Copy, Debug)]
struct Turned {
    x: f64,
    angle: f64,
    z: f64,
    rapid: bool,
    /// Whether only the tool axis has a word in it.
    only_z: bool,
}

/// The movements of a file with that rotary axis.
fn turned_blocks(text: &str, axis: char) -> Vec<Turned> {
    let mut at = Turned { x: 0.0, angle: 0.0, z: 0.0, rapid: false, only_z: false };
    let mut found = Vec::new();
    for line in text.lines() {
        let mut words = line.split_ascii_whitespace().skip(1).peekable();
        if words.next() != Some("L") {
            continue;
        }
        (at.rapid, at.only_z) = (false, true);
        for word in words {
            let number = || word[1..].parse().expect("a coordinate");
            match &word[..1] {
                "X" => (at.x, at.only_z) = (number(), false),
                "Z" => at.z = number(),
                "F" => at.rapid = true,
                letter => {
                    assert_eq!(letter, axis.to_string());
                    (at.angle, at.only_z) = (number(), false);
                }
            }
        }
        found.push(at);
    }
    found
}

/// Parts on a table that turns without end about an axis through the origin, under a probe that stays at one Y.
#[derive(Clone, Debug)]
struct OnTable {
    shop: Shop,
    axis: char,
    y: f64,
}

impl OnTable {
    fn scene(&self) -> String {
        let machine = format!(
            "machine:\n  machine: 1\n  name: table\n  axes:\n    - {{axis: X, min: -999, max: 999, rapid: 9000}}\n    - {{axis: Y, min: -999, max: 999, rapid: 9000}}\n    \
             - {{axis: Z, min: -999, max: 999, rapid: 9000}}\n  rotary:\n    - {{axis: {}, carries: workpiece, rapid: 5000}}\n",
            self.axis
        );
        let scene = self.shop.scene("").replace("start: [0, 0, 90]", &format!("start: [0, {}, 90]", self.y));
        scene.replacen("scene: 1\n", &format!("scene: 1\n{machine}"), 1)
    }

    /// How far the ball is from the part: to the workpiece the tool goes right-handed about the axis.
    fn gap(&self, at: Turned) -> f64 {
        let (s, c) = at.angle.to_radians().sin_cos();
        let [x, y, z] = [at.x, self.y, at.z + self.shop.radius];
        let seen = if self.axis == 'A' { [x, y * c - z * s, y * s + z * c] } else { [x * c - y * s, x * s + y * c, z] };
        distance(&self.shop.parts, seen) - self.shop.radius
    }

    fn digitize(&self, range: &str, cycle: &str) -> Result<String, TestCaseError> {
        let program = format!("0 BEGIN PGM LAW MM\nTOOL CALL 1 Z\n{range}{cycle}END PGM LAW MM\n");
        let (outcome, _) = execute(&self.scene(), &program, None);
        prop_assert_eq!(outcome.status, Status::Done, "{:?}\n{}\n{}", outcome.fault, program, self.scene());
        let file = outcome.logs.iter().find(|(name, _)| name == "DATA.H").expect("the file").1.clone();
        prop_assert!(!file.contains("BLK FORM") && !file.contains('Y'), "{}", file);
        Ok(file)
    }

    /// Between two points a tool of the radius of the ball goes no deeper than chords of its radius and of the turning.
    fn between(&self, from: Turned, to: Turned) -> Result<(), TestCaseError> {
        let turn = (to.angle - from.angle).to_radians();
        let far = (from.x.abs() + from.z.abs()).max(to.x.abs() + to.z.abs()) + self.y.abs() + self.shop.radius;
        let chord = length([to.x - from.x, far * turn, to.z - from.z]);
        let radius = self.shop.radius;
        let sagitta = radius - (radius.powi(2) - chord.powi(2) / 4.0).max(0.0).sqrt() + far * turn * turn / 8.0;
        for share in [0.2, 0.5, 0.8] {
            let at = |a: f64, b: f64| a + (b - a) * share;
            let middle = Turned { x: at(from.x, to.x), angle: at(from.angle, to.angle), z: at(from.z, to.z), ..to };
            prop_assert!(
                self.gap(middle) > -sagitta - 2.0 * WRITTEN,
                "{} mm in the part at {:?}",
                -self.gap(middle),
                middle
            );
        }
        Ok(())
    }

    /// The file is a program that a tool of the radius of the ball goes through to its end.
    fn runs(&self, file: &str) -> Result<(), TestCaseError> {
        let program = "0 BEGIN PGM MILL MM\nTOOL CALL 2 Z S4000\nL R0 F1500 M13\nCALL PGM DATA\nEND PGM MILL MM\n";
        let (outcome, events) = execute(&self.scene(), program, Some(("DATA", file)));
        prop_assert_eq!(outcome.status, Status::Done, "{:?}", outcome.fault);
        let letter = self.axis.to_string();
        let last = events.iter().rev().find_map(|event| match &event.kind {
            EventKind::Turn { axes, .. } => {
                axes.iter().find(|own| own.axis.letter().to_string() == letter).map(|own| own.to)
            }
            _ => None,
        });
        let wanted = turned_blocks(file, self.axis).last().map_or(0.0, |last| last.angle);
        prop_assert!(last.is_none_or(|last| (last - wanted).abs() < 1e-9), "{:?} and not {}", last, wanted);
        Ok(())
    }
}

/// How lines are asked for in a range with a rotary axis.
#[derive(Clone, Copy, Debug)]
struct Turning {
    y: f64,
    /// Meander or lines, along the linear axis or the rotary one, or lines of a measuring stylus.
    kind: u8,
    spacing: f64,
    points: f64,
    travel: f64,
    /// Half the length of the range, its least angle, and by how much the greatest one is more.
    x: f64,
    turn: f64,
    from: f64,
}

/// Lines in a range with a rotary axis.
fn with_a_rotary_axis(shop: Shop, how: &Turning) -> Result<(), TestCaseError> {
    let Turning { y, kind, spacing, points, travel, x, turn, from } = *how;
    let table = OnTable { shop, axis: 'A', y };
    let (least, greatest) = (from, ((from + turn) * 1000.0).round() / 1000.0);
    let range = format!(
        "TCH PROBE 5.0 RANGE\nTCH PROBE 5.1 PGM NAME: DATA\nTCH PROBE 5.2 Z X-{x} A{least:+} Z+0\nTCH PROBE 5.3 X+{x} A{greatest:+} Z+25\nTCH PROBE 5.4 HEIGHT: +40\n"
    );
    let (number, name, direction, rest) = match kind {
        0 => (6, "MEANDER", 'X', ""),
        1 => (6, "MEANDER", 'A', ""),
        2 => (8, "LINE", 'X', " HEIGHT: +32"),
        3 => (8, "LINE", 'A', " HEIGHT: +32"),
        _ => (18, "LINE", 'X', " ANGLE: 0 HEIGHT: +32"),
    };
    let how = if number == 18 {
        format!("F1000 FMIN500 MIN.L.SPAC: 0 L.SPAC: {spacing} P.SPAC: {points} TOL: 0 DIST: 1")
    } else {
        format!("TRAVEL: {travel} L.SPAC: {spacing} P.SPAC: {points}")
    };
    let cycle = format!(
        "TCH PROBE {number}.0 {name}\nTCH PROBE {number}.1 DIRECTN: {direction}{rest}\nTCH PROBE {number}.2 {how}\n"
    );
    let file = table.digitize(&range, &cycle)?;
    let (begin, end) = if direction == 'X' { (least, greatest) } else { (-x, x) };
    let mut lines = vec![begin];
    while let Some(last) = lines.last().copied().filter(|last| end - last > 1e-6) {
        lines.push((last + spacing).min(end));
    }
    let mut seen = vec![(f64::INFINITY, f64::NEG_INFINITY); lines.len()];
    let mut before: Option<Turned> = None;
    for point in turned_blocks(&file, 'A') {
        if point.rapid {
            before = None;
            continue;
        }
        let gap = table.gap(point);
        let on_floor = point.z.abs() < WRITTEN && gap > -2.0 * WRITTEN;
        prop_assert!(gap.abs() < 2.0 * WRITTEN || on_floor, "{} mm from the part at {:?}\n{}", gap, point, cycle);
        let (along, across) = if direction == 'X' { (point.x, point.angle) } else { (point.angle, point.x) };
        let line = lines.iter().position(|line| (line - across).abs() < WRITTEN);
        prop_assert!(line.is_some() || number == 6, "{:?} is on no line", point);
        if let Some((low, high)) = line.and_then(|line| seen.get_mut(line)) {
            (*low, *high) = (low.min(along), high.max(along));
        }
        if let Some(before) = before {
            let far = length([point.x - before.x, point.angle - before.angle, point.z - before.z]);
            // Along the rotary axis a wall is between two points that are over each other.
            let is_wall = (point.angle - before.angle).abs() < WRITTEN && (direction == 'A' || point.x == before.x);
            prop_assert!(
                far < points + 3.0 * WRITTEN || is_wall,
                "{} from {:?} to {:?}\n{}",
                far,
                before,
                point,
                cycle
            );
            table.between(before, point)?;
        }
        before = Some(point);
    }
    let (first, last) = if direction == 'X' { (-x, x) } else { (least, greatest) };
    for (low, high) in seen {
        prop_assert!((low - first).abs() < WRITTEN && (high - last).abs() < WRITTEN, "a line from {} to {}", low, high);
    }
    table.runs(&file)?;
    Ok(())
}

laws! {
    #![proptest_config(config(30))]

    /// In a range with a rotary axis: lines along the linear axis, and along the rotary one.
    #[test]
    fn lines_with_a_rotary_axis_lie_on_the_part(
        shop in shop(2), y in mm(-3.0..3.0), kind in 0..5_u8, spacing in mm(2.0..5.0), points in mm(0.5..2.0), travel in mm(0.0..2.0),
        x in mm(2.0..5.0), turn in mm(4.0..25.0), from in mm(-60.0..60.0),
    ) {
        with_a_rotary_axis(shop, &Turning { y, kind, spacing, points, travel, x, turn, from })?;
    }

    /// Contour lines while the table turns once: the stylus goes to and fro along X.
    #[test]
    fn contour_lines_with_a_rotary_axis_go_once_around(
        part in part(), radius in mm(1.0..4.0), at in (mm(-1.0..1.0), mm(-1.0..1.0)), y in mm(-0.5..0.5), points in mm(2.0..5.0),
        step in mm(0.8..3.0), travel in mm(0.0..2.0), forwards in any::<bool>(), down in any::<bool>(), from in mm(-90.0..90.0),
    ) {
        let top = match part {
            Part::Block { top, .. } | Part::Stud { top, .. } => top - 0.1,
            Part::Ball { radius, below } | Part::Roll { radius, below, .. } => radius - below - 1.5,
            Part::Hill { .. } => return Ok(()),
        };
        prop_assume!(top > 0.2);
        // The axis is in the part, so that it is there at every angle.
        if let Part::Stud { radius, .. } = part {
            prop_assume!(radius > 2.5);
        }
        let top = (top * 1000.0).round() / 1000.0;
        let table = OnTable { shop: Shop { radius, parts: vec![Placed { part, at: [at.0, at.1] }] }, axis: 'C', y };
        let (sign, spacing) = (if forwards { '+' } else { '-' }, if down { -step } else { step });
        let (least, greatest) = (from - 10.0, from + 350.0);
        let program = format!(
            "TCH PROBE 7.0 CONTOUR LINES\nTCH PROBE 7.1 TIME: 0 X+25 C{from:+}\nTCH PROBE 7.2 ORDER: X- / C{sign}\n\
             TCH PROBE 7.3 TRAVEL: {travel} L.SPAC: {spacing:+} P.SPAC: {points}\n"
        );
        let range = format!(
            "TCH PROBE 5.0 RANGE\nTCH PROBE 5.1 PGM NAME: DATA\nTCH PROBE 5.2 Z X-30 C{least:+.3} Z+0\nTCH PROBE 5.3 X+30 C{greatest:+.3} Z{top:+.3}\nTCH PROBE 5.4 HEIGHT: +40\n"
        );
        let file = table.digitize(&range, &program)?;
        let all = turned_blocks(&file, 'C');
        let mut lines: Vec<Vec<Turned>> = Vec::new();
        for block in all.iter().filter(|block| !block.rapid) {
            if block.only_z {
                lines.push(Vec::new());
            }
            lines.last_mut().expect("a height first").push(*block);
        }
        prop_assert_eq!(lines.len(), (top / step + 1e-9).floor() as usize + 1);
        for (count, line) in lines.iter().enumerate() {
            let way = step * count as f64;
            let height = if down { top - way } else { way };
            // Down, the points, back along X, and back about C.
            let (points_of_line, back) = line[1..].split_at(line.len() - 3);
            prop_assert_eq!((back[0].x, back[1].x), (25.0, 25.0));
            prop_assert!((back[1].angle - from).abs() < WRITTEN);
            let (first, last) = (points_of_line[0], points_of_line[points_of_line.len() - 1]);
            let turned = if forwards { 360.0 } else { -360.0 };
            prop_assert!((last.angle - first.angle - turned).abs() < WRITTEN && (last.x - first.x).abs() < 2.0 * WRITTEN);
            for pair in points_of_line.windows(2) {
                let (a, b) = (pair[0], pair[1]);
                prop_assert!(table.gap(b).abs() < 2.0 * WRITTEN, "{} mm from the part at {:?}", table.gap(b), b);
                prop_assert!((b.z - height).abs() < WRITTEN);
                prop_assert!((b.angle - a.angle) * turned >= 0.0);
                prop_assert!(length([b.x - a.x, b.angle - a.angle, 0.0]) < points + 3.0 * WRITTEN, "{:?} {:?}", a, b);
                table.between(a, b)?;
            }
        }
        table.runs(&file)?;
    }
}

/// How far a place is outside of a polygon; 0 inside of it.
fn outside(corners: &[[f64; 2]], [x, y]: [f64; 2]) -> f64 {
    let (mut inside, mut near) = (false, f64::INFINITY);
    for (index, a) in corners.iter().enumerate() {
        let b = corners[(index + 1) % corners.len()];
        if (a[1] > y) != (b[1] > y) && x < a[0] + (b[0] - a[0]) * (y - a[1]) / (b[1] - a[1]) {
            inside = !inside;
        }
        let (u, v) = (b[0] - a[0], b[1] - a[1]);
        let share = (((x - a[0]) * u + (y - a[1]) * v) / (u * u + v * v)).clamp(0.0, 1.0);
        near = near.min((x - a[0] - u * share).hypot(y - a[1] - v * share));
    }
    if inside { 0.0 } else { near }
}

/// What searches have found.
mod found {
    use super::*;

    /// At the end of a wall the ball grazes it and goes on to the end of the range.
    #[test]
    fn past_the_end_of_a_wall() {
        let part = Part::Stud { radius: 3.208, top: 2.746 };
        let shop = Shop { radius: 1.235, parts: vec![Placed { part, at: [3.513, 4.444] }] };
        let how = Turning {
            y: 1.128,
            kind: 1,
            spacing: 3.89,
            points: 1.856,
            travel: 0.0,
            x: 3.73,
            turn: 6.106,
            from: -8.289,
        };
        with_a_rotary_axis(shop, &how).expect("the lines");
    }
}
