//! The drawing of a whole program: what is left of the workpiece, the ways of the tool, axes, scale and legend.
//!
//! Coordinates are those of the blank: main axis, secondary axis, tool axis. Invariant: the same run gives the same bytes.
use std::fmt::Write as _;

use glam::{DVec2, DVec3};

use super::pen::{Pen, Rect, escaped, short};
use super::shot::Film;
use super::stroke::{Stroke, Way};
use super::window::Window;
use super::{STYLE, axonometric, relief, way};
use crate::engine::geometry::{Axis, WorkingPlane};
use crate::engine::run::Event;
use crate::engine::scene::Scene;
use crate::engine::stock::{Blank, Stock};
use crate::program::syntax::Program;

/// The size of the sheet without the legend, in pixels: at most so wide, and so high.
const SHEET: [f64; 2] = [720.0, 560.0];
const EDGE: f64 = 10.0;
/// The room for axes, scale and legend.
const FOOT: f64 = 64.0;
/// How far around the part rapid traverse is shown, as a part of its longest edge.
const AROUND: f64 = 0.35;
/// Ways are looked at in so many pieces at most, to see what of them is hidden.
const PIECES: f64 = 60_000.0;
/// What surfaces of the part look like: each has its colour, some a dark edge.
const SURFACES: &str = "<style>.ciklo-figure .w path{fill:currentColor;fill-rule:evenodd;stroke:currentColor;\
                        stroke-width:.6}.ciklo-figure .w .we{stroke:#555}</style>\n<g class=\"w\">\n";

/// Arrowheads are so far from each other, in pixels, on pieces that are as long as the second number.
const APART: f64 = 40.0;
const LONG: f64 = 22.0;
/// The isometric view: how far the reader stands aside, and how high above the plane, degrees.
const ASIDE: f64 = 45.0;
const ABOVE: f64 = 35.264_389_682_754_654;

/// From where the drawing looks.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum View {
    /// Against the tool axis.
    Top,
    /// Along the secondary axis.
    Side,
    /// From the front, right and above.
    Isometric,
}

impl View {
    /// The view of a word.
    pub fn by_word(word: &str) -> Option<Self> {
        Some(match word {
            "top" => Self::Top,
            "side" => Self::Side,
            "isometric" => Self::Isometric,
            _ => return None,
        })
    }

    /// To the right, upwards and towards the reader.
    fn directions(self) -> [DVec3; 3] {
        match self {
            Self::Top => [DVec3::X, DVec3::Y, DVec3::Z],
            Self::Side => [DVec3::X, DVec3::Z, DVec3::NEG_Y],
            Self::Isometric => axonometric::seen_from(ASIDE, ABOVE),
        }
    }
}

/// The words on a drawing.
#[derive(Clone, Debug)]
pub struct Legend {
    /// Its title.
    pub title: String,
    /// Rapid traverse, feed, probing.
    pub ways: [String; 3],
}

/// The drawing of a program that is being run.
pub struct Plot<'s> {
    film: Film<'s>,
    scene: &'s Scene,
    axis: Axis,
}

impl<'s> Plot<'s> {
    /// Nothing yet, where the blank lies or, if there is none, in the preset that is active at the start.
    pub fn new(program: &Program, scene: &'s Scene) -> Self {
        let blank = Blank::find(program, scene).ok();
        let (frame, axis) = blank.map_or((scene.frame, scene.machine.spindle), |blank| (blank.frame, blank.axis));
        Self { film: Film::of_program(scene, &frame, axis), scene, axis }
    }

    /// Takes an event of the run.
    pub fn see(&mut self, event: &Event) {
        self.film.see(event);
    }

    /// The drawing as SVG, with what is left of the blank; without one, with the parts of the scene.
    pub fn draw(self, stock: Option<&Stock>, view: View, words: &Legend) -> String {
        let (strokes, contacts) = self.film.developed(self.scene, self.axis);
        let parts =
            if stock.is_none() { Blank::of_parts(self.scene).and_then(|parts| parts.uncut().ok()) } else { None };
        let plane = WorkingPlane::of_tool_axis(self.axis);
        let letters = [plane.main, plane.secondary, plane.tool].map(|axis| axis.letter());
        let sheet = Sheet::new(view, &strokes, &contacts, stock.or(parts.as_ref()), letters);
        sheet.draw(&strokes, &contacts, words)
    }
}

struct Sheet<'s> {
    view: View,
    directions: [DVec3; 3],
    stock: Option<&'s Stock>,
    letters: [char; 3],
    window: Window,
    scale: f64,
    /// Where the drawing is on the sheet.
    paper: Rect,
    pen: Pen,
}

