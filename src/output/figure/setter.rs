//! The tool setter, the tools at it, and where they touch it.
//!
//! Invariant: knows places of a run, no cycle. The tool is drawn where it touched last: there it is measured.
use std::fmt::Write as _;

use glam::{DVec2, DVec3};

use super::cutter::{self, End};
use super::pen::{Pen, Rect, short};
use super::shot::Shot;
use super::stroke::{Stroke, Turning, Way};
use crate::base::expr::{cosd, sind};
use crate::engine::geometry::WorkingPlane;
use crate::engine::machine::Tool;
use crate::engine::scene::{Plate, Scene};
use crate::spec::FigureView;

/// The height of the plate, and how much of the setter is drawn below its face, as parts of half its width.
pub(super) const PLATE: f64 = 0.34;
pub(super) const DRAWN: f64 = 1.1;
/// The same for the post that carries the plate.
pub(super) const POST: f64 = 0.38;
/// Directions that differ by less are the same.
const ASKEW: f64 = 1e-9;

/// A tool setter in the coordinates of the shot.
#[derive(Clone, Debug)]
pub(super) struct Setter {
    /// The centre of its upper face.
    pub(super) at: DVec3,
    /// Half its width.
    pub(super) half: f64,
    /// The corners of a cube; none of a disc.
    pub(super) corners: Vec<DVec3>,
    /// Its main, minor and tool axis.
    pub(super) axes: [DVec3; 3],
}

impl Setter {
    /// The setter of a scene; `own` is from the machine to the coordinates of the shot.
    pub(super) fn of(scene: &Scene, plane: WorkingPlane, own: &dyn Fn(DVec3) -> DVec3) -> Option<Self> {
        let setter = scene.setter.as_ref()?;
        let mounted = setter.mounted();
        let seen = |way: DVec3| own(mounted.vector(way)) - own(DVec3::ZERO);
        let axes = [plane.main, plane.secondary, plane.tool].map(|axis| seen(axis.unit()));
        let (half, corners) = match setter.plate {
            Plate::Disc(radius) => (radius, Vec::new()),
            Plate::Cube(half) => {
                let corner = |x: f64, y: f64| own(setter.at + mounted.vector(plane.lift(DVec2::new(x, y) * half, 0.0)));
                (half, vec![corner(-1.0, -1.0), corner(1.0, -1.0), corner(1.0, 1.0), corner(-1.0, 1.0)])
            }
        };
        Some(Self { at: own(setter.at), half, corners, axes })
    }

    /// Whether it is mounted in the directions of the figure.
    pub(super) fn is_upright(&self) -> bool {
        let units = [DVec3::X, DVec3::Y, DVec3::Z];
        self.axes.iter().zip(units).all(|(axis, unit)| axis.distance(unit) < ASKEW)
    }

    /// Places that a drawing of it must show.
    pub(super) fn bounds(&self) -> Vec<DVec3> {
        if !self.is_upright() {
            return self.corners_turned().collect();
        }
        let wide = DVec3::new(self.half, self.half, 0.0);
        vec![self.at - wide - DVec3::Z * self.half * DRAWN, self.at + wide]
    }

    /// Whether a stroke is in the plane through its centre that is seen from the side.
    pub(super) fn is_in_plane(&self, stroke: &Stroke) -> bool {
        let minor = if self.is_upright() { DVec3::Y } else { self.axes[1] };
        stroke.points.iter().all(|p| (*p - self.at).dot(minor).abs() < self.half / 2.0)
    }

