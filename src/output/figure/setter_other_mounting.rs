//! A tool setter that is mounted in other directions than those of the figure, and the tools at it, which lean as it does.
//!
//! Invariant: it is drawn as an upright one would be, with each place where it is; what is behind is hidden.
use std::f64::consts::{FRAC_PI_2, TAU};

use glam::{DVec2, DVec3};

use super::axonometric::directions;
use super::measure::axes;
use super::pen::Pen;
use super::setter::{DRAWN, PLATE, POST, Setter, touches};
use super::shot::Shot;
use super::stroke::{Stroke, Turning};
use crate::base::expr::{cosd, sind};
use crate::engine::machine::Tool;
use crate::spec::{Along, FigureView};

/// A circle has so many corners.
const CORNERS: usize = 48;
/// A rounded corner of a tool has so many pieces.
const ROUNDING: u32 = 6;
/// So much of a tool is drawn, in parts of its radius.
const LENGTH: f64 = 5.0;
/// The arrow around a tool that turns: its radius in parts of that of the tool, and from where to where it goes, degrees.
const AROUND: f64 = 1.35;
const ARROW: (f64, f64) = (215.0, -35.0);
/// Places on the sheet that are so near to each other are one.
const SAME: f64 = 2.0;

/// Places of the world on the sheet.
type Sheet<'s> = &'s dyn Fn(DVec3) -> DVec2;

impl Setter {
    /// A circle about the tool axis of the setter, so far from a place along that axis.
    fn ring(&self, place: DVec3, along: f64, radius: f64) -> Vec<DVec3> {
        let [main, minor, up] = self.axes;
        let corner = |angle: f64| place + up * along + (main * libm::cos(angle) + minor * libm::sin(angle)) * radius;
        (0..CORNERS).map(|count| corner(count as f64 / CORNERS as f64 * TAU)).collect()
    }

    /// The corners of its plate, so far from its face.
    fn plate(&self, along: f64) -> Vec<DVec3> {
        if self.corners.is_empty() {
            self.ring(self.at, along, self.half)
        } else {
            self.corners.iter().map(|corner| *corner + self.axes[2] * along).collect()
        }
    }

    /// Everything of it that is drawn.
    pub(super) fn corners_turned(&self) -> impl Iterator<Item = DVec3> {
        let foot = self.ring(self.at, -DRAWN * self.half, POST * self.half);
        self.plate(0.0).into_iter().chain(self.plate(-PLATE * self.half)).chain(foot)
    }

    /// What is drawn of a tool with its tip there.
    pub(super) fn tool_turned(&self, tool: &Tool, tip: DVec3) -> Vec<DVec3> {
        let end = self.ring(tip, LENGTH * tool.radius, tool.radius);
        if tool.point > 0.0 && tool.point < 180.0 {
            let shoulder = tool.radius / libm::tan((tool.point / 2.0).to_radians());
            return [vec![tip], self.ring(tip, shoulder, tool.radius), end].concat();
        }
        let corner = tool.corner.clamp(0.0, tool.radius);
        let last = if corner > 0.0 { ROUNDING } else { 0 };
        let rounding = (0..=last).flat_map(|step| {
            let angle = f64::from(step) / f64::from(ROUNDING) * FRAC_PI_2;
            self.ring(tip, corner * (1.0 - libm::cos(angle)), tool.radius - corner * (1.0 - libm::sin(angle)))
        });
        rounding.chain(end).collect()
    }
}

/// The outline of a body whose corners are there.
fn outline(corners: &[DVec3], at: Sheet<'_>) -> Vec<DVec2> {
    let mut points: Vec<DVec2> = corners.iter().map(|corner| at(*corner)).collect();
    points.sort_by(|a, b| a.x.total_cmp(&b.x).then(a.y.total_cmp(&b.y)));
    let half = |points: &mut dyn Iterator<Item = &DVec2>| {
        let mut line: Vec<DVec2> = Vec::new();
        for point in points {
            while let [.., a, b] = line[..]
                && (b - a).perp_dot(*point - b) <= 0.0
            {
                line.pop();
            }
            line.push(*point);
        }
        line.pop();
        line
    };
    [half(&mut points.iter()), half(&mut points.iter().rev())].concat()
}

