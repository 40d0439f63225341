//! Dimensions on the sheet: lines with arrowheads in lanes around the drawing, and those inside it.
//!
//! Invariant: what is drawn was measured; a label names a parameter and gives no number.
use std::fmt::Write as _;

use glam::{DVec2, DVec3};

use super::frame::{Frame, direction};
use super::lanes::{Bar, Lane};
use super::measure::{Measured, Spot};
use super::pen::{ARROW, Pen, escaped, short, width};
use super::subject::{Subject, Words, flat};
use super::{axonometric, rotary, setter};
use crate::base::expr::{cosd, sind};
use crate::spec::{DimensionKind, FigureView};

/// Draws all dimensions, those in lanes first.
pub(super) fn all(pen: &mut Pen, subject: &Subject<'_>, words: &Words, frame: &Frame) {
    for inside in [false, true] {
        let mut turn = 0;
        for (n, measured) in subject.measured.iter().enumerate() {
            if direction(measured, subject.view).is_none() != inside {
                continue;
            }
            let label = words.labels.get(n).map_or("", String::as_str);
            let tag = open(pen, measured, words.links.get(n).and_then(Option::as_deref));
            let work = Work { pen, subject, frame, label };
            match (measured.kind, frame.placed.get(n).copied().flatten()) {
                (_, Some((bar, lane))) => work.in_lane(measured, bar, lane),
                (DimensionKind::Angle, None) => work.angle(measured, turn),
                (DimensionKind::Turn, None) => work.turn(measured, turn),
                (_, None) => work.inside(measured),
            }
            turn += usize::from(matches!(measured.kind, DimensionKind::Angle | DimensionKind::Turn));
            let _ = writeln!(pen.body, "</{tag}>");
        }
    }
}

/// The class that a dimension and the row of its parameter share.
pub(super) fn class(of: &str) -> String {
    format!("d-{}", of.replace(['.', ' '], "-"))
}

fn open(pen: &mut Pen, measured: &Measured, link: Option<&str>) -> &'static str {
    let class = class(&measured.of);
    match link {
        Some(link) => {
            let _ = writeln!(pen.body, "<a class=\"d {class}\" href=\"#{}\">", escaped(link));
            "a"
        }
        None => {
            let _ = writeln!(pen.body, "<g class=\"d {class}\">");
            "g"
        }
    }
}

/// From the middle of a label to its edge in a direction.
fn reach(label: &str, way: DVec2) -> f64 {
    let half = Pen::size(label) / 2.0;
    half.x * way.x.abs() + half.y * way.y.abs()
}

struct Work<'w> {
    pen: &'w mut Pen,
    subject: &'w Subject<'w>,
    frame: &'w Frame,
    label: &'w str,
}

/// How many pixels a line goes on beyond the dimension line.
const BEYOND: f64 = 3.0;