    /// Where a tool touches it that went along a stroke.
    fn touched(&self, stroke: &Stroke) -> Option<DVec3> {
        let (from, tip) = (*stroke.points.first()?, *stroke.points.last()?);
        let way = tip - from;
        let radius = stroke.tool.radius;
        // The width of its flat end, and how far above its tip it has its full width.
        let corner = stroke.tool.corner.clamp(0.0, radius);
        let flat = radius - corner;
        if !self.is_upright() {
            let up = self.axes[2];
            let deep = (tip - self.at).dot(up);
            let aside = (self.at - tip).reject_from_normalized(up);
            return Some(match way.reject_from_normalized(up).length() > way.dot(up).abs() {
                true => tip + way.normalize() * radius + up * (-deep / 2.0).max(corner.min(-deep)),
                false => tip - up * deep + aside.clamp_length_max(flat),
            });
        }
        Some(if way.truncate().length() > way.z.abs() {
            // With its side, as deep as the tip is below the face.
            let height = tip.z.midpoint(self.at.z).max((tip.z + corner).min(self.at.z));
            (tip + way.normalize() * radius).with_z(height)
        } else {
            let aside = (self.at - tip).truncate();
            (tip.truncate() + aside.clamp_length_max(flat)).extend(self.at.z)
        })
    }
}

/// The tool and where its tip is drawn: where it touched the setter last, else where it is at the moment.
pub(super) fn pose(shot: &Shot) -> Option<(Tool, DVec3)> {
    touches(shot).last().and_then(|stroke| Some((stroke.tool, *stroke.points.last()?))).or(shot.tool)
}

/// The ways on which a tool touched the setter.
pub(super) fn touches(shot: &Shot) -> impl Iterator<Item = &Stroke> {
    shot.strokes.iter().filter(|stroke| stroke.way == Way::Probe && shot.setter.is_some())
}

/// Places around the tools where they touched the setter.
pub(super) fn around(shot: &Shot) -> impl Iterator<Item = DVec3> {
    touches(shot).flat_map(move |stroke| {
        let Some(tip) = stroke.points.last().copied() else { return Vec::new() };
        match shot.setter.as_ref().filter(|setter| !setter.is_upright()) {
            Some(setter) => setter.tool_turned(&stroke.tool, tip),
            None => {
                let wide = DVec3::new(stroke.tool.radius, stroke.tool.radius, 0.0);
                vec![tip - wide, tip + wide]
            }
        }
    })
}

/// The places at which tools touched the setter.
pub(super) fn touched(shot: &Shot) -> Vec<DVec3> {
    let Some(setter) = &shot.setter else { return Vec::new() };
    touches(shot).filter_map(|stroke| setter.touched(stroke)).collect()
}

/// Draws the setter as the view sees it; `at` puts places on the sheet.
pub(super) fn draw(pen: &mut Pen, setter: &Setter, view: FigureView, at: &dyn Fn(DVec3) -> DVec2) {
    let centre = at(setter.at);
    let half = at(setter.at + DVec3::X * setter.half).x - centre.x;
    if view == FigureView::Plan {
        let corners: Vec<DVec2> = setter.corners.iter().map(|corner| at(*corner)).collect();
        if corners.is_empty() {
            pen.circle("m o", centre, half)
        } else {
            pen.area("m o", &corners)
        }
        let cross = half * 0.3;
        for end in [DVec2::X, DVec2::Y] {
            pen.line("x", &[centre - end * cross, centre + end * cross]);
        }
        return;
    }
    let (down, bottom) = (DVec2::Y * half * PLATE, centre + DVec2::Y * half * DRAWN);
    let (plate, post) = (DVec2::X * half, DVec2::X * half * POST);
    // The post goes on below the edge of the drawing.
    let wave = DVec2::Y * (half * 0.08).min(4.0);
    let cut = [bottom + post - wave, bottom + post / 3.0, bottom - post / 3.0 - 2.0 * wave, bottom - post - wave];
    let mut outline = vec![centre + down - post, centre + down + post];
    outline.extend(cut);
    pen.area("m o", &outline);
    pen.area("m o", &[centre - plate, centre + plate, centre + plate + down, centre - plate + down]);
}

