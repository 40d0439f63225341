//! How a figure is laid out: what it shows of the world, at which scale, and the lanes of its dimensions.
//!
//! Invariant: found before anything is drawn, from places alone.
use glam::DVec2;

use super::lanes::{Bar, Lane, lanes};
use super::measure::{Measured, Spot, axes};
use super::pen::{Rect, height, width};
use super::setter::{self, Setter};
use super::shot::{BOTTOM, CORNERS, TOP, number, point};
use super::slice::{Face, Outline};
use super::stroke::Way;
use super::subject::{Subject, Words, coordinate, flat, surface};
use super::window::Window;
use super::{axonometric, bar, rotary, scan};
use crate::spec::{Along, DimensionKind, FigureView};

/// From the world to the sheet.
#[derive(Clone, Copy, Debug)]
pub(super) struct Camera {
    /// Pixels a millimetre.
    pub(super) scale: f64,
    /// What of the world is at the origin of the sheet.
    origin: DVec2,
}

impl Camera {
    pub(super) fn place(&self, world: DVec2) -> DVec2 {
        DVec2::new(world.x - self.origin.x, self.origin.y - world.y) * self.scale
    }
}

/// The layout of a figure.
#[derive(Debug)]
pub(super) struct Frame {
    pub(super) size: DVec2,
    pub(super) camera: Camera,
    /// What of the world is shown.
    pub(super) window: Window,
    /// The blank.
    pub(super) material: Window,
    /// Whether the edges of the blank in the plane are known, and it does not go on beyond them.
    pub(super) known_edges: bool,
    /// The coordinate of its surface.
    pub(super) top: f64,
    /// Its surface where the view cuts it.
    pub(super) surface: Vec<DVec2>,
    /// The drawing without the lanes around it.
    pub(super) inner: Rect,
    /// Whether some dimension begins at the datum.
    pub(super) shows_datum: bool,
    /// For each dimension in a lane, its bar and lane.
    pub(super) placed: Vec<Option<(Bar, Lane)>>,
    /// The distance of lanes to the left and right, and above and below.
    pub(super) pitch: DVec2,
}

/// Around the sheet.
const EDGE: f64 = 6.0;
/// The distance of lanes above and below.
const ROW: f64 = 22.0;
/// So many lanes to the left and right leave no room for a drawing.
const MOST_LANES: usize = 8;
/// The room for axes and legend.
const FOOT: f64 = 48.0;

/// The axis of a lane: 0 for bars that lie, 1 for upright ones; none for dimensions inside the drawing.
pub(super) fn direction(measured: &Measured, view: FigureView) -> Option<usize> {
    let axis = measured.along?;
    let in_lane = measured.kind == DimensionKind::Length || (view == FigureView::Turned && measured.is_half());
    in_lane.then(|| usize::from(axes(view)[1] == axis))
}

impl Frame {
    pub(super) fn new(subject: &Subject<'_>, words: &Words, faces: &[Face]) -> Self {
        let mut content = content(subject, faces);
        let shot = subject.shot;
        let top = number(shot, TOP).unwrap_or(0.0);
        let known_edges = CORNERS.iter().all(|place| point(shot, *place).is_some());
        let mut material = content;
        let section = matches!(subject.view, FigureView::Section | FigureView::Side);
        // At a tool setter, and where a sphere is measured, there is no workpiece; in three dimensions it is drawn otherwise.
        let blank = shot.setter.is_none() && rotary::axis(subject.view).is_none() && subject.view != FigureView::ThreeD;
        if section && blank {
            material.max.y = top;
            let below = 0.16 * content.size().y;
            material.min.y = number(shot, BOTTOM).unwrap_or(content.min.y.min(top) - below);
            content.min.y = content.min.y.min(material.min.y);
            let cut = 0.3 * content.size().x.max(0.45 * content.size().y);
            if !known_edges && faces.is_empty() {
                (material.min.x, material.max.x) = (content.min.x - cut, content.max.x + cut);
            }
        } else if subject.view == FigureView::Turned {
            // The rotary axis, and some room for what goes on below it.
            content.take(DVec2::new(content.min.x, -0.02 * content.size().x));
        } else if let Some(round) = &shot.round {
            material = Window { min: DVec2::splat(-round.radius), max: DVec2::splat(round.radius) };
        } else if !known_edges && faces.is_empty() && blank {
            let more = DVec2::splat(0.12 * content.size().max_element());
            material = Window { min: content.min - more, max: content.max + more };
        }
        if known_edges && subject.view != FigureView::ThreeD {
            let [least, greatest] = CORNERS.map(|n| point(shot, n).map(|p| flat(p, subject.view)).unwrap_or_default());
            (material.min.x, material.max.x) = (least.x, greatest.x);
            if !section {
                (material.min.y, material.max.y) = (least.y, greatest.y);
            }
        }
        let shows_datum = subject.whole || subject.measured.iter().any(Measured::begins_at_datum);
        if shows_datum && subject.view == FigureView::Plan {
            // The sign of the datum has room around it.
            content.take(DVec2::ZERO);
            content.take(-0.03 * content.size());
        }
        content.take(material.min);
        content.take(material.max);
        let bars = directions(subject, words);
        let widest = words.labels.iter().zip(&bars).filter(|(_, bar)| **bar == Some(1)).map(|(label, _)| width(label));
        let pitch = DVec2::new(widest.fold(20.0, f64::max) + 10.0, ROW);
        let mut frame = Self {
            size: DVec2::ZERO,
            camera: Camera { scale: 1.0, origin: DVec2::ZERO },
            window: content,
            material,
            known_edges,
            top,
            surface: Vec::new(),
            inner: Rect { min: DVec2::ZERO, max: DVec2::ZERO },
            shows_datum,
            placed: vec![None; bars.len()],
            pitch,
        };
        frame.find_scale(subject, words);
        if section && faces.is_empty() && blank {
            let edges = [frame.material.min.x, frame.material.max.x];
            frame.surface = match bar::of(shot) {
                Some(_) => edges.map(|x| DVec2::new(x, top)).to_vec(),
                None => surface(subject, edges, top),
            };
        }
        frame
    }

