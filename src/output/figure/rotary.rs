//! Views along a rotary axis of the table: the axis, the calibration sphere where it is measured, and angles between.
//!
//! Invariant: knows a machine and the places of a run, no cycle. Where the sphere is follows from the kinematics and is
//! compared with where it was touched.
use glam::{DAffine3, DVec2, DVec3};

use super::pen::{ARROW, Pen, Rect, width};
use super::stroke::{Stroke, Way};
use crate::base::expr::{cosd, sind};
use crate::engine::geometry::{RotaryAxis, WorkingPlane};
use crate::engine::machine::{Carried, Machine};
use crate::spec::FigureView;

/// Angles that differ by less, degrees, are one.
const SAME: f64 = 1e-6;
/// A ball is touched where it is expected if its centre is not farther off, mm.
const NEAR: f64 = 1e-3;
/// The probe is over the sphere if it is not farther beside it, mm.
const OVER: f64 = 0.5;
/// From the centre of the sphere to the foot of its stem, as parts of its radius.
const STEM: f64 = 2.6;
/// The pieces of an arc, degrees.
const PIECE: f64 = 5.0;

/// Where the rotary axes stood when the probe touched the sphere.
#[derive(Clone, Debug)]
struct Station {
    /// Their angles in the program.
    angles: DVec3,
    /// The points that were touched.
    contacts: Vec<DVec3>,
}

/// The rotary axes of a run and a point of the table that turns with them.
#[derive(Clone, Debug)]
pub(super) struct Rotary {
    machine: Machine,
    /// The point on the table with all axes at 0.
    fixed: DVec3,
    /// What the angles of the machine are more than those of the program.
    datum: DVec3,
    back: DAffine3,
    plane: WorkingPlane,
    /// All angles at which the axes stood, in the program.
    stood: Vec<DVec3>,
    stations: Vec<Station>,
}

/// The axis along which a view is seen.
pub(super) const fn axis(view: FigureView) -> Option<RotaryAxis> {
    match view {
        FigureView::RotaryA => Some(RotaryAxis::ALL[0]),
        FigureView::RotaryB => Some(RotaryAxis::ALL[1]),
        FigureView::RotaryC => Some(RotaryAxis::ALL[2]),
        FigureView::Section
        | FigureView::Plan
        | FigureView::Side
        | FigureView::Turned
        | FigureView::Rotary
        | FigureView::ThreeD => None,
    }
}

impl Rotary {
    /// What is known when the cycle begins: the machine, the origin of the shot in it, and the angles in the machine.
    pub(super) fn new(machine: &Machine, back: DAffine3, plane: WorkingPlane, angles: DVec3, datum: DVec3) -> Self {
        let origin = back.inverse().transform_point3(DVec3::ZERO);
        let fixed = machine.table(angles).inverse().point(origin);
        let stood = vec![angles - datum];
        Self { machine: machine.clone(), fixed, datum, back, plane, stood, stations: Vec::new() }
    }

    /// The axes have turned to these angles.
    pub(super) fn turned(&mut self, angles: DVec3) {
        self.stood.push(angles);
    }

    /// The probe has touched a point while they stood there.
    pub(super) fn touched(&mut self, angles: DVec3, contact: DVec3) {
        let same = |station: &&mut Station| (station.angles - angles).abs().max_element() < SAME;
        match self.stations.iter_mut().find(same) {
            Some(station) => station.contacts.push(contact),
            None => self.stations.push(Station { angles, contacts: vec![contact] }),
        }
    }

    /// Where the point is while the axes are there.
    fn place(&self, angles: DVec3) -> DVec3 {
        self.own(self.machine.table(angles + self.datum).point(self.fixed), false)
    }

    /// The centre about which an axis of the table turns, while the others stand as they do when it is measured.
    pub(super) fn centre(&self, axis: RotaryAxis) -> Option<DVec3> {
        let data = self.machine.rotary(axis).filter(|data| matches!(data.carries, Carried::Workpiece))?;
        let angles = self.measured(axis)?.angles + self.datum;
        Some(self.own(self.machine.turning(data, angles).centre, false))
    }

    /// The angles at which the axis stood at that one of its own.
    fn standing(&self, axis: RotaryAxis, angle: f64) -> Option<DVec3> {
        let stations = self.stations.iter().map(|station| &station.angles);
        stations.chain(&self.stood).find(|angles| (axis.of(**angles) - angle).abs() < SAME).copied()
    }

