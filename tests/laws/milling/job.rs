//! A job for a milling tool: the program around a cycle, the part that it is to leave, and what every run keeps to.
//!
//! Invariant: sizes in here are those of the program; `View` leads from the program to the workpiece.
use std::fmt::Write as _;

use ciklo::base::diag::Source;
use ciklo::engine::geometry::{Axis, Frame, WorkingPlane};
use ciklo::engine::run::{Engine, Event, EventKind, MoveKind, NoTexts, Outcome, Status};
use ciklo::engine::scene::Scene;
use ciklo::engine::solid::Shape;
use ciklo::engine::stock::{FindingKind, Machining, Report};
use ciklo::program::syntax;
use glam::{DVec2, DVec3};
use proptest::prelude::*;

use super::field::{Move, Piece, follow, widest};
use crate::built::{Built, built};

/// How far a surface may lie beside its place, mm; what the run adds up stays far below.
pub(super) const NEAR: f64 = 1e-4;
/// Height of the blank.
pub(super) const HEIGHT: f64 = 25.0;
/// Size of the columns.
pub(super) const RESOLUTION: f64 = 1.1;
/// Feeds, by which moves are told apart: plunging, milling, finishing.
pub(super) const PLUNGE: f64 = 150.0;
pub(super) const MILL: f64 = 500.0;
pub(super) const FINISH: f64 = 600.0;

/// The few cases that a law of these cycles tries.
pub(super) fn config() -> ProptestConfig {
    crate::cases::config(6)
}

/// Lengths in hundredths of a mm, so that programs are easy to read.
pub(super) fn mm(range: std::ops::Range<f64>) -> impl Strategy<Value = f64> {
    range.prop_map(|value| (value * 100.0).round() / 100.0)
}

/// A transformation of the program.
#[derive(Clone, Copy, Debug)]
pub(super) struct View {
    pub(super) mirror: [bool; 2],
    pub(super) turn: f64,
    pub(super) scale: f64,
}

impl View {
    pub(super) const PLAIN: Self = Self { mirror: [false; 2], turn: 0.0, scale: 1.0 };

    /// Where a point of the program lies in the working plane of the workpiece.
    pub(super) fn point(&self, p: DVec2) -> DVec2 {
        let flip = |yes: bool, value: f64| if yes { -value } else { value };
        let [x, y] = self.mirror;
        DVec2::from_angle(self.turn.to_radians()).rotate(DVec2::new(flip(x, p.x), flip(y, p.y))) * self.scale
    }

    /// Whether left and right are changed over.
    pub(super) const fn flips(&self) -> bool {
        self.mirror[0] != self.mirror[1]
    }

    /// The direction of an angle.
    pub(super) fn angle(&self, degrees: f64) -> f64 {
        let (s, c) = degrees.to_radians().sin_cos();
        let way = self.point(DVec2::new(c, s));
        way.y.atan2(way.x).to_degrees()
    }
}

fn view() -> impl Strategy<Value = View> {
    prop_oneof![
        3 => Just(View::PLAIN),
        1 => (any::<bool>(), any::<bool>()).prop_map(|(x, y)| View { mirror: [x, y], ..View::PLAIN }),
        1 => mm(-180.0..180.0).prop_map(|turn| View { turn, ..View::PLAIN }),
        1 => mm(0.5..1.5).prop_map(|scale| View { scale, ..View::PLAIN }),
    ]
}

/// The tool axis, the tool, the surface of the blank along the tool axis, and what most cycles ask for.
#[derive(Clone, Debug)]
pub(super) struct Job {
    pub(super) axis: Axis,
    pub(super) view: View,
    pub(super) radius: f64,
    /// `R2`.
    pub(super) corner: f64,
    /// The plunging angle and the length of the edges in the tool table.
    pub(super) angle: f64,
    pub(super) edges: f64,
    pub(super) surface: f64,
    pub(super) clearance: f64,
    pub(super) second: f64,
    pub(super) depth: f64,
    pub(super) infeed: f64,
    pub(super) climb: f64,
    /// Half the extent of the blank in the working plane.
    pub(super) half: DVec2,
    /// Whether the blank is a cylinder of that radius.
    pub(super) round: bool,
}