/// The least and greatest coordinates of places.
fn bounds(places: impl Iterator<Item = DVec3>) -> Option<[DVec3; 2]> {
    places.map(|p| [p, p]).reduce(|a, b| [a[0].min(b[0]), a[1].max(b[1])])
}

/// Whether a place is within a box.
fn within(p: DVec3, [low, high]: [DVec3; 2]) -> bool {
    p.cmpge(low).all() && p.cmple(high).all()
}

impl<'s> Sheet<'s> {
    fn new(view: View, strokes: &[Stroke], contacts: &[DVec3], stock: Option<&'s Stock>, letters: [char; 3]) -> Self {
        let directions = view.directions();
        let flat = |p: DVec3| DVec2::new(p.dot(directions[0]), p.dot(directions[1]));
        let mut window = Window::EMPTY;
        let work = strokes.iter().filter(|stroke| stroke.way != Way::Rapid).flat_map(|stroke| &stroke.points);
        let near = stock.iter().flat_map(|stock| stock.bounds()).chain(contacts.iter().copied()).chain(work.copied());
        let near = bounds(near).or_else(|| {
            // Nothing but rapid traverse.
            bounds(strokes.iter().flat_map(|stroke| &stroke.points).copied())
        });
        if let Some(near) = near {
            let [low, high] = near;
            let corner = |n: usize| DVec3::new(near[n & 1].x, near[n >> 1 & 1].y, near[n >> 2 & 1].z);
            (0..8).for_each(|n| window.take(flat(corner(n))));
            // The way there is shown where it is not far; the rest is cut off.
            let around = DVec3::splat(AROUND * (high - low).max_element());
            let shown = [low - around, high + around];
            let rapid = strokes.iter().flat_map(|stroke| &stroke.points);
            rapid.filter(|p| within(**p, shown)).for_each(|p| window.take(flat(*p)));
        } else {
            window = Window { min: DVec2::ZERO, max: DVec2::ONE };
        }
        let margin = DVec2::splat(0.03 * window.size().max_element().max(1e-3));
        window = Window { min: window.min - margin, max: window.max + margin };
        let size = window.size();
        let room = DVec2::from(SHEET) - DVec2::splat(2.0 * EDGE);
        let scale = (room.x / size.x).min(room.y / size.y);
        let min = DVec2::new((SHEET[0] - size.x * scale) / 2.0, EDGE);
        let paper = Rect { min, max: min + size * scale };
        let pen = Pen::new(DVec2::new(SHEET[0], paper.max.y + FOOT));
        Self { view, directions, stock, letters, window, scale, paper, pen }
    }

    fn at(&self, p: DVec3) -> DVec2 {
        let [right, up, _] = self.directions;
        self.paper.min + DVec2::new(p.dot(right) - self.window.min.x, self.window.max.y - p.dot(up)) * self.scale
    }

