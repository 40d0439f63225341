//! Tool path and part as a drawing: SVG from above, from the side, or isometric.
//!
//! Coordinates are those of the stock's grid: main axis, secondary axis, tool axis. Invariant: the same moves give the
//! same bytes; arcs are drawn by chords that leave them by 0.01 mm at most.
use std::fmt::Write as _;

use glam::{DVec2, DVec3};

use super::geometry::{Frame, WorkingPlane};
use super::report::event::{Event, EventKind, MoveKind};
use super::scene::Scene;
use super::solid::Path;
use super::stock::{Blank, Plateau, Stock};
use crate::program::syntax::Program;

/// From where the drawing looks.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum View {
    /// Against the tool axis.
    Top,
    /// Against the secondary axis.
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

    /// Where a point is drawn: to the right and down.
    fn place(self, p: DVec3) -> DVec2 {
        const COS_30: f64 = 0.866_025_403_784_438_6;
        match self {
            Self::Top => DVec2::new(p.x, -p.y),
            Self::Side => DVec2::new(p.x, -p.z),
            Self::Isometric => DVec2::new((p.x + p.y) * COS_30, (p.x - p.y) * 0.5 - p.z),
        }
    }

    /// Whether an upright wall is seen whose outside is to the right of an edge.
    fn sees(self, edge: DVec2) -> bool {
        self == Self::Isometric && edge.x + edge.y > 0.0
    }
}

/// From the machine to the coordinates of a drawing: main axis, secondary axis, tool axis, as the blank has them.
#[derive(Clone, Copy, Debug)]
pub struct PathGrid {
    back: Frame,
    plane: WorkingPlane,
}

impl PathGrid {
    /// The grid of a run: that of its blank, or of the preset that is active at the start where there is none.
    pub fn new(program: &Program, scene: &Scene) -> Self {
        let blank = Blank::find(program, scene).ok();
        let (frame, axis) = blank.map_or((scene.frame, scene.machine.spindle), |blank| (blank.frame, blank.axis));
        Self { back: frame.inverse(), plane: WorkingPlane::of_tool_axis(axis) }
    }

    fn point(&self, machine: DVec3) -> DVec3 {
        let own = self.back.point(machine);
        self.plane.flat(own).extend(self.plane.tool.of(own))
    }
}

/// A piece of the tool path.
#[derive(Clone, Debug)]
struct Stroke {
    rapid: bool,
    points: Vec<DVec3>,
}

/// The tool path of a run.
#[derive(Clone, Debug, Default)]
pub struct Track {
    strokes: Vec<Stroke>,
}

impl Track {
    /// Takes an event; moves are drawn where the blank lies.
    pub fn see(&mut self, event: &Event, grid: &PathGrid) {
        let EventKind::Move { kind, path, .. } = &event.kind else { return };
        let rapid = matches!(kind, MoveKind::Rapid | MoveKind::Arc { rapid: true, .. });
        let pieces = match path {
            Path::Line { .. } => 1,
            Path::Arc { centre, from, sweep, .. } => {
                let radius = (*from - *centre).length().max(0.01);
                // A chord of this angle is off by 0.01 mm.
                let angle = 2.0 * libm::acos((1.0 - 0.01 / radius).max(0.5));
                ((sweep.to_radians().abs() / angle).ceil() as usize).clamp(8, 100_000)
            }
        };
        let points = (0..=pieces).map(|n| grid.point(path.at(n as f64 / pieces as f64)));
        match self.strokes.last_mut().filter(|last| last.rapid == rapid) {
            Some(last) => last.points.extend(points.skip(1)),
            None => self.strokes.push(Stroke { rapid, points: points.collect() }),
        }
    }

    /// The drawing; without a part that of the path alone.
    pub fn draw(&self, stock: Option<&Stock>, view: View) -> String {
        let mut sheet = Sheet { view, body: String::new(), min: DVec2::INFINITY, max: DVec2::NEG_INFINITY };
        if let Some(stock) = stock {
            sheet.part(stock);
        }
        for rapid in [true, false] {
            let mut data = String::new();
            for stroke in self.strokes.iter().filter(|stroke| stroke.rapid == rapid) {
                sheet.line(&stroke.points, false, &mut data);
            }
            if !data.is_empty() {
                let class = if rapid { "rapid" } else { "feed" };
                let _ = writeln!(sheet.body, "<path class=\"{class}\" d=\"{}\"/>", data.trim_end());
            }
        }
        sheet.finish()
    }
}

struct Sheet {
    view: View,
    body: String,
    min: DVec2,
    max: DVec2,
}

/// A coordinate with two places, without what is not needed.
fn short(value: f64) -> String {
    let text = format!("{value:.2}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0".to_owned() } else { text.to_owned() }
}

impl Sheet {
    /// Adds a line to the data of a path.
    fn line(&mut self, points: &[DVec3], closed: bool, data: &mut String) {
        let mut last = String::new();
        for (n, p) in points.iter().enumerate() {
            let p = self.view.place(*p);
            (self.min, self.max) = (self.min.min(p), self.max.max(p));
            let text = format!("{} {}", short(p.x), short(p.y));
            if text != last {
                let _ = write!(data, "{}{text} ", if n == 0 { "M" } else { "L" });
                last = text;
            }
        }
        if closed {
            data.push_str("Z ");
        }
    }