prop_compose! {
    pub(super) fn job()(
        axis in prop::sample::select(Axis::ALL.to_vec()), view in view(), radius in mm(1.5..6.0), angle in mm(2.0..30.0),
        edges in prop_oneof![2 => Just(0.0), 1 => mm(1.0..12.0)], surface in -10..10, clearance in mm(1.0..5.0),
        second in prop_oneof![Just(0.0), mm(6.0..40.0)], depth in mm(0.5..15.0), infeed in mm(0.8..9.0), climb in any::<bool>(),
    ) -> Job {
        let climb = if climb { 1.0 } else { -1.0 };
        let half = DVec2::splat(55.0);
        Job { axis, view, radius, corner: 0.0, angle, edges, surface: f64::from(surface), clearance, second, depth, infeed, climb, half, round: false }
    }
}

/// What a run left behind.
pub(super) struct Done {
    pub(super) report: Report,
    pub(super) pieces: Vec<Piece>,
    /// Where the last call ended: main and secondary axis and height, on the workpiece.
    pub(super) end: DVec3,
    /// Program and scene.
    pub(super) both: String,
}

/// The parameters of a cycle: numbers and values.
pub(super) fn definition(cycle: u16, values: &[(u16, f64)]) -> String {
    values.iter().fold(format!("CYCL DEF {cycle}\n"), |mut text, (q, value)| {
        let _ = writeln!(text, "Q{q}={value:+}");
        text
    })
}

impl Job {
    pub(super) fn plane(&self) -> WorkingPlane {
        WorkingPlane::of_tool_axis(self.axis)
    }

    /// The radius of the tool in the units of the program.
    pub(super) fn tool(&self) -> f64 {
        self.radius / self.view.scale
    }

    /// The deepest infeed that edges allow.
    pub(super) fn step(&self) -> f64 {
        if self.edges > 0.0 { self.infeed.min(self.edges / self.view.scale) } else { self.infeed }
    }

    /// The height at which the tool waits.
    pub(super) fn safe(&self) -> f64 {
        self.surface + if self.second == 0.0 { self.clearance } else { self.second }
    }

    /// A point of the workpiece.
    pub(super) fn at(&self, x: f64, y: f64, z: f64) -> DVec3 {
        self.plane().lift(DVec2::new(x, y), z)
    }

    /// A point of the program on the workpiece.
    pub(super) fn place(&self, p: DVec2, z: f64) -> DVec3 {
        self.plane().lift(self.view.point(p), z * self.view.scale)
    }

    /// The words of a position.
    pub(super) fn words(&self, p: DVec2) -> String {
        let plane = self.plane();
        format!("{}{:+} {}{:+}", plane.main.letter(), p.x, plane.secondary.letter(), p.y)
    }

    /// A call at a position.
    pub(super) fn call(&self, p: DVec2) -> String {
        format!("L {} R0 FMAX M99\n", self.words(p))
    }

    fn transforms(&self) -> String {
        let View { mirror, turn, scale } = self.view;
        let plane = self.plane();
        let letters: Vec<String> = [plane.main, plane.secondary]
            .iter()
            .zip(mirror)
            .filter(|(_, yes)| *yes)
            .map(|(axis, _)| axis.letter().to_string())
            .collect();
        let mut text = String::new();
        if !letters.is_empty() {
            let _ = writeln!(text, "CYCL DEF 8.0\nCYCL DEF 8.1 {}", letters.join(" "));
        }
        if turn != 0.0 {
            let _ = writeln!(text, "CYCL DEF 10.0\nCYCL DEF 10.1 ROT{turn:+}");
        }
        if scale != 1.0 {
            let _ = writeln!(text, "CYCL DEF 11.0\nCYCL DEF 11.1 SCL {scale}");
        }
        text
    }