    fn draw(mut self, strokes: &[Stroke], contacts: &[DVec3], words: &Legend) -> String {
        self.part();
        self.ways(strokes);
        for contact in contacts {
            let hidden = self.stock.is_some_and(|stock| relief::hides(stock, *contact, self.directions[2]));
            let place = self.at(*contact);
            self.pen.circle(if hidden { "n y" } else { "n" }, place, 3.0);
        }
        let datum = self.at(DVec3::ZERO);
        if self.paper.holds(datum) {
            self.pen.datum(datum, 5.0);
        }
        self.foot(strokes, words);
        let [w, h] = [self.pen.sheet.max.x, self.pen.sheet.max.y].map(short);
        let mut svg = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"ciklo-figure\" role=\"img\" viewBox=\"0 0 {w} {h}\" \
             width=\"{w}\" height=\"{h}\">\n<title>{}</title>\n<style>{STYLE}</style>\n\
             <rect class=\"b\" width=\"{w}\" height=\"{h}\"/>\n",
            escaped(&words.title)
        );
        svg.push_str(&self.pen.body);
        svg.push_str("</svg>\n");
        svg
    }

    /// What is left of the workpiece.
    fn part(&mut self) {
        let Some(stock) = self.stock else { return };
        if self.view == View::Side {
            return self.silhouette(stock);
        }
        // There are many of them, so what they share is written once.
        self.pen.body.push_str(SURFACES);
        for surface in relief::surfaces(stock, self.directions[2]) {
            let lines = surface.lines.iter();
            let data: String =
                lines.map(|line| Pen::outline(&line.iter().map(|p| self.at(*p)).collect::<Vec<_>>())).collect();
            if !data.is_empty() {
                let class = if surface.edged { " class=\"we\"" } else { "" };
                let _ = writeln!(self.pen.body, "<path{class} color=\"{}\" d=\"{data}\"/>", grey(surface.light));
            }
        }
        self.pen.body.push_str("</g>\n");
    }

    /// The part from the side: the highest and lowest ends over each place of the main axis, the lowest top dashed, and
    /// the blank around it.
    fn silhouette(&mut self, stock: &Stock) {
        let [min, max] = stock.bounds();
        let (columns, rows) = stock.size();
        let (mut upper, mut lower, mut floor) = (Vec::new(), Vec::new(), Vec::new());
        let half = 0.5 * stock.cell().x;
        for column in 0..columns {
            let at = stock.place(column, 0).x;
            let (mut high, mut low, mut least) = (f64::NEG_INFINITY, f64::INFINITY, f64::INFINITY);
            for row in 0..rows {
                let stretches = stock.column(column, row);
                if let (Some([from, _]), Some([_, to])) = (stretches.first(), stretches.last()) {
                    (high, low, least) = (high.max(*to), low.min(*from), least.min(*to));
                } else {
                    least = min.z;
                }
            }
            if high > low {
                for x in [at - half, at + half] {
                    upper.push(self.at(DVec3::new(x, 0.0, high)));
                    lower.push(self.at(DVec3::new(x, 0.0, low)));
                    floor.push(self.at(DVec3::new(x, 0.0, least)));
                }
            }
        }
        lower.reverse();
        self.pen.area("m o", &straightened(&[upper, lower].concat()));
        self.pen.line("v", &straightened(&floor));
        let corners = [min, DVec3::new(max.x, 0.0, min.z), max, DVec3::new(min.x, 0.0, max.z)];
        let corners = corners.map(|p| self.at(p));
        self.pen.area("v", &corners);
    }

    /// The ways of the tool: pale where the part hides them, cut off where they come from far away.
    fn ways(&mut self, strokes: &[Stroke]) {
        let cell = self.stock.map_or(f64::INFINITY, |stock| 1.5 * stock.cell().max_element());
        let all: f64 = strokes.iter().flat_map(|s| s.points.windows(2)).map(|pair| pair[0].distance(pair[1])).sum();
        let step = cell.max(all / PIECES);
        let frame = self.paper.grown(0.5);
        let mut data: [[String; 2]; 3] = Default::default();
        let mut arrows: Vec<(Way, DVec2, DVec2)> = Vec::new();
        let mut breaks: Vec<(Way, DVec2, DVec2)> = Vec::new();
        for stroke in strokes {
            for pair in stroke.points.windows(2) {
                let [a, b] = [self.at(pair[0]), self.at(pair[1])];
                let Some((from, to)) = way::clip_pair(a, b, &frame) else { continue };
                breaks.extend(
                    [(from, a), (to, b)]
                        .iter()
                        .filter(|(cut, end)| cut.distance(*end) > 1.0)
                        .map(|(cut, _)| (stroke.way, *cut, (b - a).normalize_or_zero())),
                );
                let count = if self.stock.is_some() { (pair[0].distance(pair[1]) / step).ceil().max(1.0) } else { 1.0 };
                let mut run: Option<(bool, DVec3)> = None;
                for n in 0..count as usize {
                    let share = |n: f64| pair[0].lerp(pair[1], n / count);
                    let hidden =
                        self.stock.is_some_and(|stock| relief::hides(stock, share(n as f64 + 0.5), self.directions[2]));
                    match run {
                        Some((known, _)) if known == hidden => {}
                        Some((known, begin)) => {
                            self.add(
                                &mut data[stroke.way as usize][usize::from(known)],
                                begin,
                                share(n as f64),
                                &frame,
                            );
                            run = Some((hidden, share(n as f64)));
                        }
                        None => run = Some((hidden, pair[0])),
                    }
                }
                let Some((hidden, begin)) = run else { continue };
                self.add(&mut data[stroke.way as usize][usize::from(hidden)], begin, pair[1], &frame);
                if !hidden
                    && let Some((tip, along)) = way::arrow_place(&[from, to]).filter(|_| from.distance(to) > LONG)
                    && arrows.iter().all(|(_, other, _)| other.distance(tip) > APART)
                {
                    arrows.push((stroke.way, tip, along));
                }
            }
        }
        for hidden in [1, 0] {
            for kind in [Way::Rapid, Way::Feed, Way::Probe] {
                let class = if hidden == 1 { format!("{} y", way::class(kind)) } else { way::class(kind).to_owned() };
                self.pen.path(&class, &data[kind as usize][hidden]);
            }
        }
        arrows.into_iter().for_each(|(kind, tip, along)| way::head(&mut self.pen, kind, tip, along));
        let mut drawn: Vec<DVec2> = Vec::new();
        for (kind, cut, along) in breaks {
            if drawn.iter().any(|other| other.distance(cut) < 8.0) {
                continue;
            }
            drawn.push(cut);
            // Two strokes across the end of what is cut off.
            let (across, inward) = (along.perp() * 6.0 + along * 3.0, toward(cut, self.paper) * 4.0);
            for place in [cut + inward, cut + inward * 2.0] {
                self.pen.line(if kind == Way::Rapid { "ra" } else { "a" }, &[place - across, place + across]);
            }
        }
    }

    /// Adds a piece of a way to a path; it goes on where that ended.
    fn add(&self, data: &mut String, from: DVec3, to: DVec3, frame: &Rect) {
        let Some((from, to)) = way::clip_pair(self.at(from), self.at(to), frame) else { return };
        let [from, to] = [from, to].map(|p| format!("{} {}", short(p.x), short(p.y)));
        if from == to {
            return;
        }
        if !data.ends_with(&format!("L{from}")) {
            let _ = write!(data, "M{from}");
        }
        let _ = write!(data, "L{to}");
    }

    /// Axes, scale and what the lines mean.
    fn foot(&mut self, strokes: &[Stroke], words: &Legend) {
        let [right, up, _] = self.directions;
        let bottom = self.pen.sheet.max.y;
        let corner = DVec2::new(if self.view == View::Isometric { 40.0 } else { 16.0 }, bottom - 22.0);
        let arms = [DVec3::X, DVec3::Y, DVec3::Z].into_iter().zip(self.letters);
        let arms: Vec<(DVec2, char)> = arms
            .map(|(axis, letter)| (DVec2::new(axis.dot(right), -axis.dot(up)) * 26.0, letter))
            .filter(|(arm, _)| arm.length() > 1.0)
            .collect();
        way::axes(&mut self.pen, corner, &arms);
        let left = corner.x + 60.0;
        let (length, text) = nice(90.0 / self.scale);
        let (a, b) = (DVec2::new(left, bottom - 14.0), DVec2::new(left + length * self.scale, bottom - 14.0));
        self.pen.line("a", &[a, b]);
        for end in [a, b] {
            self.pen.line("a", &[end - DVec2::Y * 4.0, end + DVec2::Y * 4.0]);
        }
        self.pen.text("l", &text, DVec2::new(b.x + 8.0 + Pen::size(&text).x / 2.0, bottom - 14.0));
        let used = |kind: Way| strokes.iter().any(|stroke| stroke.way == kind);
        let ways = [Way::Rapid, Way::Feed, Way::Probe].into_iter().zip(&words.ways).filter(|(kind, _)| used(*kind));
        way::legend(&mut self.pen, DVec2::new(left, bottom - 36.0), SHEET[0], ways);
    }
}