    /// The sheet inside its lanes, where ways may be drawn.
    pub(super) const fn paper(&self) -> Rect {
        self.inner
    }

    /// The greatest scale at which the lanes beside the drawing are enough: the fewer there are, the larger it is.
    fn find_scale(&mut self, subject: &Subject<'_>, words: &Words) {
        for lanes in 0..=MOST_LANES {
            for left in [lanes / 2, lanes - lanes / 2] {
                let beside = [left, lanes - left];
                let mut rows = [0, 0];
                for _ in 0..3 {
                    self.fit(subject, [beside, rows]);
                    let needed = self.place_bars(subject, words);
                    let enough = needed[0][0] <= beside[0] && needed[0][1] <= beside[1];
                    if enough && needed[1] == rows {
                        return;
                    }
                    rows = needed[1];
                }
            }
        }
    }

    /// Chooses the scale for so many lanes: to the left and right, above and below.
    fn fit(&mut self, subject: &Subject<'_>, counts: [[usize; 2]; 2]) {
        let lane = |axis: usize, side: usize| {
            let pitch = if axis == 1 { self.pitch.x } else { self.pitch.y };
            counts[usize::from(axis == 0)][side] as f64 * pitch
        };
        let (left, right, above, below) = (lane(1, 0) + EDGE, lane(1, 1) + EDGE, lane(0, 0) + EDGE, lane(0, 1) + 2.0);
        let room = DVec2::new(subject.width - left - right, subject.height);
        let size = self.window.size();
        let scale = (room.x / size.x).min(room.y / size.y);
        let height = size.y * scale;
        let slack = (room.x - size.x * scale) / 2.0;
        self.inner = Rect { min: DVec2::new(left, above), max: DVec2::new(subject.width - right, above + height) };
        self.camera = Camera {
            scale,
            origin: DVec2::new(self.window.min.x - (left + slack) / scale, self.window.max.y + above / scale),
        };
        self.size = DVec2::new(
            subject.width,
            above + height + below + if subject.view == FigureView::ThreeD { EDGE } else { FOOT },
        );
    }

    /// Gives dimensions their lanes; how many there are to the left and right, above and below.
    fn place_bars(&mut self, subject: &Subject<'_>, words: &Words) -> [[usize; 2]; 2] {
        let mut counts = [[0; 2]; 2];
        let kinds = directions(subject, words);
        for axis in [1, 0] {
            let own: Vec<usize> = (0..kinds.len()).filter(|n| kinds[*n] == Some(axis)).collect();
            let bars: Vec<Bar> =
                own.iter().map(|n| self.bar(&subject.measured[*n], &words.labels[*n], axis, subject.view)).collect();
            let (found, count) = lanes(&bars);
            for ((n, bar), lane) in own.iter().zip(bars).zip(found) {
                self.placed[*n] = Some((bar, lane));
            }
            counts[usize::from(axis == 0)] = count;
        }
        counts
    }

