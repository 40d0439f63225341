//! What is milled on a rotary axis: where the tool is on the part while the table turns, and what is left across the axis.
//!
//! Invariant: ways are those on the part; it is drawn as the table holds it at the moment of the figure.
use glam::{DVec2, DVec3};

use super::half_plane::{SPECK, area, around, corners_of};
use super::slabs;
use super::stroke::{Stroke, Way};
use crate::base::expr::{cosd, sind};
use crate::engine::run::Turned;
use crate::engine::scene::Scene;

/// While the table turns, the tool is noted every so many degrees.
const STEP: f64 = 3.0;
/// Corners of a circle.
const CORNERS: usize = 120;

/// Points with the direction of the tool at each of them.
type Poses = (Vec<DVec3>, Vec<DVec3>);

/// The table of a machine with the angles of its axes.
#[derive(Clone)]
pub(super) struct Table<'s> {
    scene: &'s Scene,
    angles: DVec3,
}

impl<'s> Table<'s> {
    /// The table as it is when a run begins.
    pub(super) fn new(scene: &'s Scene) -> Self {
        Self { scene, angles: scene.start_angles }
    }

    /// Places of the machine as they lie on the table with all axes at 0.
    pub(super) fn held(&self, points: &[DVec3], up: &[DVec3]) -> Poses {
        let back = self.scene.machine.table(self.angles).inverse();
        (points.iter().map(|p| back.point(*p)).collect(), up.iter().map(|up| back.vector(*up)).collect())
    }

    /// The other way, as the axes are now.
    pub(super) fn lying(&self, points: &[DVec3], up: &[DVec3]) -> Poses {
        let table = self.scene.machine.table(self.angles);
        (points.iter().map(|p| table.point(*p)).collect(), up.iter().map(|up| table.vector(*up)).collect())
    }

    /// Turns axes; where on the table a tool is meanwhile that stays where it is.
    pub(super) fn turn(&mut self, axes: &[Turned], here: DVec3) -> Poses {
        let before = self.angles;
        let after = axes.iter().fold(before, |angles, turned| turned.axis.with(angles, turned.machine));
        let steps = ((after - before).abs().max_element() / STEP).ceil().max(1.0) as usize;
        let mut poses = Poses::default();
        for n in 0..=steps {
            self.angles = before.lerp(after, n as f64 / steps as f64);
            let (points, up) = self.held(&[here], &[DVec3::Z]);
            poses.0.extend(points);
            poses.1.extend(up);
        }
        self.angles = after;
        poses
    }
}

/// What is left of a part that is round about the datum.
#[derive(Clone, Debug)]
pub(super) struct Round {
    /// The radius of the blank, mm.
    pub(super) radius: f64,
    /// What is left of it.
    pub(super) left: Vec<Vec<DVec2>>,
    /// What will be left of it, if that is something else.
    pub(super) finished: Vec<Vec<DVec2>>,
}

impl Round {
    /// What is left after some ways and after later ones, in a plane across the axis at `plane` along it, or of all
    /// planes together.
    pub(super) fn new(radius: f64, plane: Option<f64>, [strokes, later]: [&[Stroke]; 2]) -> Self {
        let mut taken = beyond(radius);
        taken.extend(cuts(radius, plane, strokes));
        let left = without(radius, &taken);
        let later = cuts(radius, plane, later);
        let finished = if later.is_empty() {
            Vec::new()
        } else {
            taken.extend(later);
            without(radius, &taken)
        };
        Self { radius, left, finished }
    }
}

/// Whether a tool on its way meets a plane across the axis.
pub(super) fn meets(stroke: &Stroke, plane: Option<f64>) -> bool {
    let Some(plane) = plane else { return true };
    let ends = stroke.points.iter().map(|p| p.y - plane);
    let (low, high) = ends.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), y| (low.min(y), high.max(y)));
    low < stroke.tool.radius && high > -stroke.tool.radius
}

fn circle(radius: f64, n: usize) -> DVec2 {
    let angle = n as f64 * 360.0 / CORNERS as f64;
    DVec2::new(cosd(angle), sind(angle)) * radius
}

/// All that is not within the blank.
fn beyond(radius: f64) -> Vec<Vec<DVec2>> {
    let wedge = |n: usize| {
        let (a, b) = (circle(radius, n), circle(radius, n + 1));
        vec![a, a * 2.0, b * 2.0, b]
    };
    (0..CORNERS).map(wedge).collect()
}

/// What the tool takes away, seen along the rotary axis.
fn cuts(radius: f64, plane: Option<f64>, strokes: &[Stroke]) -> Vec<Vec<DVec2>> {
    let flat = |p: DVec3| DVec2::new(p.x, p.z);
    let mut all: Vec<Vec<DVec2>> = Vec::new();
    for stroke in strokes.iter().filter(|stroke| stroke.way == Way::Feed && meets(stroke, plane)) {
        let tool = |(p, up): (DVec3, DVec3)| {
            let off = plane.map_or(0.0, |plane| p.y - plane);
            let half = (stroke.tool.radius * stroke.tool.radius - off * off).max(0.0).sqrt();
            let (tip, up) = (flat(p), flat(up).normalize_or_zero());
            let (side, top) = (up.perp() * half, tip + up * (2.0 * radius));
            if half > 0.0 { vec![tip + side, tip - side, top - side, top + side] } else { Vec::new() }
        };
        let poses: Vec<(DVec3, DVec3)> = stroke.points.iter().copied().zip(stroke.up.iter().copied()).collect();
        for pair in poses.windows(2) {
            let &[from, to] = pair else { continue };
            let between = |share: f64| (from.0.lerp(to.0, share), from.1.lerp(to.1, share));
            // Where the tool is nearest to the plane, it is as wide there as can be.
            let nearest = plane.map(|plane| (plane - from.0.y) / (to.0.y - from.0.y)).filter(|share| share.is_finite());
            let shares = [0.0, nearest.unwrap_or_default().clamp(0.0, 1.0), 1.0];
            let cut = around(shares.into_iter().flat_map(|share| tool(between(share))).collect());
            if cut.len() > 2 && !all.contains(&cut) {
                all.push(cut);
            }
        }
    }
    all
}

fn without(radius: f64, taken: &[Vec<DVec2>]) -> Vec<Vec<DVec2>> {
    let lines = slabs::left([DVec2::splat(-radius), DVec2::splat(radius)], taken);
    let lines = lines.into_iter().map(|line| corners_of(&line));
    lines.filter(|line| line.len() > 2 && area(line).abs() > SPECK).collect()
}
