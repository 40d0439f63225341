//! What a figure shows of a scan: the range that is scanned, and the points that are taken.
//!
//! Invariant: knows places of a run, no cycle.
use glam::{DVec2, DVec3};

use super::pen::Pen;
use super::shot::{SCAN, Shot, point};
use super::stroke::Way;

/// The least and the greatest corner of the range, if the figure shows a scan.
pub(super) fn range(shot: &Shot) -> Option<[DVec3; 2]> {
    let [Some(least), Some(greatest)] = SCAN.map(|place| point(shot, place)) else { return None };
    Some([least, greatest])
}

/// Draws the outline of the range; `at` puts places on the sheet.
pub(super) fn outline(pen: &mut Pen, shot: &Shot, at: &dyn Fn(DVec3) -> DVec2) {
    let Some([least, greatest]) = range(shot).map(|corners| corners.map(at)) else { return };
    pen.area("v", &[least, DVec2::new(greatest.x, least.y), greatest, DVec2::new(least.x, greatest.y)]);
}

/// The places of the ball at which points are taken while it stays on the part: the ends of its pieces of way.
pub(super) fn points(shot: &Shot) -> Vec<DVec3> {
    let slides = shot.strokes.iter().filter(|stroke| stroke.way == Way::Feed);
    slides.filter_map(|stroke| stroke.points.last().copied()).filter(|end| shot.ball_touches(*end)).collect()
}