/// From a place on the edge of a rectangle towards its inside.
fn toward(place: DVec2, paper: Rect) -> DVec2 {
    let inside = (paper.min + paper.max) / 2.0 - place;
    let edge = (paper.max - paper.min) / 2.0 - inside.abs();
    if edge.x < edge.y { DVec2::new(inside.x.signum(), 0.0) } else { DVec2::new(0.0, inside.y.signum()) }
}

/// The greatest length of 1, 2 or 5 with noughts that is not more, mm, and how it is written.
fn nice(most: f64) -> (f64, String) {
    let mut power = 1e-6;
    while power * 10.0 <= most && power < 1e9 {
        power *= 10.0;
    }
    // Written with as few places as it has.
    let power = if power < 1.0 { 1.0 / (1.0 / power).round() } else { power.round() };
    let length = [5.0, 2.0, 1.0].into_iter().map(|n| n * power).find(|length| *length <= most).unwrap_or(power);
    (length, format!("{} mm", length))
}

fn grey(light: f64) -> String {
    let light = light.clamp(0.0, 255.0) as u8;
    format!("#{light:02x}{light:02x}{light:02x}")
}

/// The points without those between two others on a line.
fn straightened(points: &[DVec2]) -> Vec<DVec2> {
    let mut kept: Vec<DVec2> = Vec::new();
    for p in points {
        if let [.., a, b] = kept.as_slice()
            && (*b - *a).perp_dot(*p - *b).abs() < 1e-6
            && (*b - *a).dot(*p - *b) >= 0.0
        {
            kept.pop();
        }
        kept.push(*p);
    }
    kept
}