impl Work<'_> {
    fn at(&self, p: DVec3) -> DVec2 {
        self.frame.camera.place(flat(p, self.subject.view))
    }

    /// A dimension line beside the drawing.
    fn in_lane(self, measured: &Measured, bar: Bar, lane: Lane) {
        // 0: the bar lies, 1: it is upright.
        let axis = direction(measured, self.subject.view).unwrap_or(1);
        let across = 1 - axis;
        let inner = self.frame.inner;
        let pitch = self.frame.pitch[across];
        let away = (lane.index as f64 + 0.5) * pitch;
        let line = if lane.side == 0 { inner.min[across] - away } else { inner.max[across] + away };
        let outward = if lane.side == 0 { -1.0 } else { 1.0 };
        let put = |along: f64, over: f64| if axis == 0 { DVec2::new(along, over) } else { DVec2::new(over, along) };
        for spot in [measured.from, measured.to] {
            let place = self.place_along(spot, axis);
            let start = self.anchor(spot, axis, lane.side) + 2.0 * outward;
            if (line - start) * outward > 0.0 {
                self.pen.line("e", &[put(place, start), put(place, line + BEYOND * outward)]);
            }
            if self.is_half(measured) && spot == measured.from {
                continue;
            }
            if measured.from_datum && spot == measured.from {
                self.pen.datum(put(place, line + (BEYOND + 4.0) * outward), 4.0);
            }
        }
        let [low, high] = bar.ends;
        let (first, last) = (put(low, line), put(high, line));
        let way = last - first;
        if self.is_half(measured) {
            // The other half is below the rotary axis.
            let (edge, axis) = if self.place_along(measured.to, axis) == low { (first, last) } else { (last, first) };
            let way = (edge - axis).normalize_or_zero();
            self.pen.line("e", &[edge, axis - way * 6.0]);
            self.pen.arrow("ea", edge, way);
        } else if bar.fits() {
            self.pen.line("e", &[first, last]);
            self.pen.arrow("ea", first, -way);
            self.pen.arrow("ea", last, way);
        } else {
            let tail = put(1.0, 0.0) * (ARROW + 4.0) - put(0.0, 0.0);
            self.pen.line("e", &[first - tail, last + tail]);
            self.pen.arrow("ea", first, tail);
            self.pen.arrow("ea", last, -tail);
        }
        let middle = put(bar.middle(), line);
        self.pen.text("l", self.label, middle);
    }

    /// Whether only one end of it is in the drawing.
    fn is_half(&self, measured: &Measured) -> bool {
        measured.from_datum && self.subject.view == FigureView::Turned && measured.is_half()
    }

    fn place_along(&self, spot: Spot, axis: usize) -> f64 {
        let world = match spot {
            Spot::Coordinate(c) => DVec2::splat(c),
            Spot::Point(p) => flat(p, self.subject.view),
        };
        self.frame.camera.place(world)[axis]
    }

    /// Where the line from a place to its dimension line begins, across the bar.
    fn anchor(&self, spot: Spot, axis: usize, side: usize) -> f64 {
        let across = 1 - axis;
        let inner = self.frame.inner;
        if let Spot::Point(point) = spot {
            return self.at(point)[across];
        }
        let Spot::Coordinate(coordinate) = spot else { return inner.min[across] };
        let camera = &self.frame.camera;
        let material = [self.frame.material.min, self.frame.material.max].map(|p| camera.place(p)[across]);
        let edge = if side == 0 { material[0].min(material[1]) } else { material[0].max(material[1]) };
        if let (FigureView::Rotary, 1, Some(round)) = (self.subject.view, axis, &self.subject.shot.round) {
            // At the round part, or at the tool above it.
            let half = (round.radius * round.radius - coordinate * coordinate).max(0.0).sqrt();
            let tool = self.subject.shot.tool.map_or(0.0, |(tool, _)| tool.radius);
            let out = half.max(tool);
            return camera.place(DVec2::new(if side == 0 { -out } else { out }, 0.0)).x;
        }
        if matches!(self.subject.view, FigureView::Plan | FigureView::Turned | FigureView::Rotary)
            || axis == 0
            || (coordinate - self.frame.top).abs() < 1e-6
        {
            return edge;
        }
        // At the wall of what is cut at that height, or at the tool.
        let hollow = self.frame.surface.iter().filter(|p| p.y <= coordinate + 1e-6).map(|p| camera.place(*p)[across]);
        let wall = if side == 0 { hollow.reduce(f64::min) } else { hollow.reduce(f64::max) };
        let tool = setter::pose(self.subject.shot).map(|(tool, tip)| {
            let radius = tool.radius * camera.scale;
            self.at(tip)[across] + if side == 0 { -radius } else { radius }
        });
        match (wall, tool) {
            (Some(wall), _) if coordinate < self.frame.top => wall,
            (_, Some(tool)) => tool,
            (_, None) => edge,
        }
    }

    /// A diameter, a radius, or the distance of two points, where they are.
    fn inside(self, measured: &Measured) {
        let (Spot::Point(a), Spot::Point(b)) = (measured.from, measured.to) else { return };
        let (a, b) = (self.at(a), self.at(b));
        let way = b - a;
        self.pen.line("e", &[a, b]);
        self.pen.arrow("ea", b, way);
        if measured.kind != DimensionKind::Radius {
            self.pen.arrow("ea", a, -way);
        }
        let side = way.normalize_or_zero().perp();
        let mut places: Vec<DVec2> = Vec::new();
        // Beside a line that is too short for it, so far that it does not cover it.
        let near = reach(self.label, side) + 4.0;
        let beside = [near, -near, near + 8.0, -near - 8.0, 0.0];
        let on = [0.0, 12.0, -12.0, 20.0, -20.0];
        for off in if way.length() < width(self.label) + 16.0 { beside } else { on } {
            places.extend([0.5, 0.62, 0.38, 0.72, 0.28, 0.82].map(|share| a + way * share + side * off));
        }
        let out = way.normalize_or_zero();
        places.extend([14.0, 22.0, 32.0].map(|more| b + out * more));
        let place = self.pen.place(self.label, &places);
        self.pen.text("l", self.label, place);
    }

    /// A turn of the rotary axis along which the view is seen.
    fn turn(self, measured: &Measured, turn: usize) {
        let (Spot::Coordinate(from), Spot::Coordinate(to)) = (measured.from, measured.to) else { return };
        let (camera, view) = (self.frame.camera, self.subject.view);
        if let Some(about) = measured.along.filter(|_| view == FigureView::ThreeD) {
            let at = |p: DVec3| camera.place(flat(p, view));
            return axonometric::angle(self.pen, self.subject.shot, about, [from, to], self.label, &at);
        }
        if let Some((known, axis)) = self.subject.shot.rotary.as_ref().zip(rotary::axis(view)) {
            let at = |p: DVec3| camera.place(flat(p, view));
            rotary::angle(self.pen, known, axis, [from, to], turn, self.label, &at);
        }
    }

    /// An angle: its two directions and an arc that points its way.
    fn angle(self, measured: &Measured, turn: usize) {
        let (Spot::Coordinate(from), Spot::Coordinate(to)) = (measured.from, measured.to) else { return };
        let centre = self.at(measured.centre);
        let radius = if self.subject.width < 300.0 { 24.0 } else { 46.0 } + 16.0 * turn as f64;
        let ray = |angle: f64, length: f64| centre + DVec2::new(cosd(angle), -sind(angle)) * length;
        for angle in [from, to] {
            self.pen.line("x", &[centre, ray(angle, radius + 10.0)]);
        }
        let (begin, end) = (ray(from, radius), ray(to, radius));
        let large = u8::from((to - from).abs() > 180.0);
        let sweep = u8::from(to < from);
        let r = short(radius);
        let [x, y] = [begin.x, begin.y].map(short);
        let [ex, ey] = [end.x, end.y].map(short);
        self.pen.path("e", &format!("M{x} {y}A{r} {r} 0 {large} {sweep} {ex} {ey}"));
        let turning: f64 = if to < from { -90.0 } else { 90.0 };
        // The arrowhead leans against the arc.
        let lean = (ARROW / radius / 2.0).to_degrees() * turning.signum();
        self.pen.arrow("ea", end, ray(to + turning - lean, 1.0) - centre);
        let middle = (from + to) / 2.0;
        let mut places = Vec::new();
        // So far out that it does not cover the arc.
        let out = reach(self.label, ray(middle, 1.0) - centre) + 6.0;
        for more in [out, out + 10.0, 12.0, -18.0, out + 22.0, 0.0] {
            places.extend([middle, middle + 12.0, middle - 12.0].map(|angle| ray(angle, radius + more)));
        }
        let place = self.pen.place(self.label, &places);
        self.pen.text("l", self.label, place);
    }
}
