//! A boring bar whose edge is on one side above its tip and cuts upwards: the bar, the bore that it goes through, and what
//! it takes away at the underside.
//!
//! Invariant: the bar cuts while the spindle turns; while it stands, its edge points away from where the bar is set off.
use glam::{DVec2, DVec3};

use super::frame::Frame;
use super::half_plane::{SPECK, area, around, corners_of};
use super::pen::{Pen, Rect};
use super::shot::{BAR, Shot, number, point};
use super::slabs;
use super::stroke::{Stroke, Way};
use super::subject::Subject;

/// The width of the part that carries the edge, seen from above, as a part of the bar.
const WIDE: f64 = 0.8;

/// A boring bar and the bore.
#[derive(Clone, Copy, Debug)]
pub(super) struct Bar {
    /// The axis of the bore.
    axis: DVec3,
    /// The radii of the bore and of the bar, mm.
    bore: f64,
    neck: f64,
    /// How high the edge is above the tip, mm.
    pub(super) edge: f64,
}

/// The bar of a figure, if it has one.
pub(super) fn of(shot: &Shot) -> Option<Bar> {
    let [bore, neck, edge] = [1, 2, 3].map(|n| number(shot, BAR + n));
    Some(Bar { axis: point(shot, BAR)?, bore: bore? / 2.0, neck: neck? / 2.0, edge: edge? })
}

impl Bar {
    /// Where the edge is from the axis of the spindle while the tip is there.
    fn side(&self, tip: DVec3) -> DVec2 {
        (self.axis - tip).truncate().normalize_or(DVec2::X)
    }

    /// What it takes away, seen along the secondary axis.
    fn cuts(&self, shot: &Shot) -> Vec<Vec<DVec2>> {
        let mut all: Vec<Vec<DVec2>> = Vec::new();
        let turning = |stroke: &&Stroke| stroke.way == Way::Feed && stroke.turning.direction != 0;
        for stroke in shot.strokes.iter().filter(turning) {
            let radius = stroke.tool.radius;
            let corners = |p: &DVec3| {
                let p = DVec2::new(p.x, p.z);
                let (side, high) = (DVec2::X * radius, DVec2::Y * self.edge);
                [p - side, p + side, p + side + high, p - side + high]
            };
            for pair in stroke.points.windows(2) {
                all.push(around(pair.iter().flat_map(corners).collect()));
            }
        }
        all
    }
}

/// Draws the workpiece cut open along the axis of the bore.
pub(super) fn cut_open(pen: &mut Pen, bar: &Bar, subject: &Subject<'_>, frame: &Frame) {
    let (min, max) = (frame.material.min, frame.material.max);
    let (left, right) = (bar.axis.x - bar.bore, bar.axis.x + bar.bore);
    let bore =
        vec![DVec2::new(left, min.y), DVec2::new(right, min.y), DVec2::new(right, max.y), DVec2::new(left, max.y)];
    let mut taken = vec![bore];
    taken.extend(bar.cuts(subject.shot));
    let lines = slabs::left([min, max], &taken).into_iter().map(|line| corners_of(&line));
    let lines: Vec<Vec<DVec2>> = lines.filter(|line| line.len() > 2 && area(line).abs() > SPECK).collect();
    let placed: Vec<Vec<DVec2>> =
        lines.iter().map(|line| line.iter().map(|p| frame.camera.place(*p)).collect()).collect();
    let data: String = placed.iter().map(|line| Pen::data(line, true)).collect();
    pen.path("m", &data);
    pen.hatch(&placed);
    // The part goes on where the drawing ends.
    let is_end =
        |a: DVec2, b: DVec2| [min.x, max.x].iter().any(|end| (a.x - end).abs() < 1e-6 && (b.x - end).abs() < 1e-6);
    let sides = lines.iter().flat_map(|line| line.iter().zip(line.iter().cycle().skip(1)));
    let edges = sides.filter(|(a, b)| frame.known_edges || !is_end(**a, **b));
    let edges: String = edges.map(|(a, b)| Pen::data(&[*a, *b].map(|p| frame.camera.place(p)), false)).collect();
    pen.path("o", &edges);
    let axis = [min.y, max.y].map(|y| frame.camera.place(DVec2::new(bar.axis.x, y)));
    pen.line("x", &axis);
}

/// Draws the workpiece with its bore from above.
pub(super) fn from_above(pen: &mut Pen, bar: &Bar, frame: &Frame) {
    let (min, max) = (frame.material.min, frame.material.max);
    let corners = [min, DVec2::new(max.x, min.y), max, DVec2::new(min.x, max.y)];
    pen.area(if frame.known_edges { "m o" } else { "m" }, &corners.map(|p| frame.camera.place(p)));
    pen.circle("b o", frame.camera.place(bar.axis.truncate()), bar.bore * frame.camera.scale);
}

/// Draws the bar where it is at the moment, to scale.
pub(super) fn tool(pen: &mut Pen, bar: &Bar, subject: &Subject<'_>, frame: &Frame, is_from_above: bool) {
    let Some((tool, tip)) = subject.shot.tool else { return };
    let scale = frame.camera.scale;
    let (neck, reach, edge) = (bar.neck * scale, tool.radius * scale, bar.edge * scale);
    if is_from_above {
        let place = frame.camera.place(tip.truncate());
        let side = bar.side(tip);
        let side = DVec2::new(side.x, -side.y);
        let across = side.perp() * neck * WIDE;
        pen.area(
            "t",
            &[place + across, place + side * reach + across / 2.0, place + side * reach - across / 2.0, place - across],
        );
        pen.circle("t", place, neck);
        pen.circle("q", place + side * reach, 2.2);
        return;
    }
    let place = frame.camera.place(DVec2::new(tip.x, tip.z));
    let top = frame.paper().min.y;
    let sign = if bar.side(tip).x < 0.0 { -1.0 } else { 1.0 };
    let at = |x: f64, up: f64| place + DVec2::new(x * sign, -up);
    let (high, wave) = (place.y - top, (neck * 0.5).min(5.0));
    pen.area(
        "t",
        &[
            at(-neck, 0.0),
            at(reach, 0.0),
            at(reach, edge),
            at(neck, edge),
            at(neck, high - wave),
            at(neck / 3.0, high),
            at(-neck / 3.0, high - 2.0 * wave),
            at(-neck, high - wave),
        ],
    );
    pen.line("x", &[DVec2::new(place.x, top - 4.0), DVec2::new(place.x, place.y + 6.0)]);
    let (a, b) = (at(-neck, 0.0), at(reach, high));
    pen.blocked.push(Rect { min: a.min(b), max: a.max(b) });
}