    /// By how much the axis turned from one of its angles to another one; nothing if it did not stand there, or if the
    /// sphere was not touched where it is drawn.
    pub(super) fn between(&self, axis: RotaryAxis, from: f64, to: f64) -> Option<f64> {
        let [a, b] = [self.standing(axis, from)?, self.standing(axis, to)?];
        let held = |angles: DVec3| {
            let station = self.stations.iter().find(|station| (station.angles - angles).abs().max_element() < SAME);
            station.is_none_or(|station| {
                let far: Vec<f64> = station.contacts.iter().map(|p| p.distance(self.place(angles))).collect();
                far.iter().all(|own| (own - far[0]).abs() < NEAR)
            })
        };
        (held(a) && held(b)).then_some(axis.of(b) - axis.of(a))
    }

    /// The spheres that were touched on the circle around an axis: centre, foot of the stem, radius.
    pub(super) fn spheres(&self, axis: RotaryAxis) -> Vec<(DVec3, DVec3, f64)> {
        let Some(about) = self.centre(axis) else { return Vec::new() };
        let out = self.own(self.machine.table(DVec3::ZERO).vector(axis.0.unit()), true);
        let circle = |p: DVec3| ((p - about).dot(out), (p - about).reject_from(out).length());
        let sphere = |station: &Station| {
            let centre = self.place(station.angles);
            let radius = station.contacts.first().map_or(0.0, |p| p.distance(centre));
            let foot = self.fixed - self.plane.tool.unit() * radius * STEM;
            (centre, self.own(self.machine.table(station.angles + self.datum).point(foot), false), radius)
        };
        let all: Vec<_> = self.stations.iter().map(sphere).collect();
        // Of the axis itself are those that come last, before the next axis is measured: seen along it they are on one
        // circle, and so is the sphere while it stands at its angle of incidence.
        let Some((along, far)) = self.measured(axis).map(|station| circle(self.place(station.angles))) else {
            return Vec::new();
        };
        let same = |(a, r): (f64, f64)| (a - along).abs() < NEAR && (r - far).abs() < NEAR;
        all.into_iter().filter(|(centre, ..)| same(circle(*centre))).collect()
    }

    /// The first of two stations between which only this axis turned.
    fn measured(&self, axis: RotaryAxis) -> Option<&Station> {
        let only = |pair: &&[Station]| {
            let way = pair[1].angles - pair[0].angles;
            axis.of(way).abs() > SAME && axis.with(way, 0.0).abs().max_element() < SAME
        };
        self.stations.windows(2).find(only).map(|pair| &pair[0])
    }

    /// From the machine to the coordinates of the shot: a point or a direction.
    fn own(&self, machine: DVec3, direction: bool) -> DVec3 {
        let own = if direction { self.back.transform_vector3(machine) } else { self.back.transform_point3(machine) };
        self.plane.flat(own).extend(self.plane.tool.of(own))
    }

    /// The places of the point between two angles of an axis, the first to the last.
    fn arc(&self, axis: RotaryAxis, from: f64, to: f64) -> Vec<DVec3> {
        let Some(others) = self.standing(axis, to) else { return Vec::new() };
        let pieces = ((to - from).abs() / PIECE).ceil().max(2.0);
        (0..=pieces as u32).map(|n| self.place(axis.with(others, from + (to - from) * f64::from(n) / pieces))).collect()
    }
}

/// The strokes between the places at which the sphere is measured: there, only the way to it and off it.
pub(super) fn between_stations(strokes: Vec<Stroke>) -> Vec<Stroke> {
    let mut kept: Vec<Stroke> = Vec::new();
    let mut rest = strokes.into_iter().peekable();
    while let Some(first) = rest.next() {
        let angles = first.angles;
        let mut group = vec![first];
        while let Some(next) = rest.next_if(|stroke| (stroke.angles - angles).abs().max_element() < SAME) {
            group.push(next);
        }
        let probes = |stroke: &Stroke| stroke.way == Way::Probe;
        match (group.iter().position(probes), group.iter().rposition(probes)) {
            (Some(begin), Some(end)) => {
                let after = group.split_off((end + 1).min(group.len()));
                let over = group.get(begin).and_then(|stroke| stroke.points.first().copied());
                let is_over = |stroke: &Stroke| {
                    over.zip(stroke.points.last()).is_some_and(|(over, end)| over.distance(*end) < OVER)
                };
                // From the side of the sphere back over it.
                let leaves = after.iter().rposition(is_over).map_or(0, |at| at + 1);
                kept.extend(group.into_iter().take(begin));
                kept.extend(after.into_iter().skip(leaves));
            }
            _ => kept.append(&mut group),
        }
    }
    kept
}

