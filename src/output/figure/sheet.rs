//! A figure on its sheet: the workpiece, the tool, the way, and the dimensions around them.
//!
//! Invariant: knows places and words, no cycle; no text overlaps another one.
use std::collections::BTreeSet;
use std::fmt::Write as _;

use glam::{DVec2, DVec3};

use super::frame::{Camera, Frame};
use super::measure::axes;
use super::pen::{Pen, Rect, short};
use super::shot::{CUT, MARKS, number, point};
use super::slice::{self, Face, Outline};
use super::stroke::{Stroke, Way};
use super::subject::{Subject, Words, depth, flat};
use super::window::Window;
use super::{axonometric, bar, cutter, cylinder, rotary, scan, setter, setter_other_mounting, turned, way};
use crate::spec::{Along, FigureView};

/// The figure on paper.
pub(super) struct Drawn {
    pub(super) body: String,
    pub(super) size: DVec2,
    /// Where texts are.
    pub(super) texts: Vec<Rect>,
}

/// A figure without its legend, which is all that differs between languages where dimensions are called the same.
#[derive(Debug)]
pub(super) struct Plate {
    /// The labels and links of its dimensions.
    labels: Vec<String>,
    links: Vec<Option<String>>,
    frame: Frame,
    pen: Pen,
}

impl Plate {
    /// Whether its dimensions have these labels and links.
    pub(super) fn has(&self, words: &Words) -> bool {
        self.labels == words.labels && self.links == words.links
    }

    /// The figure with its legend.
    pub(super) fn finished(&self, subject: &Subject<'_>, words: &Words) -> Drawn {
        let mut sheet = Sheet { subject, frame: &self.frame, pen: self.pen.clone(), view: subject.view };
        sheet.legend(words);
        Drawn { body: sheet.pen.body, size: self.frame.size, texts: sheet.pen.texts }
    }
}

/// Draws a figure.
pub(super) fn draw(subject: &Subject<'_>, words: &Words) -> Plate {
    let faces = match (subject.view, rotary::axis(subject.view)) {
        (FigureView::ThreeD, _) | (_, Some(_)) => Vec::new(),
        _ => slice::faces(subject.shot, subject.view, depth(subject)),
    };
    let frame = Frame::new(subject, words, &faces);
    let mut sheet = Sheet { subject, frame: &frame, pen: Pen::new(frame.size), view: subject.view };
    sheet.workpiece(&faces);
    sheet.scan();
    sheet.tool();
    sheet.poses();
    sheet.ways();
    sheet.datum();
    super::dimension::all(&mut sheet.pen, subject, words, &frame);
    sheet.axes();
    sheet.marks();
    let pen = sheet.pen;
    Plate { labels: words.labels.clone(), links: words.links.clone(), frame, pen }
}

struct Sheet<'s> {
    subject: &'s Subject<'s>,
    frame: &'s Frame,
    pen: Pen,
    view: FigureView,
}