    fn shape(&mut self, class: &str, style: &str, data: &str) {
        if !data.is_empty() {
            let style = if style.is_empty() { String::new() } else { format!(" fill=\"{style}\"") };
            let _ = writeln!(self.body, "<path class=\"{class}\"{style} d=\"{}\"/>", data.trim_end());
        }
    }

    fn part(&mut self, stock: &Stock) {
        let plateaus = stock.plateaus();
        let [min, max] = stock.bounds();
        if self.view == View::Side {
            self.silhouette(stock, [min, max]);
            return;
        }
        let extent = (max.z - min.z).max(1e-9);
        let mut below = min.z;
        for Plateau { height, outlines } in &plateaus {
            self.walls(outlines, [below, *height]);
            let mut data = String::new();
            for outline in outlines {
                let points: Vec<DVec3> = outline.iter().map(|p| p.extend(*height)).collect();
                self.line(&points, true, &mut data);
            }
            // The higher, the lighter.
            let light = 150.0 + 90.0 * (height - min.z) / extent;
            self.shape("top", &grey(light), &data);
            below = *height;
        }
    }

    /// The walls under the outlines that face the viewer.
    fn walls(&mut self, outlines: &[Vec<DVec2>], [low, high]: [f64; 2]) {
        if self.view != View::Isometric || high <= low {
            return;
        }
        let mut faces: Vec<(f64, String, String)> = Vec::new();
        for outline in outlines {
            for (n, a) in outline.iter().enumerate() {
                let b = outline[(n + 1) % outline.len()];
                let edge = b - *a;
                if !self.view.sees(edge) {
                    continue;
                }
                let mut data = String::new();
                let corners = [a.extend(low), b.extend(low), b.extend(high), a.extend(high)];
                self.line(&corners, true, &mut data);
                // Outside is to the right; the front is lighter than the right side.
                let outward = DVec2::new(edge.y, -edge.x).normalize_or_zero();
                let depth = 0.5 * (a.x - a.y + b.x - b.y);
                faces.push((depth, grey(110.0 + 40.0 * -outward.y), data));
            }
        }
        // What is farther away first.
        faces.sort_by(|a, b| a.0.total_cmp(&b.0));
        for (_, style, data) in faces {
            self.shape("wall", &style, &data);
        }
    }

    /// The part from the side: the highest and lowest ends over each place of the main axis, and the lowest top dashed.
    fn silhouette(&mut self, stock: &Stock, [min, max]: [DVec3; 2]) {
        let (columns, rows) = stock.size();
        let (mut upper, mut lower, mut floor) = (Vec::new(), Vec::new(), Vec::new());
        let half = DVec2::new(0.5 * stock.cell().x, 0.0);
        for column in 0..columns {
            let at = stock.place(column, 0);
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
                for x in [at.x - half.x, at.x + half.x] {
                    upper.push(DVec3::new(x, 0.0, high));
                    lower.push(DVec3::new(x, 0.0, low));
                    floor.push(DVec3::new(x, 0.0, least));
                }
            }
        }
        lower.reverse();
        let mut data = String::new();
        self.line(&straightened(&[upper, lower].concat()), true, &mut data);
        self.shape("top", &grey(225.0), &data);
        let mut data = String::new();
        self.line(&straightened(&floor), false, &mut data);
        self.shape("hidden", "", &data);
        let mut data = String::new();
        let corners = [min, DVec3::new(max.x, 0.0, min.z), max, DVec3::new(min.x, 0.0, max.z)];
        self.line(&corners, true, &mut data);
        self.shape("blank", "", &data);
    }

    fn finish(self) -> String {
        let (min, max) = if self.min.x <= self.max.x { (self.min, self.max) } else { (DVec2::ZERO, DVec2::ONE) };
        let size = max - min;
        let edge = 0.04 * size.max_element().max(1.0);
        let (min, size) = (min - DVec2::splat(edge), size + DVec2::splat(2.0 * edge));
        let line = size.max_element() / 500.0;
        let [x, y, w, h, thin, thick, dash] =
            [min.x, min.y, size.x, size.y, 0.6 * line, line, 4.0 * line].map(|value| short(value.max(-1e9)));
        format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"{x} {y} {w} {h}\">\n<style>\
             path{{stroke-linejoin:round;stroke-linecap:round;fill-rule:evenodd}}\
             .top,.wall{{stroke:#555;stroke-width:{thin}}}.wall{{stroke:none}}\
             .feed,.rapid,.hidden,.blank{{fill:none;stroke-width:{thick}}}\
             .feed{{stroke:#0057b7}}.rapid{{stroke:#d1242f;stroke-width:{thin};stroke-dasharray:{dash}}}\
             .hidden,.blank{{stroke:#777;stroke-width:{thin};stroke-dasharray:{dash}}}</style>\n{}</svg>\n",
            self.body
        )
    }
}

fn grey(light: f64) -> String {
    let light = light.clamp(0.0, 255.0) as u8;
    format!("#{light:02x}{light:02x}{light:02x}")
}

/// The points without those between two others on a line.
fn straightened(points: &[DVec3]) -> Vec<DVec3> {
    let mut kept: Vec<DVec3> = Vec::new();
    for p in points {
        if let [.., a, b] = kept.as_slice()
            && (*b - *a).cross(*p - *b).length() < 1e-9
            && (*b - *a).dot(*p - *b) >= 0.0
        {
            kept.pop();
        }
        kept.push(*p);
    }
    kept
}