    fn bar(&self, measured: &Measured, label: &str, axis: usize, view: FigureView) -> Bar {
        let own: Along = axes(view)[axis];
        let place = |spot: Spot| {
            let world = coordinate(spot, own);
            let world = if axis == 0 { DVec2::new(world, 0.0) } else { DVec2::new(0.0, world) };
            self.camera.place(world)[axis]
        };
        let (a, b) = (place(measured.from), place(measured.to));
        let label = if axis == 0 { width(label) + 4.0 } else { height(label) };
        // Points are nearer to one side; coordinates are seen from both.
        let across = |spot: Spot| match spot {
            Spot::Point(point) => Some(self.camera.place(flat(point, view))[1 - axis]),
            Spot::Coordinate(_) => None,
        };
        let middle = (self.inner.min[1 - axis] + self.inner.max[1 - axis]) / 2.0;
        let near = match (across(measured.from), across(measured.to)) {
            (Some(a), Some(b)) => usize::from((a + b) / 2.0 >= middle - 1.0),
            _ => 1,
        };
        Bar { ends: [a.min(b), a.max(b)], label, near, edges: [2.0, self.size[axis] - 2.0] }
    }
}

fn directions(subject: &Subject<'_>, words: &Words) -> Vec<Option<usize>> {
    let all = subject.measured.iter().take(words.labels.len());
    all.map(|measured| direction(measured, subject.view)).collect()
}

/// What a figure must show: ways, tool, dimensions, parts.
fn content(subject: &Subject<'_>, faces: &[Face]) -> Window {
    let (view, shot) = (subject.view, subject.shot);
    let mut window = Window::EMPTY;
    if view == FigureView::ThreeD {
        axonometric::bounds(shot).into_iter().for_each(|p| window.take(flat(p, view)));
        // Letters stand beyond the ends of the axes.
        let more = 0.06 * window.size();
        return Window { min: window.min - more, max: window.max + more };
    }
    for (n, stroke) in shot.strokes.iter().enumerate() {
        // The tool comes from far away: where from does not matter.
        let skipped = usize::from(n == 0 && stroke.way == Way::Rapid);
        let is_wide = stroke.way == Way::Feed && view != FigureView::Turned;
        let radius = if is_wide { stroke.tool.radius } else { 0.0 };
        for p in stroke.points.iter().skip(skipped) {
            let p = flat(*p, view);
            let around = if view == FigureView::Plan { DVec2::splat(radius) } else { DVec2::new(radius, 0.0) };
            window.take(p - around);
            window.take(p + around);
        }
    }
    for measured in subject.measured {
        for spot in [measured.from, measured.to] {
            match (spot, measured.along) {
                (Spot::Point(p), _) => window.take(flat(p, view)),
                (Spot::Coordinate(c), Some(axis)) => {
                    let at = usize::from(axes(view)[1] == axis);
                    (window.min[at], window.max[at]) = (window.min[at].min(c), window.max[at].max(c));
                }
                _ => {}
            }
        }
        if measured.kind == DimensionKind::Angle {
            window.take(flat(measured.centre, view));
        }
    }
    scan::range(shot).iter().flatten().for_each(|p| window.take(flat(*p, view)));
    shot.contacts.iter().for_each(|p| window.take(flat(*p, view)));
    for p in shot.setter.iter().flat_map(Setter::bounds).chain(setter::around(shot)) {
        window.take(flat(p, view));
    }
    if let Some((rotary, axis)) = shot.rotary.as_ref().zip(rotary::axis(view)) {
        for (centre, foot, radius) in rotary.spheres(axis) {
            window.take(flat(centre, view) - 1.1 * radius);
            window.take(flat(centre, view) + 1.1 * radius);
            window.take(flat(foot, view));
        }
        rotary.centre(axis).into_iter().for_each(|centre| window.take(flat(centre, view)));
    }
    if let Some((tool, tip)) = setter::pose(shot).filter(|_| !shot.strokes.is_empty()) {
        let around = match view {
            FigureView::Plan => DVec2::splat(tool.radius),
            FigureView::Turned => DVec2::ZERO,
            _ => DVec2::new(tool.radius, 0.0),
        };
        window.take(flat(tip, view) - around);
        window.take(flat(tip, view) + around);
        let insert = shot.turned.iter().flat_map(|turned| &turned.insert);
        insert.for_each(|p| window.take(flat(tip, view) + *p));
    }
    for face in faces.iter().filter(|face| face.material) {
        match &face.outline {
            Outline::Circle(centre, radius) => {
                window.take(*centre - DVec2::splat(*radius));
                window.take(*centre + DVec2::splat(*radius));
            }
            // What has no end is drawn as far as the rest reaches.
            Outline::Polygon(points) if points.iter().all(|p| p.abs().max_element() < 900.0) => {
                points.iter().for_each(|p| window.take(*p));
            }
            Outline::Polygon(_) => {}
        }
    }
    if window.min.x > window.max.x {
        return Window { min: DVec2::ZERO, max: DVec2::ONE };
    }
    window
}