/// Draws the axis, the circle on which the sphere goes around it, and the sphere where it was touched.
pub(super) fn draw(pen: &mut Pen, rotary: &Rotary, axis: RotaryAxis, paper: &Rect, at: &dyn Fn(DVec3) -> DVec2) {
    let Some(centre) = rotary.centre(axis).map(at) else { return };
    let pixels = |p: DVec3, r: f64| at(p + DVec3::ONE * r).x - at(p).x;
    let spheres: Vec<(DVec2, DVec2, f64)> =
        rotary.spheres(axis).iter().map(|(p, foot, r)| (at(*p), at(*foot), pixels(*p, *r))).collect();
    let far = spheres.iter().map(|(p, ..)| p.distance(centre)).fold(0.0, f64::max);
    circle(pen, centre, far, paper);
    for (sphere, foot, radius) in &spheres {
        pen.line("x", &[centre, *sphere]);
        let way = *foot - *sphere;
        // From above the sphere hides its stem.
        if way.length() > *radius {
            let wide = way.normalize().perp() * radius * 0.24;
            pen.area("m o", &[*sphere + wide, *foot + wide, *foot - wide, *sphere - wide]);
            pen.line("o", &[*foot - wide * 3.5, *foot + wide * 3.5]);
        }
        pen.circle("m o", *sphere, *radius);
    }
    let cross = 12.0;
    for end in [DVec2::X, DVec2::Y] {
        pen.line("x", &[centre - end * cross, centre + end * cross]);
    }
    pen.circle("z", centre, 4.0);
    pen.circle("q", centre, 1.2);
}

/// The part of a circle that is on the paper.
fn circle(pen: &mut Pen, centre: DVec2, radius: f64, paper: &Rect) {
    let place = |n: u32| centre + DVec2::new(cosd(f64::from(n) * PIECE), sind(f64::from(n) * PIECE)) * radius;
    let mut run: Vec<DVec2> = Vec::new();
    for p in (0..=72).map(place) {
        if paper.holds(p) {
            run.push(p);
        } else {
            pen.line("x", &std::mem::take(&mut run));
        }
    }
    pen.line("x", &run);
}

/// Draws an angle from one position of an axis to another one, `turn` counts those before it; the label is put there.
pub(super) fn angle(
    pen: &mut Pen,
    rotary: &Rotary,
    axis: RotaryAxis,
    [from, to]: [f64; 2],
    turn: usize,
    label: &str,
    at: &dyn Fn(DVec3) -> DVec2,
) {
    let Some(centre) = rotary.centre(axis).map(at) else { return };
    let arc: Vec<DVec2> = rotary.arc(axis, from, to).into_iter().map(at).collect();
    let (Some(first), Some(last)) = (arc.first(), arc.last()) else { return };
    // Between the axis and the sphere with its stem.
    let far = first.distance(centre);
    let spheres = rotary.spheres(axis);
    let (stem, size) = spheres
        .first()
        .map_or((0.0, 0.0), |(p, foot, r)| (at(*p).distance(at(*foot)), at(*p + DVec3::ONE * *r).x - at(*p).x));
    let radius = (far - stem.max(size) - 12.0 - 19.0 * turn as f64).max(16.0);
    let onto = |p: DVec2| centre + (p - centre).normalize_or_zero() * radius;
    for end in [first, last] {
        pen.line("x", &[centre, *end]);
    }
    let points: Vec<DVec2> = arc.iter().map(|p| onto(*p)).collect();
    pen.line("e", &points);
    if let [.., before, end] = points.as_slice() {
        // The arrowhead leans against the arc.
        let lean = (*end - *before).normalize_or_zero() - (*end - centre).normalize_or_zero() * (ARROW / radius / 2.0);
        pen.arrow("ea", *end, lean);
    }
    let middle = points.get(points.len() / 2).copied().unwrap_or(centre);
    let out = (middle - centre).normalize_or_zero();
    let near = |share: f64| points.get((points.len() as f64 * share) as usize).copied().unwrap_or(middle);
    // Beside an arc that is too short for it.
    let (long, wide) = (points.windows(2).map(|pair| pair[0].distance(pair[1])).sum::<f64>(), width(label));
    let beside = [(last, 1.0), (first, -1.0)].map(|(end, sign)| {
        let end = onto(*end);
        let way = (onto(*last) - onto(*first)).normalize_or_zero() * sign;
        end + way * (wide / 2.0 * way.x.abs() + 14.0)
    });
    let along = [0.5, 0.35, 0.65, 0.2, 0.8].into_iter().map(near);
    let across = [middle + out * 14.0, middle - out * 14.0, middle + out * 24.0];
    let places: Vec<DVec2> = if long < wide + 16.0 {
        beside.into_iter().chain(across).chain(along).collect()
    } else {
        along.chain(across).collect()
    };
    let place = pen.place(label, &places);
    pen.text("l", label, place);
}