    /// The corners of the blank.
    fn blank(&self) -> [DVec3; 2] {
        let (half, top) = (self.half, self.surface * self.view.scale);
        [self.at(-half.x, -half.y, top - HEIGHT), self.at(half.x, half.y, top)]
    }

    pub(super) fn program(&self, body: &str) -> String {
        let [min, max] = self.blank();
        let letter = self.axis.letter();
        format!(
            "BEGIN PGM LAW MM\nBLK FORM 0.1 {letter} X{:+} Y{:+} Z{:+}\nBLK FORM 0.2 X{:+} Y{:+} Z{:+}\n\
             TOOL CALL 1 {letter} S2000 F300\nL {letter}+90 R0 FMAX M3\n{}{body}L {letter}+90 R0 FMAX M30\nEND PGM LAW MM\n",
            min.x,
            min.y,
            min.z,
            max.x,
            max.y,
            max.z,
            self.transforms()
        )
    }

    pub(super) fn scene(&self) -> String {
        let start = self.at(0.0, 0.0, 100.0);
        let mut scene = format!(
            "scene: 1\ntools: [{{T: 1, L: 100, R: {}, R2: {}, ANGLE: {}, LCUTS: {}}}]\nstart: [{}, {}, {}]\n",
            self.radius, self.corner, self.angle, self.edges, start.x, start.y, start.z
        );
        if self.round {
            let top = self.surface * self.view.scale;
            let _ = writeln!(
                scene,
                "stock: {{cylinder: {{axis: {}, diameter: {}, from: {}, to: {top}}}}}",
                self.axis.letter(),
                2.0 * self.half.x,
                top - HEIGHT
            );
        }
        scene
    }

    /// Runs the program: how it ended, its events, program and scene.
    pub(super) fn run(&self, body: &str, see: &mut dyn FnMut(&Event)) -> (Outcome, String) {
        self.run_with("", body, see)
    }

    /// The same in a scene with more in it.
    pub(super) fn run_with(&self, more: &str, body: &str, see: &mut dyn FnMut(&Event)) -> (Outcome, String) {
        let Built { files, catalogue, .. } = built();
        let (program, scene) = (self.program(body), self.scene() + more);
        let on = catalogue.on("tnc640").expect("a control");
        let read = Scene::parse(&Source::new("scene.yaml", scene.as_str()), files).expect("a scene");
        let tree = syntax::parse(&Source::new("LAW.H", program.as_str()));
        let outcome = Engine::new(&tree, on, &read, &NoTexts).with_catalogue(catalogue).run(&mut |event| see(&event));
        (outcome, format!("\n{program}\n{scene}"))
    }

    /// Machines: the part is the blank without the `hollow` (or with only the `hollow` and the base below `floor`
    /// standing, see `leaves_stud`), and nothing that every run must keep to is broken.
    pub(super) fn leaves(&self, body: &str, hollow: Vec<Shape>, short_edges: bool) -> Result<Done, TestCaseError> {
        let [min, max] = self.blank();
        let mut shapes = vec![Shape::Box { min, max }];
        shapes.extend(hollow);
        self.leaves_part(body, &Shape::Difference(shapes), short_edges)
    }

    /// The same, and the part is given.
    pub(super) fn leaves_part(&self, body: &str, part: &Shape, short_edges: bool) -> Result<Done, TestCaseError> {
        let (done, stock) = self.machined(body, short_edges)?;
        let deviation = stock.compare(part, NEAR).expect("a comparison");
        prop_assert!(deviation.is_none(), "{:?}{}", deviation, done.both);
        Ok(done)
    }

