//! Runs of contours, and where the tool's centre went in the coordinates of the program.
//!
//! Invariant: the way is that of the machine, led back through the transformations by the formulas here.
use std::fmt::Write as _;

use crate::built::{Built, built};
pub(super) use crate::cases::config;
use ciklo::base::diag::Source;
use ciklo::engine::geometry::{Axis, WorkingPlane};
use ciklo::engine::run::{Engine, EventKind, MoveKind, NoTexts, Status};
use ciklo::engine::scene::Scene;
use ciklo::engine::solid::Path;
use ciklo::engine::stock::{Machining, Stock};
use ciklo::program::syntax;
use glam::{DVec2, DVec3};
use proptest::prelude::*;
use std::f64::consts::TAU;

/// What a distance may be wrong, mm.
pub(super) const NEAR: f64 = 1e-6;
/// Half the extent of the blank in the working plane.
const HALF: f64 = 70.0;

/// A piece of a path in the working plane, in coordinates of the program.
#[derive(Clone, Copy, Debug)]
pub(super) struct Piece {
    pub(super) line: usize,
    pub(super) from: DVec2,
    pub(super) to: DVec2,
    /// Centre, radius and signed angle of an arc.
    pub(super) arc: Option<(DVec2, f64, f64)>,
    /// Heights along the tool axis.
    pub(super) heights: [f64; 2],
}

impl Piece {
    pub(super) const fn flat(from: DVec2, to: DVec2, arc: Option<(DVec2, f64, f64)>) -> Self {
        Self { line: 0, from, to, arc, heights: [0.0; 2] }
    }

    pub(super) fn at(&self, t: f64) -> DVec2 {
        match self.arc {
            None => self.from + (self.to - self.from) * t,
            Some((centre, _, angle)) => {
                let (s, c) = (angle * t).sin_cos();
                let arm = self.from - centre;
                centre + DVec2::new(arm.x * c - arm.y * s, arm.x * s + arm.y * c)
            }
        }
    }

    pub(super) fn heading(&self, at: DVec2) -> DVec2 {
        match self.arc {
            None => (self.to - self.from).normalize(),
            Some((centre, _, angle)) => (at - centre).perp().normalize() * angle.signum(),
        }
    }

    pub(super) fn length(&self) -> f64 {
        self.arc.map_or_else(|| self.from.distance(self.to), |(_, radius, angle)| radius * angle.abs())
    }