/// Draws the outlines of a tool where it touched before, and at rest or turning, where it touched last.
pub(super) fn poses(pen: &mut Pen, shot: &Shot, view: FigureView, top: f64, at: &dyn Fn(DVec3) -> DVec2) {
    let ends: Vec<(&Stroke, DVec2)> =
        touches(shot).filter_map(|stroke| Some((stroke, at(*stroke.points.last()?)))).collect();
    let Some((last, here)) = ends.last() else { return };
    let scale = at(DVec3::X).x - at(DVec3::ZERO).x;
    let radius = last.tool.radius * scale;
    let mut drawn = vec![*here];
    for (stroke, place) in &ends {
        if drawn.iter().all(|other| (*other - *place).length() > 2.0) {
            drawn.push(*place);
            if view == FigureView::Plan {
                pen.circle("v", *place, radius);
            } else {
                pen.path("v", &cutter::outline(End::of(&stroke.tool, scale), *place, top));
            }
        }
    }
    if view == FigureView::Plan {
        match last.turning.direction {
            0 => edges(pen, &last.tool, last.turning, *here, radius),
            _ => turn(pen, last, *here, radius),
        }
    } else if last.turning.direction != 0 {
        turn_from_side(pen, last, DVec2::new(here.x, top), radius);
    }
}

/// The cutting edges of a tool that stands, as seen from the spindle.
pub(super) fn edges(pen: &mut Pen, tool: &Tool, turning: Turning, centre: DVec2, radius: f64) {
    let count = tool.teeth as u32;
    let Some(angle) = turning.angle.filter(|_| turning.direction == 0) else { return };
    for edge in 0..count {
        let angle = angle + turning.first + 360.0 / f64::from(count) * f64::from(edge);
        let way = DVec2::new(cosd(angle), -sind(angle));
        pen.line("o", &[centre + way * radius * 0.45, centre + way * radius]);
        pen.circle("q", centre + way * radius, 2.2);
    }
}

/// An arrow around a tool that turns, as seen from the spindle.
fn turn(pen: &mut Pen, stroke: &Stroke, centre: DVec2, radius: f64) {
    let around = (radius * 0.6).max(5.0);
    let clockwise = stroke.turning.direction > 0;
    // From the lower left corner over the top, or the other way round.
    let (from, to) = if clockwise { (215.0, -35.0) } else { (-35.0, 215.0) };
    let place = |angle: f64| centre + DVec2::new(cosd(angle), -sind(angle)) * around;
    let (begin, end) = (place(from), place(to));
    let r = short(around);
    let [x, y, ex, ey] = [begin.x, begin.y, end.x, end.y].map(short);
    pen.path("g", &format!("M{x} {y}A{r} {r} 0 1 {} {ex} {ey}", u8::from(clockwise)));
    let lean = if clockwise { -78.0 } else { 78.0 };
    let way = DVec2::new(cosd(to + lean), -sind(to + lean));
    pen.arrow("aa", end + way * 2.0, way);
}

/// The same before a tool that is seen from its side, `top` where it leaves the drawing.
fn turn_from_side(pen: &mut Pen, stroke: &Stroke, top: DVec2, radius: f64) {
    let (wide, flat) = (radius + 6.0, (radius * 0.3).clamp(3.0, 7.0));
    // What turns clockwise as seen from the spindle goes to the left on the side of the reader.
    let way = if stroke.turning.direction > 0 { -1.0 } else { 1.0 };
    let middle = top + DVec2::Y * (2.0 * flat + 12.0);
    let (begin, end) = (middle - DVec2::X * wide * way, middle + DVec2::X * wide * way);
    let [x, y, ex, ey, rx, ry] = [begin.x, begin.y, end.x, end.y, wide, flat].map(short);
    let _ = writeln!(pen.body, "<path class=\"g\" d=\"M{x} {y}A{rx} {ry} 0 0 {} {ex} {ey}\"/>", u8::from(way < 0.0));
    pen.arrow("aa", end - DVec2::Y * 3.0, DVec2::new(way * 0.35, -1.0));
    pen.blocked.push(Rect::around(middle, DVec2::new(2.0 * wide, 2.0 * flat)));
}