impl Sheet<'_> {
    const fn camera(&self) -> &Camera {
        &self.frame.camera
    }

    fn at(&self, p: DVec3) -> DVec2 {
        self.camera().place(flat(p, self.view))
    }

    const fn is_from_above(&self) -> bool {
        matches!(self.view, FigureView::Plan | FigureView::RotaryC)
    }

    fn workpiece(&mut self, faces: &[Face]) {
        if let Some(setter) = &self.subject.shot.setter {
            let camera = self.frame.camera;
            let at = |p: DVec3| camera.place(flat(p, self.view));
            return match setter.is_upright() {
                true => setter::draw(&mut self.pen, setter, self.view, &at),
                false => setter_other_mounting::draw(&mut self.pen, setter, self.view, &at),
            };
        }
        if !faces.is_empty() {
            return self.parts(faces);
        }
        if let Some(bar) = bar::of(self.subject.shot) {
            return match self.is_from_above() {
                true => bar::from_above(&mut self.pen, &bar, self.frame),
                false => bar::cut_open(&mut self.pen, &bar, self.subject, self.frame),
            };
        }
        match self.view {
            FigureView::ThreeD => {
                let camera = self.frame.camera;
                axonometric::part(&mut self.pen, self.subject.shot, &|p| camera.place(axonometric::project(p)));
            }
            FigureView::Plan => self.from_above(),
            FigureView::Section | FigureView::Side => self.cut_open(),
            FigureView::Turned => turned::part(&mut self.pen, self.subject, self.frame),
            FigureView::Rotary => turned::across(&mut self.pen, self.subject, self.frame),
            FigureView::RotaryA | FigureView::RotaryB | FigureView::RotaryC => self.rotary(),
        }
    }

    /// The rotary axis with the sphere that goes around it.
    fn rotary(&mut self) {
        let (camera, view) = (self.frame.camera, self.view);
        if let Some((rotary, axis)) = self.subject.shot.rotary.as_ref().zip(rotary::axis(view)) {
            let paper = self.frame.paper().grown(4.0);
            rotary::draw(&mut self.pen, rotary, axis, &paper, &|p| camera.place(flat(p, view)));
        }
    }

    /// The parts of a scene, hatched where the view cuts them.
    fn parts(&mut self, faces: &[Face]) {
        let mut window = self.frame.window;
        for face in faces {
            if let (false, Some(bounds)) = (face.material, slice::bounds(faces)) {
                // A hole may go on beyond the part.
                (window.min, window.max) = (window.min.max(bounds[0]), window.max.min(bounds[1]));
            }
            let class = if face.material { "m" } else { "b" };
            match &face.outline {
                Outline::Circle(centre, radius) => {
                    let class = if face.material { "m o" } else { "b o" };
                    self.pen.circle(class, self.camera().place(*centre), radius * self.camera().scale);
                }
                Outline::Polygon(points) => {
                    let points: Vec<DVec2> = window.clip(points).iter().map(|p| self.camera().place(*p)).collect();
                    self.pen.area(class, &points);
                    if face.material && self.view != FigureView::Plan {
                        self.pen.hatch(&[points]);
                    }
                }
            }
        }
        let edges = slice::edges(faces, &window);
        let edges = edges.iter().map(|edge| Pen::data(&edge.map(|p| self.camera().place(p)), false));
        let edges: String = edges.collect();
        self.pen.path("o", &edges);
    }

    /// The blank from above with what was milled off it.
    fn from_above(&mut self) {
        let Window { min, max } = self.frame.material;
        let corners = [min, DVec2::new(max.x, min.y), max, DVec2::new(min.x, max.y)];
        let corners = corners.map(|p| self.camera().place(p));
        if self.subject.round {
            let middle = (corners[0] + corners[2]) / 2.0;
            self.pen.circle("m o", middle, (max.x - min.x) / 2.0 * self.camera().scale);
        } else {
            self.pen.area(if self.frame.known_edges { "m o" } else { "m" }, &corners);
        }
        let top = self.frame.top;
        let shot = self.subject.shot;
        self.tracks(&shot.later, top, &[("u", 0.0)]);
        self.tracks(&shot.strokes, top, &[("k", 1.6), ("c", 0.0)]);
        if self.subject.round {
            self.pen.circle("v", (corners[0] + corners[2]) / 2.0, (max.x - min.x) / 2.0 * self.camera().scale);
        } else if self.frame.known_edges {
            self.pen.area("v", &corners);
        }
    }

    /// What the tool covers where it cuts, in lines as wide as it is, each class by so many pixels wider.
    fn tracks(&mut self, strokes: &[Stroke], top: f64, classes: &[(&str, f64)]) {
        let cuts = |stroke: &&Stroke| stroke.way == Way::Feed && stroke.points.iter().any(|p| p.z < top - 1e-6);
        let mut tracks: Vec<(f64, BTreeSet<String>)> = Vec::new();
        for stroke in strokes.iter().filter(cuts) {
            let points: Vec<DVec2> = stroke.points.iter().map(|p| self.at(*p)).collect();
            let mut data = Pen::data(&points, false);
            if !data.contains('L') {
                // A plunge: a line of no length has round ends.
                data.push_str("h0");
            }
            let radius = stroke.tool.radius;
            match tracks.iter_mut().find(|(known, _)| *known == radius) {
                Some((_, list)) => _ = list.insert(data),
                None => tracks.push((radius, BTreeSet::from([data]))),
            }
        }
        for (class, more) in classes {
            for (radius, list) in &tracks {
                let width = short(2.0 * radius * self.camera().scale + *more);
                let data: String = list.iter().map(String::as_str).collect();
                let _ = writeln!(self.pen.body, "<path class=\"{class}\" stroke-width=\"{width}\" d=\"{data}\"/>");
            }
        }
    }

    /// The blank cut open along the main axis.
    fn cut_open(&mut self) {
        let Window { min, max } = self.frame.material;
        let surface = &self.frame.surface;
        let line: Vec<DVec2> = surface.iter().map(|p| self.camera().place(DVec2::new(p.x, p.y.max(min.y)))).collect();
        let mut area = line.clone();
        area.extend([DVec2::new(max.x, min.y), min].map(|p| self.camera().place(p)));
        self.pen.area("m", &area);
        self.pen.hatch(&[area]);
        self.pen.line("o", &line);
    }

    /// The tool where it is at the moment, to scale; from the side it is cut off at the edge of the drawing.
    fn tool(&mut self) {
        if self.view == FigureView::Turned {
            return turned::insert(&mut self.pen, self.subject, self.frame);
        }
        if self.view == FigureView::ThreeD {
            return;
        }
        if let Some(bar) = bar::of(self.subject.shot) {
            let above = self.is_from_above();
            return bar::tool(&mut self.pen, &bar, self.subject, self.frame, above);
        }
        let Some((tool, tip)) = setter::pose(self.subject.shot) else { return };
        let (scale, place) = (self.camera().scale, self.at(tip));
        let radius = self.subject.shot.ball.unwrap_or(tool.radius) * scale;
        if !self.frame.paper().holds(place) || radius <= 0.0 {
            return;
        }
        if let Some(setter) = self.subject.shot.setter.as_ref().filter(|setter| !setter.is_upright()) {
            let (camera, view) = (self.frame.camera, self.view);
            return setter_other_mounting::tool(&mut self.pen, setter, &tool, tip, &|p| camera.place(flat(p, view)));
        }
        if self.is_from_above() {
            self.pen.circle("t", place, radius);
            if self.subject.shot.setter.is_none() {
                setter::edges(&mut self.pen, &tool, self.subject.shot.turning, place, radius);
            }
            return;
        }
        let top = self.frame.paper().min.y;
        if self.subject.shot.ball.is_some() {
            let stem = (radius * 0.4).max(1.5);
            let (x, end) = (DVec2::new(stem, 0.0), DVec2::new(place.x, top));
            self.pen.area("t", &[place - x, end - x, end + x, place + x]);
            self.pen.circle("t", place, radius);
            return;
        }
        self.pen.path("t", &cutter::outline(cutter::End::of(&tool, scale), place, top));
        self.pen.line("x", &[DVec2::new(place.x, top - 4.0), DVec2::new(place.x, place.y + 6.0)]);
        self.pen
            .blocked
            .push(Rect { min: DVec2::new(place.x - radius, top), max: DVec2::new(place.x + radius, place.y) });
    }

    /// The range of a scan.
    fn scan(&mut self) {
        let (camera, view) = (self.frame.camera, self.view);
        scan::outline(&mut self.pen, self.subject.shot, &|p| camera.place(flat(p, view)));
    }

    /// What else is to be seen of a tool at a tool setter.
    fn poses(&mut self) {
        let (camera, view, top) = (self.frame.camera, self.view, self.frame.paper().min.y);
        let (shot, at) = (self.subject.shot, |p: DVec3| camera.place(flat(p, view)));
        match shot.setter.as_ref().filter(|setter| !setter.is_upright()) {
            Some(setter) => setter_other_mounting::poses(&mut self.pen, shot, setter, &at),
            None => setter::poses(&mut self.pen, shot, view, top, &at),
        }
    }

    /// The ways of the tool. Ways up and down over one another are drawn side by side; those that go on from one another
    /// are one line.
    fn ways(&mut self) {
        let paper = self.frame.paper();
        let mut arrows: Vec<(Way, DVec2, DVec2)> = Vec::new();
        let mut drawn: BTreeSet<(usize, String)> = BTreeSet::new();
        let mut lines: Vec<(Way, String)> = Vec::new();
        for (stroke, offset) in self.subject.shot.strokes.iter().zip(self.offsets()) {
            let points: Vec<DVec2> = stroke.points.iter().map(|p| self.at(*p) + DVec2::new(offset, 0.0)).collect();
            if self.view == FigureView::Rotary && !cylinder::meets(stroke, number(self.subject.shot, CUT)) {
                continue;
            }
            let points = way::clip_line(&points, &paper.grown(0.5));
            let data = Pen::data(&points, false);
            if !data.contains('L') || !drawn.insert((stroke.way as usize, data.clone())) {
                continue;
            }
            let (begin, rest) = data.split_at(data.find('L').unwrap_or_default());
            match lines.last_mut() {
                Some((way, line)) if *way == stroke.way && line.rsplit('L').next() == begin.strip_prefix('M') => {
                    line.push_str(rest);
                }
                _ => lines.push((stroke.way, data)),
            }
            let Some((tip, along)) = way::arrow_place(&points) else { continue };
            if arrows.iter().all(|(_, other, _)| (*other - tip).length() > 16.0) {
                arrows.push((stroke.way, tip, along));
            }
        }
        for (way, line) in lines {
            self.pen.path(way::class(way), &line);
        }
        for (way, tip, along) in arrows {
            way::head(&mut self.pen, way, tip, along);
        }
        let shot = self.subject.shot;
        if shot.rotary.is_some() && rotary::axis(self.view).is_some() {
            return;
        }
        let contacts = if shot.setter.is_some() { setter::touched(shot) } else { shot.contacts.clone() };
        for contact in contacts.into_iter().chain(scan::points(shot)) {
            let place = self.at(contact);
            self.pen.circle("n", place, 3.0);
        }
    }

    /// By how much each stroke is drawn beside its place.
    fn offsets(&self) -> Vec<f64> {
        let strokes = &self.subject.shot.strokes;
        let mut offsets = vec![0.0; strokes.len()];
        if self.is_from_above()
            || matches!(self.view, FigureView::Turned | FigureView::Rotary)
            || self.subject.shot.ball.is_some()
        {
            return offsets;
        }
        let mut columns: Vec<(f64, Vec<(usize, bool)>)> = Vec::new();
        for (n, stroke) in strokes.iter().enumerate() {
            let [a, b] =
                [stroke.points.first(), stroke.points.last()].map(|p| p.map(|p| self.at(*p)).unwrap_or_default());
            if stroke.points.len() != 2 || (a.x - b.x).abs() > 0.5 || (a.y - b.y).abs() < 0.5 {
                continue;
            }
            let entry = (n, b.y < a.y);
            match columns.iter_mut().find(|(x, _)| (*x - a.x).abs() < 0.5) {
                Some((_, list)) => list.push(entry),
                None => columns.push((a.x, vec![entry])),
            }
        }
        for (_, list) in columns {
            let mut lane = 0.0;
            let mut lanes = Vec::new();
            for (at, (_, up)) in list.iter().enumerate() {
                let before = at.checked_sub(1).and_then(|at| list.get(at));
                if before.is_some_and(|(_, other)| other != up) {
                    lane += 1.0;
                }
                lanes.push(lane);
            }
            let room = strokes.first().map_or(0.0, |stroke| 2.0 * stroke.tool.radius * self.camera().scale);
            let step = (room.max(16.0) / (lane + 1.0)).min(7.0);
            for ((n, _), own) in list.iter().zip(lanes) {
                offsets[*n] = (own - lane / 2.0) * step;
            }
        }
        offsets
    }

    /// The datum, where it is in the drawing.
    fn datum(&mut self) {
        let old = (self.view == FigureView::Plan && self.frame.shows_datum).then_some(DVec3::ZERO);
        for datum in old.into_iter().chain(self.subject.shot.datum) {
            let place = self.at(datum);
            if self.frame.paper().grown(1.0).holds(place) {
                self.pen.datum(place, 5.0);
            }
        }
    }

    /// The axes after the cycle has turned them, where the view shows their plane.
    fn axes(&mut self) {
        let (camera, shot) = (self.frame.camera, self.subject.shot);
        if self.view == FigureView::ThreeD {
            return axonometric::letters(&mut self.pen, shot, &|p| camera.place(axonometric::project(p)));
        }
        let [main, minor, _] = shot.axes;
        let place = self.at(shot.datum.unwrap_or_default());
        let turned = [(main, DVec3::X), (minor, DVec3::Y)].iter().any(|(axis, before)| axis.distance(*before) > 1e-6);
        if self.view != FigureView::Plan || !turned || !self.frame.paper().grown(1.0).holds(place) {
            return;
        }
        for (axis, along) in [(main, Along::Main), (minor, Along::Minor)] {
            let way = DVec2::new(axis.x, -axis.y).normalize_or_zero();
            let tip = place + way * 26.0;
            self.pen.line("a", &[place + way * 5.0, tip]);
            self.pen.arrow("aa", tip, way);
            let text = format!("{}\u{2032}", shot.letter(along));
            let near = [tip + way * 9.0, tip + way.perp() * 10.0, tip - way.perp() * 10.0, tip + way * 16.0];
            let centre = self.pen.place(&text, &near);
            self.pen.text("l", &text, centre);
        }
    }

    fn marks(&mut self) {
        for (n, number) in self.subject.marks.iter().enumerate() {
            let Some(point) = point(self.subject.shot, MARKS + n) else { continue };
            let place = self.at(point);
            let text = number.to_string();
            let around =
                [(0.0, -1.0), (1.0, -1.0), (-1.0, -1.0), (1.0, 1.0), (-1.0, 1.0), (0.0, 1.0), (1.0, 0.0), (-1.0, 0.0)];
            let near: Vec<DVec2> =
                [15.0, 22.0, 30.0].iter().flat_map(|r| around.map(|(x, y)| place + DVec2::new(x, y) * *r)).collect();
            let centre = self.pen.place(&text, &near);
            let way = (centre - place).normalize_or_zero();
            self.pen.line("e", &[place, centre - way * 8.0]);
            self.pen.circle("n", place, 1.5);
            self.pen.text("l", &text, centre);
            self.pen.circle("g", centre, 8.5);
        }
    }

    /// Axes, and what the lines mean.
    fn legend(&mut self, words: &Words) {
        if self.view == FigureView::ThreeD {
            return;
        }
        let used = |way: Way| self.subject.shot.strokes.iter().any(|stroke| stroke.way == way);
        let ways = [Way::Rapid, Way::Feed, Way::Probe].into_iter().zip(&words.ways).filter(|(way, _)| used(*way));
        let wide = way::legend_width(ways.clone());
        // Below the drawing or, where that is too narrow for all words, more to the left.
        let left = (self.frame.size.x - 52.0 - wide).min(self.frame.inner.min.x + 10.0).max(16.0);
        let corner = DVec2::new(left, self.frame.size.y - 9.0);
        let letter = |axis: Along| self.subject.shot.letter(axis);
        let [right, up] = axes(self.view);
        let arms = [(DVec2::new(22.0, 0.0), letter(right)), (DVec2::new(0.0, -22.0), letter(up))];
        way::axes(&mut self.pen, corner, &arms);
        if self.subject.width < 300.0 {
            // The figures of a row stand below one that explains the lines.
            return;
        }
        let right = self.frame.size.x;
        way::legend(&mut self.pen, corner + DVec2::new(52.0, -3.0), right, ways);
    }
}