    /// The same, and nothing is said of the part.
    pub(super) fn machined(
        &self,
        body: &str,
        short_edges: bool,
    ) -> Result<(Done, ciklo::engine::stock::Stock), TestCaseError> {
        let Built { files, .. } = built();
        let (program, scene) = (self.program(body), self.scene());
        let read = Scene::parse(&Source::new("scene.yaml", scene.as_str()), files).expect("a scene");
        let tree = syntax::parse(&Source::new("LAW.H", program.as_str()));
        let mut machining = Machining::new(&tree, &read, Some(RESOLUTION)).expect("a stock");
        let (mut moves, mut ends) = (Vec::new(), Vec::new());
        let (outcome, both) = self.run(body, &mut |event| {
            machining.see(event);
            if let EventKind::Move { kind, feed, path, machine, .. } = &event.kind {
                let rapid = matches!(kind, MoveKind::Rapid | MoveKind::Arc { rapid: true, .. });
                moves.push(Move { path: *path, feed: *feed, rapid });
                ends.push(*machine);
            }
        });
        prop_assert_eq!(outcome.status, Status::Done, "{:?}{}", outcome.fault, both);
        let (stock, report) = machining.finish();
        for finding in &report.findings {
            let expected = short_edges && finding.kind == FindingKind::EdgesTooShort;
            prop_assert!(expected, "{:?}{}", finding, both);
        }
        prop_assert!((report.blank - report.removed - stock.volume()).abs() < 1e-4, "volumes{}", both);
        let plane = self.plane();
        // The last move of all goes up again.
        let end = ends.iter().rev().nth(1).copied().unwrap_or_default();
        let end = plane.flat(end).extend(self.axis.of(end));
        let surface = self.surface * self.view.scale;
        let pieces = follow(&moves, plane, self.radius, (self.half, self.round), surface);
        for piece in &pieces {
            prop_assert!(piece.feed.is_finite() || piece.depth == 0.0, "rapid traverse cuts: {:?}{}", piece, both);
        }
        Ok((Done { report, pieces, end, both }, stock))
    }

    /// The tool has ended at a place of the program.
    pub(super) fn ends(&self, done: &Done, at: DVec2, height: f64) -> Result<(), TestCaseError> {
        let wanted = self.view.point(at).extend(height * self.view.scale);
        prop_assert!((done.end - wanted).length() < 1e-6, "ends at {} and not at {}{}", done.end, wanted, done.both);
        Ok(())
    }

    /// No cut at all is deeper, by the columns of the stock.
    pub(super) fn deepest(&self, done: &Done, deepest: f64) -> Result<(), TestCaseError> {
        let (found, deepest) = (done.report.depth.value, deepest * self.view.scale);
        prop_assert!(found <= deepest + 1e-6, "{} is deeper than {}{}", found, deepest, done.both);
        Ok(())
    }

    /// No piece at that feed is deeper.
    pub(super) fn depth_at(&self, done: &Done, feed: f64, deepest: f64) -> Result<(), TestCaseError> {
        let deepest = deepest * self.view.scale;
        for piece in done.pieces.iter().filter(|piece| piece.feed == feed) {
            prop_assert!(piece.depth <= deepest + 1e-6, "{:?} is deeper than {}{}", piece, deepest, done.both);
        }
        Ok(())
    }

    /// No piece at that feed is wider than laps at a distance of `step` explain, apart from where `free` says so.
    pub(super) fn width_at(
        &self,
        done: &Done,
        feed: f64,
        step: f64,
        free: &dyn Fn(DVec2) -> bool,
    ) -> Result<(), TestCaseError> {
        let step = step * self.view.scale;
        for (index, piece) in done.pieces.iter().enumerate() {
            if piece.feed != feed || piece.left.is_none() || free(piece.at) {
                continue;
            }
            let most = widest(&done.pieces, index, self.radius, step);
            prop_assert!(piece.width() <= most + 0.1, "wider than {}: {:?}{}", most, piece, done.both);
        }
        Ok(())
    }

