//! What a figure shows, and how its view sees places of the run.
//!
//! Invariant: knows nothing of paper.
use glam::{DVec2, DVec3};

use super::axonometric;
use super::measure::{Measured, Spot, along, axes};
use super::profile;
use super::shot::{CUT, Shot, number};
use crate::spec::{Along, FigureView};

/// What a figure shows, measured.
pub(super) struct Subject<'s> {
    pub(super) view: FigureView,
    pub(super) shot: &'s Shot,
    pub(super) measured: &'s [Measured],
    /// The numbers of the marks.
    pub(super) marks: &'s [u32],
    /// Whether the blank is round from above.
    pub(super) round: bool,
    /// Whether it shows what becomes of a whole program, and with it the datum.
    pub(super) whole: bool,
    /// The greatest height of the drawing, in pixels.
    pub(super) height: f64,
    /// The width of the sheet, in pixels.
    pub(super) width: f64,
}

/// The words on a figure.
pub(super) struct Words {
    /// The label of each dimension.
    pub(super) labels: Vec<String>,
    /// What each dimension is a link to, if to anything.
    pub(super) links: Vec<Option<String>>,
    /// Rapid traverse, feed, probing.
    pub(super) ways: [String; 3],
}

/// A point as the view sees it: to the right and upwards.
pub(super) fn flat(p: DVec3, view: FigureView) -> DVec2 {
    if view == FigureView::ThreeD {
        return axonometric::project(p);
    }
    let [right, up] = axes(view);
    DVec2::new(along(p, right), along(p, up))
}

/// Where the plane of the view is along the axis that it does not show.
pub(super) fn depth(subject: &Subject<'_>) -> f64 {
    let shot = subject.shot;
    let tool = shot.tool.map_or(DVec3::ZERO, |(_, tip)| tip);
    number(shot, CUT).unwrap_or_else(|| match subject.view {
        FigureView::Plan | FigureView::RotaryC | FigureView::ThreeD => {
            shot.contacts.first().map_or(tool.z, |contact| contact.z)
        }
        FigureView::Section | FigureView::Side | FigureView::Rotary | FigureView::RotaryB => tool.y,
        FigureView::RotaryA => tool.x,
        FigureView::Turned => 0.0,
    })
}

/// The surface of a blank after the strokes, where the view cuts it.
pub(super) fn surface(subject: &Subject<'_>, edges: [f64; 2], top: f64) -> Vec<DVec2> {
    profile::surface(&subject.shot.strokes, depth(subject), edges, top)
}

/// The coordinate of a place along an axis.
pub(super) const fn coordinate(spot: Spot, axis: Along) -> f64 {
    match spot {
        Spot::Coordinate(coordinate) => coordinate,
        Spot::Point(point) => along(point, axis),
    }
}