    /// The distance of a point from it.
    pub(super) fn distance(&self, point: DVec2) -> f64 {
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

pub(super) fn far(path: &[Piece], point: DVec2) -> f64 {
    path.iter().map(|piece| piece.distance(point)).fold(f64::INFINITY, f64::min)
}

/// The tool axis and what changes the coordinate system: the mirrored contour is turned, and then scaled.
#[derive(Clone, Copy, Debug)]
pub(super) struct View {
    pub(super) axis: Axis,
    pub(super) mirror: [bool; 2],
    pub(super) turn: f64,
    pub(super) scale: f64,
}

pub(super) fn view() -> impl Strategy<Value = View> {
    let turn = prop_oneof![2 => Just(0.0), 1 => (-180..180).prop_map(f64::from)];
    let scale = prop_oneof![2 => Just(1.0), 1 => (60..140).prop_map(|percent| f64::from(percent) / 100.0)];
    let axes = prop::sample::select(Axis::ALL.to_vec());
    let mirrored = prop_oneof![2 => Just([false; 2]), 1 => [any::<bool>(), any::<bool>()]];
    (axes, mirrored, turn, scale).prop_map(|(axis, mirror, turn, scale)| View { axis, mirror, turn, scale })
}

impl View {
    pub(super) fn plane(&self) -> WorkingPlane {
        WorkingPlane::of_tool_axis(self.axis)
    }

    /// The words of a point of the working plane.
    pub(super) fn words(&self, p: DVec2) -> String {
        let plane = self.plane();
        format!("{}{:+} {}{:+}", plane.main.letter(), p.x, plane.secondary.letter(), p.y)
    }

    /// A place of the working plane of the machine in coordinates of the program.
    pub(super) fn back(&self, place: DVec2) -> DVec2 {
        let (s, c) = (-self.turn.to_radians()).sin_cos();
        let p = place / self.scale;
        let p = DVec2::new(p.x * c - p.y * s, p.x * s + p.y * c);
        DVec2::new(if self.mirror[0] { -p.x } else { p.x }, if self.mirror[1] { -p.y } else { p.y })
    }

    /// The beginning of a program: blank, tool, transformations, and the tool beside the blank at a height.
    pub(super) fn head(&self, height: f64) -> String {
        let (plane, letter) = (self.plane(), self.axis.letter());
        let half = DVec2::splat(HALF * self.scale);
        let (min, max) = (plane.lift(-half, -20.0 * self.scale), plane.lift(half, 0.0));
        let mut text = format!(
            "BEGIN PGM LAW MM\nBLK FORM 0.1 {letter} X{:+} Y{:+} Z{:+}\nBLK FORM 0.2 X{:+} Y{:+} Z{:+}\n\
             TOOL CALL 1 {letter} S1000 F500\nL {letter}+90 R0 FMAX M3\n",
            min.x, min.y, min.z, max.x, max.y, max.z
        );
        // What is defined first acts last.
        if self.scale != 1.0 {
            let _ = writeln!(text, "CYCL DEF 11.0 SCALING\nCYCL DEF 11.1 SCL {}", self.scale);
        }
        if self.turn != 0.0 {
            let _ = writeln!(text, "CYCL DEF 10.0 ROTATION\nCYCL DEF 10.1 ROT{:+}", self.turn);
        }
        let axes = [(self.mirror[0], plane.main), (self.mirror[1], plane.secondary)];
        let letters: Vec<String> =
            axes.iter().filter(|(yes, _)| *yes).map(|(_, axis)| axis.letter().to_string()).collect();
        if !letters.is_empty() {
            let _ = writeln!(text, "CYCL DEF 8.0 MIRROR IMAGE\nCYCL DEF 8.1 {}", letters.join(" "));
        }
        let outside = DVec2::splat(90.0);
        let _ = writeln!(text, "L {} R0 FMAX\nL {letter}{height:+} R0 F200", self.words(outside));
        text
    }

    fn scene(&self, tool: f64) -> String {
        let start = self.plane().lift(DVec2::ZERO, 100.0);
        format!(
            "scene: 1\ntools: [{{T: 1, L: 100, R: {}}}]\nstart: [{}, {}, {}]\n",
            tool * self.scale,
            start.x,
            start.y,
            start.z
        )
    }
}

pub(super) struct Ran {
    pub(super) code: String,
    pub(super) status: Status,
    /// The moves in the working plane.
    pub(super) path: Vec<Piece>,
    pub(super) stock: Stock,
    /// Program and scene.
    pub(super) both: String,
}

/// Runs a program with a tool of that radius in units of the program.
pub(super) fn run(view: &View, program: &str, tool: f64) -> Ran {
    let Built { files, catalogue, .. } = built();
    let text = view.scene(tool);
    let scene = Scene::parse(&Source::new("scene.yaml", text.as_str()), files).expect("a scene");
    let tree = syntax::parse(&Source::new("LAW.H", program));
    let on = catalogue.on("tnc640").expect("a control");
    let mut machining = Machining::new(&tree, &scene, Some(1.1 * view.scale)).expect("a stock");
    let mut path = Vec::new();
    let plane = view.plane();
    let seen = |p: DVec3| (view.back(plane.flat(p)), plane.tool.of(p) / view.scale);
    let flips = if view.mirror[0] == view.mirror[1] { 1.0 } else { -1.0 };
    let outcome = Engine::new(&tree, on, &scene, &NoTexts).with_catalogue(catalogue).run(&mut |event| {
        machining.see(&event);
        let EventKind::Move { kind, path: way, .. } = &event.kind else { return };
        let ((from, low), (to, high)) = (seen(way.at(0.0)), seen(way.at(1.0)));
        let arc = match way {
            Path::Line { .. } => None,
            Path::Arc { centre, axis, sweep, .. } => {
                let centre = seen(*centre).0;
                Some((centre, from.distance(centre), sweep.to_radians() * plane.tool.of(*axis) * flips))
            }
        };
        let moved = arc.is_some() || from.distance(to) > 1e-9;
        if moved && *kind != MoveKind::Rapid {
            path.push(Piece { line: event.at.line, from, to, arc, heights: [low, high] });
        }
    });
    let code = outcome.fault.as_ref().map_or_else(String::new, |fault| fault.code.to_string());
    let both = format!("\n{program}\n{text}");
    Ran { code, status: outcome.status, path, stock: machining.finish().0, both }
}