    /// On straight pieces at that feed, the material is on the right of the path if the tool climbs (it turns
    /// clockwise), and on the left if it does not: a lap takes what it lies beside the one before, from its rim on. Yields how much
    /// more of it was on the wrong side than on the right one, mm².
    pub(super) fn climbs_at(
        &self,
        done: &Done,
        feed: f64,
        step: f64,
        free: &dyn Fn(DVec2) -> bool,
    ) -> Result<f64, TestCaseError> {
        // Mirroring one axis changes the direction.
        let climb = if self.view.flips() { -self.climb } else { self.climb };
        let pieces = &done.pieces;
        let mut sum = 0.0;
        for (index, piece) in pieces.iter().enumerate() {
            let straight =
                |n: usize| pieces.get(n).is_none_or(|near| near.turn.to_degrees() < 12.0 && near.length > 0.0);
            let reach = (2.5 * self.radius / 0.4) as usize;
            let calm = || (index.saturating_sub(reach)..index + reach).all(straight);
            let Some(left) = piece.left.filter(|_| piece.feed == feed && !free(piece.at) && calm()) else { continue };
            let most = left.map(|side| side * climb).into_iter().fold(f64::NEG_INFINITY, f64::max);
            let inner = widest(pieces, index, self.radius, step * self.view.scale) - self.radius;
            // Chords of a bend point a little beside it.
            let slack = 0.25 + 0.5 * self.radius * if piece.bend.is_finite() { piece.turn } else { 0.0 };
            prop_assert!(most <= inner + slack, "the wrong way round: {:?}{}", piece, done.both);
            sum += piece.side() * climb * piece.length;
        }
        Ok(sum)
    }

    /// Upright walls about a shape of the program's plane, from a floor up beyond the blank.
    pub(super) fn round(&self, centre: DVec2, radius: f64, floor: f64) -> Shape {
        let scale = self.view.scale;
        let high = self.surface + 60.0 / scale;
        Shape::Cylinder { from: self.place(centre, high), to: self.place(centre, floor), radius: radius * scale }
    }

    /// A rectangle with round corners.
    pub(super) fn rectangle(&self, centre: DVec2, half: DVec2, corner: f64, rotation: f64, floor: f64) -> Shape {
        let (k, high) = (self.view.scale, self.surface * self.view.scale + 60.0);
        let middle = self.view.point(centre);
        let frame =
            Frame::shift(self.at(middle.x, middle.y, 0.0)).of(Frame::rotate(self.axis, self.view.angle(rotation)));
        let slab = |half: DVec2| Shape::Box {
            min: self.at(-half.x * k, -half.y * k, floor * k),
            max: self.at(half.x * k, half.y * k, high),
        };
        let mut shapes = vec![slab(half - DVec2::X * corner), slab(half - DVec2::Y * corner)];
        let arm = half - DVec2::splat(corner);
        for (x, y) in [(1.0, 1.0), (1.0, -1.0), (-1.0, 1.0), (-1.0, -1.0)] {
            let at = |z: f64| self.at(x * arm.x * k, y * arm.y * k, z);
            shapes.push(Shape::Cylinder { from: at(high), to: at(floor * k), radius: corner * k });
        }
        // A side as long as the corners are round is no slab, and a sharp corner is not round.
        shapes.retain(|shape| match shape {
            Shape::Box { min, max } => (*max - *min).min_element() > 1e-9,
            _ => corner > 0.0,
        });
        Shape::Placed { frame, shape: Box::new(Shape::Union(shapes)) }
    }
}

/// The distance of a point from a stretch.
pub(super) fn beside(p: DVec2, a: DVec2, b: DVec2) -> f64 {
    let way = b - a;
    let share = if way.length() < 1e-9 { 0.0 } else { (p - a).dot(way) / way.length_squared() };
    (p - a - way * share.clamp(0.0, 1.0)).length()
}