/// The direction towards the reader of a view.
fn to_reader(view: FigureView) -> DVec3 {
    if view == FigureView::ThreeD {
        return directions()[2];
    }
    let [right, up] = axes(view).map(|axis| match axis {
        Along::Main => DVec3::X,
        Along::Minor => DVec3::Y,
        Along::Tool => DVec3::Z,
    });
    right.cross(up)
}

/// Draws the setter.
pub(super) fn draw(pen: &mut Pen, setter: &Setter, view: FigureView, at: Sheet<'_>) {
    let half = setter.half;
    let post = [-PLATE, -DRAWN].map(|along| setter.ring(setter.at, along * half, POST * half)).concat();
    let plate = [setter.plate(0.0), setter.plate(-PLATE * half)].concat();
    let shows_face = setter.axes[2].dot(to_reader(view)) > 1e-9;
    let bodies = if shows_face { [&post, &plate] } else { [&plate, &post] };
    for body in bodies {
        pen.area("m o", &outline(body, at));
    }
    if shows_face {
        pen.area("m o", &outline(&setter.plate(0.0), at));
        for end in &setter.axes[..2] {
            let cross = *end * half * 0.3;
            pen.line("x", &[at(setter.at - cross), at(setter.at + cross)]);
        }
    }
}

/// Draws a tool with its tip there.
pub(super) fn tool(pen: &mut Pen, setter: &Setter, tool: &Tool, tip: DVec3, at: Sheet<'_>) {
    pen.area("t", &outline(&setter.tool_turned(tool, tip), at));
    let up = setter.axes[2] * tool.radius;
    pen.line("x", &[at(tip + up * (LENGTH + 0.5)), at(tip - up * 0.5)]);
}

/// Draws the outlines of a tool where it touched before, and at rest or turning, where it touched last.
pub(super) fn poses(pen: &mut Pen, shot: &Shot, setter: &Setter, at: Sheet<'_>) {
    let ends: Vec<(&Stroke, DVec3)> =
        touches(shot).filter_map(|stroke| Some((stroke, *stroke.points.last()?))).collect();
    let Some((last, here)) = ends.last() else { return };
    let mut drawn = vec![at(*here)];
    for (stroke, tip) in &ends {
        let place = at(*tip);
        if drawn.iter().all(|other| (*other - place).length() > SAME) {
            drawn.push(place);
            let mut line = outline(&setter.tool_turned(&stroke.tool, *tip), at);
            line.extend(line.first().copied());
            pen.line("v", &line);
        }
    }
    if last.turning.direction == 0 {
        edges(pen, setter, last, *here, at);
    } else {
        turn(pen, setter, last, *here, at);
    }
}

/// A direction at right angles to the tool.
fn across(setter: &Setter, angle: f64) -> DVec3 {
    setter.axes[0] * cosd(angle) + setter.axes[1] * sind(angle)
}

/// The cutting edges of a stationary tool.
fn edges(pen: &mut Pen, setter: &Setter, stroke: &Stroke, tip: DVec3, at: Sheet<'_>) {
    let Turning { angle: Some(angle), first, .. } = stroke.turning else { return };
    let count = stroke.tool.teeth as u32;
    for edge in 0..count {
        let way = across(setter, angle + first + 360.0 / f64::from(count) * f64::from(edge)) * stroke.tool.radius;
        pen.line("o", &[at(tip + way * 0.45), at(tip + way)]);
        pen.circle("q", at(tip + way), 2.2);
    }
}

/// An arrow around a tool that turns.
fn turn(pen: &mut Pen, setter: &Setter, stroke: &Stroke, tip: DVec3, at: Sheet<'_>) {
    let radius = stroke.tool.radius;
    let middle = tip + setter.axes[2] * radius * (LENGTH / 2.0);
    let (from, to) = if stroke.turning.direction > 0 { ARROW } else { (ARROW.1, ARROW.0) };
    let place = |count: usize| {
        let share = count as f64 / CORNERS as f64;
        at(middle + across(setter, from + (to - from) * share) * radius * AROUND)
    };
    let points: Vec<DVec2> = (0..=CORNERS).map(place).collect();
    pen.line("g", &points);
    if let [.., before, end] = points[..] {
        pen.arrow("aa", end, end - before);
    }
}
